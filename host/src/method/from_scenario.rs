//! By which method and rule does a scenario run? Reads a scenario; writes nothing, hands out one running method.

use super::components::first;
use super::enclose::enclose;
use super::event_driven::EventDriven;
use super::force_based::ForceBased;
use super::force_law::{end, system};
use super::interface::Method;
use super::obstacles::Obstacles;
use super::rules::rules;
use super::running::{Borrower, Running};
use super::spins::Spins;
use super::told::told;
use crate::any_rule::{AnyRule, smooth};
use crate::drive::Driving;
use crate::observe::Layout;
use crate::scenario::{EnduringSpec, MethodName, ReleaseSpec, Scenario, Start, buried, sources};
use anyhow::{Context, Result};
use carom::HeapMemory;
use carom::law::{PairRules, Rule};
use carom::particle::Body;
use carom::space::ContactState;
use carom::world::{Buffers, SavedRotation, ScheduledEvent, Snapshot, Storage as _, WorldBuilder};
use carom::{Enduring, Grain, Release, World};
use carom_reference::{Exact, Verlet, VerletOptions};

/// Sets a method up and hands it to `work`.
///
/// # Errors
/// An error of the set-up or of `work`.
///
/// ```
/// use carom_host::{method, scenario::{MethodName, Scenario, Start}};
/// let scenario = Scenario::parse("dimension = 1\nduration = 1.0\nsample = 1.0\n\
///     [law]\nkind = \"lsd\"\nstiffness = 1e6\ndamping = 0.0\n\
///     [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0]\nmoving = [1.0]\n\
///     [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.5]").unwrap();
/// let start = Start::new(&scenario).unwrap();
/// let speed = method::with(MethodName::Emd, &scenario, &start, |method| {
///     method.advance_to(1.0)?;
///     Ok(method.grains()[1].velocity[0])
/// }).unwrap();
/// assert!((speed - 1.0).abs() < 1e-6);
/// ```
pub fn with<T>(
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    work: impl FnOnce(&mut dyn Method) -> Result<T>,
) -> Result<T> {
    with_state(name, scenario, start, None, work)
}

/// As [`with`], from a state that [`Method::save`] gave. A method that cannot be saved begins anew.
///
/// # Errors
/// As [`with`], and when the state is not one of such a world.
pub fn with_state<T>(
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    state: Option<&[u8]>,
    work: impl FnOnce(&mut dyn Method) -> Result<T>,
) -> Result<T> {
    let mut running = begin(name, scenario, start, state)?;
    running.with(work).with_context(|| name.label())
}

/// As [`with_state`], for whoever keeps the method: it owns all it needs, and may go to another thread.
///
/// # Errors
/// As [`with_state`].
///
/// ```
/// use carom_host::{method, scenario::{MethodName, Scenario, Start}};
/// let scenario = Scenario::parse("dimension = 1\nduration = 1.0\nsample = 1.0\n\
///     [law]\nkind = \"constant\"\nrestitution = 1.0\n\
///     [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0]\nmoving = [1.0]").unwrap();
/// let start = Start::new(&scenario).unwrap();
/// let mut running = method::begin(MethodName::Emd, &scenario, &start, None).unwrap();
/// let place = std::thread::spawn(move || running.with(|method| {
///     method.advance_to(2.0).map(|()| method.grains()[0].position[0])
/// }));
/// assert_eq!(place.join().unwrap().unwrap(), 2.0);
/// ```
pub fn begin(
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    state: Option<&[u8]>,
) -> Result<Running> {
    let begun = match start.dimension {
        1 => begin_in::<1>(name, scenario, start, state),
        2 => begin_in::<2>(name, scenario, start, state),
        _ => begin_in::<3>(name, scenario, start, state),
    };
    begun.with_context(|| name.label())
}

fn begin_in<const D: usize>(
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    state: Option<&[u8]>,
) -> Result<Running> {
    match name {
        MethodName::Md => {
            let (system, law) = system::<D>(scenario, start)?;
            let begin = || Ok(Verlet::new(&system, law, end(&law), VerletOptions::default())?);
            let layout = scenario.observe.as_ref().map(|_| Layout::new(start));
            Ok(Running::alone(ForceBased::new(begin, state, start, layout.as_ref())?))
        }
        MethodName::Exact => {
            let (system, law) = system::<D>(scenario, start)?;
            let begin = || Ok(Exact::new(system, law, end(&law))?);
            Ok(Running::alone(ForceBased::new(begin, state, start, None)?))
        }
        MethodName::Emd | MethodName::EmdStar => {
            let grains = HeapMemory::<f64, D>::with_capacity(start.grains.len());
            let obstacles = Obstacles::new(start);
            let memory = Memory { grains, spins: Spins::new::<D>(start), obstacles };
            let rules = rules(name, scenario, &start.laws)?;
            Running::on(memory, rules, |memory, rules| {
                let rule = PairRules::new(rules).context("a rule for each pair of materials")?;
                if start.laws.has_friction() {
                    let rough: AnyRule<'_> = Box::new(rule);
                    return world(memory, rough, name, scenario, start, state);
                }
                world(memory, smooth(rule), name, scenario, start, state)
            })
        }
    }
}

/// What a world borrows.
struct Memory<const D: usize> {
    grains: HeapMemory<f64, D>,
    spins: Spins,
    obstacles: Obstacles<D>,
}

/// A saved world of the core.
type Saved<const D: usize> = Snapshot<
    f64,
    D,
    Vec<Body<f64, D>>,
    Vec<ScheduledEvent<f64>>,
    SavedRotation<Vec<f64>, Vec<ContactState<f64>>>,
>;

/// A world at its start, or from where it was saved.
fn world<'m, const D: usize, R: Rule<f64> + Send + 'm>(
    memory: &'m mut Memory<D>,
    rule: R,
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    state: Option<&[u8]>,
) -> Result<Borrower<'m>> {
    let layout = scenario.observe.as_ref().map(|_| Layout::new(start));
    let (rotation, contacts) = memory.spins.buffers();
    let obstacles = memory.obstacles.buffers();
    let buffers = Buffers { rotation, contacts, obstacles, ..memory.grains.buffers() };
    if let Some(bytes) = state {
        let (saved, tally, driving): (Saved<D>, Option<Vec<f64>>, Option<Driving<D>>) =
            postcard::from_bytes(bytes).context("the saved state is damaged")?;
        let world = World::restore_with(buffers, rule, &saved)?;
        let method = EventDriven::new(world, name, scenario.options.events);
        let method = method.with_tally(layout.as_ref(), tally.as_deref());
        return Ok(Box::new(method.driven(driving)));
    }
    buried(start).map_or(Ok(()), Err)?;
    let builder = World::builder_with(buffers).gravity(first(&start.gravity));
    let builder = builder.enduring(enduring(scenario));
    let builder =
        enclose(builder.release(release(scenario)).tc(scenario.options.tc), start).rule(rule);
    let materials = start.materials.iter().copied().chain(std::iter::repeat(0));
    let grains = start.grains.iter().zip(materials).map(|(grain, material)| {
        Grain::with_mass(grain.radius, grain.mass)
            .at(first(&grain.position))
            .moving(first(&grain.velocity))
            .of_material(material)
    });
    let world = builder.grains(grains).and_then(WorldBuilder::start);
    let world = world.map_err(|why| told(why, start))?;
    let method = EventDriven::new(world, name, scenario.options.events);
    let driving = driving(scenario, start)?;
    Ok(Box::new(method.with_tally(layout.as_ref(), None).driven(driving)))
}

/// What drives a run, if anything does.
fn driving<const D: usize>(scenario: &Scenario, start: &Start) -> Result<Option<Driving<D>>> {
    let sources = sources(scenario, start);
    let is_driven = !sources.is_empty();
    let driving = || Driving::new(sources, start.grains.len(), scenario.seed);
    is_driven.then(driving).transpose()
}

fn enduring(scenario: &Scenario) -> Enduring {
    match scenario.options.enduring {
        EnduringSpec::Paper => Enduring::Paper,
        EnduringSpec::Integrated => Enduring::Integrated,
    }
}

fn release(scenario: &Scenario) -> Release {
    match scenario.options.release {
        ReleaseSpec::Paired => Release::Paired,
        ReleaseSpec::Independent => Release::Independent,
    }
}
