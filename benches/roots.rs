//! The root finders: what a miss, a hit and a graze cost, and the errors of every pathological class in units of its bound.

#![allow(
    missing_docs,
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout
)]

use carom::math::first_root::{Approach, Blur, first_contact, first_crossing, straight_contact};
use carom::math::random::Draws;
use criterion::{Criterion, Throughput};
use std::hint::black_box;

#[path = "../tests/suite/roots/truth.rs"]
#[allow(dead_code)]
mod truth;

/// Approaches of one kind; a round goes through all of them, so that no branch is learnt by heart.
const MANY: u64 = 1000;

const LIMIT: f64 = 2.0;
const BLUR: Blur<f64> = Blur {
    length: 1e-14,
    speed: 1e-14,
};

/// A partner six distances away that is passed at `miss` distances, from the side, at speed 4; with a relative
/// acceleration of up to 1 if `curved`.
fn approach(index: u64, miss: (f64, f64), curved: bool) -> Approach<f64> {
    let mut draws = Draws::new(5, index);
    let angle = draws.between(0.0, std::f64::consts::TAU);
    let (n, m) = ([angle.cos(), angle.sin()], [-angle.sin(), angle.cos()]);
    let distance = 0.5;
    let (sine, speed) = (distance * draws.between(miss.0, miss.1) / 3.0, 4.0);
    let cosine = (1.0 - sine * sine).sqrt();
    let a = if curved {
        [draws.between(-0.7, 0.7), draws.between(-0.7, 0.7)]
    } else {
        [0.0; 2]
    };
    Approach {
        p: n.map(|x| 3.0 * x),
        v: [0, 1].map(|i| speed * (-cosine * n[i] + sine * m[i])),
        a,
        distance,
    }
}

fn finders(criterion: &mut Criterion) {
    let kinds = [
        ("miss, by four distances", (4.8, 5.2)),
        ("miss, by a distance", (1.8, 2.2)),
        ("hit", (0.0, 0.9)),
        ("graze, within 1e-6", (1.0 - 1e-6, 1.0 + 1e-6)),
    ];
    for (name, miss) in kinds {
        let mut group = criterion.benchmark_group(name);
        group.throughput(Throughput::Elements(MANY));
        let curved: Vec<_> = (0..MANY).map(|i| approach(i, miss, true)).collect();
        let straight: Vec<_> = (0..MANY).map(|i| approach(i, miss, false)).collect();
        group.bench_function("first_contact", |bencher| {
            bencher.iter(|| {
                for m in &curved {
                    black_box(first_contact(black_box(m), LIMIT, &BLUR));
                }
            });
        });
        group.bench_function("straight_contact", |bencher| {
            bencher.iter(|| {
                for m in &straight {
                    let m = black_box(m);
                    black_box(straight_contact(m.p, m.v, 3.0, m.distance, LIMIT, &BLUR));
                }
            });
        });
        group.finish();
    }
    let mut group = criterion.benchmark_group("wall");
    group.throughput(Throughput::Elements(MANY));
    let curved: Vec<_> = (0..MANY).map(|i| approach(i, (0.0, 3.0), true)).collect();
    group.bench_function("first_crossing", |bencher| {
        bencher.iter(|| {
            for m in &curved {
                let m = black_box(m);
                black_box(first_crossing(m.p[0], m.v[0], m.a[0], LIMIT, &BLUR));
            }
        });
    });
    group.finish();
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    finders(&mut criterion);
    criterion.final_summary();
    let rows = truth::rows();
    let tallies = truth::tallies::<f64>(&rows, f64::MIN_POSITIVE);
    println!(
        "\nf64 against 75 digits; err/input: over what half an ulp of every input may do, err/bound:"
    );
    println!(
        "over that and the finder's own rounding\n\n{}",
        truth::table(&tallies)
    );
}
