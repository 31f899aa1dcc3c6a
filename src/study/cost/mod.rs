//! What accuracy costs: for one scene, how wrong each engine is at each setting, and for how much time.
//!
//! Plan: every ladder of every engine from coarse to fine, each level from several starts shifted within its step. Conclusion: the
//! error of each level in what users read off, its time alone on the machine, the cheapest way to each error, how errors fall
//! along a ladder, and which setting holds them where they do not.

mod cause;
mod plan;
pub mod price;
mod price_list;
mod quantity;
mod verdict;

pub use cause::{Cause, Parameters, Substitution};
pub use plan::{Family, Grid, Level};

pub use price::{HIGH_FROM, Offer, THRESHOLDS, cheapest, front, noise, offers};
pub use price_list::{Price, PriceList};
pub use quantity::{Errors, Quantity};
pub use verdict::{Fit, GAINS, Kind, Verdict, in_order};

use super::Extent;
use super::compare::default_columns;
use super::matrix::{self, Configuration, Effort, Job, Timed, Watch};
use crate::compare::closest_hits;
use crate::engine::{Limits, Roster};
use crate::math::statistics::Distribution;
use crate::oracle::{self, Absence, Precision};
use crate::scene::Scene;
use crate::trace::{Record, Trace};
use crate::words::describe_ending;
use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};

/// Everything that a study of cost found.
#[derive(Debug)]
pub struct CostOutcome {
    /// The scene; its duration ends where the oracle can no longer be believed.
    pub scene: Scene,
    /// How much was run.
    pub grid: Grid,
    /// The engines and what was set for them, as asked for; empty for every engine.
    pub named: Vec<Configuration>,
    /// Why there is nothing to hold errors against, in one sentence; `None` if there is.
    pub no_oracle: Option<String>,
    /// When the oracle's horizon ends the study before the scene's own end, s.
    pub certain_until: Option<f64>,
    /// Simulated time of the shot, s.
    pub simulated: f64,
    /// The smallest time between two collisions of one ball, s; `None` without an oracle, or where no ball has two.
    pub closest_hits: Option<f64>,
    /// Every family, in the order of the engines.
    pub families: Vec<Measured>,
    /// Levels that were run from every start and timed, of those planned; a level that its engine refuses is done.
    pub levels: Extent,
    /// Whether the user asked to stop before everything was done: every level, and the searches for what holds errors.
    pub stopped: bool,
}

impl CostOutcome {
    /// What stands before everything else where the user asked to stop before it was done.
    pub fn stopped_early(&self) -> Option<String> {
        if !self.stopped {
            return None;
        }
        let levels = self
            .levels
            .stopped_early("settings were both run and timed");
        Some(levels.unwrap_or_else(|| {
            "This was stopped early: every setting was run and timed, and not everything that says why they err."
                .to_owned()
        }))
    }
}

/// A family with what its runs gave.
#[derive(Debug)]
pub struct Measured {
    /// What was run.
    pub family: Family,
    /// One entry a level.
    pub points: Vec<Point>,
    /// Whether every level was run from every start; otherwise the user asked to stop before.
    pub whole: bool,
    /// How its errors fall; `None` where nothing ran, and for a family that is not whole.
    pub verdict: Option<Verdict>,
    /// Which setting is responsible where they do not; `None` where nothing has to be explained or the search was not run.
    pub cause: Option<Cause>,
}

/// One level with what its runs gave.
#[derive(Clone, Debug)]
pub struct Point {
    /// What was run.
    pub level: Level,
    /// Errors of each start; empty if the user asked to stop before all of them were run.
    pub errors: Vec<Errors>,
    /// Whether every start was run; otherwise the user asked to stop before.
    pub whole: bool,
    /// Every effective parameter; empty where nothing ran.
    pub parameters: Parameters,
    /// Its time; `None` if the user asked to stop before.
    pub timed: Option<Timed>,
}

impl Point {
    /// Mean error over the starts; `None` where there is no such quantity or a run has no answer. Infinite if one is.
    pub fn error(&self, quantity: Quantity) -> Option<f64> {
        mean(self.errors.iter().map(|errors| errors.get(quantity)))
    }

    /// Smallest and largest error over the starts.
    pub fn range(&self, quantity: Quantity) -> Option<(f64, f64)> {
        let values: Option<Vec<f64>> = self.errors.iter().map(|e| e.get(quantity)).collect();
        let values = Distribution::of(values?)?;
        Some((values.least(), values.most()))
    }

    /// Largest gain of kinetic energy over the starts, E0.
    pub fn gained(&self) -> Option<f64> {
        self.errors
            .iter()
            .filter_map(|errors| errors.gained)
            .reduce(f64::max)
    }

    /// Starts whose run did not reach the end that the scene asks for.
    pub fn failed(&self) -> usize {
        self.errors.iter().filter(|errors| !errors.complete).count()
    }

    /// Shortest time of a run, s.
    pub fn seconds(&self) -> Option<f64> {
        self.timed.as_ref().map(|timed| timed.seconds)
    }
}

/// The mean, or nothing where a value is missing.
fn mean(values: impl Iterator<Item = Option<f64>>) -> Option<f64> {
    let values: Vec<f64> = values.collect::<Option<_>>()?;
    let count = values.len() as f64;
    (count > 0.0).then(|| values.iter().sum::<f64>() / count)
}

/// Runs of one shifted start: the scene, and the oracle's run of it.
struct Start {
    scene: Scene,
    oracle: Option<Trace>,
}

/// What the oracle runs in: more digits than any engine of the study but itself.
fn oracle_column() -> Configuration {
    Configuration::with(oracle::engine(), oracle::finest())
}

/// Runs the study of one scene. `named`: engines, with settings that hold at every level; empty for every engine. One that refuses its
/// setting is a family without levels that says why.
pub fn study(
    roster: &Roster,
    scene: &Scene,
    named: &[Configuration],
    grid: Grid,
    watch: Watch<'_>,
) -> CostOutcome {
    let mut scene = scene.clone();
    let limits = Limits {
        cancelled: watch.cancelled,
        ..Limits::NONE
    };
    let believed = watch.whole(|| oracle::believed_until(&scene, Precision::Dd, &limits));
    let certain_until = believed.flatten();
    if let Some(until) = certain_until {
        scene.duration = until;
    }
    let base = first(matrix::run_jobs(
        &[Job {
            scene: &scene,
            column: oracle_column(),
            weight: 1.0,
        }],
        Record::Events,
        watch.cancelled,
        |_| {},
        |_, ran| ran,
    ));
    let stopped = believed.is_none() || base.is_none();
    let answer = match &base {
        None => Err(Absence::Stopped),
        Some(ran) => oracle::answer(ran.as_ref()),
    };
    let no_oracle = answer
        .err()
        .map(|absence| absence.in_words(describe_ending));
    let base = base.and_then(Result::ok);
    let simulated = match (&base, &no_oracle) {
        (Some(trace), None) => trace.end_time,
        _ => longest(roster, &scene, watch),
    };
    let closest_hits = match &no_oracle {
        None => {
            let closest = base.as_ref().and_then(|base| closest_hits(base, true));
            closest.map(|hits| hits.apart)
        }
        Some(_) => None,
    };
    let families = plan::families(roster, &scene, named, grid, simulated);
    let mut outcome = CostOutcome {
        grid,
        named: named.to_vec(),
        no_oracle,
        certain_until,
        simulated,
        closest_hits,
        families: Vec::new(),
        levels: Extent::default(),
        stopped: false,
        scene,
    };
    let planned = families
        .iter()
        .flat_map(|family| &family.levels)
        .map(|level| level.work(simulated));
    let runs = Runs {
        scene: &outcome.scene.clone(),
        base,
        simulated,
        starts: HashMap::new(),
        done: AtomicU64::new(0),
        planned: planned.sum(),
        watch,
        stopped,
    };
    runs.fill(&mut outcome, families);
    outcome
}

/// Simulated time until the last of the default engines comes to its end, s: what a shot takes where the oracle does not know.
fn longest(roster: &Roster, scene: &Scene, watch: Watch<'_>) -> f64 {
    let job = |column| Job {
        scene,
        column,
        weight: 1.0,
    };
    let jobs: Vec<Job<'_>> = default_columns(roster).into_iter().map(job).collect();
    let ends = matrix::run_jobs(
        &jobs,
        Record::Final,
        watch.cancelled,
        |_| {},
        |_, ran| {
            ran.ok()
                .filter(|trace| trace.ending.is_complete())
                .map(|trace| trace.end_time)
        },
    );
    let ends = ends.into_iter().flatten().flatten();
    ends.reduce(f64::max).unwrap_or(scene.duration)
}

fn first<T>(answers: Vec<Option<T>>) -> Option<T> {
    answers.into_iter().next().flatten()
}

/// Runs what a study plans, and tells how far it is.
struct Runs<'a> {
    scene: &'a Scene,
    /// The exact run of the scene, as far as it goes.
    base: Option<Trace>,
    /// Simulated time of the shot, s.
    simulated: f64,
    /// Starts by step and number of starts.
    starts: HashMap<(u64, usize), Vec<Start>>,
    /// Work that is done, and work that is planned, ns.
    done: AtomicU64,
    planned: f64,
    watch: Watch<'a>,
    /// Whether anything was left out because the user asked to stop.
    stopped: bool,
}

/// How often a cell is timed.
const EFFORT: Effort = Effort {
    least_runs: 2,
    most_runs: 100,
    seconds: 0.03,
};

impl<'a> Runs<'a> {
    /// Work of one run of a level, ns.
    fn work(&self, level: &Level) -> f64 {
        level.pace.cost * self.simulated
    }

    fn tell(&self, work: f64, what: &str) {
        let done = self.done.fetch_add(work as u64, Ordering::Relaxed) + work as u64;
        // in steps of a hundredth of a second of work
        let in_steps = |nanoseconds: f64| (nanoseconds * 1e-7) as usize;
        let planned = in_steps(self.planned).max(1);
        (self.watch.progress)(in_steps(done as f64).min(planned), planned, what);
    }

    /// Everything, in order: errors, verdicts, causes, times.
    fn fill(mut self, outcome: &mut CostOutcome, families: Vec<Family>) {
        let levels: Vec<Level> = families
            .iter()
            .flat_map(|f| f.levels.iter().cloned())
            .collect();
        let mut errors = self.errors(&levels).into_iter();
        for family in families {
            let mut whole = true;
            let points: Vec<Point> = family
                .levels
                .iter()
                .zip(errors.by_ref())
                .map(|(level, found)| {
                    let of_level = found.is_some();
                    whole &= of_level;
                    let (errors, parameters) = found.unwrap_or_default();
                    Point {
                        whole: of_level,
                        level: level.clone(),
                        errors,
                        parameters,
                        timed: None,
                    }
                })
                .collect();
            outcome.families.push(Measured {
                // a ladder that lacks a rung says nothing about how errors fall
                verdict: whole.then(|| verdict::judge(&points)).flatten(),
                whole,
                cause: None,
                points,
                family,
            });
        }
        cause::find(outcome, &mut self);
        self.time(outcome);
        outcome.stopped = self.stopped || outcome.levels.is_cut_short();
    }

    /// Errors of every start of every level, and the effective parameters of the level; `None` for a level of which a start was not run
    /// to its end because the user asked to stop.
    fn errors(&mut self, levels: &[Level]) -> Vec<Option<(Vec<Errors>, Parameters)>> {
        for level in levels {
            self.start(level);
        }
        let key = |level: &Level| (level.pace.step.to_bits(), level.phases);
        let mut owners = Vec::new();
        let mut jobs = Vec::new();
        for (k, level) in levels.iter().enumerate() {
            for start in &self.starts[&key(level)] {
                owners.push((k, start));
                jobs.push(Job {
                    scene: &start.scene,
                    column: level.column.clone(),
                    weight: self.work(level),
                });
            }
        }
        let cadence = self.simulated / quantity::ENERGY_TIMES as f64;
        let ran = matrix::run_jobs(
            &jobs,
            Record::Every(cadence),
            self.watch.cancelled,
            |job| self.tell(job.weight, &job.column.label()),
            |k, ran| {
                let start = owners[k].1;
                let measured = ran.map(|trace| {
                    let errors = Errors::of(&start.scene, &trace, start.oracle.as_ref());
                    (errors, trace.provenance.parameters)
                });
                measured.unwrap_or_default()
            },
        );
        let mut found = vec![Some((Vec::new(), Parameters::new())); levels.len()];
        for ((k, _), ran) in owners.iter().zip(ran) {
            let level = &mut found[*k];
            match (level.as_mut(), ran) {
                (Some((all, of_level)), Some((errors, parameters))) => {
                    all.push(errors);
                    *of_level = parameters;
                }
                _ => *level = None,
            }
        }
        self.stopped |= found.iter().any(Option::is_none);
        found
    }

    /// Makes the starts of a level, and runs the oracle on them.
    fn start(&mut self, level: &Level) {
        let key = (level.pace.step.to_bits(), level.phases);
        if self.starts.contains_key(&key) {
            return;
        }
        let phase = |k: usize| k as f64 / level.phases as f64;
        let shifted = (0..level.phases).filter_map(|k| match &self.base {
            Some(base) if k > 0 => plan::shifted(self.scene, base, level.pace.step, phase(k)),
            Some(_) => Some(self.scene.clone()),
            None => (k == 0).then(|| self.scene.clone()),
        });
        let scenes: Vec<Scene> = shifted.collect();
        let jobs: Vec<Job<'_>> = scenes
            .iter()
            .map(|scene| Job {
                scene,
                column: oracle_column(),
                weight: 1.0,
            })
            .collect();
        let oracles = matrix::run_jobs(
            &jobs,
            Record::Events,
            self.watch.cancelled,
            |_| {},
            |_, ran| ran.ok().filter(|trace| trace.ending.is_complete()),
        );
        let start = |(scene, oracle): (Scene, Option<Option<Trace>>)| Start {
            scene,
            oracle: oracle.flatten(),
        };
        let starts = scenes.into_iter().zip(oracles).map(start).collect();
        self.starts.insert(key, starts);
    }

    /// Times every level, alone: the families in turn, from the cheapest level on, so that a study that was stopped has the
    /// cheap ones of all.
    fn time(&self, outcome: &mut CostOutcome) {
        let mut order: Vec<(usize, usize)> = Vec::new();
        for (f, measured) in outcome.families.iter().enumerate() {
            order.extend((0..measured.points.len()).map(|p| (f, p)));
        }
        let work = |&(f, p): &(usize, usize)| self.work(&outcome.families[f].points[p].level);
        order.sort_by(|a, b| work(a).total_cmp(&work(b)));
        for (f, p) in order {
            let level = &outcome.families[f].points[p].level;
            let column = Configuration {
                setting: level.column.engine.awake(&level.column.setting),
                ..level.column.clone()
            };
            let work = plan::TIMING_RUNS * self.work(level);
            let timed = matrix::time_alone(self.scene, &column, EFFORT, self.watch.cancelled);
            self.tell(work, &format!("timing {}", column.label()));
            // one that its engine refuses has no time, and lacks none
            let has_time = !matches!(timed, Ok(None));
            let point = &mut outcome.families[f].points[p];
            point.timed = timed.ok().flatten();
            outcome.levels.count(has_time && point.whole);
        }
    }
}
