//! Where are the obstacles of a scenario kept? Reads a start; writes memory that worlds borrow.

use crate::scenario::{Made, Motion, Start, Wall};
use carom::particle::Index;
use carom::space::{Facet, RigidMotion, Surface};
use carom::world::ObstacleBuffers;

/// Facets, and places for their lists.
pub struct Obstacles<const D: usize> {
    facets: Vec<Facet<f64, D>>,
    lists: Vec<Index>,
    motions: Vec<RigidMotion<f64, D>>,
}

/// So many places in lists a facet has on average: cells are about as wide as facets then.
const PLACES: usize = 32;

impl<const D: usize> Obstacles<D> {
    /// Those of a start.
    pub fn new(start: &Start) -> Self {
        let facets: Vec<_> = start.walls.iter().map(facet).collect();
        let motions: Vec<_> = start.motions.iter().map(motion).collect();
        let lists = vec![Index::default(); (PLACES + 2) * (facets.len() + motions.len())];
        Self { facets, lists, motions }
    }

    /// Lends them.
    pub fn buffers(&mut self) -> ObstacleBuffers<'_, f64, D> {
        let motions = &mut self.motions;
        ObstacleBuffers { facets: &self.facets, lists: &mut self.lists, motions }
    }
}

fn facet<const D: usize>(wall: &Wall) -> Facet<f64, D> {
    let corner = |k: usize| wall.corners.get(k).copied().unwrap_or_default();
    let corners = std::array::from_fn(|k| std::array::from_fn(|axis| corner(k)[axis]));
    let facet = Facet::new(corners, surface(wall.made));
    let facet = wall.motion.map_or(facet, |motion| facet.moving(motion));
    if wall.speed == 0.0 {
        return facet;
    }
    let [from, to] = [corner(0), corner(1)];
    let along: [f64; D] = std::array::from_fn(|axis| to[axis] - from[axis]);
    let length = along.iter().map(|x| x * x).sum::<f64>().sqrt();
    facet.running(along.map(|x| x / length * wall.speed))
}

/// How an obstacle moves.
fn motion<const D: usize>(motion: &Motion) -> RigidMotion<f64, D> {
    let vector = |v: &[f64; 3]| std::array::from_fn(|axis| v[axis]);
    match motion {
        Motion::Drift(velocity) => RigidMotion::drifting(vector(velocity)),
        Motion::Vibration { amplitude, frequency, phase } => {
            RigidMotion::vibrating(vector(amplitude), *frequency).starting_at(*phase)
        }
        Motion::Rotation { centre, angular_velocity } => {
            RigidMotion::turning_about(vector(centre), *angular_velocity)
        }
    }
}

/// What a wall of this does.
pub const fn surface(made: Made) -> Surface<f64> {
    match made {
        Made::Soft => Surface::Rule,
        Made::Hard(restitution) => Surface::Hard(restitution),
        Made::Of(material) => Surface::Material(material),
    }
}
