//! Every key of every engine at another value than its default, in a gate scene that is not as accepted when the key is ignored.

use super::{Exempt, gate, hold, tried};
use crate::mutants::{Fault, Wrong, caught, held};
use carom::study::compare::default_columns;
use carom::study::matrix::Configuration;
use std::collections::BTreeSet;

/// Keys that no gate scene can hold.
const EXEMPT: &[Exempt] = &[
    Exempt {
        what: "contacts",
        engine: "exact",
        why: "the other value ends runs where contacts begin, as all did before they were followed; `contact` holds that it does",
    },
    Exempt {
        what: "partners",
        engine: "stepper",
        why: "it changes cost only: the trace is the same to the bit, which `transcription` holds",
    },
    Exempt {
        what: "contact_clustering",
        engine: "",
        why: "it merges contact manifolds with one normal, and balls have none to merge",
    },
    Exempt {
        what: "friction_model",
        engine: "",
        why: "the two models differ at contacts of several points, and balls have one",
    },
];

#[test]
fn every_key_at_another_value_is_held_so_that_ignoring_it_is_noticed() {
    let mut missing: BTreeSet<(String, String)> = BTreeSet::new();
    for engine in crate::support::roster() {
        let keys = engine.knobs().into_iter().map(|knob| knob.key);
        missing.extend(keys.map(|key| (key, engine.id().to_owned())));
    }
    assert!(missing.len() > 50, "{} keys", missing.len());
    let mut ignored = 0;
    for scene in gate() {
        let presets = default_columns(crate::support::roster()).into_iter();
        for column in presets.chain(tried(&scene)) {
            for key in column.setting.values.keys() {
                let place = (key.clone(), column.engine.id().to_owned());
                if !missing.contains(&place) {
                    continue;
                }
                let knobs = column.engine.knobs();
                let knob = knobs.into_iter().find(|knob| knob.key == *key).unwrap();
                let [key, default] = [&knob.key, &knob.default].map(|word| &*word.clone().leak());
                let wrong = Configuration {
                    engine: Wrong::engine(column.engine.id(), Fault::Setting(key, default)),
                    setting: column.setting.clone(),
                };
                if wrong.engine.pace(&scene, &wrong.setting).is_err() {
                    continue;
                }
                let held = held(std::slice::from_ref(&scene), &[wrong], 0);
                if !caught(&held).is_empty() {
                    missing.remove(&place);
                }
                ignored += 1;
            }
        }
    }
    assert!(ignored > 40, "{ignored} keys were ignored");
    hold("keys at another value", &missing, EXEMPT);
}
