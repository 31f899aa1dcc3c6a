//! The hard scenes: what the exact engine and the report's model with its missing check must hold in all of them, and what
//! each scene's answer is.

mod answers;
mod contacts;
mod motions;
mod symmetry;

use crate::support::run;
use carom::compare::deepest_overlap;
use carom::math::Vec3;
use carom::physics::State;
use carom::scene::{Scene, SetName, catalogue};
use carom::study::Configuration;
use carom::trace::{Ending, Record, Trace};
use std::collections::BTreeSet;

/// The two models of our own that must hold everywhere.
const OURS: [(&str, &[&str]); 2] = [
    ("exact", &[]),
    ("stepper", &["contact=approaching-only", "dt=1e-3"]),
];

/// Steps at which the stepper must hold as well, from those that pass through a ball in one to those that take many a contact.
const STEPS: [&str; 4] = ["dt=0.1", "dt=0.0166", "dt=0.01", "dt=1e-4"];

/// Scenes in which the exact engine stops because there is no answer, with the ending that says why.
const WITHOUT_END: [(&str, &str); 12] = [
    ("report-break-central", "indeterminate"),
    ("report-break-frozen", "indeterminate"),
    ("report-break-frozen-ensemble", "indeterminate"),
    ("triple-hit", "indeterminate"),
    ("triple-hit-ensemble", "indeterminate"),
    ("rack-frozen-central", "indeterminate"),
    ("rack-frozen-oblique", "indeterminate"),
    ("cradle-nearly-elastic", "indeterminate"),
    ("collapse-chain", "indeterminate"),
    ("two-at-once-lossy", "indeterminate"),
    ("thin-cut-1e-15", "undecidable"),
    ("near-miss-1e-15", "undecidable"),
];

fn hard() -> Vec<Scene> {
    catalogue::set(SetName::Hard).unwrap()
}

fn scene(name: &str) -> Scene {
    catalogue::scene(name).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn more_than_forty_hard_scenes_run_without_being_asked_for_in_full() {
    let everyday = catalogue::all().iter().filter(|entry| {
        let mut lines = entry
            .text
            .lines()
            .filter(|line| line.starts_with("sets = [") && line.ends_with(']'));
        lines.any(|sets| sets.contains("\"hard\"") && !sets.contains("\"full\""))
    });
    let count = everyday.count();
    assert!(count >= 42, "{count} scenes");
    let gated = hard().iter().filter(|s| s.is_in(SetName::Gate)).count();
    assert!((1..=10).contains(&gated), "{gated} hard scenes are gated");
}

#[test]
fn what_a_scene_wants_tried_is_an_engine_and_settings_that_it_knows() {
    let mut tried = 0;
    for scene in hard() {
        for asked in &scene.try_settings {
            let column = Configuration::tried(crate::support::roster(), asked)
                .unwrap_or_else(|unknown| panic!("{}: {unknown}", scene.name));
            if let Err(refusal) = column.engine.prepare(&scene, &column.setting) {
                panic!("{}: {asked}: {refusal}", scene.name);
            }
            tried += 1;
        }
    }
    assert!(tried >= 20, "{tried} settings");
}

#[test]
fn both_models_stay_finite_inside_and_below_their_energy_in_every_hard_scene() {
    let mut broken = Vec::new();
    let mut runs = 0;
    for scene in hard() {
        let steps = STEPS.iter().map(|dt| vec!["contact=approaching-only", *dt]);
        let steps = steps.map(|settings| ("stepper", settings));
        let ours = OURS.map(|(engine, settings)| (engine, settings.to_vec()));
        for (engine, settings) in ours.into_iter().chain(steps) {
            let trace = run(engine, &settings, &scene, Record::Events);
            for why in laws_broken(&scene, &trace) {
                broken.push(format!("{engine} {settings:?} in {}: {why}", scene.name));
            }
            runs += 1;
        }
    }
    assert!(runs >= 6 * 42, "{runs} runs");
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

/// What a trace breaks of: a typed ending, finite states, bounds, energy, momentum, overlap.
fn laws_broken(scene: &Scene, trace: &Trace) -> Vec<String> {
    let mut broken = Vec::new();
    let mut hold = |law: &str, got: f64, bound: f64| {
        // false for NaN as well
        let holds = got <= bound;
        if !holds {
            broken.push(format!("{law}: {got:e}, bound {bound:e}"));
        }
    };
    let dt = trace.provenance.resolution;
    let fastest = scene.fastest();
    let energy = scene.initial_energy();
    let impacts = trace.events.len() as f64 + 1.0;
    let ends = match trace.ending {
        Ending::Rest | Ending::Duration => true,
        Ending::Indeterminate(_) | Ending::Undecidable(_) | Ending::Collapsed(_) => dt == 0.0,
        Ending::Cancelled | Ending::Budget(_) | Ending::NotFinite(_) => false,
    };
    hold(trace.ending.id(), f64::from(u8::from(!ends)), 0.0);
    let knots = trace.paths.iter().flat_map(|path| &path.knots);
    let numbers = |s: &State| [s.position, s.velocity, s.spin].map(|v| v.iter().sum::<f64>());
    let strange = knots.filter(|knot| numbers(&knot.state).iter().any(|x| !x.is_finite()));
    hold("states that are no numbers", strange.count() as f64, 0.0);
    // walls are tested before balls move; see design: bounds follow from each scheme
    hold(
        "outside",
        trace.extrema.outside.value,
        scene.position_uncertainty() + fastest * dt,
    );
    // two products and a sum for each of two balls in each impact, each of which may round up
    hold(
        "energy gained",
        trace.extrema.energy_gained.value,
        16.0 * f64::EPSILON * energy * impacts,
    );
    let states = trace.final_states();
    if states.iter().all(Option::is_some) {
        let states: Vec<State> = states.into_iter().flatten().collect();
        let last = scene.kinetic_energy(&states);
        hold(
            "energy at the end",
            last,
            energy * (1.0 + 16.0 * f64::EPSILON * impacts),
        );
        if scene.effects.cloth.is_none() && scene.effects.cushion.is_none() {
            let sum = |of: &dyn Fn(usize) -> Vec3| {
                let momenta = (0..states.len()).map(|i| of(i) * scene.balls[i].mass);
                momenta.fold(Vec3::zeros(), |sum, p| sum + p)
            };
            let moved = sum(&|i| states[i].velocity) - sum(&|i| scene.balls[i].state.velocity);
            let heaviest = scene.balls.iter().map(|b| b.mass).fold(0.0, f64::max);
            // no ball has more momentum than the heaviest with all the energy; a few roundings in each impact
            let largest = (2.0 * energy * heaviest).sqrt();
            hold(
                "momentum of the whole",
                moved.norm(),
                16.0 * f64::EPSILON * largest * impacts,
            );
        }
    }
    if dt == 0.0 {
        hold(
            "overlap by parry",
            deepest_overlap(scene, trace),
            2.0 * scene.position_uncertainty(),
        );
    } else if scene.balls.len() == 2 {
        // a pair alone: found one step after contact at the latest, then it separates
        hold(
            "overlap",
            trace.extrema.overlap.value,
            scene.position_uncertainty() + 2.0 * fastest * dt,
        );
    }
    broken
}

#[test]
fn the_exact_engine_says_where_there_is_no_answer_and_reaches_the_end_of_every_other_scene() {
    let mut seen = BTreeSet::new();
    for scene in hard() {
        let trace = run("exact", &[], &scene, Record::Events);
        let expected = WITHOUT_END.iter().find(|(name, _)| *name == scene.name);
        match expected {
            None => assert!(
                trace.ending.is_complete(),
                "{}: {:?}",
                scene.name,
                trace.ending
            ),
            Some((name, ending)) => {
                assert_eq!(trace.ending.id(), *ending, "{name}: {:?}", trace.ending);
                seen.insert(*name);
            }
        }
    }
    assert_eq!(seen.len(), WITHOUT_END.len(), "{seen:?}");
}

#[test]
fn every_hard_scene_has_an_answer_that_is_checked_or_a_reason_why_there_is_none() {
    let answered = answers::scenes();
    for scene in hard() {
        let without = WITHOUT_END.iter().any(|(name, _)| *name == scene.name);
        let elsewhere = symmetry::ANSWERED_ELSEWHERE.contains(&scene.name.as_str())
            || crate::contact::catalogue::is_answered(&scene.name);
        let ways = [answered.contains(scene.name.as_str()), without, elsewhere];
        assert!(ways.contains(&true), "{} is held to nothing", scene.name);
    }
}
