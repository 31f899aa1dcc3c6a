//! `carom compare`.

use super::arguments::{CompareArguments, parse_engines};
use super::{Failure, scene, terminal};
use crate::engine::{Limits, Roster};
use crate::page::{answer, compare::shorten};
use crate::study::compare::{default_columns, plan};
use crate::study::{Answer, Configuration, Timing, Watch};
use std::process::ExitCode;

/// Compares one scene and prints the summary.
pub fn compare(arguments: &CompareArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    let scene = scene::resolve(&arguments.scene)?;
    let columns = columns(roster, arguments.engines.as_deref())?;
    let progress = terminal::Progress::new();
    let show = |done: usize, total: usize, what: &str| progress.show(done, total, what);
    let watch = Watch {
        progress: &show,
        cancelled: terminal::cancelled(),
    };
    let max_events = Limits::NONE.max_events;
    let answer = Answer::to(&scene, &columns, Timing::Alone, max_events, watch)?;
    drop(progress);
    let mut summary = answer::summary(&answer, arguments.units);
    if arguments.format.is_cut {
        shorten(&mut summary);
    }
    terminal::show(&summary, &arguments.format)
}

/// The engines that were named, or the default ones; the exact engine first.
pub fn columns(roster: &Roster, engines: Option<&str>) -> Result<Vec<Configuration>, Failure> {
    let named = match engines {
        Some(list) => parse_engines(roster, list)?,
        None => default_columns(roster),
    };
    Ok(plan(roster, &named))
}
