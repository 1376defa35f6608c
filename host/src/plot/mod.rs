//! How does a picture get drawn? Reads numbers; writes one scene, as SVG and as PNG.
//!
//! A figure draws into a [`Scene`] of outlines once; [`save`] writes that scene in the format
//! that the file's name asks for. Letters are outlines too, taken from the font in `assets/`
//! (Noto Sans, SIL Open Font License 1.1), so a picture looks the same everywhere and needs no
//! font to be installed.

mod axes;
mod file;
pub mod matrix;
pub mod methods;
mod pair;
mod scene;
pub mod text;

pub use axes::{Axis, Field, NORMAL, Panel, SMALL, colour_bar};
pub use file::{Format, ending, save};
pub use scene::{Colour, Item, Rect, Scene, Stroke};
