//! The error theory against the thing itself: contacts of approaches that are wrong by a known amount.

use super::truth::{Kind, Motion, Row, rows};
use carom::math::first_root::{
    Approach, Blur, Contact, InputError, crossing_error, first_contact, first_crossing, time_error,
};
use carom::math::{DoubleDouble, Real};

type Wide = DoubleDouble;

/// Fine enough that no contact of the file is in doubt.
const SHARP: f64 = 1e-28;

fn wide(x: f64) -> Wide {
    Wide::lift(x)
}

/// Contact of an approach that is off along the line of centres at its contact: in position by `d[0]`, in velocity by `d[1]`,
/// in acceleration by `d[2]`.
fn pushed(row: &Row, n: [Wide; 2], d: [f64; 3]) -> Contact<Wide> {
    let m = row.approach::<Wide>();
    let by = |x: [Wide; 2], d: f64| [0, 1].map(|i| x[i] + n[i] * wide(d));
    let off = Approach {
        p: by(m.p, d[0]),
        v: by(m.v, d[1]),
        a: by(m.a, d[2]),
        ..m
    };
    let blur = Blur {
        length: wide(SHARP * (m.distance.to_f64() + off.p[0].abs().to_f64())),
        speed: wide(0.0),
    };
    first_contact(&off, wide(4.0 * row.limit), &blur)
}

#[test]
fn an_error_of_the_input_moves_a_contact_by_its_bound_at_most_and_by_half_of_it_at_worst() {
    let (mut bounded, mut unbounded, mut slack) = (0, 0, f64::INFINITY);
    for row in rows() {
        // not straight: an error of v would go with one of a
        if row.kind != Kind::Hit || !matches!(row.motion, Motion::Curved(_)) || !row.fits(1e-150) {
            continue;
        }
        let m = row.approach::<Wide>();
        let free = |x: [Wide; 2]| Real::sqrt(x[0] * x[0] + x[1] * x[1]).to_f64();
        // a start within the error of contact is contact now
        if free(m.p) < 1.01 * row.distance {
            continue;
        }
        let Contact::At(t) = pushed(&row, [wide(0.0); 2], [0.0; 3]) else {
            panic!("no contact in double-double: {row:?}");
        };
        let at = [0, 1].map(|i| m.p[i] + t * (m.v[i] + m.a[i] * t * wide(0.5)));
        let n = at.map(|x| x / m.distance);
        let time = t.to_f64();
        for part in [1e-12, 1e-9, 1e-6] {
            let length = part * row.distance.min(row.margin);
            // the same length by an error of position, of velocity, of acceleration
            for d in [
                [length, 0.0, 0.0],
                [0.0, length / time, 0.0],
                [0.0, 0.0, 2.0 * length / (time * time)],
            ] {
                let error = InputError {
                    position: wide(d[0]),
                    velocity: wide(d[1]),
                    acceleration: wide(d[2]),
                };
                let Some(bound) = time_error(&m, t, &error) else {
                    unbounded += 1;
                    continue;
                };
                let mut largest = 0.0_f64;
                for sign in [1.0, -1.0] {
                    let Contact::At(moved) = pushed(&row, n, d.map(|x| sign * x)) else {
                        panic!("{d:?} removes a contact that has a bound: {row:?}");
                    };
                    largest = largest.max((moved - t).abs().to_f64());
                }
                let over = largest / bound.to_f64();
                // both times are good to the finder's own error in double-double
                let own = InputError::of_search(&m, Wide::ROUNDING).length(t);
                let rounding = 2.0 * own.to_f64() / length;
                assert!(
                    over <= 1.0 + rounding,
                    "{d:?}: {over} of the bound for {row:?}"
                );
                slack = slack.min(over);
                bounded += 1;
            }
        }
    }
    assert!(bounded > 4000, "{bounded} bounds, {unbounded} without");
    // the bound is the motion itself where f'' changes little within its window
    assert!(slack >= 0.5, "the bound is {} times too large", 1.0 / slack);
}

#[test]
fn an_error_larger_than_the_depth_of_a_contact_has_no_bound() {
    let mut seen = 0;
    for row in rows() {
        if row.kind != Kind::Hit || !row.class.starts_with("graze") {
            continue;
        }
        let m = row.approach::<f64>();
        let t = row.time.map_or(f64::NAN, |t| t.to_f64());
        // deeper than rounding of t
        if row.margin < 1e-10 * row.distance {
            continue;
        }
        let bound = |length: f64| {
            let error = InputError {
                position: length,
                ..InputError::default()
            };
            time_error(&m, t, &error)
        };
        assert_eq!(bound(1.01 * row.margin), None, "{row:?}");
        assert!(bound(0.1 * row.margin).is_some(), "{row:?}");
        seen += 1;
    }
    assert!(seen > 100, "{seen} grazes");
}

#[test]
fn an_error_of_the_gap_moves_a_crossing_by_its_bound() {
    let blur = Blur {
        length: 1e-30,
        speed: 0.0,
    };
    // (gap, speed, acceleration, why)
    for (gap, speed, acceleration, why) in [
        (1.0, 2.0, 0.0, "constant velocity: the gap over the speed"),
        (
            1.0,
            2.0,
            -1.9999,
            "slowing, a ten-thousandth of the way before it would stop",
        ),
        (1.0, -1.0, 2.0, "inward, turned outward"),
    ] {
        let at = |gap: f64| {
            first_crossing(gap, speed, acceleration, 100.0, &blur)
                .time()
                .unwrap()
        };
        let t = at(gap);
        for length in [1e-9, 1e-6] {
            let error = InputError {
                position: length,
                ..InputError::default()
            };
            let bound = crossing_error(speed, acceleration, t, &error).unwrap();
            let moved = (at(gap + length) - t)
                .abs()
                .max((at(gap - length) - t).abs());
            // both times are good to the finder's own error
            let own = InputError::of_crossing(speed, acceleration, f64::ROUNDING);
            let rounding = 2.0 * own.length(t) / length;
            assert!(
                moved <= bound * (1.0 + rounding) && moved >= 0.9 * bound,
                "{why}: {moved:e} of {bound:e}"
            );
        }
    }
    let wide = InputError {
        position: 1e-3,
        ..InputError::default()
    };
    assert_eq!(
        crossing_error(2.0, -1.9999, 1.99, &wide),
        None,
        "it might stop short of the line"
    );
}
