//! The validation report as a document: every scene of a set compared, the report's claims audited, one first screen.

use super::{claims, compare, cost, curves, ensemble};
use crate::engine::{Engine, Roster};
use crate::finding::{
    Axis, Block, Cell, Column as TableColumn, Document, Figure, Series, Style, Table, Tone,
};
use crate::math::worse;
use crate::oracle::{self, Lack};
use crate::study::Configuration;
use crate::study::compare::{Cause, ComparisonEntry, ComparisonOutcome, PairOutcome};
use crate::study::cost::PriceList;
use crate::study::ensemble::Surroundings;
use crate::study::validation::ValidationOutcome;
use crate::words::describe_order;
use std::sync::Arc;

/// Final positions closer to the exact ones than this, in R, are marked as good: a hundredth of a ball's radius.
const GOOD_WITHIN: f64 = 1e-2;

/// The report. `prices`: what earlier studies of cost left. A report that was stopped concludes from the scenes that were compared to the end, and says so.
pub fn page(roster: &Roster, outcome: &ValidationOutcome, prices: &[PriceList]) -> Document {
    let outcomes: Vec<&ComparisonOutcome> = outcome.compared.iter().map(|(o, _)| o).collect();
    let claims = outcome.claims.as_deref().unwrap_or_default();
    let mut blocks = vec![Block::Table(scene_table(&outcomes))];
    if !claims.is_empty() {
        blocks.push(Block::Heading("What the report got wrong".to_owned()));
        blocks.push(Block::List(
            claims
                .iter()
                .take(5)
                .map(|claim| claim.found.clone())
                .collect(),
        ));
    }
    blocks.push(Block::Heading("What accuracy costs".to_owned()));
    blocks.push(Block::Figure(cost_figure(&outcomes)));
    blocks.extend(cost::listing(&outcome.scenes, prices));
    blocks.push(Block::Heading("Engines, and who shares what".to_owned()));
    blocks.push(Block::Table(engine_table(engines_of(
        roster,
        &outcome.columns,
    ))));
    blocks.push(Block::Heading("How to reproduce every number".to_owned()));
    blocks.push(Block::Command("carom report".to_owned()));
    blocks.push(Block::Text(format!(
        "carom {}. Every run is deterministic: the same build gives the same bits, times excepted. One scene alone: carom \
         compare SCENE. Raw traces: carom run SCENE --engine ID --out DIR.",
        env!("CARGO_PKG_VERSION")
    )));
    let mut pages: Vec<Document> = outcome.compared.iter().map(compared).collect();
    if !claims.is_empty() {
        pages.push(claims::page(claims));
    }
    pages.extend(outcome.laws.as_ref().map(|laws| Document {
        id: "laws".to_owned(),
        ..curves::page(laws)
    }));
    Document {
        id: "index".to_owned(),
        stopped_early: stopped_early(outcome),
        title: "carom validation report".to_owned(),
        lead: first_sentence(&outcomes, &outcome.columns),
        blocks,
        pages,
    }
}

/// One scene, with the ensemble around it.
fn compared((outcome, surroundings): &(ComparisonOutcome, Option<Surroundings>)) -> Document {
    let mut page = compare::page(outcome);
    if let Some(found) = surroundings {
        ensemble::surround(&mut page, ensemble::surroundings(outcome, found));
    }
    page
}

fn stopped_early(outcome: &ValidationOutcome) -> Option<String> {
    let scenes = outcome.extent.stopped_early("scenes were compared");
    scenes.or_else(|| {
        let what = "pages about claims and laws were made, after every scene was compared";
        outcome.rest.stopped_early(what)
    })
}

/// The engines whose agreement the first sentence tells of: at their defaults, the first that steps, and the first after it that has
/// nothing in common with it.
fn rivals(columns: &[Configuration]) -> Option<[&Configuration; 2]> {
    let stepping =
        |column: &&Configuration| !column.engine.solves() && column.setting.values.is_empty();
    let mut stepping = columns.iter().filter(stepping);
    let first = stepping.next()?;
    let other = stepping.find(|other| other.engine.family() != first.engine.family())?;
    Some([first, other])
}

/// "In n of m scenes the report's model and rapier agree ...; they part in ... because ...".
///
/// They agree where both have the same collisions in the same order.
fn first_sentence(outcomes: &[&ComparisonOutcome], columns: &[Configuration]) -> String {
    let Some(rivals) = rivals(columns) else {
        return "No two engines that step were compared.".to_owned();
    };
    let [model, rival] = rivals.map(|column| column.engine.about().name);
    let pairs: Vec<(&ComparisonOutcome, &PairOutcome)> = outcomes
        .iter()
        .filter_map(|o| Some((*o, pair_of(o, rivals)?)))
        .collect();
    if pairs.is_empty() {
        return capitalised(format!("{model} and {rival} were not compared."));
    }
    let (same, other): (Vec<_>, Vec<_>) = pairs
        .iter()
        .partition(|(_, pair)| pair.standing.order.parting.is_none());
    let farthest = same
        .iter()
        .filter_map(|(_, pair)| pair.standing.final_position)
        .reduce(worse);
    let apart = farthest.map_or(String::new(), |r| {
        format!(", with final positions up to {r:.1} R apart")
    });
    let mut sentence = format!(
        "In {} of {} scenes {model} and {rival} have the same collisions in the same order{apart}",
        same.len(),
        pairs.len()
    );
    if !other.is_empty() {
        let mut reasons: Vec<(String, usize)> = Vec::new();
        for (outcome, _) in &other {
            let reason = reason(outcome, rivals);
            match reasons.iter_mut().find(|(known, _)| *known == reason) {
                Some((_, count)) => *count += 1,
                None => reasons.push((reason, 1)),
            }
        }
        let reasons: Vec<String> = reasons
            .into_iter()
            .map(|(reason, count)| format!("{reason} ({count})"))
            .collect();
        sentence += &format!(
            "; in the other {} they part: {}",
            other.len(),
            reasons.join(", ")
        );
    }
    sentence + "."
}

fn capitalised(sentence: String) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// Why two engines part in a scene: what moved the first of them to leave the exact solution.
fn reason(outcome: &ComparisonOutcome, rivals: [&Configuration; 2]) -> String {
    if let Some((lack, _)) = &outcome.no_reference {
        let solver = oracle::engine().id();
        return match lack {
            Lack::NotUnique(_) => "simultaneous hits leave no single right answer".to_owned(),
            Lack::StoppedAt(time) => format!("{solver} stopped at t = {time:.4} s"),
            Lack::Refused => format!("{solver} refuses the scene"),
            Lack::NotAsked => format!("{solver} was not asked"),
        };
    }
    let labels = rivals.map(Configuration::label);
    let own = outcome.entries.iter();
    let own = own.filter(|entry| labels.contains(&entry.label()));
    let parted = own
        .filter_map(|e| e.standing.as_ref())
        .filter_map(|s| Some((s.order.parting.as_ref()?.time(), s)));
    let first = parted.min_by(|a, b| a.0.total_cmp(&b.0));
    match first.and_then(|(_, standing)| standing.cause.as_ref()) {
        Some(
            Cause::Resolution { .. }
            | Cause::Contact {
                interval: Some(_), ..
            },
        ) => "hits fall closer together than a step resolves".to_owned(),
        Some(Cause::Setting { what, .. }) => format!("{what} decides a hit"),
        Some(Cause::Contact { .. }) => "a contact that lasts takes hits in steps".to_owned(),
        Some(Cause::Open { .. }) | None => "no single setting explains it".to_owned(),
    }
}

/// One engine against the other.
fn pair_of<'a>(
    outcome: &'a ComparisonOutcome,
    rivals: [&Configuration; 2],
) -> Option<&'a PairOutcome> {
    let labels = rivals.map(Configuration::label);
    outcome.pairs.iter().find(|pair| {
        let label = |i: usize| outcome.entries[i].label();
        [label(pair.entries.0), label(pair.entries.1)] == labels
    })
}

/// One row a scene: what each engine did, its worst number, a picture, a link.
fn scene_table(outcomes: &[&ComparisonOutcome]) -> Table {
    let mut labels: Vec<String> = Vec::new();
    for entry in outcomes.iter().flat_map(|outcome| &outcome.entries) {
        if !labels.contains(&entry.label()) {
            labels.push(entry.label());
        }
    }
    let mut columns = vec![
        TableColumn::words("scene", "scene"),
        TableColumn::words("picture", "paths"),
    ];
    columns.extend(
        labels
            .iter()
            .map(|label| TableColumn::words(&label.replace([' ', '='], "-"), label)),
    );
    let mut rows = Vec::new();
    for outcome in outcomes {
        let name = &outcome.scene.name;
        let mut row = vec![
            Cell::Page(name.clone(), name.clone()),
            compare::thumbnail(outcome),
        ];
        for label in &labels {
            row.push(
                outcome
                    .entries
                    .iter()
                    .find(|e| e.label() == *label)
                    .map_or(Cell::Empty, |entry| verdict(outcome, entry)),
            );
        }
        rows.push(row);
    }
    let note = "n/m, x R: the first n of the m exact collisions come in the exact order, and no final position is farther than \
                x R from the exact one (where the exact one has a horizon: no position before it and before the orders part). \
                Without an exact answer a cell says how the run ended.";
    Table {
        id: "scenes".to_owned(),
        title: "Scenes".to_owned(),
        columns,
        rows,
        note: note.to_owned(),
    }
}

fn verdict(outcome: &ComparisonOutcome, entry: &ComparisonEntry) -> Cell {
    let trace = match &entry.cell {
        Ok(ran) => &ran.trace,
        Err(refusal) => return Cell::Verdict(Tone::Quiet, refusal.to_string()),
    };
    let reference = outcome.reference.map(|i| &outcome.entries[i]);
    if reference.is_some_and(|reference| std::ptr::eq(reference, entry)) {
        let collisions = format!("{} collisions", trace.collisions().count());
        return Cell::text(match &outcome.horizon {
            Some(horizon) if !horizon.is_whole() => {
                format!("{collisions}, horizon at {:.4} s", horizon.until)
            }
            _ => collisions,
        });
    }
    let Some(standing) = &entry.standing else {
        return Cell::Verdict(Tone::Quiet, trace.ending.id().to_owned());
    };
    // beyond the horizon nobody is right
    let whole = outcome.certain_until().is_infinite();
    let (error, place) = match whole {
        true => (standing.final_position, ""),
        false => {
            let before = outcome.worst(&entry.label(), "until-parting");
            (before.map(|(value, _)| value), " before the horizon")
        }
    };
    let ends = error.map_or(String::new(), |r| format!("{} R{place}", short(r)));
    let tone = match (&standing.order.parting, error) {
        (Some(_), _) => Tone::Bad,
        (None, Some(r)) if r <= GOOD_WITHIN => Tone::Good,
        (None, _) => Tone::Notice,
    };
    let words = match standing.order.reference_collisions {
        0 => ends,
        _ => format!(
            "{}, {ends}",
            describe_order(&standing.order, standing.order.strict)
        ),
    };
    Cell::Verdict(tone, words)
}

/// Two significant digits.
fn short(x: f64) -> String {
    if (1e-3..1e3).contains(&x) {
        let digits = (1 - x.log10().floor() as i32).max(0) as usize;
        format!("{x:.digits$}")
    } else {
        format!("{x:.1e}")
    }
}

/// Error against time, one point a scene and engine.
fn cost_figure(outcomes: &[&ComparisonOutcome]) -> Figure {
    let mut series: Vec<Series> = Vec::new();
    for outcome in outcomes {
        for entry in &outcome.entries {
            let Some(standing) = &entry.standing else {
                continue;
            };
            let seconds = entry.cell.as_ref().ok().and_then(|ran| ran.seconds);
            let Some((error, seconds)) = standing.final_position.zip(seconds) else {
                continue;
            };
            let point = [error, seconds * 1e6];
            match series.iter_mut().find(|s| s.name == entry.label()) {
                Some(known) => known.points.push(point),
                None => series.push(Series {
                    name: entry.label(),
                    points: vec![point],
                    style: Style::Points,
                }),
            }
        }
    }
    let exact = outcomes.iter().filter_map(|outcome| {
        let ran = outcome.entries[outcome.reference?].cell.as_ref().ok()?;
        Some(ran.seconds? * 1e6)
    });
    let slowest = exact.fold(0.0, f64::max);
    Figure {
        id: "cost".to_owned(),
        title: "Error of the final positions against time per shot".to_owned(),
        caption: format!(
            "One point a scene. Left is better, low is faster. The exact engine, against which errors are measured, took at \
             most {slowest:.0} us for any of these shots."
        ),
        x: Axis::log("largest error of a final position", "R"),
        y: Axis::log("time per shot", "us"),
        equal_scale: false,
        outline: None,
        series,
        marks: Vec::new(),
    }
}

/// The engines of some columns, each once.
fn engines_of<'a>(
    roster: &'a Roster,
    columns: &'a [Configuration],
) -> impl Iterator<Item = &'a Arc<dyn Engine>> {
    roster.iter().filter(|engine| {
        columns
            .iter()
            .any(|column| column.engine.id() == engine.id())
    })
}

/// Versions, methods, and code that engines share.
pub fn engine_table<'a>(engines: impl Iterator<Item = &'a Arc<dyn Engine>>) -> Table {
    let heads = vec![
        TableColumn::words("engine", "engine"),
        TableColumn::words("version", "version"),
        TableColumn::words("method", "method"),
        TableColumn::words("shares", "shares"),
    ];
    let rows = engines.map(|engine| {
        let about = engine.about();
        vec![
            Cell::text(engine.id()),
            Cell::text(engine.version()),
            Cell::text(about.method.into_owned()),
            Cell::text(about.shares.into_owned()),
        ]
    });
    let note = "What two engines share cannot be tested by comparing them.";
    Table {
        id: "engines".to_owned(),
        title: String::new(),
        columns: heads,
        rows: rows.collect(),
        note: note.to_owned(),
    }
}
