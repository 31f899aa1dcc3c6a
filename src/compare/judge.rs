//! An opinion on overlap that is neither the engine's nor ours: parry's.

use super::{Measured, Metric, Reads};
use crate::math::worse;
use crate::physics::State;
use crate::scene::Scene;
use crate::trace::Trace;
use parry3d_f64::math::Pose;
use parry3d_f64::query::contact;
use parry3d_f64::shape::Ball;

/// Deepest overlap that parry sees at the knots of a trace.
pub const OVERLAP_BY_PARRY: Metric = Metric {
    id: "overlap-by-parry",
    unit: "R",
    what: "deepest overlap of two balls that parry sees at the knots of the trace",
    reads: Reads::Trace(|scene, trace| {
        Measured::of_run(deepest_overlap(scene, trace) / scene.smallest_radius())
    }),
};

/// The deepest overlap of two balls at any knot of the trace, length, computed by parry; 0 without one.
///
/// Balls pass through each other where the scene names no contact: nothing is judged there.
pub fn deepest_overlap(scene: &Scene, trace: &Trace) -> f64 {
    if scene.effects.contact.is_none() {
        return 0.0;
    }
    let shapes: Vec<Ball> = scene
        .balls
        .iter()
        .map(|ball| Ball::new(ball.radius))
        .collect();
    let mut times: Vec<f64> = trace
        .paths
        .iter()
        .flat_map(|path| path.knots.iter().map(|knot| knot.time))
        .collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let mut deepest = 0.0;
    for t in times {
        let states: Vec<Option<State>> = (0..trace.paths.len())
            .map(|ball| trace.in_play_at(ball, t))
            .collect();
        deepest = worse(deepest, overlap_at(&shapes, &states));
    }
    deepest
}

fn overlap_at(shapes: &[Ball], states: &[Option<State>]) -> f64 {
    let mut deepest = 0.0;
    for i in 0..states.len() {
        for j in i + 1..states.len() {
            let Some((a, b)) = states[i].zip(states[j]) else {
                continue;
            };
            let apart = b.position - a.position;
            let reach = shapes[i].radius + shapes[j].radius;
            // parry is asked only about pairs that can overlap at all
            if apart.x.abs() < reach && apart.y.abs() < reach {
                deepest = worse(deepest, penetration(&a, &shapes[i], &b, &shapes[j]));
            }
        }
    }
    deepest
}

fn penetration(a: &State, first: &Ball, b: &State, second: &Ball) -> f64 {
    let pose = |s: &State| Pose::translation(s.position.x, s.position.y, s.position.z);
    match contact(&pose(a), first, &pose(b), second, 0.0) {
        Ok(Some(found)) => (-found.dist).max(0.0),
        _ => 0.0,
    }
}
