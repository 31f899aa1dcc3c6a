//! A scene whose touching balls are an ensemble, in a comparison: the exact answers over random gaps.

use super::{EnsembleError, EnsembleOutcome, Plan, study};
use crate::oracle;
use crate::scene::Simultaneous;
use crate::scene::perturb::Law;
use crate::study::Extent;
use crate::study::compare;
use crate::study::matrix::{self, Watch};

/// Samples of the exact engine behind a comparison.
pub const AROUND: usize = 200;
/// Their seed.
pub const SEED_AROUND: u64 = 1;
/// The ensemble around a scene, or why there is none.
pub type Surroundings = Result<EnsembleOutcome, EnsembleError>;

/// Runs the ensemble around a scene that asks for one, and says whether that was done; `None` for any other scene.
pub fn surroundings(
    compared: &compare::ComparisonOutcome,
    watch: Watch<'_>,
) -> (Option<Surroundings>, Extent) {
    let scene = &compared.scene;
    if scene.simultaneous != Simultaneous::Ensemble {
        return (None, Extent::default());
    }
    let plan = Plan {
        scene: scene.clone(),
        law: Law::default_for(scene),
        samples: AROUND,
        seed: SEED_AROUND,
        columns: vec![matrix::Configuration::of(oracle::engine())],
    };
    let found = watch.whole(|| study(plan, watch));
    let extent = Extent::of(u64::from(found.is_some()), 1);
    (found, extent)
}
