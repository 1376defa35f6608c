//! `carom collide --with forces`: what do impacts with friction, spin and adhesion lead to? Reads a CSV file; writes CSV, the engine's answer and the reference's side by side.

use crate::impacts::{self, Both, Case, Surfaces};
use crate::rows::{self, BadRow};
use crate::scenario::{FrictionSpec, SPHERE};
use anyhow::{Context, Result, anyhow, ensure};
use carom::law::{HardSphere, Rough, Rule};
use clap::Args;
use std::io::{BufWriter, Read, Write};
use toml::{Table, Value};

/// Surfaces, by the words of a scenario's `[friction]`.
#[derive(Args, Debug)]
#[group(id = "surfaces")]
pub struct Options {
    /// With forces: what surfaces do across the line of centres, constant, walton or spring.
    #[arg(long, value_name = "KIND")]
    friction: Option<String>,
    /// The coefficient of tangential restitution, from -1 to 1 (constant).
    #[arg(long, allow_negative_numbers = true)]
    beta: Option<f64>,
    /// Coulomb's coefficient of friction (walton, spring).
    #[arg(long, allow_negative_numbers = true)]
    mu: Option<f64>,
    /// The same of surfaces that stick, from -1 to 1; 0 if left out (walton).
    #[arg(long, allow_negative_numbers = true)]
    beta_0: Option<f64>,
    /// k_t in N/m (spring).
    #[arg(long, allow_negative_numbers = true)]
    stiffness: Option<f64>,
    /// The dashpot beside it in kg/s; 0 if left out (spring).
    #[arg(long, allow_negative_numbers = true)]
    damping: Option<f64>,
    /// I/(m R^2): 0.4 for spheres, if left out; 0.5 for disks.
    #[arg(long, allow_negative_numbers = true)]
    inertia: Option<f64>,
    /// With forces: the engine's steps in a contact; 512 if left out.
    #[arg(long)]
    steps: Option<u32>,
}

impl Options {
    /// What is given of friction, by the scenario's names.
    fn given(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let all = [
            ("beta", self.beta),
            ("mu", self.mu),
            ("beta_0", self.beta_0),
            ("stiffness", self.stiffness),
            ("damping", self.damping),
        ];
        all.into_iter().filter_map(|(name, value)| Some((name, value?)))
    }

    /// Tables and the contact equation know nothing of surfaces.
    pub fn must_be_absent(&self) -> Result<()> {
        let steps = self.steps.map(|_| "steps");
        let friction = self.friction.as_ref().map(|_| "friction");
        let inertia = self.inertia.map(|_| "inertia");
        let first = self.given().map(|(name, _)| name).next();
        let first = friction.or(first).or(inertia).or(steps);
        first.map_or(Ok(()), |name| {
            Err(anyhow!("--{} is for --with forces", name.replace('_', "-")))
        })
    }

    /// The surfaces; none if nothing is said of friction.
    fn surfaces(&self) -> Result<Option<Surfaces>> {
        let Some(kind) = &self.friction else {
            let first = self.given().map(|(name, _)| name).next();
            let first = first.or(self.inertia.map(|_| "inertia"));
            return first.map_or(Ok(None), |name| {
                let flag = name.replace('_', "-");
                Err(anyhow!("--{flag} is for --friction constant, walton or spring"))
            });
        };
        let kind_field = ("kind".to_owned(), Value::String(kind.clone()));
        let numbers = self.given().map(|(name, x)| (name.to_owned(), Value::Float(x)));
        let table: Table = [kind_field].into_iter().chain(numbers).collect();
        let friction: FrictionSpec = table
            .try_into()
            .map_err(|why: toml::de::Error| anyhow!("--friction {kind}: {}", why.message()))?;
        let (tangential, inertia) = (friction.into(), self.inertia.unwrap_or(SPHERE));
        let rule = HardSphere { restitution: 1.0 };
        Rough { normal: rule, tangential, inertia, eta_max: 0.0 }
            .check()
            .with_context(|| format!("--friction {kind}"))?;
        Ok(Some(Surfaces { tangential, inertia }))
    }
}

/// Computes every impact of the file.
///
/// # Errors
/// Bad flags; a file that cannot be read; or, once the others are answered, that some rows were bad.
pub fn run(file: impl Read, name: &str, options: &Options) -> Result<()> {
    let surfaces = options.surfaces()?;
    let steps = options.steps.unwrap_or(512);
    ensure!((8..=131_072).contains(&steps), "--steps {steps}: from 8 to 131072 would be right");
    let cases = impacts::read(file).with_context(|| name.to_owned())?;
    let answer = |case: &Case| -> Result<Both> {
        let engine = impacts::by_engine(case, surfaces.as_ref(), steps)?;
        Ok((engine, impacts::by_reference(case, surfaces.as_ref())?))
    };
    let answered: Vec<Result<(Case, Both), BadRow>> = cases
        .into_iter()
        .map(|row| {
            let case = row?;
            let both = answer(&case).map_err(|why| BadRow {
                id: case.id.clone(),
                why: format!("{}: {why:#}", case.id),
            })?;
            Ok((case, both))
        })
        .collect();
    let mut sink = BufWriter::new(std::io::stdout().lock());
    impacts::write(
        &mut sink,
        answered.iter().map(|row| match row {
            Ok((case, both)) => impacts::Row { id: &case.id, answers: Some((case, *both)) },
            Err(bad) => impacts::Row { id: &bad.id, answers: None },
        }),
    )?;
    sink.flush()?;
    let bad: Vec<&BadRow> = answered.iter().filter_map(|row| row.as_ref().err()).collect();
    rows::report(name, &bad, answered.len())
}
