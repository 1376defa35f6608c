//! How does a table become Rust text? Reads what was made; writes text, and a file that is whole or not there.

use std::fmt::Write as _;
use std::path::Path;

use super::error::Error;
use super::made::{Made, Store};
use crate::form::Scaled;

/// Can this be the name of a static?
pub(super) fn is_name(name: &str) -> bool {
    let mut letters = name.chars();
    letters.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_')
        && name != "_"
        && letters.all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// `pub static NAME: Table<f32> = ...;`
pub(super) fn text<C: Store>(made: &Made<C>, name: &str, form: &str) -> String {
    let mut out = String::new();
    let c = &made.certificate;
    let _ = writeln!(
        out,
        "/// Restitution of the law {:?} until {:?} ends the contact: {} bytes, largest error of tau {:e}.\n\
         pub static {name}: {form}::Table<{}> = {form}::Table {{",
        c.law,
        c.end,
        c.bytes,
        c.largest.tau,
        if C::NAME == "Quanta" { format!("{form}::Quanta") } else { C::NAME.into() }
    );
    certificate(&mut out, made, form);
    body(&mut out, made, form);
    out.push_str("};\n");
    out
}

fn certificate<C: Store>(out: &mut String, made: &Made<C>, form: &str) {
    let c = &made.certificate;
    let _ = writeln!(
        out,
        "certificate: {form}::Certificate {{ law: {form}::Law::{:?}, end: {form}::End::{:?}, \
         domain: {form}::{:?}, bytes: {}, terms: {}, largest: {}, typical: {}, usual: {}, points: {}, \
         margin: {:?}, digest: {:#018x}, citation: {:?} }},",
        c.law,
        c.end,
        c.domain,
        c.bytes,
        c.terms,
        scaled(&c.largest, form),
        scaled(&c.typical, form),
        scaled(&c.usual, form),
        c.points,
        c.margin,
        c.digest,
        c.citation,
    );
}

fn scaled(s: &Scaled<f64>, form: &str) -> String {
    format!("{form}::{s:?}")
}

fn body<C: Store>(out: &mut String, made: &Made<C>, form: &str) {
    let b = made.body();
    let f = &b.frame;
    let _ = writeln!(
        out,
        "body: {form}::Body {{\ndomain: {form}::{:?},\n\
         frame: {form}::Frame {{ law: {form}::Law::{:?}, end: {form}::End::{:?}, wide: {}, kappa_scale: {:?}, \
         softness: {:?}, c_dis: {:?}, bend: {:?} }},",
        b.domain, f.law, f.end, f.wide, f.kappa_scale, f.softness, f.c_dis, f.bend,
    );
    if C::NAME == "Quanta" {
        *out = out.replace(" Quanta(", &format!(" {form}::Quanta("));
    }
    let coefficients =
        format!("{:?}", b.coefficients).replace("Quanta(", &format!("{form}::Quanta("));
    let branches: Vec<String> = b.branches.iter().map(|b| format!("{form}::{b:?}")).collect();
    let leaves: Vec<String> = b.leaves.iter().map(|l| format!("{form}::{l:?}")).collect();
    let rows: Vec<String> = b.rows.iter().map(|r| format!("{form}::{r:?}")).collect();
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
