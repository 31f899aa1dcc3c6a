//! What the laws of a scene are, never how they are solved in time.
//!
//! [`Effects`] is the only list of effects. Each law is one file named by its law or paper: a rate for what acts
//! continuously, an impulse for an impact. Engines that solve in time call these; the exact engine writes the closed form
//! of each rate anew and never calls the rate, so that the two can be held against each other.

pub mod cloth;
pub mod contact;
pub mod cue;
pub mod cushion;
mod effects;
pub mod friction;
pub mod invariants;
pub mod pockets;
mod state;

pub use effects::{Cloth, Contact, Cushion, EFFECTS, EffectEntry, Effects, Friction, Pockets};
pub use state::{Body, Motion, Side, State};
