//! What the report's model does, and how wrong it is.

use crate::support::{G, MU, R, report_break, run, scenario};
use carom::engine::{self, Limits, Refusal, Setting};
use carom::trace::{Ending, EventKind, Record};

/// A ball of speed 4 sliding to rest on the report's cloth.
fn slide() -> carom::scene::Scene {
    scenario("slide")
        .moving("cue", [0.0, 0.0], [0.0, 4.0])
        .cloth(MU)
        .build()
}

fn with_dt(dt: f64) -> String {
    format!("dt={dt}")
}

#[test]
fn slide_is_short_by_a_t_dt_over_2() {
    let (a, v) = (MU * G, 4.0);
    for dt in [1e-2, 1e-3, 1e-4] {
        let trace = run("stepper", &[&with_dt(dt)], &slide(), Record::Every(0.01));
        let path = &trace.paths[0];
        for t in [0.5, 1.0, 1.5, 2.0] {
            let exact = v * t - 0.5 * a * t * t;
            let error = exact - path.state_at(t).unwrap().position.y;
            let predicted = 0.5 * a * t * dt;
            assert!(
                (error / predicted - 1.0).abs() < 0.01,
                "dt {dt}, t {t}: error {error:e}, predicted {predicted:e}"
            );
        }
    }
}

#[test]
fn slide_converges_with_order_one() {
    let (a, v, t) = (MU * G, 4.0, 1.5);
    let mut orders = Vec::new();
    let error = |dt: f64| {
        let trace = run("stepper", &[&with_dt(dt)], &slide(), Record::Every(0.01));
        (v * t - 0.5 * a * t * t - trace.paths[0].state_at(t).unwrap().position.y).abs()
    };
    for dt in [1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4] {
        orders.push((error(dt) / error(dt / 2.0)).log2());
    }
    for order in &orders {
        assert!((order - 1.0).abs() < 0.05, "orders {orders:?}");
    }
}

#[test]
fn ball_stops_at_the_first_step_end_after_v_over_mu_g() {
    let t = 4.0 / (MU * G);
    for dt in [1e-2, 1e-3, 1e-4] {
        let trace = run("stepper", &[&with_dt(dt)], &slide(), Record::Events);
        let stop = trace.stop_times[0].unwrap();
        // the speed falls by mu g dt in each step, so it is clamped in the step that reaches t
        assert!(
            stop >= t - 1e-12 && stop <= t + dt,
            "dt {dt}: stopped at {stop}, exact {t}"
        );
        assert_eq!(trace.ending, Ending::Rest);
        assert_eq!(trace.end_time, stop);
        assert_eq!(trace.events.last().unwrap().kind, EventKind::Stop(0));
    }
}

#[test]
fn unexplained_is_a_h_dt_over_2_and_sees_a_dropped_hit() {
    let scene = report_break(1e-2 * R, 90.2);
    let (dt, cadence) = (1e-3, 0.02);
    let mut trace = run("stepper", &[&with_dt(dt)], &scene, Record::Every(cadence));
    // a piece is at most one cadence long, and one step longer where a sample falls between two steps
    let bound = MU * G * (cadence + dt) * dt / 2.0;
    let clean = trace.unexplained();
    assert!(
        clean > 0.9 * MU * G * cadence * dt / 2.0 && clean <= bound * (1.0 + 1e-9),
        "{clean:e}, bound {bound:e}"
    );

    let hit = trace
        .events
        .iter()
        .position(|e| e.kind.is_collision())
        .unwrap();
    for path in &mut trace.paths {
        path.knots.retain(|knot| knot.after != Some(hit as u32));
    }
    trace.events.remove(hit);
    let dropped = trace.unexplained();
    assert!(
        dropped > 100.0 * bound,
        "a dropped hit left {dropped:e}, clean {clean:e}"
    );
}

#[test]
fn rule_as_written_sticks_and_the_approach_check_cures_it() {
    // gap 1e-3 R, speed 10.0934, dt 1e-3: the cue ball moves 10 gaps in one step
    for angle in [90.2, 89.8] {
        let scene = report_break(1e-3 * R, angle);
        let sticky = run("stepper", &["dt=1e-3"], &scene, Record::Events);
        let clean = run(
            "stepper",
            &["dt=1e-3", "contact=approaching-only"],
            &scene,
            Record::Events,
        );
        // exchanges that changed a velocity, over all pairs; longest unbroken overlap of a pair in steps
        let count = |name: &str| sticky.counters[name];
        assert!(
            count("exchanges") > 1000,
            "aim {angle}: {} exchanges",
            count("exchanges")
        );
        assert!(
            count("longest_overlap_steps") > 100,
            "aim {angle}: {}",
            count("longest_overlap_steps")
        );
        assert!(
            count("pairs_overlapping_at_end") >= 1,
            "aim {angle}: none overlaps at rest"
        );
        let hits = clean
            .events
            .iter()
            .filter(|e| matches!(e.kind, EventKind::BallBall(..)))
            .count() as u64;
        assert!(
            clean.counters["exchanges"] < 60,
            "aim {angle}: {} exchanges",
            clean.counters["exchanges"]
        );
        // a pair exchanges again within an episode only if a third ball pushed it back
        assert!(
            clean.counters["exchanges"] <= 2 * hits,
            "aim {angle}: {} for {hits} hits",
            clean.counters["exchanges"]
        );
    }
}

#[test]
fn launch_as_written_makes_the_shot_depend_on_the_step() {
    let mut scene = report_break(1e-2 * R, 90.2);
    let (force, contact_time) = (108.0, 0.01);
    scene.shot = Some(carom::scene::Shot::Force {
        ball: 0,
        angle_deg: 90.2,
        force,
        contact_time,
    });
    for (dt, speed) in [
        (1.0 / 30.0, 33.6449),
        (0.01, 10.0935),
        (1.0 / 240.0, 4.2056),
    ] {
        let trace = run(
            "stepper",
            &[&with_dt(dt), "launch=as-written"],
            &scene,
            Record::Final,
        );
        let got = trace.paths[0].knots[0].state.speed();
        assert!(
            (got - speed).abs() < 5e-5,
            "dt {dt}: launched at {got}, report {speed}"
        );
    }
}

#[test]
fn what_it_cannot_do_is_refused_with_the_remedy() {
    let stepper = crate::support::find("stepper").unwrap();
    let unequal = scenario("unequal")
        .moving("a", [0.0, 0.0], [1.0, 0.0])
        .resting("b", [2.0, 0.0])
        .with_mass(1.0)
        .build();
    let refusal = |scene: &carom::scene::Scene, pairs: &[&str]| {
        let setting = Setting::parse(pairs.iter().copied()).unwrap();
        match engine::prepare(stepper.as_ref(), scene, &setting) {
            Err(Refusal::Setting { message, .. }) => message,
            Err(other) => panic!("{pairs:?}: {other}"),
            Ok(_) => panic!("{pairs:?} was accepted"),
        }
    };
    for (pairs, wanted) in [
        (vec!["dt=0"], "expected a step above 0"),
        (vec!["dt=-1"], "expected a step above 0"),
        (
            vec!["dt=1e-300"],
            "would take 2.0e301 steps, more than 1e11",
        ),
        (vec!["dt=fast"], "expected a finite number"),
        (vec!["dt=NaN"], "expected a finite number"),
        (vec!["contact=never"], "approaching-only"),
        (vec!["launch=as-written"], "[shot.force]"),
        (vec!["speed=3"], "known are dt, contact, launch"),
    ] {
        let message = refusal(&slide(), &pairs);
        assert!(message.contains(wanted), "{pairs:?}: {message}");
    }
    assert!(refusal(&unequal, &[]).contains("approaching-only"));
    let trace = run(
        "stepper",
        &["contact=approaching-only"],
        &unequal,
        Record::Events,
    );
    // elastic, m1 = .107 against m2 = 1 at rest: v2 = 2 m1 / (m1 + m2) v1
    let v2 = trace.final_states()[1].unwrap().velocity.x;
    assert!(
        (v2 - 2.0 * 0.107 / 1.107).abs() < 1e-15,
        "struck ball leaves at {v2}"
    );
}

#[test]
fn number_of_allocations_does_not_depend_on_the_number_of_steps() {
    let stepper = crate::support::find("stepper").unwrap();
    let scene = report_break(1e-2 * R, 90.2);
    let allocations = |dt: f64| {
        let setting = Setting::default()
            .with("dt", dt)
            .with("contact", "approaching-only");
        let run = engine::prepare(stepper.as_ref(), &scene, &setting).unwrap();
        let mut steps = 0;
        let count = allocation_counter::measure(|| {
            steps = run.simulate(Record::Final, &Limits::NONE).counters["steps"]
        });
        (steps, count.count_total)
    };
    let ((few, coarse), (many, fine)) = (allocations(1e-3), allocations(1e-4));
    assert!(many > 9 * few, "{few} and {many} steps");
    // the arrays of the run, and the trace itself: a few dozen either way
    assert!(
        fine < 2 * coarse && fine < 500,
        "{coarse} allocations in {few} steps, {fine} in {many}"
    );
}

#[test]
fn with_a_contact_time_the_launch_does_not_depend_on_the_step() {
    let scene = carom::scene::catalogue::scene("report-break").unwrap();
    for dt in [1.0 / 30.0, 1e-3, 1e-5] {
        let trace = run("stepper", &[&with_dt(dt)], &scene, Record::Final);
        // F t / m, the same three numbers in the same order
        assert_eq!(
            trace.paths[0].knots[0].state.speed(),
            scene.largest_speed(),
            "dt {dt}"
        );
        assert!(
            (scene.largest_speed() - 108.0 * 0.01 / 0.107).abs() < 1e-14 * 10.1,
            "{}",
            scene.largest_speed()
        );
    }
}

#[test]
fn free_flight_in_a_box_is_the_unfolded_straight_line_up_to_a_step_at_each_wall() {
    let (v, t, size) = ([3.0, 1.7], 10.0, [4.0, 7.0]);
    let scene = scenario("box")
        .moving("cue", [1.0, 2.0], v)
        .cushions(size[0], size[1])
        .duration(t)
        .build();
    for dt in [1e-2, 1e-3] {
        let trace = run("stepper", &[&with_dt(dt)], &scene, Record::Events);
        let end = trace.final_states()[0].unwrap().position;
        for axis in 0..2 {
            let reach = size[axis] - 2.0 * R;
            let start = scene.balls[0].state.position[axis] - R;
            let unfolded = (start + v[axis] * t).rem_euclid(2.0 * reach);
            let folded = R + if unfolded > reach {
                2.0 * reach - unfolded
            } else {
                unfolded
            };
            // each bounce starts at the wall up to a step late, and loses what the ball was beyond it
            let bounces = ((start + v[axis] * t) / reach).ceil();
            let bound = bounces * 2.0 * v[axis] * dt;
            let error = (end[axis] - folded).abs();
            assert!(
                error <= bound,
                "dt {dt}, axis {axis}: {error:e} off, bound {bound:e}"
            );
        }
        assert_eq!(trace.end_time, (t / dt).round() * dt);
    }
}

#[test]
fn equal_balls_part_at_a_right_angle() {
    for offset in [0.1, 0.3, 0.5, 0.7, 0.9] {
        let scene = scenario("cut")
            .moving("a", [0.0, 0.0], [3.0, 0.0])
            .resting("b", [2.0, 2.0 * R * offset])
            .duration(1.0)
            .build();
        let trace = run(
            "stepper",
            &["contact=approaching-only"],
            &scene,
            Record::Events,
        );
        let end = trace.final_states();
        let (a, b) = (end[0].unwrap().velocity, end[1].unwrap().velocity);
        assert!(b.norm() > 0.1, "offset {offset}: no hit");
        // whatever the normal at the step of the hit, an exchange leaves orthogonal velocities up to rounding
        assert!(
            a.dot(&b).abs() < 1e-14 * 9.0,
            "offset {offset}: {:e}",
            a.dot(&b)
        );
    }
}

#[test]
fn the_last_step_ends_with_the_duration_and_slows_a_ball_for_as_long() {
    // 33 steps of 0.03 s and one of 0.01 s
    let (dt, v) = (0.03, 10.0);
    let ends = |mu: Option<f64>, duration: f64| {
        let scene = scenario("cut").moving("cue", [0.0, 0.0], [0.0, v]);
        let scene = match mu {
            Some(mu) => scene.cloth(mu),
            None => scene,
        };
        let scene = scene.duration(duration).build();
        run("stepper", &[&with_dt(dt)], &scene, Record::Every(dt))
    };
    for mu in [None, Some(MU)] {
        let (cut, whole) = (ends(mu, 1.0), ends(mu, 0.99));
        assert_eq!(cut.ending, Ending::Duration);
        assert_eq!(cut.end_time, 1.0);
        assert_eq!(cut.counters["steps"], 34);
        assert_eq!(whole.counters["steps"], 33);
        let (last, before) = (cut.paths[0].last().unwrap(), whole.paths[0].last().unwrap());
        let slower = mu.map_or(0.0, |mu| mu * G * 0.01);
        // times of the order of 1 s round by 1e-16
        let speed = before.velocity.y - slower;
        assert!((last.velocity.y - speed).abs() < 1e-14, "{last:?}");
        let way = last.position.y - before.position.y;
        assert!((way - speed * 0.01).abs() < 1e-13, "{way}");
    }
    let scene = report_break(1e-3 * R, 90.2);
    let cut = |duration: f64| carom::scene::Scene {
        duration,
        ..scene.clone()
    };
    let trace = |duration| run("stepper", &["dt=0.03"], &cut(duration), Record::Events);
    assert_eq!(trace(1.0).end_time, 1.0);
    let (short, long) = (trace(2.0), trace(2.01));
    assert_eq!((short.end_time, long.end_time), (2.0, 2.01));
    let until = |events: &[carom::trace::Event]| {
        let early = events.iter().filter(|event| event.time < 1.965);
        early.copied().collect::<Vec<_>>()
    };
    assert_eq!(until(&short.events), until(&long.events));
    assert!(!until(&short.events).is_empty());
}
