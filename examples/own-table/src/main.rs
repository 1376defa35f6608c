//! What is in the table of this package's build.rs? Reads the table; prints its certificate and one collision.

use carom::law::embedded::read::Groups;

include!(concat!(env!("OUT_DIR"), "/rubber.rs"));

fn main() {
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
