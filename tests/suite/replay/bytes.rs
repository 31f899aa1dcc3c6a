//! The data of a replay, read back as a browser reads them.

use super::{compared, scene};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use carom::math::Vec3;
use carom::page::compare::replay;
use carom::physics::State;
use carom::report::replay::data;
use carom::trace::{Knot, Path};
use serde_json::Value;

/// Half of the spacing of f32 around 1: what a number is rounded by, relative to itself.
const ROUNDING: f64 = f32::EPSILON as f64 / 2.0;

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

/// The paths of a run in scene units.
fn decoded(replay: &Value, run: &Value) -> Vec<Path> {
    let counts: Vec<usize> = run["knots"]["counts"]
        .as_array()
        .unwrap()
        .iter()
        .map(|count| count.as_u64().unwrap() as usize)
        .collect();
    let total: usize = counts.iter().sum();
    let packed = STANDARD
        .decode(run["knots"]["bytes"].as_str().unwrap())
        .unwrap();
    let bytes = miniz_oxide::inflate::decompress_to_vec(&packed).unwrap();
    let columns = if replay["rotates"].as_bool().unwrap() {
        10
    } else {
        7
    };
    assert_eq!(bytes.len(), total * columns * 4);
    let at = |column: usize, k: usize| {
        let plane = |byte: usize| bytes[column * total * 4 + byte * total + k];
        f64::from(f32::from_le_bytes([plane(0), plane(1), plane(2), plane(3)]))
    };
    let origin = &replay["origin"];
    let (radius, speed) = (
        number(&replay["R"]),
        number(&replay["scene"]["speed_scale"]),
    );
    let knot = |k: usize| Knot {
        time: at(0, k),
        state: State {
            position: Vec3::from_fn(|i, _| number(&origin[i]) + radius * at(1 + i, k)),
            velocity: Vec3::from_fn(|i, _| speed * at(4 + i, k)),
            spin: match columns {
                10 => Vec3::from_fn(|i, _| speed / radius * at(7 + i, k)),
                _ => Vec3::zeros(),
            },
        },
        after: None,
    };
    let mut first = 0;
    let path = |count: usize| {
        first += count;
        Path {
            knots: (first - count..first).map(knot).collect(),
        }
    };
    counts.into_iter().map(path).collect()
}

/// Both sides of every event of its balls are kept knots, so what a browser shows there is the trace's own state, rounded to f32.
/// A ball with another knot within the rounding of the time is passed over: which side is which is lost there.
#[test]
fn a_browser_sees_the_balls_of_every_event_as_the_engine_had_them() {
    for (name, engines, least) in [
        ("report-break", None, 200),
        ("discs-in-a-box", None, 800),
        ("report-break-frozen", None, 10),
        (
            "pool-break",
            Some("exact,stepper:contact=approaching-only"),
            300,
        ),
    ] {
        let scene = scene(name);
        let outcome = compared(&scene, engines);
        let replay = replay(&outcome).unwrap();
        let text = data(&replay);
        let json: Value = serde_json::from_str(&text).unwrap();
        let traces: Vec<_> = outcome
            .entries
            .iter()
            .filter_map(|entry| entry.trace())
            .collect();
        let runs = json["runs"].as_array().unwrap();
        assert_eq!(runs.len(), traces.len(), "{name}");
        let mut checked = 0;
        for (run, trace) in runs.iter().zip(traces) {
            let label = run["label"].as_str().unwrap();
            let paths = decoded(&json, run);
            // where exchanges are left out, places are promised, and to the tolerance
            let all = !replay.remark.contains(label);
            let tolerance = match all {
                true => 0.0,
                false => number(&run["knots"]["tolerance"]) * scene.smallest_radius(),
            };
            let events = run["events"].as_array().unwrap();
            assert_eq!(events.len(), trace.events.len(), "{name} in {label}");
            for (row, event) in events.iter().zip(&trace.events) {
                let (a, b) = event.kind.parties(|ball| &trace.balls[ball]);
                assert_eq!(
                    *row,
                    serde_json::json!([event.time, event.kind.id(), a, b]),
                    "{name} in {label}"
                );
                let (a, b) = event.kind.balls();
                for ball in [Some(a), b].into_iter().flatten() {
                    let time = f64::from(event.time as f32);
                    let near = trace.paths[ball].knots.iter().filter(|knot| {
                        knot.time != event.time && f64::from(knot.time as f32) == time
                    });
                    if near.count() > 0 {
                        continue;
                    }
                    checked += 1;
                    let sides = [
                        (
                            trace.paths[ball].before(event.time),
                            paths[ball].before(time),
                        ),
                        (
                            trace.paths[ball].state_at(event.time),
                            paths[ball].state_at(time),
                        ),
                    ];
                    for (true_one, shown) in sides {
                        let (true_one, shown) = (true_one.unwrap(), shown.unwrap());
                        let origin = Vec3::from_fn(|i, _| number(&json["origin"][i]));
                        for (what, wanted, got, size) in [
                            (
                                "position",
                                true_one.position,
                                shown.position,
                                (true_one.position - origin).amax(),
                            ),
                            (
                                "velocity",
                                true_one.velocity,
                                shown.velocity,
                                true_one.velocity.amax(),
                            ),
                            ("spin", true_one.spin, shown.spin, true_one.spin.amax()),
                        ]
                        .into_iter()
                        .take(if all { 3 } else { 1 })
                        {
                            // rounded to f32 from the origin, then a few roundings of f64 there and back
                            let rounding = ROUNDING * size + 8.0 * f64::EPSILON * wanted.amax();
                            let bound = tolerance + rounding;
                            let off = (wanted - got).amax();
                            assert!(
                                off <= bound,
                                "{name} in {label}: {what} of {} at {} is off by {off} > {bound}",
                                trace.balls[ball],
                                event.time
                            );
                        }
                    }
                }
            }
        }
        assert!(checked > least, "{name}: only {checked} balls of events");
    }
}

/// Anywhere else a browser is off by the tolerance, the rounding of a number, and the way made in the rounding of the time.
#[test]
fn a_browser_sees_every_knot_within_the_tolerance() {
    for (name, engines, least) in [
        (
            "report-break",
            "exact,stepper:contact=approaching-only,rapier-f64",
            5_000,
        ),
        ("ladder-rotation", "exact,rapier-f64", 5_000),
    ] {
        let scene = scene(name);
        let outcome = compared(&scene, Some(engines));
        let replay = replay(&outcome).unwrap();
        let json: Value = serde_json::from_str(&data(&replay)).unwrap();
        let traces: Vec<_> = outcome
            .entries
            .iter()
            .filter_map(|entry| entry.trace())
            .collect();
        let mut checked = 0;
        for (run, trace) in json["runs"].as_array().unwrap().iter().zip(traces) {
            let tolerance = number(&run["knots"]["tolerance"]) * scene.smallest_radius();
            for (path, shown) in trace.paths.iter().zip(decoded(&json, run)) {
                let fastest = path
                    .knots
                    .iter()
                    .map(|knot| knot.state.speed())
                    .fold(0.0, f64::max);
                let farthest = path
                    .knots
                    .iter()
                    .map(|knot| knot.state.position.amax())
                    .fold(0.0, f64::max);
                // knots that the clock of a browser puts at one time: the first is what it has before, the last what it has after
                let clock = |knot: &Knot| f64::from(knot.time as f32);
                for group in path.knots.chunk_by(|a, b| clock(a) == clock(b)) {
                    let (first, last) = (&group[0], &group[group.len() - 1]);
                    let time = clock(first);
                    for (knot, seen) in [(first, shown.before(time)), (last, shown.state_at(time))]
                    {
                        checked += 1;
                        let off = (seen.unwrap().position - knot.state.position).norm();
                        // both ends of a piece and the moment itself are rounded in time; three coordinates at both ends in place
                        let bound = tolerance
                            + 3.0 * ROUNDING * knot.time * fastest
                            + 4.0 * ROUNDING * farthest;
                        assert!(off <= bound, "{name}: off by {off} > {bound} at {time}");
                    }
                }
            }
        }
        assert!(checked > least, "{name}: only {checked} knots");
    }
}

#[test]
fn partings_come_by_time_and_point_at_runs_balls_and_events_that_are_there() {
    let mut partings = 0;
    for name in [
        "report-break",
        "report-break-frozen",
        "discs-in-a-box",
        "slide",
    ] {
        let replay = replay(&compared(&scene(name), None)).unwrap();
        assert!(
            replay.partings.is_sorted_by(|a, b| a.time <= b.time),
            "{name}"
        );
        for parting in &replay.partings {
            partings += 1;
            let [ours, theirs] = parting.runs.map(|i| &replay.runs[i]);
            assert_ne!(ours.label, theirs.label, "{name}");
            let has = |run: &carom::finding::ReplayRun| {
                run.events.iter().any(|event| event.time == parting.time)
            };
            assert!(
                has(ours) || has(theirs),
                "{name}: nothing happens at {}",
                parting.time
            );
            assert!(parting.words.contains(&ours.label) && parting.words.contains(&theirs.label));
            for id in &parting.balls {
                assert!(
                    replay.balls.iter().any(|ball| ball.id == *id),
                    "{name}: {id}"
                );
            }
        }
    }
    assert!(partings > 10, "only {partings}");
}

#[test]
fn what_cannot_be_shown_is_said_in_words() {
    let mut outcome = compared(&scene("slide"), Some("exact"));
    outcome.scene.balls = vec![outcome.scene.balls[0].clone(); 2_500];
    let why = replay(&outcome).unwrap_err();
    assert_eq!(why, "2500 balls are too many to be shown");
    // a clock of f32 moves by 6 s after 1e8 s
    let mut outcome = compared(&scene("slide"), Some("exact"));
    let entry = outcome.entries[0].cell.as_mut().unwrap();
    entry.trace.end_time = 1e8;
    let why = replay(&outcome).unwrap_err();
    assert!(why.contains("clock"), "{why}");
    let mut outcome = compared(&scene("slide"), Some("exact"));
    outcome.entries.clear();
    assert_eq!(replay(&outcome).unwrap_err(), "no engine ran the scene");
}
