//! What does an instantaneous collision leave? Reads two bodies or a body and a plane; writes velocities.
//!
//! Two rules can make it elastic: the TC rule, if the last collision is less than t_c ago (Luding &
//! McNamara, Granul. Matter 1, 113, 1998), and, so that no collapse goes on for ever, the end of
//! patience with collisions that follow each other within the rounding of positions.

use super::apply::{Affected, Deed};
use super::scene::{Counters, Scene};
use super::support::HOPPING;
use super::turn::Touch;
use super::{rest, wake};
use crate::fault::Fault;
use crate::matter::{Body, Partner};
use crate::number::{Scalar, Vector, dot, largest, norm};

/// After so many collisions right after each other they are elastic.
const fn patience<const D: usize>() -> u16 {
    if D == 1 { 2048 } else { 256 }
}

/// After so many, elastic ones included, the world is stuck.
const MOST: u16 = u16::MAX - 1;

/// An instantaneous collision of two grains (MP13 Eq. 63 with the signs right; BSFP14 Eq. 5).
pub(super) fn grains<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    who: [usize; 2],
    pair: &[Body<S, D>; 2],
    touch: &Touch<S, D>,
    (restitution, is_slow): (S, bool),
    affected: &mut Affected,
) -> Result<Deed<S>, Fault> {
    let [a, b] = pair;
    let [i, k] = who;
    let speed = -touch.radial;
    let [x, y] = [a, b].map(|body| burst(scene, body, speed, is_slow));
    let last = a.last_collision().larger(b.last_collision());
    let lossy = restitution < S::one();
    let restitution = lasting::<S, D>(scene, restitution, (last, is_slow), x.max(y));
    // Hops that lose nothing only because they are slow may end on an elastic plane, too.
    let hopping = is_slow && lossy && restitution == S::one();
    let [x, y] = [x, y].map(|burst| if hopping { burst.max(HOPPING) } else { burst });
    if x.min(y) >= MOST {
        return Err(stuck(scene, i, Partner::grain(k), x.min(y)));
    }
    let away = (restitution * speed).larger(told_apart(&a.velocity) + told_apart(&b.velocity));
    let change = touch.e_r * (speed + away);
    let mass = a.mass + b.mass;
    wake::push(scene, i, &Body { burst: kept(a, x), ..*a }, change * (b.mass / mass), affected);
    wake::push(scene, k, &Body { burst: kept(b, y), ..*b }, -change * (a.mass / mass), affected);
    Ok(Deed::Collision { restitution })
}

/// A reflection at plane `p`, that may move, with this speed of approach.
pub(super) fn plane<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    (i, p): (usize, usize),
    body: &Body<S, D>,
    [speed, restitution]: [S; 2],
    affected: &mut Affected,
) -> Result<Deed<S>, Fault> {
    let Some(plane) = scene.boundary.planes().get(p) else { return Ok(Deed::Wander) };
    let normal = plane.normal;
    let is_slow = speed + speed <= norm(&scene.gravity) * scene.hop;
    let mut burst = burst(scene, body, speed, is_slow);
    if is_slow && loses(scene) {
        burst = burst.max((burst + 1).min(HOPPING));
    }
    if burst >= MOST {
        return Err(stuck(scene, i, Partner::plane(p), burst));
    }
    if rest::settles(scene, body, p, [speed * restitution, restitution, S::zero()]) {
        return Ok(rest::settle(scene, i, body, p));
    }
    let restitution = lasting::<S, D>(scene, restitution, (body.last_collision(), false), burst);
    let away = (speed * restitution).larger(S::zero());
    let mut change = normal * (speed + away);
    if dot(&normal, &(body.velocity + change)) < scene.speed_of(p) {
        change += normal * told_apart(&body.velocity);
    }
    wake::push(scene, i, &Body { burst: kept(body, burst), ..*body }, change, affected);
    Ok(Deed::Collision { restitution })
}

/// Whether slow collisions would have lost energy in this world but for the rules above. Where everything
/// is elastic no hop on a plane may end.
fn loses<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>) -> bool {
    scene.counters.within_tc > 0
}

/// The smallest change of a velocity that its rounding does not swallow. Grains part at least this
/// fast: with ε = 0, else, rounding could leave them approaching, and the collision would repeat itself.
fn told_apart<S: Scalar, const D: usize>(velocity: &Vector<S, D>) -> S {
    largest(velocity).rounding() * S::from_f32(4.0)
}

/// A frozen body stays one until it is pushed.
fn kept<S: Scalar, const D: usize>(body: &Body<S, D>, burst: u16) -> u16 {
    if body.is_frozen() { body.burst } else { burst }
}

/// How many collisions the body has had right after each other, this one included: it flew less than
/// the rounding of its position since the last. Slow ones have been counted already.
fn burst<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    body: &Body<S, D>,
    speed: S,
    is_slow: bool,
) -> u16 {
    let far = body.position.iter().fold(body.radius, |far, x| far.larger(x.magnitude()));
    let last = body.last_collision();
    let flown = if last > -S::NEVER { (scene.now - last) * speed } else { S::NEVER };
    if body.is_frozen() || !(flown <= far.rounding() * S::from_f32(4.0)) {
        return if is_slow { body.burst } else { 0 };
    }
    (body.burst + 1).min(MOST)
}

/// The coefficient of restitution after both rules.
fn lasting<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    restitution: S,
    (last, is_slow): (S, bool),
    burst: u16,
) -> S {
    let t_c = if is_slow { scene.t_c.larger(scene.hop) } else { scene.t_c };
    let soon = last > -S::NEVER && scene.now - last < t_c;
    let endless = burst >= patience::<D>();
    if restitution < S::one() && (soon || endless) {
        let Counters { within_tc, collapses, .. } = &mut scene.counters;
        *(if soon { within_tc } else { collapses }) += 1;
        return S::one();
    }
    restitution
}

fn stuck<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    grain: usize,
    with: Partner,
    events: u16,
) -> Fault {
    Fault::Stuck { grain, with, at: scene.instant(), events: u32::from(events) }
}
