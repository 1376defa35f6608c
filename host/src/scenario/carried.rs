//! Where have obstacles that move come to? Reads a start and a time; writes the corners of its facets.

use super::start::Start;

impl Start {
    /// The same with obstacles that move where they are at a time.
    #[must_use]
    pub fn at(mut self, time: f64) -> Self {
        for wall in &mut self.walls {
            let motion = wall.motion.and_then(|number| self.motions.get(usize::from(number)));
            if let Some(motion) = motion {
                wall.corners.iter_mut().for_each(|corner| *corner = motion.carried(*corner, time));
            }
        }
        self
    }
}
