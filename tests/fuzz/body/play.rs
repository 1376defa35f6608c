//! What happens to a fuzzed world? Reads bytes; steps, turns, saves and restores the world, and asks the judge.

use super::draw::Draw;
use super::judge::Judge;
use super::snapshot;
use super::world::Store;
use carom::law::Rule;
use carom::{Error, Instant, Scalar, World};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Steps that one input may take in all.
const STEPS: u32 = 600;
/// How often one input may be saved and taken up again.
const RESTORES: u8 = 6;

/// A world under a rule that is only known at run time.
pub type Any<'m, 'r, S, const D: usize> = World<'m, S, D, &'r dyn Rule<S>>;

/// Does what the bytes say, then steps on until the steps are used up.
///
/// # Errors
/// The fault at which the world stopped.
pub fn play<'r, S, const D: usize>(
    mut world: Any<'_, 'r, S, D>,
    rule: &'r dyn Rule<S>,
    draw: &mut Draw<'_>,
    mut judge: Judge,
    depth: u8,
) -> Result<(), Error>
where
    S: Scalar + Serialize + DeserializeOwned,
{
    while !draw.is_empty() && judge.steps < STEPS {
        match draw.below(12) {
            0..=5 => steps(&mut world, u32::from(draw.byte()) + 1, draw, &mut judge)?,
            6 => advance(&mut world, 0.5, &mut judge)?,
            7 => advance(&mut world, 1.0, &mut judge)?,
            8 => past(&mut world),
            9 => {
                let gravity = std::array::from_fn(|_| draw.number());
                judge.saw_gravity();
                judge.look(world.set_gravity(gravity), draw)?;
            }
            10 if depth < RESTORES => return again(world, rule, draw, judge, depth),
            _ => snapshot::hostile(&world, rule, draw),
        }
        judge.inspect(&world, draw);
    }
    steps(&mut world, STEPS.saturating_sub(judge.steps), draw, &mut judge)
}

fn steps<S: Scalar, const D: usize>(
    world: &mut Any<'_, '_, S, D>,
    count: u32,
    draw: &Draw<'_>,
    judge: &mut Judge,
) -> Result<(), Error> {
    for _ in 0..count {
        judge.steps += 1;
        let step = judge.look(world.step(), draw)?;
        judge.clock(world.now());
        match step {
            Some(event) => judge.happened(world, &event, draw),
            None => break,
        }
    }
    judge.inspect(world, draw);
    Ok(())
}

/// Goes to the next event or part of the way there. Not while many happen at one instant: this would
/// take them all.
fn advance<S: Scalar, const D: usize>(
    world: &mut Any<'_, '_, S, D>,
    part: f64,
    judge: &mut Judge,
) -> Result<(), Error> {
    let now = world.now();
    let Some(next) = world.next_event_time().filter(|next| *next > now) else { return Ok(()) };
    let to = if part < 1.0 { now + Instant::from(next.since::<f64>(now) * part) } else { next };
    let before = world.statistics().events();
    world.advance_to(to)?;
    judge.steps += u32::try_from(world.statistics().events() - before).unwrap_or(STEPS) + 1;
    assert!(world.now() <= to, "asked for {to}, is {}", world.now());
    judge.clock(world.now());
    Ok(())
}

/// The past stays past.
fn past<S: Scalar, const D: usize>(world: &mut Any<'_, '_, S, D>) {
    let now = world.now();
    if now > Instant::START {
        let refused = world.advance_to(Instant::START);
        assert!(matches!(refused, Err(Error::Past { .. })), "{refused:?}");
    }
    assert_eq!(world.now(), now);
}

/// The world is saved, taken up elsewhere, and goes on there with the same bits.
fn again<'r, S, const D: usize>(
    mut world: Any<'_, 'r, S, D>,
    rule: &'r dyn Rule<S>,
    draw: &mut Draw<'_>,
    mut judge: Judge,
    depth: u8,
) -> Result<(), Error>
where
    S: Scalar + Serialize + DeserializeOwned,
{
    let mut memory = Box::new(Store::<S, D>::new());
    let mut copy = match World::restore(&mut *memory, rule, &world.save()) {
        Ok(copy) => copy,
        // Speeds that cross the box in no time at all leave a grain outside its cell.
        Err(fault) if !draw.tame => return Err(fault),
        Err(fault) => panic!("a world's own snapshot is refused: {fault}"),
    };
    assert_eq!(world.digest(), copy.digest(), "restored");
    for step in 0..12 {
        judge.steps += 1;
        let (one, other) = (world.step(), copy.step());
        assert_eq!(one, other, "step {step} after it was restored");
        assert_eq!(world.digest(), copy.digest(), "step {step} after it was restored");
        judge.look(other, draw)?;
    }
    judge.clock(copy.now());
    play(copy, rule, draw, judge, depth + 1)
}
