//! What is a wall, and where is it now? Planes at rest and vibrating plates; reads a time, writes nothing.

use crate::scalar::{Instant, Scalar, Vector, dot, vector};

/// What a plane does to a grain that touches it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Surface<S> {
    /// The world's rule decides: the law with infinite mass, without rotation.
    Rule,
    /// An instantaneous reflection with this coefficient of restitution, whatever the rule is.
    Hard(S),
}

/// A plate's sinusoidal motion along its normal, z₀(t) = A₀ sin(2π (f t + φ)) (L94, Eq. 1).
///
/// # Units
/// Amplitude A₀ in units of length (negative: against the normal), frequency f in cycles per unit of
/// time, phase φ in turns. A box shaken as one has the amplitude A₀ on its floor and −A₀ on its lid.
///
/// Phases are taken from the exact [`Instant`] of the epoch, so that they do not drift, however long
/// a world runs.
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

/// Where a plate is along its normal, how fast it moves, and its acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PlaneMotion<S> {
    /// z₀.
    pub place: S,
    /// ż₀.
    pub speed: S,
    /// z̈₀.
    pub acceleration: S,
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

/// A plane wall: grains stay where `normal · r ≥ offset` (plus their radius).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Plane<S: Scalar, const D: usize> {
    /// Unit vector into the allowed side.
    pub normal: Vector<S, D>,
    /// Distance of the plane (of a plate's mean position) from the origin along the normal.
    pub offset: S,
    /// What it does.
    pub surface: Surface<S>,
    /// How it moves; none if it stands still.
    pub vibration: Option<Vibration<S>>,
}

#[cfg(feature = "defmt")]
impl<S: Scalar + defmt::Format, const D: usize> defmt::Format for Plane<S, D> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(
            f,
            "Plane {{ normal: {}, offset: {}, surface: {}, vibration: {} }}",
            self.normal.as_slice(),
            self.offset,
            self.surface,
            self.vibration
        );
    }
}

impl<S: Scalar, const D: usize> Plane<S, D> {
    /// A place in memory that no plane has: all bits zero.
    pub(crate) const VACANT: Self = Self {
        normal: vector([S::ZERO; D]),
        offset: S::ZERO,
        surface: Surface::Rule,
        vibration: None,
    };

    /// A plane with this unit normal, at this distance from the origin along it, at rest.
    #[must_use]
    pub fn new(normal: [S; D], offset: S, surface: Surface<S>) -> Self {
        Self { normal: Vector::from(normal), offset, surface, vibration: None }
    }

    /// The same plane, vibrating along its normal about its offset.
    #[must_use]
    pub fn vibrating(self, vibration: Vibration<S>) -> Self {
        Self { vibration: Some(vibration), ..self }
    }

    /// The same plane, its normal of unit length to the last place if it was to five digits.
    #[inline(never)]
    pub(crate) fn with_unit_normal(self) -> Self {
        let square = dot(&self.normal, &self.normal);
        let is_near = (square - S::one()).abs() <= S::from_f32(1e-5).max(S::RESOLUTION);
        if square == S::one() || !is_near {
            return self;
        }
        Self { normal: self.normal / square.sqrt(), ..self }
    }

    /// The plane at `at` across `axis`, allowing what is above it (or below).
    pub(crate) fn across(axis: usize, at: S, above: bool, surface: Surface<S>) -> Self {
        let sign = if above { S::one() } else { -S::one() };
        let mut normal = [S::zero(); D];
        if let Some(n) = normal.get_mut(axis) {
            *n = sign;
        }
        Self::new(normal, sign * at, surface)
    }

    /// Where it is now along its normal, about its offset; a plane at rest does not move.
    pub(crate) fn motion(&self, now: S) -> PlaneMotion<S> {
        let still = PlaneMotion { place: S::zero(), speed: S::zero(), acceleration: S::zero() };
        self.vibration.map_or(still, |v| v.at(now))
    }

    /// How far a grain of this radius, centred there, is from touching; negative if it overlaps.
    pub(crate) fn gap(&self, position: &Vector<S, D>, radius: S, now: S) -> S {
        let mean = self.mean_gap(position, radius);
        self.vibration.map_or(mean, |v| mean - v.at(now).place)
    }

    /// How far a grain is from touching the plane's mean position.
    pub(crate) fn mean_gap(&self, position: &Vector<S, D>, radius: S) -> S {
        dot(&self.normal, position) - self.offset - radius
    }
}
