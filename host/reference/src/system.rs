//! Which grains are there, and in which box? Reads grains, boundary and gravity; writes a checked system and its totals.

use crate::error::ReferenceError;
use crate::law::ForceLaw;
use crate::plate::Plate;
use crate::vector::{Vector, dot, length, minus};

/// One smooth grain.
///
/// # Units
///
/// SI, or the same consistent set as the law.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Grain<const D: usize> {
    /// Radius, > 0.
    pub radius: f64,
    /// Mass, > 0.
    pub mass: f64,
    /// Centre.
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
    pub position: [f64; D],
    /// Velocity.
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
    pub velocity: [f64; D],
}

/// What bounds one axis.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Boundary {
    /// Nothing.
    Open,
    /// The box repeats.
    Periodic {
        /// Lower end.
        lo: f64,
        /// Upper end.
        hi: f64,
    },
    /// Two plane walls, soft by the same force law (R_eff = R, m_eff = m); they do not move.
    Walls {
        /// Lower wall.
        lo: f64,
        /// Upper wall.
        hi: f64,
    },
    /// One plane below, soft by the same force law, which may vibrate; nothing above.
    Plate(Plate),
}

impl Boundary {
    /// The period of the axis, 0 where it does not repeat.
    #[inline]
    pub(crate) fn period(&self) -> f64 {
        match *self {
            Self::Periodic { lo, hi } => hi - lo,
            _ => 0.0,
        }
    }
}

/// Grains in a box under uniform gravity, checked.
///
/// # Examples
///
/// ```
/// use carom_reference::{Boundary, Grain, System};
/// let grain = Grain { radius: 0.1, mass: 1.0, position: [0.0, 0.5], velocity: [1.0, 0.0] };
/// let floor = Boundary::Walls { lo: 0.0, hi: 10.0 };
/// let system = System::new(vec![grain], [Boundary::Open, floor], [0.0, -9.81])?;
/// assert_eq!(system.kinetic_energy(), 0.5);
/// # Ok::<(), carom_reference::ReferenceError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct System<const D: usize> {
    grains: Vec<Grain<D>>,
    boundary: [Boundary; D],
    gravity: [f64; D],
}

impl<const D: usize> System<D> {
    /// Checks and keeps grains, boundary (one per axis) and gravity.
    ///
    /// Grains may overlap each other or a wall (a contact under way), but not share a centre, and
    /// centres must lie between the walls. In a periodic box positions may lie outside the box.
    ///
    /// # Errors
    ///
    /// [`ReferenceError`] naming the field, the grain or axis, the value and what would be right:
    /// radius or mass not finite and positive, a position or velocity not finite, an empty
    /// boundary or one narrower than the largest grain, two grains with one centre, no grains.
    pub fn new(
        grains: Vec<Grain<D>>,
        boundary: [Boundary; D],
        gravity: [f64; D],
    ) -> Result<Self, ReferenceError> {
        if grains.is_empty() {
            return Err(ReferenceError::Empty);
        }
        for g in gravity {
            if !g.is_finite() {
                return Err(ReferenceError::parameter("gravity", g, "finite"));
            }
        }
        grains.iter().enumerate().try_for_each(|(i, grain)| check_grain(i, grain))?;
        let widest = grains.iter().map(|g| 2.0 * g.radius).fold(0.0, f64::max);
        for (axis, bound) in boundary.iter().enumerate() {
            check_boundary(axis, bound, widest)?;
        }
        let system = Self { grains, boundary, gravity };
        system.check_inside()?;
        system.check_apart()?;
        Ok(system)
    }

    fn check_inside(&self) -> Result<(), ReferenceError> {
        for (i, grain) in self.grains.iter().enumerate() {
            for (axis, bound) in self.boundary.iter().enumerate() {
                let (lo, hi, wanted) = match *bound {
                    Boundary::Walls { lo, hi } => (lo, hi, "between the walls"),
                    Boundary::Plate(plate) => (plate.height(0.0), f64::INFINITY, "above the plate"),
                    _ => continue,
                };
                let value = grain.position[axis];
                if !(lo < value && value < hi) {
                    let field = format!("position[{axis}]");
                    return Err(ReferenceError::Grain { grain: i, field, value, wanted });
                }
            }
        }
        Ok(())
    }

    /// Sorted along the first axis, so that a large system is checked in reasonable time.
    fn check_apart(&self) -> Result<(), ReferenceError> {
        let mut order: Vec<(Vec<f64>, usize)> =
            self.grains.iter().enumerate().map(|(i, g)| (self.reduced(&g.position), i)).collect();
        order.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        for two in order.windows(2) {
            if two[0].0 == two[1].0 {
                let (a, b) = (two[0].1, two[1].1);
                return Err(ReferenceError::Coincident { first: a.min(b), second: a.max(b) });
            }
        }
        Ok(())
    }

    fn reduced(&self, position: &Vector<D>) -> Vec<f64> {
        let inside = |(p, b): (&f64, &Boundary)| match *b {
            Boundary::Periodic { lo, hi } => lo + (p - lo).rem_euclid(hi - lo),
            _ => *p,
        };
        position.iter().zip(&self.boundary).map(inside).collect()
    }

    /// The grains, in the order given.
    pub fn grains(&self) -> &[Grain<D>] {
        &self.grains
    }

    /// The boundary of each axis.
    pub fn boundary(&self) -> &[Boundary; D] {
        &self.boundary
    }

    /// Uniform gravity.
    pub fn gravity(&self) -> &[f64; D] {
        &self.gravity
    }

    /// Σ m v²/2.
    pub fn kinetic_energy(&self) -> f64 {
        self.grains.iter().map(|g| 0.5 * g.mass * dot(&g.velocity, &g.velocity)).sum()
    }

    /// −Σ m g·r. In an axis that repeats this is of little use.
    pub fn gravitational_energy(&self) -> f64 {
        -self.grains.iter().map(|g| g.mass * dot(&self.gravity, &g.position)).sum::<f64>()
    }

    /// The energy stored in all overlaps, by geometry alone, O(N²); a plate as it is at time 0.
    ///
    /// After [`End::Force`](crate::End::Force) has ended a damped contact the grains still overlap
    /// a little; what is counted for them then is not given back.
    pub fn elastic_energy(&self, law: &ForceLaw) -> f64 {
        let (n, mut sum) = (self.grains.len(), 0.0);
        for i in 0..n {
            sum += self.wall_energy(law, i);
            for j in i + 1..n {
                let (a, b) = (&self.grains[i], &self.grains[j]);
                let overlap = a.radius + b.radius - length(&self.separation(i, j));
                if overlap > 0.0 {
                    let contact = law.pair([a.radius, b.radius], [a.mass, b.mass]);
                    sum += contact.elastic_energy(overlap);
                }
            }
        }
        sum
    }

    fn wall_energy(&self, law: &ForceLaw, i: usize) -> f64 {
        let grain = &self.grains[i];
        let contact = law.wall(grain.radius, grain.mass);
        let mut sum = 0.0;
        for (axis, bound) in self.boundary.iter().enumerate() {
            if let Boundary::Walls { lo, hi } = *bound {
                let p = grain.position[axis];
                sum += contact.elastic_energy(grain.radius - (p - lo));
                sum += contact.elastic_energy(grain.radius - (hi - p));
            }
            if let Boundary::Plate(plate) = *bound {
                let gap = grain.position[axis] - plate.height(0.0);
                sum += contact.elastic_energy(grain.radius - gap);
            }
        }
        sum
    }

    /// Σ m v.
    pub fn momentum(&self) -> [f64; D] {
        std::array::from_fn(|k| self.grains.iter().map(|g| g.mass * g.velocity[k]).sum())
    }

    /// Σ m r × v about the origin, always with three components (0 where D lacks the axes).
    pub fn angular_momentum(&self) -> [f64; 3] {
        let mut total = [0.0; 3];
        for g in &self.grains {
            let at = |v: &[f64; D], k: usize| v.get(k).copied().unwrap_or(0.0);
            for (k, sum) in total.iter_mut().enumerate() {
                let (a, b) = ((k + 1) % 3, (k + 2) % 3);
                let (r, v) = (&g.position, &g.velocity);
                *sum += g.mass * (at(r, a) * at(v, b) - at(r, b) * at(v, a));
            }
        }
        total
    }

    /// r_i − r_j, to the nearest image.
    pub fn separation(&self, i: usize, j: usize) -> [f64; D] {
        let mut r = minus(&self.grains[i].position, &self.grains[j].position);
        for (r, bound) in r.iter_mut().zip(&self.boundary) {
            let period = bound.period();
            if period > 0.0 {
                *r -= period * (*r / period).round();
            }
        }
        r
    }
}

fn check_grain<const D: usize>(i: usize, grain: &Grain<D>) -> Result<(), ReferenceError> {
    let wrong =
        |field: String, value, wanted| ReferenceError::Grain { grain: i, field, value, wanted };
    for (field, value) in [("radius", grain.radius), ("mass", grain.mass)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(wrong(field.into(), value, "finite and above 0"));
        }
    }
    for (field, vector) in [("position", &grain.position), ("velocity", &grain.velocity)] {
        for (axis, &value) in vector.iter().enumerate() {
            if !value.is_finite() {
                return Err(wrong(format!("{field}[{axis}]"), value, "finite"));
            }
        }
    }
    Ok(())
}

fn check_boundary(axis: usize, bound: &Boundary, widest: f64) -> Result<(), ReferenceError> {
    if let Boundary::Plate(plate) = bound {
        return plate.check();
    }
    let (Boundary::Periodic { lo, hi } | Boundary::Walls { lo, hi }) = *bound else {
        return Ok(());
    };
    if lo.is_finite() && hi.is_finite() && hi - lo > widest {
        return Ok(());
    }
    let wanted = format!("finite and wider than the largest grain's diameter, {widest}");
    Err(ReferenceError::Boundary { axis, lo, hi, wanted })
}
