//! When does any smooth overlap function first demand an event? Reads f and ḟ as a function of time; writes nothing.
//!
//! For motions that are no parabola: a plate's sine, a grain at rest and one in flight. BSFP14's rule
//! (Eq. 10) with bracketed roots: f̈ ≥ −M bounds f from below by a parabola through f and ḟ, so the
//! time up to that parabola's root holds no event, and the search steps there. It never steps over
//! an event, and near one it converges as Newton's method does.

use crate::scalar::{Scalar, WideProduct};

/// Steps after which a search pauses and says how far it has come.
const MAX_STEPS: usize = 64;

/// What a search found: at which time, or after which span since its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Found<S> {
    /// f ≤ 0 and ḟ < 0 then, for the first time.
    Event(S),
    /// No event before; further than that it has not looked.
    NotBefore(S),
    /// No event before the limit.
    Nothing,
}

impl<S: Scalar> Found<S> {
    /// Up to when nothing happens.
    pub fn time(&self) -> S {
        match *self {
            Self::Event(time) | Self::NotBefore(time) => time,
            Self::Nothing => S::NEVER,
        }
    }

    /// The same as times, if it was found as spans since `start`.
    pub fn from(self, start: S) -> Self {
        match self {
            Self::Event(span) => Self::Event(start + span),
            Self::NotBefore(span) => Self::NotBefore(start + span),
            Self::Nothing => Self::Nothing,
        }
    }
}

/// How a search steps.
#[derive(Clone, Copy, Debug)]
pub struct Search<S> {
    /// M > 0: the least that f̈ can be is −M.
    pub bound: S,
    /// The smallest step: f changes by less than its rounding against its parabola meanwhile.
    pub least: S,
    /// The span beyond which nobody asks.
    pub limit: S,
}

impl<S: Scalar> Search<S> {
    /// A search for something of this size: what it can miss is below the size's last place.
    ///
    /// `most` is the most that f̈ can be. The root does not depend on the limit: it has the same bits, whoever
    /// asks, and however far.
    pub fn new([bound, most]: [S; 2], size: S, limit: S) -> Self {
        let least = S::min_step(size, bound.max(most));
        Self { bound, least, limit }
    }

    /// The first event of f, given as t ↦ (f, ḟ).
    pub fn first(&self, f: impl Fn(S) -> (S, S)) -> Found<S> {
        let mut t = S::zero();
        for _ in 0..MAX_STEPS {
            let (gap, rate) = f(t);
            let step = if gap > S::zero() { self.down(gap, rate) } else { rate / self.bound };
            let here = gap <= S::zero() || step <= self.least;
            if here && rate < S::zero() {
                return Found::Event(t + step.max(S::zero()));
            }
            // Negated so that NaN ends the search.
            if !(t <= self.limit) {
                return Found::Nothing;
            }
            t += step.max(self.least);
        }
        Found::NotBefore(t)
    }

    /// The time at which gap + rate t − M t²/2 = 0, without cancellation.
    fn down(&self, gap: S, rate: S) -> S {
        let root = (rate.times(rate) + (self.bound + self.bound).times(gap)).sqrt();
        if rate > S::zero() { (rate + root) / self.bound } else { (gap + gap) / (root - rate) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_takes_one_step() {
        let search = Search::new([9.81; 2], 1.0, 10.0);
        let found = search.first(|t: f64| (1.0 - 0.5 * 9.81 * t * t, -9.81 * t));
        let Found::Event(t) = found else { panic!("{found:?}") };
        assert!((t - libm::sqrt(2.0 / 9.81)).abs() < 1e-15, "{t}");
    }

    #[test]
    fn an_overlap_that_gets_better_waits_for_its_peak() {
        let search = Search::new([1.0; 2], 1.0, 10.0);
        let found = search.first(|t: f64| (-1.0 + 0.5 * t - 0.5 * t * t, 0.5 - t));
        let Found::Event(t) = found else { panic!("{found:?}") };
        assert!((t - 0.5).abs() < 1e-7, "{t}");
    }

    #[test]
    fn a_wave_that_does_not_touch_is_no_event() {
        let search = Search::new([1.0; 2], 1.0, 100.0);
        let wave = |t: f64| (1.0 + 1e-9 + libm::sin(t), libm::cos(t));
        let mut from = 0.0;
        while let Found::NotBefore(t) = search.first(|s| wave(from + s)) {
            from += t;
            if from > 100.0 {
                break;
            }
        }
        assert!(from > 90.0, "{from}");
    }
}
