//! How are contacts treated that last or crowd, and how stiff is what stands in for a hard one? Reads and writes nothing else.

use crate::error::Error;
use crate::law::{Enduring, Impact, Rule, tried};
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, WideProduct, norm};
use crate::space::{Boundary, Obstacles, Sight, Surface};

/// What a world was told of clusters, and what follows from its grains.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Settings<S> {
    pub enduring: Enduring,
    /// n: steps in the shortest contact that a crowd can have.
    pub steps: S,
    /// The stand-in's contact time; none: (R/g)^½/16, R the pair's own.
    pub contact_time: Option<S>,
    /// What the stand-in's contact time follows from: the last gravity that was not zero, with what plates add.
    pub gravity: S,
    /// The smallest radius and mass.
    pub smallest: [S; 2],
    /// The largest speed that a plate's vibration gives it, and the largest acceleration.
    pub plates: [S; 2],
    /// Whether something may collide at once: the rule has no force law, or a plane is hard.
    pub has_instantaneous: bool,
    /// Whether the rule has no force law for some pair of materials.
    pub is_rule_instantaneous: bool,
    /// Whether it has one for some.
    pub has_forces: bool,
}

impl<S: Scalar> Settings<S> {
    /// As a builder starts.
    pub fn new(enduring: Enduring) -> Self {
        Self {
            enduring,
            steps: S::from_f32(32.0),
            contact_time: None,
            gravity: S::zero(),
            smallest: [S::one(), S::one()],
            plates: [S::zero(); 2],
            has_instantaneous: true,
            is_rule_instantaneous: true,
            has_forces: false,
        }
    }

    /// Whether clusters are integrated. Where the rule says so once for all, the compiler knows.
    #[inline]
    pub fn is_integrated(&self, rule: &impl Rule<S>) -> bool {
        rule.enduring().unwrap_or(self.enduring) == Enduring::Integrated
    }

    /// The same with what follows from the rule, the planes and the grains.
    pub fn adopted<const D: usize, R: Rule<S>>(
        mut self,
        rule: &R,
        boundary: &Boundary<'_, S, D>,
        gravity: &Vector<S, D>,
        bodies: &[Body<S, D>],
    ) -> Self {
        self.enduring = rule.enduring().unwrap_or(self.enduring);
        if is_paper_alone(rule) {
            return self;
        }
        let mut fastest = S::zero();
        self.smallest = [S::NEVER; 2];
        for body in bodies.iter().filter(|body| !body.is_vacant()) {
            let [radius, mass] = self.smallest;
            self.smallest = [radius.min(body.radius), mass.min(body.mass)];
            let peculiar = body.velocity - boundary.flow_at(&body.position);
            fastest = fastest.max(norm(&peculiar));
        }
        self.plates = boundary.planes().iter().fold([S::zero(); 2], |[speed, most], plane| {
            let acceleration = plane.vibration().map_or(S::zero(), |v| v.peak_acceleration());
            [speed.max(plane.peak_speed()), most.max(acceleration)]
        });
        if let Some([speed, most]) = boundary.obstacles().map(Obstacles::peaks) {
            self.plates = [self.plates[0].max(speed), self.plates[1].max(most)];
        }
        let [speed, _] = self.plates;
        fastest = fastest.max(speed);
        let is_hard = |surface: Surface<S>| matches!(surface, Surface::Hard(_));
        self.is_rule_instantaneous = self.has_pair(rule, bodies, boundary, false);
        self.has_forces = self.has_pair(rule, bodies, boundary, true);
        self.has_instantaneous = self.is_rule_instantaneous || boundary.surfaces().any(is_hard);
        self.take_gravity(gravity, fastest);
        // Who meets somebody's image may do so as fast as that moves.
        self.plates[0] = self.plates[0].max(boundary.image_speed());
        self
    }

    /// The same with one grain more, which is among these bodies.
    pub fn with_grain<const D: usize, R: Rule<S>>(
        mut self,
        rule: &R,
        grain: &Body<S, D>,
        (bodies, boundary): (&[Body<S, D>], &Boundary<'_, S, D>),
    ) -> Self {
        if is_paper_alone(rule) {
            return self;
        }
        let [radius, mass] = self.smallest;
        self.smallest = [radius.min(grain.radius), mass.min(grain.mass)];
        self.is_rule_instantaneous |= self.has_pair(rule, bodies, boundary, false);
        self.has_instantaneous |= self.is_rule_instantaneous;
        self.has_forces |= self.has_pair(rule, bodies, boundary, true);
        self
    }

    /// Whether two of these grains, or one and a plane, may have a force law, or none. Of more than 16 materials some may.
    fn has_pair<const D: usize, R: Rule<S>>(
        &self,
        rule: &R,
        bodies: &[Body<S, D>],
        boundary: &Boundary<'_, S, D>,
        with_force: bool,
    ) -> bool {
        let mut materials = heapless::Vec::<u8, 16>::new();
        for body in bodies.iter().filter(|body| !body.is_vacant()) {
            if !materials.contains(&body.material) && materials.push(body.material).is_err() {
                return true;
            }
        }
        let surfaces = boundary.surfaces();
        let pairs = materials.iter().flat_map(|&a| {
            let with_surfaces = surfaces.clone().map(move |surface| surface.materials(a));
            materials.iter().map(move |&b| [a, b]).chain(with_surfaces)
        });
        let mut impacts = pairs.map(|materials| Impact { materials, ..self.small_pair(S::one()) });
        impacts.any(|impact| rule.force(&impact, S::zero()).is_some() == with_force)
    }

    /// How far grains must be seen: no cell is narrower.
    pub fn sight(&self) -> Sight {
        Sight { may_crowd: self.enduring == Enduring::Integrated && self.has_forces }
    }

    /// Takes over gravity; without it, if there never was one, a speed from which slow is a sixteenth.
    pub fn take_gravity<const D: usize>(&mut self, gravity: &Vector<S, D>, fastest: S) {
        let [_, shaken] = self.plates;
        let g = norm(gravity) + shaken;
        if g > S::zero() && g.in_range() && g.is_finite() {
            self.gravity = g;
        } else if !(self.gravity > S::zero()) {
            // Slow is (g R)^½/4.
            let [radius, _] = self.smallest;
            let speed = fastest * S::from_f32(0.25);
            let g = speed.times(speed).divided_by(radius);
            self.gravity = if g > S::zero() && g.is_finite() { g } else { S::RESOLUTION };
        }
    }

    /// Whether grains at rest under this gravity overlap by no more than a twentieth of their radius.
    pub fn check_contact_time<const D: usize>(&self, gravity: &Vector<S, D>) -> Result<(), Error> {
        let Some(time) = self.contact_time else { return Ok(()) };
        // x = g (t/π)².
        let weight = norm(gravity) + self.plates[1];
        let [t, g, radius] = [time, weight, self.smallest[0]].map(|x| x.to_f64());
        let shortest = t / core::f64::consts::PI;
        let overlap = g * shortest * shortest / radius;
        if overlap <= 0.05 {
            return Ok(());
        }
        let longest = core::f64::consts::PI * libm::sqrt(0.05 * radius / g);
        Err(Error::LongContact { contact_time: t, overlap, longest })
    }

    /// Whether contacts under a law of one's own push, and end.
    #[inline(always)]
    pub fn try_law(&self, rule: &impl Rule<S>) -> Result<(), Error> {
        if rule.remembers() { tried(rule, &self.small_pair(S::zero())) } else { Ok(()) }
    }

    /// Two of the smallest grains that meet at this speed.
    fn small_pair(&self, normal_speed: S) -> Impact<S> {
        let [radius, mass] = self.smallest;
        Impact {
            contact_distance: radius + radius,
            effective_radius: radius * S::half(),
            reduced_mass: mass * S::half(),
            normal_speed,
            tangential_speed: S::zero(),
            acceleration: S::zero(),
            materials: [0; 2],
        }
    }

    /// π over the stand-in's contact time: ω of its spring.
    pub fn frequency(&self, radius: S) -> S {
        let pi = S::from_f64(core::f64::consts::PI);
        match self.contact_time {
            Some(time) => pi / time,
            None => pi * S::from_f32(16.0) * self.gravity.sqrt_of_ratio(radius),
        }
    }

    /// The largest speed of approach that counts as slow: R/(64 t), with which the stand-in overlaps by
    /// 0.5 % of R; by default 4 g t.
    pub fn slow_speed(&self, radius: S) -> S {
        radius * self.frequency(radius) * S::from_f64(1.0 / (64.0 * core::f64::consts::PI))
    }

    /// Below this a clustered grain is slow enough to sleep: g t/128 by default, (g R)^½/2048.
    pub fn sleep_speed(&self, radius: S) -> S {
        self.slow_speed(radius) * S::from_f32(1.0 / 512.0)
    }

    /// For so long, ten contact times, it must have been so.
    pub fn sleep_time(&self, radius: S) -> S {
        S::from_f64(10.0 * core::f64::consts::PI) / self.frequency(radius)
    }

    /// Nobody counts as slower than this, (g R)^½/1024, where the length of a step is chosen: it must not be
    /// that of grains at rest, whose contact would last for ever, when they begin to fall.
    fn least_speed(&self) -> S {
        let [radius, _] = self.smallest;
        self.gravity.times(radius).sqrt() * S::from_f32(1.0 / 1024.0)
    }

    /// The step of clustered grains of which none is faster than `speed`, no pair deeper than `overlap`, and
    /// no stand-in's ω above `frequency`.
    pub fn step<R: Rule<S>>(&self, rule: &R, speed: S, (overlap, frequency): (S, S)) -> S {
        let speed = speed.max(self.plates[0]).max(self.least_speed());
        // A body pressed from all sides swings up to √3 times as fast as a pair does.
        let part = self.steps * S::from_f64(1.732_050_807_568_877_2);
        let soft = |speed| {
            rule.contact_time(&self.small_pair(speed + speed), overlap).map(|time| time / part)
        };
        let soft = match soft(speed) {
            // Gravity makes it faster within the step.
            Some(first) if self.gravity * first > speed => soft(self.gravity * first),
            first => first,
        };
        let stand_in =
            self.has_instantaneous && (self.gravity > S::zero() || self.contact_time.is_some());
        let hard = stand_in.then(|| {
            let frequency = self.frequency(self.smallest[0]).max(frequency);
            let (pi, product) = (S::from_f64(core::f64::consts::PI), frequency * self.steps);
            // A number of few digits may not hold the product: a step that never ends would follow.
            if product.is_finite() { pi / product } else { pi / self.steps / frequency }
        });
        let step = match (soft, hard) {
            (Some(soft), Some(hard)) => soft.min(hard),
            (soft, hard) => soft.or(hard).unwrap_or(S::one()),
        };
        step.max(S::RESOLUTION * S::from_f32(4.0))
    }
}

/// Whether worlds with this rule are in the papers' mode only: nothing of the other is needed then, and none of it compiled.
/// (Of rough grains it is asked whether there are forces.)
#[inline(always)]
fn is_paper_alone<S: Scalar>(rule: &impl Rule<S>) -> bool {
    rule.enduring() == Some(Enduring::Paper) && rule.inertia().is_none()
}
