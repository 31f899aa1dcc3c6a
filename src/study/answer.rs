//! One scene compared, with all that its summary says: the richer scene that it is a model of, and the ensemble that it may ask for.

use super::compare::{self, LengthUnit};
use super::ensemble;
use super::matrix::{Configuration, Timing, Watch};
use crate::engine::Limits;
use crate::finding::{Block, Document};
use crate::scene::{Scene, SceneError, catalogue};

/// What `carom compare` and the live page answer.
#[derive(Debug)]
pub struct Answer {
    /// The comparison.
    pub outcome: compare::ComparisonOutcome,
    /// What the ensemble around a scene of touching balls says; empty for any other scene.
    surroundings: Vec<Block>,
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

    /// What the terminal shows.
    pub fn summary(&self, unit: LengthUnit) -> Document {
        self.surrounded(compare::summary(&self.outcome, unit))
    }

    /// The same with pictures, ball by ball.
    pub fn page(&self) -> Document {
        self.surrounded(compare::page(&self.outcome))
    }

    fn surrounded(&self, mut document: Document) -> Document {
        ensemble::surround(&mut document, self.surroundings.clone());
        document
    }
}
