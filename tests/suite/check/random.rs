//! Random scenes in the gate: they are held, they cannot be left out, and what they break is nobody's to accept.

use super::{baselines, check, said};
use carom::engine::Setting;
use carom::gate::{self, Decision, Held, Refused};
use carom::law::Fault;
use carom::study::check::{self as gate_study, Level, RANDOM, State, random_hash, random_plan};
use carom::study::random::{self, Failure};
use carom::study::{Configuration, Watch};
use std::fs;
use std::sync::atomic::AtomicBool;

/// A few scenes, added to a check of nothing else.
fn few(scenes: u64, cancelled: bool) -> (gate_study::CheckOutcome, random::RandomOutcome) {
    let stop = AtomicBool::new(cancelled);
    let watch = Watch {
        progress: &|_, _, _| {},
        cancelled: &stop,
    };
    let columns = [Configuration::of(crate::support::find("exact").unwrap())];
    let found = random::study(random_plan(&columns, scenes), watch);
    let outcome = gate_study::study(crate::support::roster(), &[], &columns, watch).unwrap();
    (outcome, found)
}

/// How a check stands to what was accepted of its random scenes; `None`: nothing was.
fn decision(outcome: gate_study::CheckOutcome, accepted: Option<gate::Accepted>) -> Decision {
    let held = Held::new(outcome, vec![accepted], Vec::new());
    held.standing().decision()
}

#[test]
fn what_random_scenes_show_is_held_to_the_last_count_and_cannot_be_left_out() {
    let (mut outcome, found) = few(64, false);
    outcome.add_random(&found);
    assert_eq!(outcome.names(), [RANDOM]);
    let rows: Vec<gate::Row> = outcome.of_scene(RANDOM).map(gate::Row::from).collect();
    let value = |subject: &str| {
        let row = rows.iter().find(|row| row.subject == subject);
        row.and_then(|row| row.value).unwrap_or(0.0)
    };
    assert!(value("impacts held") > 100.0 && value("motions held") > 500.0);
    let ended = rows
        .iter()
        .filter(|row| row.subject.starts_with("ended as "));
    let ended: f64 = ended.filter_map(|row| row.value).sum();
    assert_eq!(ended, 64.0);
    let accepted = gate::Accepted {
        scene: RANDOM.to_owned(),
        hash: random_hash(&found.plan),
        reason: "for a test".to_owned(),
        rows: rows.clone(),
        ..gate::Accepted::default()
    };
    let met = decision(outcome.clone(), Some(accepted.clone()));
    assert_eq!(met, Decision::Met);
    for (index, row) in rows.iter().enumerate() {
        let mut other = accepted.clone();
        other.rows[index].value = other.rows[index].value.map(|count| count + 1.0);
        let decided = decision(outcome.clone(), Some(other));
        assert_eq!(decided, Decision::NotMet, "{row:?}");
    }
    let mut stale = accepted;
    stale.hash = random_hash(&random::Plan {
        scenes: 65,
        ..found.plan
    });
    let decided = decision(outcome.clone(), Some(stale));
    assert_eq!(decided, Decision::NotMet);
    assert_eq!(decision(outcome, None), Decision::Incomplete);
}

#[test]
fn random_scenes_that_did_not_run_are_missing() {
    let (mut outcome, found) = few(64, true);
    outcome.add_random(&found);
    let cases: Vec<_> = outcome
        .cases
        .iter()
        .filter(|case| case.scene == RANDOM)
        .collect();
    assert_eq!(cases.len(), 1);
    assert_eq!(cases[0].state, State::Missing);
    assert_eq!(decision(outcome, None), Decision::Incomplete);
}

#[test]
fn a_fault_in_a_random_scene_is_a_broken_promise_that_names_what_shows_it() {
    let (mut outcome, mut found) = few(8, false);
    for (scene, what) in [(3, "hit-friction"), (5, "hit-friction"), (5, "overlap")] {
        found.failures.push(Failure {
            scene,
            engine: "exact".to_owned(),
            fault: Fault::new(what, "who and when".to_owned()),
        });
    }
    outcome.add_random(&found);
    let broken: Vec<_> = outcome
        .broken
        .iter()
        .map(|b| (b.level, b.what, b.engine.as_str()))
        .collect();
    assert_eq!(
        broken,
        [
            (Level::Fuzz, "hit-friction", "exact"),
            (Level::Fuzz, "overlap", "exact")
        ]
    );
    let why = &outcome.broken[0].why;
    assert!(why.contains("who and when (2 of this kind)"), "{why}");
    let shows = "carom fuzz --seed 13 --first 3 --scenes 1 --max-events 200 --engines exact";
    assert!(why.contains(shows), "{why}");
    assert!(why.contains("--show 3"), "{why}");
    let held = Held::new(outcome, vec![None], Vec::new());
    assert_eq!(held.standing().acceptance(), Err(Refused::BrokenPromise(2)));
}

#[test]
fn the_random_scenes_of_the_gate_are_asked_for_by_name_and_appear_wherever_a_scene_does() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("random-scenes.csv");
    let good = fs::read_to_string(baselines().join("random-scenes.csv")).unwrap();
    let line = good
        .lines()
        .find(|line| line.starts_with("exact,fuzz,impacts held,"));
    fs::write(
        &file,
        good.replacen(line.unwrap(), "exact,fuzz,impacts held,7.0,", 1),
    )
    .unwrap();
    let junit = folder.path().join("junit.xml");
    let output = check(folder.path(), &[RANDOM, "--junit", junit.to_str().unwrap()]);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(1), "{said}");
    let words = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("0 scenes and 3000 random ones"), "{words}");
    assert!(
        words.contains("fuzz impacts held in exact of random-scenes: moved, was 7"),
        "{words}"
    );
    let xml = fs::read_to_string(junit).unwrap();
    for words in [
        "<testsuite name=\"random-scenes\"",
        "exact / fuzz",
        "stepper contact=approaching-only / fuzz",
        "carom check random-scenes --accept",
    ] {
        assert!(xml.contains(words), "{words}: {xml}");
    }
}

#[test]
fn the_engines_that_hold_in_random_scenes_are_those_of_the_check() {
    let columns =
        Configuration::list(crate::support::roster(), "stepper:dt=0.004,rapier-f64").unwrap();
    let plan = random_plan(&columns, 1);
    let labels: Vec<String> = plan.columns.iter().map(Configuration::label).collect();
    assert_eq!(labels, ["stepper contact=approaching-only"]);
    assert_eq!(
        plan.columns[0].setting,
        Setting::parse(["contact=approaching-only"]).unwrap()
    );
}
