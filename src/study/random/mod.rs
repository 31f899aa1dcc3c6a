//! Random scenes that look for trouble, in engines that promise to hold: what must be true of every run is checked of each, and every impact
//! and motion by closed forms that share nothing with the engines' laws.
//!
//! Plan: scene by scene, made as a file, read as any file, run in every engine within a limit of events, and judged. Conclusion:
//! how the runs ended, the worst of each bound with its scene, and every fault with the number of its scene, which anybody can
//! make again.

mod verdict;

pub use verdict::{Verdict, check};

use super::Extent;
use super::matrix::{self, Configuration, Watch};
use crate::engine::{Limits, Refusal};
use crate::law::Fault;
use crate::law::closed_forms::{self, Laws};
use crate::physics::invariants::Invariant;
use crate::scene::adversarial::adversarial;
use crate::scene::{Scene, parse};
use crate::trace::{Ending, Record};
use std::any::Any;
use std::collections::BTreeMap;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::AtomicBool;

/// Every so many scenes are also swept for collisions that a trace passed over.
pub const SWEPT: u64 = 10;

/// Faults that are kept with their words; the rest is counted.
const KEPT: usize = 1000;

/// What to run.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Index of the first scene.
    pub first: u64,
    /// Number of scenes; those whose index would be beyond [`u64::MAX`] - 1 do not exist.
    pub scenes: u64,
    /// Seed of all of them.
    pub seed: u64,
    /// Engines, each with its own setting over that of the scene's `try`.
    pub columns: Vec<Configuration>,
    /// Events after which an event-driven run ends.
    pub max_events: u64,
}

impl Plan {
    /// The indices of the scenes.
    pub fn indices(&self) -> Range<u64> {
        self.first..self.first.saturating_add(self.scenes)
    }
}

/// The worst of something and the scene it was seen in.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// The value; 0 where nothing was seen.
    pub value: f64,
    /// Index of the scene.
    pub scene: u64,
}

impl Worst {
    fn see(&mut self, value: f64, scene: u64) {
        if value > self.value {
            *self = Worst { value, scene };
        }
    }
}

/// What was seen of one engine.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RandomEntry {
    /// Runs by the id of their ending; `refused` where nothing ran.
    pub endings: BTreeMap<&'static str, u64>,
    /// Events of all runs.
    pub events: u64,
    /// Most events of a run.
    pub longest: Worst,
    /// Largest rise of the energy above its start, in the energy at the start.
    pub energy: Worst,
    /// Farthest outside, in what is allowed.
    pub outside: Worst,
    /// Deepest overlap, in what is allowed.
    pub overlap: Worst,
    /// Scenes swept for collisions that were passed over.
    pub swept: u64,
    /// Questions of the sweeps to parry.
    pub casts: u64,
    /// Pairs that a sweep gave up.
    pub given_up: u64,
    /// What was held against the laws.
    pub laws: Held,
}

/// What was held against the laws in all runs of an engine that promises them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Held {
    /// Impacts that were held whole.
    pub impacts: u64,
    /// Farthest from its law, in what is allowed.
    pub impact: Worst,
    /// Impacts without a closed form that were integrated again.
    pub integrated: u64,
    /// Farthest from its second integral, in what is allowed.
    pub integral: Worst,
    /// Pieces of paths between events.
    pub pieces: u64,
    /// Farthest from its law, in what is allowed.
    pub piece: Worst,
    /// What could not be held whole, by the reason.
    pub left_out: BTreeMap<&'static str, u64>,
}

impl Held {
    fn see(&mut self, laws: &Laws, scene: u64) {
        self.impacts += laws.impacts;
        self.integrated += laws.integrated;
        self.pieces += laws.pieces;
        self.impact.see(laws.impact, scene);
        self.integral.see(laws.integral, scene);
        self.piece.see(laws.piece, scene);
        for (why, count) in &laws.left_out {
            *self.left_out.entry(why).or_default() += count;
        }
    }

    fn add(&mut self, more: Held) {
        self.impacts += more.impacts;
        self.integrated += more.integrated;
        self.pieces += more.pieces;
        for (worst, other) in [
            (&mut self.impact, more.impact),
            (&mut self.integral, more.integral),
            (&mut self.piece, more.piece),
        ] {
            worst.see(other.value, other.scene);
        }
        for (why, count) in more.left_out {
            *self.left_out.entry(why).or_default() += count;
        }
    }
}

/// A scene that shows a fault.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// Index of the scene.
    pub scene: u64,
    /// Engine and setting; empty where the scene itself is at fault.
    pub engine: String,
    /// What must not be.
    pub fault: Fault,
}

/// Everything that was found.
#[derive(Clone, Debug)]
pub struct RandomOutcome {
    /// What was asked for.
    pub plan: Plan,
    /// Scenes that were run in every engine.
    pub done: u64,
    /// Scenes that were seen to their end: those, and the ones that are at fault themselves.
    pub seen: u64,
    /// One entry an engine, in the order of the plan.
    pub entries: Vec<RandomEntry>,
    /// Faults in the order of scenes, the first thousand.
    pub failures: Vec<Failure>,
    /// Number of all faults.
    pub faults: u64,
}

/// Runs the scenes of a plan. Answers the same for any number of threads.
pub fn study(plan: Plan, watch: Watch<'_>) -> RandomOutcome {
    let block = |range: Range<u64>| {
        let mut found = RandomOutcome::empty(&plan);
        for index in range {
            if watch.is_cancelled() {
                break;
            }
            found.run(index, watch.cancelled);
        }
        found
    };
    let mut outcome = RandomOutcome::empty(&plan);
    let what = "random scenes";
    matrix::fold_blocks(plan.indices(), what, watch, block, |found| {
        outcome.add(found);
    });
    outcome
}

/// The text of the file of scene `index`; `None` only if the file type holds what a file cannot.
pub fn text(seed: u64, index: u64) -> Option<String> {
    adversarial(seed, index).text().ok()
}

/// The scene with this index, through its file.
pub fn scene(seed: u64, index: u64) -> Result<Scene, Fault> {
    let file = adversarial(seed, index);
    let text = file
        .text()
        .map_err(|error| Fault::new("cannot-be-written", error.to_string()))?;
    parse(&file.name, &text).map_err(|error| Fault::new("no-scene", error.to_string()))
}

/// Runs a scene in one column and checks the trace: how it ended, its number of events, and the verdict. `sweeps`: see [`check`].
pub fn judge(
    scene: &Scene,
    column: &Configuration,
    limits: &Limits<'_>,
    sweeps: bool,
) -> Result<(Ending, u64, Verdict), Refusal> {
    let trace = matrix::run_one(scene, column, Record::Events, limits)?;
    let mut verdict = check(scene, &trace, sweeps);
    let promised = column.engine.promises(scene, &column.setting);
    if promised.contains(&Invariant::Laws) {
        let mut laws = closed_forms::check(scene, &trace);
        verdict.faults.append(&mut laws.faults);
        verdict.laws = Some(laws);
    }
    Ok((trace.ending, trace.events.len() as u64, verdict))
}

impl RandomOutcome {
    /// What stands before everything else where the user asked to stop before it was done.
    pub fn stopped_early(&self) -> Option<String> {
        self.extent()
            .stopped_early("scenes were run in every engine")
    }

    /// Scenes that were seen to their end, of those that there are.
    pub fn extent(&self) -> Extent {
        let indices = self.plan.indices();
        Extent::of(self.seen, indices.end - indices.start)
    }

    fn empty(plan: &Plan) -> Self {
        RandomOutcome {
            plan: plan.clone(),
            done: 0,
            seen: 0,
            entries: vec![RandomEntry::default(); plan.columns.len()],
            failures: Vec::new(),
            faults: 0,
        }
    }

    /// Runs one scene in every engine. The only place where a panic is caught: it is a defect, and the scene that shows it is named.
    fn run(&mut self, index: u64, cancelled: &AtomicBool) {
        let seed = self.plan.seed;
        let scene = match caught(|| scene(seed, index)) {
            Ok(Ok(scene)) => scene,
            Ok(Err(fault)) | Err(fault) => {
                self.seen += 1;
                return self.fail(index, String::new(), fault);
            }
        };
        let limits = Limits {
            max_events: self.plan.max_events,
            cancelled,
        };
        let sweeps = index.is_multiple_of(SWEPT);
        let mut found = Vec::new();
        for column in &self.plan.columns {
            let column = column.as_tried(&scene);
            let judged = caught(|| judge(&scene, &column, &limits, sweeps));
            // what not every engine has run is nobody's
            if let Ok(Err(Refusal::Stopped)) = judged {
                return;
            }
            found.push((column, judged));
        }
        for (number, (column, judged)) in found.into_iter().enumerate() {
            let entry = &mut self.entries[number];
            let faults = match judged {
                Err(fault) => vec![fault],
                Ok(Err(_)) => {
                    *entry.endings.entry("refused").or_default() += 1;
                    Vec::new()
                }
                Ok(Ok((ending, events, verdict))) => {
                    entry.see(index, ending.id(), events, &verdict);
                    verdict.faults
                }
            };
            for fault in faults {
                self.fail(index, column.label(), fault);
            }
        }
        self.done += 1;
        self.seen += 1;
    }

    fn fail(&mut self, scene: u64, engine: String, fault: Fault) {
        self.faults += 1;
        if self.failures.len() < KEPT {
            self.failures.push(Failure {
                scene,
                engine,
                fault,
            });
        }
    }

    /// Adds what was found of later scenes.
    fn add(&mut self, later: RandomOutcome) {
        self.done += later.done;
        self.seen += later.seen;
        self.faults += later.faults;
        let room = KEPT - self.failures.len();
        self.failures.extend(later.failures.into_iter().take(room));
        for (entry, more) in self.entries.iter_mut().zip(later.entries) {
            entry.add(more);
        }
    }
}

impl RandomEntry {
    fn see(&mut self, scene: u64, ending: &'static str, events: u64, verdict: &Verdict) {
        *self.endings.entry(ending).or_default() += 1;
        self.events += events;
        self.longest.see(events as f64, scene);
        self.energy.see(verdict.energy, scene);
        self.outside.see(verdict.outside, scene);
        self.overlap.see(verdict.overlap, scene);
        if let Some(sweep) = &verdict.sweep {
            self.swept += 1;
            self.casts += sweep.casts;
            self.given_up += sweep.given_up + sweep.lasting;
        }
        if let Some(laws) = &verdict.laws {
            self.laws.see(laws, scene);
        }
    }

    fn add(&mut self, more: RandomEntry) {
        for (ending, count) in more.endings {
            *self.endings.entry(ending).or_default() += count;
        }
        self.events += more.events;
        self.swept += more.swept;
        self.casts += more.casts;
        self.given_up += more.given_up;
        self.laws.add(more.laws);
        for (worst, other) in [
            (&mut self.longest, more.longest),
            (&mut self.energy, more.energy),
            (&mut self.outside, more.outside),
            (&mut self.overlap, more.overlap),
        ] {
            worst.see(other.value, other.scene);
        }
    }
}

/// What `f` answers, or the fault that it panicked.
pub(super) fn caught<T>(f: impl FnOnce() -> T) -> Result<T, Fault> {
    // nothing outlives a panic here but counts that it did not reach
    catch_unwind(AssertUnwindSafe(f)).map_err(|panic| Fault::new("panic", words(panic.as_ref())))
}

fn words(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    text.unwrap_or("a panic without words").to_owned()
}
