//! Where each ball ended.

use super::{Comparison, Measured, Metric, Reads, attribution};
use crate::finding::Hold;

/// Distance between the final positions of each ball.
pub const FINAL_POSITION: Metric = Metric {
    id: "final-position",
    unit: "R",
    hold: Hold::Figure,
    what: "distance between the final positions of each ball",
    reads: Reads::Pair(|c| {
        let distances = attribution::distances_at_end(c.trace, c.reference);
        let radius = c.scene.smallest_radius();
        let measured = |(ball, distance): (&String, Option<f64>)| Measured {
            subject: ball.clone(),
            value: distance.map(|d| d / radius),
        };
        c.trace.balls.iter().zip(distances).map(measured).collect()
    }),
};

/// Largest distance at any time before the collision orders part and the horizon: an error that means something.
pub const UNTIL_PARTING: Metric = Metric {
    id: "until-parting",
    unit: "R",
    hold: Hold::Figure,
    what: "largest distance of a ball at any time before the collision orders part, and before the horizon",
    reads: Reads::Pair(|c: &Comparison<'_>| {
        let parting = c.parting_time().unwrap_or(f64::INFINITY);
        let until = parting.min(c.horizon);
        Measured::of_run(c.divergence.largest_before(until) / c.scene.smallest_radius())
    }),
};

/// Balls whose end is not the same: a pocket in one, the table or another pocket in the other.
pub const POCKETS: Metric = Metric {
    id: "pocket-disagreements",
    unit: "",
    hold: Hold::Count,
    what: "balls that fell into another pocket, or in only one of the two",
    reads: Reads::Pair(|c: &Comparison<'_>| {
        let differ = (0..c.trace.balls.len())
            .filter(|&ball| c.trace.pocket_of(ball) != c.reference.pocket_of(ball));
        Measured::of_run(differ.count() as f64)
    }),
};
