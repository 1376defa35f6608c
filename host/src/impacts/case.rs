//! Which impacts are listed? Reads CSV rows; writes cases: two grains, how they meet, and the law of their contact.

use crate::collide;
use crate::rows::{self, BadRow};
use crate::scale::{Contact, Pair};
use anyhow::{Result, bail, ensure};
use carom::law::{Adhesive, PowerLaw, Tangential, WaltonBraun};
use std::io::Read;

/// The columns that a file must have; a law may need more.
pub const COLUMNS: [&str; 13] = collide::COLUMNS;

/// The law of a contact along the line of centres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// Spring and dashpot, or viscoelastic spheres.
    Soft(Contact),
    /// A constant coefficient of restitution, without duration.
    Constant {
        /// ε.
        restitution: f64,
    },
    /// Any powers of the overlap.
    Power(PowerLaw<f64>),
    /// Springs that stay pressed.
    WaltonBraun(WaltonBraun<f64>),
    /// Adhesion after Derjaguin, Muller and Toporov.
    Dmt(Adhesive<f64>),
    /// Adhesion after Johnson, Kendall and Roberts.
    Jkr(Adhesive<f64>),
}

/// What surfaces do to each other, and the grains' moment of inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surfaces {
    /// The law across the line of centres.
    pub tangential: Tangential<f64>,
    /// q = I/(m R²).
    pub inertia: f64,
}

/// One impact of two spheres in a plane.
#[derive(Clone, Debug)]
pub struct Case {
    /// The row's own name.
    pub id: String,
    /// The law.
    pub law: Law,
    /// A constant force that holds the two (N), of laws that are not `Soft` nor `Constant`.
    pub cohesion: f64,
    /// Radii and masses.
    pub pair: Pair,
    /// The relative velocity of the first: along the normal, which points from the second to it, and across (m/s).
    pub velocity: [f64; 2],
    /// The angular velocities (1/s), anticlockwise.
    pub spins: [f64; 2],
}

/// Reads every row of a CSV file with a header.
///
/// # Errors
/// A missing column, or a file that cannot be read on.
///
/// ```
/// let text = "id,law,k,gamma,Y,nu,A,R1,R2,m1,m2,v,e,unloading,w1\na,walton-braun,1e6,,,,,0.1,0.1,1,1,2,0.5,4e6,3\n";
/// let rows = carom_host::impacts::read(text.as_bytes()).unwrap();
/// let case = rows[0].as_ref().unwrap();
/// assert_eq!((case.velocity[1], case.spins), (1.0, [3.0, 0.0]));
/// ```
pub fn read(source: impl Read) -> Result<Vec<Result<Case, BadRow>>> {
    rows::read(source, &COLUMNS, case)
}

fn case(row: &rows::Row<'_>) -> Result<Case> {
    let law = law(row)?;
    let cohesion = row.number_or_zero("cohesion", "a force [N] of at least 0", |x| x >= 0.0)?;
    let holds = !matches!(law, Law::Soft(_) | Law::Constant { .. });
    ensure!(
        holds || cohesion == 0.0,
        "column `cohesion`: `{cohesion}` is not 0, and law `{}` has none; power, walton-braun, dmt and jkr have",
        row.text("law")
    );
    let (pair, [speed, e]) = row.pair()?;
    let spin = |column| row.number_or_zero(column, "an angular velocity [1/s]", |_| true);
    let spins = [spin("w1")?, spin("w2")?];
    let velocity = [-speed * ((1.0 - e) * (1.0 + e)).sqrt(), speed * e];
    Ok(Case { id: row.text("id").to_owned(), law, cohesion, pair, velocity, spins })
}

fn law(row: &rows::Row<'_>) -> Result<Law> {
    Ok(match row.text("law") {
        "lsd" | "viscoelastic" => Law::Soft(row.contact()?),
        "constant" => {
            let wanted = "a coefficient between 0 and 1";
            let within = |x| (0.0..=1.0).contains(&x);
            Law::Constant { restitution: row.number("restitution", wanted, within)? }
        }
        "power" => Law::Power(PowerLaw {
            stiffness: row.positive("k", "a spring constant [N/m^exponent]")?,
            exponent: row.number("exponent", "an exponent between 1 and 16", |x| {
                (1.0..=16.0).contains(&x)
            })?,
            damping: row.not_negative("gamma", "a dissipative parameter")?,
            damping_exponent: row.not_negative("damping_exponent", "an exponent")?,
        }),
        "walton-braun" => {
            let loading = row.positive("k", "a spring constant [N/m]")?;
            let unloading = row.positive("unloading", "a spring constant [N/m]")?;
            ensure!(
                unloading >= loading,
                "column `unloading`: `{unloading}` is not a spring constant [N/m] of at least k, {loading}"
            );
            Law::WaltonBraun(WaltonBraun { loading, unloading })
        }
        "dmt" => Law::Dmt(adhesive(row)?),
        "jkr" => Law::Jkr(adhesive(row)?),
        other => bail!(
            "column `law`: `{other}` is not `lsd`, `viscoelastic`, `constant`, `power`, `walton-braun`, `dmt` or `jkr`"
        ),
    })
}

fn adhesive(row: &rows::Row<'_>) -> Result<Adhesive<f64>> {
    Ok(Adhesive {
        young: row.positive("Y", "a Young modulus [Pa]")?,
        poisson: row
            .number("nu", "a Poisson ratio above -1 and up to 0.5", |x| x > -1.0 && x <= 0.5)?,
        dissipation: row.not_negative("A", "a dissipative parameter [s]")?,
        work: row.not_negative("work", "a work of adhesion [J/m2]")?,
    })
}
