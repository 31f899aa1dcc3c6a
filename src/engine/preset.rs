//! Settings by which an engine is known, and where each of them runs when nobody names one.

use super::{Name, Setting};

/// A setting with a name. Every hard case runs in every preset; the rest is up to the engine.
#[derive(Clone, Debug, PartialEq)]
pub struct Preset {
    /// Kebab-case name, unique among those of its engine.
    pub id: Name,
    /// What a heading calls it beside the engine's id; empty where that says it all.
    pub words: Name,
    /// What is set; empty for the defaults.
    pub setting: Setting,
    /// Whether it is part of comparisons, reports and the gate.
    pub compared: bool,
    /// Whether ensembles run in it: quick enough for thousands of runs.
    pub sampled: bool,
    /// Whether hard cases run in it with steps other than its own as well.
    pub swept: bool,
    /// Whether it promises to hold in every random scene, so that the gate asks that of it.
    pub sound: bool,
}

impl Default for Preset {
    /// The defaults of an engine: compared, and swept where it has a step.
    fn default() -> Self {
        Preset {
            id: "default".into(),
            words: "".into(),
            setting: Setting::default(),
            compared: true,
            sampled: false,
            swept: true,
            sound: false,
        }
    }
}
