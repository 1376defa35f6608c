//! Which triangles does a mesh file have? Reads STL and OBJ; writes nothing, returns corners or names what is wrong.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// The triangles of a file, in metres. What is wrong is said without the file's name.
///
/// # Errors
/// When it cannot be read, or has no triangle.
pub fn mesh(file: &Path, unit: f64) -> Result<Vec<Vec<[f64; 3]>>, String> {
    let opened =
        File::open(file).map_err(|why| format!("cannot read {}: {why}", file.display()))?;
    let mut reader = BufReader::new(opened);
    let extension = file.extension().and_then(|end| end.to_str()).unwrap_or("");
    let triangles = match extension.to_ascii_lowercase().as_str() {
        "stl" => stl(&mut reader),
        "obj" => obj(&mut reader),
        _ => Err("its name must end in .stl or .obj".to_owned()),
    }?;
    if triangles.is_empty() {
        return Err("there is no triangle in it".to_owned());
    }
    Ok(triangles.into_iter().map(|t| t.map(|c| c.map(|x| x * unit)).to_vec()).collect())
}

/// Three corners.
type Triangle = [[f64; 3]; 3];

fn stl(reader: &mut BufReader<File>) -> Result<Vec<Triangle>, String> {
    let stl = stl_io::read_stl(reader).map_err(|why| format!("is no STL file: {why}"))?;
    let corner = |k: usize| {
        let vertex: [f32; 3] = stl.vertices.get(k).copied().map_or([f32::NAN; 3], Into::into);
        vertex.map(f64::from)
    };
    Ok(stl.faces.iter().map(|face| face.vertices.map(corner)).collect())
}

fn obj(reader: &mut BufReader<File>) -> Result<Vec<Triangle>, String> {
    let options = tobj::LoadOptions { triangulate: true, ..tobj::LoadOptions::default() };
    let none = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(reader, &options, none)
        .map_err(|why| format!("is no OBJ file: {why}"))?;
    let triangles = models.iter().flat_map(|model| {
        let positions = &model.mesh.positions;
        let corner = move |k: u32| -> [f64; 3] {
            let first = 3 * k as usize;
            std::array::from_fn(|axis| {
                positions.get(first + axis).map_or(f64::NAN, |&x| f64::from(x))
            })
        };
        model.mesh.indices.chunks_exact(3).map(move |t| [corner(t[0]), corner(t[1]), corner(t[2])])
    });
    Ok(triangles.collect())
}
