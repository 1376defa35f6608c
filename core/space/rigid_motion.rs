//! How does a group of facets move? As one body: it vibrates, goes on steadily or turns; reads a time, writes nothing.

use super::grid::Grid;
use super::pose::Pose;
use crate::scalar::{Axial, Instant, Scalar, Vector, component, norm};

/// How a group of an obstacle's facets moves: as a rigid body that vibrates, goes on steadily or turns at a constant rate.
/// Corners of its facets are where they are at [`Instant::START`](crate::Instant::START), but of a group that vibrates,
/// whose corners are in the middle of its way. With the feature `plates`.
///
/// Facets say by [`Facet::moving`](super::Facet::moving) which motion is theirs; the world borrows the motions from
/// [`WithObstacles::moving`](crate::world::WithObstacles::moving).
///
/// # Units
/// Lengths, times and speeds are those of the grains; an angular velocity is in radians over time.
///
/// ```
/// use carom::law::HardSphere;
/// use carom::space::{Facet, RigidMotion, Surface};
/// use carom::world::WithObstacles;
/// use carom::{Grain, Memory, World};
///
/// // A bat of length 2 turns about the origin, once in 2π, and meets a ball a quarter of a turn on.
/// let bat = Facet::new([[0.0, 0.0], [-2.0, 0.0]], Surface::Hard(1.0)).moving(0);
/// let mut memory = WithObstacles::new(Memory::<f64, 2, 1>::new(), [bat], [Default::default(); 16])
///     .moving([RigidMotion::<f64, 2>::turning([0.0, 0.0], 1.0)]);
/// let mut world = World::builder(&mut memory)
///     .rule(HardSphere { restitution: 1.0 })
///     .grain(Grain::with_mass(0.6, 1.0).at([0.0, -1.0]))?
///     .start()?;
/// world.advance_to(1.0)?;
/// // It meets it where the bat's speed is 0.8, and an elastic ball leaves twice as fast.
/// assert!((world.grain(0).unwrap().velocity.norm() - 1.6).abs() < 1e-12);
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMotion<S: Scalar, const D: usize> {
    course: Course<S, D>,
    /// How far the group had come at the world's epoch.
    place: Vector<S, D>,
    /// The same in turns.
    turn: S,
    /// Its facets' lists, written when the world starts.
    pub(super) lists: Option<Listed<S, D>>,
}

/// Where a group's lists are, and from where its facets are seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Listed<S: Scalar, const D: usize> {
    pub grid: Grid<S, D>,
    /// Where its lists begin.
    pub first: u32,
    /// So far a grain may go from its cell, and sees what it can touch.
    pub margin: S,
}

/// What it does.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Course<S: Scalar, const D: usize> {
    /// s(t) = A₀ sin(2π (f t + φ)).
    Vibrates { amplitude: Vector<S, D>, frequency: S, phase: S },
    /// s(t) = u t.
    Drifts { velocity: Vector<S, D> },
    /// Turned by 2π f t about an axis through the centre.
    Turns { centre: Vector<S, D>, axis: Axial<S>, frequency: S },
}

impl<S: Scalar, const D: usize> RigidMotion<S, D> {
    /// A group that vibrates along a vector, s(t) = A₀ sin(2π f t): it starts in the middle, along the vector.
    #[must_use]
    pub fn vibrating(amplitude: [S; D], frequency: S) -> Self {
        let amplitude = Vector::from(amplitude);
        Self::new(Course::Vibrates { amplitude, frequency, phase: S::zero() })
    }

    /// The same, starting at this phase, in turns. What does not vibrate starts as before.
    #[must_use]
    pub fn starting_at(self, phase: S) -> Self {
        match self.course {
            Course::Vibrates { amplitude, frequency, .. } => {
                let course = Course::Vibrates { amplitude, frequency, phase };
                Self { turn: phase, ..Self::new(course) }
            }
            _ => self,
        }
    }

    /// A group that goes on steadily.
    #[must_use]
    pub fn drifting(velocity: [S; D]) -> Self {
        Self::new(Course::Drifts { velocity: Vector::from(velocity) })
    }

    /// A group that turns about the axis through a point along the angular velocity, in any dimension: in the plane only
    /// the last of the three components counts.
    #[must_use]
    pub fn turning_about(centre: [S; D], angular_velocity: [S; 3]) -> Self {
        let angular_velocity = Axial::from(angular_velocity);
        let angular_velocity = match D {
            3 => angular_velocity,
            _ => Axial::new(S::zero(), S::zero(), component(&angular_velocity, 2)),
        };
        let rate = norm(&angular_velocity);
        let axis = if rate > S::zero() { angular_velocity / rate } else { angular_velocity };
        let frequency = rate / S::from_f64(core::f64::consts::TAU);
        Self::new(Course::Turns { centre: Vector::from(centre), axis, frequency })
    }

    fn new(course: Course<S, D>) -> Self {
        Self { course, place: Vector::zeros(), turn: S::zero(), lists: None }
    }

    /// Where it is, and how it moves, at a time since the epoch.
    pub(crate) fn at(&self, now: S) -> Pose<S, D> {
        match self.course {
            Course::Vibrates { amplitude, frequency, .. } => {
                let (sin, cos) = self.angle(frequency, now);
                let omega = S::from_f64(core::f64::consts::TAU) * frequency;
                Pose::shifted(amplitude * sin, amplitude * (cos * omega))
            }
            Course::Drifts { velocity } => Pose::shifted(self.place + velocity * now, velocity),
            Course::Turns { centre, axis, frequency } => {
                let omega = S::from_f64(core::f64::consts::TAU) * frequency;
                Pose::turned(centre, axis * omega, (axis, self.angle(frequency, now)))
            }
        }
    }

    /// Sine and cosine of its phase.
    fn angle(&self, frequency: S, now: S) -> (S, S) {
        let turns = S::phase(self.turn, frequency, now);
        (S::from_f64(core::f64::consts::TAU) * turns).sin_cos()
    }

    /// From now on clocks count from this epoch: places are taken from the exact time, and nothing adds up.
    pub(super) fn set_epoch(&mut self, epoch: Instant) {
        match self.course {
            Course::Vibrates { frequency, phase, .. } => {
                self.turn = S::phase_at(phase, frequency, epoch);
            }
            Course::Drifts { velocity } => {
                self.place = velocity.map(|u| S::from_f64(u.to_f64() * epoch.as_f64()));
            }
            Course::Turns { frequency, .. } => {
                self.turn = S::phase_at(S::zero(), frequency, epoch);
            }
        }
    }

    /// ω of one that turns; of others 0.
    pub(crate) fn turning_rate(&self) -> S {
        match self.course {
            Course::Turns { frequency, .. } => S::from_f64(core::f64::consts::TAU) * frequency,
            _ => S::zero(),
        }
    }

    /// How far it swings from its middle, if it vibrates.
    pub(crate) fn swing(&self) -> Option<S> {
        match self.course {
            Course::Vibrates { amplitude, .. } => Some(norm(&amplitude)),
            _ => None,
        }
    }

    /// The largest speed and acceleration of its points, of which the furthest corner from the axis is this far.
    pub(crate) fn peaks(&self, radius: S) -> [S; 2] {
        let tau = S::from_f64(core::f64::consts::TAU);
        match self.course {
            Course::Vibrates { amplitude, frequency, .. } => {
                let speed = norm(&amplitude) * (tau * frequency);
                [speed, speed * (tau * frequency)]
            }
            Course::Drifts { velocity } => [norm(&velocity), S::zero()],
            Course::Turns { frequency, .. } => {
                let speed = radius * (tau * frequency);
                [speed, speed * (tau * frequency)]
            }
        }
    }

    /// The point about which it turns; of others none.
    pub(crate) fn centre(&self) -> Option<&Vector<S, D>> {
        match &self.course {
            Course::Turns { centre, .. } => Some(centre),
            _ => None,
        }
    }

    /// The box in which a corner is at any time; of one that drifts, in which it begins.
    pub(super) fn swept(&self, corner: &Vector<S, D>) -> [Vector<S, D>; 2] {
        let (from, reach) = match &self.course {
            Course::Vibrates { amplitude, .. } => (*corner, amplitude.map(S::abs)),
            Course::Drifts { .. } => (*corner, Vector::zeros()),
            Course::Turns { centre, .. } => {
                (*centre, Vector::from_element(norm(&(corner - centre))))
            }
        };
        [from - reach, from + reach]
    }

    /// How far beyond its facets' cells a position in their frame is: nothing of them can be touched before one has gone so
    /// far. 0 of one among them.
    pub(crate) fn beyond(&self, inside: &Vector<S, D>) -> S {
        let Some(listed) = &self.lists else { return S::zero() };
        let [low, high] = listed.grid.extent();
        let apart =
            inside.zip_zip_map(&low, &high, |x, low, high| (low - x).max(x - high).max(S::zero()));
        norm(&apart)
    }

    /// How far a grain can go from a position in their frame before it may touch what is not seen from there.
    pub(crate) fn clearance(&self, inside: &Vector<S, D>) -> S {
        let margin = self.lists.as_ref().map_or(S::zero(), |listed| listed.margin);
        self.beyond(inside).max(margin)
    }

    /// How far the furthest corner of its cells is from the centre about which it turns.
    pub(crate) fn reach(&self) -> S {
        let (Some(listed), Some(centre)) = (&self.lists, self.centre()) else { return S::NEVER };
        let [low, high] = listed.grid.extent();
        norm(&(low - centre).zip_map(&(high - centre), |low, high| low.abs().max(high.abs())))
    }

    /// Names and values of what describes it, and whether each must be above 0.
    pub(crate) fn fields(&self) -> impl Iterator<Item = (&'static str, S, bool)> + '_ {
        let (vector, frequency, phase) = match &self.course {
            Course::Vibrates { amplitude, frequency, phase } => {
                (("amplitude", amplitude), Some(*frequency), *phase)
            }
            Course::Drifts { velocity } => (("velocity", velocity), None, S::zero()),
            Course::Turns { centre, frequency, .. } => {
                (("centre of rotation", centre), Some(*frequency), S::zero())
            }
        };
        let rate = match self.course {
            Course::Turns { .. } => "angular velocity over 2 pi",
            _ => "frequency",
        };
        let (name, vector) = vector;
        let components = (0..D).map(move |axis| (name, component(vector, axis), false));
        let frequency = frequency.map(|f| (rate, f, true));
        components.chain(frequency).chain([("phase", phase, false)])
    }

    /// All numbers that tell it from others.
    pub(super) fn numbers(&self) -> impl Iterator<Item = S> + '_ {
        let axis = match &self.course {
            Course::Turns { axis, .. } => *axis,
            _ => Axial::zeros(),
        };
        let axis = [0, 1, 2].map(|k| component(&axis, k));
        self.fields().map(|(_, value, _)| value).chain(axis)
    }
}

impl<S: Scalar> RigidMotion<S, 2> {
    /// A group that turns about a point, anticlockwise for a positive angular velocity.
    #[must_use]
    pub fn turning(centre: [S; 2], angular_velocity: S) -> Self {
        Self::turning_about(centre, [S::zero(), S::zero(), angular_velocity])
    }
}

impl<S: Scalar> RigidMotion<S, 3> {
    /// A group that turns about the axis through a point along the angular velocity.
    #[must_use]
    pub fn turning(centre: [S; 3], angular_velocity: [S; 3]) -> Self {
        Self::turning_about(centre, angular_velocity)
    }
}
