//! What are Newton's equations of grains in contact? Reads all unknowns; writes their rates and scales.

use super::members::{Cluster, Link, Side};
use crate::collocation::{Scale, Segment};
use crate::contact_law::End;
use crate::vector::{Vector, dot, length, minus, plus};

/// The equations of one cluster.
///
/// Unknowns: time; position and velocity of each member; overlap and second unknown of each link.
/// If link m is `regular`, the overlap's place is taken by q with x_m = q^p (p = 2 for viscoelastic
/// grains), and the independent variable is s with dt = p q^{p−1} ds: then dq/ds = ẋ, and the roots
/// of x in the law are gone from the beginning (q = 0) and the end (q = 0 again) of that contact.
pub(super) struct Motion<'a, const D: usize> {
    pub masses: &'a [f64],
    pub links: &'a [Link<D>],
    pub gravity: &'a Vector<D>,
    /// Absolute time of the first unknown's 0.
    pub origin: f64,
    pub regular: Option<usize>,
}

/// One link, taken apart.
struct View<const D: usize> {
    rate: f64,
    force: f64,
    /// L94 Eq. (4), on the first grain.
    rub: Vector<D>,
    /// From the partner to the first grain.
    normal: Vector<D>,
    /// v_t²/r: how fast the distance's rate grows without any force.
    bend: f64,
}

pub(super) fn links_from<const D: usize>(members: usize) -> usize {
    1 + 2 * D * members
}

pub(super) fn position<const D: usize>(y: &[f64], a: usize) -> Vector<D> {
    std::array::from_fn(|k| y[1 + 2 * D * a + k])
}

pub(super) fn velocity<const D: usize>(y: &[f64], a: usize) -> Vector<D> {
    std::array::from_fn(|k| y[1 + 2 * D * a + D + k])
}

impl<const D: usize> Motion<'_, D> {
    fn base(&self) -> usize {
        links_from::<D>(self.masses.len())
    }

    /// Overlap, its root q, its rate, and w = x^s + θ ẋ.
    fn compressed(&self, y: &[f64], c: usize) -> [f64; 4] {
        let (raw, second) = (y[self.base() + 2 * c], y[self.base() + 2 * c + 1]);
        let law = &self.links[c].law;
        let (x, root) = match self.regular {
            Some(m) if m == c => (raw.powi(law.order()), raw),
            _ => (raw, law.root(raw)),
        };
        let theta = law.relaxation;
        match self.links[c].by_force {
            true => [x, root, (second - x) / theta, second],
            false => [x, root, second, law.spring(x, root) + theta * second],
        }
    }

    fn view(&self, y: &[f64], c: usize) -> View<D> {
        let link = &self.links[c];
        let [_, root, rate, w] = self.compressed(y, c);
        let force = link.law.gain(root) * w;
        match link.side {
            Side::Wall { axis, facing, .. } => {
                let mut normal = [0.0; D];
                normal[axis] = facing;
                let mut rub = velocity(y, link.first).map(|v| -link.law.tangential * v);
                rub[axis] = 0.0;
                View { rate, force, rub, normal, bend: 0.0 }
            }
            Side::Member { local, shift } => {
                let apart = minus(&position(y, link.first), &position(y, local));
                let apart = minus(&apart, &shift);
                let distance = length(&apart);
                let normal = apart.map(|r| r / distance);
                let v = minus(&velocity(y, link.first), &velocity(y, local));
                let tangential = plus(&v, -dot(&v, &normal), &normal);
                let rub = tangential.map(|v| -link.law.tangential * v);
                let bend = dot(&tangential, &tangential) / distance;
                View { rate, force, rub, normal, bend }
            }
        }
    }

    /// d/dt, or d/ds, of all unknowns.
    pub fn slopes(&self, y: &[f64], f: &mut [f64]) {
        let time_scale = self.regular.map_or(1.0, |m| {
            let p = self.links[m].law.order();
            f64::from(p) * y[self.base() + 2 * m].powi(p - 1)
        });
        f.fill(0.0);
        f[0] = time_scale;
        for c in 0..self.links.len() {
            self.push(&self.view(y, c), c, f);
        }
        for c in 0..self.links.len() {
            self.compress(y, c, time_scale, f);
        }
        for a in 0..self.masses.len() {
            let at = 1 + 2 * D * a;
            for k in 0..D {
                f[at + k] = time_scale * y[at + D + k];
                f[at + D + k] = time_scale * (f[at + D + k] + self.gravity[k]);
            }
        }
    }

    /// Adds a link's force to its members' accelerations (without gravity).
    fn push(&self, view: &View<D>, c: usize, f: &mut [f64]) {
        let link = &self.links[c];
        let rubbing = link.law.tangential != 0.0;
        let mut add = |a: usize, sign: f64| {
            let (at, per_mass) = (1 + 2 * D * a + D, sign / self.masses[a]);
            (0..D).for_each(|k| f[at + k] += per_mass * view.force * view.normal[k]);
            if rubbing {
                (0..D).for_each(|k| f[at + k] += per_mass * view.rub[k]);
            }
        };
        add(link.first, 1.0);
        if let Side::Member { local, .. } = link.side {
            add(local, -1.0);
        }
    }

    /// The rates of a link's own unknowns, once all accelerations are there.
    fn compress(&self, y: &[f64], c: usize, time_scale: f64, f: &mut [f64]) {
        let (link, view) = (&self.links[c], self.view(y, c));
        let toward = match link.side {
            Side::Member { local, .. } => minus(&velocity(f, link.first), &velocity(f, local)),
            Side::Wall { axis, plate, .. } => {
                let mut toward = plus(&velocity(f, link.first), 1.0, self.gravity);
                toward[axis] -= plate.acceleration(self.origin + y[0]);
                toward
            }
        };
        let growth = -dot(&view.normal, &toward) - view.bend;
        let at = self.base() + 2 * c;
        f[at] = if self.regular == Some(c) { view.rate } else { time_scale * view.rate };
        f[at + 1] = time_scale
            * match link.by_force {
                true => view.rate + link.law.relaxation * growth,
                false => growth,
            };
    }

    /// Positive while contact c lasts: w (MP13) or x (L94).
    pub fn margin(&self, segment: &Segment, theta: f64, c: usize, end: End) -> f64 {
        let at = self.base() + 2 * c;
        let link = &self.links[c];
        let raw = segment.one(theta, at);
        if end == End::Overlap || link.law.relaxation == 0.0 {
            return raw;
        }
        let second = segment.one(theta, at + 1);
        if link.by_force {
            return second;
        }
        let x = if self.regular == Some(c) { raw.powi(link.law.order()) } else { raw };
        link.law.push(x, second)
    }

    /// Whether every overlap follows from the distance of the centres: not so once two centres have coincided.
    pub fn agrees(&self, y: &[f64], radii: &[f64]) -> bool {
        (0..self.links.len()).all(|c| {
            let link = &self.links[c];
            let at = position::<D>(y, link.first);
            let (contact_distance, gap) = match link.side {
                Side::Wall { axis, facing, plate } => {
                    let wall = plate.height(self.origin + y[0]);
                    (radii[link.first], facing * (at[axis] - wall))
                }
                Side::Member { local, shift } => {
                    let apart = minus(&minus(&at, &position(y, local)), &shift);
                    (radii[link.first] + radii[local], length(&apart))
                }
            };
            (self.compressed(y, c)[0] - (contact_distance - gap)).abs() < 1e-6 * contact_distance
        })
    }

    pub fn pack(&self, cluster: &Cluster<D>) -> Vec<f64> {
        let mut y = vec![cluster.elapsed];
        for (r, v) in cluster.positions.iter().zip(&cluster.velocities) {
            y.extend(r.iter().chain(v));
        }
        for (c, link) in cluster.links.iter().enumerate() {
            let x = link.overlap;
            y.push(if self.regular == Some(c) { link.law.root(x) } else { x });
            y.push(link.second);
        }
        y
    }

    /// Positions count against the radius, velocities against the fastest contact, the links'
    /// unknowns against themselves.
    pub fn scales(&self, cluster: &Cluster<D>) -> Vec<Scale> {
        let speed = cluster.speed_scale();
        let mut scales = vec![Scale::Largest(0.0)];
        for radius in &cluster.radii {
            scales.extend([Scale::Fixed(*radius); D]);
            scales.extend([Scale::Fixed(speed); D]);
        }
        for link in &cluster.links {
            let floor = match link.by_force {
                true => 0.0,
                false => 0.1 * link.law.speed_scale(link.overlap),
            };
            scales.extend([Scale::Largest(0.0), Scale::Largest(floor)]);
        }
        scales
    }
}
