//! Knobs, presets, and what is refused.

use super::BOTH;
use crate::support::{MU, R, run, scenario};
use carom::engine::{self, Refusal, Setting};
use carom::scene::Scene;
use carom::trace::Record;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

fn slide() -> Scene {
    scenario("slide")
        .shot("cue", [0.0, 0.0], 2.0, 30.0)
        .cloth(MU)
        .duration(0.05)
        .build()
}

fn effective(engine: &str, settings: &[&str]) -> BTreeMap<String, Value> {
    run(engine, settings, &slide(), Record::Final)
        .provenance
        .parameters
}

fn refusal(engine: &str, settings: &[&str], scene: &Scene) -> String {
    let setting = Setting::parse(settings.iter().copied()).unwrap();
    let engine = crate::support::find(engine).unwrap();
    match engine::prepare(engine.as_ref(), scene, &setting) {
        Err(Refusal::Setting { message, .. }) => message,
        Err(other) => panic!("{settings:?}: refused for another reason: {other}"),
        Ok(_) => panic!("{settings:?}: not refused"),
    }
}

#[test]
fn the_default_preset_is_the_equivalent_scene() {
    for (engine, _) in BOTH {
        let got = effective(engine, &[]);
        let expected = [
            ("preset", Value::from("converging")),
            ("dt", Value::from(1e-3)),
            ("substeps", Value::from(4)),
            ("contact_recycling", Value::from(false)),
            ("can_sleep", Value::from(false)),
            ("normalized_max_linear_velocity", Value::from(f64::MAX)),
            ("ccd", Value::from("off")),
            ("length_unit", Value::from(1.0)),
            ("soft_ccd_prediction", Value::from(0.0)),
        ];
        for (key, value) in expected {
            assert_eq!(got[key], value, "{engine}: {key}");
        }
        let knobs: Vec<String> = crate::support::find(engine)
            .unwrap()
            .knobs()
            .into_iter()
            .map(|knob| knob.key)
            .collect();
        let keys: Vec<&String> = got.keys().collect();
        assert_eq!(
            keys.len(),
            knobs.len(),
            "{engine}: every knob is a parameter"
        );
        assert!(
            keys.iter().all(|key| knobs.contains(key)),
            "{engine}: {keys:?}"
        );
    }
}

#[test]
fn the_stock_preset_has_the_defaults_of_rapier_and_a_key_overrides_it() {
    for (engine, _) in BOTH {
        let stock = effective(engine, &["preset=stock"]);
        let expected = [
            ("preset", Value::from("stock")),
            ("dt", Value::from(1.0 / 60.0)),
            ("contact_recycling", Value::from(true)),
            ("can_sleep", Value::from(true)),
            ("normalized_max_linear_velocity", Value::from(400.0)),
            ("ccd", Value::from("fixed")),
            ("allow_fast_rotation", Value::from(false)),
        ];
        for (key, value) in expected {
            assert_eq!(stock[key], value, "{engine}: {key}");
        }
        let mut mixed = effective(engine, &["dt=0.002", "preset=stock"]);
        assert_eq!(mixed["dt"], Value::from(0.002), "{engine}");
        mixed.insert("dt".to_owned(), stock["dt"].clone());
        assert_eq!(mixed, stock, "{engine}: nothing else changes");
    }
}

/// Another value for every knob.
const OTHER: [(&str, &str); 24] = [
    ("preset", "stock"),
    ("dt", "0.002"),
    ("substeps", "2"),
    ("internal_iterations", "3"),
    ("stabilization_iterations", "0"),
    ("contact_recycling", "true"),
    ("contact_recycle_distance", "0.01"),
    ("contact_clustering", "false"),
    ("prediction_distance", "0.1"),
    ("soft_ccd_prediction", "0.5"),
    ("ccd", "all"),
    ("normalized_max_linear_velocity", "1"),
    ("length_unit", "2"),
    ("can_sleep", "true"),
    ("allow_fast_rotation", "false"),
    ("allowed_linear_error", "0.001"),
    ("max_corrective_velocity", "1"),
    ("contact_natural_frequency", "10"),
    ("contact_damping_ratio", "5"),
    ("static_contact_natural_frequency", "10"),
    ("static_contact_damping_ratio", "5"),
    ("warmstart_coefficient", "0"),
    ("friction_in_bias_pass", "true"),
    ("friction_model", "coulomb"),
];

#[test]
fn every_knob_is_described_accepted_and_printed() {
    for (id, _) in BOTH {
        let engine = crate::support::find(id).unwrap();
        let knobs = engine.knobs();
        assert_eq!(
            knobs.len(),
            OTHER.len(),
            "{id}: a knob without a test value"
        );
        let scene = slide();
        let sheet = |setting: &Setting| {
            let run = engine::prepare(engine.as_ref(), &scene, setting).unwrap();
            let rows = run.sheet();
            let text = rows
                .iter()
                .map(|row| format!("{} {}\n", row.name, row.value));
            text.collect::<String>()
        };
        for knob in knobs {
            let (_, value) = OTHER.iter().find(|(key, _)| *key == knob.key).unwrap();
            assert!(knob.what.len() > 20, "{id}: {} says too little", knob.key);
            assert_ne!(&knob.default, value, "{id}: {}", knob.key);
            // a value that matters only together with recycling is printed only then
            let base = match knob.key.as_str() {
                "contact_recycle_distance" => Setting::default().with("contact_recycling", true),
                _ => Setting::default(),
            };
            let set = base.clone().with(&knob.key, value);
            assert_ne!(
                sheet(&base),
                sheet(&set),
                "{id}: {} is not on the sheet",
                knob.key
            );
            let parameters = effective(id, &[&format!("{}={value}", knob.key)]);
            let got = parameters[&knob.key].to_string();
            let got = got.trim_matches('"').trim_end_matches(".0").to_owned();
            assert_eq!(&got, value, "{id}: {}", knob.key);
        }
    }
}

#[test]
fn knobs_of_friction_and_correction_reach_rapier() {
    // each of these moves a sliding ball or the ball that it hits at least a bit differently; it moves .03 in a step, and
    // contacts are predicted .02 ahead
    let scene = super::cut_shot(35.0, 30.0, 0.205)
        .cloth(MU)
        .duration(0.02)
        .build();
    let moving = [
        "dt=0.002",
        "substeps=2",
        "stabilization_iterations=0",
        "contact_recycling=true",
        "prediction_distance=0.1",
        "soft_ccd_prediction=1",
        "normalized_max_linear_velocity=1",
        "length_unit=10",
        "static_contact_natural_frequency=10",
        "static_contact_damping_ratio=1",
        "warmstart_coefficient=0",
        "preset=stock",
    ];
    for (engine, _) in BOTH {
        let base = run(engine, &[], &scene, Record::Final).final_states();
        for setting in moving {
            let other = run(engine, &[setting], &scene, Record::Final).final_states();
            assert_ne!(base, other, "{engine}: {setting} changes nothing");
        }
    }
}

#[test]
fn the_ccd_that_runs_is_the_one_that_is_printed() {
    for (speed, dt, expected) in [(2.0, "dt=1e-3", "off"), (200.0, "dt=1e-3", "cue")] {
        let scene = scenario("fast")
            .shot("cue", [0.0, 0.0], speed, 0.0)
            .duration(0.01)
            .build();
        let moves: f64 = speed * 1e-3;
        assert_eq!(expected == "off", moves < 0.5 * R);
        for (engine, _) in BOTH {
            let trace = run(engine, &[dt], &scene, Record::Final);
            assert_eq!(
                trace.provenance.parameters["ccd"], expected,
                "{engine}, v {speed}"
            );
        }
    }
}

#[test]
fn what_cannot_run_is_refused_in_a_sentence() {
    let cases = [
        (
            "dt=0",
            "`dt=0`: expected a number, more than 0 and at most 1e9",
        ),
        (
            "dt=-1e-3",
            "`dt=-0.001`: expected a number, more than 0 and at most 1e9",
        ),
        ("dt=1e-50", "more than 0"),
        (
            "dt=1e-12",
            "`dt=0.000000000001`: the 0.05 s of scene slide would take 5.0e10 steps, more than 1e8; raise dt",
        ),
        ("dt=inf", "`dt=inf`: expected a finite number"),
        ("dt=fast", "`dt=fast`: expected a finite number"),
        (
            "substeps=0",
            "`substeps=0`: expected a whole number from 1 to 1000",
        ),
        ("substeps=1001", "from 1 to 1000"),
        (
            "substeps=2.5",
            "`substeps=2.5`: expected a whole number, 0 or more",
        ),
        ("stabilization_iterations=5000", "from 0 to 1000"),
        (
            "prediction_distance=-1",
            "`prediction_distance=-1`: expected a number, more than 0",
        ),
        (
            "length_unit=0",
            "`length_unit=0`: expected a number, 0.000001 or more and at most 1e6",
        ),
        (
            "warmstart_coefficient=1.5",
            "`warmstart_coefficient=1.5`: expected a number, 0 or more and at most 1e0",
        ),
        ("contact_damping_ratio=-1", "0 or more"),
        (
            "can_sleep=maybe",
            "`can_sleep=maybe`: expected true or false",
        ),
        ("preset=fast", "`preset=fast`: expected converging or stock"),
        (
            "ccd=some",
            "unknown variant `some`, expected one of `off`, `auto`, `fixed`, `cue`, `all`",
        ),
        (
            "friction_model=none",
            "unknown variant `none`, expected `simplified` or `coulomb`",
        ),
        (
            "dT=1",
            "unknown setting `dT`; known are preset, dt, substeps",
        ),
    ];
    for (engine, _) in BOTH {
        for (setting, expected) in cases {
            let message = refusal(engine, &[setting], &slide());
            assert!(
                message.contains(expected),
                "{engine}, {setting}: `{message}` does not say `{expected}`"
            );
        }
    }
}

#[test]
fn every_rung_of_every_ladder_can_run() {
    for (id, _) in BOTH {
        let engine = crate::support::find(id).unwrap();
        let ladders = engine.ladders();
        let names: Vec<&str> = ladders.iter().map(|(name, _)| name.as_ref()).collect();
        for name in [
            "converging",
            "substeps",
            "recycling",
            "soft-ccd",
            "prediction",
            "stock",
        ] {
            assert!(names.contains(&name), "{id}: no ladder {name}");
        }
        for (name, rungs) in ladders {
            assert!(rungs.len() > 3, "{id}, {name}");
            for setting in rungs {
                let scene = slide();
                if let Err(refusal) = engine::prepare(engine.as_ref(), &scene, &setting) {
                    panic!("{id}, {name}, {setting}: {refusal}");
                }
            }
        }
    }
}

#[test]
fn remedies_are_those_for_what_can_go_wrong_in_the_scene() {
    let stock = Setting::default().with("preset", "stock");
    for (name, more) in [
        // 1.5 m/s and nothing that turns
        ("contact-recycling", vec!["contact recycling"]),
        // 500 m/s, nothing to meet
        ("speed-cap", vec!["the cap on speed"]),
        // 200 m/s are below the cap of 400, and 3 m a step
        (
            "through-a-ball",
            vec!["contact recycling", "the sweep of the cue ball"],
        ),
        // 105 rad/s turn a ball by 1.7 in 1/60 s
        ("rotation-cap", vec!["the cap on rotation"]),
    ] {
        let scene = carom::scene::catalogue::scene(name).unwrap();
        for (engine, _) in BOTH {
            let remedies = crate::support::find(engine)
                .unwrap()
                .ablations(&scene, &stock);
            let found: BTreeSet<&str> = remedies.iter().map(|(what, _)| what.as_ref()).collect();
            let expected: BTreeSet<&str> = ["sleep", "the time step"]
                .into_iter()
                .chain(more.clone())
                .collect();
            assert_eq!(found, expected, "{engine} in {name}");
            for (what, setting) in remedies {
                let prepared = engine::prepare(
                    crate::support::find(engine).unwrap().as_ref(),
                    &scene,
                    &setting,
                );
                assert!(prepared.is_ok(), "{engine} in {name}: {what}: {setting}");
            }
        }
    }
}
