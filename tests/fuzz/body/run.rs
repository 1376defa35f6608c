//! What happens to a fuzzed world? Reads bytes; steps, turns, saves and restores the world, and checks the invariants.

use super::input::Input;
use super::invariants::Invariants;
use super::tampered_snapshot;
use super::world::FuzzMemory;
use carom::law::Rule;
use carom::{Error, Instant, Scalar, World};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Steps that one input may take in all.
const STEPS: u32 = 600;
/// How often one input may be saved and restored.
const RESTORES: u8 = 6;

/// A world under a rule that is only known at run time.
pub type DynWorld<'m, 'r, S, const D: usize> = World<'m, S, D, &'r dyn Rule<S>>;

/// Does what the bytes say, then steps on until the steps are used up.
///
/// # Errors
/// The error at which the world stopped.
pub fn run_world<'r, S, const D: usize>(
    mut world: DynWorld<'_, 'r, S, D>,
    rule: &'r dyn Rule<S>,
    input: &mut Input<'_>,
    mut invariants: Invariants,
    depth: u8,
) -> Result<(), Error>
where
    S: Scalar + Serialize + DeserializeOwned,
{
    while !input.is_empty() && invariants.steps < STEPS {
        match input.below(12) {
            0..=5 => steps(&mut world, u32::from(input.byte()) + 1, input, &mut invariants)?,
            6 => advance(&mut world, 0.5, &mut invariants)?,
            7 => advance(&mut world, 1.0, &mut invariants)?,
            8 => past(&mut world),
            9 => {
                let gravity = std::array::from_fn(|_| input.number());
                invariants.gravity_changed();
                invariants.check_error(world.set_gravity(gravity), input)?;
            }
            10 if depth < RESTORES => return restore(world, rule, input, invariants, depth),
            _ => tampered_snapshot::check(&world, rule, input),
        }
        invariants.check_state(&world, input);
    }
    steps(&mut world, STEPS.saturating_sub(invariants.steps), input, &mut invariants)
}

fn steps<S: Scalar, const D: usize>(
    world: &mut DynWorld<'_, '_, S, D>,
    count: u32,
    input: &Input<'_>,
    invariants: &mut Invariants,
) -> Result<(), Error> {
    for _ in 0..count {
        invariants.steps += 1;
        let step = invariants.check_error(world.step(), input)?;
        invariants.check_time(world.now());
        match step {
            Some(event) => invariants.check_event(world, &event, input),
            None => break,
        }
    }
    invariants.check_state(world, input);
    Ok(())
}

/// Goes to the next event or part of the way there. Not while many happen at one instant: this would
/// take them all.
fn advance<S: Scalar, const D: usize>(
    world: &mut DynWorld<'_, '_, S, D>,
    part: f64,
    invariants: &mut Invariants,
) -> Result<(), Error> {
    let now = world.now();
    let Some(next) = world.next_event_time().filter(|next| *next > now) else { return Ok(()) };
    let to = if part < 1.0 { now + Instant::from(next.since::<f64>(now) * part) } else { next };
    let before = world.statistics().events();
    world.advance_to(to)?;
    invariants.steps += u32::try_from(world.statistics().events() - before).unwrap_or(STEPS) + 1;
    assert!(world.now() <= to, "asked for {to}, is {}", world.now());
    invariants.check_time(world.now());
    Ok(())
}

/// The past stays past.
fn past<S: Scalar, const D: usize>(world: &mut DynWorld<'_, '_, S, D>) {
    let now = world.now();
    if now > Instant::START {
        let refused = world.advance_to(Instant::START);
        assert!(matches!(refused, Err(Error::Past { .. })), "{refused:?}");
    }
    assert_eq!(world.now(), now);
}

/// The world is saved, restored elsewhere, and goes on there with the same bits.
fn restore<'r, S, const D: usize>(
    mut world: DynWorld<'_, 'r, S, D>,
    rule: &'r dyn Rule<S>,
    input: &mut Input<'_>,
    mut invariants: Invariants,
    depth: u8,
) -> Result<(), Error>
where
    S: Scalar + Serialize + DeserializeOwned,
{
    let mut memory = Box::new(FuzzMemory::<S, D>::new());
    let mut copy = match World::restore(&mut *memory, rule, &world.save()) {
        Ok(copy) => copy,
        // Speeds that cross the box in no time at all leave a grain outside its cell.
        Err(error) if !input.moderate => return Err(error),
        Err(error) => panic!("a world's own snapshot is refused: {error}"),
    };
    assert_eq!(world.digest(), copy.digest(), "restored");
    for step in 0..12 {
        invariants.steps += 1;
        let (one, other) = (world.step(), copy.step());
        assert_eq!(one, other, "step {step} after it was restored");
        assert_eq!(world.digest(), copy.digest(), "step {step} after it was restored");
        invariants.check_error(other, input)?;
    }
    invariants.check_time(copy.now());
    run_world(copy, rule, input, invariants, depth + 1)
}
