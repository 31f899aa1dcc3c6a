//! Curves of the impact laws as a document.

use crate::finding::{Block, Cell, Column as TableColumn, Document, Table, Tone};
use crate::study::curves::{Curve, CurvesOutcome};

/// The curves, how far the engines are from them, and the shots of a paper.
pub fn page(outcome: &CurvesOutcome) -> Document {
    let found = &outcome.curves;
    let mut blocks: Vec<Block> = Vec::new();
    for (_, curve) in found {
        blocks.extend(curve.figures.iter().cloned().map(Block::Figure));
    }
    blocks.push(Block::Table(departure_table(found)));
    blocks.extend(outcome.shots.clone().map(Block::Table));
    let labels: Vec<String> = outcome
        .columns
        .iter()
        .map(|c| c.label().replace(' ', ":"))
        .collect();
    blocks.push(Block::Command(format!(
        "carom effects --curves --engines {}",
        labels.join(",")
    )));
    Document {
        id: "effect-curves".to_owned(),
        stopped_early: outcome
            .extent
            .stopped_early("families of curves were run in every engine"),
        title: "Throw, squirt and rebound against published curves".to_owned(),
        lead: sentence(found),
        blocks,
        pages: Vec::new(),
    }
}

/// How far the first engine with points is from each curve.
fn sentence(found: &[(&str, Curve)]) -> String {
    let parts = found.iter().filter_map(|(name, curve)| {
        let first = curve.departures.iter().find(|d| d.largest.is_some())?;
        Some(format!(
            "{name}: {} is within {:.1e} {} of the {}",
            first.who, first.largest?, first.unit, first.from
        ))
    });
    let mut text = parts.collect::<Vec<_>>().join("; ");
    if let Some(first) = text.get_mut(0..1) {
        first.make_ascii_uppercase();
    }
    if text.is_empty() { text } else { text + "." }
}

fn departure_table(found: &[(&str, Curve)]) -> Table {
    let columns = vec![
        TableColumn::words("curve", "curve"),
        TableColumn::words("who", "points of"),
        TableColumn::words("from", "held against"),
        TableColumn::number("points", "points", ""),
        TableColumn::number("largest", "largest departure", ""),
        TableColumn::words("unit", "unit"),
        TableColumn::words("missing", "missing"),
    ];
    let mut rows = Vec::new();
    for (name, curve) in found {
        for departure in &curve.departures {
            let missing = departure
                .missing
                .iter()
                .map(|(why, n)| format!("{n}: {why}"));
            let missing = missing.collect::<Vec<_>>().join("; ");
            rows.push(vec![
                Cell::text(*name),
                Cell::text(departure.who.clone()),
                Cell::text(departure.from),
                Cell::Count(departure.points as u64),
                Cell::maybe(departure.largest),
                Cell::text(departure.unit),
                if missing.is_empty() {
                    Cell::Empty
                } else {
                    Cell::verdict(Tone::Quiet, missing)
                },
            ]);
        }
    }
    Table {
        id: "departures".to_owned(),
        title: "How far from the curves".to_owned(),
        columns,
        rows,
        note: "A stepping engine sees a contact within its step, so that its impacts are off by about speed x dt.".to_owned(),
    }
}
