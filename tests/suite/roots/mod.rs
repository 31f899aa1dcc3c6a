//! The root finders against high-precision truth, in every scalar, and against the second finder with 237 bits.
//!
//! The truth of `validation/references/contact_roots.csv` is that of an independent program. Every error is measured in units
//! of the bound that `math::first_root` derives for it, so that 1 is the law and nothing is tuned.

mod slopes;
mod theory;
mod truth;

use carom::math::first_root::{Approach, bracketed_contact};
use carom::math::random::Draws;
use carom::math::{DoubleDouble, Dual, Octuple, Real};
use truth::{Finder, Judged, Kind, Motion, Row, Tally, Wide, judge, rows, table, tallies};

/// Smallest normal numbers: squares must stay above them. Double-double needs room for its second part.
const LEAST_F32: f64 = f32::MIN_POSITIVE as f64;
const LEAST_F64: f64 = f64::MIN_POSITIVE;
const LEAST_DD: f64 = f64::MIN_POSITIVE / f64::EPSILON / f64::EPSILON;

/// Every class of the file in one scalar: no error above its bound, nothing missed, nothing invented, nothing doubted without
/// need.
fn hold<T: Wide>(scalar: &str, least: f64) -> Vec<(String, Tally)> {
    let all = rows();
    let found = tallies::<T>(&all, least);
    let table = table(&found);
    let (mut judged, mut hits) = (0, 0);
    for (class, tally) in &found {
        let failures = tally.failures.join("\n");
        assert!(
            tally.missed + tally.ghosts + tally.wrong == 0,
            "{scalar}, {class}: {} missed, {} ghosts, {} wrong\n{failures}\n{table}",
            tally.missed,
            tally.ghosts,
            tally.wrong
        );
        assert!(
            tally.over_bound <= 1.0,
            "{scalar}, {class}: error {} of its bound\n{table}",
            tally.over_bound
        );
        judged += tally.rows;
        hits += tally.hits;
    }
    // straight rows are asked twice
    assert!(
        2 * judged > all.len() && 5 * hits > judged,
        "{scalar}: {judged} answers, {hits} hits, of {} rows\n{table}",
        all.len()
    );
    found
}

#[test]
fn every_class_is_solved_within_its_bound_in_f64() {
    let found = hold::<f64>("f64", LEAST_F64);
    assert!(found.len() > 40, "{} classes", found.len());
    for (class, tally) in &found {
        // classes made of grazes and stops down to 1e-15 of the distance; of all others nothing is in doubt
        let close = class.starts_with("graze")
            || class.contains("stop at")
            || class.starts_with("residual speed at contact");
        assert!(
            close == (tally.unclear > 0),
            "{class}: {} of {} unclear\n{}",
            tally.unclear,
            tally.rows,
            table(&found)
        );
    }
}

#[test]
fn every_class_is_solved_within_its_bound_in_f32() {
    hold::<f32>("f32", LEAST_F32);
}

#[test]
fn every_class_is_solved_within_its_bound_in_double_double() {
    let found = hold::<DoubleDouble>("dd", LEAST_DD);
    // every graze of the file lies far above 106 bits
    let unclear: usize = found.iter().map(|(_, tally)| tally.unclear).sum();
    assert_eq!(unclear, 0, "{}", table(&found));
}

#[test]
fn every_class_is_solved_within_its_bound_with_237_bits() {
    let found = hold::<Octuple>("f256", 0.0);
    let unclear: usize = found.iter().map(|(_, tally)| tally.unclear).sum();
    assert_eq!(unclear, 0, "{}", table(&found));
}

#[test]
fn dual_numbers_take_the_same_branches_and_find_the_same_contacts() {
    hold::<Dual<f64, 7>>("dual numbers", LEAST_F64);
}

#[test]
fn grazes_down_to_1e_13_of_the_distance_are_decided_and_closer_ones_are_flagged() {
    let (mut decided, mut flagged) = (0, 0);
    for row in rows() {
        let depth = row.margin / row.distance;
        // a scene of a hundred distances: its blur is 4 ulp of that, below 1e-13 of a distance
        let compact = row.blur::<f64>().length < 1e-13 * row.distance / 1.5;
        if !compact || !row.class.starts_with("graze") {
            continue;
        }
        for finder in row.finders() {
            let judged = judge::<f64>(&row, *finder);
            if depth >= 1e-13 {
                assert!(
                    matches!(judged, Judged::Hit { .. } | Judged::Miss),
                    "1 - b/D = {depth:e}: {judged:?} for {row:?}"
                );
                decided += 1;
            } else if row.margin < 0.5 * row.blur::<f64>().length {
                assert_eq!(judged, Judged::Unclear, "1 - b/D = {depth:e} for {row:?}");
                flagged += 1;
            }
        }
    }
    assert!(decided > 400 && flagged > 20, "{decided}, {flagged}");
}

#[test]
fn a_finder_that_errs_is_caught() {
    // the judge must fail answers that are wrong by little: time off by twice the bound, contacts dropped and invented
    let all = rows();
    let row = all
        .iter()
        .find(|row| row.class == "generic" && row.kind == Kind::Hit)
        .unwrap();
    let Judged::Hit { over_bound, .. } = judge::<f64>(row, Finder::Search) else {
        panic!("{row:?}");
    };
    assert!(over_bound <= 1.0);
    let mut late = row.clone();
    late.time = row
        .time
        .map(|t| t * Octuple::lift(1.0 + 64.0 * f64::EPSILON));
    let judged = judge::<f64>(&late, Finder::Search);
    assert!(
        matches!(judged, Judged::Hit { over_bound, .. } if over_bound > 1.0),
        "{judged:?}"
    );
    let mut none = row.clone();
    (none.kind, none.time) = (Kind::Miss, None);
    let judged = judge::<f64>(&none, Finder::Search);
    assert!(matches!(judged, Judged::Ghost(_)), "{judged:?}");
    let miss = all
        .iter()
        .find(|row| row.class == "generic" && row.kind == Kind::Miss)
        .unwrap();
    let mut hit = miss.clone();
    (hit.kind, hit.time) = (Kind::Hit, Some(Octuple::lift(0.5 * miss.limit)));
    let judged = judge::<f64>(&hit, Finder::Search);
    assert!(matches!(judged, Judged::Missed(_)), "{judged:?}");
}

/// A random approach of one of many kinds, as a row whose truth is the second finder's in the scalar `W`.
fn random_row<W: Wide>(index: u64) -> Row {
    let mut draws = Draws::new(20_240_612, index);
    let mut decades = |from: f64, to: f64| 10_f64.powf(draws.between(from, to));
    let (length, time) = (decades(-6.0, 6.0), decades(-4.0, 4.0));
    let far = length * decades(0.05, 2.0);
    let speed = far / time * decades(-0.5, 0.5);
    let bend = length * decades(-4.0, 1.0) / (time * time);
    let depth = decades(-12.0, 0.0);
    let direction = |angle: f64| [angle.cos(), angle.sin()];
    let n = direction(draws.between(0.0, std::f64::consts::TAU));
    let side = if draws.uniform() < 0.5 { 1.0 } else { -1.0 };
    // a straight line would pass at (1 - depth) or (1 + depth) of the distance
    let sine = (length * (1.0 - side * depth) / far).min(1.0);
    let cosine = (1.0 - sine * sine).sqrt();
    let v = [
        -speed * (n[0] * cosine - n[1] * sine),
        -speed * (n[1] * cosine + n[0] * sine),
    ];
    let a = direction(draws.between(0.0, std::f64::consts::TAU)).map(|x| x * bend);
    let limit = time * draws.between(0.3, 4.0);
    let motion = match index % 4 {
        0 => Motion::Straight(f64::INFINITY),
        1 => Motion::Straight(limit),
        _ => Motion::Curved(a),
    };
    let mut row = Row {
        class: "random".to_owned(),
        p: n.map(|x| x * far),
        v,
        motion,
        distance: length,
        limit,
        extent: None,
        kind: Kind::Miss,
        time: None,
        margin: f64::INFINITY,
    };
    if let Some(t) = bracketed_contact(&row.approach::<W>(), W::lift(limit)) {
        (row.kind, row.time) = (Kind::Hit, Some(t.wide()));
    }
    row
}

/// Whether discs that are larger or smaller by so much still give the same answer.
fn holds_within<W: Wide>(row: &Row, off: f64) -> bool {
    let answer = |off: f64| {
        let m = row.approach::<W>();
        let other = Approach {
            distance: m.distance + W::lift(off),
            ..m
        };
        bracketed_contact(&other, W::lift(row.limit)).is_some()
    };
    answer(off) == answer(-off)
}

fn second_witness<W: Wide>(rows: std::ops::Range<u64>) {
    let (mut hits, mut misses, mut unclear) = (0, 0, 0);
    let mut worst = 0.0_f64;
    for index in rows.clone() {
        let mut row = random_row::<W>(index);
        for finder in row.finders() {
            let mut judged = judge::<f64>(&row, *finder);
            if !matches!(judged, Judged::Hit { .. } | Judged::Miss) {
                let blur = row.blur::<f64>().length;
                row.margin = if holds_within::<W>(&row, 1.5 * blur) {
                    f64::INFINITY
                } else {
                    blur
                };
                judged = judge::<f64>(&row, *finder);
            }
            match judged {
                Judged::Hit { over_bound, .. } => {
                    assert!(
                        over_bound <= 1.0,
                        "row {index}: error {over_bound} of its bound by {finder:?}: {row:?}"
                    );
                    hits += 1;
                    worst = worst.max(over_bound);
                }
                Judged::Miss => misses += 1,
                Judged::Unclear => unclear += 1,
                wrong => panic!("row {index}: {wrong:?}"),
            }
        }
    }
    let n = (rows.end - rows.start) as usize;
    // a third of the rows, at least, on either side
    assert!(
        3 * hits > n && 3 * misses > n,
        "{hits} hits, {misses} misses"
    );
    assert!(worst > 0.0);
    // grazes are drawn evenly down to 1e-12 of the distance, and the blur of the longest flights reaches there
    assert!(unclear * 1000 < n, "{unclear} unclear of {n}");
}

#[test]
fn random_approaches_agree_with_the_second_finder_in_double_double() {
    second_witness::<DoubleDouble>(0..50_000);
}

#[test]
fn more_random_approaches_agree_with_the_second_finder_in_double_double() {
    second_witness::<DoubleDouble>(50_000..100_000);
}

#[test]
fn random_approaches_agree_with_the_second_finder_at_237_bits() {
    second_witness::<Octuple>(0..2_000);
}
