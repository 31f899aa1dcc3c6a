//! The matrix of hard cases as a picture: which engine breaks where, and at which steps.

use super::tables;
use super::words::{heading, is_preset};
use crate::finding::{Axis, Figure, Series, Sign, Style, Verdict};
use crate::study::stability::{Case, STEPS, StabilityOutcome, is_swept};

/// Verdicts as they are drawn: the more ink, the more one asks for attention.
const DRAWN: [(Verdict, &str, Sign); 5] = [
    (Verdict::Holds, "holds", Sign::Dot),
    (Verdict::Drifts, "drifts", Sign::Triangle),
    (Verdict::Breaks, "breaks", Sign::Cross),
    (Verdict::Indeterminate, "indeterminate", Sign::Ring),
    (Verdict::CannotExpress, "cannot express", Sign::Dash),
];

/// Scenes x engines and presets; `None` without scenes.
pub fn matrix(outcome: &StabilityOutcome) -> Option<Figure> {
    let presets = &outcome.question.presets;
    let of_preset = |preset: usize| {
        let label = presets[preset].label();
        move |case: &&Case| is_preset(case) && case.planned.column.label() == label
    };
    let names = (0..presets.len()).map(|preset| {
        let mut cases = outcome.cases.iter();
        let case = cases.find(of_preset(preset));
        case.map_or_else(|| presets[preset].label(), heading)
    });
    picture(
        outcome,
        "matrix-picture",
        "Hard cases on every engine and preset, drawn",
        "One field a scene and engine, as in the table.",
        names.collect(),
        |scene, column| outcome.of_scene(scene).find(of_preset(column)),
    )
}

/// Scenes x steps of the engines whose steps are swept; `None` if there are none.
pub fn steps(outcome: &StabilityOutcome) -> Option<Figure> {
    let presets = &outcome.question.presets;
    let swept: Vec<usize> = (0..presets.len())
        .filter(|&preset| is_swept(&presets[preset]))
        .collect();
    // an empty column between two engines
    let apart = STEPS.len() + 1;
    let mut names: Vec<String> = Vec::new();
    for &preset in &swept {
        if !names.is_empty() {
            names.push(String::new());
        }
        let label = presets[preset].label();
        let mut cases = outcome.cases.iter();
        let case = cases.find(|case| case.planned.column.label() == label);
        let label = case.map_or(label, heading);
        names.extend(STEPS.map(|step| format!("{label} {step:e} s")));
    }
    picture(
        outcome,
        "steps-picture",
        "Hard cases from the finest step to the coarsest",
        "One field a scene, engine and step. An empty place was left to --full, or is out of reach.",
        names,
        |scene, column| {
            let (preset, step) = (swept[column / apart], column % apart);
            tables::of_step(outcome, scene, preset, step)
        },
    )
}

/// A matrix: rows are the scenes, columns have these names.
fn picture<'a>(
    outcome: &'a StabilityOutcome,
    id: &str,
    title: &str,
    caption: &str,
    columns: Vec<String>,
    case: impl Fn(usize, usize) -> Option<&'a Case>,
) -> Option<Figure> {
    let scenes = &outcome.question.scenes;
    let verdict = |scene: usize, column: usize| {
        let judged = case(scene, column)?.judged.as_ref()?;
        Some(judged.verdict)
    };
    let mut series: Vec<Series> = Vec::new();
    for (drawn, name, sign) in DRAWN {
        let fields = (0..scenes.len()).flat_map(|scene| {
            let mine = (0..columns.len()).filter(|&column| verdict(scene, column) == Some(drawn));
            let mine = mine.map(|column| [(column + 1) as f64, (scene + 1) as f64]);
            mine.collect::<Vec<_>>()
        });
        let points: Vec<[f64; 2]> = fields.collect();
        if !points.is_empty() {
            series.push(Series {
                name: name.to_owned(),
                points,
                style: Style::Tiles(sign),
            });
        }
    }
    (!series.is_empty()).then(|| Figure {
        id: id.to_owned(),
        title: title.to_owned(),
        caption: caption.to_owned(),
        x: Axis::of_names("", columns),
        y: Axis::of_names("", scenes.iter().map(|scene| scene.name.clone()).collect()),
        equal_scale: false,
        outline: None,
        series,
        marks: Vec::new(),
    })
}
