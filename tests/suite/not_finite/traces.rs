//! Traces with numbers that are none: which are read, and what a comparison says of them.

use carom::engine::{self, Limits, Setting};
use carom::finding::{Finding, Hold};
use carom::math::Vec3;
use carom::scene::{Scene, catalogue};
use carom::study::check::{between, tolerance};
use carom::trace::files::{self, Files};
use carom::trace::{Ending, Record, Spot, Trace};

fn run(scene: &Scene, engine: &str) -> Trace {
    let engine = crate::support::find(engine).unwrap();
    let run = engine::prepare(engine.as_ref(), scene, &Setting::default()).unwrap();
    run.simulate(Record::Every(0.1), &Limits::NONE)
}

#[test]
fn a_run_that_ended_because_a_state_was_no_number_is_read_and_no_other_is() {
    let scene = catalogue::scene("head-on").unwrap();
    let good = run(&scene, "stepper");
    for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let mut trace = good.clone();
        for knot in trace.paths[1].knots.iter_mut().rev().take(3) {
            knot.state.position.y = x;
        }
        let refused = files::read(&files::write(&trace).unwrap()).unwrap_err();
        let words = refused.to_string();
        assert!(words.starts_with("samples.csv:"), "{x}: {words}");
        assert!(words.contains("column `y`"), "{x}: {words}");
        assert!(words.contains("expected a finite number"), "{x}: {words}");
        trace.ending = Ending::NotFinite(Spot {
            time: trace.end_time,
            balls: vec![1],
            why: "a position or speed overflowed".into(),
        });
        let read = files::read(&files::write(&trace).unwrap()).unwrap();
        // a NaN is not equal to itself, and its text is
        assert_eq!(format!("{read:?}"), format!("{trace:?}"));
    }
}

#[test]
fn what_the_program_writes_of_a_run_that_overflowed_is_read_again() {
    // so far away that squares overflow, on a table that is no bound
    let mut scene = catalogue::scene("slide").unwrap();
    scene.balls[0].state.velocity = Vec3::new(1.0, 0.0, 0.0);
    scene.balls[0].state.position.x = 1e300;
    scene.shot = None;
    let mut seen = 0;
    for engine in crate::support::roster() {
        let Ok(run) = engine::prepare(engine.as_ref(), &scene, &Setting::default()) else {
            continue;
        };
        let trace = run.simulate(Record::Every(0.1), &Limits::NONE);
        let files = files::write(&trace).unwrap();
        let read = files::read(&files).unwrap_or_else(|e| panic!("{}: {e}", engine.id()));
        assert_eq!(files::write(&read).unwrap(), files, "{}", engine.id());
        seen += usize::from(matches!(trace.ending, Ending::NotFinite(_)));
    }
    assert!(seen > 0, "no engine ended as not-finite");
}

/// True if `carom diff` would tell two traces apart.
fn differ(scene: &Scene, a: &Trace, b: &Trace) -> bool {
    let rows = |trace: &Trace| -> Vec<carom::gate::Row> {
        let findings: Vec<Finding> = between(scene, "x", trace, a);
        findings.iter().map(carom::gate::Row::from).collect()
    };
    let held = |row: &carom::gate::Row| tolerance(&row.check, f64::EPSILON);
    !carom::gate::diff(&rows(a), &rows(b), held).is_empty()
}

#[test]
fn a_place_so_far_that_distances_overflow_is_another_place() {
    let scene = catalogue::scene("head-on").unwrap();
    let good = run(&scene, "stepper");
    let with = |y: f64| {
        let mut trace = good.clone();
        let knots = trace.paths[0].knots.len();
        trace.paths[0].knots[knots / 2].state.position.y = y;
        trace
    };
    assert!(!differ(&scene, &good, &good));
    for far in [1e308, -1e308, f64::MAX, f64::INFINITY, f64::NAN] {
        assert!(differ(&scene, &good, &with(far)), "{far}");
        assert!(differ(&scene, &with(far), &good), "{far} first");
        // where every distance is infinite on both sides, what is written is not the same
        assert!(differ(&scene, &with(far), &with(0.5 * far)) || !far.is_finite());
        assert!(differ(&scene, &with(far), &with(-far)) || far.is_nan());
        assert!(!differ(&scene, &with(far), &with(far)), "{far} and itself");
    }
}

#[test]
fn a_stop_time_without_end_is_refused() {
    let scene = catalogue::scene("slide").unwrap();
    let good = files::write(&run(&scene, "exact")).unwrap();
    let (row, stop) = {
        let row = good.final_states.lines().nth(1).unwrap();
        (row, row.rsplit_once(',').unwrap().1)
    };
    for bad in ["inf", "-inf", "NaN", "1e999", "infinity"] {
        let bad_row = row.replace(stop, bad);
        let files = Files {
            final_states: good.final_states.replace(row, &bad_row),
            ..good.clone()
        };
        let words = files::read(&files).unwrap_err().to_string();
        let expected =
            format!("final.csv:2: column `stop_time`: `{bad}`: expected a finite number");
        assert_eq!(words, expected);
    }
}

#[test]
fn no_tolerance_of_any_metric_lets_a_number_that_is_none_pass() {
    for ulp in [f64::EPSILON, f64::from(f32::EPSILON)] {
        for hold in [Hold::Count, Hold::Figure] {
            let tolerance = hold.tolerance(ulp);
            let none = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
            for bad in none {
                for x in [0.0, 1.0, -1e308, f64::MAX] {
                    assert!(!tolerance.holds(x, bad), "{hold:?}: {x} became {bad}");
                    assert!(!tolerance.holds(bad, x), "{hold:?}: {bad} became {x}");
                }
                assert!(tolerance.holds(bad, bad), "{hold:?}: {bad}");
            }
        }
    }
}
