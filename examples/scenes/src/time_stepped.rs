//! What does the tilt box cost by force-based molecular dynamics? Reads the same grains; steps through time.
//!
//! The scheme is that of textbook MD: velocity Verlet, one evaluation of the forces a step, neighbour
//! lists, contacts by the very force law whose table the event-driven run reads.

use carom::{Grain, Scalar};

use crate::scene::n;
use crate::tilt::{self, DISSIPATION, GRAINS, POISSON, SIDE, YOUNG};

/// The longest neighbour list: in two dimensions about six neighbours a grain, each pair once.
const PAIRS: usize = 256;
/// How far outside contact a pair is listed, in millimetres.
const SKIN: f64 = 0.6;

#[derive(Clone, Copy, Debug)]
struct Body<S> {
    position: [S; 2],
    velocity: [S; 2],
    force: [S; 2],
    /// Where it was when the neighbours were listed.
    listed: [S; 2],
    radius: S,
    mass: S,
}

/// The tilt box as a time-stepped simulation.
pub struct TimeStepped<S> {
    bodies: [Body<S>; GRAINS],
    pairs: [(u8, u8); PAIRS],
    count: usize,
    gravity: [S; 2],
    step: S,
    /// (2/3) Y/(1 − ν²), and (3/2) A.
    stiffness: S,
    dissipation: S,
}

/// (l − r)^{3/2} ρ + (3/2) A ρ (l − r)^{1/2} v_n, never pulling (MP13 Eq. 51).
fn force<S: Scalar>(rho: S, dissipation: S, overlap: S, approach: S) -> S {
    (rho * overlap.sqrt() * (overlap + dissipation * approach)).max(S::zero())
}

fn dot<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[0] + a[1] * b[1]
}

fn minus<S: Scalar>(a: [S; 2], b: [S; 2]) -> [S; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

impl<S: Scalar> TimeStepped<S> {
    /// The grains of the tilt box, and a time step in milliseconds.
    ///
    /// Not inlined: the copy that is made of it does not stay on the stack.
    #[inline(never)]
    #[must_use]
    pub fn new(grains: &[Grain<S, 2>; GRAINS], step: S) -> Self {
        let zero = [S::zero(); 2];
        let bodies = grains.map(|grain| {
            let (position, velocity) = (grain.position.into(), grain.velocity.into());
            let (radius, mass) = (grain.radius, grain.mass);
            Body { position, velocity, force: zero, listed: position, radius, mass }
        });
        let stiffness = n(2.0 / 3.0 * YOUNG / (1.0 - POISSON * POISSON));
        let (pairs, dissipation) = ([(0, 0); PAIRS], n(1.5 * DISSIPATION));
        let mut run = Self { bodies, pairs, count: 0, gravity: zero, step, stiffness, dissipation };
        run.list();
        run.forces();
        run
    }

    /// Gravity is that of a reading from now on.
    pub fn tilt(&mut self, reading: u32) {
        self.gravity = tilt::accelerometer(reading);
    }

    /// Where a grain is.
    #[must_use]
    pub fn position(&self, grain: usize) -> [S; 2] {
        self.bodies[grain].position
    }

    /// One time step.
    pub fn advance(&mut self) {
        let (step, half) = (self.step, self.step * S::half());
        let limit = n::<S>(SKIN * SKIN / 4.0);
        let mut far = false;
        for body in &mut self.bodies {
            let kick = half / body.mass;
            for axis in 0..2 {
                body.velocity[axis] += kick * body.force[axis] + half * self.gravity[axis];
                body.position[axis] += step * body.velocity[axis];
            }
            let moved = minus(body.position, body.listed);
            far |= dot(moved, moved) > limit;
        }
        if far {
            self.list();
        }
        self.forces();
        for body in &mut self.bodies {
            let kick = half / body.mass;
            for axis in 0..2 {
                body.velocity[axis] += kick * body.force[axis] + half * self.gravity[axis];
            }
        }
    }

    /// Lists the pairs that may touch before one of their grains has moved half of the skin.
    fn list(&mut self) {
        self.count = 0;
        for a in 0..GRAINS {
            for b in 0..a {
                let separation = minus(self.bodies[a].position, self.bodies[b].position);
                let cutoff = self.bodies[a].radius + self.bodies[b].radius + n(SKIN);
                if dot(separation, separation) < cutoff * cutoff && self.count < PAIRS {
                    self.pairs[self.count] = (a as u8, b as u8);
                    self.count += 1;
                }
            }
        }
        self.bodies.iter_mut().for_each(|body| body.listed = body.position);
    }

    fn forces(&mut self) {
        for k in 0..GRAINS {
            self.walls(k);
        }
        for k in 0..self.count {
            let (a, b) = (usize::from(self.pairs[k].0), usize::from(self.pairs[k].1));
            self.pair(a, b);
        }
    }

    fn pair(&mut self, a: usize, b: usize) {
        let (one, other) = (self.bodies[a], self.bodies[b]);
        let separation = minus(one.position, other.position);
        let (square, contact_distance) = (dot(separation, separation), one.radius + other.radius);
        if square >= contact_distance * contact_distance {
            return;
        }
        let distance = square.sqrt();
        let approach = -dot(separation, minus(one.velocity, other.velocity)) / distance;
        let rho = self.stiffness * (one.radius * other.radius / contact_distance).sqrt();
        let along = force(rho, self.dissipation, contact_distance - distance, approach) / distance;
        for (axis, part) in separation.into_iter().enumerate() {
            self.bodies[a].force[axis] += along * part;
            self.bodies[b].force[axis] -= along * part;
        }
    }

    /// Forgets a grain's force and adds those of the four walls.
    fn walls(&mut self, k: usize) {
        let (side, body) = (n::<S>(f64::from(SIDE)), &mut self.bodies[k]);
        for axis in 0..2 {
            let (x, u, r) = (body.position[axis], body.velocity[axis], body.radius);
            body.force[axis] = S::zero();
            if x < r {
                body.force[axis] += force(self.stiffness * r.sqrt(), self.dissipation, r - x, -u);
            } else if x > side - r {
                let overlap = x - (side - r);
                body.force[axis] -= force(self.stiffness * r.sqrt(), self.dissipation, overlap, u);
            }
        }
    }
}
