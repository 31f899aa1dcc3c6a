//! An opinion on overlap that is neither the engine's nor ours: parry's.

use super::{Measured, Metric, Reads};
use crate::finding::Hold;
use crate::math::worse;
use crate::physics::State;
use crate::scene::Scene;
use crate::trace::{Contacts, Trace, UNEXPLAINED_IN_CONTACT};
use parry3d_f64::math::Pose;
use parry3d_f64::query::contact;
use parry3d_f64::shape::Ball;

/// Deepest overlap that parry sees at the knots of a trace.
pub const OVERLAP_BY_PARRY: Metric = Metric {
    id: "overlap-by-parry",
    unit: "R",
    hold: Hold::Figure,
    what: "deepest overlap of two balls that parry sees at the knots of the trace",
    reads: Reads::Trace(|scene, trace| {
        Measured::of_run(deepest_overlap(scene, trace) / scene.smallest_radius())
    }),
};

/// An overlap of two balls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// The balls, indices in scene order.
    pub balls: (usize, usize),
    /// s.
    pub time: f64,
    /// Length.
    pub depth: f64,
}

/// The deepest overlap of two balls at any knot of the trace, length, computed by parry; 0 without one.
///
/// Balls pass through each other where the scene names no contact: nothing is judged there.
pub fn deepest_overlap(scene: &Scene, trace: &Trace) -> f64 {
    worst_overlap(scene, trace, &|_, _| 1.0).map_or(0.0, |worst| worst.depth)
}

/// The overlap of two balls at any knot of the trace, computed by parry, that is the deepest in units of `allowed`, a length for
/// each pair; `None` without one.
///
/// Balls pass through each other where the scene names no contact: nothing is judged there.
pub fn worst_overlap(
    scene: &Scene,
    trace: &Trace,
    allowed: &dyn Fn(usize, usize) -> f64,
) -> Option<Overlap> {
    scene.effects.contact?;
    let shapes: Vec<Ball> = scene
        .balls
        .iter()
        .map(|ball| Ball::new(ball.radius))
        .collect();
    let knots = |ball: usize| &trace.paths[ball].knots;
    let mut times: Vec<f64> = (0..shapes.len())
        .flat_map(|ball| knots(ball).iter().map(|knot| knot.time))
        .collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    // where a ball left play, others may follow
    let left: Vec<f64> = (0..shapes.len())
        .map(|ball| match (trace.pocketed(ball), knots(ball).last()) {
            (true, Some(last)) => last.time,
            _ => f64::INFINITY,
        })
        .collect();
    let contacts = trace.follows_contacts().then(|| Contacts::of(trace));
    let (mut worst, mut share) = (None, 0.0);
    for time in times {
        // between knots of its own a ball in contact is elsewhere than they say, by so much
        let unexplained = |contacts: &Contacts, ball: usize| {
            let own = knots(ball).binary_search_by(|knot| knot.time.total_cmp(&time));
            if own.is_err() && contacts.during(ball, [time; 2]) {
                UNEXPLAINED_IN_CONTACT * scene.balls[ball].radius
            } else {
                0.0
            }
        };
        let states: Vec<Option<State>> = (0..shapes.len())
            .map(|ball| {
                let state = || trace.paths[ball].state_at(time);
                if time >= left[ball] { None } else { state() }
            })
            .collect();
        for (balls, depth) in overlaps_at(&shapes, &states) {
            let depth = contacts.as_ref().map_or(depth, |contacts| {
                let [a, b] = [balls.0, balls.1].map(|ball| unexplained(contacts, ball));
                depth - a - b
            });
            let part = depth / allowed(balls.0, balls.1);
            if worse(part, share).to_bits() != share.to_bits() {
                (worst, share) = (Some(Overlap { balls, time, depth }), part);
            }
        }
    }
    worst
}

fn overlaps_at(
    shapes: &[Ball],
    states: &[Option<State>],
) -> impl Iterator<Item = ((usize, usize), f64)> {
    let pairs = (0..states.len()).flat_map(move |i| (i + 1..states.len()).map(move |j| (i, j)));
    pairs.filter_map(|(i, j)| {
        let (a, b) = states[i].zip(states[j])?;
        let apart = b.position - a.position;
        let reach = shapes[i].radius + shapes[j].radius;
        // parry is asked only about pairs that can overlap at all
        let near = apart.x.abs() < reach && apart.y.abs() < reach;
        near.then(|| ((i, j), penetration(&a, &shapes[i], &b, &shapes[j])))
    })
}

fn penetration(a: &State, first: &Ball, b: &State, second: &Ball) -> f64 {
    let pose = |s: &State| Pose::translation(s.position.x, s.position.y, s.position.z);
    match contact(&pose(a), first, &pose(b), second, 0.0) {
        Ok(Some(found)) => worse(0.0, -found.dist),
        _ => 0.0,
    }
}
