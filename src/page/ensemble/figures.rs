//! Pictures of an ensemble: where the balls stopped, and the distribution that tells most.

use crate::finding::{Axis, Figure, Series, Style};
use crate::study::ensemble::{EnsembleEntry, EnsembleOutcome, Quantity};

/// Most points of a picture of final positions.
const MOST_POINTS: usize = 3000;
/// Most steps of a drawn distribution function.
const MOST_STEPS: usize = 400;

/// Final positions of all balls, one picture an engine.
pub(super) fn landings(outcome: &EnsembleOutcome) -> Vec<Figure> {
    let scene = &outcome.plan.scene;
    // as every table of the page
    let radius = scene.smallest_radius();
    let cue = scene.cue_ball();
    let mut figures = Vec::new();
    for entry in &outcome.entries {
        let complete = entry.complete().count();
        if complete == 0 {
            continue;
        }
        let shown = complete.min((MOST_POINTS / scene.balls.len()).max(1));
        let of_balls = |balls: &dyn Fn(usize) -> bool| -> Vec<[f64; 2]> {
            let runs = entry.complete().take(shown);
            runs.flat_map(|(_, landing)| {
                let own = landing.at.iter().enumerate();
                own.filter(|(ball, _)| balls(*ball))
                    .filter_map(|(_, at)| at.map(|place| place.map(|x| x / radius)))
                    .collect::<Vec<_>>()
            })
            .collect()
        };
        let mut series = vec![Series {
            name: format!("ball {}", scene.balls[cue].id),
            points: of_balls(&|ball| ball == cue),
            style: Style::Points,
        }];
        if scene.balls.len() > 1 {
            series.push(Series {
                name: "other balls".to_owned(),
                points: of_balls(&|ball| ball != cue),
                style: Style::Points,
            });
        }
        let label = entry.label();
        figures.push(Figure {
            id: format!("landings-{}", label.replace([' ', '=', ':', '.'], "-")),
            title: format!("Where the balls stopped: {label}"),
            caption: format!(
                "Centres of the balls in the first {shown} of {complete} complete samples."
            ),
            x: Axis::linear("x", "R"),
            y: Axis::linear("y", "R"),
            equal_scale: true,
            outline: scene
                .table
                .map(|table| [table.min, table.max].map(|corner| corner.map(|x| x / radius))),
            series,
            marks: Vec::new(),
        });
    }
    figures
}

/// The distribution functions, in all engines, of what differs most from the reference, or else is spread most.
pub(super) fn telling(outcome: &EnsembleOutcome) -> Option<Figure> {
    let scene = &outcome.plan.scene;
    let farthest = outcome
        .tests
        .iter()
        .filter(|test| test.differs)
        .reduce(|most, test| {
            if test.distance > most.distance {
                test
            } else {
                most
            }
        });
    let (ball, which, what) = match farthest {
        Some(test) => {
            let which = Quantity::ALL.iter().position(|q| *q == test.quantity)?;
            (test.ball, which, "differs most between the engines")
        }
        None => {
            let (ball, which, _) = widest(&outcome.entries[outcome.reference?])?;
            (ball, which, "is spread most")
        }
    };
    let quantity = Quantity::ALL[which];
    let (scale, unit) = quantity.scale(scene);
    let series = outcome.entries.iter().filter_map(|entry| {
        let steps = entry.distributions[ball][which]
            .as_ref()?
            .staircase(MOST_STEPS);
        Some(Series {
            name: entry.label(),
            points: steps.into_iter().map(|[x, y]| [x / scale, y]).collect(),
            style: Style::Line,
        })
    });
    let id = &scene.balls[ball].id;
    Some(Figure {
        id: "distribution".to_owned(),
        title: format!("Distribution of the {} of ball {id}", quantity.title()),
        caption: format!("Of all balls and quantities this one {what}."),
        x: Axis::linear(quantity.title(), unit),
        y: Axis::linear("part of the samples at or below", ""),
        equal_scale: false,
        outline: None,
        series: series.collect(),
        marks: Vec::new(),
    })
}

/// The coordinate with the largest deviation: ball, index of the quantity, deviation in length.
pub(super) fn widest(entry: &EnsembleEntry) -> Option<(usize, usize, f64)> {
    let mut widest: Option<(usize, usize, f64)> = None;
    for (ball, quantities) in entry.distributions.iter().enumerate() {
        // of positions: times are of another unit
        for (which, distribution) in quantities.iter().enumerate().take(2) {
            let deviation = distribution.as_ref().and_then(|d| d.deviation());
            if let Some(deviation) = deviation
                && widest.is_none_or(|(_, _, most)| deviation > most)
            {
                widest = Some((ball, which, deviation));
            }
        }
    }
    widest
}
