//! `carom stability`.

use super::accepted::{self, AcceptedPlace, Use};
use super::arguments::{StabilityArguments, parse_engines};
use super::exit::Exit;
use super::{Failure, publish, terminal, versions};
use crate::engine::Roster;
use crate::finding::{Block, Document};
use crate::gate::{self, Accepted, Decision, Located, Row, Standing};
use crate::page::stability::{page, summary};
use crate::scene::{Scene, SetName, catalogue};
use crate::study::Watch;
use crate::study::stability::{Question, Reach, StabilityOutcome, presets, study};
use std::process::ExitCode;

/// What is done with accepted findings.
const HARD: Use = Use {
    command: "carom stability",
    option: "--accepted",
    built_in: "hard",
};

/// Runs the hard cases, holds them against what was accepted, or accepts them.
pub fn stability(arguments: &StabilityArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    let reason = accepted::reason(arguments.reason.as_deref())?;
    let question = question(arguments, roster)?;
    let place = AcceptedPlace::new(&HARD, arguments.accepted.as_deref(), arguments.accept)?;
    // a file that cannot be read is said before anything runs
    let before = place.read(&names(&question.scenes))?;
    let unread = if arguments.scenes.is_empty() {
        // whether it runs or is left to --full
        place.unread(&names(&catalogue::set(SetName::Hard)?))
    } else {
        Vec::new()
    };
    let progress = terminal::Progress::new();
    let show = |done: usize, total: usize, what: &str| progress.show(done, total, what);
    let watch = Watch {
        progress: &show,
        cancelled: terminal::cancelled(),
    };
    let outcome = study(question, watch);
    drop(progress);
    let outcome = outcome.map_err(|error| Failure::Message(error.to_string()))?;
    let held = Held::new(outcome, before, unread, arguments, place);
    let printed = publish(
        &held.document(summary, accepted::MOST_CHANGES),
        &arguments.format,
        || held.document(page, usize::MAX),
        arguments.out.as_deref(),
    )?;
    if accepted::was_stopped(printed, reason.as_deref()) {
        return Ok(printed);
    }
    match reason {
        Some(reason) => held.accept(&reason),
        None => held.decide(printed, arguments),
    }
}

fn question(arguments: &StabilityArguments, roster: &Roster) -> Result<Question, Failure> {
    let presets = match &arguments.engines {
        Some(list) => parse_engines(roster, list)?,
        None => presets(roster),
    };
    Ok(Question {
        roster: roster.clone(),
        scenes: scenes(arguments)?,
        presets,
        full: arguments.full,
        pictures: arguments.out.is_some(),
    })
}

/// The scenes that were named, or the set `hard`, without those that take long unless `--full` is given.
fn scenes(arguments: &StabilityArguments) -> Result<Vec<Scene>, Failure> {
    if !arguments.scenes.is_empty() {
        return accepted::named(&arguments.scenes);
    }
    let mut scenes = catalogue::set(SetName::Hard)?;
    if !arguments.full {
        scenes.retain(|scene| !scene.is_in(SetName::Full));
    }
    Ok(scenes)
}

fn names(scenes: &[Scene]) -> Vec<String> {
    scenes.iter().map(|scene| scene.name.clone()).collect()
}

/// Writes a document of a matrix; the function says whether a cell of a scene differs from what was accepted.
type Writer = fn(&StabilityOutcome, &dyn Fn(usize, &str) -> bool) -> Document;

/// A matrix held against what was accepted.
struct Held<'a> {
    outcome: StabilityOutcome,
    /// By scene; `None` where nothing was accepted.
    accepted: Vec<Option<Accepted>>,
    /// What differs, in the scenes of which something was accepted.
    changes: Vec<Located>,
    /// Scenes that are not what they were when their findings were accepted.
    stale: Vec<String>,
    /// Accepted files that no scene reads.
    unread: Vec<String>,
    /// What an accepted file says of itself that is not so: scene and sentence.
    contradictions: Vec<(String, String)>,
    /// Findings of runs that only `--full` does, of which nothing was accepted.
    new: usize,
    /// Accepted findings that are not held, because only `--full` makes their runs.
    left_out: usize,
    place: AcceptedPlace<'a>,
}

impl<'a> Held<'a> {
    fn new(
        outcome: StabilityOutcome,
        accepted: Vec<Option<Accepted>>,
        unread: Vec<String>,
        arguments: &StabilityArguments,
        place: AcceptedPlace<'a>,
    ) -> Self {
        let mut held = Held {
            outcome,
            accepted,
            changes: Vec::new(),
            stale: Vec::new(),
            unread,
            contradictions: Vec::new(),
            new: 0,
            left_out: 0,
            place,
        };
        // what was stopped has no findings, and that is no change
        if held.outcome.is_cut_short() {
            return held;
        }
        for index in 0..held.outcome.question.scenes.len() {
            held.hold(index, arguments.engines.is_some());
        }
        held
    }

    /// Holds one scene. `some`: whether engines were named, so that those that were not are not missed.
    fn hold(&mut self, index: usize, some: bool) {
        let Some(accepted) = &self.accepted[index] else {
            return;
        };
        let name = &self.outcome.question.scenes[index].name;
        let found = gate::hold_cases(&self.outcome, index, accepted, some);
        if found.stale {
            self.stale.push(name.clone());
        }
        let said = found.contradictions.into_iter();
        self.contradictions
            .extend(said.map(|words| (name.clone(), words)));
        self.new += found.new;
        self.left_out += found.left_out;
        self.changes
            .extend(found.changes.into_iter().map(|change| Located {
                scene: name.clone(),
                change,
            }));
    }

    /// Names of scenes of which nothing was accepted.
    fn unknown(&self) -> Vec<&str> {
        let scenes = self.outcome.question.scenes.iter().zip(&self.accepted);
        scenes
            .filter(|(_, accepted)| accepted.is_none())
            .map(|(scene, _)| scene.name.as_str())
            .collect()
    }

    /// A document with what differs in it, after its opening.
    fn document(&self, write: Writer, most: usize) -> Document {
        let changed = |scene: usize, engine: &str| {
            let name = &self.outcome.question.scenes[scene].name;
            self.changes.iter().any(|located| {
                located.scene == *name
                    && located.change.row().is_some_and(|row| row.engine == engine)
            })
        };
        let mut document = write(&self.outcome, &changed);
        let mut opening = vec![Block::Text(self.sentence())];
        if !self.changes.is_empty() {
            opening.push(Block::Table(gate::changes_table(&self.changes, most)));
        }
        document.blocks.splice(0..0, opening);
        document
    }

    /// How the findings stand to the accepted ones.
    fn sentence(&self) -> String {
        let place = self.place.words();
        if self.outcome.is_cut_short() {
            return format!("Accepted findings, {place}: not held, because not everything ran.");
        }
        let unknown = self.unknown();
        if unknown.len() == self.accepted.len() {
            return format!("Accepted findings: none {}.", self.place.within());
        }
        let mut parts = vec![
            gate::changes_sentence(&self.changes)
                .unwrap_or_else(|| "everything is as accepted".to_owned()),
        ];
        if !self.stale.is_empty() {
            parts.push(format!(
                "changed since they were accepted: {}",
                self.stale.join(", ")
            ));
        }
        parts.extend(self.contradictions.iter().map(|(_, words)| words.clone()));
        if !self.unread.is_empty() {
            parts.push(format!("read by no scene: {}", self.unread.join(", ")));
        }
        if !unknown.is_empty() {
            parts.push(format!("nothing is accepted of {}", unknown.join(", ")));
        }
        let known = self.accepted.iter().flatten();
        parts.extend(gate::versions_sentence(
            known,
            &versions::of_engines(&self.outcome.question.roster),
        ));
        if self.left_out > 0 {
            parts.push(format!(
                "{} accepted findings are not held: only --full makes their runs",
                self.left_out
            ));
        }
        if self.new > 0 {
            parts.push(format!(
                "{} findings of --full are not held: none were accepted",
                self.new
            ));
        }
        format!("Accepted findings, {place}: {}.", parts.join("; "))
    }

    /// How the run stands to what was accepted.
    fn standing(&self) -> Standing {
        Standing {
            cut_short: self.outcome.is_cut_short(),
            missing: self.unknown().len(),
            stale: self.stale.len() + self.contradictions.len() + self.unread.len(),
            changes: self.changes.len(),
            broken_promises: self.outcome.broken_promises().len(),
        }
    }

    /// Writes the files of the scenes in which something changed.
    fn accept(&self, reason: &str) -> Result<ExitCode, Failure> {
        if let Err(refused) = self.standing().acceptance() {
            return Ok(accepted::refuse(&refused));
        }
        let mut changes = Vec::new();
        for (index, scene) in self.outcome.question.scenes.iter().enumerate() {
            let contradicts = self.contradictions.iter().any(|(of, _)| *of == scene.name);
            let stale = self.stale.contains(&scene.name) || contradicts;
            let known = self.accepted[index].is_some() && !stale;
            let changed = self
                .changes
                .iter()
                .any(|located| located.scene == scene.name);
            if known && !changed && self.new == 0 {
                continue;
            }
            let now = Accepted {
                scene: scene.name.clone(),
                hash: scene.hash(),
                reason: reason.to_owned(),
                versions: versions::of_engines(&self.outcome.question.roster),
                bits: Vec::new(),
                rows: self.rows(index),
            };
            changes.push(now);
        }
        self.place.write(&changes, self.accepted.len())?;
        for file in &self.unread {
            terminal::say(&format!("No scene reads {file}: remove it."));
        }
        Ok(Exit::Finished.into())
    }

    /// What is accepted of a scene: what was found, and what was accepted before of runs that were left out.
    fn rows(&self, index: usize) -> Vec<Row> {
        let found: Vec<Row> = self.outcome.findings(index).iter().map(Row::from).collect();
        let before = self.accepted[index].iter().flat_map(|a| &a.rows);
        let left_out = |label: &str| -> Vec<Row> {
            let own = before.clone().filter(|row| row.engine == label);
            own.cloned().collect()
        };
        let mut rows = Vec::new();
        for case in self.outcome.of_scene(index) {
            let label = case.planned.column.label();
            if case.judged.is_some() {
                rows.extend(found.iter().filter(|row| row.engine == label).cloned());
            } else if case.planned.reach != Reach::Never {
                rows.extend(left_out(&label));
            }
        }
        rows
    }

    /// The exit code, and what to do about it.
    fn decide(
        &self,
        printed: ExitCode,
        arguments: &StabilityArguments,
    ) -> Result<ExitCode, Failure> {
        let standing = self.standing();
        match standing.decision() {
            Decision::Met => Ok(printed),
            Decision::NotMet => Ok(self.place.not_met()),
            Decision::Incomplete => Err(self.missing(arguments)),
        }
    }

    /// Which files are missing, and the command that makes them.
    fn missing(&self, arguments: &StabilityArguments) -> Failure {
        let unknown = self.unknown();
        let whole_set = arguments.scenes.is_empty() && unknown.len() == self.accepted.len();
        let mut scenes = String::new();
        if !whole_set {
            scenes += &format!(" {}", unknown.join(" "));
        }
        if arguments.full {
            scenes += " --full";
        }
        Failure::Message(format!(
            "nothing is accepted of {} of {} scenes {}; `{}` accepts what is found",
            unknown.len(),
            self.accepted.len(),
            self.place.within(),
            self.place.command(&scenes)
        ))
    }
}
