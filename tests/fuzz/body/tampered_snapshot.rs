//! What if a snapshot was tampered with? Changes one number in it; panics unless it is refused or runs.

use super::input::Input;
use super::run::DynWorld;
use super::world::FuzzMemory;
use carom::law::Rule;
use carom::particle::Body;
use carom::world::{ScheduledEvent, Snapshot};
use carom::{Scalar, World};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

/// Steps that a tampered world may take.
const STEPS: usize = 100;

/// Saves the world as text, changes a number, and restores it.
pub fn check<S, const D: usize>(
    world: &DynWorld<'_, '_, S, D>,
    rule: &dyn Rule<S>,
    input: &mut Input<'_>,
) where
    S: Scalar + Serialize + DeserializeOwned,
{
    let Ok(mut value) = serde_json::to_value(world.save()) else { return };
    let which = usize::from(input.byte()) | usize::from(input.byte()) << 8;
    let mut numbers = Vec::new();
    collect(&mut value, &mut numbers);
    let count = numbers.len().max(1);
    if let Some(number) = numbers.into_iter().nth(which % count) {
        *number = other(input);
    }
    let Ok(saved) =
        serde_json::from_value::<Snapshot<S, D, Vec<Body<S, D>>, Vec<ScheduledEvent<S>>>>(value)
    else {
        return;
    };
    let mut memory = Box::new(FuzzMemory::<S, D>::new());
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
fn other(input: &mut Input<'_>) -> Value {
    match input.below(3) {
        0 => Value::from(input.byte()),
        1 => Value::from(u64::from_le_bytes(std::array::from_fn(|_| input.byte()))),
        _ => {
            // The tampered number says nothing of the world that goes on.
            let moderate = input.moderate;
            let number: f64 = input.number();
            input.moderate = moderate;
            Value::from(number)
        }
    }
}
