//! How do grains come to rest? Reads supports; writes bodies at rest and counters.
//!
//! A grain whose next hop could not be told from lying still is laid still.
//! * On a plane: a hop lower than the rounding of its position, or shorter than the contact itself (of
//!   a soft law, or t_c). It may still slide; the plane takes what gravity presses into it.
//! * Among planes and grains at rest that hold it on all sides to which gravity pushes it: it is frozen.
//!   A column comes to rest as one, from below.
//! * In two and three dimensions, where grains hold each other up in all directions: a grain that has had
//!   64 slow collisions in a row, is itself slow and is held by such as it. A pile comes to rest as
//!   one; what it weighs on its neighbours is taken by them as by static friction.
//!
//! What lets them go is in [`super::wake`].
//! Slow is a speed that gravity takes away within the contact duration (of a soft law or t_c), or
//! within the hop time of [`super::support::hop`].

use super::apply::{Affected, Deed, without};
use super::bounce;
use super::scene::Scene;
use super::support::{CALM, HOPPING, carried, felt, give, is_nothing, size, unseen};
use super::turn::Touch;
use super::wake::push;
use crate::fault::Fault;
use crate::matter::{Body, flight};
use crate::number::{Product, Scalar, Vector, dot, norm};

/// Whether a rebound with this speed under this weight is too low or too short to be one.
fn is_rest<S: Scalar>(speed: S, weight: S, height: S, duration: S) -> bool {
    weight > S::zero()
        && (speed.times(speed) <= (weight + weight).times(height)
            || speed + speed <= weight * duration)
}

/// Whether a grain that leaves plane `p` at this speed comes to rest on it.
pub(super) fn settles<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    body: &Body<S, D>,
    p: usize,
    [speed, restitution, duration]: [S; 3],
) -> bool {
    let Some(plane) = scene.boundary.planes().get(p) else { return false };
    let pull = dot(&plane.normal, &flight::acceleration(body, scene.field()));
    let weight = plane.motion(scene.now).acceleration - pull;
    let hopping = body.burst >= HOPPING;
    let lossy = restitution < S::one() || speed == S::zero() || duration > S::zero() || hopping;
    let hop = if hopping { scene.hop } else { S::zero() };
    let duration = duration.larger(scene.t_c).larger(hop);
    lossy && is_rest(speed, weight, unseen(size(body)), duration)
}

/// Lays a grain onto plane `p`: it has the plane's speed along the normal, and keeps what is across.
pub(super) fn settle<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    i: usize,
    body: &Body<S, D>,
    p: usize,
) -> Deed<S> {
    let Some(plane) = scene.boundary.planes().get(p) else { return Deed::Wander };
    let speed = plane.motion(scene.now).speed;
    let velocity = without(&body.velocity, &plane.normal) + plane.normal * speed;
    let planes = body.planes & square_to(scene, p);
    let corner = planes != body.planes && !body.is_frozen();
    let planes = if body.is_frozen() { body.planes } else { planes };
    let at_rest = Body { velocity, planes, moment: scene.now, ..*body }.resting_on(p);
    let g = felt(scene, &at_rest);
    let wedged = corner && is_nothing(&give(scene, (i, &at_rest), g, None), &g);
    if wedged && freeze(scene, i, &at_rest, &at_rest, S::zero()) {
        return Deed::Rest;
    }
    scene.counters.rests += 1;
    scene.place(i, at_rest);
    Deed::Rest
}

/// The planes at right angles to plane `p`, as bits: sliding along one of two others leads off or into it.
fn square_to<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, p: usize) -> u8 {
    let Some(plane) = scene.boundary.planes().get(p) else { return 0 };
    let planes = scene.boundary.planes().iter().enumerate();
    let square =
        planes.filter(|(_, q)| dot(&q.normal, &plane.normal).magnitude() <= S::from_f32(1e-6));
    square.fold(0, |bits, (q, _)| bits | 1_u8.checked_shl(q as u32).unwrap_or(0))
}

/// Whether two grains touch so slowly that gravity decides what comes of it, not their collision.
///
/// In one dimension only grains of which one is held can: the others fall together.
pub(super) fn is_slow<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    [a, b]: &[Body<S, D>; 2],
    touch: &Touch<S, D>,
    [restitution, duration]: [S; 2],
) -> bool {
    if scene.weightless && scene.held == 0 {
        return false;
    }
    let held = [a, b].into_iter().find(|body| body.is_held());
    if D == 1 && held.is_none() {
        return false;
    }
    let g = felt(scene, held.unwrap_or(a));
    let lossy = restitution < S::one() || duration > S::zero();
    let hop = if lossy { scene.hop.larger(scene.t_c).larger(duration) } else { S::zero() };
    let height = unseen(size(a).larger(size(b)));
    // Where grains slide the approach says how fast they are, even if ε = 0.
    let speed = if D == 1 { -touch.radial * restitution } else { -touch.radial };
    is_rest(speed, norm(&g), height, hop)
}

/// The largest speed of a grain that can lie still.
fn slow<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, body: &Body<S, D>, radial: S) -> S {
    let g = felt(scene, body);
    let hop = scene.hop.larger(scene.t_c) * norm(&g);
    hop.larger(radial.magnitude()) * S::from_f32(2.0)
}

/// Counts slow collisions in a row. A grain that was calm and is not any more holds nothing up.
pub(super) fn calmed<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    (x, body): (usize, &Body<S, D>),
    (is_slow, radial): (bool, S),
    affected: &mut Affected,
) -> Body<S, D> {
    if D == 1 || body.is_frozen() || !is_slow && body.burst < CALM / 2 {
        return *body;
    }
    let moves = body.velocity - carried(scene, body);
    let limit = slow(scene, body, radial);
    if is_slow && S::dot(&moves, &moves) <= limit.times(limit) {
        return Body { burst: (body.burst + 1).min(CALM.max(body.burst)), ..*body };
    }
    if body.burst >= CALM / 2 {
        affected.wakes(x);
    }
    if is_slow { Body { burst: 0, ..*body } } else { *body }
}

/// Two grains touch slowly: whoever cannot move, and whoever is held from all sides, lies still.
pub(super) fn comes<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    who: [usize; 2],
    pair: &[Body<S, D>; 2],
    touch: &Touch<S, D>,
) -> bool {
    let [i, k] = who;
    let mut rested = false;
    for (x, body, other, push) in [(i, &pair[0], k, touch.e_r), (k, &pair[1], i, -touch.e_r)] {
        let blocked = body.is_held()
            && !body.is_frozen()
            && is_nothing(&give(scene, (x, body), push, Some(other)), &push);
        rested |= blocked && freeze(scene, x, body, body, touch.radial);
    }
    for (x, body, other) in [(i, &pair[0], k), (k, &pair[1], i)] {
        rested |= leans(scene, (x, body), other, touch.radial);
    }
    rested
}

/// Freezes a grain that is held from all sides, if the other one is frozen or it is calm itself.
fn leans<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    (x, body): (usize, &Body<S, D>),
    other: usize,
    radial: S,
) -> bool {
    let Some(support) = scene.body(other).copied() else { return false };
    let calm = D > 1 && body.burst >= CALM;
    if scene.body(x).is_some_and(Body::is_frozen) || !(support.is_frozen() || calm) {
        return false;
    }
    let g = felt(scene, &support);
    is_nothing(&give(scene, (x, body), g, None), &g) && freeze(scene, x, body, &support, radial)
}

/// Lays a grain still, on the plate that carries its support; not if that falls away, nor if the grain
/// moves on across the contact.
fn freeze<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    x: usize,
    body: &Body<S, D>,
    support: &Body<S, D>,
    radial: S,
) -> bool {
    let velocity = carried(scene, support);
    let moves = body.velocity - velocity;
    let limit = slow(scene, support, radial);
    let falls = flight::plates(support, scene.field())
        .any(|plate| plate.motion(scene.now).acceleration < dot(&plate.normal, &scene.gravity));
    if falls || (D > 1 && S::dot(&moves, &moves) > limit.times(limit)) {
        return false;
    }
    let planes = body.planes | support.planes;
    let at_rest = Body { velocity, planes, moment: scene.now, ..*body }.frozen();
    scene.counters.rests += 1;
    scene.place(x, at_rest);
    true
}

/// An elastic collision of two grains of which each moves only as its supports let it, and no slower
/// than a quarter of what is slow: else one that slides down another would hop ever faster.
pub(super) fn part<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    who: [usize; 2],
    pair: &[Body<S, D>; 2],
    touch: &Touch<S, D>,
    affected: &mut Affected,
) -> Result<Deed<S>, Fault> {
    let [a, b] = pair;
    let [i, k] = who;
    let e = touch.e_r;
    let to_a = moves(scene, (i, a), e, k);
    let to_b = moves(scene, (k, b), -e, i);
    let mobility = S::dot(&e, &to_a).over(a.mass) - S::dot(&e, &to_b).over(b.mass);
    let largest = S::one() / a.mass + S::one() / b.mass;
    if !(mobility > largest * S::from_f32(1e-4)) {
        return bounce::grains(scene, who, pair, touch, (S::one(), true), affected);
    }
    let g = felt(scene, if a.is_held() { a } else { b });
    let least = norm(&g) * scene.hop * S::from_f32(0.125);
    let approach = -touch.radial;
    let impulse = (approach + approach.larger(least)) / mobility;
    scene.counters.propped += 1;
    for (x, body, to) in [(i, a, to_a), (k, b, to_b)] {
        push(scene, x, body, to * (impulse / body.mass), affected);
    }
    Ok(Deed::Collision { restitution: S::one() })
}

/// What is left of a push on a grain: nothing if it lies still.
fn moves<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    (x, body): (usize, &Body<S, D>),
    push: Vector<S, D>,
    other: usize,
) -> Vector<S, D> {
    match (body.is_frozen(), body.is_held()) {
        (true, _) => Vector::zeros(),
        (_, true) => give(scene, (x, body), push, Some(other)),
        _ => push,
    }
}
