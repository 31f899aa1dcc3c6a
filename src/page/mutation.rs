//! The document of mutated inputs.

use crate::finding::{Block, Cell, Column, Document, Table, Tone};
use crate::study::Extent;
use crate::study::mutation::{MutationOutcome, Reader};

/// Faults that are shown; the rest is counted.
const SHOWN: usize = 40;

/// What the terminal shows.
pub fn summary(outcome: &MutationOutcome) -> Document {
    let plan = &outcome.plan;
    let done = outcome.done();
    // no index is beyond the largest number
    let planned = plan.first.saturating_add(plan.inputs) - plan.first;
    let lead = match outcome.faults {
        0 => format!("{done} mutated inputs were read or refused as they should be."),
        n => format!("{n} faults in {done} mutated inputs."),
    };
    let mut blocks = Vec::new();
    blocks.push(Block::Table(counts(outcome)));
    if outcome.faults > 0 {
        blocks.push(Block::Table(faults(outcome)));
    }
    blocks.push(Block::Text(format!(
        "Inputs {} to {} of seed {}. Held: no panic; every error has a place and words; what is accepted holds finite numbers, and is \
         written as text that reads back as the same.",
        plan.first,
        plan.indices().end.saturating_sub(1).max(plan.first),
        plan.seed
    )));
    Document {
        id: "mutated-inputs".to_owned(),
        stopped_early: Extent::of(done, planned).stopped_early("inputs were read"),
        title: "Mutated inputs".to_owned(),
        lead,
        blocks,
        pages: Vec::new(),
    }
}

fn counts(outcome: &MutationOutcome) -> Table {
    let row = |(reader, [accepted, refused]): (Reader, &[u64; 2])| {
        vec![
            Cell::text(reader.words()),
            Cell::Count(*accepted),
            Cell::Count(*refused),
        ]
    };
    Table {
        id: "readers".to_owned(),
        title: String::new(),
        columns: vec![
            Column::words("inputs", "inputs"),
            Column::number("accepted", "accepted", ""),
            Column::number("refused", "refused", ""),
        ],
        rows: Reader::ALL
            .into_iter()
            .zip(&outcome.counts)
            .map(row)
            .collect(),
        note: String::new(),
    }
}

fn faults(outcome: &MutationOutcome) -> Table {
    let hidden = outcome.faults.saturating_sub(SHOWN as u64);
    let rows = outcome.failures.iter().take(SHOWN).map(|failure| {
        vec![
            Cell::Count(failure.input),
            Cell::text(failure.reader.words()),
            Cell::verdict(Tone::Bad, failure.fault.what),
            Cell::text(&failure.fault.words),
        ]
    });
    Table {
        id: "faults".to_owned(),
        title: "Faults".to_owned(),
        columns: vec![
            Column::number("input", "input", ""),
            Column::words("reader", "reader"),
            Column::words("what", "what"),
            Column::words("words", "how"),
        ],
        rows: rows.collect(),
        note: if hidden > 0 {
            format!("and {hidden} more")
        } else {
            String::new()
        },
    }
}
