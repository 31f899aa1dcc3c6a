//! No collision is missed: the traces of ten thousand random scenes, swept by parry's time of impact.
//!
//! Neither the finders nor the contact law of the engine are asked: only the knots of a trace are read, and two spheres of the
//! scene's radii are cast along its paths. A path between knots is a parabola; it is cut into pieces whose chord leaves
//! it by at most `a h^2 / 8`, and `h` is chosen so that this is no more than rounding may be. Stretches that the speeds at the
//! knots alone keep the balls apart in are skipped.
//!
//! Allowed: `1e-12 R + 8 ulp` of the largest coordinate for rounding (the definition of touching), and as much again for the
//! chord.

use crate::random::{Draw, random_scene};
use crate::support::{R, report_break, run};
use carom::math::Vec3;
use carom::math::random::Draws;
use carom::physics::{Side, State};
use carom::scene::perturb::{Law, Perturbation};
use carom::scene::{Scene, catalogue};
use carom::trace::{EventKind, Knot, Record, Trace};
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::{ShapeCastOptions, cast_shapes};
use parry3d_f64::shape::Ball;

/// Scenes in all, shared evenly by the tests of a part.
const SCENES: u64 = 10_000;
const PARTS: u64 = 4;

/// What a sweep saw.
#[derive(Debug, Default)]
struct Sweep {
    /// Questions to parry.
    casts: u64,
    /// The first overlap of each pair: the balls and s.
    overlaps: Vec<(usize, usize, f64)>,
    /// Centres beyond where their cushions let them be: ball, side, s.
    outside: Vec<(usize, Side, f64)>,
}

/// Position at `t` of a ball between its knots, and the largest speed and the acceleration there.
fn states(trace: &Trace, ball: usize, from: f64, to: f64) -> (State, State) {
    let path = &trace.paths[ball];
    (path.state_at(from).unwrap(), path.before(to).unwrap())
}

fn times(trace: &Trace, balls: &[usize]) -> Vec<f64> {
    let knots = balls.iter().flat_map(|ball| &trace.paths[*ball].knots);
    let mut times: Vec<f64> = knots.map(|knot| knot.time).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// Sweeps every pair of a trace, and every ball against its cushions.
fn sweep(scene: &Scene, trace: &Trace) -> Sweep {
    let mut seen = Sweep::default();
    let n = scene.balls.len();
    for a in 0..n {
        for b in a + 1..n {
            if let Some(time) = first_overlap(scene, trace, a, b, &mut seen.casts) {
                seen.overlaps.push((a, b, time));
            }
        }
        if scene.effects.cushion.is_some() {
            outside(scene, trace, a, &mut seen.outside);
        }
    }
    seen
}

/// Motion of one ball as seen from another over one stretch of time: exact where both accelerations are constant.
struct Stretch {
    p: Vec3,
    v: Vec3,
    a: Vec3,
    h: f64,
}

impl Stretch {
    fn at(&self, t: f64) -> Vec3 {
        self.p + (self.v + self.a * (0.5 * t)) * t
    }

    /// Largest relative speed from `t` on: it is linear in time as a vector, so that its size is largest at an end.
    fn fastest(&self, t: f64) -> f64 {
        let speed = |t: f64| (self.v + self.a * t).norm();
        speed(t).max(speed(self.h))
    }
}

fn first_overlap(scene: &Scene, trace: &Trace, a: usize, b: usize, casts: &mut u64) -> Option<f64> {
    let rounding = scene.touching();
    // half of both allowances off each radius: these must never meet
    let shrunk = |ball: usize| Ball::new(scene.balls[ball].radius - rounding);
    let (first, second) = (shrunk(a), shrunk(b));
    let reach = scene.balls[a].radius + scene.balls[b].radius;
    // where a ball left play, others may follow
    let in_play = |ball: usize| match trace.pocketed(ball) {
        true => trace.paths[ball].knots.last().unwrap().time,
        false => f64::INFINITY,
    };
    let until = in_play(a).min(in_play(b));
    for span in times(trace, &[a, b]).windows(2).filter(|s| s[1] <= until) {
        let h = span[1] - span[0];
        let ((a0, a1), (b0, b1)) = (
            states(trace, a, span[0], span[1]),
            states(trace, b, span[0], span[1]),
        );
        let stretch = Stretch {
            p: b0.position - a0.position,
            v: b0.velocity - a0.velocity,
            a: ((b1.velocity - b0.velocity) - (a1.velocity - a0.velocity)) / h,
            h,
        };
        // a step whose chord is within rounding of the parabola
        let fine = (8.0 * rounding / stretch.a.norm()).sqrt();
        let mut t = 0.0;
        while t < h {
            let here = stretch.at(t);
            let free = (here.norm() - reach).max(0.0) / stretch.fastest(t);
            if free > fine {
                t += free;
                continue;
            }
            let next = (t + fine).min(h);
            let there = stretch.at(next);
            *casts += 1;
            if meets(&first, &second, here, there) {
                return Some(span[0] + t);
            }
            // the last piece may be shorter than the clock resolves
            t = if next > t { next } else { h };
        }
    }
    None
}

/// Whether the second ball, going from one place to another in a straight line as seen from the first, touches it.
fn meets(first: &Ball, second: &Ball, from: Vec3, to: Vec3) -> bool {
    let vector = |v: Vec3| Vector::new(v.x, v.y, v.z);
    let options = ShapeCastOptions {
        max_time_of_impact: 1.0,
        ..ShapeCastOptions::default()
    };
    let hit = cast_shapes(
        &Pose::IDENTITY,
        Vector::ZERO,
        first,
        &Pose::from_translation(vector(from)),
        vector(to - from),
        second,
        options,
    );
    hit.expect("parry casts balls").is_some()
}

/// Times at which the centre of a ball is farther out than rounding explains.
fn outside(scene: &Scene, trace: &Trace, ball: usize, found: &mut Vec<(usize, Side, f64)>) {
    let bound = scene.touching();
    for span in times(trace, &[ball]).windows(2) {
        let (from, h) = (span[0], span[1] - span[0]);
        let (start, end) = states(trace, ball, from, span[1]);
        for side in Side::ALL {
            let axis = side.axis();
            let outward = f64::from(side.sign());
            let reach = scene.reach(side, scene.balls[ball].radius).unwrap();
            let (v0, v1) = (outward * start.velocity[axis], outward * end.velocity[axis]);
            let beyond = |x: f64| outward * (x - reach) > bound;
            // where it turns back, if it does
            let turn = if v0 > 0.0 && v1 < 0.0 {
                start.position[axis] + outward * 0.5 * v0 * v0 * h / (v0 - v1)
            } else {
                end.position[axis]
            };
            if beyond(start.position[axis]) || beyond(end.position[axis]) || beyond(turn) {
                found.push((ball, side, from));
            }
        }
    }
}

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
            seen.overlaps.is_empty() && seen.outside.is_empty(),
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
                seen.overlaps.is_empty() && seen.outside.is_empty(),
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
                    let found = first_overlap(&scene, &missed, a, b, &mut 0);
                    assert!(
                        found.is_some(),
                        "{}: {event:?} missed and not seen",
                        scene.name
                    );
                    hits += 1;
                }
                EventKind::BallCushion(ball, side) => {
                    let mut found = Vec::new();
                    outside(&scene, &missed, ball as usize, &mut found);
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
