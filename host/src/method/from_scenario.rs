//! By which method and rule does a scenario run? Reads a scenario; writes nothing, hands out one running method.

use super::event_driven::EventDriven;
use super::force_based::ForceBased;
use super::interface::Method;
use super::l94::{Hard, L94};
use super::obstacles::{Obstacles, surface};
use super::running::{Borrower, Running};
use super::spins::Spins;
use super::told::told;
use crate::any_rule::{AnyRule, smooth};
use crate::drive::Driving;
use crate::integrated::Integrated;
use crate::observe::Layout;
use crate::scenario::{
    EnduringSpec, FrictionSpec, LawSpec, Laws, Made, MatrixSpec, MethodName, OutsideSpec,
    ReleaseSpec, Scenario, Shaking, Side, Start, buried, sources,
};
use crate::tables::embedded;
use anyhow::{Context, Result, bail};
use carom::HeapMemory;
use carom::law::{
    Central, HardSphere, LinearDashpot, Outside, PairRules, Rough, Rule, Soft, Tangential,
    Viscoelastic,
};
use carom::particle::Body;
use carom::space::{ContactState, Drift, Plane, Shear, Vibration};
use carom::world::{Buffers, SavedRotation, ScheduledEvent, Snapshot, Storage as _, WorldBuilder};
use carom::{Enduring, Grain, Release, World};
use carom_reference::{Exact, Plate, Verlet, VerletOptions};
use carom_tables::read::Law;

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

fn enclose<'m, const D: usize, R>(
    mut builder: WorldBuilder<'m, f64, D, R>,
    start: &Start,
) -> WorldBuilder<'m, f64, D, R> {
    for (axis, side) in start.sides.iter().enumerate().take(D) {
        match *side {
            Side::Open => {}
            Side::Periodic(range) => builder = builder.periodic_axis(axis, range),
            Side::Plate(plate, made) => {
                let Plate { at, amplitude, frequency, phase } = plate;
                let shaking = Shaking { amplitude, frequency, phase };
                let steady = start.steady[axis][0];
                builder = builder.plane(wall(axis, (at, 1.0), made, Some(shaking), steady));
            }
            Side::Walls([from, to], made, shaking) => {
                for (end, steady) in [(from, 1.0), (to, -1.0)].into_iter().zip(start.steady[axis]) {
                    builder = builder.plane(wall(axis, end, made, shaking, steady));
                }
            }
        }
    }
    match start.flow {
        Some(flow) => builder.sheared(Shear::new(flow.along, flow.gradient, flow.rate)),
        None => builder,
    }
}

/// The wall across an axis that faces up or down it; a positive amplitude moves it up first, wherever it faces, and a
/// positive steady speed up all the time.
fn wall<const D: usize>(
    axis: usize,
    (at, facing): (f64, f64),
    made: Made,
    shaking: Option<Shaking>,
    steady: f64,
) -> Plane<f64, D> {
    let mut normal = [0.0; D];
    normal[axis] = facing;
    let plane = Plane::new(normal, facing * at, surface(made));
    match shaking.filter(|shaking| shaking.amplitude != 0.0) {
        Some(Shaking { amplitude, frequency, phase }) => {
            plane.vibrating(Vibration::new(facing * amplitude, frequency).starting_at(phase))
        }
        None if steady != 0.0 => plane.drifting(Drift::new(facing * steady)),
        None => plane,
    }
}

fn system<const D: usize>(
    scenario: &Scenario,
    start: &Start,
) -> Result<(carom_reference::System<D>, carom_reference::ForceLaw)> {
    let boundary = std::array::from_fn(|axis| match start.sides[axis] {
        Side::Periodic([lo, hi]) => carom_reference::Boundary::Periodic { lo, hi },
        Side::Walls([lo, hi], ..) => carom_reference::Boundary::Walls { lo, hi },
        Side::Plate(plate, _) => carom_reference::Boundary::Plate(plate),
        Side::Open => carom_reference::Boundary::Open,
    });
    let grains = start.grains.iter().map(|grain| carom_reference::Grain {
        radius: grain.radius,
        mass: grain.mass,
        position: first(&grain.position),
        velocity: first(&grain.velocity),
    });
    let system = carom_reference::System::new(grains.collect(), boundary, first(&start.gravity))?;
    Ok((system, force_law(scenario)?))
}

/// The first `D` of three numbers.
fn first<const D: usize>(numbers: &[f64; 3]) -> [f64; D] {
    std::array::from_fn(|k| numbers[k])
}

/// The rules of an event-driven method for all pairs of materials, row by row; pairs that never meet have
/// that of another.
///
/// # Errors
/// When no two materials have a law, or one has no such rule.
pub fn rules(name: MethodName, scenario: &Scenario, laws: &Laws) -> Result<Vec<AnyRule<'static>>> {
    let all = || laws.pairs().flatten();
    let some = all().next().context("there is no law")?;
    if name == MethodName::EmdStar && !all().any(|law| law.has_force()) {
        bail!("{} needs a force law, but law.kind is constant", name.label());
    }
    let of = |law: Option<LawSpec>| rule(name, scenario, law.unwrap_or(some));
    if !laws.has_friction() {
        return Ok(laws.pairs().map(of).collect());
    }
    let smooth = Tangential::Constant { beta: -1.0 };
    let inertia = scenario.inertia.unwrap_or(0.4);
    let rough = |(law, friction): (Option<LawSpec>, Option<FrictionSpec>)| {
        let tangential = friction.map_or(smooth, Into::into);
        Box::new(Rough { inertia, ..Rough::spheres(of(law), tangential) }) as AnyRule<'static>
    };
    Ok(laws.pairs().zip(laws.frictions()).map(rough).collect())
}

/// The collision rule of an event-driven method.
fn rule(name: MethodName, scenario: &Scenario, law: LawSpec) -> AnyRule<'static> {
    match law {
        LawSpec::Constant { restitution } => Box::new(HardSphere { restitution }),
        LawSpec::Lsd { stiffness, damping } => {
            let law = LinearDashpot { stiffness, damping };
            match scenario.options.matrix {
                MatrixSpec::Integrate => by_method(name, Integrated::new(law)),
                MatrixSpec::Table => {
                    let table = embedded(scenario.options.table, Law::LinearDashpot);
                    by_method(name, Soft::with_table(law, table, outside(scenario)))
                }
            }
        }
        LawSpec::L94 { stiffness, beta, damping, gamma } => {
            let law = L94 { stiffness, beta, damping, gamma };
            match name {
                MethodName::Emd => Box::new(Hard(law)),
                _ => Box::new(carom::law::Integrated(law)),
            }
        }
        LawSpec::Viscoelastic { young, poisson, dissipation } => {
            let law = Viscoelastic { young, poisson, dissipation };
            match scenario.options.matrix {
                MatrixSpec::Integrate => by_method(name, Integrated::new(law)),
                MatrixSpec::Table => {
                    let table = embedded(scenario.options.table, Law::Viscoelastic);
                    by_method(name, Soft::with_table(law, table, outside(scenario)))
                }
            }
        }
    }
}

/// eMD takes only the central restitution of the rule, eMD* all of it.
fn by_method(name: MethodName, rule: impl Rule<f64> + Send + Sync + 'static) -> AnyRule<'static> {
    match name {
        MethodName::Emd => Box::new(Central(rule)),
        _ => Box::new(rule),
    }
}

fn outside(scenario: &Scenario) -> Outside {
    match scenario.options.outside {
        OutsideSpec::Reject => Outside::Reject,
        OutsideSpec::Clamp => Outside::Clamp,
        OutsideSpec::HardSphere => Outside::HardSphere,
    }
}

/// When contacts under this law are over.
const fn end(law: &carom_reference::ForceLaw) -> carom_reference::End {
    match law {
        carom_reference::ForceLaw::PowerLaw { .. } => carom_reference::End::Overlap,
        _ => carom_reference::End::Force,
    }
}

/// The force law of the reference.
///
/// # Errors
/// When the law has no force.
pub fn force_law(scenario: &Scenario) -> Result<carom_reference::ForceLaw> {
    match scenario.only_law().context("MD needs one law for all contacts")? {
        LawSpec::Lsd { stiffness, damping } => {
            Ok(carom_reference::ForceLaw::LinearDashpot { stiffness, damping })
        }
        LawSpec::Viscoelastic { young, poisson, dissipation } => {
            Ok(carom_reference::ForceLaw::Viscoelastic { young, poisson, dissipation })
        }
        LawSpec::L94 { stiffness, beta, damping, gamma } => {
            Ok(L94 { stiffness, beta, damping, gamma }.of_reference())
        }
        LawSpec::Constant { .. } => bail!("MD needs a force law, but law.kind is constant"),
    }
}
