//! What does an exact run hold, and what comes next in it? Reads a system and a law; writes the next event and the state at any instant.

use crate::cluster::Cluster;
use crate::contact_law::End;
use crate::error::ReferenceError;
use crate::law::ForceLaw;
use crate::system::{Boundary, Grain, System};
use crate::vector::{Vector, plus};

/// What a grain touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Partner {
    /// Another grain.
    Grain(usize),
    /// A wall of an axis.
    Wall {
        /// The axis, from 0.
        axis: usize,
        /// Whether it is the wall at `hi`.
        upper: bool,
    },
}

/// One contact, from its beginning to its end.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactRecord {
    /// The grain, the one with the lower number of two.
    pub grain: usize,
    /// What it touches.
    pub partner: Partner,
    /// When the contact began.
    pub begin: f64,
    /// When it ended; `None` while it lasts.
    pub end: Option<f64>,
}

/// Beginning or end of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// The contact began.
    Begin,
    /// The contact ended.
    End,
}

/// What just happened; the run stands at `time`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// The instant.
    pub time: f64,
    /// Beginning or end.
    pub kind: EventKind,
    /// The contact's place in [`Exact::records`].
    pub record: usize,
}

/// What is met.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Target<const D: usize> {
    /// A grain, at its position plus `shift`.
    Grain {
        other: usize,
        #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
        shift: Vector<D>,
    },
    /// A wall.
    Wall { axis: usize, upper: bool },
}

/// The next event of a free grain; without a target, only the time to look again.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Forecast<const D: usize> {
    pub time: f64,
    pub target: Option<Target<D>>,
}

impl<const D: usize> Forecast<D> {
    pub const NEVER: Self = Self { time: f64::INFINITY, target: None };

    pub(super) fn sooner(&mut self, time: f64, target: Option<Target<D>>) {
        if time < self.time {
            *self = Self { time, target };
        }
    }
}

/// Force-based molecular dynamics at tight tolerance.
///
/// Grains without a contact are moved in closed form. Grains that hang together by contacts (two
/// grains, as a rule; any number, walls included) are integrated as one system by Gauss
/// collocation of order 32 with steps chosen to about 1e-14. Beginnings of contacts between
/// free grains are roots of a quadratic, found without cancellation; ends, and beginnings that
/// involve a grain already in contact, are roots of the collocation polynomials.
///
/// A run of many contacts multiplies the round-off of its start as chaos does, whatever the
/// tolerance. Cost: O(N) per contact and step, and O(N²) at the start.
///
/// # Examples
///
/// ```
/// use carom_reference::{Boundary, End, Exact, ForceLaw, Grain, System};
/// let grain = |x: f64, v: f64| Grain { radius: 0.1, mass: 1.0, position: [x], velocity: [v] };
/// let system = System::new(vec![grain(0.0, 1.0), grain(1.0, -1.0)], [Boundary::Open], [0.0])?;
/// let law = ForceLaw::LinearDashpot { stiffness: 1e4, damping: 0.0 };
/// let mut run = Exact::new(system, law, End::Force)?;
/// let contact = run.next_contact(10.0)?.expect("they collide");
/// assert!((contact.begin - 0.4).abs() < 1e-15);
/// assert!((contact.end.unwrap() - 0.4 - std::f64::consts::PI * (0.5_f64 / 1e4).sqrt()).abs() < 1e-14);
/// assert!((run.velocity(0)[0] + 1.0).abs() < 1e-13);
/// # Ok::<(), carom_reference::ReferenceError>(())
/// ```
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Exact<const D: usize> {
    /// Radii and masses; positions and velocities of free grains at their `since`.
    pub(super) grains: Vec<Grain<D>>,
    pub(super) since: Vec<f64>,
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
    pub(super) boundary: [Boundary; D],
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
    pub(super) gravity: Vector<D>,
    pub(super) law: ForceLaw,
    pub(super) end: End,
    pub(super) now: f64,
    pub(super) owner: Vec<Option<usize>>,
    pub(super) clusters: Vec<Cluster<D>>,
    pub(super) forecasts: Vec<Forecast<D>>,
    pub(super) records: Vec<ContactRecord>,
    pub(super) three: Option<f64>,
    pub(super) steps: u64,
}

impl<const D: usize> Exact<D> {
    /// Starts at time 0. Overlapping grains start in contact if their force pushes (or, with
    /// [`End::Overlap`], whatever it does).
    ///
    /// # Errors
    ///
    /// [`ReferenceError::Parameter`] for a bad law.
    pub fn new(system: System<D>, law: ForceLaw, end: End) -> Result<Self, ReferenceError> {
        law.validate()?;
        let n = system.grains().len();
        let mut run = Self {
            grains: system.grains().to_vec(),
            since: vec![0.0; n],
            boundary: *system.boundary(),
            gravity: *system.gravity(),
            law,
            end,
            now: 0.0,
            owner: vec![None; n],
            clusters: Vec::new(),
            forecasts: vec![Forecast::NEVER; n],
            records: Vec::new(),
            three: None,
            steps: 0,
        };
        run.begin_overlapping();
        (0..n).for_each(|i| run.foresee(i));
        Ok(run)
    }

    /// The instant the run stands at.
    pub fn now(&self) -> f64 {
        self.now
    }

    /// All contacts so far, in the order of their beginnings.
    pub fn records(&self) -> &[ContactRecord] {
        &self.records
    }

    /// When a grain first had two contacts at once, or a grain was hit that had one.
    pub fn first_three_grain_contact(&self) -> Option<f64> {
        self.three
    }

    /// Integration steps taken.
    pub fn steps(&self) -> u64 {
        self.steps + self.clusters.iter().map(|c| c.steps).sum::<u64>()
    }

    /// Contacts under way.
    pub fn contacts(&self) -> usize {
        self.clusters.iter().map(|c| c.links.len()).sum()
    }

    /// Where grain i is now. In a periodic box it may be outside: any image of it.
    pub fn position(&self, i: usize) -> [f64; D] {
        self.state(i, self.now).0
    }

    /// How grain i moves now.
    pub fn velocity(&self, i: usize) -> [f64; D] {
        self.state(i, self.now).1
    }

    /// All grains as they are now.
    pub fn grains(&self) -> Vec<Grain<D>> {
        let at_now = |(i, grain): (usize, &Grain<D>)| {
            let (position, velocity) = self.state(i, self.now);
            Grain { position, velocity, ..*grain }
        };
        self.grains.iter().enumerate().map(at_now).collect()
    }

    /// The system as it is now.
    ///
    /// # Errors
    ///
    /// As [`System::new`]; a soft grain's centre may have crossed a wall.
    pub fn system(&self) -> Result<System<D>, ReferenceError> {
        System::new(self.grains(), self.boundary, self.gravity)
    }

    /// Goes on to time t ≥ now.
    ///
    /// # Errors
    ///
    /// [`ReferenceError::Parameter`] if t is before now or not a number,
    /// [`ReferenceError::Unresolved`] if a contact cannot be integrated.
    pub fn advance_to(&mut self, t: f64) -> Result<(), ReferenceError> {
        self.advance_within(t, u64::MAX).map(drop)
    }

    /// As [`Exact::advance_to`], but after so many beginnings and ends of contacts it pauses: false if it has
    /// not arrived then. In how many calls it arrives changes no bit.
    ///
    /// # Errors
    ///
    /// As [`Exact::advance_to`].
    pub fn advance_within(&mut self, t: f64, events: u64) -> Result<bool, ReferenceError> {
        for _ in 0..events {
            if self.next_event(t)?.is_none() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Goes on to the next beginning or end of a contact, or to `until` if that comes first.
    ///
    /// # Errors
    ///
    /// As [`Exact::advance_to`].
    pub fn next_event(&mut self, until: f64) -> Result<Option<Event>, ReferenceError> {
        if until.is_nan() || until < self.now {
            return Err(ReferenceError::parameter("until", until, "at least the present time"));
        }
        loop {
            self.clusters.iter_mut().try_for_each(Cluster::look_ahead)?;
            let (step, cluster) = self.next_step();
            let (flight, grain) = self.next_forecast();
            let window = until.min(step).min(flight);
            if let Some(event) = self.contact_in_window(window) {
                return Ok(Some(event));
            }
            self.now = window.max(self.now);
            if until < step && until < flight {
                return Ok(None);
            }
            let event = match flight <= step {
                true => self.collide(grain),
                false => self.finish_step(cluster),
            };
            if event.is_some() {
                return Ok(event);
            }
            if !self.now.is_finite() {
                return Ok(None);
            }
        }
    }

    /// Goes on to the next end of a contact and returns that contact, or goes to `until`.
    ///
    /// # Errors
    ///
    /// As [`Exact::advance_to`].
    pub fn next_contact(&mut self, until: f64) -> Result<Option<ContactRecord>, ReferenceError> {
        while let Some(event) = self.next_event(until)? {
            if event.kind == EventKind::End {
                return Ok(Some(self.records[event.record]));
            }
        }
        Ok(None)
    }

    fn next_step(&self) -> (f64, usize) {
        let ends = self.clusters.iter().enumerate().map(|(k, c)| (c.known_until(), k));
        ends.fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a })
    }

    pub(super) fn next_forecast(&self) -> (f64, usize) {
        let times = self.forecasts.iter().enumerate().map(|(i, f)| (f.time, i));
        times.fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a })
    }

    /// Position and velocity at a time for which the motion is known.
    pub(super) fn state(&self, i: usize, time: f64) -> (Vector<D>, Vector<D>) {
        let cluster = self.owner[i].map(|k| &self.clusters[k]);
        if let Some((cluster, local)) = cluster.and_then(|c| Some((c, c.local(i)?))) {
            return cluster.state(local, time);
        }
        let (grain, dt) = (&self.grains[i], time - self.since[i]);
        let fallen = plus(&grain.position, 0.5 * dt * dt, &self.gravity);
        (plus(&fallen, dt, &grain.velocity), plus(&grain.velocity, dt, &self.gravity))
    }

    pub(super) fn periods(&self) -> Vector<D> {
        self.boundary.each_ref().map(Boundary::period)
    }
}
