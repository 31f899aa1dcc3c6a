//! The stepper against a plain transcription of the report's program, to the bit: for few balls, and for so many that it looks at
//! those nearby only.

mod program;

use crate::support::{MU, R, report_break, run, scenario};
use carom::math::random::Draws;
use carom::physics::{Effects, Pockets};
use carom::scene::generate::{Recipe, generate};
use carom::scene::{Scene, parse};
use carom::trace::{Record, Trace};
use program::Program;

const RULES: [(&str, bool); 2] = [("as-written", false), ("approaching-only", true)];

/// Runs both and holds the stepper's final states against the transcription's. Answers the trace.
fn hold(case: &str, scene: &Scene, dt: f64, (contact, approaching_only): (&str, bool)) -> Trace {
    let case = format!("{case}, {} balls, dt {dt}, {contact}", scene.balls.len());
    let mut want = Program::new(scene, dt, approaching_only);
    want.run();
    let mut traces = ["auto", "all", "near"].map(|partners| {
        let settings = [
            format!("dt={dt}"),
            format!("contact={contact}"),
            format!("partners={partners}"),
        ];
        let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
        run("stepper", &settings, scene, Record::Events)
    });
    for trace in &mut traces {
        trace.provenance.parameters.clear();
    }
    let [got, all, near] = traces;
    for other in [&all, &near] {
        // unlike ==, the text tells one NaN from none and 0 from -0
        assert!(
            format!("{got:?}") == format!("{other:?}"),
            "{case}: traces of different searches differ"
        );
    }
    assert_eq!(got.counters["steps"], want.steps, "{case}: steps");
    assert_eq!(
        got.counters["exchanges"], want.exchanges,
        "{case}: exchanges"
    );
    for ball in want.balls.iter().chain(&want.pocketed) {
        let last = got.paths[ball.index].last().unwrap();
        for (what, got, want) in [
            ("x", last.position.x, ball.r[0]),
            ("y", last.position.y, ball.r[1]),
            ("vx", last.velocity.x, ball.v[0]),
            ("vy", last.velocity.y, ball.v[1]),
        ] {
            // the program brings a ball to rest by a product, which keeps a sign of zero that no later number depends on
            let equal = got.to_bits() == want.to_bits()
                || (got == 0.0 && want == 0.0)
                || (got.is_nan() && want.is_nan());
            let i = ball.index;
            assert!(equal, "{case}: {what} of ball {i} is {got:e}, not {want:e}");
        }
    }
    let left = got.final_states().iter().filter(|s| s.is_none()).count();
    assert_eq!(left, want.pocketed.len(), "{case}: pocketed balls");
    got
}

#[test]
fn stepper_equals_a_plain_transcription_of_the_report_to_the_bit() {
    for (gap, angle, dt, least_exchanges) in [
        (1e-2, 90.2, 1e-3, 10),
        (1e-3, 89.8, 1e-3, 10),
        // past the rack, and off the walls
        (1e-2, 75.0, 1e-2, 0),
        (0.0, 90.0, 1e-3, 10),
        (5e-2, 91.0, 1e-4, 5),
    ] {
        for rule in RULES {
            let scene = report_break(gap * R, angle);
            let trace = hold(&format!("gap {gap} R, aim {angle}"), &scene, dt, rule);
            assert!(
                trace.counters["exchanges"] >= least_exchanges,
                "{:?}",
                trace.counters
            );
        }
    }
}

/// Discs in a box, or on an unbounded plane.
struct Discs {
    balls: usize,
    density: f64,
    /// Root mean square speed, R/s.
    speed: f64,
    mu: Option<f64>,
    /// Radii are drawn between this part of R and R, in steps of a quarter of R.
    smallest: f64,
    bounded: bool,
}

impl Discs {
    fn scene(&self, steps: f64, dt: f64) -> Scene {
        let recipe = Recipe {
            balls: self.balls,
            density: self.density,
            speed: self.speed,
            mu: self.mu,
            seed: 4,
            ..Recipe::default()
        };
        let mut scene = parse("generated", &generate(&recipe).unwrap()).unwrap();
        scene.duration = steps * dt;
        for (i, ball) in scene.balls.iter_mut().enumerate() {
            let drawn = Draws::new(9, i as u64).between(self.smallest, 1.0);
            // sizes that occur more than once
            ball.radius *= (4.0 * drawn).ceil() / 4.0;
            ball.state.position.z = ball.radius;
        }
        if !self.bounded {
            scene.table = None;
            scene.effects.cushion = None;
        }
        scene
    }
}

#[test]
fn discs_by_the_hundred_equal_the_transcription_to_the_bit() {
    let plain = Discs {
        balls: 0,
        density: 0.5,
        speed: 2.0,
        mu: None,
        smallest: 1.0,
        bounded: true,
    };
    for (case, discs, dt, steps) in [
        (
            "sparse",
            Discs {
                density: 0.1,
                ..plain
            },
            1e-2,
            300.0,
        ),
        (
            "dense",
            Discs {
                density: 0.7,
                ..plain
            },
            1e-3,
            300.0,
        ),
        // a ball goes through several others in a step, and every list is used up in one
        (
            "very fast",
            Discs {
                speed: 300.0,
                ..plain
            },
            1e-2,
            100.0,
        ),
        // so fast that balls overlap at random: clusters
        (
            "clusters",
            Discs {
                density: 0.7,
                speed: 20.0,
                ..plain
            },
            1e-2,
            100.0,
        ),
        (
            "sliding",
            Discs {
                mu: Some(0.2),
                ..plain
            },
            1e-2,
            300.0,
        ),
        (
            "unequal",
            Discs {
                smallest: 0.2,
                density: 0.6,
                ..plain
            },
            1e-2,
            200.0,
        ),
        (
            "unbounded",
            Discs {
                bounded: false,
                speed: 20.0,
                ..plain
            },
            1e-2,
            200.0,
        ),
    ] {
        // below the crossover, above it, and ten times above it
        for balls in [12, 80, 320] {
            for rule in RULES {
                let discs = Discs { balls, ..discs };
                let trace = hold(case, &discs.scene(steps, dt), dt, rule);
                let least = if case == "sparse" || balls == 12 {
                    1
                } else {
                    20
                };
                assert!(
                    trace.counters["exchanges"] >= least,
                    "{case}, {balls} balls: {:?}",
                    trace.counters
                );
            }
        }
    }
}

#[test]
fn balls_far_outside_and_overflowing_ones_equal_the_transcription_to_the_bit() {
    let discs = Discs {
        balls: 200,
        density: 0.5,
        speed: 5.0,
        mu: None,
        smallest: 1.0,
        bounded: false,
    };
    for rule in RULES {
        for (case, position, velocity, dt, least_exchanges) in [
            (
                "a ball far outside that comes in",
                [-4e3, 10.0],
                [1e3, 0.0],
                1e-2,
                100,
            ),
            (
                "a ball that leaves for good",
                [1e9, -1e9],
                [1e9, 0.0],
                1e-2,
                100,
            ),
            (
                "a ball whose square overflows",
                [1e200, 0.0],
                [0.0, 0.0],
                1e-2,
                100,
            ),
        ] {
            let mut scene = discs.scene(500.0, dt);
            let ball = &mut scene.balls[17].state;
            (ball.position.x, ball.position.y) = (position[0], position[1]);
            (ball.velocity.x, ball.velocity.y) = (velocity[0], velocity[1]);
            let trace = hold(case, &scene, dt, rule);
            assert!(
                trace.counters["exchanges"] >= least_exchanges,
                "{case}: {:?}",
                trace.counters
            );
        }
    }
}

#[test]
fn the_ball_that_was_shot_comes_first_wherever_it_is_listed() {
    for rule in RULES {
        let mut scene = report_break(1e-3 * R, 90.2);
        let cue = scene.balls.remove(0);
        scene.balls.insert(9, cue);
        scene.shot = Some(carom::scene::Shot::Velocity {
            ball: 9,
            speed: scene.balls[9].state.speed(),
            angle_deg: 90.2,
        });
        assert_eq!(scene.cue_ball(), 9);
        hold("cue ball listed tenth", &scene, 1e-3, rule);
    }
}

#[test]
fn pocketed_balls_leave_the_search_and_the_order_of_the_others_alone() {
    let discs = Discs {
        balls: 150,
        density: 0.6,
        speed: 20.0,
        mu: Some(MU),
        smallest: 1.0,
        bounded: true,
    };
    for rule in RULES {
        for balls in [12, 150] {
            let mut scene = Discs { balls, ..discs }.scene(600.0, 5e-3);
            let [width, length] = scene.table.unwrap().max;
            let circles = [[0.0, 0.0], [width, 0.0], [0.4 * width, 0.5 * length]];
            scene.effects = Effects {
                pockets: Some(Pockets {
                    circles: circles.map(|[x, y]| [x, y, 3.0]).to_vec(),
                }),
                ..scene.effects
            };
            let trace = hold("pockets", &scene, 5e-3, rule);
            let fell = trace.final_states().iter().filter(|s| s.is_none()).count();
            assert!(fell >= balls / 10, "{fell} of {balls} balls fell");
        }
    }
}

#[test]
fn allocations_of_many_balls_do_not_depend_on_the_number_of_steps() {
    let stepper = crate::support::find("stepper").unwrap();
    let discs = Discs {
        balls: 500,
        density: 0.5,
        speed: 5.0,
        mu: None,
        smallest: 1.0,
        bounded: true,
    };
    let allocations = |steps: f64| {
        let dt = 1e-2;
        let scene = discs.scene(steps, dt);
        let setting = carom::engine::Setting::default().with("dt", dt);
        let run = carom::engine::prepare(stepper.as_ref(), &scene, &setting).unwrap();
        let count = allocation_counter::measure(|| {
            run.simulate(Record::Final, &carom::engine::Limits::NONE);
        });
        count.count_total
    };
    // lists are made anew some hundred times in the longer run; what they need was there before, but for a vector that grows
    let (short, long) = (allocations(100.0), allocations(4_000.0));
    assert!(
        long < short + 20,
        "{short} allocations in 100 steps, {long} in 4000"
    );
}

#[test]
fn two_balls_at_one_place_have_no_normal_and_are_left_alone() {
    for rule in RULES {
        let scene = scenario("one place")
            .moving("a", [1.0, 1.0], [0.5, 0.0])
            .moving("b", [1.0, 1.0], [-0.25, 0.0])
            .duration(0.01)
            .build();
        let trace = hold("one place", &scene, 1e-2, rule);
        assert_eq!(trace.counters["overlaps"], 1);
        assert_eq!(trace.counters["exchanges"], 0);
    }
}
