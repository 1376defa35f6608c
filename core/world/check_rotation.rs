//! Can these grains rotate? Reads the memory for it and the rule's inertia; writes nothing, names what is missing.

use super::saved_rotation::SavedRotation;
use crate::cluster::Settings;
use crate::error::{Error, Subject};
use crate::law::{Enduring, Rule};
use crate::particle::Body;
use crate::scalar::{Axial, Scalar, axes};
use crate::space::{ContactState, RotationBuffers};

/// The places of these bodies, if the rule lets them rotate; nothing for smooth ones.
#[inline(always)]
pub(super) fn angular_velocities<'m, S: Scalar, const D: usize>(
    lent: RotationBuffers<'m, S>,
    inertia: Option<S>,
    bodies: &[Body<S, D>],
) -> Result<RotationBuffers<'m, S>, Error> {
    match inertia {
        Some(_) => places(lent, bodies),
        None => Ok(RotationBuffers::default()),
    }
}

fn places<'m, S: Scalar, const D: usize>(
    lent: RotationBuffers<'m, S>,
    bodies: &[Body<S, D>],
) -> Result<RotationBuffers<'m, S>, Error> {
    let (places, grains) = (lent.capacity::<D>(), bodies.len());
    if places < grains {
        let wanted = "as many as grains in each row of Rotating, for a rule whose grains rotate";
        let field = "memory's angular velocities";
        return Err(Error::input(Subject::World, field, places as f64, wanted));
    }
    let rotation = lent.of::<D>(grains);
    (0..grains).try_for_each(|i| finite(i, &rotation.velocity::<D>(i)))?;
    Ok(rotation)
}

/// An angular velocity must be one, and so must the speed of the surface.
pub(super) fn finite<S: Scalar>(grain: usize, w: &Axial<S>) -> Result<(), Error> {
    match w.iter().find(|x| !x.in_range()) {
        None => Ok(()),
        Some(x) => {
            let wanted = "a finite number";
            Err(Error::input(Subject::Grain(grain), "angular velocity", x.to_f64(), wanted))
        }
    }
}

/// Whether this can be the rotation of so many grains.
pub(super) fn saved<S: Scalar, const D: usize>(
    rotation: &SavedRotation<impl AsRef<[S]>, impl AsRef<[ContactState<S>]>>,
    inertia: Option<S>,
    grains: usize,
) -> Result<(), Error> {
    let wanted_count = if inertia.is_some() { grains * axes::<D>() } else { 0 };
    for (field, saved) in [
        ("number of angular velocities", &rotation.velocities),
        ("number of angular accelerations", &rotation.accelerations),
    ] {
        let saved = saved.as_ref();
        if saved.len() != wanted_count {
            let wanted = "as many as grains have, under a rule whose grains rotate; else none";
            return Err(Error::input(Subject::World, field, saved.len() as f64, wanted));
        }
        if let Some(x) = saved.iter().find(|x| !x.in_range()) {
            let wanted = "a finite number";
            return Err(Error::input(Subject::World, "angular velocity", x.to_f64(), wanted));
        }
    }
    match rotation.contacts.as_ref().iter().find_map(|state| state.refused(grains)) {
        None => Ok(()),
        Some((field, value)) => {
            let wanted = "one that is there, and a finite length";
            Err(Error::input(Subject::World, field, value, wanted))
        }
    }
}

/// In the papers' mode no contact that lasts has friction.
pub(super) fn mode<S: Scalar>(rule: &impl Rule<S>, settings: &Settings<S>) -> Result<(), Error> {
    if settings.enduring != Enduring::Paper {
        return Ok(());
    }
    if rule.remembers() {
        let wanted = "one that a table knows in the papers' mode (Enduring::Integrated has all)";
        return Err(Error::input(Subject::Rule, "force law of one's own", 1.0, wanted));
    }
    if rule.inertia().is_some() && settings.has_forces {
        let wanted =
            "a rule without forces in the papers' mode (Enduring::Integrated has friction)";
        return Err(Error::input(Subject::Rule, "rough surfaces", 1.0, wanted));
    }
    Ok(())
}
