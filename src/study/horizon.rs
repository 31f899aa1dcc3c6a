//! How far one scene can be predicted: its horizon, the growth of perturbations, and which input matters most.
//!
//! Plan: the exact engine in one precision and in the next finer one. Conclusion: up to which event both can be right, and what moves
//! the balls before.

use crate::engine::{Limits, Refusal, can_run};
use crate::oracle::{self, Horizon, Influence, Precision, horizon, influences};
use crate::scene::Scene;
use std::sync::atomic::AtomicBool;

/// How far a scene can be predicted.
#[derive(Debug)]
pub struct HorizonOutcome {
    /// The scene.
    pub scene: Scene,
    /// What was found; `None` where the user asked to stop before.
    pub found: Option<Predicted>,
}

/// What was found of a scene.
#[derive(Debug)]
pub struct Predicted {
    /// Up to where the run and its witness agree.
    pub horizon: Horizon,
    /// What each input does to the final positions.
    pub influences: Vec<Influence>,
    /// How far each ball may be off in the end, length.
    pub errors: Vec<f64>,
}

/// Runs the scene in `precision` and in its witness and says how far they can be believed.
///
/// Errors: the scene calls for what the exact engine cannot simulate, or has too many balls.
pub fn study(
    scene: &Scene,
    precision: Precision,
    cancelled: &AtomicBool,
) -> Result<HorizonOutcome, Refusal> {
    can_run(oracle::engine().as_ref(), scene)?;
    let limits = Limits {
        cancelled,
        ..Limits::NONE
    };
    let refused = || Refusal::Setting {
        key: None,
        message: format!(
            "a horizon needs a precision with a finer one to be held against, and a scene of at most {} balls; this one has {}",
            oracle::MOST_BALLS,
            scene.balls.len()
        ),
    };
    let found: Option<Result<_, Refusal>> = limits.whole(|| {
        let horizon = horizon(scene, precision, true, &limits).ok_or_else(refused)?;
        let ulp = horizon.precision.ulp();
        let errors = oracle::place_errors(scene, &horizon.trace, ulp, &limits);
        let influences = influences(scene, &horizon.trace, horizon.until, &limits);
        Ok(Predicted {
            horizon,
            influences,
            errors,
        })
    });
    Ok(HorizonOutcome {
        scene: scene.clone(),
        found: found.transpose()?,
    })
}
