//! `carom fuzz`: random scenes and mutated inputs, and what they break.

use super::arguments::{FuzzArguments, parse_engines};
use super::exit::Exit;
use super::{Failure, bounds, output, publish, terminal};
use crate::engine::Roster;
use crate::finding::Document;
use crate::page;
use crate::study::mutation::{Examples, Input};
use crate::study::{Watch, mutation, random};
use std::process::ExitCode;

/// Scenes unless told otherwise.
const SCENES: u64 = 10_000;

/// Files of what shows a fault, by name.
type Shown = Vec<(String, Vec<u8>)>;

/// Runs random scenes or reads mutated inputs, prints what they broke, and saves what shows it.
pub fn fuzz(arguments: &FuzzArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    if let Some(index) = arguments.show {
        return terminal::print(&random::text(arguments.seed, index).unwrap_or_default());
    }
    let progress = terminal::Progress::new();
    let show = |done: usize, total: usize, what: &str| progress.show(done, total, what);
    let watch = Watch {
        progress: &show,
        cancelled: terminal::cancelled(),
    };
    let (document, shown) = match arguments.inputs {
        Some(inputs) => read(arguments, roster, inputs, watch)?,
        None => run(arguments, roster, watch)?,
    };
    drop(progress);
    let found = !shown.is_empty();
    if let Some(folder) = &arguments.save {
        let files: Vec<_> = shown
            .iter()
            .map(|(name, content)| (folder.join(name), content))
            .collect();
        output::write_at(folder, &files)?;
    }
    let printed = publish(&document, &arguments.format, || document.clone(), None)?;
    // what was stopped says so first, whatever it had found
    Ok(if found && document.stopped_early.is_none() {
        Exit::NotMet.into()
    } else {
        printed
    })
}

fn run(
    arguments: &FuzzArguments,
    roster: &Roster,
    watch: Watch<'_>,
) -> Result<(Document, Shown), Failure> {
    let plan = random::Plan {
        first: arguments.first,
        scenes: bounds::indices(
            "--scenes",
            arguments.scenes.unwrap_or(SCENES),
            arguments.first,
        )?,
        seed: arguments.seed,
        columns: parse_engines(roster, &arguments.engines)?,
        max_events: bounds::events_of_each(arguments.max_events)?,
    };
    let outcome = random::study(plan, watch);
    let file = |index: u64| {
        let name = format!("random-{}-{index}.toml", arguments.seed);
        let text = random::text(arguments.seed, index).unwrap_or_default();
        (name, text.into_bytes())
    };
    let shown = outcome.failures.iter().map(|f| file(f.scene)).collect();
    Ok((page::random::summary(&outcome), shown))
}

fn read(
    arguments: &FuzzArguments,
    roster: &Roster,
    inputs: u64,
    watch: Watch<'_>,
) -> Result<(Document, Shown), Failure> {
    let examples = Examples::new(roster).ok_or_else(|| {
        Failure::Message("there is no example to mutate: the catalogue cannot be read".to_owned())
    })?;
    let plan = mutation::Plan {
        first: arguments.first,
        inputs: bounds::indices("--inputs", inputs, arguments.first)?,
        seed: arguments.seed,
    };
    let outcome = mutation::study(plan, &examples, watch);
    let mut shown = Vec::new();
    for failure in &outcome.failures {
        let name = format!("input-{}-{}", arguments.seed, failure.input);
        match examples.input(arguments.seed, failure.input).1 {
            Input::Scene(bytes) => shown.push((format!("{name}.toml"), bytes)),
            Input::Trace(files) => shown.extend(
                files
                    .named()
                    .map(|(file, text)| (format!("{name}/{file}"), text.as_bytes().to_vec())),
            ),
            Input::Engines(list) => shown.push((format!("{name}.txt"), list.into_bytes())),
            Input::Recipe(recipe) => {
                shown.push((format!("{name}.txt"), format!("{recipe:?}").into_bytes()));
            }
        }
    }
    Ok((page::mutation::summary(&outcome), shown))
}
