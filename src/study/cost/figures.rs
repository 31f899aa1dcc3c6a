//! Work against precision: what each error costs.

use super::verdict::GAINS;
use super::{Measured, Outcome, Point, Quantity};
use crate::finding::{Axis, Figure, Series, Style};

/// Where errors that are zero to the last digit are drawn, in the unit of the quantity.
const ZERO: f64 = f64::EPSILON;

/// A figure a quantity, with the time of a shot, and one with the time of a simulated second.
pub fn all(outcome: &Outcome) -> Vec<Figure> {
    let shot = |quantity| figure(outcome, quantity, "time per shot", 1.0);
    let mut figures: Vec<Figure> = Quantity::ALL.into_iter().filter_map(shot).collect();
    let per_second = figure(
        outcome,
        Quantity::FinalPosition,
        "time per simulated second",
        1.0 / outcome.simulated,
    );
    figures.extend(per_second.map(|figure| Figure {
        id: "cost-per-second".to_owned(),
        ..figure
    }));
    figures
}

/// The figure that says most: final positions.
pub fn main(outcome: &Outcome) -> Option<Figure> {
    figure(outcome, Quantity::FinalPosition, "time per shot", 1.0)
}

fn figure(outcome: &Outcome, quantity: Quantity, time: &str, factor: f64) -> Option<Figure> {
    let place = |point: &Point| {
        let error = point.error(quantity).filter(|error| error.is_finite())?;
        Some([error.max(ZERO), point.seconds()? * factor])
    };
    let mut series = Vec::new();
    for measured in &outcome.families {
        let points: Vec<[f64; 2]> = measured.points.iter().filter_map(place).collect();
        if points.is_empty() {
            continue;
        }
        for style in [Style::Line, Style::Points] {
            series.push(Series {
                name: measured.family.label(),
                points: points.clone(),
                style,
            });
        }
    }
    if series.is_empty() {
        return None;
    }
    let points = || {
        outcome
            .families
            .iter()
            .flat_map(|measured: &Measured| &measured.points)
    };
    let gains = |point: &&Point| point.gained().is_some_and(|gained| gained > GAINS);
    let gaining: Vec<[f64; 2]> = points().filter(gains).filter_map(place).collect();
    // what has no error stands to the right of all that have one
    let errors = series
        .iter()
        .flat_map(|series| &series.points)
        .map(|point| point[0]);
    let beyond = 10.0 * errors.fold(ZERO, f64::max);
    let failed: Vec<[f64; 2]> = points()
        .filter(|point| !point.errors.is_empty() && place(point).is_none())
        .filter_map(|point| Some([beyond, point.seconds()? * factor]))
        .collect();
    for (name, points, style) in [
        ("gains energy", gaining, Style::Rings),
        ("no answer", failed, Style::Crosses),
    ] {
        if !points.is_empty() {
            series.push(Series {
                name: name.to_owned(),
                points,
                style,
            });
        }
    }
    Some(Figure {
        id: format!("cost-{}", quantity.id()),
        title: format!("What an error of the {} costs", quantity.name()),
        caption: format!(
            "Left and down is better. Error: {}, mean over the starts; one of zero is drawn at {ZERO:.1e}. Time: the shortest of \
             several runs, alone. A point without an answer, or with one that is infinitely wrong, stands at the right edge.",
            quantity.what()
        ),
        x: Axis::log(
            &format!("error of the {}", quantity.name()),
            quantity.unit(),
        ),
        y: Axis::log(time, "s"),
        equal_scale: false,
        outline: None,
        series,
        marks: Vec::new(),
    })
}
