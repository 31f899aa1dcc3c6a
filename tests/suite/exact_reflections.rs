//! Engine `exact` under generalised reflections: touching balls resolved together.

use crate::random::mapped;
use crate::support::{MU, R, report_break, run, scenario};
use carom::math::Vec3;
use carom::scene::{Scene, Simultaneous, catalogue};
use carom::trace::{Ending, EventKind, Record, Trace};

/// Speeds come from a few dozen sums and products of numbers of the size of the shot's speed.
const ROUNDING: f64 = 1e-12;

fn reflected(mut scene: Scene) -> (Scene, Trace) {
    scene.simultaneous = Simultaneous::GeneralizedReflections;
    let trace = run("exact", &[], &scene, Record::Events);
    (scene, trace)
}

/// Velocities on the far side of the first instant at which something happens, and that instant.
fn after_the_first_impact(trace: &Trace) -> (f64, Vec<Vec3>) {
    let time = trace.events[0].time;
    let velocity = |path: &carom::trace::Path| path.state_at(time).unwrap().velocity;
    (time, trace.paths.iter().map(velocity).collect())
}

fn energy_after(scene: &Scene, trace: &Trace, time: f64, before: bool) -> f64 {
    let states: Vec<_> = trace
        .paths
        .iter()
        .map(|path| {
            if before {
                path.before(time)
            } else {
                path.state_at(time)
            }
            .unwrap()
        })
        .collect();
    scene.kinetic_energy(&states)
}

#[test]
fn a_cradle_sends_out_as_many_balls_as_come_in() {
    let spacing = 2.0 * R;
    for incoming in 1..=3 {
        // from far away together, in line, each touching the next
        let mut balls = scenario("cradle").duration(1.0);
        for i in 0..incoming {
            let y = -1.0 - spacing * f64::from(incoming - 1 - i);
            balls = balls.moving(&format!("in-{i}"), [0.0, y], [0.0, 5.0]);
        }
        for i in 0..4 {
            balls = balls.resting(&format!("{i}"), [0.0, spacing * f64::from(i)]);
        }
        let (scene, trace) = reflected(balls.build());
        assert_eq!(trace.ending, Ending::Duration, "{incoming} in");
        let (_, velocities) = after_the_first_impact(&trace);
        let n = scene.balls.len();
        for (i, v) in velocities.iter().enumerate() {
            let expected = if i + incoming as usize >= n { 5.0 } else { 0.0 };
            assert!(
                (v - Vec3::new(0.0, expected, 0.0)).norm() <= 5.0 * ROUNDING,
                "{incoming} in: ball {i} has {v:?}, expected {expected}"
            );
        }
    }
}

#[test]
fn a_ball_into_two_touching_ones_comes_back_with_a_fifth_of_its_speed() {
    let scene = catalogue::scene("triple-hit-reflections").unwrap();
    let trace = run("exact", &[], &scene, Record::Events);
    assert_eq!(trace.ending, Ending::Duration);
    let kinds: Vec<EventKind> = trace.events.iter().map(|e| e.kind).collect();
    assert_eq!(
        kinds,
        [EventKind::BallBall(0, 1), EventKind::BallBall(0, 2)]
    );
    let (_, v) = after_the_first_impact(&trace);
    let across = 0.6 / 3.0_f64.sqrt();
    for (i, expected) in [[0.0, -0.2], [-across, 0.6], [across, 0.6]]
        .iter()
        .enumerate()
    {
        let error = (v[i].xy() - nalgebra::Vector2::from(*expected)).norm();
        // positions of size 1 are good to an ulp, normals to an ulp over the ball's diameter
        assert!(
            error <= ROUNDING,
            "ball {i}: {:?}, expected {expected:?}",
            v[i]
        );
    }
    let refused = catalogue::scene("triple-hit").unwrap();
    let refused = run("exact", &[], &refused, Record::Events);
    assert!(
        matches!(refused.ending, Ending::Indeterminate(_)),
        "{:?}",
        refused.ending
    );
}

#[test]
fn a_frozen_rack_hit_in_the_centre_opens_symmetrically_and_keeps_its_energy() {
    let (scene, trace) = reflected(report_break(0.0, 90.0));
    assert!(trace.ending.is_complete(), "{:?}", trace.ending);
    let (time, v) = after_the_first_impact(&trace);
    let speed = scene.largest_speed();
    // ball 0 is the cue; row r of the rack begins at 1 + r (r + 1) / 2
    for row in 0..5 {
        let first = 1 + row * (row + 1) / 2;
        for place in 0..=row {
            let (one, other) = (v[first + place], v[first + row - place]);
            let error = (one.x + other.x).hypot(one.y - other.y);
            assert!(
                error <= speed * ROUNDING,
                "row {row}, place {place}: {one:?}, {other:?}"
            );
        }
    }
    let (before, after) = (
        energy_after(&scene, &trace, time, true),
        energy_after(&scene, &trace, time, false),
    );
    assert!(
        (after - before).abs() <= before * ROUNDING,
        "{before} becomes {after}"
    );
    let gained = trace.extrema.energy_gained.value;
    assert!(gained <= before * ROUNDING, "gains {gained:e}");
    // one event a pair at the instant
    let mut pairs: Vec<EventKind> = trace
        .collisions()
        .take_while(|event| event.time == time)
        .map(|event| event.kind)
        .collect();
    let rows = pairs.len();
    pairs.sort_by_key(|kind| kind.balls());
    pairs.dedup();
    assert!(
        rows > 15 && pairs.len() == rows,
        "{rows} rows, {} pairs",
        pairs.len()
    );
}

#[test]
fn other_orders_of_the_balls_and_the_mirror_image_open_a_frozen_rack_alike() {
    let scene = catalogue::scene("report-break-frozen-reflections").unwrap();
    let (_, trace) = reflected(scene.clone());
    assert!(trace.ending.is_complete(), "{:?}", trace.ending);
    let (_, v) = after_the_first_impact(&trace);
    let allowed = scene.largest_speed() * ROUNDING;
    let n = scene.balls.len();
    for stride in [3, 5, 7, 15] {
        // a permutation, as no stride shares a factor with 16
        let order: Vec<usize> = (0..n).map(|i| (i * stride) % n).collect();
        let mut other = scene.clone();
        other.balls = order.iter().map(|i| scene.balls[*i].clone()).collect();
        let (_, w) = after_the_first_impact(&reflected(other).1);
        for (place, ball) in order.iter().enumerate() {
            let error = (w[place] - v[*ball]).norm();
            assert!(
                error <= allowed,
                "stride {stride}: ball {ball} is off by {error:e}"
            );
        }
    }
    let (_, mirror) = after_the_first_impact(&reflected(mapped(&scene, |x, y| (-x, y))).1);
    for (ball, (a, b)) in v.iter().zip(&mirror).enumerate() {
        let error = (a.x + b.x).hypot(a.y - b.y);
        assert!(error <= allowed, "mirror: ball {ball} is off by {error:e}");
    }
}

#[test]
fn a_ball_frozen_to_a_cushion_and_a_neighbour_keeps_energy_when_driven_into_both() {
    let (x, y) = (4.0 - R, 2.0);
    let scene = scenario("frozen")
        .cushions(4.0, 8.0)
        .cloth(MU)
        .moving("cue", [x - 1.5, y - 1.0], [3.0, 2.0])
        .resting("1", [x, y])
        .resting("2", [x - R, y + 3.0_f64.sqrt() * R])
        .build();
    let (scene, trace) = reflected(scene);
    assert!(trace.ending.is_complete(), "{:?}", trace.ending);
    let (time, _) = after_the_first_impact(&trace);
    let (before, after) = (
        energy_after(&scene, &trace, time, true),
        energy_after(&scene, &trace, time, false),
    );
    assert!(
        (after - before).abs() <= before * ROUNDING,
        "{before} becomes {after}"
    );
    let cushion = |e: &&carom::trace::Event| matches!(e.kind, EventKind::BallCushion(1, _));
    assert_eq!(
        trace.events.iter().find(cushion).map(|e| e.time),
        Some(time)
    );
}

#[test]
fn a_light_ball_pressed_between_heavy_ones_sends_them_back_with_their_own_speed() {
    // by symmetry it stays where it is, and energy is kept; along a direction in which normals are rounded
    let (sin, cos) = 1.3_f64.sin_cos();
    for ratio in [1.0, 1e2, 1e4, 1e6, 1e9] {
        let (x, y) = (2.0 * R * cos, 2.0 * R * sin);
        let (vx, vy) = (3.0 * cos, 3.0 * sin);
        let balls = scenario("pressed")
            .resting("light", [0.0, 0.0])
            .with_mass(1.0 / ratio)
            .moving("left", [-x, -y], [vx, vy])
            .with_mass(1.0)
            .moving("right", [x, y], [-vx, -vy])
            .with_mass(1.0)
            .duration(1.0);
        let (scene, trace) = reflected(balls.build());
        assert_eq!(trace.ending, Ending::Duration, "ratio {ratio:e}");
        let (time, velocities) = after_the_first_impact(&trace);
        for (ball, sign) in [(1, -1.0), (2, 1.0)] {
            let want = Vec3::new(sign * vx, sign * vy, 0.0);
            let error = (velocities[ball] - want).norm();
            // the directions of the two normals differ by an ulp or so, which a light ball between them turns into as much
            assert!(error <= 3.0 * ROUNDING, "ratio {ratio:e}: {error:e}");
        }
        let gained = energy_after(&scene, &trace, time, false) / scene.initial_energy() - 1.0;
        assert!(gained.abs() <= ROUNDING, "ratio {ratio:e}: {gained:e}");
    }
}
