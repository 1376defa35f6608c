//! How does a picture get drawn? Reads numbers; writes one scene, as SVG and as PNG.
//!
//! A figure draws into a [`Scene`] of outlines once; [`save`] writes that scene in the format
//! that the file's name asks for. Letters are outlines too, taken from the font in `assets/`
//! (Noto Sans, SIL Open Font License 1.1), so a picture looks the same everywhere and needs no
//! font to be installed.

pub mod axes;
pub mod colour;
pub mod figures;
pub mod heat;
mod png;
pub mod scene;
mod svg;
pub mod text;

pub use axes::{Axis, Panel};
pub use scene::{Colour, Item, Rect, Scene, Stroke};

use crate::output;
use anyhow::{Result, bail};
use std::path::Path;

/// Writes the picture; `.png` or `.svg` at the end of the name decides the format.
///
/// # Errors
/// Another ending, or a file that cannot be written.
pub fn save(scene: &Scene, file: &Path) -> Result<()> {
    let bytes = match ending(file)? {
        Format::Png => png::encode(scene)?,
        Format::Svg => svg::encode(scene)?.into_bytes(),
    };
    output::write_file(file, &bytes)
}

/// A picture's file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Pixels.
    Png,
    /// Outlines.
    Svg,
}

/// The format that a file's name asks for.
///
/// # Errors
/// When the name ends neither in `.png` nor in `.svg`.
pub fn ending(file: &Path) -> Result<Format> {
    match file.extension().and_then(|ending| ending.to_str()) {
        Some(ending) if ending.eq_ignore_ascii_case("png") => Ok(Format::Png),
        Some(ending) if ending.eq_ignore_ascii_case("svg") => Ok(Format::Svg),
        _ => bail!("{}: a picture's name ends in .png or .svg", file.display()),
    }
}
