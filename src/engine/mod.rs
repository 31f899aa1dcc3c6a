//! The border between scenes and engines: what an engine is, and the only way to a run.
//!
//! [`prepare`] asks what is missing, builds the run, and audits that what is inside the engine is the scene. Inside this
//! module no engine knows another; adding one is a folder and one line in [`Roster::built_in`]. What every engine needs that advances a
//! whole world by fixed steps is in [`stepped`], which is no engine.

mod audit;
pub mod built;
mod clock;
pub mod exact;
mod preset;
pub mod rapier;
mod roster;
mod setting;
pub mod sheet;
pub mod stepped;
pub mod stepper;

pub use audit::{Inside, PairMaterial, Partner};
pub use built::Built;
pub use preset::Preset;
pub use roster::{Roster, Twice, UnknownEngine};
pub use setting::{Knob, KnobRole, Setting};
pub use sheet::{Parameter, Role};

use crate::physics::invariants::Invariant;
use crate::scene::Scene;
use crate::trace::{Record, Trace};
use std::borrow::Cow;
use std::sync::atomic::{AtomicBool, Ordering};
use thiserror::Error;

/// A name or a phrase: a constant of a built-in engine, or made by one that says of itself what it is called.
pub type Name = Cow<'static, str>;

/// One way to simulate a scene.
pub trait Engine: Send + Sync {
    /// Unique kebab-case name.
    fn id(&self) -> &str;

    /// Name, version and source of what does the work, such as `rapier3d-f64 0.36.1 (registry)`.
    fn version(&self) -> String;

    /// The crates of others that it was built from; none where the workbench itself does the work.
    fn built(&self) -> Vec<Built> {
        Vec::new()
    }

    /// What it is and how it solves in time, in one sentence; and which code it shares with other engines.
    fn about(&self) -> About;

    /// What engines have in common that differ in their arithmetic alone and take the same settings; else the id.
    fn family(&self) -> &str {
        self.id()
    }

    /// True where it solves for its events and steps no time, so that others can be held against what it answers.
    fn solves(&self) -> bool {
        false
    }

    /// Spacing of the numbers of its scalar just above 1 with this setting.
    fn ulp(&self, _setting: &Setting) -> f64 {
        f64::EPSILON
    }

    /// The knobs of `--set`, with meaning and default.
    fn knobs(&self) -> Vec<Knob>;

    /// Settings by which it is known: the defaults, then others that it is worth comparing by. What runs where none is named.
    fn presets(&self) -> Vec<Preset> {
        vec![Preset::default()]
    }

    /// What the scene calls for and the engine cannot simulate; empty when it can run the scene.
    fn missing(&self, scene: &Scene) -> Vec<Name>;

    /// Invariants that hold for every run of the scene with this setting; a trace that breaks one is a defect.
    fn promises(&self, scene: &Scene, setting: &Setting) -> Vec<Invariant>;

    /// Named families of settings from coarse to fine, for a study of cost; those that matter most first.
    fn ladders(&self) -> Vec<(Name, Vec<Setting>)>;

    /// How it goes through time with this setting, for plans: the only budget. Errors: a setting that it cannot read, or by which it
    /// would never come to an end.
    fn pace(&self, scene: &Scene, setting: &Setting) -> Result<Pace, Refusal>;

    /// Its step with this setting, s; `None` for an engine that has none, and for a setting that it cannot read.
    fn step(&self, setting: &Setting) -> Option<f64> {
        let knob = step_knob(self.knobs())?;
        let given = setting.values.get(&knob.key);
        given.unwrap_or(&knob.default).parse().ok()
    }

    /// The same setting with a step of `dt`, s; `None` for an engine that has none.
    fn with_step(&self, setting: &Setting, dt: f64) -> Option<Setting> {
        let knob = step_knob(self.knobs())?;
        Some(setting.clone().with(&knob.key, format!("{dt:e}")))
    }

    /// The same setting with nothing asleep: what is timed, so that a time is that of the whole scene.
    fn awake(&self, setting: &Setting) -> Setting {
        setting.clone()
    }

    /// Settings that differ from `setting` in one knob each, and what that knob stands for: each removes one source of
    /// error that can act in the scene, so that a study can name the one that makes a difference disappear.
    fn ablations(&self, scene: &Scene, setting: &Setting) -> Vec<(Name, Setting)>;

    /// Builds a run. Call [`prepare`] instead, which also asks and audits.
    fn prepare<'a>(
        &self,
        scene: &'a Scene,
        setting: &Setting,
    ) -> Result<Box<dyn Run + 'a>, Refusal>;
}

/// The knob that is an engine's step.
pub fn step_knob(knobs: Vec<Knob>) -> Option<Knob> {
    knobs.into_iter().find(|knob| knob.role == KnobRole::Step)
}

/// How an engine goes through time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Its step, s; 0 for an engine that solves for its events.
    pub step: f64,
    /// Roughly what a simulated second costs, ns. It says which of two runs is longer and is never shown: measured times are.
    pub cost: f64,
}

/// What a reader should know of an engine before believing its numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct About {
    /// What it is called in a sentence: `the report's model`.
    pub name: Name,
    /// How it solves in time, in one sentence.
    pub method: Name,
    /// Code it shares with other engines; what two engines share cannot be tested by comparing them.
    pub shares: Name,
}

/// A scene that is inside an engine and ready to run.
pub trait Run {
    /// What the engine holds, read back from inside it.
    fn inside(&self) -> Inside;

    /// Every parameter that changes physics.
    fn sheet(&self) -> Vec<Parameter>;

    /// Runs to an [`crate::trace::Ending`]; cannot fail.
    fn simulate(self: Box<Self>, record: Record, limits: &Limits<'_>) -> Trace;
}

/// Most events that a run may be asked for: what belongs to an event names it by 32 bits.
pub const MOST_EVENTS: u64 = 1_000_000_000;

/// What may end a run early.
#[derive(Clone, Copy, Debug)]
pub struct Limits<'a> {
    /// Largest number of events of an event-driven engine; at most [`MOST_EVENTS`].
    pub max_events: u64,
    /// Set when the user asks to stop.
    pub cancelled: &'a AtomicBool,
}

/// A flag that nobody sets.
static NEVER: AtomicBool = AtomicBool::new(false);

impl Limits<'static> {
    /// Ten million events, never cancelled.
    pub const NONE: Limits<'static> = Limits {
        max_events: 10_000_000,
        cancelled: &NEVER,
    };
}

impl Limits<'_> {
    /// True once the user asked to stop.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// What `work` answers; `None` where the user asked to stop before it was done: what was cut short says nothing.
    pub fn whole<T>(&self, work: impl FnOnce() -> T) -> Option<T> {
        if self.is_cancelled() {
            return None;
        }
        let answer = work();
        (!self.is_cancelled()).then_some(answer)
    }
}

/// Why there is no run to conclude from.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Refusal {
    /// The engine cannot simulate what the scene calls for.
    #[error("cannot simulate {}", missing.join(", "))]
    NotComparable {
        /// What it lacks: ids of effects, or a phrase.
        missing: Vec<Name>,
    },
    /// A setting is unknown, of the wrong type, or out of range.
    #[error("{message}")]
    Setting {
        /// The key that is at fault; `None` where no single one is.
        key: Option<String>,
        /// What is wrong and what would be right.
        message: String,
    },
    /// The scene lasts for longer than the clock of any engine can tell.
    #[error(
        "a duration of {duration} s is beyond the clock: it could no longer say where the fastest ball is to a tenth of a \
         radius; {most:.1e} s are the most"
    )]
    TooLong {
        /// The duration of the scene, s.
        duration: f64,
        /// The longest that the fastest ball of the scene can move, s.
        most: f64,
    },
    /// What arrived inside the engine is not the scene.
    #[error("the scene did not arrive in the engine as written: {}", differs.join("; "))]
    Audit {
        /// Each difference in one sentence.
        differs: Vec<String>,
    },
    /// The user asked to stop before it had come to its end. No refusal of the engine's: another time it runs.
    #[error("was stopped before its end")]
    Stopped,
}

/// Asks whether an engine can run a scene at all: whether it lacks something, and whether any clock can tell.
pub fn can_run(engine: &dyn Engine, scene: &Scene) -> Result<(), Refusal> {
    let missing = engine.missing(scene);
    if !missing.is_empty() {
        return Err(Refusal::NotComparable { missing });
    }
    clock::check(scene)
}

/// The only way to a run: asks whether it can be, builds, and audits what is inside.
pub fn prepare<'a>(
    engine: &dyn Engine,
    scene: &'a Scene,
    setting: &Setting,
) -> Result<Box<dyn Run + 'a>, Refusal> {
    can_run(engine, scene)?;
    let run = engine.prepare(scene, setting)?;
    let differs = audit::differences(scene, &run.inside());
    if !differs.is_empty() {
        return Err(Refusal::Audit { differs });
    }
    Ok(run)
}
