//! How does the tilt box run on a Raspberry Pi Pico? Reads an LIS3DH on I2C0; draws on an SSD1306 on SPI0.
//!
//! docs/guide/tilt-box.md has the wiring. The chip's own `f32` routines (feature `intrinsics` of embassy-rp) round
//! differently: with them the box would have other bits than elsewhere.
#![no_std]
#![no_main]

use carom_soft_float as _; // arithmetic
use carom_tilt_box::{Memory, Mounting, Tilt, board, screen, sensor};
use defmt_rtt as _;
use embassy_executor::Spawner;
use embassy_rp::gpio::{Level, Output};
use embassy_rp::{i2c, spi};
use embassy_time::Delay;
use embedded_hal_bus::spi::ExclusiveDevice;
use panic_probe as _;
use static_cell::ConstStaticCell;

/// As many disks as this chip has time for.
const DISKS: usize = 8;
static MEMORY: ConstStaticCell<Memory<DISKS>> = ConstStaticCell::new(Memory::new());

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let pins = embassy_rp::init(embassy_rp::config::Config::default());

    let mut fast = i2c::Config::default();
    fast.frequency = 400_000;
    let mut bus = i2c::I2c::new_blocking(pins.I2C0, pins.PIN_5, pins.PIN_4, fast);

    let mut fast = spi::Config::default();
    fast.frequency = 8_000_000;
    let spi = spi::Spi::new_blocking_txonly(pins.SPI0, pins.PIN_18, pins.PIN_19, fast);
    let Ok(mut spi) = ExclusiveDevice::new(spi, Output::new(pins.PIN_17, Level::High), Delay);
    let mut data_or_command = Output::new(pins.PIN_20, Level::Low);
    let mut reset = Output::new(pins.PIN_21, Level::High);

    let mut screen = loop {
        match screen::oled(&mut spi, &mut data_or_command, &mut reset, &mut Delay) {
            Ok(screen) => break screen,
            Err(_) => board::wait_for("the SSD1306").await,
        }
    };
    let mut sensor = loop {
        match sensor::lis3dh(&mut bus) {
            Ok(sensor) => break sensor,
            Err(_) => board::wait_for("the LIS3DH").await,
        }
    };
    let tilt = Tilt::new(Mounting::default());
    board::run(MEMORY.take(), &mut sensor, &mut screen, tilt).await
}
