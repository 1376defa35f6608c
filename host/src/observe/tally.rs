//! What do contacts transfer and cost? Reads every event of a world, just before and just after; writes sums.

use super::layout::{Contact, Layout, Wall};
use carom::law::Outcome;
use carom::nalgebra::SVector;
use carom::particle::Partner;
use carom::world::{Event, EventKind, EventOutcome, Relative};
use carom::{Observer, View};

/// Sums over the contacts of a world.
///
/// The momentum that a contact of some duration transfers is counted where velocities change, at its
/// beginning and its end; with velocities as the world shows them in between, of which the stress of
/// motion is made, the two give the whole stress exactly. What clustered grains do to each other is not
/// seen here.
#[derive(Clone, Debug)]
pub struct Tally<const D: usize> {
    layout: Layout,
    sums: Vec<f64>,
    /// Where the sums of the first pair of species and those of the first wall begin.
    contacts: usize,
    walls: usize,
    /// What is about to happen.
    touch: Option<Touch<D>>,
    /// Contacts under way that an event may end.
    ending: Vec<Ending<D>>,
}

type Vector<const D: usize> = SVector<f64, D>;

/// Two that are about to touch.
#[derive(Clone, Copy, Debug)]
enum Touch<const D: usize> {
    Grains { a: usize, b: usize, before: Relative<f64, D> },
    Plane(Grounded<D>),
}

/// A grain at a plane, before they know of each other.
#[derive(Clone, Copy, Debug)]
struct Grounded<const D: usize> {
    grain: usize,
    plane: usize,
    mass: f64,
    velocity: Vector<D>,
}

/// A grain whose contact may end.
#[derive(Clone, Copy, Debug)]
enum Ending<const D: usize> {
    /// With another, which is released for itself or with it.
    Grain {
        grain: usize,
        with: usize,
        mass: f64,
        velocity: Vector<D>,
        separation: Vector<D>,
    },
    Plane(Grounded<D>),
}

impl<const D: usize> Tally<D> {
    /// Nothing has happened.
    pub fn new(layout: &Layout) -> Self {
        Self {
            layout: layout.clone(),
            sums: vec![0.0; layout.tally_width()],
            contacts: layout.contact(0, Contact::Count),
            walls: layout.wall(0, Wall::Count),
            touch: None,
            ending: Vec::with_capacity(4),
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

    /// The sums since the last call.
    pub fn take(&mut self) -> Vec<f64> {
        let width = self.sums.len();
        std::mem::replace(&mut self.sums, vec![0.0; width])
    }

    /// Grains moved in a cluster, whose forces are not seen: what contacts gave meanwhile is not known.
    #[cold]
    fn withhold(&mut self) {
        self.sums.iter_mut().skip(1).for_each(|sum| *sum = f64::NAN);
    }

    /// The sums over contacts of two grains.
    #[inline]
    fn contacts_of(&mut self, a: usize, b: usize) -> &mut [f64] {
        let species = |k: usize| self.layout.species.get(k).copied().map_or(0, usize::from);
        let at = self.contacts + Contact::COUNT * self.layout.pair(species(a), species(b));
        self.sums.get_mut(at..at + Contact::COUNT).unwrap_or_default()
    }

    /// The sums over contacts with a plane.
    fn wall(&mut self, plane: usize) -> &mut [f64] {
        let at = self.walls + Wall::COUNT * plane;
        self.sums.get_mut(at..at + Wall::COUNT).unwrap_or_default()
    }

    /// Momentum that a grain was given by another one at this separation, or half of what both were.
    #[inline]
    fn transfer(&mut self, separation: &Vector<D>, change: &Vector<D>) {
        let Some(virial) = self.sums.get_mut(1..1 + D * D) else { return };
        for (row, r) in virial.chunks_exact_mut(D).zip(separation.iter()) {
            row.iter_mut().zip(change.iter()).for_each(|(sum, p)| *sum += r * p);
        }
    }

    /// A collision of two grains, or the beginning of a contact: they have this relative velocity now.
    #[inline]
    fn touched(
        &mut self,
        [a, b]: [usize; 2],
        before: &Relative<f64, D>,
        after: &Vector<D>,
        how: &EventOutcome<f64>,
    ) {
        let Relative { separation, velocity, reduced_mass } = before;
        self.transfer(separation, &((after - velocity) * *reduced_mass));
        let approach = -separation.dot(velocity) / separation.norm_squared().sqrt();
        let (restitution, duration, lasting) = match how {
            EventOutcome::ContactBegan(Outcome { restitution, duration, .. }) => {
                (*restitution, *duration, 1.0)
            }
            EventOutcome::Collision { restitution } => (*restitution, 0.0, 0.0),
            _ => return,
        };
        let loss = 0.5 * reduced_mass * (velocity.norm_squared() - after.norm_squared());
        let more = [1.0, lasting, loss, approach, restitution, duration];
        self.contacts_of(a, b).iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }

    /// What a plane and a grain gave each other.
    fn pushed(&mut self, ground: &Grounded<D>, view: &View<'_, f64, D>, count: f64) {
        let Some(after) = view.velocity(ground.grain) else { return };
        let Some(plane) = view.boundary().planes().get(ground.plane) else { return };
        let push = plane.normal.dot(&(after - ground.velocity)) * ground.mass;
        let loss = 0.5 * ground.mass * (ground.velocity.norm_squared() - after.norm_squared());
        let more = [count, push, loss];
        self.wall(ground.plane).iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }

    /// A contact may have ended; if it has not the velocity is the same.
    fn ended(&mut self, ending: &Ending<D>, view: &View<'_, f64, D>) {
        match ending {
            Ending::Plane(ground) => self.pushed(ground, view, 0.0),
            Ending::Grain { grain, with, mass, velocity, separation } => {
                let Some(after) = view.velocity(*grain) else { return };
                self.transfer(separation, &((after - velocity) * (0.5 * mass)));
                let loss = 0.5 * mass * (velocity.norm_squared() - after.norm_squared());
                if let Some(sum) = self.contacts_of(*grain, *with).get_mut(Contact::Loss as usize) {
                    *sum += loss;
                }
            }
        }
    }

    /// The contact of a grain, if it has one, may end in this event, for one of the two or for both.
    fn may_end(&mut self, grain: usize, view: &View<'_, f64, D>) {
        let Some((partner, _)) = view.contact(grain) else { return };
        if let Some(plane) = partner.as_plane() {
            self.ending.extend(grounded(grain, plane, view).map(Ending::Plane));
        }
        let Some(other) = partner.as_grain() else { return };
        let of = |grain, with| {
            let mine = view.grain(grain)?;
            let Relative { separation, .. } = view.relative(grain, with)?;
            let (mass, velocity) = (mine.mass, mine.velocity);
            Some(Ending::Grain { grain, with, mass, velocity, separation })
        };
        self.ending.extend(of(grain, other));
        let mutual = view.contact(other).is_some_and(|(with, _)| with.as_grain() == Some(grain));
        self.ending.extend(mutual.then(|| of(other, grain)).flatten());
    }
}

fn touch<const D: usize>(grain: usize, with: Partner, view: &View<'_, f64, D>) -> Option<Touch<D>> {
    match (with.as_grain(), with.as_plane()) {
        (Some(b), _) => {
            let before = view.relative(grain, b)?;
            Some(Touch::Grains { a: grain, b, before })
        }
        (None, Some(plane)) => grounded(grain, plane, view).map(Touch::Plane),
        (None, None) => None,
    }
}

fn grounded<const D: usize>(
    grain: usize,
    plane: usize,
    view: &View<'_, f64, D>,
) -> Option<Grounded<D>> {
    let mine = view.grain(grain)?;
    Some(Grounded { grain, plane, mass: mine.mass, velocity: mine.velocity })
}

impl<const D: usize> Observer<f64, D> for Tally<D> {
    #[inline]
    fn before(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        match event.kind {
            EventKind::Collision => {
                self.touch = touch(event.grain, event.partner, &view);
                self.may_end(event.grain, &view);
                event.partner.as_grain().into_iter().for_each(|i| self.may_end(i, &view));
            }
            EventKind::ContactEnd => self.may_end(event.grain, &view),
            _ => {}
        }
    }

    #[inline]
    fn after(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        if event.kind == EventKind::Step {
            self.withhold();
        }
        if !matches!(event.kind, EventKind::Collision | EventKind::ContactEnd) {
            return;
        }
        match (&event.outcome, self.touch.take()) {
            (
                Some(how @ (EventOutcome::Collision { .. } | EventOutcome::ContactBegan(_))),
                Some(touch),
            ) => {
                self.ending.clear();
                match touch {
                    Touch::Grains { a, b, before } => {
                        if let (Some(v), Some(w)) = (view.velocity(a), view.velocity(b)) {
                            self.touched([a, b], &before, &(v - w), how);
                        }
                    }
                    Touch::Plane(ground) => self.pushed(&ground, &view, 1.0),
                }
            }
            _ => {
                while let Some(ending) = self.ending.pop() {
                    self.ended(&ending, &view);
                }
            }
        }
    }
}
