//! How do letters become outlines? Reads text with simple marks and the font in `assets/`; writes one item to a scene.
//!
//! Marks: `*x*` is italic (`∗` sets an asterisk), `_{…}` is lowered and `^{…}` raised, both smaller; italics work inside
//! them too.

use super::scene::{Colour, Item, Run, Scene};
use tiny_skia::{Path, PathBuilder, Transform};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

const REGULAR: &[u8] = include_bytes!("../../assets/NotoSans-Regular-subset.ttf");
const ITALIC: &[u8] = include_bytes!("../../assets/NotoSans-Italic-subset.ttf");

/// Which part of the text stands at the given point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// Its left end.
    Left,
    /// Its middle.
    Middle,
    /// Its right end.
    Right,
}

/// How text is set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Size in points.
    pub size: f64,
    /// Colour.
    pub colour: Colour,
    /// Which part stands at the given point.
    pub align: Align,
    /// True if the text reads upwards.
    pub upright: bool,
}

impl Style {
    /// Horizontal text.
    pub const fn new(size: f64, colour: Colour, align: Align) -> Self {
        Self { size, colour, align, upright: false }
    }

    /// The same, reading upwards.
    pub const fn upwards(self) -> Self {
        Self { upright: true, ..self }
    }
}

impl Scene {
    /// Sets text; `at` is on its base line.
    pub fn text(&mut self, at: [f64; 2], text: &str, style: Style) {
        let Outlined { path, width, runs } = outline(text, style.size);
        let back = match style.align {
            Align::Left => 0.0,
            Align::Middle => -width / 2.0,
            Align::Right => -width,
        };
        let Style { colour, upright, .. } = style;
        let (turn, at) = match upright {
            true => (-90.0, [at[0], at[1] - back]),
            false => (0.0, [at[0] + back, at[1]]),
        };
        let place = Transform::from_rotate(turn).post_translate(at[0] as f32, at[1] as f32);
        if let Some(path) = path.and_then(|path| path.transform(place)) {
            self.items.push(Item::Letters { path, colour, at, upright, runs });
        }
    }
}

/// Width of a text in points.
pub fn width(text: &str, size: f64) -> f64 {
    outline(text, size).width
}

/// Where the next letter goes.
struct Pen {
    x: f64,
    size: f64,
    italic: bool,
    /// -1 lowered, 0 on the line, 1 raised.
    level: i8,
    last: Option<Set>,
    runs: Vec<Run>,
}

/// A text, as outlines and as letters.
struct Outlined {
    path: Option<Path>,
    width: f64,
    runs: Vec<Run>,
}

/// A letter as it was set.
#[derive(Clone, Copy)]
struct Set {
    glyph: GlyphId,
    x: f64,
    y: f64,
    scale: f64,
}

fn outline(text: &str, size: f64) -> Outlined {
    let faces = [REGULAR, ITALIC].map(|font| Face::parse(font, 0).ok());
    let mut builder = PathBuilder::new();
    let mut pen = Pen { x: 0.0, size, italic: false, level: 0, last: None, runs: Vec::new() };
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '*' => pen.italic = !pen.italic,
            '_' | '^' if letters.peek() == Some(&'{') => {
                letters.next();
                pen.level = if letter == '_' { -1 } else { 1 };
            }
            '}' if pen.level != 0 => pen.level = 0,
            _ => {
                if let Some(face) = &faces[usize::from(pen.italic)] {
                    set(&mut builder, face, &mut pen, letter);
                }
            }
        }
    }
    Outlined { path: builder.finish(), width: pen.x, runs: pen.runs }
}

fn set(builder: &mut PathBuilder, face: &Face<'_>, pen: &mut Pen, letter: char) {
    // The font has no minus sign; its en dash is one. An asterisk itself is a mark here.
    let (letter, written) = match letter {
        '−' => ('–', '−'),
        '∗' => ('*', '*'),
        other => (other, other),
    };
    if let ('\u{300}'..='\u{36f}', Some(below)) = (letter, pen.last) {
        if let Some(run) = pen.runs.last_mut() {
            run.text.push(letter);
        }
        return accent(builder, face, pen, below, letter);
    }
    let (size, shift) = match pen.level {
        0 => (pen.size, 0.0),
        level => {
            (0.72 * pen.size, -f64::from(level) * if level > 0 { 0.36 } else { 0.22 } * pen.size)
        }
    };
    let scale = size / f64::from(face.units_per_em());
    let Some(glyph) = face.glyph_index(letter) else { return };
    let mut outline = Outline { builder, x: pen.x, y: shift, scale };
    let _ = face.outline_glyph(glyph, &mut outline);
    pen.last = Some(Set { glyph, x: pen.x, y: shift, scale });
    let advance = scale * f64::from(face.glyph_hor_advance(glyph).unwrap_or(0));
    pen.write(written, [size, shift], advance);
    pen.x += advance;
}

impl Pen {
    /// Adds a letter to the last run, or to a new one if it differs.
    fn write(&mut self, letter: char, [size, shift]: [f64; 2], advance: f64) {
        let (italic, x) = (self.italic, self.x);
        match self.runs.last_mut() {
            Some(run) if run.italic == italic && run.size == size && run.at[1] == shift => {
                run.text.push(letter);
                run.width += advance;
            }
            _ => {
                let text = letter.to_string();
                self.runs.push(Run { text, at: [x, shift], width: advance, size, italic });
            }
        }
    }
}

/// Sets an accent over the middle of the letter before it.
fn accent(builder: &mut PathBuilder, face: &Face<'_>, pen: &Pen, below: Set, accent: char) {
    let glyph = face.glyph_index(accent);
    let boxes = glyph.map(|glyph| (face.glyph_bounding_box(glyph), glyph));
    let letter = face.glyph_bounding_box(below.glyph);
    let (Some((Some(mark), glyph)), Some(letter)) = (boxes, letter) else { return };
    let middle = |b: ttf_parser::Rect| (f64::from(b.x_min) + f64::from(b.x_max)) / 2.0;
    // Italic letters lean: what stands above them is further to the right.
    let lean = if pen.italic { 0.12 * f64::from(letter.y_max) } else { 0.0 };
    let gap = 0.09 * f64::from(face.units_per_em());
    let up = f64::from(letter.y_max) - f64::from(mark.y_min) + gap;
    let x = below.x + below.scale * (middle(letter) + lean - middle(mark));
    let mut outline = Outline { builder, x, y: below.y - below.scale * up, scale: below.scale };
    let _ = face.outline_glyph(glyph, &mut outline);
}

struct Outline<'a> {
    builder: &'a mut PathBuilder,
    x: f64,
    y: f64,
    scale: f64,
}

impl Outline<'_> {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        let across = self.x + self.scale * f64::from(x);
        let down = self.y - self.scale * f64::from(y);
        (across as f32, down as f32)
    }
}

impl OutlineBuilder for Outline<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.builder.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.builder.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.builder.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.builder.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.builder.close();
    }
}
