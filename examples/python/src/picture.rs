//! How is a picture shown and kept? Reads a scene; writes SVG for a notebook, or a file.

use super::error::of_run;
use carom_host::plot::{self, Scene};
use pyo3::prelude::*;
use std::path::PathBuf;

/// A picture. A notebook shows it.
#[pyclass(frozen, module = "carom")]
pub struct Picture(Scene);

impl Picture {
    /// A picture of this scene.
    pub const fn new(scene: Scene) -> Self {
        Self(scene)
    }
}

#[pymethods]
impl Picture {
    /// As an SVG document.
    #[getter]
    fn svg(&self) -> PyResult<String> {
        plot::svg(&self.0).map_err(of_run)
    }

    /// Writes it, as its name ends: in .svg, .png or .pdf.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        plot::save(&self.0, &path).map_err(of_run)
    }

    fn _repr_svg_(&self) -> PyResult<String> {
        self.svg()
    }

    fn __repr__(&self) -> String {
        format!("<carom.Picture, {:.0} by {:.0} points>", self.0.width, self.0.height)
    }
}
