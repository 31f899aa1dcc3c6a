//! When a ball counts as stopped, and when its slip and spin count as none, for engines whose numbers never become zero by themselves.

use crate::scene::{Ball, Scene};

/// Speed at or below which a ball counts as stopped, length/s: `1e-6 sqrt(g R)`, and 0 where nothing slows a ball.
pub fn rest_speed(scene: &Scene) -> f64 {
    match scene.effects.cloth {
        Some(_) => 1e-6 * (scene.gravity * scene.smallest_radius()).sqrt(),
        None => 0.0,
    }
}

/// Slip speeds and spins that a solver cannot tell from zero are below this many ulp of the largest speed of the scene: it holds the
/// velocity of the contact point to a handful of roundings in every substep.
const ROLLING_ULPS: f64 = 64.0;

/// Slip speed, and surface speed by spin about the vertical, at or below which there is none, length/s: the speed below which a
/// ball counts as stopped, or what rounding leaves where that is more. `ulp`: spacing of the engine's numbers just above 1.
pub fn slip_rest(scene: &Scene, ulp: f64) -> f64 {
    rest_speed(scene).max(ROLLING_ULPS * ulp * top_speed(scene))
}

/// An upper bound of the speeds that a scene starts with, length/s: of centres, and of surfaces where balls rotate.
pub(super) fn top_speed(scene: &Scene) -> f64 {
    let rotates = scene.effects.rotates();
    let surface = |ball: &Ball| {
        let turning = if rotates {
            ball.radius * ball.state.spin.norm()
        } else {
            0.0
        };
        ball.state.speed() + turning
    };
    scene.balls.iter().map(surface).fold(0.0, f64::max)
}
