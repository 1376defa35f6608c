//! Which force acts in a contact, and when does the contact end? Reads nothing; writes nothing, names the cases.

/// A normal force law between two smooth spheres, in the scaled form of Müller & Pöschel (2013), Sec. V.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Law {
    /// Linear spring-dashpot: `F = k(l - r) - gamma r'` (MP13 Eq. 40); `T = 1/omega`, `X = v_n/omega`.
    LinearDashpot,
    /// Viscoelastic spheres: `F = rho (l - r)^(3/2) - (3/2) A rho r' (l - r)^(1/2)` (MP13 Eq. 51);
    /// `T = k^(-2/5) v_n^(-1/5)`, `X = v_n^(4/5) k^(-2/5)`.
    Viscoelastic,
}

/// The instant at which a contact is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// The force vanishes while the grains separate (MP13 Eq. 10): no attraction.
    Force,
    /// The overlap vanishes (Luding et al. 1994): the dashpot may pull before.
    Overlap,
}
