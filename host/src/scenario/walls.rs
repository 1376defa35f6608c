//! Which facets are obstacles made of? Reads their fields and mesh files; writes nothing, returns facets or names what is wrong.

use super::closed::closed;
use super::mesh::mesh;
use super::obstacle::ObstacleSpec;
use super::problem::Problem;
use super::side::Made;
use super::standing::Inside;
use std::path::Path;

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

/// All facets of obstacle `number`, and how a place inside of it is recognised, if it is solid.
///
/// # Errors
/// When a file cannot be read or has no mesh, when a triangle has no area, and when a mesh has a hole that must have none.
pub fn walls(
    (number, obstacle): (usize, &ObstacleSpec),
    folder: &Path,
    made: Made,
) -> Result<(Option<Inside>, Vec<Wall>), Problem> {
    let told = |why: String| {
        let (path, name) =
            (format!("obstacle.{number}.{}", obstacle.field()), obstacle.file.as_ref());
        let name = name.map_or(String::new(), |file| format!("{}: ", file.display()));
        Problem { path, offset: None, message: format!("obstacle {number}: {name}{why}") }
    };
    let facets = facets(obstacle, folder).map_err(told)?;
    let inside = inside(obstacle, &facets).map_err(told)?;
    let wall = |corners: Vec<[f64; 3]>| Wall {
        corners,
        made,
        speed: obstacle.speed,
        obstacle: number,
        motion: None,
    };
    Ok((inside, facets.into_iter().map(wall).collect()))
}

/// The corners of all facets, where they stand.
fn facets(obstacle: &ObstacleSpec, folder: &Path) -> Result<Vec<Vec<[f64; 3]>>, String> {
    let mut facets = match &obstacle.file {
        Some(file) => mesh(&folder.join(file), obstacle.unit.unwrap_or(1.0))?,
        None => listed(obstacle),
    };
    let shift = padded(&obstacle.at);
    for corner in facets.iter_mut().flatten() {
        *corner = std::array::from_fn(|k| corner[k] + shift[k]);
    }
    for (k, facet) in facets.iter().enumerate() {
        good(facet).map_err(|why| format!("{} {k} {why}", obstacle.piece()))?;
    }
    Ok(facets)
}

/// How a place inside is recognised, if the obstacle is solid; a mesh of which it is said must be closed.
fn inside(obstacle: &ObstacleSpec, facets: &[Vec<[f64; 3]>]) -> Result<Option<Inside>, String> {
    let inside = match obstacle.piece() {
        "triangle" if obstacle.closed || obstacle.solid => closed(facets)?,
        _ => Inside::Wound,
    };
    Ok(obstacle.solid.then_some(inside))
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

/// The corners of a facet must be numbers and span something.
fn good(facet: &[[f64; 3]]) -> Result<(), String> {
    if let Some(corner) = facet.iter().find(|corner| corner.iter().any(|x| !x.is_finite())) {
        return Err(format!("has a corner at {corner:?}, must be finite"));
    }
    let to = |k: usize| -> [f64; 3] { std::array::from_fn(|axis| facet[k][axis] - facet[0][axis]) };
    let norm = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (what, is_good) = match facet.len() {
        2 => ("length", norm(to(1)) > 0.0),
        _ => {
            let ([a, b, c], [d, e, f]) = (to(1), to(2));
            let across = norm([b * f - c * e, c * d - a * f, a * e - b * d]);
            ("area", across > 1e-12 * norm(to(1)) * norm(to(2)))
        }
    };
    is_good.then_some(()).ok_or_else(|| format!("has no {what}: its corners are {facet:?}"))
}
