//! Is this the state of a world? Reads a snapshot, which anyone may have written; writes nothing, names the first bad field.

use super::statistics::Statistics;
use crate::cluster::Clusters;
use crate::detect::{EventKind, ScheduledEvent};
use crate::error::{Error, Subject};
use crate::law::Enduring;
use crate::particle::{Body, Partner};
use crate::scalar::Scalar;
use crate::space::{Boundary, SavedBoundary};

/// Whether these can be the bodies and events of one world: anything may have been read from a file.
pub(super) fn check<S: Scalar, const D: usize>(
    bodies: &[Body<S, D>],
    events: &[ScheduledEvent<S>],
    now: S,
    [planes, facets]: [usize; 2],
) -> Result<(), Error> {
    let count = bodies.len();
    if events.len() != count {
        let wanted = "one for each grain";
        return Err(Error::input(Subject::World, "number of events", events.len() as f64, wanted));
    }
    if !(now >= S::zero() && now < S::NEVER) {
        return Err(Error::input(Subject::World, "now", now.to_f64(), "at least 0 and finite"));
    }
    for (i, (body, event)) in bodies.iter().zip(events).enumerate() {
        check_body(i, body, now)?;
        check_event(i, event, now)?;
        for partner in [body.partner, event.partner] {
            let grain = partner.as_grain().is_some_and(|k| k < count && k != i);
            let plane = partner.as_plane().is_some_and(|p| p < planes);
            let facet = partner.as_facet().is_some_and(|k| k < facets);
            let body = grain || plane || facet;
            if !(body || partner == Partner::NOTHING || partner.is_clustered()) {
                let wanted = "another grain, a plane, a facet or nothing";
                let word = f64::from(partner.word());
                return Err(Error::input(Subject::Grain(i), "partner", word, wanted));
            }
        }
    }
    Ok(())
}

fn check_body<S: Scalar, const D: usize>(i: usize, body: &Body<S, D>, now: S) -> Result<(), Error> {
    if body.is_vacant() && *body != Body::vacant(body.clock, body.event_count) {
        let wanted = "above 0, or 0 in an empty place with nothing else";
        return Err(Error::input(Subject::Grain(i), "mass", 0.0, wanted));
    }
    let no = |field, value: S, wanted| {
        Err(Error::input(Subject::Grain(i), field, value.to_f64(), wanted))
    };
    if !(body.clock >= S::zero() && body.clock <= now) {
        return no("clock", body.clock, "at least 0 and at most the present");
    }
    let touched = body.is_clustered() && body.contact_end.is_finite();
    if !(touched || body.contact_end >= now && body.contact_end <= S::NEVER) {
        return no("contact_end", body.contact_end, "not before the present");
    }
    if !body.reference_time.is_finite() {
        return no("reference_time", body.reference_time, "a finite number");
    }
    match body.velocity_change.iter().find(|x| !x.is_finite()) {
        Some(&x) => no("velocity_change", x, "a finite number"),
        None => Ok(()),
    }
}

fn check_event<S: Scalar>(i: usize, event: &ScheduledEvent<S>, now: S) -> Result<(), Error> {
    let idle = event.kind == EventKind::Nothing;
    let due = event.time >= now && event.time < S::NEVER && event.collision_time >= event.time;
    if idle && event.time == S::NEVER || !idle && due {
        return Ok(());
    }
    let wanted = "not before the present, and never for a grain without an event";
    Err(Error::input(Subject::Grain(i), "time of its event", event.time.to_f64(), wanted))
}

/// The obstacles are not in a snapshot: the memory must have those with which it was saved.
pub(super) fn check_obstacles<S: Scalar, const D: usize>(
    boundary: &Boundary<'_, S, D>,
    saved: &SavedBoundary<S, D>,
) -> Result<(), Error> {
    if boundary.fingerprint() == saved.obstacles {
        return Ok(());
    }
    let wanted = "those of the saved world, in the same order (WithObstacles)";
    let facets = boundary.facets().len() as f64;
    Err(Error::input(Subject::World, "number of the obstacles' facets", facets, wanted))
}

/// The common time of clustered grains is not after the present, and their step ends after it.
pub(super) fn check_clusters<S: Scalar>(clusters: &Clusters<S>, now: S) -> Result<(), Error> {
    let Clusters { time, step, speed, count, phase, .. } = *clusters;
    let ends = step >= S::zero() && step.is_finite() && time + step >= now;
    let is_one = count == 0 || time >= S::zero() && time <= now && ends;
    let is_phase = phase >= S::zero() && phase.is_finite();
    if is_one && is_phase && speed >= S::zero() && time.is_finite() {
        return Ok(());
    }
    let wanted = "not after the present, and not before it with the step";
    Err(Error::input(Subject::World, "time of the last step", time.to_f64(), wanted))
}

/// Statistics near the end of their range would overflow.
pub(super) fn check_statistics(statistics: &Statistics) -> Result<(), Error> {
    if statistics.max() < 1 << 60 {
        return Ok(());
    }
    let wanted = "below 2^60";
    Err(Error::input(
        Subject::World,
        "a counter of the statistics",
        statistics.max() as f64,
        wanted,
    ))
}

/// A rule that is in one mode only cannot go on with a world that was in the other.
pub(super) fn check_mode(rule: Option<Enduring>, saved: Enduring) -> Result<(), Error> {
    if rule.is_none_or(|mode| mode == saved) {
        return Ok(());
    }
    let wanted = "that of the saved world (PaperMode, IntegratedMode, or neither)";
    Err(Error::input(Subject::Rule, "mode", 0.0, wanted))
}
