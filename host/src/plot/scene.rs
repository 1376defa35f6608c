//! What is in a picture, and which colour stands for what? Reads shapes as they are drawn; writes nothing, keeps them in order.

use tiny_skia::{Path, PathBuilder};

/// A colour with opacity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colour {
    /// Red, green and blue.
    pub rgb: [u8; 3],
    /// From 0, not seen, to 1.
    pub opacity: f32,
}

impl Colour {
    /// Ink of frames, ticks and letters.
    pub const INK: Self = Self::rgb(0x22, 0x22, 0x22);
    /// Force-based MD: black, as in MP13 Fig. 6.
    pub const MD: Self = Self::rgb(0x11, 0x11, 0x11);
    /// eMD: red, as in MP13 Fig. 6 (a tone that differs from the green also for the colour-blind).
    pub const EMD: Self = Self::rgb(0xd5, 0x3e, 0x1f);
    /// eMD*: green, as in MP13 Fig. 6.
    pub const EMD_STAR: Self = Self::rgb(0x00, 0x8f, 0x6b);
    /// A fourth line.
    pub const BLUE: Self = Self::rgb(0x2a, 0x66, 0xb3);
    /// Help lines.
    pub const FAINT: Self = Self::rgb(0xb8, 0xb8, 0xb8);
    /// Nothing there.
    pub const WHITE: Self = Self::rgb(0xff, 0xff, 0xff);

    /// A colour scale whose lightness grows evenly (viridis); `fraction` is held to 0..1.
    pub fn scale(fraction: f64) -> Self {
        let colour = colorous::VIRIDIS.eval_continuous(fraction.clamp(0.0, 1.0));
        Self::rgb(colour.r, colour.g, colour.b)
    }

    /// An opaque colour.
    pub const fn rgb(red: u8, green: u8, blue: u8) -> Self {
        Self { rgb: [red, green, blue], opacity: 1.0 }
    }

    /// The same colour, partly seen through.
    pub const fn with_opacity(self, opacity: f32) -> Self {
        Self { opacity, ..self }
    }
}

/// A rectangle; y grows downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Left edge.
    pub x: f64,
    /// Upper edge.
    pub y: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub colour: Colour,
    /// Its width.
    pub width: f32,
    /// Lengths of dash and gap, if dashed.
    pub dash: Option<[f32; 2]>,
}

impl Stroke {
    /// A solid line.
    pub const fn solid(colour: Colour, width: f32) -> Self {
        Self { colour, width, dash: None }
    }

    /// A dashed line.
    pub const fn dashed(colour: Colour, width: f32, dash: f32, gap: f32) -> Self {
        Self { colour, width, dash: Some([dash, gap]) }
    }
}

/// Letters of one size and slant, beside each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// They.
    pub text: String,
    /// From the left end of the line of text, along it and below it.
    pub at: [f64; 2],
    /// How long they are together.
    pub width: f64,
    /// Size in points.
    pub size: f64,
    /// Whether they lean.
    pub italic: bool,
}

/// One thing drawn.
#[derive(Clone, Debug)]
pub enum Item {
    /// An outline, filled or stroked or both.
    Shape {
        /// The outline.
        path: Path,
        /// Colour of the inside.
        fill: Option<Colour>,
        /// Line along the outline.
        stroke: Option<Stroke>,
        /// Nothing is seen outside of this rectangle.
        clip: Option<Rect>,
    },
    /// A line of text: outlines for pixels, letters for SVG.
    Letters {
        /// The outlines of all letters.
        path: Path,
        /// Their colour.
        colour: Colour,
        /// The left end of the base line.
        at: [f64; 2],
        /// True if the text reads upwards.
        upright: bool,
        /// The same as text.
        runs: Vec<Run>,
    },
    /// Pixels, stretched over a rectangle.
    Pixels {
        /// Where.
        place: Rect,
        /// Pixels along each side.
        size: [u32; 2],
        /// Red, green, blue and opacity, row by row from the top.
        rgba: Vec<u8>,
    },
}

/// A picture: a size in points and what is on it, drawn from first to last.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Width in points.
    pub width: f64,
    /// Height in points.
    pub height: f64,
    /// What is on it.
    pub items: Vec<Item>,
}

impl Scene {
    /// An empty white picture.
    pub const fn new(width: f64, height: f64) -> Self {
        Self { width, height, items: Vec::new() }
    }

    /// Adds an outline.
    pub fn shape(
        &mut self,
        path: Option<Path>,
        fill: Option<Colour>,
        stroke: Option<Stroke>,
        clip: Option<Rect>,
    ) {
        if let Some(path) = path {
            self.items.push(Item::Shape { path, fill, stroke, clip });
        }
    }

    /// A line through points; a point that is not finite starts a new piece.
    pub fn line(&mut self, points: &[[f64; 2]], stroke: Stroke, clip: Option<Rect>) {
        let mut path = PathBuilder::new();
        let mut down = false;
        for [x, y] in points {
            if !(x.is_finite() && y.is_finite()) {
                down = false;
            } else if down {
                path.line_to(*x as f32, *y as f32);
            } else {
                path.move_to(*x as f32, *y as f32);
                down = true;
            }
        }
        self.shape(path.finish(), None, Some(stroke), clip);
    }

    /// A rectangle.
    pub fn rectangle(&mut self, place: Rect, fill: Option<Colour>, stroke: Option<Stroke>) {
        let rect = tiny_skia::Rect::from_xywh(
            place.x as f32,
            place.y as f32,
            place.width as f32,
            place.height as f32,
        );
        self.shape(rect.map(PathBuilder::from_rect), fill, stroke, None);
    }

    /// A disc.
    pub fn disc(
        &mut self,
        centre: [f64; 2],
        radius: f64,
        fill: Option<Colour>,
        stroke: Option<Stroke>,
        clip: Option<Rect>,
    ) {
        let path = PathBuilder::from_circle(centre[0] as f32, centre[1] as f32, radius as f32);
        self.shape(path, fill, stroke, clip);
    }
}
