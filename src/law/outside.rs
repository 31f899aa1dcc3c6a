//! No centre goes beyond where the cushions let it be.

use super::{Held, Law, Reach, Reads, Run};
use crate::math::worse;
use crate::physics::Side;
use crate::physics::invariants::Invariant;
use crate::scene::Scene;
use crate::trace::{Extremum, Trace};

/// The invariant.
pub const LAW: Law = Law {
    invariant: Invariant::Bounds,
    unit: "R",
    what: "no centre is farther beyond where the cushions let it be than that ball goes in a step, and rounding",
    reads: Reads::Run(|run| {
        applies(run.scene).then(|| {
            let farthest = run.trace.extrema.outside;
            let seen = Extremum {
                value: worse(0.0, farthest.value),
                ..farthest
            };
            let bound = farthest.ball.map(|ball| bound(&run.reach(), ball as usize));
            // what was measured of nobody was never outside
            let bound = bound.unwrap_or(0.0);
            Held { seen, bound }
        })
    }),
};

/// True where there are cushions on a table.
pub fn applies(scene: &Scene) -> bool {
    scene.effects.cushion.is_some() && scene.table.is_some()
}

/// How far ball `ball` may be outside, length.
///
/// Rounding, and `|v| h`: a step moves a ball after it has looked at the cushions. `|v|` is the largest speed of the ball at any knot. An
/// engine that solves for its events has `h = 0`; a ball that it holds at a cushion drifts by what its knots leave unexplained.
pub fn bound(reach: &Reach, ball: usize) -> f64 {
    let of = |each: &[f64]| each.get(ball).copied().unwrap_or(0.0);
    reach.and(of(&reach.step) + of(&reach.contact))
}

/// Tells every ball, time, s, and how far its centre is outside, length, negative within: by the trace's own account where it has one, and
/// by its paths, at their knots and where they turn back between two.
pub fn each(scene: &Scene, trace: &Trace, mut tell: impl FnMut(usize, f64, f64)) {
    if !applies(scene) {
        return;
    }
    let own = &trace.extrema.outside;
    if let Some(ball) = own.ball {
        tell(ball as usize, own.time, own.value);
    }
    for (ball, path) in trace.paths.iter().enumerate() {
        let radius = scene.balls[ball].radius;
        for side in Side::ALL {
            let (axis, outward) = (side.axis(), f64::from(side.sign()));
            let Some(reach) = scene.reach(side, radius) else {
                continue;
            };
            for pair in path.knots.windows(2) {
                let (start, end) = (&pair[0].state, &pair[1].state);
                let h = pair[1].time - pair[0].time;
                let (v0, v1) = (outward * start.velocity[axis], outward * end.velocity[axis]);
                let beyond = |x: f64| outward * (x - reach);
                let mut far = worse(beyond(start.position[axis]), beyond(end.position[axis]));
                if v0 > 0.0 && v1 < 0.0 && h > 0.0 {
                    let turn = 0.5 * v0 * (v0 / (v0 - v1)) * h;
                    far = worse(far, beyond(start.position[axis]) + turn);
                }
                tell(ball, pair[0].time, far);
            }
        }
    }
}

/// How far outside a run was at most in what is allowed, and the first ball that was farther: which, when, s, how far and what is allowed.
pub fn worst(run: &Run<'_>, reach: &Reach) -> (f64, Option<(usize, f64, f64, f64)>) {
    let (mut part, mut first) = (0.0, None);
    each(run.scene, run.trace, |ball, time, beyond| {
        let allowed = bound(reach, ball);
        part = worse(part, beyond / allowed);
        if first.is_none() && !crate::math::within(beyond, allowed) {
            first = Some((ball, time, beyond, allowed));
        }
    });
    (part, first)
}
