//! How is a figure drawn: which axes, lines, colours, marks? Reads nothing; keeps what `draw.rs` needs.

use crate::plot::{Colour, Stroke};

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Equal steps are equal factors.
    pub logarithmic: bool,
    /// From where to where; none to fit the data.
    pub range: Option<[f64; 2]>,
}

impl Scale {
    /// Equal steps, fitted to the data.
    pub const LINEAR: Self = Self { logarithmic: false, range: None };
    /// Equal factors, fitted to the data.
    pub const LOG: Self = Self { logarithmic: true, range: None };

    /// The same over a given range.
    #[must_use]
    pub const fn from(self, low: f64, high: f64) -> Self {
        Self { range: Some([low, high]), ..self }
    }
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A line without dots.
    Line,
    /// Dots without a line.
    Dots,
    /// Both.
    Both,
}

/// Something of the paper's, to compare with; drawn in grey.
#[derive(Clone, Debug)]
pub enum Mark {
    /// A level: a dashed line across.
    Level(f64, String),
    /// A place: a dashed line upwards.
    Place(f64, String),
    /// A curve: dashed.
    Curve(Vec<[f64; 2]>, String),
    /// Points: open squares.
    Points(Vec<[f64; 2]>, String),
}

/// How a figure is drawn. Texts take the marks of [`crate::plot::text`].
#[derive(Clone, Debug)]
pub struct PlotStyle {
    /// Over the picture.
    pub title: String,
    /// What stands along the axes, if it differs from the figure's own labels.
    pub labels: Option<[String; 2]>,
    /// From left to right.
    pub x: Scale,
    /// From bottom to top.
    pub y: Scale,
    /// How the curves are drawn, by their number; the last holds for those that follow.
    pub kinds: Vec<Kind>,
    /// The curves' colours, by their number; a palette serves those that follow.
    pub colours: Vec<Colour>,
    /// The paper's numbers.
    pub marks: Vec<Mark>,
}

impl PlotStyle {
    /// Lines with dots on linear axes.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            labels: None,
            x: Scale::LINEAR,
            y: Scale::LINEAR,
            kinds: vec![Kind::Both],
            colours: Vec::new(),
            marks: Vec::new(),
        }
    }

    /// The same with other words along the axes.
    #[must_use]
    pub fn labels(self, x: &str, y: &str) -> Self {
        Self { labels: Some([x.to_owned(), y.to_owned()]), ..self }
    }

    /// The same on other axes.
    #[must_use]
    pub fn scales(self, x: Scale, y: Scale) -> Self {
        Self { x, y, ..self }
    }

    /// The same with curves drawn so.
    #[must_use]
    pub fn kinds(self, kinds: &[Kind]) -> Self {
        Self { kinds: kinds.to_vec(), ..self }
    }

    /// The same with one more of the paper's numbers.
    #[must_use]
    pub fn mark(mut self, mark: Mark) -> Self {
        self.marks.push(mark);
        self
    }

    pub(super) fn kind(&self, number: usize) -> Kind {
        self.kinds.get(number).or(self.kinds.last()).copied().unwrap_or(Kind::Both)
    }

    /// The line of a curve: its dashes differ from those of its neighbours, as its colour does.
    pub(super) fn pen(&self, number: usize) -> Stroke {
        Stroke { colour: self.colour(number), width: 1.5, dash: DASHES[number % DASHES.len()] }
    }

    pub(super) fn colour(&self, number: usize) -> Colour {
        let others = number.saturating_sub(self.colours.len());
        self.colours.get(number).copied().unwrap_or(PALETTE[others % PALETTE.len()])
    }
}

impl Mark {
    pub(super) fn name(&self) -> &str {
        match self {
            Self::Level(_, name)
            | Self::Place(_, name)
            | Self::Curve(_, name)
            | Self::Points(_, name) => name,
        }
    }

    pub(super) fn values(&self, direction: usize) -> Vec<f64> {
        match self {
            Self::Level(y, _) if direction == 1 => vec![*y],
            Self::Place(x, _) if direction == 0 => vec![*x],
            Self::Level(..) | Self::Place(..) => Vec::new(),
            Self::Curve(points, _) | Self::Points(points, _) => {
                points.iter().map(|point| point[direction]).collect()
            }
        }
    }
}

/// Distinct for the colour-blind too.
const PALETTE: [Colour; 8] = [
    Colour::INK,
    Colour::EMD,
    Colour::EMD_STAR,
    Colour::BLUE,
    Colour::rgb(0xe0, 0x9f, 0x00),
    Colour::rgb(0x9a, 0x4d, 0xa8),
    Colour::rgb(0x58, 0xb5, 0xe3),
    Colour::rgb(0x80, 0x5b, 0x36),
];

/// For one curve after the other; no two beside each other are alike.
const DASHES: [Option<[f32; 2]>; 5] =
    [None, Some([7.0, 2.5]), Some([2.5, 2.0]), Some([12.0, 3.0]), Some([1.2, 2.2])];
