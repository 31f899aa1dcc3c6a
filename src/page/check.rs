//! A check as a document.

use crate::compare::METRICS;
use crate::finding::{Block, Cell, Column, Document, Table, Tolerance, Tone};
use crate::study::check::{Case, CheckOutcome, HELD, Level, State, hold};

/// How what was found of a scene, an engine and a level stands to what was accepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Against {
    /// So many findings changed.
    Changed(usize),
    /// Nothing is accepted of the scene.
    NoBaseline,
    /// Not everything ran, so nothing is held.
    NotHeld,
}

/// Says how findings of a scene, an engine and a level stand to what was accepted.
type Changed<'a> = &'a dyn Fn(&str, &str, Level) -> Against;

/// What a terminal shows: the sentence, and how each scene stands on each level.
pub fn summary(outcome: &CheckOutcome, changed: Changed<'_>) -> Document {
    Document {
        id: "check".to_owned(),
        stopped_early: outcome.stopped_early(),
        title: "Check".to_owned(),
        lead: lead(outcome),
        blocks: vec![Block::Table(scenes(outcome, changed))],
        pages: Vec::new(),
    }
}

/// The summary, every case, and the bounds.
pub fn page(outcome: &CheckOutcome, changed: Changed<'_>) -> Document {
    let mut document = summary(outcome, changed);
    document.blocks.push(Block::Table(cases(outcome, changed)));
    document.blocks.push(Block::Table(bounds()));
    document
}

fn lead(outcome: &CheckOutcome) -> String {
    let count = |state: fn(&State) -> bool| {
        let own = outcome.cases.iter().filter(|case| state(&case.state));
        own.count()
    };
    let (ran, refused) = (
        count(|s| *s == State::Ran),
        count(|s| matches!(s, State::Refused(_))),
    );
    let broken = outcome.broken.len();
    let promises = match broken {
        0 if outcome.extent.is_cut_short() => "nothing that ran breaks a promise".to_owned(),
        0 => "every promised invariant holds".to_owned(),
        1 => "1 promised invariant does not hold".to_owned(),
        more => format!("{more} promised invariants do not hold"),
    };
    let random = outcome.random.as_ref();
    let random = random.map_or(String::new(), |(count, _)| {
        format!(" and {count} random ones")
    });
    format!(
        "{} scenes{random}, {} findings; {ran} of {} cases ran, {refused} cannot be simulated; {promises}.",
        outcome.scenes.len(),
        outcome.findings.len(),
        outcome.cases.len(),
    )
}

/// One row a scene.
fn scenes(outcome: &CheckOutcome, changed: Changed<'_>) -> Table {
    let rows = outcome.names().into_iter().map(|scene| {
        let mut row = vec![Cell::text(scene)];
        row.extend(Level::ALL.map(|level| cell(outcome, scene, None, level, changed)));
        row
    });
    Table {
        id: "scenes".to_owned(),
        title: "What was held".to_owned(),
        columns: columns(&["scene"]),
        rows: rows.collect(),
        note: String::new(),
    }
}

/// One row a scene and engine.
fn cases(outcome: &CheckOutcome, changed: Changed<'_>) -> Table {
    let mut rows = Vec::new();
    for scene in outcome.names() {
        let mut engines: Vec<&str> = Vec::new();
        for case in outcome.cases.iter().filter(|c| c.scene == scene) {
            if !engines.contains(&case.engine.as_str()) {
                engines.push(&case.engine);
            }
        }
        for engine in engines {
            let mut row = vec![Cell::text(scene), Cell::text(engine)];
            let own = |level| cell(outcome, scene, Some(engine), level, changed);
            row.extend(Level::ALL.map(own));
            rows.push(row);
        }
    }
    Table {
        id: "cases".to_owned(),
        title: "Every case".to_owned(),
        columns: columns(&["scene", "engine"]),
        rows,
        note: String::new(),
    }
}

fn columns(first: &[&str]) -> Vec<Column> {
    let levels = Level::ALL.iter().map(|level| level.id());
    let all = first.iter().copied().chain(levels);
    all.map(|name| Column::words(name, name)).collect()
}

/// How a level of a scene stands, in one engine or in all.
fn cell(
    outcome: &CheckOutcome,
    scene: &str,
    engine: Option<&str>,
    level: Level,
    changed: Changed<'_>,
) -> Cell {
    let wanted = |of: &str| engine.is_none_or(|engine| engine == of);
    let cases: Vec<&Case> = outcome
        .cases
        .iter()
        .filter(|c| c.scene == scene && wanted(&c.engine) && c.level == level)
        .collect();
    let count = |state: fn(&State) -> bool| cases.iter().filter(|c| state(&c.state)).count();
    let missing = count(|s| *s == State::Missing);
    let refused = count(|s| matches!(s, State::Refused(_)));
    let broken = outcome
        .broken
        .iter()
        .filter(|b| b.level == level && b.scene == scene && wanted(&b.engine));
    let broken = broken.count();
    let stands: Vec<Against> = cases
        .iter()
        .map(|c| changed(scene, &c.engine, level))
        .collect();
    let moved: usize = stands
        .iter()
        .map(|against| match against {
            Against::Changed(moved) => *moved,
            Against::NoBaseline | Against::NotHeld => 0,
        })
        .sum();
    if cases.is_empty() {
        Cell::Empty
    } else if missing > 0 {
        Cell::verdict(Tone::Bad, format!("{missing} not run"))
    } else if broken > 0 {
        Cell::verdict(Tone::Bad, format!("{broken} broken"))
    } else if outcome.extent.is_cut_short() {
        Cell::verdict(Tone::Quiet, "ran, not held")
    } else if moved > 0 {
        Cell::verdict(Tone::Bad, format!("{moved} changed"))
    } else if stands.contains(&Against::NotHeld) {
        Cell::verdict(Tone::Notice, "not held")
    } else if stands.contains(&Against::NoBaseline) {
        Cell::verdict(Tone::Bad, "no baseline")
    } else if refused == cases.len() {
        Cell::verdict(Tone::Quiet, "refused")
    } else if refused > 0 {
        Cell::verdict(Tone::Good, format!("same, {refused} refused"))
    } else {
        Cell::verdict(Tone::Good, "same")
    }
}

/// Every metric with its level, and by how much it may move in f64 and in f32.
pub fn bounds() -> Table {
    let metrics = METRICS.iter().map(|m| (m.id, m.unit, Level::Error, m.what));
    let held = HELD.iter().map(|h| (h.id, h.unit, h.level, h.what));
    let words = |tolerance: Tolerance| match tolerance {
        Tolerance::None => "not at all".to_owned(),
        Tolerance::Absolute(bound) => format!("absolute {bound:.1e}"),
        Tolerance::Relative { part, above } => {
            format!("relative {part:.1e}, of {above} where smaller")
        }
    };
    let row = |(id, unit, level, what): (&'static str, &'static str, Level, &'static str)| {
        let own = hold(id);
        vec![
            Cell::text(id),
            Cell::text(unit),
            Cell::text(level.id()),
            Cell::text(words(own.tolerance(f64::EPSILON))),
            Cell::text(words(own.tolerance(f64::from(f32::EPSILON)))),
            Cell::text(what),
            Cell::text(own.why()),
        ]
    };
    Table {
        id: "bounds".to_owned(),
        title: "By how much each may move".to_owned(),
        columns: vec![
            Column::words("metric", "metric"),
            Column::words("unit", "unit"),
            Column::words("level", "level"),
            Column::words("f64", "in f64"),
            Column::words("f32", "in f32"),
            Column::words("what", "what it is"),
            Column::words("why", "why that much"),
        ],
        rows: metrics.chain(held).map(row).collect(),
        note: String::new(),
    }
}
