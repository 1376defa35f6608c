//! What does a contact do to this pair? Reads the scaled groups and a table; writes the scaled restitution.

use crate::number::Real;

mod certificate;
mod domain;
mod frame;
mod leaf;
pub use crate::law::{End, Law};
pub use certificate::Certificate;
pub use domain::{Domain, SOFT};
pub use frame::Frame;
pub use leaf::{Branch, Leaf, MAX_TERMS, Row};

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

impl<S: Real> Groups<S> {
    /// The same in the number in which tables are read.
    fn precise(&self) -> Groups<S::Precise> {
        let Self { sin, cos, eta, c_dis } = *self;
        let [sin, cos, eta, c_dis] = [sin, cos, eta, c_dis].map(S::precise);
        Groups { sin, cos, eta, c_dis }
    }
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

impl<S: Real> Scaled<S> {
    /// From the number in which tables are read.
    fn rounded(precise: Scaled<S::Precise>) -> Self {
        let Scaled { tau, speed, angle, separation } = precise;
        let [tau, speed, angle, separation] = [tau, speed, angle, separation].map(S::rounded);
        Self { tau, speed, angle, separation }
    }
}

/// A number as a table stores it.
pub trait Stored: Copy + 'static {
    /// Whether a wide table can be stored so. Where not, its cube roots and logarithms are not linked.
    const WIDE: bool = true;
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

/// A number in steps of 2^−28, from −8 to 8: as good as an `f32` near one, and read without float arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quanta(pub i32);

impl Stored for Quanta {
    const WIDE: bool = false;
    #[inline]
    fn get<S: Real>(self) -> S {
        S::from_quanta(self.0)
    }
}

/// The data of a table, wherever they live.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body<'a, C> {
    /// Where the table answers.
    pub domain: Domain<C>,
    /// Coordinates.
    pub frame: Frame<C>,
    /// Bisections of the unit cube; empty when there is one leaf.
    pub branches: &'a [Branch],
    /// Pieces of the unit cube.
    pub leaves: &'a [Leaf],
    /// Rows of the sparse expansions.
    pub rows: &'a [Row],
    /// Chebyshev coefficients.
    pub coefficients: &'a [C],
}

impl<C: Stored> Body<'_, C> {
    /// The restitution of one collision; `None` outside the domain and for NaN.
    pub fn read<S: Real>(&self, g: &Groups<S>) -> Option<Scaled<S>> {
        self.read_precise(&g.precise()).map(Scaled::rounded)
    }

    /// The restitution of the nearest collision inside the domain; NaN becomes the lower end.
    pub fn read_nearest<S: Real>(&self, g: &Groups<S>) -> Option<Scaled<S>> {
        self.read_precise(&self.domain.clamp(&g.precise())).map(Scaled::rounded)
    }

    fn read_precise<S: Real>(&self, g: &Groups<S>) -> Option<Scaled<S>> {
        if !self.domain.contains(g) {
            return None;
        }
        let one = S::from_f32(1.0);
        let tan = g.sin / g.cos;
        let groups = [S::push(tan, g.eta), g.eta, g.c_dis];
        let (columns, direct) = leaf::evaluate(self, self.frame.coordinates(groups))?;
        let [tau, speed, angle] = self.frame.unscale(groups, tan * g.eta, direct, columns);
        let separation = match self.frame.end {
            End::Force => one - g.c_dis * speed * g.eta,
            End::Overlap => one,
        };
        Some(Scaled { tau, speed, angle, separation })
    }

    /// Bytes of branches, leaves, rows and coefficients.
    pub fn bytes(&self) -> usize {
        size_of_val(self.branches)
            + size_of_val(self.leaves)
            + size_of_val(self.rows)
            + size_of_val(self.coefficients)
    }
}

/// A fitted, certified table; `C` is the stored number.
///
/// ```
/// use carom_tables::{Groups, Law, Recipe, Table};
/// # #[cfg(feature = "generate")] {
/// let made = Recipe::compact(Law::LinearDashpot).generate::<f32>().unwrap();
/// let hit = Groups { sin: 0.6, cos: 0.8, eta: 0.05, c_dis: 0.1 };
/// let after = made.body().read(&hit).unwrap();
/// assert!(after.speed < 1.0 && after.angle > 0.0);
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table<C: 'static = f32> {
    /// What the table promises.
    pub certificate: Certificate,
    /// The data.
    pub body: Body<'static, C>,
}

impl<C: Stored> Table<C> {
    /// Are these groups inside the domain? `false` for NaN.
    pub fn contains<S: Real>(&self, g: &Groups<S>) -> bool {
        self.body.domain.contains(g)
    }

    /// The nearest groups inside the domain, axis by axis; NaN becomes the lower end.
    pub fn clamp<S: Real>(&self, g: &Groups<S>) -> Groups<S> {
        self.body.domain.clamp(g)
    }

    /// The restitution of one collision; `None` outside the domain and for NaN.
    ///
    /// Exact by construction: `speed = separation = 1` at `c_dis = 0`; `angle = 0` and
    /// `separation = 1` at `eta = 0` (the hard sphere).
    ///
    /// # Units
    /// Scaled as in [`Scaled`]; multiply with the law's `T` and normal impact speed.
    pub fn read<S: Real>(&self, g: &Groups<S>) -> Option<Scaled<S>> {
        self.body.read(g)
    }

    /// The restitution of the nearest collision inside the domain, axis by axis; NaN becomes the lower end.
    pub fn read_nearest<S: Real>(&self, g: &Groups<S>) -> Option<Scaled<S>> {
        self.body.read_nearest(g)
    }
}
