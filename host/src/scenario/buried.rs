//! Is a grain inside of a solid obstacle? Reads a start; writes nothing, names grain and obstacle.

use super::clear::Obstacles;
use super::problem::Problem;
use super::start::Start;

/// The first grain whose centre is inside of a solid obstacle, as a problem; none if there is no such.
///
/// # Units
/// SI.
pub fn buried(start: &Start) -> Option<Problem> {
    if start.obstacles.iter().all(|one| one.inside.is_none()) {
        return None;
    }
    let obstacles = Obstacles::new(&start.walls, &start.motions, &start.obstacles);
    start.grains.iter().enumerate().find_map(|(grain, placed)| {
        let number = obstacles.around(&placed.position)?;
        let name = start.obstacles.get(number)?.named(number);
        let at = &placed.position[..start.dimension];
        let message = format!("grain {grain} is inside of {name}, which is solid: it is at {at:?}");
        Some(Problem { path: format!("grain.{grain}.at"), offset: None, message })
    })
}
