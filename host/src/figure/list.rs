//! Which figures of the papers can be made, and how do they read as text? Reads an id; returns the figure, writes its data as a table.

use super::data::{Entry, Figure, Made, Note, Series, Value};
use super::number::significant;
use super::{bsfp14, gases, l94, mp13, rest, walls, waves};
use anyhow::{Result, bail};
use std::io::Write;

/// All figures, in the order in which they are listed.
pub fn all() -> impl Iterator<Item = &'static Entry> {
    BSFP14.iter().chain(L94).chain(MP13).chain(OURS)
}

/// The figure with this id.
///
/// # Errors
/// When there is none; the message lists those that there are.
///
/// ```
/// use carom_host::figure;
/// assert!(figure::find("bsfp14-7").is_ok());
/// assert!(figure::find("fig7").unwrap_err().to_string().contains("bsfp14-7"));
/// ```
pub fn find(id: &str) -> Result<&'static Entry> {
    if let Some(entry) = all().find(|entry| entry.id == id) {
        return Ok(entry);
    }
    let ids: Vec<_> = all().map(|entry| entry.id).collect();
    bail!("figure {id:?} is not known; there are {}", ids.join(", "))
}

/// A figure and its page's text, which has the figure's name.
macro_rules! entry {
    ($id:literal, $what:literal, $make:expr) => {
        Entry {
            id: $id,
            what: $what,
            make: $make,
            text: include_str!(concat!("pages/", $id, ".md")),
        }
    };
}

/// The figures of BSFP14.
const BSFP14: &[Entry] = &[
    entry!(
        "bsfp14-3",
        "how far from contact spheres collide, in units of the last place",
        bsfp14::gas::make_impacts
    ),
    entry!(
        "bsfp14-5",
        "how often a grain overlaps its partner and a third at a collision",
        bsfp14::three_body::make
    ),
    entry!(
        "bsfp14-7",
        "a bouncing ball on plates at any height: naive detection halts, the stable one rests",
        bsfp14::plates::make
    ),
    entry!("bsfp14-7-path", "height of the bouncing ball against time", bsfp14::path::make),
];

/// The figures of L94.
const L94: &[Entry] = &[
    entry!("l94-1", "trajectories of ten beads at a wall, for three gaps", l94::paths::at_a_wall),
    entry!("l94-2a", "ε_eff of a column at a wall, against the gaps", l94::separation::make),
    entry!("l94-2b", "loss of beads in contact, against N and ε", l94::loss::make_b),
    entry!("l94-2c", "relative energy left by the impact of beads in contact", l94::loss::make_c),
    entry!("l94-3", "ε_eff of beads in contact, for three force laws", l94::loss::make_laws),
    entry!("l94-4a", "ε_eff of a layer in two dimensions, against the gaps", l94::layer::make_a),
    entry!("l94-4b", "loss of layers in contact, against their height", l94::layer::make_b),
    entry!("l94-5", "a column on a vibrating plate, for two contact times", l94::paths::on_a_plate),
    entry!(
        "l94-6a",
        "a bead of a shaken column, against the phase of the plate",
        l94::phase::make_a
    ),
    entry!("l94-6b", "a column on a vibrating plate, as in the experiment", l94::phase::make_b),
    entry!("l94-7", "height of a strongly shaken column, against α", l94::height::make),
    entry!("l94-table1", "exponents of depth, duration and loss of a contact", l94::table1::make),
];

/// The figures of MP13, and what the paper leaves open.
const MP13: &[Entry] = &[
    entry!("mp13-3", "ε_φ of elastic collisions, over MP13's Table I", mp13::maps::make_3),
    entry!("mp13-4", "the matrix of restitution, linear dashpot", mp13::maps::make_4),
    entry!("mp13-5", "the matrix of restitution, viscoelastic spheres", mp13::maps::make_5),
    entry!("mp13-6", "two soft grains by eMD and by eMD*, against MD", mp13::pair::make),
    entry!(
        "mp13-7",
        "how often eMD* cannot treat a contact as one of two grains alone",
        mp13::gas::make
    ),
    entry!(
        "mp13-7-transport",
        "self-diffusion and pressure by eMD and eMD*, against MD",
        mp13::transport::make
    ),
];

/// Of no figure of the papers: what the engine's default does, and what they leave as outlook.
const OURS: &[Entry] = &[
    entry!("rest", "a hundred soft disks fall into a box and come to rest, against MD", rest::make),
    entry!(
        "cooling",
        "a gas of viscoelastic grains cools, T ~ t^(−5/3), beside one of constant ε",
        gases::cooling::make
    ),
    entry!(
        "mixture",
        "the two temperatures of a mixture that cools, against Garzó and Dufty",
        gases::mixture::make
    ),
    entry!(
        "mean-free-time",
        "mean free time of elastic hard spheres, against Enskog and Lue",
        gases::free_time::make
    ),
    entry!(
        "faraday",
        "waves on a shaken layer of spheres, against Umbanhowar and Swinney",
        waves::faraday::make
    ),
    entry!(
        "flow",
        "how grains flow in a shaken layer of disks, by MD and event by event",
        waves::flow::make
    ),
    entry!(
        "patterns",
        "squares and stripes on a shaken layer of rough spheres, against Bizon et al.",
        waves::patterns::make
    ),
    entry!("drum", "the slope in a drum of rough disks that turns, against μ", walls::drum::make),
    entry!(
        "hopper",
        "how fast disks run out of openings of four widths, against Beverloo's law",
        walls::hopper::make
    ),
];

/// Points of a curve that are printed.
const MAX_ROWS: usize = 40;

/// Prints the data, then the comparison with the paper.
///
/// # Errors
/// An error of the sink.
pub fn print(out: &mut impl Write, what: &str, made: &Made) -> Result<()> {
    let Figure { id, axes, series } = &made.figure;
    writeln!(out, "{id}: {what}")?;
    writeln!(out, "  x: {}\n  y: {}", axes.x, axes.y)?;
    for series in series {
        curve(out, series)?;
    }
    if !made.notes.is_empty() {
        comparison(out, &made.notes)?;
    }
    Ok(())
}

fn curve(out: &mut impl Write, series: &Series) -> Result<()> {
    let params: Vec<_> = series.params.iter().map(|(k, v)| format!("{k} = {}", shown(v))).collect();
    writeln!(out, "\n  {} ({})", series.name, params.join(", "))?;
    let count = series.x.len();
    let every = count.div_ceil(MAX_ROWS).max(1);
    if every > 1 {
        writeln!(out, "    (one of {every} of {count} points; --json prints all)")?;
    }
    for (i, (x, y)) in series.x.iter().zip(&series.y).enumerate().step_by(every) {
        let error = series.yerr.get(i).map_or_else(String::new, |e| format!("  ± {}", number(*e)));
        writeln!(out, "    {:>14}  {:>14}{error}", number(*x), number(*y))?;
    }
    Ok(())
}

fn comparison(out: &mut impl Write, notes: &[Note]) -> Result<()> {
    let width = |of: fn(&Note) -> &String| {
        notes.iter().map(|note| of(note).chars().count()).max().unwrap_or(0)
    };
    let (what, paper) = (width(|note| &note.what), width(|note| &note.paper).max(10));
    let theory = match width(|note| &note.theory) {
        0 => 0,
        wide => wide.max(6) + 2,
    };
    let title = if theory > 0 { "theory" } else { "" };
    writeln!(out, "\n  {:what$}  {:paper$}  {title:theory$}we get", "", "paper says")?;
    for note in notes {
        let Note { what: of, paper: says, theory: by, ours } = note;
        writeln!(out, "  {of:what$}  {says:paper$}  {by:theory$}{ours}")?;
    }
    Ok(())
}

fn shown(value: &Value) -> String {
    match value {
        Value::Number(x) => number(*x),
        Value::Text(text) => text.clone(),
    }
}

/// Six digits, as short as they can be.
fn number(x: f64) -> String {
    significant(x, 6)
}
