//! How do the images of a sheared box move? Reads the box and time; writes nothing.
//!
//! Lees & Edwards, J. Phys. C 5, 1921 (1972): above and below a box that is periodic along its gradient lie images
//! that move along the flow. So a steady linear flow has no walls, and each place in it is like any other.

use super::periodic_axis::PeriodicAxis;
use crate::error::{Error, Subject};
use crate::scalar::{Instant, Scalar, Vector, component};

/// A steady shear of a periodic box: the velocity along one axis, the flow, grows along another, the gradient. With the
/// feature `shear`.
///
/// The image above the box moves along the flow by rate × height a time unit, the image below backwards. A grain that
/// leaves the box through a sheared face comes in at the other side, moved as that image is and with its velocity.
///
/// ```
/// use carom::{Grain, Memory, World, law::HardSphere, space::Shear};
/// let mut memory = Memory::<f64, 2, 1>::new();
/// let mut world = World::builder(&mut memory)
///     .periodic([[0.0, 8.0], [0.0, 4.0]])
///     .sheared(Shear::new(0, 1, 0.5)) // the image above moves by 0.5 × 4 a time unit
///     .rule(HardSphere { restitution: 0.9 })
///     .grain(Grain::with_mass(0.5, 1.0).at([1.0, 3.0]).moving([0.0, 1.0]))?
///     .start()?;
/// world.advance_to(2.0)?;
/// let grain = world.grain(0).unwrap();
/// assert_eq!(<[f64; 2]>::from(grain.velocity), [-2.0, 1.0]); // that of the image below
/// assert_eq!(<[f64; 2]>::from(grain.position), [5.0, 1.0]); // at time 1 it had moved by 2 to 1 − 2 = 7, and two more since
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shear<S> {
    /// The axis along which images move.
    pub flow: usize,
    /// The axis along which the flow's velocity grows.
    pub gradient: usize,
    /// The shear rate γ̇: by how much it grows with length.
    pub rate: S,
    #[cfg(not(feature = "shear"))]
    never: Never,
}

/// Without the feature `shear` there is none: what has this in it has no value, and nothing is compiled for it.
#[cfg(not(feature = "shear"))]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum Never {}

impl<S: Scalar> Shear<S> {
    /// The velocity along the axis `flow` grows by `rate` with each unit of length along the axis `gradient`.
    ///
    /// # Units
    /// Of the rate: one over time.
    #[cfg(feature = "shear")]
    #[must_use]
    pub fn new(flow: usize, gradient: usize, rate: S) -> Self {
        Self { flow, gradient, rate }
    }
}

/// The images of a sheared box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Images<S> {
    pub shear: Shear<S>,
    /// The gradient axis.
    pub across: PeriodicAxis<S>,
    /// How long the flow axis is, and what rounds to its lattice.
    length: S,
    lattice: S,
    /// How fast the image above moves along the flow.
    pub speed: S,
    /// The same without its sign, in lengths of the flow axis.
    frequency: S,
    /// How far it had come at the world's epoch, in the same.
    turn: S,
}

impl<S: Scalar> Images<S> {
    /// Those of a box with these axes; none if nothing moves.
    ///
    /// # Errors
    /// [`Error::Input`] for an axis that is not periodic, or for a rate that is none.
    pub fn new(
        shear: Shear<S>,
        [along, across]: [Option<PeriodicAxis<S>>; 2],
        lattice: S,
    ) -> Result<Option<Self>, Error> {
        let no =
            |axis, wanted| Err(Error::input(Subject::Axis(axis), "shear", axis as f64, wanted));
        if shear.flow == shear.gradient {
            return no(shear.flow, "two axes: the flow's, and another for its gradient");
        }
        let wanted = "two periodic axes: make this one periodic, too";
        let Some(along) = along else { return no(shear.flow, wanted) };
        let Some(across) = across else { return no(shear.gradient, wanted) };
        let frequency = (shear.rate.abs() * across.length) / along.length;
        let speed = frequency * along.length;
        let is_slow = frequency > S::zero() && Instant::from(S::one() / frequency) > Instant::START;
        let fits = frequency == S::zero() || is_slow && speed.is_finite() && speed.in_range();
        if !fits || !shear.rate.is_finite() {
            let wanted = "finite, and such that rate times height is a speed";
            return Err(Error::input(Subject::World, "shear rate", shear.rate.to_f64(), wanted));
        }
        let speed = if shear.rate < S::zero() { -speed } else { speed };
        let turn = S::zero();
        let images = Self { shear, across, length: along.length, lattice, speed, frequency, turn };
        Ok((frequency > S::zero()).then_some(images))
    }

    /// From now on clocks count from this epoch. From the exact number of lengths passed: nothing adds up.
    pub fn set_epoch(&mut self, epoch: Instant) {
        self.turn = S::phase_at(S::zero(), self.frequency, epoch);
    }

    /// How far the image above has come along the flow by a time, less whole lengths: between −1/2 and 1/2 of one, and
    /// on the lattice of positions. A function of time alone, whoever asks.
    pub fn offset(&self, time: S) -> S {
        let turns = S::phase(self.turn, self.frequency, time);
        let turns = if turns > S::half() { turns - S::one() } else { turns };
        let come = ((turns * self.length) + self.lattice) - self.lattice;
        if self.speed < S::zero() { -come } else { come }
    }

    /// In which image above (1), below (−1) or beside (0) the separation a − b across the gradient is the smallest: b's.
    pub fn nearest_row(&self, apart: S) -> S {
        let half = self.across.length * S::half();
        if apart > half {
            S::one()
        } else if apart < -half {
            -S::one()
        } else {
            S::zero()
        }
    }

    /// What moves a body, or a separation, to the image that is so many rows further up, at a time: to be added to its
    /// position, and to its velocity.
    pub fn image<const D: usize>(&self, rows: S, time: S) -> [Vector<S, D>; 2] {
        let Shear { flow, gradient, .. } = self.shear;
        let (mut place, mut velocity) = (Vector::zeros(), Vector::zeros());
        put(&mut place, flow, rows * self.offset(time));
        put(&mut place, gradient, rows * self.across.length);
        put(&mut velocity, flow, rows * self.speed);
        [place, velocity]
    }

    /// The same image at another time: what [`Images::image`] gives then, in that one of its copies along the flow in
    /// which it was here, moved on steadily.
    pub fn continued<const D: usize>(
        &self,
        rows: S,
        (here, time): (S, S),
        then: S,
    ) -> [Vector<S, D>; 2] {
        let [mut place, velocity] = self.image(rows, then);
        let x = component(&place, self.shear.flow);
        let moved = here + rows * self.speed * (then - time);
        let lengths = ((moved - x) / self.length + S::half()).floor();
        put(&mut place, self.shear.flow, x + lengths * self.length);
        [place, velocity]
    }

    /// In how many rows above the box something lies; 0 in the box.
    pub fn row_of<const D: usize>(&self, position: &Vector<S, D>) -> S {
        let y = component(position, self.shear.gradient);
        ((y - self.across.low) / self.across.length).floor()
    }

    /// How fast the steady flow is at a place: it stands in the middle of the box.
    pub fn flow_at<const D: usize>(&self, position: &Vector<S, D>) -> Vector<S, D> {
        let middle = self.across.low + self.across.length * S::half();
        let above = component(position, self.shear.gradient) - middle;
        let mut velocity = Vector::zeros();
        put(&mut velocity, self.shear.flow, self.shear.rate * above);
        velocity
    }
}

/// Writes a component of a vector; nothing for an axis that there is not.
fn put<S: Scalar, const D: usize>(v: &mut Vector<S, D>, axis: usize, x: S) {
    if let Some(place) = v.get_mut(axis) {
        *place = x;
    }
}
