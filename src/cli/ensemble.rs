//! `carom ensemble`.

use super::arguments::{EnsembleArguments, parse_engines};
use super::{Failure, bounds, publish, scene, terminal};
use crate::engine::Roster;
use crate::page::ensemble::{page, summary};
use crate::scene::Scene;
use crate::scene::perturb::Law;
use crate::study::Watch;
use crate::study::ensemble::{EnsembleError, Plan, plan_columns, study};
use std::process::ExitCode;

/// Runs an ensemble, prints the summary and writes the page if a folder is named.
pub fn ensemble(arguments: &EnsembleArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    let scene = scene::resolve(&arguments.scene)?;
    let plan = Plan {
        law: law(arguments, &scene),
        scene,
        samples: arguments.samples,
        seed: arguments.seed,
        columns: plan_columns(&parse_engines(roster, &arguments.engines)?),
    };
    let progress = terminal::Progress::new();
    let show = |done: usize, total: usize, what: &str| progress.show(done, total, what);
    let watch = Watch {
        progress: &show,
        cancelled: terminal::cancelled(),
    };
    let outcome = study(plan, watch);
    drop(progress);
    let outcome = outcome.map_err(|error| match error {
        EnsembleError::Samples { .. } => bounds::refused("--samples", &error),
        error => Failure::Message(error.to_string()),
    })?;
    publish(
        &summary(&outcome),
        &arguments.format,
        || page(&outcome),
        arguments.out.as_deref(),
    )
}

/// What the flags name varies and nothing else; without any, the scene's default law.
fn law(arguments: &EnsembleArguments, scene: &Scene) -> Law {
    let named = [arguments.aim, arguments.speed, arguments.gap];
    if named.iter().all(Option::is_none) {
        return Law::default_for(scene);
    }
    let [aim, speed, gap] = named.map(Option::unwrap_or_default);
    Law { aim, speed, gap }
}
