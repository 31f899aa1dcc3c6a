//! What the gate runs, as a rule: every branch of every law in every column that accepts it, every number of every law, and every key of
//! every engine at another value than its default, each in a scene that a fault in that place would change.
//!
//! What cannot stand in a gate scene stands in a list of exemptions with its reason; an exemption that is no longer needed fails.

mod branches;
mod keys;
mod numbers;

use crate::support::scenario;
use branches::{Branch, laws, seen};
use carom::engine;
use carom::scene::{Scene, SetName, catalogue};
use carom::study::check::plan;
use carom::study::compare::default_columns;
use carom::study::matrix::Configuration;
use carom::trace::Record;
use std::collections::BTreeSet;

/// Something that no gate scene holds, and why.
pub struct Exempt {
    /// The branch, number or key.
    pub what: &'static str,
    /// Label of the column or id of the engine; empty for all.
    pub engine: &'static str,
    /// Why.
    pub why: &'static str,
}

/// Branches that no gate scene goes through.
const EXEMPT: &[Exempt] = &[Exempt {
    what: "cushion.mathavan-2010: sticks at both",
    engine: "",
    why: "a ball that both hold is wedged: the impulse of the nose moves it no more, so it does not come back",
}];

/// The scenes of the gate.
pub fn gate() -> Vec<Scene> {
    let scenes = catalogue::set(SetName::Gate).unwrap();
    assert!(scenes.len() > 20, "{} scenes", scenes.len());
    scenes
}

/// Holds what is missing against a list of exemptions: each is in it, and nothing else is.
///
/// `missing`: what and in which engine.
pub fn hold(what: &str, missing: &BTreeSet<(String, String)>, exempt: &[Exempt]) {
    let faults = faults(missing, exempt);
    assert!(faults.is_empty(), "{what}: {faults:#?}");
}

/// What no gate scene holds and no exemption names, and exemptions that nothing needs.
fn faults(missing: &BTreeSet<(String, String)>, exempt: &[Exempt]) -> Vec<String> {
    let matches = |one: &Exempt, (of, engine): &(String, String)| {
        one.what == of && (one.engine.is_empty() || one.engine == engine)
    };
    let uncovered = missing
        .iter()
        .filter(|one| !exempt.iter().any(|e| matches(e, one)))
        .map(|(what, engine)| format!("no gate scene holds {what} in {engine}"));
    let idle = exempt
        .iter()
        .filter(|one| !missing.iter().any(|of| matches(one, of)))
        .map(|one| format!("{} is held, and needs no exemption", one.what));
    let unreasoned = exempt
        .iter()
        .filter(|one| one.why.len() < 20)
        .map(|one| format!("{} is exempt without a reason", one.what));
    uncovered.chain(idle).chain(unreasoned).collect()
}

/// Two balls on a table, which every law can act on.
fn two_balls() -> Scene {
    scenario("two-balls")
        .moving("a", [1.0, 1.0], [1.0, 0.0])
        .resting("b", [2.0, 1.0])
        .cushions(4.0, 4.0)
        .build()
}

/// True where the column can simulate the scene.
fn accepts(column: &Configuration, scene: &Scene) -> bool {
    engine::prepare(column.engine.as_ref(), scene, &column.setting).is_ok()
}

#[test]
fn every_branch_of_every_law_occurs_in_a_gate_scene_of_every_column_that_accepts_it() {
    let columns = default_columns(crate::support::roster());
    let mut missing: BTreeSet<(Branch, String)> = BTreeSet::new();
    let mut wanted = 0;
    for law in laws() {
        for branch in law.branches() {
            let smallest = law.smallest(&branch, two_balls());
            for column in columns.iter().filter(|c| accepts(c, &smallest)) {
                missing.insert((branch.clone(), column.label()));
                wanted += 1;
            }
        }
    }
    assert!(wanted > 150, "{wanted} branches");
    for scene in gate() {
        for column in &columns {
            let Ok(run) = engine::prepare(column.engine.as_ref(), &scene, &column.setting) else {
                continue;
            };
            let trace = run.simulate(Record::Events, &engine::Limits::NONE);
            for branch in seen(&scene, &trace) {
                missing.remove(&(branch, column.label()));
            }
        }
    }
    hold("branches", &missing, EXEMPT);
}

#[test]
fn what_is_missing_is_told_and_so_is_an_exemption_that_is_not_needed() {
    let missing = BTreeSet::from([("a".to_owned(), "exact".to_owned())]);
    let exempt = |what, engine, why| Exempt { what, engine, why };
    let why = "a reason that is long enough";
    let count = |exempt: &[Exempt]| faults(&missing, exempt).len();
    assert_eq!(count(&[exempt("a", "exact", why)]), 0);
    assert_eq!(count(&[exempt("a", "", why)]), 0);
    assert_eq!(count(&[]), 1, "nothing holds it");
    assert_eq!(
        count(&[exempt("a", "stepper", why)]),
        2,
        "of another engine"
    );
    assert_eq!(count(&[exempt("a", "exact", why), exempt("b", "", why)]), 1);
    assert_eq!(count(&[exempt("a", "exact", "")]), 1, "without a reason");
}

/// The columns of a scene that its `try` adds.
fn tried(scene: &Scene) -> Vec<Configuration> {
    let given = default_columns(crate::support::roster());
    plan(crate::support::roster(), scene, &given)
        .unwrap()
        .split_off(given.len())
}
