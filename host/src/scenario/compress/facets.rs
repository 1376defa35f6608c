//! When does a grain that grows touch an obstacle, and what then? Reads facets; writes the grain's velocity and next event.

use super::super::clear::Obstacles;
use super::super::nearest::{Point, apart, dot};
use super::state::{Next, Run};

/// Steps of a search; each at least halves what is left.
const STEPS: usize = 64;

/// So near, in radii, a grain touches.
const NEAR: f64 = 1e-13;

impl Run {
    /// Lists the facets that a grain of this radius can touch from each cell.
    pub(super) fn list_facets(&mut self, obstacles: &Obstacles, radius: f64) {
        if obstacles.are_none() {
            return;
        }
        self.facets = obstacles.facets().map(<[Point]>::to_vec).collect();
        let [nx, ny, nz] = self.counts;
        for number in 0..nx * ny * nz {
            let cell = [number % nx, number / nx % ny, number / nx / ny];
            let end = |axis: usize, by: usize| {
                let width = self.region.length(axis) / self.counts[axis] as f64;
                self.region.axes[axis][0] + width * (cell[axis] + by) as f64
            };
            let low = std::array::from_fn(|axis| end(axis, 0) - radius);
            let high = std::array::from_fn(|axis| end(axis, 1) + radius);
            self.facets_near.push(obstacles.within(low, high).collect());
        }
    }

    /// The facets near the cell of a grain.
    pub(super) fn look_at_facets(&self, i: usize, here: &Point, best: &mut (f64, Next)) {
        let Some(near) = self.facets_near.get(self.number(self.bodies[i].cell)) else { return };
        for &facet in near {
            if let Some(after) = self.touching(i, here, facet, best.0) {
                *best = (after, Next::Facet(facet));
            }
        }
    }

    /// After which time before `end` a grain touches a facet.
    ///
    /// The gap is a convex function of time, so Newton's method comes to its first root from the left, and never
    /// beyond it.
    fn touching(&self, i: usize, here: &Point, facet: usize, end: f64) -> Option<f64> {
        let body = &self.bodies[i];
        let (radius, growth) = (self.radius(i), self.rate * body.growing);
        let mut after = 0.0;
        for _ in 0..STEPS {
            let place = std::array::from_fn(|k| here[k] + body.velocity[k] * after);
            let way = apart(&self.facets[facet], &place);
            let distance = dot(&way, &way).sqrt();
            let closing = growth - dot(&way, &body.velocity) / distance;
            if !(closing > 0.0 && after < end) {
                return None;
            }
            let gap = distance - radius - growth * after;
            if gap <= NEAR * radius {
                break;
            }
            after += gap / closing;
        }
        (after < end).then_some(after)
    }

    /// It comes off along the way from the nearest point, faster than it grows.
    pub(super) fn touch_facet(&mut self, i: usize, facet: usize) {
        self.advance(i);
        let growth = self.rate * self.bodies[i].growing;
        let way = apart(&self.facets[facet], &self.bodies[i].position);
        let normal = way.map(|x| x / dot(&way, &way).sqrt());
        let velocity = &mut self.bodies[i].velocity;
        let gained = 2.0 * (growth - dot(velocity, &normal)).max(0.0);
        for (v, n) in velocity.iter_mut().zip(normal) {
            *v += gained * n;
        }
        self.collisions += 1;
        self.bodies[i].changes += 1;
        self.predict(i);
    }
}
