//! Random scenes in the gate: some thousand of one seed, in the engines that promise to hold in all of them.
//!
//! What must hold of every run is no matter of acceptance: a scene that breaks it is a broken promise. What became of the runs is counted,
//! and the counts are held like those of the work done: a change that makes a law lenient, or ends runs that went on, moves one.

use super::item::FUZZ;
use super::{Broken, Case, CheckOutcome, Level, State, unit_of};
use crate::finding::Finding;
use crate::study::matrix::Configuration;
use crate::study::random::{self, Failure, Plan, RandomEntry};
use sha2::{Digest, Sha256};

/// What stands for the scene where the findings of random scenes are listed, accepted and asked for.
pub const RANDOM: &str = "random-scenes";

/// Scenes of the gate: as many as cost about a quarter of its time.
pub const RANDOM_SCENES: u64 = 3000;

/// Their seed: not one that engines were mended with.
pub const RANDOM_SEED: u64 = 13;

/// Events after which a run ends: most scenes show what they have to show early.
const MAX_EVENTS: u64 = 200;

/// A column for each engine of a check that promises to hold in random scenes.
pub fn random_plan(columns: &[Configuration], scenes: u64) -> Plan {
    let mut sound: Vec<Configuration> = Vec::new();
    for column in columns {
        let engine = &column.engine;
        let presets = engine.presets().into_iter().filter(|preset| preset.sound);
        for preset in presets {
            let column = Configuration::with(engine, preset.setting);
            if sound.iter().all(|known| known.label() != column.label()) {
                sound.push(column);
            }
        }
    }
    Configuration::solvers_first(&mut sound);
    Plan {
        first: 0,
        scenes,
        seed: RANDOM_SEED,
        columns: sound,
        max_events: MAX_EVENTS,
    }
}

/// Words for a terminal: shows what became of one scene, or of all.
pub fn random_command(engine: &str, scene: Option<u64>) -> String {
    let engine = engine.replace(' ', ":");
    let scenes = match scene {
        Some(index) => format!("--first {index} --scenes 1"),
        None => format!("--scenes {RANDOM_SCENES}"),
    };
    format!("carom fuzz --seed {RANDOM_SEED} {scenes} --max-events {MAX_EVENTS} --engines {engine}")
}

/// Fingerprint of the scenes of a plan: other scenes have other counts.
pub fn random_hash(plan: &Plan) -> String {
    let mut hash = Sha256::new();
    for index in plan.indices() {
        hash.update(random::text(plan.seed, index).unwrap_or_default());
        hash.update([0]);
    }
    hash.update(plan.max_events.to_le_bytes());
    let digest = hash.finalize();
    digest.iter().take(8).map(|b| format!("{b:02x}")).collect()
}

impl CheckOutcome {
    /// Adds what random scenes showed: counts that are held, and what is broken. Scenes that did not run leave their cases missing.
    pub fn add_random(&mut self, found: &random::RandomOutcome) {
        let plan = &found.plan;
        self.random = Some((plan.scenes, random_hash(plan)));
        let labels: Vec<String> = plan.columns.iter().map(Configuration::label).collect();
        self.extent.add(found.extent());
        let ran = !found.extent().is_cut_short();
        for (label, entry) in labels.iter().zip(&found.entries) {
            self.cases.push(Case {
                scene: RANDOM.to_owned(),
                engine: label.clone(),
                level: Level::Fuzz,
                state: if ran { State::Ran } else { State::Missing },
            });
            if ran {
                self.findings.extend(counts(label, entry));
            }
        }
        self.broken.extend(broken(&labels, &found.failures));
    }
}

/// The first fault of each kind in each engine; the others of the kind are counted.
fn broken(labels: &[String], failures: &[Failure]) -> Vec<Broken> {
    let mut kinds: Vec<(&String, &Failure, usize)> = Vec::new();
    for failure in failures {
        let own = |label: &&String| {
            let tried = failure.engine.strip_prefix(label.as_str());
            tried.is_some_and(|rest| rest.is_empty() || rest.starts_with(' '))
        };
        // a scene that cannot be read is at fault in every engine
        let Some(engine) = labels.iter().find(own).or(labels.first()) else {
            continue;
        };
        let same = |(of, first, _): &&mut (&String, &Failure, usize)| {
            *of == engine && first.fault.what == failure.fault.what
        };
        match kinds.iter_mut().find(same) {
            Some((.., count)) => *count += 1,
            None => kinds.push((engine, failure, 1)),
        }
    }
    let broken = |(engine, first, count): (&String, &Failure, usize)| Broken {
        scene: RANDOM.to_owned(),
        engine: engine.clone(),
        level: Level::Fuzz,
        what: first.fault.what,
        why: format!(
            "{} ({count} of this kind); to see it: {}; scene: carom fuzz --seed {RANDOM_SEED} --show {}",
            first.fault.words,
            random_command(engine, Some(first.scene)),
            first.scene
        ),
    };
    kinds.into_iter().map(broken).collect()
}

/// How runs ended, and how much of them was held.
fn counts(engine: &str, entry: &RandomEntry) -> Vec<Finding> {
    let finding = |subject: String, count: u64| Finding {
        scene: RANDOM.to_owned(),
        engine: engine.to_owned(),
        metric: FUZZ,
        subject,
        value: Some(count as f64),
        unit: unit_of(FUZZ),
        verdict: None,
    };
    let endings = entry.endings.iter();
    let mut findings: Vec<Finding> = endings
        .map(|(id, count)| finding(format!("ended as {id}"), *count))
        .collect();
    let held = &entry.laws;
    for (what, count) in [
        ("events", entry.events),
        ("impacts held", held.impacts),
        ("impacts integrated", held.integrated),
        ("motions held", held.pieces),
        ("scenes swept", entry.swept),
    ] {
        findings.push(finding(what.to_owned(), count));
    }
    for (why, count) in &held.left_out {
        findings.push(finding(format!("left out: {why}"), *count));
    }
    findings
}
