//! Thinning: what is left out is given by the rest, and the work grows no faster than n log n.

use carom::math::Vec3;
use carom::math::random::Draws;
use carom::physics::State;
use carom::trace::thin::{Jumps, Tolerance, stretch, thin};
use carom::trace::{Knot, Path};
use std::cell::Cell;

const TOLERANCE: Tolerance = Tolerance {
    position: 1e-3,
    velocity: 2e-3,
    spin: 3e-3,
};

/// A path of random arcs, some straight, some with a wobble larger or smaller than the tolerance, with jumps between them: hits that
/// belong to an event, further exchanges of one, and jumps that belong to none.
fn wandering(seed: u64) -> Path {
    let mut draws = Draws::new(seed, 0);
    let mut knots = Vec::new();
    let (mut time, mut place) = (0.0, Vec3::zeros());
    let mut event = 0;
    for arc in 0..12 {
        let mut any = |size: f64| Vec3::from_fn(|_, _| draws.between(-size, size));
        let (speed, bend, turn, wind) = (any(1.0), any(0.5), any(3.0), any(1.0));
        let wobble = any(3e-3);
        let samples = 1 + (draws.uniform() * 60.0) as u32;
        let after = match arc % 3 {
            0 => {
                event += 1;
                Some(event)
            }
            1 => Some(event),
            _ => None,
        };
        for k in 0..=samples {
            let s = f64::from(k) * 0.01;
            let wave = wobble * (40.0 * s).sin();
            knots.push(Knot {
                time: time + s,
                state: State {
                    position: place + speed * s + bend * (0.5 * s * s) + wave,
                    velocity: speed + bend * s,
                    spin: turn + wind * s,
                },
                after: if k == 0 { after } else { None },
            });
        }
        if let Some(last) = knots.last() {
            (time, place) = (last.time, last.state.position);
        }
    }
    Path { knots }
}

/// True if two knots are the same in every number.
fn has(path: &Path, knot: &Knot) -> bool {
    path.knots.contains(knot)
}

#[test]
fn what_is_left_out_is_given_by_the_rest() {
    let (mut left_out, mut kept) = (0, 0);
    for seed in 0..60 {
        let path = wandering(seed);
        let thinned = thin(&path, TOLERANCE, Jumps::All);
        kept += thinned.knots.len();
        for knot in path.knots.iter().filter(|knot| !has(&thinned, knot)) {
            left_out += 1;
            let given = thinned.state_at(knot.time).unwrap();
            for (what, off, bound) in [
                (
                    "position",
                    given.position - knot.state.position,
                    TOLERANCE.position,
                ),
                (
                    "velocity",
                    given.velocity - knot.state.velocity,
                    TOLERANCE.velocity,
                ),
                ("spin", given.spin - knot.state.spin, TOLERANCE.spin),
            ] {
                // the same cubic evaluated twice: a few roundings of numbers below 40
                let rounding = 40.0 * 8.0 * f64::EPSILON;
                assert!(
                    off.norm() <= bound + rounding,
                    "seed {seed}, t = {}: {what} is off by {} > {bound}",
                    knot.time,
                    off.norm()
                );
            }
        }
    }
    assert!(
        left_out > 5_000 && kept > 1_000,
        "{left_out} left out, {kept} kept"
    );
}

#[test]
fn ends_jumps_and_far_sides_are_kept() {
    for seed in 0..60 {
        let path = wandering(seed);
        let thinned = thin(&path, TOLERANCE, Jumps::All);
        let mut jumps = 0;
        for (k, knot) in path.knots.iter().enumerate() {
            let end = k == 0 || k + 1 == path.knots.len();
            let near = path
                .knots
                .get(k + 1)
                .is_some_and(|next| next.time == knot.time);
            let far = k > 0 && path.knots[k - 1].time == knot.time;
            jumps += usize::from(near);
            if end || near || far || knot.after.is_some() {
                assert!(
                    has(&thinned, knot),
                    "seed {seed}: knot {k} at {} is lost",
                    knot.time
                );
            }
        }
        assert_eq!(jumps, 11, "twelve arcs have eleven jumps between them");
        assert!(thinned.knots.is_sorted_by(|a, b| a.time <= b.time));
    }
}

#[test]
fn without_further_exchanges_the_first_jump_of_each_event_and_the_places_stay() {
    let places = Tolerance {
        velocity: f64::INFINITY,
        spin: f64::INFINITY,
        ..TOLERANCE
    };
    let mut fewer = 0;
    for seed in 0..60 {
        let path = wandering(seed);
        let thinned = thin(&path, places, Jumps::FirstOf(&[]));
        fewer += usize::from(thinned.knots.len() < thin(&path, places, Jumps::All).knots.len());
        let mut seen = std::collections::BTreeSet::new();
        for knot in &path.knots {
            if knot.after.is_some_and(|event| seen.insert(event)) {
                assert!(
                    has(&thinned, knot),
                    "seed {seed}: event {:?} is lost",
                    knot.after
                );
            }
            let given = thinned.state_at(knot.time).unwrap().position;
            let off = (given - knot.state.position).norm();
            assert!(
                off <= TOLERANCE.position + 1e-12,
                "seed {seed}, t = {}: off by {off}",
                knot.time
            );
        }
        assert_eq!(seen.len(), 4);
    }
    assert!(fewer > 0, "no seed has an exchange that can be left out");
}

#[test]
fn an_event_that_is_not_wanted_may_be_left_out() {
    let places = Tolerance {
        position: f64::INFINITY,
        velocity: f64::INFINITY,
        spin: f64::INFINITY,
    };
    // event 1 is at the start, which stays as an end; 2 and 4 are wanted: both sides of their first jumps, and of the four jumps
    // that belong to no event
    let path = wandering(3);
    let thinned = thin(
        &path,
        places,
        Jumps::FirstOf(&[false, false, true, false, true]),
    );
    let events: Vec<_> = thinned.knots.iter().filter_map(|knot| knot.after).collect();
    assert_eq!(events, [1, 2, 4]);
    assert_eq!(thinned.knots.len(), 2 + 2 * 2 + 2 * 4);
}

#[test]
fn a_knot_that_is_no_number_is_kept() {
    let mut path = wandering(1);
    let middle = path.knots.len() / 2;
    path.knots[middle].state.position.x = f64::NAN;
    let thinned = thin(&path, TOLERANCE, Jumps::All);
    let lost = thinned
        .knots
        .iter()
        .filter(|knot| knot.state.position.x.is_nan());
    assert_eq!(lost.count(), 1);
}

#[test]
fn a_steady_slide_of_a_hundred_thousand_knots_is_two() {
    let knot = |k: u32| {
        let t = f64::from(k) * 1e-4;
        Knot {
            time: t,
            state: State {
                position: Vec3::new(10.0 * t - 0.5 * t * t, 0.0, 1.0),
                velocity: Vec3::new(10.0 - t, 0.0, 0.0),
                spin: Vec3::zeros(),
            },
            after: None,
        }
    };
    let path = Path {
        knots: (0..100_000).map(knot).collect(),
    };
    assert_eq!(thin(&path, TOLERANCE, Jumps::All).knots.len(), 2);
    assert_eq!(thin(&Path::default(), TOLERANCE, Jumps::All).knots.len(), 0);
}

/// Whether what lies between two places may be left out.
type Fits = fn(usize, usize) -> bool;

/// A step that ends up reaching r has doubled up to it (looking at 2 + 4 + ... < 4 r places, the last of them perhaps in vain, another
/// 2 r) and halved log2 r times with less than 2 r places each: over all steps at most n (6 + 2 log2 n).
#[test]
fn the_work_of_thinning_grows_as_n_log_n_whatever_fits() {
    let count = 100_000_usize;
    let most = count * (6 + 2 * count.ilog2() as usize + 2);
    let pieces: [(&str, Fits); 5] = [
        ("everything fits", |_, _| true),
        ("nothing fits", |_, _| false),
        ("stretches of a thousand", |a, b| a / 1000 == b / 1000),
        ("stretches one short of a power of two", |a, b| b - a < 4095),
        ("stretches that grow", |a, b| {
            (a as f64).sqrt() as usize + 40 > b - a
        }),
    ];
    for (what, fits) in pieces {
        let looked = Cell::new(0);
        let kept = stretch(count, |a, b| {
            looked.set(looked.get() + (b - a));
            fits(a, b)
        });
        assert!(
            looked.get() <= most,
            "{what}: {} places > {most}",
            looked.get()
        );
        assert_eq!(
            (kept.first(), kept.last()),
            (Some(&0), Some(&(count - 1))),
            "{what}"
        );
        for pair in kept.windows(2) {
            assert!(
                pair[1] == pair[0] + 1 || fits(pair[0], pair[1]),
                "{what}: {pair:?} does not fit"
            );
        }
    }
}
