//! When balls are in contact, as a trace tells.

use super::{Counter, Event, EventKind, Partner, Trace};
use std::collections::HashMap;

/// A ball in contact moves as no parabola does: what its knots leave unexplained between them, in radii, at most.
pub const UNEXPLAINED_IN_CONTACT: f64 = 1e-9;

/// From when to when each ball is in contact.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contacts {
    /// By ball: begin and end, s; one that has not ended ends after the run.
    spans: Vec<Vec<[f64; 2]>>,
}

impl Trace {
    /// Whether the run followed balls into contact, or impacts that shrink to it.
    pub fn follows_contacts(&self) -> bool {
        let begins = |event: &Event| matches!(event.kind, EventKind::ContactBegin(..));
        self.counters.contains_key(Counter::Handovers.id()) || self.events.iter().any(begins)
    }
}

impl Contacts {
    /// The contacts of a trace.
    pub fn of(trace: &Trace) -> Self {
        let mut spans: Vec<Vec<[f64; 2]>> = vec![Vec::new(); trace.paths.len()];
        let mut open: HashMap<(u32, Partner), f64> = HashMap::new();
        let mut close = |ball: u32, partner: Partner, span: [f64; 2]| {
            let partner = match partner {
                Partner::Ball(other) => Some(other),
                Partner::Cushion(_) => None,
            };
            for ball in [Some(ball), partner].into_iter().flatten() {
                spans[ball as usize].push(span);
            }
        };
        for event in &trace.events {
            match event.kind {
                EventKind::ContactBegin(ball, partner) => {
                    open.insert((ball, partner), event.time);
                }
                EventKind::ContactEnd(ball, partner) => {
                    if let Some(since) = open.remove(&(ball, partner)) {
                        close(ball, partner, [since, event.time]);
                    }
                }
                _ => {}
            }
        }
        for ((ball, partner), since) in open {
            close(ball, partner, [since, f64::INFINITY]);
        }
        Contacts { spans }
    }

    /// True if the trace has none.
    pub fn is_empty(&self) -> bool {
        self.spans.iter().all(Vec::is_empty)
    }

    /// True where a ball is in contact at some time of a span that has a length, s, or at its one time, ends included.
    pub fn during(&self, ball: usize, [from, to]: [f64; 2]) -> bool {
        self.spans[ball].iter().any(|[begins, ends]| {
            if from == to {
                from >= *begins && from <= *ends
            } else {
                to > *begins && from < *ends
            }
        })
    }
}
