//! Which runs a matrix of hard cases needs: presets, steps from coarse to fine, what a scene asks for; and which cost too much.

use crate::engine::{self, ENGINES, Setting};
use crate::oracle::Oracle;
use crate::scene::Scene;
use crate::study::matrix::Column;
use crate::trace::Ending;
use thiserror::Error;

/// Steps in which every stepping engine runs besides its own, s, as written in a setting.
pub const STEPS: [&str; 6] = ["1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "1e-1"];

/// Work of one run above which a step or a tried setting is left to `--full`, steps x balls.
///
/// A step of rapier with one ball more costs some microseconds, one of the stepper some nanoseconds: both bounds are about a tenth of
/// a second a run.
const MOST_WORK: [(&str, f64); 2] = [("rapier", 4e4), ("stepper", 1e7)];

/// Work of one run above which not even `--full` runs it: a minute for rapier, some seconds for the stepper, whose trace of a pair
/// that sticks grows by four states a step.
const OUT_OF_REACH: [(&str, f64); 2] = [("rapier", 2e7), ("stepper", 3e8)];

/// Work of one run above which its events are not kept, steps x balls: only its end is looked at.
pub const MOST_EVENTS: f64 = 3e6;

/// Why a column is in the matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// An engine and preset, in which every case runs.
    Preset,
    /// A step of the preset with this index; the second is the index in [`STEPS`].
    Step(usize, usize),
    /// The scene asks for it.
    Tried,
}

/// Whether a cell runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Always.
    Always,
    /// Only with `--full`: it takes more than its share.
    Full,
    /// Never: it would take minutes.
    Never,
}

/// One cell of the matrix.
#[derive(Clone, Debug)]
pub struct Planned {
    /// Index of the scene.
    pub scene: usize,
    /// Engine and setting.
    pub column: Column,
    /// Why it is here.
    pub role: Role,
    /// Steps x balls of one run; events expected x balls for an engine without steps.
    pub work: f64,
    /// Whether it runs.
    pub reach: Reach,
}

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlanError {
    /// A scene asks for a setting that is none.
    #[error("scene {scene}: `try = \"{setting}\"`: {why}")]
    Try {
        /// Name of the scene.
        scene: String,
        /// The setting as written.
        setting: String,
        /// What is wrong with it.
        why: String,
    },
}

/// The engines and presets in which every case runs when none are named.
pub fn presets() -> Vec<Column> {
    let mut columns = Vec::new();
    for engine in ENGINES {
        columns.push(Column::of(*engine));
        let variant = match engine.id() {
            "stepper" => Some(("contact", "approaching-only")),
            "exact" => None,
            _ => Some(("preset", "stock")),
        };
        columns.extend(variant.map(|(key, value)| Column {
            engine: *engine,
            setting: Setting::default().with(key, value),
        }));
    }
    columns
}

/// True where a step can be set for a preset: it has one, and the setting does not fix it or the defaults around it.
pub fn is_swept(column: &Column) -> bool {
    let steps = column.engine.knobs().iter().any(|knob| knob.key == "dt");
    let fixed = ["dt", "preset"];
    steps
        && !fixed
            .iter()
            .any(|key| column.setting.values.contains_key(*key))
}

/// The cells of one scene.
pub fn cells(
    index: usize,
    scene: &Scene,
    oracle: Option<&Oracle>,
    presets: &[Column],
) -> Result<Vec<Planned>, PlanError> {
    let end = end_time(scene, oracle);
    let mut cells: Vec<Planned> = Vec::new();
    let mut add = |column: Column, role: Role| {
        if cells
            .iter()
            .any(|cell| cell.column.label() == column.label())
        {
            return;
        }
        let work = work(&column, end, scene, oracle);
        let reach = match role {
            Role::Preset => Reach::Always,
            Role::Step(..) | Role::Tried => reach(column.engine.id(), work),
        };
        cells.push(Planned {
            scene: index,
            column,
            role,
            work,
            reach,
        });
    };
    for preset in presets {
        add(preset.clone(), Role::Preset);
    }
    for (p, preset) in presets
        .iter()
        .enumerate()
        .filter(|(_, preset)| is_swept(preset))
    {
        for (s, step) in STEPS.iter().enumerate() {
            // a preset's own step has run already
            if default_step(preset) == step.parse().ok() {
                continue;
            }
            let column = Column {
                engine: preset.engine,
                setting: preset.setting.clone().with("dt", step),
            };
            add(column, Role::Step(p, s));
        }
    }
    for text in &scene.try_settings {
        let column = tried(scene, text)?;
        if presets
            .iter()
            .any(|preset| preset.engine.id() == column.engine.id())
        {
            add(column, Role::Tried);
        }
    }
    Ok(cells)
}

/// Whether a run of a scene with this label is in the matrix of every preset; `None` where no matrix has it.
pub fn reach_of(scene: &Scene, oracle: Option<&Oracle>, label: &str) -> Option<Reach> {
    let planned = cells(0, scene, oracle, &presets()).ok()?;
    let own = planned.iter().find(|cell| cell.column.label() == label);
    own.map(|cell| cell.reach)
}

/// `ENGINE KEY=VALUE ...` as a column.
pub(in crate::study) fn tried(scene: &Scene, text: &str) -> Result<Column, PlanError> {
    let wrong = |why: String| PlanError::Try {
        scene: scene.name.clone(),
        setting: text.to_owned(),
        why,
    };
    let mut words = text.split_whitespace();
    let id = words.next().unwrap_or_default();
    let engine = engine::find(id).ok_or_else(|| wrong(format!("no engine is called `{id}`")))?;
    let setting = Setting::parse(words).map_err(|refusal| wrong(refusal.to_string()))?;
    Ok(Column { engine, setting })
}

/// The step of a column, s; `None` for an engine without one.
pub fn step_of(column: &Column) -> Option<f64> {
    let given = column.setting.values.get("dt");
    given.map_or_else(|| default_step(column), |dt| dt.parse().ok())
}

fn default_step(column: &Column) -> Option<f64> {
    let stock = column
        .setting
        .values
        .get("preset")
        .is_some_and(|preset| preset == "stock");
    let knobs = column.engine.knobs();
    let knob = knobs.iter().find(|knob| knob.key == "dt")?;
    if stock {
        // rapier's own
        return Some(1.0 / 60.0);
    }
    knob.default.parse().ok()
}

/// When a run of the scene ends, s: when everything rests, as far as the oracle knows, else after its duration.
fn end_time(scene: &Scene, oracle: Option<&Oracle>) -> f64 {
    let rest = oracle.filter(|o| o.trace.ending == Ending::Rest && !scene.run_to_duration);
    rest.map_or(scene.duration, |o| o.trace.end_time.min(scene.duration))
}

fn work(column: &Column, end: f64, scene: &Scene, oracle: Option<&Oracle>) -> f64 {
    let balls = scene.balls.len() as f64;
    match step_of(column) {
        Some(dt) if dt > 0.0 => (end / dt).max(1.0) * balls,
        _ => oracle.map_or(1.0, |o| o.trace.events.len() as f64 + 1.0) * balls,
    }
}

fn reach(engine: &str, work: f64) -> Reach {
    let of = |bounds: [(&str, f64); 2]| {
        let own = bounds.iter().find(|(id, _)| engine.starts_with(id));
        own.map_or(f64::INFINITY, |(_, bound)| *bound)
    };
    if work > of(OUT_OF_REACH) {
        Reach::Never
    } else if work > of(MOST_WORK) {
        Reach::Full
    } else {
        Reach::Always
    }
}

/// How long a cell takes compared with others: a ball-step of rapier is some hundred times one of the stepper.
pub fn cost(planned: &Planned) -> f64 {
    let each = match planned.column.engine.id() {
        "stepper" => 0.01,
        "exact" => 1.0,
        _ => 2.0,
    };
    planned.work * each
}

/// The bounds in words, for the page.
pub fn bounds_in_words() -> String {
    let each = |bounds: [(&str, f64); 2]| {
        let one = |(engine, bound): &(&str, f64)| format!("{bound:e} for {engine}");
        bounds.iter().map(one).collect::<Vec<_>>().join(" and ")
    };
    format!(
        "A run of more than {} steps x balls, other than a preset's own, is left to `--full`; one of more than {} is out of reach.",
        each(MOST_WORK),
        each(OUT_OF_REACH)
    )
}
