//! Phases of motion: when balls begin to roll and when their spin about the vertical ends.

use super::{Comparison, Measured, Metric, Reads};
use crate::finding::Hold;
use crate::math::worse;
use crate::trace::{EventKind, Trace};
use std::collections::HashMap;

/// Largest difference of the times at which a phase ends.
pub const PHASE_TIME: Metric = Metric {
    id: "phase-time",
    unit: "s",
    hold: Hold::Figure,
    what: "largest difference of the times at which a ball begins to roll or its spin about the vertical ends, k-th with k-th",
    reads: Reads::Pair(|c| {
        of_turning(c, |ours, theirs| {
            let pairs = ours.iter().flat_map(|(kind, times)| {
                let other = theirs.get(kind).map_or(&[][..], Vec::as_slice);
                times.iter().zip(other)
            });
            pairs.map(|(a, b)| (a - b).abs()).reduce(worse)
        })
    }),
};

/// Ends of a phase that only one of the two has.
pub const PHASES: Metric = Metric {
    id: "phase-disagreements",
    unit: "",
    hold: Hold::Count,
    what: "ends of a slide or of a spin about the vertical that only one of the two has",
    reads: Reads::Pair(|c| {
        of_turning(c, |ours, theirs| {
            let count = |of: &Ends, kind| of.get(kind).map_or(0, Vec::len);
            let more = ours
                .keys()
                .map(|kind| count(ours, kind).abs_diff(count(theirs, kind)));
            let only = theirs.keys().filter(|kind| !ours.contains_key(*kind));
            let only = only.map(|kind| count(theirs, kind));
            Some((more.sum::<usize>() + only.sum::<usize>()) as f64)
        })
    }),
};

/// Times at which each ball ended each phase, s.
type Ends = HashMap<EventKind, Vec<f64>>;

/// A value of both traces up to their common end; none where balls do not turn.
fn of_turning(c: &Comparison<'_>, value: impl Fn(&Ends, &Ends) -> Option<f64>) -> Vec<Measured> {
    if !c.scene.effects.rotates() {
        return Vec::new();
    }
    let end = c.common_end();
    Measured::of_run(value(&ends(c.trace, end), &ends(c.reference, end)))
}

fn ends(trace: &Trace, until: f64) -> Ends {
    let mut ends = Ends::new();
    for event in &trace.events {
        let phase = matches!(
            event.kind,
            EventKind::SlideToRoll(_) | EventKind::SpinEnd(_)
        );
        if phase && event.time <= until {
            ends.entry(event.kind).or_default().push(event.time);
        }
    }
    ends
}
