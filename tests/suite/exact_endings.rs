//! Every way in which a run of `exact` can end, and what it says then.

use crate::random::{Draw, random_scene};
use crate::support::{G, MU, R, Scenario, run, scenario};
use carom::engine::{self, Limits, Setting};
use carom::physics::Side;
use carom::scene::Scene;
use carom::trace::{Ending, EventKind, Record, Trace};
use std::sync::atomic::AtomicBool;

const EXACT: &str = "exact";

fn exact(scene: &Scene) -> Trace {
    run(EXACT, &[], scene, Record::Events)
}

fn with_limits(scene: &Scene, limits: &Limits<'_>) -> Trace {
    let engine = crate::support::find(EXACT).unwrap();
    let run = engine::prepare(engine.as_ref(), scene, &Setting::default()).unwrap();
    run.simulate(Record::Events, limits)
}

fn kinds(trace: &Trace) -> Vec<EventKind> {
    trace.events.iter().map(|event| event.kind).collect()
}

fn busy() -> Scene {
    random_scene(
        5,
        Draw {
            balls: 6,
            moving: 6,
            mu: 0.0,
            duration: 50.0,
            unequal: false,
        },
    )
}

#[test]
fn a_scene_at_rest_ends_at_once() {
    let mut scene = scenario("still").resting("a", [0.0, 0.0]).build();
    let trace = exact(&scene);
    assert_eq!((trace.ending, trace.end_time), (Ending::Rest, 0.0));
    assert_eq!(trace.stop_times, vec![Some(0.0)]);
    assert!(trace.events.is_empty());
    scene.run_to_duration = true;
    let trace = exact(&scene);
    assert_eq!((trace.ending, trace.end_time), (Ending::Duration, 20.0));
    assert_eq!(trace.stop_times, vec![Some(0.0)]);
}

#[test]
fn a_run_ends_with_the_last_stop_unless_it_runs_to_its_duration() {
    let mut scene = scenario("slide")
        .cloth(MU)
        .moving("a", [0.0, 0.0], [1.0, 0.0])
        .build();
    let trace = exact(&scene);
    let stop = 1.0 / (MU * G);
    assert_eq!(trace.ending, Ending::Rest);
    assert_eq!(kinds(&trace), vec![EventKind::Stop(0)]);
    assert!((trace.end_time - stop).abs() <= 4.0 * f64::EPSILON * stop);
    scene.run_to_duration = true;
    let longer = exact(&scene);
    assert_eq!((longer.ending, longer.end_time), (Ending::Duration, 20.0));
    assert_eq!(longer.stop_times, trace.stop_times);
    scene.duration = 0.25;
    let shorter = exact(&scene);
    assert_eq!((shorter.ending, shorter.end_time), (Ending::Duration, 0.25));
    assert_eq!(shorter.stop_times, vec![None]);
}

#[test]
fn the_event_limit_and_the_user_end_a_run_and_keep_its_trace() {
    let scene = busy();
    let whole = exact(&scene);
    assert!(whole.events.len() > 20, "{} events", whole.events.len());
    let limits = Limits {
        max_events: 7,
        ..Limits::NONE
    };
    let trace = with_limits(&scene, &limits);
    let Ending::Budget(spot) = &trace.ending else {
        panic!("{:?}", trace.ending);
    };
    let (next, other) = whole.events[7].kind.balls();
    let balls: Vec<usize> = spot.balls.iter().map(|ball| *ball as usize).collect();
    assert!(balls.contains(&next) && other.is_none_or(|ball| balls.contains(&ball)));
    assert!(spot.why.contains("7 events") && spot.time == trace.end_time);
    assert_eq!(trace.events, whole.events[..7]);
    assert_eq!(trace.end_time, whole.events[6].time);
    let cancelled = AtomicBool::new(true);
    let limits = Limits {
        cancelled: &cancelled,
        ..Limits::NONE
    };
    let trace = with_limits(&scene, &limits);
    assert_eq!(trace.ending, Ending::Cancelled);
    assert!(trace.events.is_empty());
    assert_eq!(trace.paths.len(), scene.balls.len());
}

#[test]
fn a_head_on_hit_stops_the_cue_ball_at_the_same_time() {
    // along an axis, and off the axes where rounding leaves something of the velocity
    for (x, y) in [(1.0, 0.0), (0.6, 0.8), (0.28, -0.96)] {
        let scene = scenario("head-on")
            .cloth(MU)
            .moving("cue", [0.0, 0.0], [4.0 * x, 4.0 * y])
            .resting("object", [1.5 * x, 1.5 * y])
            .build();
        let trace = exact(&scene);
        let expected = [
            EventKind::BallBall(0, 1),
            EventKind::Stop(0),
            EventKind::Stop(1),
        ];
        assert_eq!(kinds(&trace), expected, "along ({x}, {y})");
        assert_eq!(trace.events[0].time, trace.events[1].time);
        assert_eq!(trace.stop_times[0], Some(trace.events[0].time));
        assert_eq!(trace.ending, Ending::Rest);
    }
}

fn line(balls: usize, gap: f64) -> Scenario {
    let spacing = 2.0 * R + gap;
    (0..balls).fold(scenario("line").cloth(MU), |line, i| {
        line.resting(&i.to_string(), [0.0, spacing * i as f64])
    })
}

#[test]
fn a_cradle_passes_the_motion_to_its_last_ball() {
    // each impact leaves one ball approaching one other: one order only
    for balls in 2..6 {
        let scene = line(balls, 0.0)
            .moving("cue", [0.0, -2.0], [0.0, 5.0])
            .build();
        let trace = exact(&scene);
        assert_eq!(trace.ending, Ending::Rest, "{balls} balls");
        let moved =
            |i: usize| trace.paths[i].last().unwrap().position - scene.balls[i].state.position;
        for i in 0..balls - 1 {
            assert_eq!(moved(i).norm(), 0.0, "{balls} balls: ball {i} moved");
        }
        assert!(
            moved(balls - 1).norm() > 1.0,
            "{balls} balls: the last one stays"
        );
        assert_eq!(trace.collisions().count(), balls);
        assert_eq!(
            trace.collisions().last().unwrap().time,
            trace.events[0].time
        );
    }
}

#[test]
fn two_balls_into_a_cradle_send_two_out_whatever_the_order() {
    // the second ball of the pair closes in while the first passes the motion on: two impacts at one instant, both orders agree
    let scene = line(3, 0.0)
        .moving("front", [0.0, -2.0], [0.0, 5.0])
        .moving("back", [0.0, -2.0 - 2.0 * R], [0.0, 5.0])
        .build();
    let trace = exact(&scene);
    assert_eq!(trace.ending, Ending::Rest, "{:?}", trace.ending);
    let moved: Vec<bool> = (0..5)
        .map(|i| trace.paths[i].last().unwrap().position.y - scene.balls[i].state.position.y > 0.1)
        .collect();
    // the two that came in stop where the line began, having moved up to it
    assert_eq!(moved, [false, true, true, true, true]);
}

#[test]
fn a_ball_into_two_touching_ones_has_no_single_answer() {
    let half = R;
    let height = 3.0_f64.sqrt() * R;
    for gap in [0.0, 0.05] {
        let scene = scenario("triple")
            .cloth(MU)
            .moving("cue", [0.0, -height - 2.0], [0.0, 5.0])
            .resting("left", [-half - gap, 0.0])
            .resting("right", [half + gap, 0.0])
            .build();
        let trace = exact(&scene);
        let Ending::Indeterminate(spot) = &trace.ending else {
            panic!("gap {gap}: {:?}", trace.ending);
        };
        assert_eq!(spot.balls, [0, 1, 2], "gap {gap}");
        // neither impact is recorded: which came first is what cannot be said
        assert!(trace.events.is_empty(), "gap {gap}: {:?}", trace.events);
        assert!(spot.time > 0.0 && spot.time == trace.end_time);
        assert!(trace.paths[0].last().unwrap().velocity.y > 0.0);
    }
}

#[test]
fn the_apex_of_a_touching_rack_is_indeterminate_after_a_certain_impact() {
    let row = 3.0_f64.sqrt() * R;
    let scene = scenario("rack")
        .cloth(MU)
        .moving("cue", [0.01, -2.0], [0.0, 5.0])
        .resting("1", [0.0, 0.0])
        .resting("2", [-R, row])
        .resting("3", [R, row])
        .build();
    let trace = exact(&scene);
    let Ending::Indeterminate(spot) = &trace.ending else {
        panic!("{:?}", trace.ending);
    };
    assert_eq!(spot.balls, [0, 1, 2, 3]);
    // the impact on the apex itself is beyond doubt
    assert_eq!(kinds(&trace), vec![EventKind::BallBall(0, 1)]);
    assert_eq!(trace.end_time, trace.events[0].time);
}

#[test]
fn contacts_at_right_angles_may_come_in_any_order() {
    // the cue ball meets two balls at one instant, along x and along y: the impulses do not see each other
    let scene = scenario("right-angle")
        .cloth(MU)
        .moving("cue", [0.0, 0.0], [3.0, 3.0])
        .resting("right", [1.0 + 2.0 * R, 1.0])
        .resting("above", [1.0, 1.0 + 2.0 * R])
        .build();
    let trace = exact(&scene);
    assert_eq!(trace.ending, Ending::Rest, "{:?}", trace.ending);
    let hits: Vec<EventKind> = trace.collisions().map(|event| event.kind).collect();
    assert_eq!(hits, [EventKind::BallBall(0, 1), EventKind::BallBall(0, 2)]);
}

#[test]
fn a_corner_is_two_cushion_events_x_before_y() {
    let scene = scenario("corner")
        .cushions(4.0, 4.0)
        .moving("a", [2.0, 2.0], [1.0, 1.0])
        .duration(3.0)
        .build();
    let trace = exact(&scene);
    let expected = [Side::X1, Side::Y1].map(|side| EventKind::BallCushion(0, side));
    assert_eq!(kinds(&trace), expected);
    assert_eq!(trace.events[0].time, trace.events[1].time);
    assert_eq!(trace.ending, Ending::Duration);
}

#[test]
fn a_ball_frozen_to_a_cushion_and_to_a_neighbour_is_indeterminate_when_driven_into_both() {
    // ball 1 touches the cushion at x = 4 and ball 2 above it; the hit drives it into both, and they are not at right angles
    let direction = [0.5, 0.75_f64.sqrt()];
    let (x, y) = (4.0 - R, 2.0);
    let scene = scenario("frozen")
        .cushions(4.0, 8.0)
        .cloth(MU)
        .moving("cue", [x - 1.5, y - 1.0], [3.0, 2.0])
        .resting("1", [x, y])
        .resting(
            "2",
            [x - 2.0 * R * direction[0], y + 2.0 * R * direction[1]],
        )
        .build();
    let trace = exact(&scene);
    let Ending::Indeterminate(spot) = &trace.ending else {
        panic!("{:?} after {:?}", trace.ending, trace.events);
    };
    assert!(
        spot.balls.contains(&1) && spot.balls.contains(&2),
        "{spot:?}"
    );
}

#[test]
fn a_graze_at_rounding_level_is_undecidable_and_one_beside_it_is_not() {
    // the cue ball passes at a distance of 2R (1 - depth)
    for (depth, hits) in [(0.0, None), (1e-13, Some(1)), (-1e-13, Some(0))] {
        let scene = scenario("graze")
            .cloth(MU)
            .moving("cue", [2.0 * R * (1.0 - depth), -3.0], [0.0, 5.0])
            .resting("object", [0.0, 0.0])
            .build();
        let trace = exact(&scene);
        match hits {
            None => {
                let Ending::Undecidable(spot) = &trace.ending else {
                    panic!("depth {depth:e}: {:?}", trace.ending);
                };
                assert_eq!(spot.balls, [0, 1]);
                assert!(trace.events.is_empty());
            }
            Some(count) => {
                assert_eq!(trace.ending, Ending::Rest, "depth {depth:e}");
                assert_eq!(trace.collisions().count(), count, "depth {depth:e}");
            }
        }
    }
}

#[test]
fn a_stop_at_rounding_distance_from_another_ball_is_undecidable() {
    // it slides v^2 / (2 mu g) and would stop in contact
    let reach = 2.0 * 2.0 / (2.0 * MU * G);
    for (short, decided) in [(0.0, false), (1e-9, true), (-1e-9, true)] {
        let scene = scenario("stop")
            .cloth(MU)
            .moving("cue", [0.0, 0.0], [2.0, 0.0])
            .resting("object", [2.0 * R + reach + short, 0.0])
            .build();
        let trace = exact(&scene);
        assert_eq!(
            trace.ending == Ending::Rest,
            decided,
            "short by {short:e}: {:?}",
            trace.ending
        );
        if decided {
            let hits = usize::from(short < 0.0);
            assert_eq!(trace.collisions().count(), hits, "short by {short:e}");
        } else {
            assert!(
                matches!(trace.ending, Ending::Undecidable(_)),
                "{:?}",
                trace.ending
            );
        }
    }
}

/// How a run with residual speeds must end.
enum Due {
    /// One contact of these two parties, at this time, s, good to this part of it.
    Contact(EventKind, f64, f64),
    /// At rest without one.
    Rest,
    /// The scalar cannot hold the squares of its speeds.
    NotFinite,
    /// The scalar cannot tell.
    Undecidable,
}

fn holds(name: &str, scene: &Scene, due: &Due) {
    let trace = exact(scene);
    let met: Vec<_> = trace.collisions().collect();
    let found = format!(
        "{name}: {:?}, {met:?}, until {}",
        trace.ending, trace.end_time
    );
    match *due {
        Due::Contact(kind, time, part) => {
            assert!(trace.ending.is_complete(), "{found}");
            assert_eq!(met.len(), 1, "{found}");
            assert_eq!(met[0].kind, kind, "{found}");
            assert!(
                (met[0].time - time).abs() <= part * time,
                "{found}, expected {time}"
            );
        }
        Due::Rest => assert!(trace.ending == Ending::Rest && met.is_empty(), "{found}"),
        Due::NotFinite => assert!(matches!(trace.ending, Ending::NotFinite(_)), "{found}"),
        Due::Undecidable => assert!(matches!(trace.ending, Ending::Undecidable(_)), "{found}"),
    }
}

#[test]
fn residual_speeds_down_to_1e_300_end_in_the_right_contact_or_with_a_reason() {
    let gap = 0.5;
    for power in [
        8, 16, 32, 64, 100, 120, 140, 145, 150, 155, 160, 162, 200, 250, 300,
    ] {
        let speed = 10.0_f64.powi(-power);
        let until = 3.0 * gap / speed;
        // an ulp of the square of a speed is a number down to 1e-146 = sqrt(2e-308 / 2e-16)
        let due = |kind| match power {
            ..=145 => Due::Contact(kind, gap / speed, 16.0 * f64::EPSILON),
            _ => Due::NotFinite,
        };
        let toward_a_ball = scenario("ball")
            .moving("slow", [0.0, 0.0], [speed, 0.0])
            .resting("still", [2.0 * R + gap, 0.0])
            .duration(until)
            .build();
        let name = format!("speed 1e-{power}, free");
        holds(&name, &toward_a_ball, &due(EventKind::BallBall(0, 1)));
        let toward_a_cushion = scenario("cushion")
            .cushions(4.0, 4.0)
            .moving("slow", [4.0 - R - gap, 2.0], [speed, 0.0])
            .duration(until)
            .build();
        let kind = EventKind::BallCushion(0, Side::X1);
        holds(&name, &toward_a_cushion, &due(kind));
        // with cloth it stops before it has gone anywhere, also where its square is 0 and the engine holds it at rest
        let mut on_cloth = toward_a_ball.clone();
        (on_cloth.effects.cloth, on_cloth.duration) =
            (Some(carom::physics::Cloth::Translational { mu: MU }), 20.0);
        holds(&format!("{name}, on cloth"), &on_cloth, &Due::Rest);
    }
}

#[test]
fn what_is_left_of_the_speed_at_a_contact_is_decided_down_to_the_blur() {
    // it arrives with this speed: it would have gone speed^2 / (2 mu g) further
    let way = 1.0;
    for power in 1..=12 {
        let left = 10.0_f64.powi(-power);
        let scene = scenario("late")
            .cloth(MU)
            .moving(
                "cue",
                [0.0, 0.0],
                [(left * left + 2.0 * MU * G * way).sqrt(), 0.0],
            )
            .resting("object", [2.0 * R + way, 0.0])
            .build();
        let further = left * left / (2.0 * MU * G);
        // four ulp of the largest coordinate and of the longest way, and as much for the numbers of the scene
        let blur = 4.0 * f64::EPSILON * (2.0 * R + 2.0 * way);
        let time = (scene.balls[0].state.velocity.x - left) / (MU * G);
        let due = if further > 3.0 * blur {
            // the time moves by the blur over the speed that is left
            Due::Contact(EventKind::BallBall(0, 1), time, 2.0 * blur / (left * time))
        } else {
            Due::Undecidable
        };
        holds(&format!("{left:e} left"), &scene, &due);
    }
}

#[test]
fn a_ball_that_is_hardly_faster_than_the_one_ahead_catches_up_or_it_cannot_be_told() {
    let gap = 1e-3;
    for power in 3..=16 {
        let faster = 1.0 + 10.0_f64.powi(-power);
        let (closing, distance) = (faster - 1.0, 2.0 * R + gap);
        let scene = scenario("catch-up")
            .moving("behind", [0.0, 0.0], [faster, 0.0])
            .moving("ahead", [distance, 0.0], [1.0, 0.0])
            .duration(if closing > 0.0 {
                3.0 * gap / closing
            } else {
                10.0
            })
            .build();
        let trace = exact(&scene);
        let hits = trace.collisions().count();
        // both end where positions are good to this, and to this much of the gap
        let blur = 4.0 * f64::EPSILON * (distance + faster * scene.duration);
        let found = format!(
            "1e-{power}: {:?}, {hits} hits, {:?}",
            trace.ending, trace.events
        );
        if closing == 0.0 {
            assert!(trace.ending == Ending::Duration && hits == 0, "{found}");
        } else if gap > 4.0 * blur {
            let time = gap / closing;
            assert!(trace.ending == Ending::Duration && hits == 1, "{found}");
            assert!(
                (trace.events[0].time - time).abs() <= blur / closing,
                "{found}, expected {time}"
            );
        } else {
            assert!(trace.ending.spot().is_some() || hits <= 1, "{found}");
        }
    }
}

#[test]
fn a_stop_at_rounding_distance_from_a_cushion_is_undecidable() {
    let reach = 2.0 * 2.0 / (2.0 * MU * G);
    let scene = scenario("stop")
        .cushions(1.0 + R + reach, 4.0)
        .cloth(MU)
        .moving("cue", [1.0, 2.0], [2.0, 0.0])
        .build();
    let trace = exact(&scene);
    assert!(
        matches!(trace.ending, Ending::Undecidable(_)),
        "{:?}",
        trace.ending
    );
}

#[test]
fn a_light_ball_trapped_between_two_heavy_ones_collapses() {
    // masses M, m, M in contact on a line unfold to a wedge of angle acos(M / (M + m)), which a straight line crosses at most
    // ceil(pi / angle) times; all of that happens while no time passes
    let between = |light: f64| {
        scenario("trapped")
            .moving("hammer", [-1.0, 0.0], [1.0, 0.0])
            .with_mass(1.0)
            .resting("light", [0.0, 0.0])
            .with_mass(light)
            .resting("anvil", [2.0 * R, 0.0])
            .with_mass(1.0)
            .duration(5.0)
            .build()
    };
    let trace = exact(&between(1e-10));
    let Ending::Collapsed(spot) = &trace.ending else {
        panic!("{:?}", trace.ending);
    };
    assert!(spot.balls.contains(&1), "{spot:?}");
    assert!(trace.events.len() > 1000);
    // with a ratio of a hundred it is over after 22 or 23
    let trace = exact(&between(0.01));
    assert_eq!(trace.ending, Ending::Duration);
    let crossings = std::f64::consts::PI / (1.0_f64 / 1.01).acos();
    let hits = trace.collisions().count() as f64;
    assert!(
        hits >= crossings.floor() && hits <= crossings.ceil(),
        "{hits} impacts, expected {crossings}"
    );
}

#[test]
fn numbers_that_cannot_be_computed_with_end_the_run_before_it_starts() {
    for (speed, why) in [
        (1e200, "its square overflows"),
        (f64::NAN, "not a number"),
        (f64::INFINITY, "infinite"),
    ] {
        let mut scene = scenario("huge").cloth(MU).resting("a", [0.0, 0.0]).build();
        scene.balls[0].state.velocity.x = speed;
        // the audit refuses NaN and infinity, so ask the engine itself
        let engine = crate::support::find(EXACT).unwrap();
        let run = engine.prepare(&scene, &Setting::default()).unwrap();
        let trace = run.simulate(Record::Events, &Limits::NONE);
        let Ending::NotFinite(spot) = &trace.ending else {
            panic!("{why}: {:?}", trace.ending);
        };
        assert_eq!((spot.time, spot.balls.as_slice()), (0.0, &[0][..]), "{why}");
    }
}

#[test]
fn absent_effects_are_not_simulated() {
    let mut scene = scenario("ghosts")
        .moving("a", [1.0, 1.0], [1.0, 0.0])
        .resting("b", [2.0, 1.0])
        .cushions(3.0, 3.0)
        .duration(10.0)
        .build();
    scene.effects.contact = None;
    scene.effects.cushion = None;
    let trace = exact(&scene);
    assert!(trace.events.is_empty());
    assert_eq!(trace.paths[0].last().unwrap().position.x, 11.0);
}

#[test]
fn unknown_settings_are_refused() {
    let scene = scenario("still").resting("a", [0.0, 0.0]).build();
    let setting = Setting::parse(["precision=f128"]).unwrap();
    let engine = crate::support::find(EXACT).unwrap();
    let refusal = engine::prepare(engine.as_ref(), &scene, &setting)
        .err()
        .map(|r| r.to_string());
    assert!(
        refusal.as_deref().is_some_and(|r| r.contains("precision")),
        "{refusal:?}"
    );
}
