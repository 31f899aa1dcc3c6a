//! Contacts in line in closed form: who pushes whom, how fast, and until when. Per mass: a ball that slides with its topspin
//! pushes k rolling ones at (mu_s - 7k/5 mu_r) g / (1 + 7k/5), because a pushed ball that rolls has the mass 7/5.

use super::{G, MU_ROLL, MU_SLIDE, R};
use carom::engine::Limits;
use carom::engine::exact::solve;
use carom::scene::{Scene, parse};
use carom::trace::{Ending, EventKind, Trace};

/// Common speed of a row at the start, m/s, and the topspin of the ball at its end, rad/s.
const V: f64 = 0.5;
const TOPSPIN: f64 = 120.0;

/// Relative error of a closed form: some roundings of times and places that are read from knots.
const CLOSED: f64 = 1e-12;

/// Touching balls in line along x with speeds, m/s, and topspins, rad/s, on a cloth with `mu_roll`.
fn row(balls: &[(f64, f64)], mu_ball: f64, mu_roll: f64) -> Scene {
    let mut text = format!(
        "name = \"row\"\nduration = 60.0\ngravity = {G:?}\n\
         units = {{ length = \"m\", length_in_metres = 1.0, time = \"s\" }}\n\
         [ball]\nradius = {R:?}\nmass = 0.17\n\
         [effects.cloth.rotational]\nmu_slide = {MU_SLIDE:?}\nmu_roll = {mu_roll:?}\nmu_spin = 0.0127\n\
         [effects.contact.inelastic]\ne = 0.5\n"
    );
    if mu_ball > 0.0 {
        text += &format!("[effects.friction.constant]\nmu = {mu_ball:?}\n");
    }
    for (i, (v, w)) in balls.iter().enumerate() {
        let x = 2.0 * R * i as f64;
        text += &format!(
            "[[balls]]\nid = \"{i}\"\nposition = [{x:?}, 0.0]\nvelocity = [{v:?}, 0.0]\nspin = [0.0, {w:?}, 0.0]\n"
        );
    }
    parse("row.toml", &text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn run(scene: &Scene) -> Trace {
    let trace = solve::<f64>(scene, &Limits::NONE).trace;
    assert_eq!(trace.ending, Ending::Rest, "{:?}", trace.ending);
    trace
}

/// When `ball` begins to roll, s.
fn rolls(trace: &Trace, ball: u32) -> f64 {
    let mut events = trace.events.iter();
    let event = events.find(|event| event.kind == EventKind::SlideToRoll(ball));
    event.map_or(f64::NAN, |event| event.time)
}

/// Mean acceleration along x of `ball` from the start until `time`, m/s^2.
fn acceleration(trace: &Trace, ball: usize, time: f64) -> f64 {
    let v = trace.paths[ball].before(time).map(|s| s.velocity.x);
    (v.unwrap_or(f64::NAN) - V) / time
}

fn hold(what: &str, got: f64, want: f64) {
    let error = (got - want).abs();
    assert!(
        error <= CLOSED * want.abs().max(1.0),
        "{what}: {got}, the closed form is {want}: {error:e} off"
    );
}

#[test]
fn a_sliding_ball_pushes_rolling_ones_at_the_acceleration_of_their_masses_and_losses() {
    for k in 1..=3_u32 {
        let mut balls = vec![(V, TOPSPIN)];
        balls.extend((0..k).map(|_| (V, V / R)));
        let trace = run(&row(&balls, 0.0, MU_ROLL));
        let heavier = 1.4 * f64::from(k);
        let a = (MU_SLIDE - heavier * MU_ROLL) * G / (1.0 + heavier);
        let until = (R * TOPSPIN - V) / (a + 2.5 * MU_SLIDE * G);
        let time = rolls(&trace, 0);
        hold(&format!("{k} pushed: end"), time, until);
        for ball in 0..balls.len() {
            let what = format!("{k} pushed: ball {ball}");
            hold(&what, acceleration(&trace, ball, until), a);
        }
        if k == 1 {
            let stated = (5.0 * MU_SLIDE - 7.0 * MU_ROLL) / 12.0 * G;
            hold("one pushed", a, stated);
        }
    }
}

#[test]
fn with_friction_between_balls_the_push_and_the_fall_of_the_topspin_are_larger() {
    let mu = 0.06;
    let trace = run(&row(&[(V, TOPSPIN), (V, V / R)], mu, MU_ROLL));
    let push = (MU_SLIDE + MU_ROLL) * G / (1.0 + (1.0 - mu) / 1.4);
    let a = MU_SLIDE * G - push;
    let fall = 2.5 / R * (MU_SLIDE * G + mu * push);
    let until = (R * TOPSPIN - V) / (a + R * fall);
    hold("end", rolls(&trace, 0), until);
    for ball in 0..2 {
        hold("acceleration", acceleration(&trace, ball, until), a);
    }
    let pushed = (1.0 - mu) / 1.4 * push - MU_ROLL * G;
    hold("of the pushed ball by its own law", a, pushed);
    let spin = trace.paths[0].before(until).map(|s| s.spin.y);
    hold(
        "topspin",
        spin.unwrap_or(f64::NAN) / TOPSPIN,
        1.0 - fall * until / TOPSPIN,
    );
}

#[test]
fn two_sliding_balls_that_push_each_other_keep_their_speed() {
    let trace = run(&row(&[(V, TOPSPIN), (V, 0.0)], 0.0, MU_ROLL));
    // the cloth speeds up one and slows the other by mu_s g, which is what presses
    let until = V / (2.5 * MU_SLIDE * G);
    hold("end", rolls(&trace, 1), until);
    for ball in 0..2 {
        hold("speed", V + until * acceleration(&trace, ball, until), V);
    }
    // from then on the second rolls and is pushed
    let a = (5.0 * MU_SLIDE - 7.0 * MU_ROLL) / 12.0 * G;
    let spin = TOPSPIN - 2.5 / R * MU_SLIDE * G * until;
    let further = (R * spin - V) / (a + 2.5 * MU_SLIDE * G);
    hold("end of the push", rolls(&trace, 0), until + further);
    let last = until + further;
    hold("speed", last * acceleration(&trace, 0, last), a * further);
}

#[test]
fn two_balls_that_roll_in_line_touch_without_a_force_until_they_rest() {
    let trace = run(&row(&[(V, V / R), (V, V / R)], 0.0, MU_ROLL));
    hold("end", trace.end_time, V / (MU_ROLL * G));
    let ends: Vec<f64> = (trace.paths.iter())
        .filter_map(|path| path.last())
        .map(|state| state.position.x)
        .collect();
    hold("path", ends[0], V * V / (2.0 * MU_ROLL * G));
    hold("distance", ends[1] - ends[0], 2.0 * R);
    // nothing but the contact, where it is told, and the two stops
    let told = trace.events.iter().filter(|event| {
        !matches!(
            event.kind,
            EventKind::ContactBegin(..) | EventKind::ContactEnd(..)
        )
    });
    assert_eq!(told.count(), 2, "{:?}", trace.events);
}

#[test]
fn a_resting_ball_stays_until_it_is_pushed_with_more_than_its_rolling_resistance() {
    // the push of a ball that turns in its place is mu_s g; the threshold 7/5 mu_r g
    for (mu_roll, moves) in [(0.15, false), (0.14, true)] {
        let trace = run(&row(&[(0.0, TOPSPIN), (0.0, 0.0)], 0.0, mu_roll));
        let first = trace.paths[1].knots[0].state.position.x;
        let last = trace.paths[1].last().map_or(f64::NAN, |s| s.position.x);
        assert_eq!(
            last > first,
            moves,
            "mu_r {mu_roll}: from {first} to {last}"
        );
        if !moves {
            assert_eq!(last, first, "mu_r {mu_roll}");
            hold(
                "topspin ends",
                trace.end_time,
                R * TOPSPIN / (2.5 * MU_SLIDE * G),
            );
        }
    }
}
