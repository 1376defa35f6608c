//! Which obstacles do these bytes describe? Reads bytes; writes nothing, panics if a grain among them does what it must not.
//!
//! A closed room with facets of any kind in it: with tiny angles, without area, with shared corners and nearly shared ones;
//! grains anywhere, on corners and along edges too.

use super::input::Input;
use carom::law::embedded::standard;
use carom::law::{HardSphere, LinearDashpot, Outside, Rule, Soft};
use carom::particle::Index;
use carom::space::{Facet, Surface};
use carom::world::WithObstacles;
use carom::{Error, Grain, HeapMemory, Scalar, World};

/// The room is a square or a cube from −SIDE to SIDE.
const SIDE: f64 = 4.0;
/// Events of one input.
const STEPS: usize = 400;

/// Builds a world among obstacles, steps it, and checks what must hold.
///
/// # Errors
/// The error with which the world refused or stopped.
pub fn run(bytes: &[u8]) -> Result<(), Error> {
    let mut input = Input::new(bytes);
    match input.below(4) {
        0 => run_as::<f64, 2>(&mut input),
        1 => run_as::<f64, 3>(&mut input),
        2 => run_as::<f32, 2>(&mut input),
        _ => run_as::<f32, 3>(&mut input),
    }
}

fn run_as<S: Scalar, const D: usize>(input: &mut Input<'_>) -> Result<(), Error> {
    let scene = Scene::<S, D>::new(input);
    match input.below(3) {
        0 => scene.run(HardSphere { restitution: input.fraction() }, input),
        1 => scene.run(HardSphere { restitution: S::one() }, input),
        _ => {
            let law = LinearDashpot { stiffness: S::from_f64(1e4), damping: input.fraction() };
            scene.run(Soft::with_table(law, &standard::LINEAR_DASHPOT, Outside::HardSphere), input)
        }
    }
}

/// Facets, grains and gravity.
struct Scene<S: Scalar, const D: usize> {
    facets: Vec<Facet<S, D>>,
    grains: Vec<Grain<S, D>>,
    gravity: [S; D],
    places: usize,
}

type Point<S, const D: usize> = [S; D];

impl<S: Scalar, const D: usize> Scene<S, D> {
    fn new(input: &mut Input<'_>) -> Self {
        let mut facets = room();
        let mut corners: Vec<Point<S, D>> = Vec::new();
        for _ in 0..2 + input.below(8) {
            let corner = corner(input, &corners);
            corners.push(corner);
        }
        for _ in 0..input.below(12) {
            let surface = surface(input);
            let which: [usize; D] = std::array::from_fn(|_| usize::from(input.byte()));
            facets.push(Facet::new(which.map(|k| corners[k % corners.len()]), surface));
        }
        let grains = (0..=input.below(6)).map(|_| grain(input, &corners)).collect();
        let is_falling = input.below(2) == 0;
        let gravity = std::array::from_fn(|axis| {
            S::from_f64(if is_falling && axis == 1 { -8.0 } else { 0.0 })
        });
        let places = facets.len() * usize::from(1 + input.below(32)) + 2;
        Self { facets, grains, gravity, places }
    }

    fn run<R: Rule<S>>(&self, rule: R, input: &mut Input<'_>) -> Result<(), Error> {
        let lists = vec![Index::default(); self.places];
        let memory = HeapMemory::<S, D>::with_capacity(self.grains.len());
        let mut memory = WithObstacles::new(memory, &self.facets[..], lists);
        let grains = self.grains.iter().copied();
        let mut world =
            World::builder(&mut memory).gravity(self.gravity).rule(rule).grains(grains)?.start()?;
        let energy = world.view().kinetic_energy().to_f64();
        for _ in 0..STEPS {
            let before = world.now();
            let Some(event) = world.step()? else { break };
            assert!(event.at >= before && world.now() >= before, "time went back to {}", event.at);
            self.check(&world, energy, input);
        }
        Ok(())
    }

    /// Numbers are numbers, nobody is outside, and nobody has passed through a facet.
    fn check<R: Rule<S>>(&self, world: &World<'_, S, D, R>, energy: f64, input: &Input<'_>) {
        if !input.moderate {
            return;
        }
        let forces = self.gravity != [S::zero(); D] || world.statistics().steps > 0;
        for k in 0..self.grains.len() {
            let grain = world.grain(k).expect("it was not removed");
            let numbers = grain.position.iter().chain(grain.velocity.iter());
            assert!(numbers.clone().all(|x| x.is_finite()), "grain {k} is at {:?}", grain.position);
            if world.statistics().crushed > 0 {
                continue;
            }
            for x in grain.position.iter() {
                assert!(x.to_f64().abs() < SIDE, "grain {k} is outside, at {:?}", grain.position);
            }
            // Forces press grains in; free ones reach no further than their rounding.
            let least = if forces { 0.0 } else { 0.99 * grain.radius.to_f64() };
            for (number, facet) in self.facets.iter().enumerate() {
                let apart = distance(facet, &grain.position.map(|x| x.to_f64()).into());
                assert!(apart >= least, "grain {k} is {apart} from facet {number}");
            }
        }
        let now = world.view().kinetic_energy().to_f64();
        assert!(forces || now <= energy * (1.0 + 1e-3), "energy rose from {energy} to {now}");
    }
}

/// The sides of the room.
fn room<S: Scalar, const D: usize>() -> Vec<Facet<S, D>> {
    let at = |bits: usize| -> Point<S, D> {
        std::array::from_fn(|axis| S::from_f64(if bits >> axis & 1 == 1 { SIDE } else { -SIDE }))
    };
    let mut facets = Vec::new();
    for axis in 0..D {
        let others: Vec<usize> = (0..D).filter(|other| *other != axis).map(|k| 1 << k).collect();
        for side in [0, 1 << axis] {
            let square: Vec<usize> = match others[..] {
                [a, b] => vec![side, side | a, side | a | b, side | b],
                _ => vec![side, side | others[0]],
            };
            for first in (1..square.len()).take(D - 1).filter(|k| D == 2 || k + 1 < square.len()) {
                let corners = |k: usize| at(square[if k == 0 { 0 } else { first + k - 1 }]);
                facets.push(Facet::new(std::array::from_fn(corners), Surface::Rule));
            }
        }
    }
    facets
}

/// In eighths within the room; the same as another one, or nearly; sometimes anything.
fn corner<S: Scalar, const D: usize>(input: &mut Input<'_>, known: &[Point<S, D>]) -> Point<S, D> {
    let kind = input.below(16);
    if kind == 15 {
        return std::array::from_fn(|_| input.number());
    }
    let near = known.get(usize::from(input.byte()) % known.len().max(1)).filter(|_| kind > 10);
    std::array::from_fn(|axis| match near {
        Some(corner) => {
            let off = [0.0, 1e-12, 1e-7, -1e-7, 1e-3][usize::from(input.below(5))];
            corner[axis] + S::from_f64(off)
        }
        None => S::from_f64(f64::from(input.byte() as i8) / 40.0),
    })
}

fn surface<S: Scalar>(input: &mut Input<'_>) -> Surface<S> {
    match input.below(4) {
        0 => Surface::Hard(input.fraction()),
        1 => Surface::Hard(S::one()),
        _ => Surface::Rule,
    }
}

/// Anywhere, or as far from a corner as it is wide.
fn grain<S: Scalar, const D: usize>(input: &mut Input<'_>, corners: &[Point<S, D>]) -> Grain<S, D> {
    let radius = 0.05 + f64::from(input.byte()) / 512.0;
    let on_corner = input.below(4) == 0;
    let axis = usize::from(input.byte()) % D;
    let corner = corners[usize::from(input.byte()) % corners.len()];
    let is_inside = corner.iter().all(|x| x.to_f64().abs() < SIDE - 2.0 * radius);
    let at = std::array::from_fn(|k| {
        if on_corner && is_inside {
            let off = if k == axis { radius } else { 0.0 };
            return corner[k] + S::from_f64(off);
        }
        S::from_f64(f64::from(input.byte() as i8) / 40.0)
    });
    let moving = std::array::from_fn(|_| S::from_f64(f64::from(input.byte() as i8) / 16.0));
    Grain::with_mass(S::from_f64(radius), S::one()).at(at).moving(moving)
}

/// From a position to a facet.
fn distance<S: Scalar, const D: usize>(facet: &Facet<S, D>, position: &[f64; D]) -> f64 {
    let corners = facet.corners().map(|corner| {
        let numbers: [f64; D] = std::array::from_fn(|axis| corner[axis].to_f64());
        numbers
    });
    let less = |a: &[f64; D], b: &[f64; D]| -> [f64; D] { std::array::from_fn(|k| a[k] - b[k]) };
    let dot = |a: &[f64; D], b: &[f64; D]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
    let segment = |a: &[f64; D], b: &[f64; D]| {
        let (along, to) = (less(b, a), less(position, a));
        let part = (dot(&to, &along) / dot(&along, &along)).clamp(0.0, 1.0);
        let apart: [f64; D] = std::array::from_fn(|k| to[k] - part * along[k]);
        dot(&apart, &apart).sqrt()
    };
    let edges = (0..D).map(|k| segment(&corners[k], &corners[(k + 1) % D]));
    let edges = edges.fold(f64::INFINITY, f64::min);
    if D < 3 {
        return edges;
    }
    // Barycentric coordinates of the foot.
    let (u, v, w) = (
        less(&corners[1], &corners[0]),
        less(&corners[2], &corners[0]),
        less(position, &corners[0]),
    );
    let (uu, uv, vv, wu, wv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v), dot(&w, &u), dot(&w, &v));
    let area = uu * vv - uv * uv;
    let (s, t) = ((vv * wu - uv * wv) / area, (uu * wv - uv * wu) / area);
    if !(s >= 0.0 && t >= 0.0 && s + t <= 1.0) {
        return edges;
    }
    let apart: [f64; D] = std::array::from_fn(|k| w[k] - s * u[k] - t * v[k]);
    dot(&apart, &apart).sqrt().min(edges)
}
