//! What the stepping loop sees of rapier, the same for both precisions: states in f64, and who pushed whom in a step.

use super::cloth::Load;
use crate::engine::Inside;
use crate::math::Vec3;
use crate::physics::{Side, State};

/// A scene inside rapier, one step at a time.
pub(super) trait World {
    /// Spacing of the numbers just above 1.
    const ULP: f64;

    /// Advances by `dt`, s.
    fn step(&mut self, dt: f64);

    /// Sets what acts on a ball besides rapier's own forces in every step from now on.
    fn load(&mut self, ball: usize, load: &Load);

    /// Takes a ball out of play: nothing meets it any more, and its state stays as it is.
    fn remove(&mut self, ball: usize);

    /// Replaces `presses` by the normal impulse, mass * length/s, of the cloth on every ball in the last step.
    fn presses(&self, presses: &mut Vec<f64>);

    /// Replaces `states` by those of all balls, in scene order.
    fn read(&self, states: &mut Vec<State>);

    /// Replaces `pushes` by the impulses that the last step applied between two balls, and between ball and cushion.
    fn pushes(&self, pushes: &mut Vec<Push>);

    /// Balls that rapier took out of its simulation in the last step because a number stopped being one.
    fn quarantined(&self) -> Vec<u32>;

    /// Everything the audit asks for, read from bodies and colliders.
    fn inside(&self) -> Inside;

    /// Gravity, length/s^2, as the world holds it.
    fn gravity(&self) -> f64;
}

/// The total impulse of one contact in one step: warm start, solver and restitution together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Push {
    /// Index of the ball that receives `impulse`; of two balls the smaller index.
    pub ball: usize,
    /// What it met.
    pub other: Other,
    /// mass * length/s, along the contact normal; a second ball receives the opposite.
    pub impulse: Vec3,
}

/// What a ball can be pushed by, besides the cloth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Other {
    /// The ball with this larger index.
    Ball(usize),
    /// A cushion.
    Cushion(Side),
}
