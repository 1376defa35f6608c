//! Which accelerometers does the box know? Reads registers over any I²C bus of `embedded-hal`; writes accelerations in g.
//!
//! Whatever else implements [`accelerometer::Accelerometer`] will do as well.

use accelerometer::vector::F32x3;
use accelerometer::{Accelerometer, ErrorKind};
use embedded_hal::delay::DelayNs;
use embedded_hal::i2c::I2c;
use lis3dh::{Configuration, DataRate, Lis3dh, Lis3dhI2C, SlaveAddr};
use mpu6050_dmp::accel::AccelFullScale;
use mpu6050_dmp::address::Address;
use mpu6050_dmp::config::DigitalLowPassFilter;
use mpu6050_dmp::error::Error;
use mpu6050_dmp::sensor::Mpu6050 as Driver;

/// An LIS3DH at its usual address (0x18, SDO to ground), ±2 g, 100 readings a second.
///
/// # Errors
/// Where the bus fails, or somebody else answers at that address.
pub fn lis3dh<I: I2c>(
    bus: I,
) -> Result<Lis3dh<Lis3dhI2C<I>>, lis3dh::Error<I::Error, core::convert::Infallible>> {
    let configuration = Configuration { datarate: DataRate::Hz_100, ..Configuration::default() };
    Lis3dh::new_i2c_with_config(bus, SlaveAddr::Default, configuration)
}

/// An MPU-6050 as an accelerometer: ±2 g, what is faster than 44 Hz filtered out.
pub struct Mpu6050<I: I2c>(Driver<I>);

/// An MPU-6050 at its usual address (0x68, AD0 to ground).
///
/// It is reset first: the driver only ever sets bits of range and filter, and it may have kept those of another program.
///
/// # Errors
/// Where the bus fails.
pub fn mpu6050<I: I2c>(bus: I, delay: &mut impl DelayNs) -> Result<Mpu6050<I>, Error<I>> {
    let mut driver = Driver::new(bus, Address::default()).map_err(|failed| failed.error)?;
    driver.reset(delay)?;
    driver.disable_sleep()?;
    driver.set_accel_full_scale(AccelFullScale::G2)?;
    driver.set_digital_lowpass_filter(DigitalLowPassFilter::Filter3)?;
    Ok(Mpu6050(driver))
}

impl<I: I2c> Accelerometer for Mpu6050<I> {
    type Error = Error<I>;

    fn accel_norm(&mut self) -> Result<F32x3, accelerometer::Error<Self::Error>> {
        let reading = self
            .0
            .accel()
            .map_err(|cause| accelerometer::Error::new_with_cause(ErrorKind::Bus, cause))?;
        let part = |raw| AccelFullScale::G2.scale_value(raw);
        Ok(F32x3::new(part(reading.x()), part(reading.y()), part(reading.z())))
    }

    fn sample_rate(&mut self) -> Result<f32, accelerometer::Error<Self::Error>> {
        Ok(1000.0)
    }
}
