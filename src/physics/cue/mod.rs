//! How a shot sets a ball in motion: by a force that acts for a time, by a strike of a cue, or by a velocity, which needs no law.

pub mod force;
pub mod strike;

pub use force::speed_from_force;
pub use strike::Strike;
