//! Which effects a shot needs, and what leaving one out would cost.
//!
//! Plan: the scene with each of its effects alone on the bare model, with all, and with all but one; and the ladder of scenes that
//! `richer` links with it, or else its effects one upon the other. Conclusion: how far each moves the balls from where the whole
//! scene leaves them, which of them the shot needs, and how long each takes.

mod change;
mod optional;
mod plan;

pub use change::{Change, Owned, energy_at, fallen};
pub use optional::{Optional, dependents, present, reduced};
pub use plan::{Plan, Rung, Variant, WHOLE};

use super::Extent;
use super::matrix::{self, Cell, Configuration, Timing, Watch};
use crate::scene::{Scene, SceneError};
use crate::trace::{Record, Trace};
use crate::words::describe_ending;

/// Everything that an ablation found.
#[derive(Debug)]
pub struct EffectsOutcome {
    /// What was run.
    pub plan: Plan,
    /// The engines, the exact ones first.
    pub columns: Vec<Configuration>,
    /// A ball that moves farther than this when an effect is left out makes that effect needed, R.
    pub threshold: f64,
    /// One entry a row of the plan, one cell a column; fewer rows if the user asked to stop.
    pub cells: Vec<Vec<Cell>>,
    /// Index of the column whose whole scene all else is held against: the first that reaches its end; `None` if none does.
    pub reference: Option<usize>,
    /// When energies are compared, s: half of the shortest complete run of the reference's engine.
    pub common_time: f64,
}

/// What leaving an effect out means for a shot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It moves a ball farther than the threshold, or changes who falls.
    Needed,
    /// It does neither.
    NotNeeded,
    /// The run without it has no end to compare.
    Unknown,
}

/// Runs the ablation of a scene. Errors: a scene that `richer` names cannot be read.
pub fn study(
    scene: &Scene,
    columns: &[Configuration],
    threshold: f64,
    watch: Watch<'_>,
) -> Result<EffectsOutcome, SceneError> {
    let plan = Plan::new(scene)?;
    let silent = Watch {
        progress: &|_, _, _| {},
        cancelled: watch.cancelled,
    };
    let mut cells = Vec::new();
    for (done, row) in plan.rows.iter().enumerate() {
        let what = format!("{} with {}", row.name, row.effects.named().join(" "));
        (watch.progress)(done, plan.rows.len(), &what);
        // a row that not every engine has run says nothing
        let ran =
            silent.whole(|| matrix::run_row(row, columns, Record::Events, Timing::Alone, silent));
        let Some(ran) = ran else { break };
        cells.push(ran);
    }
    Ok(conclude(plan, columns, threshold, cells))
}

/// Concludes from the cells.
fn conclude(
    plan: Plan,
    columns: &[Configuration],
    threshold: f64,
    cells: Vec<Vec<Cell>>,
) -> EffectsOutcome {
    let mut outcome = EffectsOutcome {
        plan,
        columns: columns.to_vec(),
        threshold,
        cells,
        reference: None,
        common_time: 0.0,
    };
    let complete = |column: &usize| outcome.complete(WHOLE, *column).is_some();
    outcome.reference = (0..columns.len()).find(complete);
    if let Some(column) = outcome.reference {
        let rows = 0..outcome.cells.len();
        let ends = rows.filter_map(|row| Some(outcome.complete(row, column)?.end_time));
        outcome.common_time = ends.fold(f64::INFINITY, f64::min) / 2.0;
    }
    outcome
}

impl EffectsOutcome {
    /// What stands before everything else where the user asked to stop before it was done.
    pub fn stopped_early(&self) -> Option<String> {
        Extent::of(self.cells.len() as u64, self.plan.rows.len() as u64)
            .stopped_early("combinations of effects were run in every engine")
    }

    /// The run of a row in a column, whatever its end; `None` after a refusal.
    pub fn trace(&self, row: usize, column: usize) -> Option<&Trace> {
        let cell = self.cells.get(row)?.get(column)?;
        cell.as_ref().ok().map(|ran| &ran.trace)
    }

    /// The run of a row in a column, if it reached its end.
    pub fn complete(&self, row: usize, column: usize) -> Option<&Trace> {
        self.trace(row, column)
            .filter(|trace| trace.ending.is_complete())
    }

    /// The whole scene in the engine that all else is held against.
    pub fn whole(&self) -> Option<&Trace> {
        self.complete(WHOLE, self.reference?)
    }

    /// How a row in a column differs from row `from` in the reference's engine.
    pub fn change(&self, row: usize, column: usize, from: usize) -> Option<Change> {
        let reference = self.complete(from, self.reference?)?;
        let trace = self.complete(row, column)?;
        Some(Change::between(&self.plan.scene, trace, reference))
    }

    /// What leaving an effect out costs, in the reference's engine.
    pub fn cost(&self, variant: &Variant) -> Option<Change> {
        self.change(variant.row, self.reference?, WHOLE)
    }

    /// Whether the shot needs an effect.
    pub fn verdict(&self, variant: &Variant) -> Verdict {
        match self.cost(variant) {
            None => Verdict::Unknown,
            // written so that a NaN is needed
            Some(change) if change.falls.is_empty() && change.moved() <= self.threshold => {
                Verdict::NotNeeded
            }
            Some(_) => Verdict::Needed,
        }
    }

    /// The effects by what leaving them out costs: those that change who falls, then by distance; unknown ones last.
    pub fn by_cost(&self) -> Vec<&Variant> {
        let mut variants: Vec<&Variant> = self.plan.without.iter().collect();
        let rank = |variant: &Variant| {
            self.cost(variant).map_or((2, 0.0), |change| {
                (u8::from(change.falls.is_empty()), -change.moved())
            })
        };
        variants.sort_by(|a, b| {
            let (a, b) = (rank(a), rank(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        variants
    }

    /// Shortest time of a run, s.
    pub fn seconds(&self, row: usize, column: usize) -> Option<f64> {
        let cell = self.cells.get(row)?.get(column)?;
        cell.as_ref().ok().and_then(|ran| ran.seconds)
    }

    /// Why a row in a column has no end to compare, in one sentence; `None` where it has, or was not run.
    pub fn why_not(&self, row: usize, column: usize) -> Option<String> {
        match self.cells.get(row)?.get(column)? {
            Err(refusal) => Some(format!("{} {refusal}", self.columns[column].label())),
            Ok(ran) if ran.trace.ending.is_complete() => None,
            Ok(ran) => Some(describe_ending(&ran.trace)),
        }
    }
}
