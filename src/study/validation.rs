//! The validation report: every scene of a set compared, the report's claims audited, one first screen.

use super::claims::{self, Claim};
use super::compare::{self, ComparisonOutcome};
use super::curves::{self, CurvesOutcome};
use super::ensemble::{self, Surroundings};
use super::extent::Extent;
use super::matrix::{Configuration, Timing, Watch};
use crate::engine::Roster;
use crate::scene::{Scene, SceneError, catalogue};

/// What a validation found.
#[derive(Debug)]
pub struct ValidationOutcome {
    /// The scenes, those after the last comparison too.
    pub scenes: Vec<Scene>,
    /// The engines of every comparison.
    pub columns: Vec<Configuration>,
    /// The scenes that were compared to the end, and the ensembles around those that ask for one.
    pub compared: Vec<(ComparisonOutcome, Option<Surroundings>)>,
    /// The report's claims; `None` where the user asked to stop before.
    pub claims: Option<Vec<Claim>>,
    /// The impact laws beside published curves, in the engines that promise to hold them; `None` where there are none, or before.
    pub laws: Option<CurvesOutcome>,
    /// Scenes that were compared, of those that were to be.
    pub extent: Extent,
    /// The audit and the curves that were made, of those that were to be.
    pub rest: Extent,
}

/// Runs the comparison of every scene, the audit and the curves.
///
/// `progress` counts scenes and the audit. A report that was stopped concludes from the scenes
/// that were compared to the end, and says so.
pub fn study(
    roster: &Roster,
    scenes: &[Scene],
    columns: &[Configuration],
    watch: Watch<'_>,
) -> Result<ValidationOutcome, SceneError> {
    let total = scenes.len() + 1;
    let silent = Watch {
        progress: &|_, _, _| {},
        cancelled: watch.cancelled,
    };
    let mut compared = Vec::new();
    for (done, scene) in scenes.iter().enumerate() {
        (watch.progress)(done, total, &scene.name);
        let richer = scene.richer.as_deref().map(catalogue::scene).transpose()?;
        // a comparison that lacks a run has no place beside whole ones
        let found = watch.whole(|| {
            let outcome = compare::study(scene, richer.as_ref(), columns, Timing::Alone, silent);
            let (surroundings, _) = ensemble::surroundings(&outcome, silent);
            (outcome, surroundings)
        });
        let Some(found) = found else {
            break;
        };
        compared.push(found);
    }
    (watch.progress)(scenes.len(), total, "the report's claims");
    let claims = watch.whole(|| claims::audit(roster, silent)).transpose()?;
    let laws = watch.whole(|| laws(columns, silent)).transpose()?;
    (watch.progress)(total, total, "done");
    let mut rest = Extent::default();
    rest.count(claims.is_some());
    rest.count(laws.is_some());
    Ok(ValidationOutcome {
        scenes: scenes.to_vec(),
        columns: columns.to_vec(),
        extent: Extent::of(compared.len() as u64, scenes.len() as u64),
        compared,
        claims,
        laws: laws.flatten(),
        rest,
    })
}

/// The impact laws beside published curves, in the engines of the report that promise to hold them; `None` if there are none.
fn laws(columns: &[Configuration], watch: Watch<'_>) -> Result<Option<CurvesOutcome>, SceneError> {
    let quick: Vec<Configuration> = columns
        .iter()
        .filter(|column| column.is_preset(|preset| preset.sound))
        .cloned()
        .collect();
    if quick.is_empty() {
        return Ok(None);
    }
    curves::study(&quick, watch).map(Some)
}
