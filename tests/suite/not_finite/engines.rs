//! An engine that becomes infinite is noticed by every rule that looks, however infinite the bounds have become with it.

use crate::support::{run, scenario};
use carom::compare::Comparison;
use carom::engine::Limits;
use carom::finding::Verdict;
use carom::math::Vec3;
use carom::oracle::{Allowance, Oracle};
use carom::physics::invariants::Invariant;
use carom::scene::Scene;
use carom::study::random;
use carom::study::stability::{Evidence, Judgement, RULES, judge};
use carom::trace::{Extremum, Record, Trace};

/// A hit, a bounce and two stops.
fn shot() -> Scene {
    scenario("planted")
        .moving("cue", [1.0, 1.0], [3.0, 0.0])
        .resting("1", [2.0, 1.0])
        .cloth(0.2)
        .cushions(4.0, 2.0)
        .build()
}

/// The same without anything that takes energy.
fn lossless() -> Scene {
    scenario("planted-lossless")
        .moving("cue", [1.0, 1.0], [3.0, 0.0])
        .resting("1", [2.0, 1.0])
        .duration(2.0)
        .build()
}

/// What is measured beside a trace, R.
#[derive(Default)]
struct Beside {
    mirror: Option<f64>,
    relabelled: Option<f64>,
    reversal: Option<f64>,
}

/// What a rule says of a trace of an engine that promises everything. `unknown`: the growth of the scene overflowed.
fn says(id: &str, scene: &Scene, trace: &Trace, beside: &Beside, unknown: bool) -> Judgement {
    let mut oracle = Oracle::ask(scene, &Limits::NONE).unwrap();
    if unknown {
        oracle.grown = f64::INFINITY;
        oracle.handed_on.fill(f64::INFINITY);
    }
    let promises = [
        Invariant::Finite,
        Invariant::Momentum,
        Invariant::EnergyNeverGrows,
        Invariant::Bounds,
        Invariant::Overlap,
        Invariant::Mirror,
        Invariant::Relabelling,
        Invariant::TimeReversal,
        Invariant::EverythingStops,
    ];
    let judged = judge(&Evidence {
        scene,
        trace,
        promises: &promises,
        allowance: Allowance {
            dt: trace.provenance.resolution,
            steps: trace.counters.get("steps").copied().unwrap_or(0),
            ulp: f64::EPSILON,
        },
        oracle: Some(&oracle),
        comparison: Some(Comparison::new(scene, trace, &oracle.trace).up_to(oracle.until)),
        events: true,
        mirror: beside.mirror,
        relabelled: beside.relabelled,
        reversal: beside.reversal,
    });
    let own = judged.judgements.iter().find(|(r, _)| RULES[*r].id == id);
    let own = own.unwrap_or_else(|| panic!("{id} does not apply"));
    own.1.clone()
}

#[test]
fn no_rule_holds_of_a_figure_that_is_no_number() {
    type Plant = fn(&mut Trace, &mut Beside, f64);
    fn worst(value: f64) -> Extremum {
        Extremum {
            value,
            time: 0.3,
            ball: Some(0),
            other: Some(1),
        }
    }
    let plants: [(&str, Scene, Plant); 10] = [
        ("energy-gained", shot(), |t, _, x| {
            t.extrema.energy_gained = worst(x)
        }),
        ("energy-lost", lossless(), |t, _, x| {
            // the last velocity is what is left of the energy
            if let Some(knot) = t.paths[0].knots.last_mut() {
                knot.state.velocity.x = x;
            }
        }),
        ("outside", shot(), |t, _, x| t.extrema.outside = worst(x)),
        ("overlap", shot(), |t, _, x| t.extrema.overlap = worst(x)),
        ("momentum", shot(), |t, _, x| t.extrema.momentum = worst(x)),
        ("stop-time", shot(), |t, _, x| t.stop_times[0] = Some(x)),
        ("mirror", shot(), |_, b, x| b.mirror = Some(x)),
        ("relabelling", shot(), |_, b, x| b.relabelled = Some(x)),
        ("time-reversal", lossless(), |_, b, x| b.reversal = Some(x)),
        ("still-moving", shot(), |t, _, x| {
            if let Some(knot) = t.paths[0].knots.last_mut() {
                knot.state.velocity.x = x;
            }
        }),
    ];
    let mut looked = 0;
    for (id, scene, plant) in plants {
        let good = run(
            "stepper",
            &["contact=approaching-only"],
            &scene,
            Record::Every(0.01),
        );
        for x in [f64::INFINITY, f64::NAN] {
            for (fast, unknown) in [(false, false), (true, false), (false, true), (true, true)] {
                let (mut trace, mut beside) = (good.clone(), Beside::default());
                if fast {
                    // finite, and its square is not: every bound made from the largest speed is infinite
                    trace.paths[1].knots[1].state.velocity.x = 1e200;
                }
                plant(&mut trace, &mut beside, x);
                let said = says(id, &scene, &trace, &beside, unknown);
                let holds = said.verdict == Some(Verdict::Holds);
                assert!(
                    !holds,
                    "{id} of {x}, fast {fast}, unknown {unknown}: {said:?}"
                );
                looked += 1;
            }
        }
    }
    assert_eq!(looked, 80);
}

#[test]
fn a_random_scene_in_which_a_bound_overflows_has_a_fault() {
    let scene = shot();
    let good = run(
        "stepper",
        &["contact=approaching-only"],
        &scene,
        Record::Every(0.01),
    );
    assert_eq!(random::check(&scene, &good, false).faults, []);
    // as fast as that every length that is made from its speed is infinite
    let mut fast = good.clone();
    fast.paths[1].knots[1].state.velocity = Vec3::new(1e200, 0.0, 0.0);
    for (what, x) in [
        ("outside", 1e300),
        ("outside", f64::NAN),
        ("overlap", 1e300),
        ("overlap", f64::NAN),
    ] {
        let mut trace = fast.clone();
        let extremum = Extremum {
            value: x,
            time: 0.3,
            ball: Some(1),
            other: (what == "overlap").then_some(0),
        };
        match what {
            "outside" => trace.extrema.outside = extremum,
            _ => trace.extrema.overlap = extremum,
        }
        let faults = random::check(&scene, &trace, false).faults;
        let told = faults.iter().any(|fault| fault.what == what);
        assert!(told, "{what} {x}: {faults:?}");
    }
}
