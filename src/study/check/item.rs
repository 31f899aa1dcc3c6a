//! What one held thing is, and the ids of those that are no metric.

use super::Level;
use crate::finding::Hold;

/// One thing that is held: in a check, or between two runs alone.
#[derive(Clone, Copy, Debug)]
pub struct Held {
    /// Unique kebab-case name.
    pub id: &'static str,
    /// Unit; empty for a count, a ratio or a word.
    pub unit: &'static str,
    /// Its level.
    pub level: Level,
    /// How an accepted value is held.
    pub hold: Hold,
    /// Meaning, in one sentence.
    pub what: &'static str,
}

/// A held thing by its parts.
pub(super) const fn held(
    id: &'static str,
    unit: &'static str,
    level: Level,
    hold: Hold,
    what: &'static str,
) -> Held {
    Held {
        id,
        unit,
        level,
        hold,
        what,
    }
}

/// A promised invariant.
pub const PROMISE: &str = "promise";
/// An engine that cannot simulate a scene.
pub const REFUSED: &str = "refused";
/// How and when a run ended.
pub const ENDING: &str = "ending";
/// Where collision orders first differ.
pub const PARTING: &str = "parting";
/// Events of the exact engine within its horizon.
pub const CERTAIN: &str = "certain";
/// Where a ball of the exact engine ends, across the table.
pub const END_X: &str = "end-x";
/// The same along the table.
pub const END_Y: &str = "end-y";
/// When a ball of the exact engine stopped.
pub const STOPPED: &str = "stopped-at";
/// Samples with a complete run.
pub const COMPLETE: &str = "complete-samples";
/// Kolmogorov-Smirnov distance.
pub const KS: &str = "kolmogorov-smirnov";
/// A quantile.
pub const QUANTILE: &str = "quantile";
/// What a hard case is known to do.
pub const VERDICT: &str = "verdict";
/// A counter.
pub const WORK: &str = "work";
/// What became of random scenes: counts.
pub const FUZZ: &str = "fuzz";
