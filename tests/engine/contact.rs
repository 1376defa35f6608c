//! Does one contact do what the papers say? Single events against closed forms.

use carom::law::{ByMaterial, Central, HardSphere, LinearDashpot, Outside, Soft};
use carom::space::{Plane, Surface};
use carom::world::{EventKind, EventOutcome};
use carom::{Enduring, Error, Grain, Memory, World};
use carom_host::integrated::Integrated;

const SPRING: LinearDashpot<f64> = LinearDashpot { stiffness: 1.0e4, damping: 0.0 };

/// A head-on elastic contact: the centre of mass goes on, the two part after half a period.
#[test]
fn a_central_elastic_contact_lasts_half_a_period_and_swaps_velocities() {
    let mut memory = Memory::<f64, 1, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(Soft::linear_dashpot(SPRING, Outside::Reject))
        .grain(Grain::with_mass(0.5, 2.0).moving([1.0]))
        .unwrap()
        .grain(Grain::with_mass(0.5, 2.0).at([2.0]))
        .unwrap()
        .start()
        .unwrap();
    let begin = world.step().unwrap().unwrap();
    assert!((begin.at.as_f64() - 1.0).abs() < 1e-15);
    assert_eq!(world.grain(0).unwrap().velocity[0], 0.5);
    assert_eq!(world.grain(1).unwrap().velocity[0], 0.5);
    let end = world.step().unwrap().unwrap();
    let duration = std::f64::consts::PI * (1.0_f64 / 1.0e4).sqrt();
    let error = (end.at.as_f64() - 1.0 - duration).abs() / duration;
    let promised = carom::law::embedded::standard::LINEAR_DASHPOT.certificate.largest.tau;
    assert!(error <= promised, "{error:e} against {promised:e}");
    assert_eq!((end.kind, end.outcome), (EventKind::ContactEnd, Some(EventOutcome::ContactEnded)));
    assert!(world.grain(0).unwrap().velocity[0].abs() < 1e-15);
    assert!((world.grain(1).unwrap().velocity[0] - 1.0).abs() < 1e-15);
    assert_eq!(world.statistics().releases, 2);
    assert!(world.step().unwrap().is_none());
}

/// Two grains of different mass: velocities of a hard elastic collision in closed form.
#[test]
fn unequal_masses_part_as_conservation_demands() {
    let mut memory = Memory::<f64, 2, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution: 0.5 })
        .grain(Grain::with_mass(0.5, 1.0).moving([3.0, 1.0]))
        .unwrap()
        .grain(Grain::with_mass(0.5, 2.0).at([4.0, 1.0]).moving([0.0, 1.0]))
        .unwrap()
        .start()
        .unwrap();
    assert!(world.step().unwrap().is_none() || world.statistics().collisions == 1);
    let mut memory = Memory::<f64, 1, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution: 0.5 })
        .grain(Grain::with_mass(0.5, 1.0).moving([3.0]))
        .unwrap()
        .grain(Grain::with_mass(0.5, 2.0).at([4.0]))
        .unwrap()
        .start()
        .unwrap();
    world.step().unwrap();
    assert_eq!(world.grain(0).unwrap().velocity[0], 0.0);
    assert_eq!(world.grain(1).unwrap().velocity[0], 1.5);
}

/// A soft wall: the duration is that of m_eff = m, the tangential motion goes on.
#[test]
fn a_soft_wall_holds_a_grain_for_half_a_period_and_leaves_its_tangential_motion() {
    let mut memory = Memory::<f64, 2, 1>::new();
    let mut world = World::builder(&mut memory)
        .walls([[0.0, 10.0]; 2])
        .rule(Integrated::new(SPRING))
        .grain(Grain::with_mass(0.5, 4.0).at([2.5, 2.0]).moving([-1.0, 0.5]))
        .unwrap()
        .start()
        .unwrap();
    let begin = world.step().unwrap().unwrap().at.as_f64();
    let end = world.step().unwrap().unwrap().at.as_f64();
    assert!((begin - 2.0).abs() < 1e-15);
    assert!((end - begin - std::f64::consts::PI * (4.0_f64 / 1.0e4).sqrt()).abs() < 1e-12);
    let grain = world.grain(0).unwrap();
    assert!((grain.velocity[0] - 1.0).abs() < 1e-12 && (grain.velocity[1] - 0.5).abs() < 1e-15);
    assert!((grain.position[0] - 0.5).abs() < 1e-12);
    assert!((grain.position[1] - 2.0 - 0.5 * end).abs() < 1e-12);
}

/// A ball on a soft floor under gravity: each speed is ε times the last one, less c_dis g T/v for its weight, which is
/// the first order, and less the climb from the end of contact.
#[test]
fn a_bouncing_ball_keeps_epsilon_of_its_speed_each_time() {
    let law = LinearDashpot { stiffness: 1.0e6, damping: 100.0 };
    let mut memory = Memory::<f64, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .walls([[0.0, 10.0]])
        .gravity([-9.81])
        .rule(Integrated::new(law))
        .grain(Grain::with_mass(0.5, 1.0).at([1.5]))
        .unwrap()
        .start()
        .unwrap();
    // MP13's end of contact: ε = exp(−μ τ') with the shorter τ'.
    let (mu, omega0) = (50.0_f64, 1.0e3_f64);
    let omega = (omega0 * omega0 - mu * mu).sqrt();
    let tau =
        (std::f64::consts::PI - (2.0 * mu * omega / (omega * omega - mu * mu)).atan()) / omega;
    let epsilon = (-mu * tau).exp();
    let mut impact = (2.0 * 9.81_f64).sqrt();
    for bounce in 0..5 {
        while world.step().unwrap().unwrap().kind != EventKind::ContactEnd {}
        let speed = world.grain(0).unwrap().velocity[0];
        let weight = 100.0 / 1.0e3 * (9.81 / 1.0e3 / impact);
        let expected = epsilon * impact * (1.0 - weight);
        assert!((speed / expected - 1.0).abs() < 1e-5, "{bounce}: {speed}");
        // It starts from where the force vanished, x = γ v/k below the surface, and lands on the surface.
        impact = (speed * speed - 2.0 * 9.81 * (100.0 * speed / 1.0e6)).sqrt();
    }
}

/// Gravity changed in the middle of a contact: relative motion is not touched.
#[test]
fn gravity_changed_in_the_middle_of_a_contact_moves_only_the_centre_of_mass() {
    let mut memory = Memory::<f64, 2, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(Integrated::new(SPRING))
        .grain(Grain::with_mass(0.5, 2.0).moving([1.0, 0.0]))
        .unwrap()
        .grain(Grain::with_mass(0.5, 2.0).at([2.0, 0.0]))
        .unwrap()
        .start()
        .unwrap();
    world.step().unwrap();
    world.advance_to(1.01).unwrap();
    world.set_gravity([0.0, -2.0]).unwrap();
    world.advance_to(2.01).unwrap();
    let (a, b) = (world.grain(0).unwrap(), world.grain(1).unwrap());
    assert!(a.velocity[0].abs() < 1e-12 && (b.velocity[0] - 1.0).abs() < 1e-12);
    assert!((a.velocity[1] + 2.0).abs() < 1e-12 && (b.velocity[1] + 2.0).abs() < 1e-12);
    assert!((a.position[1] + 1.0).abs() < 1e-12);
}

/// The same against a floor: nothing is pressed into it, and the contact ends where and when it would have.
/// Gravity that pulls the grain off the floor far enough to be seen ends the contact at once.
#[test]
fn gravity_changed_in_the_middle_of_a_contact_presses_nothing_into_the_floor() {
    let duration = std::f64::consts::PI * (2.0_f64 / 1.0e4).sqrt();
    for (gravity, end) in [(-9.0, duration), (1.0, duration), (200.0, duration / 4.0)] {
        let mut memory = Memory::<f64, 1, 1>::new();
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .walls([[0.0, 10.0]])
            .rule(Integrated::new(SPRING))
            .grain(Grain::with_mass(0.5, 2.0).at([1.5]).moving([-1.0]))
            .unwrap()
            .start()
            .unwrap();
        world.step().unwrap();
        world.advance_to(1.0 + duration / 4.0).unwrap();
        world.set_gravity([gravity]).unwrap();
        let release = world.step().unwrap().unwrap();
        assert_eq!(release.kind, EventKind::ContactEnd);
        assert!((release.at.as_f64() - 1.0 - end).abs() < 1e-12, "{gravity}: {}", release.at);
        let grain = world.grain(0).unwrap();
        assert!((grain.position[0] - 0.5).abs() < 1e-12, "{gravity}: {grain:?}");
        assert!((grain.velocity[0] - 1.0).abs() < 1e-12, "{gravity}: {grain:?}");
    }
}

/// Exception (a): a third grain stands where the turn would put one of the two.
#[test]
fn a_turn_into_a_third_grain_is_refused_and_counted() {
    let soft = LinearDashpot { stiffness: 40.0, damping: 0.0 };
    let mut memory = Memory::<f64, 2, 3>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .rule(Integrated::new(soft))
        .grain(Grain::with_mass(0.5, 1.0).at([-1.5, 0.5]).moving([1.0, 0.0]))
        .unwrap()
        .grain(Grain::with_mass(0.5, 1.0).at([1.0, 0.0]).moving([-1.0, 0.0]))
        .unwrap()
        .grain(Grain::with_mass(0.5, 1.0).at([-0.005, 1.262]))
        .unwrap()
        .start()
        .unwrap();
    let outcome = world.step().unwrap().unwrap().outcome;
    assert!(matches!(outcome, Some(EventOutcome::Collision { .. })), "{outcome:?}");
    assert_eq!(world.statistics().rotation_refused, 1);
}

#[test]
fn a_rule_by_material_uses_the_pair_s_own_whatever_the_order() {
    let rule = ByMaterial([
        [HardSphere { restitution: 1.0 }, HardSphere { restitution: 0.5 }],
        [HardSphere { restitution: 0.0 }, HardSphere { restitution: 0.25 }],
    ]);
    for swap in [false, true] {
        let mut memory = Memory::<f64, 1, 2>::new();
        let (m, n) = if swap { (1, 0) } else { (0, 1) };
        let mut world = World::builder(&mut memory)
            .rule(rule)
            .grain(Grain::with_mass(0.5, 1.0).moving([1.0]).of_material(m))
            .unwrap()
            .grain(Grain::with_mass(0.5, 1.0).at([2.0]).of_material(n))
            .unwrap()
            .start()
            .unwrap();
        world.step().unwrap();
        assert_eq!(world.grain(1).unwrap().velocity[0], 0.75);
    }
}

/// A wall has the law of its own material with the grain's; without one, that of two of the grain's. Hard ones in
/// both modes; a soft one, a spring, keeps the energy and takes half a period of the grain on it.
#[test]
fn a_wall_of_a_material_has_the_law_of_the_pair() {
    let rule = ByMaterial([
        [HardSphere { restitution: 1.0 }, HardSphere { restitution: 0.5 }],
        [HardSphere { restitution: 0.0 }, HardSphere { restitution: 0.25 }],
    ]);
    for enduring in [Enduring::Paper, Enduring::Integrated] {
        for (surface, material, after) in [
            (Surface::Rule, 0, 1.0),
            (Surface::Rule, 1, 0.25),
            (Surface::Material(0), 1, 0.5),
            (Surface::Material(1), 0, 0.5),
            (Surface::Material(1), 1, 0.25),
        ] {
            let mut memory = Memory::<f64, 1, 1>::new();
            let mut world = World::builder(&mut memory)
                .enduring(enduring)
                .plane(Plane::new([1.0], 0.0, surface))
                .rule(rule)
                .grain(Grain::with_mass(0.5, 1.0).at([2.0]).moving([-1.0]).of_material(material))
                .unwrap()
                .start()
                .unwrap();
            world.advance_to(2.0).unwrap();
            let speed = world.grain(0).unwrap().velocity[0];
            assert_eq!(speed, after, "{enduring:?} {surface:?} {material}");
        }
    }
}

#[test]
fn a_soft_wall_of_a_material_lasts_as_long_as_its_spring_says() {
    let [own, mixed] = [1.0e4, 4.0e4].map(|stiffness| {
        Soft::linear_dashpot(LinearDashpot { stiffness, damping: 0.0 }, Outside::Reject)
    });
    for (surface, stiffness) in [(Surface::Rule, 1.0e4_f64), (Surface::Material(1), 4.0e4)] {
        let mut memory = Memory::<f64, 1, 1>::new();
        let mut world = World::builder(&mut memory)
            .plane(Plane::new([1.0], 0.0, surface))
            .rule(ByMaterial([[own, mixed], [mixed, own]]))
            .grain(Grain::with_mass(0.5, 1.0).at([1.5]).moving([-1.0]))
            .unwrap()
            .start()
            .unwrap();
        let begin = world.step().unwrap().unwrap().at.as_f64();
        let end = world.step().unwrap().unwrap().at.as_f64();
        let half = std::f64::consts::PI / stiffness.sqrt();
        assert!(((end - begin) / half - 1.0).abs() < 1e-5, "{surface:?}: {}", end - begin);
        assert!((world.grain(0).unwrap().velocity[0] - 1.0).abs() < 1e-5);
    }
}

#[test]
fn outside_the_table_the_user_s_choice_holds_and_is_counted() {
    let very_soft = LinearDashpot { stiffness: 1.0, damping: 0.0 };
    let run = |outside| -> Result<(u64, u64), Error> {
        let mut memory = Memory::<f64, 1, 2>::new();
        let mut world = World::builder(&mut memory)
            .rule(Soft::linear_dashpot(very_soft, outside))
            .grain(Grain::with_mass(0.5, 1.0).moving([10.0]))?
            .grain(Grain::with_mass(0.5, 1.0).at([2.0]))?
            .start()?;
        world.step()?;
        Ok((world.statistics().clamped, world.statistics().hard_sphere))
    };
    assert_eq!(run(Outside::Clamp), Ok((1, 0)));
    assert_eq!(run(Outside::HardSphere), Ok((0, 1)));
    assert!(matches!(run(Outside::Reject), Err(Error::OutsideTable { .. })));
}

#[test]
fn the_central_rule_has_the_law_s_restitution_and_no_duration() {
    let law = LinearDashpot { stiffness: 1.0e4, damping: 10.0 };
    let mut memory = Memory::<f64, 1, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(Central(Integrated::new(law)))
        .grain(Grain::with_mass(0.5, 1.0).moving([1.0]))
        .unwrap()
        .grain(Grain::with_mass(0.5, 1.0).at([2.0]))
        .unwrap()
        .start()
        .unwrap();
    let outcome = world.step().unwrap().unwrap().outcome;
    let Some(EventOutcome::Collision { restitution }) = outcome else { panic!("{outcome:?}") };
    // β = γ/(2 m_eff) = 10, ω0² = k/m_eff = 2e4; Schwager & Pöschel (2007).
    let (beta, omega) = (10.0_f64, (2.0e4_f64 - 100.0).sqrt());
    let tau = (std::f64::consts::PI - (2.0 * beta * omega / (omega * omega - beta * beta)).atan())
        / omega;
    assert!((restitution - (-beta * tau).exp()).abs() < 1e-11, "{restitution}");
}
