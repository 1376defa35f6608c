//! What does the matrix of restitution look like? Reads the contact equation and the tables' ranges; writes MP13's Figs. 3, 4 and 5 as scenes.

use super::axes::{Axis, Field, NORMAL, Panel, SMALL, colour_bar};
use super::scene::{Colour, Rect, Scene};
use super::text::{Align, Style};
use carom_tables::contact;
use carom_tables::read::{End, Groups, Law, ScaledRestitution};
use rayon::prelude::*;
use std::f64::consts::PI;
use tiny_skia::PathBuilder;

/// MP13 Fig. 3: ε_φ of elastic linear-dashpot collisions over (ln c_φ, ln l~); white where Table I
/// does not reach.
pub fn fig3() -> Scene {
    let space = Space::linear();
    let (columns, rows) = (370usize, 240usize);
    let y_range = [space.m[0], space.m[1] + 2.2];
    let x_range = [y_range[0] + space.g[0], y_range[1] + space.g[1]];
    let value = |k: usize| {
        let x = spread(k % columns, columns, x_range);
        let y = spread(k / columns, rows, y_range);
        let Some([u, w]) = space.near(x, y, 0.3) else { return f64::NAN };
        let groups = Groups { c_dis: 0.0, ..space.groups(u, w, 0.0) };
        contact::integrate(space.law, End::Force, &groups).angle
    };
    let values = (0..columns * rows).into_par_iter().map(value).collect();
    let mut scene = Scene::new(440.0, 350.0);
    let place = Rect { x: 52.0, y: 56.0, width: 370.0, height: 240.0 };
    Field { columns, values }.draw(&mut scene, place, 0.0, PI);
    let (x, y) = (Axis::linear(x_range[0], x_range[1], 8), Axis::linear(y_range[0], y_range[1], 7));
    let panel = Panel { place, x, y };
    blank_outside(&mut scene, &panel, &space);
    panel.frame(&mut scene);
    panel.labels(&mut scene, "ln *c*_{φ}", "ln *l\u{303}*", 34.0);
    let bar = Rect { x: 222.0, y: 16.0, width: 200.0, height: 9.0 };
    colour_bar(&mut scene, bar, 0.0, PI);
    scene.text([bar.x - 8.0, 24.0], "*ε*_{φ} [rad]", Style::new(NORMAL, Colour::INK, Align::Right));
    scene
}

/// Covers what lies outside of Table I: the panel with the region left out.
fn blank_outside(scene: &mut Scene, panel: &Panel, space: &Space) {
    let Rect { x, y, width, height } = panel.place;
    let mut path = PathBuilder::new();
    // The panel runs against the clock and the region with it, so the region stays open.
    let corners = [[x, y], [x, y + height], [x + width, y + height], [x + width, y]];
    let rim: Vec<[f64; 2]> = space.rim(60).into_iter().map(|[a, b]| panel.at(a, b)).collect();
    for outline in [corners.as_slice(), rim.as_slice()] {
        for (number, [x, y]) in outline.iter().enumerate() {
            match number {
                0 => path.move_to(*x as f32, *y as f32),
                _ => path.line_to(*x as f32, *y as f32),
            }
        }
        path.close();
    }
    scene.shape(path.finish(), Some(Colour::WHITE), None, Some(panel.place));
}

/// MP13 Fig. 4 (linear dashpot) or Fig. 5 (viscoelastic): a row for each damping, a column for
/// each coefficient, over ln(c_φ/c_φ^min) and ln(l~/l~^min).
pub fn coefficients(law: Law) -> Scene {
    let (space, rows, name): (_, [f64; 5], _) = match law {
        Law::LinearDashpot => (Space::linear(), [-4.0, -1.0, 0.0, 1.0, 3.0], "ln *c*_{dis}"),
        Law::Viscoelastic => {
            let name = "ln *c*_{dis}/*c*_{dis}^{min}";
            (Space::viscoelastic(), [4.0, 8.0, 12.0, 16.0, 20.0], name)
        }
    };
    let mut scene = Scene::new(LEFT + 4.0 * (WIDE + GAP) + 8.0, TOP + 5.0 * (TALL + GAP) + 30.0);
    let answers: Vec<_> = rows.iter().map(|damping| sample(&space, *damping)).collect();
    for (column, coefficient) in COEFFICIENTS.iter().enumerate() {
        let value = coefficient.value;
        let [low, high] = coefficient.range(answers.iter().flatten());
        head(&mut scene, column, coefficient.name, [low, high]);
        for (row, answers) in answers.iter().enumerate() {
            let values = answers.iter().map(value).collect();
            Field { columns: COLUMNS, values }.draw(&mut scene, cell(row, column), low, high);
            panel(&space, row, column).frame(&mut scene);
        }
    }
    for (row, damping) in rows.iter().enumerate() {
        let at = [cell(row, 0).x + 6.0, cell(row, 0).y + 13.0];
        let text = format!("{name} = {damping}").replace('-', "−");
        scene.text(at, &text, Style::new(SMALL, Colour::WHITE, Align::Left));
    }
    let middle = [LEFT + 2.0 * (WIDE + GAP) - GAP / 2.0, scene.height - 10.0];
    let style = Style::new(NORMAL, Colour::INK, Align::Middle);
    scene.text(middle, "ln *c*_{φ}/*c*_{φ}^{min}", style);
    let middle = [14.0, TOP + 2.5 * (TALL + GAP)];
    scene.text(middle, "ln *l\u{303}*/*l\u{303}*^{min}", style.upwards());
    scene
}

const LEFT: f64 = 44.0;
const TOP: f64 = 52.0;
const WIDE: f64 = 128.0;
const TALL: f64 = 100.0;
const GAP: f64 = 9.0;
const COLUMNS: usize = 128;
const ROWS: usize = 100;

struct Coefficient {
    name: &'static str,
    /// The limits, where the values themselves shall not set them.
    low: Option<f64>,
    high: Option<f64>,
    value: fn(&ScaledRestitution<f64>) -> f64,
}

impl Coefficient {
    /// From the smallest to the largest value, rounded outwards to tenths.
    fn range<'a>(&self, answers: impl Iterator<Item = &'a ScaledRestitution<f64>>) -> [f64; 2] {
        let all = answers.map(self.value);
        let (low, high) = all
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        [
            self.low.unwrap_or((10.0 * low).floor() / 10.0),
            self.high.unwrap_or((10.0 * high).ceil() / 10.0),
        ]
    }
}

const COEFFICIENTS: [Coefficient; 4] = [
    Coefficient { name: "*ε*_{φ} [rad]", low: Some(0.0), high: None, value: |s| s.angle },
    Coefficient {
        name: "*ε*_{*r\u{307}*}", low: Some(-1.0), high: Some(0.0), value: |s| -s.speed
    },
    Coefficient { name: "*ε*_{*r*}", low: None, high: Some(1.0), value: |s| s.separation },
    Coefficient { name: "*ε*_{*t*}", low: Some(0.0), high: None, value: |s| s.tau },
];

fn spread(k: usize, count: usize, [low, high]: [f64; 2]) -> f64 {
    low + (high - low) * (k as f64 + 0.5) / count as f64
}

fn sample(space: &Space, damping: f64) -> Vec<ScaledRestitution<f64>> {
    (0..COLUMNS * ROWS)
        .into_par_iter()
        .map(|k| {
            let u = spread(k % COLUMNS, COLUMNS, [0.0, space.width()]);
            let w = spread(k / COLUMNS, ROWS, [0.0, space.height()]);
            contact::integrate(space.law, End::Force, &space.groups(u, w, damping))
        })
        .collect()
}

fn cell(row: usize, column: usize) -> Rect {
    let (x, y) = (LEFT + column as f64 * (WIDE + GAP), TOP + row as f64 * (TALL + GAP));
    Rect { x, y, width: WIDE, height: TALL }
}

fn panel(space: &Space, row: usize, column: usize) -> Panel {
    let x = Axis::linear(0.0, space.width(), 6);
    let y = Axis::linear(0.0, space.height(), 6);
    Panel {
        place: cell(row, column),
        x: if row == 4 { x } else { x.unlabelled() },
        y: if column == 0 { y } else { y.unlabelled() },
    }
}

fn head(scene: &mut Scene, column: usize, name: &str, [low, high]: [f64; 2]) {
    let Rect { x, width, .. } = cell(0, column);
    scene.text([x + width / 2.0, 14.0], name, Style::new(NORMAL, Colour::INK, Align::Middle));
    let bar = Rect { x: x + 4.0, y: 21.0, width: width - 8.0, height: 8.0 };
    colour_bar(scene, bar, low, high);
}

/// The smallest and largest eccentricity of both tables.
const ECCENTRICITY: [f64; 2] = [0.01, 0.99];
/// Radius (m), density (kg/m³) and speed (m/s), the same in both tables.
const RADIUS: [f64; 2] = [0.001, 0.1];
const DENSITY: [f64; 2] = [250.0, 3250.0];
const SPEED: [f64; 2] = [0.001, 25.0];
/// Spring constant (N/m), Table I.
const STIFFNESS: [f64; 2] = [1e3, 1e6];
/// Young modulus (Pa), Poisson ratio and dissipative parameter (s), Table II.
const YOUNG: [f64; 2] = [1e7, 1e11];
const POISSON: [f64; 2] = [0.2, 0.5];
const DISSIPATION: [f64; 2] = [1e-6, 1.0];

/// The space of scaled parameters of one law: MP13 Secs. V A and V B.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Space {
    /// The law.
    pub law: Law,
    /// Range of g = ln(c_φ/l~) = ln tan α, MP13 Eqs. (45) and (46).
    pub g: [f64; 2],
    /// Range of the first term of MP13 Eq. (48) or (55).
    pub m: [f64; 2],
}

impl Space {
    /// Table I.
    pub fn linear() -> Self {
        // l ω / v of two equal spheres
        let m = |k: f64, radius: f64, density: f64, v: f64| {
            (2.0 * radius * (k / effective_mass(radius, density)).sqrt() / v).ln()
        };
        let low = m(STIFFNESS[0], RADIUS[1], DENSITY[1], SPEED[1]);
        let high = m(STIFFNESS[1], RADIUS[0], DENSITY[0], SPEED[0]);
        Self { law: Law::LinearDashpot, g: g(), m: [low, high] }
    }

    /// Table II.
    pub fn viscoelastic() -> Self {
        // l (k/v²)^(2/5) of two equal spheres does not depend on their radius
        let m = |young: f64, poisson: f64, density: f64, v: f64| {
            let (radius, eff) = (1.0, 0.5f64);
            let rho = 2.0 * young * eff.sqrt() / (3.0 * (1.0 - poisson * poisson));
            (2.0 * radius * (rho / effective_mass(radius, density) / (v * v)).powf(0.4)).ln()
        };
        let low = m(YOUNG[0], POISSON[0], DENSITY[1], SPEED[1]);
        let high = m(YOUNG[1], POISSON[1], DENSITY[0], SPEED[0]);
        Self { law: Law::Viscoelastic, g: g(), m: [low, high] }
    }

    /// Extent of ln(c_φ/c_φ^min).
    pub fn width(&self) -> f64 {
        self.g[1] - self.g[0]
    }

    /// Extent of ln(l~/l~^min).
    pub fn height(&self) -> f64 {
        self.m[1] - self.m[0]
    }

    /// The groups at ln(c_φ/c_φ^min) = `u`, ln(l~/l~^min) = `w`: MP13 Eqs. (50) and (61).
    ///
    /// `damping` is ln c_dis for the linear law, ln(c_dis/c_dis^min) for the viscoelastic one.
    pub fn groups(&self, u: f64, w: f64, damping: f64) -> Groups<f64> {
        let tan = (u + self.g[0]).exp();
        let half = 0.5 * (tan * tan).ln_1p();
        let ln_l = |part: f64| w + self.m[0] + 2.0 * part * half;
        let (ln_l, ln_c) = match self.law {
            Law::LinearDashpot => (ln_l(0.5), damping),
            Law::Viscoelastic => {
                let ln_l = ln_l(0.4);
                (ln_l, damping + c_min() + ln_l - half)
            }
        };
        let cos = (-half).exp();
        Groups { sin: tan * cos, cos, eta: (-ln_l).exp(), c_dis: ln_c.exp() }
    }

    /// `u` and `w` of a point (ln c_φ, ln l~), or nothing where the table does not reach, not even
    /// with a margin.
    pub fn near(&self, ln_c_phi: f64, ln_l: f64, margin: f64) -> Option<[f64; 2]> {
        let g = ln_c_phi - ln_l;
        let m = ln_l - self.rise(g);
        let within = |x: f64, [low, high]: [f64; 2]| x >= low - margin && x <= high + margin;
        (within(g, self.g) && within(m, self.m)).then(|| [g - self.g[0], m - self.m[0]])
    }

    /// Points (ln c_φ, ln l~) around the region that the table reaches, clockwise.
    pub fn rim(&self, steps: u32) -> Vec<[f64; 2]> {
        let along =
            |[from, to]: [f64; 2], k: u32| from + (to - from) * f64::from(k) / f64::from(steps);
        let point = |g: f64, m: f64| [m + self.rise(g) + g, m + self.rise(g)];
        let ([left, right], [bottom, top]) = (self.g, self.m);
        let up = (0..steps).map(|k| point(left, along([bottom, top], k)));
        let over = (0..steps).map(|k| point(along([left, right], k), top));
        let down = (0..steps).map(|k| point(right, along([top, bottom], k)));
        let back = (0..steps).map(|k| point(along([right, left], k), bottom));
        up.chain(over).chain(down).chain(back).collect()
    }

    /// The second term of MP13 Eq. (48) or (55).
    fn rise(&self, g: f64) -> f64 {
        let part = if self.law == Law::LinearDashpot { 0.5 } else { 0.4 };
        part * (2.0 * g).exp().ln_1p()
    }
}

fn g() -> [f64; 2] {
    ECCENTRICITY.map(|e| -0.5 * (1.0 / (e * e) - 1.0).ln())
}

/// ln(3/2 A v / l) at its smallest, below MP13 Eq. (59).
fn c_min() -> f64 {
    (1.5 * DISSIPATION[0] * SPEED[0] / (2.0 * RADIUS[1])).ln()
}

/// m_eff of two equal spheres.
fn effective_mass(radius: f64, density: f64) -> f64 {
    2.0 / 3.0 * PI * density * radius.powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers that MP13 states: g from -4.6 to 1.95, m from -2.3 to 14.83 (Eq. 48) and from
    /// 0.75 to 13.66 (Eq. 56), c from -18.71 (below Eq. 59).
    #[test]
    fn ranges_are_those_of_the_paper() {
        let near = |a: f64, b: f64, by: f64| assert!((a - b).abs() <= by, "{a} against {b}");
        let (linear, viscoelastic) = (Space::linear(), Space::viscoelastic());
        near(linear.g[0], -4.6, 0.05);
        near(linear.g[1], 1.95, 0.005);
        near(linear.m[0], -2.3, 0.05);
        near(linear.m[1], 14.83, 0.005);
        near(viscoelastic.m[0], 0.75, 0.005);
        near(viscoelastic.m[1], 13.66, 0.005);
        near(c_min(), -18.71, 0.005);
    }

    #[test]
    fn groups_lead_back_to_the_axes() {
        let space = Space::linear();
        let groups = space.groups(3.0, 5.0, 0.0);
        let ln_l = -groups.eta.ln();
        let ln_c_phi = ln_l + (groups.sin / groups.cos).ln();
        let [u, w] = space.near(ln_c_phi, ln_l, 0.0).expect("inside Table I");
        assert!((u - 3.0).abs() < 1e-12 && (w - 5.0).abs() < 1e-12, "{u} {w}");
    }
}
