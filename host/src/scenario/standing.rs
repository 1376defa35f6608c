//! What are an obstacle and its facets called, and has it an inside? Reads its fields; writes nothing, returns names.

use super::obstacle::ObstacleSpec;
use std::path::PathBuf;

/// An obstacle as errors name it.
#[derive(Clone, Debug, PartialEq)]
pub struct Standing {
    /// The file in which its mesh is, as the scenario calls it.
    pub file: Option<PathBuf>,
    /// What one of its facets is called: a side of a polygon, a piece of a chain, a triangle.
    pub piece: &'static str,
    /// By which rule places are inside of it; none if it is not solid.
    pub inside: Option<Inside>,
    /// Its first facet among those of all obstacles.
    pub first: usize,
}

/// When is a place inside?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inside {
    /// Where what is closed winds round it: bodies may overlap, and a hollow is turned the other way.
    Wound,
    /// Where a ray from there meets an odd number of triangles: they are not turned alike.
    Odd,
}

impl ObstacleSpec {
    /// The field that says its corners.
    pub fn field(&self) -> &'static str {
        let Self { polygon, chain, file, .. } = self;
        match (polygon, chain, file) {
            (Some(_), ..) => "polygon",
            (_, Some(_), _) => "chain",
            (_, _, Some(_)) => "file",
            _ => "triangles",
        }
    }

    /// What one of its facets is called.
    pub fn piece(&self) -> &'static str {
        match self.field() {
            "polygon" => "side",
            "chain" => "piece",
            _ => "triangle",
        }
    }
}

impl Standing {
    /// One of its facets, counted among those of all obstacles: `triangle 812 of "funnel.stl"`.
    pub fn facet(&self, number: usize, facet: usize) -> String {
        format!("{} {} of {}", self.piece, facet - self.first.min(facet), self.named(number))
    }

    /// As obstacle `number`.
    pub fn named(&self, number: usize) -> String {
        self.file.as_ref().map_or_else(|| format!("obstacle {number}"), |file| format!("{file:?}"))
    }
}
