//! The law of perturbation: what a sample may be, held against the scene it comes from.

use crate::support::{MU, R, report_break, scenario};
use carom::engine::{Setting, prepare};
use carom::scene::perturb::{Law, PerturbError, Perturbation};
use carom::scene::{Scene, Shot, Simultaneous, catalogue};

const SAMPLES: u64 = 400;

fn perturbation(scene: &Scene, law: Law) -> Perturbation {
    Perturbation::new(scene, law).unwrap_or_else(|error| panic!("{}: {error}", scene.name))
}

fn gaps_alone(gap: f64) -> Law {
    Law {
        gap,
        ..Law::default()
    }
}

/// Gaps of all pairs, length.
fn gaps(scene: &Scene) -> Vec<((usize, usize), f64)> {
    let n = scene.balls.len();
    let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let gap = |(i, j): (usize, usize)| {
        let apart = scene.balls[i].state.position - scene.balls[j].state.position;
        ((i, j), apart.norm() - scene.contact_distance(i, j))
    };
    pairs.map(gap).collect()
}

fn heading(scene: &Scene) -> f64 {
    let v = scene.balls[scene.cue_ball()].state.velocity;
    v.y.atan2(v.x).to_degrees()
}

/// Mean of values that are uniform within +-1 of 0: their deviation is 1/sqrt(3 n), and five of them are allowed.
fn assert_centred(values: &[f64], what: &str) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    assert!(
        mean.abs() <= 5.0 / (3.0 * n).sqrt(),
        "{what}: mean {mean} of {n} values"
    );
}

#[test]
fn aim_and_speed_fill_their_intervals_and_the_shot_says_the_same_as_the_velocity() {
    let law = Law {
        aim: 0.5,
        speed: 0.02,
        gap: 0.0,
    };
    for name in ["report-break", "triple-hit", "three-ball"] {
        let scene = catalogue::scene(name).unwrap();
        let samples = perturbation(&scene, law);
        let (mut turns, mut factors) = (Vec::new(), Vec::new());
        for index in 0..SAMPLES {
            let sample = samples.sample(3, index);
            turns.push((heading(&sample) - heading(&scene)) / law.aim);
            factors.push((sample.largest_speed() / scene.largest_speed() - 1.0) / law.speed);
            let (ball, said) = match sample.shot {
                Some(Shot::Force {
                    ball, contact_time, ..
                }) => {
                    let again = sample.launched_for(contact_time).unwrap();
                    (ball, again.balls[ball].state.velocity)
                }
                Some(Shot::Velocity {
                    ball,
                    angle_deg,
                    speed,
                }) => (ball, carom::scene::plan_vector(speed, angle_deg)),
                Some(Shot::Strike { ball, strike }) => {
                    let struck = &sample.balls[ball];
                    (ball, strike.motion(struck.mass, struck.radius).velocity)
                }
                None => (0, sample.balls[0].state.velocity),
            };
            assert_eq!(sample.balls[ball].state.velocity, said, "{name} {index}");
            for (got, was) in sample.balls.iter().zip(&scene.balls) {
                assert_eq!(got.state.position, was.state.position, "{name} {index}");
            }
        }
        for (what, values) in [("aim", &turns), ("speed", &factors)] {
            assert_centred(values, &format!("{name}: {what}"));
            let most = values.iter().copied().fold(0.0_f64, |m, x| m.max(x.abs()));
            // degrees and ratios of rounded numbers, over the width of the interval; of 400 draws one reaches beyond .9 but
            // for a chance of .9^400
            assert!(most <= 1.0 + 1e-10, "{name}: {what} reaches {most}");
            assert!(most > 0.9, "{name}: {what} reaches only {most}");
        }
    }
}

#[test]
fn a_sample_depends_on_seed_and_index_and_one_more_thing_that_varies_leaves_the_others() {
    let scene = catalogue::scene("report-break").unwrap();
    let all = Law {
        aim: 0.1,
        speed: 0.01,
        gap: 1e-2,
    };
    let both = perturbation(&scene, all);
    assert_eq!(both.sample(1, 7).hash(), both.sample(1, 7).hash());
    assert_ne!(both.sample(1, 7).hash(), both.sample(1, 8).hash());
    assert_ne!(both.sample(1, 7).hash(), both.sample(2, 7).hash());
    let only_gaps = perturbation(&scene, gaps_alone(all.gap));
    for (with, without) in both
        .sample(1, 7)
        .balls
        .iter()
        .zip(&only_gaps.sample(1, 7).balls)
    {
        assert_eq!(with.state.position, without.state.position);
    }
    assert_eq!(both.sample(1, 7).simultaneous, scene.simultaneous);
    let frozen = catalogue::scene("triple-hit-ensemble").unwrap();
    let sample = perturbation(&frozen, gaps_alone(1e-5)).sample(1, 0);
    // a sample has gaps, and is a single run
    assert_eq!(sample.simultaneous, Simultaneous::Refuse);
}

#[test]
fn touching_balls_are_opened_to_gaps_of_the_size_asked_for_and_none_overlap() {
    let scene = report_break(0.0, 90.2);
    for gap in [1e-3, 1e-5, 1e-7] {
        let size = gap * R;
        let samples = perturbation(&scene, gaps_alone(gap));
        let touching: Vec<(usize, usize)> = gaps(&scene)
            .into_iter()
            .filter(|(_, gap)| gap.abs() <= scene.touching())
            .map(|(pair, _)| pair)
            .collect();
        assert_eq!(touching.len(), 30, "a triangle of fifteen");
        // a coordinate of 20 R is good to its ulp, a distance of two to a few
        let rounding = 8.0 * f64::EPSILON * scene.largest_coordinate();
        let mut deviations = Vec::new();
        for index in 0..SAMPLES {
            let sample = samples.sample(5, index);
            for (pair, now) in gaps(&sample) {
                assert!(now >= -rounding, "{gap} R: {pair:?} overlap by {now:e}");
                if touching.contains(&pair) {
                    // opened to the size, and each of the two displaced by half of it at most
                    assert!(now <= 2.0 * size + rounding, "{gap} R: {pair:?} {now:e}");
                    deviations.push(now / size - 1.0);
                }
            }
            for (ball, was) in sample.balls.iter().zip(&scene.balls) {
                let moved = (ball.state.position - was.state.position).norm();
                // the corners are 8 R / sqrt(3) from the centre, which opening stretches by half a gap for each R
                let most = (4.0 / 3.0_f64.sqrt() + 0.5) * size + rounding;
                assert!(moved <= most, "{gap} R: ball {} moved {moved:e}", ball.id);
                if was.state.speed() > 0.0 {
                    assert_eq!(ball.state.position, was.state.position);
                }
            }
        }
        // the difference of two displacements along the line of centres has deviation size / (2 sqrt 2), less than that
        // of a uniform number; second order in gap / R is far less
        assert_centred(&deviations, &format!("gaps of {gap} R"));
        let spread = deviations.iter().map(|x| x * x).sum::<f64>() / deviations.len() as f64;
        // of n independent values with lighter tails than a bell's the mean square is good to sqrt(2/n) of itself; seven of the
        // pairs of a sample share no ball
        let tolerance = 5.0 * (2.0 / (7.0 * SAMPLES as f64)).sqrt();
        assert!(
            (spread * 8.0 - 1.0).abs() < tolerance,
            "gaps of {gap} R: mean square {spread} instead of 1/8"
        );
    }
}

#[test]
fn balls_with_room_are_displaced_within_half_their_gap_and_no_farther_than_asked() {
    let scene = catalogue::scene("report-break").unwrap();
    // gaps of the rack are 1e-2 R
    for (gap, room) in [(1e-3, 0.5e-3), (1.0, 0.5e-2)] {
        let samples = perturbation(&scene, gaps_alone(gap));
        let mut largest = 0.0_f64;
        for index in 0..SAMPLES {
            let sample = samples.sample(1, index);
            for (ball, was) in sample.balls.iter().zip(&scene.balls) {
                let moved = (ball.state.position - was.state.position).norm() / R;
                assert!(moved <= room * (1.0 + 1e-9), "{gap}: {moved}");
                largest = largest.max(moved);
            }
            let narrowest = gaps(&sample).into_iter().map(|(_, gap)| gap);
            assert!(narrowest.fold(f64::INFINITY, f64::min) >= 0.0);
        }
        // of 6000 points of a disc one lies beyond .98 of its radius but for a chance of .96^6000
        assert!(
            largest > 0.98 * room,
            "{gap}: at most {largest} instead of {room}"
        );
    }
}

#[test]
fn balls_on_a_cushion_are_moved_off_it_and_stay_on_the_table() {
    let gap = 1e-4;
    let size = gap * R;
    // a pair frozen to a cushion, a ball in a corner, a frozen pair that opening would press against a third ball
    let scene = scenario("frozen")
        .cushions(4.0, 4.0)
        .cloth(MU)
        .moving("cue", [2.0, 1.0], [0.0, 1.0])
        .resting("a", [R, 2.0])
        .resting("b", [R, 2.0 + 2.0 * R])
        .resting("corner", [4.0 - R, R])
        .resting("c", [2.0, 3.0])
        .resting("d", [2.0 + 2.0 * R, 3.0])
        .resting("e", [2.0 + 4.0 * R + 0.1 * size, 3.0])
        .build();
    let samples = perturbation(&scene, gaps_alone(gap));
    let rounding = 8.0 * f64::EPSILON * scene.largest_coordinate();
    for index in 0..SAMPLES {
        let sample = samples.sample(2, index);
        let position = |id: &str| sample.balls[sample.ball_index(id).unwrap()].state.position;
        let off = [
            ("a", position("a").x - R),
            ("b", position("b").x - R),
            ("corner in x", 4.0 - R - position("corner").x),
            ("corner in y", position("corner").y - R),
        ];
        for (what, off) in off {
            assert!(
                off >= 0.5 * size - rounding && off <= 1.5 * size + rounding,
                "{what}: {} sizes off the cushion",
                off / size
            );
        }
        for (pair, now) in gaps(&sample) {
            assert!(now >= -rounding, "{pair:?} overlap by {now:e}");
        }
        // the narrow gap is opened with the pair, so that it keeps its part
        let (d, e) = (position("d"), position("e"));
        assert!((e - d).norm() - 2.0 * R >= 0.09 * size, "narrowed");
        for engine in crate::support::roster() {
            assert!(
                prepare(engine.as_ref(), &sample, &Setting::default()).is_ok(),
                "{} refuses sample {index}",
                engine.id()
            );
        }
    }
}

#[test]
fn unequal_balls_that_touch_are_opened_too() {
    let mut scene = scenario("unequal")
        .moving("cue", [0.0, -2.0], [0.0, 1.0])
        .resting("small", [0.0, 0.0])
        .resting("large", [1.0, 0.0])
        .build();
    scene.balls[1].radius = 0.5 * R;
    scene.balls[1].state.position.z = 0.5 * R;
    scene.balls[2].state.position.x = scene.contact_distance(1, 2);
    let samples = perturbation(&scene, gaps_alone(1e-3));
    let size = 1e-3 * scene.smallest_radius();
    for index in 0..SAMPLES {
        let sample = samples.sample(1, index);
        let apart = sample.balls[2].state.position - sample.balls[1].state.position;
        let now = apart.xy().norm() - scene.contact_distance(1, 2);
        // the distance stretches with the larger of the two, sqrt(2) here, and each is displaced by half of the size
        let most = (2.0_f64.sqrt() + 1.0) * size;
        assert!(now >= 0.0 && now <= most * (1.0 + 1e-9), "{now:e}");
    }
}

#[test]
fn the_default_law_varies_what_the_scene_has() {
    for (name, aim, speed, gap) in [
        ("report-break", 0.1, 0.01, 1e-2),
        ("report-break-frozen", 0.1, 0.01, 1e-5),
        ("report-break-frozen-ensemble", 0.0, 0.0, 1e-5),
        ("triple-hit-ensemble", 0.0, 0.0, 1e-5),
        ("discs-in-a-box", 0.1, 0.01, 0.0),
    ] {
        let scene = catalogue::scene(name).unwrap();
        let law = Law::default_for(&scene);
        assert_eq!(law, Law { aim, speed, gap }, "{name}");
        let words = perturbation(&scene, law).in_words();
        let varied = [aim, speed, gap].iter().filter(|x| **x > 0.0).count();
        assert_eq!(words.len(), varied, "{name}: {words:?}");
    }
    for entry in catalogue::all() {
        let scene = entry.scene().unwrap();
        perturbation(&scene, Law::default_for(&scene));
    }
}

#[test]
fn a_law_that_cannot_be_says_what_would_be_right() {
    let scene = catalogue::scene("report-break").unwrap();
    let still = scenario("still").resting("a", [0.0, 0.0]).build();
    let moving = catalogue::scene("discs-in-a-box").unwrap();
    // as wide as the pair that touches both of its cushions
    let full = scenario("full")
        .cushions(4.0 * R, 4.0)
        .resting("a", [R, 1.0])
        .resting("b", [3.0 * R, 1.0])
        .build();
    let aim = |aim| Law {
        aim,
        ..Law::default()
    };
    let speed = |speed| Law {
        speed,
        ..Law::default()
    };
    for (scene, law, wanted) in [
        (&scene, Law::default(), "above 0"),
        (&scene, aim(-1.0), "0 to 180 degrees"),
        (&scene, aim(f64::NAN), "0 to 180 degrees"),
        (&scene, speed(1.0), "below 1"),
        (&scene, gaps_alone(2.0), "0 to 1 R"),
        (&scene, gaps_alone(1e-13), "at least"),
        (&still, aim(1.0), "give a gap"),
        (&moving, gaps_alone(1e-3), "give an aim or a speed"),
        (&full, gaps_alone(1e-3), "no room before cushion"),
    ] {
        let error: PerturbError = Perturbation::new(scene, law).unwrap_err();
        let text = error.to_string();
        assert!(text.contains(wanted), "{law:?} in {}: {text}", scene.name);
    }
}
