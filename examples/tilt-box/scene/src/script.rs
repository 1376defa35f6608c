//! How is the box tilted where there is no sensor? An I²C bus on which an LIS3DH answers by a script; reads and writes registers.
//!
//! The driver is the real one: the firmware of QEMU, the tests and the pictures of the workstation run all of the box but
//! the bus itself.

use embedded_hal::i2c::{ErrorKind, ErrorType, I2c, NoAcknowledgeSource, Operation};

/// The address of an LIS3DH whose SDO is tied to ground.
pub const ADDRESS: u8 = 0x18;

const WHO_AM_I: usize = 0x0F;
const OUT_X_L: usize = 0x28;
const REGISTERS: usize = 0x40;
/// In the register's number: go on to the next register with the next byte.
const AUTO_INCREMENT: u8 = 0x80;

/// How long the script goes on: so many readings, one a frame.
pub const READINGS: u32 = 240;

/// The bus with an LIS3DH that is rocked, turned over, and held still.
#[derive(Clone, Debug)]
pub struct Script {
    registers: [u8; REGISTERS],
    reading: u32,
}

impl Default for Script {
    fn default() -> Self {
        let mut registers = [0; REGISTERS];
        registers[WHO_AM_I] = 0x33;
        Self { registers, reading: 0 }
    }
}

/// The acceleration that is felt in a reading, in mg, along x and y: 1 g, turned.
///
/// Four seconds of rocking by up to 67.5 degrees, one in which the box is turned over once, one held still.
#[must_use]
pub fn felt(reading: u32) -> [i16; 2] {
    let turn = match reading {
        rocked @ 0..160 => [0, 4, 8, 12, 8, 4, 0, 60, 56, 52, 56, 60][rocked as usize / 4 % 12],
        turned @ 160..200 => 64 * (turned - 160) / 40,
        _ => 0,
    };
    [sine(turn), sine(turn + 16)]
}

/// 1000 times the sine of a 64th of a turn.
fn sine(turn: u32) -> i16 {
    const QUARTER: [i16; 17] =
        [0, 98, 195, 290, 383, 471, 556, 634, 707, 773, 831, 882, 924, 957, 981, 995, 1000];
    let part = (turn % 32) as usize;
    let value = QUARTER.get(part.min(32 - part)).copied().unwrap_or(0);
    if turn % 64 < 32 { value } else { -value }
}

impl Script {
    /// The registers of the next reading: in steps of 1 mg, left-justified.
    fn sample(&mut self) {
        let [x, y] = felt(self.reading);
        self.reading += 1;
        for (place, part) in [x, y, 0].into_iter().enumerate() {
            let bytes = (part << 4).to_le_bytes();
            let low = OUT_X_L + 2 * place;
            self.registers[low..low + 2].copy_from_slice(&bytes);
        }
    }

    fn answer(&mut self, pointer: u8, buffer: &mut [u8]) {
        let first = usize::from(pointer & !AUTO_INCREMENT);
        if first == OUT_X_L {
            self.sample();
        }
        let step = usize::from(pointer & AUTO_INCREMENT != 0);
        for (k, byte) in buffer.iter_mut().enumerate() {
            *byte = self.registers.get(first + k * step).copied().unwrap_or(0);
        }
    }

    fn accept(&mut self, pointer: u8, bytes: &[u8]) {
        let first = usize::from(pointer & !AUTO_INCREMENT);
        for (register, byte) in self.registers.iter_mut().skip(first).zip(bytes) {
            *register = *byte;
        }
    }
}

impl ErrorType for Script {
    type Error = ErrorKind;
}

impl I2c for Script {
    fn transaction(
        &mut self,
        address: u8,
        operations: &mut [Operation<'_>],
    ) -> Result<(), Self::Error> {
        if address != ADDRESS {
            return Err(ErrorKind::NoAcknowledge(NoAcknowledgeSource::Address));
        }
        let mut pointer = 0;
        for operation in operations {
            match operation {
                Operation::Write([register, bytes @ ..]) => {
                    pointer = *register;
                    self.accept(pointer, bytes);
                }
                Operation::Write([]) => {}
                Operation::Read(buffer) => self.answer(pointer, buffer),
            }
        }
        Ok(())
    }
}
