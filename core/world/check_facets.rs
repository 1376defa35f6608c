//! What is wrong with these obstacles? Reads facets, motions and boundaries; writes nothing, names the first bad field.

use super::check_input::finite;
use crate::error::{Error, Subject};
use crate::law::Enduring;
use crate::particle::Partner;
use crate::scalar::{Instant, Scalar, dot, norm};
use crate::space::{Boundary, Facet, ObstacleBuffers, RigidMotion, Surface};

/// Obstacles stand in an open world whose contacts are integrated.
pub(super) fn obstacles<S: Scalar, const D: usize>(
    boundary: &Boundary<S, D>,
    enduring: Enduring,
) -> Result<(), Error> {
    if boundary.obstacles().is_none() {
        return Ok(());
    }
    if let Some((axis, periodic)) = boundary.periodic_axes().next() {
        let wanted = "none in a world with obstacles: their images are not there";
        let length = periodic.length.to_f64();
        return Err(Error::input(Subject::Axis(axis), "length", length, wanted));
    }
    if enduring == Enduring::Paper {
        let wanted = "Enduring::Integrated in a world with obstacles: the papers have none";
        return Err(Error::input(Subject::World, "papers' mode", 1.0, wanted));
    }
    Ok(())
}

/// Every facet of obstacles must be one.
pub(super) fn facets<S: Scalar, const D: usize>(
    buffers: &ObstacleBuffers<'_, S, D>,
) -> Result<(), Error> {
    let facets = buffers.facets();
    if facets.len() > Partner::MAX_FACETS {
        let (number, wanted) = (facets.len() as f64, "at most 2^24");
        return Err(Error::input(Subject::World, "number of facets", number, wanted));
    }
    let motions = buffers.motions();
    facets.iter().enumerate().try_for_each(|(k, facet)| {
        if let Some(motion) = facet.motion().filter(|&motion| motion >= motions.len()) {
            let wanted = "the number of a motion that is lent (WithObstacles::moving)";
            return Err(Error::input(Subject::Facet(k), "motion", motion as f64, wanted));
        }
        self::facet(facet, k)
    })?;
    (0..motions.len()).try_for_each(|k| {
        let facet = facets.iter().position(|facet| facet.motion() == Some(k));
        motions.get(k).map_or(Ok(()), |motion| self::motion(motion, facet))
    })
}

/// A motion is described by numbers; it is named by the first facet that moves so.
fn motion<S: Scalar, const D: usize>(
    motion: &RigidMotion<S, D>,
    facet: Option<usize>,
) -> Result<(), Error> {
    let subject = facet.map_or(Subject::World, Subject::Facet);
    for (field, value, is_positive) in motion.fields() {
        if !value.in_range() {
            return Err(Error::input(subject, field, value.to_f64(), "a finite number"));
        }
        let exact = !is_positive || Instant::from(S::one() / value) > Instant::START;
        if is_positive && !(value > S::zero() && exact) {
            return Err(Error::input(subject, field, value.to_f64(), "above 0 and below 2^63"));
        }
    }
    Ok(())
}

fn facet<S: Scalar, const D: usize>(facet: &Facet<S, D>, number: usize) -> Result<(), Error> {
    let subject = Subject::Facet(number);
    facet.corners().iter().try_for_each(|corner| finite(subject, "corner", corner))?;
    if !facet.is_valid() {
        let (field, wanted) = match D {
            3 => (
                "area",
                "above 0: its corners lie on a line, or so near to one that it has no normal",
            ),
            _ => ("length", "above 0: its ends are the same"),
        };
        return Err(Error::input(subject, field, 0.0, wanted));
    }
    finite(subject, "belt's velocity", facet.belt())?;
    let across = dot(facet.normal(), facet.belt());
    if across.abs() > norm(facet.belt()) * S::from_f32(1e-3) {
        let wanted = "0 across the facet: its surface moves along itself";
        return Err(Error::input(subject, "belt's velocity", across.to_f64(), wanted));
    }
    match *facet.surface() {
        Surface::Hard(e) if !(e >= S::zero() && e <= S::one()) => {
            Err(Error::input(subject, "restitution", e.to_f64(), "between 0 and 1"))
        }
        _ => Ok(()),
    }
}
