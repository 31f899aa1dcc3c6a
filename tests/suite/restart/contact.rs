//! Inside a contact the contact is found again from the state alone.

use super::{CASES, Grain, Side, apart, case, from, run};
use carom::scene::Scene;
use carom::trace::{Event, EventKind, Partner, Trace};

/// Starts between the begin and the end of each contact.
const BETWEEN: u32 = 12;

/// What two times of one event may be apart, s.
const TIMES: f64 = 1e-9;

/// Contacts of a trace with the times between which they lasted, s.
pub fn lasting(trace: &Trace) -> Vec<(u32, Partner, f64, f64)> {
    let begun = trace.events.iter().enumerate();
    let lasting = begun.filter_map(|(index, event)| {
        let EventKind::ContactBegin(ball, partner) = event.kind else {
            return None;
        };
        let end = |event: &&Event| event.kind == EventKind::ContactEnd(ball, partner);
        let end = trace.events[index..].iter().find(end);
        let end = end.map_or(trace.end_time, |event| event.time);
        (end > event.time + TIMES).then_some((ball, partner, event.time, end))
    });
    lasting.collect()
}

/// The same scene cut at `time`: its states are those of the run and no interpolation.
fn cut(scene: &Scene, time: f64) -> Trace {
    let mut scene = scene.clone();
    (scene.duration, scene.run_to_duration) = (time, true);
    run("exact", &scene).unwrap()
}

/// Holds that a run from within a contact finds it and goes on as the whole one; answers whether it is told.
fn hold(
    what: &str,
    scene: &Scene,
    whole: &Trace,
    rest: &Scene,
    (ball, partner, end): (u32, Partner, f64),
) -> bool {
    let again = run("exact", rest).unwrap_or_else(|refusal| panic!("{what}: {refusal}"));
    assert_eq!(again.ending, whole.ending, "{what}");
    let time = scene.duration - rest.duration;
    let grain = Grain::of(scene);
    let rounding = 64.0
        * f64::EPSILON
        * (scene.largest_coordinate() + scene.fastest() * whole.end_time.min(1.0));
    let allowed = rounding + grain.nothing() * (whole.end_time - time);
    let off = apart(whole, &again);
    assert!(
        off <= allowed,
        "{what}: {off:e} m apart, allowed {allowed:e}"
    );
    let find = |kind: EventKind| again.events.iter().find(|event| event.kind == kind);
    let begun = find(EventKind::ContactBegin(ball, partner)).filter(|event| event.time == 0.0);
    if begun.is_some() {
        let ended = find(EventKind::ContactEnd(ball, partner)).map(|event| event.time + time);
        let ended = ended.unwrap_or(f64::NAN);
        assert!(
            (ended - end).abs() <= TIMES,
            "{what}: ends at {ended}, not {end}"
        );
    } else {
        // without a force there is no contact to tell of: they go on alongside and never meet
        let meets = |event: &Event| {
            let party = |other: u32| ball == other || partner == Partner::Ball(other);
            match event.kind {
                EventKind::BallBall(a, b) => {
                    party(a) && party(b) && event.time + time < end - TIMES
                }
                _ => false,
            }
        };
        let met = again.events.iter().find(|event| meets(event));
        assert!(met.is_none(), "{what}: {met:?}");
    }
    begun.is_some()
}

#[test]
fn a_contact_is_found_again_from_any_state_within_it() {
    let (mut told, mut alongside) = (0, 0);
    for name in CASES {
        let scene = case(name);
        let whole = run("exact", &scene).unwrap();
        for (ball, partner, begin, end) in lasting(&whole) {
            let contact = (ball, partner, end);
            let mut found = |what: String, rest: Option<Scene>| {
                let rest = rest.unwrap_or_else(|| panic!("{what}: nothing is left"));
                match hold(&what, &scene, &whole, &rest, contact) {
                    true => told += 1,
                    false => alongside += 1,
                }
            };
            for part in 1..BETWEEN {
                let time = begin + (end - begin) * f64::from(part) / f64::from(BETWEEN);
                let what = format!("{name}: {ball} and {partner:?} from {time} s");
                found(what, from(&scene, &cut(&scene, time), time, Side::Far));
            }
            // and at its knots, every some of many: both parties have theirs at the same times
            let inside = |time: f64| time > begin + TIMES && time < end - TIMES;
            let own = whole.paths[ball as usize]
                .knots
                .iter()
                .map(|knot| knot.time);
            let own: Vec<f64> = own.filter(|time| inside(*time)).collect();
            for time in own.iter().step_by(own.len().div_ceil(12).max(1)) {
                let what = format!("{name}: {ball} and {partner:?} from the knot at {time} s");
                found(what, from(&scene, &whole, *time, Side::Far));
            }
        }
    }
    assert!(
        told >= 60 && alongside >= 100,
        "{told} told, {alongside} alongside"
    );
}
