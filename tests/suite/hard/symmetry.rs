//! Hard scenes whose answer is a symmetry, a standstill or an agreement rather than a number.

use super::{OURS, scene};
use crate::support::run;
use carom::trace::{Ending, Event, Record, Trace};

/// Scenes that this file or other files of the suite hold to their answer.
pub const ANSWERED_ELSEWHERE: [&str; 10] = [
    "rack-frozen-central-reflections",
    "rack-hair-gaps",
    "rack-at-rest",
    "rack-at-rest-long",
    // exact_reflections, ensemble, missed_collisions
    "report-break-frozen-reflections",
    "report-break-tight",
    "report-break-tight-mirrored",
    "triple-hit-reflections",
    // contact::phase
    "report-break-pressed",
    "rack-lossy",
];

/// Two places closer than this, in R, are the same: what the workbench asks of two precisions up to the horizon.
const SAME: f64 = 1e-9;

#[test]
fn what_nobody_touches_moves_by_not_one_bit() {
    for name in ["rack-at-rest", "rack-at-rest-long"] {
        let scene = scene(name);
        for (engine, settings) in OURS {
            let trace = run(engine, settings, &scene, Record::Events);
            assert_eq!(trace.ending, Ending::Duration, "{engine} in {name}");
            assert!(
                trace.events.is_empty(),
                "{engine} in {name}: {:?}",
                trace.events
            );
            let last = trace.final_states();
            assert!(!last.is_empty());
            for (state, ball) in last.iter().zip(&scene.balls) {
                assert_eq!(
                    *state,
                    Some(ball.state),
                    "{engine} in {name}: ball {}",
                    ball.id
                );
            }
        }
    }
}

/// The ball in the mirror place of the rack: ids 1; 2, 3; 4, 5, 6; ... row by row, x ascending.
fn mirrored(id: usize) -> usize {
    let row = (1..=5).find(|row| row * (row + 1) / 2 >= id).unwrap();
    let (first, last) = (row * (row - 1) / 2 + 1, row * (row + 1) / 2);
    first + last - id
}

#[test]
fn a_frozen_rack_hit_along_its_axis_breaks_into_its_own_mirror_image_under_reflections() {
    let scene = scene("rack-frozen-central-reflections");
    let trace = run("exact", &[], &scene, Record::Events);
    assert_eq!(trace.ending, Ending::Rest);
    let last = trace.final_states();
    let mut worst: f64 = 0.0;
    for id in 1..=15 {
        let (one, other) = (
            last[id].unwrap().position,
            last[mirrored(id)].unwrap().position,
        );
        worst = worst.max((one.x + other.x - 2.0 * 6.315).hypot(one.y - other.y));
    }
    let axis = (last[0].unwrap().position.x - 6.315).abs();
    let same = SAME * scene.smallest_radius();
    assert!(
        worst < same && axis < same,
        "asymmetry {worst:e}, cue {axis:e}"
    );
}

#[test]
fn gaps_of_a_millionth_of_a_radius_are_impacts_one_by_one_in_any_precision() {
    let scene = scene("rack-hair-gaps");
    let kinds = |trace: &Trace| {
        trace
            .events
            .iter()
            .map(|e: &Event| e.kind)
            .collect::<Vec<_>>()
    };
    let (f64, dd) = (
        run("exact", &[], &scene, Record::Events),
        run("exact", &["precision=dd"], &scene, Record::Events),
    );
    assert_eq!((&f64.ending, &dd.ending), (&Ending::Rest, &Ending::Rest));
    assert!(
        f64.counters["ball_ball"] >= 14,
        "every ball is reached: {:?}",
        f64.counters
    );
    assert_eq!(kinds(&f64), kinds(&dd));
    for (one, other) in f64.final_states().iter().zip(dd.final_states()) {
        let apart = (one.unwrap().position - other.unwrap().position).norm();
        assert!(apart < SAME * scene.smallest_radius(), "{apart:e}");
    }
}

#[test]
fn the_rule_as_written_sticks_where_the_check_that_it_lacks_lets_go() {
    for name in ["frozen-to-cushion", "restitution-fast"] {
        let scene = scene(name);
        let longest = |rule: &str| {
            let contact = format!("contact={rule}");
            let trace = run("stepper", &[&contact, "dt=1e-3"], &scene, Record::Events);
            trace.counters["longest_overlap_steps"]
        };
        let (written, approaching) = (longest("as-written"), longest("approaching-only"));
        assert!(
            written > 10 * approaching,
            "{name}: {written} steps as written, {approaching} with the check"
        );
    }
}
