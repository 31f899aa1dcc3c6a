//! A whole run in a scalar of one's choice, with the digits that a trace, which is f64, does not keep.

use super::solve::Solver;
use crate::engine::Limits;
use crate::math::Real;
use crate::scene::Scene;
use crate::trace::{Provenance, Record, Trace};

/// A run in the scalar `T`, before anything of it is rounded.
#[derive(Clone, Debug)]
pub struct Solution<T> {
    /// Time of every event of the trace, s.
    pub times: Vec<T>,
    /// Centres of all balls at the end, in scene order, length; infinite for a ball that left play.
    pub positions: Vec<[T; 2]>,
    /// Velocities of all balls at the end, length/s.
    pub velocities: Vec<[T; 2]>,
    /// Time at which the run ended, s.
    pub end_time: T,
    /// The same run rounded to f64, with every event.
    pub trace: Trace,
}

/// Runs a scene in the scalar `T`: the same source as the engine, without its border.
///
/// The scene must be one that the engine can simulate; see `Engine::missing`.
pub fn solve<T: Real>(scene: &Scene, limits: &Limits<'_>) -> Solution<T> {
    let solver = Solver::<T>::new(scene);
    let mut played = solver.play(Provenance::default(), Record::Events, limits, true);
    let balls = played.balls();
    let (positions, velocities) = (0..balls.count()).map(|ball| balls.at(ball)).unzip();
    Solution {
        positions,
        velocities,
        end_time: balls.now(),
        times: played.take_times(),
        trace: played.trace(),
    }
}

/// Where the balls end, in the scalar `T`: centres in scene order, length.
pub fn final_positions<T: Real>(scene: &Scene) -> Vec<[T; 2]> {
    solve(scene, &Limits::NONE).positions
}
