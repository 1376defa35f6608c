//! Which grains hang together by contacts? Reads grains and contacts; writes clusters that join, part and take a first step.

use crate::collocation::Segment;
use crate::contact_law::{ContactLaw, End};
use crate::plate::Plate;
use crate::system::Grain;
use crate::vector::{Vector, length, minus};

/// The other side of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Side<const D: usize> {
    /// Member `local` of the cluster, seen at its position plus `shift` (a periodic image).
    Member {
        local: usize,
        #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
        shift: Vector<D>,
    },
    /// A wall across `axis`; `facing` +1 for the lower wall, −1 for the upper one.
    Wall { axis: usize, facing: f64, plate: Plate },
}

/// One contact under way.
///
/// Overlap x and overlap rate are unknowns of their own, next to the Cartesian ones they could be
/// had from: the difference of two coordinates would lose their digits. Where the dashpot rules
/// (c_dis > 1, exponents β = γ), w = x + θ ẋ takes the place of ẋ, for F_n = g w passes through zero
/// by a margin far below the round-off of ẋ.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Link<const D: usize> {
    pub first: usize,
    pub side: Side<D>,
    pub law: ContactLaw,
    pub overlap: f64,
    pub second: f64,
    pub by_force: bool,
    /// Which record of the run this is.
    pub record: usize,
}

impl<const D: usize> Link<D> {
    pub fn rate(&self) -> f64 {
        if self.by_force {
            return (self.second - self.overlap) / self.law.relaxation;
        }
        self.second
    }
}

/// The step under way.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Active {
    pub(super) segment: Segment,
    pub(super) regular: Option<usize>,
    /// In t, or in s.
    pub(super) length: f64,
    /// The step is used for 0 ≤ θ ≤ finish.
    pub(super) finish: f64,
    pub(super) ended: Option<usize>,
    /// Time at `finish`, since `origin`.
    pub(super) until: f64,
    /// A bound of each member's speed during the step.
    pub(super) speeds: Vec<f64>,
}

/// Grains that hang together by contacts.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Cluster<const D: usize> {
    pub grains: Vec<usize>,
    pub radii: Vec<f64>,
    pub masses: Vec<f64>,
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::arrays"))]
    pub positions: Vec<Vector<D>>,
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::arrays"))]
    pub velocities: Vec<Vector<D>>,
    pub links: Vec<Link<D>>,
    /// Absolute time of `elapsed` = 0.
    pub origin: f64,
    pub elapsed: f64,
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
    pub(super) gravity: Vector<D>,
    pub(super) end: End,
    /// The step before, if the motion goes on smoothly from it.
    pub(super) before: Option<Active>,
    pub(super) active: Option<Active>,
    /// Steps taken.
    pub steps: u64,
}

impl<const D: usize> Cluster<D> {
    pub fn local(&self, grain: usize) -> Option<usize> {
        self.grains.iter().position(|&g| g == grain)
    }

    /// A cluster of one grain, without a contact yet.
    pub fn single(id: usize, grain: &Grain<D>, time: f64, gravity: Vector<D>, end: End) -> Self {
        Self {
            grains: vec![id],
            radii: vec![grain.radius],
            masses: vec![grain.mass],
            positions: vec![grain.position],
            velocities: vec![grain.velocity],
            links: Vec::new(),
            origin: time,
            elapsed: 0.0,
            gravity,
            end,
            before: None,
            active: None,
            steps: 0,
        }
    }

    /// Takes in all of another cluster; both must stand at the same time, without a step ahead.
    pub fn join(&mut self, other: Self, time: f64) {
        let base = self.grains.len();
        self.grains.extend(other.grains);
        self.radii.extend(other.radii);
        self.masses.extend(other.masses);
        self.positions.extend(other.positions);
        self.velocities.extend(other.velocities);
        self.links.extend(other.links.into_iter().map(|mut link| {
            link.first += base;
            if let Side::Member { local, .. } = &mut link.side {
                *local += base;
            }
            link
        }));
        (self.origin, self.elapsed, self.before) = (time, 0.0, None);
        self.steps += other.steps;
    }

    /// Adds a contact that begins now.
    pub fn touch(
        &mut self,
        first: usize,
        side: Side<D>,
        law: ContactLaw,
        at: [f64; 2],
        record: usize,
    ) {
        let [overlap, rate] = at;
        let fastest = match rate > 0.0 {
            true => 1.0 / law.time_scale(rate),
            false => 0.0,
        };
        let fastest = fastest.max(law.frequency(overlap));
        let by_force = law.proportional() && law.relaxation * fastest > 1.0;
        let second = if by_force { overlap + law.relaxation * rate } else { rate };
        self.links.push(Link { first, side, law, overlap, second, by_force, record });
        self.before = None;
    }

    /// The parts that still hang together; grains without a contact come alone.
    pub fn parts(self) -> Vec<Self> {
        let group = self.groups();
        let count = group.iter().max().map_or(0, |g| g + 1);
        (0..count).map(|part| self.part(&group, part)).collect()
    }

    fn groups(&self) -> Vec<usize> {
        let n = self.grains.len();
        let mut group: Vec<usize> = (0..n).collect();
        for _ in 0..n {
            for link in &self.links {
                if let Side::Member { local, .. } = link.side {
                    let least = group[link.first].min(group[local]);
                    (group[link.first], group[local]) = (least, least);
                }
            }
        }
        let mut names: Vec<usize> = group.clone();
        names.sort_unstable();
        names.dedup();
        group.iter().map(|g| names.binary_search(g).unwrap_or(0)).collect()
    }

    fn part(&self, group: &[usize], part: usize) -> Self {
        let members: Vec<usize> = (0..group.len()).filter(|&a| group[a] == part).collect();
        let place = |a: usize| members.iter().position(|&m| m == a).unwrap_or(0);
        let links = self.links.iter().filter(|link| group[link.first] == part).map(|link| {
            let mut link = link.clone();
            link.first = place(link.first);
            if let Side::Member { local, .. } = &mut link.side {
                *local = place(*local);
            }
            link
        });
        Self {
            grains: members.iter().map(|&a| self.grains[a]).collect(),
            radii: members.iter().map(|&a| self.radii[a]).collect(),
            masses: members.iter().map(|&a| self.masses[a]).collect(),
            positions: members.iter().map(|&a| self.positions[a]).collect(),
            velocities: members.iter().map(|&a| self.velocities[a]).collect(),
            links: links.collect(),
            before: None,
            active: None,
            steps: 0,
            ..*self
        }
    }

    /// The link that most needs the roots of its law removed: among those, the one with least overlap.
    pub(super) fn regular(&self) -> Option<usize> {
        let able = |link: &&(usize, &Link<D>)| {
            let link = link.1;
            link.law.order() > 1 && (link.overlap > 0.0 || link.rate() > 0.0)
        };
        let all: Vec<(usize, &Link<D>)> = self.links.iter().enumerate().collect();
        let least =
            |a: &&(usize, &Link<D>), b: &&(usize, &Link<D>)| a.1.overlap.total_cmp(&b.1.overlap);
        all.iter().filter(able).min_by(least).map(|(c, _)| *c)
    }

    /// The step to try first after a contact has begun or ended, in t or in s.
    pub(super) fn first_step(&self, regular: Option<usize>) -> f64 {
        let span = self.links.iter().map(|l| self.span(l)).fold(f64::INFINITY, f64::min) / 6.0;
        let Some(m) = regular else { return span };
        let (x, u) = (self.links[m].overlap.max(0.0), self.links[m].rate().max(0.0));
        let (q, p) = (self.links[m].law.root(x), self.links[m].law.order());
        match u * span > 1e-3 * x {
            true => (libm::pow(x + u * span, 1.0 / f64::from(p)) - q) / u,
            false => span / (f64::from(p) * q.powi(p - 1)),
        }
    }

    fn span(&self, link: &Link<D>) -> f64 {
        let typical = link.law.speed_scale(link.overlap).max(link.rate().abs());
        link.law.contact_time(typical.max(1e-6 * self.slow()))
    }

    /// The speed of a fall through the largest radius: nothing slower than a small part of it
    /// matters where gravity acts.
    fn slow(&self) -> f64 {
        let largest = self.radii.iter().fold(0.0, |m: f64, r| m.max(*r));
        (length(&self.gravity) * largest).sqrt()
    }

    /// The largest relative speed over a contact, or the speed its overlap stands for.
    pub(super) fn speed_scale(&self) -> f64 {
        let of = |link: &Link<D>| {
            let v = match link.side {
                Side::Member { local, .. } => {
                    minus(&self.velocities[link.first], &self.velocities[local])
                }
                Side::Wall { .. } => self.velocities[link.first],
            };
            length(&v).max(0.1 * link.law.speed_scale(link.overlap))
        };
        self.links.iter().map(of).fold(1e-3 * self.slow(), f64::max).max(f64::MIN_POSITIVE)
    }
}
