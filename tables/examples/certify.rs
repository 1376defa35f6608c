//! Do the certificates hold? Makes carom's tables, tests each at fresh random points (100,000 unless said), prints a table.
//!
//! `cargo run --release -p carom-tables --example certify [compact|standard|wide|all|wideViscoelastic|…] [points]`

use std::time::Instant;

use carom_tables::collision::draw_from_mp13;
use carom_tables::contact;
use carom_tables::random::Rng;
use carom_tables::read::{End, Groups, Law, ScaledRestitution};
use carom_tables::recipe::{GeneratedTable, Recipe};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut words = std::env::args().skip(1);
    let which = words.next().unwrap_or_else(|| "all".into());
    let points: usize = words.next().map_or(Ok(100_000), |w| w.parse())?;
    if which == "bisections" {
        return bisections();
    }
    println!(
        "largest: tau (relative), speed, angle [rad], separation; promised by the certificate / found / 99.9 % of the points"
    );
    for law in [Law::LinearDashpot, Law::Viscoelastic] {
        let recipes = [
            ("compact", Recipe::compact(law)),
            ("standard", Recipe::standard(law)),
            ("wide", Recipe::wide(law)),
        ];
        for (name, recipe) in recipes {
            let asked =
                which.contains(name) && (which == name || which.contains(&format!("{law:?}")));
            if which == "all" || asked {
                let start = Instant::now();
                let table = recipe.generate::<f32>()?;
                let seconds = start.elapsed().as_secs_f64();
                report(&format!("{name} {law:?}"), &table, seconds, points);
            }
        }
    }
    Ok(())
}

/// Searches for the bisections and prints them as `src/recipe/bisections.rs` keeps them.
fn bisections() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "//! How are the presets' unit cubes bisected? Reads nothing; writes nothing, keeps what a search found."
    );
    println!("//!");
    println!(
        "//! Made by `cargo run --release -p carom-tables --example certify bisections > tables/src/recipe/bisections.rs`."
    );
    println!(
        "//! An unoptimised build script has no time for the search; the table that a kept bisection gives is certified all the same."
    );
    for (law, suffix) in [(Law::LinearDashpot, "LINEAR"), (Law::Viscoelastic, "VISCOELASTIC")] {
        for (name, recipe) in [("STANDARD", Recipe::standard(law)), ("WIDE", Recipe::wide(law))] {
            let table = recipe.search().points(100).generate::<f32>()?;
            println!("\npub(super) const {name}_{suffix}: &str = \"\\");
            let bisection = table.bisection().as_bytes();
            for line in bisection.chunks(90) {
                println!("    {}\\", String::from_utf8_lossy(line));
            }
            println!("    \";");
        }
    }
    Ok(())
}

fn report(name: &str, table: &GeneratedTable<f32>, seconds: f64, points: usize) {
    let c = &table.certificate;
    println!(
        "{name}: {} bytes, {} leaves, at most {} terms, made in {seconds:.1} s, digest {:#018x}",
        c.bytes,
        table.data().leaves.len(),
        c.terms,
        c.digest
    );
    println!(
        "  promised  {}   99.9 % {}   typical {}",
        row(&c.largest),
        row(&c.quantile_999),
        row(&c.typical)
    );
    let wide = c.domain.softness_max > 0.3;
    let kinds: &[&str] = if wide { &["tables", "domain"] } else { &["domain", "e<=0.99"] };
    for kind in kinds {
        let (largest, usual, outside) = measure(table, kind, points);
        println!("  {kind:8}  {}   99.9 % {}   outside {outside}", row(&largest), row(&usual));
    }
}

fn row(s: &ScaledRestitution<f64>) -> String {
    format!("{:.2e} {:.2e} {:.2e} {:.2e}", s.tau, s.speed, s.angle, s.separation)
}

fn measure(
    table: &GeneratedTable<f32>,
    kind: &str,
    points: usize,
) -> (ScaledRestitution<f64>, ScaledRestitution<f64>, usize) {
    let law = table.certificate.law;
    let body = table.data();
    let mut rng = Rng::new(0xfeed);
    let mut errors = [const { Vec::new() }; 4];
    let mut outside = 0;
    for n in 0..points {
        let g = match kind {
            "tables" => draw_from_mp13(law, &mut rng),
            _ => anywhere(table, &mut rng, n, kind == "e<=0.99"),
        };
        let single = Groups {
            sin: g.sin as f32,
            cos: g.cos as f32,
            eta: g.eta as f32,
            c_dis: g.c_dis as f32,
        };
        let g = Groups {
            sin: single.sin.into(),
            cos: single.cos.into(),
            eta: single.eta.into(),
            c_dis: single.c_dis.into(),
        };
        let (Some(a), Some(b)) = (body.read(&single), body.read(&g)) else {
            outside += 1;
            continue;
        };
        let truth = contact::integrate(law, End::Force, &g);
        let e = |a: f32, b: f64, t: f64| (f64::from(a) - t).abs().max((b - t).abs());
        errors[0].push(e(a.tau, b.tau, truth.tau) / truth.tau);
        errors[1].push(e(a.speed, b.speed, truth.speed));
        errors[2].push(e(a.angle, b.angle, truth.angle));
        errors[3].push(e(a.separation, b.separation, truth.separation));
    }
    errors.iter_mut().for_each(|list| list.sort_by(f64::total_cmp));
    let at = |part: f64| {
        let [tau, speed, angle, separation] =
            [0, 1, 2, 3].map(|k| errors[k][((errors[k].len() - 1) as f64 * part) as usize]);
        ScaledRestitution { tau, speed, angle, separation }
    };
    (at(1.0), at(0.999), outside)
}

/// Anywhere in the domain: every second point grazing, or with little damping.
fn anywhere(table: &GeneratedTable<f32>, rng: &mut Rng, n: usize, usual: bool) -> Groups<f64> {
    let d = table.certificate.domain;
    let top = if usual { 0.99 } else { (1.0 - d.cos_min * d.cos_min).sqrt() };
    let u = rng.uniform();
    let sin = if n % 2 == 0 || usual { u * top } else { top * (1.0 - u.powi(6)) };
    let cos = ((1.0 - sin) * (1.0 + sin)).sqrt().max(d.cos_min);
    let soft = rng.uniform().powi(if d.softness_max > 1.0 { 3 } else { 1 });
    let c_dis = if d.c_dis_max > 1.5 && n % 3 != 0 {
        rng.log_uniform(1e-4, d.c_dis_max)
    } else {
        d.c_dis_max * rng.uniform().powi(1 + (n % 2) as i32)
    };
    Groups { sin, cos, eta: soft * d.softness_max * cos, c_dis }
}
