//! What happens to a clustered grain before its step ends? Reads bodies near it; writes nothing, returns its earliest collision.
//!
//! It may touch a free grain, which is clustered then, or, where the rule or a plane has no force, collide at
//! once. In between steps everybody flies freely.

use super::contact::PRESSED;
use super::forces::MAX_COLLISIONS;
use super::members::Clusters;
use super::settings::Settings;
use crate::detect::{
    EventKind, ScheduledEvent, closing_speed, facet_collision, pair_collision, plane_collision,
};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, WideProduct, dot, norm};
use crate::space::{Domain, Obstacles, Particles, Plane, Surface, flight};

/// The earliest collision of a clustered grain up to the end of its step.
pub(crate) fn next_event<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    (clusters, settings): (&Clusters<S>, &Settings<S>),
    now: S,
    grain: usize,
) -> ScheduledEvent<S> {
    let Some(me) = particles.body(grain) else { return ScheduledEvent::NONE };
    let everyone = clusters.count as usize + particles.supported >= particles.bodies.len();
    if everyone && !settings.has_instantaneous {
        return ScheduledEvent::NONE;
    }
    let fast = norm(&me.velocity) + clusters.speed + domain.boundary.image_speed();
    let mut watch = Watch {
        particles,
        domain,
        settings,
        now,
        limit: clusters.due(),
        grain,
        me,
        here: flight::free(me, domain, now),
        fast,
        first: ScheduledEvent::NONE,
    };
    let may_collide =
        settings.is_rule_instantaneous && fast > settings.slow_speed(settings.smallest[0]);
    if !everyone || may_collide {
        particles.cells.for_each_near(me.cell, me.radius, |k| watch.pair(k, may_collide));
    }
    if settings.has_instantaneous {
        watch.planes();
        watch.obstacles();
    }
    watch.first
}

struct Watch<'a, S: Scalar, const D: usize> {
    particles: &'a Particles<'a, S, D>,
    domain: &'a Domain<'a, S, D>,
    settings: &'a Settings<S>,
    now: S,
    limit: S,
    grain: usize,
    me: &'a Body<S, D>,
    /// Where it is now and how it flies until the step ends.
    here: (Vector<S, D>, Vector<S, D>),
    /// A bound on the speed at which it nears another clustered grain.
    fast: S,
    first: ScheduledEvent<S>,
}

impl<S: Scalar, const D: usize> Watch<'_, S, D> {
    fn pair(&mut self, k: usize, may_collide: bool) {
        let Some(other) = self.particles.body(k).filter(|_| k != self.grain) else { return };
        let is_free = !other.is_clustered() && !other.is_asleep();
        if is_free && !self.may_reach(other) {
            return;
        }
        let tired = self.me.consecutive_collisions >= MAX_COLLISIONS
            || other.is_clustered() && other.consecutive_collisions >= MAX_COLLISIONS;
        if !is_free && (!may_collide || tired || !self.may_meet(other)) {
            return;
        }
        let time = pair_collision(self.particles, self.domain, self.now, [self.grain, k]);
        let Some(time) = time.map(|time| time.max(self.now)).filter(|&time| time <= self.limit)
        else {
            return;
        };
        let with = Partner::grain(k);
        let slow = self.settings.slow_speed(self.me.radius.min(other.radius));
        let speed = closing_speed(self.particles, self.domain, (self.grain, with), time);
        if is_free || speed > slow {
            self.keep(time, with, other.event_count, speed);
        }
    }

    /// Whether a free grain may be touched before the step ends: a bound without roots. Both fly freely until then.
    fn may_reach(&self, other: &Body<S, D>) -> bool {
        let ((x, v), (y, w)) = (&self.here, flight::free(other, self.domain, self.now));
        let [apart, velocity] = self.domain.boundary.relative([x - y, v - w], self.now);
        // Rounding is the root's affair. Negated so that what does not fit is asked there, too.
        let slack = S::one() + S::from_f32(1.0 / 64.0);
        let way = norm(&velocity) * (self.limit - self.now);
        let reach = (self.me.radius + other.radius + way) * slack;
        !(S::dot(&apart, &apart) > reach.times(reach))
    }

    /// Whether two clustered grains may touch fast before the step ends: a bound without roots.
    fn may_meet(&self, other: &Body<S, D>) -> bool {
        if self.me.clock != other.clock {
            return true;
        }
        let [apart, velocity] = self.domain.relative(self.me, other, self.me.clock);
        let slow = self.settings.slow_speed(self.me.radius.min(other.radius));
        let reach = self.me.radius + other.radius + self.fast * (self.limit - self.me.clock);
        let touching = self.me.radius + other.radius;
        let pressed = touching - self.me.radius.min(other.radius) * S::from_f32(PRESSED);
        S::dot(&apart, &apart) >= pressed.times(pressed)
            && S::dot(&velocity, &velocity) > slow.times(slow)
            && S::dot(&apart, &velocity).rounded() < S::zero()
            && S::dot(&apart, &apart) <= reach.times(reach)
    }

    /// Whether a grain may touch a plane fast before the step ends: a bound without roots.
    fn may_meet_plane(&self, plane: &Plane<S, D>, slow: S) -> bool {
        let span = self.limit - self.me.clock;
        let fall = norm(self.domain.gravity()) * span;
        let fastest = plane.peak_speed() + fall - dot(&plane.normal, &self.me.velocity);
        let gap = plane.gap(&self.me.position, self.me.radius, self.me.clock);
        let least = match plane.vibration() {
            Some(v) => plane.mean_gap(&self.me.position, self.me.radius) - v.swing().abs(),
            None => gap,
        };
        let pressed = self.me.radius * S::from_f32(-PRESSED);
        fastest > slow && least <= fastest * span && gap >= pressed
    }

    fn planes(&mut self) {
        let slow = self.settings.slow_speed(self.me.radius);
        if self.me.consecutive_collisions >= MAX_COLLISIONS {
            return;
        }
        for (p, plane) in self.domain.boundary.planes().iter().enumerate() {
            if !(matches!(plane.surface, Surface::Hard(_)) || self.settings.is_rule_instantaneous) {
                continue;
            }
            if !self.may_meet_plane(plane, slow) {
                continue;
            }
            let time = plane_collision(self.domain, self.now, self.me, (plane, self.limit));
            let Some(time) = time.filter(|&time| time <= self.limit) else { continue };
            let with = Partner::plane(p);
            let speed = closing_speed(self.particles, self.domain, (self.grain, with), time);
            if speed > slow {
                self.keep(time, with, 0, speed);
            }
        }
    }

    #[inline(always)]
    fn obstacles(&mut self) {
        if let Some(obstacles) = self.domain.boundary.obstacles() {
            self.facets(obstacles);
        }
    }

    /// In a step a grain goes nowhere near as far as the lists see.
    #[inline(never)]
    fn facets(&mut self, obstacles: &Obstacles<'_, S, D>) {
        let slow = self.settings.slow_speed(self.me.radius);
        if self.me.consecutive_collisions >= MAX_COLLISIONS {
            return;
        }
        let clock = self.me.clock;
        for k in obstacles.near(&self.me.position, clock) {
            let plane = self.domain.boundary.facet_plane(k, &self.me.position, clock);
            let may = plane.is_some_and(|plane| {
                let collides =
                    plane.surface.restitution().is_some() || self.settings.is_rule_instantaneous;
                // What moves may become faster in the step.
                collides && (plane.moves() || self.may_meet_plane(&plane, slow))
            });
            if !may {
                continue;
            }
            let time = facet_collision(self.domain, self.now, self.me, (k, self.limit));
            let Some(time) = time.filter(|&time| time <= self.limit) else { continue };
            let (there, with) = (flight::free(self.me, self.domain, time).0, Partner::facet(k));
            // Where another facet has what it shares with it, that one is met.
            let is_met = obstacles.touched(&there, (k, S::NEVER), time).is_some();
            let speed = closing_speed(self.particles, self.domain, (self.grain, with), time);
            if is_met && speed > slow {
                self.keep(time, with, 0, speed);
            }
        }
    }

    /// Keeps the earlier, of equals the faster, of equals that with the lower number.
    fn keep(&mut self, time: S, partner: Partner, partner_event_count: u32, speed: S) {
        let first = &self.first;
        let sooner = time < first.collision_time
            || time == first.collision_time && {
                let old =
                    closing_speed(self.particles, self.domain, (self.grain, first.partner), time);
                speed > old || speed == old && partner.word() < first.partner.word()
            };
        if sooner {
            self.first = ScheduledEvent {
                time,
                collision_time: time,
                partner,
                partner_event_count,
                kind: EventKind::Collision,
                face: ScheduledEvent::<S>::NO_FACE,
            };
        }
    }
}
