//! How do two isolated grains collide? Reads two touching grains and a law; writes duration, path and coefficients.

use crate::cluster::{Cluster, Side};
use crate::contact_law::End;
use crate::error::ReferenceError;
use crate::law::ForceLaw;
use crate::system::{Boundary, Grain, System};
use crate::vector::{Vector, dot, length, minus, plus};

/// The outcome of one collision.
#[derive(Debug, Clone, PartialEq)]
pub struct Collision<const D: usize> {
    /// Contact duration τ (s).
    pub duration: f64,
    /// ε_r = r(τ)/r(0) (MP13 Eq. 16).
    pub eps_r: f64,
    /// ε_ṙ = ṙ(τ)/ṙ(0) (MP13 Eq. 21), negative.
    pub eps_rdot: f64,
    /// ε_φ, the angle by which the line of centres has turned (rad; MP13 Eq. 17), in 0 … π.
    pub eps_phi: f64,
    /// Positions of both grains at the times asked for.
    pub path: Vec<[[f64; D]; 2]>,
    /// Both grains at the end of the contact.
    pub after: [Grain<D>; 2],
}

/// Integrates the contact of two touching grains that approach each other, in Cartesian coordinates.
///
/// The contact begins at time 0, with no overlap: the distance of the centres must equal the sum
/// of the radii to 1e-9 relative. `times` (s, any order, at or after 0) may lie in the contact or
/// after it, where the grains fly freely.
///
/// # Errors
///
/// [`ReferenceError`] for a bad grain or law, for grains that do not touch or do not approach each
/// other, a time before 0, or a contact that does not end within 10⁵ steps (as an overdamped one
/// with [`End::Overlap`] may not).
///
/// # Examples
///
/// ```
/// use carom_reference::{End, ForceLaw, Grain, collide};
/// let a = Grain { radius: 0.1, mass: 1.0, position: [0.2, 0.0], velocity: [-1.0, 0.0] };
/// let b = Grain { radius: 0.1, mass: 1.0, position: [0.0, 0.0], velocity: [0.0, 0.0] };
/// let law = ForceLaw::LinearDashpot { stiffness: 1e4, damping: 0.0 };
/// let hit = collide([a, b], law, End::Force, &[])?;
/// assert!((hit.eps_rdot + 1.0).abs() < 1e-13);
/// # Ok::<(), carom_reference::ReferenceError>(())
/// ```
pub fn collide<const D: usize>(
    grains: [Grain<D>; 2],
    law: ForceLaw,
    end: End,
    times: &[f64],
) -> Result<Collision<D>, ReferenceError> {
    law.validate()?;
    System::new(grains.to_vec(), [Boundary::Open; D], [0.0; D])?;
    if let Some(t) = times.iter().find(|t| !(t.is_finite() && **t >= 0.0)) {
        return Err(ReferenceError::parameter("time", *t, "finite and at least 0"));
    }
    let mut contact = touching(&grains, law, end)?;
    let mut path = vec![None; times.len()];
    loop {
        contact.look_ahead()?;
        fill(&mut path, times, &contact);
        if contact.finish().is_some() {
            break;
        }
        if contact.steps > 100_000 {
            let why = "it has not ended within 100000 steps";
            return Err(ReferenceError::Unresolved { time: contact.elapsed, grain: 0, why });
        }
    }
    Ok(outcome(&grains, &contact, path, times))
}

fn touching<const D: usize>(
    grains: &[Grain<D>; 2],
    law: ForceLaw,
    end: End,
) -> Result<Cluster<D>, ReferenceError> {
    let [a, b] = grains;
    let (r, v) = (minus(&a.position, &b.position), minus(&a.velocity, &b.velocity));
    let (distance, contact_distance) = (length(&r), a.radius + b.radius);
    let wrong = |what, value| ReferenceError::NotAnImpact { first: 0, second: 1, what, value };
    if (distance / contact_distance - 1.0).abs() > 1e-9 {
        return Err(wrong("distance / (R1 + R2)", distance / contact_distance));
    }
    let rate = 0.0 - dot(&r, &v) / distance;
    if rate <= 0.0 {
        return Err(wrong("approach speed", rate));
    }
    let mut contact = Cluster::single(0, a, 0.0, [0.0; D], end);
    contact.join(Cluster::single(1, b, 0.0, [0.0; D], end), 0.0);
    let bound = law.pair([a.radius, b.radius], [a.mass, b.mass]);
    contact.touch(0, Side::Member { local: 1, shift: [0.0; D] }, bound, [0.0, rate], 0);
    Ok(contact)
}

fn fill<const D: usize>(path: &mut [Option<[Vector<D>; 2]>], times: &[f64], contact: &Cluster<D>) {
    for (place, &t) in path.iter_mut().zip(times) {
        if place.is_none() && t <= contact.known_until() {
            *place = Some([0, 1].map(|a| contact.state(a, t).0));
        }
    }
}

fn outcome<const D: usize>(
    before: &[Grain<D>; 2],
    contact: &Cluster<D>,
    path: Vec<Option<[Vector<D>; 2]>>,
    times: &[f64],
) -> Collision<D> {
    let after = [0, 1].map(|a| Grain {
        position: contact.positions[a],
        velocity: contact.velocities[a],
        ..before[a]
    });
    let duration = contact.elapsed;
    let flown = |t: &f64| after.map(|g| plus(&g.position, t - duration, &g.velocity));
    let path = path.iter().zip(times).map(|(p, t)| p.unwrap_or_else(|| flown(t))).collect();
    let relative = |g: &[Grain<D>; 2]| {
        let r = minus(&g[0].position, &g[1].position);
        let v = minus(&g[0].velocity, &g[1].velocity);
        (r, length(&r), dot(&r, &v) / length(&r))
    };
    let ((r0, d0, u0), (r1, d1, u1)) = (relative(before), relative(&after));
    // The angle between two vectors, good at both ends of 0 … π.
    let (a, b) = (r0.map(|x| x / d0), r1.map(|x| x / d1));
    let eps_phi = 2.0 * libm::atan2(length(&minus(&a, &b)), length(&plus(&a, 1.0, &b)));
    Collision { duration, eps_r: d1 / d0, eps_rdot: u1 / u0, eps_phi, path, after }
}
