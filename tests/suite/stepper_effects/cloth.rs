//! One ball on its cloth: slide, roll, spin-down.

use super::{G, MU, R, ROUNDING, one_ball, rolling, simulate, time_of, within};
use carom::physics::cloth::rotational::{self, slid, slide_time};
use carom::trace::{Ending, EventKind, Record};

#[test]
fn centre_hit_rolls_after_2v_over_7_mu_g_with_five_sevenths_of_speed_and_energy() {
    let a = MU.mu_slide * G;
    for v in [0.5, 2.0] {
        for dt in [1e-2, 1e-3, 1e-4] {
            let case = format!("v {v}, dt {dt}");
            let scene = one_ball([0.0, v], [0.0; 3]);
            let trace = simulate(&scene, dt, Record::Events);
            let t_s = 2.0 * v / (7.0 * a);
            let t = time_of(&trace, EventKind::SlideToRoll(0));
            assert!(
                t >= t_s - ROUNDING && t <= t_s + dt + ROUNDING,
                "{case}: rolls at {t}, exact {t_s}"
            );
            let state = trace.paths[0].state_at(t).unwrap();
            // natural roll at t_s, and rolling for what is left of the step
            let late = t - t_s;
            let rolled = 5.0 / 7.0 * v - MU.mu_roll * G * late;
            within(
                &format!("{case}: speed"),
                state.velocity.y,
                rolled,
                ROUNDING,
            );
            let left = scene.kinetic_energy(&[state]) / scene.initial_energy();
            let law = 5.0 / 7.0 * (rolled / (5.0 / 7.0 * v)).powi(2);
            within(&format!("{case}: energy left"), left, law, ROUNDING);
            // 12 v^2 / (49 mu g) at t_s, and on from there
            let way = 5.0 / 7.0 * v * late - 0.5 * MU.mu_roll * G * late * late;
            let exact = 12.0 * v * v / (49.0 * a) + way;
            // n whole steps of sliding fall short by a n dt^2 / 2, the step in which the slide ends by at most (a + a_roll) dt^2 / 2
            let short = exact - state.position.y;
            within(
                &format!("{case}: distance"),
                short,
                0.5 * a * (t - dt) * dt,
                0.5 * (MU.mu_slide + MU.mu_roll) * G * dt * dt + ROUNDING,
            );
        }
    }
}

#[test]
fn any_spin_ends_as_natural_roll_v_minus_two_sevenths_of_the_slip() {
    let dt = 1e-3;
    for (v, w) in [
        ([0.0, 1.5], [30.0, 40.0, 25.0]),
        ([1.2, -0.7], [-80.0, 15.0, -60.0]),
        ([0.0, 0.0], [50.0, -20.0, 0.0]),
        ([0.3, 0.4], [0.0, 0.0, 90.0]),
    ] {
        let scene = one_ball(v, w);
        let start = scene.balls[0].state;
        let trace = simulate(&scene, dt, Record::Every(0.01));
        let slip = rotational::slip_velocity(&start.velocity, &start.spin, R);
        let t_s = slide_time(slip.norm(), MU.mu_slide, G);
        let t = time_of(&trace, EventKind::SlideToRoll(0));
        assert!(
            t >= t_s - ROUNDING && t <= t_s + dt + ROUNDING,
            "{v:?} {w:?}: {t}, {t_s}"
        );
        let state = trace.paths[0].state_at(t).unwrap();
        // natural roll at t_s, and rolling for what is left of the step
        let roll = start.velocity - slip * (2.0 / 7.0);
        let roll = roll - roll.normalize() * (MU.mu_roll * G * (t - t_s));
        // one rounding a step of sliding
        let steps = t / dt;
        let off = (state.velocity - roll).norm();
        assert!(off <= steps * 1e-15, "{v:?} {w:?}: rolls {off:e} off");
        // the parabola on the way: a t dt/2 short along the slip, whose direction never changes
        for part in [0.3, 0.9] {
            let at = (part * t_s / dt).floor() * dt;
            let exact = slid(&start, R, MU, G, at);
            let lag = slip.normalize() * (0.5 * MU.mu_slide * G * at * dt);
            let got = trace.paths[0].state_at(at).unwrap();
            // between samples the trace is the cubic of constant acceleration, whose own error is of the size of a step's
            let bound = 0.5 * MU.mu_slide * G * 0.011 * dt;
            let off = (exact.position - lag - got.position).norm();
            assert!(
                off <= bound,
                "{v:?} {w:?} at {at}: {off:e}, bound {bound:e}"
            );
        }
    }
}

#[test]
fn draw_slows_stops_dead_at_five_halves_and_comes_back_beyond() {
    let v = 1.0;
    for k in [0.0, 1.0, 2.0, 2.5, 3.0, 4.0] {
        let scene = one_ball([0.0, v], [k * v / R, 0.0, 0.0]);
        let trace = simulate(&scene, 1e-3, Record::Events);
        let rolled = v * (5.0 - 2.0 * k) / 7.0;
        let slide = slide_time((1.0 + k) * v, MU.mu_slide, G);
        let speed = if k == 2.5 {
            // what is left is rounding: the ball stops within the step
            let stop = trace.stop_times[0].unwrap();
            assert!(
                stop >= slide - ROUNDING && stop <= slide + 1e-3 + ROUNDING,
                "{stop} after {slide}"
            );
            0.0
        } else {
            let t = time_of(&trace, EventKind::SlideToRoll(0));
            // what it has lost by rolling for the rest of the step is given back
            let got = trace.paths[0].state_at(t).unwrap().velocity.y;
            got + (MU.mu_roll * G * (t - slide)).copysign(got)
        };
        within(&format!("draw {k}"), speed, rolled, ROUNDING);
        // the halt of a ball that comes back is no stop
        time_of(&trace, EventKind::Stop(0));
    }
}

#[test]
fn a_ball_that_rolls_from_the_start_stops_after_v_over_mu_g_and_v_squared_over_2_mu_g() {
    let a = MU.mu_roll * G;
    for v in [[0.0, 0.3], [-0.24, 0.18]] {
        for dt in [1e-2, 1e-3] {
            let trace = simulate(&one_ball(v, rolling(v)), dt, Record::Events);
            let kinds: Vec<EventKind> = trace.events.iter().map(|e| e.kind).collect();
            assert_eq!(kinds, [EventKind::Stop(0)], "a rolling ball only stops");
            let stop = trace.stop_times[0].unwrap();
            let exact = 0.3 / a;
            // one rounding a step may move the end by a step
            assert!(
                stop >= exact - 1e-9 && stop <= exact + dt + 1e-9,
                "dt {dt}: stops at {stop}, exact {exact}"
            );
            let travelled = trace.final_states()[0].unwrap().position.xy().norm();
            // v = (N + f) a dt stops after N steps, v dt / 2 short but for a dt^2 (f - f^2) / 2
            within(
                &format!("dt {dt}: distance"),
                travelled,
                0.3 * 0.3 / (2.0 * a) - 0.3 * dt / 2.0,
                a * dt * dt / 8.0 + 1e-11,
            );
        }
    }
}

#[test]
fn spin_about_the_vertical_ends_after_2_r_w_over_5_mu_g_and_counts_as_stopped() {
    for w in [12.0, -30.0] {
        for dt in [1e-2, 1e-3] {
            let trace = simulate(&one_ball([0.0, 0.0], [0.0, 0.0, w]), dt, Record::Events);
            let exact = 2.0 * R * w.abs() / (5.0 * MU.mu_spin * G);
            let t = time_of(&trace, EventKind::SpinEnd(0));
            assert!(
                t >= exact - 1e-9 && t <= exact + dt + 1e-9,
                "{t}, exact {exact}"
            );
            assert_eq!(trace.events.len(), 1);
            assert_eq!(
                (trace.stop_times[0], &trace.ending),
                (Some(0.0), &Ending::Rest)
            );
            assert_eq!(trace.end_time, t);
            assert!(trace.final_states()[0].unwrap().is_at_rest());
        }
    }
}
