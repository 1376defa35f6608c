//! What does the scripted box do? Runs the script of the firmware; writes twelve pictures of it as one PNG.

use std::error::Error;
use std::path::Path;

use carom_tilt_box::scene::Memory;
use carom_tilt_box::script::{READINGS, Script};
use carom_tilt_box::{Mounting, Tilt, TiltBox, picture, sensor};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::{BinaryColorTheme, OutputSettingsBuilder, SimulatorDisplay};

const COLUMNS: u32 = 3;
const ROWS: u32 = 4;
const BETWEEN_PICTURES: u32 = READINGS / (COLUMNS * ROWS);
/// Light pixels between two pictures.
const GAP: u32 = 4;

/// Writes the pictures, row by row.
pub fn write(path: &Path) -> Result<(), Box<dyn Error>> {
    let mut strip = SimulatorDisplay::<BinaryColor>::with_default_color(
        Size::new(COLUMNS * step(picture::PIXELS.width), ROWS * step(picture::PIXELS.height)),
        BinaryColor::On,
    );
    let mut memory = Memory::<12>::new();
    let mut tilt_box = TiltBox::new(&mut memory)?;
    let mut sensor = sensor::lis3dh(Script::default()).map_err(|_| "the script is no LIS3DH")?;
    let mut tilt = Tilt::new(Mounting::default());
    for reading in 0..READINGS {
        tilt_box.frame(tilt.read(&mut sensor), || true)?;
        if (reading + 1).is_multiple_of(BETWEEN_PICTURES) {
            picture::draw(
                tilt_box.disks(),
                &mut strip.cropped(&place(reading / BETWEEN_PICTURES)),
            )?;
        }
    }
    let settings = OutputSettingsBuilder::new().theme(BinaryColorTheme::OledBlue).scale(3).build();
    strip.to_rgb_output_image(&settings).save_png(path)?;
    Ok(())
}

fn step(pixels: u32) -> u32 {
    pixels + GAP
}

/// The place of a picture on the strip.
fn place(number: u32) -> Rectangle {
    let [column, row] = [number % COLUMNS, number / COLUMNS];
    let [left, top] = [column * step(picture::PIXELS.width), row * step(picture::PIXELS.height)];
    Rectangle::new(Point::new((left + GAP / 2) as i32, (top + GAP / 2) as i32), picture::PIXELS)
}
