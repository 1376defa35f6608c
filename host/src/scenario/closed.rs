//! Is a mesh closed, and are its triangles turned alike? Reads corners; writes nothing, names the first open edge.

use super::standing::Inside;
use std::collections::HashMap;

/// An edge, from one corner to the next, by the bits of their components.
type Edge = [[u64; 3]; 2];

/// How a place inside of the mesh is recognised. Each edge must belong to two triangles.
///
/// # Errors
/// An edge that does not, with its triangle and its ends.
pub fn closed(triangles: &[Vec<[f64; 3]>]) -> Result<Inside, String> {
    // The first triangle, the number of the edge in it, how many go along it, and how many of them forwards.
    let mut edges: HashMap<Edge, (usize, usize, usize, usize)> = HashMap::new();
    let bits = |corner: [f64; 3]| corner.map(|x| (x + 0.0).to_bits());
    for (number, triangle) in triangles.iter().enumerate() {
        for k in 0..triangle.len() {
            let [from, to] = [triangle[k], triangle[(k + 1) % triangle.len()]].map(bits);
            let edge = if from < to { [from, to] } else { [to, from] };
            let (_, _, all, forwards) = edges.entry(edge).or_insert((number, k, 0, 0));
            (*all, *forwards) = (*all + 1, *forwards + usize::from(from < to));
        }
    }
    let open = edges.iter().filter(|(_, (_, _, all, _))| *all != 2);
    if let Some((edge, &(triangle, k, all, _))) = open.min_by_key(|(_, (t, k, ..))| (*t, *k)) {
        return Err(told(edge, (triangle, k), all));
    }
    let turned_alike = edges.values().all(|(_, _, _, forwards)| *forwards == 1);
    Ok(if turned_alike { Inside::Wound } else { Inside::Odd })
}

fn told(edge: &Edge, (triangle, k): (usize, usize), count: usize) -> String {
    let [from, to] = edge.map(|corner| corner.map(f64::from_bits));
    let belongs = match count {
        1 => "belongs to no other: there is a hole".to_owned(),
        _ => format!("belongs to {count} triangles"),
    };
    format!(
        "must be closed, but edge {k} of triangle {triangle}, from {from:?} to {to:?}, {belongs}"
    )
}
