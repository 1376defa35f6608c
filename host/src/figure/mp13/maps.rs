//! How does the matrix of restitution depend on its three parameters? Integrates the contact equation over MP13's Tables I and II; writes Figs. 3, 4 and 5.

use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::number::{fixed, significant};
use crate::parameter_space::{self, Space};
use crate::plot::matrix::{self, COEFFICIENTS, Coefficient, Maps};
use anyhow::Result;
use carom_tables::contact;
use carom_tables::read::{End, Groups, Law};

/// ln l~ of the cuts through Fig. 3.
const LEVELS: [f64; 5] = [-1.0, 0.0, 2.0, 5.0, 10.0];
/// ln(l~/l~^min) of the cuts through Figs. 4 and 5.
const CUTS: [f64; 3] = [1.0, 3.0, 10.0];
/// Points of a cut.
const POINTS: u32 = 14;

/// MP13 Fig. 3: ε_φ of elastic collisions.
///
/// # Errors
/// None; the signature is that of all figures.
pub fn make_3(_: &Options) -> Result<Made> {
    let space = Space::linear();
    let mut figure = Figure::new("mp13-3", ["ln c_φ", "ε_φ (rad)"]);
    for ln_l in LEVELS {
        let mut found = Series::new(format!("integrated, ln l~ = {ln_l}")).param("ln_l", ln_l);
        let mut hard = Series::new(format!("π c_φ/l~², ln l~ = {ln_l}")).param("ln_l", ln_l);
        for k in 0..200 {
            let ln_c = -6.0 + 0.125 * f64::from(k);
            let Some([u, w]) = space.near(ln_c, ln_l, 0.0) else { continue };
            let groups = Groups { c_dis: 0.0, ..space.groups(u, w, 0.0) };
            found.push(ln_c, contact::integrate(space.law, End::Force, &groups).angle);
            hard.push(ln_c, std::f64::consts::PI * (ln_c - 2.0 * ln_l).exp());
        }
        figure = figure.with(found.param("c_dis", 0.0)).with(hard.param("closed_form", "l~ >> 1"));
    }
    let notes = notes_3(&space, &figure);
    Ok(Made { figure, picture: matrix::fig3(), notes })
}

fn notes_3(space: &Space, figure: &Figure) -> Vec<Note> {
    let range = |[low, high]: [f64; 2]| format!("{} to {}", fixed(low, 3), fixed(high, 3));
    let mut notes = vec![
        Note::new("−½ ln(1/e² − 1), Eq. (45)", "-4.6 to 1.95", range(space.g)),
        Note::new("ln(l ω/v), Eq. (48)", "-2.3 to 14.83", range(space.m)),
    ];
    for pair in figure.series.chunks_exact(2) {
        let off = pair[0].y.iter().zip(&pair[1].y).map(|(found, hard)| (found / hard - 1.0).abs());
        let largest = pair[0].y.iter().copied().fold(0.0, f64::max);
        let ours = format!(
            "at most {} rad; off by up to {} from π c_φ/l~², the limit of hard spheres",
            significant(largest, 3),
            significant(off.fold(0.0, f64::max), 2)
        );
        notes.push(Note::new(pair[0].name.clone(), "only a picture", ours));
    }
    notes
}

/// MP13 Fig. 4: the linear dashpot.
///
/// # Errors
/// None; the signature is that of all figures.
pub fn make_4(_: &Options) -> Result<Made> {
    let maps = Maps::new(Law::LinearDashpot);
    Ok(made("mp13-4", &maps, Vec::new()))
}

/// MP13 Fig. 5: viscoelastic spheres.
///
/// # Errors
/// None; the signature is that of all figures.
pub fn make_5(_: &Options) -> Result<Made> {
    let maps = Maps::new(Law::Viscoelastic);
    let [low, high] = maps.space.m;
    let of_l = format!("{} to {}", fixed(low, 3), fixed(high, 3));
    let [low, high] = [parameter_space::c_min(), parameter_space::c_max()];
    let of_c = format!("{} to {}", fixed(low, 3), fixed(high, 3));
    let notes = vec![
        Note::new("ln(l (k/v²)^(2/5)), Eq. (56)", "0.75 to 13.66", of_l),
        Note::new("ln(3/2 A v/l), below Eq. (59)", "-18.71 to 9.84", of_c),
    ];
    Ok(made("mp13-5", &maps, notes))
}

fn made(id: &str, maps: &Maps, mut notes: Vec<Note>) -> Made {
    let mut figure = Figure::new(id, ["ln(c_φ/c_φ^min)", "coefficient"]);
    for damping in maps.dampings {
        for coefficient in COEFFICIENTS {
            for w in CUTS {
                figure = figure.with(cut(maps, damping, &coefficient, w));
            }
        }
    }
    notes.extend(remarks(maps));
    Made { figure, picture: maps.draw(), notes }
}

/// One coefficient along ln(c_φ/c_φ^min).
fn cut(maps: &Maps, damping: f64, coefficient: &Coefficient, w: f64) -> Series {
    let Maps { space, .. } = maps;
    let dissipation = match space.law {
        Law::LinearDashpot => "ln c_dis",
        Law::Viscoelastic => "ln(c_dis/c_dis^min)",
    };
    let name = format!("{}, {dissipation} = {damping}, ln(l~/l~^min) = {w}", coefficient.plain);
    let mut series = Series::new(name)
        .param("coefficient", coefficient.plain)
        .param("damping", damping)
        .param("ln_l_over_min", w);
    for k in 0..POINTS {
        let u = space.width() * f64::from(k) / f64::from(POINTS - 1);
        let found = contact::integrate(space.law, End::Force, &space.groups(u, w, damping));
        series.push(u, (coefficient.value)(&found));
    }
    series
}

/// What the paper says of each coefficient (Sec. V A), and whether it holds at all points.
fn remarks(maps: &Maps) -> [Note; 4] {
    let [angle, speed, _, tau] = COEFFICIENTS;
    let smaller = "falls as dissipation grows";
    [
        Note::new(
            "ε_φ",
            format!("{smaller}; elastic is the marginal case"),
            falls(maps, &angle, 1.0),
        ),
        Note::new("−ε_ṙ", format!("{smaller}, everywhere"), falls(maps, &speed, -1.0)),
        Note::new("ε_r", "some dissipation makes it smallest", lows(maps)),
        Note::new("ε_t", smaller, falls(maps, &tau, 1.0)),
    ]
}

/// A change below this is rounding.
const ROUNDING: f64 = 1e-9;

/// Whether a coefficient falls from each damping to the next, at all points; where not, how far up that goes.
fn falls(maps: &Maps, coefficient: &Coefficient, sign: f64) -> String {
    let value = |answer| sign * (coefficient.value)(answer);
    let (mut rises, mut most, mut highest) = (0_u32, 0.0_f64, 0);
    for rows in maps.answers.windows(2) {
        for (k, (before, after)) in rows[0].iter().zip(&rows[1]).enumerate() {
            let rise = value(after) - value(before);
            if rise > ROUNDING {
                (rises, most, highest) = (rises + 1, most.max(rise), highest.max(k));
            }
        }
    }
    let points = maps.answers[0].len();
    let steps = (maps.answers.len() - 1) * points;
    match rises {
        0 => format!("so at all {points} points"),
        _ => format!(
            "so in {:.1} % of the steps to the next row; rises by up to {}, all at ln(l~/l~^min) < {:.1}",
            100.0 - 100.0 * f64::from(rises) / steps as f64,
            significant(most, 2),
            maps.space.height() * ((highest / matrix::COLUMNS + 1) * matrix::COLUMNS) as f64
                / points as f64
        ),
    }
}

/// The smallest ε_r over the picture as a function of dissipation: where it is smallest, and at both ends of the table.
fn lows(maps: &Maps) -> String {
    let Maps { space, .. } = maps;
    let [first, last] = match space.law {
        Law::LinearDashpot => [-6.0, 4.0],
        Law::Viscoelastic => [0.0, parameter_space::c_max() - parameter_space::c_min()],
    };
    let low_at = |damping: f64| {
        let at = |k: u32| {
            let (u, w) = (f64::from(k % 20) / 19.0, f64::from(k / 20) / 49.0);
            let groups = space.groups(u * space.width(), w * space.height(), damping);
            contact::integrate(space.law, End::Force, &groups).separation
        };
        (0..1000).map(at).fold(f64::INFINITY, f64::min)
    };
    let dampings = (0..=40).map(|k| first + (last - first) * f64::from(k) / 40.0);
    let all: Vec<[f64; 2]> = dampings.map(|damping| [damping, low_at(damping)]).collect();
    let least = all.iter().fold([0.0, f64::INFINITY], |a, b| if b[1] < a[1] { *b } else { a });
    let shown =
        |[damping, low]: [f64; 2]| format!("{} at {}", significant(low, 3), fixed(damping, 1));
    format!(
        "smallest over l~ and c_φ: {}, {}, {} of ln c_dis or ln(c_dis/c_dis^min)",
        shown(all[0]),
        shown(least),
        shown(all[40])
    )
}
