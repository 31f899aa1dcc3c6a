//! Each row of what is demanded of rapier's scene.

use super::{BOTH, cut_shot, discs, final_energy, final_momentum, final_velocity, rack};
use crate::support::{G, MU, R, Scenario, run, scenario};
use carom::math::Vec3;
use carom::physics::State;
use carom::scene::Scene;
use carom::trace::{EventKind, Record, Trace};

/// Speed, direction in degrees, mu, dt, substeps of single slides: h = dt / substeps is 1/4000 s or more, below which f32
/// gets worse with the step.
const SLIDES: [(f64, f64, f64, f64, u64); 5] = [
    (5.0, 37.0, MU, 1e-3, 4),
    (0.3, 90.0, MU, 1e-3, 4),
    (10.0, 211.0, 0.4, 2e-3, 2),
    (2.0, 0.0, 0.05, 5e-3, 1),
    (5.0, 122.0, MU, 1.0 / 60.0, 8),
];

struct Slide {
    name: String,
    trace: Trace,
    speed: f64,
    a: f64,
    dt: f64,
    h: f64,
}

fn slides(engine: &str) -> Vec<Slide> {
    let slide = |(speed, angle, mu, dt, substeps): (f64, f64, f64, f64, u64)| {
        let scene = scenario("slide")
            .shot("cue", [0.0, 0.0], speed, angle)
            .cloth(mu)
            .duration(60.0)
            .build();
        let settings = [format!("dt={dt}"), format!("substeps={substeps}")];
        let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
        Slide {
            name: format!("{engine}, v {speed}, mu {mu}, {}", settings.join(" ")),
            trace: run(engine, &settings, &scene, Record::Every(4.0 * dt)),
            speed,
            a: mu * G,
            dt,
            h: dt / substeps as f64,
        }
    };
    SLIDES.into_iter().map(slide).collect()
}

#[test]
fn a_sliding_ball_decelerates_by_mu_g() {
    for (engine, tolerance) in [("rapier-f64", 1e-9), ("rapier-f32", 1e-3)] {
        for slide in slides(engine) {
            let knots = &slide.trace.paths[0].knots;
            // the stop is three knots: where its step began, and both sides
            let last = &knots[knots.len() - 3];
            assert!(last.time > 0.8 * slide.speed / slide.a, "{}", slide.name);
            let got = (slide.speed - last.state.speed()) / last.time;
            assert!(
                (got - slide.a).abs() <= tolerance * slide.a,
                "{}: deceleration {got}, expected {}",
                slide.name,
                slide.a
            );
        }
    }
}

#[test]
fn a_sliding_ball_stops_with_the_first_step_after_v_over_mu_g() {
    for (engine, early, late) in [("rapier-f64", 1.0, 1.0), ("rapier-f32", 0.999, 1.001)] {
        for slide in slides(engine) {
            let t = slide.speed / slide.a;
            let got = slide.trace.stop_times[0].unwrap();
            // a ball counts as stopped once it is slower than the rest speed, so much sooner
            let sooner = slide.trace.provenance.rest_speed / slide.a;
            assert!(
                got >= early * t - sooner && got <= late * t + slide.dt,
                "{}: stopped at {got}, expected {t} to {}",
                slide.name,
                t + slide.dt
            );
            let speed = slide.trace.final_states()[0].unwrap().speed();
            assert!(
                speed <= slide.trace.provenance.rest_speed,
                "{}: {speed}",
                slide.name
            );
            let kinds: Vec<_> = slide.trace.events.iter().map(|e| e.kind).collect();
            assert_eq!(kinds, [EventKind::Stop(0)], "{}", slide.name);
        }
    }
}

#[test]
fn a_sliding_ball_stops_short_by_half_a_substep_of_its_speed() {
    for slide in slides("rapier-f64") {
        let short = shortfall(&slide);
        let expected = 0.5 * slide.h * slide.speed;
        assert!(
            (short - expected).abs() <= 0.05 * expected,
            "{}: short by {short}, expected {expected}",
            slide.name
        );
    }
    for slide in slides("rapier-f32") {
        let distance = slide.speed * slide.speed / (2.0 * slide.a);
        let bound = 1e-3 * distance + 0.5 * slide.h * slide.speed;
        let short = shortfall(&slide);
        assert!(
            short.abs() <= bound,
            "{}: short by {short}, bound {bound}",
            slide.name
        );
    }
}

fn shortfall(slide: &Slide) -> f64 {
    let end = slide.trace.final_states()[0].unwrap().position;
    slide.speed * slide.speed / (2.0 * slide.a) - end.xy().norm()
}

#[test]
fn a_single_hit_keeps_energy_and_momentum_at_any_speed_and_step() {
    for (engine, tolerance) in BOTH {
        for speed in [0.003, 0.3, 3.0, 30.0, 300.0] {
            for dt in ["dt=1e-4", "dt=1e-3", "dt=0.016666666666666666"] {
                for (cut, mass) in [(0.0, 0.107), (40.0, 0.107), (25.0, 0.3)] {
                    let scene = cut_shot(cut, speed, 1.7).with_mass(mass).build();
                    let scene = in_steps_of(scene, dt, 1000.0);
                    let trace = run(engine, &[dt], &scene, Record::Events);
                    let case = format!("{engine}, v {speed}, {dt}, cut {cut}, mass {mass}");
                    let hits = trace.collisions().count();
                    assert_eq!(hits, 1, "{case}: {:?}", trace.events);
                    let energy = final_energy(&scene, &trace) / scene.initial_energy();
                    assert!((energy - 1.0).abs() <= tolerance, "{case}: energy {energy}");
                    let p0 = Vec3::new(0.107 * speed, 0.0, 0.0);
                    let lost = (final_momentum(&scene, &trace) - p0).norm() / p0.norm();
                    assert!(lost <= tolerance, "{case}: momentum off by {lost}");
                    let booked = trace.extrema.momentum.value / p0.norm();
                    assert!(booked <= tolerance, "{case}: booked {booked}");
                }
            }
        }
    }
}

/// The scene scaled so that it takes about as many steps at any speed: a slow ball starts closer.
fn in_steps_of(mut scene: Scene, dt: &str, steps: f64) -> Scene {
    let dt: f64 = dt.trim_start_matches("dt=").parse().unwrap();
    let speed = scene.balls[0].state.velocity.x;
    let lead = (speed * dt * steps).min(1.7);
    scene.balls[0].state.position.x += 1.7 - lead;
    scene.duration = (2.0 * lead / speed).max(8.0 * dt);
    scene
}

#[test]
fn a_head_on_hit_of_equal_balls_exchanges_their_velocities() {
    for (engine, tolerance) in BOTH {
        for speed in [0.3, 3.0] {
            let scene = cut_shot(0.0, speed, 0.3).build();
            let trace = run(engine, &[], &scene, Record::Events);
            let (cue, object) = (final_velocity(&trace, 0), final_velocity(&trace, 1));
            assert!(
                cue.norm() <= tolerance * speed,
                "{engine}: cue ball keeps {cue:?}"
            );
            let expected = Vec3::new(speed, 0.0, 0.0);
            assert!(
                (object - expected).norm() <= tolerance * speed,
                "{engine}: object ball has {object:?}, expected {expected:?}"
            );
        }
    }
}

#[test]
fn the_direction_after_an_oblique_hit_is_off_by_a_step_at_most() {
    for (engine, _) in BOTH {
        for cut in [10.0, 30.0, 50.0, 70.0] {
            for (dt, speed) in [(1e-3, 5.0), (1e-3, 1.0), (1.25e-4, 5.0)] {
                let (worst, bound) = worst_direction_error(engine, &[], cut, speed, dt);
                assert!(
                    worst <= bound,
                    "{engine}, cut {cut}, v {speed}, dt {dt}: off by {worst}, bound {bound}"
                );
            }
        }
    }
}

/// Largest error of the object ball's direction over eight phases of the hit within the step, radians, and its bound
/// 1.3 sin(cut) v dt / (2R): the normal is taken where the balls are at the start of the step.
pub fn worst_direction_error(
    engine: &str,
    settings: &[&str],
    cut: f64,
    speed: f64,
    dt: f64,
) -> (f64, f64) {
    let step = format!("dt={dt}");
    let mut all = vec![step.as_str()];
    all.extend(settings);
    let mut worst = 0.0_f64;
    for phase in 0..8 {
        // from farther away than contacts are predicted
        let lead = 0.1 + speed * dt * f64::from(phase) / 8.0;
        let scene = cut_shot(cut, speed, lead);
        let scene = scene.duration(lead / speed + 20.0 * dt).build();
        let trace = run(engine, &all, &scene, Record::Events);
        let v = final_velocity(&trace, 1);
        let got = v.y.atan2(v.x);
        worst = worst.max((got - cut.to_radians()).abs());
    }
    (worst, 1.3 * cut.to_radians().sin() * speed * dt / (2.0 * R))
}

#[test]
fn a_cushion_mirrors_the_velocity_at_most_a_step_late() {
    for (engine, tolerance) in BOTH {
        for (v, dt) in [([3.0, 1.0], 1e-3), ([0.2, 5.0], 1e-3), ([7.0, 6.5], 2.5e-3)] {
            let scene = scenario("cushion")
                .moving("cue", [2.0, 2.0], v)
                .cushions(4.0, 4.0)
                .duration(2.0)
                .build();
            let trace = run(engine, &[&format!("dt={dt}")], &scene, Record::Events);
            let case = format!("{engine}, v {v:?}, dt {dt}");
            let got = final_velocity(&trace, 0);
            let (want, bounces) = mirrored(v, 4.0, 2.0);
            for axis in 0..2 {
                assert!(
                    (got[axis] - want[axis]).abs() <= tolerance * v[axis],
                    "{case}: velocity {got:?}, expected {want:?}"
                );
            }
            assert!(bounces.len() > 2, "{case}: {bounces:?}");
            for (axis, speed) in v.iter().enumerate() {
                let ulp = if tolerance < 1e-9 {
                    f64::EPSILON
                } else {
                    f64::from(f32::EPSILON)
                };
                // a substep of dt/4 rounds a position below 4 by half an ulp of 2, all to one side at worst
                let drift = 4.0 / dt * ulp / speed;
                on_time(&case, &trace, axis, &bounces, dt, drift);
            }
            let beyond = trace.extrema.outside.value;
            assert!(beyond <= v[0].max(v[1]) * dt, "{case}: outside by {beyond}");
        }
    }
}

/// Holds the bounces of one axis against their exact times. A bounce is found with the first substep that could reach the
/// cushion and acts at the end of that step: up to a step late, and up to a substep early. Each shifts those after it.
/// `drift`: how much rounding of the position may add to that, per s.
/// This takes v dt below the prediction distance, .02; a faster ball is found once it is past the cushion, a step later.
fn on_time(case: &str, trace: &Trace, axis: usize, bounces: &[(f64, usize)], dt: f64, drift: f64) {
    let of_axis = |kind| matches!(kind, EventKind::BallCushion(0, side) if side.axis() == axis);
    let got = trace.events.iter().filter(|event| of_axis(event.kind));
    let got: Vec<f64> = got.map(|event| event.time).collect();
    let want = bounces.iter().filter(|bounce| bounce.1 == axis);
    let want: Vec<f64> = want.map(|bounce| bounce.0).collect();
    assert_eq!(
        got.len(),
        want.len(),
        "{case}, axis {axis}: {got:?}, expected {want:?}"
    );
    for (k, (got, want)) in got.iter().zip(&want).enumerate() {
        let times = (k + 1) as f64;
        let late = got - want;
        let rounding = drift * want;
        let (least, most) = (-0.25 * dt * times - rounding, dt * times + rounding);
        assert!(
            late >= least && late <= most,
            "{case}, axis {axis}: bounce {k} at {got}, expected {want}"
        );
    }
}

/// Velocity after `duration`, and time and axis of every bounce, in a square box of side `size` from its middle.
fn mirrored(v: [f64; 2], size: f64, duration: f64) -> ([f64; 2], Vec<(f64, usize)>) {
    let (mut velocity, mut bounces) = (v, Vec::new());
    for axis in 0..2 {
        let width = size - 2.0 * R;
        let mut t = 0.5 * width / v[axis];
        while t < duration {
            velocity[axis] = -velocity[axis];
            bounces.push((t, axis));
            t += width / v[axis];
        }
    }
    (velocity, bounces)
}

/// A break whose hits are pairwise: the gap takes longer to cross than the coarsest step. `phase` shifts all hits within it.
fn pairwise_break(phase: f64) -> Scenario {
    let cue = scenario("break").moving("cue", [0.07, -1.5 - phase], [0.0, 10.0]);
    rack(cue, [0.0, 0.0], 5, 0.2).duration(0.5)
}

#[test]
fn a_break_with_pairwise_hits_converges_to_straight_lines_in_first_order() {
    // an oracle of the test's own: nothing of the crate on its side
    first_order(|phase| {
        let scene = pairwise_break(phase).build();
        let (discs, hits) = discs::exact(&scene, scene.duration);
        (
            scene,
            discs.iter().map(|disc| disc.position).collect(),
            hits,
        )
    });
}

#[test]
fn a_break_with_pairwise_hits_on_cloth_converges_to_the_exact_engine_in_first_order() {
    first_order(|phase| {
        let scene = pairwise_break(phase).cloth(MU).build();
        let exact = run("exact", &[], &scene, Record::Events);
        let place = |state: &Option<State>| {
            let position = state.unwrap().position;
            [position.x, position.y]
        };
        let places = exact.final_states().iter().map(place).collect();
        (scene, places, exact.collisions().count())
    });
}

/// Fits the order of the largest position error over steps from 1/1000 to 1/16000 s, each the geometric mean over eight
/// phases of the hits within the step: the error of one run is a saw-tooth in that phase. `reference` answers a break for
/// a phase, with final positions and the number of hits.
fn first_order(reference: impl Fn(f64) -> (Scene, Vec<[f64; 2]>, usize)) {
    let mut points = Vec::new();
    for rate in [1000.0, 2000.0, 4000.0, 8000.0, 16000.0] {
        let dt: f64 = 1.0 / rate;
        let step = format!("dt={dt}");
        let mut mean = 0.0;
        for eighth in 0..8 {
            let travel = 10.0 * dt;
            let (scene, want, hits) = reference(f64::from(eighth) / 8.0 * travel);
            let trace = run("rapier-f64", &[&step], &scene, Record::Events);
            let got = trace.collisions().count();
            assert!(
                hits >= 10 && got == hits,
                "dt {dt}: {got} hits, expected {hits}"
            );
            mean += largest_distance(&trace.final_states(), &want).ln() / 8.0;
        }
        points.push((dt.ln(), mean));
    }
    let order = slope(&points);
    assert!((order - 1.0).abs() <= 0.3, "order {order} over {points:?}");
}

fn largest_distance(got: &[Option<State>], want: &[[f64; 2]]) -> f64 {
    let distance = |(state, place): (&Option<State>, &[f64; 2])| {
        let p = state.unwrap().position;
        (p.x - place[0]).hypot(p.y - place[1])
    };
    got.iter().zip(want).map(distance).fold(0.0, f64::max)
}

/// Slope of the least-squares line.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let (x, y) = points
        .iter()
        .fold((0.0, 0.0), |(x, y), p| (x + p.0 / n, y + p.1 / n));
    let (sxy, sxx) = points.iter().fold((0.0, 0.0), |(sxy, sxx), p| {
        (sxy + (p.0 - x) * (p.1 - y), sxx + (p.0 - x) * (p.0 - x))
    });
    sxy / sxx
}

#[test]
fn touching_balls_keep_their_momentum() {
    let triangle = |name: &str| {
        let cue = scenario(name).moving("cue", [0.0, -1.0], [0.01, 10.0]);
        rack(cue, [0.0, 0.0], 5, 0.0).duration(0.3).build()
    };
    let cradle = {
        let mut row = scenario("cradle").moving("cue", [-1.0, 0.0], [5.0, 0.0]);
        for k in 0..5 {
            row = row.resting(&k.to_string(), [2.0 * R * f64::from(k), 0.0]);
        }
        row.duration(0.5).build()
    };
    for (engine, tolerance) in BOTH {
        for scene in [&triangle("frozen"), &cradle] {
            let trace = run(engine, &[], scene, Record::Events);
            let p0: Vec3 = scene
                .balls
                .iter()
                .fold(Vec3::zeros(), |sum, b| sum + b.state.velocity * b.mass);
            let lost = (final_momentum(scene, &trace) - p0).norm() / p0.norm();
            // every hit may round once more
            let bound = tolerance * trace.counters["exchanges"].max(1) as f64;
            assert!(
                lost <= bound,
                "{engine}, {}: momentum off by {lost}",
                scene.name
            );
            let booked = trace.extrema.momentum.value / p0.norm();
            assert!(booked <= bound, "{engine}, {}: booked {booked}", scene.name);
            assert!(trace.counters["exchanges"] >= 5, "{engine}, {}", scene.name);
        }
    }
}

#[test]
fn a_rerun_gives_the_same_bits() {
    let cue = scenario("break").moving("cue", [6.3, 15.0], [0.05, 12.0]);
    let scene = rack(cue, [6.315, 18.225], 5, 0.0)
        .cloth(MU)
        .cushions(12.63, 24.3)
        .duration(1.0)
        .build();
    for (engine, _) in BOTH {
        for settings in [&[][..], &["preset=stock"]] {
            let first = run(engine, settings, &scene, Record::Every(0.01));
            let second = run(engine, settings, &scene, Record::Every(0.01));
            assert!(first.collisions().count() > 10, "{engine} {settings:?}");
            assert_eq!(first, second, "{engine} {settings:?}");
        }
    }
}
