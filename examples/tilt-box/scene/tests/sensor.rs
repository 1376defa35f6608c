//! Does the box read its accelerometers? Mocks the bus byte by byte; reads gravity.

use accelerometer::Accelerometer;
use carom_tilt_box::scene::G;
use carom_tilt_box::script::{self, Script};
use carom_tilt_box::{Axis, Mounting, Tilt, sensor};
use embedded_hal::i2c::{ErrorKind, NoAcknowledgeSource};
use embedded_hal_mock::eh1::delay::NoopDelay;
use embedded_hal_mock::eh1::i2c::{Mock, Transaction};

const LIS3DH: u8 = 0x18;
const MPU6050: u8 = 0x68;

fn read(address: u8, register: u8, bytes: &[u8]) -> Transaction {
    Transaction::write_read(address, vec![register], bytes.to_vec())
}

fn write(address: u8, register: u8, value: u8) -> Transaction {
    Transaction::write(address, vec![register, value])
}

/// What the data sheet of the LIS3DH (ST, DocID17530, section 8) wants: identity 0x33; block data update and high
/// resolution in CTRL_REG4 (0x23); 100 Hz and three axes in CTRL_REG1 (0x20).
fn lis3dh_starts() -> Vec<Transaction> {
    let mut bus = vec![read(LIS3DH, 0x0F, &[0x33]), write(LIS3DH, 0x23, 0x80)];
    bus.extend([read(LIS3DH, 0x20, &[0x07]), write(LIS3DH, 0x20, 0x07)]);
    bus.extend([read(LIS3DH, 0x23, &[0x80]), write(LIS3DH, 0x23, 0x88)]);
    bus.extend([read(LIS3DH, 0x20, &[0x07]), write(LIS3DH, 0x20, 0x57)]);
    bus.extend([read(LIS3DH, 0x20, &[0x57]), write(LIS3DH, 0x20, 0x57)]);
    bus.extend([read(LIS3DH, 0x1F, &[0x00]), write(LIS3DH, 0x1F, 0x80)]);
    bus
}

/// One reading: mode and range, then six bytes from 0x28 on.
fn lis3dh_reads(bytes: [u8; 6]) -> Vec<Transaction> {
    vec![
        read(LIS3DH, 0x20, &[0x57]),
        read(LIS3DH, 0x23, &[0x88]),
        read(LIS3DH, 0x23, &[0x88]),
        read(LIS3DH, 0xA8, &bytes),
    ]
}

#[test]
fn an_lis3dh_is_read_in_steps_of_a_thousandth_of_g() {
    // 500 mg, -866 mg and 2 mg, left-justified in 16 bits.
    let bytes: Vec<u8> = [500_i16, -866, 2].iter().flat_map(|mg| (mg << 4).to_le_bytes()).collect();
    let mut bus = lis3dh_starts();
    bus.extend(lis3dh_reads(bytes.try_into().unwrap()));
    let mut mock = Mock::new(&bus);
    let mut sensor = sensor::lis3dh(&mut mock).unwrap();
    let [x, y] = Tilt::new(Mounting::default()).read(&mut sensor);
    assert!((x + 0.5 * G).abs() < 1e-6 * G && (y - 0.866 * G).abs() < 1e-6 * G, "{x} {y}");
    mock.done();
}

#[test]
fn somebody_else_at_its_address_is_refused() {
    let mut mock = Mock::new(&[read(LIS3DH, 0x0F, &[0x32])]);
    assert!(matches!(sensor::lis3dh(&mut mock), Err(lis3dh::Error::WrongAddress)));
    mock.done();
}

#[test]
fn nobody_at_its_address_is_an_error() {
    let nobody = ErrorKind::NoAcknowledge(NoAcknowledgeSource::Address);
    let mut mock = Mock::new(&[read(LIS3DH, 0x0F, &[0]).with_error(nobody)]);
    assert!(sensor::lis3dh(&mut mock).is_err());
    mock.done();
}

#[test]
fn where_the_bus_fails_the_last_reading_stays_and_the_fault_is_counted() {
    let mut bus = lis3dh_starts();
    bus.extend(lis3dh_reads([0, 0, 0xC0, 0x3E, 0, 0])); // (0, 1004, 0) mg
    bus.push(read(LIS3DH, 0x20, &[0]).with_error(ErrorKind::Bus));
    bus.extend(lis3dh_reads([0xC0, 0x3E, 0, 0, 0, 0]));
    let mut mock = Mock::new(&bus);
    let mut sensor = sensor::lis3dh(&mut mock).unwrap();
    let mut tilt = Tilt::new(Mounting::default());
    let upright = tilt.read(&mut sensor);
    assert_eq!((tilt.read(&mut sensor), tilt.faults()), (upright, 1));
    assert!((tilt.read(&mut sensor)[0] + 1.004 * G).abs() < 1e-6 && tilt.faults() == 1);
    mock.done();
}

/// Register map RM-MPU-6000A: PWR_MGMT_1 is 0x6B, ACCEL_CONFIG 0x1C, CONFIG 0x1A, ACCEL_XOUT_H 0x3B; 16384 a g.
#[test]
fn an_mpu6050_is_read_as_well() {
    let bus = [
        read(MPU6050, 0x6B, &[0x40]),
        write(MPU6050, 0x6B, 0x00),
        read(MPU6050, 0x6B, &[0x00]),
        write(MPU6050, 0x6B, 0x80),
        read(MPU6050, 0x6B, &[0x40]),
        write(MPU6050, 0x6B, 0x00),
        read(MPU6050, 0x1C, &[0x00]),
        write(MPU6050, 0x1C, 0x00),
        read(MPU6050, 0x1A, &[0x00]),
        write(MPU6050, 0x1A, 0x03),
        read(MPU6050, 0x3B, &[0xE0, 0x00, 0x10, 0x00, 0x00, 0x00]),
    ];
    let mut mock = Mock::new(&bus);
    let mut sensor = sensor::mpu6050(&mut mock, &mut NoopDelay).unwrap();
    let reading = sensor.accel_norm().unwrap();
    assert_eq!([reading.x, reading.y, reading.z], [-0.5, 0.25, 0.0]);
    mock.done();
}

/// A sensor that says what it is told.
struct Told([f32; 3]);

impl Accelerometer for Told {
    type Error = core::convert::Infallible;

    fn accel_norm(
        &mut self,
    ) -> Result<accelerometer::vector::F32x3, accelerometer::Error<Self::Error>> {
        let [x, y, z] = self.0;
        Ok(accelerometer::vector::F32x3::new(x, y, z))
    }

    fn sample_rate(&mut self) -> Result<f32, accelerometer::Error<Self::Error>> {
        Ok(100.0)
    }
}

#[test]
fn gravity_is_against_what_is_felt_however_the_sensor_is_mounted() {
    let mut felt = Told([0.1, 0.2, 0.3]);
    let mut read =
        |right, up| Tilt::new(Mounting { right, up }).read(&mut felt).map(|part| part / G);
    let near = |[x, y]: [f32; 2], wanted: [f32; 2]| {
        assert!((x - wanted[0]).abs() < 1e-6 && (y - wanted[1]).abs() < 1e-6, "{x} {y}");
    };
    near(read(Axis::X, Axis::Y), [-0.1, -0.2]);
    near(read(Axis::MinusY, Axis::X), [0.2, -0.1]);
    near(read(Axis::Z, Axis::MinusX), [-0.3, 0.1]);
    near(read(Axis::MinusZ, Axis::MinusY), [0.3, 0.2]);
}

#[test]
fn noise_changes_no_gravity() {
    let mut tilt = Tilt::new(Mounting::default());
    let before = tilt.read(&mut Told([0.2, 0.9, 0.3]));
    for noise in [-0.029, 0.015, 0.029] {
        assert_eq!(tilt.read(&mut Told([0.2 + noise, 0.9 - noise, 0.3])), before);
    }
    assert_ne!(tilt.read(&mut Told([0.2, 0.94, 0.3])), before);
}

/// The script through the driver of the real sensor.
#[test]
fn the_script_answers_as_an_lis3dh() {
    let mut sensor = sensor::lis3dh(Script::default()).unwrap();
    for reading in 0..script::READINGS {
        let (got, felt) = (sensor.accel_norm().unwrap(), script::felt(reading));
        assert_eq!(
            [got.x, got.y, got.z],
            [f32::from(felt[0]) * 0.001, f32::from(felt[1]) * 0.001, 0.0]
        );
        let strength = f32::from(felt[0]).hypot(f32::from(felt[1]));
        assert!((strength - 1000.0).abs() < 1.0, "reading {reading}: {strength} mg");
    }
    assert!(sensor::lis3dh(Elsewhere).is_err());
}

/// The script, but asked at another address.
struct Elsewhere;

impl embedded_hal::i2c::ErrorType for Elsewhere {
    type Error = ErrorKind;
}

impl embedded_hal::i2c::I2c for Elsewhere {
    fn transaction(
        &mut self,
        _: u8,
        operations: &mut [embedded_hal::i2c::Operation<'_>],
    ) -> Result<(), ErrorKind> {
        Script::default().transaction(0x19, operations)
    }
}
