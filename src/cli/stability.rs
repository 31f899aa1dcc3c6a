//! `carom stability`.

use super::arguments::{StabilityArguments, parse_engines};
use super::{Failure, publish, scene, terminal};
use crate::scene::{Scene, catalogue};
use crate::study::Watch;
use crate::study::stability::{Question, page, presets, study, summary};
use std::process::ExitCode;

/// Runs the hard cases.
pub fn stability(arguments: &StabilityArguments) -> Result<ExitCode, Failure> {
    let presets = match &arguments.engines {
        Some(list) => parse_engines(list)?,
        None => presets(),
    };
    let question = Question {
        scenes: scenes(arguments)?,
        presets,
        full: arguments.full,
        pictures: arguments.out.is_some(),
    };
    let progress = terminal::Progress::new();
    let show = |done: usize, total: usize, what: &str| progress.show(done, total, what);
    let watch = Watch {
        progress: &show,
        cancelled: terminal::cancelled(),
    };
    let outcome = study(question, watch);
    drop(progress);
    let outcome = outcome.map_err(|error| Failure::Message(error.to_string()))?;
    publish(
        &summary(&outcome, &|_, _| false),
        &arguments.format,
        || page(&outcome, &|_, _| false),
        arguments.out.as_deref(),
    )
}

/// The scenes that were named, or the set `hard`, without those that take long unless `--full` is given.
fn scenes(arguments: &StabilityArguments) -> Result<Vec<Scene>, Failure> {
    if !arguments.scenes.is_empty() {
        let named = arguments.scenes.iter().map(|name| scene::resolve(name));
        return Ok(named.collect::<Result<_, _>>()?);
    }
    let mut scenes = catalogue::set("hard")?;
    if !arguments.full {
        scenes.retain(|scene| !scene.sets.iter().any(|set| set == "full"));
    }
    Ok(scenes)
}
