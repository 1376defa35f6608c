//! What do contacts transfer and cost? Reads every event of a world, just before and just after; writes sums.

use super::layout::{Contact, Layout, Wall};
use carom::law::Outcome;
use carom::particle::Partner;
use carom::world::{Event, EventKind, EventOutcome};
use carom::{Grain, Observer, View};

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
    /// What is about to happen: to whom, with whom.
    two: Option<Two<D>>,
    /// Contacts under way that an event may end.
    ending: Vec<Two<D>>,
}

/// A grain and what it touches, before they know of each other.
#[derive(Clone, Copy, Debug)]
struct Two<const D: usize> {
    grain: usize,
    one: Grain<f64, D>,
    other: Other<D>,
}

/// What a grain touches.
#[derive(Clone, Copy, Debug)]
enum Other<const D: usize> {
    Grain { number: usize, grain: Grain<f64, D>, separation: [f64; D] },
    Plane { number: usize, normal: [f64; D] },
}

impl<const D: usize> Tally<D> {
    /// Nothing has happened.
    pub fn new(layout: &Layout) -> Self {
        let sums = vec![0.0; layout.tally_width()];
        Self { layout: layout.clone(), sums, two: None, ending: Vec::with_capacity(2) }
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

    fn species(&self, grain: usize) -> usize {
        self.layout.species.get(grain).copied().map_or(0, usize::from)
    }

    fn add(&mut self, place: usize, value: f64) {
        if let Some(sum) = self.sums.get_mut(place) {
            *sum += value;
        }
    }

    fn pair_of(&self, a: usize, b: usize) -> usize {
        self.layout.pair(self.species(a), self.species(b))
    }

    /// Momentum that a grain was given by what it touched, or half of what both were given.
    fn transfer(&mut self, two: &Two<D>, change: &[f64; D], share: f64) {
        match two.other {
            Other::Grain { separation, .. } => {
                for (a, r) in separation.iter().enumerate() {
                    for (b, p) in change.iter().enumerate() {
                        let place = self.layout.virial(a, b);
                        self.add(place, share * r * p);
                    }
                }
            }
            Other::Plane { number, normal } => {
                let place = self.layout.wall(number, Wall::Push);
                self.add(place, dot(&normal, change));
            }
        }
    }

    fn lose(&mut self, two: &Two<D>, energy: f64) {
        let place = match two.other {
            Other::Grain { number, .. } => {
                self.layout.contact(self.pair_of(two.grain, number), Contact::Loss)
            }
            Other::Plane { number, .. } => self.layout.wall(number, Wall::Loss),
        };
        self.add(place, energy);
    }

    /// A collision, or a contact that began: both have the new velocities of these two.
    fn touched(&mut self, two: &Two<D>, velocity: &[f64; D], how: &EventOutcome<f64>) {
        let change = momentum(&two.one, velocity);
        self.transfer(two, &change, 1.0);
        let square = dot(&change, &change);
        match two.other {
            Other::Grain { number, grain, separation } => {
                let relative: [f64; D] =
                    std::array::from_fn(|a| two.one.velocity[a] - grain.velocity[a]);
                let reduced = two.one.mass * grain.mass / (two.one.mass + grain.mass);
                self.lose(two, -dot(&change, &relative) - square / (2.0 * reduced));
                let approach = -dot(&separation, &relative) / dot(&separation, &separation).sqrt();
                self.count(self.pair_of(two.grain, number), approach, how);
            }
            Other::Plane { number, .. } => {
                let old: [f64; D] = two.one.velocity.into();
                self.lose(two, -dot(&change, &old) - square / (2.0 * two.one.mass));
                self.add(self.layout.wall(number, Wall::Count), 1.0);
            }
        }
    }

    fn count(&mut self, pair: usize, approach: f64, how: &EventOutcome<f64>) {
        let (restitution, duration, lasting) = match how {
            EventOutcome::ContactBegan(Outcome { restitution, duration, .. }) => {
                (*restitution, *duration, 1.0)
            }
            EventOutcome::Collision { restitution } => (*restitution, 0.0, 0.0),
            _ => return,
        };
        for (what, value) in [
            (Contact::Count, 1.0),
            (Contact::Lasting, lasting),
            (Contact::Approach, approach),
            (Contact::Restitution, restitution),
            (Contact::Duration, duration),
        ] {
            self.add(self.layout.contact(pair, what), value);
        }
    }

    /// A contact that ended, for one of the two.
    fn ended(&mut self, two: &Two<D>, velocity: &[f64; D]) {
        let change = momentum(&two.one, velocity);
        let share = if matches!(two.other, Other::Grain { .. }) { 0.5 } else { 1.0 };
        self.transfer(two, &change, share);
        let old: [f64; D] = two.one.velocity.into();
        self.lose(two, -dot(&change, &old) - dot(&change, &change) / (2.0 * two.one.mass));
    }

    /// The contact of a grain, if it has one, may end in this event, for one of the two or for both.
    fn may_end(&mut self, grain: usize, view: &View<'_, f64, D>) {
        let Some((partner, _)) = view.contact(grain) else { return };
        let Some(mine) = two(grain, partner, view) else { return };
        self.ending.push(mine);
        let other = partner.as_grain().and_then(|k| Some((k, view.contact(k)?.0)));
        if let Some((k, _)) = other.filter(|(_, with)| with.as_grain() == Some(grain)) {
            self.ending.extend(two(k, Partner::grain(grain), view));
        }
    }
}

fn two<const D: usize>(grain: usize, with: Partner, view: &View<'_, f64, D>) -> Option<Two<D>> {
    let one = view.grain(grain)?;
    let other = match (with.as_grain(), with.as_plane()) {
        (Some(number), _) => {
            let grain = view.grain(number)?;
            let separation = view.boundary().nearest(one.position - grain.position).into();
            Other::Grain { number, grain, separation }
        }
        (None, Some(number)) => {
            let normal = view.boundary().planes().get(number)?.normal.into();
            Other::Plane { number, normal }
        }
        (None, None) => return None,
    };
    Some(Two { grain, one, other })
}

impl<const D: usize> Observer<f64, D> for Tally<D> {
    #[inline]
    fn before(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        match event.kind {
            EventKind::Collision => {
                self.two = two(event.grain, event.partner, &view);
                let both = [Some(event.grain), event.partner.as_grain()];
                both.into_iter().flatten().for_each(|i| self.may_end(i, &view));
            }
            EventKind::ContactEnd => self.may_end(event.grain, &view),
            _ => {}
        }
    }

    #[inline]
    fn after(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        if !matches!(event.kind, EventKind::Collision | EventKind::ContactEnd) {
            return;
        }
        let two = self.two.take();
        let velocity = |grain: usize| view.grain(grain).map(|grain| grain.velocity.into());
        match (&event.outcome, two) {
            (
                Some(how @ (EventOutcome::Collision { .. } | EventOutcome::ContactBegan(_))),
                Some(two),
            ) => {
                if let Some(velocity) = velocity(two.grain) {
                    self.touched(&two, &velocity, how);
                }
                self.ending.clear();
            }
            _ => {
                while let Some(two) = self.ending.pop() {
                    if let Some(velocity) = velocity(two.grain) {
                        self.ended(&two, &velocity);
                    }
                }
            }
        }
    }
}

fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The momentum that a grain was given.
fn momentum<const D: usize>(before: &Grain<f64, D>, after: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|a| before.mass * (after[a] - before.velocity[a]))
}
