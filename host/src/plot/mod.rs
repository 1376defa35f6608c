//! How does a picture get drawn? Reads numbers; writes one scene, as SVG, PNG or PDF.
//!
//! A figure draws into a [`Scene`] of outlines once; [`save`] writes that scene in the format
//! that the file's name asks for. In PNG and PDF letters are outlines, taken from the font in `assets/`
//! (Noto Sans, SIL Open Font License 1.1), so no font needs to be installed. In SVG they are text, which can be
//! searched and edited, in places and widths that do not depend on which font is at hand.

mod axes;
mod file;
mod grains;
pub mod matrix;
pub mod methods;
mod pair;
mod pdf;
mod scene;
pub mod text;

pub use axes::{Axis, Field, NORMAL, Panel, SMALL, colour_bar};
pub use file::{Format, ending, save, svg};
pub use grains::grains;
pub use scene::{Colour, Item, Rect, Run, Scene, Stroke};
