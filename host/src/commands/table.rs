//! `carom table`: what do the tables hold? Reads certificates; writes text, JSON or pictures.

use crate::plot::matrix::{self, Maps};
use crate::plot::{self, Scene};
use crate::report::write_aligned;
use crate::tables::{Size, embedded};
use anyhow::Result;
use carom_tables::read::{Certificate, End, Law, ScaledRestitution};
use clap::Args;
use serde::Serialize;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// The options of `carom table`.
#[derive(Args, Debug)]
pub struct TableOptions {
    /// Print the certificates as JSON.
    #[arg(long)]
    json: bool,
    /// Print them as the table in docs/guide/tables.md.
    #[arg(long, conflicts_with = "json")]
    markdown: bool,
    /// Draw MP13's Figs. 3, 4 and 5 as NAME-fig3.png and so on (.png, .svg or .pdf).
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// With --plot: draw only this figure, into FILE itself.
    #[arg(long, requires = "plot", value_parser = clap::value_parser!(u8).range(3..=5))]
    figure: Option<u8>,
}

/// Prints the certificates, draws the figures.
///
/// # Errors
/// A file that cannot be written.
pub fn table(options: &TableOptions) -> Result<()> {
    options.plot.as_deref().map(plot::ending).transpose()?;
    let mut sink = BufWriter::new(std::io::stdout().lock());
    let certified = certified();
    if options.json {
        serde_json::to_writer_pretty(&mut sink, &certified)?;
        writeln!(sink)?;
    } else if options.markdown {
        markdown(&mut sink, &certified)?;
    } else {
        print(&mut sink, &certified)?;
    }
    sink.flush()?;
    if let Some(file) = &options.plot {
        match options.figure {
            Some(number) => plot::save(&figure(number), file)?,
            None => {
                for number in 3..=5 {
                    plot::save(&figure(number), &numbered(file, number))?;
                }
            }
        }
    }
    Ok(())
}

/// One embedded table's certificate; the numbers are those that the generator measured.
#[derive(Debug, Serialize)]
struct Certified {
    table: &'static str,
    law: &'static str,
    end: &'static str,
    bytes: usize,
    domain: Domain,
    /// Coefficients that one lookup reads at most.
    terms: usize,
    /// Largest error at any of the points, times `margin`.
    max: Errors,
    /// The error that 99.9 % of the points stay below.
    quantile_999: Errors,
    points: usize,
    margin: f64,
    digest: String,
    citation: &'static str,
}

#[derive(Debug, Serialize)]
struct Domain {
    /// Smallest l~ cos(alpha).
    stiffness_min: f64,
    c_dis_max: f64,
    /// Largest eccentricity.
    eccentricity_max: f64,
    /// Smallest eccentricity where l~ < 2: there a central pair may pass through.
    eccentricity_min: f64,
    /// Largest c_dis / (l~ cos(alpha)).
    c_dis_softness_max: f64,
}

#[derive(Debug, Serialize)]
struct Errors {
    /// Relative.
    eps_t: f64,
    eps_rdot: f64,
    eps_r: f64,
    /// In radians.
    eps_phi: f64,
}

impl Errors {
    const fn new(scaled: &ScaledRestitution<f64>) -> Self {
        let ScaledRestitution { tau, speed, angle, separation } = *scaled;
        Self { eps_t: tau, eps_rdot: speed, eps_r: separation, eps_phi: angle }
    }

    fn texts(&self) -> [String; 4] {
        [self.eps_t, self.eps_rdot, self.eps_r, self.eps_phi].map(|error| format!("{error:.1e}"))
    }
}

fn certified() -> Vec<Certified> {
    let laws = [(Law::LinearDashpot, "lsd"), (Law::Viscoelastic, "viscoelastic")];
    let each = |size: Size| {
        laws.map(|(law, name)| certificate(size, name, &embedded(size, law).certificate))
    };
    Size::ALL.into_iter().flat_map(each).collect()
}

fn certificate(size: Size, law: &'static str, c: &Certificate) -> Certified {
    let cos = c.domain.cos_min;
    Certified {
        table: size.name(),
        law,
        end: match c.end {
            End::Force => "force",
            End::Overlap => "overlap",
        },
        bytes: c.bytes,
        terms: c.terms,
        domain: Domain {
            stiffness_min: 1.0 / c.domain.softness_max,
            c_dis_max: c.domain.c_dis_max,
            eccentricity_max: ((1.0 - cos) * (1.0 + cos)).sqrt(),
            eccentricity_min: c.domain.sin_min,
            c_dis_softness_max: c.domain.c_dis_softness_max,
        },
        max: Errors::new(&c.largest),
        quantile_999: Errors::new(&c.quantile_999),
        points: c.points,
        margin: c.margin,
        digest: format!("{:016x}", c.digest),
        citation: c.citation,
    }
}

const HEAD: [&str; 12] = [
    "table",
    "law",
    "errors",
    "eps_t",
    "eps_rdot",
    "eps_r",
    "eps_phi",
    "bytes",
    "l~ cos(a) >",
    "c_dis <",
    "e <",
    "digest",
];

fn print(sink: &mut dyn Write, all: &[Certified]) -> Result<()> {
    let mut rows = vec![HEAD.map(str::to_owned).to_vec()];
    for c in all {
        let d = &c.domain;
        let mut row = vec![c.table.to_owned(), c.law.to_owned(), "max".to_owned()];
        row.extend(c.max.texts());
        row.extend([
            c.bytes.to_string(),
            rounded(d.stiffness_min),
            rounded(d.c_dis_max),
            rounded(d.eccentricity_max),
            c.digest.clone(),
        ]);
        rows.push(row);
        let mut row = vec![String::new(), String::new(), "99.9 %".to_owned()];
        row.extend(c.quantile_999.texts());
        rows.push(row);
    }
    write_aligned(sink, &rows, 3)?;
    let points = all.iter().map(|c| c.points).min().unwrap_or(0);
    writeln!(sink, "  errors: eps_t relative, the others absolute, eps_phi in radians;")?;
    writeln!(
        sink,
        "  measured at {points} points or more that the fit did not use; a = angle of impact"
    )?;
    Ok(())
}

/// Certified errors, and in brackets what 99.9 % of the points stay below.
fn markdown(sink: &mut dyn Write, all: &[Certified]) -> Result<()> {
    let head = "| table | law | bytes | l̃ cos α ≥ | c_dis ≤ | e ≤ | τ (relative) | ε_ṙ | ε_r | ε_φ [rad] |";
    writeln!(sink, "{head}\n|{}", "---|".repeat(head.matches('|').count() - 1))?;
    for c in all {
        let law = if c.law == "lsd" { "linear" } else { c.law };
        let d = &c.domain;
        let domain = [d.stiffness_min, d.c_dis_max, d.eccentricity_max].map(rounded).join(" | ");
        let both = c.max.texts().into_iter().zip(c.quantile_999.texts());
        let errors: Vec<String> = both.map(|(max, most)| format!("{max} ({most})")).collect();
        let (table, bytes, errors) = (c.table, c.bytes, errors.join(" | "));
        writeln!(sink, "| {table} | {law} | {bytes} | {domain} | {errors} |")?;
    }
    Ok(())
}

fn rounded(value: f64) -> String {
    let text = format!("{value:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn figure(number: u8) -> Scene {
    match number {
        3 => matrix::fig3(),
        4 => Maps::new(Law::LinearDashpot).draw(),
        _ => Maps::new(Law::Viscoelastic).draw(),
    }
}

/// `maps.png` becomes `maps-fig3.png`.
fn numbered(file: &Path, number: u8) -> PathBuf {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let ending = file.extension().unwrap_or_default().to_string_lossy();
    file.with_file_name(format!("{stem}-fig{number}.{ending}"))
}
