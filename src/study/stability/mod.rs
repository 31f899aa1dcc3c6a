//! Hard cases on every engine: what holds, what drifts, what breaks, and by which rule.
//!
//! Plan: each scene in every engine and preset, in steps from 1e-6 to 1e-1, and in what the scene asks for; each of them also mirrored, with
//! its balls listed in reverse and, where nothing dissipates, backward. Conclusion: [`RULES`] judge every run, and the worst verdict
//! speaks for it.

mod against;
mod cell;
mod evidence;
mod plan;
mod rules;

pub use cell::{Examined, Judged, VERDICT, apart, examine, judge};
pub use evidence::{Evidence, FoundAt, Judgement, short};
pub(super) use plan::tried;
pub use plan::{
    PlanError, Planned, Reach, Role, STEPS, bounds_in_words, is_swept, presets, reach_of, step_of,
};
pub use rules::{RULES, Rule, rule};

use super::matrix::{Configuration, Task, Watch, run_tasks};
use crate::engine::Roster;
use crate::finding::{Finding, Hold, Tolerance, Verdict};
use crate::oracle::Oracle;
use crate::scene::Scene;

/// Most events of an event-driven run: a hard case that needs more is not one that a person waits for.
const MOST_EVENTS: u64 = 1_000_000;

/// What is run.
#[derive(Clone, Debug)]
pub struct Question {
    /// The engines of which scenes may ask something.
    pub roster: Roster,
    /// The hard cases.
    pub scenes: Vec<Scene>,
    /// The engines and presets in which every case runs.
    pub presets: Vec<Configuration>,
    /// Whether cells that take more than their share run as well.
    pub full: bool,
    /// Whether cells of presets and tried settings that break are drawn.
    pub pictures: bool,
}

/// One cell of the matrix and what came of it.
#[derive(Clone, Debug)]
pub struct Case {
    /// What was to run.
    pub planned: Planned,
    /// What the rules say; `None` where it did not run.
    pub judged: Option<Judged>,
}

/// Everything that the matrix found.
#[derive(Clone, Debug)]
pub struct StabilityOutcome {
    /// What was asked.
    pub question: Question,
    /// What the exact engine knows of each scene.
    pub oracles: Vec<Option<Oracle>>,
    /// Every cell, by scene and then in the order of its columns.
    pub cases: Vec<Case>,
    /// Cells that were to run.
    pub asked: usize,
}

/// Runs the matrix. Errors: a scene asks for a setting that is none.
pub fn study(question: Question, watch: Watch<'_>) -> Result<StabilityOutcome, PlanError> {
    let oracles = ask_oracles(&question.scenes, watch);
    let mut planned = Vec::new();
    for (index, scene) in question.scenes.iter().enumerate() {
        planned.extend(plan::cells(
            index,
            scene,
            oracles[index].as_ref(),
            &question.roster,
            &question.presets,
        )?);
    }
    let runs: Vec<usize> = (0..planned.len())
        .filter(|&i| question.runs(planned[i].reach))
        .collect();
    let tasks: Vec<Task> = runs
        .iter()
        .map(|&i| Task {
            cost: planned[i].time,
            label: format!(
                "{} in {}",
                question.scenes[planned[i].scene].name,
                planned[i].column.label()
            ),
        })
        .collect();
    let answers = run_tasks(&tasks, MOST_EVENTS, watch, |task, runner| {
        let cell = &planned[runs[task]];
        let scene = &question.scenes[cell.scene];
        cell::run(
            scene,
            cell,
            oracles[cell.scene].as_ref(),
            question.pictures,
            runner,
        )
    });
    let mut judged: Vec<Option<Judged>> = vec![None; planned.len()];
    for (index, answer) in runs.iter().zip(answers) {
        judged[*index] = answer;
    }
    let cases = planned.into_iter().zip(judged);
    Ok(StabilityOutcome {
        asked: runs.len(),
        cases: cases
            .map(|(planned, judged)| Case { planned, judged })
            .collect(),
        question,
        oracles,
    })
}

/// What the exact engine knows of each scene; `None` where it cannot be asked, or was stopped.
pub fn ask_oracles(scenes: &[Scene], watch: Watch<'_>) -> Vec<Option<Oracle>> {
    let tasks: Vec<Task> = scenes
        .iter()
        .map(|scene| Task {
            cost: scene.balls.len() as f64,
            label: format!("the exact answer of {}", scene.name),
        })
        .collect();
    let answers = run_tasks(&tasks, MOST_EVENTS, watch, |index, runner| {
        Oracle::ask(&scenes[index], runner.limits())
    });
    answers.into_iter().map(Option::flatten).collect()
}

impl Question {
    /// True if a cell of this reach runs.
    pub fn runs(&self, reach: Reach) -> bool {
        match reach {
            Reach::Always => true,
            Reach::Full => self.full,
            Reach::Never => false,
        }
    }
}

impl StabilityOutcome {
    /// The scene of a case.
    pub fn scene(&self, case: &Case) -> &Scene {
        &self.question.scenes[case.planned.scene]
    }

    /// The cases of one scene.
    pub fn of_scene(&self, scene: usize) -> impl Iterator<Item = &Case> {
        self.cases
            .iter()
            .filter(move |case| case.planned.scene == scene)
    }

    /// Cells that ran to their end.
    pub fn done(&self) -> usize {
        self.cases.iter().filter(|c| c.judged.is_some()).count()
    }

    /// True if the person stopped it before its end.
    pub fn is_cut_short(&self) -> bool {
        self.done() < self.asked
    }

    /// Number of cells with a verdict, among those that `wanted` picks.
    pub fn count(&self, verdict: Verdict, wanted: impl Fn(&Case) -> bool) -> usize {
        let own = self.cases.iter().filter(|case| wanted(case));
        own.filter(|case| case.judged.as_ref().is_some_and(|j| j.verdict == verdict))
            .count()
    }

    /// Promised invariants that do not hold, one sentence each.
    pub fn broken_promises(&self) -> Vec<String> {
        let mut broken = Vec::new();
        for case in &self.cases {
            let Some(judged) = &case.judged else { continue };
            for (rule, judgement) in judged.broken_promises() {
                broken.push(format!(
                    "{} in {}: {} ({})",
                    case.planned.column.label(),
                    self.scene(case).name,
                    judgement.why,
                    rule.id
                ));
            }
        }
        broken
    }

    /// By how much a figure of a check may move in the engine with this label.
    pub fn tolerance(&self, engine: &str, check: &str) -> Tolerance {
        let labelled = |case: &&Case| case.planned.column.label() == engine;
        let judged = self.cases.iter().filter(labelled);
        let ulp = judged
            .filter_map(|case| case.judged.as_ref())
            .map(|judged| judged.ulp);
        let ulp = ulp.fold(f64::EPSILON, f64::max);
        match (check, rule(check)) {
            (VERDICT, _) => Tolerance::None,
            (_, Some(rule)) => rule.tolerance(ulp),
            (_, None) => Hold::Figure.tolerance(ulp),
        }
    }

    /// Every figure and verdict of one scene, with its address.
    pub fn findings(&self, scene: usize) -> Vec<Finding> {
        let name = &self.question.scenes[scene].name;
        let mut findings = Vec::new();
        for case in self.of_scene(scene) {
            if let Some(judged) = &case.judged {
                findings.extend(judged.findings(name, &case.planned.column.label()));
            }
        }
        findings
    }
}
