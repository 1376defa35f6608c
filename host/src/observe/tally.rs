//! What do contacts transfer and cost? Reads every event of a world, just before and just after; writes sums.

use super::alone::{Alone, Gained};
use super::given::Given;
use super::layout::{Contact, Layout};
use carom::law::{Outcome, Rule};
use carom::nalgebra::SVector;
use carom::particle::Partner;
use carom::world::{Event, EventKind, EventOutcome, Relative, Transfer};
use carom::{Observer, View, World};

/// Sums over the contacts of a world.
///
/// The momentum that a contact of some duration transfers is counted where velocities change, at its
/// beginning and its end; with velocities as the world shows them in between, of which the stress of
/// motion is made, the two give the whole stress exactly. Clustered grains say in each step what they give each
/// other; those that sleep are asked at each look ([`Tally::rest`]). Restitution and duration of contacts in clusters
/// are not known, and left empty. Where several collide at one instant, what a wall or an obstacle was given is that of
/// the grain of the event, all at once.
#[derive(Clone, Debug)]
pub struct Tally<const D: usize> {
    given: Given,
    /// What is about to happen.
    touch: Option<Touch<D>>,
    /// Contacts under way that an event may end.
    ending: Vec<Ending<D>>,
    /// Steps that nobody observed, as many as were counted.
    unseen: Option<u64>,
    /// I/(m R²) of all grains; 0 for smooth ones.
    inertia: f64,
}

type Vector<const D: usize> = SVector<f64, D>;

/// Two that are about to touch.
#[derive(Clone, Copy, Debug)]
enum Touch<const D: usize> {
    Grains { a: usize, b: usize, before: Relative<f64, D>, rotation: f64 },
    Plane(usize, Alone<D>),
    Facet(usize, Alone<D>),
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
    Plane(usize, Alone<D>),
}

impl<const D: usize> Tally<D> {
    /// Nothing has happened.
    pub fn new(layout: &Layout, inertia: Option<f64>) -> Self {
        let (given, ending) = (Given::new(layout), Vec::with_capacity(4));
        Self { given, touch: None, ending, unseen: None, inertia: inertia.unwrap_or(0.0) }
    }

    /// The sums so far.
    pub fn sums(&self) -> &[f64] {
        self.given.sums()
    }

    /// Goes on from these sums.
    pub fn set(&mut self, sums: &[f64]) {
        self.given.set(sums);
    }

    /// The sums since the last call; the next are from now on.
    pub fn take(&mut self, now: f64) -> Vec<f64> {
        self.given.take(now)
    }

    /// Adds what sleeping grains have given each other and the walls since the last call of [`Tally::take`].
    ///
    /// Who woke meanwhile is not among them: what a grain gives between a look and its waking is lost.
    pub fn rest<R: Rule<f64>>(&mut self, world: &World<'_, f64, D, R>) {
        self.look_for_unseen(&world.view());
        let (now, last) = (world.now().as_f64(), self.given.since());
        world.for_each_resting_contact(|contact, since| {
            let span = now - last.max(since.as_f64());
            self.gave(&Transfer { impulse: contact.impulse * span, ..*contact });
        });
    }

    /// Steps of clusters that were not observed: what contacts gave meanwhile is not known.
    fn look_for_unseen(&mut self, view: &View<'_, f64, D>) {
        let now = view.statistics().cut_steps;
        if self.unseen.replace(now).is_some_and(|before| before != now) {
            self.given.forget();
        }
    }

    /// What two gave each other in a cluster or at rest, where it is not known how long a contact lasts.
    fn gave(&mut self, contact: &Transfer<f64, D>) {
        let unknown = if contact.approach.is_some() { f64::NAN } else { 0.0 };
        self.given.add(contact, unknown);
    }

    /// A collision of two grains, or the beginning of a contact: they have this relative velocity now.
    #[inline]
    fn touched(
        &mut self,
        [a, b]: [usize; 2],
        before: &Relative<f64, D>,
        (after, rotation): (&Vector<D>, f64),
        how: &EventOutcome<f64>,
    ) {
        let Relative { separation, velocity, reduced_mass } = before;
        self.given.transfer(separation, &((after - velocity) * *reduced_mass));
        let approach = -separation.dot(velocity) / separation.norm_squared().sqrt();
        let (restitution, duration, lasting) = match how {
            EventOutcome::ContactBegan(Outcome { restitution, duration, .. }) => {
                (*restitution, *duration, 1.0)
            }
            EventOutcome::Collision { restitution } => (*restitution, 0.0, 0.0),
            _ => return,
        };
        let square = velocity.norm_squared() - after.norm_squared();
        let loss = 0.5 * reduced_mass * square + rotation;
        let more = [1.0, lasting, loss, approach, restitution, duration];
        self.given.contacts_of(a, b).iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }

    /// What a plane and a grain gave each other.
    fn pushed(&mut self, plane: usize, before: &Alone<D>, view: &View<'_, f64, D>, count: f64) {
        let Some(Gained { momentum, energy, .. }) = before.gained(view, self.inertia) else {
            return;
        };
        let Some(normal) = view.boundary().planes().get(plane).map(|plane| plane.normal) else {
            return;
        };
        self.given.push(plane, [count, normal.dot(&momentum), -energy]);
    }

    /// What a facet and a grain gave each other: what the grain has gained, of angular momentum, too.
    fn struck(&mut self, facet: usize, before: &Alone<D>, view: &View<'_, f64, D>) {
        let Some(Gained { momentum, spin, energy }) = before.gained(view, self.inertia) else {
            return;
        };
        self.given.strike(facet, [1.0, -energy], &momentum, (&before.grain.position, spin));
    }

    /// Who touches whom in an event.
    fn touch(&self, a: usize, with: Partner, view: &View<'_, f64, D>) -> Option<Touch<D>> {
        if let Some(b) = with.as_grain() {
            let (before, rotation) = (view.relative(a, b)?, self.rotation([a, b], view));
            return Some(Touch::Grains { a, b, before, rotation });
        }
        let alone = Alone::new(a, view)?;
        let plane = with.as_plane().map(|plane| Touch::Plane(plane, alone));
        plane.or_else(|| Some(Touch::Facet(with.as_facet()?, alone)))
    }

    /// The rotational energy of two grains.
    fn rotation(&self, pair: [usize; 2], view: &View<'_, f64, D>) -> f64 {
        if self.inertia == 0.0 {
            return 0.0;
        }
        let alone = pair.into_iter().filter_map(|i| Alone::new(i, view));
        alone.map(|grain| grain.rotational_energy(self.inertia)).sum()
    }

    /// A contact may have ended; if it has not the velocity is the same.
    fn ended(&mut self, ending: &Ending<D>, view: &View<'_, f64, D>) {
        match ending {
            Ending::Plane(plane, before) => self.pushed(*plane, before, view, 0.0),
            Ending::Grain { grain, with, mass, velocity, separation } => {
                let Some(after) = view.velocity(*grain) else { return };
                self.given.transfer(separation, &((after - velocity) * (0.5 * mass)));
                // The two of a contact have one velocity, but for images of a sheared box: there theirs is none.
                let loss = match view.boundary().shear() {
                    Some(_) => -0.5 * mass * (after - velocity).norm_squared(),
                    None => 0.5 * mass * (velocity.norm_squared() - after.norm_squared()),
                };
                if let Some(sum) =
                    self.given.contacts_of(*grain, *with).get_mut(Contact::Loss as usize)
                {
                    *sum += loss;
                }
            }
        }
    }

    /// The contact of a grain, if it has one, may end in this event, for one of the two or for both.
    fn may_end(&mut self, grain: usize, view: &View<'_, f64, D>) {
        let Some((partner, _)) = view.contact(grain) else { return };
        if let Some(plane) = partner.as_plane() {
            let alone = Alone::new(grain, view);
            self.ending.extend(alone.map(|alone| Ending::Plane(plane, alone)));
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

/// How fast a grain moves against another, in the images that are the nearest.
#[inline]
fn relative_velocity<const D: usize>(
    view: &View<'_, f64, D>,
    a: usize,
    b: usize,
) -> Option<Vector<D>> {
    if view.boundary().shear().is_some() {
        return view.relative(a, b).map(|relative| relative.velocity);
    }
    Some(view.velocity(a)? - view.velocity(b)?)
}

impl<const D: usize> Observer<f64, D> for Tally<D> {
    #[inline]
    fn before(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        match event.kind {
            EventKind::Collision => {
                self.touch = self.touch(event.grain, event.partner, &view);
                self.may_end(event.grain, &view);
                event.partner.as_grain().into_iter().for_each(|i| self.may_end(i, &view));
            }
            EventKind::ContactEnd => self.may_end(event.grain, &view),
            _ => {}
        }
    }

    #[inline]
    fn transferred(&mut self, transfer: &Transfer<f64, D>) {
        self.gave(transfer);
    }

    #[inline]
    fn after(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        if event.kind == EventKind::Step {
            self.look_for_unseen(&view);
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
                    Touch::Grains { a, b, before, rotation } => {
                        if let Some(after) = relative_velocity(&view, a, b) {
                            let lost = rotation - self.rotation([a, b], &view);
                            self.touched([a, b], &before, (&after, lost), how);
                        }
                    }
                    Touch::Plane(plane, before) => self.pushed(plane, &before, &view, 1.0),
                    Touch::Facet(facet, before) => self.struck(facet, &before, &view),
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
