//! How is a table made of one pair of bodies under a force law of one's own? Reads the force; writes a fitted, certified table as Rust text.

use super::emit;
use super::error::Error;
use super::pair_fit::{Column, fit, largest_error};
use crate::pair_contact::{Endless, Pair};
use crate::read::pair::{PairCertificate, PairTable};
use std::cell::Cell;
use std::path::Path;

/// A recipe for the table of one pair of bodies, or of one and a plane, under any force law without a state.
///
/// The force is a function of the overlap, of its rate, and of two numbers that the contact remembers: the signature of
/// carom's `ContactLaw`. A law that writes into these has a state, and no table.
///
/// ```
/// use carom_tables::recipe::PairRecipe;
/// // Two spheres of 1 kg that touch at 0.2 m: F = k x^1.75 + γ x^0.6 ẋ, never an attraction.
/// let force = |x: f64, rate: f64, _: &mut [f64; 2]| {
///     (1e8 * x.powf(1.75) + 1e4 * x.powf(0.6) * rate).max(0.0)
/// };
/// let recipe = PairRecipe::new([0.2, 0.5], force).speeds(0.1, 1.0).across(1.0).tolerance(1e-4);
/// let text = recipe.emit("BALLS", "::carom_tables::read")?;
/// assert!(text.contains("pub static BALLS: ::carom_tables::read::PairTable<f32>"));
/// # Ok::<(), carom_tables::recipe::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct PairRecipe<F> {
    force: F,
    contact_distance: f64,
    reduced_mass: f64,
    speeds: [f64; 2],
    across: f64,
    tolerance: f64,
    points: usize,
}

impl<F: Fn(f64, f64, &mut [f64; 2]) -> f64> PairRecipe<F> {
    /// Two bodies that touch at this distance R₁ + R₂ and have this reduced mass, and the force that drives them apart.
    /// Speeds from 0.01 to 1, and as much across, if nothing else is said; a tolerance of 1e-5.
    pub fn new([contact_distance, reduced_mass]: [f64; 2], force: F) -> Self {
        let (speeds, across, tolerance, points) = ([0.01, 1.0], 1.0, 1e-5, 2000);
        Self { force, contact_distance, reduced_mass, speeds, across, tolerance, points }
    }

    /// From the slowest to the fastest speed of approach along the line of centres.
    #[must_use]
    pub fn speeds(self, slowest: f64, fastest: f64) -> Self {
        Self { speeds: [slowest, fastest], ..self }
    }

    /// The fastest speed across the line of centres.
    #[must_use]
    pub fn across(self, across: f64) -> Self {
        Self { across, ..self }
    }

    /// The largest error wanted: of the duration (relative), of the restitution, of the angle (radians).
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// At how many random speeds the certificate is measured; 2,000 if nothing else is said.
    #[must_use]
    pub fn points(self, points: usize) -> Self {
        Self { points, ..self }
    }

    /// The table. Its coefficients live as long as the program.
    ///
    /// # Errors
    /// A number that makes no sense; a law that remembers, that is not finite, that does not hold two of these speeds
    /// apart, or under which they do not part; a tolerance that would take more than 64 pieces.
    pub fn generate(&self) -> Result<PairTable<f32>, Error> {
        self.check()?;
        let (remembers, bad) = (Cell::new(false), Cell::new(None));
        let force = |x: f64, rate: f64| {
            let mut memory = [0.0; 2];
            let force = (self.force)(x, rate, &mut memory);
            remembers.set(remembers.get() || memory != [0.0; 2]);
            if !force.is_finite() {
                bad.set(Some(x));
            }
            force
        };
        let pair = Pair {
            contact_distance: self.contact_distance,
            reduced_mass: self.reduced_mass,
            force: &force,
        };
        let exact = |speeds: [f64; 2]| -> Result<Column, Error> {
            let hit = pair.collide(speeds);
            if let Some(x) = bad.get() {
                return Err(Error::field(
                    "overlap",
                    x,
                    "one at which the law gives a finite force",
                ));
            }
            if remembers.get() {
                let wanted = "one without a state: a table cannot remember, integrate this one";
                return Err(Error::field("law", "one that remembers", wanted));
            }
            hit.map_err(|why| endless(why, speeds))
        };
        let table = fit(self.unmeasured(), self.tolerance, &exact)?;
        let largest = largest_error(&table, self.points, &exact)?;
        let certificate = PairCertificate { largest, points: self.points, ..table.certificate };
        Ok(PairTable { certificate, ..table })
    }

    /// The table as Rust text: `pub static NAME: PairTable<f32> = ...;`. `reader_path` is the path of carom-tables' module
    /// `read` there.
    ///
    /// # Errors
    /// As [`generate`](Self::generate), and a name that is none.
    pub fn emit(&self, name: &str, reader_path: &str) -> Result<String, Error> {
        if !emit::is_name(name) {
            return Err(Error::field("name", name, "a Rust name such as MY_TABLE"));
        }
        let table = self.generate()?;
        let c = &table.certificate;
        Ok(format!(
            "/// Contacts of one pair of bodies: {} bytes, largest error of the restitution {:e}.\n\
             pub static {name}: {reader_path}::PairTable<f32> = {reader_path}::PairTable {{\n\
             certificate: {reader_path}::{c:?},\npieces: {:?}, time: {:?}, span: {:?},\n\
             coefficients: &{:?} }};\n",
            c.bytes, c.largest[1], table.pieces, table.time, table.span, table.coefficients
        ))
    }

    /// Writes the table as Rust text into a file, whole or not at all.
    ///
    /// # Errors
    /// As [`emit`](Self::emit), and a file that cannot be written.
    pub fn write(
        &self,
        path: impl AsRef<Path>,
        name: &str,
        reader_path: &str,
    ) -> Result<(), Error> {
        emit::write(path.as_ref(), &self.emit(name, reader_path)?)
    }

    fn check(&self) -> Result<(), Error> {
        let [slowest, fastest] = self.speeds;
        for (field, value) in [
            ("contact_distance", self.contact_distance),
            ("reduced_mass", self.reduced_mass),
            ("slowest", slowest),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::field(field, value, "finite and above 0"));
            }
        }
        if !(fastest > slowest && fastest.is_finite()) {
            return Err(Error::field("fastest", fastest, "finite and above the slowest speed"));
        }
        if !(self.across >= 0.0 && self.across.is_finite()) {
            return Err(Error::field("across", self.across, "finite and at least 0"));
        }
        if !(1e-6..=0.1).contains(&self.tolerance) {
            return Err(Error::field("tolerance", self.tolerance, "between 1e-6 and 0.1"));
        }
        Ok(())
    }

    fn unmeasured(&self) -> PairCertificate {
        PairCertificate {
            contact_distance: self.contact_distance,
            reduced_mass: self.reduced_mass,
            speeds: self.speeds,
            across: self.across,
            bytes: 0,
            largest: [0.0; 3],
            points: 0,
        }
    }
}

fn endless(why: Endless, [normal, tangential]: [f64; 2]) -> Error {
    let speeds = format!("one that at the speeds {normal} along and {tangential} across");
    let (value, wanted) = match why {
        Endless::Passes => ("does not stop the two", "one that pushes them apart"),
        Endless::Holds => {
            ("does not let the two part", "one whose contacts end, or speeds at which they do")
        }
    };
    Error::field("law", format!("{speeds} {value}"), wanted)
}
