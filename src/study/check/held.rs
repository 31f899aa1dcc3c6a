//! What is held besides the metrics of a comparison: unit, level, and by how much each may move.

use super::Level;
use super::item::{
    CERTAIN, COMPLETE, END_X, END_Y, ENDING, FUZZ, Held, KS, PARTING, PROMISE, QUANTILE, REFUSED,
    STOPPED, VERDICT, WORK, held,
};
use super::written::WRITTEN;
use crate::compare::metric;
use crate::finding::{Hold, Tolerance};

/// Everything that is held besides [`crate::compare::METRICS`], which are all of the level [`Level::Error`].
pub const HELD: &[Held] = &[
    held(
        PROMISE,
        "",
        Level::Promise,
        Hold::Count,
        "an invariant that the engine promises holds",
    ),
    held(
        REFUSED,
        "",
        Level::Error,
        Hold::Count,
        "the engine cannot simulate the scene",
    ),
    held(
        ENDING,
        "s",
        Level::Error,
        Hold::Figure,
        "how the run ended, and when if the whole run can be believed",
    ),
    held(
        PARTING,
        "s",
        Level::Error,
        Hold::Figure,
        "when the order of collisions first differs from the exact engine's within the horizon, and the two collisions",
    ),
    held(
        CERTAIN,
        "",
        Level::Error,
        Hold::Count,
        "events of the exact engine within its horizon",
    ),
    held(
        END_X,
        "R",
        Level::Error,
        Hold::Figure,
        "where the ball ends in the exact engine, across the table",
    ),
    held(
        END_Y,
        "R",
        Level::Error,
        Hold::Figure,
        "where the ball ends in the exact engine, along the table",
    ),
    held(
        STOPPED,
        "s",
        Level::Error,
        Hold::Figure,
        "when the ball stopped in the exact engine",
    ),
    held(
        COMPLETE,
        "",
        Level::Distribution,
        Hold::Count,
        "samples of the ensemble with a complete run",
    ),
    held(
        KS,
        "",
        Level::Distribution,
        Hold::Figure,
        "largest distance of the ball's distribution function from the exact engine's over the same samples",
    ),
    held(
        QUANTILE,
        "",
        Level::Distribution,
        Hold::Figure,
        "the value below which this part of all balls of all samples lies; lengths in R, times in s",
    ),
    held(
        VERDICT,
        "",
        Level::Verdict,
        Hold::Count,
        "what a hard case is known to do, by the rules of `carom stability`",
    ),
    held(
        WORK,
        "",
        Level::Work,
        Hold::Count,
        "a deterministic count of the work done",
    ),
    held(
        FUZZ,
        "",
        Level::Fuzz,
        Hold::Count,
        "how random scenes ended, and how many impacts and motions of them were held against the laws",
    ),
];

fn find(id: &str) -> Option<&'static Held> {
    HELD.iter().chain(WRITTEN).find(|held| held.id == id)
}

/// The level of a metric.
pub fn level(id: &str) -> Level {
    find(id).map_or(Level::Error, |held| held.level)
}

/// How an accepted value of a metric is held.
pub fn hold(id: &str) -> Hold {
    let of_metric = || metric(id).map_or(Hold::Figure, |metric| metric.hold);
    find(id).map_or_else(of_metric, |held| held.hold)
}

/// By how much a value of a metric may move in an engine with rounding `ulp`.
pub fn tolerance(id: &str, ulp: f64) -> Tolerance {
    hold(id).tolerance(ulp)
}

/// Unit of a metric.
pub fn unit_of(id: &str) -> &'static str {
    let of_metric = || metric(id).map_or("", |metric| metric.unit);
    find(id).map_or_else(of_metric, |held| held.unit)
}

/// Meaning of a metric, in one sentence.
pub fn what(id: &str) -> &'static str {
    let of_metric = || metric(id).map_or("", |metric| metric.what);
    find(id).map_or_else(of_metric, |held| held.what)
}
