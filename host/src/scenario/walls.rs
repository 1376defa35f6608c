//! Which facets are obstacles made of? Reads their fields and mesh files; writes nothing, returns facets or names what is wrong.

use super::obstacle::{ObstacleSpec, RotationSpec, VibrationSpec};
use super::problem::Problem;
use super::side::Made;
use std::collections::HashMap;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

/// One facet of an obstacle: a segment or a triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Two corners in the plane, three in space; components beyond the dimension are 0.
    pub corners: Vec<[f64; 3]>,
    /// What it is made of.
    pub made: Made,
    /// How fast its surface moves along itself, from the first corner to the second.
    pub speed: f64,
    /// Of which `[[obstacle]]` it is.
    pub obstacle: usize,
    /// Which of the start's motions is its own; none if it stands.
    pub motion: Option<u8>,
}

/// How an obstacle moves, its vectors with zeros beyond the dimension; in SI units and radians.
#[derive(Clone, Debug, PartialEq)]
pub enum Motion {
    /// Steadily, with this velocity.
    Drift([f64; 3]),
    /// A₀ sin(2π (f t + φ)).
    Vibration {
        /// A₀.
        amplitude: [f64; 3],
        /// f.
        frequency: f64,
        /// φ, in turns.
        phase: f64,
    },
    /// About an axis through a point.
    Rotation {
        /// The point.
        centre: [f64; 3],
        /// ω.
        angular_velocity: [f64; 3],
    },
}

impl Motion {
    /// What an obstacle says; none if it stands.
    #[must_use]
    pub fn of(obstacle: &ObstacleSpec) -> Option<Self> {
        if let Some(velocity) = &obstacle.velocity {
            return Some(Self::Drift(padded(velocity)));
        }
        if let Some(VibrationSpec { amplitude, frequency, phase }) = &obstacle.vibration {
            let (frequency, phase) = (*frequency, *phase);
            return Some(Self::Vibration { amplitude: padded(amplitude), frequency, phase });
        }
        let RotationSpec { centre, angular_velocity } = obstacle.rotation.as_ref()?;
        let angular_velocity = match angular_velocity[..] {
            [flat] => [0.0, 0.0, flat],
            ref all => padded(all),
        };
        Some(Self::Rotation { centre: padded(centre), angular_velocity })
    }
}

/// All facets of obstacle `number`.
///
/// # Errors
/// When a file cannot be read or has no mesh, when a triangle has no area, and when a mesh has a hole that must have none.
pub fn walls(
    (number, obstacle): (usize, &ObstacleSpec),
    folder: &Path,
    made: Made,
) -> Result<Vec<Wall>, Problem> {
    let meshed = match &obstacle.file {
        Some(file) => mesh(&folder.join(file), obstacle.unit.unwrap_or(1.0))
            .map_err(|why| problem(number, "file", &why))?,
        None => listed(obstacle),
    };
    let shift: [f64; 3] = std::array::from_fn(|k| obstacle.at.get(k).copied().unwrap_or(0.0));
    let shifted = |corner: [f64; 3]| std::array::from_fn(|k| corner[k] + shift[k]);
    let field = if obstacle.file.is_some() { "file" } else { "triangles" };
    let told = |why: String| problem(number, field, &named(obstacle, &why));
    if let Some(k) = meshed.iter().position(|facet| !has_area(facet)) {
        return Err(told(format!("facet {k} of {} has no length or area", meshed.len())));
    }
    if obstacle.closed {
        closed(&meshed).map_err(told)?;
    }
    let wall = |facet: Vec<[f64; 3]>| Wall {
        corners: facet.into_iter().map(shifted).collect(),
        made,
        speed: obstacle.speed,
        obstacle: number,
        motion: None,
    };
    Ok(meshed.into_iter().map(wall).collect())
}

fn problem(number: usize, field: &str, why: &str) -> Problem {
    let message = format!("obstacle {number}: {why}");
    Problem { path: format!("obstacle.{number}.{field}"), offset: None, message }
}

fn named(obstacle: &ObstacleSpec, why: &str) -> String {
    obstacle
        .file
        .as_ref()
        .map_or_else(|| why.to_owned(), |file| format!("{}: {why}", file.display()))
}

fn padded(numbers: &[f64]) -> [f64; 3] {
    std::array::from_fn(|k| numbers.get(k).copied().unwrap_or(0.0))
}

/// Those that the scenario itself lists.
fn listed(obstacle: &ObstacleSpec) -> Vec<Vec<[f64; 3]>> {
    let points = |points: &[Vec<f64>]| points.iter().map(|p| padded(p)).collect::<Vec<_>>();
    let pieces = |points: &[[f64; 3]]| points.windows(2).map(<[_]>::to_vec).collect::<Vec<_>>();
    if let Some(corners) = &obstacle.polygon {
        let mut corners = points(corners);
        corners.extend(corners.first().copied());
        return pieces(&corners);
    }
    if let Some(chain) = &obstacle.chain {
        return pieces(&points(chain));
    }
    obstacle.triangles.iter().flatten().map(|triangle| points(triangle)).collect()
}

/// The triangles of a file, in metres.
fn mesh(file: &PathBuf, unit: f64) -> Result<Vec<Vec<[f64; 3]>>, String> {
    let name = file.display();
    let opened = File::open(file).map_err(|why| format!("cannot read {name}: {why}"))?;
    let mut reader = BufReader::new(opened);
    let extension = file.extension().and_then(|end| end.to_str()).unwrap_or("");
    let triangles = match extension.to_ascii_lowercase().as_str() {
        "stl" => stl(&mut reader),
        "obj" => obj(&mut reader),
        _ => Err("its name must end in .stl or .obj".to_owned()),
    };
    let triangles = triangles.map_err(|why| format!("{name}: {why}"))?;
    if triangles.is_empty() {
        return Err(format!("{name}: there is no triangle in it"));
    }
    for (k, corner) in triangles.iter().enumerate().flat_map(|(k, t)| t.iter().map(move |c| (k, c)))
    {
        if let Some(x) = corner.iter().find(|x| !x.is_finite()) {
            return Err(format!("{name}: triangle {k} has a corner at {x}, must be finite"));
        }
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

/// Whether the corners of a facet span something.
fn has_area(facet: &[[f64; 3]]) -> bool {
    let to = |k: usize| -> [f64; 3] { std::array::from_fn(|axis| facet[k][axis] - facet[0][axis]) };
    let norm = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    match facet.len() {
        2 => norm(to(1)) > 0.0,
        _ => {
            let ([a, b, c], [d, e, f]) = (to(1), to(2));
            let across = norm([b * f - c * e, c * d - a * f, a * e - b * d]);
            across > 1e-12 * norm(to(1)) * norm(to(2))
        }
    }
}

/// Each edge must belong to two triangles.
fn closed(triangles: &[Vec<[f64; 3]>]) -> Result<(), String> {
    let mut edges: HashMap<[[u64; 3]; 2], (usize, usize)> = HashMap::new();
    let bits = |corner: [f64; 3]| corner.map(|x| (x + 0.0).to_bits());
    for (number, triangle) in triangles.iter().enumerate() {
        for k in 0..triangle.len() {
            let mut edge = [triangle[k], triangle[(k + 1) % triangle.len()]].map(bits);
            edge.sort_unstable();
            edges.entry(edge).or_insert((number, 0)).1 += 1;
        }
    }
    let open =
        edges.iter().filter(|(_, (_, count))| *count != 2).min_by_key(|(_, (first, _))| *first);
    let Some((edge, (triangle, count))) = open else { return Ok(()) };
    let [from, to] = edge.map(|corner| corner.map(f64::from_bits));
    Err(format!(
        "must be closed, but the edge from {from:?} to {to:?} of triangle {triangle} belongs to {count} triangle{}",
        if *count == 1 { ": there is a hole" } else { "s" }
    ))
}
