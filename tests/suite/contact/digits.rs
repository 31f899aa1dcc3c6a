//! Runs through contacts in 53 and in 106 bits: which events are certain, and where the balls end.

use super::second::Break;
use super::{CASES, case};
use carom::engine::Limits;
use carom::engine::exact::{final_positions, place_errors};
use carom::math::{DoubleDouble, Real};
use carom::oracle::{Horizon, Limit, Precision, Sight, horizon};
use carom::scene::Scene;
use carom::trace::EventKind;

/// Samples of each break.
const SAMPLES: u64 = 8;

/// Breaks and speeds of which samples are taken, m/s.
const BREAKS: [(Break, f64); 5] = [
    (Break::Pool, 11.0),
    (Break::Pool, 8.0),
    (Break::Pool, 4.0),
    (Break::Report, 4.0),
    (Break::Frozen, 4.0),
];

/// An error estimated from 16 probes is beyond four deviations now and then: no more often than this.
const BEYOND: f64 = 1e-2;

fn in_f64(scene: &Scene) -> Horizon {
    let found = horizon(scene, Precision::F64, false, &Limits::NONE);
    found.unwrap_or_else(|| panic!("no horizon"))
}

/// Largest distance of a ball's last places in both precisions, and how far it may be off as printed, length; `None` where nothing is printed.
fn ends(scene: &Scene, found: &Horizon) -> Option<(f64, f64)> {
    // empty of a run without contacts, of which `Whole` says all there is
    let printed = place_errors(scene, &found.trace, f64::EPSILON, &Limits::NONE);
    let theirs = final_positions::<DoubleDouble>(scene);
    let mut worst: Option<(f64, f64)> = None;
    for (ball, (path, printed)) in found.trace.paths.iter().zip(&printed).enumerate() {
        let Some(state) = path.last().filter(|_| !found.trace.pocketed(ball)) else {
            continue;
        };
        let [x, y] = [0, 1].map(|axis| state.position[axis] - theirs[ball][axis].to_f64());
        let off = x.hypot(y);
        let is_worse = worst.is_none_or(|(known, allowed)| off / printed > known / allowed);
        if printed.is_finite() && is_worse {
            worst = Some((off, *printed));
        }
    }
    worst
}

#[test]
fn accumulations_of_the_reference_are_one_event_of_which_all_is_certain() {
    let begins = |sight: &&Sight| matches!(sight.event.kind, EventKind::ContactBegin(..));
    for (name, _) in CASES.into_iter().filter(|(name, _)| !name.starts_with('a')) {
        let found = in_f64(&case(name).scene);
        assert_eq!(found.limit, Limit::Whole, "{name}: {}", found.certain);
        assert!(found.until.is_infinite(), "{name}");
    }
    // of 85 impacts of a pair the last fifty follow each other within the error of their times
    for (name, limit) in [
        ("a2-rack-4ms-seed13", Limit::Whole),
        ("a3-three-e1", Limit::Whole),
        // up to where f64 lets go of a ball that stops, and tells of its stop again
        ("a4-four-e08-friction", Limit::Order),
    ] {
        let found = in_f64(&case(name).scene);
        assert_eq!(found.limit, limit, "{name}: {}", found.certain);
        let contacts = found.sights.iter().filter(begins);
        let sure = found.sights[..found.certain].iter().filter(begins);
        assert_eq!(sure.count(), contacts.count(), "{name}: {}", found.certain);
        let of_no_account = found.sights.iter().filter(|sight| sight.shrinks);
        assert!(of_no_account.count() > 20, "{name}");
        for sight in found.sights.iter().filter(begins) {
            let (seen, estimated) = (sight.seen, sight.estimated);
            assert!(seen.is_some() && seen <= estimated, "{name}: {sight:?}");
        }
    }
}

#[test]
fn what_a_run_in_53_bits_is_sure_of_106_bits_confirm() {
    let (mut whole, mut through, mut compared, mut beyond) = (0, 0, 0, 0);
    for (which, speed) in BREAKS {
        let drawn = which.samples(speed);
        for sample in 0..SAMPLES {
            let scene = drawn.sample(3, sample);
            let found = in_f64(&scene);
            assert!(
                found.trace.ending.is_complete(),
                "{which:?} {speed}, {sample}"
            );
            for sight in found.sights[..found.certain].iter().filter(|s| !s.shrinks) {
                let (Some(seen), Some(estimated)) = (sight.seen, sight.estimated) else {
                    continue;
                };
                compared += 1;
                beyond += usize::from(seen > estimated);
                assert!(
                    seen <= 4.0 * estimated,
                    "{which:?} {speed}, {sample}: {sight:?}"
                );
            }
            if !found.is_whole() {
                continue;
            }
            whole += 1;
            if let Some((off, printed)) = ends(&scene, &found) {
                through += 1;
                let what = format!("{which:?} {speed}, {sample}");
                assert!(off <= printed, "{what}: {off:e}, printed {printed:e}");
            }
        }
    }
    assert!(
        whole >= 10 && through >= 3,
        "{whole} whole, {through} through contacts"
    );
    assert!(
        (beyond as f64) < BEYOND * compared as f64,
        "{beyond} of {compared} times beyond their error"
    );
}
