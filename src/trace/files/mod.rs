//! Trace files: what other programs may rely on.
//!
//! [`write()`] turns a [`Trace`] into the text of four files and [`read`] turns them back into the same trace to the bit, so
//! that any program that writes them can become an engine. Text in, text out: paths are the business of `cli`.
//!
//! Where everything lives:
//!
//! | file          | holds                                                                                                   |
//! |---------------|---------------------------------------------------------------------------------------------------------|
//! | `events.csv`  | the events, by index, with their certainty where the engine states it                                   |
//! | `samples.csv` | the knots by time, then ball in scene order, near side before far side; a ball's own order is its path's |
//! | `final.csv`   | one row a ball, *in scene order*: this file is what names the balls; last state and stop time           |
//! | `run.json`    | provenance, ending, end time, counters, extrema                                                         |
//!
//! Numbers are shortest round-trip decimals; `-0`, `inf`, `-inf` and `NaN` are kept (as text in JSON, which has no such
//! numbers; the sign and payload of a NaN are not kept). A reader finds columns and keys by name and ignores those it does
//! not know, because later versions append some.
//!
//! Every time, step and rest speed is finite, a margin or condition is 0 or more or `inf`, and the estimate of a time error may be
//! no number where its derivative overflowed. Positions, velocities and
//! spins are finite too, unless `run.json` says that the run ended as `not-finite`: an engine that steps notices that a number overflowed
//! only after it has recorded it, and what led there is worth reading. Extrema may be anything in any run: a square overflows before a
//! speed does.

mod number;
mod read;
mod run;
mod write;

pub use number::shortest;
pub use read::read;
pub use write::write;

use super::Trace;
use thiserror::Error;

/// Name of the file of events.
pub const EVENTS: &str = "events.csv";
/// Name of the file of knots.
pub const SAMPLES: &str = "samples.csv";
/// Name of the file of balls, last states and stop times.
pub const FINAL: &str = "final.csv";
/// Name of the file of everything else.
pub const RUN: &str = "run.json";

/// Columns of [`EVENTS`], in order.
pub const EVENT_COLUMNS: [&str; 6] = ["index", "time", "kind", "a", "b", "exchanges"];
/// Further columns of [`EVENTS`], empty where the engine does not say: see [`super::Certainty`].
pub const CERTAINTY_COLUMNS: [&str; 3] = ["margin", "condition", "time_error"];
/// Columns of [`SAMPLES`], in order.
pub const SAMPLE_COLUMNS: [&str; 12] = [
    "time", "ball", "x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "event",
];
/// Columns of [`FINAL`], in order.
pub const FINAL_COLUMNS: [&str; 11] = [
    "ball",
    "x",
    "y",
    "z",
    "vx",
    "vy",
    "vz",
    "wx",
    "wy",
    "wz",
    "stop_time",
];

/// The text of the four files of one trace.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Files {
    /// Text of [`EVENTS`].
    pub events: String,
    /// Text of [`SAMPLES`].
    pub samples: String,
    /// Text of [`FINAL`].
    pub final_states: String,
    /// Text of [`RUN`].
    pub run: String,
}

impl Files {
    /// Each file's name and text, in the order in which they are best written: `run.json` last, as the sign that the others
    /// are complete.
    pub fn named(&self) -> [(&'static str, &str); 4] {
        [
            (EVENTS, &self.events),
            (SAMPLES, &self.samples),
            (FINAL, &self.final_states),
            (RUN, &self.run),
        ]
    }
}

/// Why four texts are no trace, or a trace is not four texts.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum FileError {
    /// A column that every version has is not there.
    #[error("{file}:1: there is no column `{column}`; the first line must name {}", columns.join(","))]
    MissingColumn {
        /// Name of the file.
        file: &'static str,
        /// The column.
        column: &'static str,
        /// All columns that must be there.
        columns: &'static [&'static str],
    },
    /// A line does not have one field a column.
    #[error("{file}:{line}: {problem}")]
    Line {
        /// Name of the file.
        file: &'static str,
        /// Line in the file, from 1.
        line: u64,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// A field cannot be what it says.
    #[error("{file}:{line}: column `{column}`: {problem}")]
    Field {
        /// Name of the file.
        file: &'static str,
        /// Line in the file, from 1.
        line: u64,
        /// The column.
        column: &'static str,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// `run.json` is no JSON, or lacks a key, or a value has the wrong type.
    #[error("{RUN}:{line}:{column}: {problem}")]
    Run {
        /// Line in the file, from 1.
        line: usize,
        /// Column in the line, from 1.
        column: usize,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// A value of `run.json` is well formed and cannot be true.
    #[error("{RUN}: `{key}`: {problem}")]
    Value {
        /// The key, with those above it: `extrema.overlap`.
        key: String,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// The trace contradicts itself, so no file can hold it.
    #[error("the trace cannot be written: {problem}")]
    Unwritable {
        /// The contradiction.
        problem: String,
    },
}

/// Balls that an error lists at most.
const LISTED: usize = 16;

/// Index of the ball called `id`, or what would be right.
fn ball_index(trace_balls: &[String], id: &str) -> Result<u32, String> {
    let found = trace_balls.iter().position(|ball| ball == id);
    found.map(|index| index as u32).ok_or_else(|| {
        let listed = trace_balls.len().min(LISTED);
        let more = match trace_balls.len() - listed {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        let names = trace_balls[..listed].join(", ");
        format!("there is no ball `{id}`; {FINAL} names {names}{more}")
    })
}

/// True when ball `i` of a trace that is being written exists.
fn id_of(trace: &Trace, i: u32) -> Result<&str, FileError> {
    let id = trace.balls.get(i as usize).map(String::as_str);
    id.ok_or_else(|| FileError::Unwritable {
        problem: format!("it has {} balls and names ball {i}", trace.balls.len()),
    })
}
