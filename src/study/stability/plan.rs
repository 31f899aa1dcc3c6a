//! Which runs a matrix of hard cases needs: presets, steps from coarse to fine, what a scene asks for; and which cost too much.

use crate::engine::{Roster, UnknownEngine};
use crate::oracle::Oracle;
use crate::scene::{Scene, Tried};
use crate::study::matrix::Configuration;
use crate::trace::Ending;
use thiserror::Error;

/// Steps in which every stepping engine runs besides its own, s.
pub const STEPS: [f64; 6] = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1];

/// Expected time of one run above which a step or a tried setting is left to `--full`, ns: a case has four images, each engine a dozen
/// settings, and a person waits for all of them.
const MOST_TIME: f64 = 0.1e9;

/// Expected time of one run above which not even `--full` runs it, ns.
const OUT_OF_REACH: f64 = 60e9;

/// States of one run above which its events are not kept, steps x balls: only its end is looked at. A pair that sticks leaves four
/// states a step.
pub const MOST_STATES: f64 = 3e6;

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
    pub column: Configuration,
    /// Why it is here.
    pub role: Role,
    /// States that one run goes through: steps x balls; events expected x balls for an engine without steps.
    pub states: f64,
    /// Expected time of one run, ns, by [`crate::engine::Engine::pace`]; 0 where the engine refuses the setting.
    pub time: f64,
    /// Whether it runs.
    pub reach: Reach,
}

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlanError {
    /// A scene asks for an engine that is none.
    #[error("scene {scene}: `try = \"{tried}\"`: {unknown}")]
    Try {
        /// Name of the scene.
        scene: String,
        /// What it asks for, as written.
        tried: String,
        /// That there is no such engine, and which there are.
        unknown: UnknownEngine,
    },
}

/// The engines and presets in which every case runs when none are named.
pub fn presets(roster: &Roster) -> Vec<Configuration> {
    Configuration::presets(roster, |_| true)
}

/// True where a step can be set for a column: its engine has one, and neither the preset that it extends nor what is set besides
/// fixes it.
pub fn is_swept(column: &Configuration) -> bool {
    let Some(swept) = column.engine.with_step(&column.setting, STEPS[0]) else {
        return false;
    };
    swept.besides(&column.setting).is_some()
        && column.preset().is_none_or(|(preset, _)| preset.swept)
}

/// The cells of one scene.
pub fn cells(
    index: usize,
    scene: &Scene,
    oracle: Option<&Oracle>,
    roster: &Roster,
    presets: &[Configuration],
) -> Result<Vec<Planned>, PlanError> {
    let end = end_time(scene, oracle);
    let mut cells: Vec<Planned> = Vec::new();
    let mut add = |column: Configuration, role: Role| {
        if cells
            .iter()
            .any(|cell| cell.column.label() == column.label())
        {
            return;
        }
        let pace = column.engine.pace(scene, &column.setting);
        let time = pace.as_ref().map_or(0.0, |pace| pace.cost * end);
        let reach = match role {
            Role::Preset => Reach::Always,
            // what it cannot step by is not for want of time
            Role::Step(..) if pace.is_err() => Reach::Never,
            Role::Step(..) | Role::Tried => reach(time),
        };
        cells.push(Planned {
            scene: index,
            states: states(&column, end, scene, oracle),
            column,
            role,
            time,
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
        for (s, step) in STEPS.into_iter().enumerate() {
            // a preset's own step has run already
            if step_of(preset) == Some(step) {
                continue;
            }
            if let Some(setting) = preset.engine.with_step(&preset.setting, step) {
                add(
                    Configuration::with(&preset.engine, setting),
                    Role::Step(p, s),
                );
            }
        }
    }
    for column in tried(roster, scene)? {
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
pub fn reach_of(
    roster: &Roster,
    scene: &Scene,
    oracle: Option<&Oracle>,
    label: &str,
) -> Option<Reach> {
    let planned = cells(0, scene, oracle, roster, &presets(roster)).ok()?;
    let own = planned.iter().find(|cell| cell.column.label() == label);
    own.map(|cell| cell.reach)
}

/// The columns that a scene wants tried, in order. Errors: it asks for an engine that is none.
pub(in crate::study) fn tried(
    roster: &Roster,
    scene: &Scene,
) -> Result<Vec<Configuration>, PlanError> {
    let column = |tried: &Tried| {
        Configuration::tried(roster, tried).map_err(|unknown| PlanError::Try {
            scene: scene.name.clone(),
            tried: tried.to_string(),
            unknown,
        })
    };
    scene.try_settings.iter().map(column).collect()
}

/// The step of a column, s; `None` for an engine without one.
pub fn step_of(column: &Configuration) -> Option<f64> {
    column.engine.step(&column.setting)
}

/// When a run of the scene ends, s: when everything rests, as far as the oracle knows, else after its duration.
fn end_time(scene: &Scene, oracle: Option<&Oracle>) -> f64 {
    let rest = oracle.filter(|o| o.trace.ending == Ending::Rest && !scene.run_to_duration);
    rest.map_or(scene.duration, |o| o.trace.end_time.min(scene.duration))
}

fn states(column: &Configuration, end: f64, scene: &Scene, oracle: Option<&Oracle>) -> f64 {
    let balls = scene.balls.len() as f64;
    match step_of(column) {
        Some(dt) if dt > 0.0 => (end / dt).max(1.0) * balls,
        _ => oracle.map_or(1.0, |o| o.trace.events.len() as f64 + 1.0) * balls,
    }
}

fn reach(time: f64) -> Reach {
    if time > OUT_OF_REACH {
        Reach::Never
    } else if time > MOST_TIME {
        Reach::Full
    } else {
        Reach::Always
    }
}

/// The bounds in words, for the page.
pub fn bounds_in_words() -> String {
    format!(
        "A run that is expected to take more than {} s of a processor, other than a preset's own, is left to `--full`; one of more than {} s \
         is out of reach.",
        MOST_TIME / 1e9,
        OUT_OF_REACH / 1e9
    )
}
