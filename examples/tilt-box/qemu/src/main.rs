//! Does the box do here what it does on a workstation, and how long do its frames take? Reads a scripted accelerometer; writes lines over semihosting.
//!
//! First the lines of `carom_tilt_box::replay`, then what was counted: with all the time there is, and with that of a board.
#![no_std]
#![no_main]

mod counter;

use carom_tilt_box::replay::{self, Onlooker, Refusal};
use carom_tilt_box::screen::Canvas;
use carom_tilt_box::{Memory, TiltBox, frame};
use core::fmt;
use counter::Counter;
use semihosting::{print, println, process};
use static_cell::ConstStaticCell;

#[cfg(target_arch = "arm")]
use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
use riscv_rt::entry;

/// As many disks as the board of this family lets go: see the packages beside this one.
const DISKS: usize = if cfg!(target_abi = "eabihf") { 12 } else { 8 };
/// The clock of that board: nRF52840, RP2040, ESP32-C3. One instruction is taken as one cycle here.
const MEGAHERTZ: u64 = if cfg!(target_abi = "eabihf") {
    64
} else if cfg!(target_arch = "arm") {
    125
} else {
    160
};
/// What is compared with a workstation: as many disks on every target.
const COMPARED: usize = 12;

static COMPARED_MEMORY: ConstStaticCell<Memory<COMPARED>> = ConstStaticCell::new(Memory::new());
static MEMORY: ConstStaticCell<Memory<DISKS>> = ConstStaticCell::new(Memory::new());
static CANVAS: ConstStaticCell<Canvas> = ConstStaticCell::new(Canvas::new());

/// Text to the host.
struct Host;

impl fmt::Write for Host {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        print!("{text}");
        Ok(())
    }
}

/// Counts what frames take, and ends a share of time after so many instructions.
struct Stopwatch {
    counter: Counter,
    /// The longest that physics may take in a frame.
    share: u64,
    begun: u64,
    asked: u64,
    event: u64,
    frame: u64,
    all: u64,
    events: u64,
}

impl Stopwatch {
    fn start(counter: Counter, share: u64) -> Self {
        Self { counter, share, begun: 0, asked: 0, event: 0, frame: 0, all: 0, events: 0 }
    }
}

impl Onlooker for Stopwatch {
    fn begin(&mut self) {
        self.begun = self.counter.instructions();
        self.asked = self.begun;
    }

    fn has_time(&mut self) -> bool {
        let now = self.counter.instructions();
        self.event = self.event.max(now - self.asked);
        self.asked = now;
        self.events += 1;
        now - self.begun < self.share
    }

    fn end(&mut self, _: u32, _: &TiltBox<'_>) {
        let took = self.counter.instructions() - self.begun;
        self.frame = self.frame.max(took);
        self.all += took;
    }
}

fn measure(
    name: &str,
    memory: &mut Memory<DISKS>,
    canvas: &mut Canvas,
    watch: Stopwatch,
) -> Result<Counter, Refusal> {
    let mut watch = watch;
    let pace = replay::run(memory, canvas, &mut watch)?;
    println!("{name}.disks {DISKS}");
    println!("{name}.event {}", watch.event);
    println!("{name}.frame {}", watch.frame);
    println!("{name}.mean {}", watch.all / u64::from(pace.frames));
    println!("{name}.events {}", watch.events / u64::from(pace.frames));
    println!("{name}.slowed {} of {}", pace.slowed, pace.frames);
    println!("{name}.behind {}", pace.behind);
    Ok(watch.counter)
}

fn run() -> Result<(), Refusal> {
    let canvas = CANVAS.take();
    let written = replay::lines(COMPARED_MEMORY.take(), canvas, &mut Host)?;
    let (Ok(()), Some(counter)) = (written, Counter::start()) else { process::exit(2) };
    let memory = MEMORY.take();
    let counter = measure("unbounded", memory, canvas, Stopwatch::start(counter, u64::MAX))?;
    let share = MEGAHERTZ * 1000 * u64::from(frame::SHARE);
    measure("bounded", memory, canvas, Stopwatch::start(counter, share))?;
    Ok(())
}

#[entry]
fn main() -> ! {
    match run() {
        Ok(()) => process::exit(0),
        Err(refusal) => {
            println!("{refusal:?}");
            process::exit(1)
        }
    }
}
