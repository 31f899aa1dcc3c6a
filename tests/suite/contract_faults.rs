//! The contract is one that can be broken: each promise on a trace with one thing planted in it.

use crate::contract::{Case, HALF};
use crate::support::{R, run, scenario};
use carom::engine::Setting;
use carom::math::Vec3;
use carom::physics::State;
use carom::physics::invariants::Invariant;
use carom::scene::{Scene, Table};
use carom::trace::{Ending, Event, EventKind, Record, Trace};
use carom::{law, oracle};
use std::collections::BTreeSet;

/// A fault in a trace, which its extrema keep silent about.
type Plant = fn(&mut Trace);

/// The far side of the first meeting of two balls: of one of them.
fn first_far_side(trace: &mut Trace) -> &mut State {
    let met = |event: &Event| matches!(event.kind, EventKind::BallBall(..));
    let event = trace.events.iter().position(met).unwrap() as u32;
    let mut knots = trace.paths.iter_mut().flat_map(|path| &mut path.knots);
    &mut knots.find(|knot| knot.after == Some(event)).unwrap().state
}

fn end(trace: &mut Trace, ball: usize) -> &mut State {
    &mut trace.paths[ball].knots.last_mut().unwrap().state
}

#[test]
fn each_promise_is_seen_to_be_broken_whatever_the_engine_says_of_itself() {
    let moved: Plant = |trace| end(trace, 0).position.y += 1e-6;
    let plants: [(Invariant, Plant); 14] = [
        (Invariant::Finite, |trace| end(trace, 1).spin.y = f64::NAN),
        (Invariant::Momentum, |trace| {
            first_far_side(trace).velocity *= 1.0 + 1e-9;
        }),
        (Invariant::ImpactEnergy, |trace| {
            first_far_side(trace).velocity *= 1.0 + 1e-9;
        }),
        (Invariant::EnergyNeverGrows, |trace| {
            // a ball that has come to rest has more than was left to both
            end(trace, 0).velocity.x = 2.0;
        }),
        (Invariant::Bounds, |trace| {
            end(trace, 0).position.x = HALF - 0.99 * R;
        }),
        (Invariant::Overlap, |trace| {
            let there = end(trace, 0).position;
            end(trace, 1).position = there + Vec3::new(1.99 * R, 0.0, 0.0);
        }),
        (Invariant::EverythingStops, |trace| {
            trace.ending = Ending::Duration;
        }),
        (Invariant::Rerun, |trace| {
            trace.end_time = trace.end_time.next_up();
        }),
        (Invariant::Mirror, moved),
        (Invariant::Relabelling, moved),
        (Invariant::QuarterTurn, moved),
        (Invariant::Scaling, moved),
        (Invariant::TimeReversal, |trace| {
            end(trace, 0).velocity.y += 1e-6;
        }),
        (Invariant::Laws, |trace| {
            first_far_side(trace).velocity *= 1.0 + 1e-9;
        }),
    ];
    let planted: BTreeSet<&str> = plants.iter().map(|(invariant, _)| invariant.id()).collect();
    let every: BTreeSet<&str> = law::LAWS.iter().map(|law| law.invariant.id()).collect();
    assert_eq!(planted, every);
    // two balls that meet and bounce, with a cloth and without anything that takes energy
    let shot = |name| {
        let shot = scenario(name).moving("cue", [-1.0, 0.1], [2.0, 0.3]);
        shot.resting("1", [0.0, 0.0])
    };
    let table = |mut scene: Scene| {
        scene.table = Some(Table {
            min: [-HALF, -HALF],
            max: [HALF, HALF],
        });
        scene
    };
    let stops = table(shot("stops").cloth(0.2).cushions(1.0, 1.0).build());
    let lossless = table(shot("lossless").duration(1.5).cushions(1.0, 1.0).build());
    let engine = oracle::engine();
    let setting = Setting::default();
    for (invariant, plant) in plants {
        let reverses = invariant == Invariant::TimeReversal;
        let scene = if reverses { &lossless } else { &stops };
        let promised = engine.promises(scene, &setting);
        assert!(promised.contains(&invariant), "{}", invariant.id());
        let trace = run(engine.id(), &[], scene, Record::Every(0.02));
        let case = |trace| Case {
            engine: engine.as_ref(),
            setting: &setting,
            scene,
            trace,
        };
        assert_eq!(case(&trace).check(invariant), Ok(()), "{}", invariant.id());
        let mut broken = trace.clone();
        plant(&mut broken);
        let said = case(&broken).check(invariant);
        assert!(said.is_err(), "{} is not seen", invariant.id());
        assert_eq!(broken.extrema, trace.extrema, "{}", invariant.id());
    }
}
