//! No collision is missed: the traces of ten thousand random scenes, swept by parry's time of impact.
//!
//! How: see `compare::sweep`. Allowed: `1e-12 R + 8 ulp` of the largest coordinate for rounding (the definition of touching), and as much again for the
//! chord.

use crate::random::{Draw, random_scene};
use crate::support::{R, report_break, run};
use carom::compare::{Sweep, first_overlap, outside};
use carom::math::Vec3;
use carom::math::random::Draws;
use carom::scene::perturb::{Law, Perturbation};
use carom::scene::{Scene, catalogue};
use carom::trace::{EventKind, Knot, Record, Trace};

/// Scenes in all, shared evenly by the tests of a part.
const SCENES: u64 = 10_000;
const PARTS: u64 = 4;

/// Scene number `index` of ten thousand: 2 to 12 balls, sometimes 24 or a break of 16; with much, little and no friction;
/// with and without cushions; equal and unequal balls.
fn scene(index: u64) -> Scene {
    let mut draws = Draws::new(77, index);
    if index % 100 == 99 {
        let gap = R * 10_f64.powf(draws.between(-4.0, -1.0));
        return report_break(gap, draws.between(88.0, 92.0));
    }
    let crowded = index % 25 == 24;
    let balls = if crowded {
        24
    } else {
        2 + (draws.bits() % 11) as usize
    };
    let mu = [0.2, 0.02, 0.0][(index % 3) as usize];
    let mut scene = random_scene(
        draws.bits(),
        Draw {
            balls,
            moving: 1 + (draws.bits() % balls as u64) as usize,
            mu,
            // without friction collisions go on for ever
            duration: if mu > 0.1 { 20.0 } else { 3.0 },
            unequal: index.is_multiple_of(2),
        },
    );
    if index.is_multiple_of(5) {
        (scene.effects.cushion, scene.table) = (None, None);
    }
    scene.name = format!("scene {index}");
    scene
}

fn sweep(scene: &Scene, trace: &Trace) -> Sweep {
    carom::compare::sweep(scene, trace, scene.touching())
}

fn simulate(scene: &Scene) -> Trace {
    run("exact", &[], scene, Record::Events)
}

fn hold(part: u64) {
    let (mut casts, mut collisions, mut complete) = (0, 0, 0);
    for index in (part..SCENES).step_by(PARTS as usize) {
        let scene = scene(index);
        let trace = simulate(&scene);
        let seen = sweep(&scene, &trace);
        assert!(
            seen.overlaps.is_empty() && seen.outside.is_empty() && seen.given_up == 0,
            "scene {index}: balls overlap {:?}, are outside {:?}; ended {:?}",
            seen.overlaps,
            seen.outside,
            trace.ending
        );
        casts += seen.casts;
        collisions += trace.collisions().count();
        complete += u64::from(trace.ending.is_complete());
    }
    let n = SCENES / PARTS;
    // every ball-ball impact makes parry look on both sides of it
    assert!(
        collisions as u64 > 5 * n && casts > 5 * n,
        "{collisions} collisions, {casts} casts"
    );
    assert!(
        complete * 100 >= 99 * n,
        "{complete} of {n} runs went to their end"
    );
}

#[test]
fn parry_sees_no_missed_collision_in_the_first_quarter_of_ten_thousand_scenes() {
    hold(0);
}

#[test]
fn parry_sees_no_missed_collision_in_the_second_quarter_of_ten_thousand_scenes() {
    hold(1);
}

#[test]
fn parry_sees_no_missed_collision_in_the_third_quarter_of_ten_thousand_scenes() {
    hold(2);
}

#[test]
fn parry_sees_no_missed_collision_in_the_fourth_quarter_of_ten_thousand_scenes() {
    hold(3);
}

#[test]
fn parry_sees_no_missed_collision_in_shots_with_rotation_losses_and_pockets() {
    let (mut shots, mut collisions) = (0, 0);
    for entry in catalogue::all() {
        let nominal = entry.scene().unwrap();
        if !nominal.effects.rotates() {
            continue;
        }
        // and twenty variations of each: aim, speed and gaps
        let law = Law {
            aim: 1.0,
            speed: 0.05,
            gap: 0.0,
        };
        let varied = Perturbation::new(&nominal, law).ok();
        let samples = varied
            .iter()
            .flat_map(|law| (0..20).map(|index| law.sample(5, index)));
        for scene in std::iter::once(nominal.clone()).chain(samples) {
            let trace = simulate(&scene);
            let seen = sweep(&scene, &trace);
            assert!(
                seen.overlaps.is_empty() && seen.outside.is_empty() && seen.given_up == 0,
                "{}: balls overlap {:?}, are outside {:?}; ended {:?}",
                scene.name,
                seen.overlaps,
                seen.outside,
                trace.ending
            );
            shots += 1;
            collisions += trace.collisions().count();
        }
    }
    assert!(
        shots > 200 && collisions > 1000,
        "{shots} shots, {collisions} collisions"
    );
}

/// The trace of an engine that missed the event with this index: its balls fly on as before, and nothing else is known of them.
fn without(trace: &Trace, index: usize) -> Trace {
    let mut missed = trace.clone();
    let event = trace.events[index];
    let (a, b) = event.kind.balls();
    for ball in [Some(a), b].into_iter().flatten() {
        let knots = &mut missed.paths[ball].knots;
        let far = knots
            .iter()
            .position(|k| k.after == Some(index as u32))
            .unwrap();
        knots.truncate(far);
        let near = knots[far - 1];
        let before = knots[..far].iter().rev().find(|k| k.time < near.time);
        let a = before.map_or(Vec3::zeros(), |k| {
            (near.state.velocity - k.state.velocity) / (near.time - k.time)
        });
        let v = near.state.velocity;
        // to its stop, or for a second
        let h = if a.norm() > 0.0 {
            v.norm() / a.norm()
        } else {
            1.0
        };
        let mut state = near.state;
        state.position += (v + a * (0.5 * h)) * h;
        state.velocity += a * h;
        knots.push(Knot {
            time: near.time + h,
            state,
            after: None,
        });
    }
    missed.events.truncate(index);
    missed
}

/// How deep two balls pass through each other after the knots before the last of `missed`, length; by sampling.
fn deepest(scene: &Scene, missed: &Trace, a: usize, b: usize, from: f64) -> f64 {
    let reach = scene.balls[a].radius + scene.balls[b].radius;
    let last = |ball: usize| missed.paths[ball].knots.last().unwrap().time;
    let to = last(a).min(last(b)).max(from);
    let depth = |i: i32| {
        let t = from + (to - from) * f64::from(i) / 1000.0;
        let place = |ball: usize| missed.paths[ball].state_at(t).unwrap().position;
        reach - (place(a) - place(b)).norm()
    };
    (0..=1000).map(depth).fold(0.0, f64::max)
}

#[test]
fn an_event_that_is_missed_is_seen() {
    let (mut hits, mut bounces) = (0, 0);
    for index in 0..60 {
        let scene = scene(index);
        let trace = simulate(&scene);
        for (i, event) in trace.events.iter().enumerate() {
            let missed = without(&trace, i);
            match event.kind {
                EventKind::BallBall(a, b) => {
                    let (a, b) = (a as usize, b as usize);
                    // a graze may go no deeper than rounding
                    if deepest(&scene, &missed, a, b, event.time) <= 3.0 * scene.touching() {
                        continue;
                    }
                    let found = first_overlap(
                        &scene,
                        &missed,
                        (a, b),
                        scene.touching(),
                        &mut Sweep::default(),
                    );
                    assert!(
                        found.is_some(),
                        "{}: {event:?} missed and not seen",
                        scene.name
                    );
                    hits += 1;
                }
                EventKind::BallCushion(ball, side) => {
                    let found = outside(&scene, &missed, ball as usize, scene.touching());
                    let seen = found.iter().any(|(_, s, _)| *s == side);
                    assert!(seen, "{}: {event:?} missed and not seen", scene.name);
                    bounces += 1;
                }
                _ => {}
            }
        }
    }
    assert!(
        hits > 300 && bounces > 300,
        "{hits} hits, {bounces} bounces"
    );
}
