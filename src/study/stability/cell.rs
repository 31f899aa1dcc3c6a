//! One cell: its runs, its evidence, its verdict.

use super::evidence::{Evidence, Judgement};
use super::plan::{MOST_STATES, Planned};
use super::rules::{RULES, Rule, rounding_grown};
use crate::compare::Comparison;
use crate::engine::Refusal;
use crate::finding::{Finding, Verdict};
use crate::law::{Law, Reads, mirror, relabelling, time_reversal};
use crate::oracle::{Allowance, Oracle};
use crate::physics::invariants::Invariant;
use crate::scene::Scene;
use crate::study::matrix::{Configuration, Ran, Runner};
use crate::trace::{Counter, Ending, Record, Trace};

/// The finding that is the verdict of a run.
pub const VERDICT: &str = "verdict";

/// The finding that says how and when a run ended.
const ENDING: &str = "ending";

/// Samples of a stepping engine in a run, besides its events.
const SAMPLES: f64 = 256.0;

/// What the rules say of one cell.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The worst of all verdicts.
    pub verdict: Verdict,
    /// Index in [`RULES`] of the rule that speaks for it; `None` where nothing ran.
    pub speaker: Option<usize>,
    /// The verdict in one sentence; empty where everything holds.
    pub why: String,
    /// What each rule says, by its index in [`RULES`].
    pub judgements: Vec<(usize, Judgement)>,
    /// How the run ended, and when, s; `None` where nothing ran.
    pub ending: Option<(&'static str, f64)>,
    /// Rounding of the engine's scalar.
    pub ulp: f64,
    /// Indices in [`RULES`] of those whose invariant the engine promises.
    pub promised: Vec<usize>,
    /// The run that broke, where pictures are asked for.
    pub broken: Option<Box<Trace>>,
}

impl Judged {
    /// What the speaking rule says.
    pub fn spoken(&self) -> Option<(&'static Rule, &Judgement)> {
        let speaker = self.speaker?;
        let (_, judgement) = self.judgements.iter().find(|(rule, _)| *rule == speaker)?;
        Some((&RULES[speaker], judgement))
    }

    /// Rules that are broken although the engine promises their invariant.
    pub fn broken_promises(&self) -> impl Iterator<Item = (&'static Rule, &Judgement)> {
        let broken = |(rule, judgement): &&(usize, Judgement)| {
            self.promised.contains(rule) && judgement.verdict == Some(Verdict::Breaks)
        };
        self.judgements
            .iter()
            .filter(broken)
            .map(|(rule, judgement)| (&RULES[*rule], judgement))
    }

    /// Every figure and verdict, with its address. A figure that holds and is nothing within its tolerance says no more than the verdict of the
    /// run and is left out.
    pub fn findings(&self, scene: &str, engine: &str) -> Vec<Finding> {
        let finding = |metric, value, unit, verdict| Finding {
            scene: scene.to_owned(),
            engine: engine.to_owned(),
            metric,
            subject: String::new(),
            value,
            unit,
            verdict,
        };
        let mut findings = vec![finding(VERDICT, None, "", Some(self.verdict))];
        if let Some((ending, time)) = self.ending {
            findings.push(Finding {
                subject: ending.to_owned(),
                ..finding(ENDING, Some(time), "s", None)
            });
        }
        for (rule, judgement) in &self.judgements {
            let rule = &RULES[*rule];
            let nothing = |value: f64| rule.tolerance(self.ulp).holds(value, 0.0);
            let says_nothing = judgement.value.is_none_or(nothing);
            if says_nothing && judgement.verdict == Some(Verdict::Holds) {
                continue;
            }
            findings.push(finding(
                rule.id,
                judgement.value,
                rule.unit,
                judgement.verdict,
            ));
        }
        findings
    }

    fn refused(why: String) -> Self {
        Judged {
            verdict: Verdict::CannotExpress,
            speaker: None,
            why,
            judgements: Vec::new(),
            ending: None,
            ulp: f64::EPSILON,
            promised: Vec::new(),
            broken: None,
        }
    }
}

/// A run, what the rules say of it, and what rounding makes of it.
#[derive(Clone, Debug)]
pub struct Examined {
    /// What ran.
    pub ran: Ran,
    /// What the rules say.
    pub judged: Judged,
    /// Rounding grown over the whole run, R; infinite where its growth is not known.
    pub rounding: f64,
}

/// Runs a cell and its images and judges them.
pub fn run(
    scene: &Scene,
    planned: &Planned,
    oracle: Option<&Oracle>,
    picture: bool,
    runner: Runner<'_>,
) -> Judged {
    let steps = super::plan::step_of(&planned.column).is_some();
    let events = planned.states <= MOST_STATES;
    let record = match (events, steps) {
        (false, _) => Record::Final,
        (true, false) => Record::Events,
        (true, true) => Record::Every(scene.duration / SAMPLES),
    };
    let column = &planned.column;
    let examined = match examine(scene, column, oracle, record, &|_| true, runner) {
        Ok(examined) => examined,
        Err(why) => return Judged::refused(why),
    };
    let mut judged = examined.judged;
    let own_step = !matches!(planned.role, super::plan::Role::Step(..));
    if picture && own_step && judged.verdict == Verdict::Breaks && events {
        judged.broken = Some(Box::new(examined.ran.trace));
    }
    judged
}

/// Runs a scene in a column, and those of its images that are `wanted`, and judges them. Errors: why nothing ran.
pub fn examine(
    scene: &Scene,
    column: &Configuration,
    oracle: Option<&Oracle>,
    record: Record,
    wanted: &dyn Fn(Invariant) -> bool,
    runner: Runner<'_>,
) -> Result<Examined, String> {
    let events = !matches!(record, Record::Final);
    let ran = match runner.run(scene, column, record) {
        Ok(ran) => ran,
        Err(refusal) => return Err(refusal.to_string()),
    };
    // a run that could not begin: its numbers are beyond the scalar
    if let Ending::NotFinite(spot) = &ran.trace.ending
        && spot.time == 0.0
    {
        return Err(spot.why.clone());
    }
    let short = if events {
        Record::Events
    } else {
        Record::Final
    };
    let image = |law: &Law| {
        let wanted = wanted(law.invariant);
        wanted.then(|| apart(law, scene, column, &ran.trace, short, runner))?
    };
    let promises = column.engine.promises(scene, &column.setting);
    let evidence = Evidence {
        scene,
        promises: &promises,
        allowance: allowance(column, &ran),
        oracle,
        comparison: comparison(scene, &ran, oracle, events),
        trace: &ran.trace,
        events,
        mirror: image(&mirror::LAW),
        relabelled: image(&relabelling::LAW),
        reversal: image(&time_reversal::LAW),
    };
    let judged = judge(&evidence);
    let rounding = rounding_grown(&evidence);
    drop(evidence);
    Ok(Examined {
        judged,
        ran,
        rounding,
    })
}

/// Lets every rule judge, and the worst verdict speak.
pub fn judge(evidence: &Evidence<'_>) -> Judged {
    let rules = RULES.iter().enumerate();
    let judgements: Vec<(usize, Judgement)> = rules
        .filter_map(|(index, rule)| Some((index, (rule.judge)(evidence)?)))
        .collect();
    let mut speaker: Option<(usize, Verdict)> = None;
    for (index, judgement) in &judgements {
        let Some(verdict) = judgement.verdict else {
            continue;
        };
        if speaker.is_none_or(|(_, worst)| verdict > worst) {
            speaker = Some((*index, verdict));
        }
    }
    let promised = RULES.iter().enumerate().filter(|(_, rule)| {
        rule.invariant()
            .is_some_and(|invariant| evidence.promises(invariant))
    });
    let mut judged = Judged {
        verdict: speaker.map_or(Verdict::Holds, |(_, verdict)| verdict),
        speaker: speaker.map(|(index, _)| index),
        why: String::new(),
        promised: promised.map(|(index, _)| index).collect(),
        judgements,
        ending: Some((evidence.trace.ending.id(), evidence.trace.end_time)),
        ulp: evidence.allowance.ulp,
        broken: None,
    };
    judged.why = judged
        .spoken()
        .map_or(String::new(), |(_, j)| j.why.clone());
    judged
}

/// What an error of a run may come from. The scalar is the engine's by its own word: a run that says another is allowed no more.
fn allowance(column: &Configuration, ran: &Ran) -> Allowance {
    Allowance {
        dt: ran.trace.provenance.resolution,
        steps: ran.trace.count(Counter::Steps).unwrap_or(0),
        ulp: column.engine.ulp(&column.setting).max(f64::EPSILON),
    }
}

/// The run against the exact one, unless it is that one itself.
fn comparison<'a>(
    scene: &'a Scene,
    ran: &'a Ran,
    oracle: Option<&'a Oracle>,
    events: bool,
) -> Option<Comparison<'a>> {
    let oracle = oracle?;
    let (ours, theirs) = (&ran.trace.provenance, &oracle.trace.provenance);
    // the oracle is the exact engine in f64
    let itself = ours.engine == theirs.engine && ours.ulp == f64::EPSILON;
    (events && !itself)
        .then(|| Comparison::new(scene, &ran.trace, &oracle.trace).up_to(oracle.until))
}

/// How far the image of a scene ends from where a run of the scene says, R: infinite where the engine refuses what it must run; `None` where
/// there is no image, or nothing to compare.
pub fn apart(
    law: &Law,
    scene: &Scene,
    column: &Configuration,
    trace: &Trace,
    record: Record,
    runner: Runner<'_>,
) -> Option<f64> {
    let Reads::Image(image) = law.reads else {
        return None;
    };
    let mapped = (image.of)(scene, trace)?;
    match runner.run(&mapped, column, record) {
        Ok(ran) => (image.apart)(scene, trace, &ran.trace),
        Err(Refusal::Stopped) => None,
        Err(_) => image.must_run.then_some(f64::INFINITY),
    }
}
