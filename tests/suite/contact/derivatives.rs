//! Derivatives through accumulations and contact phases, against differences of runs in 106 bits.

use super::{number, off, runs};
use crate::references::text;
use carom::engine::Limits;
use carom::engine::exact::sensitivity::{Input, Why, growth, influences};
use carom::engine::exact::{certify, final_positions, place_errors, solve};
use carom::math::{DoubleDouble, Real};
use carom::scene::{Scene, parse};
use carom::trace::EventKind;

/// The change of an input on either side. Second order leaves its square, and the f64 numbers of a scene 1e-16 of themselves, 1e-8 of it.
const BY: f64 = 1e-8;

/// Derivatives are those of differences to this part of the largest. Of the run in f64 an approach of 1e-11 m/s and less is taken out, and with it a part of its
/// derivative in a chain of impacts that ends there, 1e-11 of the speeds over 1e-6 of an input that moves little.
const SAME: f64 = 1e-5;

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
    for (case, solution) in runs() {
        let name = case.name;
        let scene = &case.scene;
        let found = influences(scene, &solution.trace, f64::INFINITY, &Limits::NONE);
        assert!(!found.is_empty(), "{name}: nothing");
        for influence in &found {
            let ends = [BY, -BY].map(|by| {
                Some(final_positions::<DoubleDouble>(&changed(
                    scene,
                    influence.input,
                    by,
                )?))
            });
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
                    assert!(
                        error <= SAME * largest,
                        "{name}, {}, ball {ball}: {d:e} instead of {quotient:e}",
                        influence.input.name()
                    );
                    compared += usize::from(d.abs() > 1e-3 * largest);
                }
            }
        }
    }
    assert!(
        compared > 100,
        "only {compared} were large enough to mean anything"
    );
}

#[test]
fn estimated_errors_of_runs_through_contacts_bound_their_distance_to_the_truth() {
    for (case, solution) in runs() {
        let (name, scene, trace) = (case.name, &case.scene, &solution.trace);
        let certainty = certify(scene, trace, f64::EPSILON, &Limits::NONE);
        assert_eq!(certainty.len(), trace.events.len(), "{name}");
        for (event, known) in trace.events.iter().zip(&certainty) {
            let EventKind::Stop(ball) = event.kind else {
                continue;
            };
            let id = scene.balls[ball as usize].id.as_str();
            if trace.stop_times[ball as usize] != Some(event.time) {
                continue;
            }
            let off = (event.time - number(&case.truth["final"][id]["stop"])).abs();
            let error = known.time_error.unwrap_or(f64::NAN);
            assert!(
                off <= error,
                "{name}: {id} stops {off:e} s off, estimated {error:e}"
            );
        }
        let places = place_errors(scene, trace, f64::EPSILON, &Limits::NONE);
        assert_eq!(places.len(), scene.balls.len(), "{name}");
        assert!(places.iter().all(|e| e.is_finite()), "{name}: {places:?}");
        let worst = places.iter().copied().fold(0.0, f64::max);
        let off = off(solution, case);
        assert!(off <= worst, "{name}: {off:e} m off, estimated {worst:e}");
        // and they are estimates of it, not of anything: f64 is demanded to 1e-9 or 1e-8 m
        assert!(worst <= 1e-6, "{name}: {worst:e}");
    }
}

#[test]
fn balls_without_a_derivative_say_so_and_the_others_go_on() {
    // two of three balls begin to roll at one time, and do not when one of them is faster
    let extra =
        "[[balls]]\nid=\"far\"\nposition=[0.0,2.0]\nvelocity=[1.0,0.5]\n[effects.cloth.rotational]";
    let toml =
        text("contact/b8-three-inline.toml").replacen("[effects.cloth.rotational]", extra, 1);
    let scene = parse("b8.toml", &toml).unwrap_or_else(|error| panic!("{error}"));
    let trace = solve::<f64>(&scene, &Limits::NONE).trace;
    let found = growth(&scene, &trace, true, &Limits::NONE);
    let found = found.unwrap_or_else(|| panic!("no growth"));
    assert_eq!(found.factors.len(), trace.events.len());
    let lost: Vec<(usize, Why)> = found
        .lost
        .iter()
        .map(|lost| (lost.ball, lost.why))
        .collect();
    assert_eq!(lost, [0, 1, 2].map(|ball| (ball, Why::Together)));
    let first = found.lost[0].event;
    assert!(matches!(
        trace.events[first].kind,
        EventKind::SlideToRoll(_)
    ));
    assert_eq!(found.rough, Some(first));
    // alone, the fourth grows as it does in a scene of its own
    let alone = toml
        .find("[[balls]]")
        .zip(toml.find("[[balls]]\nid=\"far\""));
    let alone = alone.map(|(first, last)| toml[..first].to_owned() + &toml[last..]);
    let alone = alone.unwrap_or_else(|| panic!("no balls in the scene"));
    let alone = parse("far.toml", &alone).unwrap_or_else(|error| panic!("{error}"));
    let alone = Scene {
        duration: trace.end_time,
        ..alone
    };
    let own = solve::<f64>(&alone, &Limits::NONE).trace;
    let own = growth(&alone, &own, false, &Limits::NONE).map(|growth| growth.last());
    let (got, want) = (found.last(), own.unwrap_or(f64::NAN));
    // in the same units
    assert_eq!(scene.largest_speed(), alone.largest_speed());
    assert!(got > 0.0 && (got / want - 1.0).abs() < 1e-9, "{got} {want}");
    // what a person sets moves the whole scene along
    let moved = influences(&scene, &trace, f64::INFINITY, &Limits::NONE);
    assert!(
        moved
            .iter()
            .all(|influence| influence.derivative[3].iter().all(|d| d.is_finite()))
    );
}

#[test]
fn a_ball_that_rolls_to_six_digits_rolls_in_the_run_with_derivatives_too() {
    let extra = "[[balls]]\nid=\"far\"\nposition=[0.0,2.0]\nvelocity=[1.0,0.0]\nspin=[0.0,34.9956,0.0]\n[effects.cloth.rotational]";
    let toml = text("contact/a3-three-e1.toml").replacen("[effects.cloth.rotational]", extra, 1);
    let scene = parse("a3.toml", &toml).unwrap_or_else(|error| panic!("{error}"));
    let trace = solve::<f64>(&scene, &Limits::NONE).trace;
    let slides = |kind| kind == EventKind::SlideToRoll(3);
    assert!(!trace.events.iter().any(|e| slides(e.kind)), "it slides");
    let moved = influences(&scene, &trace, f64::INFINITY, &Limits::NONE);
    assert!(!moved.is_empty(), "no derivatives");
    let found = growth(&scene, &trace, false, &Limits::NONE);
    assert!(found.is_some_and(|found| !found.differs && found.last() > 1.0));
}
