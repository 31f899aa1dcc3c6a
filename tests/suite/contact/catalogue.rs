//! The hard cases of contacts: those of the reference, which is held in this room and in `exact_simultaneous`, and a combination shot.

use super::R;
use crate::references::text;
use carom::engine::Limits;
use carom::engine::exact::{final_positions, solve};
use carom::math::{DoubleDouble, Real};
use carom::scene::{catalogue, parse};
use carom::trace::{Ending, EventKind};

/// Hard cases and what they are called in the reference.
pub const CASES: [(&str, &str); 11] = [
    ("soft-break-2ms", "a1-rack-2ms-seed11"),
    ("soft-break-4ms", "a2-rack-4ms-seed13"),
    ("accumulate-three", "a3-three-e1"),
    ("accumulate-four-lossy", "a4-four-e08-friction"),
    ("press-plastic", "b1-plastic-inline"),
    ("press-follow", "b2-soft-follow-friction"),
    ("press-off-line", "b3-offline-release"),
    ("press-cushion", "b4-cushion"),
    ("clay-follow", "b7-b35"),
    ("press-three", "b8-three-inline"),
    ("one-on-two-lossy", "c1-one-on-two"),
];

/// Hard cases whose answers are held here and with the reference.
pub fn is_answered(name: &str) -> bool {
    name == COMBINATION || CASES.iter().any(|(case, _)| *case == name)
}

/// A combination through a frozen pair.
const COMBINATION: &str = "frozen-pair-combination";

#[test]
fn hard_cases_of_contacts_are_those_of_the_reference() {
    for (name, reference) in CASES {
        let ours = catalogue::scene(name).unwrap_or_else(|error| panic!("{name}: {error}"));
        let toml = format!("{reference}.toml");
        let theirs = parse(&toml, &text(&format!("contact/{toml}")));
        let theirs = theirs.unwrap_or_else(|error| panic!("{reference}: {error}"));
        assert_eq!(ours.balls, theirs.balls, "{name}");
        assert_eq!(ours.effects, theirs.effects, "{name}");
        assert_eq!(ours.table, theirs.table, "{name}");
        assert_eq!(ours.simultaneous, theirs.simultaneous, "{name}");
        assert_eq!(ours.gravity, theirs.gravity, "{name}");
        assert_eq!(ours.duration, theirs.duration, "{name}");
    }
}

#[test]
fn a_combination_through_a_frozen_pair_sends_the_second_ball_along_the_line_of_centres() {
    let scene = catalogue::scene(COMBINATION).unwrap_or_else(|e| panic!("{e}"));
    let trace = solve::<f64>(&scene, &Limits::NONE).trace;
    assert_eq!(trace.ending, Ending::Rest);
    let begins = |kind| matches!(kind, EventKind::ContactBegin(..));
    assert!(trace.events.iter().any(|e| begins(e.kind)), "no contact");
    let last = trace.paths[2].last().map(|s| s.position);
    let last = last.unwrap_or_else(|| panic!("the second ball is gone"));
    let start = scene.balls[2].state.position;
    let (along, across) = (last.x - start.x, last.y - start.y);
    // "within a few degrees", and far: it takes most of the speed
    assert!(along > 0.5, "{along} m along the line");
    let aside = across.atan2(along).abs().to_degrees();
    assert!(aside < 5.0, "{aside} degrees off the line");
    let finer = final_positions::<DoubleDouble>(&scene);
    for (path, finer) in trace.paths.iter().zip(&finer) {
        let got = path.last().map(|s| [s.position.x, s.position.y]);
        let got = got.unwrap_or([f64::NAN; 2]);
        for (got, finer) in got.into_iter().zip(finer) {
            let off = (*finer - DoubleDouble::lift(got)).abs().to_f64();
            assert!(off <= 1e-8 * R, "{off:e} m between precisions");
        }
    }
}
