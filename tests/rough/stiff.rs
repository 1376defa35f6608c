//! Is β of a contact that is read from tables that of its equations of motion? Balls on a plane, over all groups.

use crate::pair::seeded;
use carom::law::{LinearDashpot, Outside, Rough, Rule, Soft, Tangential, Viscoelastic};
use carom::space::{ContactState, Plane, Surface};
use carom::world::{Rotating, WithContacts};
use carom::{Grain, Memory, World};
use rand::RngExt;

/// A ball of unit mass and radius that hits the plane below it with unit speed.
#[derive(Clone, Copy, Debug)]
struct Ball {
    is_linear: bool,
    /// Dissipation, and the spring across, in the scales of the contact.
    c_dis: f64,
    across: f64,
    mu: f64,
    sliding: f64,
}

/// T: the contact is so short that it is of no size.
const T: f64 = 1e-7;
/// m_t = m_eff q/(1 + q).
const SHARE: f64 = 2.0 / 7.0;

/// β in the limit of stiff grains: 40,000 small steps of the equations of motion, MP13's Eqs. 42 and 54 without η, and
/// the spring of Cundall and Strack.
fn stepped(ball: &Ball) -> f64 {
    let force = |x: f64, v: f64| {
        let f = x + ball.c_dis * v;
        (if ball.is_linear { f } else { f * x.max(0.0).sqrt() }).max(0.0)
    };
    let h = 1e-4;
    let (mut x, mut v, mut sliding, mut spring) = (0.0, 1.0, ball.sliding, 0.0_f64);
    loop {
        let middle = v - 0.5 * h * force(x, v);
        let f = force(x + 0.5 * h * v, middle);
        (x, v) = (x + h * middle, v - h * f);
        if v < 0.0 && force(x, v) <= 0.0 {
            return -sliding / ball.sliding;
        }
        let longest = ball.mu * f / ball.across;
        let half = (spring + 0.5 * h * sliding).clamp(-longest, longest);
        sliding -= h * ball.across * half / SHARE;
        spring = half + 0.5 * h * sliding;
    }
}

/// β by the engine.
fn found(ball: &Ball, rule: impl Rule<f64>) -> f64 {
    let memory = WithContacts::new(Memory::<f64, 2, 1>::new(), [ContactState::VACANT; 1]);
    let mut memory = Rotating::new(memory, [[0.0]; 3]);
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
        .rule(rule)
        .grain(Grain::with_mass(1.0, 1.0).at([0.0, 1.5]).moving([ball.sliding, -1.0]))
        .unwrap()
        .start()
        .unwrap();
    while world.grain(0).unwrap().velocity.y <= 0.0 {
        assert!(world.step().unwrap().is_some());
    }
    while world.view().contact(0).is_some() {
        assert!(world.step().unwrap().is_some());
    }
    // It was one contact, from the table: nothing was integrated.
    assert_eq!(world.statistics().joins, 0, "{ball:?}");
    let [.., spin] = world.view().angular_velocity(0).unwrap();
    -(world.grain(0).unwrap().velocity.x + spin) / ball.sliding
}

/// The difference of both for one ball.
fn difference(ball: &Ball) -> f64 {
    let Ball { is_linear, c_dis, across, mu, .. } = *ball;
    let tangential = Tangential::Spring { mu, stiffness: across / (T * T), damping: 0.0 };
    let here = if is_linear {
        let law = LinearDashpot { stiffness: 1.0 / (T * T), damping: c_dis / T };
        found(ball, Rough::spheres(Soft::linear_dashpot(law, Outside::Reject), tangential))
    } else {
        // T = ρ^(−2/5) with ρ = (2/3) Y/(1 − ν²).
        let young = 1.5 * (1.0 - 0.09) * T.powf(-2.5);
        let law = Viscoelastic { young, poisson: 0.3, dissipation: c_dis * T / 1.5 };
        found(ball, Rough::spheres(Soft::viscoelastic(law, Outside::Reject), tangential))
    };
    (here - stepped(ball)).abs()
}

/// Over the domain: dissipation, stiffness across over along, and friction over what there is to stop.
fn differences(count: usize, is_linear: bool, seed: u64) -> Vec<f64> {
    let mut rng = seeded(seed);
    let mut draw = |low: f64, high: f64| (rng.random_range(low.ln()..high.ln())).exp();
    let mut one = || {
        let [c_dis, across, sliding] = [draw(1e-3, 1.0), draw(0.03, 14.0), draw(0.01, 10.0)];
        let mu = (draw(1e-2, 1e2) * sliding * SHARE).min(16.0);
        difference(&Ball { is_linear, c_dis, across, mu, sliding })
    };
    let mut all: Vec<f64> = (0..count).map(|_| one()).collect();
    all.sort_by(f64::total_cmp);
    all
}

#[test]
fn beta_of_a_stiff_contact_is_within_a_ten_thousandth() {
    for (is_linear, seed) in [(true, 1), (false, 2)] {
        let all = differences(400, is_linear, seed);
        println!("{:e} {:e} {:e}", all[200], all[390], all[399]);
        assert!(all[399] < 1e-4, "{:e}", all[399]);
    }
}
