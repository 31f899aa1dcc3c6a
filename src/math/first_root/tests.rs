//! Closed forms, and both finders against each other on random and pathological approaches.
//!
//! Tolerances are errors over conditioning: a position known to `e` gives a time good to `e / |v_n|`. `e` is counted in ulps
//! of the largest term of the position, 32 of them: the two finders evaluate the same sum in different orders.

use super::*;

const ULPS: f64 = 32.0 * f64::EPSILON;

struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        // SplitMix64
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.unit()
    }

    /// Between `10^from` and `10^to`, evenly in the exponent.
    fn decades(&mut self, from: f64, to: f64) -> f64 {
        10_f64.powf(self.between(from, to))
    }

    fn direction(&mut self) -> [f64; 2] {
        let angle = self.between(0.0, std::f64::consts::TAU);
        [angle.cos(), angle.sin()]
    }

    fn vector(&mut self, size: f64) -> [f64; 2] {
        let length = size * self.unit();
        self.direction().map(|x| x * length)
    }
}

fn norm(v: [f64; 2]) -> f64 {
    v[0].hypot(v[1])
}

/// Largest term of the position up to `t`.
fn extent(m: &Approach<f64>, t: f64) -> f64 {
    norm(m.p) + norm(m.v) * t + 0.5 * norm(m.a) * t * t
}

fn blur(m: &Approach<f64>, limit: f64) -> Blur<f64> {
    Blur {
        length: 4.0 * f64::EPSILON * extent(m, limit),
        speed: 4.0 * f64::EPSILON * (norm(m.v) + norm(m.a) * limit),
    }
}

/// Speed of approach at time `t`.
fn closing(m: &Approach<f64>, t: f64) -> f64 {
    let d = [0, 1].map(|i| m.p[i] + m.v[i] * t + 0.5 * m.a[i] * t * t);
    let u = [0, 1].map(|i| m.v[i] + m.a[i] * t);
    -(d[0] * u[0] + d[1] * u[1]) / norm(d)
}

/// What the comparison of the finders on one approach came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    Hit,
    Miss,
    Unclear,
}

/// Holds the finder against the bracketing one. Panics where they disagree and it does not say that it cannot tell.
fn compare(class: &str, found: Contact<f64>, m: &Approach<f64>, limit: f64) -> Outcome {
    let truth = bracketed_contact(m, limit);
    match (found, truth) {
        (Contact::Never, None) => Outcome::Miss,
        (Contact::At(got), Some(expected)) => {
            let tolerance = ULPS * extent(m, limit) / closing(m, expected).abs()
                + ULPS * expected.max(f64::MIN_POSITIVE);
            assert!(
                (got - expected).abs() <= tolerance,
                "{class}: got {got:e}, expected {expected:e}, allowed {tolerance:e} for {m:?} up to {limit:e}"
            );
            Outcome::Hit
        }
        (Contact::Unclear(_), _) => Outcome::Unclear,
        // at the limit itself one finder may see the contact and the other not
        (Contact::At(t), None) | (Contact::Never, Some(t))
            if (t - limit).abs() <= ULPS * extent(m, limit) / closing(m, t).abs() =>
        {
            Outcome::Miss
        }
        (got, expected) => panic!(
            "{class}: {} contact: got {got:?}, expected {expected:?} for {m:?} up to {limit:e}",
            if expected.is_some() {
                "missed"
            } else {
                "ghost"
            }
        ),
    }
}

fn straight(m: &Approach<f64>, rest_in: f64, limit: f64) -> Contact<f64> {
    straight_contact(m.p, m.v, rest_in, m.distance, limit, &blur(m, limit))
}

fn general(m: &Approach<f64>, limit: f64) -> Contact<f64> {
    first_contact(m, limit, &blur(m, limit))
}

/// Counts of hits, misses and unclear cases.
#[derive(Debug, Default)]
struct Tally([usize; 3]);

impl Tally {
    fn add(&mut self, outcome: Outcome) {
        self.0[outcome as usize] += 1;
    }

    /// Both answers must have occurred, and at most `unclear` may have been unclear.
    fn hold(&self, class: &str, unclear: usize) {
        let [hits, misses, doubts] = self.0;
        assert!(hits > 0 && misses > 0, "{class}: one-sided sample {self:?}");
        assert!(doubts <= unclear, "{class}: {doubts} unclear of {self:?}");
    }
}

#[test]
fn both_finders_agree_on_random_approaches_of_every_scale() {
    let mut random = Random(1);
    let mut tally = Tally::default();
    for _ in 0..60_000 {
        let (length, time) = (random.decades(-30.0, 30.0), random.decades(-20.0, 20.0));
        let speed = length / time;
        let m = Approach {
            p: random.vector(12.0 * length),
            v: random.vector(4.0 * speed),
            a: random.vector(3.0 * speed / time),
            distance: length,
        };
        if norm(m.p) < m.distance {
            continue;
        }
        let limit = time * random.decades(-1.0, 1.5);
        tally.add(compare("random", general(&m, limit), &m, limit));
    }
    tally.hold("random", 0);
}

#[test]
fn straight_motion_has_the_same_contacts_in_all_three_finders() {
    let mut random = Random(2);
    let mut tally = Tally::default();
    for i in 0..60_000 {
        let p = random.direction().map(|x| x * 8.0);
        let v = random.vector(6.0);
        let rest_in = if i % 2 == 0 {
            f64::INFINITY
        } else {
            random.between(0.1, 10.0)
        };
        let m = Approach {
            p,
            v,
            a: v.map(|x| -x / rest_in),
            distance: random.between(0.3, 3.0),
        };
        let limit = random.between(0.1, 20.0).min(rest_in);
        let closed = straight(&m, rest_in, limit);
        tally.add(compare("straight, closed form", closed, &m, limit));
        compare("straight, general", general(&m, limit), &m, limit);
    }
    tally.hold("straight", 0);
}

/// An approach whose smallest distance is `(1 - depth) D` at time `t`, passing with relative velocity of size `speed`.
fn graze(
    random: &mut Random,
    depth: f64,
    t: f64,
    speed: f64,
    acceleration: [f64; 2],
) -> Approach<f64> {
    let n = random.direction();
    let distance = random.between(0.2, 2.0);
    let d = n.map(|x| x * distance * (1.0 - depth));
    let u = [-n[1] * speed, n[0] * speed];
    let a = acceleration;
    Approach {
        p: [0, 1].map(|i| d[i] - u[i] * t + 0.5 * a[i] * t * t),
        v: [0, 1].map(|i| u[i] - a[i] * t),
        a,
        distance,
    }
}

#[test]
fn grazes_are_hits_inside_and_misses_outside_the_contact_distance() {
    let mut random = Random(3);
    for digits in 2..=13 {
        for sign in [1.0, -1.0] {
            let depth = sign * 10_f64.powi(-digits);
            let mut clear = 0;
            for i in 0..400 {
                let straight_line = i % 2 == 0;
                let t = random.between(0.5, 3.0);
                let speed = random.between(1.0, 4.0);
                let a = if straight_line {
                    [0.0; 2]
                } else {
                    random.vector(0.5)
                };
                let m = graze(&mut random, depth, t, speed, a);
                let limit = t + 0.5;
                // the graze is the first contact only if it starts outside
                if norm(m.p) <= m.distance * 1.1 {
                    continue;
                }
                let mut found = vec![general(&m, limit)];
                if straight_line {
                    found.push(straight(&m, f64::INFINITY, limit));
                }
                // rounding of the construction and of the finder's input, as a part of the distance
                let error = 16.0 * f64::EPSILON * extent(&m, limit) / m.distance;
                for found in found {
                    match found {
                        Contact::Unclear(at) => {
                            assert!(
                                depth.abs() <= error,
                                "depth {depth:e} unclear at {at} for {m:?}"
                            );
                        }
                        Contact::At(at) => {
                            assert!(depth > -error, "ghost: depth {depth:e}, at {at} for {m:?}");
                            // it enters half a chord before the closest point: D sqrt(2 depth) / speed, and no earlier than twice that
                            let chord = 2.0 * m.distance * (2.0 * depth.abs().max(error)).sqrt();
                            assert!(
                                at <= t + 1e-7 && at >= t - chord,
                                "depth {depth:e}: {at} for {m:?}"
                            );
                            clear += 1;
                        }
                        Contact::Never => {
                            assert!(depth < error, "missed: depth {depth:e} for {m:?}");
                            clear += 1;
                        }
                    }
                }
            }
            let enough = if digits <= 12 { 400 } else { 50 };
            assert!(
                clear >= enough,
                "depth {depth:e}: only {clear} clear answers"
            );
        }
    }
}

#[test]
fn curved_grazes_agree_with_the_bracketing_finder() {
    let mut random = Random(4);
    let mut tally = Tally::default();
    for _ in 0..20_000 {
        let depth = random.decades(-10.0, -1.0) * if random.unit() < 0.5 { 1.0 } else { -1.0 };
        let (t, speed) = (random.between(0.2, 5.0), random.decades(-1.0, 1.0));
        let a = random.vector(2.0);
        let m = graze(&mut random, depth, t, speed, a);
        if norm(m.p) <= m.distance {
            continue;
        }
        let limit = t * random.between(0.9, 3.0);
        tally.add(compare("curved graze", general(&m, limit), &m, limit));
    }
    // blur.length grows with the limit, up to 1e-12 of the distance where speeds are smallest
    tally.hold("curved graze", 20);
}

#[test]
fn nearly_equal_motions_are_found_however_slowly_they_close() {
    let mut random = Random(5);
    let mut tally = Tally::default();
    for _ in 0..20_000 {
        // relative speeds down to 1e-9 of the others; relative acceleration as small, or none
        let slow = random.decades(-9.0, -1.0);
        let n = random.direction();
        let distance = 0.5;
        let gap = random.decades(-6.0, 1.0);
        let m = Approach {
            p: n.map(|x| x * (distance + gap)),
            v: {
                let side = random.between(-0.5, 0.5);
                [-n[0] - side * n[1], -n[1] + side * n[0]].map(|x| x * slow)
            },
            a: random.vector(slow * slow),
            distance,
        };
        let limit = random.between(0.5, 4.0) * gap / slow;
        tally.add(compare("catch-up", general(&m, limit), &m, limit));
    }
    tally.hold("catch-up", 0);
}

#[test]
fn touching_and_receding_waits_for_the_turn_inward() {
    let mut random = Random(6);
    for _ in 0..2000 {
        let n = random.direction();
        let (distance, out, inward) = (0.5, random.decades(-2.0, 1.0), random.decades(-1.0, 1.0));
        // rounding puts the start on either side of contact
        let m = Approach {
            p: n.map(|x| x * distance),
            v: n.map(|x| x * out),
            a: n.map(|x| -x * inward),
            distance,
        };
        let back = 2.0 * out / inward;
        let limit = 2.0 * back;
        let Contact::At(got) = general(&m, limit) else {
            panic!("no contact for {m:?}");
        };
        // it comes back at the speed with which it left
        let tolerance = ULPS * extent(&m, limit) / out;
        assert!(
            (got - back).abs() <= tolerance,
            "got {got}, expected {back} for {m:?}"
        );
        assert_eq!(
            general(&m, 0.9 * back),
            Contact::Never,
            "before it is back: {m:?}"
        );
    }
}

#[test]
fn touching_and_approaching_is_contact_now_even_if_it_would_turn_back() {
    let mut random = Random(7);
    for _ in 0..2000 {
        let n = random.direction();
        let m = Approach {
            p: n.map(|x| x * 0.5),
            v: n.map(|x| -x * random.decades(-5.0, 1.0)),
            a: n.map(|x| x * 2.0),
            distance: 0.5,
        };
        assert_eq!(general(&m, 5.0), Contact::At(0.0), "{m:?}");
        assert_eq!(straight(&m, f64::INFINITY, 5.0), Contact::At(0.0), "{m:?}");
    }
}

#[test]
fn overlapping_balls_meet_when_they_turn_inward() {
    // 0.4 apart instead of 0.5, receding at 0.1, turning inward at t = 0.1 before they are apart
    let m = Approach {
        p: [0.4, 0.0],
        v: [0.1, 0.0],
        a: [-1.0, 0.0],
        distance: 0.5,
    };
    let Contact::At(got) = general(&m, 5.0) else {
        panic!("no contact");
    };
    assert!((got - 0.1).abs() <= ULPS, "got {got}, expected 0.1");
    let expected = bracketed_contact(&m, 5.0).unwrap_or(f64::NAN);
    assert!((expected - 0.1).abs() <= ULPS, "bracketing: {expected}");
}

#[test]
fn a_ball_that_stops_short_does_not_touch() {
    for (gap, touches) in [(0.9999, true), (1.0001, false)] {
        // it travels v rest / 2 = 1
        let m = Approach {
            p: [0.5 + gap, 0.0],
            v: [-2.0, 0.0],
            a: [2.0, 0.0],
            distance: 0.5,
        };
        for found in [general(&m, 1.0), straight(&m, 1.0, 1.0)] {
            assert_eq!(found.time().is_some(), touches, "gap {gap}: {found:?}");
        }
        if touches {
            // gap = 2 t - t^2
            let expected = 1.0 - (1.0_f64 - gap).sqrt();
            let got = straight(&m, 1.0, 1.0).time().unwrap_or(f64::NAN);
            assert!(
                (got - expected).abs() < 1e-13,
                "got {got}, expected {expected}"
            );
        }
    }
    // stopping within rounding of contact cannot be told from touching
    let m = Approach {
        p: [1.5, 0.0],
        v: [-2.0, 0.0],
        a: [2.0, 0.0],
        distance: 0.5,
    };
    assert_eq!(straight(&m, 1.0, 1.0).time(), None);
    assert_eq!(general(&m, 1.0).time(), None);
}

#[test]
fn a_wall_is_met_moving_outward_only() {
    let blur = Blur {
        length: 1e-15,
        speed: 1e-15,
    };
    // (gap, speed, acceleration, expected, why)
    let half = 0.5_f64;
    for (gap, speed, acceleration, expected, why) in [
        (1.0, 2.0, 0.0, Some(0.5), "constant velocity"),
        (
            1.0,
            2.0,
            -1.0,
            Some(2.0 - 2.0_f64.sqrt()),
            "slowing, reaches it",
        ),
        (3.0, 2.0, -1.0, None, "slowing, turns back before it"),
        (1.0, -1.0, 0.0, None, "moving inward"),
        (
            1.0,
            -1.0,
            2.0,
            Some(half + 1.25_f64.sqrt()),
            "inward, turned outward",
        ),
        (0.0, 1.0, -1.0, Some(0.0), "at the wall and outward"),
        (0.0, -1.0, 0.0, None, "at the wall and inward"),
        (-0.1, 1.0, 0.0, Some(0.0), "beyond it and outward"),
        (-0.1, -1.0, 0.0, None, "beyond it and inward"),
        (
            -1.0,
            -0.5,
            0.5,
            Some(1.0),
            "beyond it, turns outward while beyond",
        ),
        (
            -0.1,
            -1.0,
            1.0,
            Some(1.0 + 0.8_f64.sqrt()),
            "beyond it, comes in and out again",
        ),
    ] {
        let found = first_crossing(gap, speed, acceleration, 10.0, &blur);
        match (found.time(), expected) {
            (Some(got), Some(time)) => {
                assert!(
                    (got - time).abs() < 1e-14,
                    "{why}: got {got}, expected {time}"
                );
            }
            (got, expected) => assert_eq!(got, expected, "{why}"),
        }
        if let Some(time) = expected
            && time > 0.0
        {
            let early = first_crossing(gap, speed, acceleration, 0.99 * time, &blur);
            assert_eq!(early, Contact::Never, "{why}: beyond the limit");
        }
    }
    let stops_at_it = first_crossing(2.0, 2.0, -1.0, 10.0, &blur);
    assert!(
        matches!(stops_at_it, Contact::Unclear(_)),
        "{stops_at_it:?}"
    );
}
