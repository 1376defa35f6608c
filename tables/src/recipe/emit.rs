//! How does a table become Rust text? Reads a generated table; writes text, and a file that is complete or not there.

use std::fmt::Write as _;
use std::path::Path;

use super::error::Error;
use super::generated::GeneratedTable;
use super::number_type::EncodeNumber;
use crate::read::groups::ScaledRestitution;

/// Whether this can be the name of a static.
pub(super) fn is_name(name: &str) -> bool {
    let mut letters = name.chars();
    letters.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_')
        && name != "_"
        && letters.all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// `pub static NAME: Table<f32> = ...;`
pub(super) fn text<C: EncodeNumber>(table: &GeneratedTable<C>, name: &str, reader: &str) -> String {
    let mut out = String::new();
    let c = &table.certificate;
    let _ = writeln!(
        out,
        "/// Restitution of the law {:?} until {:?} ends the contact: {} bytes, largest error of tau {:e}.\n\
         pub static {name}: {reader}::Table<{}> = {reader}::Table {{",
        c.law,
        c.end,
        c.bytes,
        c.largest.tau,
        if C::NAME == "Quantised" { format!("{reader}::Quantised") } else { C::NAME.into() }
    );
    certificate(&mut out, table, reader);
    data(&mut out, table, reader);
    out.push_str("};\n");
    out
}

fn certificate<C: EncodeNumber>(out: &mut String, table: &GeneratedTable<C>, reader: &str) {
    let c = &table.certificate;
    let _ = writeln!(
        out,
        "certificate: {reader}::Certificate {{ law: {reader}::Law::{:?}, end: {reader}::End::{:?}, \
         domain: {reader}::{:?}, bytes: {}, terms: {}, largest: {}, typical: {}, quantile_999: {}, points: {}, \
         margin: {:?}, digest: {:#018x}, citation: {:?} }},",
        c.law,
        c.end,
        c.domain,
        c.bytes,
        c.terms,
        restitution(&c.largest, reader),
        restitution(&c.typical, reader),
        restitution(&c.quantile_999, reader),
        c.points,
        c.margin,
        c.digest,
        c.citation,
    );
}

fn restitution(s: &ScaledRestitution<f64>, reader: &str) -> String {
    format!("{reader}::{s:?}")
}

fn data<C: EncodeNumber>(out: &mut String, table: &GeneratedTable<C>, reader: &str) {
    let b = table.data();
    let m = &b.coordinates;
    let _ = writeln!(
        out,
        "data: {reader}::TableData {{\ndomain: {reader}::{:?},\n\
         coordinates: {reader}::CoordinateMap {{ law: {reader}::Law::{:?}, end: {reader}::End::{:?}, wide: {}, kappa_scale: {:?}, \
         softness_max: {:?}, c_dis_max: {:?}, coupling: {:?} }},",
        b.domain, m.law, m.end, m.wide, m.kappa_scale, m.softness_max, m.c_dis_max, m.coupling,
    );
    if C::NAME == "Quantised" {
        *out = out.replace(" Quantised(", &format!(" {reader}::Quantised("));
    }
    let coefficients =
        format!("{:?}", b.coefficients).replace("Quantised(", &format!("{reader}::Quantised("));
    let branches: Vec<String> = b.branches.iter().map(|b| format!("{reader}::{b:?}")).collect();
    let leaves: Vec<String> = b.leaves.iter().map(|l| format!("{reader}::{l:?}")).collect();
    let rows: Vec<String> = b.rows.iter().map(|r| format!("{reader}::{r:?}")).collect();
    let _ = writeln!(
        out,
        "branches: &[{}],\nleaves: &[{}],\nrows: &[{}],\ncoefficients: &{},\n}},",
        branches.join(", "),
        leaves.join(", "),
        rows.join(", "),
        coefficients,
    );
}

/// Writes beside the target and renames, so that nobody reads half a file.
pub(super) fn write(path: &Path, text: &str) -> Result<(), Error> {
    let fail = |source| Error::Write { path: path.to_path_buf(), source };
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    std::fs::write(&part, text).map_err(fail)?;
    std::fs::rename(&part, path).map_err(fail)
}
