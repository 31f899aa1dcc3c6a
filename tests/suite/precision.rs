//! The exact engine in many scalars: what more digits must agree on.

use crate::references::{self, reference};
use crate::support::{R, report_break};
use carom::engine::Limits;
use carom::engine::exact::{Solution, solve};
use carom::math::{DoubleDouble, Octuple, Real};
use carom::scene::Scene;
use carom::trace::{Ending, EventKind};
use serde_json::Value;

fn kinds<T>(solution: &Solution<T>) -> Vec<EventKind> {
    solution
        .trace
        .events
        .iter()
        .map(|event| event.kind)
        .collect()
}

fn wide(x: DoubleDouble) -> Octuple {
    Octuple::lift(x.high()) + Octuple::lift(x.low())
}

/// Largest difference of final centres, in units of the radius.
fn apart<A: Copy, B: Copy>(
    a: &Solution<A>,
    b: &Solution<B>,
    difference: impl Fn(A, B) -> f64,
) -> f64 {
    assert_eq!(a.positions.len(), b.positions.len());
    let pairs = a.positions.iter().zip(&b.positions);
    pairs
        .flat_map(|(p, q)| [difference(p[0], q[0]), difference(p[1], q[1])])
        .map(f64::abs)
        .fold(0.0, f64::max)
        / R
}

fn run<T: Real>(scene: &Scene) -> Solution<T> {
    solve(scene, &Limits::NONE)
}

#[test]
fn double_double_and_237_bits_agree_on_a_whole_break() {
    for (gap, angle) in [(1e-2 * R, 90.2), (1e-3 * R, 90.35), (3e-2 * R, 91.1)] {
        let scene = report_break(gap, angle);
        let (dd, octuple) = (run::<DoubleDouble>(&scene), run::<Octuple>(&scene));
        assert_eq!(octuple.trace.ending, Ending::Rest);
        assert_eq!(kinds(&dd), kinds(&octuple), "aim {angle}: order");
        assert!(dd.trace.events.len() > 10);
        let difference = apart(&dd, &octuple, |x, y| (wide(x) - y).to_f64());
        // 2^-104 times coordinates of 100 R times a growth of up to 1000
        assert!(
            difference > 0.0 && difference <= 1e-26,
            "exact, aim {angle}, gap {gap}: dd and 237 bits differ by {difference:e} R"
        );
        for (x, y) in dd.times.iter().zip(&octuple.times) {
            assert!((wide(*x) - *y).to_f64().abs() <= 1e-26);
        }
    }
}

#[test]
fn all_two_hundred_collisions_of_ten_discs_come_out_at_237_bits() {
    let truth = reference("e_discs_seed1_mp260");
    let mut scene = truth.scene.clone();
    scene.duration = 38.0;
    let got = run::<Octuple>(&scene);
    assert_eq!(truth.events.len(), 200);
    assert!(got.times.len() >= 200, "{} events", got.times.len());
    let file: Value = serde_json::from_str(&references::text("e_discs_seed1_mp260.json")).unwrap();
    let mut worst = 0.0_f64;
    for (i, want) in truth.events.iter().enumerate() {
        assert_eq!(got.trace.events[i].kind, want.kind, "event {i}");
        let digits = file["events"][i]["t"].as_str().unwrap();
        let time: Octuple = digits.parse().unwrap();
        // the reference is written with 25 digits: half a unit of the last one
        let decimals = digits.split_once('.').unwrap().1.len() as i32;
        let error = (got.times[i] - time).to_f64().abs() * 10_f64.powi(decimals);
        worst = worst.max(error);
        assert!(
            error <= 0.51,
            "event {i}: {error} units of the last digit of {digits}"
        );
    }
    assert!(worst > 0.0);
}

#[test]
fn precisions_agree_on_the_break_and_one_that_cannot_order_it_says_so() {
    use crate::support::{R, report_break, run};
    let scene = report_break(1e-2 * R, 90.2);
    let order = |precision: &str| {
        let trace = run("exact", &[precision], &scene, carom::trace::Record::Events);
        assert!(
            trace.ending.is_complete(),
            "{precision}: {:?}",
            trace.ending
        );
        let kinds: Vec<_> = trace.events.iter().map(|event| event.kind).collect();
        (kinds, trace.final_states())
    };
    let (reference, ends) = order("precision=f64");
    assert!(reference.len() > 20);
    for precision in ["precision=dd", "precision=f256"] {
        let (kinds, finals) = order(precision);
        assert_eq!(kinds, reference, "{precision}");
        for (a, b) in finals.iter().zip(&ends) {
            // f64 errs by rounding times the growth of this break, below 1e4: a known figure is 1.7e-12 at worst
            let apart = (a.unwrap().position - b.unwrap().position).norm();
            assert!(apart < 1e-11, "{precision}: {apart:e}");
        }
    }
    // 24 bits cannot tell hits of the break apart, and the run says so instead of choosing
    let coarse = run(
        "exact",
        &["precision=f32"],
        &scene,
        carom::trace::Record::Events,
    );
    assert!(
        !coarse.ending.is_complete() && coarse.ending.spot().is_some(),
        "{:?}",
        coarse.ending
    );
    assert!(!coarse.events.is_empty());
}
