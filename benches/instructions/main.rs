//! How many instructions does a collision cost, and a look at obstacles? Runs cases under callgrind; writes the tables of docs/guide.
//!
//! Instructions do not depend on what else the machine does. Needs `valgrind`. Cases are those of `carom bench`; what has
//! more than 20,000 grains is run if it is named: `cargo bench --bench instructions -- hs3d-108000`. So are `obstacles`:
//! a gas in a box that is made of planes, or of triangles.

mod obstacles;

use carom_host::bench::{self, Case, Effort};
use std::path::Path;
use std::process::{Command, ExitCode};

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

/// Collisions that are counted.
const COLLISIONS: u64 = 5_000;
/// The function that callgrind counts: `carom_host::bench::timed` or `obstacles::bench_timed`, mangled or not.
const COUNTED: &str = "*bench*timed*";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let outcome = match &arguments[..] {
        [flag, name] if flag == "--under-callgrind" => run(name),
        [name] if name == obstacles::NAME => obstacles::table(),
        [name, bench] if name == obstacles::NAME && bench == "--bench" => obstacles::table(),
        all => table(&all.iter().filter(|a| !a.starts_with("--")).collect::<Vec<_>>()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("instructions: {why}");
            ExitCode::FAILURE
        }
    }
}

/// What runs under callgrind: one collision a grain, so that the lattice is left, and those counted.
fn run(name: &str) -> Outcome<()> {
    if let Some(pieces) = obstacles::named(name) {
        return obstacles::run(pieces);
    }
    for case in bench::named(name) {
        let equilibration = case.count as u64 / 2;
        bench::measure_with(&case, Effort { equilibration, collisions: COLLISIONS })?;
    }
    Ok(())
}

fn table(names: &[&String]) -> Outcome<()> {
    let cases: Vec<Case> = if names.is_empty() {
        bench::ALL.into_iter().filter(|case| case.count < 20_000).collect()
    } else {
        names.iter().flat_map(|name| bench::named(name)).collect()
    };
    let folder = tempfile::tempdir()?;
    println!("| case | N | instructions per collision |\n|---|---|---|");
    for case in cases {
        let count = count(case.name, folder.path())?;
        println!("| {} | {} | {} |", case.name, case.count, count / COLLISIONS);
    }
    Ok(())
}

/// Instructions of a case, by its name.
fn count(case: &str, folder: &Path) -> Outcome<u64> {
    let out = folder.join(case);
    let status = Command::new("valgrind")
        .args(["--tool=callgrind", "--quiet", "--collect-atstart=no"])
        .arg(format!("--toggle-collect={COUNTED}"))
        .arg(format!("--callgrind-out-file={}", out.display()))
        .arg(std::env::current_exe()?)
        .args(["--under-callgrind", case])
        .status()
        .map_err(|why| format!("cannot run valgrind ({why}); install it"))?;
    if !status.success() {
        return Err(format!("{case} ended with {status}").into());
    }
    let text = std::fs::read_to_string(&out)?;
    let total = text.lines().find_map(|line| line.strip_prefix("totals: "));
    let total = total.ok_or("callgrind counted nothing")?.trim().parse()?;
    if total == 0 { Err("callgrind did not find what to count".into()) } else { Ok(total) }
}
