//! Which facet does an error of the core mean? Reads a start; writes nothing, says it in the scenario's words.

use crate::scenario::{Problem, Start};
use anyhow::Error;
use carom::error::Subject;

/// The same error, with facets named as the scenario and its files count them.
pub fn told(why: carom::Error, start: &Start) -> Error {
    in_words(why, start).map_or_else(|| why.into(), Into::into)
}

fn in_words(why: carom::Error, start: &Start) -> Option<Problem> {
    let name = |facet: usize| start.facet(facet).map(|(_, name)| name);
    match why {
        carom::Error::Overlap { grain, with, gap, also } => {
            let first = name(with.as_facet()?)?;
            let placed = start.grains.get(grain)?;
            let at = &placed.position[..start.dimension.min(3)];
            let and = also.and_then(|also| name(also.as_facet()?));
            let and = and.map_or(String::new(), |second| {
                format!(" and, on its other side, {second}: between them is no room for it")
            });
            let message = format!(
                "grain {grain} overlaps {first}{and}; it is at {at:?} m, its gap is {gap:?} m, must be at least 0"
            );
            Some(Problem { path: format!("grain.{grain}.at"), offset: None, message })
        }
        carom::Error::Input { subject: Subject::Facet(facet), field, value, wanted } => {
            let (number, name) = start.facet(facet)?;
            let message = format!("{name}: {field} is {value}, must be {wanted}");
            Some(Problem { path: format!("obstacle.{number}"), offset: None, message })
        }
        _ => None,
    }
}
