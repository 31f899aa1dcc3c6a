//! The audit of the report computes what its specification states.

use carom::page::claims::page;
use carom::study::Watch;
use carom::study::claims::{Claim, audit};

fn number(claims: &[Claim], id: &str, what: &str) -> f64 {
    let claim = claims
        .iter()
        .find(|claim| claim.id == id)
        .unwrap_or_else(|| panic!("no claim {id}"));
    claim
        .number(what)
        .unwrap_or_else(|| panic!("{id} has no number `{what}`: {:?}", claim.numbers))
}

#[test]
fn every_claim_is_computed_and_agrees_with_the_known_findings() {
    let watch = Watch::NONE;
    let claims = audit(crate::support::roster(), watch).unwrap();
    // half a unit in the last digit that the specification of the report's model gives
    for (id, what, known, tolerance) in [
        ("launch", "speed at dt 1/30 s", 33.6, 0.05),
        ("launch", "speed at dt 1/100 s", 10.09, 0.005),
        ("launch", "speed at dt 1/240 s", 4.21, 0.005),
        (
            "launch",
            "stopping distance, dt halved from 1/100 s",
            4.0,
            0.01,
        ),
        ("units", "length units in a metre", 8.2021, 0.00005),
        ("units", "gravity in the report's units", 80.46, 0.005),
        (
            "units",
            "friction that the report simulates",
            0.0244,
            0.00005,
        ),
        ("units", "radius", 0.234375, 1e-15),
        ("sliding", "as the report simulates it", 8.36, 0.005),
        (
            "sliding",
            "sliding all the way, consistent gravity",
            1.02,
            0.005,
        ),
        ("sliding", "sliding, then rolling", 10.9, 0.05),
        ("table", "ratio as simulated", 1.924, 0.0005),
        ("table", "length", 2.84, 0.005),
        ("table", "width", 1.42, 0.005),
        // an independent transcription counted these, with motion; the counts are of whole exchanges
        ("sticking", "exchanges as written, aim 90.2", 4800.0, 0.5),
        ("sticking", "exchanges as written, aim 89.8", 3021.0, 0.5),
        ("sticking", "exchanges of approaching balls only", 21.0, 1.5),
    ] {
        let got = number(&claims, id, what);
        assert!(
            (got - known).abs() <= tolerance,
            "{id}, {what}: {got}, known {known} +- {tolerance}"
        );
    }
    let right = number(&claims, "sticking", "ball-ball hits of the exact solution");
    let off = number(&claims, "sticking", "worst final position, as written");
    assert!(right < 40.0, "{right} hits are right");
    // the specification saw 1.5 to 4.7 over its aims
    assert!((1.45..4.75).contains(&off), "off by {off}");
    assert!(number(&claims, "sticking", "pairs overlapping at rest") >= 1.0);
    assert!(number(&claims, "sticking", "aim 90.2 against 89.8 mirrored") > 0.1);
    let (error, predicted) = (
        number(&claims, "order", "error of the position"),
        number(&claims, "order", "a t dt / 2"),
    );
    assert!(
        (error / predicted - 1.0).abs() < 0.01,
        "{error:e} against {predicted:e}"
    );
    assert_eq!(number(&claims, "mass", "shift of the final positions"), 0.0);

    assert!(
        claims
            .iter()
            .flat_map(|claim| &claim.numbers)
            .all(|(_, value, _)| value.is_finite())
    );
    assert_eq!(page(&claims).blocks.len(), 1 + 3 * claims.len());
}
