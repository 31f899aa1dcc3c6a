//! The picture of the first event where the engines part: who meets whom, in each of them.

use crate::finding::{Axis, Figure, Series, Style};
use crate::math::Vec3;
use crate::study::compare::ComparisonOutcome;
use crate::trace::{Event, EventKind, Path, Trace};
use crate::words::{describe_event, describe_kind};
use std::collections::BTreeSet;

/// Events side by side at most.
const MOST_PLACES: usize = 4;
/// A place shows at least this much around its middle, in the largest radius.
const LEAST_REACH: f64 = 4.5;
/// Balls that are farther apart than this around one middle are not shown in one place, in the largest radius.
const MOST_REACH: f64 = 9.0;
/// Space around the balls that meet, in the largest radius.
const AROUND: f64 = 2.2;
/// Width of all places over their height.
const SHAPE: f64 = 2.0;
/// Points of a piece of path.
const POINTS: usize = 24;
/// Letters that fit above all places together.
const LETTERS: usize = 76;

/// What a kind of series is called.
const BEFORE: &str = "before";
const AFTER: &str = "after";
const MEETING: &str = "balls that meet";
const CONTACT: &str = "contact";

/// What runs have at one place of their collision orders, and which of them.
struct Version<'a> {
    /// Indices of the runs that have it.
    runs: Vec<usize>,
    /// The first of them.
    trace: &'a Trace,
    /// `None`: no more collisions.
    event: Option<Event>,
    /// The moment to show, s.
    time: f64,
}

/// What the engines have at the first event where two of them part; `None` where none do.
pub(super) fn first_parting(outcome: &ComparisonOutcome) -> Option<Figure> {
    let held = outcome.held();
    let partings = held
        .iter()
        .filter_map(|&(i, j, standing)| Some((i, j, standing.order.parting.as_ref()?, standing)));
    let (ours, theirs, parting, standing) =
        partings.min_by(|a, b| a.2.time().total_cmp(&b.2.time()))?;
    let versions = versions(outcome, theirs, parting.index, parting.time());
    let places = Places::around(outcome, &versions);
    let mut series = Vec::new();
    for (place, version) in versions.iter().enumerate() {
        places.draw(outcome, version, place, versions.len(), &mut series);
    }
    // names in one order whatever the first place lacks: it is what dashes and shapes go by
    let rank = |name: &str| {
        [BEFORE, AFTER, MEETING, CONTACT]
            .iter()
            .position(|n| *n == name)
    };
    let on_top = |series: &Series| matches!(series.style, Style::Words);
    series.sort_by_key(|series| (on_top(series), rank(&series.name)));
    let why = standing
        .cause
        .as_ref()
        .map(|cause| format!(": {}", cause.sentence()));
    let label = |i: usize| outcome.entries[i].label();
    let trace = |i: usize| outcome.entries[i].trace();
    Some(Figure {
        id: format!("parting-{}", outcome.scene.name),
        title: "Where they part first".to_owned(),
        caption: format!(
            "At event {} {} has {}, {} has {}{}. Each version is drawn at its own moment, x to the right, y up; in the data each \
             stands {:.2} R to the right of the one before.",
            parting.index + 1,
            label(ours),
            describe_event(parting.event.as_ref(), trace(ours)?),
            label(theirs),
            describe_event(parting.reference.as_ref(), trace(theirs)?),
            why.unwrap_or_default(),
            places.apart(versions.len()) / outcome.scene.smallest_radius(),
        ),
        x: Axis::linear("", &outcome.scene.units.length),
        y: Axis::linear("", &outcome.scene.units.length),
        equal_scale: true,
        outline: None,
        series,
        marks: Vec::new(),
    })
}

/// The versions of the collision with this index: the yardstick's first, then in the order of the comparison.
fn versions(
    outcome: &ComparisonOutcome,
    yardstick: usize,
    index: usize,
    time: f64,
) -> Vec<Version<'_>> {
    let mut order: Vec<usize> = (0..outcome.entries.len()).collect();
    order.sort_by_key(|&i| i != yardstick);
    let mut versions: Vec<Version> = Vec::new();
    for i in order {
        let Some(trace) = outcome.entries[i].trace() else {
            continue;
        };
        let event = trace.collisions().nth(index).copied();
        // a run that ended before says nothing about it
        if event.is_none() && trace.end_time < time && !trace.ending.is_complete() {
            continue;
        }
        let kind = |event: Option<Event>| event.map(|event| event.kind);
        match versions.iter_mut().find(|v| kind(v.event) == kind(event)) {
            Some(known) => known.runs.push(i),
            None => versions.push(Version {
                runs: vec![i],
                trace,
                event,
                time: event.map_or(time, |event| event.time),
            }),
        }
    }
    versions.truncate(MOST_PLACES);
    versions
}

/// The part of the table that is shown of each version.
struct Places {
    /// Middle of each.
    middles: Vec<[f64; 2]>,
    /// From the middle to an edge, length.
    reach: f64,
    /// The largest radius, length.
    radius: f64,
}

impl Places {
    /// One part for all where the balls that meet are near each other, else one around those of each version.
    fn around(outcome: &ComparisonOutcome, versions: &[Version]) -> Self {
        let radius = outcome.scene.balls.iter().map(|ball| ball.radius);
        let radius = radius.fold(0.0, f64::max);
        let all: BTreeSet<usize> = versions.iter().flat_map(meeting).collect();
        let spots = |version: &Version, balls: &BTreeSet<usize>| -> Vec<Vec3> {
            let at = |&ball: &usize| version.trace.paths[ball].state_at(version.time);
            balls
                .iter()
                .filter_map(at)
                .map(|state| state.position)
                .collect()
        };
        let together: Vec<Vec3> = versions.iter().flat_map(|v| spots(v, &all)).collect();
        let (middle, extent) = middle(&together);
        let reach = (extent + AROUND * radius).max(LEAST_REACH * radius);
        if reach <= MOST_REACH * radius {
            return Places {
                middles: vec![middle; versions.len()],
                reach,
                radius,
            };
        }
        let own = |version: &Version| {
            let own: BTreeSet<usize> = meeting(version).collect();
            self::middle(&spots(version, if own.is_empty() { &all } else { &own })).0
        };
        Places {
            middles: versions.iter().map(own).collect(),
            reach: LEAST_REACH * radius,
            radius,
        }
    }

    /// How far one place is from the next in the picture, length.
    fn apart(&self, places: usize) -> f64 {
        let height = 2.0 * (self.reach + self.above());
        (2.0 * self.reach + 2.5 * self.radius).max(SHAPE * height / places as f64)
    }

    /// How far words are above and below a place, length.
    fn above(&self) -> f64 {
        1.1 * self.radius + 0.12 * self.reach
    }

    fn draw(
        &self,
        outcome: &ComparisonOutcome,
        version: &Version,
        place: usize,
        places: usize,
        series: &mut Vec<Series>,
    ) {
        let [x, y] = self.middles[place];
        // the first place stays where it is
        let shift = place as f64 * self.apart(places) + self.middles[0][0] - x;
        let down = self.middles[0][1] - y;
        let mut add = |name: &str, style: Style, points: Vec<[f64; 2]>| {
            let shifted = points.into_iter().map(|[x, y]| [x + shift, y + down]);
            series.push(Series {
                name: name.to_owned(),
                points: shifted.collect(),
                style,
            });
        };
        let inside = |p: [f64; 2]| (p[0] - x).abs() <= self.reach && (p[1] - y).abs() <= self.reach;
        let (trace, time) = (version.trace, version.time);
        let meeting: Vec<usize> = meeting(version).collect();
        let span = self.span(trace, &meeting, time);
        for (ball, path) in trace.paths.iter().enumerate() {
            let Some(state) = trace.in_play_at(ball, time) else {
                continue;
            };
            let at = [state.position.x, state.position.y];
            if !inside(at) {
                continue;
            }
            let met = meeting.contains(&ball);
            let name = |named: &str| if met { named.to_owned() } else { String::new() };
            let before = piece(path, time - span, time, inside);
            let after = piece(path, time, time + span, inside);
            let moves = |points: &[[f64; 2]]| points.windows(2).any(|pair| pair[0] != pair[1]);
            if moves(&before) {
                add(&name(BEFORE), Style::Line, before);
            }
            // of a ball that only stands by, one line is enough: where it came from
            if met && moves(&after) {
                add(AFTER, Style::Line, after);
            }
            let radius = outcome.scene.balls[ball].radius;
            add(&name(MEETING), Style::Discs(radius), vec![at]);
            add(&trace.balls[ball], Style::Words, vec![at]);
        }
        if let Some(contact) = version
            .event
            .and_then(|event| contact(outcome, trace, event))
        {
            add(CONTACT, Style::Crosses, vec![contact]);
        }
        for edge in self.cushions(outcome, [x, y]) {
            add("", Style::Line, edge);
        }
        let above = self.reach + self.above();
        let labels: Vec<String> = version
            .runs
            .iter()
            .map(|&i| outcome.entries[i].label())
            .collect();
        add(
            &listed(&labels, LETTERS / places),
            Style::Words,
            vec![[x, y + above]],
        );
        let what = match &version.event {
            Some(event) => format!(
                "{} at {:.7} s",
                describe_kind(event.kind, trace),
                event.time
            ),
            None => "no more collisions".to_owned(),
        };
        add(&what, Style::Words, vec![[x, y - above]]);
    }

    /// How long before and after the moment paths are shown, s: until the fastest of the balls that meet crosses a place.
    fn span(&self, trace: &Trace, meeting: &[usize], time: f64) -> f64 {
        let paths = meeting.iter().map(|&ball| &trace.paths[ball]);
        let sides = paths.flat_map(|path| [path.before(time), path.state_at(time)]);
        let fastest = sides
            .flatten()
            .map(|state| state.speed())
            .fold(0.0, f64::max);
        if fastest > 0.0 {
            self.reach / fastest
        } else {
            0.0
        }
    }

    /// Edges of the table within a place.
    fn cushions(&self, outcome: &ComparisonOutcome, middle: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
        let Some(table) = outcome.scene.table else {
            return Vec::new();
        };
        let low = |axis: usize| (middle[axis] - self.reach).max(table.min[axis]);
        let high = |axis: usize| (middle[axis] + self.reach).min(table.max[axis]);
        let mut edges = Vec::new();
        for side in [table.min, table.max] {
            if (side[0] - middle[0]).abs() <= self.reach && low(1) < high(1) {
                edges.push(vec![[side[0], low(1)], [side[0], high(1)]]);
            }
            if (side[1] - middle[1]).abs() <= self.reach && low(0) < high(0) {
                edges.push(vec![[low(0), side[1]], [high(0), side[1]]]);
            }
        }
        edges
    }
}

/// The balls that meet in a version.
fn meeting<'a>(version: &'a Version) -> impl Iterator<Item = usize> + 'a {
    let balls = version.event.map(|event| event.kind.balls());
    balls.into_iter().flat_map(|(a, b)| [Some(a), b]).flatten()
}

/// Middle of the box around some places, and half of its longer side.
fn middle(spots: &[Vec3]) -> ([f64; 2], f64) {
    let along = |axis: usize| {
        let values = spots.iter().map(|spot| spot[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        (0.5 * (low + high), 0.5 * (high - low))
    };
    let ((x, wide), (y, high)) = (along(0), along(1));
    ([x, y], wide.max(high).max(0.0))
}

/// A path between two times; what lies outside is left out, with a gap.
fn piece(path: &Path, from: f64, to: f64, inside: impl Fn([f64; 2]) -> bool) -> Vec<[f64; 2]> {
    let first = path.knots.first().map_or(from, |knot| knot.time);
    let from = from.max(first);
    let mut times: Vec<f64> = (0..=POINTS)
        .map(|k| from + (to - from) * k as f64 / POINTS as f64)
        .collect();
    times.extend(
        path.knots
            .iter()
            .map(|knot| knot.time)
            .filter(|&t| from < t && t < to),
    );
    times.sort_by(f64::total_cmp);
    let point = |&t: &f64| {
        let state = path.before(t)?;
        let at = [state.position.x, state.position.y];
        Some(if inside(at) { at } else { [f64::NAN; 2] })
    };
    let points: Vec<[f64; 2]> = times.iter().filter_map(point).collect();
    let seen = |p: &[f64; 2]| !p[0].is_nan();
    let first = points.iter().position(seen).unwrap_or(0);
    let last = points.iter().rposition(seen).map_or(0, |last| last + 1);
    points[first..last].to_vec()
}

/// Where the surfaces meet in an event.
fn contact(outcome: &ComparisonOutcome, trace: &Trace, event: Event) -> Option<[f64; 2]> {
    let centre = |ball: usize| {
        trace.paths[ball]
            .before(event.time)
            .map(|state| state.position)
    };
    let radius = |ball: usize| outcome.scene.balls[ball].radius;
    match event.kind {
        EventKind::BallBall(a, b) => {
            let (a, b) = (a as usize, b as usize);
            let (from, to) = (centre(a)?, centre(b)?);
            let share = radius(a) / (radius(a) + radius(b));
            let point = from + (to - from) * share;
            Some([point.x, point.y])
        }
        EventKind::BallCushion(ball, side) => {
            let mut point = centre(ball as usize)?;
            point[side.axis()] += f64::from(side.sign()) * radius(ball as usize);
            Some([point.x, point.y])
        }
        _ => None,
    }
}

/// Labels in few letters: the first ones, and how many more.
fn listed(labels: &[String], letters: usize) -> String {
    let mut text = String::new();
    for (k, label) in labels.iter().enumerate() {
        let joined = if k == 0 {
            label.clone()
        } else {
            format!("{text}, {label}")
        };
        if k > 0 && joined.chars().count() + 11 > letters {
            return format!("{text} and {} more", labels.len() - k);
        }
        text = joined;
    }
    text
}
