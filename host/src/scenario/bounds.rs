//! What bounds the box, and how large is it? Reads its sides and who is to be in it; writes nothing, returns axes.

use super::gas;
use super::laws::Laws;
use super::populate::Population;
use super::problem::Problem;
use super::side::{Flow, Made, Shaking, Side, filled};
use super::sides::{MadeSpec, SideSpec, SurfaceSpec};
use super::spec::Scenario;
use carom_reference::Plate;

/// The box, its size set by a packing fraction where sides say none.
pub fn sides(
    scenario: &Scenario,
    laws: &Laws,
    populations: &[Population<'_>],
) -> Result<[Side; 3], Problem> {
    let edge = edge(scenario, populations)?;
    let mut sides = [Side::Open; 3];
    for (side, (name, spec)) in sides.iter_mut().zip(scenario.sides.named()) {
        let range = |from: Option<f64>, to: Option<f64>| match (from, to, edge) {
            (Some(from), Some(to), _) => Ok([from, to]),
            (_, _, Some(edge)) => Ok([0.0, edge]),
            _ => {
                let message = format!(
                    "box.{name}: give from and to [m], or gas.packing_fraction or box.packing_fraction"
                );
                Err(Problem { path: format!("box.{name}"), offset: None, message })
            }
        };
        let made = made(laws, spec.surface().unwrap_or_default());
        *side = match *spec {
            SideSpec::Open => Side::Open,
            SideSpec::Periodic { from, to } => Side::Periodic(range(from, to)?),
            SideSpec::Walls { from, to, amplitude, frequency, phase, .. } => {
                let shaking = Shaking { amplitude, frequency, phase };
                Side::Walls(range(from, to)?, made, (amplitude != 0.0).then_some(shaking))
            }
            SideSpec::Plate { at, amplitude, frequency, phase, .. } => {
                Side::Plate(Plate { at, amplitude, frequency, phase }, made)
            }
        };
    }
    Ok(sides)
}

/// The flow of a sheared box.
pub fn flow(scenario: &Scenario, sides: &[Side; 3]) -> Option<Flow> {
    let shear = scenario.sides.shear?;
    let [from, to] = sides[shear.gradient.number()].range()?;
    let (along, gradient) = (shear.flow.number(), shear.gradient.number());
    Some(Flow { along, gradient, rate: shear.rate, middle: 0.5 * (from + to) })
}

/// What something is made of that says this.
pub fn made(laws: &Laws, (surface, restitution, material): MadeSpec<'_>) -> Made {
    match (material, restitution) {
        (Some(name), _) => Made::Of(laws.number(Some(name)).unwrap_or(0) as u8),
        (None, Some(restitution)) => Made::Hard(restitution),
        (None, None) if surface == Some(SurfaceSpec::Hard) => Made::Hard(1.0),
        (None, None) => Made::Soft,
    }
}

/// How long the sides are that say no size, so that the packing fraction is what the scenario says.
fn edge(scenario: &Scenario, populations: &[Population<'_>]) -> Result<Option<f64>, Problem> {
    let of_gas = scenario.gas.as_ref().and_then(|gas| gas.packing_fraction);
    let (path, packing) = match (scenario.sides.packing_fraction, of_gas) {
        (Some(packing), None) => ("box.packing_fraction", packing),
        (None, Some(packing)) => ("gas.packing_fraction", packing),
        (None, None) => return Ok(None),
        (Some(_), Some(_)) => {
            let message =
                "box.packing_fraction is given, and so is gas.packing_fraction: give one of them";
            return Err(Problem {
                path: "box.packing_fraction".to_owned(),
                offset: None,
                message: message.to_owned(),
            });
        }
    };
    let d = scenario.dimension;
    let (mut sized, mut unsized_axes, mut has_plate) = (1.0, 0, false);
    for (_, spec) in &scenario.sides.named()[..d] {
        match spec {
            SideSpec::Periodic { from, to } | SideSpec::Walls { from, to, .. } => {
                match (from, to) {
                    (Some(from), Some(to)) => sized *= to - from,
                    _ => unsized_axes += 1,
                }
            }
            SideSpec::Plate { .. } => has_plate = true,
            SideSpec::Open => {}
        }
    }
    if unsized_axes == 0 && has_plate {
        return Ok(None);
    }
    if unsized_axes == 0 {
        let message =
            format!("{path} sets the size of the box: leave out from and to of a side, or it");
        return Err(Problem { path: path.to_owned(), offset: None, message });
    }
    let radii = |population: &Population<'_>| population.radii.clone();
    let mut all: Vec<f64> = populations.iter().flat_map(radii).collect();
    all.extend(scenario.gas.iter().flat_map(gas::radii));
    if path == "box.packing_fraction" {
        all.extend(scenario.grains.iter().map(|grain| grain.radius));
    }
    let volume: f64 = all.into_iter().map(|radius| filled(radius, d)).sum();
    let axes = unsized_axes + i32::from(has_plate);
    Ok(Some((volume / (packing * sized)).powf(1.0 / f64::from(axes))))
}
