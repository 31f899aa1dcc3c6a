//! Holds a column against the accepted baseline as `carom check` does, and says on which levels it differs.

use carom::finding::Verdict;
use carom::gate::{self, Accepted, Change, Decision, Held, Kind, Located, Row};
use carom::scene::{Scene, SetName, catalogue};
use carom::study::check::{self, CheckOutcome, Level, ORACLE};
use carom::study::matrix::{Configuration, Watch};
use std::collections::BTreeMap;

/// What differs, level by level: how many findings, and the first of them in words.
pub type Caught = BTreeMap<Level, (usize, String)>;

/// Scenes of the gate set by name; a scene outside of it says nothing about the gate.
pub fn gate_scenes(names: &[&str]) -> Vec<Scene> {
    let scene = |name: &&str| {
        let scene = catalogue::scene(name).unwrap();
        assert!(scene.is_in(SetName::Gate), "{name} is not in the gate set");
        scene
    };
    names.iter().map(scene).collect()
}

/// Runs scenes in columns as `check` does, and so many of its random ones.
fn study(scenes: &[Scene], columns: &[Configuration], random: u64) -> CheckOutcome {
    let watch = Watch::NONE;
    let mut outcome = check::study(crate::support::roster(), scenes, columns, watch).unwrap();
    if random > 0 {
        let plan = check::random_plan(columns, random);
        outcome.add_random(&carom::study::random::study(plan, watch));
    }
    outcome
}

/// Accepted findings of a scene for some columns and what it asks of them, and of the oracle.
fn accepted(scene: &Scene, columns: &[Configuration]) -> Accepted {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/validation/baselines");
    let path = format!("{folder}/{}.csv", scene.name);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let mut baseline = gate::read(&text).unwrap_or_else(|e| panic!("{path}: {e}"));
    let planned = check::plan(crate::support::roster(), scene, columns).unwrap();
    let labels: Vec<String> = planned.iter().map(Configuration::label).collect();
    let rows = &mut baseline.rows;
    rows.retain(|row| row.engine == ORACLE || labels.contains(&row.engine));
    // bits of columns that do not run would be those of engines that are no more
    baseline.bits.retain(|(label, _)| labels.contains(label));
    for label in labels {
        let known = rows.iter().any(|row| row.engine == label);
        assert!(known, "{path} says nothing of {label}");
    }
    baseline
}

/// Runs scenes in columns and holds them against what is accepted; `random`: so many of the gate's random scenes, whose counts are not held.
pub fn hold(scenes: &[Scene], columns: &[Configuration], random: u64) -> Held {
    let baselines = scenes.iter().map(|scene| Some(accepted(scene, columns)));
    let baselines = baselines.collect();
    Held::new(study(scenes, columns, random), baselines, Vec::new())
}

/// What is not as accepted; empty exactly when the decision is that everything is.
pub fn caught(held: &Held) -> Caught {
    assert!(held.stale.is_empty(), "other scenes: {:?}", held.stale);
    let mut caught = Caught::new();
    let mut note = |level: Level, words: String| {
        caught.entry(level).or_insert((0, words)).0 += 1;
    };
    for broken in &held.outcome.broken {
        let words = format!("{}: {}: {}", broken.scene, broken.what, broken.why);
        note(broken.level, words);
    }
    for Located { scene, change } in &held.changes {
        let Some(row) = change.row() else { continue };
        let level = check::level(&row.check);
        // a broken promise is told above, with its reason
        if level != Level::Promise || row.verdict != Some(Verdict::Breaks) {
            note(level, words(scene, change, row));
        }
    }
    let met = held.standing().decision() == Decision::Met;
    assert_eq!(caught.is_empty(), met, "{:?}", held.standing());
    caught
}

/// `slide: final-position cue moved, 0.0103 to 14.2`.
fn words(scene: &str, change: &Change, row: &Row) -> String {
    let said = |row: &Option<Row>| {
        let value = || row.as_ref()?.value.map(|x| format!("{x:.3e}"));
        let verdict = row.as_ref().and_then(|row| row.verdict);
        verdict.map_or_else(
            || value().unwrap_or("none".to_owned()),
            |v| v.id().to_owned(),
        )
    };
    let subject = [row.check.as_str(), row.subject.as_str()].join(" ");
    let named = format!("{scene}: {} {}", subject.trim_end(), change.kind.id());
    match change.kind {
        Kind::Worse | Kind::Better | Kind::Moved => {
            format!("{named}, {} to {}", said(&change.old), said(&change.new))
        }
        Kind::Appeared | Kind::Vanished => named,
    }
}
