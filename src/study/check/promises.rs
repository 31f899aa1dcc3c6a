//! What an engine promises of a run, held on the run: no acceptance excuses a promise that is broken.
//!
//! Most promises have a rule of `stability`. Those that no hard case needs are looked at here: what a single impact does to energy,
//! a rerun to the bit, a quarter turn, all lengths four times as long.

use super::Level;
use super::item::PROMISE;
use crate::finding::{Finding, Verdict};
use crate::law::rerun::digest;
use crate::law::{self, Reads, Run, image};
use crate::math::within;
use crate::oracle::Oracle;
use crate::physics::invariants::Invariant;
use crate::scene::Scene;
use crate::study::matrix::{Configuration, Runner};
use crate::study::stability::{Examined, RULES, apart};
use crate::trace::Record;

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

/// A run longer than this is not repeated to see that it repeats: what is accepted of it sees that in every check, ns.
const MOST_RERUN: f64 = 5e7;

/// Every promise that can be looked at: one finding each, and those that do not hold.
pub fn hold(
    scene: &Scene,
    column: &Configuration,
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
    let own = |(index, _): &&(usize, _)| RULES[*index].invariant() == Some(invariant);
    let (_, judgement) = examined.judged.judgements.iter().find(own)?;
    Some(match judgement.verdict {
        Some(Verdict::Breaks) => Err(judgement.why.clone()),
        _ => Ok(()),
    })
}

/// What is seen of an invariant that no rule of `stability` looks at.
fn directly(
    invariant: Invariant,
    scene: &Scene,
    column: &Configuration,
    examined: &Examined,
    oracle: Option<&Oracle>,
    record: Record,
    runner: Runner<'_>,
) -> Option<Result<(), String>> {
    let trace = &examined.ran.trace;
    // every other invariant has a rule, or is held in random scenes
    if RULES.iter().any(|rule| rule.invariant() == Some(invariant)) || invariant == Invariant::Laws
    {
        return None;
    }
    let law = law::law(invariant)?;
    match law.reads {
        Reads::Run(held) => {
            let held = held(&Run {
                ulp: examined.judged.ulp,
                ..Run::of(scene, trace)
            })?;
            let whole = scene.initial_energy();
            Some(if held.holds() {
                Ok(())
            } else {
                let part = held.seen.value / whole;
                Err(format!("an impact changes {part:.2e} of the energy"))
            })
        }
        Reads::Rerun => {
            if super::cost(scene, column) > MOST_RERUN {
                return None;
            }
            let again = runner.run(scene, column, record).ok()?;
            Some(if digest(&again.trace) == digest(trace) {
                Ok(())
            } else {
                Err("a rerun has other bits".to_owned())
            })
        }
        Reads::Image(_) => {
            let apart = apart(law, scene, column, trace, Record::Events, runner)?;
            let bound = image::bound(examined.rounding, 0.0);
            // beyond the horizon nothing is demanded, and a NaN is within nothing
            let known = oracle.is_some_and(Oracle::is_whole);
            Some(if within(apart, bound) || !known {
                Ok(())
            } else {
                Err(format!(
                    "it ends {apart:.2e} R from where it should; rounding makes {bound:.2e} R"
                ))
            })
        }
    }
}
