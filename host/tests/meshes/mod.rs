//! Which meshes do tests put into files? Reads nothing; writes nothing, returns text and bytes.

/// A tetrahedron of edges about one long, as STL says it.
pub const FACES: [[[f64; 3]; 3]; 4] = {
    const A: [f64; 3] = [0.0, 0.0, 0.0];
    const B: [f64; 3] = [1000.0, 0.0, 0.0];
    const C: [f64; 3] = [0.0, 1000.0, 0.0];
    const D: [f64; 3] = [0.0, 0.0, 1000.0];
    [[A, C, B], [A, B, D], [B, C, D], [C, A, D]]
};

/// As text.
pub fn stl_text(faces: &[[[f64; 3]; 3]]) -> String {
    let mut text = "solid test\n".to_owned();
    for face in faces {
        text += "facet normal 0 0 0\nouter loop\n";
        for [x, y, z] in face {
            text += &format!("vertex {x} {y} {z}\n");
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid test\n"
}

/// As bytes.
pub fn stl_binary(faces: &[[[f64; 3]; 3]]) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend((faces.len() as u32).to_le_bytes());
    for face in faces {
        bytes.extend([0; 12]);
        bytes.extend(face.iter().flatten().flat_map(|x| (*x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// The same as OBJ says it.
pub const OBJ: &str =
    "v 0 0 0\nv 1000 0 0\nv 0 1000 0\nv 0 0 1000\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

/// A ball in a room that a file says, in millimetres.
pub fn in_room(file: &str, more: &str) -> String {
    format!(
        "dimension = 3\nduration = 2.0\nsample = 1.0\n[law]\nkind = \"constant\"\nrestitution = 1.0\n\
         [[obstacle]]\nfile = {file:?}\nunit = 1e-3\nclosed = true\nrestitution = 1.0\n{more}\n\
         [[grain]]\nradius = 0.05\nmass = 1.0\nat = [0.2, 0.2, 0.2]\nmoving = [1.0, 0.3, -0.7]\n"
    )
}
