//! Does a restored world have the same future? Draws worlds with floors, plates, rest and open sides; compares digests.

use crate::gas::gas;
use carom::law::HardSphere;
use carom::particle::Body;
use carom::space::{Plane, Surface, Vibration};
use carom::world::{ScheduledEvent, Snapshot};
use carom::{Enduring, Error, HeapMemory, Scalar, World};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::Serialize;
use serde::de::DeserializeOwned;

type Saved<S, const D: usize> = Snapshot<S, D, Vec<Body<S, D>>, Vec<ScheduledEvent<S>>>;

const LENGTH: f64 = 4.1;

/// A floor, at rest or vibrating, perhaps with side walls, under a gravity that is not quite upright.
fn planes<S: Scalar, const D: usize>(rng: &mut Pcg64Mcg) -> (Vec<Plane<S, D>>, [S; D]) {
    let up = D - 1;
    let along = |axis: usize, sign: f64| {
        std::array::from_fn(|a| S::from_f64(if a == axis { sign } else { 0.0 }))
    };
    let surface = Surface::Hard(S::from_f64(rng.random_range(0.2..0.9)));
    let mut floor = Plane::new(along(up, 1.0), S::zero(), surface);
    if rng.random_bool(0.3) {
        floor = floor.vibrating(Vibration::new(S::from_f64(0.05), S::from_f64(3.0)));
    }
    let mut planes = vec![floor];
    if rng.random_bool(0.7) {
        for axis in 0..up {
            planes.push(Plane::new(along(axis, 1.0), S::zero(), surface));
            planes.push(Plane::new(along(axis, -1.0), S::from_f64(-LENGTH), surface));
        }
    }
    let aside = rng.random_range(-0.5..0.5);
    let g = |a: usize| {
        if a == up {
            -9.81
        } else if a == 0 {
            aside
        } else {
            0.0
        }
    };
    (planes, std::array::from_fn(|a| S::from_f64(g(a))))
}

/// Saves the world, goes on with both, and compares; false if nothing is left to happen.
fn goes_on<S: Scalar + Serialize + DeserializeOwned, const D: usize>(
    world: &mut World<'_, S, D, HardSphere<S>>,
    rule: HardSphere<S>,
    what: &str,
) -> Result<bool, Error>
where
    Saved<S, D>: DeserializeOwned,
{
    let text = serde_json::to_string(&world.save()).unwrap();
    let saved: Saved<S, D> = serde_json::from_str(&text).unwrap();
    let mut memory = HeapMemory::with_capacity(world.view().len());
    let mut again = World::restore(&mut memory, rule, &saved).expect(what);
    for _ in 0..40 {
        let (here, there) = (world.step(), again.step());
        assert_eq!(here, there, "{what}");
        assert_eq!(world.digest(), again.digest(), "{what}");
        if here?.is_none() {
            return Ok(false);
        }
    }
    Ok(true)
}

fn drawn<S: Scalar + Serialize + DeserializeOwned, const D: usize>(seed: u64, enduring: Enduring)
where
    Saved<S, D>: DeserializeOwned,
{
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let (planes, gravity) = planes::<S, D>(&mut rng);
    let n = rng.random_range(3..12);
    let radius = if D == 1 { [0.05, 0.15] } else { [0.15, 0.35] };
    let rule = HardSphere { restitution: S::from_f64(rng.random_range(0.2..0.95)) };
    let mut storage = HeapMemory::with_capacity(n);
    let mut builder = World::builder(&mut storage).enduring(enduring).gravity(gravity).rule(rule);
    for plane in planes {
        builder = builder.plane(plane);
    }
    let mut world = builder.grains(gas::<S, D>(n, seed, LENGTH, radius)).unwrap().start().unwrap();
    let what = format!("{} {D}D, seed {seed}, {enduring:?}", core::any::type_name::<S>());
    for _ in 0..30 {
        // A heap that jams is another matter.
        match goes_on(&mut world, rule, &what) {
            Ok(true) => {}
            Ok(false) | Err(Error::Stuck { .. }) => return,
            Err(error) => panic!("{what}: {error}"),
        }
    }
}

/// Restoring changes the order in which neighbours are visited, and nothing else.
#[test]
fn every_snapshot_is_taken_back_and_goes_on_with_the_same_bits() {
    for enduring in [Enduring::Paper, Enduring::Integrated] {
        for seed in 0..25 {
            drawn::<f64, 1>(seed, enduring);
            drawn::<f32, 1>(seed, enduring);
            drawn::<f64, 2>(seed, enduring);
            drawn::<f32, 2>(seed, enduring);
            drawn::<f64, 3>(seed, enduring);
            drawn::<f32, 3>(seed, enduring);
        }
    }
}
