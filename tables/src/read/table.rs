//! What does a table say about a collision? Reads the scaled groups and a table; writes the scaled restitution.

use super::certificate::Certificate;
use super::chebyshev::evaluate;
use super::groups::{Groups, ScaledRestitution};
use super::law::End;
use super::layout::TableData;
use super::real::Real;
use super::stored::StoredNumber;

impl<C: StoredNumber> TableData<'_, C> {
    /// The restitution of one collision; `None` outside the domain and for NaN.
    pub fn read<S: Real>(&self, g: &Groups<S>) -> Option<ScaledRestitution<S>> {
        self.read_precise(&g.to_precise()).map(ScaledRestitution::from_precise)
    }

    /// The restitution of the nearest collision inside the domain; NaN becomes the lower limit.
    pub fn read_nearest<S: Real>(&self, g: &Groups<S>) -> Option<ScaledRestitution<S>> {
        self.read_precise(&self.domain.clamp(&g.to_precise())).map(ScaledRestitution::from_precise)
    }

    fn read_precise<S: Real>(&self, g: &Groups<S>) -> Option<ScaledRestitution<S>> {
        if !self.domain.contains(g) {
            return None;
        }
        let one = S::from_f32(1.0);
        let tan = g.sin / g.cos;
        let groups = [S::kappa(tan, g.eta), g.eta, g.c_dis];
        let (columns, direct_angle) = evaluate(self, self.coordinates.cube_point(groups))?;
        let [tau, speed, angle] =
            self.coordinates.outcome(groups, tan * g.eta, direct_angle, columns);
        let separation = match self.coordinates.end {
            End::Force => one - g.c_dis * speed * g.eta,
            End::Overlap => one,
        };
        Some(ScaledRestitution { tau, speed, angle, separation })
    }
}

/// A fitted, certified table; `C` is the stored number.
///
/// ```
/// # #[cfg(feature = "generate")] {
/// use carom_tables::read::{Groups, Law};
/// use carom_tables::recipe::Recipe;
/// let table = Recipe::compact(Law::LinearDashpot).generate::<f32>().unwrap();
/// let before = Groups { sin: 0.6, cos: 0.8, eta: 0.05, c_dis: 0.1 };
/// let after = table.data().read(&before).unwrap();
/// assert!(after.speed < 1.0 && after.angle > 0.0);
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table<C: 'static = f32> {
    /// What the table promises.
    pub certificate: Certificate,
    /// Domain, coordinates and coefficients.
    pub data: TableData<'static, C>,
}

impl<C: StoredNumber> Table<C> {
    /// The nearest groups inside the domain, axis by axis; NaN becomes the lower limit.
    pub fn clamp<S: Real>(&self, g: &Groups<S>) -> Groups<S> {
        self.data.domain.clamp(g)
    }

    /// The restitution of one collision; `None` outside the domain and for NaN.
    ///
    /// Exact by construction: `speed = separation = 1` at `c_dis = 0`; `angle = 0` and
    /// `separation = 1` at `eta = 0` (the hard sphere).
    ///
    /// # Units
    /// Scaled as in [`ScaledRestitution`]; multiply with the law's `T` and normal impact speed.
    pub fn read<S: Real>(&self, g: &Groups<S>) -> Option<ScaledRestitution<S>> {
        self.data.read(g)
    }

    /// The restitution of the nearest collision inside the domain, axis by axis; NaN becomes the lower limit.
    pub fn read_nearest<S: Real>(&self, g: &Groups<S>) -> Option<ScaledRestitution<S>> {
        self.data.read_nearest(g)
    }
}
