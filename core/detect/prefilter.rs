//! Which grains may collide with this one at all? Reads their motions; writes nothing, errs only on the side of "maybe".
//!
//! Most pairs never collide. A batch of them is tested side by side and without a branch.

use crate::particle::Body;
use crate::scalar::{LANES, Lanes, Scalar, Vector, component};
use crate::space::Domain;

/// The grain whose neighbours are tested, at the present.
pub(super) struct Prefilter<S: Scalar, const D: usize> {
    here: [S::Lanes; D],
    velocity: [S::Lanes; D],
    radius: S::Lanes,
    now: S::Lanes,
}

/// What all neighbours of a batch have in common.
#[derive(Clone, Copy)]
pub(super) struct Kind {
    /// Whether they are the nearest images.
    pub same_image: bool,
    /// Whether there is no gravity.
    pub weightless: bool,
}

/// What decides whether a pair collides: r·v, r² and v².
struct Sums<S: Scalar> {
    parting: S::Lanes,
    distance2: S::Lanes,
    speed2: S::Lanes,
}

impl<S: Scalar, const D: usize> Prefilter<S, D> {
    pub fn new(now: S, [here, velocity]: [&Vector<S, D>; 2], radius: S) -> Self {
        let lanes = |v| core::array::from_fn(|axis| S::Lanes::all(component(v, axis)));
        let [radius, now] = [radius, now].map(S::Lanes::all);
        Self { here: lanes(here), velocity: lanes(velocity), radius, now }
    }

    /// A bit for each of a few grains, the lowest for the first: whether it may collide with the one.
    ///
    /// Where they are is not rounded to a lattice: the margins allow for that.
    #[inline(always)]
    pub fn may_collide(
        &self,
        domain: &Domain<'_, S, D>,
        others: [&Body<S, D>; LANES],
        kind: Kind,
    ) -> u32 {
        let mut sums = Sums::<S>::new();
        let span = self.now - S::Lanes::of(others.map(|other| other.clock));
        for (axis, (&here, &velocity)) in self.here.iter().zip(&self.velocity).enumerate() {
            let mut way = S::Lanes::of(others.map(|other| component(&other.velocity, axis)));
            let mut then = way;
            if !kind.weightless {
                let g = component(domain.gravity(), axis);
                way = way + S::Lanes::all(g * S::half()) * span;
                then = then + S::Lanes::all(g) * span;
            }
            let place = S::Lanes::of(others.map(|other| component(&other.position, axis)));
            let mut apart = here - (place + way * span);
            if !kind.same_image {
                apart = nearest::<S>(apart, domain.boundary.periodic_length(axis));
            }
            sums.add(apart, velocity - then);
        }
        sums.may_collide(self.radius + S::Lanes::of(others.map(|other| other.radius)), kind)
    }
}

impl<S: Scalar> Sums<S> {
    /// The sums without a component.
    fn new() -> Self {
        let zero = S::Lanes::all(S::zero());
        Self { parting: zero, distance2: zero, speed2: zero }
    }

    /// Adds a component of separations r and relative velocities v.
    #[inline(always)]
    fn add(&mut self, r: S::Lanes, v: S::Lanes) {
        self.parting = self.parting + r * v;
        self.distance2 = self.distance2 + r * r;
        self.speed2 = self.speed2 + v * v;
    }

    /// Never none where [`super::root::spheres`] finds a collision, even from separations that are wrong by a
    /// thousandth of the reach.
    ///
    /// That margin is in σ², larger by 1/256, and in the discriminant, smaller by 1/100. For floats only.
    #[inline(always)]
    fn may_collide(&self, reach: S::Lanes, kind: Kind) -> u32 {
        let zero = S::Lanes::all(S::zero());
        let gap = self.distance2 - reach * reach * S::Lanes::all(S::from_f32(1.0 + 1.0 / 256.0));
        let most = self.speed2 * gap * S::Lanes::all(S::from_f32(0.99));
        let approach2 = self.parting * self.parting;
        // What flies side by side never meets: so the grain itself, too, is left out. Under gravity velocities
        // are rounded, and only the exact test knows which are the same.
        let near = match kind.weightless {
            true => !most.at_least(approach2),
            false => approach2.at_least(most),
        };
        near & (zero.at_least(self.parting) | zero.at_least(gap))
    }
}

/// A component of the separation of the nearest images; a length of zero takes nothing off.
#[inline(always)]
fn nearest<S: Scalar>(x: S::Lanes, length: S) -> S::Lanes {
    let (half, whole) = (S::Lanes::all(length * S::half()), S::Lanes::all(length));
    let zero = S::Lanes::all(S::zero());
    x - x.where_above(half, whole) + (zero - x).where_above(half, whole)
}

#[cfg(test)]
mod tests {
    use super::super::root::spheres;
    use super::*;

    fn may_collide<S: Scalar>(r: &Vector<S, 3>, v: &Vector<S, 3>, reach: S) -> bool {
        let mut sums = Sums::<S>::new();
        for axis in 0..3 {
            sums.add(S::Lanes::all(component(r, axis)), S::Lanes::all(component(v, axis)));
        }
        let all = (1 << LANES) - 1;
        let may = |weightless| {
            sums.may_collide(S::Lanes::all(reach), Kind { same_image: true, weightless })
        };
        may(true) == all && may(false) == all
    }

    proptest::proptest! {
        /// Directions, distances and aims of all kinds, most of them near to touching or to a glancing pass;
        /// the prefilter sees separations that are wrong by a thousandth of the reach.
        #[test]
        fn the_prefilter_misses_no_collision(
            gap in proptest::prop_oneof![-0.5..4.0_f64, -1e-3..1e-3_f64, 10.0..1e4_f64],
            aim in proptest::prop_oneof![-1.5..1.5_f64, 0.999..1.001_f64],
            (turn, speed) in (0.0..6.2_f64, 1e-3..1e3_f64),
            error in proptest::array::uniform3(-0.0005..0.0005_f64),
        ) {
            let (distance, sigma) = (1.0 + gap, 1.0);
            // Passes at `aim` reaches from the centre, coming or going.
            let across = (aim / distance).clamp(-1.0, 1.0);
            let along = libm::sqrt(1.0 - across * across) * if turn > 3.1 { 1.0 } else { -1.0 };
            let (sin, cos) = (libm::sin(turn), libm::cos(turn));
            let r = Vector::from([distance * cos, distance * sin, 0.0]);
            let v = Vector::from([along * cos - across * sin, along * sin + across * cos, 0.0]) * speed;
            if spheres(&r, &v, sigma).is_some() {
                proptest::prop_assert!(may_collide(&(r + Vector::from(error)), &v, sigma));
                proptest::prop_assert!(may_collide(&r.cast::<f32>(), &v.cast::<f32>(), 1.0_f32));
            }
        }
    }
}
