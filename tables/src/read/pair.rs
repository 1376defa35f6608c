//! What does a table of one pair of bodies say? Reads the speeds along and across the line of centres; writes duration, restitution and angle.

use super::real::Real;
use super::stored::StoredNumber;

/// Terms of an expansion over the speed along the line of centres, and over the square of that across it.
pub const PAIR_TERMS: [usize; 2] = [10, 6];

/// The outcome of contacts of one pair of bodies under any force law without a state: a fitted, certified table.
///
/// A contact goes on until the overlap is none again.
///
/// # Units
/// Those of the recipe: lengths, masses, speeds and times that go together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairTable<C: 'static = f32> {
    /// What the table promises.
    pub certificate: PairCertificate,
    /// How many pieces there are along and across.
    pub pieces: [u8; 2],
    /// The shortest duration of central contacts, by which times are divided.
    pub time: f64,
    /// ln(fastest/slowest).
    pub span: f64,
    /// For each piece three expansions, of duration, restitution and angle.
    pub coefficients: &'static [C],
}

/// What a [`PairTable`] promises.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairCertificate {
    /// R₁ + R₂.
    pub contact_distance: f64,
    /// m₁ m₂/(m₁ + m₂).
    pub reduced_mass: f64,
    /// The slowest and the fastest speed of approach along the line of centres.
    pub speeds: [f64; 2],
    /// The fastest speed across it.
    pub across: f64,
    /// How many bytes the table takes.
    pub bytes: usize,
    /// The largest error found, times 1.5: of the duration (relative), of the restitution, and of the angle (radians).
    pub largest: [f64; 3],
    /// How many contacts were integrated and compared for that, none of which the fit had used.
    pub points: usize,
}

/// What a contact comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairOutcome<S> {
    /// How long it lasts.
    pub duration: S,
    /// The speed along the line of centres at its end, in units of that at the touch.
    pub restitution: S,
    /// By how much the line of centres turns, in radians.
    pub angle: S,
}

impl<C: StoredNumber> PairTable<C> {
    /// What a contact comes to; none outside the speeds of the table, and for NaN.
    pub fn read<S: Real>(&self, [normal, tangential]: [S; 2]) -> Option<PairOutcome<S>> {
        let c = &self.certificate;
        let [slowest, fastest, across] = [c.speeds[0], c.speeds[1], c.across].map(S::from_f64);
        let (zero, one) = (S::from_f32(0.0), S::from_f32(1.0));
        let inside = normal >= slowest && normal <= fastest;
        if !(inside && tangential >= zero && tangential <= across) {
            return None;
        }
        let along = (normal / slowest - one).ln_1p() / S::from_f64(self.span);
        let part = if across > zero { tangential / across } else { zero };
        let (i, x) = piece(along, self.pieces[0]);
        let (k, y) = piece(part * part, self.pieces[1]);
        let each = PAIR_TERMS[0] * PAIR_TERMS[1];
        let number = usize::from(i) * usize::from(self.pieces[1]) + usize::from(k);
        let mine = self.coefficients.get(3 * each * number..3 * each * (number + 1))?;
        let (first, second) = (polynomials(x), polynomials(y));
        let mut columns = [zero; 3];
        for (column, terms) in columns.iter_mut().zip(mine.chunks_exact(each)) {
            for (row, &s) in terms.chunks_exact(PAIR_TERMS[1]).zip(&first) {
                let sum = row.iter().zip(&second).fold(zero, |sum, (a, &t)| sum + a.get::<S>() * t);
                *column = *column + sum * s;
            }
        }
        let [duration, restitution, turned] = columns;
        let time = S::from_f64(self.time);
        let angle = turned * time * tangential / S::from_f64(c.contact_distance);
        Some(PairOutcome { duration: duration * time, restitution, angle })
    }

    /// The nearest speeds inside the table; NaN becomes the slowest, and none across.
    pub fn clamp<S: Real>(&self, [normal, tangential]: [S; 2]) -> [S; 2] {
        let clamped = |x: S, low: f64, high: f64| {
            let (low, high) = (S::from_f64(low), S::from_f64(high));
            if x > high {
                high
            } else if x > low {
                x
            } else {
                low
            }
        };
        let c = &self.certificate;
        [clamped(normal, c.speeds[0], c.speeds[1]), clamped(tangential, 0.0, c.across)]
    }
}

/// Which of so many equal pieces of 0..1 a place is in, and where in it, from −1 to 1.
fn piece<S: Real>(place: S, pieces: u8) -> (u8, S) {
    let (zero, one) = (S::from_f32(0.0), S::from_f32(1.0));
    let mut rest = place * S::from_f32(f32::from(pieces));
    let mut number = 0;
    while rest >= one && number + 1 < pieces {
        rest = rest - one;
        number += 1;
    }
    let rest = if rest > one { one } else { rest };
    let rest = if rest > zero { rest } else { zero };
    (number, rest + rest - one)
}

/// T₀ to T₉.
fn polynomials<S: Real>(x: S) -> [S; PAIR_TERMS[0]] {
    let (mut before, mut last) = (x, S::from_f32(1.0));
    core::array::from_fn(|_| {
        let term = last;
        (before, last) = (last, (x + x) * last - before);
        term
    })
}
