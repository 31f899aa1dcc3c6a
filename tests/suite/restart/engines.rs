//! A knot of any engine is a start for every engine that runs the scene.

use super::{CASES, Side, case, from, knots, run};
use carom::engine::can_run;
use carom::physics;
use carom::scene::{Scene, catalogue};
use carom::study::random::check;
use carom::trace::{Ending, Trace};

const ENGINES: [&str; 4] = ["exact", "stepper", "rapier-f64", "rapier-f32"];

/// Those whose runs are held against all that must hold, also where a law is not promised by every engine.
const HELD: [&str; 2] = ["exact", "stepper"];

/// How far a start is within another ball or beyond a cushion, length: an engine that steps leaves it there.
fn depth(scene: &Scene) -> f64 {
    let n = scene.balls.len();
    let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let pairs = pairs.map(|(i, j)| {
        let way = scene.balls[j].state.position - scene.balls[i].state.position;
        scene.contact_distance(i, j) - way.xy().norm()
    });
    let bounded = scene.effects.cushion.is_some();
    let sides = scene.balls.iter().filter(|_| bounded).flat_map(|ball| {
        physics::Side::ALL.into_iter().filter_map(|side| {
            let beyond = ball.state.position[side.axis()] - scene.reach(side, ball.radius)?;
            Some(f64::from(side.sign()) * beyond)
        })
    });
    pairs.chain(sides).fold(0.0, f64::max)
}

fn is_finite(trace: &Trace) -> bool {
    let knots = trace.paths.iter().flat_map(|path| &path.knots);
    let mut states = knots.map(|knot| knot.state);
    let finite = states.all(|s| {
        (s.position + s.velocity + s.spin)
            .iter()
            .all(|x| x.is_finite())
    });
    finite && !matches!(trace.ending, Ending::NotFinite(_))
}

/// Starts every engine from knots of every engine; answers how many runs that were.
fn hold(scene: &Scene) -> usize {
    let able: Vec<&str> = ENGINES
        .into_iter()
        .filter(|id| can_run(crate::support::find(id).unwrap().as_ref(), scene).is_ok())
        .collect();
    let mut runs = 0;
    for source in &able {
        let mut first = scene.clone();
        first.duration = first.duration.min(2.0);
        let trace = run(source, &first).unwrap();
        for time in knots(&trace, 5) {
            for side in [Side::Near, Side::Far] {
                let Some(mut rest) = from(&first, &trace, time, side) else {
                    continue;
                };
                rest.duration = rest.duration.min(0.5);
                let inside = depth(&rest) > rest.touching();
                for id in &able {
                    let what =
                        format!("{}: {id} from {side:?} of {time} s of {source}", scene.name);
                    let run = run(id, &rest).unwrap_or_else(|refusal| panic!("{what}: {refusal}"));
                    assert!(is_finite(&run), "{what}: {:?}", run.ending);
                    runs += 1;
                    if !HELD.contains(id) {
                        continue;
                    }
                    // what the start has overlapping or outside is no finding
                    let known = |fault: &str| inside && matches!(fault, "overlap" | "outside");
                    let mut faults = check(&rest, &run, false).faults;
                    faults.retain(|fault| !known(fault.what));
                    assert!(faults.is_empty(), "{what}: {faults:?}");
                }
            }
        }
    }
    runs
}

#[test]
fn a_knot_of_any_engine_is_a_start_for_every_engine() {
    let mut runs = 0;
    for name in CASES {
        runs += hold(&case(name));
    }
    for name in ["follow", "three-ball", "curve", "throw"] {
        runs += hold(&catalogue::scene(name).unwrap());
    }
    assert!(runs >= 1000, "{runs} runs");
}
