//! Derivatives through accumulations and contact phases, against differences of runs in 106 bits.

use super::run_of;
use carom::engine::Limits;
use carom::engine::exact::final_positions;
use carom::engine::exact::sensitivity::{Input, influences};
use carom::math::{DoubleDouble, Real};
use carom::scene::Scene;

/// The change of an input on either side. Second order leaves its square, and the f64 numbers of a scene 1e-16 of themselves, 1e-8 of it.
const BY: f64 = 1e-8;

/// A scene with another aim or speed of its cue ball, or another number of an effect; `None` for what a scene has no number for.
fn changed(scene: &Scene, input: Input, by: f64) -> Option<Scene> {
    let mut scene = scene.clone();
    let cue = scene.cue_ball();
    let state = &mut scene.balls[cue].state;
    let (v, w) = (state.velocity, state.spin);
    match input {
        Input::Aim => {
            (state.velocity.x, state.velocity.y) = (v.x - by * v.y, v.y + by * v.x);
            (state.spin.x, state.spin.y) = (w.x - by * w.y, w.y + by * w.x);
        }
        Input::Speed => {
            state.velocity *= 1.0 + by;
            state.spin *= 1.0 + by;
        }
        Input::Effect(key) => {
            let change = |of, value| if of == key { value * (1.0 + by) } else { value };
            scene.effects = scene.effects.map(change);
        }
        Input::BallRestitution | Input::CushionRestitution => return None,
    }
    Some(scene)
}

#[test]
fn derivatives_of_final_positions_go_through_contacts() {
    let mut compared = 0;
    for name in [
        "a3-three-e1",
        "a4-four-e08-friction",
        "b1-plastic-inline",
        "b2-soft-follow-friction",
        "b3-offline-release",
        "b4-cushion",
        "b7-b35",
        "b8-three-inline",
    ] {
        let (case, solution) = run_of(name);
        let scene = &case.scene;
        let found = influences(scene, &solution.trace, f64::INFINITY, &Limits::NONE);
        assert!(!found.is_empty(), "{name}: nothing");
        for influence in &found {
            let ends = [BY, -BY].map(|by| Some(final_positions::<DoubleDouble>(&changed(scene, influence.input, by)?)));
            let [Some(after), Some(before)] = ends else {
                continue;
            };
            let largest = influence.derivative.iter().flatten();
            let largest = largest.fold(0.0_f64, |most, d| most.max(d.abs()));
            for (ball, d) in influence.derivative.iter().enumerate() {
                for (axis, d) in d.iter().enumerate() {
                    let moved = (after[ball][axis] - before[ball][axis]).to_f64();
                    let quotient = moved / (2.0 * BY);
                    let error = (quotient - d).abs();
                    println!("{name} {} ball {ball} axis {axis}: {d:e} fd {quotient:e} err {:e}", influence.input.name(), error / largest);
                    compared += usize::from(d.abs() > 1e-3 * largest);
                }
            }
        }

    }
    println!("{compared}");
}
