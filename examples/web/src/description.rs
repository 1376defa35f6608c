//! Which world did JavaScript describe? Keeps the description until the world starts; reads it, builds the world.

use crate::lent::{D, Facets, Lent, WorldRule};
use crate::rule::{ChosenRule, Material};
#[cfg(feature = "rough")]
use carom::law::{Rough, Tangential};
use carom::space::{MAX_PLANES, Plane, Surface, Vibration};
use carom::{Enduring, Error, Grain, World};

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
    /// What stands inside the box.
    pub facets: Facets,
    /// What surfaces do.
    #[cfg(feature = "rough")]
    pub friction: Tangential<f64>,
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
            #[cfg(feature = "rough")]
            facets: Facets::new(),
            #[cfg(not(feature = "rough"))]
            facets: (),
            #[cfg(feature = "rough")]
            friction: Tangential::Walton { mu: 0.0, beta_0: 0.0 },
        }
    }

    /// What grains do when they touch, their surfaces too.
    #[cfg(not(feature = "rough"))]
    const fn world_rule(&self) -> WorldRule {
        self.rule
    }
    #[cfg(feature = "rough")]
    fn world_rule(&self) -> WorldRule {
        Rough::spheres(self.rule, self.friction)
    }

    /// The world, started in this memory.
    pub fn start(
        &self,
        memory: &'static mut Lent,
        grains: &[[f64; GRAIN_FIELDS]],
    ) -> Result<World<'static, f64, D, WorldRule>, Error> {
        let mut builder = World::builder(memory)
            .enduring(self.enduring)
            .gravity(first(&self.gravity))
            .rule(self.world_rule());
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

/// By the rule where there is no restitution.
pub fn surface(restitution: f64) -> Surface<f64> {
    if restitution.is_nan() { Surface::Rule } else { Surface::Hard(restitution) }
}

fn plane(wall: &Wall) -> Plane<f64, D> {
    let &[_, _, _, offset, restitution, amplitude, frequency, phase] = wall;
    let surface = surface(restitution);
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
