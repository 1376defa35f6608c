//! How does Python hold a scenario that runs? Keeps an engine; hands out time, arrays, tables and pictures.

use super::engine::{Engine, Kept};
use super::error::{SimulationError, of_run, of_scenario};
use super::picture::Picture;
use super::scenario::{Scenario, method, name_of};
use super::table::{self, Table};
use super::value::dictionary;
use super::views::Views;
use anyhow::Result;
use carom_host::method::Method;
use carom_host::plot;
use carom_host::scenario::{MethodName, Start};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, TryLockError};

/// A scenario that runs by one method.
///
/// While it computes, other threads of Python go on, and Ctrl-C stops it between two events: it can go on from there.
/// One thread at a time can work with it.
#[pyclass(frozen, module = "carom")]
pub struct World {
    scenario: Py<Scenario>,
    name: MethodName,
    start: Start,
    engine: Mutex<Engine>,
    views: Mutex<Option<Views>>,
}

/// Whoever works with a world; nobody waits, for Python's lock may be held.
fn entered<T>(door: &Mutex<T>) -> PyResult<MutexGuard<'_, T>> {
    door.try_lock().map_err(|why| {
        SimulationError::new_err(match why {
            TryLockError::WouldBlock => "this world is at work in another thread",
            TryLockError::Poisoned(_) => "this world broke down",
        })
    })
}

impl World {
    fn begin(
        scenario: &Bound<'_, Scenario>,
        name: MethodName,
        kept: Option<&Kept>,
    ) -> PyResult<Self> {
        let (py, checked) = (scenario.py(), &scenario.get().checked);
        let begun = py.detach(|| Engine::new(checked, name, kept));
        let (start, engine) = begun.map_err(|error| of_scenario(py, error))?;
        let (engine, views) = (Mutex::new(engine), Mutex::new(None));
        Ok(Self { scenario: scenario.clone().unbind(), name, start, engine, views })
    }

    fn ask<T>(&self, question: impl FnOnce(&mut dyn Method) -> T) -> PyResult<T> {
        Ok(entered(&self.engine)?.ask(question))
    }

    /// Computes without Python's lock; then arrays are as the world is.
    fn work<T: Send>(
        &self,
        py: Python<'_>,
        work: impl Send + FnOnce(&mut Engine) -> Result<T>,
    ) -> PyResult<T> {
        let done = py.detach(|| entered(&self.engine).map(|mut engine| work(&mut engine)))?;
        if let Some(views) = &*entered(&self.views)? {
            views.fill(py, &entered(&self.engine)?.grains())?;
        }
        done.map_err(of_run)
    }

    fn view<'py>(&self, py: Python<'py>, which: usize) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let mut engine = entered(&self.engine)?;
        let mut views = entered(&self.views)?;
        if let Some(views) = &*views {
            return Ok(views.shown(py, which));
        }
        let new = Views::new(py, [self.start.grains.len(), self.start.dimension])?;
        new.fill(py, &engine.grains())?;
        Ok(views.insert(new).shown(py, which))
    }
}

/// All that a saved world needs to go on: the scenario, its folder, the method and where it stands.
type Saved = (String, PathBuf, String, Kept);

#[pymethods]
impl World {
    #[new]
    #[pyo3(signature = (scenario, method=None))]
    fn new(scenario: &Bound<'_, Scenario>, method: Option<&str>) -> PyResult<Self> {
        let checked = &scenario.get().checked;
        let name = match method {
            Some(name) => self::method(name)?,
            None => *checked.chosen_methods().last().unwrap_or(&MethodName::Emd),
        };
        Self::begin(scenario, name, None)
    }

    /// The scenario.
    #[getter]
    fn scenario(&self, py: Python<'_>) -> Py<Scenario> {
        self.scenario.clone_ref(py)
    }

    /// The method: md, md-exact, emd or emd*.
    #[getter]
    fn method(&self) -> &'static str {
        name_of(self.name)
    }

    /// 1, 2 or 3.
    #[getter]
    fn dimension(&self) -> usize {
        self.start.dimension
    }

    /// The present (s).
    #[getter]
    fn time(&self) -> PyResult<f64> {
        self.ask(|method| method.time())
    }

    /// Goes on to an instant (s).
    fn advance_to(&self, py: Python<'_>, time: f64) -> PyResult<()> {
        self.work(py, |engine| engine.come_to(time))
    }

    /// Goes on by a span of time (s).
    fn advance_by(&self, py: Python<'_>, span: f64) -> PyResult<()> {
        let now = self.time()?;
        self.work(py, |engine| engine.come_to(now + span))
    }

    /// So many events happen, a grain's way into another cell among them; false if nothing ever happens any more.
    #[pyo3(signature = (events=1))]
    fn step(&self, py: Python<'_>, events: u64) -> PyResult<bool> {
        self.work(py, |engine| engine.step(events))
    }

    /// Goes on to the scenario's end.
    fn run(&self, py: Python<'_>) -> PyResult<()> {
        while self.work(py, Engine::next_sample)?.is_some() {}
        Ok(())
    }

    /// Goes on from sample to sample, each time the loop asks for the next one, to the scenario's end; yields times (s).
    fn samples(slf: Py<Self>) -> Samples {
        Samples { world: slf }
    }

    /// Where the grains are (m), a row each: an array that stays the same and changes when the world goes on.
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.view(py, 0)
    }

    /// How fast they are (m/s), as `positions`.
    #[getter]
    fn velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.view(py, 1)
    }

    /// The grains' radii (m).
    #[getter]
    fn radii<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_iter(py, self.start.grains.iter().map(|grain| grain.radius))
    }

    /// The grains' masses (kg).
    #[getter]
    fn masses<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_iter(py, self.start.grains.iter().map(|grain| grain.mass))
    }

    /// Of which species each grain is: numbers of `species_names`.
    #[getter]
    fn species<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u16>> {
        PyArray1::from_slice(py, &self.start.species)
    }

    /// What species are called.
    #[getter]
    fn species_names(&self) -> Vec<String> {
        self.start.species_names.clone()
    }

    /// Kinetic energy (J).
    #[getter]
    fn kinetic_energy(&self) -> PyResult<f64> {
        self.ask(|method| method.kinetic_energy())
    }

    /// Contacts begun so far, with grains and walls.
    #[getter]
    fn collisions(&self) -> PyResult<u64> {
        self.ask(|method| method.collisions())
    }

    /// How often everything happened.
    #[getter]
    fn statistics<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        dictionary(py, self.ask(|method| method.statistics())?)
    }

    /// How many grains move in which way.
    #[getter]
    fn motions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        dictionary(py, self.ask(|method| method.motions())?)
    }

    /// A digest of the whole state: the same on every machine, and from Rust. None for force-based methods.
    #[getter]
    fn digest(&self) -> PyResult<Option<u64>> {
        self.ask(|method| method.digest())
    }

    /// What `[observe]` has measured so far: tables by their names.
    #[getter]
    fn observed<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let tables = entered(&self.engine)?.tables();
        match tables {
            Some(tables) if !tables.is_empty() => table::by_name(py, tables),
            other => Err(table::nothing(other.is_some())),
        }
    }

    /// The events since the last call, if `options.events` is true.
    fn take_events(&self) -> PyResult<Table> {
        Ok(table::of_events(&self.ask(|method| method.take_events())?))
    }

    /// The grains as they are now, in colours of their species, and the obstacles.
    fn draw(&self) -> PyResult<Picture> {
        let grains = self.ask(|method| method.grains())?;
        let title = format!("t = {:.6} s", self.time()?);
        Ok(Picture::new(plot::grains(&self.start, &grains, &title)))
    }

    /// The whole state, from which `restore` goes on with the same bits.
    fn save<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let kept = entered(&self.engine)?.keep().map_err(of_run)?;
        let (scenario, method) = (self.scenario.get(), name_of(self.name).to_owned());
        let saved: Saved = (scenario.text().to_owned(), scenario.folder(), method, kept);
        let bytes = postcard::to_stdvec(&saved).map_err(|error| of_run(error.into()))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// A world that `save` has saved.
    #[staticmethod]
    fn restore(py: Python<'_>, state: &[u8]) -> PyResult<Self> {
        let saved: Result<Saved, _> = postcard::from_bytes(state);
        let (text, folder, name, kept) =
            saved.map_err(|_| SimulationError::new_err("the saved state is damaged"))?;
        let scenario = Bound::new(py, Scenario::new(py, text, folder)?)?;
        Self::begin(&scenario, self::method(&name)?, Some(&kept))
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        let restore = slf.get_type().getattr("restore")?;
        Ok((restore, (slf.get().save(slf.py())?,)))
    }

    fn __len__(&self) -> usize {
        self.start.grains.len()
    }

    fn __repr__(&self) -> PyResult<String> {
        let (time, grains) = (self.time()?, self.start.grains.len());
        Ok(format!("<carom.World of {grains} grains by {}, t = {time} s>", self.name.label()))
    }

    fn _repr_html_(&self) -> PyResult<String> {
        let title = &self.scenario.get().checked.title;
        let facts = [
            ("method", self.name.label().to_owned()),
            ("grains", self.start.grains.len().to_string()),
            ("time", format!("{} s", self.time()?)),
            ("contacts", self.collisions()?.to_string()),
            ("kinetic energy", format!("{:.6e} J", self.kinetic_energy()?)),
        ];
        let rows = facts.map(|(name, value)| format!("<tr><th>{name}</th><td>{value}</td></tr>"));
        let title = title.replace('&', "&amp;").replace('<', "&lt;");
        Ok(format!("<table><caption>{title}</caption>{}</table>", rows.concat()))
    }
}

/// The samples of a run, one after the other.
#[pyclass(frozen, module = "carom")]
pub struct Samples {
    world: Py<World>,
}

#[pymethods]
impl Samples {
    const fn __iter__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __next__(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.world.get().work(py, Engine::next_sample)
    }
}
