//! No state is NaN or infinite.

use super::{Held, Law, Reads, Run};
use crate::physics::State;
use crate::physics::invariants::Invariant;
use crate::trace::{Ending, Knot, Trace};

/// The invariant.
///
/// No bound: there may be none. An engine whose numbers leave its scalar must end as [`Ending::NotFinite`], which breaks it as well, before
/// it writes a state that is none.
pub const LAW: Law = Law {
    invariant: Invariant::Finite,
    unit: "",
    what: "no state is NaN or infinite",
    reads: Reads::Run(|run| Some(Held::none_of(broken(run)))),
};

/// Number of balls that are concerned.
fn broken(run: &Run<'_>) -> usize {
    match &run.trace.ending {
        Ending::NotFinite(spot) => spot.balls.len().max(1),
        _ => strange(run.trace).count(),
    }
}

/// The first knot of each ball that is no number.
pub fn strange(trace: &Trace) -> impl Iterator<Item = (usize, &Knot)> {
    let first = |path: &'_ crate::trace::Path| {
        let mut knots = path.knots.iter();
        knots.position(|knot| !(is_finite(&knot.state) && knot.time.is_finite()))
    };
    let paths = trace.paths.iter().enumerate();
    paths.filter_map(move |(ball, path)| Some((ball, &path.knots[first(path)?])))
}

/// True if every number of a state is finite.
pub fn is_finite(state: &State) -> bool {
    let all = [state.position, state.velocity, state.spin];
    all.iter().all(|v| v.iter().all(|x| x.is_finite()))
}
