//! The baselines of the repository: complete, current, and every number in them held.

use super::baselines;
use carom::gate::{self, Accepted, Kind, diff};
use carom::scene::{SetName, catalogue};
use carom::study::check::{
    Level, RANDOM, RANDOM_SCENES, level, random_hash, random_plan, tolerance,
};
use carom::study::compare::default_columns;
use std::collections::BTreeSet;
use std::fs;

fn all() -> Vec<(String, Accepted)> {
    let scenes = catalogue::set(SetName::Gate).unwrap();
    let names = scenes.iter().map(|scene| scene.name.as_str());
    let read = |name: &str| {
        let text = fs::read_to_string(baselines().join(format!("{name}.csv"))).unwrap();
        let accepted = gate::read(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
        (text, accepted)
    };
    let all: Vec<(String, Accepted)> = names.chain([RANDOM]).map(read).collect();
    assert!(all.len() >= 8, "{} baselines", all.len());
    all
}

#[test]
fn every_scene_of_the_gate_has_a_current_baseline_and_no_other_is_there() {
    let mut files: Vec<String> = fs::read_dir(baselines())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    let mut expected = Vec::new();
    for (text, accepted) in all() {
        let name = &accepted.scene;
        let hash = match name.as_str() {
            RANDOM => random_hash(&random_plan(
                &default_columns(crate::support::roster()),
                RANDOM_SCENES,
            )),
            scene => catalogue::scene(scene).unwrap().hash(),
        };
        assert_eq!(accepted.hash, hash, "{name} changed: accept it anew");
        assert_eq!(gate::write(&accepted), text, "{name} was edited by hand");
        for version in [
            "carom",
            "exact",
            "rapier-f64",
            "target",
            "compiler",
            "commit",
        ] {
            assert!(!accepted.version(version).is_empty(), "{name}: {version}");
        }
        expected.push(format!("{name}.csv"));
    }
    expected.sort();
    assert_eq!(files, expected);
}

#[test]
fn moving_any_number_of_any_baseline_by_1_percent_and_1e_3_is_a_change() {
    let mut moved = 0;
    for (_, accepted) in all() {
        for index in 0..accepted.rows.len() {
            let Some(value) = accepted.rows[index].value else {
                continue;
            };
            for other in [1.01 * value + 1e-3, 0.99 * value - 1e-3] {
                let mut rows = accepted.rows.clone();
                rows[index].value = Some(other);
                // the widest bound that any engine has
                let changes = diff(&rows, &accepted.rows, |row| {
                    tolerance(&row.check, f64::from(f32::EPSILON))
                });
                let kinds: Vec<Kind> = changes.iter().map(|change| change.kind).collect();
                let row = &accepted.rows[index];
                assert_eq!(kinds, [Kind::Moved], "{} {row:?}", accepted.scene);
                moved += 1;
            }
        }
    }
    assert!(moved > 4000, "{moved} numbers were moved");
}

#[test]
fn removing_any_row_of_any_baseline_is_a_change() {
    for (_, accepted) in all() {
        for index in 0..accepted.rows.len() {
            let mut rows = accepted.rows.clone();
            rows.remove(index);
            let changes = diff(&rows, &accepted.rows, |row| {
                tolerance(&row.check, f64::from(f32::EPSILON))
            });
            assert!(
                matches!(&changes[..], [only] if only.kind == Kind::Appeared),
                "{} {:?}",
                accepted.scene,
                accepted.rows[index]
            );
        }
    }
}

#[test]
fn every_level_is_held_and_a_promise_is_accepted_only_where_it_holds() {
    let mut levels = BTreeSet::new();
    for (_, accepted) in all() {
        for row in &accepted.rows {
            let level = level(&row.check);
            levels.insert(level);
            if level == Level::Promise {
                let holds = row.verdict == Some(carom::finding::Verdict::Holds);
                assert!(holds, "{} {row:?}", accepted.scene);
            }
        }
    }
    assert_eq!(levels, BTreeSet::from(Level::ALL));
}
