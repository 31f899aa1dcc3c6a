//! Accepted findings, and what differs from them.
//!
//! An accepted file is a table of findings of one scene with a reason and the versions that gave them. One [`diff`] holds a run against it:
//! a number that left its tolerance, in either direction, another verdict, a finding that vanished and one that appeared are changes alike.
//! What is accepted may be a break: then the break is what is expected. Reads and writes text; files are for `cli`.

mod cases;
mod check;
mod decision;
mod diff;
mod file;
mod header;
mod words;

pub use cases::{HeldCases, hold_cases};
pub use check::{Bits, Held};
pub use decision::{Decision, Refused, Standing};
pub use diff::{Change, Kind, diff};
pub use file::{Accepted, Malformed, read, write};
pub use header::{contradictions, other_versions, versions_sentence};
pub use words::{Located, changes_sentence, changes_table};

use crate::finding::{Finding, Verdict};

/// One finding of a scene, as it is accepted.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Engine and setting, as a label; `a | b` for a pair.
    pub engine: String,
    /// Id of the metric or check.
    pub check: String,
    /// The ball, event or word concerned; empty for the whole run.
    pub subject: String,
    /// The number; `None` where there is none.
    pub value: Option<f64>,
    /// What it means; `None` where nothing is judged.
    pub verdict: Option<Verdict>,
}

impl Row {
    /// Where a row belongs: two rows with one address are the same finding.
    pub fn address(&self) -> [&str; 3] {
        [&self.engine, &self.check, &self.subject]
    }
}

impl From<&Finding> for Row {
    fn from(finding: &Finding) -> Self {
        Row {
            engine: finding.engine.clone(),
            check: finding.metric.to_owned(),
            subject: finding.subject.clone(),
            value: finding.value,
            verdict: finding.verdict,
        }
    }
}
