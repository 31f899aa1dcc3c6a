//! `carom diff`: what of two result folders is not the same.

use super::arguments::DiffArguments;
use super::exit::Exit;
use super::{Failure, output, publish, scene};
use crate::engine::Roster;
use crate::finding::{Block, Document};
use crate::gate::{self, Accepted, Located, Row};
use crate::scene::{Scene, catalogue};
use crate::study::Configuration;
use crate::study::check::{between, tolerance, unheld};
use crate::trace::{Ending, Trace, files};
use std::collections::{BTreeMap, BTreeSet};
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
pub fn diff(arguments: &DiffArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    let (first, second) = (&arguments.first, &arguments.second);
    let (lead, changes) = match (read(first)?, read(second)?) {
        (Results::Trace(a), Results::Trace(b)) => traces(arguments, &a, &b)?,
        (Results::Baselines(a), Results::Baselines(b)) => baselines(roster, &a, &b),
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
    let four = || -> Result<_, Failure> {
        if !folder.join(files::RUN).exists() {
            return Ok(None);
        }
        Ok(Some(files::Files {
            events: text(files::EVENTS)?,
            samples: text(files::SAMPLES)?,
            final_states: text(files::FINAL)?,
            run: text(files::RUN)?,
        }))
    };
    if let Some(four) = output::undisturbed(folder, four)?? {
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
    let found = output::undisturbed(folder, || baselines_in(folder))??;
    if found.is_empty() {
        let why = "it holds neither the files of `carom run` nor baselines of `carom check`";
        return Err(cannot_read(folder, &why));
    }
    Ok(Results::Baselines(found))
}

/// The baselines in a folder.
fn baselines_in(folder: &Path) -> Result<BTreeMap<String, Accepted>, Failure> {
    let entries = fs::read_dir(folder).map_err(|error| cannot_read(folder, &error))?;
    let mut found = BTreeMap::new();
    for entry in entries.flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|extension| extension != "csv") {
            continue;
        }
        let text = fs::read_to_string(&path).map_err(|error| cannot_read(&path, &error))?;
        let accepted = gate::read(&text).map_err(|error| cannot_read(&path, &error))?;
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        if stem != accepted.scene {
            let why = format!("it says that it is of the scene {}", accepted.scene);
            return Err(cannot_read(&path, &why));
        }
        found.insert(accepted.scene.clone(), accepted);
    }
    Ok(found)
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
    let ulp = (a.provenance.rounding()).max(b.provenance.rounding());
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
    if let Some(words) = unheld(&scene, b, a, ulp) {
        lead += &format!(" {words}");
    }
    Ok((lead, located(&scene.name, changes)))
}

/// The scene of both runs: the one that was named, or that of the catalogue.
fn scene_of(arguments: &DiffArguments, a: &Trace, b: &Trace) -> Result<Scene, Failure> {
    let (ours, theirs) = (&a.provenance, &b.provenance);
    if (&ours.scene_hash, &ours.scene) != (&theirs.scene_hash, &theirs.scene) {
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
    for trace in [a, b] {
        let balls = scene.balls.iter().map(|ball| &ball.id);
        if !trace.balls.iter().eq(balls) {
            return Err(Failure::Message(format!(
                "the balls of {} of {} are not those of the scene, in its order",
                files::FINAL,
                name(trace)
            )));
        }
    }
    Ok(scene)
}

fn baselines(
    roster: &Roster,
    a: &BTreeMap<String, Accepted>,
    b: &BTreeMap<String, Accepted>,
) -> (String, Vec<Located>) {
    // a table names the scalar only in the label of its engine
    let ulp = |label: &str| {
        let column = Configuration::list(roster, &label.replace(' ', ":"));
        let columns = column.unwrap_or_default();
        let ulps = columns
            .iter()
            .map(|column| column.engine.ulp(&column.setting));
        ulps.fold(f64::EPSILON, f64::max)
    };
    let names: BTreeSet<&String> = a.keys().chain(b.keys()).collect();
    let mut changes = Vec::new();
    let (mut bits, mut reasons) = (0, 0);
    let mut versions: BTreeSet<String> = BTreeSet::new();
    for &name in &names {
        let rows = |of: &BTreeMap<String, Accepted>| of.get(name).map_or(Vec::new(), rows_of);
        let own = gate::diff(&rows(a), &rows(b), |row| {
            tolerance(&row.check, ulp(&row.engine))
        });
        let digests = |of: &BTreeMap<String, Accepted>| of.get(name).map(|one| one.bits.clone());
        bits += usize::from(digests(a) != digests(b));
        let reason = |of: &BTreeMap<String, Accepted>| of.get(name).map(|one| one.reason.clone());
        reasons += usize::from(reason(a) != reason(b));
        if let (Some(before), Some(now)) = (a.get(name), b.get(name)) {
            versions.extend(gate::other_versions(before, &now.versions));
        }
        changes.extend(located(name, own));
    }
    let mut lead = format!(
        "{} scenes; in {bits} of them a run has other bits, in {reasons} the reason is another.",
        names.len()
    );
    if !versions.is_empty() {
        let told: Vec<String> = versions.into_iter().collect();
        lead += &format!(" Of other versions: {}.", told.join(", "));
    }
    (lead, changes)
}

/// The findings of a file, and its fingerprint of the scene as one more: findings of another scene are others.
fn rows_of(accepted: &Accepted) -> Vec<Row> {
    let hash = Row {
        engine: "scene".to_owned(),
        check: "hash".to_owned(),
        subject: accepted.hash.clone(),
        value: None,
        verdict: None,
    };
    let mut rows = vec![hash];
    rows.extend(accepted.rows.iter().cloned());
    rows
}

fn located(scene: &str, changes: Vec<gate::Change>) -> Vec<Located> {
    let here = |change| Located {
        scene: scene.to_owned(),
        change,
    };
    changes.into_iter().map(here).collect()
}
