//! What is in the tables of this package's build.rs? Reads the tables; prints their certificates and one collision by each.

use carom::law::embedded::read::Groups;
use carom::law::{Outside, PairTabulated, PowerLaw};
use carom::{Error, Grain, Memory, World};

include!(concat!(env!("OUT_DIR"), "/rubber.rs"));
include!(concat!(env!("OUT_DIR"), "/balls.rs"));

fn main() -> Result<(), Error> {
    rubber();
    balls()
}

/// A law with a table of one's own in a world.
fn balls() -> Result<(), Error> {
    let c = &BALLS.certificate;
    println!("{} bytes; speeds {:?} along, {} across", c.bytes, c.speeds, c.across);
    let [duration, restitution, angle] = c.largest;
    println!(
        "largest error: duration {duration:.1e} (relative), restitution {restitution:.1e}, angle {angle:.1e} rad"
    );
    let law = PowerLaw { stiffness: 2e7, exponent: 1.75, damping: 5e3, damping_exponent: 0.6 };
    let mut memory = Memory::<f64, 2, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(PairTabulated { law, table: &BALLS, outside: Outside::Reject })
        .grain(Grain::with_mass(0.1, 1.0).moving([1.0, 0.3]))?
        .grain(Grain::with_mass(0.1, 1.0).at([0.3, 0.05]))?
        .start()?;
    world.advance_to(1.0)?;
    let of = |k| world.grain(k).map(|grain| grain.velocity);
    println!("afterwards {:?} and {:?}", of(0), of(1));
    Ok(())
}

fn rubber() {
    let c = &RUBBER.certificate;
    println!("{} bytes, at most {} terms a lookup", c.bytes, c.terms);
    println!("eta/cos(alpha) <= {}, c_dis <= {}", c.domain.softness_max, c.domain.c_dis_max);
    println!(
        "largest error: tau {:.1e} (relative), speed {:.1e}, angle {:.1e} rad, separation {:.1e}",
        c.largest.tau, c.largest.speed, c.largest.angle, c.largest.separation
    );
    println!("digest {:#018x}; {}", c.digest, c.citation);
    let hit = Groups { sin: 0.6, cos: 0.8, eta: 0.02, c_dis: 0.3 };
    match RUBBER.read(&hit) {
        Some(after) => println!("e = 0.6, eta = 0.02, c_dis = 0.3: {after:?}"),
        None => println!("{hit:?} lies outside the table"),
    }
}
