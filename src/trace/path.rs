//! The path of one ball: states at times, with both sides of every jump.

use crate::math::worse;
use crate::physics::State;

/// One ball at one time. Two knots at the same time are the near and far side of a jump.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knot {
    /// s, non-decreasing along a path.
    pub time: f64,
    /// Centre, velocity, spin; scene units, world frame.
    pub state: State,
    /// Index of the event whose far side this is.
    pub after: Option<u32>,
}

/// The path of one ball. Between knots velocity and spin are linear and the position is the cubic through both ends, which
/// is the motion itself wherever the acceleration is constant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    /// Knots by time; at equal times in the order in which they happened. Never empty in a finished trace.
    pub knots: Vec<Knot>,
}

impl Path {
    /// State at time `t`, the far side where `t` is a jump. Before the first and after the last knot: that knot.
    ///
    /// `None` only for an empty path.
    pub fn state_at(&self, t: f64) -> Option<State> {
        let next = self.knots.partition_point(|knot| knot.time <= t);
        self.between(next, t)
    }

    /// State just before time `t`: the near side where `t` is a jump, else the same as [`Path::state_at`].
    pub fn before(&self, t: f64) -> Option<State> {
        let next = self.knots.partition_point(|knot| knot.time < t);
        match self.knots.get(next) {
            // the first knot at t is the near side
            Some(knot) if knot.time == t => Some(knot.state),
            _ => self.between(next, t),
        }
    }

    /// Largest speed at a knot, length/s. Between knots a velocity is linear in time, so that its size is largest at one of them.
    pub fn fastest(&self) -> f64 {
        let speeds = self.knots.iter().map(|knot| knot.state.speed());
        speeds.fold(0.0, worse)
    }

    /// Last state of the path: where the ball stayed, or where it left play.
    pub fn last(&self) -> Option<State> {
        self.knots.last().map(|knot| knot.state)
    }

    /// The largest |dr - h (v0 + v1)/2| over the pieces of the path with h > 0, length: motion that the knots do not explain.
    ///
    /// Rounding where acceleration is constant between knots; large where something happened that was not reported.
    pub fn unexplained(&self) -> f64 {
        let mut worst = 0.0_f64;
        for pair in self.knots.windows(2) {
            let (k0, k1) = (&pair[0], &pair[1]);
            let h = k1.time - k0.time;
            if h > 0.0 {
                let expected = (k0.state.velocity + k1.state.velocity) * (0.5 * h);
                let moved = k1.state.position - k0.state.position;
                worst = worse(worst, (moved - expected).norm());
            }
        }
        worst
    }

    /// The largest jump of the position at one time, length.
    pub fn displaced(&self) -> f64 {
        let jumps = self
            .knots
            .windows(2)
            .filter(|pair| pair[0].time == pair[1].time);
        jumps
            .map(|pair| (pair[1].state.position - pair[0].state.position).norm())
            .fold(0.0, worse)
    }

    fn between(&self, next: usize, t: f64) -> Option<State> {
        let Some(left) = next.checked_sub(1).map(|i| &self.knots[i]) else {
            return self.knots.first().map(|knot| knot.state);
        };
        let Some(right) = self.knots.get(next) else {
            return Some(left.state);
        };
        Some(interpolate(left, right, t))
    }
}

/// The state at `t` between two knots with different times.
pub(super) fn interpolate(left: &Knot, right: &Knot, t: f64) -> State {
    let h = right.time - left.time;
    let s = (t - left.time) / h;
    let (s2, s3) = (s * s, s * s * s);
    let (a, b) = (&left.state, &right.state);
    let position = a.position * (2.0 * s3 - 3.0 * s2 + 1.0)
        + a.velocity * (h * (s3 - 2.0 * s2 + s))
        + b.position * (3.0 * s2 - 2.0 * s3)
        + b.velocity * (h * (s3 - s2));
    State {
        position,
        velocity: a.velocity.lerp(&b.velocity, s),
        spin: a.spin.lerp(&b.spin, s),
    }
}
