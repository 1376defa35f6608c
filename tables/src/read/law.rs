//! Which force acts in a contact, and when does the contact end? Reads nothing; writes nothing, names the cases.
//!
//! Neither is `#[non_exhaustive]`: code that meets a law it does not know must not compile, rather than take
//! it for another.

/// A normal force law between two smooth spheres, scaled as in MP13, Sec. V.
///
/// `r` is the distance of the centres, `l` the sum of the radii, `x = (l - r)/X` the scaled
/// compression. Time is measured in units of `T`, length in units of `X = T v_n`, where `v_n` is
/// the normal component of the impact velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Law {
    /// Linear spring-dashpot: `F = k (l - r) - gamma r'` (MP13 Eq. 40).
    ///
    /// `T = 1/omega`, `X = v_n/omega` with `omega^2 = k/m_eff` (MP13 Eq. 41).
    LinearDashpot,
    /// Viscoelastic spheres: `F = rho (l - r)^(3/2) - (3/2) A rho r' (l - r)^(1/2)` (MP13 Eq. 51).
    ///
    /// `T = k^(-2/5) v_n^(-1/5)`, `X = v_n^(4/5) k^(-2/5)` with `k = rho/m_eff` (MP13 Eqs. 52, 53).
    Viscoelastic,
}

/// The instant at which a contact is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// The force vanishes while the spheres separate (MP13 Eq. 10), so it never attracts.
    Force,
    /// The overlap vanishes (Luding et al. 1994). The dashpot may attract shortly before.
    Overlap,
}
