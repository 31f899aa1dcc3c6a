//! Scenes: the file as a person writes it, and the resolved [`Scene`] that engines see.
//!
//! The two are different types. In a [`Scene`] every ball is explicit, every default applied and the shot has been
//! played, so that an engine has nothing left to interpret.

mod resolved;

pub use resolved::{Ball, Scene, Shot, Simultaneous, Table, Units, plan_vector};
