//! How does the tilt box run on an nRF52840-DK? Reads an LIS3DH on TWISPI0; draws on an SSD1306 on SPI3.
//!
//! docs/guide/tilt-box.md has the wiring.
#![no_std]
#![no_main]

use carom_tilt_box::{Memory, Mounting, Tilt, board, screen, sensor};
use cortex_m as _; // its critical section
use defmt_rtt as _;
use embassy_executor::Spawner;
use embassy_nrf::gpio::{Level, Output, OutputDrive};
use embassy_nrf::{bind_interrupts, peripherals, spim, twim};
use embassy_time::Delay;
use embedded_hal_bus::spi::ExclusiveDevice;
use panic_probe as _;
use static_cell::ConstStaticCell;

bind_interrupts!(struct Interrupts {
    TWISPI0 => twim::InterruptHandler<peripherals::TWISPI0>;
    SPIM3 => spim::InterruptHandler<peripherals::SPI3>;
});

/// As many disks as this chip has time for.
const DISKS: usize = 12;
static MEMORY: ConstStaticCell<Memory<DISKS>> = ConstStaticCell::new(Memory::new());
/// The chip's bus reads RAM only: what is written from flash is copied here.
static SENT: ConstStaticCell<[u8; 16]> = ConstStaticCell::new([0; 16]);

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let pins = embassy_nrf::init(embassy_nrf::config::Config::default());
    let output = |pin: embassy_nrf::Peri<'static, embassy_nrf::gpio::AnyPin>, level| {
        Output::new(pin, level, OutputDrive::Standard)
    };

    let mut fast = twim::Config::default();
    fast.frequency = twim::Frequency::K400;
    let mut bus =
        twim::Twim::new(pins.TWISPI0, Interrupts, pins.P0_26, pins.P0_27, fast, SENT.take());

    let mut fast = spim::Config::default();
    fast.frequency = spim::Frequency::M8;
    let spi = spim::Spim::new_txonly(pins.SPI3, Interrupts, pins.P1_15, pins.P1_13, fast);
    let Ok(mut spi) = ExclusiveDevice::new(spi, output(pins.P1_12.into(), Level::High), Delay);
    let mut data_or_command = output(pins.P1_11.into(), Level::Low);
    let mut reset = output(pins.P1_10.into(), Level::High);

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
