//! Which world did JavaScript describe? Keeps the description until the world starts; reads it, builds the world.

use crate::rule::{ChosenRule, Material};
use carom::space::{MAX_PLANES, Plane, Surface, Vibration};
use carom::{Enduring, Error, Grain, Memory, World};

/// The dimension of this module's worlds.
pub const D: usize = if cfg!(feature = "line") {
    1
} else if cfg!(feature = "space") {
    3
} else {
    2
};
/// The most grains of a world.
pub const MAX_GRAINS: usize = 500;
/// Numbers that describe a grain: radius, mass, material, position, velocity.
pub const GRAIN_FIELDS: usize = 9;

/// A plane as it came: normal, offset, restitution (NaN: by the rule), amplitude, frequency (0: at rest), phase.
pub type Wall = [f64; 8];

/// Everything but the grains.
pub struct Description {
    /// One plane more than carom takes, so that the error is carom's.
    pub planes: heapless::Vec<Wall, { MAX_PLANES + 1 }>,
    /// Low and high end of the periodic axes.
    pub periodic: [Option<[f64; 2]>; 3],
    /// Gravity.
    pub gravity: [f64; 3],
    /// Whether contacts that last or crowd are integrated, or as in the papers.
    pub enduring: Enduring,
    /// How long a contact of hard grains lasts: the stand-in's, or t_c of the TC rule; NaN: as carom has it.
    pub contact_time: f64,
    /// Steps in a contact of a cluster; 0: as carom has it.
    pub steps: u32,
    /// What grains do when they touch.
    pub rule: ChosenRule,
}

impl Description {
    /// Empty space.
    pub const fn new() -> Self {
        let rule = ChosenRule { material: Material::Hard(1.0), lasting: false, outside: None };
        Self {
            planes: heapless::Vec::new(),
            periodic: [None; 3],
            gravity: [0.0; 3],
            enduring: Enduring::Integrated,
            contact_time: f64::NAN,
            steps: 0,
            rule,
        }
    }

    /// The world, started in this memory.
    pub fn start(
        &self,
        memory: &'static mut Memory<f64, D, MAX_GRAINS>,
        grains: &[[f64; GRAIN_FIELDS]],
    ) -> Result<World<'static, f64, D, ChosenRule>, Error> {
        let mut builder = World::builder(memory)
            .enduring(self.enduring)
            .gravity(first(&self.gravity))
            .rule(self.rule);
        if !self.contact_time.is_nan() {
            builder = match self.enduring {
                Enduring::Paper => builder.tc(self.contact_time),
                _ => builder.contact_time(self.contact_time),
            };
        }
        if self.steps > 0 {
            builder = builder.steps_per_contact(self.steps);
        }
        for wall in &self.planes {
            builder = builder.plane(plane(wall));
        }
        for (axis, side) in self.periodic.iter().enumerate() {
            if let Some(side) = side {
                builder = builder.periodic_axis(axis, *side);
            }
        }
        builder.grains(grains.iter().map(grain))?.start()
    }
}

/// The first `D` numbers.
pub fn first(all: &[f64]) -> [f64; D] {
    core::array::from_fn(|i| all.get(i).copied().unwrap_or(0.0))
}

fn plane(wall: &Wall) -> Plane<f64, D> {
    let &[_, _, _, offset, restitution, amplitude, frequency, phase] = wall;
    let surface = if restitution.is_nan() { Surface::Rule } else { Surface::Hard(restitution) };
    let plane = Plane::new(first(wall), offset, surface);
    if frequency == 0.0 && amplitude == 0.0 {
        return plane;
    }
    plane.vibrating(Vibration::new(amplitude, frequency).starting_at(phase))
}

fn grain(fields: &[f64; GRAIN_FIELDS]) -> Grain<f64, D> {
    let &[radius, mass, material, ..] = fields;
    Grain::with_mass(radius, mass)
        .at(first(&fields[3..6]))
        .moving(first(&fields[6..9]))
        .of_material(material as u8)
}
