//! What does one step of velocity Verlet do? Reads a system and a law; writes positions and velocities a step on.

use super::leg::Leg;
use super::told::Push;
use crate::cells::Neighbours;
use crate::contact_law::End;
use crate::error::{ReferenceError, positive};
use crate::law::ForceLaw;
use crate::system::{Boundary, Grain, System};
use crate::vector::{Vector, length, plus};

/// How finely, and with which list.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct VerletOptions {
    /// Time steps per shortest contact; 50 unless told otherwise.
    pub steps_per_contact: f64,
    /// How far beyond contact the pair list reaches; `None` chooses the cheapest by estimate.
    pub skin: Option<f64>,
}

impl Default for VerletOptions {
    fn default() -> Self {
        Self { steps_per_contact: 50.0, skin: None }
    }
}

/// What a run has cost so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Statistics {
    /// Time steps.
    pub steps: u64,
    /// Contacts begun: a pair, or a grain and a wall, that came to overlap.
    pub contacts: u64,
    /// Distances computed.
    pub distances: u64,
    /// Contact forces computed.
    pub forces: u64,
    /// Pair lists made.
    pub lists: u64,
}

/// Force-based molecular dynamics as it is usually done: velocity Verlet, a fixed step, a pair
/// list from cells.
///
/// The step is the shortest contact's length over [`VerletOptions::steps_per_contact`], the
/// contact being that of the lightest (and largest) grains at the largest relative speed there is,
/// estimated by [`ContactLaw::contact_time`](crate::ContactLaw::contact_time); it is made shorter
/// when speeds grow.
///
/// Forces depend on velocities, which velocity Verlet knows only half a step earlier. They are
/// taken at v(t + dt/2) + a(t) dt/2, which is v(t + dt) to second order; so the whole scheme stays
/// of second order at one force computation a step. At the ends of a contact the force or its
/// slope jumps: there the order is lower, though the error stays small.
///
/// Cost: O(N) per step. Between two lists only the listed pairs are looked at; contact forces
/// touch only the grains they act on.
///
/// # Examples
///
/// ```
/// use carom_reference::{Boundary, End, ForceLaw, Grain, System, Verlet, VerletOptions};
/// let grain = |x: f64, v: f64| Grain { radius: 0.1, mass: 1.0, position: [x], velocity: [v] };
/// let system = System::new(vec![grain(0.0, 1.0), grain(1.0, -1.0)], [Boundary::Open], [0.0])?;
/// let law = ForceLaw::LinearDashpot { stiffness: 1e4, damping: 0.0 };
/// let mut run = Verlet::new(&system, law, End::Force, VerletOptions::default())?;
/// run.advance_to(1.0)?;
/// assert_eq!(run.statistics().contacts, 1);
/// assert!((run.velocity(0)[0] + 1.0).abs() < 1e-2);
/// # Ok::<(), carom_reference::ReferenceError>(())
/// ```
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Verlet<const D: usize> {
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::arrays"))]
    pub(super) positions: Vec<Vector<D>>,
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::arrays"))]
    pub(super) velocities: Vec<Vector<D>>,
    /// Contact accelerations, zero but for the grains in `loaded`.
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::arrays"))]
    pub(super) accelerations: Vec<Vector<D>>,
    pub(super) loaded: Vec<u32>,
    pub(super) radii: Vec<f64>,
    pub(super) masses: Vec<f64>,
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
    pub(super) boundary: [Boundary; D],
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
    pub(super) gravity: Vector<D>,
    pub(super) law: ForceLaw,
    pub(super) end: End,
    pub(super) options: VerletOptions,
    pub(super) skin: f64,
    pub(super) step: f64,
    /// The relative speed the step was chosen for.
    pub(super) designed: f64,
    pub(super) near: Neighbours<D>,
    /// How much of the skin may be used up.
    pub(super) used: f64,
    pub(super) fastest: f64,
    pub(super) touching: [Vec<u64>; 2],
    pub(super) pushes: Vec<Push<D>>,
    /// Σ r·F of the pairs in contact now, and its integral over time.
    pub(super) virial: [f64; 2],
    pub(super) statistics: Statistics,
    pub(super) now: f64,
    /// The steps under way, if any are.
    pub(super) leg: Option<Leg>,
    /// The time of the positions, also between two full steps.
    pub(super) clock: f64,
    /// Whether there is a contact now whose force matters, and the last instant with one.
    pub(super) pushed: bool,
    pub(super) touched: f64,
    pub(super) lightest: f64,
    pub(super) fastest_plate: f64,
}

impl<const D: usize> Verlet<D> {
    /// Starts at time 0.
    ///
    /// # Errors
    ///
    /// [`ReferenceError::Parameter`] for a bad law or bad options.
    pub fn new(
        system: &System<D>,
        law: ForceLaw,
        end: End,
        options: VerletOptions,
    ) -> Result<Self, ReferenceError> {
        law.validate()?;
        positive("steps_per_contact", options.steps_per_contact)?;
        options.skin.map_or(Ok(()), |skin| positive("skin", skin))?;
        let grains = system.grains();
        let mut run = Self {
            positions: grains.iter().map(|g| g.position).collect(),
            velocities: grains.iter().map(|g| g.velocity).collect(),
            accelerations: vec![[0.0; D]; grains.len()],
            loaded: Vec::new(),
            radii: grains.iter().map(|g| g.radius).collect(),
            masses: grains.iter().map(|g| g.mass).collect(),
            boundary: *system.boundary(),
            gravity: *system.gravity(),
            law,
            end,
            options,
            skin: 0.0,
            step: f64::INFINITY,
            designed: 0.0,
            near: Neighbours::default(),
            used: f64::INFINITY,
            fastest: 0.0,
            touching: [Vec::new(), Vec::new()],
            pushes: Vec::new(),
            virial: [0.0; 2],
            statistics: Statistics::default(),
            now: 0.0,
            leg: None,
            clock: 0.0,
            pushed: false,
            touched: f64::NEG_INFINITY,
            lightest: grains.iter().map(|g| g.mass).fold(f64::INFINITY, f64::min),
            fastest_plate: fastest_plate(system.boundary()),
        };
        run.prepare();
        run.push_all(0.0);
        Ok(run)
    }

    /// The time the run stands at.
    #[expect(clippy::misnamed_getters, reason = "that of the positions, also in a pause")]
    pub fn now(&self) -> f64 {
        self.clock
    }

    /// The largest step taken (s).
    pub fn time_step(&self) -> f64 {
        self.step
    }

    /// How many grains there are.
    #[expect(clippy::len_without_is_empty, reason = "there is always one")]
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// How far beyond contact the pair list reaches.
    pub fn skin(&self) -> f64 {
        self.skin
    }

    /// Pairs in the present list.
    pub fn listed(&self) -> usize {
        self.near.pairs.len()
    }

    /// What the run has cost so far.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// ∫ Σ r·F dt over all pairs since the start, r = r_i − r_j and F on grain i (J s): D V times the
    /// contacts' share of the pressure, summed over time.
    pub fn virial(&self) -> f64 {
        self.virial[1]
    }

    /// Where grain i is; in a periodic box, some image of it near the box.
    pub fn position(&self, i: usize) -> [f64; D] {
        self.positions[i]
    }

    /// How grain i moves.
    pub fn velocity(&self, i: usize) -> [f64; D] {
        self.present_velocity(i)
    }

    /// All grains as they are now.
    pub fn grains(&self) -> Vec<Grain<D>> {
        let grain = |i: usize| Grain {
            radius: self.radii[i],
            mass: self.masses[i],
            position: self.positions[i],
            velocity: self.present_velocity(i),
        };
        (0..self.positions.len()).map(grain).collect()
    }

    /// The system as it is now.
    ///
    /// # Errors
    ///
    /// As [`System::new`]; a soft grain's centre may have crossed a wall.
    pub fn system(&self) -> Result<System<D>, ReferenceError> {
        System::new(self.grains(), self.boundary, self.gravity)
    }
}

impl<const D: usize> Verlet<D> {
    pub(super) fn drift(&mut self, h: f64) {
        let velocities = self.velocities.as_flattened();
        for (r, v) in self.positions.as_flattened_mut().iter_mut().zip(velocities) {
            *r += h * v;
        }
        self.clock += h;
        self.used += 2.0 * h * self.fastest.max(self.fastest_plate);
    }

    pub(super) fn kick(&mut self, h: f64) {
        if self.gravity != [0.0; D] {
            let g = self.gravity.map(|g| h * g);
            self.velocities.iter_mut().for_each(|v| *v = plus(v, 1.0, &g));
            self.fastest += length(&g);
        }
        for &i in &self.loaded {
            let v = &mut self.velocities[i as usize];
            *v = plus(v, h, &self.accelerations[i as usize]);
            self.fastest = self.fastest.max(length(v));
            if !v[0].is_finite() {
                self.fastest = f64::NAN;
            }
        }
    }
}

/// The largest speed of any plate.
fn fastest_plate(boundary: &[Boundary]) -> f64 {
    let speed = |bound: &Boundary| match bound {
        Boundary::Plate(plate) => plate.fastest(),
        _ => 0.0,
    };
    boundary.iter().map(speed).fold(0.0, f64::max)
}
