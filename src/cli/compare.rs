//! `carom compare`.

use super::arguments::{CompareArguments, parse_engines};
use super::{Failure, scene, terminal};
use crate::report;
use crate::scene::{Scene, catalogue};
use crate::study::compare::{LengthUnit, default_columns, plan, study, summary};
use crate::study::{Column, Timing, Watch, ensemble};
use std::process::ExitCode;

/// Compares one scene and prints the summary.
pub fn compare(arguments: &CompareArguments) -> Result<ExitCode, Failure> {
    let scene = scene::resolve(&arguments.scene)?;
    let richer = richer(&scene)?;
    let columns = columns(arguments.engines.as_deref())?;
    let progress = terminal::Progress::new();
    let show = |done: usize, total: usize, what: &str| progress.show(done, total, what);
    let watch = Watch {
        progress: &show,
        cancelled: terminal::cancelled(),
    };
    let outcome = study(&scene, richer.as_ref(), &columns, Timing::Alone, watch);
    let surroundings = ensemble::surroundings(&outcome, watch);
    drop(progress);
    let unit = match arguments.units.as_str() {
        "scene" => LengthUnit::Scene,
        _ => LengthUnit::Radius,
    };
    let mut document = summary(&outcome, unit);
    ensemble::surround(&mut document, surroundings);
    terminal::print(&report::render(&document, &arguments.format).unwrap_or_default())
}

/// The engines that were named, or the default ones; the exact engine first.
pub fn columns(engines: Option<&str>) -> Result<Vec<Column>, Failure> {
    let named = match engines {
        Some(list) => parse_engines(list)?,
        None => default_columns(),
    };
    Ok(plan(&named))
}

/// The scene that this one is a model of.
fn richer(scene: &Scene) -> Result<Option<Scene>, Failure> {
    let Some(name) = &scene.richer else {
        return Ok(None);
    };
    Ok(Some(catalogue::scene(name)?))
}
