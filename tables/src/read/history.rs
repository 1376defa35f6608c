//! How deep is a contact at an instant, and how fast does it become deeper? Reads expansions over time and c_dis; writes both.

use super::law::Law;
use super::real::Real;
use super::stored::StoredNumber;

/// Terms of the expansions over time.
pub const TERMS: usize = 24;

/// The overlap and its rate all through a central contact of two alone, from the touch until the force vanishes.
///
/// What surfaces do to each other meanwhile follows from that: see carom's `law::Rough`.
///
/// # Units
/// Scaled as [`Groups`](super::Groups) are: time in T, length in X = T v_n.
///
/// # Range
/// 0 ≤ c_dis ≤ `c_dis_max`; contacts that turn (η > 0) only as far as that can be left out.
#[derive(Clone, Copy, Debug)]
pub struct History<C: 'static> {
    /// The force law.
    pub law: Law,
    /// The largest scaled dissipation.
    pub c_dis_max: f64,
    /// The largest error of overlap and rate, found at points that the fit did not use, times 1.5.
    pub error: f64,
    /// The duration, an expansion in c_dis.
    pub duration: &'static [C],
    /// The overlap: for each of [`TERMS`] polynomials in time an expansion in c_dis, one after the other.
    pub overlap: &'static [C],
    /// Its rate, in the same way.
    pub rate: &'static [C],
}

impl<C: StoredNumber> History<C> {
    /// How a contact of this dissipation goes; none outside the range.
    pub fn at<S: Real>(&self, c_dis: S) -> Option<Compression<S>> {
        let (zero, most) = (S::from_f32(0.0), S::from_f64(self.c_dis_max));
        if !(c_dis >= zero && c_dis <= most) {
            return None;
        }
        let x = (c_dis + c_dis) / most - S::from_f32(1.0);
        let terms = |series: &[C]| {
            let each = series.len() / TERMS;
            let mut terms = [zero; TERMS];
            for (term, part) in terms.iter_mut().zip(series.chunks_exact(each.max(1))) {
                *term = chebyshev(part.iter().map(|a| a.get::<S>()), x);
            }
            terms
        };
        Some(Compression {
            law: self.law,
            c_dis,
            duration: chebyshev(self.duration.iter().map(|a| a.get::<S>()), x),
            overlap: terms(self.overlap),
            rate: terms(self.rate),
        })
    }
}

/// One contact of a [`History`].
///
/// Time goes by phases: p from 0 to 1 is the time τ p²(3 − 2p), in which touch and end are smooth.
#[derive(Clone, Copy, Debug)]
pub struct Compression<S> {
    law: Law,
    c_dis: S,
    /// The duration τ.
    pub duration: S,
    overlap: [S; TERMS],
    rate: [S; TERMS],
}

impl<S: Real> Compression<S> {
    /// The time of a phase.
    pub fn time(&self, phase: S) -> S {
        self.duration * (phase * phase) * (S::from_f32(3.0) - phase - phase)
    }

    /// The overlap.
    pub fn overlap(&self, phase: S) -> S {
        chebyshev(self.overlap, phase + phase - S::from_f32(1.0))
    }

    /// The mean of the overlap, as the force weighs it.
    pub fn mean_overlap(&self) -> S {
        let (mut sum, mut all) = (S::from_f32(0.0), S::from_f32(0.0));
        for k in 1..8_u8 {
            let phase = S::from_f32(f32::from(k) / 8.0);
            // The time goes by as p (1 − p).
            let weight = self.force(phase) * phase * (S::from_f32(1.0) - phase);
            sum = sum + weight * self.overlap(phase);
            all = all + weight;
        }
        sum / all
    }

    /// The rate at which the overlap grows: 1 at the touch.
    pub fn rate(&self, phase: S) -> S {
        chebyshev(self.rate, phase + phase - S::from_f32(1.0))
    }

    /// The normal force per reduced mass, at least 0.
    pub fn force(&self, phase: S) -> S {
        let (zero, depth) = (S::from_f32(0.0), self.overlap(phase));
        let depth = if depth > zero { depth } else { zero };
        let force = depth + self.c_dis * self.rate(phase);
        let force = match self.law {
            Law::LinearDashpot => force,
            Law::Viscoelastic => force * depth.sqrt(),
        };
        if force > zero { force } else { zero }
    }
}

/// Σ aₖ Tₖ(x).
fn chebyshev<S: Real>(terms: impl IntoIterator<Item = S>, x: S) -> S {
    let (mut sum, mut before, mut last) = (S::from_f32(0.0), x, S::from_f32(1.0));
    for term in terms {
        sum = sum + term * last;
        (before, last) = (last, (x + x) * last - before);
    }
    sum
}
