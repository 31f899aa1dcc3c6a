//! What every engine owes: it says what it cannot do, holds the scene, simulates nothing else, and always ends.

use super::{BOTH, cut_shot, final_velocity, rack};
use crate::support::{G, MU, R, run, scenario};
use carom::engine::{self, About, Engine, Knob, Limits, Name, Pace, Refusal, Role, Run, Setting};
use carom::math::Vec3;
use carom::physics::invariants::Invariant;
use carom::scene::Scene;
use carom::trace::{Ending, EventKind, Record};
use proptest::prelude::*;
use std::sync::atomic::AtomicBool;

/// What is changed in a scene, and how.
type Change = (&'static str, fn(&mut Scene));

#[test]
fn balls_of_unequal_radii_are_refused_only_where_they_can_meet() {
    let mut scene = cut_shot(0.0, 1.0, 1.0).build();
    scene.balls[1].radius = 0.5 * R;
    scene.balls[1].state.position.z = 0.5 * R;
    for (id, _) in BOTH {
        let engine = crate::support::find(id).unwrap();
        let missing = engine.missing(&scene);
        assert!(
            missing.len() == 1 && missing[0].contains("unequal radii"),
            "{id}: {missing:?}"
        );
        let refused = engine::prepare(engine.as_ref(), &scene, &Setting::default());
        assert!(
            matches!(refused, Err(Refusal::NotComparable { .. })),
            "{id}"
        );
        let mut apart = scene.clone();
        apart.effects.contact = None;
        assert!(
            engine::prepare(engine.as_ref(), &apart, &Setting::default()).is_ok(),
            "{id}"
        );
    }
}

#[test]
fn numbers_that_its_arithmetic_cannot_hold_are_refused() {
    let changes: [Change; 4] = [
        ("mass", |s| s.balls[0].mass = 1e-60),
        ("speed", |s| s.balls[0].state.velocity.x = 1e60),
        ("place", |s| s.balls[0].state.position.x = -1e60),
        ("gravity", |s| s.gravity = 1e60),
    ];
    for (what, change) in changes {
        let mut scene = cut_shot(0.0, 1.0, 1.0).cloth(MU).build();
        change(&mut scene);
        let single = crate::support::find("rapier-f32").unwrap();
        assert!(!single.missing(&scene).is_empty(), "{what} fits into f32");
        let double = crate::support::find("rapier-f64").unwrap();
        assert!(
            double.missing(&scene).is_empty(),
            "{what} does not fit into f64"
        );
    }
}

#[test]
fn what_is_absent_is_not_simulated() {
    for (engine, tolerance) in BOTH {
        // no cloth: nothing slows the ball and nothing moves it off the plane
        let scene = scenario("free")
            .shot("cue", [0.0, 0.0], 3.0, 20.0)
            .duration(2.0)
            .build();
        let trace = run(engine, &[], &scene, Record::Events);
        let state = trace.final_states()[0].unwrap();
        assert!(
            (state.speed() - 3.0).abs() <= tolerance * 3.0,
            "{engine}: {state:?}"
        );
        assert_eq!(state.position.z, R, "{engine}");
        assert_eq!(trace.ending, Ending::Duration, "{engine}");
        assert_eq!(trace.end_time, 2.0, "{engine}");
        assert_eq!(trace.stop_times, [None], "{engine}");

        // no contact: balls pass through each other
        let mut scene = cut_shot(20.0, 3.0, 0.5).duration(1.0).build();
        scene.effects.contact = None;
        let trace = run(engine, &[], &scene, Record::Events);
        assert_eq!(trace.events, [], "{engine}");
        assert_eq!(final_velocity(&trace, 1), Vec3::zeros(), "{engine}");

        // no cushion: the ball leaves the table
        let mut scene = scenario("open")
            .shot("cue", [1.0, 1.0], 3.0, 0.0)
            .cushions(2.0, 2.0)
            .duration(1.0)
            .build();
        scene.effects.cushion = None;
        let trace = run(engine, &[], &scene, Record::Events);
        assert_eq!(trace.events, [], "{engine}");
        assert!(
            trace.final_states()[0].unwrap().position.x > 3.9,
            "{engine}"
        );
    }
}

#[test]
fn a_run_ends_at_rest_or_at_its_duration_or_when_cancelled() {
    for (id, _) in BOTH {
        let stop = 2.0 / (MU * G);
        let slide = scenario("slide")
            .shot("cue", [0.0, 0.0], 2.0, 0.0)
            .cloth(MU);
        let mut scene = slide.duration(3.0).build();
        let rest = run(id, &[], &scene, Record::Events);
        assert_eq!(rest.ending, Ending::Rest, "{id}");
        assert!(rest.end_time < stop + 2e-3, "{id}: {}", rest.end_time);
        assert_eq!(Some(rest.end_time), rest.stop_times[0], "{id}");

        scene.run_to_duration = true;
        let whole = run(id, &[], &scene, Record::Events);
        assert_eq!(
            (whole.ending, whole.end_time),
            (Ending::Duration, 3.0),
            "{id}"
        );
        assert_eq!(whole.stop_times, rest.stop_times, "{id}");
        assert_eq!(whole.events, rest.events, "{id}");

        // a duration that the step does not divide ends where the scene says
        scene.duration = 0.12345;
        let short = run(id, &[], &scene, Record::Events);
        assert_eq!(
            (short.ending, short.end_time),
            (Ending::Duration, 0.12345),
            "{id}"
        );
        assert_eq!(short.stop_times, [None], "{id}");

        let nobody = scenario("still")
            .resting("cue", [0.0, 0.0])
            .cloth(MU)
            .build();
        let still = run(id, &[], &nobody, Record::Events);
        assert_eq!((still.ending, still.end_time), (Ending::Rest, 0.0), "{id}");
        assert_eq!(still.stop_times, [Some(0.0)], "{id}");

        let cancelled = AtomicBool::new(true);
        let limits = Limits {
            max_events: 1000,
            cancelled: &cancelled,
        };
        let engine = crate::support::find(id).unwrap();
        let run = engine::prepare(engine.as_ref(), &scene, &Setting::default()).unwrap();
        let trace = run.simulate(Record::Events, &limits);
        assert_eq!(
            (trace.ending, trace.end_time),
            (Ending::Cancelled, 0.0),
            "{id}"
        );
    }
}

#[test]
fn a_ball_that_is_stopped_by_an_impact_has_its_stop_after_it() {
    for (engine, _) in BOTH {
        let scene = cut_shot(0.0, 3.0, 0.3).cloth(MU).duration(5.0).build();
        let trace = run(engine, &[], &scene, Record::Events);
        let kinds: Vec<EventKind> = trace.events.iter().map(|event| event.kind).collect();
        assert_eq!(kinds[0], EventKind::BallBall(0, 1), "{engine}");
        assert!(kinds.contains(&EventKind::Stop(0)), "{engine}: {kinds:?}");
        assert_eq!(
            *kinds.last().unwrap(),
            EventKind::Stop(1),
            "{engine}: {kinds:?}"
        );
        let stop = trace
            .events
            .iter()
            .find(|e| e.kind == EventKind::Stop(0))
            .unwrap();
        // friction in the step of the hit may leave a ball mu g dt to lose
        assert!(
            stop.time - trace.events[0].time <= 2e-3,
            "{engine}: {:?}",
            trace.events
        );
        assert_eq!(trace.stop_times[0], Some(stop.time), "{engine}");
    }
}

/// An engine that builds another scene than it is asked for.
struct Tampering {
    real: &'static dyn Engine,
    scene: &'static Scene,
}

impl Engine for Tampering {
    fn id(&self) -> &str {
        "tampering"
    }
    fn version(&self) -> String {
        self.real.version()
    }
    fn about(&self) -> About {
        self.real.about()
    }
    fn knobs(&self) -> Vec<Knob> {
        self.real.knobs()
    }
    fn missing(&self, _scene: &Scene) -> Vec<Name> {
        Vec::new()
    }
    fn promises(&self, scene: &Scene, setting: &Setting) -> Vec<Invariant> {
        self.real.promises(scene, setting)
    }
    fn ladders(&self) -> Vec<(Name, Vec<Setting>)> {
        Vec::new()
    }
    fn pace(&self, scene: &Scene, setting: &Setting) -> Result<Pace, Refusal> {
        self.real.pace(scene, setting)
    }

    fn ablations(&self, _scene: &Scene, _setting: &Setting) -> Vec<(Name, Setting)> {
        Vec::new()
    }
    fn prepare<'a>(&self, _: &'a Scene, setting: &Setting) -> Result<Box<dyn Run + 'a>, Refusal> {
        self.real.prepare(self.scene, setting)
    }
}

#[test]
fn a_scene_that_did_not_arrive_is_refused_by_the_audit() {
    let scene = cut_shot(20.0, 3.0, 0.5)
        .cloth(MU)
        .cushions(9.0, 9.0)
        .build();
    let changes: [Change; 8] = [
        ("mass of ball 1", |s| s.balls[1].mass *= 1.00001),
        ("radius of ball cue", |s| s.balls[0].radius *= 0.99999),
        ("position x of ball 1", |s| {
            s.balls[1].state.position.x += 1e-4
        }),
        ("velocity y of ball cue", |s| {
            s.balls[0].state.velocity.y = 1e-5
        }),
        ("kinetic energy", |s| s.balls[0].state.velocity.x *= 1.00001),
        ("no material of ball cue with a Cloth", |s| {
            s.effects.cloth = None
        }),
        ("no material of ball 1 with a Ball", |s| {
            s.effects.contact = None
        }),
        ("no material of ball 1 with a Cushion", |s| {
            s.effects.cushion = None
        }),
    ];
    for (id, _) in BOTH {
        let real = crate::support::find(id).unwrap();
        assert!(
            engine::prepare(real.as_ref(), &scene, &Setting::default()).is_ok(),
            "{id}"
        );
        for (what, change) in changes {
            let mut other = scene.clone();
            change(&mut other);
            let tampering = Tampering {
                real: real.as_ref(),
                scene: Box::leak(Box::new(other)),
            };
            let Err(Refusal::Audit { differs }) =
                engine::prepare(&tampering, &scene, &Setting::default())
            else {
                panic!("{id}: {what} passes the audit");
            };
            let says = differs.iter().any(|line| line.contains(what));
            assert!(says, "{id}: {what} is not in {differs:?}");
        }
    }
}

#[test]
fn the_sheet_names_every_role_and_reads_its_values_from_inside() {
    let scene = cut_shot(20.0, 3.0, 0.5)
        .cloth(MU)
        .cushions(9.0, 9.0)
        .build();
    for (id, _) in BOTH {
        let engine = crate::support::find(id).unwrap();
        let run = engine::prepare(engine.as_ref(), &scene, &Setting::default()).unwrap();
        let sheet = run.sheet();
        for role in Role::ALL {
            assert!(
                sheet.iter().any(|row| row.role == role),
                "{id}: no {}",
                role.title()
            );
        }
        let number = |role: Role| {
            let row = sheet.iter().find(|row| row.role == role).unwrap();
            row.value.parse::<f64>().unwrap()
        };
        for (role, expected) in [
            (Role::ClothFriction, MU),
            (Role::Gravity, G),
            (Role::Mass, 0.107),
            (Role::Radius, R),
            (Role::BallRestitution, 1.0),
            (Role::BallFriction, 0.0),
            (Role::CushionRestitution, 1.0),
            (Role::CushionFriction, 0.0),
        ] {
            let got = number(role);
            // f32 rounds by 6e-8 at most, an inverse mass twice more
            assert!(
                (got - expected).abs() <= 2e-7 * expected,
                "{id}, {}: {got}",
                role.title()
            );
        }
        let rotation = sheet.iter().find(|row| row.role == Role::Rotation).unwrap();
        assert_eq!(rotation.value, "ROTATION_LOCKED", "{id}");
    }
}

#[test]
fn momentum_is_promised_unless_balls_may_sleep() {
    let cue = scenario("break").moving("cue", [0.05, -1.0], [0.0, 10.0]);
    let scene = rack(cue, [0.0, 0.0], 3, 1e-3)
        .cloth(MU)
        .duration(1.0)
        .build();
    let p0 = 0.107 * 10.0;
    for (id, tolerance) in BOTH {
        let engine = crate::support::find(id).unwrap();
        for settings in [
            &[][..],
            &["dt=0.016666666666666666"],
            &["preset=stock", "can_sleep=false"],
        ] {
            let setting = Setting::parse(settings.iter().copied()).unwrap();
            let promised = engine.promises(&scene, &setting);
            assert!(promised.contains(&Invariant::Momentum), "{id} {settings:?}");
            let trace = run(id, settings, &scene, Record::Final);
            let lost = trace.extrema.momentum.value / p0;
            assert!(
                lost <= tolerance,
                "{id} {settings:?}: momentum off by {lost}"
            );
        }
        let setting = Setting::parse(["preset=stock"]).unwrap();
        assert!(
            !engine
                .promises(&scene, &setting)
                .contains(&Invariant::Momentum),
            "{id}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_scene_and_step_ends_with_numbers(
        speed in prop_oneof![Just(0.0), 1e-6..1e6f64, 0.1..50.0f64],
        angle in 0.0..360.0f64,
        gap in prop_oneof![Just(0.0), 0.0..1.0f64],
        mass in prop_oneof![Just(0.107), 1e-6..1e6f64],
        dt in prop_oneof![Just(1e-3), 1e-6..1.0f64, Just(100.0)],
        (cloth, cushions, stock) in any::<(bool, bool, bool)>(),
    ) {
        let (sine, cosine) = angle.to_radians().sin_cos();
        let mut made = scenario("any")
            .shot("cue", [3.0, 3.0], speed, angle)
            .resting("1", [3.0 + (2.0 * R + gap) * cosine, 3.0 + (2.0 * R + gap) * sine])
            .with_mass(mass)
            .resting("2", [R, R]);
        if cloth {
            made = made.cloth(MU);
        }
        if cushions {
            made = made.cushions(6.0, 6.0);
        }
        let scene = made.duration(200.0 * dt).build();
        let preset = if stock { "preset=stock" } else { "preset=converging" };
        for (engine, _) in BOTH {
            let trace = run(engine, &[preset, &format!("dt={dt}")], &scene, Record::Every(10.0 * dt));
            prop_assert!(trace.ending.is_complete(), "{}: {:?}", engine, trace.ending);
            let finite = trace.paths.iter().flat_map(|path| &path.knots).all(|knot| {
                (knot.state.position + knot.state.velocity).iter().all(|x| x.is_finite())
            });
            prop_assert!(finite, "{engine}");
        }
    }
}
