//! How does a lasting contact begin, and go on when gravity changes? Reads two bodies and an outcome; writes both, turned and bound (E^φ).

use super::apply::Affected;
use super::scene::Scene;
use super::turn::Touch;
use super::{plane, wake};
use crate::law::Outcome;
use crate::matter::{Body, Partner};
use crate::number::{Product, Scalar, Vector, dot, norm};

/// Until when a contact that begins now cannot be ended by a third body: a 64th of its duration, or,
/// if that is less, until it, or a plate towards it, can have moved a 64th of its radius or of its height
/// above a plane.
///
/// Meanwhile a third body may sink in by v τ/64, a fraction of what it would in a real contact; and the
/// centre of a grain that is pressed into a corner again and again does not come behind a plane.
pub(super) fn unbroken<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    body: &Body<S, D>,
    duration: S,
) -> S {
    let part = S::from_f32(1.0 / 64.0);
    let height = scene.boundary.planes().iter().fold(body.radius, |least, plane| {
        let height = plane.gap(&body.position, body.radius, scene.now) + body.radius;
        least.smaller(height.larger(body.radius * part * part))
    });
    let plates = scene.boundary.planes().iter().filter_map(|plane| plane.vibration);
    let shaken = plates.fold(S::zero(), |most, plate| most.larger(plate.peak_speed()));
    let (far, g) = (height * part, norm(&scene.gravity));
    let speed = norm(&body.velocity) + shaken;
    // v t + g t²/2 = far, without cancellation.
    let fastest = speed + (speed.times(speed) + (g + g).times(far)).root();
    let brief = duration * part;
    scene.now + if fastest * brief > far + far { (far + far) / fastest } else { brief }
}

/// Gravity has changed during the contact of grain `i`: a third body may end it in time again, and one
/// with a plane ends where it would have, or at once if gravity pulls the grain off visibly now.
pub(crate) fn goes_on<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    i: usize,
    before: &Vector<S, D>,
) {
    let Some(body) = scene.body(i).copied().filter(Body::in_contact) else { return };
    let (mut body, left) = (body, body.release_at - scene.now);
    if let Some(plane) = body.partner.as_plane().and_then(|p| scene.boundary.planes().get(p)) {
        let n = &plane.normal;
        body.velocity += n * (dot(n, &(before - scene.gravity)) * left * S::half());
        if plane::is_pulled_off(scene, &body, plane, left) {
            (body.release_at, body.moment) = (scene.now, scene.now);
        }
    }
    body.moment = body.moment.smaller(unbroken(scene, &body, left));
    scene.place(i, body);
}

/// E^φ: the line of centres turns, both grains take the velocity of their centre of mass, and what
/// they will have after the contact is kept for E^v (MP13 §VI.B.2). False if the turn would overlap a
/// third body (exception a): then nothing has changed.
pub(super) fn begins<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    who: [usize; 2],
    pair: &[Body<S, D>; 2],
    (touch, outcome): (&Touch<S, D>, &Outcome<S>),
    affected: &mut Affected,
) -> bool {
    let [a, b] = pair;
    let [i, k] = who;
    let (separation, velocity) = touch.after(a.radius + b.radius, outcome);
    let mass = a.mass + b.mass;
    let (share_a, share_b) = (b.mass / mass, -(a.mass / mass));
    let moved = separation - scene.separation(a, b);
    // Steps on the lattice: positions then do not depend on the image in which a grain is kept.
    let step = |share| scene.boundary.on_lattice(moved * share);
    let (at_a, at_b) = (a.position + step(share_a), b.position + step(share_b));
    if !(scene.is_free(i, at_a, Partner::grain(k)) && scene.is_free(k, at_b, Partner::grain(i))) {
        scene.counters.rotation_refused += 1;
        return false;
    }
    let centre = b.velocity + (a.velocity - b.velocity) * (a.mass / mass);
    let bound = |body: &Body<S, D>, position, share, partner| {
        let there = Body { position, velocity: centre, ..body.let_go() };
        Body {
            release: velocity * share,
            release_at: scene.now + outcome.duration,
            moment: unbroken(scene, &there, outcome.duration),
            partner: Partner::grain(partner),
            ..there
        }
    };
    let (bound_a, bound_b) = (bound(a, at_a, share_a, k), bound(b, at_b, share_b, i));
    for (x, body, bound) in [(i, a, bound_a), (k, b, bound_b)] {
        scene.relocate(x, bound);
        if body.is_held() {
            wake::grain(scene, x, affected);
        }
    }
    true
}
