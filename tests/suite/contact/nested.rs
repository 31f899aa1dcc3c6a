//! Several encounters whose impacts shrink together: balls pressed to one that knocks at another, chains of balls that knock at each other.

use carom::engine::Limits;
use carom::engine::exact::solve_following;
use carom::physics::State;
use carom::scene::perturb::{Law, Perturbation};
use carom::scene::{Scene, parse};
use carom::study::random::{check, scene};
use carom::trace::{Ending, EventKind, UNEXPLAINED_IN_CONTACT};

/// The pool break at 2 m/s, moved by the law of `carom ensemble --seed 3`.
fn soft_break(index: u64) -> Scene {
    let hard = include_str!("../../../validation/scenes/pool-break.toml");
    let soft = hard.replace("\nspeed = 12.0\n", "\nspeed = 2.0\n");
    assert_ne!(soft, hard, "another speed");
    let scene = parse("pool-break", &soft).unwrap_or_else(|error| panic!("{error}"));
    let drawn = Perturbation::new(&scene, Law::default_for(&scene));
    drawn
        .unwrap_or_else(|error| panic!("{error}"))
        .sample(3, index)
}

/// A random scene of `carom fuzz`.
fn random(seed: u64, index: u64) -> Scene {
    scene(seed, index).unwrap_or_else(|error| panic!("{error:?}"))
}

fn budget() -> Limits<'static> {
    Limits {
        max_events: 1000,
        ..Limits::NONE
    }
}

#[test]
fn a_soft_break_goes_on_through_nested_limits_to_rest_and_gains_nothing() {
    let mut most = 0;
    for index in [0, 1, 9, 10] {
        let scene = soft_break(index);
        let trace = solve_following::<f64>(&scene, &Limits::NONE).trace;
        assert_eq!(trace.ending, Ending::Rest, "sample {index}");
        let extrema = &trace.extrema;
        let (gained, overlap) = (extrema.energy_gained.value, extrema.overlap.value);
        assert!(gained <= 1e-12, "sample {index} gains {gained:e} J");
        let touching = scene.touching();
        assert!(overlap <= touching, "sample {index}: overlap {overlap:e} m");
        let unexplained = trace.unexplained();
        let allowed = 1.01 * UNEXPLAINED_IN_CONTACT * scene.smallest_radius();
        assert!(
            unexplained <= allowed,
            "sample {index}: {unexplained:e} m, allowed {allowed:e}"
        );
        let begins = |kind: EventKind| matches!(kind, EventKind::ContactBegin(..));
        most = most.max(trace.events.iter().filter(|e| begins(e.kind)).count());
    }
    assert!(most >= 100, "no sample has more than {most} contacts");
}

#[test]
fn friction_that_turns_pressed_balls_back_and_forth_gives_them_nothing() {
    // ten balls in a row that touch, of which four roll: the others slide, and rub on them with a slip that soon vanishes. A series that is followed
    // beyond where the slip does turns them out of nothing
    let scene = random(101, 45);
    let trace = solve_following::<f64>(&scene, &budget()).trace;
    let contacts = |kind: EventKind| matches!(kind, EventKind::ContactBegin(..));
    assert!(trace.events.iter().any(|e| contacts(e.kind)), "no contact");
    let faults = check(&scene, &trace, true).faults;
    assert!(faults.is_empty(), "{faults:?}");
}

#[test]
fn balls_keep_their_numbers_where_a_contact_takes_all_of_a_speed_and_where_a_slip_soon_vanishes() {
    // one rolls into a cushion as slowly as rounding, and no longer rolls anywhere; three others rub with a slip that lasts some 1e-14 s, and the
    // coefficients of their series grow beyond the range of numbers
    let scene = random(102, 369);
    let trace = solve_following::<f64>(&scene, &budget()).trace;
    let numbers = |state: &State| state.position.iter().all(|x| x.is_finite());
    for (ball, path) in trace.paths.iter().enumerate() {
        let strange = path.knots.iter().find(|knot| !numbers(&knot.state));
        assert!(strange.is_none(), "ball {ball}: {strange:?}");
    }
}

#[test]
fn a_gap_that_closes_by_its_rate_alone_is_not_closed_before() {
    // a ball that rolls along a cushion, and others that fly at it: no acceleration is above 1e-28, which is nothing beside the speeds
    let scene = random(100, 165);
    let trace = solve_following::<f64>(&scene, &budget()).trace;
    let hits = trace.collisions().filter_map(|event| match event.kind {
        EventKind::BallBall(a, b) => Some((event.time, a as usize, b as usize)),
        _ => None,
    });
    let mut held = 0;
    for (time, a, b) in hits {
        let place = |ball: usize| trace.paths[ball].state_at(time).map(|state| state.position);
        let Some((p, q)) = place(a).zip(place(b)) else {
            continue;
        };
        let apart = (p - q).norm();
        let touch = scene.balls[a].radius + scene.balls[b].radius;
        assert!(
            (apart - touch).abs() <= scene.touching(),
            "{a} and {b} at {time} s: {apart}"
        );
        held += 1;
    }
    assert!(held >= 5, "{held} hits");
}
