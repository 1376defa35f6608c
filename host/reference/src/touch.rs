//! How does a contact under friction go on to its end? Reads two that touch, a normal force and friction; writes their state when they part.
//!
//! Newton's and Euler's equations in Cartesian coordinates, by Dormand and Prince's method of fifth order with steps
//! chosen by its error; the contact's end, and where surfaces begin to slide or to stick, are located in time.

use crate::error::ReferenceError;
use crate::friction::Friction;
use crate::general_law::Normal;
use crate::rough_step::{STATE, State, Vector, cross, dot, parts, plus, step};
use std::cell::Cell;

/// So often the two have neared each other anew without parting: they do not part.
const STUCK: u32 = 8;

/// Who touches: two grains, or one and a plane, which is infinitely heavy and flat.
pub(crate) struct Touch {
    pub normal: Normal,
    pub friction: Friction,
    /// R₁ and R₂; R₂ = 0 for a plane.
    pub radii: [f64; 2],
    /// 1/m₁ and 1/m₂.
    pub inverse: [f64; 2],
    /// The normal of a plane.
    pub plane: Option<Vector>,
    /// How deep the two have been.
    pub deepest: Cell<f64>,
}

/// What surfaces do at an instant.
#[derive(Clone, Copy, PartialEq)]
enum Surfaces {
    Stick,
    Slide,
}

/// The contact as it is at an instant.
struct Instant {
    normal: Vector,
    /// How the normal turns.
    turning: Vector,
    arms: [f64; 2],
    overlap: f64,
    rate: f64,
    /// How the surfaces slide.
    sliding: Vector,
}

impl Touch {
    fn at(&self, y: &State) -> Instant {
        let [r, v, w, z, _] = parts(y);
        let reach = self.radii[0] + self.radii[1];
        let distance = self.plane.map_or_else(|| dot(&r, &r).sqrt(), |n| dot(&r, &n));
        let normal = self.plane.unwrap_or_else(|| r.map(|x| x / distance));
        let along = dot(&normal, &v);
        let across = plus(&v, -along, &normal);
        let turning = if self.plane.is_some() { [0.0; 3] } else { across.map(|x| x / distance) };
        let arms = self.radii.map(|radius| radius * distance / reach);
        let spin: Vector = std::array::from_fn(|k| arms[0] * w[k] + arms[1] * z[k]);
        let sliding = plus(&across, -1.0, &cross(&spin, &normal));
        Instant { normal, turning, arms, overlap: reach - distance, rate: -along, sliding }
    }

    /// The normal force before it is cut at zero.
    fn raw(&self, at: &Instant) -> f64 {
        self.normal.force(at.overlap, at.rate, self.deepest.get())
    }

    /// The length of the spring that would hold as strongly as spring and dashpot do.
    fn free(&self, at: &Instant, s: &Vector) -> Vector {
        plus(s, self.friction.damping / self.friction.stiffness, &at.sliding)
    }

    /// How fast μ F_n/k_t grows, the acceleration of the overlap being known.
    fn growth(&self, at: &Instant, acceleration: f64) -> f64 {
        let x = if at.overlap.abs() > 1e-300 { at.overlap } else { 1e-300 };
        let [in_x, in_u] = self.normal.slopes([x, at.rate], self.deepest.get());
        self.friction.mu / self.friction.stiffness * (in_x * at.rate + in_u * acceleration)
    }

    /// λ: how fast the spring is cut while surfaces slide; below zero they stick.
    fn cut(&self, y: &State) -> f64 {
        let (at, [.., s]) = (self.at(y), parts(y));
        let free = self.free(&at, &s);
        let size = dot(&free, &free).sqrt();
        let along = |g: &Vector| match size > 0.0 {
            true => dot(&free, g) / size,
            false => dot(g, g).sqrt(),
        };
        let slope = self.slope(y, Surfaces::Stick, None);
        let acceleration =
            -(dot(&[slope[3], slope[4], slope[5]], &at.normal) + dot(&parts(y)[1], &at.turning));
        // How a dashpot's force changes while surfaces stick.
        let dashpot = self.friction.damping / self.friction.stiffness;
        let faster = if dashpot > 0.0 && size > 0.0 {
            let h = 1e-6 * (at.overlap / at.rate).abs().max(1e-300);
            let later = self.at(&std::array::from_fn(|k| y[k] + h * slope[k])).sliding;
            dashpot * (along(&later) - along(&at.sliding)) / h
        } else {
            0.0
        };
        along(&at.sliding) + faster - self.growth(&at, acceleration)
    }

    /// By how much the spring is longer than friction can hold.
    fn excess(&self, y: &State) -> f64 {
        let (at, [.., s]) = (self.at(y), parts(y));
        let most = self.friction.mu * self.raw(&at).max(0.0) / self.friction.stiffness;
        let free = self.free(&at, &s);
        dot(&free, &free).sqrt() - most
    }

    fn slope(&self, y: &State, surfaces: Surfaces, cut: Option<f64>) -> State {
        let (at, [_, v, _, _, s]) = (self.at(y), parts(y));
        let Friction { mu, stiffness, inertia, .. } = self.friction;
        let (force, free) = (self.raw(&at), self.free(&at, &s));
        let is_plain = matches!(self.normal, Normal::Plain(_));
        let force = if is_plain { force.max(0.0) } else { force };
        // What does not press does not rub.
        let is_free = mu == 0.0 || !is_plain && force <= 0.0;
        let size = dot(&free, &free).sqrt();
        let held: Vector = match surfaces {
            _ if is_free => [0.0; 3],
            Surfaces::Slide if size > 0.0 => free.map(|x| -mu * force.max(0.0) * x / size),
            _ => free.map(|x| -stiffness * x),
        };
        let total = plus(&held, force, &at.normal);
        let size = dot(&s, &s).sqrt();
        let inverse = self.inverse[0] + self.inverse[1];
        let torque = cross(&at.normal, &held);
        let turned = |k: usize| {
            let radius = self.radii[k];
            let share = if radius > 0.0 {
                at.arms[k] * self.inverse[k] / (inertia * radius * radius)
            } else {
                0.0
            };
            torque.map(|x| -share * x)
        };
        let mut spring = plus(&at.sliding, -dot(&s, &at.turning), &at.normal);
        if let (Surfaces::Slide, true, Some(cut)) = (surfaces, size > 0.0, cut) {
            spring = plus(&spring, -cut / size, &s);
        }
        // A spring beside a dashpot has the length that is left for it.
        let is_left = surfaces == Surfaces::Slide && self.friction.damping > 0.0;
        if is_free || is_left {
            spring = [0.0; 3];
        }
        let all = [v, total.map(|x| x * inverse), turned(0), turned(1), spring];
        let mut slope = [0.0; STATE];
        all.iter().flatten().zip(&mut slope).for_each(|(x, place)| *place = *x);
        slope
    }

    /// The spring as long as friction holds it.
    fn held(&self, y: &State) -> State {
        let (at, [.., s]) = (self.at(y), parts(y));
        let most = self.friction.mu * self.raw(&at).max(0.0) / self.friction.stiffness;
        let free = self.free(&at, &s);
        let size = dot(&free, &free).sqrt();
        let mut held = *y;
        if size > 0.0 {
            let dashpot = self.friction.damping / self.friction.stiffness;
            (0..3).for_each(|k| held[12 + k] = free[k] * most / size - dashpot * at.sliding[k]);
        }
        held
    }

    fn moved(&self, y: &State, surfaces: Surfaces, h: f64, units: [f64; 3]) -> (State, f64) {
        let slope = |y: &State| {
            let cut = (surfaces == Surfaces::Slide).then(|| self.cut(y));
            self.slope(y, surfaces, cut)
        };
        let (next, worst) = step(y, h, units, slope);
        (if surfaces == Surfaces::Slide { self.held(&next) } else { next }, worst)
    }

    /// Whether the contact is over, or surfaces do something else than before.
    fn changes(&self, y: &State, surfaces: Surfaces, length: f64) -> bool {
        let at = self.at(y);
        let over = self.normal.is_over([at.overlap, at.rate], self.raw(&at));
        // Where friction holds next to nothing it does not matter what surfaces do.
        let most = self.friction.mu * self.raw(&at) / self.friction.stiffness;
        let matters = most > 1e-11 * length;
        over || matters
            && match surfaces {
                // More than rounding: where they begin to stick both are the same.
                Surfaces::Stick => self.excess(y) > 1e-13 * length,
                Surfaces::Slide => self.cut(y) < 0.0,
            }
    }

    /// From the touch to the end: the state then, and the duration; none if the two do not part.
    fn run(&self, touch: &State, scales: [f64; 2]) -> Result<Option<(State, f64)>, ReferenceError> {
        let [time, length] = scales;
        let units = [length, length / time, length / time / self.radii[0]];
        // Before the first step nothing presses, and nothing is stretched.
        let (mut t, mut h) = (1e-9 * time, 1e-9 * time);
        let mut y = self.moved(touch, Surfaces::Stick, t, units).0;
        let (mut surfaces, mut neared) = (Surfaces::Stick, 0);
        for _ in 0..1_000_000 {
            if surfaces == Surfaces::Stick && self.changes(&y, surfaces, length) {
                (surfaces, y) = (Surfaces::Slide, self.held(&y));
                if self.cut(&y) < 0.0 {
                    surfaces = Surfaces::Stick;
                }
            }
            let (next, worst) = self.moved(&y, surfaces, h, units);
            if worst > 1e-12 && h > 1e-12 * time {
                h *= (0.9 * (1e-12 / worst).powf(0.2)).clamp(0.2, 0.9);
                continue;
            }
            if self.changes(&next, surfaces, length) {
                let (before, after) = self.located(&y, surfaces, h, units);
                t += after;
                y = before;
                self.remember(&y);
                let at = self.at(&y);
                if self.normal.is_over([at.overlap, at.rate], self.raw(&at)) {
                    return Ok(Some((y, t)));
                }
                surfaces = match surfaces {
                    Surfaces::Slide => Surfaces::Stick,
                    Surfaces::Stick => Surfaces::Slide,
                };
                continue;
            }
            let (next, gone) = self.as_far_as_the_turn(&y, (next, h), surfaces, units);
            let [before, after] = [&y, &next].map(|y| self.at(y));
            neared += u32::from(before.rate < 0.0 && after.rate >= 0.0);
            if neared == STUCK {
                return Ok(None);
            }
            self.remember(&next);
            (t, y) = (t + gone, next);
            h *= (0.9 * (1e-12 / worst.max(1e-18)).powf(0.2)).clamp(0.2, 3.0);
            h = h.min(0.02 * time);
        }
        let why = "it has not ended within a million steps";
        Err(ReferenceError::Unresolved { time: t, grain: 0, why })
    }

    /// How deep the two are may be the deepest so far.
    fn remember(&self, y: &State) {
        self.deepest.set(self.deepest.get().max(self.at(y).overlap));
    }

    /// A step, but no further than to where the overlap is largest, for laws that remember it.
    fn as_far_as_the_turn(
        &self,
        y: &State,
        (next, h): (State, f64),
        surfaces: Surfaces,
        units: [f64; 3],
    ) -> (State, f64) {
        let turns = self.at(y).rate > 0.0 && self.at(&next).rate < 0.0;
        if matches!(self.normal, Normal::Plain(_)) || !turns {
            return (next, h);
        }
        let (mut low, mut high) = (0.0, h);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let there = self.moved(y, surfaces, middle, units).0;
            if self.at(&there).rate < 0.0 { high = middle } else { low = middle }
        }
        (self.moved(y, surfaces, high, units).0, high)
    }

    /// The state just after the change within a step, and how long until then.
    fn located(&self, y: &State, surfaces: Surfaces, h: f64, units: [f64; 3]) -> (State, f64) {
        let (mut low, mut high) = (0.0, h);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            let there = self.moved(y, surfaces, middle, units).0;
            if self.changes(&there, surfaces, units[0]) { high = middle } else { low = middle }
        }
        (self.moved(y, surfaces, high, units).0, high)
    }
}

impl Touch {
    /// The impact at this speed along the normal; none if the two do not part.
    pub fn impact(
        &self,
        begin: &State,
        speed: f64,
    ) -> Result<Option<(State, f64)>, ReferenceError> {
        if !(speed > 0.0) {
            let what = "approach speed";
            return Err(ReferenceError::NotAnImpact { first: 0, second: 1, what, value: speed });
        }
        self.run(begin, self.normal.scales(speed))
    }
}
