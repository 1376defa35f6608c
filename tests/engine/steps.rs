//! Is the step of clustered grains short enough, whoever joins them? Reads starts at rest, bullets, own rules and long contacts; compares with closed forms.

use carom::law::{Answer, HardSphere, Impact, LinearDashpot, Outside, Rule, Soft, Viscoelastic};
use carom::space::{Plane, Surface};
use carom::world::Motion;
use carom::{Error, Grain, Memory, World};

/// ρ of MP13, below Eq. (51), for a sphere of radius 1 on a plane.
const RHO: f64 = 2.0 / 3.0 * RUBBER.young / (1.0 - RUBBER.poisson * RUBBER.poisson);
const RUBBER: Viscoelastic<f64> = Viscoelastic { young: 1.0e5, poisson: 0.4, dissipation: 0.0 };

/// A grain that is let go on a soft floor sinks in until ρ x^{5/2}·2/5 = m g x, and comes back.
#[test]
fn who_starts_at_rest_sinks_as_deep_as_its_energy_says() {
    let mut memory = Memory::<f64, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([1.0], 0.0, Surface::Rule))
        .gravity([-1.0])
        .rule(Soft::viscoelastic(RUBBER, Outside::HardSphere))
        .grain(Grain::with_mass(1.0, 1.0).at([1.0]))
        .unwrap()
        .start()
        .unwrap();
    let deepest = (2.5 / RHO).powf(2.0 / 3.0);
    let mut most = 0.0_f64;
    for k in 1..2_000 {
        world.advance_to(1e-3 * f64::from(k)).unwrap();
        most = most.max(1.0 - world.grain(0).unwrap().position[0]);
    }
    assert!((most / deepest - 1.0).abs() < 1e-2, "{most:e} for {deepest:e}");
}

/// A bullet hits grains that have hardly moved: the step under way was chosen for them, and is cut for it.
#[test]
fn a_bullet_is_stopped_by_grains_at_rest() {
    for speed in [10.0, 100.0, 1000.0] {
        let mut memory = Memory::<f64, 1, 3>::new();
        let mut world = World::builder(&mut memory)
            .plane(Plane::new([1.0], 0.0, Surface::Rule))
            .gravity([-1.0])
            .rule(Soft::viscoelastic(Viscoelastic { young: 1e9, ..RUBBER }, Outside::HardSphere))
            .grains([1.0, 3.0].map(|x| Grain::with_mass(1.0, 1.0).at([x])))
            .unwrap()
            .grain(Grain::with_mass(1.0, 1.0).at([5.0 + 0.3 * speed]).moving([-speed]))
            .unwrap()
            .start()
            .unwrap();
        let energy = |world: &World<'_, f64, 1, _>| {
            (0..3).filter_map(|i| world.grain(i)).fold(0.0, |sum, grain| {
                sum + grain.mass * (0.5 * grain.velocity[0].powi(2) + grain.position[0])
            })
        };
        let start = energy(&world);
        world.advance_to(0.29).unwrap();
        assert_eq!(world.view().motion(0), Some(Motion::Cluster));
        let mut checked = 0;
        for k in 0..400 {
            world.advance_to(0.31 + 1e-3 * f64::from(k)).unwrap();
            let order: Vec<_> = (0..3).map(|i| world.grain(i).unwrap().position[0]).collect();
            assert!(order.is_sorted(), "{speed}: {order:?}");
            // Where all fly, all energy is kinetic.
            let flies = |i| world.view().motion(i) == Some(Motion::Flight);
            if (0..3).all(flies) {
                let change = energy(&world) / start - 1.0;
                assert!(change.abs() < 1e-4, "{speed}: {change:e}");
                checked += 1;
            }
        }
        assert!(checked > 0, "{speed}");
    }
}

/// A rule of the user's own that knows how long contacts last, but no force.
#[derive(Clone, Copy)]
struct WithoutForce(Soft<LinearDashpot<f64>>);

impl Rule<f64> for WithoutForce {
    fn collide(&self, impact: &Impact<f64>) -> Answer<f64> {
        self.0.collide(impact)
    }
}

/// Its slow contacts are the stand-in's, its fast ones in a crowd happen at once: a heap of it sleeps.
#[test]
fn a_heap_of_a_rule_without_force_law_sleeps() {
    let law = LinearDashpot { stiffness: 1e4, damping: 20.0 };
    let mut memory = Memory::<f64, 2, 10>::new();
    let mut world = World::builder(&mut memory)
        .walls([[0.0, 8.0], [0.0, 40.0]])
        .gravity([0.0, -1.0])
        .rule(WithoutForce(Soft::linear_dashpot(law, Outside::HardSphere)))
        .grains((0..10).map(|i| {
            let (x, y) = (1.1 + 2.5 * f64::from(i % 3), 1.5 + 2.2 * f64::from(i / 3));
            Grain::with_mass(1.0, 1.0).at([x, y]).moving([0.3 * f64::from(i).sin(), 0.0])
        }))
        .unwrap()
        .start()
        .unwrap();
    for _ in 0..1_000_000 {
        if world.step().unwrap().is_none() {
            break;
        }
        assert!(world.now().as_f64() < 400.0, "awake");
    }
    assert_eq!(world.next_event_time(), None);
    assert!((0..10).all(|i| world.view().motion(i) == Some(Motion::Rest)));
}

/// x = g (t/π)² must not be more than R/20: from the start, and when gravity grows.
#[test]
fn a_contact_time_that_lets_grains_sink_in_is_refused_with_both_numbers() {
    let longest = std::f64::consts::PI * (0.05_f64 * 0.5 / 9.81).sqrt();
    let start = |time: f64, gravity: f64| {
        let mut memory = Memory::<f64, 1, 1>::new();
        let mut world = World::builder(&mut memory)
            .contact_time(time)
            .gravity([-9.81])
            .rule(HardSphere { restitution: 0.5 })
            .grain(Grain::with_mass(0.5, 1.0))?
            .start()?;
        world.set_gravity([-gravity])
    };
    assert_eq!(start(0.999 * longest, 9.81), Ok(()));
    for (time, gravity, sinks) in [(2.0 * longest, 9.81, 0.2), (0.9 * longest, 19.62, 0.081)] {
        let error = start(time, gravity).unwrap_err();
        let Error::LongContact { contact_time, overlap, .. } = error else { panic!("{error}") };
        assert_eq!(contact_time, time);
        assert!((overlap - sinks).abs() < 1e-12, "{overlap}");
        let text = error.to_string();
        assert!(text.contains(&time.to_string()) && text.contains(&overlap.to_string()), "{text}");
    }
    for time in [0.0, -1.0, f64::NAN] {
        let Err(Error::Input { field, .. }) = start(time, 9.81) else { panic!("{time}") };
        assert_eq!(field, "contact time");
    }
}

/// A light and fast grain hits a pair in the middle of a deep contact: it comes from too far away for the pair to
/// have expected it. In whatever direction and whenever it comes, all energy is there when all fly again.
#[test]
fn who_breaks_off_a_contact_gains_nothing() {
    let law = LinearDashpot { stiffness: 1e4, damping: 0.0 };
    // The contact of the two lasts π √(m/2k).
    let contact = std::f64::consts::PI * (0.5_f64 / 1e4).sqrt();
    let (mut worst, mut broken) = (0.0_f64, 0);
    for radius in [0.15, 0.5] {
        for speed in [20.0, 60.0] {
            for k in 0..160 {
                let (angle, part) =
                    (f64::from(k % 16) * 0.4 + 0.01, f64::from(k / 16) * 0.1 + 0.03);
                let far = 1.5 + radius + (0.2 + part * contact) * speed;
                let direction = [angle.cos(), angle.sin()];
                let mut memory = Memory::<f64, 2, 3>::new();
                let mut world = World::builder(&mut memory)
                    .rule(Soft::linear_dashpot(law, Outside::HardSphere))
                    .grains([
                        Grain::with_mass(1.0, 1.0).at([1.6, 0.0]).moving([-3.0, 0.1]),
                        Grain::with_mass(1.0, 1.0).at([-1.6, 0.0]).moving([3.0, -0.1]),
                        Grain::with_mass(radius, 0.02)
                            .at(direction.map(|d| d * far))
                            .moving(direction.map(|d| -d * speed)),
                    ])
                    .unwrap()
                    .start()
                    .unwrap();
                let energy = |world: &World<'_, f64, 2, _>| {
                    let of = |g: Grain<f64, 2>| {
                        0.5 * g.mass * g.velocity.iter().map(|v| v * v).sum::<f64>()
                    };
                    (0..3).filter_map(|i| world.grain(i)).map(of).sum::<f64>()
                };
                let start = energy(&world);
                world.advance_to(2.0).unwrap();
                broken += i32::from(world.statistics().joins > 0);
                assert!((0..3).all(|i| world.view().motion(i) == Some(Motion::Flight)));
                let change = energy(&world) / start - 1.0;
                worst = worst.max(change.abs());
            }
        }
    }
    assert!(broken > 100 && worst < 2e-3, "{broken} {worst:e}");
}
