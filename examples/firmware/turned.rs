//! What do frames take of a box that is turned? Reads a scripted accelerometer and a chip's counter; shows the box, writes a line for each number.

use carom::law::Rule;
use carom::{Error, Scalar, World};
use carom_scenes::largest::largest;
use carom_scenes::tilt::{Board, frame};

/// How many readings of an accelerometer there are, and what they say.
pub type Script<S> = (u32, fn(u32) -> [S; 2]);

/// Instructions of a frame of 25 ms at 100 MHz: what is within them runs in real time.
pub const FRAME: u64 = 2_500_000;

/// Frames as long as they take: the longest event and frame, the mean, and how many take longer than 25 ms.
///
/// # Errors
/// Any error of the engine.
pub fn free<S: Scalar, R: Rule<S>>(
    world: &mut World<'_, S, 2, R>,
    (readings, accelerometer): Script<S>,
    board: &mut impl Board,
) -> Result<(), Error> {
    let [mut step, mut longest, mut all, mut longer] = [0; 4];
    for reading in 0..readings {
        let most = largest(world, reading..reading + 1, accelerometer, board)?;
        step = most.step.max(step);
        longest = most.frame.max(longest);
        all += most.all;
        longer += u64::from(most.frame > FRAME);
    }
    line(board, b"free.step", step);
    line(board, b"free.frame", longest);
    line(board, b"free.mean", all / u64::from(readings.max(1)));
    line(board, b"free.longer", longer);
    Ok(())
}

/// Physics has 25 ms of each frame; where that is too little the box goes slower. The longest frame, and in how many it
/// went slower. Something looks at the box after each.
///
/// # Errors
/// Any error of the engine.
pub fn shared<S: Scalar, R: Rule<S>, B: Board>(
    world: &mut World<'_, S, 2, R>,
    (readings, accelerometer): Script<S>,
    board: &mut B,
    mut look: impl FnMut(u32, &World<'_, S, 2, R>, &mut B),
) -> Result<(), Error> {
    let (mut longest, mut done) = (0, 0);
    for reading in 0..readings {
        let start = board.instructions();
        let in_time = || board.instructions() - start < FRAME;
        done += u32::from(frame(world, [reading, done], accelerometer, in_time)?);
        longest = (board.instructions() - start).max(longest);
        look(reading, world, board);
    }
    line(board, b"shared.frame", longest);
    line(board, b"shared.late", u64::from(readings - done));
    Ok(())
}

/// A name and a number. Formatting with `core::fmt` would cost flash and could panic.
pub fn line(board: &mut impl Board, name: &[u8], number: u64) {
    let (mut digits, mut rest) = ([0; 20], number);
    for digit in digits.iter_mut().rev() {
        *digit = b'0' + (rest % 10) as u8;
        rest /= 10;
    }
    let zeros = digits.iter().take(19).take_while(|&&digit| digit == b'0').count();
    board.write(name);
    board.write(b" ");
    board.write(digits.get(zeros..).unwrap_or_default());
    board.write(b"\n");
}
