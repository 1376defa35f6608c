//! What does a look at obstacles cost? Lets a gas fly in boxes made of planes and of triangles; writes instructions.

use super::{Outcome, count};
use carom::law::HardSphere;
use carom::space::{Facet, Plane, Surface};
use carom::world::WithObstacles;
use carom::{Grain, HeapMemory, World};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::hint::black_box;

/// What is asked for on the command line.
pub const NAME: &str = "obstacles";

/// The boxes: into how many pieces each edge of the cube is cut; none is a box of planes.
const BOXES: [(&str, usize); 3] = [("planes", 0), ("triangles", 1), ("fine-triangles", 91)];

const GRAINS: usize = 1000;
/// Of the grains, in sides of the cube.
const RADIUS: f64 = 0.02;
/// The time that is counted; speeds are up to one along each axis.
const TIME: f64 = 0.2;

/// A box by its name.
pub fn named(name: &str) -> Option<usize> {
    BOXES.into_iter().find(|(known, _)| *known == name).map(|(_, pieces)| pieces)
}

/// Counts all of them.
pub fn table() -> Outcome<()> {
    let folder = tempfile::tempdir()?;
    println!("| box | facets | instructions (millions) |\n|---|---|---|");
    for (name, pieces) in BOXES {
        let instructions = count(name, folder.path())? as f64 / 1e6;
        println!("| {name} | {} | {instructions:.1} |", 12 * pieces * pieces);
    }
    Ok(())
}

/// What runs under callgrind.
pub fn run(pieces: usize) -> Outcome<()> {
    let places = HeapMemory::<f64, 3>::with_capacity(GRAINS);
    let facets = triangles(pieces);
    let lists = vec![Default::default(); 32 * facets.len()];
    let mut memory = WithObstacles::new(places, facets, lists);
    let mut builder = World::builder(&mut memory).rule(HardSphere { restitution: 1.0 });
    if pieces == 0 {
        builder = planes().into_iter().fold(builder, |builder, plane| builder.plane(plane));
    }
    let mut world = builder.grains(gas())?.start()?;
    bench_timed(&mut world)
}

/// What is counted.
#[inline(never)]
fn bench_timed(world: &mut World<'_, f64, 3, HardSphere<f64>>) -> Outcome<()> {
    world.advance_to(black_box(TIME))?;
    Ok(())
}

fn gas() -> impl Iterator<Item = Grain<f64, 3>> {
    let mut rng = Pcg64::seed_from_u64(5);
    (0..GRAINS).map(move |k| {
        let at = [k % 10, k / 10 % 10, k / 100].map(|i| 0.05 + 0.1 * i as f64);
        let velocity = std::array::from_fn(|_| rng.random_range(-1.0..1.0));
        Grain::with_mass(RADIUS, 1.0).at(at).moving(velocity)
    })
}

fn planes() -> [Plane<f64, 3>; 6] {
    std::array::from_fn(|k| {
        let (axis, upper) = (k / 2, k % 2 == 1);
        let mut normal = [0.0; 3];
        normal[axis] = if upper { -1.0 } else { 1.0 };
        Plane::new(normal, if upper { -1.0 } else { 0.0 }, Surface::Rule)
    })
}

/// The sides of the cube, each of twice as many triangles as its edges' pieces squared.
fn triangles(pieces: usize) -> Vec<Facet<f64, 3>> {
    let mut all = Vec::new();
    for (side, i, j) in
        (0..6 * pieces * pieces).map(|k| (k / (pieces * pieces), k / pieces % pieces, k % pieces))
    {
        let corner = |a: usize, b: usize| {
            let mut corner = [(side % 2) as f64; 3];
            corner[(side / 2 + 1) % 3] = a as f64 / pieces as f64;
            corner[(side / 2 + 2) % 3] = b as f64 / pieces as f64;
            corner
        };
        let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
        all.extend([[a, b, c], [a, c, d]].map(|corners| Facet::new(corners, Surface::Rule)));
    }
    all
}
