//! The only place for arguments, environment, terminal, paths, Ctrl-C and SIGTERM.
//!
//! Results go to stdout, everything else to stderr. Exit codes: [`exit::Exit`].

mod accepted;
mod arguments;
mod bounds;
mod check;
mod choice;
mod compare;
mod cost;
mod diff;
mod effects;
mod engines;
mod ensemble;
pub mod exit;
mod fuzz;
mod horizon;
mod output;
mod play;
mod report;
mod run;
pub mod scene;
pub mod scene_list;
mod stability;
mod terminal;
mod versions;

use crate::engine::Roster;
use crate::finding::Document;
use crate::report::Format;
use crate::scene::is_hidden;
use arguments::{Arguments, Command};
use clap::{CommandFactory, Parser};
use exit::Exit;
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::Ordering;

/// Why a command could not run, as shown after `error:`, or a message that is already rendered.
#[derive(Debug)]
enum Failure {
    /// A message of one line or more.
    Message(String),
    /// A diagnostic with its own heading.
    Rendered(String),
}

impl From<scene::LoadError> for Failure {
    fn from(error: scene::LoadError) -> Self {
        Failure::Rendered(error.render(terminal::colour_on_stderr()))
    }
}

impl From<crate::scene::SceneError> for Failure {
    fn from(error: crate::scene::SceneError) -> Self {
        scene::LoadError::from(error).into()
    }
}

impl From<output::OutputError> for Failure {
    fn from(error: output::OutputError) -> Self {
        Failure::Message(error.to_string())
    }
}

/// Runs the program with the arguments of the process.
pub fn main() -> ExitCode {
    terminal::listen();
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // clap's own code for usage errors is 2, for --help and --version 0
            let help = error.exit_code() == 0;
            let code = |exit: Exit| ExitCode::from(exit);
            // clap repeats what it was given; with nothing hidden in it, clap may colour its own words
            let mut given = std::env::args_os();
            if given.any(|word| word.to_string_lossy().contains(is_hidden)) {
                terminal::say(error.render().to_string().trim_end());
                return code(if help {
                    Exit::Finished
                } else {
                    Exit::CouldNotRun
                });
            }
            return match error.print() {
                Ok(()) if help => Exit::Finished.into(),
                _ => Exit::CouldNotRun.into(),
            };
        }
    };
    match dispatch(arguments.command, &Roster::built_in()) {
        Ok(code) => code,
        Err(Failure::Message(message)) => {
            terminal::say(&format!("error: {message}"));
            Exit::CouldNotRun.into()
        }
        Err(Failure::Rendered(text)) => {
            terminal::say_rendered(&text);
            Exit::CouldNotRun.into()
        }
    }
}

/// Writes a page where a folder is named, prints the summary, and says where the page is.
fn publish(
    summary: &Document,
    format: &Format,
    page: impl FnOnce() -> Document,
    folder: Option<&Path>,
) -> Result<ExitCode, Failure> {
    publish_with(summary, format, page, folder, Vec::new())
}

/// The same, with other files that belong to the page; `also`: name and content of each.
fn publish_with(
    summary: &Document,
    format: &Format,
    page: impl FnOnce() -> Document,
    folder: Option<&Path>,
    also: Vec<(String, String)>,
) -> Result<ExitCode, Failure> {
    let Some(folder) = folder else {
        return terminal::show(summary, format);
    };
    let site = write_site(summary, page, folder, also)?;
    let shown = Document {
        stopped_early: site.stopped_early.clone(),
        ..summary.clone()
    };
    let printed = terminal::show(&shown, format);
    if !site.files.is_empty() {
        terminal::say(&format!("Page: {}", folder.join("index.html").display()));
    }
    printed
}

/// What was written of a page and those below it.
struct Written {
    /// Every file, in the order in which they were written; none where writing was stopped.
    files: Vec<(String, String)>,
    /// What stands before everything else that is printed: the study's own words, or that writing was stopped.
    stopped_early: Option<String>,
}

/// Makes a page and writes it, with the files in `also` before it. Of a study that ran to its end nothing is written once the user asks
/// to stop; one that was stopped is written as it is, for that was asked before.
fn write_site(
    summary: &Document,
    page: impl FnOnce() -> Document,
    folder: &Path,
    also: Vec<(String, String)>,
) -> Result<Written, Failure> {
    let cancelled = terminal::cancelled();
    let enough = || summary.stopped_early.is_none() && cancelled.load(Ordering::Relaxed);
    let mut site = Written {
        files: Vec::new(),
        stopped_early: summary.stopped_early.clone(),
    };
    if !enough() {
        let page = page();
        if !enough() {
            site.files = also;
            // the first page last, by which others find their way
            site.files.extend(crate::report::site(&page));
        }
    }
    let files = site.files.iter().map(|(name, content)| (name, content));
    if site.files.is_empty() || !output::write_files_unless(folder, files, enough)? {
        site.files = Vec::new();
        site.stopped_early =
            Some("This was stopped early: everything was run, and no page was written.".to_owned());
    }
    Ok(site)
}

/// Runs a command with the engines that it may name.
fn dispatch(command: Option<Command>, roster: &Roster) -> Result<ExitCode, Failure> {
    match command {
        None => report::report(&arguments::ReportArguments::default(), roster),
        Some(Command::Report(arguments)) => report::report(&arguments, roster),
        Some(Command::Run(arguments)) => run::run(&arguments, roster),
        Some(Command::Compare(arguments)) => compare::compare(&arguments, roster),
        Some(Command::Cost(arguments)) => cost::cost(&arguments, roster),
        Some(Command::Horizon(arguments)) => horizon::horizon(&arguments),
        Some(Command::Ensemble(arguments)) => ensemble::ensemble(&arguments, roster),
        Some(Command::Effects(arguments)) => effects::effects(&arguments, roster),
        Some(Command::Play(arguments)) => play::play(&arguments, roster),
        Some(Command::Fuzz(arguments)) => fuzz::fuzz(&arguments, roster),
        Some(Command::Check(arguments)) => check::check(&arguments, roster),
        Some(Command::Diff(arguments)) => diff::diff(&arguments, roster),
        Some(Command::Stability(arguments)) => stability::stability(&arguments, roster),
        Some(Command::Engines { format }) => engines::engines(&format, roster),
        Some(Command::Scene { command, format }) => scene::scene(&command, &format),
        Some(Command::Completions { shell }) => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), "carom", &mut script);
            terminal::print(&String::from_utf8_lossy(&script))
        }
    }
}
