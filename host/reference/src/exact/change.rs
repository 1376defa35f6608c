//! What changes when a contact begins or ends? Reads the run at that instant; writes its clusters, records and forecasts.

use super::flight::Shifts;
use super::run::{ContactRecord, Event, EventKind, Exact, Forecast, Partner, Target};
use crate::cluster::{Cluster, Link, Side};
use crate::contact_law::ContactLaw;
use crate::contact_law::End;
use crate::plate::Plate;
use crate::system::Boundary;
use crate::vector::{dot, length, minus};

impl<const D: usize> Exact<D> {
    /// Grains that overlap at the start.
    pub(super) fn begin_overlapping(&mut self) {
        for i in 0..self.grains.len() {
            for target in self.near(i) {
                let [x, u] = self.approach(i, target);
                let pushes = self.contact_law(i, target).push(x, u) > 0.0;
                if x > 0.0 && (pushes || self.end == End::Overlap) {
                    self.begin(i, target, true);
                }
            }
        }
    }

    /// Walls, and grains of higher number in any image, that grain i overlaps now.
    fn near(&self, i: usize) -> Vec<Target<D>> {
        let mut found = self.walls();
        for j in i + 1..self.grains.len() {
            let d = minus(&self.position(i), &self.position(j));
            let contact_distance = self.grains[i].radius + self.grains[j].radius;
            let images = Shifts::near(&d, contact_distance, self.periods());
            found.extend(images.map(|shift| Target::Grain { other: j, shift }));
        }
        found.retain(|target| self.approach(i, *target)[0] > 0.0);
        found
    }

    pub(super) fn walls(&self) -> Vec<Target<D>> {
        let sides = |axis: usize| {
            let sides: &[bool] = match self.boundary[axis] {
                Boundary::Walls { .. } => &[false, true],
                Boundary::Plate(_) => &[false],
                _ => &[],
            };
            sides.iter().map(move |&upper| Target::Wall { axis, upper })
        };
        (0..D).flat_map(sides).collect()
    }

    /// Overlap and its rate, now.
    pub(super) fn approach(&self, i: usize, target: Target<D>) -> [f64; 2] {
        self.approach_at(i, target, self.now)
    }

    pub(super) fn approach_at(&self, i: usize, target: Target<D>, time: f64) -> [f64; 2] {
        let (r, v) = self.state(i, time);
        match target {
            Target::Wall { axis, upper } => {
                let (facing, plate) = self.wall(axis, upper);
                let gap = facing * (r[axis] - plate.height(time));
                [self.grains[i].radius - gap, -facing * (v[axis] - plate.velocity(time))]
            }
            Target::Grain { other, shift } => {
                let (rj, vj) = self.state(other, time);
                let d = minus(&minus(&r, &rj), &shift);
                let contact_distance = self.grains[i].radius + self.grains[other].radius;
                let distance = length(&d);
                [contact_distance - distance, -dot(&d, &minus(&v, &vj)) / distance]
            }
        }
    }

    pub(super) fn contact_law(&self, i: usize, target: Target<D>) -> ContactLaw {
        let a = &self.grains[i];
        match target {
            Target::Wall { .. } => self.law.wall(a.radius, a.mass),
            Target::Grain { other, .. } => {
                let b = &self.grains[other];
                self.law.pair([a.radius, b.radius], [a.mass, b.mass])
            }
        }
    }

    /// Which way it faces, and where it is.
    pub(super) fn wall(&self, axis: usize, upper: bool) -> (f64, Plate) {
        match (self.boundary[axis], upper) {
            (Boundary::Walls { lo, .. }, false) => (1.0, Plate::fixed(lo)),
            (Boundary::Walls { hi, .. }, true) => (-1.0, Plate::fixed(hi)),
            (Boundary::Plate(plate), false) => (1.0, plate),
            _ => (1.0, Plate::fixed(f64::NEG_INFINITY)),
        }
    }

    /// The forecast of grain i has come true.
    pub(super) fn collide(&mut self, i: usize) -> Option<Event> {
        match self.forecasts[i].target {
            Some(target) => {
                let overlapped = self.approach(i, target)[0] > 1e-9 * self.grains[i].radius;
                Some(self.begin(i, target, overlapped))
            }
            None => {
                // Others may have foreseen a contact with this image.
                self.halt(i);
                self.foresee(i);
                None
            }
        }
    }

    /// Begins a contact now, with the overlap there is or with none.
    pub(super) fn begin(&mut self, i: usize, target: Target<D>, overlapped: bool) -> Event {
        let [x, u] = self.approach(i, target);
        let law = self.contact_law(i, target);
        let partner = match target {
            Target::Grain { other, .. } => Partner::Grain(other),
            Target::Wall { axis, upper } => Partner::Wall { axis, upper },
        };
        let home = self.gather(i, target);
        let record = self.record(i, partner);
        let cluster = &mut self.clusters[home];
        let first = cluster.local(i).unwrap_or(0);
        let side = match target {
            Target::Grain { other, shift } => {
                Side::Member { local: cluster.local(other).unwrap_or(0), shift }
            }
            Target::Wall { axis, upper } => {
                let (facing, plate) = self.wall(axis, upper);
                Side::Wall { axis, facing, plate }
            }
        };
        let at = [if overlapped { x } else { 0.0 }, u];
        self.clusters[home].touch(first, side, law, at, record);
        self.note_three(home, i, partner);
        Event { time: self.now, kind: EventKind::Begin, record }
    }

    fn record(&mut self, i: usize, partner: Partner) -> usize {
        let (grain, partner) = match partner {
            Partner::Grain(j) => (i.min(j), Partner::Grain(i.max(j))),
            wall => (i, wall),
        };
        self.records.push(ContactRecord { grain, partner, begin: self.now, end: None });
        self.records.len() - 1
    }

    fn note_three(&mut self, home: usize, i: usize, partner: Partner) {
        let links = &self.clusters[home].links;
        let touches = |grain: usize| {
            let local = self.clusters[home].local(grain);
            let of = |link: &&Link<D>| {
                Some(link.first) == local
                    || matches!(link.side, Side::Member { local: l, .. } if Some(l) == local)
            };
            links.iter().filter(of).count()
        };
        let other = if let Partner::Grain(j) = partner { touches(j) } else { 0 };
        if self.three.is_none() && (touches(i) > 1 || other > 1) {
            self.three = Some(self.now);
        }
    }

    /// One cluster, standing at now, that holds grain i and the target.
    fn gather(&mut self, i: usize, target: Target<D>) -> usize {
        let home = self.cluster_of(i);
        let Target::Grain { other, .. } = target else { return home };
        let guest = self.cluster_of(other);
        if guest == home {
            return home;
        }
        let joining = self.take(guest);
        let home = self.owner[i].unwrap_or(0);
        self.clusters[home].join(joining, self.now);
        self.own(home);
        home
    }

    /// The cluster of a grain, stopped now; a new one if it flies freely.
    fn cluster_of(&mut self, i: usize) -> usize {
        if let Some(k) = self.owner[i] {
            self.clusters[k].stop_at(self.now);
            return k;
        }
        // Not into the box: the target's image was chosen for where the grain is.
        self.halt(i);
        let cluster = Cluster::single(i, &self.grains[i], self.now, self.gravity, self.end);
        self.clusters.push(cluster);
        self.own(self.clusters.len() - 1);
        self.forecasts[i] = Forecast::NEVER;
        let about =
            |f: &Forecast<D>| matches!(f.target, Some(Target::Grain { other, .. }) if other == i);
        let stale: Vec<usize> =
            (0..self.grains.len()).filter(|&j| about(&self.forecasts[j])).collect();
        stale.into_iter().for_each(|j| self.foresee(j));
        self.clusters.len() - 1
    }

    /// Brings a free grain's state to now, into the periodic box.
    fn rest(&mut self, i: usize) {
        self.halt(i);
        for (p, bound) in self.grains[i].position.iter_mut().zip(&self.boundary) {
            if let Boundary::Periodic { lo, hi } = *bound {
                *p -= (hi - lo) * ((*p - lo) / (hi - lo)).floor();
            }
        }
    }

    /// Brings a free grain's state to now, in the image in which it is.
    fn halt(&mut self, i: usize) {
        (self.grains[i].position, self.grains[i].velocity) = self.state(i, self.now);
        self.since[i] = self.now;
    }

    fn take(&mut self, k: usize) -> Cluster<D> {
        let cluster = self.clusters.swap_remove(k);
        if k < self.clusters.len() {
            self.own(k);
        }
        cluster
    }

    fn own(&mut self, k: usize) {
        for &grain in &self.clusters[k].grains {
            self.owner[grain] = Some(k);
        }
    }

    /// A cluster's step is over; its contact may be.
    pub(super) fn finish_step(&mut self, k: usize) -> Option<Event> {
        let link = self.clusters[k].finish()?;
        let mut cluster = self.take(k);
        let record = cluster.links.remove(link).record;
        self.records[record].end = Some(self.now);
        self.steps += cluster.steps;
        let mut freed = Vec::new();
        for part in cluster.parts() {
            if part.links.is_empty() {
                freed.push(self.release(&part));
            } else {
                self.clusters.push(part);
                self.own(self.clusters.len() - 1);
            }
        }
        freed.into_iter().for_each(|i| self.foresee(i));
        Some(Event { time: self.now, kind: EventKind::End, record })
    }

    fn release(&mut self, part: &Cluster<D>) -> usize {
        let i = part.grains[0];
        self.owner[i] = None;
        self.grains[i].position = part.positions[0];
        self.grains[i].velocity = part.velocities[0];
        self.since[i] = self.now;
        self.rest(i);
        i
    }
}
