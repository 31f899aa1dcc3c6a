//! What a study of cost found, in sentences.

use crate::engine::Setting;
use crate::study::cost::{
    CostOutcome, Fit, Kind, Measured, Offer, Point, Quantity, in_order, price,
};
use crate::words::describe_span;

/// The errors that the first sentence names, R.
const NAMED: [f64; 2] = [1e-2, 1e-6];

/// The answer in a sentence or two: what an error of the final position costs, by engine.
pub fn sentence(outcome: &CostOutcome) -> String {
    if let Some(why) = &outcome.no_oracle {
        return format!(
            "There is nothing to hold errors against: {}. What is left are times and gains of energy.",
            why.trim_end_matches('.')
        );
    }
    if outcome.levels.is_cut_short() {
        return "Which setting is the cheapest is not known: that takes all of them.".to_owned();
    }
    let offers = price::offers(outcome, Quantity::FinalPosition);
    if offers.is_empty() {
        return "Nothing was both run and timed.".to_owned();
    }
    let engines = engines(outcome);
    let mut sentences = Vec::new();
    for error in NAMED {
        let mut best: Vec<Offer<'_>> = engines
            .iter()
            .filter_map(|engine| price::cheapest(of_engine(&offers, engine), error))
            .collect();
        best.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
        let unreached: Vec<&str> = engines
            .iter()
            .filter(|engine| !best.iter().any(|offer| offer.engine() == **engine))
            .copied()
            .collect();
        let costs: Vec<String> = best
            .iter()
            .map(|offer| {
                format!(
                    "{} in {}",
                    describe_span(offer.seconds),
                    short_label(offer.point)
                )
            })
            .collect();
        let mut sentence = match &costs[..] {
            [] => {
                format!("No setting of this grid puts every ball within {error:e} R of its place")
            }
            _ => format!(
                "Every ball within {error:e} R of its place costs {}",
                costs.join(", ")
            ),
        };
        if !costs.is_empty() && !unreached.is_empty() {
            let grid = outcome.grid.id();
            sentence += &format!(
                "; not reached on the {grid} grid by {}",
                unreached.join(", ")
            );
        }
        sentences.push(sentence + ".");
    }
    sentences.join(" ")
}

/// The engines of the study, each once.
pub fn engines(outcome: &CostOutcome) -> Vec<&str> {
    let mut engines = Vec::new();
    for measured in &outcome.families {
        let id = measured.family.given.engine.id();
        if !engines.contains(&id) {
            engines.push(id);
        }
    }
    engines
}

/// The offers of one engine.
pub fn of_engine<'a, 'b>(
    offers: &'b [Offer<'a>],
    engine: &'b str,
) -> impl Iterator<Item = Offer<'a>> + 'b {
    offers
        .iter()
        .filter(move |offer| offer.engine() == engine)
        .copied()
}

/// Engine and setting with numbers of three digits; the exact ones are in the tables for programs.
pub fn short_label(point: &Point) -> String {
    let column = &point.level.column;
    format!("{} {}", column.engine.id(), short_setting(&column.setting))
        .trim_end()
        .to_owned()
}

/// A setting with numbers of three digits.
pub fn short_setting(setting: &Setting) -> String {
    let pair = |(key, value): (&String, &String)| match value.parse::<f64>() {
        Ok(number) => format!("{key}={}", short(number)),
        Err(_) => format!("{key}={value}"),
    };
    setting
        .values
        .iter()
        .map(pair)
        .collect::<Vec<_>>()
        .join(" ")
}

/// A number of three significant digits without trailing zeros: `1e-3`, `0.0167`, `400`.
pub fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.2e}").parse().unwrap_or(x);
    if x != 0.0 && !(1e-2..1e6).contains(&x.abs()) {
        format!("{rounded:e}")
    } else {
        format!("{rounded}")
    }
}

/// `1.00 ± 0.01`.
pub fn order(fit: &Fit) -> String {
    format!("{:.2} ± {:.2}", fit.order, fit.spread)
}

/// Why a family has its verdict, in one sentence; empty where nothing needs to be said.
pub fn why(outcome: &CostOutcome, measured: &Measured) -> String {
    let family = &measured.family;
    let mut parts = Vec::new();
    if let Some(refusal) = &family.refusal {
        return format!("does not run: {refusal}");
    }
    match measured.verdict.map(|verdict| (verdict, verdict.kind)) {
        _ if !measured.whole => parts.push("its levels were not all run".to_owned()),
        None if measured
            .points
            .iter()
            .any(|point| point.failed() < point.errors.len()) =>
        {
            parts.push("nothing to hold it against".to_owned());
        }
        None if measured.points.is_empty() => {}
        None => parts.push("no level has an answer".to_owned()),
        Some((verdict, Kind::Converging)) => {
            if let Some(fit) = verdict.fit.filter(|fit| fit.from > 0) {
                let from = short_setting(&measured.points[fit.from].level.column.setting);
                parts.push(format!(
                    "from {from} on: coarser levels do not follow the law"
                ));
            }
        }
        Some((_, kind)) => parts.push(blame(outcome, measured, kind)),
    }
    if !family.left_out.is_empty() {
        parts.push(match family.left_out.len() {
            all if measured.points.is_empty() => format!("all {all} levels are for --grid full"),
            1 => "one finer level with --grid full".to_owned(),
            more => format!("{more} finer levels with --grid full"),
        });
    }
    parts.join("; ")
}

fn blame(outcome: &CostOutcome, measured: &Measured, kind: Kind) -> String {
    let unit = if kind == Kind::GainingEnergy {
        "E0"
    } else {
        "R"
    };
    let Some(cause) = &measured.cause else {
        return "the search for the setting responsible was not run".to_owned();
    };
    let mut parts = Vec::new();
    if let Some(found) = cause.responsible() {
        parts.push(format!(
            "{}={} is responsible: {} alone takes {} {unit} to {} {unit}",
            found.knob,
            short_value(&found.values[0]),
            short_value(&found.values[1]),
            short(found.measure[0]),
            short(found.measure[1])
        ));
    }
    if let Some((engine, error)) = &cause.arithmetic {
        parts.push(format!(
            "24-bit arithmetic is responsible: the same setting in {engine} is within {} R",
            short(*error)
        ));
    }
    let too_coarse = too_coarse(outcome, measured);
    if parts.is_empty() {
        parts.extend(too_coarse);
    }
    let other_way = measured
        .points
        .last()
        .is_some_and(|finest| !in_order(finest));
    if parts.is_empty() && kind != Kind::GainingEnergy && other_way {
        parts.push("its finest level still has other collisions than the oracle".to_owned());
    }
    if parts.is_empty() {
        parts.push(match &cause.better {
            None => "no setting of the engine's ladders does better".to_owned(),
            Some(better) => format!("no single parameter of {better} makes the difference"),
        });
    }
    parts.join("; ")
}

/// Says so where two hits of one ball lie closer together than the finest step.
fn too_coarse(outcome: &CostOutcome, measured: &Measured) -> Option<String> {
    let closest = outcome.closest_hits?;
    let step = measured.points.last()?.level.pace.step;
    (step > closest).then(|| {
        format!(
            "steps of {} see hits {} apart at once",
            describe_span(step),
            describe_span(closest)
        )
    })
}

fn short_value(value: &str) -> String {
    value
        .parse::<f64>()
        .map_or_else(|_| value.to_owned(), short)
}
