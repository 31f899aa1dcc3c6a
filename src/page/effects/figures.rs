//! Pictures of an ablation: what leaving each effect out costs, the ladder, and the paths with all effects and with none.

use crate::finding::{Axis, Figure, Series, Style};
use crate::page::compare::{TABLE_CAPTION, table_picture};
use crate::page::logarithm::{beyond, mark, zero_among};
use crate::study::effects::{Change, EffectsOutcome, Rung, Verdict, WHOLE};

/// What is read of a change.
type Read<'a> = &'a dyn Fn(&Change) -> Option<f64>;

/// Where a change of 0 stands where nothing changes, and where a run without an end stands then, R.
const NOTHING: (f64, f64) = (1e-3, 1e3);

/// How far leaving each effect out moves a ball, in every engine against its own whole run.
pub fn without(outcome: &EffectsOutcome) -> Option<Figure> {
    let reference = outcome.reference?;
    let variants = outcome.by_cost();
    if variants.is_empty() {
        return None;
    }
    let place = |index: usize| (index + 1) as f64;
    let change = |column: usize, row: usize| {
        let (whole, trace) = (
            outcome.complete(WHOLE, column)?,
            outcome.complete(row, column)?,
        );
        Some(Change::between(&outcome.plan.scene, trace, whole))
    };
    let mut series = Vec::new();
    for (column, known) in outcome.columns.iter().enumerate() {
        let moved = variants.iter().enumerate().filter_map(|(index, variant)| {
            Some([change(column, variant.row)?.moved(), place(index)])
        });
        series.push(Series {
            name: known.label(),
            points: moved.collect(),
            style: Style::Points,
        });
    }
    series.retain(|series| !series.points.is_empty());
    let mut picture = Picture::of(series, outcome.threshold, "needed beyond");
    let enumerated = || variants.iter().enumerate();
    let falls = enumerated().filter_map(|(index, variant)| {
        let cost = outcome.cost(variant)?;
        (!cost.falls.is_empty()).then(|| [picture.at(cost.moved()), place(index)])
    });
    let falls = falls.collect();
    let unknown = enumerated()
        .filter(|(_, variant)| outcome.verdict(variant) == Verdict::Unknown)
        .map(|(index, _)| [picture.none, place(index)]);
    let unknown: Vec<[f64; 2]> = unknown.collect();
    picture.add("changes which balls fall", falls, Style::Rings);
    picture.add("no end to compare", unknown, Style::Crosses);
    let names = variants
        .iter()
        .map(|variant| variant.effect.name().to_owned());
    Some(picture.figure(
        "without",
        "What leaving each effect out costs",
        format!(
            "Largest change of where a ball ends when the effect is left out, in each engine against its own run of the whole scene. First \
             what changes which balls fall, then by the change in {}.",
            outcome.columns[reference].label()
        ),
        "change of position",
        Axis::of_names("left out", names.collect()),
    ))
}

/// How far each rung of the ladder is from the last one, in every engine.
pub fn ladder(outcome: &EffectsOutcome) -> Option<Figure> {
    outcome.reference?;
    let (plan, top) = (&outcome.plan, outcome.plan.top());
    if plan.ladder.len() < 2 {
        return None;
    }
    let place = |index: usize| (index + 1) as f64;
    let points = |column: usize, of: Read<'_>| -> Vec<[f64; 2]> {
        let rungs = plan.ladder.iter().enumerate();
        let point = |(index, rung): (usize, &Rung)| {
            let change = outcome.change(rung.row, column, top)?;
            Some([of(&change)?, place(index)])
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
        for (name, of) in kinds.into_iter().take(plan.scene.balls.len()) {
            let points = points(column, of);
            series.extend([Style::Line, Style::Points].map(|style| Series {
                name: name.clone(),
                points: points.clone(),
                style,
            }));
        }
    }
    series.retain(|series| !series.points.is_empty());
    let names = plan.ladder.iter().map(|rung| rung.name.clone());
    let label = if plan.is_chain { "scene" } else { "effects" };
    Some(Picture::of(series, outcome.threshold, "").figure(
        "ladder",
        "The effect ladder",
        format!(
            "Distance of where a ball ends from where {} leaves it in the last rung, the largest over all balls and that of ball {cue}.",
            outcome.columns[outcome.reference?].label()
        ),
        "distance from the last rung",
        Axis::of_names(label, names.collect()),
    ))
}

/// Changes along a logarithmic axis, with places for those that have none on it.
struct Picture {
    series: Vec<Series>,
    threshold: f64,
    /// Where a change of 0 stands, R.
    zero: f64,
    /// Where a run without an end stands, R.
    none: f64,
    has_zeros: bool,
    /// What is said at the threshold.
    beyond: String,
}

impl Picture {
    /// `word`: what a change beyond the threshold is called.
    fn of(mut series: Vec<Series>, threshold: f64, word: &str) -> Self {
        let changes = || {
            let points = series.iter().flat_map(|series| &series.points);
            points.map(|point| point[0]).chain([threshold])
        };
        let (zero, none) = (
            zero_among(changes(), NOTHING.0),
            beyond(changes(), NOTHING.1),
        );
        let has_zeros = changes().any(|change| change == 0.0);
        for point in series.iter_mut().flat_map(|series| &mut series.points) {
            if point[0] == 0.0 {
                point[0] = zero;
            }
        }
        Picture {
            series,
            threshold,
            zero,
            none,
            has_zeros,
            beyond: format!("{word} {threshold} R").trim_start().to_owned(),
        }
    }

    /// Where a change stands.
    fn at(&self, change: f64) -> f64 {
        if change > 0.0 { change } else { self.zero }
    }

    fn add(&mut self, name: &str, points: Vec<[f64; 2]>, style: Style) {
        if !points.is_empty() {
            self.series.push(Series {
                name: name.to_owned(),
                points,
                style,
            });
        }
    }

    fn figure(self, id: &str, title: &str, caption: String, label: &str, rows: Axis) -> Figure {
        let mut marks = vec![mark(self.threshold, self.beyond)];
        if self.has_zeros {
            marks.push(mark(self.zero, "no change"));
        }
        if self.series.iter().any(|s| s.style == Style::Crosses) {
            marks.push(mark(self.none, "no end"));
        }
        Figure {
            id: id.to_owned(),
            title: title.to_owned(),
            caption,
            x: Axis::log(label, "R"),
            y: rows,
            equal_scale: false,
            outline: None,
            series: self.series,
            marks,
        }
    }
}

/// Paths with every effect and in the bare model, in the reference's engine.
pub fn paths(outcome: &EffectsOutcome) -> Vec<Figure> {
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
        figure.caption = TABLE_CAPTION.to_owned();
        Some(figure)
    };
    shown.into_iter().filter_map(picture).collect()
}
