//! What does a contact do to this pair? Reads the scaled groups and a table; writes the scaled restitution.

use crate::law::{End, Law};
use crate::number::Real;

mod leaf;
pub use leaf::{Branch, Leaf, MAX_TERMS};

/// The dimensionless groups on which one collision depends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Groups<S> {
    /// Eccentricity `e = d/l = sin(alpha)`.
    pub sin: S,
    /// `cos(alpha)`, the normal part of the impact velocity.
    pub cos: S,
    /// Softness `eta = X/l`, one over MP13's scaled contact distance.
    pub eta: S,
    /// Scaled damping (MP13 Eqs. 43, 54).
    pub c_dis: S,
}

/// Scaled restitution of one collision: the independent entries of MP13's matrix of restitution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaled<S> {
    /// Contact duration in units of `T` (MP13 Eq. 20).
    pub tau: S,
    /// Normal speed after over normal speed before, not negative (minus MP13 Eq. 21).
    pub speed: S,
    /// Rotation of the line of centres in radians (MP13 Eq. 17).
    pub angle: S,
    /// Distance of the centres after over before (MP13 Eq. 16).
    pub separation: S,
}

/// The groups for which a table answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// Largest `eta / cos(alpha)`, one over the smallest `l~ cos(alpha)`.
    pub softness_max: f64,
    /// Largest `c_dis`.
    pub c_dis_max: f64,
    /// Smallest `cos(alpha)`.
    pub cos_min: f64,
}

/// What a table promises, measured by its generator through the same [`Table::read`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// The force law.
    pub law: Law,
    /// The end of the contact.
    pub end: End,
    /// Where the table answers.
    pub domain: Domain,
    /// Bytes of constant data.
    pub bytes: usize,
    /// Largest error found: `tau` relative, the others absolute, `angle` in radians.
    pub largest: Scaled<f64>,
    /// The error that 99.9 % of the points stay below.
    pub usual: Scaled<f64>,
    /// Number of points at which it was measured.
    pub points: usize,
    /// FNV-1a (64 bit) of layout and coefficients.
    pub digest: u64,
    /// Where the equations come from.
    pub citation: &'static str,
}

/// A number as a table stores it.
pub trait Stored: Copy + 'static {
    /// The stored value in the number type of the reader.
    fn get<S: Real>(self) -> S;
}

impl Stored for f32 {
    fn get<S: Real>(self) -> S {
        S::from_f32(self)
    }
}

impl Stored for f64 {
    fn get<S: Real>(self) -> S {
        S::from_f64(self)
    }
}

/// How the groups become coordinates in the unit cube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<C> {
    /// Centrifugal scale `a` in `kappa / (kappa + a)`.
    pub kappa_scale: C,
    /// `softness_max`, the largest `eta / cos(alpha)`.
    pub softness: C,
    /// Largest `c_dis`.
    pub c_dis: C,
    /// How strongly centrifugal push and damping go together.
    pub bend: C,
    /// Take the root of the damping coordinate?
    pub root: bool,
}

/// A fitted, certified table; `C` is the stored number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table<C: 'static = f32> {
    /// What the table promises.
    pub certificate: Certificate,
    /// Coordinates.
    pub frame: Frame<C>,
    /// Smallest cosine of the domain.
    pub cos_min: C,
    /// Bisections of the unit cube; empty when there is one leaf.
    pub branches: &'static [Branch],
    /// Pieces of the unit cube.
    pub leaves: &'static [Leaf],
    /// Row lengths of the sparse expansions.
    pub rows: &'static [u8],
    /// Chebyshev coefficients.
    pub coefficients: &'static [C],
}

impl<C: Stored> Table<C> {
    /// Are these groups inside the domain? `false` for NaN.
    pub fn contains<S: Real>(&self, g: &Groups<S>) -> bool {
        let zero = S::from_f32(0.0);
        g.sin >= zero
            && g.sin <= S::from_f32(1.0)
            && g.cos >= self.cos_min.get()
            && g.cos <= S::from_f32(1.0)
            && g.eta >= zero
            && g.eta <= self.frame.softness.get::<S>() * g.cos
            && g.c_dis >= zero
            && g.c_dis <= self.frame.c_dis.get()
    }

    /// The nearest groups inside the domain, axis by axis; NaN becomes the lower end.
    pub fn clamp<S: Real>(&self, g: &Groups<S>) -> Groups<S> {
        let (zero, one) = (S::from_f32(0.0), S::from_f32(1.0));
        let cos = between(g.cos, self.cos_min.get(), one);
        let sin = between(g.sin, zero, (one - cos * cos).sqrt());
        Groups {
            sin,
            cos,
            eta: between(g.eta, zero, self.frame.softness.get::<S>() * cos),
            c_dis: between(g.c_dis, zero, self.frame.c_dis.get()),
        }
    }

    /// The restitution of one collision; `None` outside the domain and for NaN.
    pub fn read<S: Real>(&self, g: &Groups<S>) -> Option<Scaled<S>> {
        if !self.contains(g) {
            return None;
        }
        let point = self.frame.coordinates(g);
        let columns = leaf::evaluate(self, point)?;
        Some(unscale(g, columns, self.certificate.end))
    }
}

fn between<S: Real>(value: S, low: S, high: S) -> S {
    if value >= high {
        high
    } else if value > low {
        value
    } else {
        low
    }
}

impl<C: Stored> Frame<C> {
    /// The unit cube: centrifugal push, softness, damping.
    pub fn coordinates<S: Real>(&self, g: &Groups<S>) -> [S; 3] {
        let one = S::from_f32(1.0);
        let two = S::from_f32(2.0);
        let (a, b): (S, S) = (self.kappa_scale.get(), self.softness.get());
        let bend: S = self.bend.get();
        let cos2 = g.cos * g.cos;
        let push = g.sin * g.sin * g.eta;
        let first = push / (push + a * cos2);
        let second = g.eta * (two * b * cos2 + push) / (two * b * b * cos2);
        let u = g.c_dis / self.c_dis.get();
        let third = u * (cos2 + bend * push) / (cos2 + bend * push * u);
        let third = if self.root { third.sqrt() } else { third };
        [between(first, S::from_f32(0.0), one), between(second, S::from_f32(0.0), one), third]
    }
}

/// Puts back what was divided out of the three columns.
fn unscale<S: Real>(g: &Groups<S>, columns: [S; 3], end: End) -> Scaled<S> {
    let one = S::from_f32(1.0);
    let tan = g.sin / g.cos;
    let push = one + tan * tan * g.eta;
    let tau = columns[0] / push;
    let speed = one / (one + g.c_dis * push * columns[1]);
    let angle = tan * g.eta * tau * (one + g.eta * columns[2]);
    let separation = match end {
        End::Force => one - g.c_dis * speed * g.eta,
        End::Overlap => one,
    };
    Scaled { tau, speed, angle, separation }
}
