//! Shots with every effect at once: more digits, energy, symmetry, derivatives.

use super::{CLOTH, POOL, exact, scene};
use crate::support::run;
use carom::engine::Limits;
use carom::engine::exact::sensitivity::{Influence, Input, growth, influences};
use carom::engine::exact::solve;
use carom::math::{DoubleDouble, Octuple, Real, Vec3};
use carom::scene::Scene;
use carom::trace::{Ending, EventKind, Record, Trace};

/// A full shot with every effect: a cue ball with side and follow into three balls, cushions of Han and pockets.
fn everything(cushion: &str, friction: &str) -> Scene {
    let effects = format!(
        "{CLOTH}[effects.contact.inelastic]\ne = 0.93\n{friction}\n{cushion}\n\
         [effects.pockets]\ncircles = [[0.0, 0.0, 0.075], [1.27, 0.0, 0.075], [0.0, 2.54, 0.075], [1.27, 2.54, 0.075]]\n"
    );
    let balls = [
        ("cue", [0.635, 0.6], [0.3, 4.0], [-60.0, 10.0, 45.0]),
        ("1", [0.66, 1.4], [0.0, 0.0], [0.0; 3]),
        ("2", [0.62, 1.47], [0.0, 0.0], [0.0; 3]),
        ("3", [0.70, 1.475], [0.0, 0.0], [0.0; 3]),
    ];
    scene(POOL, &balls, &effects)
}

const HAN: &str = "[effects.cushion.han-2005]\ne = 0.85\nmu = 0.2\nheight = 1.28";
const CONSTANT: &str = "[effects.friction.constant]\nmu = 0.06";
const ALCIATORE: &str = "[effects.friction.alciatore]\na = 0.009951\nb = 0.108\nc = 1.088";

#[test]
fn more_digits_agree_on_a_shot_with_every_effect() {
    for friction in [CONSTANT, ALCIATORE] {
        let scene = everything(HAN, friction);
        let coarse = solve::<f64>(&scene, &Limits::NONE);
        let wide = solve::<DoubleDouble>(&scene, &Limits::NONE);
        let widest = solve::<Octuple>(&scene, &Limits::NONE);
        let kinds =
            |trace: &Trace| -> Vec<EventKind> { trace.events.iter().map(|e| e.kind).collect() };
        assert!(
            kinds(&coarse.trace).len() > 15,
            "{:?}",
            kinds(&coarse.trace)
        );
        assert_eq!(kinds(&coarse.trace), kinds(&wide.trace));
        assert_eq!(kinds(&wide.trace), kinds(&widest.trace));
        for (ball, state) in coarse.trace.final_states().iter().enumerate() {
            if state.is_none() {
                continue;
            }
            for axis in 0..2 {
                let fine = widest.positions[ball][axis];
                let rough = (wide.positions[ball][axis].widen::<Octuple>() - fine)
                    .to_f64()
                    .abs();
                let plain = (coarse.positions[ball][axis] - fine.to_f64()).abs();
                // rounding of 106 and of 53 bits, grown a million times at most
                assert!(
                    rough < 1e-24 && plain < 1e-9,
                    "ball {ball}: {rough:e} {plain:e}"
                );
            }
        }
    }
}

#[test]
fn what_impacts_and_cloth_do_explains_the_whole_trace_and_energy_never_grows() {
    for (cushion, friction) in [
        (HAN, CONSTANT),
        (HAN, ALCIATORE),
        ("[effects.cushion.restitution]\ne = 0.8", CONSTANT),
        (
            "[effects.cushion.mathavan-2010]\ne = 0.98\nmu = 0.14\nmu_cloth = 0.212\nheight = 1.4",
            CONSTANT,
        ),
    ] {
        let scene = everything(cushion, friction);
        let trace = exact(&scene);
        assert_eq!(trace.ending, Ending::Rest, "{cushion}");
        assert!(
            trace.unexplained() < 1e-13,
            "{cushion}: {:e}",
            trace.unexplained()
        );
        let start = scene.initial_energy();
        assert!(
            trace.extrema.energy_gained.value <= 1e-15 * start,
            "{:?}",
            trace.extrema.energy_gained
        );
        // the sum over all balls at the knots of all, far side after near side
        let mut times: Vec<f64> = trace
            .paths
            .iter()
            .flat_map(|p| p.knots.iter().map(|k| k.time))
            .collect();
        times.sort_by(f64::total_cmp);
        let mut least = start;
        for t in times {
            let states: Vec<_> = trace
                .paths
                .iter()
                .map(|path| path.state_at(t).unwrap())
                .collect();
            let energy = scene.kinetic_energy(&states);
            assert!(
                energy <= least + 1e-13 * start,
                "{cushion} at {t}: {energy} after {least}"
            );
            least = least.min(energy);
        }
    }
}

#[test]
fn a_mirrored_shot_is_the_mirrored_trace_with_spin_turned_the_other_way() {
    let scene = everything(HAN, CONSTANT);
    let mut mirrored = scene.clone();
    for ball in &mut mirrored.balls {
        ball.state.position.x = 1.27 - ball.state.position.x;
        ball.state.velocity.x = -ball.state.velocity.x;
        // an axial vector: the part along the mirror's normal stays
        ball.state.spin.y = -ball.state.spin.y;
        ball.state.spin.z = -ball.state.spin.z;
    }
    let (a, b) = (exact(&scene), exact(&mirrored));
    assert_eq!(a.events.len(), b.events.len());
    for (p, q) in a.events.iter().zip(&b.events) {
        // rounding of 1.27 - x, grown as the horizon of this shot shows
        assert!((p.time - q.time).abs() < 1e-9, "{p:?} {q:?}");
    }
    for (p, q) in a.paths.iter().zip(&b.paths) {
        let (p, q) = (p.last().unwrap(), q.last().unwrap());
        let off = (p.position.x + q.position.x - 1.27).hypot(p.position.y - q.position.y);
        assert!(off < 1e-9, "{off:e}");
    }
}

#[test]
fn derivatives_with_rotation_are_those_of_perturbed_pairs() {
    let scene = everything(HAN, CONSTANT);
    let trace = exact(&scene);
    let found = influences(&scene, &trace, f64::INFINITY, &Limits::NONE);
    let before = solve::<DoubleDouble>(&scene, &Limits::NONE);
    let by = 1e-10;
    let mut compared = 0;
    for influence in &found {
        let Influence {
            input, derivative, ..
        } = influence;
        let mut changed = scene.clone();
        match input {
            Input::Speed => {
                changed.balls[0].state.velocity *= 1.0 + by;
                changed.balls[0].state.spin *= 1.0 + by;
            }
            Input::Aim => {
                let turned = |v: Vec3| Vec3::new(v.x - by * v.y, v.y + by * v.x, v.z);
                changed.balls[0].state.velocity = turned(scene.balls[0].state.velocity);
                changed.balls[0].state.spin = turned(scene.balls[0].state.spin);
            }
            Input::Effect(wanted) => {
                changed.effects = scene.effects.map(|key, value| {
                    if key == *wanted {
                        value * (1.0 + by)
                    } else {
                        value
                    }
                });
            }
            Input::BallRestitution | Input::CushionRestitution => {
                panic!("laws with losses have numbers")
            }
        }
        let after = solve::<DoubleDouble>(&changed, &Limits::NONE);
        let largest = derivative
            .iter()
            .flatten()
            .fold(0.0_f64, |most, d| most.max(d.abs()));
        for (ball, d) in derivative.iter().enumerate() {
            if trace.pocketed(ball) {
                continue;
            }
            for (axis, d) in d.iter().enumerate() {
                let quotient =
                    (after.positions[ball][axis] - before.positions[ball][axis]).to_f64() / by;
                let error = (quotient - d).abs();
                assert!(
                    error <= 0.01 * d.abs() + 1e-4 * largest,
                    "{}, ball {ball}: {d} instead of {quotient}",
                    input.name()
                );
                compared += usize::from(d.abs() > 1e-3 * largest && largest > 0.0);
            }
        }
    }
    assert!(
        found.len() >= 10 && compared > 30,
        "{} inputs, {compared} derivatives",
        found.len()
    );
    let grown = growth(&scene, &trace, true, &Limits::NONE).unwrap();
    assert_eq!(
        (grown.rough, grown.factors.len()),
        (None, trace.events.len())
    );
}

#[test]
fn what_a_law_integrates_is_an_error_of_the_events_after_it() {
    let law =
        "[effects.cushion.mathavan-2010]\ne = 0.98\nmu = 0.14\nmu_cloth = 0.212\nheight = 1.4";
    let errors = |cushion: &str| {
        let trace = run(
            "exact",
            &["precision=dd"],
            &everything(cushion, CONSTANT),
            Record::Every(0.1),
        );
        let cushions = trace
            .events
            .iter()
            .position(|e| matches!(e.kind, EventKind::BallCushion(..)));
        let first = cushions.unwrap();
        let error = |index: usize| trace.certainty[index].time_error.unwrap();
        (error(first), error(trace.events.len() - 1))
    };
    let (before, after) = errors(law);
    let (_, closed) = errors(HAN);
    // a law in closed form rounds to 106 bits; an integrated one is no better than it says
    assert!(before < 1e-25 && closed < 1e-20, "{before:e} {closed:e}");
    assert!(after > 1e-16, "{after:e}");
}

#[test]
fn a_shot_with_every_effect_runs_under_the_convention() {
    for cushion in [HAN, "[effects.cushion.restitution]\ne = 0.85"] {
        let mut scene = everything(cushion, CONSTANT);
        scene.simultaneous = carom::scene::Simultaneous::GeneralizedReflections;
        let engine = crate::support::find("exact").unwrap();
        assert_eq!(engine.missing(&scene), Vec::<&str>::new());
        let trace = crate::support::run("exact", &[], &scene, carom::trace::Record::Events);
        assert!(trace.ending.is_complete(), "{:?}", trace.ending);
    }
}
