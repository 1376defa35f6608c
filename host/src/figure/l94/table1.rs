//! How do depth, duration and loss of a contact grow with the impact speed? Reads exponents β and γ; writes L94 Table I, measured.

use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::figure::fit::slope;
use crate::figure::number::fixed;
use crate::plot::text::{Align, Style};
use crate::plot::{Colour, NORMAL, SMALL, Scene, Stroke};
use anyhow::Result;
use carom_reference::{End, ForceLaw, Grain, ReferenceError, collide};

/// β and γ of Table I. Two misprints: β of the third row is 1/2, and ν_2 of the fourth is −1/5.
pub const ROWS: [[f64; 2]; 5] = [[0.0, 0.0], [0.0, 0.2], [0.5, 0.0], [0.5, 0.5], [0.5, 0.25]];
/// ν1, ν2, ν3 as the table prints them, row by row.
const PRINTED: [&str; 5] =
    ["1, 0, 0", "1, 0, 1/5", "4/5, −1/5, −1/5 (at β = 1)", "4/5, −3/5, 1/5", "4/5, −1/5, 0"];
/// Impact speeds of the fit (m/s).
const SPEEDS: [f64; 4] = [1e-3, 1e-2, 1e-1, 1.0];
/// 1 − ε at 1 m/s, about: the exponents are those of weak dissipation.
const LOSS: f64 = 1e-5;

/// x_max, t_c and 1 − ε of one central impact of two grains of mass 1 and diameter 1 mm.
fn impact(law: &ForceLaw, speed: f64) -> Result<[f64; 3], ReferenceError> {
    let grain = |x: f64, v: f64| Grain { radius: 5e-4, mass: 1.0, position: [x], velocity: [v] };
    let pair = [grain(0.0, speed), grain(1e-3, 0.0)];
    let hit = collide(pair, *law, End::Overlap, &[])?;
    let loss = 1.0 + hit.eps_rdot;
    Ok([deepest(pair, law, hit.duration)?, hit.duration, loss])
}

/// The largest overlap: looked for three times, each time thirty times as finely.
fn deepest(pair: [Grain<1>; 2], law: &ForceLaw, duration: f64) -> Result<f64, ReferenceError> {
    let (mut from, mut to, mut found) = (0.0, duration, 0.0);
    for _ in 0..3 {
        let step = (to - from) / 60.0;
        let times: Vec<f64> = (0..=60).map(|k| from + step * f64::from(k)).collect();
        let path = collide(pair, *law, End::Overlap, &times)?.path;
        let overlaps = path.iter().map(|[a, b]| 1e-3 - (b[0] - a[0]));
        let (at, most) = times
            .iter()
            .zip(overlaps)
            .fold((0.0, 0.0), |best, (t, x)| if x > best.1 { (*t, x) } else { best });
        (from, to, found) = ((at - step).max(0.0), (at + step).min(duration), most);
    }
    Ok(found)
}

/// ν_1, ν_2, ν_3 in x_max ∝ v^{ν1}, t_c ∝ v^{ν2}, 1 − ε ∝ v^{ν3}, fitted.
///
/// # Errors
/// As [`collide`].
pub fn measured([beta, gamma]: [f64; 2]) -> Result<[f64; 3], ReferenceError> {
    let stiffness = 1e9;
    let law =
        |damping: f64| ForceLaw::PowerLaw { stiffness, beta, damping, gamma, tangential: 0.0 };
    // 1 − ε is proportional to D_n where it is small.
    let trial = impact(&law(1.0), 1.0)?[2];
    let law = law(LOSS / trial);
    let all: Result<Vec<[f64; 3]>, _> = SPEEDS.iter().map(|v| impact(&law, *v)).collect();
    let all = all?;
    Ok(std::array::from_fn(|k| slope(&SPEEDS, &all.iter().map(|x| x[k]).collect::<Vec<_>>())))
}

/// The same by L94 Eqs. (A1), (A2), (A4).
pub fn theory([beta, gamma]: [f64; 2]) -> [f64; 3] {
    [2.0, -beta, 2.0 * gamma - beta].map(|above| above / (2.0 + beta) + 0.0)
}

/// Makes the table.
///
/// # Errors
/// As [`collide`].
pub fn make(_: &Options) -> Result<Made> {
    let axes = ["k: ν1 of x_max, ν2 of t_c, ν3 of 1 - ε", "exponent ν_k of v0"];
    let mut figure = Figure::new("l94-table1", axes);
    let (mut notes, mut wanted) = (Vec::new(), Vec::new());
    for (row, printed) in ROWS.into_iter().zip(PRINTED) {
        let (found, right) = (measured(row)?, theory(row));
        let [beta, gamma] = row;
        let mut series = Series::new(format!("MD, β = {beta}, γ = {gamma}"))
            .param("method", "MD")
            .param("beta", beta)
            .param("gamma", gamma);
        for k in 0..3 {
            series.push(k as f64 + 1.0, found[k]);
            series = series.param(["nu1_theory", "nu2_theory", "nu3_theory"][k], right[k]);
            wanted.push([k as f64 + 1.0, right[k]]);
        }
        figure = figure.with(series);
        let shown = |nu: [f64; 3]| nu.map(|nu| fixed(nu, 5)).join(", ");
        let what = format!("ν1, ν2, ν3 for β = {beta}, γ = {gamma}");
        notes.push(Note::new(what, printed, shown(found)).theory(shown(right)));
    }
    let style = PlotStyle::new("Exponents of the impact speed (L94 Table I)")
        .labels("*k*: ν_{1} of *x*_{max}, ν_{2} of *t*_{c}, ν_{3} of 1 − ε", "ν_{k}")
        .scales(Scale::LINEAR.from(0.5, 3.5), Scale::LINEAR.from(-0.4, 1.1))
        .kinds(&[Kind::Dots])
        .mark(Mark::Points(wanted, "Eqs. (A1), (A2), (A4)".to_owned()));
    let picture = draw::beside(table(&notes), draw::draw(&figure, &style));
    let figure = ROWS.into_iter().fold(figure, |figure, row| figure.with(by_theory(row)));
    Ok(Made { figure, picture, notes })
}

/// Left ends of the table's columns, and its right end.
const COLUMNS: [f64; 6] = [24.0, 58.0, 92.0, 240.0, 366.0, 488.0];
/// Height of a line of the table.
const LINE: f64 = 24.0;

/// The table as the paper sets it, with two columns more.
fn table(notes: &[Note]) -> Scene {
    let mut scene = Scene::new(COLUMNS[5] + 20.0, 354.0);
    let letters = |size| Style::new(size, Colour::INK, Align::Left);
    let title = "Exponents of the impact speed (L94 Table I)";
    scene.text([COLUMNS[0], 20.0], title, letters(11.0));
    let heads = ["β", "γ", "the paper prints", "(A1), (A2), (A4)", "MD"];
    let mut y = 56.0;
    let rule = |scene: &mut Scene, y: f64, width: f32| {
        let ends = [[COLUMNS[0] - 6.0, y], [COLUMNS[5], y]];
        scene.line(&ends, Stroke::solid(Colour::INK, width), None);
    };
    rule(&mut scene, y - 16.0, 1.2);
    heads.iter().zip(COLUMNS).for_each(|(head, x)| scene.text([x, y], head, letters(SMALL)));
    rule(&mut scene, y + 8.0, 0.6);
    for ([beta, gamma], note) in ROWS.iter().zip(notes) {
        y += LINE;
        let cells = [&beta.to_string(), &gamma.to_string(), &note.paper, &note.theory, &note.ours];
        for (cell, x) in cells.into_iter().zip(COLUMNS) {
            scene.text([x, y], &cell.replace('-', "−"), letters(SMALL));
        }
    }
    rule(&mut scene, y + 10.0, 1.2);
    let below = "Three exponents each: ν_{1} of *x*_{max}, ν_{2} of *t*_{c}, ν_{3} of 1 − ε.";
    scene.text([COLUMNS[0], y + 32.0], below, letters(NORMAL));
    scene
}

fn by_theory([beta, gamma]: [f64; 2]) -> Series {
    let series = Series::new(format!("Eqs. (A1), (A2), (A4), β = {beta}, γ = {gamma}"))
        .param("method", "theory")
        .param("beta", beta)
        .param("gamma", gamma);
    let nu = theory([beta, gamma]);
    (1..).zip(nu).fold(series, |series, (k, nu)| series.point(f64::from(k), nu))
}
