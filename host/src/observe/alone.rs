//! What does a grain gain where it touches a wall or an obstacle? Reads it before and after; writes nothing.

use carom::nalgebra::SVector;
use carom::{Grain, View};

/// A grain at a plane or a facet, before they know of each other.
#[derive(Clone, Copy, Debug)]
pub struct Alone<const D: usize> {
    number: usize,
    /// As it was.
    pub grain: Grain<f64, D>,
    /// Its angular velocity.
    spin: [f64; 3],
}

/// What a grain has gained since.
pub struct Gained<const D: usize> {
    /// m v.
    pub momentum: SVector<f64, D>,
    /// I ω.
    pub spin: [f64; 3],
    /// Kinetic, of its rotation, too.
    pub energy: f64,
}

impl<const D: usize> Alone<D> {
    /// As it is now.
    pub fn new(number: usize, view: &View<'_, f64, D>) -> Option<Self> {
        let spin = view.angular_velocity(number).unwrap_or_default();
        Some(Self { number, grain: view.grain(number)?, spin })
    }

    /// What it has gained since, I/(m R²) being this.
    pub fn gained(&self, view: &View<'_, f64, D>, inertia: f64) -> Option<Gained<D>> {
        let Self { number, grain, spin } = self;
        let now = Self::new(*number, view)?;
        let moment = inertia * grain.mass * grain.radius * grain.radius;
        Some(Gained {
            momentum: (now.grain.velocity - grain.velocity) * grain.mass,
            spin: std::array::from_fn(|axis| moment * (now.spin[axis] - spin[axis])),
            energy: now.energy(inertia) - self.energy(inertia),
        })
    }

    fn energy(&self, inertia: f64) -> f64 {
        let Self { grain, .. } = self;
        0.5 * grain.mass * grain.velocity.norm_squared() + self.rotational_energy(inertia)
    }

    /// I ω²/2.
    pub fn rotational_energy(&self, inertia: f64) -> f64 {
        let square: f64 = self.spin.iter().map(|w| w * w).sum();
        0.5 * inertia * self.grain.mass * self.grain.radius.powi(2) * square
    }
}
