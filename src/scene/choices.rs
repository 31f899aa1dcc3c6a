//! The words that a scene chooses from: sets, the unit of time, what to do with simultaneous impacts.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A set of scenes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SetName {
    /// In the default report.
    Report,
    /// Held by `check`.
    Gate,
    /// A hard case.
    Hard,
    /// Only with `--full`, whatever else.
    Full,
}

impl SetName {
    /// Every set, in the order in which lists have them.
    pub const ALL: [SetName; 4] = [SetName::Report, SetName::Gate, SetName::Hard, SetName::Full];

    /// What its scenes are for, in a few words.
    pub fn what(self) -> &'static str {
        match self {
            SetName::Report => "in the default report",
            SetName::Gate => "held by `carom check`",
            SetName::Hard => "hard cases, of `carom stability`",
            SetName::Full => "only with `--full`, as they take long",
        }
    }

    /// The word used in files.
    pub fn id(self) -> &'static str {
        match self {
            SetName::Report => "report",
            SetName::Gate => "gate",
            SetName::Hard => "hard",
            SetName::Full => "full",
        }
    }
}

/// What times are measured in. Laws with SI constants, tolerances and defaults are in seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum TimeUnit {
    /// Seconds.
    #[default]
    #[serde(rename = "s")]
    Second,
}

impl TimeUnit {
    /// The word used in files.
    pub fn id(self) -> &'static str {
        match self {
            TimeUnit::Second => "s",
        }
    }
}

/// What the exact engine does when an impact involves balls that touch others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Simultaneous {
    /// End the run as indeterminate and say where: there is no unique answer.
    #[default]
    Refuse,
    /// Reflect the velocities of all touching balls together, again and again, until none approach (Smith et al. 2012). With restitution:
    /// (1 - e) of the inelastic projection and e of the reflections, e the smallest of the contacts that take an impulse together. Friction
    /// acts while these impulses grow together, until their work is what it is without it. A cushion with friction takes turns with the
    /// other contacts, and the answer is the mean over the orders.
    GeneralizedReflections,
    /// A single run ends as with `refuse`: the answer is a distribution over small gaps.
    Ensemble,
}
