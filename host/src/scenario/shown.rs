//! Which grains does a trajectory show? Reads one frame of a file; puts its grains in the place of those of a start.

use super::frames::{self, Told};
use super::problem::Problem;
use super::side::Placed;
use super::start::Start;
use anyhow::Result;
use std::path::Path;

impl Start {
    /// The same box and obstacles with the grains of a frame, counted from 0, or of the last one: what `carom run`
    /// wrote (.xyz), or a table with radii (.csv, .parquet). They have velocity 0 where none is told. Obstacles that move
    /// are where they are at the frame's time, if it says one.
    ///
    /// # Errors
    /// When there is no such frame, or a grain without a radius.
    pub fn with_grains_of(mut self, file: &Path, frame: Option<usize>) -> Result<Self> {
        let told = frames::read(file, frame)?;
        self.species = told.iter().map(|grain| self.species_of(grain)).collect();
        let placed = told.iter().enumerate().map(|(number, grain)| placed(file, number, grain));
        self.grains = placed.collect::<Result<_, Problem>>()?;
        self.materials = vec![0; self.grains.len()];
        if !self.rotations.is_empty() {
            self.rotations = vec![[0.0; 3]; self.grains.len()];
        }
        let time = told.iter().find_map(|grain| grain.time);
        Ok(self.at(time.unwrap_or(0.0)))
    }

    /// The number of the species of this name; a name that the scenario does not have is the first's.
    fn species_of(&self, grain: &Told) -> u16 {
        let same = |name: &String| {
            let told = grain.species.as_deref().unwrap_or_default();
            name.split_whitespace().eq(told.split('-')) || name == told
        };
        self.species_names.iter().position(same).unwrap_or(0) as u16
    }
}

fn placed(file: &Path, number: usize, grain: &Told) -> Result<Placed, Problem> {
    let Some(radius) = grain.radius.filter(|radius| *radius > 0.0) else {
        let said = grain.radius.map_or_else(|| "none".to_owned(), |radius| radius.to_string());
        let message =
            format!("{}: the radius of grain {number} is {said}, must be above 0", file.display());
        return Err(Problem { path: String::new(), offset: None, message });
    };
    Ok(Placed {
        radius,
        mass: grain.mass.unwrap_or(1.0),
        position: grain.position,
        velocity: grain.velocity.unwrap_or_default(),
    })
}
