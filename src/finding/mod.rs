//! What studies conclude and reports print: plain values, no computation.
//!
//! A [`Finding`] is one number with its address. Studies conclude from findings only, a gate holds them, a report prints
//! them. A [`Document`] is what a study ends in; every report format writes any document, and no study knows a format.

mod document;
mod replay;
mod verdict;

pub use document::{
    Align, Axis, Block, Cell, Column, Document, Figure, Mark, Series, Sign, Style, Table, Tone,
};
pub use replay::{Replay, ReplayBall, ReplayDivergence, ReplayEvent, ReplayParting, ReplayRun};
pub use verdict::{Hold, Tolerance, Verdict};

use serde::Serialize;

/// One number with its address.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// Name of the scene.
    pub scene: String,
    /// Engine and setting, as a label: `stepper contact=approaching-only`. For a pair of engines: `a | b`.
    pub engine: String,
    /// Id of the metric.
    pub metric: &'static str,
    /// The ball or event concerned; empty for the whole run.
    pub subject: String,
    /// The number; `None` where there is none, which is not 0.
    pub value: Option<f64>,
    /// Unit of the number, empty for a count or ratio.
    pub unit: &'static str,
    /// What the number means; `None` where nothing is judged.
    pub verdict: Option<Verdict>,
}
