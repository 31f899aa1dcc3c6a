//! `carom effects`.

use super::arguments::{EffectsArguments, parse_engines};
use super::{Failure, publish, scene, terminal};
use crate::engine::Roster;
use crate::finding::Document;
use crate::page;
use crate::study::compare::plan;
use crate::study::{Watch, curves, effects};
use std::process::ExitCode;

/// Prints which effects a shot needs, or the curves of the impact laws; writes the page if a folder is named.
pub fn effects(arguments: &EffectsArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    let columns = plan(roster, &parse_engines(roster, &arguments.engines)?);
    let threshold = arguments.threshold;
    if !(threshold >= 0.0 && threshold.is_finite()) {
        return Err(Failure::Message(format!(
            "the threshold must be a finite number of R, 0 or greater, not {threshold}"
        )));
    }
    let scene = match &arguments.scene {
        Some(name) => Some(scene::resolve(name)?),
        None => None,
    };
    let progress = terminal::Progress::new();
    let show = |done: usize, total: usize, what: &str| progress.show(done, total, what);
    let watch = Watch {
        progress: &show,
        cancelled: terminal::cancelled(),
    };
    let (summary, page): (Document, Document) = match scene {
        Some(scene) => {
            let outcome = effects::study(&scene, &columns, threshold, watch)?;
            (
                page::effects::summary(&outcome),
                page::effects::page(&outcome),
            )
        }
        None => {
            let document = page::curves::page(&curves::study(&columns, watch)?);
            (document.clone(), document)
        }
    };
    drop(progress);
    publish(
        &summary,
        &arguments.format,
        || page,
        arguments.out.as_deref(),
    )
}
