//! The exact engine goes on from its own knots as it did.

use super::contact::lasting;
use super::{CASES, Grain, Side, apart, case, from, knots, run};
use carom::math::random::Draws;
use carom::scene::Scene;
use carom::study::random::scene as random;
use carom::trace::{EventKind, Trace};

/// What two times of one event may be apart where nothing grows, s.
const TIMES: f64 = 1e-9;

/// An error may be so many times that of starts which are an ulp away: the largest of a few stands for all.
const SAMPLED: f64 = 64.0;

/// Starts that are an ulp away.
const NUDGES: usize = 3;

/// Every coordinate of a start an ulp larger or smaller.
fn nudged(scene: &Scene, draws: &mut Draws) -> Scene {
    let mut scene = scene.clone();
    let mut ulp = || match draws.bits() % 2 {
        0 => 1.0 + f64::EPSILON,
        _ => 1.0 - f64::EPSILON,
    };
    for ball in &mut scene.balls {
        for axis in 0..2 {
            ball.state.position[axis] *= ulp();
            ball.state.velocity[axis] *= ulp();
            ball.state.spin[axis] *= ulp();
        }
    }
    scene
}

/// Rounding times growth, as the run itself shows it, length: how far the ends of starts an ulp away are from that of `again`.
fn grown(rest: &Scene, again: &Trace, draws: &mut Draws) -> f64 {
    let rounding = 64.0
        * f64::EPSILON
        * (rest.largest_coordinate() + again.end_time.min(1.0) * rest.fastest());
    let ends = (0..NUDGES).filter_map(|_| run("exact", &nudged(rest, draws)).ok());
    ends.fold(rounding, |most, end| most.max(SAMPLED * apart(again, &end)))
}

/// Impacts faster than `least`, length/s, from `since` on: what, when after that, and how fast.
fn fast(trace: &Trace, since: f64, least: f64) -> Vec<(EventKind, f64, f64)> {
    let impacts = trace.events.iter().filter(|event| event.time >= since);
    let impacts = impacts.filter_map(|event| {
        let closing = match event.kind {
            EventKind::BallBall(a, b) => {
                let [a, b] = [a, b].map(|ball| trace.paths[ball as usize].before(event.time));
                let way = b?.position - a?.position;
                way.dot(&(a?.velocity - b?.velocity)) / way.norm()
            }
            EventKind::BallCushion(a, side) => {
                trace.paths[a as usize].before(event.time)?.velocity[side.axis()].abs()
            }
            _ => return None,
        };
        (closing > least).then_some((event.kind, event.time - since, closing))
    });
    impacts.collect()
}

/// Every one of `some` has one of `others` of its kind at its time.
fn hold_impacts(
    what: &str,
    some: &[(EventKind, f64, f64)],
    others: &[(EventKind, f64, f64)],
    allowed: f64,
) {
    for (kind, time, closing) in some {
        let off = TIMES + allowed / closing;
        let same =
            |other: &&(EventKind, f64, f64)| other.0 == *kind && (other.1 - time).abs() <= off;
        let found = others.iter().any(|other| same(&other));
        assert!(found, "{what}: no {kind:?} at {time} s, at {closing:e}");
    }
}

#[test]
fn a_run_goes_on_from_every_knot_of_it_as_it_did() {
    let mut draws = Draws::new(5, 0);
    for name in CASES {
        let scene = case(name);
        let whole = run("exact", &scene).unwrap();
        let grain = Grain::of(&scene);
        // all knots of the small ones
        let held = lasting(&whole);
        for time in knots(&whole, 60) {
            // within a contact only its own knots are states of the run: see there
            if held
                .iter()
                .any(|(.., begin, end)| time > *begin && time < *end)
            {
                continue;
            }
            for side in [Side::Near, Side::Far] {
                let what = format!("{name} from {side:?} of {time:?} s");
                let Some(rest) = from(&scene, &whole, time, side) else {
                    continue;
                };
                let again =
                    run("exact", &rest).unwrap_or_else(|refusal| panic!("{what}: {refusal}"));
                assert_eq!(again.ending, whole.ending, "{what}");
                let left = whole.end_time - time;
                // a limit leaves a part of an approach that is nothing; from within one the gaps are no more than rounding
                let vague = match grain.is_within_limit(&rest) {
                    true => grain.noise,
                    false => grain.nothing(),
                };
                let allowed = grown(&rest, &again, &mut draws) + vague * left;
                let off = apart(&whole, &again);
                assert!(
                    off <= allowed,
                    "{what}: {off:e} m apart, allowed {allowed:e}"
                );
                let (least, later) = (grain.blurs(), TIMES);
                let was = fast(&whole, time, least);
                let is = fast(&again, 0.0, least);
                let clear = |list: &[(EventKind, f64, f64)]| -> Vec<(EventKind, f64, f64)> {
                    let clear = list
                        .iter()
                        .filter(|(_, time, v)| *v > 2.0 * least && *time > later);
                    clear.copied().collect()
                };
                hold_impacts(&what, &clear(&was), &is, allowed);
                hold_impacts(&what, &clear(&is), &was, allowed);
            }
        }
    }
}

#[test]
fn random_scenes_go_on_from_their_knots_as_they_did() {
    let mut draws = Draws::new(6, 0);
    let (mut held, mut forgotten) = (0, 0);
    for index in 0..300 {
        let scene = random(77, index).unwrap();
        let Ok(whole) = run("exact", &scene) else {
            continue;
        };
        // once a ball has left play the others are another scene; contacts between balls of all sizes are for others to judge
        if !whole.ending.is_complete()
            || whole.follows_contacts()
            || (0..scene.balls.len()).any(|i| whole.pocket_of(i).is_some())
        {
            continue;
        }
        let grain = Grain::of(&scene);
        for time in knots(&whole, 4) {
            let Some(rest) = from(&scene, &whole, time, Side::Far) else {
                continue;
            };
            if grain.is_within_limit(&rest) {
                continue;
            }
            let what = format!("scene {index} of seed 77 from {time:e} s");
            let again = run("exact", &rest).unwrap_or_else(|refusal| panic!("{what}: {refusal}"));
            if again.ending.id() != whole.ending.id() {
                // which contacts came about in the run is no part of a state
                assert!(
                    matches!(again.ending.id(), "indeterminate" | "collapsed"),
                    "{what}: {:?}",
                    again.ending
                );
                forgotten += 1;
                continue;
            }
            let vague = grain.nothing() * (whole.end_time - time);
            let allowed = grown(&rest, &again, &mut draws) + vague;
            let off = apart(&whole, &again);
            assert!(off <= allowed, "{what}: {off:e} apart, allowed {allowed:e}");
            held += 1;
        }
    }
    assert!(held >= 300, "{held} starts");
    assert!(
        50 * forgotten <= held,
        "{forgotten} of {held} are not told by their states"
    );
}
