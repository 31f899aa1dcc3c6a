//! Several encounters whose impacts shrink together: balls pressed to one that knocks at another, chains of balls that knock at each other.

use carom::engine::Limits;
use carom::engine::exact::solve_following;
use carom::scene::perturb::{Law, Perturbation};
use carom::scene::{Scene, parse};
use carom::trace::{Ending, EventKind, UNEXPLAINED_IN_CONTACT};

/// The pool break at 2 m/s, moved by the law of `carom ensemble --seed 3`.
fn soft_break(index: u64) -> Scene {
    let hard = include_str!("../../../validation/scenes/pool-break.toml");
    let soft = hard.replace("\nspeed = 12.0\n", "\nspeed = 2.0\n");
    assert_ne!(soft, hard, "another speed");
    let scene = parse("pool-break", &soft).unwrap_or_else(|error| panic!("{error}"));
    let drawn = Perturbation::new(&scene, Law::default_for(&scene));
    drawn
        .unwrap_or_else(|error| panic!("{error}"))
        .sample(3, index)
}

#[test]
fn a_soft_break_goes_on_through_nested_limits_to_rest_and_gains_nothing() {
    let mut most = 0;
    for index in [0, 1, 9, 10] {
        let scene = soft_break(index);
        let trace = solve_following::<f64>(&scene, &Limits::NONE).trace;
        assert_eq!(trace.ending, Ending::Rest, "sample {index}");
        let extrema = &trace.extrema;
        let (gained, overlap) = (extrema.energy_gained.value, extrema.overlap.value);
        assert!(gained <= 1e-12, "sample {index} gains {gained:e} J");
        let touching = scene.touching();
        assert!(overlap <= touching, "sample {index}: overlap {overlap:e} m");
        let unexplained = trace.unexplained();
        let allowed = 1.01 * UNEXPLAINED_IN_CONTACT * scene.smallest_radius();
        assert!(
            unexplained <= allowed,
            "sample {index}: {unexplained:e} m, allowed {allowed:e}"
        );
        let begins = |kind: EventKind| matches!(kind, EventKind::ContactBegin(..));
        most = most.max(trace.events.iter().filter(|e| begins(e.kind)).count());
    }
    assert!(most >= 100, "no sample has more than {most} contacts");
}
