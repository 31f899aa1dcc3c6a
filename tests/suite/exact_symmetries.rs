//! Engine `exact`: a transformed scene gives the transformed trace.
//!
//! Tolerances are rounding times growth. Rounding is a few ulps of the table's size; growth is bounded from the trace
//! itself: an error `d` across an impact turns its normal by `d / D`, and `v_rel` of the flight after it by as much.

use crate::random::{mapped, scenes};
use crate::support::{MU, run};
use carom::math::Vec3;
use carom::physics::Side;
use carom::scene::Scene;
use carom::trace::{Ending, EventKind, Record, Trace};

const ULP: f64 = f64::EPSILON;

fn exact(scene: &Scene) -> Trace {
    run("exact", &[], scene, Record::Events)
}

/// Upper bound of how much an error at the start has grown by the end, and the slowest normal speed of an impact.
fn growth(trace: &Trace, scene: &Scene) -> (f64, f64) {
    let (mut grown, mut slowest) = (1.0_f64, f64::INFINITY);
    for (i, event) in trace.events.iter().enumerate() {
        match event.kind {
            EventKind::BallBall(a, b) => {
                let (a, b) = (a as usize, b as usize);
                let [p, q] = [a, b].map(|ball| trace.paths[ball].before(event.time).unwrap());
                let n = (q.position - p.position).normalize();
                let relative = (p.velocity - q.velocity).norm();
                let closing = (p.velocity - q.velocity).dot(&n).abs();
                let left = trace.end_time - event.time;
                // until the next event of either ball that is an impact
                let flight = trace.events[i + 1..]
                    .iter()
                    .find(|later| later.kind.is_collision() && later.kind.shares_ball(event.kind))
                    .map_or(left, |later| later.time - event.time);
                // the impact turns by d / (D cos), and 2 v_rel of velocity turn with it; both balls carry it
                grown *= 1.0
                    + 4.0 * relative * relative / closing * flight / scene.contact_distance(a, b);
                slowest = slowest.min(closing);
            }
            EventKind::BallCushion(a, side) => {
                let v = trace.paths[a as usize].before(event.time).unwrap().velocity;
                slowest = slowest.min(v[side.axis()].abs());
            }
            _ => {}
        }
    }
    (grown, slowest)
}

/// What positions of a run are good to, length: rounding of coordinates and of paths, grown.
fn position_error(trace: &Trace, scene: &Scene) -> f64 {
    let path = scene.largest_speed() * trace.end_time;
    16.0 * ULP * (scene.largest_coordinate() + path) * growth(trace, scene).0
}

/// Final positions and event kinds of a run against those of a transformed one, brought back by `back`.
fn hold_symmetry(
    what: &str,
    scene: &Scene,
    other: &Scene,
    kind: impl Fn(EventKind) -> EventKind,
    back: impl Fn(usize, Vec3) -> (usize, Vec3),
    exactly: bool,
) -> bool {
    let (trace, image) = (exact(scene), exact(other));
    let allowed = if exactly {
        0.0
    } else {
        position_error(&trace, scene).max(position_error(&image, other))
    };
    // beyond this the bound says nothing about a table of 10
    if allowed > 1e-3 {
        return false;
    }
    let kinds: Vec<_> = trace.events.iter().map(|event| event.kind).collect();
    let images: Vec<_> = image.events.iter().map(|event| kind(event.kind)).collect();
    assert_eq!(kinds, images, "{what} of {}: order", scene.name);
    for i in 0..scene.balls.len() {
        let (ball, position) = back(i, image.paths[i].last().unwrap().position);
        let expected = trace.paths[ball].last().unwrap().position;
        let error = (position - expected).norm();
        assert!(
            error <= allowed,
            "{what} of {}: ball {ball} off by {error:e}, allowed {allowed:e}",
            scene.name
        );
    }
    if exactly {
        for (a, b) in trace.events.iter().zip(&image.events) {
            assert_eq!(a.time, b.time, "{what} of {}", scene.name);
        }
    }
    true
}

fn swap(kind: EventKind, side: impl Fn(Side) -> Side) -> EventKind {
    match kind {
        EventKind::BallCushion(ball, s) => EventKind::BallCushion(ball, side(s)),
        other => other,
    }
}

#[test]
fn a_mirrored_scene_gives_the_mirrored_trace() {
    let mut compared = 0;
    for scene in scenes(MU, 6).into_iter().chain(scenes(0.0, 6)) {
        let flip = |kind| {
            swap(kind, |s| match s {
                Side::X0 => Side::X1,
                Side::X1 => Side::X0,
                other => other,
            })
        };
        // about x = 0 every operation is odd: equal to the bit
        let mirrored = mapped(&scene, |x, y| (-x, y));
        let back = |i, p: Vec3| (i, Vec3::new(-p.x, p.y, p.z));
        assert!(hold_symmetry(
            "mirror about 0",
            &scene,
            &mirrored,
            flip,
            back,
            true
        ));
        // about the middle of the table coordinates round differently
        let mut mirrored = mapped(&scene, |x, y| (-x, y));
        for ball in &mut mirrored.balls {
            ball.state.position.x += 6.0;
        }
        mirrored.table = scene.table;
        let back = |i, p: Vec3| (i, Vec3::new(6.0 - p.x, p.y, p.z));
        compared += usize::from(hold_symmetry(
            "mirror", &scene, &mirrored, flip, back, false,
        ));
    }
    assert!(
        compared > 60,
        "only {compared} scenes whose growth is small enough"
    );
}

#[test]
fn a_turned_scene_gives_the_turned_trace() {
    for scene in scenes(MU, 6).into_iter().chain(scenes(0.0, 6)) {
        // a quarter turn about the origin only swaps and negates: equal to the bit
        let turned = mapped(&scene, |x, y| (-y, x));
        // (x, y) went to (-y, x): the image's x1 was y0, its y1 was x1, its x0 was y1, its y0 was x0
        let kind = |kind| {
            swap(kind, |s| match s {
                Side::X1 => Side::Y0,
                Side::Y1 => Side::X1,
                Side::X0 => Side::Y1,
                Side::Y0 => Side::X0,
            })
        };
        let back = |i, p: Vec3| (i, Vec3::new(p.y, -p.x, p.z));
        assert!(hold_symmetry(
            "quarter turn",
            &scene,
            &turned,
            kind,
            back,
            true
        ));
    }
}

#[test]
fn the_order_of_balls_in_the_scene_does_not_change_the_trace() {
    let mut compared = 0;
    for scene in scenes(MU, 6).into_iter().chain(scenes(0.0, 6)) {
        let n = scene.balls.len();
        let mut other = scene.clone();
        other.balls.reverse();
        let back = |i: usize, p: Vec3| (n - 1 - i, p);
        let label = |ball: u32| n as u32 - 1 - ball;
        let kind = |kind| match kind {
            EventKind::BallBall(a, b) => EventKind::ball_ball(label(a) as usize, label(b) as usize),
            EventKind::BallCushion(a, side) => EventKind::BallCushion(label(a), side),
            EventKind::Stop(a) => EventKind::Stop(label(a)),
            other => other,
        };
        compared += usize::from(hold_symmetry(
            "relabelling",
            &scene,
            &other,
            kind,
            back,
            false,
        ));
    }
    assert!(
        compared > 60,
        "only {compared} scenes whose growth is small enough"
    );
}

fn scaled(scene: &Scene, s: f64) -> Scene {
    let mut scaled = mapped(scene, |x, y| (s * x, s * y));
    scaled.gravity *= s;
    for ball in &mut scaled.balls {
        ball.radius *= s;
        ball.state.position.z = ball.radius;
    }
    scaled
}

#[test]
fn lengths_speeds_and_gravity_scaled_together_leave_times_unchanged() {
    let mut compared = 0;
    for scene in scenes(MU, 6).into_iter().chain(scenes(0.0, 6)) {
        // a power of two scales every operation without rounding
        for (s, exactly) in [(0.125, true), (3.7, false)] {
            let other = scaled(&scene, s);
            let back = |i: usize, p: Vec3| (i, p / s);
            let held = hold_symmetry(
                &format!("scaling by {s}"),
                &scene,
                &other,
                |k| k,
                back,
                exactly,
            );
            assert!(held || !exactly);
            compared += usize::from(held);
        }
    }
    assert!(compared > 180, "only {compared} comparisons");
}

#[test]
fn without_friction_a_reversed_end_state_runs_back_to_the_start() {
    let mut compared = 0;
    for scene in scenes(0.0, 20) {
        let forth = exact(&scene);
        assert_eq!(forth.ending, Ending::Duration);
        let mut reversed = scene.clone();
        for (ball, state) in reversed.balls.iter_mut().zip(forth.final_states()) {
            let state = state.unwrap();
            ball.state.position = state.position;
            ball.state.velocity = -state.velocity;
        }
        let back = exact(&reversed);
        // errors of the way out grow on the way back
        let allowed = position_error(&forth, &scene) * growth(&back, &reversed).0
            + position_error(&back, &reversed);
        if allowed > 1e-3 {
            continue;
        }
        compared += 1;
        // collisions only: a ball that was hit from rest comes to rest on the way back
        let kinds = |trace: &Trace| -> Vec<EventKind> {
            trace.collisions().map(|event| event.kind).collect()
        };
        let mut reverse = kinds(&back);
        reverse.reverse();
        assert_eq!(kinds(&forth), reverse, "{}: order", scene.name);
        for (ball, path) in scene.balls.iter().zip(&back.paths) {
            let error = (path.last().unwrap().position - ball.state.position).norm();
            assert!(
                error <= allowed,
                "{}: ball {} off by {error:e}, allowed {allowed:e}",
                scene.name,
                ball.id
            );
        }
    }
    assert!(
        compared > 60,
        "only {compared} scenes whose growth is small enough"
    );
}
