//! Engine `exact` under generalised reflections with losses, friction and cushions that rub: whole runs.

use crate::random::mapped;
use crate::references::text;
use crate::support::{MU, find, run, scenario};
use carom::engine::Limits;
use carom::engine::exact::{Solution, solve};
use carom::math::{DoubleDouble, Octuple, Real};
use carom::physics::{Cushion, Friction};
use carom::scene::{Scene, Simultaneous, parse};
use carom::trace::{Ending, Record, Trace};
use serde_json::Value;

/// A rolling ball strikes two touching ones at once, e .95, and all roll to rest.
fn one_on_two() -> (Scene, Value) {
    let scene = parse("c1-one-on-two.toml", &text("contact/c1-one-on-two.toml")).unwrap();
    let truth = serde_json::from_str(&text("contact/c1-one-on-two.json")).unwrap();
    (scene, truth)
}

/// Largest distance of a final position from the truth, m.
fn off<T: Real>(solution: &Solution<T>, scene: &Scene, truth: &Value) -> f64 {
    let mut worst: f64 = 0.0;
    for (ball, at) in scene.balls.iter().zip(&solution.positions) {
        for (axis, key) in ["x", "y"].into_iter().enumerate() {
            let digits = truth["final"][ball.id.as_str()][key].as_str().unwrap();
            let known: Octuple = digits.parse().unwrap();
            worst = worst.max((at[axis].widen::<Octuple>() - known).abs().to_f64());
        }
    }
    worst
}

#[test]
fn one_rolling_ball_on_two_comes_to_rest_where_sixty_digits_say() {
    let (scene, truth) = one_on_two();
    let coarse = solve::<f64>(&scene, &Limits::NONE);
    assert_eq!(
        coarse.trace.ending,
        Ending::Rest,
        "{:?}",
        coarse.trace.ending
    );
    let error = off(&coarse, &scene, &truth);
    assert!(error <= 1e-12, "f64: {error:e}");
    // the digits of the truth: it states 1e-20
    let wide = solve::<DoubleDouble>(&scene, &Limits::NONE);
    let error = off(&wide, &scene, &truth);
    assert!(error <= 1e-20, "dd: {error:e}");
    let (time, velocities) = first_impact(&coarse.trace);
    let known: f64 = truth["impact_time"].as_str().unwrap().parse().unwrap();
    assert!((time - known).abs() <= 1e-14, "{time}");
    for (ball, v) in scene.balls.iter().zip(velocities) {
        for axis in 0..2 {
            let digits = truth["velocities_after"][ball.id.as_str()][axis].as_str();
            let want: f64 = digits.unwrap().parse().unwrap();
            assert!((v[axis] - want).abs() <= 1e-14, "{}: {v:?}", ball.id);
        }
    }
}

/// Time of the first collision, and the velocities after it.
fn first_impact(trace: &Trace) -> (f64, Vec<[f64; 2]>) {
    let time = trace.collisions().next().unwrap().time;
    let velocity = |path: &carom::trace::Path| {
        let v = path.state_at(time).unwrap().velocity;
        [v.x, v.y]
    };
    (time, trace.paths.iter().map(velocity).collect())
}

#[test]
fn friction_in_the_impact_of_one_on_two_gains_nothing_and_is_symmetric() {
    let (mut scene, _) = one_on_two();
    scene.effects.friction = Some(Friction::Constant { mu: 0.06 });
    let trace = run("exact", &[], &scene, Record::Events);
    assert_eq!(trace.ending, Ending::Rest, "{:?}", trace.ending);
    let (time, v) = first_impact(&trace);
    assert!(
        v[0][1].abs() <= 1e-13,
        "the cue ball leaves the axis: {v:?}"
    );
    assert!(
        (v[1][0] - v[2][0]).abs() + (v[1][1] + v[2][1]).abs() <= 1e-13,
        "{v:?}"
    );
    let gained = trace.extrema.energy_gained.value;
    assert!(gained <= 1e-13 * scene.initial_energy(), "gains {gained:e}");
    // the spins that friction gave are told, and held against momentum by the closed forms
    let laws = carom::law::closed_forms::check(&scene, &trace);
    assert_eq!(laws.faults, [], "{:?}", laws.faults);
    let turning = trace.paths[1].state_at(time).unwrap().spin;
    assert!(turning.z.abs() > 0.5, "{turning:?}");
}

#[test]
fn a_frozen_rack_with_losses_opens_alike_in_the_mirror() {
    let mut scene = scenario("rack")
        .cushions(12.0, 24.0)
        .cloth(MU)
        .shot("cue", [6.0, 4.0], 16.0, 90.0)
        .rack([6.0, 16.0], 0.0)
        .build();
    scene.simultaneous = Simultaneous::GeneralizedReflections;
    scene.effects.contact = Some(carom::physics::Contact::Inelastic { e: 0.95 });
    scene.effects.cushion = Some(Cushion::Restitution { e: 0.8 });
    let trace = run("exact", &[], &scene, Record::Events);
    let mut mirror = mapped(&scene, |x, y| (12.0 - x, y));
    for (ball, original) in mirror.balls.iter_mut().zip(&scene.balls) {
        ball.state.velocity.x = -original.state.velocity.x;
    }
    let other = run("exact", &[], &mirror, Record::Events);
    let ((_, v), (_, w)) = (first_impact(&trace), first_impact(&other));
    for (ball, (v, w)) in v.iter().zip(&w).enumerate() {
        let error = (v[0] + w[0]).hypot(v[1] - w[1]);
        assert!(error <= 16.0 * 1e-12, "ball {ball} is off by {error:e}");
    }
    let gained = trace.extrema.energy_gained.value;
    assert!(gained <= 1e-12 * scene.initial_energy(), "gains {gained:e}");
}

/// A ball with side spin runs into the corner of two cushions of Han.
fn cornered(simultaneous: Simultaneous) -> Scene {
    let mut scene = scenario("corner")
        .cushions(4.0, 4.0)
        .moving("a", [2.0, 2.0], [1.0, 1.0])
        .duration(3.0)
        .build();
    scene.balls[0].state.spin.z = 3.0;
    scene.effects.cushion = Some(Cushion::Han2005 {
        e: 0.85,
        mu: 0.2,
        height: 1.28,
    });
    scene.simultaneous = simultaneous;
    scene
}

#[test]
fn a_corner_whose_order_matters_is_refused_with_the_keys_that_give_an_answer() {
    let refused = run(
        "exact",
        &[],
        &cornered(Simultaneous::Refuse),
        Record::Events,
    );
    let Ending::Indeterminate(spot) = &refused.ending else {
        panic!("{:?}", refused.ending);
    };
    for key in [
        "simultaneous = \"generalized-reflections\"",
        "simultaneous = \"ensemble\"",
    ] {
        assert!(spot.why.contains(key), "{}", spot.why);
    }
    let scene = cornered(Simultaneous::GeneralizedReflections);
    let trace = run("exact", &[], &scene, Record::Events);
    assert_eq!(trace.ending, Ending::Duration, "{:?}", trace.ending);
    assert_eq!(trace.events[0].time, trace.events[1].time);
    let laws = carom::law::closed_forms::check(&scene, &trace);
    assert_eq!(laws.faults, [], "{:?}", laws.faults);
}

#[test]
fn no_scene_is_beyond_the_convention() {
    let engine = find("exact").unwrap();
    let scene = cornered(Simultaneous::GeneralizedReflections);
    assert_eq!(engine.missing(&scene), Vec::<&str>::new());
}
