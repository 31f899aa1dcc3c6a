//! The lists from which everything else derives: unique names, units, and no entry that nothing uses.

use carom::compare::METRICS;
use carom::engine::{Refusal, Role, Setting, prepare};
use carom::physics::{Cloth, Contact, Cushion, EFFECTS, Effects, Friction, Pockets};
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
        let counts = metric.id.starts_with("order-") || metric.id.ends_with("-disagreements");
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

#[test]
fn every_engine_names_every_effect_that_it_does_not_simulate() {
    let mut named = 0;
    for effect in EFFECTS {
        let mut scene = catalogue::scene("slide").unwrap();
        scene.effects = effects_with(effect.id);
        assert!(scene.effects.named().contains(&effect.id), "{}", effect.id);
        for engine in crate::support::roster() {
            let missing = engine.missing(&scene);
            let listed = scene.effects.named();
            assert!(
                missing.iter().all(|id| listed.contains(&id.as_ref())),
                "{} misses {missing:?} of {listed:?}",
                engine.id()
            );
            let refused = prepare(engine.as_ref(), &scene, &Setting::default()).err();
            match refused {
                None => assert!(missing.is_empty(), "{}", engine.id()),
                Some(refusal) => assert_eq!(
                    refusal,
                    Refusal::NotComparable { missing },
                    "{} on {}",
                    engine.id(),
                    effect.id
                ),
            }
            named += 1;
        }
    }
    assert_eq!(named, EFFECTS.len() * crate::support::roster().iter().len());
}

/// The effect called `id`, with a contact where it is friction.
fn effects_with(id: &str) -> Effects {
    let (e, mu, height) = (0.9, 0.1, 1.28);
    let friction = |law| Effects {
        contact: Some(Contact::Elastic {}),
        friction: Some(law),
        ..Effects::default()
    };
    let cushion = |law| Effects {
        cushion: Some(law),
        ..Effects::default()
    };
    let contact = |law| Effects {
        contact: Some(law),
        ..Effects::default()
    };
    let cloth = |law| Effects {
        cloth: Some(law),
        ..Effects::default()
    };
    match id {
        "cloth.translational" => cloth(Cloth::Translational { mu }),
        "cloth.rotational" => cloth(Cloth::Rotational {
            mu_slide: 0.2,
            mu_roll: 0.01,
            mu_spin: 0.01,
        }),
        "contact.elastic" => contact(Contact::Elastic {}),
        "contact.inelastic" => contact(Contact::Inelastic { e }),
        "friction.constant" => friction(Friction::Constant { mu }),
        "friction.alciatore" => friction(Friction::Alciatore {
            a: 0.01,
            b: 0.1,
            c: 1.0,
            length_in_metres: 1.0,
        }),
        "cushion.elastic" => cushion(Cushion::Elastic {}),
        "cushion.restitution" => cushion(Cushion::Restitution { e }),
        "cushion.han-2005" => cushion(Cushion::Han2005 { e, mu, height }),
        "cushion.mathavan-2010" => cushion(Cushion::Mathavan2010 {
            e,
            mu,
            mu_cloth: 0.2,
            height,
        }),
        "pockets" => Effects {
            pockets: Some(Pockets {
                circles: vec![[0.0, 0.0, 0.1]],
            }),
            ..Effects::default()
        },
        other => panic!("{other} has no scene in this test"),
    }
}
