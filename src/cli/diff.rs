//! `carom diff`: what of two result folders is not the same.

use super::arguments::DiffArguments;
use super::exit::Exit;
use super::{Failure, publish, scene};
use crate::finding::{Block, Document};
use crate::gate::{self, Accepted, Located, Row};
use crate::scene::{Scene, catalogue};
use crate::study::check::{between, tolerance, ulp_of};
use crate::trace::{Ending, Trace, files};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

/// A terminal shows no more changes than this.
const MOST_CHANGES: usize = 40;

/// What a folder holds.
enum Results {
    /// The four files of `carom run`.
    Trace(Box<Trace>),
    /// Baselines of `carom check --accept`, by scene.
    Baselines(BTreeMap<String, Accepted>),
}

/// Holds the second folder against the first.
pub fn diff(arguments: &DiffArguments) -> Result<ExitCode, Failure> {
    let (first, second) = (&arguments.first, &arguments.second);
    let (lead, changes) = match (read(first)?, read(second)?) {
        (Results::Trace(a), Results::Trace(b)) => traces(arguments, &a, &b)?,
        (Results::Baselines(a), Results::Baselines(b)) => baselines(&a, &b),
        _ => {
            return Err(Failure::Message(format!(
                "{} and {} hold different kinds of results: one the files of `carom run`, the other baselines of `carom check`",
                first.display(),
                second.display()
            )));
        }
    };
    let sentence = gate::changes_sentence(&changes).unwrap_or_else(|| "nothing differs".to_owned());
    let mut blocks = vec![Block::Text(lead)];
    if !changes.is_empty() {
        blocks.push(Block::Table(gate::changes_table(&changes, MOST_CHANGES)));
    }
    let document = Document {
        stopped_early: None,
        id: "diff".to_owned(),
        title: format!("{} against {}", second.display(), first.display()),
        lead: format!("Beyond tolerance: {sentence}."),
        blocks,
        pages: Vec::new(),
    };
    let printed = publish(&document, &arguments.format, || document.clone(), None)?;
    Ok(if changes.is_empty() {
        printed
    } else {
        Exit::NotMet.into()
    })
}

fn cannot_read(path: &Path, why: &dyn std::fmt::Display) -> Failure {
    Failure::Message(format!("cannot read {}: {why}", path.display()))
}

fn read(folder: &Path) -> Result<Results, Failure> {
    let text = |name: &str| {
        let path = folder.join(name);
        fs::read_to_string(&path).map_err(|error| cannot_read(&path, &error))
    };
    if folder.join(files::RUN).exists() {
        let four = files::Files {
            events: text(files::EVENTS)?,
            samples: text(files::SAMPLES)?,
            final_states: text(files::FINAL)?,
            run: text(files::RUN)?,
        };
        let trace = files::read(&four).map_err(|error| cannot_read(folder, &error))?;
        if trace.ending == Ending::Cancelled {
            return Err(Failure::Message(format!(
                "{} holds a run that was stopped early, at {} s: it is no whole run to compare; run it again",
                folder.display(),
                trace.end_time
            )));
        }
        return Ok(Results::Trace(Box::new(trace)));
    }
    let entries = fs::read_dir(folder).map_err(|error| cannot_read(folder, &error))?;
    let mut found = BTreeMap::new();
    for entry in entries.flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|extension| extension != "csv") {
            continue;
        }
        let text = fs::read_to_string(&path).map_err(|error| cannot_read(&path, &error))?;
        let accepted = gate::read(&text).map_err(|error| cannot_read(&path, &error))?;
        found.insert(accepted.scene.clone(), accepted);
    }
    if found.is_empty() {
        let why = "it holds neither the files of `carom run` nor baselines of `carom check`";
        return Err(cannot_read(folder, &why));
    }
    Ok(Results::Baselines(found))
}

/// Engine, version and setting of a run.
fn name(trace: &Trace) -> String {
    let provenance = &trace.provenance;
    format!("{} ({})", provenance.engine, provenance.version)
}

fn traces(
    arguments: &DiffArguments,
    a: &Trace,
    b: &Trace,
) -> Result<(String, Vec<Located>), Failure> {
    let scene = scene_of(arguments, a, b)?;
    let ulp = ulp_of(a).max(ulp_of(b));
    let label = &b.provenance.engine;
    let rows = |trace: &Trace| -> Vec<Row> {
        let findings = between(&scene, label, trace, a);
        findings.iter().map(Row::from).collect()
    };
    let changes = gate::diff(&rows(a), &rows(b), |row| tolerance(&row.check, ulp));
    let mut lead = format!("{}: {} against {}.", scene.name, name(b), name(a));
    let (ours, theirs) = (&b.provenance.parameters, &a.provenance.parameters);
    let keys: Vec<&String> = ours.keys().chain(theirs.keys()).collect();
    let mut differ: Vec<String> = keys
        .into_iter()
        .filter(|key| ours.get(*key) != theirs.get(*key))
        .map(|key| {
            let word = |value: Option<&serde_json::Value>| {
                value.map_or("nothing".to_owned(), ToString::to_string)
            };
            let (is, was) = (word(ours.get(key)), word(theirs.get(key)));
            format!("{key} {is} instead of {was}")
        })
        .collect();
    differ.sort();
    differ.dedup();
    if !differ.is_empty() {
        lead += &format!(" Other settings: {}.", differ.join(", "));
    }
    Ok((lead, located(&scene.name, changes)))
}

/// The scene of both runs: the one that was named, or that of the catalogue.
fn scene_of(arguments: &DiffArguments, a: &Trace, b: &Trace) -> Result<Scene, Failure> {
    let (ours, theirs) = (&a.provenance, &b.provenance);
    if ours.scene_hash != theirs.scene_hash {
        return Err(Failure::Message(format!(
            "the two runs are of different scenes: {} ({}) and {} ({})",
            ours.scene, ours.scene_hash, theirs.scene, theirs.scene_hash
        )));
    }
    let scene = match &arguments.scene {
        Some(named) => scene::resolve(named)?,
        None => catalogue::scene(&ours.scene).map_err(|_| {
            Failure::Message(format!(
                "the catalogue has no scene {}; name its file with `--scene FILE`",
                ours.scene
            ))
        })?,
    };
    if scene.hash() != ours.scene_hash {
        return Err(Failure::Message(format!(
            "scene {} ({}) is not the one that was run ({}); name its file with `--scene FILE`",
            scene.name,
            scene.hash(),
            ours.scene_hash
        )));
    }
    Ok(scene)
}

fn baselines(
    a: &BTreeMap<String, Accepted>,
    b: &BTreeMap<String, Accepted>,
) -> (String, Vec<Located>) {
    // a table names the scalar only in the label of its engine
    let ulp = |engine: &str| {
        if engine.contains("f32") {
            f64::from(f32::EPSILON)
        } else {
            f64::EPSILON
        }
    };
    let names: std::collections::BTreeSet<&String> = a.keys().chain(b.keys()).collect();
    let mut changes = Vec::new();
    let mut bits = 0;
    for &name in &names {
        let rows = |of: &BTreeMap<String, Accepted>| {
            of.get(name).map_or(Vec::new(), |one| one.rows.clone())
        };
        let own = gate::diff(&rows(a), &rows(b), |row| {
            tolerance(&row.check, ulp(&row.engine))
        });
        let digests = |of: &BTreeMap<String, Accepted>| of.get(name).map(|one| one.bits.clone());
        bits += usize::from(digests(a) != digests(b));
        changes.extend(located(name, own));
    }
    let lead = format!(
        "{} scenes; in {bits} of them a run has other bits.",
        names.len()
    );
    (lead, changes)
}

fn located(scene: &str, changes: Vec<gate::Change>) -> Vec<Located> {
    let here = |change| Located {
        scene: scene.to_owned(),
        change,
    };
    changes.into_iter().map(here).collect()
}
