//! Balls do not go into each other.
//!
//! An engine that solves for its events leaves no overlap but rounding. One that steps finds a contact when it is there: a pair that is apart
//! closes in by at most `(|v1| + |v2|) h` in the step in which it meets, and by no more in each step until it parts. So there are two
//! bounds, which answer two questions:
//!
//! - what a step explains ([`of_a_pair`], [`of_a_group`]), whatever the engine does with a pair that it has found: a pair alone parts in the
//!   next step; in a group the exchanges of a step sort its velocities by one place, so that it takes as many steps as it has balls but
//!   one. `stability` judges by these.
//! - what the contacts that the engine counted explain ([`in_contact`]). With one contact at a time `n` is 1 or 2; in a group each exchange
//!   can undo the one before, and no bound without `n` holds: a light ball between heavy ones needs about `sqrt(M/m)` exchanges to stop
//!   them. `fuzz`, whose scenes look for such groups, judges by these.

use super::{Held, Law, Reach, Reads, Run};
use crate::math::worse;
use crate::physics::invariants::Invariant;
use crate::trace::Extremum;

/// The invariant. Only engines that solve for their events promise it; then both bounds are the same, rounding.
pub const LAW: Law = Law {
    invariant: Invariant::Overlap,
    unit: "R",
    what: "balls overlap by no more than two of the fastest approach in a step, and by that times one less than their number in a group, \
           whose exchanges sort its velocities in as many steps",
    reads: Reads::Run(|run| {
        run.scene.effects.contact?;
        let seen = deepest(run);
        Some(Held {
            seen,
            bound: of_a_group(run, of_a_pair(run)),
        })
    }),
};

/// The deepest overlap by the trace's own account, length.
pub fn deepest(run: &Run<'_>) -> Extremum {
    let own = run.trace.extrema.overlap;
    Extremum {
        value: worse(0.0, own.value),
        ..own
    }
}

/// What a step explains of a pair alone, length: twice the largest speed times the step, and rounding.
pub fn of_a_pair(run: &Run<'_>) -> f64 {
    2.0 * run.fastest() * run.step() + run.rounding(run.trace.end_time)
}

/// What it explains where all balls may be one group, length; `pair`: [`of_a_pair`].
pub fn of_a_group(run: &Run<'_>, pair: f64) -> f64 {
    pair * (run.scene.balls.len() as f64 - 1.0)
}

/// What the steps that the engine counted in contact explain of balls `a` and `b`, length: rounding, and `n (|v1| + |v2|) h`.
///
/// Twice that where there are cushions, which put a ball back by what it went too far and let it move on in the same step. `more`: steps
/// besides those counted; [`AT_KNOTS`] where a trace is looked at between its steps. Balls that were held in contact drift by what their knots leave
/// unexplained.
pub fn in_contact(run: &Run<'_>, reach: &Reach, [a, b]: [usize; 2], more: f64) -> f64 {
    let moves = match run.scene.effects.cushion {
        Some(_) => 2.0,
        None => 1.0,
    };
    let closing = moves * (reach.step[a] + reach.step[b]);
    let drift = reach.contact[a] + reach.contact[b];
    reach.and((run.contact_steps() + more) * closing + drift)
}

/// Parry is asked at knots, between which a stepped path is not quite the cubic through them: half a step more for each ball.
pub const AT_KNOTS: f64 = 1.0;
