//! Does README's hourglass run down, and back when it is turned over?

use carom::law::HardSphere;
use carom::space::{Surface, polygon};
use carom::world::{Motion, WithObstacles};
use carom::{Grain, Memory, World};

#[test]
fn an_hourglass_runs_down_and_back() {
    let glass = [
        [-9, 24],
        [9, 24],
        [9, 10],
        [2, 0],
        [9, -10],
        [9, -24],
        [-9, -24],
        [-9, -10],
        [-2, 0],
        [-9, 10],
    ];
    let glass =
        polygon(glass.map(|corner| corner.map(|mm| 1.0e-3 * f64::from(mm))), Surface::Hard(0.5));
    let mut memory =
        WithObstacles::new(Memory::<f64, 2, 64>::new(), glass, [Default::default(); 256]);
    let sand = |k: u32| [1.6e-3 * f64::from(k % 8) - 5.6e-3, 1.6e-3 * f64::from(k / 8) + 11.0e-3];
    let mut world = World::builder(&mut memory)
        .gravity([0.0, -9.81])
        .rule(HardSphere { restitution: 0.5 })
        .grains((0..64).map(|k| Grain::sphere(0.5e-3, 2500.0).at(sand(k))))
        .unwrap()
        .start()
        .unwrap();
    let below = |world: &World<'_, f64, 2, HardSphere<f64>>| {
        (0..64).filter(|&k| world.grain(k).unwrap().position.y < 0.0).count()
    };
    world.advance_to(0.5).unwrap();
    assert_eq!(below(&world), 64);
    world.set_gravity([0.0, 9.81]).unwrap();
    world.advance_to(1.0).unwrap();
    assert_eq!(below(&world), 0);
    // Who lies at last lies still, and nobody is outside.
    world.advance_to(1.5).unwrap();
    assert!((0..64).all(|k| world.view().motion(k) == Some(Motion::Rest)));
    assert!((0..64).all(|k| {
        let [x, y]: [f64; 2] = world.grain(k).unwrap().position.into();
        x.abs() < 9.0e-3 && y < 24.0e-3
    }));
}
