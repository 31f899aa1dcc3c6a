//! The document of random scenes.

use crate::finding::{Block, Cell, Column, Document, Table, Tone};
use crate::law::energy::ABOVE_START;
use crate::study::random::{RandomEntry, RandomOutcome, SWEPT, Worst};

/// Faults that are shown; the rest is counted.
const SHOWN: usize = 40;

/// What the terminal shows.
pub fn summary(outcome: &RandomOutcome) -> Document {
    let plan = &outcome.plan;
    let mut blocks = vec![
        Block::Table(engines(outcome)),
        Block::Table(endings(outcome)),
        Block::Table(laws(outcome)),
    ];
    if outcome.faults > 0 {
        blocks.push(Block::Table(faults(outcome)));
    }
    blocks.push(Block::List(vec![
        format!(
            "Scenes {} to {} of seed {}; `carom fuzz --seed {} --show N` prints scene N.",
            plan.first,
            plan.indices().end.saturating_sub(1).max(plan.first),
            plan.seed,
            plan.seed
        ),
        format!(
            "Held: every impact, and every motion between events, is that of closed forms which share nothing with the engines' laws; \
             numbers are finite; energy never more than {ABOVE_START:e} above its start; nobody outside or overlapping by more \
             than rounding, or in a stepped engine than its step explains; no panic. Parry measures every overlap at every knot; \
             of every {SWEPT}th scene it sweeps the paths of engines that solve for their events."
        ),
    ]));
    Document {
        id: "random-scenes".to_owned(),
        stopped_early: outcome.stopped_early(),
        title: "Random scenes".to_owned(),
        lead: headline(outcome),
        blocks,
        pages: Vec::new(),
    }
}

fn headline(outcome: &RandomOutcome) -> String {
    let labels: Vec<String> = outcome.plan.columns.iter().map(|c| c.label()).collect();
    let who = labels.join(" and ");
    match outcome.faults {
        0 => format!(
            "{who} held in {} of {} random scenes.",
            outcome.done, outcome.done
        ),
        n => format!("{n} faults in {} random scenes of {who}.", outcome.done),
    }
}

fn worst(worst: Worst) -> Cell {
    if worst.value > 0.0 {
        Cell::Owned(worst.value, worst.scene.to_string())
    } else {
        Cell::Fixed(0.0, 0)
    }
}

fn engines(outcome: &RandomOutcome) -> Table {
    let row = |(label, entry): (String, &RandomEntry)| {
        vec![
            Cell::text(label),
            Cell::Count(entry.endings.values().sum()),
            Cell::Count(entry.events),
            worst(entry.longest),
            worst(entry.energy),
            worst(entry.outside),
            worst(entry.overlap),
            Cell::Count(entry.swept),
            Cell::Count(entry.casts),
            Cell::Count(entry.given_up),
        ]
    };
    let labels = outcome.plan.columns.iter().map(|column| column.label());
    Table {
        id: "engines".to_owned(),
        title: "What was run, and the worst of it".to_owned(),
        columns: vec![
            Column::words("engine", "engine"),
            Column::number("runs", "runs", ""),
            Column::number("events", "events", ""),
            Column::number("longest", "longest run", "events"),
            Column::number("energy", "energy gained", "E0"),
            Column::number("outside", "outside", "bound"),
            Column::number("overlap", "overlap", "bound"),
            Column::number("swept", "swept", "scenes"),
            Column::number("casts", "casts", ""),
            Column::number("given-up", "given up", "pairs"),
        ],
        rows: labels.zip(&outcome.entries).map(row).collect(),
        note: "In brackets: the scene.".to_owned(),
    }
}

fn endings(outcome: &RandomOutcome) -> Table {
    let mut ids: Vec<&'static str> = Vec::new();
    for id in outcome
        .entries
        .iter()
        .flat_map(|entry| entry.endings.keys())
    {
        if !ids.contains(id) {
            ids.push(id);
        }
    }
    ids.sort_unstable();
    let mut columns = vec![Column::words("engine", "engine")];
    columns.extend(ids.iter().map(|id| Column::number(id, id, "")));
    let row = |(label, entry): (String, &RandomEntry)| {
        let count = |id: &&'static str| Cell::Count(entry.endings.get(*id).copied().unwrap_or(0));
        let mut row = vec![Cell::text(label)];
        row.extend(ids.iter().map(count));
        row
    };
    let labels = outcome.plan.columns.iter().map(|column| column.label());
    Table {
        id: "endings".to_owned(),
        title: "How the runs ended".to_owned(),
        columns,
        rows: labels.zip(&outcome.entries).map(row).collect(),
        note: String::new(),
    }
}

/// What was held against the laws, and what could not be, by the reason.
fn laws(outcome: &RandomOutcome) -> Table {
    let mut why: Vec<&'static str> = Vec::new();
    for entry in &outcome.entries {
        why.extend(entry.laws.left_out.keys());
    }
    why.sort_unstable();
    why.dedup();
    let row = |(label, entry): (String, &RandomEntry)| {
        let held = &entry.laws;
        vec![
            Cell::text(label),
            Cell::Count(held.impacts),
            worst(held.impact),
            Cell::Count(held.integrated),
            worst(held.integral),
            Cell::Count(held.pieces),
            worst(held.piece),
            Cell::Count(held.left_out.values().sum()),
        ]
    };
    let left_out = |why: &&'static str| {
        let counts = outcome.entries.iter().map(|entry| &entry.laws.left_out);
        let count: u64 = counts.filter_map(|counts| counts.get(why)).sum();
        format!("{why}: {count}")
    };
    let labels = outcome.plan.columns.iter().map(|column| column.label());
    Table {
        id: "laws".to_owned(),
        title: "What was held against the laws".to_owned(),
        columns: vec![
            Column::words("engine", "engine"),
            Column::number("impacts", "impacts", ""),
            Column::number("impact", "worst", "bound"),
            Column::number("integrated", "integrated", ""),
            Column::number("integral", "worst", "bound"),
            Column::number("pieces", "motions", ""),
            Column::number("piece", "worst", "bound"),
            Column::number("left-out", "left out", ""),
        ],
        rows: labels.zip(&outcome.entries).map(row).collect(),
        note: match why.is_empty() {
            true => String::new(),
            false => format!(
                "Left out because of: {}.",
                why.iter().map(left_out).collect::<Vec<_>>().join("; ")
            ),
        },
    }
}

fn faults(outcome: &RandomOutcome) -> Table {
    let shown = outcome.failures.iter().take(SHOWN);
    let hidden = outcome.faults.saturating_sub(SHOWN as u64);
    Table {
        id: "faults".to_owned(),
        title: "Faults".to_owned(),
        columns: vec![
            Column::number("scene", "scene", ""),
            Column::words("engine", "engine"),
            Column::words("what", "what"),
            Column::words("words", "how much, who, when"),
        ],
        rows: shown
            .map(|failure| {
                vec![
                    Cell::Count(failure.scene),
                    Cell::text(&failure.engine),
                    Cell::verdict(Tone::Bad, failure.fault.what),
                    Cell::text(&failure.fault.words),
                ]
            })
            .collect(),
        note: if hidden > 0 {
            format!("and {hidden} more")
        } else {
            String::new()
        },
    }
}
