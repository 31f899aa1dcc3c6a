//! The only place for arguments, environment, terminal, paths and Ctrl-C.
//!
//! Results go to stdout, everything else to stderr. Exit codes: 0 finished, 1 something that must hold does not, 2 it could not run.

mod accepted;
mod arguments;
mod bounds;
mod check;
mod compare;
mod cost;
mod diff;
mod effects;
mod engines;
mod ensemble;
mod fuzz;
mod horizon;
mod orphans;
mod output;
mod play;
mod report;
mod run;
pub mod scene;
mod stability;
mod terminal;
mod versions;

use crate::finding::Document;
use crate::scene::is_hidden;
use arguments::{Arguments, Command};
use clap::{CommandFactory, Parser};
use std::path::Path;
use std::process::ExitCode;

/// It ran, and what was expected of it is not so.
const NOT_MET: u8 = 1;

/// It could not run: bad usage, bad scene, a file that cannot be written.
const COULD_NOT_RUN: u8 = 2;

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
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // clap's own code for usage errors is 2, for --help and --version 0
            let code = u8::try_from(error.exit_code()).unwrap_or(COULD_NOT_RUN);
            // clap repeats what it was given; with nothing hidden in it, clap may colour its own words
            let given = std::env::args_os();
            if given
                .into_iter()
                .any(|word| word.to_string_lossy().contains(is_hidden))
            {
                terminal::say(error.render().to_string().trim_end());
                return ExitCode::from(code);
            }
            return if error.print().is_ok() {
                ExitCode::from(code)
            } else {
                ExitCode::from(COULD_NOT_RUN)
            };
        }
    };
    match dispatch(arguments.command) {
        Ok(code) => code,
        Err(Failure::Message(message)) => {
            terminal::say(&format!("error: {message}"));
            ExitCode::from(COULD_NOT_RUN)
        }
        Err(Failure::Rendered(text)) => {
            terminal::say_rendered(&text);
            ExitCode::from(COULD_NOT_RUN)
        }
    }
}

/// Writes a page where a folder is named, prints the summary, and says where the page is.
fn publish(
    summary: &Document,
    format: &str,
    page: impl FnOnce() -> Document,
    folder: Option<&Path>,
) -> Result<ExitCode, Failure> {
    publish_with(summary, format, page, folder, Vec::new())
}

/// The same, with other files that belong to the page; `also`: name and content of each.
fn publish_with(
    summary: &Document,
    format: &str,
    page: impl FnOnce() -> Document,
    folder: Option<&Path>,
    mut also: Vec<(String, String)>,
) -> Result<ExitCode, Failure> {
    if let Some(folder) = folder {
        // the first page last, by which others find their way
        also.extend(crate::report::site(&page()));
        output::write_files(folder, also)?;
    }
    let printed = terminal::print(&crate::report::render(summary, format).unwrap_or_default());
    if let Some(folder) = folder {
        terminal::say(&format!("Page: {}", folder.join("index.html").display()));
    }
    printed
}

fn dispatch(command: Option<Command>) -> Result<ExitCode, Failure> {
    match command {
        None => report::report(&arguments::ReportArguments::default()),
        Some(Command::Report(arguments)) => report::report(&arguments),
        Some(Command::Run(arguments)) => run::run(&arguments),
        Some(Command::Compare(arguments)) => compare::compare(&arguments),
        Some(Command::Cost(arguments)) => cost::cost(&arguments),
        Some(Command::Horizon(arguments)) => horizon::horizon(&arguments),
        Some(Command::Ensemble(arguments)) => ensemble::ensemble(&arguments),
        Some(Command::Effects(arguments)) => effects::effects(&arguments),
        Some(Command::Play(arguments)) => play::play(&arguments),
        Some(Command::Fuzz(arguments)) => fuzz::fuzz(&arguments),
        Some(Command::Check(arguments)) => check::check(&arguments),
        Some(Command::Diff(arguments)) => diff::diff(&arguments),
        Some(Command::Stability(arguments)) => stability::stability(&arguments),
        Some(Command::Engines { format }) => engines::engines(format),
        Some(Command::Scene { command, format }) => scene::scene(&command, format),
        Some(Command::Completions { shell }) => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), "carom", &mut script);
            terminal::print(&String::from_utf8_lossy(&script))
        }
    }
}
