//! Who is in a cluster, and who sleeps? A list through the bodies, ordered by number; reads and writes bodies.

use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, norm};
use crate::space::{Domain, Particles, flight};

/// After so many steps ways are counted anew: what is left of rounding then is lost.
const COUNTED: f32 = 1024.0;

/// The clustered grains and their common time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Clusters<S> {
    /// The word for the first of them.
    pub first: Partner,
    /// How many there are.
    pub count: u32,
    /// When the last step ended: the positions of clustered grains hold then.
    pub time: S,
    /// How long the next step is.
    pub step: S,
    /// None of them is faster: after a step, and when one joins or is hit.
    pub speed: S,
    /// The time since the instant from which ways are counted, see [`Self::counted_from`].
    pub phase: S,
}

impl<S: Scalar> Clusters<S> {
    /// Nobody.
    pub fn none() -> Self {
        let zero = S::zero();
        let first = Partner::LAST_CLUSTERED;
        Self { first, count: 0, time: zero, step: zero, speed: zero, phase: zero }
    }

    /// When the next step ends; never without clusters.
    #[inline]
    pub fn due(&self) -> S {
        if self.count == 0 { S::NEVER } else { self.time + self.step }
    }

    /// The step under way ends no later than this long after it began, but not before now.
    pub fn shorten(&mut self, step: S, now: S) {
        self.step = self.step.min(step.max(now - self.time));
    }

    /// The instants, since that from which ways are counted, of a step's beginning, middle and end. Ways are counted
    /// anew after [`COUNTED`] steps, or before the fastest has gone this far: products stay as fine as positions.
    pub fn counted_from(&self, step: S, far: S) -> [S; 3] {
        let end = self.phase + step;
        let goes_on = end <= step * S::from_f32(COUNTED) && self.speed * end <= far;
        let begin = if goes_on { self.phase } else { S::zero() };
        [begin, begin + step * S::half(), begin + step]
    }

    /// The first clustered grain.
    pub fn first(&self) -> Option<usize> {
        self.first.next_clustered()
    }

    /// Puts a grain into the list.
    fn insert<const D: usize>(&mut self, bodies: &mut [Body<S, D>], grain: usize) {
        let before = self.before(bodies, grain);
        let place = match before.and_then(|k| bodies.get_mut(k)) {
            Some(body) => &mut body.partner,
            None => &mut self.first,
        };
        let next = core::mem::replace(place, Partner::clustered(Some(grain)));
        if let Some(body) = bodies.get_mut(grain) {
            body.partner = next;
        }
        self.count += 1;
    }

    /// The list of all bodies that say they are clustered: those of a snapshot.
    pub fn relink<const D: usize>(&mut self, bodies: &mut [Body<S, D>]) {
        (self.first, self.count) = (Partner::LAST_CLUSTERED, 0);
        for (i, body) in bodies.iter_mut().enumerate().rev().filter(|(_, b)| b.is_clustered()) {
            body.partner = core::mem::replace(&mut self.first, Partner::clustered(Some(i)));
            self.count += 1;
        }
    }

    /// Takes a grain out of the list.
    fn remove<const D: usize>(&mut self, bodies: &mut [Body<S, D>], grain: usize) {
        let before = self.before(bodies, grain);
        let Some(body) = bodies.get_mut(grain) else { return };
        let next = core::mem::replace(&mut body.partner, Partner::NOTHING);
        match before.and_then(|k| bodies.get_mut(k)) {
            Some(body) => body.partner = next,
            None => self.first = next,
        }
        self.count = self.count.saturating_sub(1);
    }

    /// The last clustered grain before this one: from the first on, or, if they are many, backwards.
    fn before<const D: usize>(&self, bodies: &[Body<S, D>], grain: usize) -> Option<usize> {
        if self.count > 32 {
            let earlier = bodies.get(..grain).unwrap_or_default();
            return earlier.iter().rposition(Body::is_clustered);
        }
        let mut last = None;
        let mut next = self.first();
        while let Some(k) = next.filter(|&k| k < grain) {
            last = Some(k);
            next = bodies.get(k).and_then(|body| body.partner.next_clustered());
        }
        last
    }
}

/// Grain `i` is clustered from now on. A free one keeps its state, which holds at its own clock.
pub(crate) fn join<S: Scalar, const D: usize>(
    particles: &mut Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    clusters: &mut Clusters<S>,
    (i, now): (usize, S),
) {
    let Some(body) = particles.body(i).copied().filter(|body| !body.is_clustered()) else { return };
    let there = if body.is_asleep() { flight::at(&body, domain, now) } else { body };
    let body = Body {
        velocity_change: *domain.gravity(),
        contact_end: now,
        reference_time: now,
        partner: Partner::NOTHING,
        consecutive_collisions: 0,
        ..there.awake()
    };
    particles.put(i, body);
    if clusters.count == 0 {
        (clusters.time, clusters.step, clusters.speed) = (now, S::zero(), S::zero());
    }
    let fall = norm(domain.gravity()) * (now - body.clock);
    clusters.speed = clusters.speed.max(norm(&body.velocity) + fall);
    clusters.insert(particles.bodies, i);
}

/// Grain `i` flies freely from now on.
pub(crate) fn leave<S: Scalar, const D: usize>(
    particles: &mut Particles<'_, S, D>,
    clusters: &mut Clusters<S>,
    (i, now): (usize, S),
) {
    clusters.remove(particles.bodies, i);
    if let Some(body) = particles.bodies.get_mut(i) {
        body.velocity_change = Vector::zeros();
        (body.contact_end, body.reference_time) = (S::NEVER, now);
        body.consecutive_collisions = 0;
    }
}

/// Grain `i` sleeps from now on.
pub(super) fn sleep<S: Scalar, const D: usize>(
    particles: &mut Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    clusters: &mut Clusters<S>,
    (i, now): (usize, S),
) {
    leave(particles, clusters, (i, now));
    if let Some(body) = particles.body(i) {
        let still = Body { velocity: Vector::zeros(), ..body.asleep() };
        particles.replace(&domain.boundary, i, still);
    }
}

/// Every sleeping grain is clustered from now on.
pub(crate) fn wake<S: Scalar, const D: usize>(
    particles: &mut Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    clusters: &mut Clusters<S>,
    now: S,
) {
    for i in 0..particles.bodies.len() {
        if particles.body(i).is_some_and(Body::is_asleep) {
            join(particles, domain, clusters, (i, now));
        }
    }
}
