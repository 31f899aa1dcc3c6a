//! A replay as the data that a browser reads: JSON, with the knots as compressed columns.
//!
//! A run's columns stand one after another: time, then x, y, z, then the three velocities, and the three spins where balls turn; each
//! for all balls in scene order, ball by ball. Numbers are f32, little end first, positions from the origin in R, velocities in the speed
//! scale, spins in speed scale / R, times in s. Of each column first the lowest byte of every number, then the second, and so on, which
//! compresses better. The whole is a raw deflate stream in base64.

use crate::finding::{Replay, ReplayRun};
use crate::trace::Knot;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use miniz_oxide::deflate::compress_to_vec;
use serde_json::{Value, json};

/// Of the format; a page and its script agree on it.
const FORMAT: u32 = 1;

/// Effort of the compression, 0 to 10: from here on more of it saves less than a hundredth.
const LEVEL: u8 = 6;

/// Digits of a distance in a curve.
const DIGITS: usize = 4;

/// The replay as JSON. What is not finite is `null` there, and what it is in f32 in the columns.
pub fn data(replay: &Replay) -> String {
    let balls: Vec<Value> = replay
        .balls
        .iter()
        .map(|ball| {
            json!({ "id": ball.id, "radius": ball.radius, "mass": ball.mass, "inertia": ball.inertia })
        })
        .collect();
    let partings: Vec<Value> = replay
        .partings
        .iter()
        .map(|parting| {
            json!({
                "time": parting.time, "runs": parting.runs, "balls": parting.balls,
                "words": parting.words
            })
        })
        .collect();
    let divergence: Vec<Value> = replay
        .divergence
        .iter()
        .map(|curve| {
            let points: Vec<_> = curve
                .points
                .iter()
                .map(|p| [rounded(p[0], 7), rounded(p[1], DIGITS)])
                .collect();
            json!({ "run": curve.run, "against": curve.against, "points": points })
        })
        .collect();
    json!({
        "format": FORMAT,
        "scene": {
            "name": replay.scene, "title": replay.scene, "duration": replay.duration,
            "length_unit": replay.length_unit, "time_unit": replay.time_unit,
            "speed_scale": replay.speed_scale
        },
        "origin": replay.origin,
        "R": replay.radius,
        "table": replay.table.map(|[min, max]| json!({ "min": min, "max": max })),
        "pockets": replay.pockets,
        "rotates": replay.rotates,
        "balls": balls,
        "runs": replay.runs.iter().map(|run| of_run(run, replay)).collect::<Vec<_>>(),
        "partings": partings,
        "horizon": replay.horizon,
        "divergence": divergence,
        "remark": replay.remark,
    })
    .to_string()
}

fn of_run(run: &ReplayRun, replay: &Replay) -> Value {
    let events: Vec<Value> = run
        .events
        .iter()
        .map(|event| json!([event.time, event.kind, event.a, event.b]))
        .collect();
    let counts: Vec<usize> = run.paths.iter().map(|path| path.knots.len()).collect();
    json!({
        "label": run.label, "engine": run.engine, "reference": run.reference, "end": run.end,
        "ending": run.ending, "resolution": run.resolution, "events": events,
        "knots": {
            "counts": counts, "left_out": run.left_out, "tolerance": run.tolerance,
            "bytes": STANDARD.encode(compress_to_vec(&columns(run, replay), LEVEL))
        }
    })
}

/// All numbers of all knots.
fn columns(run: &ReplayRun, replay: &Replay) -> Vec<u8> {
    let (length, speed) = (replay.radius, replay.speed_scale);
    let number = |knot: &Knot, column: usize| {
        let (state, axis) = (&knot.state, (column + 2) % 3);
        match column {
            0 => knot.time,
            1..=3 => (state.position[axis] - replay.origin[axis]) / length,
            4..=6 => state.velocity[axis] / speed,
            _ => state.spin[axis] / speed * length,
        }
    };
    let mut bytes = Vec::new();
    for column in 0..if replay.rotates { 10 } else { 7 } {
        let knots = run.paths.iter().flat_map(|path| &path.knots);
        let numbers: Vec<[u8; 4]> = knots
            .map(|knot| (number(knot, column) as f32).to_le_bytes())
            .collect();
        for plane in 0..4 {
            bytes.extend(numbers.iter().map(|number| number[plane]));
        }
    }
    bytes
}

/// A number with this many digits: a picture needs no more.
fn rounded(x: f64, digits: usize) -> f64 {
    format!("{x:.*e}", digits - 1).parse().unwrap_or(x)
}
