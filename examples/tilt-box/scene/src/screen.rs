//! Which display does the box know? Reads a picture; sends it over any SPI bus of `embedded-hal` to an SSD1306.

use display_interface::DisplayError;
use display_interface_spi::SPIInterface;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU1};
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiDevice;
use ssd1306::Ssd1306;
use ssd1306::mode::{BufferedGraphicsMode, DisplayConfig as _};
use ssd1306::rotation::DisplayRotation;
use ssd1306::size::DisplaySize128x64;

/// A display that is drawn on first and shown then.
pub trait Screen: DrawTarget {
    /// Shows what has been drawn.
    ///
    /// # Errors
    /// Where the bus fails.
    fn show(&mut self) -> Result<(), Self::Error>;
}

/// A picture in memory, where there is no display.
pub type Canvas =
    Framebuffer<BinaryColor, RawU1, LittleEndian, 128, 64, { buffer_size::<BinaryColor>(128, 64) }>;

/// An OLED of 128 × 64 pixels.
pub type Oled<SPI, DC> =
    Ssd1306<SPIInterface<SPI, DC>, DisplaySize128x64, BufferedGraphicsMode<DisplaySize128x64>>;

/// An SSD1306 over SPI: over I²C one picture takes a whole frame. It keeps a picture of 1 KB.
///
/// # Errors
/// Where the bus or a pin fails.
pub fn oled<SPI: SpiDevice, DC: OutputPin>(
    bus: SPI,
    data_or_command: DC,
    reset: &mut impl OutputPin,
    delay: &mut impl DelayNs,
) -> Result<Oled<SPI, DC>, DisplayError> {
    let interface = SPIInterface::new(bus, data_or_command);
    let mut oled = Ssd1306::new(interface, DisplaySize128x64, DisplayRotation::Rotate0)
        .into_buffered_graphics_mode();
    oled.reset(reset, delay).map_err(|_| DisplayError::RSError)?;
    oled.init()?;
    Ok(oled)
}

impl<SPI: SpiDevice, DC: OutputPin> Screen for Oled<SPI, DC> {
    fn show(&mut self) -> Result<(), Self::Error> {
        self.flush()
    }
}
