//! How does the box run on a board? Reads the clock of `embassy-time`; runs frames, writes logs.

use accelerometer::Accelerometer;
use carom::Error;
use defmt::{error, info, warn};
use embassy_time::{Duration, Instant, Ticker, Timer};
use embedded_graphics::pixelcolor::BinaryColor;

use crate::frame::{FRAME, SHARE, TiltBox};
use crate::picture;
use crate::scene::Memory;
use crate::screen::Screen;
use crate::tilt::Tilt;

/// Frames between two lines of the log: five seconds.
const BETWEEN_LOGS: u32 = 200;

/// What a board has lost, beside what [`crate::Pace`] counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, defmt::Format)]
pub struct Losses {
    /// Readings of the accelerometer that failed: the last good one counted.
    pub readings: u32,
    /// Pictures that the display did not take.
    pub pictures: u32,
    /// The longest that physics took in one frame, in µs.
    pub longest: u64,
}

/// Runs the box as long as there is power: an error of the engine, which there should never be, is logged, and the
/// disks are let go anew.
pub async fn run<const N: usize, S>(
    memory: &mut Memory<N>,
    sensor: &mut impl Accelerometer,
    screen: &mut S,
    mut tilt: Tilt,
) -> !
where
    S: Screen<Color: From<BinaryColor>>,
{
    loop {
        let Err(error) = play(memory, sensor, screen, &mut tilt).await;
        error!("the box begins anew: {}", error);
        Timer::after_secs(1).await;
    }
}

/// Frame by frame, until the engine refuses.
async fn play<const N: usize, S>(
    memory: &mut Memory<N>,
    sensor: &mut impl Accelerometer,
    screen: &mut S,
    tilt: &mut Tilt,
) -> Result<core::convert::Infallible, Error>
where
    S: Screen<Color: From<BinaryColor>>,
{
    let mut tilt_box = TiltBox::new(memory)?;
    let mut losses = Losses::default();
    let mut frames = Ticker::every(Duration::from_millis(FRAME.into()));
    loop {
        let gravity = tilt.read(sensor);
        let begin = Instant::now();
        let end = begin + Duration::from_millis(SHARE.into());
        tilt_box.frame(gravity, || Instant::now() < end)?;
        losses.longest = losses.longest.max(begin.elapsed().as_micros());
        losses.readings = tilt.faults();
        if picture::draw(tilt_box.disks(), screen).and_then(|()| screen.show()).is_err() {
            losses.pictures = losses.pictures.saturating_add(1);
        }
        tell(&tilt_box, &losses);
        frames.next().await;
    }
}

/// Now and then, how well the box keeps up.
fn tell(tilt_box: &TiltBox<'_>, losses: &Losses) {
    let pace = tilt_box.pace();
    if !pace.frames.is_multiple_of(BETWEEN_LOGS) {
        return;
    }
    info!("{}, {}", pace, losses);
    if losses.readings > 0 || losses.pictures > 0 {
        warn!("a bus fails: are all wires in place?");
    }
}

/// Says that a part does not answer, and waits a second for the next attempt.
pub async fn wait_for(part: &'static str) {
    warn!("{=str} does not answer: are all wires in place?", part);
    Timer::after_secs(1).await;
}
