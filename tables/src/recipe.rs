//! Which table is wanted? Reads limits and sizes; writes the table as Rust text for a `build.rs`.

use std::fmt::Write as _;
use std::path::Path;

use crate::fit::{Ask, Fit, fit};
use crate::form::Frame;
use crate::law::{End, Law};

/// What a table shall hold.
#[derive(Clone, Debug)]
pub struct Recipe {
    law: Law,
    end: End,
    softness_max: f64,
    c_dis_max: f64,
    tolerance: f64,
    prefix: String,
}

impl Recipe {
    /// `l~ cos(alpha) >= 5`, `c_dis <= 1`, to about 1e-6.
    pub fn standard(law: Law) -> Self {
        Recipe {
            law,
            end: End::Force,
            softness_max: 0.2,
            c_dis_max: 1.0,
            tolerance: 1e-6,
            prefix: "::carom_tables".into(),
        }
    }

    /// The path under which the emitted text finds this crate.
    pub fn prefix(mut self, prefix: &str) -> Self {
        self.prefix = prefix.into();
        self
    }

    /// The table as Rust text: `pub static NAME: Table<f32> = ...`.
    ///
    /// # Errors
    /// Names the field that is out of range.
    pub fn emit(&self, name: &str) -> Result<String, String> {
        let frame = Frame {
            kappa_scale: 1.0,
            softness: self.softness_max,
            c_dis: self.c_dis_max,
            bend: 1.0,
            root: self.law == Law::Viscoelastic,
        };
        let t = self.tolerance;
        let ask = Ask {
            law: self.law,
            end: self.end,
            frame,
            nodes: [16, 8, 14],
            tolerance: [t, 4.0 * t, 20.0 * t],
        };
        Ok(self.text(name, &ask, &fit(&ask)))
    }

    /// Writes the text to a file.
    ///
    /// # Errors
    /// Names the field that is out of range, or what the file system said.
    pub fn write(&self, path: impl AsRef<Path>, name: &str) -> Result<(), String> {
        let path = path.as_ref();
        std::fs::write(path, self.emit(name)?).map_err(|e| format!("{}: {e}", path.display()))
    }

    fn text(&self, name: &str, ask: &Ask, fit: &Fit) -> String {
        let p = &self.prefix;
        let f = &ask.frame;
        let bytes = fit.rows.len() + 4 * fit.coefficients.len();
        let zero = format!(
            "{p}::form::Scaled {{ tau: 1e-5, speed: 1e-5, angle: 1e-5, separation: 1e-5 }}"
        );
        let mut out = String::new();
        let _ = write!(
            out,
            "/// A table of restitution.\npub static {name}: {p}::form::Table<f32> = {p}::form::Table {{\n\
             certificate: {p}::form::Certificate {{ law: {p}::Law::{:?}, end: {p}::End::{:?}, \
             domain: {p}::form::Domain {{ softness_max: {:?}, c_dis_max: {:?}, cos_min: 1e-6 }}, \
             bytes: {bytes}, largest: {zero}, usual: {zero}, points: 0, digest: 0, citation: \"\" }},\n\
             frame: {p}::form::Frame {{ kappa_scale: {:?}, softness: {:?}, c_dis: {:?}, bend: {:?}, root: {} }},\n\
             cos_min: 1e-6,\nbranches: &[],\nleaves: &{:?},\nrows: &{:?},\ncoefficients: &{:?},\n}};\n",
            self.law,
            self.end,
            f.softness,
            f.c_dis,
            f.kappa_scale,
            f.softness as f32,
            f.c_dis as f32,
            f.bend,
            f.root,
            fit.leaves,
            fit.rows,
            fit.coefficients.iter().map(|&a| a as f32).collect::<Vec<_>>(),
        );
        out.replace("Leaf {", &format!("{p}::form::Leaf {{"))
    }
}
