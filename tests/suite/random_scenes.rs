//! Ten thousand random scenes that look for trouble, in the engines that promise to hold in all of them.
//!
//! `carom fuzz` runs as many as one likes; what it checks is described in `law`. The seed here is not one that
//! the engines were mended with.

use carom::physics::EFFECTS;
use carom::scene::adversarial::{MOST_BALLS, adversarial};
use carom::scene::{Scene, parse};
use carom::study::random::{Plan, check, scene, study};
use carom::study::{Configuration, Watch};
use carom::trace::{Ending, Trace};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::AtomicBool;

const SCENES: u64 = 10_000;
const SEED: u64 = 31;

/// Fewer than `carom fuzz` has: most scenes show what they have to show early.
const MAX_EVENTS: u64 = 200;

fn watch(cancelled: &AtomicBool) -> Watch<'_> {
    Watch {
        progress: &|_, _, _| {},
        cancelled,
    }
}

/// Indices of scenes of seed 2 in which something broke, once, and what.
const ONCE_BROKEN: [(u64, &str); 16] = [
    (
        3360,
        "a ball in contact that passed zero speed at a small distance was told to stop at .39 a second, by a series that did not converge so far",
    ),
    (116_060, "the same: two balls overlapped"),
    (188_360, "the same, of four balls"),
    (
        123_987,
        "powers of 1e-57 s left the range of numbers, and the series seemed to end: a gap went with the sixth power of time",
    ),
    (
        172_326,
        "of balls that roll an opening was none up to a part of what would slow a slide: a gap of 757 in 3.3e5 counted as closed",
    ),
    (
        598_512,
        "a ball that rolls along a cushion with friction of 1e-9 had a rebound of no number",
    ),
    (
        227_671,
        "the last step of a slide in the stepper took all of velocity and spin, and no stop was told",
    ),
    (
        40_179,
        "the chain of impacts between masses of a million to one is longer than was allowed for",
    ),
    (
        395_924,
        "a convention rounds light balls by the roots of masses of a million million to one",
    ),
    (
        128_801,
        "several impacts at one instant exchange more than any ball has before or after",
    ),
    (
        43_345,
        "a thousand steps of friction below the rounding of a speed",
    ),
    (
        436_063,
        "late in a run one tick of the clock is longer than a slide",
    ),
    (
        643_503,
        "a gap that is rounding, between a cushion and a ball at rest, was closed by going 3e-7 along both",
    ),
    (
        656_987,
        "a run in more digits passed over an impact that it did not see: a ball was turned back 5e-4 s late, while it parted",
    ),
    (724_323, "the same: a stop was told at ten times its time"),
    (
        874_907,
        "what no number holds, handed over to more digits, was followed as numbers that are none",
    ),
];

#[test]
fn scenes_that_once_broke_something_break_nothing() {
    let never = AtomicBool::new(false);
    for (first, why) in ONCE_BROKEN {
        let plan = Plan {
            first,
            scenes: 1,
            seed: 2,
            columns: Configuration::list(
                crate::support::roster(),
                "exact,stepper:contact=approaching-only",
            )
            .unwrap(),
            max_events: 1000,
        };
        let outcome = study(plan, watch(&never));
        assert_eq!(outcome.failures, [], "{first}: {why}");
        assert_eq!(outcome.done, 1, "{first}");
    }
}

#[test]
fn exact_and_the_stepper_hold_in_ten_thousand_scenes_that_look_for_trouble() {
    let never = AtomicBool::new(false);
    let plan = Plan {
        first: 0,
        scenes: SCENES,
        seed: SEED,
        columns: Configuration::list(
            crate::support::roster(),
            "exact,stepper:contact=approaching-only",
        )
        .unwrap(),
        max_events: MAX_EVENTS,
    };
    let outcome = study(plan, watch(&never));
    assert_eq!(outcome.failures, [], "{} faults", outcome.faults);
    assert_eq!(outcome.done, SCENES);
    for entry in &outcome.entries {
        assert_eq!(entry.endings.values().sum::<u64>(), SCENES);
        // things happen, and bounds are met to a part that shows that they are looked at
        assert!(entry.events > 10 * SCENES, "{entry:?}");
        assert!(
            entry.outside.value > 1e-3 && entry.overlap.value > 1e-3,
            "{entry:?}"
        );
    }
    let [exact, stepper] = [&outcome.entries[0], &outcome.entries[1]];
    let endings = |entry: &carom::study::random::RandomEntry| -> Vec<&str> {
        entry.endings.keys().copied().collect()
    };
    assert!(
        exact.swept > SCENES / 50 && exact.casts > SCENES / 10,
        "{exact:?}"
    );
    assert_eq!(endings(stepper), ["duration", "rest"]);
    let known = [
        "budget",
        "collapsed",
        "duration",
        "indeterminate",
        "rest",
        "undecidable",
    ];
    // each state is a start
    assert_eq!(exact.endings.get("refused"), None);
    for ending in known {
        let count = exact.endings.get(ending).copied().unwrap_or(0);
        assert!(count > SCENES / 500, "{ending}: {count} of {SCENES}");
    }
}

#[test]
fn a_random_scene_depends_on_seed_and_index_alone_and_no_two_are_the_same() {
    let mut hashes = BTreeSet::new();
    for seed in [1, 2] {
        for index in 0..200 {
            let scene = scene(seed, index).unwrap();
            let text = adversarial(seed, index).text().unwrap();
            assert_eq!(parse("again", &text).unwrap(), scene);
            hashes.insert(scene.hash());
        }
    }
    assert_eq!(hashes.len(), 400);
}

#[test]
fn random_scenes_reach_every_law_every_number_of_balls_and_sizes_far_apart() {
    let mut laws: BTreeMap<&str, u64> = BTreeMap::new();
    let (mut most, mut lone, mut touching, mut heavy, mut slow) = (0, 0, 0, 0, 0);
    for index in 0..3000 {
        let scene = scene(SEED, index).unwrap();
        for law in scene.effects.named() {
            *laws.entry(law).or_default() += 1;
        }
        most = most.max(scene.balls.len());
        lone += u64::from(scene.balls.len() == 1);
        touching += u64::from(touches(&scene));
        let mass = |m: fn(f64, f64) -> f64| scene.balls.iter().map(|b| b.mass).reduce(m).unwrap();
        heavy += u64::from(mass(f64::max) / mass(f64::min) > 0.99e9);
        let speeds = scene
            .balls
            .iter()
            .map(|b| b.state.speed())
            .filter(|v| *v > 0.0);
        slow += u64::from(speeds.fold(f64::INFINITY, f64::min) < 1e-25);
    }
    for law in EFFECTS {
        assert!(
            laws.get(law.id).copied().unwrap_or(0) > 10,
            "{}: {laws:?}",
            law.id
        );
    }
    assert_eq!(most, MOST_BALLS);
    for (what, count) in [
        ("lone", lone),
        ("touching", touching),
        ("heavy", heavy),
        ("slow", slow),
    ] {
        assert!(count > 20, "{what}: {count}");
    }
}

fn touches(scene: &Scene) -> bool {
    let n = scene.balls.len();
    let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    pairs.into_iter().any(|(i, j)| {
        let apart = scene.balls[i].state.position - scene.balls[j].state.position;
        (apart.xy().norm() - scene.contact_distance(i, j)).abs() <= scene.touching()
    })
}

/// A trace that was tampered with, and what must be seen in it.
type Tampered = (&'static str, fn(&mut Trace));

#[test]
fn a_trace_that_breaks_what_must_hold_is_seen() {
    let scene = crate::support::report_break(0.01, 90.2);
    let whole = crate::support::run("exact", &[], &scene, carom::trace::Record::Events);
    let fine = check(&scene, &whole, true);
    assert_eq!(fine.faults, []);
    let tampered: [Tampered; 6] = [
        ("not-finite", |trace| {
            trace.paths[3].knots[1].state.velocity.x = f64::NAN
        }),
        ("energy", |trace| {
            // more than it has in the scene, by a ten-billionth
            trace.paths[0].knots[0].state.velocity *= 1.0 + 1e-10;
        }),
        ("outside", |trace| {
            let last = trace.paths[0].knots.last_mut().unwrap();
            last.state.position.x = 12.63;
        }),
        ("overlap", |trace| {
            let place = trace.paths[1].knots[0].state.position;
            trace.paths[2].knots[0].state.position = place;
        }),
        ("passed-over", |trace| {
            // the cue ball goes through the whole rack
            let knots = &mut trace.paths[0].knots;
            knots.truncate(2);
            let first = knots[0].state;
            knots[1].time = 1.5;
            knots[1].state.position = first.position + first.velocity * 1.5;
            knots[1].state.velocity = first.velocity;
            trace.paths[1..]
                .iter_mut()
                .for_each(|path| path.knots.truncate(1));
            trace.ending = Ending::Duration;
        }),
        ("outside", |trace| {
            trace.extrema.outside.value = 1.0;
            trace.extrema.outside.ball = Some(0);
        }),
    ];
    for (what, tamper) in tampered {
        let mut broken = whole.clone();
        tamper(&mut broken);
        let verdict = check(&scene, &broken, true);
        let seen: Vec<&str> = verdict.faults.iter().map(|fault| fault.what).collect();
        assert!(seen.contains(&what), "{what}: {seen:?}");
    }
}

#[test]
fn the_try_of_a_scene_sets_what_the_command_line_leaves_open() {
    let mut scene = crate::support::report_break(0.01, 90.2);
    let tried = ["stepper dt=0.5 contact=as-written", "exact partners=all"];
    scene.try_settings = tried.map(|line| line.parse().unwrap()).to_vec();
    for (list, label) in [
        ("stepper", "stepper contact=as-written dt=0.5"),
        ("stepper:dt=0.1", "stepper contact=as-written dt=0.1"),
        ("exact", "exact partners=all"),
        ("rapier-f64", "rapier-f64"),
    ] {
        let column = &Configuration::list(crate::support::roster(), list).unwrap()[0];
        assert_eq!(column.as_tried(&scene).label(), label);
    }
}
