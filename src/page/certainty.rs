//! Pictures of how far a run can be believed: how a perturbation of the start grows, how sure the place of each event is, and how
//! far two precisions are apart. One room, because the page of a horizon and the page of a scene show the same.

use crate::finding::{Axis, Figure, Mark, Series, Style};
use crate::oracle::{BAND, Growth, Horizon, Precision, Sight};
use crate::scene::Scene;
use crate::words::describe_rough;

/// Growth of a perturbation of the start over time, one point an event; `None` where nothing grows.
pub fn growth(scene: &Scene, horizon: &Horizon, growth: &Growth) -> Option<Figure> {
    let times = horizon.sights.iter().map(|sight| sight.event.time);
    let events: Vec<[f64; 2]> = times
        .zip(&growth.factors)
        .map(|(time, factor)| [time, *factor])
        .collect();
    if events.len() < 2 {
        return None;
    }
    let points = events;
    let last = points.last().map_or(0.0, |point| point[0]);
    let after = |points: &[[f64; 2]]| Series {
        name: "after each event".to_owned(),
        points: points.to_vec(),
        style: if points.len() > 60 {
            Style::Line
        } else {
            Style::Points
        },
    };
    let mut series = vec![Series {
        style: Style::Line,
        ..after(&points)
    }];
    if points.len() <= 60 {
        series.push(after(&points));
    }
    let bits = bits(horizon);
    let limit = 2f64.powi(bits);
    if points.iter().any(|point| point[1] > 1e-3 * limit) {
        series.push(Series {
            name: format!("here 2^-{bits} R have become R"),
            points: vec![[points[0][0], limit], [last, limit]],
            style: Style::Guide,
        });
    }
    Some(Figure {
        id: format!("growth-{}", scene.name),
        title: "Growth of a perturbation of the start".to_owned(),
        caption: format!(
            "Largest singular value of the tangent map from the start to each event: the factor by which the worst small change of the \
             start has grown, lengths in R, speeds in the largest initial speed. A straight rise is exponential.{}",
            match (growth.rough, describe_rough(growth, &horizon.trace)) {
                (Some(index), _) if growth.lost.is_empty() && !growth.differs => format!(
                    " It ends at event {index}, where a convention resolved several contacts at once."
                ),
                (_, Some(rough)) => format!(" It is {rough}."),
                _ => String::new(),
            }
        ),
        x: Axis::linear("time", &scene.units.time),
        y: Axis::log("growth", "factor"),
        equal_scale: false,
        outline: None,
        series,
        marks: edge(horizon, horizon.until),
    })
}

/// The events, by index, but for impacts that shrink to a contact and are of no account among themselves.
fn of_account(horizon: &Horizon) -> impl Iterator<Item = (usize, &Sight)> {
    let sights = horizon.sights.iter().enumerate();
    sights.filter(|(_, sight)| !sight.shrinks)
}

/// The margin of each event against the error of its time: where an error reaches its margin, the order is no longer certain.
pub fn margins(scene: &Scene, horizon: &Horizon) -> Option<Figure> {
    let sights = || of_account(horizon);
    let of = |name: &str, style: Style, points: Vec<[f64; 2]>| Series {
        name: name.to_owned(),
        points,
        style,
    };
    let positive = |x: Option<f64>| x.filter(|x| x.is_finite() && *x > 0.0);
    let number = |index: usize| (index + 1) as f64;
    let margins: Vec<_> = sights()
        .filter_map(|(i, sight)| Some([number(i), positive(sight.margin)?]))
        .collect();
    let estimated: Vec<_> = sights()
        .filter_map(|(i, sight)| Some([number(i), positive(sight.estimated)?]))
        .collect();
    let seen: Vec<_> = sights()
        .filter_map(|(i, sight)| Some([number(i), positive(sight.seen)?]))
        .collect();
    let series = [
        of("margin to the next candidate", Style::Points, margins),
        of("error of the time, seen", Style::Points, seen),
        of("error of the time, estimated", Style::Line, estimated),
    ];
    let series: Vec<Series> = series
        .into_iter()
        .filter(|series| !series.points.is_empty())
        .collect();
    if series.len() < 2 {
        return None;
    }
    Some(Figure {
        id: format!("margins-{}", scene.name),
        title: "How sure the place of each event is".to_owned(),
        caption: format!(
            "An event keeps its place while its margin is above the error of its time. Seen: difference of {} from {}. Zeros are left out, and \
             impacts that shrink to a contact.",
            horizon.precision.id(),
            horizon.witness.id()
        ),
        x: Axis::linear("event", ""),
        y: Axis::log("time", &scene.units.time),
        equal_scale: false,
        outline: None,
        series,
        marks: edge(horizon, horizon.certain as f64 + 0.5),
    })
}

/// How far the two precisions are apart, against what growth makes of one rounding.
pub fn apart(scene: &Scene, horizon: &Horizon, growth: Option<&Growth>) -> Option<Figure> {
    let number = |index: usize| (index + 1) as f64;
    let apart: Vec<_> = of_account(horizon)
        .filter_map(|(i, sight)| Some([number(i), sight.apart.filter(|x| *x > 0.0)?]))
        .collect();
    if apart.len() < 2 {
        return None;
    }
    let last = number(horizon.sights.len() - 1);
    let mut series = vec![Series {
        name: "difference of the two precisions".to_owned(),
        points: apart,
        style: Style::Points,
    }];
    let factors = growth.map_or(&[][..], |growth| &growth.factors);
    let bits = bits(horizon);
    if factors.len() > 1 {
        let grown = factors.iter().enumerate();
        series.push(Series {
            name: format!("growth x 2^-{bits}: what it makes of one rounding at the start"),
            points: grown
                .map(|(i, factor)| [number(i), factor * 0.5f64.powi(bits)])
                .collect(),
            style: Style::Line,
        });
    }
    series.push(Series {
        name: format!("{BAND:e}: no farther within the horizon"),
        points: vec![[1.0, BAND], [last, BAND]],
        style: Style::Guide,
    });
    Some(Figure {
        id: format!("apart-{}", scene.name),
        title: format!(
            "How far {} and {} are apart",
            horizon.precision.id(),
            horizon.witness.id()
        ),
        caption: "Largest difference of time, position and velocity of the balls of each event. Lengths in R, speeds in the largest initial \
                  speed, times in R over that speed."
            .to_owned(),
        x: Axis::linear("event", ""),
        y: Axis::log("difference", "R"),
        equal_scale: false,
        outline: None,
        series,
        marks: edge(horizon, horizon.certain as f64 + 0.5),
    })
}

/// Bits of the scalar in question: one rounding is half a unit in the last of them.
fn bits(horizon: &Horizon) -> i32 {
    match horizon.precision {
        Precision::F32 => 24,
        Precision::F64 | Precision::Auto => 53,
        Precision::Dd => 106,
        Precision::F256 => 237,
    }
}

/// The horizon as a mark; none where the whole run is within it.
fn edge(horizon: &Horizon, at: f64) -> Vec<Mark> {
    let mark = (!horizon.is_whole()).then(|| Mark {
        at,
        label: "horizon".to_owned(),
    });
    mark.into_iter().collect()
}
