//! Pictures of an ablation: the ladder, and the paths with all effects and with none.

use super::{Change, Outcome, WHOLE};
use crate::finding::{Axis, Figure, Mark, Series, Style};
use crate::study::compare::table_picture;

/// What is read of a change.
type Read<'a> = &'a dyn Fn(&Change) -> Option<f64>;

/// How far each rung of the ladder is from the last one, in every engine.
pub fn ladder(outcome: &Outcome) -> Option<Figure> {
    outcome.reference?;
    let (plan, top) = (&outcome.plan, outcome.plan.top());
    if plan.ladder.len() < 2 {
        return None;
    }
    let place = |index: usize| (index + 1) as f64;
    let points = |column: usize, of: Read<'_>| -> Vec<[f64; 2]> {
        let rungs = plan.ladder.iter().enumerate();
        let point = |(index, rung): (usize, &super::Rung)| {
            let change = outcome.change(rung.row, column, top)?;
            Some([place(index), of(&change)?])
        };
        rungs.filter_map(point).collect()
    };
    let cue = &plan.scene.balls[plan.scene.cue_ball()].id;
    let mut series = Vec::new();
    for (column, known) in outcome.columns.iter().enumerate() {
        let kinds: [(String, Read<'_>); 2] = [
            (known.label(), &|change| Some(change.moved())),
            (format!("{}, ball {cue}", known.label()), &|change| {
                change.of_ball(cue)
            }),
        ];
        // in a scene of one ball both are the same
        let kinds = kinds.into_iter().take(plan.scene.balls.len());
        series.extend(kinds.filter_map(|(name, of)| {
            let points = points(column, of);
            (!points.is_empty()).then_some(Series {
                name,
                points,
                style: Style::Line,
            })
        }));
    }
    let mark = |(index, rung): (usize, &super::Rung)| Mark {
        at: place(index),
        label: rung.name.clone(),
    };
    Some(Figure {
        id: "ladder".to_owned(),
        title: "The effect ladder".to_owned(),
        caption: format!(
            "Distance of where a ball ends from where {} leaves it in the last rung, the largest over all balls and that of ball {cue}. A \
             distance of 0 has no place here.",
            outcome.columns[outcome.reference?].label()
        ),
        x: Axis::linear("rung", ""),
        y: Axis::log("distance from the last rung", "R"),
        equal_scale: false,
        outline: None,
        series,
        marks: plan.ladder.iter().enumerate().map(mark).collect(),
    })
}

/// Paths with every effect and in the bare model, in the reference's engine.
pub fn paths(outcome: &Outcome) -> Vec<Figure> {
    let Some(column) = outcome.reference else {
        return Vec::new();
    };
    let mut shown = vec![(WHOLE, "paths-all", "Paths with every effect")];
    if outcome.plan.bare != WHOLE {
        shown.push((outcome.plan.bare, "paths-bare", "Paths in the bare model"));
    }
    let picture = |(row, id, title): (usize, &str, &str)| {
        let trace = outcome.trace(row, column)?;
        let mut figure = table_picture(&outcome.plan.rows[row], trace, id);
        figure.title = title.to_owned();
        figure.caption = "Circles: where the balls ended, or left play.".to_owned();
        Some(figure)
    };
    shown.into_iter().filter_map(picture).collect()
}
