//! The lists from which everything else derives: unique names, units, and no entry that nothing uses.

use carom::compare::METRICS;
use carom::engine::{Role, Setting, prepare};
use carom::physics::EFFECTS;
use carom::scene::{catalogue, is_kebab_case};
use carom::study::stability::presets;
use std::collections::BTreeSet;

fn unique<'a>(what: &str, names: impl IntoIterator<Item = &'a str>) -> usize {
    let mut seen = BTreeSet::new();
    for name in names {
        assert!(seen.insert(name), "{what} {name} is listed twice");
    }
    assert!(!seen.is_empty(), "no {what}");
    seen.len()
}

#[test]
fn names_are_unique_and_kebab_case() {
    unique(
        "engine",
        crate::support::roster().iter().map(|engine| engine.id()),
    );
    unique("metric", METRICS.iter().map(|metric| metric.id));
    unique("effect", EFFECTS.iter().map(|effect| effect.id));
    unique("role", Role::ALL.iter().map(|role| role.title()));
    unique(
        "format",
        carom::report::FORMATS.iter().map(|format| format.id),
    );
    for name in crate::support::roster()
        .iter()
        .map(|e| e.id())
        .chain(METRICS.iter().map(|m| m.id))
    {
        assert!(is_kebab_case(name), "{name}");
    }
    for metric in METRICS {
        assert!(!metric.what.is_empty(), "{} says nothing", metric.id);
        let counts = ["contact-episodes", "contact-exchanges"].contains(&metric.id)
            || metric.id.starts_with("order-")
            || metric.id.ends_with("-disagreements");
        assert_eq!(
            metric.unit.is_empty(),
            counts,
            "{} has unit `{}`",
            metric.id,
            metric.unit
        );
    }
}

#[test]
fn every_scene_is_prepared_by_two_engines_and_passes_their_audit() {
    for entry in catalogue::all() {
        let scene = entry.scene().unwrap();
        // the stepper as the report wrote it knows balls of one mass only
        let columns = presets(crate::support::roster());
        let able: BTreeSet<&str> = columns
            .iter()
            .filter(|column| prepare(column.engine.as_ref(), &scene, &column.setting).is_ok())
            .map(|column| column.engine.id())
            .collect();
        let prepared = columns.iter().filter(|column| {
            let run = prepare(column.engine.as_ref(), &scene, &column.setting);
            run.is_ok_and(|run| {
                !run.sheet().is_empty() && run.inside().balls.len() == scene.balls.len()
            })
        });
        assert!(
            prepared.count() >= 2 && able.len() >= 2,
            "{} runs in fewer than two engines",
            entry.name
        );
    }
}

#[test]
fn every_ladder_and_remedy_is_a_setting_that_its_engine_accepts() {
    let scene = catalogue::scene("slide").unwrap();
    for engine in crate::support::roster() {
        let ladders = engine.ladders();
        unique("ladder", ladders.iter().map(|(name, _)| name.as_ref()));
        for (name, settings) in ladders {
            assert!(!settings.is_empty(), "{} {name} is empty", engine.id());
            for setting in &settings {
                let prepared = prepare(engine.as_ref(), &scene, setting).map(|_| ());
                assert_eq!(prepared, Ok(()), "{} {name} {setting}", engine.id());
            }
        }
        for (what, setting) in engine.ablations(&scene, &Setting::default()) {
            assert_eq!(
                prepare(engine.as_ref(), &scene, &setting).map(|_| ()),
                Ok(()),
                "{} {what}",
                engine.id()
            );
            assert_ne!(
                setting,
                Setting::default(),
                "{} {what} changes nothing",
                engine.id()
            );
        }
        assert!(crate::support::find(engine.id()).is_some());
        assert!(!engine.about().method.is_empty() && !engine.about().shares.is_empty());
    }
}
