//! What is wrong with this? Reads grains, boundaries and gravity; writes nothing, names the first bad field.

use crate::error::{Error, Subject};
use crate::particle::{Body, Grain, Partner};
use crate::scalar::{Instant, Scalar, Vector, dot, norm};
use crate::space::{Boundary, Domain, Obstacles, Particles, Plane, Surface, Vibration};

pub(super) fn plane<S: Scalar, const D: usize>(
    plane: &Plane<S, D>,
    number: usize,
) -> Result<(), Error> {
    let subject = Subject::Plane(number);
    finite(subject, "normal", &plane.normal)?;
    let length = dot(&plane.normal, &plane.normal);
    let rounding = S::RESOLUTION * S::from_f32(8.0);
    if !((length - S::one()).abs() <= rounding) {
        return Err(Error::input(subject, "normal's length squared", length.to_f64(), "1"));
    }
    if !plane.offset.is_finite() {
        return Err(Error::input(subject, "offset", plane.offset.to_f64(), "a finite number"));
    }
    if let Some(vibration) = &plane.vibration() {
        self::vibration(vibration, subject)?;
    }
    if let Some(drift) = plane.drift().filter(|drift| !drift.rate().in_range()) {
        let speed = drift.rate().to_f64();
        return Err(Error::input(subject, "drift's speed", speed, "a finite number"));
    }
    match plane.surface {
        Surface::Hard(e) if !(e >= S::zero() && e <= S::one()) => {
            Err(Error::input(subject, "restitution", e.to_f64(), "between 0 and 1"))
        }
        _ => Ok(()),
    }
}

fn vibration<S: Scalar>(v: &Vibration<S>, subject: Subject) -> Result<(), Error> {
    let [amplitude, phase, f] = v.parameters();
    for (field, value) in [("amplitude", amplitude), ("phase", phase)] {
        if !value.is_finite() {
            return Err(Error::input(subject, field, value.to_f64(), "a finite number"));
        }
    }
    let exact = Instant::from(S::one() / f) > Instant::START;
    if !(f > S::zero() && f.is_finite() && exact) {
        return Err(Error::input(subject, "frequency", f.to_f64(), "above 0 and below 2^63"));
    }
    let jerk = v.peak_acceleration() * v.angular_frequency() * v.angular_frequency();
    if !(jerk.is_finite() && jerk < S::NEVER) {
        let wanted = "small enough that amplitude times the fourth power of 2 pi f is a number";
        return Err(Error::input(subject, "frequency", f.to_f64(), wanted));
    }
    Ok(())
}

pub(super) fn grain<S: Scalar, const D: usize>(
    grain: &Grain<S, D>,
    number: usize,
) -> Result<(), Error> {
    let subject = Subject::Grain(number);
    for (field, value) in [("radius", grain.radius), ("mass", grain.mass)] {
        fits(subject, field, value)?;
        if !(value > S::zero() && value.is_finite()) {
            return Err(Error::input(subject, field, value.to_f64(), "finite and above 0"));
        }
        if S::RANGE.is_some() && value < S::RESOLUTION * S::from_f32(1024.0) {
            let wanted =
                "at least 1024 steps of the fixed-point number: choose a smaller unit for it";
            return Err(Error::input(subject, field, value.to_f64(), wanted));
        }
    }
    finite(subject, "position", &grain.position)?;
    finite(subject, "velocity", &grain.velocity)
}

/// What the length of a periodic axis must be.
pub(super) const LENGTH: &str = "finite, above 0 and at least 4.5 times the largest radius";

/// Every boundary must be one, and they must not contradict each other.
pub(super) fn space<S: Scalar, const D: usize>(
    boundary: &Boundary<S, D>,
    gravity: &Vector<S, D>,
    radius: S,
) -> Result<(), Error> {
    finite(Subject::World, "gravity", gravity)?;
    for (number, plane) in boundary.planes().iter().enumerate() {
        self::plane(plane, number)?;
    }
    for (axis, periodic) in boundary.periodic_axes() {
        let length = periodic.length;
        let max_displacement = Boundary::<S, D>::max_displacement(&periodic, radius);
        let roomy = max_displacement >= radius * S::from_f32(0.125) && max_displacement > S::zero();
        if !(periodic.low.is_finite() && length.is_finite() && roomy) {
            return Err(Error::input(Subject::Axis(axis), "length", length.to_f64(), LENGTH));
        }
        let across = |plane: &Plane<S, D>| plane.normal.get(axis).is_some_and(|&n| n != S::zero());
        if let Some(number) = boundary.planes().iter().position(across) {
            let wanted = "along every periodic axis: a plane cannot stand across one";
            return Err(Error::input(Subject::Plane(number), "normal", axis as f64, wanted));
        }
    }
    Ok(())
}

/// What a sheared box cannot have.
pub(super) fn sheared<S: Scalar, const D: usize>(
    boundary: &Boundary<S, D>,
    gravity: &Vector<S, D>,
) -> Result<(), Error> {
    if boundary.images().is_some() {
        if let Some(g) = gravity.iter().find(|&&g| g != S::zero()) {
            let wanted = "0 in a sheared box: it has no floor on which anything could lie";
            return Err(Error::input(Subject::World, "gravity", g.to_f64(), wanted));
        }
    }
    Ok(())
}

/// A position so far off that it cannot be wrapped into the box is refused.
pub(super) fn inside<S: Scalar, const D: usize>(
    boundary: &Boundary<S, D>,
    grain: usize,
    body: &Body<S, D>,
) -> Result<(), Error> {
    for (axis, p) in boundary.periodic_axes() {
        let x = body.position.get(axis).copied().unwrap_or(p.low);
        if !(x >= p.low && x <= p.low + p.length) {
            let wanted = "near enough to the periodic box to be told from its images";
            return Err(Error::input(Subject::Grain(grain), "position", x.to_f64(), wanted));
        }
    }
    Ok(())
}

/// No two bodies may overlap by more than the rounding of their positions: a few places of the lattice
/// of a periodic box. So little is harmless (BSFP14), and the state of another run, written out and
/// read in again, has it.
pub(super) fn overlaps<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
) -> Result<(), Error> {
    for (a, body) in particles.bodies.iter().enumerate().filter(|(_, body)| !body.is_vacant()) {
        overlaps_of(particles, domain, (a, body), now, |b| b < a)?;
    }
    Ok(())
}

/// The same of one grain and those others that count. All are taken as they are now.
pub(super) fn overlaps_of<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    (a, body): (usize, &Body<S, D>),
    now: S,
    counts: impl Fn(usize) -> bool,
) -> Result<(), Error> {
    let ends = domain.boundary.periodic_axes().map(|(_, p)| (p.low, p.low + p.length));
    let far =
        ends.fold(particles.largest_radius, |far, (low, high)| far.max(low.abs()).max(high.abs()));
    let mut checked = Ok(());
    particles.cells.for_each_near(body.cell, body.radius, |b| {
        if counts(b) && b < particles.bodies.len() && checked.is_ok() {
            let other = particles.present(b, domain, now);
            let apart = domain.separation(body, &other, now);
            let gap = norm(&apart) - (body.radius + other.radius);
            checked = refuse_overlap((a, body), Partner::grain(b), gap, far);
        }
    });
    checked?;
    for (p, plane) in domain.boundary.planes().iter().enumerate() {
        let gap = plane.gap(&body.position, body.radius, now);
        refuse_overlap((a, body), Partner::plane(p), gap, far)?;
    }
    let obstacles = domain.boundary.obstacles();
    obstacles.map_or(Ok(()), |obstacles| among_facets((a, body), obstacles, far, now))
}

/// A body must have room among facets: of two on both sides of it the error names both.
fn among_facets<S: Scalar, const D: usize>(
    who: (usize, &Body<S, D>),
    obstacles: &Obstacles<'_, S, D>,
    far: S,
    now: S,
) -> Result<(), Error> {
    let position = &who.1.position;
    let mut first = None;
    for k in obstacles.near(position, now) {
        let distance = obstacles.distance(k, position, now).unwrap_or(S::NEVER);
        let gap = distance - who.1.radius;
        // How far all facets reach is asked for those only that seem to overlap one.
        let refusal = refuse_overlap(who, Partner::facet(k), gap, far);
        let refusal = refusal
            .or_else(|_| refuse_overlap(who, Partner::facet(k), gap, far.max(obstacles.far())));
        let Err(overlap) = refusal else { continue };
        let Some(Plane { normal, .. }) = obstacles.plane(k, position, now) else { continue };
        match first {
            None => first = Some((overlap, normal)),
            Some((Error::Overlap { grain, with, gap, .. }, other))
                if dot(&normal, &other) < S::zero() =>
            {
                return Err(Error::Overlap { grain, with, gap, also: Some(Partner::facet(k)) });
            }
            Some(_) => {}
        }
    }
    first.map_or(Ok(()), |(overlap, _)| Err(overlap))
}

fn refuse_overlap<S: Scalar, const D: usize>(
    (grain, body): (usize, &Body<S, D>),
    with: Partner,
    gap: S,
    far: S,
) -> Result<(), Error> {
    let far = body.position.iter().fold(far, |far, x| far.max(x.abs()));
    let rounding = far.rounding() * S::from_f32(32.0);
    if gap >= -rounding {
        return Ok(());
    }
    Err(Error::Overlap { grain, with, gap: gap.to_f64(), also: None })
}

/// What is no number in fixed point is one that was too large.
fn fits<S: Scalar>(subject: Subject, field: &'static str, value: S) -> Result<(), Error> {
    match S::RANGE {
        Some(most) if !value.in_range() => Err(Error::overflow(subject, field, most.to_f64())),
        _ => Ok(()),
    }
}

pub(super) fn finite<S: Scalar, const D: usize>(
    subject: Subject,
    field: &'static str,
    v: &Vector<S, D>,
) -> Result<(), Error> {
    v.iter().try_for_each(|&x| fits(subject, field, x))?;
    match v.iter().find(|x| !x.is_finite()) {
        Some(x) => Err(Error::input(subject, field, x.to_f64(), "a finite number")),
        None => Ok(()),
    }
}

/// Contacts that are integrated need a vector for each grain.
pub(super) fn accelerations(grains: usize, lent: usize) -> Result<(), Error> {
    if lent >= grains {
        return Ok(());
    }
    let wanted = "as many as grains: C of Memory; none with PaperMode or Enduring::Paper";
    Err(Error::input(Subject::World, "memory's accelerations", lent as f64, wanted))
}
