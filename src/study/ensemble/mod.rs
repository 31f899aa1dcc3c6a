//! Ensembles: one scene varied by a stated law, many samples in several engines, and how the answers are distributed.
//!
//! Plan: samples by engines as a matrix whose cells keep only where and when the balls stopped. Conclusion, in two ways. Sample
//! by sample: in how many samples an engine has the orders of the reference, which is the first engine with a complete run, and
//! how far the ends lie apart. As distributions: moments, quantiles, and whether an engine's differ from the reference's.

mod agreement;
mod distribution;
mod landing;
mod orders;
mod spread;

pub use agreement::{Agreement, Farthest, agreement};
pub use distribution::{LEVEL, NEGLIGIBLE, Quantity, Test};
pub use landing::{Landing, Order};
pub use orders::Frequent;
pub use spread::{AROUND, SEED_AROUND, Surroundings, surroundings};

use super::Extent;
use super::matrix::{self, Configuration, Watch};
use crate::engine::Refusal;
use crate::math::statistics::Distribution;
use crate::oracle;
use crate::scene::Scene;
use crate::scene::perturb::{Law, PerturbError, Perturbation};
use crate::trace::Record;
use thiserror::Error;

/// Most samples of one ensemble.
pub const MOST_SAMPLES: usize = 10_000_000;

/// Most ends of balls that are kept, over all samples and engines: 40 bytes each, and as much again while they are sorted.
pub const MOST_ENDS: usize = 100_000_000;

/// What to run.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The scene in the middle of the ensemble.
    pub scene: Scene,
    /// How it varies.
    pub law: Law,
    /// Number of samples, 1 to [`MOST_SAMPLES`], and fewer where [`MOST_ENDS`] are reached before.
    pub samples: usize,
    /// Seed of all draws.
    pub seed: u64,
    /// Engines; the first with a complete run is what the others are held against.
    pub columns: Vec<Configuration>,
}

/// Why there is no such ensemble.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum EnsembleError {
    /// The scene cannot vary by the law.
    #[error(transparent)]
    Law(#[from] PerturbError),
    /// The number of samples is out of range.
    #[error(
        "an ensemble of {balls} balls in {engines} engines has 1 to {most} samples, not {samples}"
    )]
    Samples {
        /// What was asked for.
        samples: usize,
        /// Balls of the scene.
        balls: usize,
        /// Engines of the plan.
        engines: usize,
        /// The largest number that is taken.
        most: usize,
    },
    /// There is nothing to run it in.
    #[error("an ensemble needs an engine")]
    NoEngine,
}

/// What one engine made of one sample; `None` if the user asked to stop before it was done.
type Cell = Option<Result<Landing, Refusal>>;

/// Everything that an ensemble found.
#[derive(Clone, Debug)]
pub struct EnsembleOutcome {
    /// What was asked for.
    pub plan: Plan,
    /// The law as applied, one sentence for each thing that varies.
    pub law: Vec<String>,
    /// Number of samples that were run in every engine.
    pub done: usize,
    /// One entry an engine, in the order of the plan.
    pub entries: Vec<EnsembleEntry>,
    /// Index of the entry that all others are held against: the first with a complete run; `None` if there is none.
    pub reference: Option<usize>,
    /// The other engines' distributions against the reference's.
    pub tests: Vec<Test>,
    /// The most frequent collision orders.
    pub frequent: Vec<Frequent>,
    /// How many of them were run once more and put into words; those that were not have none.
    pub spelled: Extent,
}

impl EnsembleOutcome {
    /// What stands before everything else where the user asked to stop before it was done.
    pub fn stopped_early(&self) -> Option<String> {
        let samples = Extent::of(self.done as u64, self.plan.samples as u64);
        samples
            .stopped_early("samples were run in every engine")
            .or_else(|| {
                let what = "orders were put into words, after every sample was run";
                self.spelled.stopped_early(what)
            })
    }
}

/// One engine in an ensemble.
#[derive(Clone, Debug)]
pub struct EnsembleEntry {
    /// Engine and setting.
    pub column: Configuration,
    /// What it made of each sample, by index.
    pub cells: Vec<Cell>,
    /// For each ball in scene order and each [`Quantity`]: its distribution over the complete runs.
    pub distributions: Vec<[Option<Distribution>; 3]>,
    /// Number of distinct collision orders among the complete runs.
    pub orders: usize,
    /// How it agrees with the reference, sample by sample; `None` for that one itself, and without one.
    pub agreement: Option<Agreement>,
}

impl EnsembleEntry {
    /// Engine and setting as one label.
    pub fn label(&self) -> String {
        self.column.label()
    }

    /// The complete runs, with the index of their sample.
    pub fn complete(&self) -> impl Iterator<Item = (usize, &Landing)> {
        let cells = self.cells.iter().enumerate();
        cells.filter_map(|(sample, cell)| match cell {
            Some(Ok(landing)) if landing.complete => Some((sample, landing)),
            _ => None,
        })
    }
}

/// The engines in which an ensemble runs: those of the reference first, otherwise as named.
pub fn plan_columns(named: &[Configuration]) -> Vec<Configuration> {
    let mut columns = named.to_vec();
    columns.sort_by_key(|column| !oracle::is_reference(&*column.engine));
    columns
}

/// Runs an ensemble. Answers the same to the bit for any number of threads.
pub fn study(plan: Plan, watch: Watch<'_>) -> Result<EnsembleOutcome, EnsembleError> {
    if plan.columns.is_empty() {
        return Err(EnsembleError::NoEngine);
    }
    let (balls, engines) = (plan.scene.balls.len(), plan.columns.len());
    let most = MOST_SAMPLES
        .min(MOST_ENDS / (balls * engines).max(1))
        .max(1);
    if !(1..=most).contains(&plan.samples) {
        return Err(EnsembleError::Samples {
            samples: plan.samples,
            balls,
            engines,
            most,
        });
    }
    let perturbation = Perturbation::new(&plan.scene, plan.law)?;
    let seed = plan.seed;
    let sample = |index: usize| perturbation.sample(seed, index as u64);
    let cells = matrix::run_samples(
        plan.samples,
        sample,
        &plan.columns,
        Record::Events,
        watch,
        |trace| trace.map(|trace| Landing::of(&trace)),
    );
    let mut outcome = conclude(plan, perturbation.in_words(), cells);
    orders::spell_out(&mut outcome, sample, watch);
    Ok(outcome)
}

/// Concludes from the cells, which are those of the first sample in every engine, then those of the second, and so on.
fn conclude(plan: Plan, law: Vec<String>, cells: Vec<Cell>) -> EnsembleOutcome {
    let width = plan.columns.len();
    let mut by_engine: Vec<Vec<Cell>> = vec![Vec::with_capacity(plan.samples); width];
    let mut done = 0;
    let mut cells = cells.into_iter();
    for _ in 0..plan.samples {
        let row: Vec<Cell> = cells.by_ref().take(width).collect();
        let whole = row.iter().all(Option::is_some);
        done += usize::from(whole);
        for (column, cell) in by_engine.iter_mut().zip(row) {
            // what not every engine has run is nobody's
            column.push(cell.filter(|_| whole));
        }
    }
    let columns = plan.columns.iter().cloned().zip(by_engine);
    let mut entries: Vec<EnsembleEntry> = columns
        .map(|(column, cells)| EnsembleEntry {
            column,
            cells,
            distributions: Vec::new(),
            orders: 0,
            agreement: None,
        })
        .collect();
    for entry in &mut entries {
        entry.distributions = distribution::of(entry, plan.scene.balls.len());
        entry.orders = orders::distinct(entry);
    }
    let reference = entries.iter().position(|e| e.complete().next().is_some());
    if let Some(index) = reference {
        let radius = plan.scene.smallest_radius();
        let agreements: Vec<Option<Agreement>> = entries
            .iter()
            .enumerate()
            .map(|(i, entry)| (i != index).then(|| agreement(&entries[index], entry, radius)))
            .collect();
        for (entry, agreement) in entries.iter_mut().zip(agreements) {
            entry.agreement = agreement;
        }
    }
    EnsembleOutcome {
        tests: distribution::tests(&entries, reference, &plan.scene),
        frequent: orders::most_frequent(&entries, reference),
        spelled: Extent::default(),
        plan,
        law,
        done,
        entries,
        reference,
    }
}
