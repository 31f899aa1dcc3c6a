//! Reads the reference files in `validation/references/`: initial data, events with states, final states.
//!
//! Their numbers are decimal strings with more digits than f64 has; they are rounded once, by the parser.

use crate::support::scenario;
use carom::math::Vec3;
use carom::physics::{Side, State};
use carom::scene::{Ball, Scene};
use carom::trace::EventKind;
use serde_json::Value;

/// One file of an arbitrary-precision event-driven solver.
pub struct Reference {
    /// The scene it was run on.
    pub scene: Scene,
    pub events: Vec<ReferenceEvent>,
    pub end_time: f64,
    /// Final centre and velocity of every ball.
    pub finals: Vec<([f64; 2], [f64; 2])>,
}

pub struct ReferenceEvent {
    pub time: f64,
    pub kind: EventKind,
    /// Ball, centre, velocity after the event.
    pub states: Vec<(usize, [f64; 2], [f64; 2])>,
}

/// Text of a file in `validation/references/`.
pub fn text(name: &str) -> String {
    let path = format!(
        "{}/validation/references/{name}",
        env!("CARGO_MANIFEST_DIR")
    );
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Reads `NAME.json` of the mp family (d1, d2, e).
pub fn reference(name: &str) -> Reference {
    let file: Value = serde_json::from_str(&text(&format!("{name}.json"))).unwrap();
    let meta = &file["meta"];
    let scene = scene(name, meta);
    // d1 and d2 name the walls x0, xL, y0, yW and so does e; in all of them x runs to the first and y to the second
    let ball = |id: &Value| -> usize {
        match id {
            Value::String(id) => scene.ball_index(id).unwrap(),
            other => other.as_u64().unwrap() as usize,
        }
    };
    let events = file["events"].as_array().unwrap().iter().map(|event| {
        let ids = event["ids"].as_array().unwrap();
        let kind = match event["type"].as_str().unwrap() {
            "ball_ball" => EventKind::ball_ball(ball(&ids[0]), ball(&ids[1])),
            "ball_wall" => EventKind::BallCushion(ball(&ids[0]) as u32, side(&ids[1])),
            "stop" => EventKind::Stop(ball(&ids[0]) as u32),
            other => panic!("{name}: event type {other}"),
        };
        let state = |b: &Value| (ball(&b["id"]), pair(&b["r"]), pair(&b["v_after"]));
        ReferenceEvent {
            time: number(&event["t"]),
            kind,
            states: event["balls"]
                .as_array()
                .unwrap()
                .iter()
                .map(state)
                .collect(),
        }
    });
    let events: Vec<ReferenceEvent> = events.collect();
    let last = &file["final"];
    let positions = last["r"].as_array().unwrap().iter().map(pair);
    let velocities = last["v"].as_array().unwrap().iter().map(pair);
    Reference {
        end_time: number(&last["t"]),
        finals: positions.zip(velocities).collect(),
        events,
        scene,
    }
}

fn scene(name: &str, meta: &Value) -> Scene {
    let mu = meta["mu"].as_f64().unwrap();
    let edge = |keys: [&str; 2]| keys.iter().find_map(|k| meta[*k].as_f64()).unwrap();
    let mut builder = scenario(name).cushions(edge(["table_x", "L"]), edge(["table_y", "W"]));
    if mu > 0.0 {
        builder = builder.cloth(mu);
    }
    let mut scene = builder.build();
    scene.gravity = meta["g"].as_f64().unwrap_or(0.0);
    let radius = meta["R"].as_f64().unwrap();
    let positions = meta["r0"].as_array().unwrap();
    for (i, (r, v)) in positions
        .iter()
        .zip(meta["v0"].as_array().unwrap())
        .enumerate()
    {
        let ([x, y], [vx, vy]) = (pair(r), pair(v));
        let mass = meta["m"].as_f64().or_else(|| meta["masses"][i].as_f64());
        scene.balls.push(Ball {
            id: meta["names"][i]
                .as_str()
                .map_or_else(|| i.to_string(), str::to_owned),
            radius,
            mass: mass.unwrap(),
            state: State {
                position: Vec3::new(x, y, radius),
                velocity: Vec3::new(vx, vy, 0.0),
                spin: Vec3::zeros(),
            },
        });
    }
    scene
}

fn side(id: &Value) -> Side {
    match id.as_str().unwrap() {
        "x0" => Side::X0,
        "xL" => Side::X1,
        "y0" => Side::Y0,
        "yW" => Side::Y1,
        other => panic!("wall {other}"),
    }
}

fn pair(value: &Value) -> [f64; 2] {
    [number(&value[0]), number(&value[1])]
}

fn number(value: &Value) -> f64 {
    match value {
        Value::String(digits) => digits.parse().unwrap(),
        other => other.as_f64().unwrap(),
    }
}
