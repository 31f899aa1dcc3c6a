//! The report's program, transcribed sentence by sentence and as plainly as possible. It shares no code with `stepper`, so
//! the two can be held against each other to the bit.

use crate::support::{MU, R, report_break, run};
use carom::scene::Scene;
use carom::trace::Record;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Ball {
    r: [f64; 2],
    v: [f64; 2],
}

struct Outcome {
    balls: Vec<Ball>,
    steps: u64,
    exchanges: u64,
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn collide(balls: &mut [Ball], i: usize, j: usize, approaching_only: bool) -> u64 {
    let (a, b) = (balls[i], balls[j]);
    let apart = [a.r[0] - b.r[0], a.r[1] - b.r[1]];
    let distance = dot(apart, apart).sqrt();
    if R + R <= distance {
        return 0;
    }
    let n = [apart[0] / distance, apart[1] / distance];
    let (c1, c2) = (dot(a.v, n), dot(b.v, n));
    if approaching_only && c1 - c2 >= 0.0 {
        return 0;
    }
    let (vn1, vn2) = ([n[0] * c1, n[1] * c1], [n[0] * c2, n[1] * c2]);
    for k in 0..2 {
        balls[i].v[k] = a.v[k] - vn1[k] + vn2[k];
        balls[j].v[k] = b.v[k] - vn2[k] + vn1[k];
    }
    u64::from(balls[i].v != a.v || balls[j].v != b.v)
}

/// Runs the report's program on a table of 12.63 x 24.3 with the cue ball first.
fn transcription(scene: &Scene, dt: f64, approaching_only: bool, mass: f64) -> Outcome {
    let plan = |v: carom::math::Vec3| [v.x, v.y];
    let ball = |b: &carom::scene::Ball| Ball {
        r: plan(b.state.position),
        v: plan(b.state.velocity),
    };
    let mut balls: Vec<Ball> = scene.balls.iter().map(ball).collect();
    let (mut steps, mut exchanges) = (0, 0);
    while (steps as f64) * dt < 20.0 && balls.iter().any(|b| b.v != [0.0, 0.0]) {
        // "every collision[] ball is checked for a collision with the cue ball"
        for j in 1..balls.len() {
            exchanges += collide(&mut balls, 0, j, approaching_only);
        }
        // "whether any of the collision[] balls collided with any other collision[] balls"
        for i in 1..balls.len() {
            for j in i + 1..balls.len() {
                exchanges += collide(&mut balls, i, j, approaching_only);
            }
        }
        // "all of the balls have their velocity updated"
        for b in &mut balls {
            let speed = dot(b.v, b.v).sqrt();
            if speed == 0.0 {
                continue;
            }
            let slower = (-MU * 9.81 * mass * dt + mass * speed) / mass;
            let factor = if slower > 0.0 { slower / speed } else { 0.0 };
            b.v = [b.v[0] * factor, b.v[1] * factor];
        }
        // "moves the ball to the edge of the wall, turns the appropriate velocity component negative"
        for b in &mut balls {
            for (k, size) in [12.63, 24.3].into_iter().enumerate() {
                if b.r[k] < R {
                    b.r[k] = R;
                    b.v[k] = b.v[k].abs();
                }
                if b.r[k] > size - R {
                    b.r[k] = size - R;
                    b.v[k] = -b.v[k].abs();
                }
            }
        }
        // "lastly each ball has their position updated"
        for b in &mut balls {
            for k in 0..2 {
                b.r[k] += b.v[k] * dt;
            }
        }
        steps += 1;
    }
    Outcome {
        balls,
        steps,
        exchanges,
    }
}

#[test]
fn stepper_equals_a_plain_transcription_of_the_report_to_the_bit() {
    for (gap, angle, dt) in [
        (1e-2, 90.2, 1e-3),
        (1e-3, 89.8, 1e-3),
        (1e-2, 75.0, 1e-2),
        (0.0, 90.0, 1e-3),
        (5e-2, 91.0, 1e-4),
    ] {
        for (contact, approaching_only) in [("as-written", false), ("approaching-only", true)] {
            let scene = report_break(gap * R, angle);
            let want = transcription(&scene, dt, approaching_only, 0.107);
            let settings = [format!("dt={dt}"), format!("contact={contact}")];
            let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
            let got = run("stepper", &settings, &scene, Record::Events);
            let case = format!("gap {gap} R, aim {angle}, dt {dt}, {contact}");
            assert_eq!(got.counters["steps"], want.steps, "{case}: steps");
            assert_eq!(
                got.counters["exchanges"], want.exchanges,
                "{case}: exchanges"
            );
            for (i, (state, ball)) in got.final_states().iter().zip(&want.balls).enumerate() {
                let state = state.unwrap();
                let r = [state.position.x, state.position.y];
                assert_eq!(
                    r.map(f64::to_bits),
                    ball.r.map(f64::to_bits),
                    "{case}: ball {i} at {r:?}, not {:?}",
                    ball.r
                );
            }
        }
    }
}
