//! What is demanded of rapier's scene, for both precisions: laws against closed forms, traces against themselves, settings,
//! and the traps that the presets are there to avoid.

mod contract;
mod demands;
mod discs;
mod effects;
mod impacts;
mod settings;
mod traces;
mod traps;

use crate::support::{R, Scenario, scenario};
use carom::math::Vec3;
use carom::scene::Scene;
use carom::trace::Trace;

/// Both engines with a relative tolerance for what should hold to rounding: f64 and f32 of the demand table.
const BOTH: [(&str, f64); 2] = [("rapier-f64", 1e-12), ("rapier-f32", 1e-6)];

/// Velocity of ball `i` at the end of a trace.
fn final_velocity(trace: &Trace, i: usize) -> Vec3 {
    trace.final_states()[i].unwrap().velocity
}

/// Total momentum at the end of a trace.
fn final_momentum(scene: &Scene, trace: &Trace) -> Vec3 {
    let states = trace.final_states();
    let balls = scene.balls.iter().zip(&states);
    balls.fold(Vec3::zeros(), |sum, (ball, state)| {
        sum + state.unwrap().velocity * ball.mass
    })
}

/// Kinetic energy at the end of a trace.
fn final_energy(scene: &Scene, trace: &Trace) -> f64 {
    let states: Vec<_> = trace
        .final_states()
        .into_iter()
        .map(Option::unwrap)
        .collect();
    scene.kinetic_energy(&states)
}

/// A cue ball that meets a ball at rest at the origin. `cut_deg`: angle between the path and the line of centres at contact.
/// `lead`: distance of the cue ball before contact. No cloth, no cushions.
fn cut_shot(cut_deg: f64, speed: f64, lead: f64) -> Scenario {
    let (c, s) = (cut_deg.to_radians().cos(), cut_deg.to_radians().sin());
    scenario("cut")
        .moving("cue", [-2.0 * R * c - lead, -2.0 * R * s], [speed, 0.0])
        .resting("1", [0.0, 0.0])
        .duration((lead + 1.0) / speed)
}

/// Balls in a triangle with its apex at `apex`, added to a scene.
fn rack(mut scenario: Scenario, apex: [f64; 2], rows: usize, gap: f64) -> Scenario {
    let pitch = 2.0 * R + gap;
    let mut number = 0;
    for row in 0..rows {
        for column in 0..=row {
            number += 1;
            let x = apex[0] + (column as f64 - 0.5 * row as f64) * pitch;
            let y = apex[1] + row as f64 * pitch * 0.75_f64.sqrt();
            scenario = scenario.resting(&number.to_string(), [x, y]);
        }
    }
    scenario
}
