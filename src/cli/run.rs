//! `carom run`.

use super::arguments::RunArguments;
use super::{Failure, bounds, output, scene, terminal};
use crate::engine::{self, Limits, Roster, Setting};
use crate::finding::{Block, Cell, Column, Document, Table};
use crate::scene::Scene;
use crate::trace::{Ending, Record, Trace, files};
use crate::words::{describe_ending, describe_scene};
use std::process::ExitCode;

/// Runs one scene in one engine, writes the trace and prints where the balls ended.
pub fn run(arguments: &RunArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    let scene = scene::resolve(&arguments.scene)?;
    let refused = |refusal: engine::Refusal| {
        Failure::Message(format!("{} in {}: {refusal}", scene.name, arguments.engine))
    };
    let setting = Setting::parse(arguments.settings.iter().map(String::as_str)).map_err(refused)?;
    let named = roster.named(&arguments.engine);
    let engine = named.map_err(|unknown| Failure::Message(unknown.to_string()))?;
    let cadence = bounds::cadence(arguments.every, engine.as_ref(), &scene, &setting)?;
    let run = engine::prepare(engine.as_ref(), &scene, &setting).map_err(refused)?;
    let limits = Limits {
        max_events: bounds::events(arguments.max_events)?,
        cancelled: terminal::cancelled(),
    };
    let trace = run.simulate(Record::Every(cadence), &limits);
    let written = files::write(&trace).map_err(|error| Failure::Message(error.to_string()))?;
    output::write_files(&arguments.out, written.named())?;
    let document = summary(&trace, &scene);
    let printed = terminal::show(&document, &arguments.format);
    terminal::say(&format!("Trace: {}", arguments.out.display()));
    printed
}

fn summary(trace: &Trace, scene: &Scene) -> Document {
    let (length, time) = (&scene.units.length, &scene.units.time);
    let stopped_early = (trace.ending == Ending::Cancelled).then(|| {
        format!(
            "This was stopped early: at {:.7} {time} of {}, and what follows is the run so far.",
            trace.end_time, scene.duration
        )
    });
    let columns = vec![
        Column::words("ball", "ball"),
        Column::number("stop-time", "stopped at", time),
        Column::number("x", "x", length),
        Column::number("y", "y", length),
    ];
    let states = trace.final_states();
    let rows = trace.balls.iter().enumerate().map(|(i, id)| {
        vec![
            Cell::text(id.clone()),
            trace.stop_times[i].map_or(Cell::Empty, |t| Cell::Fixed(t, 6)),
            states[i].map_or(Cell::Empty, |s| Cell::Fixed(s.position.x, 6)),
            states[i].map_or(Cell::Empty, |s| Cell::Fixed(s.position.y, 6)),
        ]
    });
    let work: Vec<String> = trace
        .counters
        .iter()
        .map(|(name, count)| format!("{name} {count}"))
        .collect();
    let table = Table {
        id: "final".to_owned(),
        title: String::new(),
        columns,
        rows: rows.collect(),
        note: work.join(", "),
    };
    let mut blocks = vec![Block::Text(describe_scene(scene))];
    blocks.extend(taken_as_rolling(scene).map(Block::Text));
    blocks.push(Block::Table(table));
    Document {
        stopped_early,
        id: "run".to_owned(),
        title: format!("{} in {}", trace.provenance.scene, trace.provenance.engine),
        lead: format!("{}; {} events.", describe_ending(trace), trace.events.len()),
        blocks,
        pages: Vec::new(),
    }
}

/// Which balls start rolling though their numbers leave a slip; `None` where none does.
fn taken_as_rolling(scene: &Scene) -> Option<String> {
    let starts = scene.balls.iter().enumerate();
    let taken = starts.filter(|(i, ball)| scene.start(*i) != ball.state);
    let ids: Vec<&str> = taken.map(|(_, ball)| ball.id.as_str()).collect();
    (!ids.is_empty()).then(|| {
        format!(
            "Taken as rolling at the start, by the six digits of the spin: {}.",
            ids.join(", ")
        )
    })
}
