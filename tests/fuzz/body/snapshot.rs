//! What if a snapshot was tampered with? Changes one number in it; panics unless it is refused or runs.

use super::draw::Draw;
use super::play::Any;
use super::world::Store;
use carom::law::Rule;
use carom::particle::Body;
use carom::world::ScheduledEvent;
use carom::world::Snapshot;
use carom::{Scalar, World};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

/// Steps that a tampered world may take.
const STEPS: usize = 100;

/// Saves the world as text, changes a number, and takes it up again.
pub fn hostile<S, const D: usize>(
    world: &Any<'_, '_, S, D>,
    rule: &dyn Rule<S>,
    draw: &mut Draw<'_>,
) where
    S: Scalar + Serialize + DeserializeOwned,
{
    let Ok(mut value) = serde_json::to_value(world.save()) else { return };
    let which = usize::from(draw.byte()) | usize::from(draw.byte()) << 8;
    let mut numbers = Vec::new();
    collect(&mut value, &mut numbers);
    let count = numbers.len().max(1);
    if let Some(number) = numbers.into_iter().nth(which % count) {
        *number = other(draw);
    }
    let Ok(saved) =
        serde_json::from_value::<Snapshot<S, D, Vec<Body<S, D>>, Vec<ScheduledEvent<S>>>>(value)
    else {
        return;
    };
    let mut memory = Box::new(Store::<S, D>::new());
    if let Ok(mut world) = World::restore(&mut *memory, rule, &saved) {
        for _ in 0..STEPS {
            if !matches!(world.step(), Ok(Some(_))) {
                break;
            }
        }
    }
}

fn collect<'v>(value: &'v mut Value, numbers: &mut Vec<&'v mut Value>) {
    match value {
        Value::Number(_) => numbers.push(value),
        Value::Array(list) => list.iter_mut().for_each(|value| collect(value, numbers)),
        Value::Object(fields) => fields.values_mut().for_each(|value| collect(value, numbers)),
        _ => {}
    }
}

/// A whole number, or any that is finite.
fn other(draw: &mut Draw<'_>) -> Value {
    match draw.below(3) {
        0 => Value::from(draw.byte()),
        1 => Value::from(u64::from_le_bytes(std::array::from_fn(|_| draw.byte()))),
        _ => {
            // The tampered number says nothing of the world that goes on.
            let tame = draw.tame;
            let number: f64 = draw.number();
            draw.tame = tame;
            Value::from(number)
        }
    }
}
