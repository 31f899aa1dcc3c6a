//! Shots with every law at once: energy, symmetry, pockets, and what the trace and the sheet say.

use super::{APPROACHING, G, M, MU, R, cloth, one_ball, pool, rolling, simulate, within};
use crate::support::run;
use carom::engine::{Setting, prepare};
use carom::math::Vec3;
use carom::physics::{Contact, Cushion, Effects, Friction, Pockets, State};
use carom::scene::{Scene, Table};
use carom::trace::{Ending, EventKind, Record};

/// Five balls, every law: inelastic contacts with throw, the cushion of Mathavan 2010, pockets at both sides.
fn busy() -> Scene {
    let balls = [
        ([-0.05, -0.3], [0.5, 4.0], [20.0, -15.0, 40.0]),
        ([0.0, 0.1], [0.0, 0.0], [0.0; 3]),
        ([-0.2, 0.3], [0.0, 0.0], [0.0; 3]),
        ([0.25, 0.25], [-0.8, -0.3], [0.0, 0.0, -30.0]),
        ([0.3, -0.35], [-0.6, 0.9], [-10.0, 0.0, 0.0]),
    ];
    let mut mu = MU;
    mu.mu_roll = 0.03;
    let mut scene = pool("busy", mu, &balls);
    scene.effects = Effects {
        cloth: Some(cloth(mu)),
        contact: Some(Contact::Inelastic { e: 0.93 }),
        friction: Some(Friction::Alciatore {
            a: 9.951e-3,
            b: 0.108,
            c: 1.088,
            length_in_metres: 1.0,
        }),
        cushion: Some(Cushion::Mathavan2010 {
            e: 0.98,
            mu: 0.14,
            mu_cloth: 0.212,
            height: 1.28,
        }),
        pockets: Some(Pockets {
            circles: vec![[-0.4, 0.0, 0.07], [0.4, 0.0, 0.07]],
        }),
    };
    scene.table = Some(Table {
        min: [-0.4, -0.5],
        max: [0.4, 0.5],
    });
    scene
}

#[test]
fn energy_never_grows_with_every_law_under_both_contact_rules() {
    let scene = busy();
    let mut pocketed = 0;
    for rule in ["contact=as-written", APPROACHING] {
        for dt in [4e-3, 1e-3] {
            let trace = run(
                "stepper",
                &[&format!("dt={dt}"), rule],
                &scene,
                Record::Every(dt),
            );
            let collisions = trace.collisions().count();
            assert!(
                collisions >= 8,
                "{rule}, dt {dt}: only {collisions} collisions"
            );
            let steps = (trace.end_time / dt).round() as u64;
            // one rounding of each ball in a step
            let slack = 16.0 * f64::EPSILON * scene.initial_energy();
            let mut last = scene.initial_energy();
            for step in 0..=steps {
                let time = step as f64 * dt;
                let in_play = |i: &usize| trace.paths[*i].knots.last().unwrap().time >= time;
                let energy: f64 = (0..scene.balls.len())
                    .filter(in_play)
                    .map(|i| {
                        let state = trace.paths[i].state_at(time).unwrap();
                        let mass = scene.balls[i].mass;
                        carom::physics::invariants::kinetic_energy(&state, mass, scene.inertia(i))
                    })
                    .sum();
                assert!(
                    energy <= last + slack,
                    "{rule}, dt {dt}: grows by {:e} at {time}",
                    energy - last
                );
                last = energy;
            }
            assert!(trace.extrema.energy_gained.value <= slack * collisions as f64);
            assert_eq!(trace.ending, Ending::Rest);
            pocketed += (0..scene.balls.len())
                .filter(|&i| trace.pocketed(i))
                .count();
        }
    }
    assert!(pocketed > 0, "no ball met a pocket");
}

#[test]
fn mirrored_shots_with_spin_are_mirror_images_and_reruns_are_the_same_bits() {
    let scene = busy();
    let mut mirrored = scene.clone();
    for ball in &mut mirrored.balls {
        let State {
            position,
            velocity,
            spin,
        } = &mut ball.state;
        position.x = -position.x;
        velocity.x = -velocity.x;
        // an axial vector keeps its part across the mirror
        (spin.y, spin.z) = (-spin.y, -spin.z);
    }
    let circles = mirrored.effects.pockets.as_mut().unwrap();
    for circle in &mut circles.circles {
        circle[0] = -circle[0];
    }
    let (one, other) = (
        simulate(&scene, 1e-3, Record::Events),
        simulate(&mirrored, 1e-3, Record::Events),
    );
    assert_eq!(one, simulate(&scene, 1e-3, Record::Events));
    assert_eq!(one.events.len(), other.events.len());
    assert!(one.events.len() > 20, "{} events", one.events.len());
    for (a, b) in one.paths.iter().zip(&other.paths) {
        let (a, b) = (a.last().unwrap(), b.last().unwrap());
        let mirror = Vec3::new(-b.position.x, b.position.y, b.position.z);
        // every operation of the scheme and of the laws is the same but for signs
        assert_eq!(a.position, mirror);
    }
}

#[test]
fn a_pocketed_ball_leaves_play_and_the_next_one_follows_it_in() {
    let (v, dt) = (0.5, 1e-3);
    let balls = [
        ([0.0, 0.0], [0.0, v], rolling([0.0, v])),
        ([0.0, -0.07], [0.0, v], rolling([0.0, v])),
        ([0.0, 1.0], [0.0, 0.0], [0.0; 3]),
    ];
    let mut scene = pool("pocket", MU, &balls);
    scene.effects.pockets = Some(Pockets {
        circles: vec![[5.0, 5.0, 0.1], [0.02, 0.4, 0.06]],
    });
    let trace = simulate(&scene, dt, Record::Every(0.01));
    let kinds: Vec<EventKind> = trace.events.iter().map(|e| e.kind).collect();
    assert_eq!(kinds, [EventKind::Pocket(0, 1), EventKind::Pocket(1, 1)]);
    let a = MU.mu_roll * G;
    let rim = 0.4 - (0.06_f64.powi(2) - 0.02 * 0.02).sqrt();
    for (ball, way) in [(0, rim), (1, rim + 0.07)] {
        let entry = (v - (v * v - 2.0 * a * way).sqrt()) / a;
        let event = trace.events[ball];
        // found at the first step end inside; the roll is a t dt/2 behind, less than a step's way
        let behind = 0.5 * a * entry * dt / (v - a * entry);
        assert!(
            event.time >= entry && event.time <= entry + behind + dt,
            "ball {ball} at {}, exact {entry}",
            event.time
        );
        let last = trace.paths[ball].knots.last().unwrap();
        assert_eq!((last.time, last.after), (event.time, Some(ball as u32)));
        assert_eq!(
            (trace.final_states()[ball], trace.stop_times[ball]),
            (None, None)
        );
    }
    assert_eq!(
        (trace.stop_times[2], &trace.ending),
        (Some(0.0), &Ending::Rest)
    );
    assert_eq!(trace.end_time, trace.events[1].time);

    // the second ball passed over the place where the first left play: nothing was there to meet or to overlap
    let after = trace.events[0].time + 1e-9;
    assert_eq!(trace.in_play_at(0, after), None);
    assert_eq!(carom::compare::deepest_overlap(&scene, &trace), 0.0);

    let mut pared = trace;
    pared.pare();
    let short = simulate(&scene, dt, Record::Final);
    assert_eq!(short.paths, pared.paths);
    assert_eq!(short.stop_times, pared.stop_times);
}

#[test]
fn with_rotation_too_unexplained_is_at_most_a_h_dt_over_2() {
    for scene in [busy(), one_ball([0.3, 1.5], [40.0, 10.0, 30.0])] {
        let (dt, cadence) = (1e-3, 0.02);
        let trace = simulate(&scene, dt, Record::Every(cadence));
        // a piece is at most one cadence long, and one step longer where a sample falls between two steps
        let bound = MU.mu_slide * G * (cadence + dt) * dt / 2.0;
        let found = trace.unexplained();
        assert!(
            found > 0.1 * bound && found <= bound * (1.0 + 1e-9),
            "{}: {found:e}, bound {bound:e}",
            scene.name
        );
    }
}

#[test]
fn every_law_arrives_inside_and_stands_on_the_sheet() {
    let scene = busy();
    let stepper = crate::support::find("stepper").unwrap();
    assert_eq!(stepper.missing(&scene), Vec::<&str>::new());
    let prepared = prepare(stepper.as_ref(), &scene, &Setting::default()).unwrap();
    for inertia in prepared.inside().inertia {
        within(
            "moment of inertia",
            inertia.unwrap(),
            0.4 * M * R * R,
            1e-20,
        );
    }
    let sheet = prepared.sheet();
    for (name, value) in [
        ("mu_slide", "0.2"),
        ("mu_roll", "0.03"),
        ("mu_spin", "0.0117"),
        ("impulse with loss", "e = 0.93"),
        ("Mathavan 2010", "e = 0.98 of work, nose at 1.28 R"),
        ("rotation", "free"),
        ("pockets", "2 circles, tested at the end of a step"),
    ] {
        let row = sheet.iter().find(|row| row.name == name);
        assert_eq!(row.map(|row| row.value.as_str()), Some(value), "{name}");
    }
}
