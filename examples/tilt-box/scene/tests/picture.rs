//! Does the picture show the disks? Draws on displays in memory and over a mocked bus; compares pixels with positions.

use carom_tilt_box::picture;
use carom_tilt_box::scene::{Disks, G, Memory, disks};
use carom_tilt_box::screen::{Canvas, Screen, oled};
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::raw::{BigEndian, RawU16};
use embedded_graphics::pixelcolor::{BinaryColor, Rgb565};
use embedded_graphics::prelude::*;
use embedded_hal::spi::{ErrorType, Operation, SpiDevice};
use embedded_hal_mock::eh1::delay::NoopDelay;
use std::cell::RefCell;
use std::convert::Infallible;
use std::rc::Rc;

/// How far a pixel's middle is inside of a disk, in pixels of 2 mm; the largest of all disks.
fn depth(world: &Disks<'_>, pixel: Point, awake: bool) -> f32 {
    let (x, y) = (pixel.x as f32 * 2.0 + 1.0, 128.0 - pixel.y as f32 * 2.0 - 1.0);
    let view = world.view();
    (0..view.len())
        .filter(|&number| view.is_at_rest(number) != awake)
        .filter_map(|number| view.grain(number))
        .map(|disk| (disk.radius - (x - disk.position.x).hypot(y - disk.position.y)) / 2.0)
        .fold(f32::NEG_INFINITY, f32::max)
}

#[test]
fn a_pixel_is_lit_where_a_disk_moves() {
    let mut memory = Memory::<12>::new();
    let mut world = disks(&mut memory).unwrap();
    for _ in 0..20 {
        world.advance_to(world.now() + carom::Instant::from(40.0_f32)).unwrap();
        let mut canvas = Canvas::new();
        picture::draw(&world, &mut canvas).unwrap();
        for pixel in canvas.bounding_box().points() {
            let lit = canvas.pixel(pixel) == Some(BinaryColor::On);
            // Places are rounded down to a pixel, so a disk may be drawn a pixel and a half off.
            match depth(&world, pixel, true) {
                inside if inside > 2.0 => assert!(lit, "{pixel} is dark"),
                outside if outside < -2.0 && depth(&world, pixel, false) < -2.0 => {
                    assert!(!lit, "{pixel} is lit")
                }
                _ => {}
            }
        }
    }
}

#[test]
fn a_disk_that_sleeps_is_a_ring() {
    let mut memory = Memory::<1>::new();
    let mut world = disks(&mut memory).unwrap();
    world.advance_to(20_000.0_f32).unwrap();
    assert!(world.view().is_at_rest(0));
    let mut canvas = Canvas::new();
    picture::draw(&world, &mut canvas).unwrap();
    let lit = |pixel: &Point| canvas.pixel(*pixel) == Some(BinaryColor::On);
    let count = canvas.bounding_box().points().filter(lit).count();
    // A circle through the middles of pixels, 9 from one side to the other, passes 9 · 2√2 = 25 pixels; a filled one has 79.
    assert!((22..30).contains(&count), "{count}");
}

/// A display of other pixels: half as wide, the box in its upper half. It panics where something is drawn outside.
#[test]
fn the_box_is_scaled_to_the_display() {
    let mut memory = Memory::<12>::new();
    let mut world = disks(&mut memory).unwrap();
    world.set_gravity([G, G]).unwrap();
    world.advance_to(3000.0_f32).unwrap();
    let mut display = MockDisplay::<BinaryColor>::new();
    display.set_allow_overdraw(true);
    picture::draw(&world, &mut display).unwrap();
    let lit = |p: &Point| display.get_pixel(*p) == Some(BinaryColor::On);
    let lit: Vec<Point> = display.bounding_box().points().filter(lit).collect();
    assert!(lit.len() > 100 && lit.iter().all(|p| p.y < 32), "{}", lit.len());
    assert!(lit.iter().any(|p| p.x == 63) && lit.iter().any(|p| p.y == 0));
}

#[test]
fn a_display_with_colours_shows_the_same() {
    let mut memory = Memory::<12>::new();
    let world = disks(&mut memory).unwrap();
    let mut canvas = Canvas::new();
    let mut colours =
        Framebuffer::<Rgb565, RawU16, BigEndian, 128, 64, { buffer_size::<Rgb565>(128, 64) }>::new(
        );
    picture::draw(&world, &mut canvas).unwrap();
    picture::draw(&world, &mut colours).unwrap();
    for pixel in canvas.bounding_box().points() {
        assert_eq!(canvas.pixel(pixel).map(Rgb565::from), colours.pixel(pixel));
    }
}

/// A bus that keeps what is written, and whether the pin said data.
#[derive(Clone, Default)]
struct Wires(Rc<RefCell<(bool, Vec<u8>)>>);

impl ErrorType for Wires {
    type Error = Infallible;
}

impl SpiDevice for Wires {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let mut wires = self.0.borrow_mut();
        for operation in operations {
            if let (Operation::Write(bytes), true) = (operation, wires.0) {
                wires.1.extend_from_slice(bytes);
            }
        }
        Ok(())
    }
}

impl embedded_hal::digital::ErrorType for Wires {
    type Error = Infallible;
}

impl embedded_hal::digital::OutputPin for Wires {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().0 = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().0 = true;
        Ok(())
    }
}

/// An SSD1306 in horizontal mode takes eight rows at once, a byte a column, the lowest bit on top (data sheet, 10.1.3).
#[test]
fn the_oled_is_sent_all_pixels() {
    let mut memory = Memory::<12>::new();
    let world = disks(&mut memory).unwrap();
    let wires = Wires::default();
    let mut display =
        oled(wires.clone(), wires.clone(), &mut Wires::default(), &mut NoopDelay).unwrap();
    wires.0.borrow_mut().1.clear();
    picture::draw(&world, &mut display).unwrap();
    display.show().unwrap();
    let mut canvas = Canvas::new();
    picture::draw(&world, &mut canvas).unwrap();
    let sent = &wires.0.borrow().1;
    assert_eq!(sent.len(), 128 * 64 / 8);
    for pixel in canvas.bounding_box().points() {
        let (x, y) = (pixel.x as usize, pixel.y as usize);
        let lit = sent[y / 8 * 128 + x] >> (y % 8) & 1 == 1;
        assert_eq!(canvas.pixel(pixel), Some(BinaryColor::from(lit)), "{pixel}");
    }
}
