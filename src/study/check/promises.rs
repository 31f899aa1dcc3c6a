//! What an engine promises of a run, held on the run: no acceptance excuses a promise that is broken.
//!
//! Most promises have a rule of `stability`. Those that no hard case needs are looked at here: what a single impact does to energy,
//! a rerun to the bit, a quarter turn, all lengths four times as long.

use super::Level;
use super::held::PROMISE;
use crate::finding::{Finding, Verdict};
use crate::math::{Vec3, within, worse};
use crate::oracle::Oracle;
use crate::physics::Friction;
use crate::physics::State;
use crate::physics::invariants::{Invariant, kinetic_energy};
use crate::scene::{Scene, Table};
use crate::study::matrix::{Column, Runner};
use crate::study::stability::{Examined, RULES, apart};
use crate::trace::{EventKind, Record, Trace};
use std::collections::BTreeMap;

/// A promise that does not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// Name of the scene.
    pub scene: String,
    /// Label of the column.
    pub engine: String,
    /// [`Level::Promise`] or [`Level::Fuzz`].
    pub level: Level,
    /// What is promised: the id of an invariant, or of what a random scene broke.
    pub what: &'static str,
    /// What was found instead, in one sentence.
    pub why: String,
}

/// Lengths of the scaled scene are so many times as long: a power of two, which rounds nothing.
const SCALE: f64 = 4.0;

/// A run longer than this is not repeated to see that it repeats: what is accepted of it sees that in every check, ns.
const MOST_RERUN: f64 = 5e7;

/// Energy of an impact is kept to so many ulp: two squares, their sums and a projection for each of two balls.
const IMPACT_ULPS: f64 = 64.0;

/// Every promise that can be looked at: one finding each, and those that do not hold.
pub fn hold(
    scene: &Scene,
    column: &Column,
    examined: &Examined,
    oracle: Option<&Oracle>,
    record: Record,
    runner: Runner<'_>,
) -> (Vec<Finding>, Vec<Broken>) {
    let (mut findings, mut broken) = (Vec::new(), Vec::new());
    for invariant in column.engine.promises(scene, &column.setting) {
        let said = by_rule(invariant, examined)
            .or_else(|| directly(invariant, scene, column, examined, oracle, record, runner));
        let Some(said) = said else {
            continue;
        };
        findings.push(Finding {
            scene: scene.name.clone(),
            engine: column.label(),
            metric: PROMISE,
            subject: invariant.id().to_owned(),
            value: None,
            unit: "",
            verdict: Some(if said.is_ok() {
                Verdict::Holds
            } else {
                Verdict::Breaks
            }),
        });
        if let Err(why) = said {
            broken.push(Broken {
                scene: scene.name.clone(),
                engine: column.label(),
                level: Level::Promise,
                what: invariant.id(),
                why,
            });
        }
    }
    (findings, broken)
}

/// What the rule of an invariant says; `None` where there is none, or it does not apply.
fn by_rule(invariant: Invariant, examined: &Examined) -> Option<Result<(), String>> {
    let own = |(index, _): &&(usize, _)| RULES[*index].invariant == Some(invariant);
    let (_, judgement) = examined.judged.judgements.iter().find(own)?;
    Some(match judgement.verdict {
        Some(Verdict::Breaks) => Err(judgement.why.clone()),
        _ => Ok(()),
    })
}

fn directly(
    invariant: Invariant,
    scene: &Scene,
    column: &Column,
    examined: &Examined,
    oracle: Option<&Oracle>,
    record: Record,
    runner: Runner<'_>,
) -> Option<Result<(), String>> {
    let trace = &examined.ran.trace;
    let image = |image: &Scene, map: fn(&State) -> State| {
        let order: Vec<usize> = (0..scene.balls.len()).collect();
        let ran = runner.run(image, column, Record::Events);
        let apart = apart(scene, trace, ran, map, &order)?;
        let bound = examined.rounding.min(1.0);
        // beyond the horizon nothing is demanded, and a NaN is within nothing
        let known = oracle.is_some_and(Oracle::is_whole);
        Some(if within(apart, bound) || !known {
            Ok(())
        } else {
            Err(format!(
                "it ends {apart:.2e} R from where it should; rounding makes {bound:.2e} R"
            ))
        })
    };
    match invariant {
        Invariant::ImpactEnergy => {
            let whole = scene.initial_energy();
            let worst = impact_energy(scene, trace);
            let bound = IMPACT_ULPS * examined.judged.ulp * whole;
            Some(if within(worst, bound) {
                Ok(())
            } else {
                Err(format!(
                    "an impact changes {:.2e} of the energy",
                    worst / whole
                ))
            })
        }
        Invariant::Rerun => {
            if super::cell::cost(scene, column) > MOST_RERUN {
                return None;
            }
            let again = runner.run(scene, column, record).ok()?;
            Some(if super::bits::of(&again.trace) == super::bits::of(trace) {
                Ok(())
            } else {
                Err("a rerun has other bits".to_owned())
            })
        }
        Invariant::QuarterTurn => image(&turned(scene), |state| {
            let back = |v: Vec3| Vec3::new(v.y, -v.x, v.z);
            State {
                position: back(state.position),
                velocity: back(state.velocity),
                spin: back(state.spin),
            }
        }),
        Invariant::Scaling => image(&scaled(scene), |state| State {
            position: state.position / SCALE,
            velocity: state.velocity / SCALE,
            spin: state.spin,
        }),
        _ => None,
    }
}

/// Largest change of energy over a meeting of two balls, from both sides of it.
fn impact_energy(scene: &Scene, trace: &Trace) -> f64 {
    let mut change: BTreeMap<u32, f64> = BTreeMap::new();
    for (ball, path) in trace.paths.iter().enumerate() {
        let energy =
            |state: &State| kinetic_energy(state, scene.balls[ball].mass, scene.inertia(ball));
        for pair in path.knots.windows(2) {
            if let Some(event) = pair[1].after {
                *change.entry(event).or_default() +=
                    energy(&pair[1].state) - energy(&pair[0].state);
            }
        }
    }
    let meets = |event: u32| {
        let event = trace.events.get(event as usize);
        event.is_some_and(|event| matches!(event.kind, EventKind::BallBall(..)))
    };
    let hits = change.iter().filter(|(event, _)| meets(**event));
    hits.map(|(_, change)| change.abs()).fold(0.0, worse)
}

/// The scene turned by a quarter turn about the origin, left; every number only changes its place and sign.
fn turned(scene: &Scene) -> Scene {
    let turn = |v: Vec3| Vec3::new(-v.y, v.x, v.z);
    let mut image = scene.clone();
    // the motion is that of the balls
    image.shot = None;
    for ball in &mut image.balls {
        ball.state = State {
            position: turn(ball.state.position),
            velocity: turn(ball.state.velocity),
            spin: turn(ball.state.spin),
        };
    }
    image.table = scene.table.map(|table| Table {
        min: [-table.max[1], table.min[0]],
        max: [-table.min[1], table.max[0]],
    });
    let pockets = image.effects.pockets.iter_mut();
    for circle in pockets.flat_map(|p| &mut p.circles) {
        (circle[0], circle[1]) = (-circle[1], circle[0]);
    }
    image
}

/// The scene with lengths, speeds and gravity [`SCALE`] times as large.
fn scaled(scene: &Scene) -> Scene {
    let mut image = scene.clone();
    image.shot = None;
    image.gravity *= SCALE;
    for ball in &mut image.balls {
        ball.radius *= SCALE;
        ball.state.position *= SCALE;
        ball.state.velocity *= SCALE;
    }
    image.table = scene.table.map(|table| Table {
        min: table.min.map(|x| SCALE * x),
        max: table.max.map(|x| SCALE * x),
    });
    let pockets = image.effects.pockets.iter_mut();
    for circle in pockets.flat_map(|p| &mut p.circles) {
        *circle = circle.map(|x| SCALE * x);
    }
    // a law with constants in metres: the same scene in another unit
    if let Some(Friction::Alciatore {
        length_in_metres, ..
    }) = &mut image.effects.friction
    {
        *length_in_metres /= SCALE;
    }
    image
}
