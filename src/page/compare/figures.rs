//! Pictures of a comparison: paths on the table, speeds over time, divergence over time.

use crate::finding::{Axis, Figure, Mark, Series, Style};
use crate::page::certainty;
use crate::scene::Scene;
use crate::study::compare::{ComparisonEntry, ComparisonOutcome, pair_label};
use crate::trace::{Path, Trace};
use crate::words::describe_kind;

/// Between two knots a path may be curved; it is drawn through this many points.
const POINTS_PER_CURVE: usize = 8;

/// What the circles of a picture of the table are.
pub const TABLE_CAPTION: &str =
    "Circles: where the balls ended, or left play. Grey: where they started, and pockets.";

/// Paths of all balls on the table in one engine, with the balls where they ended.
pub(super) fn paths(outcome: &ComparisonOutcome, entry: &ComparisonEntry) -> Option<Figure> {
    let trace = entry.trace()?;
    let scene = &outcome.scene;
    let label = entry.label();
    let id = format!(
        "paths-{}-{}",
        scene.name,
        label.replace([' ', '=', ':', '.'], "-")
    );
    let mut figure = table_picture(scene, trace, &id);
    figure.title = format!("Paths: {label}");
    figure.caption = TABLE_CAPTION.to_owned();
    Some(figure)
}

/// Paths in one engine without words, to put beside a row of a table.
pub(super) fn thumbnail(outcome: &ComparisonOutcome) -> Option<Figure> {
    let complete = |entry: &ComparisonEntry| {
        entry
            .trace()
            .is_some_and(|trace| trace.ending.is_complete())
    };
    let shown = outcome
        .reference
        .or_else(|| outcome.entries.iter().position(complete))?;
    let trace = outcome.entries[shown].trace()?;
    let name = &outcome.scene.name;
    let mut figure = table_picture(&outcome.scene, trace, &format!("thumbnail-{name}"));
    figure.title = format!("{name}: paths in {}", outcome.entries[shown].label());
    // too small for more than the paths and their ends
    figure.series.retain(|series| !series.name.is_empty());
    Some(figure)
}

/// Paths and ends of all balls on the table, without words.
pub fn table_picture(scene: &Scene, trace: &Trace, id: &str) -> Figure {
    let unit = &scene.units.length;
    let mut series = Vec::new();
    let cue = scene.cue_ball();
    let name = |ball: usize| {
        if ball == cue {
            "cue ball"
        } else {
            "other balls"
        }
    };
    // in grey, below the paths
    let grey = |points: Vec<[f64; 2]>, radius: f64| Series {
        name: String::new(),
        points,
        style: Style::Discs(radius),
    };
    if let Some(pockets) = &scene.effects.pockets {
        let circles = pockets.circles.iter();
        series.extend(circles.map(|[x, y, r]| grey(vec![[*x, *y]], *r)));
    }
    for (ball, known) in scene.balls.iter().enumerate() {
        let knots = &trace.paths[ball].knots;
        if let Some(first) = knots.first() {
            let at = first.state.position;
            series.push(grey(vec![[at.x, at.y]], known.radius));
        }
    }
    for (ball, path) in trace.paths.iter().enumerate() {
        let points = plan(path);
        if points.len() > 1 {
            series.push(Series {
                name: name(ball).to_owned(),
                points,
                style: Style::Line,
            });
        }
    }
    for (i, ball) in scene.balls.iter().enumerate() {
        let ended = trace.paths[i].last().unwrap_or(ball.state).position;
        let disc = |name: &str, p: [f64; 2]| Series {
            name: name.to_owned(),
            points: vec![p],
            style: Style::Discs(ball.radius),
        };
        series.push(disc(name(i), [ended.x, ended.y]));
    }
    Figure {
        id: id.to_owned(),
        title: String::new(),
        caption: String::new(),
        x: Axis::linear("x", unit),
        y: Axis::linear("y", unit),
        equal_scale: true,
        outline: scene.table.map(|table| [table.min, table.max]),
        series,
        marks: Vec::new(),
    }
}

/// The plan view of a path: its knots, and points between two knots where it bends.
fn plan(path: &Path) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut push = |p: [f64; 2]| {
        if points.last() != Some(&p) {
            points.push(p);
        }
    };
    for pair in path.knots.windows(2) {
        let (a, b) = (&pair[0], &pair[1]);
        push([a.state.position.x, a.state.position.y]);
        let turn = a.state.velocity.cross(&b.state.velocity).norm();
        let straight = turn <= 1e-6 * a.state.velocity.norm() * b.state.velocity.norm();
        if b.time > a.time && !straight {
            for k in 1..POINTS_PER_CURVE {
                let t = a.time + (b.time - a.time) * k as f64 / POINTS_PER_CURVE as f64;
                if let Some(state) = path.state_at(t) {
                    push([state.position.x, state.position.y]);
                }
            }
        }
    }
    if let Some(last) = path.last() {
        push([last.position.x, last.position.y]);
    }
    points
}

/// Speed of the cue ball over time in every engine.
pub(super) fn cue_speed(outcome: &ComparisonOutcome) -> Figure {
    let scene = &outcome.scene;
    let cue = scene.cue_ball();
    let of_cue = |trace: &Trace| -> Vec<[f64; 2]> {
        let knots = trace.paths[cue].knots.iter();
        knots.map(|knot| [knot.time, knot.state.speed()]).collect()
    };
    let id = &scene.balls[cue].id;
    speed_figure(
        outcome,
        "speed-cue",
        &format!("Speed of ball {id}"),
        "Each jump is an impact.",
        of_cue,
    )
}

/// Root mean square speed of all balls over time in every engine.
pub(super) fn rms_speed(outcome: &ComparisonOutcome) -> Figure {
    let of_all = |trace: &Trace| -> Vec<[f64; 2]> {
        let mut times: Vec<f64> = trace
            .paths
            .iter()
            .flat_map(|path| path.knots.iter().map(|k| k.time))
            .collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        // a picture shows no more than a few hundred times
        let stride = times.len().div_ceil(600).max(1);
        let rms = |&t: &f64| {
            let balls = 0..trace.paths.len();
            let states = balls.filter_map(|ball| trace.in_play_at(ball, t));
            let sum: f64 = states.map(|state| state.velocity.norm_squared()).sum();
            [t, (sum / trace.paths.len() as f64).sqrt()]
        };
        times
            .iter()
            .step_by(stride)
            .chain(times.last())
            .map(rms)
            .collect()
    };
    let what = "Root mean square over all balls. Engines that agree in energy lie on one curve.";
    speed_figure(outcome, "speed-rms", "Speed of all balls", what, of_all)
}

fn speed_figure(
    outcome: &ComparisonOutcome,
    id: &str,
    title: &str,
    caption: &str,
    points: impl Fn(&Trace) -> Vec<[f64; 2]>,
) -> Figure {
    let series = outcome.entries.iter().filter_map(|entry| {
        Some(Series {
            name: entry.label(),
            points: points(entry.trace()?),
            style: Style::Line,
        })
    });
    Figure {
        id: format!("{id}-{}", outcome.scene.name),
        title: title.to_owned(),
        caption: caption.to_owned(),
        x: Axis::linear("time", &outcome.scene.units.time),
        y: Axis::linear("speed", &outcome.scene.units.speed()),
        equal_scale: false,
        outline: None,
        series: series.collect(),
        marks: Vec::new(),
    }
}

/// Largest distance of a ball from the reference over time, with the reference's events and each first difference marked.
pub(super) fn divergence(outcome: &ComparisonOutcome) -> Option<Figure> {
    let mut series = Vec::new();
    let mut marks = Vec::new();
    let (reference, caption) = match outcome.reference {
        Some(index) => {
            for entry in &outcome.entries {
                if let Some(standing) = &entry.standing {
                    series.push(Series {
                        name: entry.label(),
                        points: standing.divergence.clone(),
                        style: Style::Line,
                    });
                    marks.extend(parting_mark(standing, &entry.label()));
                }
            }
            (outcome.entries[index].trace()?, "from the exact solution")
        }
        None => {
            let pair = outcome.pairs.first()?;
            let (a, b) = (
                &outcome.entries[pair.entries.0],
                &outcome.entries[pair.entries.1],
            );
            let name = pair_label(a, b);
            series.push(Series {
                name,
                points: pair.standing.divergence.clone(),
                style: Style::Line,
            });
            marks.extend(parting_mark(&pair.standing, "the orders"));
            (b.trace()?, "between the two engines")
        }
    };
    marks.extend(
        outcome
            .horizon
            .as_ref()
            .filter(|h| !h.is_whole())
            .map(|h| Mark {
                at: h.until,
                label: "horizon".to_owned(),
            }),
    );
    // every event of the reference as a minor mark, the first differences in words
    marks.extend(reference.collisions().map(|event| Mark {
        at: event.time,
        label: String::new(),
    }));
    Some(Figure {
        id: format!("divergence-{}", outcome.scene.name),
        title: "Divergence".to_owned(),
        caption: format!(
            "Largest distance of any ball {caption}. Thin lines: collisions. Labels: first differing collision, and the horizon where it lies within the run."
        ),
        x: Axis::linear("time", &outcome.scene.units.time),
        y: Axis::log("distance", "R"),
        equal_scale: false,
        outline: None,
        series,
        marks,
    })
}

fn parting_mark(standing: &super::Standing, who: &str) -> Option<Mark> {
    let parting = standing.order.parting.as_ref()?;
    Some(Mark {
        at: parting.time(),
        label: format!("{who}: event {}", parting.index + 1),
    })
}

/// How a perturbation grows, and how sure each event is of its place.
pub(super) fn certainty(outcome: &ComparisonOutcome) -> Vec<Figure> {
    let Some(horizon) = &outcome.horizon else {
        return Vec::new();
    };
    let scene = &outcome.scene;
    let figures = [
        outcome
            .growth
            .as_ref()
            .and_then(|growth| certainty::growth(scene, horizon, growth)),
        certainty::margins(scene, horizon),
    ];
    figures.into_iter().flatten().collect()
}

/// Names of the events of a trace for a table: index, time, what.
pub(super) fn event_name(trace: &Trace, index: usize) -> String {
    trace
        .events
        .get(index)
        .map(|event| describe_kind(event.kind, trace))
        .unwrap_or_default()
}
