//! What does each listed collision lead to? Reads CSV rows and a table or the contact equation; writes results as CSV.

pub use crate::rows::BadRow;
use crate::rows::{self, Row};
use crate::scale::{Contact, Impact, Pair};
use anyhow::{Result, bail};
use carom_tables::contact;
use carom_tables::read::{End, Groups, Law, ScaledRestitution};
use std::io::{Read, Write};

/// Where the matrix of restitution comes from.
pub trait Restitution {
    /// The scaled coefficients, or nothing outside the range of validity.
    fn restitution(&self, law: Law, groups: &Groups<f64>) -> Option<ScaledRestitution<f64>>;

    /// The nearest groups inside the range of validity.
    fn clamp(&self, law: Law, groups: &Groups<f64>) -> Groups<f64>;
}

/// The contact equation, integrated to 1e-12 for each case.
#[derive(Clone, Copy, Debug)]
pub struct Integrated(
    /// Which condition ends the contact.
    pub End,
);

impl Restitution for Integrated {
    fn restitution(&self, law: Law, groups: &Groups<f64>) -> Option<ScaledRestitution<f64>> {
        Some(contact::integrate(law, self.0, groups))
    }

    fn clamp(&self, _law: Law, groups: &Groups<f64>) -> Groups<f64> {
        *groups
    }
}

/// What a case led to; the numbers are those of MP13's matrix of restitution, Eqs. (16) to (21).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// Duration of the contact τ (s).
    pub tau: f64,
    /// ε_t, the duration in units of T.
    pub eps_t: f64,
    /// 1 − ε_r, computed without cancellation.
    pub one_minus_eps_r: f64,
    /// ε_ṙ, negative.
    pub eps_rdot: f64,
    /// ε_φ (rad).
    pub eps_phi: f64,
}

/// One case's result: the coefficients (if there are any) and whether the case was inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// The coefficients; nothing when outside and not clamped.
    pub coefficients: Option<Coefficients>,
    /// Whether the case lies in the range of validity.
    pub inside: bool,
}

/// Looks one case up; outside the range, takes the nearest groups inside if `clamp` is set.
pub fn solve(source: &dyn Restitution, case: &Case, end: End, clamp: bool) -> Outcome {
    let law = case.contact.law();
    let groups = &case.impact.groups;
    if let Some(scaled) = source.restitution(law, groups) {
        return Outcome {
            coefficients: Some(coefficients(&case.impact, &scaled, end)),
            inside: true,
        };
    }
    let nearest = || {
        let impact = Impact { groups: source.clamp(law, groups), ..case.impact };
        let scaled = source.restitution(law, &impact.groups)?;
        Some(coefficients(&impact, &scaled, end))
    };
    Outcome { coefficients: if clamp { nearest() } else { None }, inside: false }
}

fn coefficients(impact: &Impact, scaled: &ScaledRestitution<f64>, end: End) -> Coefficients {
    Coefficients {
        tau: scaled.tau * impact.time,
        eps_t: scaled.tau,
        one_minus_eps_r: impact.shortfall(scaled, end),
        eps_rdot: -scaled.speed,
        eps_phi: scaled.angle,
    }
}

/// Writes the results as CSV, each number with as many digits as a double needs; a bad row has the status `bad` and no
/// numbers.
///
/// # Errors
/// An error of `sink`.
pub fn write<'a>(
    sink: &mut dyn Write,
    results: impl IntoIterator<Item = (&'a str, Option<Outcome>)>,
) -> Result<()> {
    let mut writer = csv::Writer::from_writer(sink);
    writer.write_record([
        "id",
        "tau",
        "eps_t",
        "one_minus_eps_r",
        "eps_rdot",
        "eps_phi",
        "status",
    ])?;
    for (id, outcome) in results {
        let status = match outcome {
            Some(Outcome { inside: true, .. }) => "ok",
            Some(_) => "outside",
            None => "bad",
        };
        let numbers = outcome.and_then(|outcome| outcome.coefficients).map_or_else(
            || std::array::from_fn(|_| String::new()),
            |a| {
                [a.tau, a.eps_t, a.one_minus_eps_r, a.eps_rdot, a.eps_phi].map(|x| format!("{x:?}"))
            },
        );
        let mut row = vec![id];
        row.extend(numbers.iter().map(String::as_str));
        row.push(status);
        writer.write_record(row)?;
    }
    writer.flush()?;
    Ok(())
}

/// The columns a collision file must have; others are ignored.
pub const COLUMNS: [&str; 13] =
    ["id", "law", "k", "gamma", "Y", "nu", "A", "R1", "R2", "m1", "m2", "v", "e"];

/// One isolated collision of two spheres.
#[derive(Clone, Debug)]
pub struct Case {
    /// The row's own name, given back in the coefficients.
    pub id: String,
    /// Physical parameters in scaled form.
    pub impact: Impact,
    /// The law with its material.
    pub contact: Contact,
    /// Radii and masses.
    pub pair: Pair,
    /// Relative speed v (m/s).
    pub speed: f64,
    /// Eccentricity e = d/l.
    pub eccentricity: f64,
}

/// Reads every row of a CSV file with a header.
///
/// # Errors
/// A missing column, or a file that cannot be read on.
///
/// ```
/// let text = "id,law,k,gamma,Y,nu,A,R1,R2,m1,m2,v,e\nfig6,lsd,2000,0,,,,0.1,0.1,4.775,4.775,5,0.3\nb,wax\n";
/// let rows = carom_host::collide::read(text.as_bytes()).unwrap();
/// assert_eq!(rows[0].as_ref().unwrap().id, "fig6");
/// assert!(rows[1].as_ref().unwrap_err().why.contains("line 3"));
/// ```
pub fn read(source: impl Read) -> Result<Vec<Result<Case, BadRow>>> {
    rows::read(source, &COLUMNS, |row| row.case())
}

/// What is to be said of a law that has no table.
fn hint(law: &str) -> &'static str {
    let has_none = ["constant", "power", "walton-braun", "dmt", "jkr"].contains(&law);
    if has_none { "; it has no table: --with forces" } else { "" }
}

impl Row<'_> {
    /// The law that a row names.
    pub(crate) fn contact(&self) -> Result<Contact> {
        match self.text("law") {
            "lsd" => Ok(Contact::LinearDashpot {
                stiffness: self.positive("k", "a spring constant [N/m]")?,
                damping: self.not_negative("gamma", "a dissipative parameter [kg/s]")?,
            }),
            "viscoelastic" => Ok(Contact::Viscoelastic {
                young: self.positive("Y", "a Young modulus [Pa]")?,
                poisson: self.number("nu", "a Poisson ratio above -1 and up to 0.5", |x| {
                    x > -1.0 && x <= 0.5
                })?,
                dissipation: self.not_negative("A", "a dissipative parameter [s]")?,
            }),
            other => bail!("column `law`: `{other}` is not `lsd` or `viscoelastic`{}", hint(other)),
        }
    }

    /// Radii and masses; relative speed and eccentricity.
    pub(crate) fn pair(&self) -> Result<(Pair, [f64; 2])> {
        let radii = [self.positive("R1", "a radius [m]")?, self.positive("R2", "a radius [m]")?];
        let masses = [self.positive("m1", "a mass [kg]")?, self.positive("m2", "a mass [kg]")?];
        let speed = self.positive("v", "a relative speed [m/s]")?;
        let eccentricity =
            self.number("e", "an eccentricity d/l from 0 to below 1", |x| (0.0..1.0).contains(&x))?;
        Ok((Pair { radii, masses }, [speed, eccentricity]))
    }

    fn case(&self) -> Result<Case> {
        let contact = self.contact()?;
        let (pair, [speed, eccentricity]) = self.pair()?;
        let impact = Impact::new(&contact, &pair, speed, eccentricity);
        let groups = impact.groups;
        if ![groups.eta, groups.c_dis, impact.time].iter().all(|x| x.is_finite()) {
            bail!(
                "the scaled groups are not finite (eta = {}, c_dis = {}): numbers of a usual size are needed",
                groups.eta,
                groups.c_dis
            );
        }
        let id = self.text("id").to_owned();
        Ok(Case { id, impact, contact, pair, speed, eccentricity })
    }
}
