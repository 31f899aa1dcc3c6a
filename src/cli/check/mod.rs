//! `carom check`.

mod built_from;
mod outputs;

use super::accepted::{self, AcceptedPlace, Use};
use super::arguments::CheckArguments;
use super::exit::Exit;
use super::{Failure, output, publish, terminal, versions};
use crate::engine::Roster;
use crate::finding::{Block, Document};
use crate::gate::{self, Accepted, Bits, Decision, Held};
use crate::page::check::{Against, bounds, page, summary};
use crate::report;
use crate::scene::{SetName, catalogue};
use crate::study::check::{Level, RANDOM, RANDOM_SCENES, random_plan, study};
use crate::study::compare::default_columns;
use crate::study::{Watch, random};
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

/// A job summary shows no more: its service cuts off what is long.
const MOST_IN_SUMMARY: usize = 200;

/// What is done with baselines.
const BASELINES: Use = Use {
    command: "carom check",
    option: "--baseline",
    built_in: "baselines",
};

/// Runs the scenes of the gate and holds them against their baselines, or accepts what is found.
pub fn check(arguments: &CheckArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    let reason = accepted::reason(arguments.reason.as_deref())?;
    let (random, named): (Vec<String>, Vec<String>) = arguments
        .scenes
        .iter()
        .cloned()
        .partition(|name| name == RANDOM);
    let whole = arguments.scenes.is_empty();
    let scenes = if whole {
        catalogue::set(SetName::Gate)?
    } else {
        accepted::named(&named)?
    };
    let random = whole || !random.is_empty();
    let place = AcceptedPlace::new(&BASELINES, arguments.baseline.as_deref(), arguments.accept)?;
    built_from::demand(roster, &arguments.built_from)?;
    let mut names: Vec<String> = scenes.iter().map(|scene| scene.name.clone()).collect();
    names.extend(random.then(|| RANDOM.to_owned()));
    // a file that cannot be read is said before anything runs
    let before = place.read(&names)?;
    let unread = if whole {
        place.unread(&names)
    } else {
        Vec::new()
    };
    let progress = terminal::Progress::new();
    let show = |done: usize, total: usize, what: &str| progress.show(done, total, what);
    let watch = Watch {
        progress: &show,
        cancelled: terminal::cancelled(),
    };
    let start = Instant::now();
    let columns = default_columns(roster);
    let mut outcome = study(roster, &scenes, &columns, watch)
        .map_err(|error| Failure::Message(error.to_string()))?;
    if random {
        let plan = random_plan(&columns, RANDOM_SCENES);
        outcome.add_random(&random::study(plan, watch));
    }
    let seconds = start.elapsed().as_secs_f64();
    drop(progress);
    let held = Held::new(outcome, before, unread);
    write(&held, arguments, &place)?;
    let listed = arguments.format.is_cut;
    let mut shown = document(&held, &place, summary, accepted::MOST_CHANGES, listed);
    if arguments.verbose {
        shown.blocks.push(Block::Table(bounds()));
    }
    let printed = publish(
        &shown,
        &arguments.format,
        || document(&held, &place, page, usize::MAX, false),
        arguments.out.as_deref(),
    )?;
    // wall time only advises
    terminal::say(&format!("Took {seconds:.1} s."));
    if accepted::was_stopped(printed, reason.as_deref()) {
        return Ok(printed);
    }
    match reason {
        Some(reason) => accept(&held, &place, &reason),
        None => decide(&held, printed, arguments, &place),
    }
}

/// Writes a document of a check; the function says how a scene, engine and level stands to what was accepted.
type Writer =
    fn(&crate::study::check::CheckOutcome, &dyn Fn(&str, &str, Level) -> Against) -> Document;

/// A document with the first `most` changes in it, after its opening. `listed`: as sentences, for a terminal, which is too narrow for a
/// table of them.
fn document(
    held: &Held,
    place: &AcceptedPlace<'_>,
    write: Writer,
    most: usize,
    listed: bool,
) -> Document {
    let changed = |scene: &str, engine: &str, level| held.against(scene, engine, level);
    let mut document = write(&held.outcome, &changed);
    let ran = std::mem::replace(&mut document.lead, sentence(held, place));
    let mut opening = vec![
        Block::Text(ran),
        Block::Text(built_from::sentence(&held.outcome.roster)),
    ];
    if !held.outcome.broken.is_empty() {
        let line = |b: &crate::study::check::Broken| {
            format!("{} in {}: {}: {}", b.engine, b.scene, b.what, b.why)
        };
        opening.push(Block::Text("Promises that do not hold:".to_owned()));
        opening.push(Block::List(held.outcome.broken.iter().map(line).collect()));
    }
    if listed && !held.changes.is_empty() {
        let some = held.changes.iter().take(most);
        let mut lines: Vec<String> = some.map(|l| held.sentence(&l.scene, &l.change)).collect();
        if held.changes.len() > most {
            lines.push(format!("{} more are not shown", held.changes.len() - most));
        }
        opening.push(Block::List(lines));
    } else if !held.changes.is_empty() {
        opening.push(Block::Table(gate::changes_table(&held.changes, most)));
    }
    document.blocks.splice(0..0, opening);
    document
}

/// How the findings stand to the accepted ones.
fn sentence(held: &Held, place: &AcceptedPlace<'_>) -> String {
    let held_against = place.words();
    let missing = held.outcome.missing();
    if missing > 0 {
        return format!(
            "It did not run to its end: {missing} of {} cases did not run, so nothing is held against {held_against}.",
            held.outcome.cases.len()
        );
    }
    let unknown = held.unknown();
    if unknown.len() == held.accepted.len() {
        return format!("Baselines: none {}.", place.within());
    }
    let mut parts = vec![
        gate::changes_sentence(&held.changes)
            .unwrap_or_else(|| "everything is as accepted".to_owned()),
    ];
    if !held.stale.is_empty() {
        parts.push(format!(
            "changed since they were accepted: {}",
            held.stale.join(", ")
        ));
    }
    parts.extend(held.contradictions.iter().map(|(_, words)| words.clone()));
    if !held.unread.is_empty() {
        parts.push(format!("read by no scene: {}", held.unread.join(", ")));
    }
    if !unknown.is_empty() {
        parts.push(format!("nothing is accepted of {}", unknown.join(", ")));
    }
    let Bits {
        same,
        other,
        changed,
    } = held.bits();
    let known = held.accepted.iter().flatten();
    parts.extend(gate::versions_sentence(
        known,
        &versions::with_compiler(&held.outcome.roster),
    ));
    parts.push(format!(
        "bits: {same} runs the same, {other} the same physics in different bits, {changed} others"
    ));
    format!("Baselines, {held_against}: {}.", parts.join("; "))
}

/// Files that other programs read, and what GitHub's runner is told.
fn write(
    held: &Held,
    arguments: &CheckArguments,
    place: &AcceptedPlace<'_>,
) -> Result<(), Failure> {
    if let Some(file) = &arguments.junit {
        let xml = outputs::junit(held, place).map_err(Failure::Message)?;
        output::write_file(file, xml.as_bytes())?;
    }
    let summary_file = std::env::var_os("GITHUB_STEP_SUMMARY").filter(|name| !name.is_empty());
    if arguments.markdown.is_some() || summary_file.is_some() {
        let document = document(held, place, summary, MOST_IN_SUMMARY, false);
        let text = report::render(&document, "markdown").unwrap_or_default();
        if let Some(file) = &arguments.markdown {
            output::write_file(file, text.as_bytes())?;
        }
        if let Some(file) = summary_file {
            append(Path::new(&file), &text)?;
        }
    }
    if std::env::var_os("GITHUB_ACTIONS").is_some() {
        for line in outputs::annotations(held, place) {
            terminal::say(&line);
        }
    }
    Ok(())
}

/// A job summary has other authors too.
fn append(file: &Path, text: &str) -> Result<(), Failure> {
    use std::io::Write;
    let opened = fs::OpenOptions::new().create(true).append(true).open(file);
    let written = opened.and_then(|mut file| file.write_all(text.as_bytes()));
    written
        .map_err(|error| Failure::Message(format!("cannot append to {}: {error}", file.display())))
}

/// Writes the baselines of the scenes in which something changed.
fn accept(held: &Held, place: &AcceptedPlace<'_>, reason: &str) -> Result<ExitCode, Failure> {
    if let Err(refused) = held.standing().acceptance() {
        return Ok(accepted::refuse(&refused));
    }
    let mut changes = Vec::new();
    let parts = held.outcome.parts().into_iter();
    for ((scene, hash), before) in parts.zip(&held.accepted) {
        let known = before.is_some() && !held.is_stale(&scene);
        let changed = held.changes.iter().any(|l| l.scene == scene);
        if known && !changed {
            continue;
        }
        let now = Accepted {
            hash,
            reason: reason.to_owned(),
            versions: versions::with_commit(&held.outcome.roster),
            bits: held.bits_of(&scene),
            rows: held.rows(&scene),
            scene,
        };
        changes.push(now);
    }
    place.write(&changes, held.accepted.len())?;
    for file in &held.unread {
        terminal::say(&format!("No scene reads {file}: remove it."));
    }
    Ok(Exit::Finished.into())
}

/// The exit code, and what to do about it.
fn decide(
    held: &Held,
    printed: ExitCode,
    arguments: &CheckArguments,
    place: &AcceptedPlace<'_>,
) -> Result<ExitCode, Failure> {
    let standing = held.standing();
    match standing.decision() {
        Decision::Met => Ok(printed),
        Decision::NotMet if standing.broken_promises > 0 => {
            terminal::say("A promised invariant does not hold; that is not up to acceptance.");
            Ok(Exit::NotMet.into())
        }
        Decision::NotMet => Ok(place.not_met()),
        Decision::Incomplete if standing.cut_short => Err(Failure::Message(format!(
            "it did not run to its end: {} of {} cases did not run",
            held.outcome.missing(),
            held.outcome.cases.len()
        ))),
        Decision::Incomplete => Err(Failure::Message(format!(
            "nothing is accepted of {} {}; `{}` accepts what is found",
            held.unknown().join(", "),
            place.within(),
            place.command(
                &arguments
                    .scenes
                    .iter()
                    .fold(String::new(), |all, s| all + " " + s)
            )
        ))),
    }
}
