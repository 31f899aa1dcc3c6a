//! The tables of an ablation.

use super::words;
use crate::engine::Refusal;
use crate::finding::{Cell, Column, Table, Tone};
use crate::study::effects::{
    Change, EffectsOutcome, Owned, Rung, Verdict, WHOLE, energy_at, fallen,
};

/// Seconds in a microsecond.
const MICRO: f64 = 1e-6;

/// Leaving one out: what it costs, the dearest first.
pub fn without(outcome: &EffectsOutcome) -> Option<Table> {
    let column = outcome.reference?;
    if outcome.plan.without.is_empty() {
        return None;
    }
    let mut columns = vec![
        Column::words("left-out", "left out"),
        Column::words("verdict", "the shot"),
        Column::words("along", "and with it"),
    ];
    columns.extend(measured(outcome));
    columns.push(Column::number(
        "share",
        "share of what the bare model misses",
        "",
    ));
    let missed = outcome
        .change(outcome.plan.bare, column, WHOLE)
        .map(|change| change.moved())
        .filter(|moved| *moved > 0.0);
    let mut rows = Vec::new();
    for variant in outcome.by_cost() {
        let share = outcome
            .cost(variant)
            .zip(missed)
            .map(|(change, missed)| change.moved() / missed);
        let mut row = vec![
            Cell::text(variant.effect.name()),
            match outcome.verdict(variant) {
                Verdict::Needed => Cell::verdict(Tone::Notice, "needs it"),
                Verdict::NotNeeded => Cell::verdict(Tone::Good, "does not need it"),
                Verdict::Unknown => Cell::verdict(Tone::Quiet, "unknown"),
            },
            words_or_empty(words::along(&variant.along)),
        ];
        row.extend(measures(outcome, variant.row, column, WHOLE));
        row.push(Cell::maybe(share));
        rows.push(row);
    }
    let note = format!(
        "A shot needs an effect when leaving it out moves a ball by more than {} R or changes which balls fall. share: change of \
         position over that of the bare model; the shares need not add up. {}",
        outcome.threshold,
        how(outcome)
    );
    Some(Table {
        id: "without".to_owned(),
        title: format!("Leaving one out, in {}", outcome.columns[column].label()),
        columns,
        rows,
        note,
    })
}

/// The bare model, each effect on it, and all of them.
pub fn alone(outcome: &EffectsOutcome) -> Option<Table> {
    let column = outcome.reference?;
    if outcome.plan.alone.is_empty() {
        return None;
    }
    let mut columns = vec![Column::words("effects", "effects")];
    columns.extend(measured(outcome));
    let mut rows = Vec::new();
    let mut row = |name: String, index: usize| {
        let mut row = vec![Cell::Text(name)];
        row.extend(measures(outcome, index, column, WHOLE));
        rows.push(row);
    };
    row("bare model".to_owned(), outcome.plan.bare);
    for variant in &outcome.plan.alone {
        let name = match &variant.along[..] {
            [] => format!("{} alone", variant.effect.name()),
            along => format!("{} with {}", variant.effect.name(), words::along(along)),
        };
        row(name, variant.row);
    }
    row("all".to_owned(), WHOLE);
    Some(Table {
        id: "alone".to_owned(),
        title: format!(
            "One at a time on the bare model, in {}",
            outcome.columns[column].label()
        ),
        columns,
        rows,
        note: format!(
            "{} What cannot act alone brings along what it needs. {}",
            bare_in_words(outcome),
            how(outcome)
        ),
    })
}

/// From the poorest to the richest, each against the richest.
pub fn ladder(outcome: &EffectsOutcome) -> Option<Table> {
    let column = outcome.reference?;
    if outcome.plan.ladder.len() < 2 {
        return None;
    }
    let top = outcome.plan.top();
    let mut columns = vec![
        Column::number("rung", "#", ""),
        Column::words(
            "name",
            if outcome.plan.is_chain {
                "scene"
            } else {
                "effects"
            },
        ),
    ];
    columns.extend(measured(outcome));
    let row = |(index, rung): (usize, &Rung)| {
        let mut row = vec![Cell::Count(index as u64 + 1), Cell::text(rung.name.clone())];
        row.extend(measures(outcome, rung.row, column, top));
        row
    };
    let rows = outcome.plan.ladder.iter().enumerate().map(row).collect();
    let what = if outcome.plan.is_chain {
        "The scenes that `richer` links with this one."
    } else {
        "The scene's effects one upon the other; no scene is linked with it by `richer`."
    };
    Some(Table {
        id: "rungs".to_owned(),
        title: format!("The ladder, in {}", outcome.columns[column].label()),
        columns,
        rows,
        note: format!("{what} Changes are against the last rung."),
    })
}

/// Every other engine: what it ran, and how far it is from the reference's engine with the same effects.
pub fn engines(outcome: &EffectsOutcome) -> Option<Table> {
    let reference = outcome.reference?;
    let length = &outcome.columns[reference].label();
    let columns = vec![
        Column::words("engine", "engine"),
        Column::words("effects", "effects"),
        Column::number("apart", &format!("from {length} with the same (ball)"), "R"),
        Column::words("order", "order"),
        Column::number("whole", "from the whole scene (ball)", "R"),
        Column::number("time", "time per shot", "us"),
        Column::words("otherwise", "otherwise"),
    ];
    let mut rows = Vec::new();
    for (column, known) in outcome.columns.iter().enumerate() {
        if column == reference {
            continue;
        }
        let mut refused = 0;
        let mut whys: Vec<(String, usize)> = Vec::new();
        for row in 0..outcome.cells.len() {
            if let Some(Err(refusal)) = outcome.cells[row].get(column) {
                refused += 1;
                for why in reasons(refusal) {
                    match whys.iter_mut().find(|(known, _)| *known == why) {
                        Some((_, count)) => *count += 1,
                        None => whys.push((why, 1)),
                    }
                }
                continue;
            }
            let same = outcome.change(row, column, row);
            let whole = outcome.change(row, column, WHOLE);
            rows.push(vec![
                Cell::text(known.label()),
                Cell::Text(row_in_words(outcome, row)),
                owned(same.as_ref().and_then(Change::position)),
                order(same.as_ref().map(|change| change.order)),
                owned(whole.as_ref().and_then(Change::position)),
                time(outcome, row, column),
                words_or_empty(outcome.why_not(row, column).unwrap_or_default()),
            ]);
        }
        if refused > 0 {
            let whys = whys.iter().map(|(why, count)| format!("{why} ({count})"));
            let mut row = vec![
                Cell::text(known.label()),
                Cell::Text(format!("{refused} of {} combinations", outcome.cells.len())),
            ];
            row.extend([const { Cell::Empty }; 4]);
            row.push(Cell::verdict(
                Tone::Quiet,
                format!("refused: {}", whys.collect::<Vec<_>>().join(", ")),
            ));
            rows.push(row);
        }
    }
    (!rows.is_empty()).then(|| Table {
        id: "engines".to_owned(),
        title: "The other engines".to_owned(),
        columns,
        rows,
        note: "Every combination of effects that was run, once. The first number is what the engine itself costs, the second also \
               what the effects cost that are left out."
            .to_owned(),
    })
}

/// Why an engine did not run a combination: each missing effect, or what else was wrong.
fn reasons(refusal: &Refusal) -> Vec<String> {
    match refusal {
        Refusal::NotComparable { missing } => missing
            .iter()
            .map(|effect| format!("lacks {effect}"))
            .collect(),
        other => vec![other.to_string()],
    }
}

/// What a row runs, in words.
fn row_in_words(outcome: &EffectsOutcome, row: usize) -> String {
    let plan = &outcome.plan;
    if row == WHOLE {
        return "all".to_owned();
    }
    if row == plan.bare {
        return "bare model".to_owned();
    }
    if let Some(variant) = plan.alone.iter().find(|variant| variant.row == row) {
        return match &variant.along[..] {
            [] => format!("{} alone", variant.effect.name()),
            along => format!("{} with {}", variant.effect.name(), words::along(along)),
        };
    }
    if let Some(variant) = plan.without.iter().find(|variant| variant.row == row) {
        return format!("without {}", variant.effect.name());
    }
    let rung = plan.ladder.iter().find(|rung| rung.row == row);
    rung.map_or_else(String::new, |rung| rung.name.clone())
}

/// The columns of what is measured of a run.
fn measured(outcome: &EffectsOutcome) -> Vec<Column> {
    let time = &outcome.plan.scene.units.time;
    vec![
        Column::number("position", "position (ball)", "R"),
        Column::number("stop", "stop time (ball)", time),
        Column::words("order", "order"),
        Column::number("events", "events", ""),
        Column::words("fallen", "fallen"),
        Column::number(
            "energy",
            &format!("energy at {:.3} {time}", outcome.common_time),
            "E0",
        ),
        Column::number("time", "time per shot", "us"),
    ]
}

/// What is measured of a run, against row `from`; words in place of the order where it has no end.
fn measures(outcome: &EffectsOutcome, row: usize, column: usize, from: usize) -> Vec<Cell> {
    let trace = outcome.trace(row, column);
    let complete = outcome.complete(row, column);
    let change = outcome.change(row, column, from);
    let ending = match outcome.cells.get(row).and_then(|cells| cells.get(column)) {
        None => "not run".to_owned(),
        Some(Err(refusal)) => refusal.to_string(),
        Some(Ok(ran)) => ran.trace.ending.id().to_owned(),
    };
    let whole = outcome.plan.scene.initial_energy();
    let energy = complete
        .filter(|_| whole > 0.0)
        .map(|trace| energy_at(&outcome.plan.rows[row], trace, outcome.common_time) / whole);
    vec![
        owned(change.as_ref().and_then(Change::position)),
        owned(change.as_ref().and_then(|change| change.stop.clone())),
        match &change {
            Some(change) => order(Some(change.order)),
            None => Cell::verdict(Tone::Quiet, ending),
        },
        trace.map_or(Cell::Empty, |trace| Cell::Count(trace.events.len() as u64)),
        words_or_empty(trace.map(fallen).unwrap_or_default()),
        Cell::maybe(energy),
        time(outcome, row, column),
    ]
}

fn time(outcome: &EffectsOutcome, row: usize, column: usize) -> Cell {
    Cell::maybe(outcome.seconds(row, column).map(|s| s / MICRO))
}

fn owned(owned: Option<Owned>) -> Cell {
    owned.map_or(Cell::Empty, |owned| Cell::Owned(owned.value, owned.ball))
}

fn order(order: Option<(usize, usize)>) -> Cell {
    order.map_or(Cell::Empty, |(agreeing, all)| {
        Cell::Text(format!("{agreeing}/{all}"))
    })
}

fn words_or_empty(words: String) -> Cell {
    if words.is_empty() {
        Cell::Empty
    } else {
        Cell::Text(words)
    }
}

fn how(outcome: &EffectsOutcome) -> String {
    format!(
        "Changes are against the whole scene; a ball that fell counts where it left play. order: collisions that agree from the \
         start. energy: of the balls in play at {:.3} {}, half of the shortest run.",
        outcome.common_time, outcome.plan.scene.units.time
    )
}

fn bare_in_words(outcome: &EffectsOutcome) -> String {
    let bare = &outcome.plan.rows[outcome.plan.bare];
    format!("Bare model: {}.", bare.effects.named().join(", "))
}
