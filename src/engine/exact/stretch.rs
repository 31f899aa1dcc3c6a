//! The next stretch of a group's common motion, at this time of a run.

use super::contact::arc::Arc;
use super::contact::group::Group;
use super::kinematics::Kinematics;
use crate::math::Real;

/// A stretch may be this many times what is left of the run.
const PAST_THE_END: f64 = 1.0 + 1e-6;

/// The next stretch of a group that begins now.
pub fn stretch<T: Real>(balls: &Kinematics<'_, T>, group: &Group<T>) -> Arc<T> {
    let world = balls.world();
    // a stretch that reaches the end of the run ends after it, which is no event
    let most = (world.duration - balls.now()) * T::lift(PAST_THE_END);
    let tick = balls.now() * T::lift(T::ULP);
    let mut arc = Arc::of(world, group, most, tick);
    if T::DIFFERENTIATES {
        arc.tell_slopes(world, group);
    }
    arc
}
