//! What have contacts given so far? Reads one transfer after the other; writes sums, as they are numbered.

use super::layout::{Contact, Layout, Wall};
use super::obstacles::Struck;
use carom::nalgebra::SVector;
use carom::world::Transfer;

/// Sums over contacts, whoever tells of them.
#[derive(Clone, Debug)]
pub struct Given {
    layout: Layout,
    sums: Vec<f64>,
    /// Where the sums of the first pair of species and those of the first wall begin.
    contacts: usize,
    walls: usize,
}

impl Given {
    /// Nothing has been given.
    pub fn new(layout: &Layout) -> Self {
        Self {
            layout: layout.clone(),
            sums: vec![0.0; layout.tally_width()],
            contacts: layout.contact(0, Contact::Count),
            walls: layout.wall(0, Wall::Count),
        }
    }

    /// The sums so far.
    pub fn sums(&self) -> &[f64] {
        &self.sums
    }

    /// Goes on from these sums.
    pub fn set(&mut self, sums: &[f64]) {
        self.sums.clear();
        self.sums.extend_from_slice(sums);
    }

    /// Since when there are sums (s).
    pub fn since(&self) -> f64 {
        self.sums[Layout::TIME]
    }

    /// The sums since the last call; the next are from now on.
    pub fn take(&mut self, now: f64) -> Vec<f64> {
        let mut next = vec![0.0; self.sums.len()];
        next[Layout::TIME] = now;
        std::mem::replace(&mut self.sums, next)
    }

    /// What contacts gave is not known.
    pub fn forget(&mut self) {
        self.sums.iter_mut().skip(1).for_each(|sum| *sum = f64::NAN);
    }

    /// The plane that bounds an axis, by its number.
    pub fn plane(&self, axis: usize, upper: bool) -> usize {
        self.layout.planes_before(axis) + usize::from(upper)
    }

    /// What two gave each other within a part of their contact; how long that was, if it is known.
    pub fn add<const D: usize>(&mut self, contact: &Transfer<f64, D>, duration: f64) {
        let Transfer { grain, partner, ref impulse, ref separation, work, approach, .. } = *contact;
        let began = f64::from(u8::from(approach.is_some()));
        if let Some(with) = partner.as_grain() {
            self.transfer(separation, impulse);
            let unknown = if approach.is_some() { f64::NAN } else { 0.0 };
            let more = [began, began, work, approach.unwrap_or(0.0), unknown, duration];
            self.contacts_of(grain, with).iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
        } else if let Some(plane) = partner.as_plane() {
            let push = separation.dot(impulse) / separation.norm_squared().sqrt();
            self.push(plane, [began, push, work]);
        } else if let Some(facet) = partner.as_facet() {
            let at = contact.position - separation;
            self.strike(facet, [began, work], impulse, (&at, [0.0; 3]));
        }
    }

    /// The obstacle that has a facet was met so often, took so much energy, and gave a grain this impulse at a point, and
    /// this angular momentum about the grain's centre if the point is that.
    pub fn strike<const D: usize>(
        &mut self,
        facet: usize,
        count_and_loss: [f64; 2],
        impulse: &SVector<f64, D>,
        at: (&SVector<f64, D>, [f64; 3]),
    ) {
        let Some(&number) = self.layout.facets.get(facet) else { return };
        let Some(obstacle) = self.layout.obstacles.get(number) else { return };
        let more = obstacle.given(count_and_loss, impulse, at);
        let place = self.layout.obstacle(number, Struck::Count);
        let sums = self.sums.get_mut(place..place + Struck::COUNT).unwrap_or_default();
        sums.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }

    /// A plane was met so often, was pushed by so much, and took so much energy.
    #[inline]
    pub fn push(&mut self, plane: usize, more: [f64; Wall::COUNT]) {
        let at = self.walls + Wall::COUNT * plane;
        let sums = self.sums.get_mut(at..at + Wall::COUNT).unwrap_or_default();
        sums.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }

    /// The sums over contacts of two grains.
    #[inline]
    pub fn contacts_of(&mut self, a: usize, b: usize) -> &mut [f64] {
        let species = |k: usize| self.layout.species.get(k).copied().map_or(0, usize::from);
        let at = self.contacts + Contact::COUNT * self.layout.pair(species(a), species(b));
        self.sums.get_mut(at..at + Contact::COUNT).unwrap_or_default()
    }

    /// Momentum that a grain was given by another one at this separation, or half of what both were.
    #[inline]
    pub fn transfer<const D: usize>(
        &mut self,
        separation: &SVector<f64, D>,
        change: &SVector<f64, D>,
    ) {
        let Some(virial) = self.sums.get_mut(1..1 + D * D) else { return };
        for (row, r) in virial.chunks_exact_mut(D).zip(separation.iter()) {
            row.iter_mut().zip(change.iter()).for_each(|(sum, p)| *sum += r * p);
        }
    }
}
