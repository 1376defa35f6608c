//! Is a restored world of rough grains the same world? Through JSON, in memory of one's own; compares digests.

use crate::pair::{random, rough, seeded, spheres};
use carom::law::Tangential;
use carom::particle::Body;
use carom::space::ContactState;
use carom::world::{SavedRotation, ScheduledEvent, Snapshot};
use carom::{Grain, World};

type Saved = Snapshot<
    f64,
    3,
    Vec<Body<f64, 3>>,
    Vec<ScheduledEvent<f64>>,
    SavedRotation<Vec<f64>, Vec<ContactState<f64>>>,
>;
type Smooth = Snapshot<f64, 3, Vec<Body<f64, 3>>, Vec<ScheduledEvent<f64>>>;

#[test]
fn a_snapshot_of_rough_grains_goes_on_with_the_same_bits() {
    let mut rng = seeded(4);
    let rule = rough(0.9, Tangential::Walton { mu: 0.3, beta_0: 0.4 });
    let mut memory = spheres((0..27).map(|_| random(&mut rng, 1.0)).collect());
    let grains = (0..27).map(|k: i32| {
        let at = [k % 3, k / 3 % 3, k / 9].map(|x| 1.5 * f64::from(x) + 0.75);
        Grain::with_mass(0.5, 1.0).at(at).moving(random(&mut rng, 1.0))
    });
    let mut world = World::builder(&mut memory)
        .periodic([[0.0, 4.5]; 3])
        .rule(rule)
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(1.0).unwrap();
    let text = serde_json::to_string(&world.save()).unwrap();
    let saved: Saved = serde_json::from_str(&text).unwrap();
    let mut memory = spheres(vec![[0.0; 3]; 27]);
    let mut again = World::restore(&mut memory, rule, &saved).unwrap();
    assert_eq!(world.digest(), again.digest());
    world.set_angular_velocity(0, [0.0; 3]).unwrap();
    assert_ne!(world.digest(), again.digest());
    again.set_angular_velocity(0, [0.0; 3]).unwrap();
    for world in [&mut world, &mut again] {
        world.advance_to(5.0).unwrap();
    }
    assert_eq!(world.digest(), again.digest());
    assert!(serde_json::from_str::<Smooth>(&text).is_err());
    let smooth = saved.clone().kept_in(saved.arrays().0.clone(), saved.arrays().1.clone());
    let mut memory = spheres(vec![[0.0; 3]; 27]);
    let refused = World::restore(&mut memory, rule, &smooth).err().unwrap();
    assert!(refused.to_string().contains("angular velocities"), "{refused}");
}

#[test]
fn only_grains_that_rotate_have_angular_velocities() {
    let mut memory = spheres(vec![[0.0; 3]]);
    let mut world = World::builder(&mut memory)
        .rule(rough(0.9, Tangential::Constant { beta: 0.5 }))
        .grain(Grain::with_mass(0.5, 1.0))
        .unwrap()
        .start()
        .unwrap();
    assert!(world.set_angular_velocity(1, [0.0; 3]).is_err());
    assert!(world.set_angular_velocity(0, [f64::INFINITY, 0.0, 0.0]).is_err());
    world.set_angular_velocity(0, [1.0, 2.0, 3.0]).unwrap();
    assert_eq!(world.view().angular_velocity(0), Some([1.0, 2.0, 3.0]));
    assert_eq!(world.view().rotational_energy(0.4), 0.5 * 0.4 * 0.25 * 14.0);
}
