//! The tables of a comparison, one function a table.

use super::scale::Scale;
use super::{contacts, figures};
use crate::compare::Order;
use crate::engine::{Parameter, Role};
use crate::finding::{Cell, Column, Table};
use crate::study::compare::{
    Cause, ComparisonEntry, ComparisonOutcome, ContactStanding, Standing, pair_label,
};
use crate::words::{describe_ending, describe_event, describe_order, describe_span};

/// Where and by how much each engine leaves the reference, or without one each pair parts; for the first screen of a page.
pub fn divergence_table(outcome: &ComparisonOutcome, scale: &Scale) -> Option<Table> {
    let (who, note) = match outcome.reference {
        Some(_) => ("engine", "Against the exact solution."),
        None => ("pair", "Out of the second engine's collisions."),
    };
    let columns = vec![
        Column::words("engine", who),
        Column::words("part", "parts at"),
        Column::words("order-strict", "order"),
        Column::number("stop-time", "stop time, worst (ball)", "s"),
        Column::number(
            "final-position",
            "final position, worst (ball)",
            &scale.unit,
        ),
    ];
    let row = |label: String, order: &Order| {
        vec![
            Cell::text(label.clone()),
            Cell::text(part(order)),
            Cell::text(describe_order(order, order.strict)),
            owned(outcome.worst(&label, "stop-time")),
            scale.owned(outcome.worst(&label, "final-position")),
        ]
    };
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    for entry in &outcome.entries {
        rows.extend(entry.standing.iter().map(|s| row(entry.label(), &s.order)));
    }
    if outcome.reference.is_none() {
        for pair in &outcome.pairs {
            let (a, b) = pair.entries;
            let label = pair_label(&outcome.entries[a], &outcome.entries[b]);
            rows.push(row(label, &pair.standing.order));
        }
    }
    (!rows.is_empty()).then(|| Table {
        id: "divergences".to_owned(),
        title: String::new(),
        columns,
        rows,
        note: format!("{note} Order: collisions that agree from the start; R: smallest radius."),
    })
}

/// Where two orders part, in words.
fn part(order: &Order) -> String {
    match &order.parting {
        Some(parting) => format!("event {}, {:.4} s", parting.index + 1, parting.time()),
        None => "never".to_owned(),
    }
}

/// The main table: one row an engine.
pub fn comparison_table(outcome: &ComparisonOutcome, scale: &Scale) -> Table {
    let columns = vec![
        Column::words("engine", "engine"),
        Column::number("stop-time", "stop time, worst (ball)", "s"),
        Column::number(
            "final-position",
            "final position, worst (ball)",
            &scale.unit,
        ),
        Column::words("order-strict", "order: strict"),
        Column::words("order-tolerant", "with ties"),
        Column::number("energy-gained", "energy gained", "E0"),
        Column::number("unexplained", "unexplained", &scale.unit),
        Column::number("time-per-shot", "time per shot", "us"),
    ];
    let mut rows = Vec::new();
    for (i, entry) in outcome.entries.iter().enumerate() {
        let label = entry.label();
        let ran = match &entry.cell {
            Ok(ran) => ran,
            Err(refusal) => {
                let mut row = vec![Cell::text(format!("{label}: {refusal}"))];
                row.resize(columns.len(), Cell::Empty);
                rows.push(row);
                continue;
            }
        };
        let named = if outcome.reference == Some(i) {
            format!("{label} (reference)")
        } else {
            label.clone()
        };
        let of_order = |count: fn(&Standing) -> usize| {
            let standing = entry.standing.as_ref();
            standing.map_or(Cell::Empty, |s| {
                Cell::text(describe_order(&s.order, count(s)))
            })
        };
        let plain = |metric| outcome.worst(&label, metric).map(|(value, _)| value);
        rows.push(vec![
            Cell::text(named),
            owned(outcome.worst(&label, "stop-time")),
            scale.owned(outcome.worst(&label, "final-position")),
            of_order(|s| s.order.strict),
            of_order(|s| s.order.tolerant),
            Cell::maybe(plain("energy-gained")),
            scale.cell(plain("unexplained")),
            Cell::maybe(ran.seconds.map(|s| s * 1e6)),
        ]);
    }
    let note = "Differences from the reference; +n: collisions that it does not have. R: smallest radius; E0: initial energy; unexplained: motion between two \
                records that the events do not account for.";
    Table {
        id: "comparison".to_owned(),
        title: String::new(),
        columns,
        rows,
        note: note.to_owned(),
    }
}

fn owned(worst: Option<(f64, &str)>) -> Cell {
    Scale {
        factor: 1.0,
        unit: String::new(),
    }
    .owned(worst)
}

/// Where each engine first differs from the reference, or the engines from each other, and why.
pub fn first_differences(outcome: &ComparisonOutcome) -> Option<Table> {
    let columns = vec![
        Column::words("engine", "engine"),
        Column::number("event", "at event", ""),
        Column::words("reference", "reference has"),
        Column::words("engine-has", "engine has"),
        Column::words("why", "why"),
    ];
    let mut rows = Vec::new();
    let mut add =
        |label: String, standing: &Standing, ours: &ComparisonEntry, theirs: &ComparisonEntry| {
            let Some(parting) = &standing.order.parting else {
                return;
            };
            let Some((ours, theirs)) = ours.trace().zip(theirs.trace()) else {
                return;
            };
            rows.push(vec![
                Cell::text(label),
                Cell::Count(parting.index as u64 + 1),
                Cell::text(describe_event(parting.reference.as_ref(), theirs)),
                Cell::text(describe_event(parting.event.as_ref(), ours)),
                Cell::text(
                    standing
                        .cause
                        .as_ref()
                        .map(Cause::sentence)
                        .unwrap_or_default(),
                ),
            ]);
        };
    match outcome.reference {
        Some(index) => {
            for entry in &outcome.entries {
                if let Some(standing) = &entry.standing {
                    add(entry.label(), standing, entry, &outcome.entries[index]);
                }
            }
        }
        None => {
            for pair in &outcome.pairs {
                let (a, b) = (
                    &outcome.entries[pair.entries.0],
                    &outcome.entries[pair.entries.1],
                );
                add(pair_label(a, b), &pair.standing, a, b);
            }
        }
    }
    let title = "First difference in collision order".to_owned();
    let note = match outcome.reference {
        Some(_) => String::new(),
        None => "Without a reference the second-named engine stands in its place.".to_owned(),
    };
    (!rows.is_empty()).then(|| Table {
        id: "first-difference".to_owned(),
        title,
        columns,
        rows,
        note,
    })
}

/// Id of the table of contacts that last.
pub const CONTACTS: &str = "contact-phases";

/// What each engine has in place of the contacts of the reference that last, and why it is off by then; nothing where it has none.
pub fn contact_table(outcome: &ComparisonOutcome, scale: &Scale) -> Option<Table> {
    let columns = vec![
        Column::words("engine", "engine"),
        Column::words("contact-of", "contact of"),
        Column::number("hits", "hits", ""),
        Column::number("contact-exchanges", "exchanges in all", ""),
        Column::number("first-hit", "first hit", "s"),
        Column::number("begin", "in contact from", "s"),
        Column::number("until", "until", "s"),
        Column::number("apart", "farthest apart", &scale.unit),
        Column::number("error-at-begin", "error at begin", &scale.unit),
        Column::number("error-at-end", "error at end", &scale.unit),
        Column::number("error-own", "its own", &scale.unit),
        Column::words("why", "why"),
    ];
    let index = outcome.reference?;
    let label = outcome.entries[index].label();
    let trace = outcome.entries[index].trace()?;
    let compared = outcome.entries.iter();
    let compared: Vec<(String, &Standing)> = compared
        .filter_map(|entry| Some((entry.label(), entry.standing.as_ref()?)))
        .collect();
    let seconds = |time: Option<f64>| time.map_or(Cell::Empty, |time| Cell::Fixed(time, 4));
    let mut rows = Vec::new();
    let (_, first) = compared.first()?;
    for (k, ContactStanding { phase, .. }) in first.contacts.iter().enumerate() {
        let mut row = vec![
            Cell::text(format!("{label} (reference)")),
            Cell::text(phase.name(trace)),
            // each hit of the reference is one exchange
            Cell::Count(phase.hits as u64),
            Cell::Count(phase.hits as u64),
            seconds((phase.hits > 0).then_some(phase.from)),
            seconds(Some(phase.begin)),
            seconds(Some(phase.end)),
        ];
        row.resize(columns.len(), Cell::Empty);
        rows.push(row);
        for (label, standing) in &compared {
            let Some(own) = standing.contacts.get(k) else {
                continue;
            };
            rows.push(vec![
                Cell::text(label.clone()),
                Cell::text(phase.name(trace)),
                Cell::Count(own.hits.episodes as u64),
                Cell::Count(own.hits.exchanges),
                seconds(own.hits.first),
                Cell::Empty,
                seconds(own.hits.until),
                scale.cell(own.apart),
                scale.cell(own.error_at_begin),
                scale.cell(own.error_at_end),
                scale.cell(own.own.as_ref().map(|own| own.error)),
                Cell::text(contacts::why(own, scale)),
            ]);
        }
    }
    let note = "hits: from the first of those that lead to the contact, an overlap that lasts is one; until: their last exchange. Errors: of its balls, the \
                farther one's; its own: at the end, if it is started in the states of the reference where the contact begins.";
    (!rows.is_empty()).then(|| Table {
        id: CONTACTS.to_owned(),
        title: "Contacts that last".to_owned(),
        columns,
        rows,
        note: note.to_owned(),
    })
}

/// What each divergence is made of.
pub fn attribution_table(outcome: &ComparisonOutcome, scale: &Scale) -> Table {
    let columns = vec![
        Column::words("engine", "engine"),
        Column::number("step", "step", &scale.unit),
        Column::number("timing", "timing", &scale.unit),
        Column::number("arithmetic", "arithmetic", &scale.unit),
        Column::number("model", "model", &scale.unit),
        Column::number(
            "until-parting",
            "before the orders part and the horizon",
            &scale.unit,
        ),
    ];
    let mut rows = Vec::new();
    for entry in &outcome.entries {
        let Some(standing) = &entry.standing else {
            continue;
        };
        let parts = &standing.attribution;
        let before = outcome
            .worst(&entry.label(), "until-parting")
            .map(|(value, _)| value);
        rows.push(vec![
            Cell::text(entry.label()),
            scale.cell(parts.step),
            scale.cell(parts.timing),
            scale.cell(parts.arithmetic),
            scale.cell(parts.model),
            scale.cell(before),
        ]);
    }
    let model = match &outcome.scene.richer {
        Some(name) => format!("model: exact here against exact in {name}."),
        None => "model: name a richer scene to see it.".to_owned(),
    };
    let note = format!(
        "step: final positions against exact. timing: largest error of an event's time x relative speed. arithmetic: f64 \
         against f32. {model} They need not add up."
    );
    Table {
        id: "attribution".to_owned(),
        title: "What the divergence is made of".to_owned(),
        columns,
        rows,
        note,
    }
}

/// Every pair of engines apart from the reference.
pub fn pair_table(outcome: &ComparisonOutcome, scale: &Scale) -> Option<Table> {
    let columns = vec![
        Column::words("pair", "pair"),
        Column::number("stop-time", "stop time, worst (ball)", "s"),
        Column::number(
            "final-position",
            "final position, worst (ball)",
            &scale.unit,
        ),
        Column::words("order-strict", "order: strict"),
        Column::words("order-tolerant", "with ties"),
        Column::words("part", "part at"),
    ];
    let mut rows = Vec::new();
    for pair in &outcome.pairs {
        let label = pair_label(
            &outcome.entries[pair.entries.0],
            &outcome.entries[pair.entries.1],
        );
        let order = &pair.standing.order;
        rows.push(vec![
            Cell::text(label.clone()),
            owned(outcome.worst(&label, "stop-time")),
            scale.owned(outcome.worst(&label, "final-position")),
            Cell::text(describe_order(order, order.strict)),
            Cell::text(describe_order(order, order.tolerant)),
            Cell::text(part(order)),
        ]);
    }
    (!rows.is_empty()).then(|| Table {
        id: "pairs".to_owned(),
        title: "The engines against each other".to_owned(),
        columns,
        rows,
        note: "Order is out of the second engine's collisions; ties within the sum of both resolutions.".to_owned(),
    })
}

/// Stop time and final position of every ball in every engine.
pub fn ball_table(outcome: &ComparisonOutcome) -> Table {
    let units = &outcome.scene.units;
    let columns = vec![
        Column::words("ball", "ball"),
        Column::words("engine", "engine"),
        Column::number("stop-time", "stopped at", &units.time),
        Column::number("x", "x", &units.length),
        Column::number("y", "y", &units.length),
        Column::number("distance", "from the reference", "R"),
    ];
    let mut rows = Vec::new();
    for (ball, id) in outcome.scene.balls.iter().map(|ball| &ball.id).enumerate() {
        for entry in &outcome.entries {
            let Some(trace) = entry.trace() else { continue };
            let last = trace.final_states()[ball];
            let label = entry.label();
            let distance = outcome
                .findings_of(&label, "final-position")
                .find(|f| f.subject == *id);
            rows.push(vec![
                Cell::text(id.clone()),
                Cell::text(label.clone()),
                trace.stop_times[ball].map_or(Cell::Empty, |t| Cell::Fixed(t, 6)),
                last.map_or(Cell::Empty, |s| Cell::Fixed(s.position.x, 6)),
                last.map_or(Cell::Empty, |s| Cell::Fixed(s.position.y, 6)),
                Cell::maybe(distance.and_then(|f| f.value)),
            ]);
        }
    }
    let title = "Where every ball stopped".to_owned();
    Table {
        id: format!("balls-{}", outcome.scene.name),
        title,
        columns,
        rows,
        note: String::new(),
    }
}

/// The reference's events, with the time of the same event in every other engine.
pub fn event_table(outcome: &ComparisonOutcome) -> Table {
    const MOST_ROWS: usize = 200;
    let shown = outcome
        .reference
        .or_else(|| outcome.entries.iter().position(|e| e.trace().is_some()));
    let id = format!("events-{}", outcome.scene.name);
    let Some((index, trace)) = shown.and_then(|i| Some((i, outcome.entries[i].trace()?))) else {
        return Table {
            id,
            ..Table::default()
        };
    };
    let columns = vec![
        Column::number("index", "#", ""),
        Column::number("time", "time", &outcome.scene.units.time),
        Column::words("kind", "kind"),
        Column::words("who", "who"),
    ];
    let rows: Vec<Vec<Cell>> = trace
        .events
        .iter()
        .enumerate()
        .take(MOST_ROWS)
        .map(|(k, event)| {
            vec![
                Cell::Count(k as u64),
                Cell::Fixed(event.time, 9),
                Cell::text(event.kind.id()),
                Cell::text(figures::event_name(trace, k)),
            ]
        })
        .collect();
    let title = format!("Events of {}", outcome.entries[index].label());
    let note = match trace.events.len() {
        n if n > MOST_ROWS => format!("The first {MOST_ROWS} of {n}; `carom run` writes them all."),
        _ => String::new(),
    };
    Table {
        id,
        title,
        columns,
        rows,
        note,
    }
}

/// What every run says against itself.
pub fn sanity_table(outcome: &ComparisonOutcome, scale: &Scale) -> Table {
    let metrics = [
        ("energy-gained", "energy gained", "E0"),
        ("momentum", "momentum", "m v0"),
        ("overlap", "overlap", "R"),
        ("overlap-by-parry", "overlap, by parry", "R"),
        ("outside", "outside", "R"),
        ("displaced", "displaced", "R"),
        ("unexplained", "unexplained", "R"),
    ];
    let mut columns = vec![Column::words("engine", "engine")];
    columns.extend(
        metrics
            .iter()
            .map(|(key, title, unit)| Column::number(key, title, unit)),
    );
    columns.push(Column::words("ending", "ending"));
    let mut rows = Vec::new();
    for entry in &outcome.entries {
        let Some(trace) = entry.trace() else { continue };
        let label = entry.label();
        let mut row = vec![Cell::text(label.clone())];
        row.extend(
            metrics
                .iter()
                .map(|(metric, _, _)| scale.owned(outcome.worst(&label, metric))),
        );
        row.push(Cell::text(describe_ending(trace)));
        rows.push(row);
    }
    let note = "Largest value over the run. momentum: in an impact, beyond what other forces explain. displaced: jumps of a \
                position, such as the stepper's wall clamp.";
    let id = format!("sanity-{}", outcome.scene.name);
    Table {
        id,
        title: String::new(),
        columns,
        rows,
        note: note.to_owned(),
    }
}

/// The parameter-equivalence sheet: one row a role, one column an engine.
pub fn sheet(outcome: &ComparisonOutcome) -> Table {
    let ran: Vec<(String, &Vec<Parameter>)> = outcome
        .entries
        .iter()
        .filter_map(|entry| Some((entry.label(), &entry.cell.as_ref().ok()?.sheet)))
        .collect();
    let mut columns = vec![Column::words("role", "what")];
    columns.extend(
        ran.iter()
            .map(|(label, _)| Column::words(&label.replace(' ', "-"), label)),
    );
    let told = |sheet: &[Parameter], role: Role| {
        let own = sheet.iter().filter(|p| p.role == role);
        let text = own.map(|p| {
            format!("{} = {} {}", p.name, p.value, p.unit)
                .trim_end()
                .to_owned()
        });
        text.collect::<Vec<_>>().join("; ")
    };
    let mut rows = Vec::new();
    for role in Role::ALL {
        let cells: Vec<String> = ran.iter().map(|(_, sheet)| told(sheet, role)).collect();
        if cells.iter().all(String::is_empty) {
            continue;
        }
        let mut row = vec![Cell::text(role.title())];
        row.extend(cells.into_iter().map(|text| {
            if text.is_empty() {
                Cell::Empty
            } else {
                Cell::Text(text)
            }
        }));
        rows.push(row);
    }
    let title = "Parameter-equivalence sheet".to_owned();
    let note =
        "Each row is one physical role; the cells say how each engine was given it.".to_owned();
    Table {
        id: format!("sheet-{}", outcome.scene.name),
        title,
        columns,
        rows,
        note,
    }
}

/// Versions and every effective setting.
pub fn settings(outcome: &ComparisonOutcome) -> Table {
    let columns = vec![
        Column::words("engine", "engine"),
        Column::words("version", "version"),
        Column::words("resolution", "event times to"),
        Column::words("settings", "settings"),
    ];
    let mut rows = Vec::new();
    for entry in &outcome.entries {
        let Some(trace) = entry.trace() else { continue };
        let from = &trace.provenance;
        let pairs: Vec<String> = from
            .parameters
            .iter()
            .map(|(key, value)| format!("{key}={value}"))
            .collect();
        let resolution = match from.resolution {
            0.0 => "rounding".to_owned(),
            seconds => describe_span(seconds),
        };
        rows.push(vec![
            Cell::text(entry.label()),
            Cell::text(from.version.clone()),
            Cell::Text(resolution),
            Cell::Text(pairs.join(" ")),
        ]);
    }
    let id = format!("settings-{}", outcome.scene.name);
    Table {
        id,
        title: "Versions and settings".to_owned(),
        columns,
        rows,
        note: String::new(),
    }
}
