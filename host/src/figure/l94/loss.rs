//! How much energy does a column lose at a wall? Reads ε, N, gaps and force laws; writes L94 Figs. 2b, 2c and 3, by MD, ED and eMD*.

use super::column::{Column, Outcome};
use super::hard::{self, Variant};
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::figure::fit;
use crate::plot::Colour;
use crate::progress::Progress;
use anyhow::{Context, Result};
use carom_reference::ForceLaw;
use rayon::prelude::*;

/// The methods, as series name them.
pub const METHODS: [&str; 3] = ["MD", "ED", "eMD*"];
/// ε of Fig. 2b, from top to bottom.
pub const RESTITUTIONS: [f64; 5] = [0.6, 0.8, 0.9, 0.95, 0.975];
/// N of Fig. 2b.
pub const BEADS: [usize; 7] = [1, 2, 5, 10, 20, 50, 100];
/// Columns longer than this are left to L94's integrator unless the figure is to be `--full`.
const LONGEST_EXACT: usize = 20;
/// Steps per contact for those: ε_eff is then within 1e-5 of exact MD.
pub const STEPS: f64 = 200.0;

/// One column by one method: "ED", "eMD*", "clusters", or else MD.
///
/// # Errors
/// An error of the method.
pub fn impact(method: &str, column: &Column, law: &ForceLaw, exact: bool) -> Result<Outcome> {
    let outcome = match method {
        "ED" => hard::collide(column, law, Variant::Instant),
        "eMD*" => hard::collide(column, law, Variant::Lasting),
        "clusters" => hard::collide(column, law, Variant::CLUSTERS),
        _ if exact || column.beads <= LONGEST_EXACT => Ok(column.collide(*law)?),
        _ => Ok(column.collide_in_steps(*law, STEPS)?),
    };
    outcome.with_context(|| format!("{method}, N = {}, s0 = {}", column.beads, column.gap))
}

/// One column of Figs. 2b and 2c: s_0 = 0, v_0 = 0.05 m/s, t_c = 2e-5 s.
struct Touching {
    method: &'static str,
    eps: f64,
    outcomes: Vec<Outcome>,
}

fn touching(id: &str, options: &Options) -> Result<Vec<Touching>> {
    let progress = Progress::new(id, (METHODS.len() * RESTITUTIONS.len() * BEADS.len()) as u64);
    let both = METHODS.iter().flat_map(|m| RESTITUTIONS.iter().map(move |e| (*m, *e)));
    let runs: Vec<_> = both.collect();
    let one = |&(method, eps): &(&'static str, f64)| {
        let law = ForceLaw::spring_of(1.0, 2e-5, eps)?;
        let beads = |&n: &usize| {
            let outcome = impact(method, &Column::new(n, 0.05, 0.0), &law, options.full);
            progress.add(1);
            outcome
        };
        let outcomes = BEADS.par_iter().map(beads).collect::<Result<_>>()?;
        Ok(Touching { method, eps, outcomes })
    };
    runs.par_iter().map(one).collect()
}

/// L94 Fig. 2b: 1 − ε_eff of beads in contact, against N.
///
/// # Errors
/// As [`impact`].
pub fn make_b(options: &Options) -> Result<Made> {
    let mut figure = Figure::new("l94-2b", ["N", "1 - ε_eff"]);
    for run in touching("l94-2b", options)? {
        let mut series = named(&run);
        for (n, outcome) in BEADS.iter().zip(&run.outcomes) {
            series.push(*n as f64, 1.0 - outcome.restitution());
        }
        figure = figure.with(series);
    }
    let slope = |eps: f64| {
        let md = figure.find(&[("method", "MD".into()), ("eps", eps.into())]);
        let of = |from: usize| {
            let fitted = |s: &Series| fit::slope(&s.x[from..], &s.y[from..]);
            md.map_or(f64::NAN, fitted)
        };
        format!("{:.3} (N ≥ 2), {:.3} (N ≥ 50)", of(1), of(5))
    };
    let notes = vec![
        Note::new("slope of MD, ε = 0.6", "-0.5", slope(0.6)),
        Note::new("slope of MD, ε = 0.975", "-0.315", slope(0.975)),
        Note::new("MD, N = 10, ε = 0.9", "not given", format!("{:.5}", at(&figure, "MD", 0.9))),
        Note::new("ED, N = 10, ε = 0.9", "0.659", format!("{:.5}", at(&figure, "ED", 0.9))),
        Note::new("eMD*, N = 10, ε = 0.9", "not given", format!("{:.5}", at(&figure, "eMD*", 0.9))),
        Note::new("ED, N = 10, ε = 0.6", "≈ 1", format!("{:.5}", at(&figure, "ED", 0.6))),
    ];
    let style = PlotStyle::new("Beads in contact hit a wall (L94 Fig. 2b)")
        .labels("*N*", "1 − ε_{eff}")
        .scales(Scale::LOG, Scale::LOG)
        .mark(line(&figure, 0.6, -0.5))
        .mark(line(&figure, 0.975, -0.315));
    let picture = draw::draw(&figure, &styled(style));
    Ok(Made { figure, picture, notes })
}

/// The paper's power law, through MD's value at N = 100.
fn line(figure: &Figure, eps: f64, slope: f64) -> Mark {
    let md = figure.find(&[("method", "MD".into()), ("eps", eps.into())]);
    let last = md.and_then(|series| series.y.last()).copied().unwrap_or(f64::NAN);
    let point = |n: f64| [n, last * (n / 100.0).powf(slope)];
    let name = format!("paper: slope {slope}").replace('-', "−");
    Mark::Curve(vec![point(5.0), point(100.0)], name)
}

fn at(figure: &Figure, method: &str, eps: f64) -> f64 {
    let series = figure.find(&[("method", method.into()), ("eps", eps.into())]);
    let ten = |s: &Series| s.x.iter().position(|n| *n == 10.0).map(|k| s.y[k]);
    series.and_then(ten).unwrap_or(f64::NAN)
}

fn named(run: &Touching) -> Series {
    Series::new(format!("{}, ε = {}", run.method, run.eps))
        .param("method", run.method)
        .param("eps", run.eps)
}

/// MD with lines and dots, ED with lines, eMD* with dots; one colour for each ε.
fn styled(style: PlotStyle) -> PlotStyle {
    let kinds = [Kind::Both, Kind::Line, Kind::Dots];
    let kinds: Vec<Kind> = kinds.iter().flat_map(|kind| [*kind; RESTITUTIONS.len()]).collect();
    let shade = |light: f32| {
        (0..RESTITUTIONS.len())
            .map(move |k| Colour::scale(0.85 * k as f64 / 4.0).with_opacity(light))
    };
    let colours = shade(1.0).chain(shade(0.45)).chain(shade(0.8)).collect();
    PlotStyle { colours, ..style.kinds(&kinds) }
}

/// L94 Fig. 2c: E_r/E_f of beads in contact, against N.
///
/// # Errors
/// As [`impact`].
pub fn make_c(options: &Options) -> Result<Made> {
    let mut figure = Figure::new("l94-2c", ["N", "E_r/E_f"]);
    for run in touching("l94-2c", options)? {
        let mut series = named(&run);
        for (n, outcome) in BEADS.iter().zip(&run.outcomes) {
            if let Some(share) = outcome.relative() {
                series.push(*n as f64, share);
            }
        }
        figure = figure.with(series);
    }
    let notes = vec![
        Note::new("MD, N = 10, ε = 0.9", "0.035", format!("{:.5}", at(&figure, "MD", 0.9))),
        Note::new("ED, N = 10, ε = 0.9", "not given", format!("{:.5}", at(&figure, "ED", 0.9))),
        Note::new("eMD*, N = 10, ε = 0.9", "not given", format!("{:.5}", at(&figure, "eMD*", 0.9))),
    ];
    let style = PlotStyle::new("Energy relative to the centre of mass (L94 Fig. 2c)")
        .labels("*N*", "*E*_{r}/*E*_{f}")
        .scales(Scale::LOG, Scale::LINEAR.from(0.0, 0.08))
        .mark(Mark::Points(vec![[10.0, 0.035]], "paper: N = 10, ε = 0.9".to_owned()));
    let picture = draw::draw(&figure, &styled(style));
    Ok(Made { figure, picture, notes })
}

/// N of the figure.
pub const LONG: [usize; 8] = [1, 2, 5, 10, 20, 50, 100, 200];
const SLOW: f64 = 0.05;

/// Name, β, γ, K/m (1/(s² m^β)) and D_n (1/(s m^γ)), as the paper gives them.
pub const LAWS: [(&str, [f64; 4]); 3] = [
    ("Hooke", [0.0, 0.0, 2e9, 3.17e3]),
    ("Hertz", [0.5, 0.0, 2e12, 2e3]),
    ("Hertz–Kuwabara–Kono", [0.5, 0.5, 2e12, 1e5]),
];

/// One of them, for beads of mass 1: the paper's m is the reduced mass (Sec. III A).
pub fn law([beta, gamma, per_mass, damping]: [f64; 4]) -> ForceLaw {
    ForceLaw::PowerLaw { stiffness: 0.5 * per_mass, beta, damping, gamma, tangential: 0.0 }
}

/// Makes the figure. `--full` changes nothing: exact MD of its longest columns finds no step that converges.
///
/// # Errors
/// An error of a method.
pub fn make_laws(_: &Options) -> Result<Made> {
    let runs = LAWS.map(|(name, numbers)| ("MD", name, numbers)).into_iter();
    let hooke = LAWS[0];
    let runs = runs.chain(["ED", "eMD*"].map(|method| (method, hooke.0, hooke.1)));
    let runs: Vec<(&str, &str, [f64; 4])> = runs.collect();
    let progress = Progress::new("l94-3", (runs.len() * LONG.len()) as u64);
    let one = |&(method, name, numbers): &(&str, &str, [f64; 4])| -> Result<Series> {
        let beads = |&n: &usize| {
            let outcome = impact(method, &Column::new(n, SLOW, 0.0), &law(numbers), false);
            progress.add(1);
            outcome.map(|outcome| outcome.restitution())
        };
        let y: Vec<f64> = LONG.par_iter().map(beads).collect::<Result<_>>()?;
        let mut series = Series::new(format!("{method}, {name}"))
            .param("method", method)
            .param("beta", numbers[0])
            .param("gamma", numbers[1]);
        LONG.iter().zip(y).for_each(|(n, y)| series.push(*n as f64, y));
        Ok(series)
    };
    let series = runs.par_iter().map(one).collect::<Result<Vec<_>>>()?;
    let figure =
        series.into_iter().fold(Figure::new("l94-3", ["N", "ε_eff"]), |f, series| f.with(series));
    let style = PlotStyle::new("Beads in contact, three force laws (L94 Fig. 3)")
        .labels("*N*", "ε_{eff}")
        .scales(Scale::LOG, Scale::LINEAR.from(-0.02, 1.05));
    let picture = draw::draw(&figure, &style);
    let notes = figure.series.iter().map(note_laws).collect();
    Ok(Made { figure, picture, notes })
}

fn note_laws(series: &Series) -> Note {
    let said = match series.name.as_str() {
        "MD, Hooke" => "increases with N",
        "ED, Hooke" => "close to 0 for large N(1 − ε)",
        "eMD*, Hooke" => "not given",
        _ => "varies little with N",
    };
    let span = |from: usize| format!("{:.4} (N = {})", series.y[from], series.x[from]);
    let ours = format!("{} to {}", span(1), span(series.y.len() - 1));
    Note::new(series.name.clone(), said, ours)
}
