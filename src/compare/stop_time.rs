//! When each ball came to rest.

use super::{Comparison, Measured, Metric, Reads};
use crate::finding::Hold;

/// Difference of the stop times of each ball.
pub const STOP_TIME: Metric = Metric {
    id: "stop-time",
    unit: "s",
    hold: Hold::Figure,
    what: "difference of the times at which each ball came to rest; empty where only one of the two stopped",
    reads: Reads::Pair(stop_times),
};

/// Balls that stopped in only one of the two traces.
pub const STILL_MOVING: Metric = Metric {
    id: "stop-disagreements",
    unit: "",
    hold: Hold::Count,
    what: "balls that came to rest in only one of the two",
    reads: Reads::Pair(|c| {
        let (ours, theirs) = (&c.trace.stop_times, &c.reference.stop_times);
        let differ = ours
            .iter()
            .zip(theirs)
            .filter(|(a, b)| a.is_some() != b.is_some())
            .count();
        Measured::of_run(differ as f64)
    }),
};

/// |difference| of the stop times, s, one value a ball in scene order.
pub fn stop_times(c: &Comparison<'_>) -> Vec<Measured> {
    let pairs = c.trace.stop_times.iter().zip(&c.reference.stop_times);
    let difference = |((ours, theirs), ball): ((&Option<f64>, &Option<f64>), &String)| Measured {
        subject: ball.clone(),
        value: ours.zip(*theirs).map(|(a, b)| (a - b).abs()),
    };
    pairs.zip(&c.trace.balls).map(difference).collect()
}
