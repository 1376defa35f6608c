//! How does numpy see the grains? Keeps two arrays that Python may read; writes positions and velocities into them.

use carom_host::scenario::Placed;
use numpy::{PyArray2, PyArrayMethods};
use pyo3::prelude::*;

/// Arrays of positions and velocities, a row for each grain. They belong to Python and live as long as anybody
/// holds them; what is handed out can be read, not written.
pub struct Views {
    own: [Py<PyArray2<f64>>; 2],
    shown: [Py<PyArray2<f64>>; 2],
}

impl Views {
    /// For so many grains in so many dimensions.
    pub fn new(py: Python<'_>, [grains, dimension]: [usize; 2]) -> PyResult<Self> {
        let own = [0, 1].map(|_| PyArray2::zeros(py, [grains, dimension], false));
        let shown = [read_only(&own[0])?, read_only(&own[1])?];
        Ok(Self { own: own.map(Bound::unbind), shown })
    }

    /// Positions (0) or velocities (1).
    pub fn shown<'py>(&self, py: Python<'py>, which: usize) -> Bound<'py, PyArray2<f64>> {
        self.shown[which].bind(py).clone()
    }

    /// These grains are in them now.
    pub fn fill(&self, py: Python<'_>, grains: &[Placed]) -> PyResult<()> {
        let parts: [fn(&Placed) -> &[f64; 3]; 2] =
            [|grain| &grain.position, |grain| &grain.velocity];
        for (array, part) in self.own.iter().zip(parts) {
            let mut array = array.bind(py).try_readwrite()?;
            let mut rows = array.as_array_mut();
            for (mut row, grain) in rows.rows_mut().into_iter().zip(grains) {
                row.iter_mut().zip(part(grain)).for_each(|(place, x)| *place = *x);
            }
        }
        Ok(())
    }
}

fn read_only(array: &Bound<'_, PyArray2<f64>>) -> PyResult<Py<PyArray2<f64>>> {
    let view = array.call_method0("view")?;
    view.getattr("flags")?.setattr("writeable", false)?;
    Ok(view.cast_into::<PyArray2<f64>>()?.unbind())
}
