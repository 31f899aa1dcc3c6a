//! What the clock of a run can tell, by the same rule for every engine: how long a scene may last.

use super::Refusal;
use crate::physics::Cloth;
use crate::scene::Scene;

/// Largest part of the smallest radius by which the clock may leave the place of a ball unsure. Below, an engine can still say of each
/// event how sure it is; not much above, gaps are taken for contacts.
const COARSEST: f64 = 0.1;

/// Roundings of the clock and of the way since then that a place has seen.
const ROUNDINGS: f64 = 8.0;

/// Refuses a scene that lasts for so long that its clock, which is f64 in every engine, no longer says where the fastest ball is.
///
/// An engine that goes on nevertheless is wrong without words: one that solves for its events takes what is half a table away for
/// touching, and one that steps adds to its clock what is less than its last digit.
pub(super) fn check(scene: &Scene) -> Result<(), Refusal> {
    let fastest = scene.fastest();
    let most = COARSEST * scene.smallest_radius() / (ROUNDINGS * f64::EPSILON * fastest);
    // friction ends all motion before that, whatever the duration
    let moving = match scene.effects.cloth {
        Some(Cloth::Translational { mu }) if mu * scene.gravity > 0.0 => {
            scene.duration.min(fastest / (mu * scene.gravity))
        }
        _ => scene.duration,
    };
    if moving <= most || fastest == 0.0 {
        return Ok(());
    }
    Err(Refusal::TooLong {
        duration: scene.duration,
        most,
    })
}
