//! Who overlaps whom? Reads grains and box; writes nothing, returns flags.

use super::side::{Made, Placed, Side};
use super::start::Start;

/// Whether each grain overlaps something.
///
/// Sweeps along the first axis, so that large systems take O(N log N) as long as they are dilute.
pub fn touching(start: &Start, grains: &[Placed]) -> Vec<bool> {
    let mut flags: Vec<bool> = grains.iter().map(|grain| on_wall(start, grain)).collect();
    let widest = 2.0 * grains.iter().map(|grain| grain.radius).fold(0.0, f64::max);
    let mut order: Vec<(f64, usize)> =
        grains.iter().enumerate().map(|(i, grain)| (grain.position[0], i)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    // A second round, one period further on, for pairs across the periodic face.
    let again: Vec<(f64, usize)> = match start.sides[0] {
        Side::Periodic([from, to]) => {
            let near = order.iter().take_while(|(x, _)| *x < from + widest);
            near.map(|(x, i)| (x + to - from, *i)).collect()
        }
        _ => Vec::new(),
    };
    for (place, (x, i)) in order.iter().enumerate() {
        let rest = order[place + 1..].iter().chain(&again);
        for (_, j) in rest.take_while(|(other, _)| other - x < widest) {
            if i != j && overlap(start, &grains[*i], &grains[*j]) {
                flags[*i] = true;
                flags[*j] = true;
            }
        }
    }
    flags
}

fn overlap(start: &Start, a: &Placed, b: &Placed) -> bool {
    let square: f64 = start.nearest(&a.position, &b.position).iter().map(|x| x * x).sum();
    square < (a.radius + b.radius).powi(2)
}

fn on_wall(start: &Start, grain: &Placed) -> bool {
    start.sides.iter().zip(grain.position).any(|(side, x)| match *side {
        Side::Periodic(_) | Side::Plate(_, Made::Hard(_)) | Side::Walls(_, Made::Hard(_), _) => {
            false
        }
        // Wherever a wall is now, it is not further in.
        _ => {
            let [low, high] = side.room();
            low.is_some_and(|low| x - low < grain.radius)
                || high.is_some_and(|high| high - x < grain.radius)
        }
    })
}
