//! Dual numbers through the finders: the derivative of a contact time by every number of its input.
//!
//! Truth is a central difference quotient in double-double, whose step is a billionth of the margin of the contact and of the number: it leaves
//! 1e-18 of the derivative and the rounding of 106 bits over the step. The derivative itself is `-f_q / f'` at the
//! contact, so what the time and the state at it are off by (the bounds of `math::first_root`) bounds what it is off by.

use super::LEAST_F64;
use super::truth::{Finder, Kind, Motion, Row, Wide, rows};
use carom::math::first_root::{
    Approach, InputError, first_contact, first_crossing, straight_contact,
};
use carom::math::{DoubleDouble, Dual, Octuple, Real};

/// Position, velocity, acceleration, distance; the place of the first acceleration is that of `rest` in straight motion.
const INPUTS: usize = 7;

fn inputs(row: &Row) -> [f64; INPUTS] {
    let ([x, y], [u, w]) = (row.p, row.v);
    let [a, b] = match row.motion {
        Motion::Curved(a) => a,
        Motion::Straight(rest) => [rest, 0.0],
        Motion::Wall(a) => [a, 0.0],
    };
    [x, y, u, w, a, b, row.distance]
}

/// The finder as a function of those numbers.
fn time<T: Real>(row: &Row, finder: Finder, q: &[T; INPUTS]) -> Option<T> {
    let [x, y, u, w, a, b, distance] = *q;
    let blur = row.blur::<T>();
    // it must not cut off what the quotient looks at
    let limit = T::lift(2.0 * row.limit);
    match finder {
        Finder::Search => {
            let m = Approach {
                p: [x, y],
                v: [u, w],
                a: [a, b],
                distance,
            };
            first_contact(&m, limit, &blur)
        }
        Finder::Straight => straight_contact([x, y], [u, w], a, distance, limit, &blur),
        Finder::Wall => first_crossing(x, u, a, limit, &blur),
    }
    .time()
}

/// By how much a step of input `k` changes the distance at time `t`, and the rate of that: lengths per unit of the input.
fn leverage(row: &Row, k: usize, t: f64) -> (f64, f64) {
    let speed = row.v[0].hypot(row.v[1]);
    match (k, row.motion) {
        (0 | 1 | 6, _) => (1.0, 0.0),
        (2 | 3, Motion::Straight(rest)) => (t - t * t / (2.0 * rest), 1.0),
        (2 | 3, _) => (t, 1.0),
        (_, Motion::Straight(rest)) => {
            let a = speed / (rest * rest);
            (a * t * t / 2.0, a * t)
        }
        _ => (t * t / 2.0, t),
    }
}

#[test]
fn derivatives_of_a_contact_time_are_those_of_difference_quotients() {
    let (mut checked, mut skipped, mut worst) = (0, 0, 0.0_f64);
    for row in rows() {
        if row.kind != Kind::Hit || !row.fits(LEAST_F64) {
            continue;
        }
        let (finder, numbers) = (row.finders()[0], inputs(&row));
        let seeded: [Dual<f64, INPUTS>; INPUTS] =
            std::array::from_fn(|k| Dual::input(numbers[k], k));
        let Some(found) = time(&row, finder, &seeded) else {
            // flagged; the time is judged elsewhere
            skipped += 1;
            continue;
        };
        if found.value == 0.0 {
            // by the rule of touching: constant
            continue;
        }
        let exact = row.approach::<Octuple>();
        let own = |rounding| match finder {
            Finder::Search => InputError::of_search(&exact, rounding),
            Finder::Straight => InputError::of_straight(&exact, rounding),
            Finder::Wall => InputError::of_crossing(exact.v[0], exact.a[0], rounding),
        };
        let (t, error) = (found.value, own(f64::ROUNDING));
        let wide_t = Octuple::lift(t);
        let bound = row.bound(wide_t, &error).unwrap_or(f64::INFINITY);
        let fine = row
            .bound(wide_t, &own(DoubleDouble::ROUNDING))
            .unwrap_or(f64::INFINITY);
        let (_, closing) = row.gap(wide_t);
        let (length, speed) = (error.length(wide_t).to_f64(), error.speed(wide_t).to_f64());
        let (moving, bend) = row.motion_at(t);
        // everything over |f'| = 2 D v_n: relative error of f'
        // and of the normal
        let (turned, reach) = match finder {
            Finder::Wall => (0.0, 0.0),
            _ => ((length + moving * bound) / row.distance, row.distance),
        };
        let off = (moving * turned + speed + bend * bound) / closing;
        if off > 0.5 {
            skipped += 1;
            continue;
        }
        for k in 0..INPUTS {
            let (lever, rate) = leverage(&row, k, t);
            let unused = match row.motion {
                Motion::Curved(_) => false,
                Motion::Straight(rest) => k == 5 || (k == 4 && rest.is_infinite()),
                Motion::Wall(_) => k % 2 == 1 || k == 6,
            };
            if unused || lever == 0.0 {
                continue;
            }
            // small against the margin, and against the number itself
            let group = match k {
                0 | 1 => row.p[0].hypot(row.p[1]),
                2 | 3 => row.v[0].hypot(row.v[1]),
                4 | 5 => numbers[4].hypot(numbers[5]),
                _ => row.distance,
            };
            // also against the length in which the closing speed changes
            let straight = if bend > 0.0 {
                closing * closing / bend
            } else {
                reach.max(closing * t)
            };
            let room = row.margin.min(reach.max(closing * t)).min(straight) / lever;
            let step = 1e-9 * if group > 0.0 { room.min(group) } else { room };
            let shifted = |h: f64| {
                let mut q = numbers.map(DoubleDouble::lift);
                q[k] += DoubleDouble::lift(h);
                time(&row, finder, &q)
            };
            let (Some(late), Some(early)) = (shifted(step), shifted(-step)) else {
                panic!("no contact at a step of {step:e} in input {k} of {row:?}");
            };
            let quotient = ((late - early) / DoubleDouble::lift(2.0 * step))
                .wide()
                .to_f64();
            let got = found.partials[k];
            let largest = lever / closing;
            let by_state = lever * turned + rate * bound;
            let tolerance = (by_state / closing + largest * off) / (1.0 - off)
                + 16.0 * f64::EPSILON * largest
                + 1e-17 * largest
                + fine / step;
            let over = (got - quotient).abs() / tolerance;
            assert!(
                over <= 1.0,
                "{finder:?}, input {k}: {got:e} instead of {quotient:e}, {over} of what is allowed, for {row:?}"
            );
            worst = worst.max(over);
            checked += 1;
        }
    }
    assert!(
        checked > 5_000,
        "{checked} derivatives, {skipped} rows skipped"
    );
    assert!(
        worst > 0.0 && skipped < 200,
        "{skipped} rows skipped, worst {worst}"
    );
}
