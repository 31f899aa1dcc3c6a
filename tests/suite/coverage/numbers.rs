//! Every number of every law, in every column that accepts it: a thousandth more in the engine than in the scene is noticed.

use super::{Exempt, gate, hold};
use crate::mutants::{Fault, Wrong, caught, held};
use carom::engine;
use carom::scene::Scene;
use carom::study::compare::default_columns;
use carom::study::matrix::Configuration;
use std::collections::BTreeSet;

/// Numbers that no gate scene holds.
const EXEMPT: &[Exempt] = &[];

/// By how much a number is too large.
const MORE: f64 = 1e-3;

/// Keys of the numbers of a scene's laws; those of all pockets share one.
fn numbers(scene: &Scene) -> BTreeSet<&'static str> {
    let mut keys = BTreeSet::new();
    scene.effects.map(|key, _| keys.insert(key));
    keys
}

#[test]
fn every_number_of_every_law_is_held_in_every_column_that_accepts_it() {
    let scenes = gate();
    let mut missing: BTreeSet<(String, String)> = BTreeSet::new();
    let mut tried = 0;
    for column in default_columns(crate::support::roster()) {
        for key in scenes.iter().flat_map(numbers).collect::<BTreeSet<_>>() {
            let own = scenes.iter().filter(|scene| {
                let runs = engine::prepare(column.engine.as_ref(), scene, &column.setting).is_ok();
                runs && numbers(scene).contains(key)
            });
            // the quick ones first: one that notices is enough
            let mut own: Vec<&Scene> = own.collect();
            own.sort_by(|a, b| {
                let cost = |scene: &Scene| {
                    let runs = 1 + scene.try_settings.len();
                    scene.duration * (scene.balls.len() * runs) as f64
                };
                cost(a).total_cmp(&cost(b))
            });
            if own.is_empty() {
                continue;
            }
            tried += 1;
            let notices = |scene: &&Scene| {
                let wrong = Configuration {
                    engine: Wrong::engine(column.engine.id(), Fault::Number(key, 1.0 + MORE)),
                    setting: column.setting.clone(),
                };
                !caught(&held(std::slice::from_ref(*scene), &[wrong], 0)).is_empty()
            };
            if !own.iter().any(notices) {
                missing.insert((key.to_owned(), column.label()));
            }
        }
    }
    assert!(tried > 60, "{tried} numbers");
    hold("numbers", &missing, EXEMPT);
}
