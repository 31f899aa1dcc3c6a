//! Sustained contact: balls that are pressed together, or to a cushion, for longer than an instant.
//!
//! - [`tail`]: the limit of infinitely many impacts, by which such a contact mostly begins.
//! - [`decide`]: which contacts of balls that touch carry a force.
//! - [`group`]: the equations of their common motion; [`arc`]: its solution, by power series, up to the next change.
//! - [`held`]: the groups of a run; [`meet`]: what meets their balls.
//!
//! Our reading where laws are silent: the loss of rolling acts wholly while a ball is pressed, as it does between two impacts but not in
//! the slides that an impact leaves; so contact is not the limit of ever smaller bounces, which lose less. A ball at rest stays while its push is below
//! 7/5 of what rolling loses, which is what vanishing impacts give.

pub mod arc;
pub mod decide;
mod equations;
pub mod foreseen;
pub mod group;
pub mod held;
pub mod meet;
mod row;
pub mod tail;
pub mod touching;
