//! What does the Boltzmann equation say of rough spheres that cool? Bird's Monte Carlo method; shares nothing with the engine.
//!
//! Molecular Gas Dynamics and the Direct Simulation of Gas Flows (1994), in a homogeneous gas: pairs are drawn at
//! random and collide with a probability that goes with their speed of approach.

use crate::pair::seeded;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

type Vector = carom::Vector<f64, 3>;

const Q: f64 = 0.4;
const R: f64 = 0.5;

struct Sphere {
    velocity: Vector,
    rotation: Vector,
}

/// A direction with equal chances.
fn direction(rng: &mut Pcg64Mcg) -> Vector {
    loop {
        let v = Vector::from_fn(|_, _| rng.random_range(-1.0..1.0));
        let size = v.norm();
        if size > 0.1 && size < 1.0 {
            return v / size;
        }
    }
}

/// T_rot/T_tr after so many collisions a sphere, averaged over as many more.
pub fn ratio(n: usize, [e, beta]: [f64; 2], collisions: usize) -> f64 {
    let mut rng = seeded(6);
    let mut gas: Vec<Sphere> = (0..n)
        .map(|_| Sphere { velocity: direction(&mut rng), rotation: direction(&mut rng) * 2.0 })
        .collect();
    // What a whole gas moves with does not cool.
    let drift = gas.iter().map(|s| s.velocity).sum::<Vector>() / n as f64;
    gas.iter_mut().for_each(|s| s.velocity -= drift);
    let (mut done, mut fastest, mut sum, mut count) = (0, 4.0, 0.0, 0.0);
    while done < collisions * n {
        done += usize::from(collide(&mut gas, &mut rng, [e, beta], fastest));
        if done % (n / 8) == 0 {
            let flight: f64 = gas.iter().map(|s| s.velocity.norm_squared()).sum();
            let turning: f64 = gas.iter().map(|s| s.rotation.norm_squared()).sum();
            fastest = 6.0 * (2.0 * flight / 3.0 / n as f64).sqrt();
            done += 1;
            if done > collisions * n / 2 {
                (sum, count) = (sum + Q * R * R * turning / flight, count + 1.0);
            }
        }
    }
    sum / count
}

/// Whether two spheres, drawn at random, collided.
fn collide(gas: &mut [Sphere], rng: &mut Pcg64Mcg, [e, beta]: [f64; 2], fastest: f64) -> bool {
    let [i, k] = [(); 2].map(|()| rng.random_range(0..gas.len()));
    let n = direction(rng);
    let relative = gas[i].velocity - gas[k].velocity;
    let along = relative.dot(&n);
    if i == k || along >= 0.0 || rng.random_range(0.0..fastest) > -along {
        return false;
    }
    let surface = relative - n * along - (gas[i].rotation + gas[k].rotation).cross(&n) * R;
    // Of two with mass 1: half the change of the relative velocity.
    let change = (n * (along * (1.0 + e)) + surface * (Q / (1.0 + Q) * (1.0 + beta))) * -0.5;
    let turn = n.cross(&change) / (Q * R);
    for (x, sign) in [(i, 1.0), (k, -1.0)] {
        gas[x].velocity += change * sign;
        gas[x].rotation -= turn;
    }
    true
}
