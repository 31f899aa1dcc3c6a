//! What every later version is held against: the scenes of the gate in every engine, on five levels, and random scenes on a sixth.
//!
//! Plan: each scene in each column, and in each setting that its `try` asks for, once, with the images that the column promises something
//! about; the scenes that nobody can predict to their end as an ensemble as well. Conclusion: findings, each with a [`Level`], and a list of the [`Case`]s that must have run, so that a
//! check that did not reach its end cannot pass. What is accepted of them is for `gate`.

mod cell;
mod distribution;
mod held;
mod item;
mod oracle;
mod pair;
mod promises;
mod random;
mod written;

pub use crate::law::rerun::{DIGITS, is_digest};
pub use distribution::{SAMPLES, SEED};
pub use held::{HELD, hold, level, tolerance, unit_of, what};
pub use item::Held;
pub use oracle::ORACLE;
pub use pair::between;
pub use promises::Broken;
pub use random::{RANDOM, RANDOM_SCENES, RANDOM_SEED, random_command, random_hash, random_plan};
pub use written::{WRITTEN, unheld};

use super::Extent;
use super::ensemble::Landing;
use super::matrix::{Configuration, Task, Watch, run_tasks};
use super::stability::{PlanError, ask_oracles, tried};
use crate::engine::Roster;
use crate::finding::{Finding, Tolerance};
use crate::oracle::Oracle;
use crate::scene::{Scene, SetName, Simultaneous};
use std::collections::BTreeMap;
use std::mem;

/// Most events of an event-driven run.
const MOST_EVENTS: u64 = 1_000_000;

/// What a finding is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// An invariant that the engine promises. Never up to acceptance.
    Promise,
    /// Errors against the exact engine and the order of events, up to the horizon and the first difference.
    Error,
    /// Distributions over a seeded ensemble, where single answers are noise.
    Distribution,
    /// What a hard case is known to do.
    Verdict,
    /// Deterministic counts of the work done.
    Work,
    /// Random scenes: what must hold of every one of them, which is never up to acceptance, and what became of them.
    Fuzz,
}

impl Level {
    /// Every level.
    pub const ALL: [Level; 6] = [
        Level::Promise,
        Level::Error,
        Level::Distribution,
        Level::Verdict,
        Level::Work,
        Level::Fuzz,
    ];

    /// Kebab-case name.
    pub fn id(self) -> &'static str {
        match self {
            Level::Promise => "promise",
            Level::Error => "error",
            Level::Distribution => "distribution",
            Level::Verdict => "verdict",
            Level::Work => "work",
            Level::Fuzz => "fuzz",
        }
    }
}

/// What became of a case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum State {
    /// It ran and has findings.
    Ran,
    /// The engine cannot simulate the scene, and why: that it refuses is a finding of the level [`Level::Error`].
    Refused(String),
    /// It did not run to its end, or found nothing.
    Missing,
}

/// One scene in one engine on one level: something that must have run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
    /// Name of the scene.
    pub scene: String,
    /// Label of the column, or [`ORACLE`].
    pub engine: String,
    /// The level.
    pub level: Level,
    /// What became of it.
    pub state: State,
}

/// Everything that a check found.
#[derive(Clone, Debug)]
pub struct CheckOutcome {
    /// The engines of which scenes may ask something; its reference is behind [`ORACLE`].
    pub roster: Roster,
    /// The scenes, in order.
    pub scenes: Vec<Scene>,
    /// Every number and verdict with its address: by scene, then the oracle, then the columns in order.
    pub findings: Vec<Finding>,
    /// What had to run.
    pub cases: Vec<Case>,
    /// Promises that do not hold.
    pub broken: Vec<Broken>,
    /// Tasks that were done, of those that had to be; fewer only if the user asked to stop.
    pub extent: Extent,
    /// Scene, engine and digest of events and final states: the same digest means the same bits.
    pub bits: Vec<(String, String, String)>,
    /// Number and fingerprint of the random scenes; `None` where none were asked for.
    pub random: Option<(u64, String)>,
    /// Rounding of the scalar of each engine, by label.
    ulps: BTreeMap<String, f64>,
}

/// What one task of the matrix found.
enum Answer {
    Cell(Box<cell::Found>),
    Samples(Vec<Option<Landing>>),
}

/// What one task does: a scene in a column, or its samples in a column or, without one, in the exact engine.
#[derive(Clone, Copy)]
enum Unit {
    Cell(usize, usize),
    Samples(usize, Option<usize>),
}

/// The columns in which a scene runs: the given ones, then what its `try` asks of each engine that is given with its defaults.
///
/// Errors: the scene asks for an engine that is none.
pub fn plan(
    roster: &Roster,
    scene: &Scene,
    columns: &[Configuration],
) -> Result<Vec<Configuration>, PlanError> {
    let mut planned = columns.to_vec();
    for asked in tried(roster, scene)? {
        let given = |column: &&Configuration| {
            column.engine.id() == asked.engine.id() && column.setting.values.is_empty()
        };
        let Some(given) = columns.iter().find(given) else {
            continue;
        };
        let column = Configuration::with(&given.engine, asked.setting);
        if planned.iter().all(|known| known.label() != column.label()) {
            planned.push(column);
        }
    }
    Ok(planned)
}

/// Runs the scenes in the columns and in what they ask for. Answers the same to the bit for any number of threads.
///
/// Errors: a scene asks for an engine that is none.
pub fn study(
    roster: &Roster,
    scenes: &[Scene],
    columns: &[Configuration],
    watch: Watch<'_>,
) -> Result<CheckOutcome, PlanError> {
    let plans = scenes.iter().map(|scene| plan(roster, scene, columns));
    let plans: Vec<Vec<Configuration>> = plans.collect::<Result<_, _>>()?;
    let oracles = ask_oracles(scenes, watch);
    let ensembles: Vec<Option<distribution::Ensemble>> = scenes
        .iter()
        .zip(&oracles)
        .map(|(scene, oracle)| {
            needs_ensemble(scene, oracle.as_ref())
                .then(|| distribution::Ensemble::of(scene))
                .flatten()
        })
        .collect();
    let mut units = Vec::new();
    for (s, scene) in scenes.iter().enumerate() {
        units.extend((0..plans[s].len()).map(|c| Unit::Cell(s, c)));
        if ensembles[s].is_some() {
            units.push(Unit::Samples(s, None));
            // what a scene asks for besides is one run each
            let affordable = (0..columns.len()).filter(|&c| distribution::runs(scene, &columns[c]));
            units.extend(affordable.map(|c| Unit::Samples(s, Some(c))));
        }
    }
    let tasks: Vec<Task> = units
        .iter()
        .map(|unit| task(unit, scenes, &plans))
        .collect();
    let answers = run_tasks(&tasks, MOST_EVENTS, watch, |index, runner| {
        match units[index] {
            Unit::Cell(s, c) => Answer::Cell(Box::new(cell::run(
                &scenes[s],
                &plans[s][c],
                oracles[s].as_ref(),
                runner,
            ))),
            Unit::Samples(s, c) => {
                Answer::Samples(ensembles[s].as_ref().map_or(Vec::new(), |ensemble| {
                    ensemble.run(c.map(|c| &plans[s][c]), runner)
                }))
            }
        }
    });
    Ok(conclude(roster, scenes, &plans, &oracles, &units, answers))
}

/// True where the scene has no single answer to its end: the horizon comes before, or it asks for an ensemble itself.
fn needs_ensemble(scene: &Scene, oracle: Option<&Oracle>) -> bool {
    scene.simultaneous == Simultaneous::Ensemble || oracle.is_some_and(|oracle| !oracle.is_single())
}

fn task(unit: &Unit, scenes: &[Scene], plans: &[Vec<Configuration>]) -> Task {
    match *unit {
        Unit::Cell(s, c) => Task {
            cost: cost(&scenes[s], &plans[s][c]),
            label: format!("{} in {}", scenes[s].name, plans[s][c].label()),
        },
        Unit::Samples(s, c) => Task {
            cost: c.map_or(0.0, |c| {
                distribution::SAMPLES as f64 * cost(&scenes[s], &plans[s][c])
            }),
            label: format!("samples of {}", scenes[s].name),
        },
    }
}

fn conclude(
    roster: &Roster,
    scenes: &[Scene],
    plans: &[Vec<Configuration>],
    oracles: &[Option<Oracle>],
    units: &[Unit],
    answers: Vec<Option<Answer>>,
) -> CheckOutcome {
    let mut outcome = CheckOutcome {
        roster: roster.clone(),
        scenes: scenes.to_vec(),
        findings: Vec::new(),
        cases: Vec::new(),
        broken: Vec::new(),
        extent: Extent::of(
            answers.iter().flatten().count() as u64,
            answers.len() as u64,
        ),
        bits: Vec::new(),
        random: None,
        ulps: BTreeMap::new(),
    };
    let mut answers: Vec<(Unit, Option<Answer>)> = units.iter().copied().zip(answers).collect();
    for (s, scene) in scenes.iter().enumerate() {
        let (own, rest): (Vec<_>, Vec<_>) =
            mem::take(&mut answers)
                .into_iter()
                .partition(|(unit, _)| match unit {
                    Unit::Cell(of, _) | Unit::Samples(of, _) => *of == s,
                });
        answers = rest;
        let hard = scene.is_in(SetName::Hard);
        outcome.expect(scene, ORACLE, [Level::Error]);
        let findings = oracles[s].as_ref().map(|o| oracle::findings(scene, o));
        outcome.add(findings);
        let mut reference = None;
        for (unit, answer) in own {
            match (unit, answer) {
                (Unit::Cell(_, c), answer) => {
                    let label = plans[s][c].label();
                    let levels = [Level::Promise, Level::Error, Level::Work];
                    outcome.expect(scene, &label, levels);
                    outcome.expect(scene, &label, hard.then_some(Level::Verdict));
                    if let Some(Answer::Cell(found)) = answer {
                        outcome.take(scene, &label, *found);
                    }
                }
                (Unit::Samples(_, None), answer) => {
                    outcome.expect(scene, ORACLE, [Level::Distribution]);
                    if let Some(Answer::Samples(landings)) = answer {
                        let found = distribution::findings(scene, ORACLE, &landings, None);
                        outcome.add(Some(found));
                        reference = Some(landings);
                    }
                }
                (Unit::Samples(_, Some(c)), answer) => {
                    let label = plans[s][c].label();
                    outcome.expect(scene, &label, [Level::Distribution]);
                    if let Some(Answer::Samples(landings)) = answer {
                        let against = reference.as_deref();
                        let found = distribution::findings(scene, &label, &landings, against);
                        outcome.add(Some(found));
                    }
                }
            }
        }
    }
    outcome.settle();
    outcome
}

impl CheckOutcome {
    fn expect(&mut self, scene: &Scene, engine: &str, levels: impl IntoIterator<Item = Level>) {
        let case = |level| Case {
            scene: scene.name.clone(),
            engine: engine.to_owned(),
            level,
            state: State::Missing,
        };
        self.cases.extend(levels.into_iter().map(case));
    }

    fn add(&mut self, findings: Option<Vec<Finding>>) {
        self.findings.extend(findings.into_iter().flatten());
    }

    fn take(&mut self, scene: &Scene, label: &str, found: cell::Found) {
        self.findings.extend(found.findings);
        self.broken.extend(found.broken);
        if let Some(refused) = found.refused {
            let own = |case: &&mut Case| {
                case.scene == scene.name && case.engine == label && case.level != Level::Error
            };
            for case in self.cases.iter_mut().filter(own) {
                case.state = State::Refused(refused.clone());
            }
        }
        if let Some(bits) = found.bits {
            let entry = (scene.name.clone(), label.to_owned(), bits);
            self.bits.push(entry);
        }
        let ulp = self.ulps.entry(label.to_owned()).or_insert(found.ulp);
        *ulp = ulp.max(found.ulp);
    }

    /// A case ran if it found something.
    fn settle(&mut self) {
        for case in &mut self.cases {
            let own = |finding: &Finding| {
                finding.scene == case.scene
                    && finding.engine == case.engine
                    && level(finding.metric) == case.level
            };
            if case.state == State::Missing && self.findings.iter().any(own) {
                case.state = State::Ran;
            }
        }
    }

    /// What findings are accepted of, in order, with its fingerprint: the scenes, and the random ones as a whole.
    pub fn parts(&self) -> Vec<(String, String)> {
        let scenes = self.scenes.iter();
        let mut parts: Vec<_> = scenes.map(|s| (s.name.clone(), s.hash())).collect();
        let random = self.random.iter();
        parts.extend(random.map(|(_, hash)| (RANDOM.to_owned(), hash.clone())));
        parts
    }

    /// Names of the parts, in order.
    pub fn names(&self) -> Vec<&str> {
        let scenes = self.scenes.iter().map(|scene| scene.name.as_str());
        scenes.chain(self.random.iter().map(|_| RANDOM)).collect()
    }

    /// What stands before everything else where the user asked to stop before it was done.
    pub fn stopped_early(&self) -> Option<String> {
        self.extent.stopped_early("tasks of the check were done")
    }

    /// Cases that did not run to their end.
    pub fn missing(&self) -> usize {
        let missing = self.cases.iter().filter(|c| c.state == State::Missing);
        missing.count()
    }

    /// The findings of one scene.
    pub fn of_scene<'a>(&'a self, scene: &'a str) -> impl Iterator<Item = &'a Finding> {
        self.findings.iter().filter(move |f| f.scene == scene)
    }

    /// By how much a figure may move in the engine with this label.
    pub fn tolerance(&self, engine: &str, metric: &str) -> Tolerance {
        let ulp = self.ulps.get(engine).copied().unwrap_or(f64::EPSILON);
        tolerance(metric, ulp)
    }
}

/// How long a cell takes, ns, roughly; 0 where the setting is refused.
fn cost(scene: &Scene, column: &Configuration) -> f64 {
    let pace = column.engine.pace(scene, &column.setting);
    pace.map_or(0.0, |pace| pace.cost * scene.duration)
}
