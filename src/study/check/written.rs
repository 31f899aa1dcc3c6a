//! What the four files of a run hold besides what a metric looks at: every event, every knot, every extremum, as they are written.
//!
//! Metrics say what two runs differ in that matters to a person; a cell that none of them reads could still be anything. Here each column has its
//! finding. Events are those of one kind and parties, k-th with k-th, knots those of one ball. A difference is taken component by component, so
//! that nothing overflows before it is looked at, and relative to the larger of the two where that is beyond 1, as accepted figures are.
//!
//! Two things are not held, and both are said: engine, version and settings, in which two runs may well differ; and the place of an extremum
//! that is nothing within its tolerance, because the largest of many roundings is another one on another target.

use super::Level;
use super::item::{Held, held};
use crate::finding::{Finding, Hold};
use crate::math::{Vec3, worse};
use crate::scene::Scene;
use crate::trace::{Event, EventKind, Extremum, Path, Trace};
use std::collections::HashMap;

const RESOLUTION: &str = "resolution";
const REST_SPEED: &str = "rest-speed";
const ULP: &str = "ulp";
const SPOT: &str = "ending-spot";
const EXTREMUM: &str = "extremum";
const EXTREMUM_TIME: &str = "extremum-time";
const ORDER: &str = "event-order";
const EVENTS: &str = "events";
const EVENT_TIME: &str = "event-time";
const EXCHANGES: &str = "event-exchanges";
const MARGIN: &str = "event-margin";
const CONDITION: &str = "event-condition";
const TIME_ERROR: &str = "event-time-error";
const KNOTS: &str = "knots";
const KNOT_TIME: &str = "knot-time";
const KNOT_POSITION: &str = "knot-position";
const KNOT_VELOCITY: &str = "knot-velocity";
const KNOT_SPIN: &str = "knot-spin";
const KNOT_EVENT: &str = "knot-event";

const fn of(id: &'static str, unit: &'static str, hold: Hold, what: &'static str) -> Held {
    held(id, unit, Level::Error, hold, what)
}

/// What is held of two runs besides metrics, ending and counters.
pub const WRITTEN: &[Held] = &[
    of(
        RESOLUTION,
        "s",
        Hold::Figure,
        "what event times are good to",
    ),
    of(
        REST_SPEED,
        "v0",
        Hold::Figure,
        "speed at which a ball is called stopped",
    ),
    of(
        ULP,
        "",
        Hold::Count,
        "spacing of the engine's numbers just above 1",
    ),
    of(
        SPOT,
        "s",
        Hold::Figure,
        "when the run ended, and the balls concerned, where the ending has a place",
    ),
    of(
        EXTREMUM,
        "",
        Hold::Figure,
        "an extremum, in the unit of its metric",
    ),
    of(
        EXTREMUM_TIME,
        "s",
        Hold::Figure,
        "when an extremum was reached, and by which balls, unless it is nothing within its tolerance",
    ),
    of(
        ORDER,
        "",
        Hold::Count,
        "events of every kind that agree from the start",
    ),
    of(EVENTS, "", Hold::Count, "events of one kind and parties"),
    of(
        EVENT_TIME,
        "s",
        Hold::Figure,
        "largest difference of their times, k-th with k-th",
    ),
    of(
        EXCHANGES,
        "",
        Hold::Count,
        "those of them that tell of another number of exchanges",
    ),
    of(
        MARGIN,
        "s",
        Hold::Figure,
        "largest difference of their margins",
    ),
    of(
        CONDITION,
        "",
        Hold::Figure,
        "largest difference of their conditions",
    ),
    of(
        TIME_ERROR,
        "s",
        Hold::Figure,
        "largest difference of their time errors",
    ),
    of(KNOTS, "", Hold::Count, "rows of a ball in samples.csv"),
    of(
        KNOT_TIME,
        "s",
        Hold::Figure,
        "largest difference of their times, k-th with k-th",
    ),
    of(
        KNOT_POSITION,
        "R",
        Hold::Figure,
        "largest difference of a coordinate",
    ),
    of(
        KNOT_VELOCITY,
        "v0",
        Hold::Figure,
        "largest difference of a component of the velocity",
    ),
    of(
        KNOT_SPIN,
        "v0/R",
        Hold::Figure,
        "largest difference of a component of the spin",
    ),
    of(
        KNOT_EVENT,
        "",
        Hold::Count,
        "those of them that are the far side of another event",
    ),
];

/// Everything that is written of a trace, and its distance from `reference`, under the label `engine`.
pub fn findings(scene: &Scene, engine: &str, trace: &Trace, reference: &Trace) -> Vec<Finding> {
    let mut sheet = Sheet {
        scene,
        engine,
        speed: speed_unit(scene),
        findings: Vec::new(),
    };
    sheet.run(trace);
    sheet.events(trace, reference);
    for (ball, id) in trace.balls.iter().enumerate() {
        if let (Some(path), Some(other)) = (trace.paths.get(ball), reference.paths.get(ball)) {
            sheet.knots(id, path, other);
        }
    }
    sheet.findings
}

/// The extrema of which `a` and `b` tell another place, which is not held, in a sentence; `None` where there are none. `ulp`: rounding of
/// the scalars.
pub fn unheld(scene: &Scene, a: &Trace, b: &Trace, ulp: f64) -> Option<String> {
    let pairs = extrema(a).into_iter().zip(extrema(b));
    let moved = |((name, ours), (_, theirs)): ((&str, &Extremum), (&str, &Extremum))| {
        let nothing = |e: &Extremum| is_nothing(scene, name, e, ulp);
        let same =
            same(ours.time, theirs.time) && (ours.ball, ours.other) == (theirs.ball, theirs.other);
        (nothing(ours) && nothing(theirs) && !same).then(|| name.to_owned())
    };
    let names: Vec<String> = pairs.filter_map(moved).collect();
    (!names.is_empty()).then(|| {
        format!(
            "Not held: when and where {} was reached, which is nothing within rounding.",
            names.join(", ")
        )
    })
}

/// Unit of what is held here.
fn unit_of(id: &str) -> &'static str {
    let own = WRITTEN.iter().find(|held| held.id == id);
    own.map_or("", |held| held.unit)
}

/// The unit of speeds, > 0.
fn speed_unit(scene: &Scene) -> f64 {
    let fastest = scene.largest_speed();
    if fastest > 0.0 { fastest } else { 1.0 }
}

/// The extrema of a trace with the names of their keys.
fn extrema(trace: &Trace) -> [(&'static str, &Extremum); 5] {
    let extrema = &trace.extrema;
    [
        ("energy_gained", &extrema.energy_gained),
        ("momentum", &extrema.momentum),
        ("overlap", &extrema.overlap),
        ("outside", &extrema.outside),
        ("displaced", &extrema.displaced),
    ]
}

/// An extremum in the unit of its metric, or in the scene's where nothing moves.
fn in_unit(scene: &Scene, name: &str, extremum: &Extremum) -> f64 {
    let positive = |unit: f64| if unit > 0.0 { unit } else { 1.0 };
    let unit = match name {
        "energy_gained" => positive(scene.initial_energy()),
        "momentum" => {
            let heaviest = scene.balls.iter().map(|ball| ball.mass).fold(0.0, worse);
            positive(heaviest * scene.largest_speed())
        }
        _ => scene.smallest_radius(),
    };
    extremum.value / unit
}

/// True if an extremum is 0 within its tolerance.
fn is_nothing(scene: &Scene, name: &str, extremum: &Extremum, ulp: f64) -> bool {
    let value = in_unit(scene, name, extremum);
    Hold::Figure.tolerance(ulp).holds(value, 0.0)
}

/// True for equal numbers, two infinities of one sign and two NaN.
fn same(a: f64, b: f64) -> bool {
    a == b || (a.is_nan() && b.is_nan())
}

/// Distance of two numbers, relative to the larger where that is beyond 1: 0 for the same ones, and no number where only one is one.
fn apart(a: f64, b: f64) -> f64 {
    if same(a, b) {
        return 0.0;
    }
    let largest = a.abs().max(b.abs()).max(1.0);
    if largest.is_finite() {
        // each by itself, so that the difference of two of the largest is one
        (a / largest - b / largest).abs()
    } else {
        f64::INFINITY
    }
}

/// The same of numbers of which either may be missing, which is as far as can be.
fn apart_if_any(a: Option<f64>, b: Option<f64>) -> f64 {
    match (a, b) {
        (Some(a), Some(b)) => apart(a, b),
        (None, None) => 0.0,
        _ => f64::INFINITY,
    }
}

/// A ball's id as a word: quoted where it would run into the next one.
fn word(id: &str) -> String {
    let plain = |c: char| !(c.is_whitespace() || c == '"' || c == '#');
    if !id.is_empty() && id.chars().all(plain) {
        id.to_owned()
    } else {
        format!("{id:?}")
    }
}

/// Balls by index as words.
fn words(trace: &Trace, balls: impl IntoIterator<Item = u32>) -> String {
    let name = |ball: u32| {
        trace
            .balls
            .get(ball as usize)
            .map_or("?".to_owned(), |id| word(id))
    };
    balls.into_iter().map(name).collect::<Vec<_>>().join(" ")
}

/// Where an event is in its trace, by kind and parties, in order.
fn places(trace: &Trace) -> Vec<(EventKind, Vec<usize>)> {
    let mut groups: Vec<(EventKind, Vec<usize>)> = Vec::new();
    let mut known: HashMap<EventKind, usize> = HashMap::new();
    for (index, event) in trace.events.iter().enumerate() {
        let group = *known.entry(event.kind).or_insert_with(|| {
            groups.push((event.kind, Vec::new()));
            groups.len() - 1
        });
        groups[group].1.push(index);
    }
    groups
}

struct Sheet<'a> {
    scene: &'a Scene,
    engine: &'a str,
    speed: f64,
    findings: Vec<Finding>,
}

impl Sheet<'_> {
    fn add(&mut self, metric: &'static str, subject: &str, value: f64) {
        self.findings.push(Finding {
            scene: self.scene.name.clone(),
            engine: self.engine.to_owned(),
            metric,
            subject: subject.to_owned(),
            value: Some(value),
            unit: unit_of(metric),
            verdict: None,
        });
    }

    /// What `run.json` says besides ending, counters, and what may differ.
    fn run(&mut self, trace: &Trace) {
        self.add(RESOLUTION, "", trace.provenance.resolution);
        self.add(REST_SPEED, "", trace.provenance.rest_speed / self.speed);
        self.add(ULP, "", trace.provenance.ulp);
        if let Some(spot) = trace.ending.spot() {
            self.add(SPOT, &words(trace, spot.balls.iter().copied()), spot.time);
        }
        let ulp = trace.provenance.rounding();
        for (name, extremum) in extrema(trace) {
            self.add(EXTREMUM, name, in_unit(self.scene, name, extremum));
            if !is_nothing(self.scene, name, extremum, ulp) {
                let balls = [extremum.ball, extremum.other].into_iter().flatten();
                let subject = format!("{name} {}", words(trace, balls));
                self.add(EXTREMUM_TIME, subject.trim_end(), extremum.time);
            }
        }
    }

    fn events(&mut self, trace: &Trace, reference: &Trace) {
        let alike = |(ours, theirs): &(&Event, &Event)| ours.kind == theirs.kind;
        let pairs = trace.events.iter().zip(&reference.events);
        self.add(ORDER, "", pairs.take_while(alike).count() as f64);
        let theirs: HashMap<EventKind, Vec<usize>> = places(reference).into_iter().collect();
        for (kind, ours) in places(trace) {
            let (a, b) = kind.parties(|ball| trace.balls.get(ball).map_or("?", String::as_str));
            let parties = if b.is_empty() {
                word(&a)
            } else {
                format!("{} {}", word(&a), word(&b))
            };
            let subject = format!("{} {parties}", kind.id());
            let other = theirs.get(&kind).map_or(&[][..], Vec::as_slice);
            let pairs = || ours.iter().copied().zip(other.iter().copied());
            let largest =
                |of: &dyn Fn(usize, usize) -> f64| pairs().map(|(i, j)| of(i, j)).fold(0.0, worse);
            let certainty = |i: usize, j: usize| {
                let of = |t: &Trace, at: usize| t.certainty.get(at).copied().unwrap_or_default();
                (of(trace, i), of(reference, j))
            };
            let events = |i: usize, j: usize| (trace.events[i], reference.events[j]);
            let exchanges = pairs().filter(|&(i, j)| {
                let (ours, theirs) = events(i, j);
                ours.exchanges != theirs.exchanges
            });
            let exchanges = exchanges.count() as f64;
            let time = largest(&|i, j| {
                let (ours, theirs) = events(i, j);
                apart(ours.time, theirs.time)
            });
            let margin = largest(&|i, j| {
                let (ours, theirs) = certainty(i, j);
                apart_if_any(ours.margin, theirs.margin)
            });
            let condition = largest(&|i, j| {
                let (ours, theirs) = certainty(i, j);
                apart_if_any(ours.condition, theirs.condition)
            });
            let time_error = largest(&|i, j| {
                let (ours, theirs) = certainty(i, j);
                apart_if_any(ours.time_error, theirs.time_error)
            });
            self.add(EVENTS, &subject, ours.len() as f64);
            self.add(EVENT_TIME, &subject, time);
            self.add(EXCHANGES, &subject, exchanges);
            self.add(MARGIN, &subject, margin);
            self.add(CONDITION, &subject, condition);
            self.add(TIME_ERROR, &subject, time_error);
        }
    }

    fn knots(&mut self, ball: &str, path: &Path, reference: &Path) {
        let pairs = || path.knots.iter().zip(&reference.knots);
        let largest = |of: fn(&crate::physics::State) -> Vec3, unit: f64| {
            let of_pair = |(ours, theirs): (&crate::trace::Knot, &crate::trace::Knot)| {
                let (a, b) = (of(&ours.state) / unit, of(&theirs.state) / unit);
                let parts = a.iter().zip(b.iter());
                parts.map(|(a, b)| apart(*a, *b)).fold(0.0, worse)
            };
            pairs().map(of_pair).fold(0.0, worse)
        };
        let radius = self.scene.smallest_radius();
        let time = pairs().map(|(a, b)| apart(a.time, b.time)).fold(0.0, worse);
        let other_event = pairs().filter(|(a, b)| a.after != b.after).count();
        let found = [
            (KNOTS, path.knots.len() as f64),
            (KNOT_TIME, time),
            (KNOT_POSITION, largest(|s| s.position, radius)),
            (KNOT_VELOCITY, largest(|s| s.velocity, self.speed)),
            (KNOT_SPIN, largest(|s| s.spin, self.speed / radius)),
            (KNOT_EVENT, other_event as f64),
        ];
        for (metric, value) in found {
            self.add(metric, ball, value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::apart;

    #[test]
    fn a_distance_is_never_lost_in_numbers_that_overflow() {
        for (a, b, expected) in [
            (1.0, 1.0, 0.0),
            (0.25, 0.5, 0.25),
            (200.0, 100.0, 0.5),
            (1e308, -1e308, 2.0),
            (f64::MAX, 1.0, 1.0),
            (f64::INFINITY, f64::INFINITY, 0.0),
            (f64::NAN, f64::NAN, 0.0),
            (f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY),
            (f64::INFINITY, 1e308, f64::INFINITY),
        ] {
            assert_eq!(apart(a, b), expected, "{a} {b}");
            assert_eq!(apart(b, a), expected, "{b} {a}");
        }
        assert!(apart(f64::NAN, 1.0).is_nan() && apart(1.0, f64::NAN).is_nan());
    }
}
