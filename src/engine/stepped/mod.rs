//! What every engine needs that advances a whole world by fixed steps: the author writes a [`World`], the rest is here.
//!
//! | file | what lives there |
//! |---|---|
//! | `world.rs` | [`World`]: a scene inside an engine, one step at a time |
//! | `alone.rs` | [`WorldEngine`]: an engine that is a world and nothing else |
//! | `clock.rs` | how a duration is cut into steps; the report's model goes by it as well |
//! | `run.rs` | the stepping loop: a world becomes a [`crate::engine::Run`] |
//! | `journal.rs` | impacts from impulses, both sides of each, extrema |
//! | `cloth.rs` | what of a cloth under balls that turn a world may leave out, as loads; what a step without impact leaves |
//! | `rest.rs` | when a ball counts as stopped, and when it slips |
//! | `materials.rs` | coefficients of balls, cloth and cushions |
//!
//! It is no engine and knows none: nothing here names a symbol of an engine's crate.

mod alone;
mod clock;
mod cloth;
mod journal;
pub mod materials;
mod rest;
mod run;
mod world;

pub use alone::WorldEngine;
pub use clock::{Clock, Span, check_step};
pub use cloth::Load;
pub use rest::{rest_speed, slip_rest};
pub use run::{Setup, Stepped};
pub use world::{Other, Push, World};
