//! What is kept of one sample in one engine once its trace is dropped: where and when the balls stopped, and digests of orders.

use crate::trace::{Event, EventKind, Partner, Trace};
use sha2::{Digest, Sha256};

/// Where one run left the balls.
#[derive(Clone, Debug, PartialEq)]
pub struct Landing {
    /// How it ended; see [`crate::trace::Ending::id`].
    pub ending: &'static str,
    /// Whether it reached the end that the scene asks for.
    pub complete: bool,
    /// Centre of every ball at the end, in scene order, length; `None` for a pocketed one.
    pub at: Vec<Option<[f64; 2]>>,
    /// When each ball stopped, s; `None` while it moves.
    pub stopped: Vec<Option<f64>>,
    /// The collision order.
    pub collisions: Order,
    /// The order of all events.
    pub events: Order,
}

/// An order of events, told apart by a digest: equal for equal sequences of kinds and parties, whatever their times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Order {
    /// Number of events.
    pub count: u32,
    /// 128 bits of the SHA-256 digest of kinds and parties.
    digest: u128,
}

impl Landing {
    /// What remains of a trace.
    pub fn of(trace: &Trace) -> Self {
        let plan = |state: &crate::physics::State| [state.position.x, state.position.y];
        Landing {
            ending: trace.ending.id(),
            complete: trace.ending.is_complete(),
            at: trace
                .final_states()
                .iter()
                .map(|state| state.as_ref().map(plan))
                .collect(),
            stopped: trace.stop_times.clone(),
            collisions: Order::of(trace.collisions()),
            events: Order::of(&trace.events),
        }
    }
}

impl Order {
    /// The order of these events.
    pub fn of<'a>(events: impl IntoIterator<Item = &'a Event>) -> Self {
        let mut hash = Sha256::new();
        let mut count = 0;
        for event in events {
            count += 1;
            let (a, b) = match event.kind {
                EventKind::BallBall(a, b) | EventKind::Pocket(a, b) => (a, b),
                EventKind::BallCushion(a, side) => (a, side as u32),
                EventKind::Stop(a) | EventKind::SlideToRoll(a) | EventKind::SpinEnd(a) => (a, 0),
                EventKind::ContactBegin(a, partner) | EventKind::ContactEnd(a, partner) => {
                    let other = match partner {
                        Partner::Ball(ball) => ball,
                        // beyond every index of a ball
                        Partner::Cushion(side) => u32::MAX - side as u32,
                    };
                    (a, other)
                }
            };
            // no name of a kind begins with another's, so that the bytes can be read in one way only
            hash.update(event.kind.id());
            hash.update(a.to_le_bytes());
            hash.update(b.to_le_bytes());
        }
        let bytes = hash.finalize();
        let digest = bytes
            .iter()
            .take(16)
            .fold(0, |digest, byte| digest << 8 | u128::from(*byte));
        Order { count, digest }
    }
}
