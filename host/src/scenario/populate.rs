//! Where do the grains of all species go, and how fast are they? Reads species and box; writes grains.

use super::arrange::arrange;
use super::clear::Obstacles;
use super::fill::{self, Crowd};
use super::frames::{self, Told};
use super::grains::{PlaceSpec, SpeciesSpec};
use super::problem::{Problem, named};
use super::radii;
use super::region::Region;
use super::side::{Placed, Side, filled, sphere_mass};
use super::spec::Scenario;
use super::{memory, thermal};
use rand::SeedableRng;
use rand_pcg::Pcg64;
use std::path::Path;

/// A species with the radii of its grains.
pub struct Population<'s> {
    /// Which one it is.
    pub number: usize,
    /// What the scenario says.
    pub spec: &'s SpeciesSpec,
    /// Largest first, or as the file has them; empty as long as a packing fraction stands for the
    /// number of grains.
    pub radii: Vec<f64>,
    /// What a file says of each.
    pub told: Vec<Told>,
    /// What it is made of.
    pub density: f64,
}

/// Random numbers for a purpose of a species, the same whatever the others draw.
fn generator(scenario: &Scenario, number: usize, purpose: u64) -> Pcg64 {
    let stream = 4 * number as u64 + purpose;
    Pcg64::seed_from_u64(scenario.seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(stream))
}

/// The species with radii as far as their number is known.
///
/// # Errors
/// When a file cannot be read.
pub fn populations<'s>(
    scenario: &'s Scenario,
    densities: &[f64],
) -> Result<Vec<Population<'s>>, Problem> {
    let species = scenario.species.iter().zip(densities).enumerate();
    species
        .map(|(number, (spec, &density))| {
            let mut rng = generator(scenario, number, 0);
            if let PlaceSpec::File { path, frame, only } = &spec.place {
                let file = scenario.folder.join(path);
                return of_file(
                    (number, spec, density),
                    (&file, *frame, only.as_deref()),
                    &mut rng,
                )
                .map_err(|problem| at(&format!("species.{number}.place"), &problem.message));
            }
            let radius = spec.radius.iter();
            let mut radii: Vec<f64> = radius
                .flat_map(|radius| radii::draw(radius, spec.count.unwrap_or(0), &mut rng))
                .collect();
            radii.sort_by(|a, b| b.total_cmp(a));
            Ok(Population { number, spec, radii, told: Vec::new(), density })
        })
        .collect()
}

fn at(path: &str, message: &str) -> Problem {
    let message = format!("{}: {message}", named(path));
    Problem { path: path.to_owned(), offset: None, message }
}

fn of_file<'s>(
    (number, spec, density): (usize, &'s SpeciesSpec, f64),
    (file, frame, only): (&Path, Option<usize>, Option<&str>),
    rng: &mut Pcg64,
) -> Result<Population<'s>, Problem> {
    let mut told = frames::read(file, frame)?;
    // Files of other kinds than CSV have no blanks in names.
    let without_blanks = |name: &str| name.split_whitespace().collect::<Vec<_>>().join("-");
    told.retain(|one| {
        only.is_none_or(|only| {
            let of = one.species.as_deref();
            of == Some(only) || of == Some(&without_blanks(only))
        })
    });
    let no = |what: &str| Problem {
        path: String::new(),
        offset: None,
        message: format!("{}: {what}", file.display()),
    };
    if told.is_empty() {
        return Err(no("there is no grain"));
    }
    let mut radii = Vec::new();
    for (k, one) in told.iter().enumerate() {
        let own = spec.radius.as_ref().map(|radius| radii::one(radius, k, rng));
        let radius = own.or(one.radius).filter(|radius| *radius > 0.0);
        radii.push(radius.ok_or_else(|| no("it says no radius above 0, and the species none"))?);
        if one.mass.is_none_or(|mass| !(mass > 0.0)) && !(density > 0.0) {
            return Err(no("it says no mass above 0, and the species has no density"));
        }
    }
    Ok(Population { number, spec, radii, told, density })
}

/// Adds the grains of all species to those that are there, and says which species each is of.
///
/// # Errors
/// When they cannot be placed.
pub fn place(
    scenario: &Scenario,
    among: (&[Side; 3], &Obstacles),
    populations: &mut [Population<'_>],
    grains: &mut Vec<Placed>,
) -> Result<Vec<usize>, Problem> {
    let mut of_species = Vec::new();
    let mut begin = 0;
    while begin < populations.len() {
        let place = &populations[begin].spec.place;
        let alike = populations[begin..].iter().take_while(|p| p.spec.place == *place).count();
        let is_file = matches!(place, PlaceSpec::File { .. });
        let end = begin + if is_file { 1 } else { alike };
        let group = &mut populations[begin..end];
        of_species.extend(match is_file {
            true => as_told(scenario, &group[0], grains),
            false => place_together(scenario, among, group, grains)?,
        });
        begin = end;
    }
    Ok(of_species)
}

/// Places the grains of a file, as fast as it says if the species says nothing else.
fn as_told(
    scenario: &Scenario,
    population: &Population<'_>,
    grains: &mut Vec<Placed>,
) -> Vec<usize> {
    let first = grains.len();
    for (one, &radius) in population.told.iter().zip(&population.radii) {
        let mass = one.mass.unwrap_or_else(|| sphere_mass(radius, population.density));
        let velocity = one.velocity.unwrap_or_default();
        grains.push(Placed { radius, mass, position: one.position, velocity });
    }
    let mut rng = generator(scenario, population.number, 2);
    thermal::set(population.spec, scenario.dimension, &mut grains[first..], &mut rng);
    for grain in &mut grains[first..] {
        grain.position[scenario.dimension..].fill(0.0);
        grain.velocity[scenario.dimension..].fill(0.0);
    }
    vec![population.number; population.told.len()]
}

/// Places the species of one placement, mixed.
fn place_together(
    scenario: &Scenario,
    (sides, obstacles): (&[Side; 3], &Obstacles),
    group: &mut [Population<'_>],
    grains: &mut Vec<Placed>,
) -> Result<Vec<usize>, Problem> {
    let dimension = scenario.dimension;
    let path = format!("species.{}", group[0].number);
    let spec: &PlaceSpec = &group[0].spec.place;
    let known = group.iter().flat_map(|p| &p.radii).map(|r| filled(*r, dimension)).sum();
    let region = Region::new((&path, spec), dimension, sides, (known, None))?;
    for population in group.iter_mut() {
        if let Some(packing) = population.spec.packing_fraction {
            let mut rng = generator(scenario, population.number, 0);
            population.radii =
                fill_up(population.spec, packing * region.volume(), dimension, &mut rng).map_err(
                    |why| {
                        let path = format!("species.{}.packing_fraction", population.number);
                        let message = format!("species {}: count {why}", population.number);
                        Problem { path, offset: None, message }
                    },
                )?;
        }
    }
    let mut order: Vec<(f64, usize)> = Vec::new();
    for (k, population) in group.iter().enumerate() {
        order.extend(population.radii.iter().map(|radius| (*radius, k)));
    }
    order.sort_by(|a, b| b.0.total_cmp(&a.0));
    let radii: Vec<f64> = order.iter().map(|(radius, _)| *radius).collect();
    let others = &grains[..];
    let crowd = Crowd { path: &path, region, sides, obstacles, radii: &radii, others };
    let mut rng = generator(scenario, group[0].number, 1);
    let gravity = std::array::from_fn(|k| scenario.gravity.get(k).copied().unwrap_or(0.0));
    let positions = match spec {
        PlaceSpec::Fill { .. } => fill::fill(&crowd, &mut rng)?,
        _ => arrange(&crowd, spec, &gravity, &mut rng)?,
    };
    let mut of_species = Vec::new();
    for (k, population) in group.iter().enumerate() {
        let first = grains.len();
        let own = order.iter().zip(&positions).filter(|((_, kind), _)| *kind == k);
        grains.extend(own.map(|(&(radius, _), &position)| Placed {
            radius,
            mass: sphere_mass(radius, population.density),
            position,
            velocity: [0.0; 3],
        }));
        let mut rng = generator(scenario, population.number, 2);
        thermal::set(population.spec, dimension, &mut grains[first..], &mut rng);
        of_species.extend(std::iter::repeat_n(population.number, grains.len() - first));
    }
    Ok(of_species)
}

/// As many radii as come nearest to filling this much, largest first.
fn fill_up(
    spec: &SpeciesSpec,
    wanted: f64,
    dimension: usize,
    rng: &mut Pcg64,
) -> Result<Vec<f64>, String> {
    let Some(radius) = &spec.radius else { return Ok(Vec::new()) };
    let (mut radii, mut sum) = (Vec::new(), 0.0);
    loop {
        let next = radii::one(radius, radii.len(), rng);
        let more = filled(next, dimension);
        if sum + 0.5 * more > wanted {
            break;
        }
        // As many as there will be if they are all like this one, before memory is taken for them.
        if radii.is_empty() || radii.len().is_power_of_two() {
            let whole = (wanted / more).min(1e18) as usize;
            memory::refusal(whole.max(radii.len()), dimension).map_or(Ok(()), Err)?;
        }
        sum += more;
        radii.push(next);
    }
    if radii.is_empty() {
        return Err("would be 0: the packing fraction is too small for one grain".to_owned());
    }
    radii.sort_by(|a, b| b.total_cmp(a));
    Ok(radii)
}
