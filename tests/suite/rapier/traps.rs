//! What rapier does where its scene is set up otherwise: each trap that the converging preset avoids is visible.

use super::demands::worst_direction_error;
use super::{BOTH, cut_shot, final_energy, final_velocity};
use crate::support::{G, R, run, scenario};
use carom::trace::Record;
use rapier3d_f64::prelude::*;

#[test]
fn recycled_contacts_stop_an_oblique_hit_from_converging() {
    let (coarse, fine) = (1.0 / 4000.0, 1.0 / 64000.0);
    let error =
        |settings: &[&str], dt| worst_direction_error("rapier-f64", settings, 30.0, 5.0, dt).0;
    let (off, on) = (&["contact_recycling=false"], &["contact_recycling=true"]);
    let (fresh, recycled) = (
        (error(off, coarse), error(off, fine)),
        (error(on, coarse), error(on, fine)),
    );
    // first order over a factor of 16, but for the saw-tooth of the phase
    assert!(
        fresh.1 < 0.2 * fresh.0,
        "fresh normals do not converge: {fresh:?}"
    );
    assert!(
        recycled.1 > 0.5 * recycled.0,
        "recycled normals converge: {recycled:?}"
    );
    assert!(
        recycled.1 > 10.0 * fresh.1,
        "{recycled:?} against {fresh:?}"
    );
}

#[test]
fn touching_balls_do_not_keep_their_energy() {
    for (engine, _) in BOTH {
        let mut row = scenario("cradle").moving("cue", [-1.0, 0.0], [5.0, 0.0]);
        for k in 0..4 {
            row = row.resting(&k.to_string(), [2.0 * R * f64::from(k), 0.0]);
        }
        let scene = row.duration(0.5).build();
        let trace = run(engine, &[], &scene, Record::Final);
        let kept = final_energy(&scene, &trace) / scene.initial_energy();
        // one sweep of restitution over five balls in a row
        assert!((0.43..0.95).contains(&kept), "{engine}: energy {kept}");
    }
}

#[test]
fn a_fast_ball_passes_through_another_unless_it_alone_is_a_bullet() {
    // it moves 21 R in a step
    let scene = cut_shot(20.0, 300.0, 7.3).duration(0.1).build();
    for (engine, _) in BOTH {
        for (ccd, hits) in [
            ("off", 0),
            ("fixed", 0),
            ("all", 0),
            ("cue", 1),
            ("auto", 1),
        ] {
            let settings = ["dt=0.016666666666666666", &format!("ccd={ccd}")];
            let trace = run(engine, &settings, &scene, Record::Events);
            assert_eq!(trace.collisions().count(), hits, "{engine}, ccd={ccd}");
        }
    }
}

#[test]
fn soft_ccd_catches_a_hit_and_turns_its_direction() {
    let scene = cut_shot(40.0, 100.0, 7.3).duration(0.2).build();
    for (engine, _) in BOTH {
        let settings = [
            "dt=0.016666666666666666",
            "ccd=off",
            "soft_ccd_prediction=10",
        ];
        let trace = run(engine, &settings, &scene, Record::Events);
        assert_eq!(trace.collisions().count(), 1, "{engine}");
        let v = final_velocity(&trace, 1);
        let off = v.y.atan2(v.x).to_degrees() - 40.0;
        assert!(
            off.abs() > 5.0,
            "{engine}: the direction is off by {off} degrees only"
        );
    }
}

#[test]
fn an_impact_is_reported_when_a_velocity_changes_and_not_when_rapier_sees_a_contact() {
    for (engine, _) in BOTH {
        for prediction in ["prediction_distance=0.02", "prediction_distance=2"] {
            let scene = cut_shot(0.0, 2.0, 1.0).duration(1.0).build();
            let trace = run(engine, &[prediction], &scene, Record::Events);
            let time = trace.events[0].time;
            // the hit is at 0.5; found with the first substep that could reach it
            assert!(
                (0.5 - 0.25e-3 - 1e-4..0.5 + 1e-3 + 1e-4).contains(&time),
                "{engine}, {prediction}: at {time}"
            );
        }
    }
    // the same two balls in rapier itself: contact is on while velocities are what they were
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    world.integration_parameters.dt = 1e-3;
    world.integration_parameters.normalized_prediction_distance = 2.0;
    let ball = |x: f64, v: f64| {
        let body = RigidBodyBuilder::dynamic().translation(Vector::new(x, 0.0, 0.0));
        let collider = ColliderBuilder::ball(R).friction(0.0).restitution(1.0);
        (body.linvel(Vector::new(v, 0.0, 0.0)), collider)
    };
    let (body, collider) = ball(-2.0 * R - 1.0, 2.0);
    let (cue, cue_shape) = world.insert(body, collider);
    let (body, collider) = ball(0.0, 0.0);
    let (_, object_shape) = world.insert(body, collider);
    for _ in 0..10 {
        world.step();
    }
    let pair = world.narrow_phase.contact_pair(cue_shape, object_shape);
    assert!(
        pair.unwrap().has_any_active_contact(),
        "rapier sees no contact yet"
    );
    assert_eq!(
        world.bodies[cue].linvel().x,
        2.0,
        "but nothing has happened"
    );
}

#[test]
fn sleep_stops_a_slow_ball_early() {
    for (engine, _) in BOTH {
        let scene = scenario("slow")
            .shot("cue", [0.0, 0.0], 0.04, 0.0)
            .cloth(4e-4)
            .build();
        let distance = 0.04 * 0.04 / (2.0 * 4e-4 * G);
        let moved = |settings: &[&str]| {
            let trace = run(engine, settings, &scene, Record::Final);
            trace.final_states()[0].unwrap().position.x
        };
        let (awake, asleep) = (moved(&[]), moved(&["can_sleep=true"]));
        assert!(
            (awake - distance).abs() < 2e-2 * distance,
            "{engine}: {awake} of {distance}"
        );
        assert!(asleep < 0.6 * distance, "{engine}: {asleep} of {distance}");
    }
}

#[test]
fn the_speed_cap_is_silent_and_scales_with_the_length_unit() {
    for (engine, tolerance) in BOTH {
        let scene = scenario("fast")
            .shot("cue", [0.0, 0.0], 1000.0, 0.0)
            .duration(0.1)
            .build();
        let cases = [
            (&["preset=stock"][..], 400.0),
            (&["preset=stock", "length_unit=2"], 800.0),
            (&[], 1000.0),
        ];
        for (settings, expected) in cases {
            let trace = run(engine, settings, &scene, Record::Events);
            let got = final_velocity(&trace, 0).x;
            assert!(
                (got - expected).abs() <= tolerance * expected,
                "{engine} {settings:?}: {got}, expected {expected}"
            );
            // no contact did it: that is counted
            let counted = trace.counters["unattributed"] > 0;
            assert_eq!(counted, expected < 1000.0, "{engine} {settings:?}");
        }
    }
}

#[test]
fn single_precision_gets_worse_with_a_step_below_a_thousandth() {
    let scene = scenario("slide")
        .shot("cue", [0.0, 0.0], 5.0, 37.0)
        .cloth(0.2)
        .build();
    let distance = 25.0 / (2.0 * 0.2 * G);
    let error = |dt: &str| {
        let trace = run("rapier-f32", &[dt, "substeps=1"], &scene, Record::Final);
        (trace.final_states()[0].unwrap().position.xy().norm() - distance).abs()
    };
    let (coarse, fine) = (error("dt=2e-3"), error("dt=5e-5"));
    assert!(fine > coarse, "error {coarse} at 2e-3 and {fine} at 5e-5");
}
