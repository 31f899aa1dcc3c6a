//! What an author of a stepping engine writes: a scene inside the engine, one step at a time.

use super::cloth::Load;
use crate::engine::Inside;
use crate::math::Vec3;
use crate::physics::{Side, State};

/// A scene inside an engine, one step at a time: states in f64, and who pushed whom in a step.
///
/// [`super::WorldEngine`] makes an engine of it. Balls are called by their index in the scene. Events, knots, extrema and rest are made of that by [`super::Stepped`].
pub trait World {
    /// Advances by `dt`, s.
    fn step(&mut self, dt: f64);

    /// Replaces `states` by those of all balls, in scene order.
    fn read(&self, states: &mut Vec<State>);

    /// Replaces `pushes` by the impulses that the last step applied between two balls, and between ball and cushion: one a pair.
    fn pushes(&self, pushes: &mut Vec<Push>);

    /// Everything the audit asks for, read from what the engine holds and not from what it was given.
    fn inside(&self) -> Inside;

    /// Takes a ball out of play: nothing meets it any more, and its state stays as it is. Only in scenes with pockets.
    fn remove(&mut self, ball: usize);

    /// Sets what acts on a ball besides the engine's own forces in every step from now on: rolling resistance and the decay of spin.
    /// Only in scenes whose cloth turns balls; sliding friction is the engine's own.
    fn load(&mut self, ball: usize, load: &Load);

    /// Replaces `presses` by the normal impulse, mass * length/s, of the cloth on every ball in the last step. Only in scenes whose
    /// cloth turns balls.
    fn presses(&self, presses: &mut Vec<f64>);

    /// Balls that the engine itself took out of its simulation in the last step because a number stopped being one.
    fn quarantined(&self) -> Vec<u32> {
        Vec::new()
    }
}

/// The total impulse of one contact in one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Push {
    /// Index of the ball that receives `impulse`; of two balls the smaller index.
    pub ball: usize,
    /// What it met.
    pub other: Other,
    /// mass * length/s, along the contact normal; a second ball receives the opposite.
    pub impulse: Vec3,
}

impl Push {
    /// What `ball` received of `other`, mass * length/s.
    pub fn new(ball: usize, other: Other, impulse: Vec3) -> Self {
        Push {
            ball,
            other,
            impulse,
        }
    }
}

/// What a ball can be pushed by, besides the cloth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Other {
    /// The ball with this larger index.
    Ball(usize),
    /// A cushion.
    Cushion(Side),
}
