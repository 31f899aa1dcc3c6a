//! Stdout, stderr, progress, Ctrl-C and SIGTERM.

use super::exit::Exit;
use super::{Failure, output};
use crate::finding::Document;
use crate::report::{Format, text};
use crate::scene::printable;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Set by the first Ctrl-C or SIGTERM.
static CANCELLED: AtomicBool = AtomicBool::new(false);

/// Set once a command looks at [`CANCELLED`].
static HEEDED: AtomicBool = AtomicBool::new(false);

/// Prints a document to stdout, and answers how a command ends that has nothing else to say.
pub fn show(document: &Document, format: &Format) -> Result<ExitCode, Failure> {
    let printed = print(&(format.write)(document, width()))?;
    let Some(stopped) = &document.stopped_early else {
        return Ok(printed);
    };
    if !format.has_words {
        say(stopped);
    }
    Ok(Exit::StoppedEarly.into())
}

/// Longest line for whoever reads stdout, in characters.
pub fn width() -> usize {
    let out = io::stdout();
    let told = terminal_size::terminal_size_of(&out).map(|(width, _)| width.0);
    let columns = std::env::var("COLUMNS").ok();
    width_of(out.is_terminal(), told, columns.as_deref())
}

/// The same for a stream that is a terminal or none, with what the terminal tells, and the variable COLUMNS for where it does not: a
/// terminal on a line tells 0. A file or another program gets lines that do not depend on where they were written.
fn width_of(is_terminal: bool, told: Option<u16>, columns: Option<&str>) -> usize {
    if !is_terminal {
        return text::WIDTH;
    }
    let told = told.map(usize::from).filter(|&width| width > 0);
    let named = || columns.and_then(|columns| columns.trim().parse().ok());
    told.or_else(named)
        .filter(|&width| width > 0)
        .unwrap_or(text::WIDTH)
        .clamp(text::NARROWEST, text::WIDEST)
}

/// Writes a result to stdout. A reader that went away (`| head`) is no error.
pub fn print(text: &str) -> Result<ExitCode, Failure> {
    let mut out = io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::Message(format!("cannot write to stdout: {error}")))
        }
        _ => Ok(Exit::Finished.into()),
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

/// Listens for Ctrl-C, SIGTERM and the end of the terminal from now on. Until a command has asked for [`cancelled`], the first one
/// ends the program.
pub fn listen() {
    #[cfg(target_os = "linux")]
    spare_hangups();
    // where it cannot be listened for, the system ends the program
    let _ = ctrlc::set_handler(|| {
        if !HEEDED.load(Ordering::Relaxed) {
            say("This was stopped early: nothing was done.");
            end();
        }
        if CANCELLED.swap(true, Ordering::Relaxed) {
            end();
        }
    });
}

/// What `nohup` began goes on when its terminal ends: there SIGHUP is ignored, and the handler, which is one for all signals, must not see it.
#[cfg(target_os = "linux")]
fn spare_hangups() {
    use nix::sys::signal::{SigSet, Signal};
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status
        .lines()
        .find_map(|line| line.strip_prefix("SigIgn:"))
        .and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    // the first bit is signal 1, which is this one
    if ignored.is_some_and(|mask| mask & 1 == 1) {
        let mut hangup = SigSet::empty();
        hangup.add(Signal::SIGHUP);
        // every thread is begun after this one and does as it does; where it cannot, a hangup stops the program
        hangup.thread_block().ok();
    }
}

/// Ends the program at once, and leaves no file half written.
fn end() {
    let _nobody_writes = output::abandon();
    std::process::exit(i32::from(Exit::StoppedEarly.code()));
}

/// The flag that Ctrl-C and SIGTERM set: the first asks to stop and keep what there is, the second ends the program.
pub fn cancelled() -> &'static AtomicBool {
    HEEDED.store(true, Ordering::Relaxed);
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

#[cfg(test)]
mod tests {
    use super::width_of;

    #[test]
    fn a_line_is_as_long_as_the_terminal_from_62_to_160_and_100_without_one() {
        for (is_terminal, told, columns, width, why) in [
            (true, Some(120), None, 120, "as the terminal tells"),
            (
                true,
                Some(120),
                Some("80"),
                120,
                "the terminal knows better",
            ),
            (true, Some(300), None, 160, "rows are lost in longer lines"),
            (true, Some(20), None, 62, "two columns need room"),
            (
                true,
                Some(0),
                Some("132"),
                132,
                "a terminal that does not know",
            ),
            (
                true,
                None,
                Some(" 80 "),
                80,
                "a terminal that does not tell",
            ),
            (true, None, Some("wide"), 100, "no number"),
            (true, None, Some("0"), 100, "nothing known"),
            (true, None, None, 100, "nothing known"),
            (false, Some(160), Some("160"), 100, "a pipe or a file"),
        ] {
            assert_eq!(width_of(is_terminal, told, columns), width, "{why}");
        }
    }
}
