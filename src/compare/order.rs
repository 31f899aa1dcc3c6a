//! Collision order: the sequence of ball-ball and ball-cushion events.

use super::{Comparison, Measured, Metric, Reads};
use crate::finding::Hold;

/// How many collisions agree from the start, event for event.
pub const STRICT: Metric = Metric {
    id: "order-strict",
    unit: "",
    hold: Hold::Count,
    what: "collisions that agree from the start, event for event",
    reads: Reads::Pair(|c| Measured::of_run(c.order.strict as f64)),
};

/// How many collisions agree from the start if ties within the resolution may swap.
pub const TOLERANT: Metric = Metric {
    id: "order-tolerant",
    unit: "",
    hold: Hold::Count,
    what: "collisions that agree from the start when ties within the resolution may swap",
    reads: Reads::Pair(|c| Measured::of_run(c.order.tolerant as f64)),
};

/// How many collisions the reference has.
pub const COLLISIONS: Metric = Metric {
    id: "order-of",
    unit: "",
    hold: Hold::Count,
    what: "collisions of the reference",
    reads: Reads::Pair(|c| Measured::of_run(c.order.reference_collisions as f64)),
};

/// Collisions of the reference that never happen.
pub const MISSED: Metric = Metric {
    id: "order-missed",
    unit: "",
    hold: Hold::Count,
    what: "collisions of the reference that never happen",
    reads: Reads::Pair(|c: &Comparison<'_>| Measured::of_run(c.order.missed as f64)),
};

/// Collisions that the reference does not have.
pub const PHANTOM: Metric = Metric {
    id: "order-phantom",
    unit: "",
    hold: Hold::Count,
    what: "collisions that the reference does not have",
    reads: Reads::Pair(|c| Measured::of_run(c.order.phantom as f64)),
};

/// Collisions that come later than the reference's by more than the resolution.
pub const LATE: Metric = Metric {
    id: "order-late",
    unit: "",
    hold: Hold::Count,
    what: "collisions later than the reference's by more than the resolution",
    reads: Reads::Pair(|c| Measured::of_run(c.order.late as f64)),
};

/// Exchanges of velocities that the collisions tell of.
pub const EXCHANGES: Metric = Metric {
    id: "order-exchanges",
    unit: "",
    hold: Hold::Count,
    what: "exchanges of velocities that the collisions of the trace tell of",
    reads: Reads::Trace(|_, trace| {
        let told = trace.collisions().filter_map(|event| event.exchanges);
        Measured::of_run(told.sum::<u64>() as f64)
    }),
};
