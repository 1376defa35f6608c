//! What does the user want? Reads the command line; writes results where the command says, one line per error.

use carom_host::{cli, interrupt, output};
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    // Without a handler an interrupt would still never leave a half-written file, only a draft.
    let _ = ctrlc::set_handler(interrupt::handle);
    match cli::run(std::env::args_os()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if output::is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "carom: {error:#}");
            if error.is::<interrupt::Stopped>() { ExitCode::from(130) } else { ExitCode::FAILURE }
        }
    }
}
