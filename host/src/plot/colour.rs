//! Which colour stands for what? Reads a fraction; writes nothing, returns a colour.

use super::scene::Colour;

/// Ink of frames, ticks and letters.
pub const INK: Colour = Colour::rgb(0x22, 0x22, 0x22);
/// Force-based MD: black, as in MP13 Fig. 6.
pub const MD: Colour = Colour::rgb(0x11, 0x11, 0x11);
/// eMD: red, as in MP13 Fig. 6 (a tone that differs from the green also for the colour-blind).
pub const EMD: Colour = Colour::rgb(0xd5, 0x3e, 0x1f);
/// eMD*: green, as in MP13 Fig. 6.
pub const EMD_STAR: Colour = Colour::rgb(0x00, 0x8f, 0x6b);
/// A fourth line.
pub const BLUE: Colour = Colour::rgb(0x2a, 0x66, 0xb3);
/// Help lines.
pub const FAINT: Colour = Colour::rgb(0xb8, 0xb8, 0xb8);
/// Nothing there.
pub const WHITE: Colour = Colour::rgb(0xff, 0xff, 0xff);

/// A colour scale whose lightness grows evenly (viridis); `fraction` is held to 0..1.
pub fn scale(fraction: f64) -> Colour {
    let colour = colorous::VIRIDIS.eval_continuous(fraction.clamp(0.0, 1.0));
    Colour::rgb(colour.r, colour.g, colour.b)
}
