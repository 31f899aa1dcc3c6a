//! The two hits of one ball that are closest in time.

use crate::trace::Trace;

/// Two hits of one ball with no other of it between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestHits {
    /// Time between them, s.
    pub apart: f64,
    /// The ball, as an index in scene order.
    pub ball: usize,
    /// When the later one is, s.
    pub time: f64,
}

/// The closest two hits of a trace, on cushions too where `cushions` says so; `None` where no ball has two.
pub fn closest_hits(trace: &Trace, cushions: bool) -> Option<ClosestHits> {
    let mut last: Vec<Option<f64>> = vec![None; trace.balls.len()];
    let mut closest: Option<ClosestHits> = None;
    for event in trace.collisions() {
        if !cushions && event.kind.each_ball().count() < 2 {
            continue;
        }
        for ball in event.kind.each_ball() {
            let Some(before) = last[ball].replace(event.time) else {
                continue;
            };
            let apart = event.time - before;
            if closest.is_none_or(|known| apart < known.apart) {
                let time = event.time;
                closest = Some(ClosestHits { apart, ball, time });
            }
        }
    }
    closest
}
