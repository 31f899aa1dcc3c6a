//! What an engine says that it lacks, and what it does: every effect that it does not name shows in its runs.
//!
//! For each effect there is a shot in which it does something that a closed form tells. An engine either names the effect as missing and is
//! refused, or does that; an engine that is silent and runs the scene without the effect is caught by what it does.

use crate::mutants::engines::{Fault, Wrong};
use crate::support::{MU, R, roster, scenario};
use carom::engine::{Engine, Limits, Refusal, Setting, prepare};
use carom::math::Vec3;
use carom::physics::{Cloth, Contact, Cushion, EFFECTS, Friction, Pockets, friction};
use carom::scene::Scene;
use carom::study::stability::presets;
use carom::trace::{Record, Trace};
use std::collections::BTreeMap;

/// A shot in which an effect shows.
struct Shot {
    scene: Scene,
    /// What it shows in.
    figure: fn(&Trace) -> f64,
    /// What it is by a closed form.
    expected: f64,
    /// What an engine that steps may be off, absolute: less than what the effect does.
    tolerance: f64,
    /// Takes the effect away.
    without: fn(&mut Scene),
}

/// Speed of the ball that is shot.
const V: f64 = 2.0;

fn velocity(trace: &Trace, ball: usize) -> Vec3 {
    trace.paths[ball].last().unwrap().velocity
}

fn no_cloth(scene: &mut Scene) {
    scene.effects.cloth = None;
}

fn no_contact(scene: &mut Scene) {
    (scene.effects.contact, scene.effects.friction) = (None, None);
}

fn no_friction(scene: &mut Scene) {
    scene.effects.friction = None;
}

fn no_cushion(scene: &mut Scene) {
    scene.effects.cushion = None;
}

fn no_pockets(scene: &mut Scene) {
    scene.effects.pockets = None;
}

/// The shot of an effect.
fn shot(id: &str) -> Shot {
    let lone = |duration| {
        let scene = scenario(id).moving("cue", [1.0, 1.0], [V, 0.0]);
        scene.duration(duration).build()
    };
    // along x; the gap is a radius
    let pair = || {
        let scene = scenario(id).moving("cue", [1.0, 1.0], [V, 0.0]);
        let scene = scene.resting("1", [1.0 + 3.0 * R, 1.0]);
        scene.duration(0.3).build()
    };
    let speed = |trace: &Trace| velocity(trace, 0).x;
    let first = |scene, expected, tolerance, without: fn(&mut Scene)| Shot {
        scene,
        figure: speed,
        expected,
        tolerance,
        without,
    };
    let cloth = |law, duration, expected| {
        let mut scene = lone(duration);
        scene.effects.cloth = Some(law);
        first(scene, expected, 0.02 * V, no_cloth)
    };
    let contact = |law, expected| {
        let mut scene = pair();
        scene.effects.contact = Some(law);
        Shot {
            figure: |trace| velocity(trace, 1).x,
            ..first(scene, expected, 0.01 * V, no_contact)
        }
    };
    // the ball that is hit goes off across by what a coefficient makes of the push, for it does not stick. The push is one without
    // restitution: rapier rubs for the part of it that stops the approach, which is then the whole
    let rub = |law, spin: f64, mu: f64| {
        let mut scene = pair();
        scene.effects.contact = Some(Contact::Inelastic { e: 0.0 });
        scene.effects.friction = Some(law);
        scene.balls[0].state.spin.z = spin;
        let (grips, slides) = (R * spin / 7.0, mu * V / 2.0);
        assert!(slides < 0.5 * grips, "it would stick");
        Shot {
            figure: |trace| velocity(trace, 1).y.abs(),
            ..first(scene, slides, 0.01 * slides, no_friction)
        }
    };
    // straight into x1
    let cushion = |law, expected| {
        let scene = scenario(id).moving("cue", [1.0, 1.0], [V, 0.0]);
        let mut scene = scene.cushions(1.0 + 2.0 * R, 2.0).duration(0.3).build();
        scene.effects.cushion = Some(law);
        first(scene, expected, 0.01 * V, no_cushion)
    };
    let (e, mu, height) = (0.7, 0.1, 1.28);
    match id {
        "cloth.translational" => {
            let law = Cloth::Translational { mu: MU };
            cloth(law, 0.5, V - MU * 9.81 * 0.5)
        }
        // slides until it rolls with 5/7 of its speed, and goes on
        "cloth.rotational" => {
            let law = Cloth::Rotational {
                mu_slide: 0.4,
                mu_roll: 0.0,
                mu_spin: 0.0,
            };
            cloth(law, 0.5, 5.0 / 7.0 * V)
        }
        "contact.elastic" => contact(Contact::Elastic {}, V),
        "contact.inelastic" => contact(Contact::Inelastic { e }, (1.0 + e) / 2.0 * V),
        "friction.constant" => rub(Friction::Constant { mu: 0.05 }, 30.0, 0.05),
        "friction.alciatore" => {
            let [a, b, c] = friction::alciatore::PUBLISHED;
            let (length_in_metres, spin) = (0.12192, 30.0);
            let law = Friction::Alciatore {
                a,
                b,
                c,
                length_in_metres,
            };
            rub(law, spin, a + b * (-c * R * spin * length_in_metres).exp())
        }
        "cushion.elastic" => cushion(Cushion::Elastic {}, -V),
        "cushion.restitution" => cushion(Cushion::Restitution { e }, -e * V),
        // a push along the line from the nose to the centre, and friction that ends the slip over the nose
        "cushion.han-2005" => {
            let sin: f64 = height - 1.0;
            let cos = (1.0 - sin * sin).sqrt();
            let push = (1.0 + e) * V * cos;
            let slip = 2.0 / 7.0 * V * sin;
            assert!(slip < 0.3 * push);
            let law = Cushion::Han2005 { e, mu: 0.3, height };
            cushion(law, V - push * cos - slip * sin)
        }
        // without friction the cloth takes what the nose pushes down: the work of the push gives the speed back by e
        "cushion.mathavan-2010" => {
            let law = Cushion::Mathavan2010 {
                e,
                mu: 0.0,
                mu_cloth: 0.0,
                height,
            };
            cushion(law, -e * V)
        }
        "pockets" => {
            let mut scene = lone(0.5);
            let scene_with_table = scenario(id).cushions(4.0, 4.0).build();
            scene.table = scene_with_table.table;
            scene.effects.pockets = Some(Pockets {
                circles: vec![[1.0 + 2.0 * R, 1.0, R]],
            });
            Shot {
                figure: |trace| f64::from(u8::from(trace.pocketed(0))),
                ..first(scene, 1.0, 0.4, no_pockets)
            }
        }
        other => panic!("{other} has no shot in this test ({mu})"),
    }
}

/// The settings in which an engine is compared. The report's rule lets a pair exchange as long as it overlaps, which no law says: what an
/// engine does in one of them it can do.
fn settings(id: &str) -> Vec<Setting> {
    let own = presets(roster())
        .into_iter()
        .filter(|preset| preset.engine.id() == id);
    own.map(|preset| preset.setting).collect()
}

/// By how much the best setting of an engine is off, with what it makes of the shot; `None` where it says that it lacks something.
fn nearest(engine: &dyn Engine, shot: &Shot) -> Option<(f64, f64)> {
    let made = settings(engine.id())
        .into_iter()
        .map(|setting| made(engine, &setting, shot));
    let made: Option<Vec<f64>> = made.collect();
    let off = made?
        .into_iter()
        .map(|got| ((got - shot.expected).abs(), got));
    off.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// What an engine makes of a shot; `None` where it says that it lacks something.
fn made(engine: &dyn Engine, setting: &Setting, shot: &Shot) -> Option<f64> {
    let missing = engine.missing(&shot.scene);
    match prepare(engine, &shot.scene, setting) {
        Ok(run) => {
            let trace = run.simulate(Record::Events, &Limits::NONE);
            assert!(missing.is_empty(), "{} runs what it lacks", engine.id());
            Some((shot.figure)(&trace))
        }
        Err(refusal) => {
            assert_eq!(refusal, Refusal::NotComparable { missing });
            None
        }
    }
}

#[test]
fn an_engine_does_what_every_effect_says_or_names_it() {
    let mut done: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for effect in EFFECTS {
        let shot = shot(effect.id);
        assert!(shot.scene.effects.named().contains(&effect.id));
        for engine in roster() {
            let missing = engine.missing(&shot.scene);
            assert!(
                missing.iter().all(|id| *id == effect.id),
                "{} misses {missing:?} of {}",
                engine.id(),
                effect.id
            );
            if let Some((off, got)) = nearest(engine.as_ref(), &shot) {
                assert!(
                    off <= shot.tolerance,
                    "{} {}: {got} instead of {}, allowed {}",
                    engine.id(),
                    effect.id,
                    shot.expected,
                    shot.tolerance
                );
                done.entry(effect.id).or_default().push(engine.id());
            }
        }
    }
    // what only one engine did could be compared with nothing
    for effect in EFFECTS {
        let engines = done.get(effect.id).map_or(0, Vec::len);
        assert!(engines >= 2, "{}: {engines} engines", effect.id);
    }
}

#[test]
fn an_engine_that_ignores_an_effect_and_does_not_say_so_is_caught() {
    let mut caught = 0;
    for effect in EFFECTS {
        let shot = shot(effect.id);
        for engine in roster() {
            if !engine.missing(&shot.scene).is_empty() {
                continue;
            }
            // what it holds, as the audit reads it, is what the scene says
            let silent = Wrong::engine(engine.id(), Fault::Scene(shot.without));
            let (off, got) = nearest(silent.as_ref(), &shot).unwrap();
            assert!(
                off > 1.2 * shot.tolerance,
                "{} without {}: {got}, and {} is right",
                engine.id(),
                effect.id,
                shot.expected
            );
            caught += 1;
        }
    }
    assert!(caught >= 2 * EFFECTS.len(), "{caught}");
}
