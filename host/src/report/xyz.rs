//! Where is every grain, for other programs? Reads samples; writes extended XYZ.

use crate::run::Sample;
use crate::scenario::{Side, Start};
use anyhow::Result;
use std::io::Write;

/// One frame of an extended XYZ trajectory (as read by OVITO and ASE): grains with position,
/// velocity, radius and mass, the box as `Lattice`, the instant as `Time`.
///
/// An open axis is given the extent of the grains of this frame and is marked not periodic.
///
/// # Errors
/// When it cannot be written.
pub fn write_frame(sink: &mut dyn Write, start: &Start, sample: &Sample) -> Result<()> {
    let mut origin = [0.0; 3];
    let mut size = [0.0; 3];
    for axis in 0..3 {
        let [from, to] = start.sides[axis].range().unwrap_or_else(|| extent(sample, axis));
        (origin[axis], size[axis]) = (from, to - from);
    }
    let periodic =
        start.sides.map(|side| if matches!(side, Side::Periodic(_)) { "T" } else { "F" });
    writeln!(sink, "{}", sample.grains.len())?;
    writeln!(
        sink,
        "Lattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{}\" \
         Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1 Time={:?}",
        size[0],
        size[1],
        size[2],
        origin[0],
        origin[1],
        origin[2],
        periodic.join(" "),
        sample.time
    )?;
    for grain in &sample.grains {
        let ([x, y, z], [u, v, w]) = (grain.position, grain.velocity);
        writeln!(
            sink,
            "G {x:?} {y:?} {z:?} {u:?} {v:?} {w:?} {:?} {:?}",
            grain.radius, grain.mass
        )?;
    }
    Ok(())
}

fn extent(sample: &Sample, axis: usize) -> [f64; 2] {
    let low = sample.grains.iter().map(|g| g.position[axis] - g.radius);
    let high = sample.grains.iter().map(|g| g.position[axis] + g.radius);
    [low.fold(f64::INFINITY, f64::min), high.fold(f64::NEG_INFINITY, f64::max)]
}
