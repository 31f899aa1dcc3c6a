//! Stdout, stderr, progress and Ctrl-C.

use super::Failure;
use crate::scene::printable;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Exit code of a program ended by Ctrl-C.
const INTERRUPTED: i32 = 130;

/// Set by the first Ctrl-C.
static CANCELLED: AtomicBool = AtomicBool::new(false);

/// Writes a result to stdout. A reader that went away (`| head`) is no error.
pub fn print(text: &str) -> Result<ExitCode, Failure> {
    let mut out = io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::Message(format!("cannot write to stdout: {error}")))
        }
        _ => Ok(ExitCode::SUCCESS),
    }
}

/// Writes words for a person to stderr, one line or several, whatever names of files, engines and balls are in them.
pub fn say(words: &str) {
    let lines: Vec<String> = words.split('\n').map(printable).collect();
    say_rendered(&lines.join("\n"));
}

/// The same for words that are safe for a terminal already, and may be coloured. There is nowhere to report that stderr is gone.
pub fn say_rendered(words: &str) {
    let _ = writeln!(io::stderr().lock(), "{words}");
}

/// True when a person sees stderr in colour.
pub fn colour_on_stderr() -> bool {
    io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none()
}

/// The flag that Ctrl-C sets: the first asks to stop and keep what there is, the second ends the program.
pub fn cancelled() -> &'static AtomicBool {
    // a second installation fails, and the first is still there
    let _ = ctrlc::set_handler(|| {
        if CANCELLED.swap(true, Ordering::Relaxed) {
            std::process::exit(INTERRUPTED);
        }
    });
    &CANCELLED
}

/// A bar on stderr, or nothing where no person looks.
#[derive(Debug)]
pub struct Progress(Option<ProgressBar>);

impl Progress {
    /// A bar of unknown length.
    pub fn new() -> Self {
        if !io::stderr().is_terminal() {
            return Progress(None);
        }
        let bar = ProgressBar::new(0);
        if let Ok(style) =
            ProgressStyle::with_template("{bar:30} {percent:>3} %, about {eta} left  {msg}")
        {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(200));
        Progress(Some(bar))
    }

    /// Shows how many parts are done, of how many, and which one is next or last.
    pub fn show(&self, done: usize, total: usize, what: &str) {
        if let Some(bar) = &self.0 {
            bar.set_length(total as u64);
            bar.set_position(done as u64);
            bar.set_message(printable(what));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.0 {
            bar.finish_and_clear();
        }
    }
}
