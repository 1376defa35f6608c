//! How does a plane move? As a vibrating plate, or steadily; reads a time, writes nothing.
//!
//! With the feature `plates`; else `no_plates.rs` is in its place.

use super::plane_motion::PlaneMotion;
use crate::scalar::{Instant, Scalar};

/// A plate's sinusoidal motion along its normal, z₀(t) = A₀ sin(2π (f t + φ)) (L94, Eq. 1).
///
/// # Units
/// Amplitude A₀ in units of length (negative: against the normal), frequency f in cycles per unit of
/// time, phase φ in turns. A box shaken as one has the amplitude A₀ on its floor and −A₀ on its lid.
///
/// Phases are taken from the exact [`Instant`] of the epoch, so that they do not drift, however long
/// a world runs.
///
/// There are such planes with the feature `plates`, which is on by default; without it a program has no code for them.
///
/// ```
/// use carom::space::Vibration;
/// let shaker = Vibration::new(1.0e-3, 20.0); // 1 mm at 20 Hz
/// let alpha = shaker.peak_acceleration() / 9.81;
/// assert!((alpha - 1.61_f64).abs() < 0.01);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vibration<S> {
    /// A₀.
    pub amplitude: S,
    /// f > 0.
    pub frequency: S,
    /// φ at [`Instant::START`], in turns.
    pub phase: S,
    /// The phase at the world's epoch, in turns.
    turn: S,
}

/// A plane's steady motion along its normal: a piston. It is at its offset at [`Instant::START`]. With the feature `plates`.
///
/// ```
/// use carom::{Grain, Memory, World, law::HardSphere};
/// use carom::space::{Drift, Plane, Surface};
/// // A piston that comes at speed 1 turns a ball round at twice its speed.
/// let mut memory = Memory::<f64, 1, 1>::new();
/// let mut world = World::builder(&mut memory)
///     .plane(Plane::new([1.0], -1.0, Surface::Hard(1.0)).drifting(Drift::new(1.0)))
///     .rule(HardSphere { restitution: 1.0 })
///     .grain(Grain::with_mass(0.5, 1.0).at([0.5]))?
///     .start()?;
/// world.advance_to(2.0)?;
/// assert_eq!(world.grain(0).unwrap().velocity[0], 2.0);
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Drift<S> {
    /// Its speed, positive towards the grains.
    pub speed: S,
    /// How far it had come at the world's epoch.
    place: S,
}

impl<S: Scalar> Drift<S> {
    /// A plane that goes on at this speed.
    ///
    /// # Units
    /// Length over time.
    #[must_use]
    pub fn new(speed: S) -> Self {
        Self { speed, place: S::zero() }
    }

    /// A plane that is at its offset now.
    pub(super) fn passing(speed: S, now: S) -> Self {
        Self { speed, place: -(speed * now) }
    }

    /// Its speed.
    pub(crate) fn rate(&self) -> S {
        self.speed
    }

    /// The plane's motion at a time since the epoch.
    pub(crate) fn at(&self, now: S) -> PlaneMotion<S> {
        let place = self.place + self.speed * now;
        PlaneMotion { place, speed: self.speed, acceleration: S::zero() }
    }

    /// How far it has come at a new epoch, from the exact time of it: nothing adds up.
    pub(super) fn set_epoch(&mut self, epoch: Instant) {
        self.place = S::from_f64(self.speed.to_f64() * epoch.as_f64());
    }
}

impl<S: Scalar> Vibration<S> {
    /// A plate of this amplitude and frequency that starts upwards through its mean position.
    #[must_use]
    pub fn new(amplitude: S, frequency: S) -> Self {
        Self { amplitude, frequency, phase: S::zero(), turn: S::zero() }
    }

    /// The same plate, starting at this phase, in turns.
    #[must_use]
    pub fn starting_at(self, phase: S) -> Self {
        Self { phase, turn: phase, ..self }
    }

    /// A₀, φ and f.
    pub(crate) fn parameters(&self) -> [S; 3] {
        [self.amplitude, self.phase, self.frequency]
    }

    /// A₀.
    pub(crate) fn swing(&self) -> S {
        self.amplitude
    }

    /// ω = 2π f.
    #[must_use]
    pub fn angular_frequency(&self) -> S {
        S::from_f64(core::f64::consts::TAU) * self.frequency
    }

    /// |A₀| ω.
    #[must_use]
    pub fn peak_speed(&self) -> S {
        self.amplitude.abs() * self.angular_frequency()
    }

    /// |A₀| ω²; L94's α is this in units of gravity.
    #[must_use]
    pub fn peak_acceleration(&self) -> S {
        let omega = self.angular_frequency();
        self.amplitude.abs() * omega * omega
    }

    /// Sine and cosine of the phase at a time since the epoch.
    pub(crate) fn phase_at(&self, now: S) -> (S, S) {
        let turns = S::phase(self.turn, self.frequency, now);
        (S::from_f64(core::f64::consts::TAU) * turns).sin_cos()
    }

    /// The plate's motion at a time since the epoch.
    pub(crate) fn at(&self, now: S) -> PlaneMotion<S> {
        let (sin, cos) = self.phase_at(now);
        let omega = self.angular_frequency();
        let place = self.amplitude * sin;
        PlaneMotion {
            place,
            speed: self.amplitude * cos * omega,
            acceleration: -(place * omega * omega),
        }
    }

    /// The phase at a new epoch, from the whole number of periods passed: nothing adds up.
    pub(super) fn set_epoch(&mut self, epoch: Instant) {
        self.turn = S::phase_at(self.phase, self.frequency, epoch);
    }
}
