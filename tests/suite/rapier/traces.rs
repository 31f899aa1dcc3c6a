//! rapier's traces held against themselves: nothing unexplained, nothing forgotten, nothing counted twice.

use super::{BOTH, cut_shot, rack};
use crate::support::{MU, R, run, scenario};
use carom::scene::Scene;
use carom::trace::{EventKind, Record, Trace};

/// Scenes in which every kind of event happens: slides, oblique hits, cushions, a break with touching balls.
fn scenes() -> Vec<Scene> {
    let broken = scenario("break").moving("cue", [6.3, 15.0], [0.05, 12.0]);
    let frozen = scenario("frozen").moving("cue", [6.3, 15.0], [0.05, 12.0]);
    vec![
        scenario("slide")
            .shot("cue", [1.0, 1.0], 5.0, 37.0)
            .cloth(MU)
            .build(),
        cut_shot(35.0, 6.0, 1.3).cloth(MU).duration(5.0).build(),
        scenario("cushions")
            .shot("cue", [2.0, 2.0], 9.0, 33.0)
            .cloth(0.1)
            .cushions(4.0, 4.0)
            .build(),
        rack(broken, [6.315, 18.225], 3, 2.34375e-3)
            .cloth(MU)
            .cushions(12.63, 24.3)
            .duration(3.0)
            .build(),
        rack(frozen, [6.315, 18.225], 3, 0.0)
            .cloth(MU)
            .cushions(12.63, 24.3)
            .duration(3.0)
            .build(),
    ]
}

/// What a trace may leave unexplained: v dt in the step of an impact and h v/2 in a slide (derived in the engine's
/// `journal.rs`), v the largest speed. f32 adds the rounding of the position in every substep, half an ulp each, all to
/// one side at worst.
fn bound(engine: &str, scene: &Scene, trace: &Trace, dt: f64, substeps: f64) -> f64 {
    let step = scene.largest_speed() * dt * (1.0 + 0.5 / substeps);
    let positions = trace.paths.iter().flat_map(|path| &path.knots);
    let coordinate = positions.fold(0.0_f64, |c, k| c.max(k.state.position.amax()));
    let longest = trace.paths.iter().flat_map(|path| path.knots.windows(2));
    let longest = longest.fold(0.0_f64, |h, pair| h.max(pair[1].time - pair[0].time));
    let ulp = if engine == "rapier-f32" {
        f64::from(f32::EPSILON)
    } else {
        f64::EPSILON
    };
    step + 0.5 * ulp * coordinate * longest / dt * substeps
}

#[test]
fn nothing_moves_that_the_events_do_not_explain() {
    for (engine, _) in BOTH {
        for scene in scenes() {
            for dt in [1e-3, 2.5e-4] {
                for record in [Record::Events, Record::Every(0.02)] {
                    let trace = run(engine, &[&format!("dt={dt}")], &scene, record);
                    let bound = bound(engine, &scene, &trace, dt, 4.0);
                    let got = trace.unexplained();
                    assert!(
                        got <= bound,
                        "{engine}, {}, dt {dt}, {record:?}: unexplained {got}, bound {bound}",
                        scene.name
                    );
                    assert_eq!(
                        trace.extrema.displaced.value, 0.0,
                        "{engine}, {}",
                        scene.name
                    );
                    assert_eq!(
                        trace.counters["unattributed"], 0,
                        "{engine}, {}",
                        scene.name
                    );
                }
            }
        }
    }
}

#[test]
fn stock_rapier_explains_itself_to_two_steps() {
    // faster than contacts are predicted: a ball is found inside what it hit, and pushing it out moves it once more, by
    // at most the v dt that it went in
    for (engine, _) in BOTH {
        for scene in scenes() {
            let trace = run(engine, &["preset=stock"], &scene, Record::Events);
            let bound = 2.0 * bound(engine, &scene, &trace, 1.0 / 60.0, 4.0);
            let got = trace.unexplained();
            assert!(
                got <= bound,
                "{engine}, {}: {got}, bound {bound}",
                scene.name
            );
        }
    }
}

#[test]
fn an_event_that_is_dropped_from_a_trace_is_seen_in_it() {
    for (engine, _) in BOTH {
        for scene in &scenes()[1..] {
            let trace = run(engine, &[], scene, Record::Events);
            let bound = bound(engine, scene, &trace, 1e-3, 4.0);
            let hits: Vec<usize> = (0..trace.events.len())
                .filter(|k| trace.events[*k].kind.is_collision())
                .collect();
            assert!(!hits.is_empty(), "{engine}, {}", scene.name);
            // every impact whose far side lasts: within one step one impact can hide behind the next
            let mut seen = 0;
            for k in hits {
                let Some(least) = hidden(&trace, k) else {
                    continue;
                };
                let got = without(&trace, k as u32).unexplained();
                // what the missing jump moves in the time to the next knot, less what the trace left unexplained anyway
                assert!(
                    got >= least - bound,
                    "{engine}, {}: without event {k} {got}, expected {least}",
                    scene.name
                );
                if got > 10.0 * bound {
                    seen += 1;
                }
            }
            assert!(seen > 0, "{engine}, {}: no impact is seen", scene.name);
        }
    }
}

/// |jump|/2 times the time to the next knot of the ball for which that is most: what is unexplained without event `k`.
fn hidden(trace: &Trace, k: usize) -> Option<f64> {
    let mut most: Option<f64> = None;
    for path in &trace.paths {
        let Some(far) = path
            .knots
            .iter()
            .position(|knot| knot.after == Some(k as u32))
        else {
            continue;
        };
        let next = path.knots.get(far + 1)?;
        let jump = path.knots[far].state.velocity - path.knots[far - 1].state.velocity;
        let missing = 0.5 * jump.norm() * (next.time - path.knots[far].time);
        most = Some(most.unwrap_or(0.0).max(missing));
    }
    most
}

/// The trace as an engine would have written it that did not notice event `k`.
fn without(trace: &Trace, k: u32) -> Trace {
    let mut trace = trace.clone();
    trace.events.remove(k as usize);
    for path in &mut trace.paths {
        path.knots.retain(|knot| knot.after != Some(k));
    }
    trace
}

#[test]
fn the_amount_recorded_does_not_change_the_run() {
    for (engine, _) in BOTH {
        for scene in scenes() {
            let events = run(engine, &[], &scene, Record::Events);
            for record in [Record::Final, Record::Every(0.05)] {
                let other = run(engine, &[], &scene, record);
                let case = format!("{engine}, {}, {record:?}", scene.name);
                assert_eq!(other.final_states(), events.final_states(), "{case}");
                assert_eq!(other.stop_times, events.stop_times, "{case}");
                assert_eq!(other.extrema, events.extrema, "{case}");
                assert_eq!(other.counters, events.counters, "{case}");
                assert_eq!(other.ending, events.ending, "{case}");
            }
        }
    }
}

#[test]
fn samples_come_at_the_cadence_without_drift() {
    let scene = scenario("slide")
        .shot("cue", [1.0, 1.0], 5.0, 37.0)
        .cloth(MU)
        .build();
    for (engine, _) in BOTH {
        let trace = run(engine, &[], &scene, Record::Every(0.03));
        let stop = trace.stop_times[0].unwrap();
        let samples = (stop / 0.03) as usize;
        assert!(samples > 10, "{engine}");
        for (k, knot) in trace.paths[0].knots.iter().enumerate().take(samples) {
            let (got, want) = (knot.time, 0.03 * k as f64);
            assert!(
                (got - want).abs() < 1e-9,
                "{engine}: sample {k} at {got}, expected {want}"
            );
        }
    }
}

#[test]
fn an_ordinary_hit_is_one_event_with_one_exchange_and_both_sides() {
    for (engine, _) in BOTH {
        let scene = cut_shot(35.0, 6.0, 1.3).cloth(MU).duration(5.0).build();
        let trace = run(engine, &[], &scene, Record::Events);
        let kinds: Vec<_> = trace.events.iter().map(|e| (e.kind, e.exchanges)).collect();
        let expected = [
            (EventKind::BallBall(0, 1), Some(1)),
            (EventKind::Stop(0), None),
            (EventKind::Stop(1), None),
        ];
        let mut sorted = kinds.clone();
        sorted.sort_by_key(|(kind, _)| kind.balls().0 + 2 * usize::from(!kind.is_collision()));
        assert_eq!(sorted, expected, "{engine}: {kinds:?}");
        let time = trace.events[0].time;
        for (ball, path) in trace.paths.iter().enumerate() {
            let far = path.knots.iter().position(|k| k.after == Some(0)).unwrap();
            let (pin, near, far) = (&path.knots[far - 2], &path.knots[far - 1], &path.knots[far]);
            assert_eq!((near.time, far.time), (time, time), "{engine}, ball {ball}");
            assert!(
                (time - pin.time - 1e-3).abs() < 1e-12,
                "{engine}, ball {ball}"
            );
            assert_eq!(
                near.state.position, far.state.position,
                "{engine}, ball {ball}"
            );
            assert_ne!(
                near.state.velocity, far.state.velocity,
                "{engine}, ball {ball}"
            );
        }
        // the ball at rest stays where it was until the step that hits it begins
        let rest = trace.paths[1].state_at(0.5 * time).unwrap();
        let start = scene.balls[1].state.position;
        // it sinks into the cloth by less than 1e-3 R
        assert!(
            (rest.position - start).xy().norm() == 0.0,
            "{engine}: {rest:?}"
        );
        assert!(
            (rest.position - start).z.abs() < 1e-3 * R,
            "{engine}: {rest:?}"
        );
    }
}

#[test]
fn several_hits_of_one_step_are_written_in_scene_order() {
    let mut row = scenario("cradle").moving("cue", [-1.0, 0.0], [5.0, 0.0]);
    for k in 0..4 {
        row = row.resting(&k.to_string(), [2.0 * R * f64::from(k), 0.0]);
    }
    let scene = row.duration(0.5).build();
    for (engine, _) in BOTH {
        let trace = run(engine, &[], &scene, Record::Events);
        assert!(trace.events.len() >= 4, "{engine}: {:?}", trace.events);
        let rank = |kind: EventKind| match kind {
            EventKind::BallBall(a, b) => (0, a, b),
            EventKind::BallCushion(a, side) => (1, a, side as u32),
            other => (2, other.balls().0 as u32, 0),
        };
        let mut same = 0;
        for pair in trace.events.windows(2) {
            assert!(pair[0].time <= pair[1].time, "{engine}: {:?}", trace.events);
            if pair[0].time == pair[1].time {
                same += 1;
                assert!(
                    rank(pair[0].kind) < rank(pair[1].kind),
                    "{engine}: {:?}",
                    trace.events
                );
            }
        }
        assert!(
            same > 0,
            "{engine}: no step with two events: {:?}",
            trace.events
        );
        let bound = bound(engine, &scene, &trace, 1e-3, 4.0);
        assert!(
            trace.unexplained() <= bound,
            "{engine}: {}",
            trace.unexplained()
        );
    }
}

#[test]
fn a_contact_that_lasts_is_one_event_with_many_exchanges() {
    // pressed together by both neighbours, the middle balls of a frozen row exchange in consecutive steps
    let mut row = scenario("squeeze").moving("cue", [-2.0 * R - 0.3, 0.0], [5.0, 0.0]);
    for k in 0..6 {
        row = row.resting(&k.to_string(), [2.0 * R * f64::from(k), 0.0]);
    }
    let scene = row
        .moving("other", [12.0 * R + 0.3, 0.0], [-5.0, 0.0])
        .cloth(MU)
        .duration(1.0)
        .build();
    for (engine, _) in BOTH {
        let trace = run(engine, &[], &scene, Record::Events);
        let exchanges: u64 = trace.events.iter().filter_map(|e| e.exchanges).sum();
        assert_eq!(exchanges, trace.counters["exchanges"], "{engine}");
        let lasting: Vec<_> = trace
            .events
            .iter()
            .filter(|e| e.exchanges > Some(1))
            .collect();
        assert!(!lasting.is_empty(), "{engine}: {:?}", trace.events);
        for event in lasting {
            let index = trace.events.iter().position(|e| e == event).unwrap() as u32;
            let (ball, _) = event.kind.balls();
            let jumps = trace.paths[ball]
                .knots
                .iter()
                .filter(|k| k.after == Some(index));
            assert_eq!(
                jumps.count() as u64,
                event.exchanges.unwrap(),
                "{engine}: {event:?}"
            );
        }
    }
}
