//! The tables of a study of cost.

use super::words;
use crate::finding::{Cell, Column, Table, Tone};
use crate::study::cost::{
    CostOutcome, GAINS, HIGH_FROM, Kind, Measured, Offer, Point, Quantity, THRESHOLDS, price,
};
use crate::words::describe_span;

/// Seconds in a microsecond.
const MICRO: f64 = 1e-6;

/// Id of the price list, in short and in full.
const CHEAPEST: &str = "cheapest";

/// The price list: for each quantity and error the cheapest setting, and the cheapest of another engine.
pub fn cheapest(outcome: &CostOutcome) -> Table {
    let columns = vec![
        Column::words("quantity", "quantity"),
        Column::words("unit", "unit"),
        Column::number("error", "error <=", ""),
        Column::words("setting", "cheapest setting"),
        Column::number("time", "time per shot", "us"),
        Column::number("reached", "its error", ""),
        Column::words("next", "cheapest of another engine"),
        Column::number("times-as-long", "takes, x", ""),
    ];
    let mut rows = Vec::new();
    for quantity in Quantity::ALL {
        let offers = price::offers(outcome, quantity);
        if offers.is_empty() {
            continue;
        }
        for error in THRESHOLDS {
            let mut row = vec![
                Cell::text(quantity.name()),
                Cell::text(quantity.unit()),
                Cell::Number(error),
            ];
            row.extend(offer_cells(&offers, error));
            rows.push(row);
        }
    }
    Table {
        id: CHEAPEST.to_owned(),
        title: "Cheapest setting for an error".to_owned(),
        columns,
        rows,
        note: measures(),
    }
}

/// The price list for a terminal: errors with the same answer share a row, and each engine has its own price.
pub fn cheapest_in_short(outcome: &CostOutcome) -> Table {
    let engines = words::engines(outcome);
    let mut columns = vec![
        Column::words("quantity", "quantity"),
        Column::words("error", "error <="),
    ];
    columns.extend(engines.iter().map(|engine| Column::words(engine, engine)));
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    for quantity in Quantity::ALL {
        let offers = price::offers(outcome, quantity);
        if offers.is_empty() {
            continue;
        }
        let price = |error: f64, engine: &str| {
            let best = price::cheapest(words::of_engine(&offers, engine), error);
            best.map_or_else(String::new, |offer| {
                let setting = words::short_setting(&offer.point.level.column.setting);
                format!("{} {setting}", describe_span(offer.seconds))
            })
        };
        let mut groups: Vec<(f64, f64, Vec<String>)> = Vec::new();
        for error in THRESHOLDS {
            let prices: Vec<String> = engines.iter().map(|engine| price(error, engine)).collect();
            match groups.last_mut().filter(|group| group.2 == prices) {
                Some(group) => group.1 = error,
                None => groups.push((error, error, prices)),
            }
        }
        for (k, (from, to, prices)) in groups.into_iter().enumerate() {
            let unit = quantity.unit();
            let errors = if from == to {
                format!("{from:e} {unit}")
            } else {
                format!("{from:e} to {to:e} {unit}")
            };
            let name = if k == 0 { quantity.name() } else { "" };
            let mut row = vec![Cell::text(name), Cell::text(errors.trim_end())];
            row.extend(prices.into_iter().map(|price| match price.as_str() {
                "" => Cell::verdict(Tone::Quiet, "-"),
                _ => Cell::Text(price),
            }));
            rows.push(row);
        }
    }
    Table {
        id: CHEAPEST.to_owned(),
        title: "Cheapest setting for an error, and its time per shot, by engine".to_owned(),
        columns,
        rows,
        note: format!("{} -: no setting of the grid reaches it.", measures()),
    }
}

/// What the errors are.
fn measures() -> String {
    let what = Quantity::ALL.map(|quantity| match quantity.unit() {
        "" => format!("{}: {}", quantity.name(), quantity.what()),
        unit => format!("{}: {}, {unit}", quantity.name(), quantity.what()),
    });
    format!("Errors are means over the starts. {}.", what.join(". "))
}

fn offer_cells(offers: &[Offer<'_>], error: f64) -> [Cell; 5] {
    let Some(best) = price::cheapest(offers.iter().copied(), error) else {
        let nothing = Cell::verdict(Tone::Quiet, "none of this grid");
        return [nothing, Cell::Empty, Cell::Empty, Cell::Empty, Cell::Empty];
    };
    let others = offers
        .iter()
        .filter(|offer| offer.engine() != best.engine());
    let next = price::cheapest(others.copied(), error);
    [
        Cell::text(words::short_label(best.point)),
        Cell::Number(best.seconds / MICRO),
        Cell::Number(best.error),
        next.map_or(Cell::Empty, |next| {
            Cell::text(words::short_label(next.point))
        }),
        Cell::maybe(next.map(|next| next.seconds / best.seconds)),
    ]
}

/// Families ranked at equal error of the final position, low and high accuracy apart.
pub fn rankings(outcome: &CostOutcome) -> Vec<Table> {
    let (low, high) = THRESHOLDS.split_at(HIGH_FROM);
    [
        ranking(
            outcome,
            "ranking-low",
            "Low accuracy: time per shot at equal error of the final position",
            low,
        ),
        ranking(outcome, "ranking-high", "High accuracy: the same", high),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn ranking(outcome: &CostOutcome, id: &str, title: &str, errors: &[f64]) -> Option<Table> {
    let mut columns = vec![Column::words("family", "family")];
    columns.extend(errors.iter().map(|error| {
        let key = format!("within-{error:e}");
        Column::number(&key, &format!("{error:e} R"), "us")
    }));
    let mut ranked: Vec<(Vec<Option<f64>>, String)> = Vec::new();
    for measured in &outcome.families {
        let offers: Vec<Offer<'_>> = family_offers(measured, Quantity::FinalPosition);
        let time =
            |error: &f64| Some(price::cheapest(offers.iter().copied(), *error)?.seconds / MICRO);
        let times: Vec<Option<f64>> = errors.iter().map(time).collect();
        if times.iter().any(Option::is_some) {
            ranked.push((times, measured.family.label()));
        }
    }
    // by the finest error that both reach, then by time
    let rank = |times: &[Option<f64>]| {
        let reached = times.iter().flatten().count();
        (
            std::cmp::Reverse(reached),
            times
                .iter()
                .flatten()
                .last()
                .copied()
                .unwrap_or(f64::INFINITY),
        )
    };
    ranked.sort_by(|a, b| {
        let (a, b) = (rank(&a.0), rank(&b.0));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    let rows: Vec<Vec<Cell>> = ranked
        .into_iter()
        .map(|(times, label)| {
            let cells = times.into_iter().map(Cell::maybe);
            std::iter::once(Cell::Text(label)).chain(cells).collect()
        })
        .collect();
    (!rows.is_empty()).then(|| Table {
        id: id.to_owned(),
        title: title.to_owned(),
        columns,
        rows,
        note: "Sorted by the smallest error that a family reaches, then by its time there. Empty: no setting of the grid reaches it."
            .to_owned(),
    })
}

fn family_offers(measured: &Measured, quantity: Quantity) -> Vec<Offer<'_>> {
    let offer = |point| {
        Some(Offer {
            point,
            error: Point::error(point, quantity).filter(|error| error.is_finite())?,
            seconds: Point::seconds(point)?,
        })
    };
    measured.points.iter().filter_map(offer).collect()
}

/// How the errors of each family fall, and what holds them where they do not.
pub fn families(outcome: &CostOutcome) -> Table {
    let columns = vec![
        Column::words("family", "family"),
        Column::words("verdict", "verdict"),
        Column::words("order", "observed order"),
        Column::number("levels", "over levels", ""),
        Column::number("finest-error", "finest error", "R"),
        Column::number("gained", "energy gained", "E0"),
        Column::words("why", "why"),
    ];
    let row = |measured: &Measured| {
        let verdict = measured.verdict;
        let fit = verdict.and_then(|verdict| verdict.fit);
        vec![
            Cell::Text(measured.family.label()),
            verdict.map_or(Cell::Empty, |verdict| {
                Cell::verdict(tone(verdict.kind), verdict.kind.words())
            }),
            fit.map_or(Cell::Empty, |fit| Cell::Text(words::order(&fit))),
            fit.map_or(Cell::Empty, |fit| Cell::Count(fit.sizes as u64)),
            Cell::maybe(verdict.and_then(|verdict| verdict.finest)),
            Cell::maybe(verdict.and_then(|verdict| verdict.gained)),
            Cell::Text(words::why(outcome, measured)),
        ]
    };
    Table {
        id: "families".to_owned(),
        title: "How errors fall".to_owned(),
        columns,
        rows: outcome.families.iter().map(row).collect(),
        note: format!(
            "Order: power of the step in the final position, with its standard error, over the finest levels and the coarser ones that \
             follow their law within a factor of 2; a level counts by the median over its starts. floor: the last three levels agree within \
             a factor of 1.5. gaining energy: more than {GAINS:e} E0 at the two finest levels. A setting is responsible if changing it alone \
             divides the error by 2."
        ),
    }
}

fn tone(kind: Kind) -> Tone {
    match kind {
        Kind::Converging => Tone::Good,
        Kind::Floor => Tone::Notice,
        Kind::NotConverging | Kind::GainingEnergy => Tone::Bad,
    }
}

/// The settings that no other beats in both error and time: of all engines, and of each.
pub fn fronts(outcome: &CostOutcome) -> Option<Table> {
    let noise = price::noise(outcome);
    let offers = price::offers(outcome, Quantity::FinalPosition);
    let mut rows = Vec::new();
    let mut add = |of: &str, offers: &[Offer<'_>]| {
        for offer in price::front(offers, noise) {
            rows.push(vec![
                Cell::text(of),
                Cell::text(words::short_label(offer.point)),
                Cell::Number(offer.error),
                Cell::Number(offer.seconds / MICRO),
            ]);
        }
    };
    add("all engines", &offers);
    for engine in words::engines(outcome) {
        let own: Vec<Offer<'_>> = words::of_engine(&offers, engine).collect();
        add(engine, &own);
    }
    (!rows.is_empty()).then(|| Table {
        id: "front".to_owned(),
        title: "Pareto fronts: settings that none beats".to_owned(),
        columns: vec![
            Column::words("of", "of"),
            Column::words("setting", "setting"),
            Column::number("error", "error of the final position", "R"),
            Column::number("time", "time per shot", "us"),
        ],
        rows,
        note: format!(
            "Times that differ by less than {:.0} % are taken as equal: the noise that nine in ten settings stay below.",
            100.0 * noise
        ),
    })
}

/// Every setting: errors, time, work.
pub fn settings(outcome: &CostOutcome) -> Table {
    let mut columns = vec![
        Column::words("family", "family"),
        Column::words("setting", "setting"),
        Column::number("starts", "starts", ""),
    ];
    columns.extend(Quantity::ALL.map(|q| Column::number(q.id(), q.name(), q.unit())));
    columns.extend([
        Column::number("worst-position", "worst start", "R"),
        Column::number("gained", "energy gained", "E0"),
        Column::number("no-answer", "no answer", ""),
        Column::number("time", "time per shot", "us"),
        Column::number("time-per-second", "per simulated s", "us"),
        Column::number("noise", "noise", "%"),
        Column::number("runs", "runs timed", ""),
        Column::words("timed-as", "timed as"),
        Column::words("work", "work"),
    ]);
    let mut rows = Vec::new();
    for measured in &outcome.families {
        rows.extend(
            measured
                .points
                .iter()
                .map(|point| setting_row(measured, point)),
        );
    }
    Table {
        id: "settings".to_owned(),
        title: "Every setting".to_owned(),
        columns,
        rows,
        note: "Starts: runs from where the exact motion has the balls at parts of a step, each against the oracle's run from there. \
               Errors: means over them. Time: the shortest of the runs timed, alone, set-up and recording outside; noise: by how much \
               their median was longer. Timed as: what was set so that nothing sleeps. Work: the engine's own counts."
            .to_owned(),
    }
}

fn setting_row(measured: &Measured, point: &Point) -> Vec<Cell> {
    let column = &point.level.column;
    let timed = point.timed.as_ref();
    let awake = column.engine.awake(&column.setting);
    let mut row = vec![
        Cell::Text(measured.family.label()),
        Cell::Text(column.label()),
        Cell::Count(point.errors.len() as u64),
    ];
    row.extend(Quantity::ALL.map(|quantity| Cell::maybe(point.error(quantity))));
    let worst = point.range(Quantity::FinalPosition).map(|(_, most)| most);
    let work = timed.map_or_else(String::new, |timed| {
        let counts = timed.counters.iter().filter(|(_, count)| **count > 0);
        let words: Vec<String> = counts
            .map(|(name, count)| format!("{count} {name}"))
            .collect();
        words.join(", ")
    });
    row.extend([
        Cell::maybe(worst),
        Cell::maybe(point.gained()),
        Cell::Count(point.failed() as u64),
        Cell::maybe(timed.map(|timed| timed.seconds / MICRO)),
        Cell::maybe(timed.map(|timed| timed.seconds / timed.simulated / MICRO)),
        Cell::maybe(
            timed
                .and_then(|timed| timed.noise)
                .map(|noise| 100.0 * noise),
        ),
        timed.map_or(Cell::Empty, |timed| Cell::Count(timed.runs as u64)),
        Cell::Text(if awake == column.setting {
            String::new()
        } else {
            awake.to_string()
        }),
        Cell::Text(work),
    ]);
    row
}

/// What was tried to find the setting responsible.
pub fn causes(outcome: &CostOutcome) -> Option<Table> {
    let mut rows = Vec::new();
    for measured in &outcome.families {
        let Some((cause, verdict)) = measured.cause.as_ref().zip(measured.verdict) else {
            continue;
        };
        let unit = if verdict.kind == Kind::GainingEnergy {
            "E0"
        } else {
            "R"
        };
        for tried in &cause.tried {
            rows.push(vec![
                Cell::Text(measured.family.label()),
                Cell::Text(format!("{}={}", tried.knob, tried.values[0])),
                Cell::Text(tried.values[1].clone()),
                Cell::Number(tried.measure[0]),
                Cell::Number(tried.measure[1]),
                Cell::text(unit),
                if tried.is_responsible() {
                    Cell::verdict(Tone::Notice, "responsible")
                } else {
                    Cell::Empty
                },
            ]);
        }
    }
    (!rows.is_empty()).then(|| Table {
        id: "causes".to_owned(),
        title: "One parameter changed at a time".to_owned(),
        columns: vec![
            Column::words("family", "family"),
            Column::words("parameter", "parameter"),
            Column::words("changed-to", "changed to"),
            Column::number("before", "before", ""),
            Column::number("after", "after", ""),
            Column::words("unit", "unit"),
            Column::words("responsible", "responsible"),
        ],
        rows,
        note: "At the finest level of the family, with each value in turn from the family of the same engine that does best; error of the \
               final position, or energy gained, median of two starts."
            .to_owned(),
    })
}
