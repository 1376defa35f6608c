//! How does the box feel? Reads the mouse; shows a window.

use std::time::{Duration, Instant};

use carom::Error;
use carom_tilt_box::frame::{FRAME, SHARE};
use carom_tilt_box::scene::{G, Memory, Number};
use carom_tilt_box::{TiltBox, picture};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{
    BinaryColorTheme, OutputSettingsBuilder, SimulatorDisplay, SimulatorEvent, Window,
};

/// Shows the box until its window is closed.
pub fn show() -> Result<(), Error> {
    let settings = OutputSettingsBuilder::new().theme(BinaryColorTheme::OledBlue).scale(6).build();
    let mut window = Window::new("carom: down is where the mouse points to", &settings);
    let mut display = SimulatorDisplay::<BinaryColor>::new(picture::PIXELS);
    let mut memory = Memory::<12>::new();
    let mut tilt_box = TiltBox::new(&mut memory)?;
    let mut gravity = [0.0, -G];
    window.update(&display);
    loop {
        let begin = Instant::now();
        for event in window.events() {
            match event {
                SimulatorEvent::Quit => return Ok(()),
                SimulatorEvent::MouseMove { point } => gravity = towards(point),
                _ => {}
            }
        }
        tilt_box.frame(gravity, || begin.elapsed() < Duration::from_millis(SHARE.into()))?;
        let Ok(()) = picture::draw(tilt_box.disks(), &mut display);
        window.update(&display);
        std::thread::sleep(Duration::from_millis(FRAME.into()).saturating_sub(begin.elapsed()));
    }
}

/// Gravity of 1 g from the middle of the picture to this pixel; none in the middle itself.
fn towards(pixel: Point) -> [Number; 2] {
    let middle = Point::zero() + picture::PIXELS / 2;
    let [right, down] = [pixel.x - middle.x, pixel.y - middle.y].map(|part| part as Number);
    let length = right.hypot(down).max(1.0);
    [right / length * G, -down / length * G]
}
