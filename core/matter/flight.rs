//! Where is a grain at a time? Free flight under uniform gravity: the only place where time moves a position.

use super::grain::Body;
use crate::number::{Scalar, Vector};

/// The grain's position after flying for `span`, gravity being `g`: r + v t + g t²/2.
pub fn position_after<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    g: &Vector<S, D>,
    span: S,
) -> Vector<S, D> {
    body.position + (body.velocity + g * (span * S::half())) * span
}

/// The grain's velocity after flying for `span`: v + g t.
pub fn velocity_after<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    g: &Vector<S, D>,
    span: S,
) -> Vector<S, D> {
    body.velocity + g * span
}

/// The grain at time `now`, its clock set there; everything else as it was.
pub fn at<S: Scalar, const D: usize>(body: &Body<S, D>, g: &Vector<S, D>, now: S) -> Body<S, D> {
    let span = now - body.clock;
    Body {
        position: position_after(body, g, span),
        velocity: velocity_after(body, g, span),
        clock: now,
        ..*body
    }
}

/// Lets the grain fly until `now`.
pub fn advance<S: Scalar, const D: usize>(body: &mut Body<S, D>, g: &Vector<S, D>, now: S) {
    *body = at(body, g, now);
}
