//! Does a board's frame loop keep its time? Runs it over a clock that the test sets; reads disks' readings and pictures.
#![cfg(feature = "board")]

use accelerometer::Accelerometer;
use accelerometer::vector::F32x3;
use carom_log as _; // a logger
use carom_tilt_box::scene::Memory;
use carom_tilt_box::screen::{Canvas, Screen};
use carom_tilt_box::{Mounting, Tilt, board};
use embassy_time::{Duration, Instant, MockDriver};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::*;
use std::convert::Infallible;
use std::future::Future;
use std::pin::pin;
use std::task::{Context, Waker};

/// A sensor that takes 1 ms, and keeps when it was read.
struct Slow(Vec<u64>);

impl Accelerometer for Slow {
    type Error = Infallible;

    fn accel_norm(&mut self) -> Result<F32x3, accelerometer::Error<Infallible>> {
        self.0.push(Instant::now().as_millis());
        MockDriver::get().advance(Duration::from_millis(1));
        match self.0.len() {
            3 => Err(accelerometer::ErrorKind::Device.into_error()),
            _ => Ok(F32x3::new(0.0, 1.0, 0.0)),
        }
    }

    fn sample_rate(&mut self) -> Result<f32, accelerometer::Error<Infallible>> {
        Ok(1000.0)
    }
}

trait IntoError {
    fn into_error(self) -> accelerometer::Error<Infallible>;
}

impl IntoError for accelerometer::ErrorKind {
    fn into_error(self) -> accelerometer::Error<Infallible> {
        accelerometer::Error::new(self)
    }
}

/// A display that takes 3 ms for a picture, and refuses the second.
#[derive(Default)]
struct Display(u32);

impl DrawTarget for Display {
    type Color = BinaryColor;
    type Error = ();

    fn draw_iter<I>(&mut self, _: I) -> Result<(), ()>
    where
        I: IntoIterator<Item = Pixel<BinaryColor>>,
    {
        Ok(())
    }
}

impl OriginDimensions for Display {
    fn size(&self) -> Size {
        Canvas::new().size()
    }
}

impl Screen for Display {
    fn show(&mut self) -> Result<(), ()> {
        self.0 += 1;
        MockDriver::get().advance(Duration::from_millis(3));
        if self.0 == 2 { Err(()) } else { Ok(()) }
    }
}

#[test]
fn there_is_a_frame_every_25_ms_whatever_fails() {
    let (mut memory, mut sensor, mut display) =
        (Memory::<12>::new(), Slow(Vec::new()), Display::default());
    {
        let tilt = Tilt::new(Mounting::default());
        let mut run = pin!(board::run(&mut memory, &mut sensor, &mut display, tilt));
        let mut context = Context::from_waker(Waker::noop());
        for _ in 0..100 {
            assert!(run.as_mut().poll(&mut context).is_pending());
            MockDriver::get().advance(Duration::from_millis(1));
        }
    }
    // 4 ms of work and 1 ms a poll: the loop is asked at 4, 5, ... 25, and so on.
    assert!(sensor.0.len() >= 4, "{:?}", sensor.0);
    for (frame, at) in (0_u64..).zip(&sensor.0) {
        assert!((25 * frame..25 * frame + 2).contains(at), "{:?}", sensor.0);
    }
    assert_eq!(display.0 as usize, sensor.0.len());
}
