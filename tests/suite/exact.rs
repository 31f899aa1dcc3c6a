//! Engine `exact` against an arbitrary-precision solver.

use crate::references::{Reference, reference};
use crate::support::run;
use carom::trace::{Ending, Record, Trace};

/// Largest errors of the first `events` events against a reference: of times and of states.
fn errors(trace: &Trace, truth: &Reference, events: usize) -> (f64, f64) {
    assert!(
        trace.events.len() >= events && events > 0,
        "exact on {}: {} events, expected at least {events}",
        trace.provenance.scene,
        trace.events.len()
    );
    let (mut time, mut state) = (0.0_f64, 0.0_f64);
    for (i, want) in truth.events.iter().take(events).enumerate() {
        let got = trace.events[i];
        assert_eq!(
            got.kind, want.kind,
            "exact on {}: event {i}",
            trace.provenance.scene
        );
        time = time.max((got.time - want.time).abs());
        for (ball, r, v) in &want.states {
            let knot = trace.paths[*ball]
                .knots
                .iter()
                .find(|knot| knot.after == Some(i as u32))
                .unwrap_or_else(|| panic!("event {i}: no far side for ball {ball}"));
            let s = knot.state;
            for axis in 0..2 {
                state = state.max((s.position[axis] - r[axis]).abs());
                state = state.max((s.velocity[axis] - v[axis]).abs());
            }
        }
    }
    (time, state)
}

fn final_error(trace: &Trace, truth: &Reference) -> f64 {
    let mut worst = 0.0_f64;
    for (got, (r, v)) in trace.final_states().iter().zip(&truth.finals) {
        let got = got.expect("in play");
        for axis in 0..2 {
            worst = worst.max((got.position[axis] - r[axis]).abs());
            worst = worst.max((got.velocity[axis] - v[axis]).abs());
        }
    }
    worst
}

#[test]
fn shots_of_the_report_agree_with_fifty_digits() {
    for (name, events, tolerance) in [
        ("d1_report_6balls_mp50", 7, 1e-11),
        ("d2_report_break_gap0.01_mp50", 36, 1e-12),
    ] {
        let truth = reference(name);
        let trace = run("exact", &[], &truth.scene, Record::Events);
        assert_eq!(trace.ending, Ending::Rest, "exact on {name}");
        assert_eq!(
            trace.events.len(),
            events,
            "exact on {name}: number of events"
        );
        assert_eq!(truth.events.len(), events, "{name}: number of events");
        let (time, state) = errors(&trace, &truth, events);
        let last = final_error(&trace, &truth);
        for (what, error) in [
            ("time", time),
            ("state", state),
            ("final", last),
            ("end", (trace.end_time - truth.end_time).abs()),
        ] {
            assert!(
                error <= tolerance,
                "exact on {name}: {what} error {error:e}, allowed {tolerance:e}"
            );
        }
    }
}

#[test]
fn discs_in_a_box_agree_with_260_digits() {
    let truth = reference("e_discs_seed1_mp260");
    let mut scene = truth.scene.clone();
    scene.duration = truth.end_time;
    let trace = run("exact", &[], &scene, Record::Events);
    let (time, state) = errors(&trace, &truth, 50);
    assert!(time <= 1e-9, "exact on e: time error {time:e} in 50 events");
    assert!(
        state <= 1e-8,
        "exact on e: state error {state:e} in 50 events"
    );
    let kinds = trace.events.iter().map(|event| event.kind);
    let order = kinds.zip(&truth.events).take_while(|(a, b)| *a == b.kind);
    let order = order.count();
    // an error of 1e-16 grows 3e7 times by event 60 (README of the references), e-fold by e-fold to order 1 by about 110
    assert!(
        order >= 100,
        "exact on e: order holds for {order} events only"
    );
}
