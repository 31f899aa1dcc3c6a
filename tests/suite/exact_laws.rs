//! Engine `exact`: closed forms, conservation, and that its traces are whole.

use crate::random::{Random, scenes};
use crate::references::reference;
use crate::support::{G, MU, R, run, scenario};
use carom::engine::{self, Limits, Setting};
use carom::math::Vec3;
use carom::math::first_root::{Approach, bracketed_contact};
use carom::physics::invariants::Invariant;
use carom::scene::Scene;
use carom::trace::{Ending, EventKind, Record, Trace};

const ULP: f64 = f64::EPSILON;

fn exact(scene: &Scene) -> Trace {
    run("exact", &[], scene, Record::Events)
}

fn energy(trace: &Trace, scene: &Scene, t: f64, before: bool) -> f64 {
    let states: Vec<_> = trace
        .paths
        .iter()
        .map(|path| {
            if before {
                path.before(t)
            } else {
                path.state_at(t)
            }
            .unwrap()
        })
        .collect();
    scene.kinetic_energy(&states)
}

#[test]
fn a_sliding_ball_stops_where_and_when_the_closed_form_says() {
    let mut random = Random(11);
    for _ in 0..200 {
        let (v, mu, angle) = (
            random.between(0.01, 20.0),
            random.between(0.01, 0.5),
            random.between(0.0, 360.0),
        );
        let scene = scenario("slide")
            .cloth(mu)
            .duration(1e5)
            .shot("a", [0.0, 0.0], v, angle)
            .build();
        let speed = scene.balls[0].state.speed();
        let trace = exact(&scene);
        let (time, distance) = (speed / (mu * G), speed * speed / (2.0 * mu * G));
        let last = trace.paths[0].last().unwrap();
        let got = last.position.xy().norm();
        // a square root, two quotients and a product
        assert!(
            (trace.end_time - time).abs() <= 8.0 * ULP * time,
            "v {v}, mu {mu}: t {} instead of {time}",
            trace.end_time
        );
        assert!(
            (got - distance).abs() <= 8.0 * ULP * distance,
            "v {v}, mu {mu}: {got} instead of {distance}"
        );
        assert_eq!(last.velocity, Vec3::zeros());
    }
}

#[test]
fn free_flight_in_a_box_is_the_unfolded_straight_line() {
    let mut random = Random(12);
    for _ in 0..100 {
        let (width, length) = (4.0, 7.0);
        let (x, y) = (random.between(R, width - R), random.between(R, length - R));
        let (vx, vy) = (random.between(-9.0, 9.0), random.between(-9.0, 9.0));
        let scene = scenario("box")
            .cushions(width, length)
            .duration(20.0)
            .moving("a", [x, y], [vx, vy])
            .build();
        let trace = exact(&scene);
        let fold = |x: f64, v: f64, size: f64, t: f64| {
            let inner = size - 2.0 * R;
            let unfolded = (x - R + v * t).rem_euclid(2.0 * inner);
            R + if unfolded > inner {
                2.0 * inner - unfolded
            } else {
                unfolded
            }
        };
        let bounces = trace.events.len() as f64;
        // each bounce rounds the position and the time once
        let allowed = 8.0 * ULP * (bounces + 1.0) * (length + 9.0 * 20.0);
        for i in 0..=100 {
            let t = 0.2 * f64::from(i);
            let p = trace.paths[0].state_at(t).unwrap().position;
            let expected = [fold(x, vx, width, t), fold(y, vy, length, t)];
            for axis in 0..2 {
                let error = (p[axis] - expected[axis]).abs();
                assert!(
                    error <= allowed,
                    "t {t}: {} instead of {}, {error:e}",
                    p[axis],
                    expected[axis]
                );
            }
        }
    }
}

#[test]
fn equal_balls_part_at_a_right_angle() {
    let mut random = Random(13);
    for _ in 0..300 {
        // cut angles from nearly head-on to nearly a graze
        let offset = 2.0 * R * random.between(0.001, 0.999);
        let scene = scenario("oblique")
            .cloth(MU)
            .moving("cue", [offset, -2.0], [0.0, random.between(4.0, 12.0)])
            .resting("object", [0.0, 0.0])
            .build();
        let trace = exact(&scene);
        let hit = trace.events[0];
        assert_eq!(hit.kind, EventKind::BallBall(0, 1), "offset {offset}");
        let [cue, object] =
            [0, 1].map(|ball| trace.paths[ball].state_at(hit.time).unwrap().velocity);
        let incoming = trace.paths[0].before(hit.time).unwrap().velocity.norm();
        // two products of rounded components
        let dot = cue.dot(&object);
        assert!(
            dot.abs() <= 8.0 * ULP * incoming * incoming,
            "offset {offset}: {dot:e}"
        );
        // and the object ball leaves along the line of centres
        let n = scene.balls[1].state.position - trace.paths[0].state_at(hit.time).unwrap().position;
        assert!(object.cross(&n).norm() <= 8.0 * ULP * incoming * n.norm());
    }
}

#[test]
fn impacts_keep_momentum_and_energy_and_nothing_ever_gains() {
    let (mut impacts, mut ended) = (0, 0);
    for scene in scenes(MU, 12).into_iter().chain(scenes(0.0, 12)) {
        let trace = exact(&scene);
        assert!(
            trace.ending.is_complete(),
            "{}: {:?}",
            scene.name,
            trace.ending
        );
        let initial = scene.initial_energy();
        for (i, event) in trace.events.iter().enumerate() {
            let (a, b) = event.kind.balls();
            let far = |ball: usize| {
                let knots = &trace.paths[ball].knots;
                let at = knots
                    .iter()
                    .position(|k| k.after == Some(i as u32))
                    .unwrap();
                (knots[at - 1].state, knots[at].state)
            };
            let mut sums = [Vec3::zeros(), Vec3::zeros()];
            let (mut energies, mut scale) = ([0.0; 2], 0.0);
            for ball in [Some(a), b].into_iter().flatten() {
                let (before, after) = far(ball);
                let mass = scene.balls[ball].mass;
                sums[0] += before.velocity * mass;
                sums[1] += after.velocity * mass;
                energies[0] += 0.5 * mass * before.velocity.norm_squared();
                energies[1] += 0.5 * mass * after.velocity.norm_squared();
                scale += mass * before.velocity.norm() + mass * after.velocity.norm();
                assert_eq!(before.position, after.position, "{}: event {i}", scene.name);
            }
            let kept = (energies[1] - energies[0]).abs();
            assert!(
                kept <= 16.0 * ULP * energies[0],
                "{}: event {i} changes energy by {kept:e}",
                scene.name
            );
            if b.is_some() {
                impacts += 1;
                let error = (sums[1] - sums[0]).norm();
                assert!(
                    error <= 8.0 * ULP * scale,
                    "{}: event {i} misses momentum by {error:e}",
                    scene.name
                );
            }
        }
        let allowed = 16.0 * ULP * initial * trace.events.len() as f64;
        let mut last = initial;
        for event in &trace.events {
            for before in [true, false] {
                let now = energy(&trace, &scene, event.time, before);
                assert!(
                    now <= last + allowed,
                    "{}: energy grows by {:e} at {}",
                    scene.name,
                    now - last,
                    event.time
                );
                last = now;
            }
        }
        assert!(
            trace.extrema.energy_gained.value <= allowed,
            "{:?}",
            trace.extrema.energy_gained
        );
        let promised = crate::support::find("exact")
            .unwrap()
            .promises(&scene, &Setting::default());
        if promised.contains(&Invariant::EverythingStops) {
            ended += 1;
            assert_eq!(trace.ending, Ending::Rest, "{}", scene.name);
            assert!(
                trace.stop_times.iter().all(Option::is_some),
                "{}",
                scene.name
            );
        }
    }
    assert!(
        impacts > 500 && ended > 100,
        "{impacts} impacts, {ended} scenes at rest"
    );
}

#[test]
fn a_rerun_is_the_same_to_the_bit() {
    for scene in scenes(MU, 3).into_iter().chain(scenes(0.0, 3)) {
        assert_eq!(exact(&scene), exact(&scene), "{}", scene.name);
    }
}

#[test]
fn knots_explain_all_motion_and_nothing_overlaps_or_leaves() {
    let mut worst = (0.0_f64, 0.0_f64, 0.0_f64);
    for scene in scenes(MU, 10).into_iter().chain(scenes(0.0, 10)) {
        let trace = exact(&scene);
        // dr and h (v0 + v1) / 2 are each good to a few ulps of the coordinates and of the path
        let path = scene.largest_speed() * trace.end_time;
        let allowed = 8.0 * ULP * (scene.largest_coordinate() + path);
        let unexplained = trace.unexplained();
        assert!(
            unexplained <= allowed,
            "{}: {unexplained:e}, allowed {allowed:e}",
            scene.name
        );
        let bound = scene.touching();
        let extrema = &trace.extrema;
        assert!(
            extrema.overlap.value <= bound,
            "{}: {:?}",
            scene.name,
            extrema.overlap
        );
        assert!(
            extrema.outside.value <= bound,
            "{}: {:?}",
            scene.name,
            extrema.outside
        );
        assert_eq!(extrema.displaced.value, 0.0, "{}", scene.name);
        worst = (
            worst.0.max(unexplained),
            worst.1.max(extrema.overlap.value),
            worst.2.max(extrema.outside.value),
        );
    }
    assert!(
        worst.0 > 0.0 && worst.1 > 0.0,
        "the measures see rounding: {worst:?}"
    );
}

#[test]
fn a_hit_dropped_from_a_trace_is_seen() {
    let truth = reference("d2_report_break_gap0.01_mp50");
    let trace = exact(&truth.scene);
    let clean = trace.unexplained();
    let mut seen = 0;
    for (index, event) in trace.events.iter().enumerate() {
        let EventKind::BallBall(a, b) = event.kind else {
            continue;
        };
        // what an engine leaves that did not report the hit: no row, no far side; the near side stays
        let mut dropped = trace.clone();
        dropped.events.remove(index);
        for ball in [a, b] {
            let knots = &mut dropped.paths[ball as usize].knots;
            knots.retain(|knot| knot.after != Some(index as u32));
        }
        let unexplained = dropped.unexplained();
        // the shortest flight after a hit of this break still is 1e8 times rounding
        assert!(
            unexplained > 1e6 * clean,
            "hit {index}: {unexplained:e} against {clean:e}"
        );
        seen += 1;
    }
    assert_eq!(seen, trace.counters["ball_ball"]);
    assert!(seen > 0 && clean > 0.0, "{seen} hits, {clean:e}");
}

#[test]
fn no_collision_is_missed_in_traces_swept_by_the_other_finder() {
    let (mut pieces, mut samples) = (0, 0);
    for scene in scenes(MU, 10).into_iter().chain(scenes(0.0, 10)) {
        let trace = exact(&scene);
        let n = scene.balls.len();
        let bound = scene.touching();
        for a in 0..n {
            for b in a + 1..n {
                let distance = scene.contact_distance(a, b);
                let mut times: Vec<f64> = [a, b]
                    .iter()
                    .flat_map(|ball| trace.paths[*ball].knots.iter().map(|knot| knot.time))
                    .collect();
                times.sort_by(f64::total_cmp);
                times.dedup();
                for span in times.windows(2) {
                    let (from, h) = (span[0], span[1] - span[0]);
                    let ends = [a, b].map(|ball| {
                        let path = &trace.paths[ball];
                        (path.state_at(from).unwrap(), path.before(span[1]).unwrap())
                    });
                    let relative = |f: &dyn Fn(usize, usize) -> f64| {
                        [0, 1].map(|axis| f(1, axis) - f(0, axis))
                    };
                    let approach = Approach {
                        p: relative(&|i, axis| ends[i].0.position[axis]),
                        v: relative(&|i, axis| ends[i].0.velocity[axis]),
                        a: relative(&|i, axis| {
                            (ends[i].1.velocity[axis] - ends[i].0.velocity[axis]) / h
                        }),
                        // deeper than rounding
                        distance: distance - bound,
                    };
                    pieces += 1;
                    let found = bracketed_contact(&approach, h);
                    assert!(
                        found.is_none(),
                        "{}: balls {a} and {b} meet unnoticed at {} + {found:?}",
                        scene.name,
                        from
                    );
                }
            }
        }
        for i in 0..=400 {
            let t = trace.end_time * f64::from(i) / 400.0;
            let places: Vec<Vec3> = trace
                .paths
                .iter()
                .map(|path| path.state_at(t).unwrap().position)
                .collect();
            for a in 0..n {
                for b in a + 1..n {
                    samples += 1;
                    let gap = (places[a] - places[b]).xy().norm() - scene.contact_distance(a, b);
                    assert!(
                        gap >= -bound,
                        "{}: {a} and {b} overlap by {:e} at {t}",
                        scene.name,
                        -gap
                    );
                }
            }
        }
    }
    assert!(
        pieces > 10_000 && samples > 1_000_000,
        "{pieces} pieces, {samples} samples"
    );
}

#[test]
fn what_is_inside_the_engine_is_the_scene() {
    for scene in scenes(MU, 2).into_iter().chain(scenes(0.0, 2)) {
        let engine = crate::support::find("exact").unwrap();
        // the audit of `prepare` reads everything back
        let run = engine::prepare(engine.as_ref(), &scene, &Setting::default())
            .unwrap_or_else(|refusal| panic!("{}: {refusal}", scene.name));
        let sheet = run.sheet();
        assert!(
            sheet.iter().any(|parameter| parameter.name == "mu") == scene.effects.cloth.is_some()
        );
        let trace = run.simulate(Record::Final, &Limits::NONE);
        assert!(trace.events.is_empty());
        // the record does not change the run
        let whole = exact(&scene);
        assert_eq!(trace.final_states(), whole.final_states(), "{}", scene.name);
        assert_eq!(trace.counters, whole.counters, "{}", scene.name);
        assert_eq!(trace.counters["events"], whole.events.len() as u64);
    }
}
