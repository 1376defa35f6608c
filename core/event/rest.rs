//! How do grains come to rest, and what lets them go? Reads supports; writes bodies at rest and counters.
//!
//! A grain whose next hop could not be told from lying still is laid still. Against a plane that is
//! a hop lower than the rounding of its position, or shorter than the contact itself (of a soft
//! law, or t_c). On a plane it may still slide; the plane takes what gravity presses into it. A grain
//! that planes and grains at rest hold on all sides that gravity pushes it to is frozen: a column or
//! pile comes to rest as one, from below. It wakes when it is hit, when what holds it
//! moves, or when its plate falls away.

use super::apply::{Affected, Deed, without};
use super::scene::Scene;
use super::turn::Touch;
use crate::matter::{Body, flight};
use crate::number::{Scalar, Vector};

/// The normals of what touches a body and does not give way.
type Supports<S, const D: usize> = heapless::Vec<Vector<S, D>, 24>;

/// Hops as high as 64 units in the last place of the size are no hops.
fn unseen<S: Scalar>(size: S) -> S {
    size * S::RESOLUTION * S::from_f32(64.0)
}

/// In two and three dimensions grains on grains are slow while they hop less than 2^-21 of their reach:
/// there a grain slides down another in hops, which must not become ever smaller.
fn low<S: Scalar, const D: usize>(size: S) -> S {
    if D == 1 { unseen(size) } else { size * S::from_f64(1.0 / 2_097_152.0) }
}

/// How far from its radius rounding can put a body.
fn size<S: Scalar, const D: usize>(body: &Body<S, D>) -> S {
    body.position.iter().fold(body.radius, |far, x| far.larger(x.magnitude()))
}

/// Whether a rebound with this speed under this weight is too small or too short to be one.
pub(super) fn is_rest<S: Scalar>(speed: S, weight: S, height: S, duration: S) -> bool {
    weight > S::zero()
        && (speed * speed <= (weight + weight) * height || speed + speed <= weight * duration)
}

/// Whether a grain that leaves plane `p` at this speed comes to rest on it.
pub(super) fn settles<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    body: &Body<S, D>,
    p: usize,
    [speed, restitution, duration]: [S; 3],
) -> bool {
    let Some(plane) = scene.boundary.planes().get(p) else { return false };
    let pull = plane.normal.dot(&flight::acceleration(body, scene.field()));
    let weight = plane.motion(scene.now).acceleration - pull;
    let lossy = restitution < S::one() || speed == S::zero() || duration > S::zero();
    lossy && is_rest(speed, weight, unseen(size(body)), duration.larger(scene.t_c))
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
    let moment = scene.now;
    let at_rest = Body { velocity, moment, burst: 0, ..*body }.resting_on(p);
    scene.counters.rests += 1;
    scene.place(i, at_rest);
    Deed::Rest
}

/// Gravity as a body feels it that moves with the plate that carries `held`.
fn felt<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, held: &Body<S, D>) -> Vector<S, D> {
    match flight::plate(held, scene.field()) {
        Some(plate) => scene.gravity - plate.normal * plate.motion(scene.now).acceleration,
        None => scene.gravity,
    }
}

/// The velocity of the plate that carries a body; zero if none does.
fn carried<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>, body: &Body<S, D>) -> Vector<S, D> {
    match flight::plate(body, scene.field()) {
        Some(plate) => plate.normal * plate.motion(scene.now).speed,
        None => Vector::zeros(),
    }
}

/// Whether two grains, at least one of them held, touch too slowly for a collision of their own.
pub(super) fn is_slow<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    [a, b]: &[Body<S, D>; 2],
    touch: &Touch<S, D>,
    [restitution, duration]: [S; 2],
) -> bool {
    let Some(held) = [a, b].into_iter().find(|body| body.is_held()) else { return false };
    let g = felt(scene, held);
    let back = -touch.radial * restitution;
    let reach = size(a).larger(size(b));
    let lossy = restitution < S::one() || duration > S::zero();
    let height = if lossy { low::<S, D>(a.radius + b.radius) } else { S::zero() };
    let height = height.larger(unseen(reach));
    is_rest(back, g.dot(&g).sqrt(), height, duration.larger(scene.t_c))
}

/// What is left of a push `w` on grain `i`, standing as `body`, after its supports have taken their part:
/// the projection onto the directions in which it can move. `and` counts as one that lies still.
fn give<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    (i, body): (usize, &Body<S, D>),
    w: Vector<S, D>,
    not: Option<usize>,
) -> Vector<S, D> {
    let supports = supports(scene, i, body, not);
    let mut taken = [S::zero(); 24];
    let mut left = w;
    // Gauss and Seidel: each support takes what is pressed into it and gives back what was too much.
    for _ in 0..if D == 1 { 1 } else { 32 } {
        for (n, t) in supports.iter().zip(&mut taken) {
            let more = (*t - left.dot(n)).larger(S::zero());
            left += n * (more - *t);
            *t = more;
        }
    }
    left
}

/// The normals, towards grain `i`, of the planes and of the grains at rest (but `not`) that it touches.
fn supports<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    i: usize,
    body: &Body<S, D>,
    not: Option<usize>,
) -> Supports<S, D> {
    let mut supports = Supports::new();
    let near = low::<S, D>(body.radius).larger(unseen(size(body))) * S::from_f32(8.0);
    for plane in scene.boundary.planes() {
        if plane.gap(&body.position, body.radius, scene.now) <= near {
            let _ = supports.push(plane.normal);
        }
    }
    for k in scene.cells.near(body.cell) {
        let at_rest = |other: &&Body<S, D>| k != i && Some(k) != not && other.is_frozen();
        if scene.body(k).filter(at_rest).is_none() {
            continue;
        }
        let other = scene.present(k);
        let apart = scene.separation(body, &other);
        let distance = apart.dot(&apart).sqrt();
        if distance <= body.radius + other.radius + near && distance > S::zero() {
            let _ = supports.push(apart / distance);
        }
    }
    supports
}

/// Whether a part of a push this small is nothing.
fn is_nothing<S: Scalar, const D: usize>(left: &Vector<S, D>, of: &Vector<S, D>) -> bool {
    left.dot(left) <= of.dot(of) * S::from_f32(1e-6)
}

/// Two grains touch slowly, at least one of them held: whoever cannot move lies still; who is held
/// by such grains lies still too; else they part, each only as far as its supports let it.
pub(super) fn lean<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    who: [usize; 2],
    pair: &[Body<S, D>; 2],
    touch: &Touch<S, D>,
    affected: &mut Affected,
) -> Deed<S> {
    let pushes = [touch.e_r, -touch.e_r];
    let [i, k] = who;
    let gives: [Vector<S, D>; 2] = core::array::from_fn(|x| match (x, pair) {
        (0, [a, _]) if a.is_held() => give(scene, (i, a), pushes[0], Some(k)),
        (1, [_, b]) if b.is_held() => give(scene, (k, b), pushes[1], Some(i)),
        (0, _) => pushes[0],
        _ => pushes[1],
    });
    let mut rested = false;
    for ((&x, body), (give, push)) in who.iter().zip(pair).zip(gives.iter().zip(&pushes)) {
        if body.is_held() && is_nothing(give, push) {
            rested |= freeze(scene, x, body, body, touch);
        }
    }
    for ((&x, body), &other) in who.iter().zip(pair).zip(&[k, i]) {
        rested |= leans_on(scene, (x, body), other, touch);
    }
    if rested { Deed::Rest } else { part(scene, who, pair, touch, &gives, affected) }
}

/// Freezes a grain if the other one is frozen and it is held from all sides.
fn leans_on<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    (x, body): (usize, &Body<S, D>),
    other: usize,
    touch: &Touch<S, D>,
) -> bool {
    let Some(support) = scene.body(other).filter(|support| support.is_frozen()).copied() else {
        return false;
    };
    let g = felt(scene, &support);
    !scene.body(x).is_some_and(Body::is_frozen)
        && is_nothing(&give(scene, (x, body), g, None), &g)
        && freeze(scene, x, body, &support, touch)
}

/// Lays a grain still, on the plate that carries its support; not if it moves on across the contact.
fn freeze<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    x: usize,
    body: &Body<S, D>,
    support: &Body<S, D>,
    touch: &Touch<S, D>,
) -> bool {
    let velocity = carried(scene, support);
    let moves = body.velocity - velocity;
    let g = felt(scene, support);
    let slow = low::<S, D>(body.radius) * g.dot(&g).sqrt() * S::from_f32(32.0);
    let slow = slow.larger(touch.radial * touch.radial * S::from_f32(4.0));
    if body.is_frozen() || (D > 1 && moves.dot(&moves) > slow) {
        return false;
    }
    let planes = body.planes | support.planes;
    let at_rest = Body { velocity, planes, moment: scene.now, ..*body }.frozen();
    scene.counters.rests += 1;
    scene.place(x, at_rest);
    true
}

/// An elastic collision of two grains of which each moves only as its supports let it, and no slower
/// than an eighth of what is slow: else one that slides down another would hop ever faster.
fn part<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    who: [usize; 2],
    pair: &[Body<S, D>; 2],
    touch: &Touch<S, D>,
    gives: &[Vector<S, D>; 2],
    affected: &mut Affected,
) -> Deed<S> {
    let [a, b] = pair;
    let [to_a, to_b] = gives;
    let e = &touch.e_r;
    let mobility = e.dot(to_a) / a.mass - e.dot(to_b) / b.mass;
    let largest = S::one() / a.mass + S::one() / b.mass;
    if !(mobility > largest * S::from_f32(1e-6)) {
        return Deed::Wander;
    }
    let held = if a.is_held() { a } else { b };
    let g = felt(scene, held);
    let least = (g.dot(&g).sqrt() * low::<S, D>(a.radius + b.radius)).sqrt() * S::from_f32(0.125);
    let approach = -touch.radial;
    let impulse = (approach + approach.larger(least)) / mobility;
    scene.counters.propped += 1;
    for ((&x, body), give) in who.iter().zip(pair).zip(gives) {
        push(scene, x, body, give * (impulse / body.mass), affected);
    }
    Deed::Collision { restitution: S::one() }
}

/// Adds to a body's velocity. What it was pushed off or into holds it no longer.
pub(super) fn push<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    x: usize,
    body: &Body<S, D>,
    change: Vector<S, D>,
    affected: &mut Affected,
) {
    let mut pushed = Body { velocity: body.velocity + change, moment: scene.now, ..*body };
    if body.is_held() && change.dot(&change) > S::zero() {
        pushed = pushed.let_go();
        for (p, plane) in scene.boundary.planes().iter().enumerate() {
            let near = unseen(size(body)) * S::from_f32(8.0);
            let lies = plane.gap(&body.position, body.radius, scene.now) <= near;
            if body.rests_on(p) && lies && plane.normal.dot(&change) == S::zero() {
                pushed = pushed.resting_on(p);
            }
        }
        wakes(scene, x, affected);
    }
    scene.place(x, pushed);
}

/// A grain that was at rest is not any more.
pub(super) fn wakes<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    x: usize,
    affected: &mut Affected,
) {
    scene.counters.take_offs += 1;
    affected.wakes(x);
}

/// The plate that carries grain `i` falls away faster than the grain does.
pub(crate) fn take_off<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    i: usize,
    affected: &mut Affected,
) -> Deed<S> {
    affected.again(i);
    let free = scene.present(i).let_go();
    scene.place(i, free);
    wakes(scene, i, affected);
    Deed::TakeOff
}

/// Something next to grain `i` has moved: is it still held?
pub(crate) fn check<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    i: usize,
    affected: &mut Affected,
) -> Deed<S> {
    affected.again(i);
    let body = scene.present(i);
    let g = felt(scene, &body);
    if !body.is_frozen() || is_nothing(&give(scene, (i, &body), g, None), &g) {
        return Deed::Wander;
    }
    take_off(scene, i, affected)
}

/// Whether grain `k` lies still and touches grain `i`.
pub(crate) fn lies_on<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    k: usize,
    i: usize,
) -> bool {
    if k == i || !scene.body(k).is_some_and(Body::is_frozen) {
        return false;
    }
    let (a, b) = (scene.present(i), scene.present(k));
    let apart = scene.separation(&a, &b);
    let near = low::<S, D>(a.radius + b.radius).larger(unseen(size(&a).larger(size(&b))));
    apart.dot(&apart).sqrt() <= a.radius + b.radius + near * S::from_f32(16.0)
}
