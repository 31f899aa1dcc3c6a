//! One scene compared, with all that its page says: the richer scene that it is a model of, and the ensemble that it may ask for.

use super::compare;
use super::ensemble::{self, Surroundings};
use super::matrix::{Configuration, Timing, Watch};
use crate::engine::Limits;
use crate::scene::{Scene, SceneError, catalogue};

/// What `carom compare` and the live page answer.
#[derive(Debug)]
pub struct Answer {
    /// The comparison.
    pub outcome: compare::ComparisonOutcome,
    /// The ensemble around a scene of touching balls that asks for one; `None` for any other scene.
    pub surroundings: Option<Surroundings>,
}

impl Answer {
    /// Compares a scene. `max_events`: see [`Limits`]. Errors: the catalogue has no scene of the name in `richer`.
    pub fn to(
        scene: &Scene,
        columns: &[Configuration],
        timing: Timing,
        max_events: u64,
        watch: Watch<'_>,
    ) -> Result<Self, SceneError> {
        let richer = scene.richer.as_deref().map(catalogue::scene).transpose()?;
        let limits = Limits {
            max_events,
            cancelled: watch.cancelled,
        };
        let mut outcome =
            compare::study_within(scene, richer.as_ref(), columns, timing, &limits, watch);
        let (surroundings, extent) = ensemble::surroundings(&outcome, watch);
        outcome.extent.add(extent);
        Ok(Answer {
            outcome,
            surroundings,
        })
    }
}
