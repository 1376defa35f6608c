//! How does the tilt box run on an ESP32-C3? Reads an LIS3DH on I2C0; draws on an SSD1306 on SPI2.
//!
//! docs/guide/tilt-box.md has the wiring.
#![no_std]
#![no_main]

use carom_soft_float as _; // arithmetic
use carom_tilt_box::{Memory, Mounting, Tilt, board, screen, sensor};
use embassy_executor::Spawner;
use embassy_time::Delay;
use embedded_hal_bus::spi::ExclusiveDevice;
use esp_backtrace as _;
use esp_hal::clock::CpuClock;
use esp_hal::gpio::{Level, Output, OutputConfig};
use esp_hal::time::Rate;
use esp_hal::timer::timg::TimerGroup;
use esp_hal::{i2c, spi};
use esp_println as _;
use static_cell::ConstStaticCell;

esp_bootloader_esp_idf::esp_app_desc!();

/// As many disks as this chip has time for.
const DISKS: usize = 8;
static MEMORY: ConstStaticCell<Memory<DISKS>> = ConstStaticCell::new(Memory::new());

#[esp_rtos::main]
async fn main(_spawner: Spawner) {
    let pins = esp_hal::init(esp_hal::Config::default().with_cpu_clock(CpuClock::max()));
    esp_rtos::start(TimerGroup::new(pins.TIMG0).timer0, pins.FROM_CPU_INTR0);

    let fast = i2c::master::Config::default().with_frequency(Rate::from_khz(400));
    let bus = i2c::master::I2c::new(pins.I2C0, fast);
    let mut bus = defmt::unwrap!(bus).with_sda(pins.GPIO4).with_scl(pins.GPIO5);

    let fast = spi::master::Config::default().with_frequency(Rate::from_mhz(8));
    let spi = spi::master::Spi::new(pins.SPI2, fast);
    let spi = defmt::unwrap!(spi).with_sck(pins.GPIO6).with_mosi(pins.GPIO7);
    let select = Output::new(pins.GPIO10, Level::High, OutputConfig::default());
    let Ok(mut spi) = ExclusiveDevice::new(spi, select, Delay);
    let mut data_or_command = Output::new(pins.GPIO1, Level::Low, OutputConfig::default());
    let mut reset = Output::new(pins.GPIO0, Level::High, OutputConfig::default());

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
