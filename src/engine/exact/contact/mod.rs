//! Sustained contact: balls that are pressed together, or to a cushion, for longer than an instant.
//!
//! - [`touching`]: which balls touch, and velocities and places in which they do and nothing more; [`decide`]: which of their contacts carry a force.
//! - [`group`]: who is held together; `equations`: of their common motion; [`arc`]: its solution, by power series, up to the next change.
//! - [`held`]: the groups of a run; [`domain`]: in which scenes; [`meet`], `row`: what meets their balls.
//!
//! Not built: friction that holds two balls without slip; what Han's and Mathavan's cushions
//! do to a ball that lies against them, which is taken for smooth.
//!
//! Our reading where laws are silent: the loss of rolling acts wholly while a ball is pressed, as it does between two impacts but not in
//! the slides that an impact leaves; so contact is not the limit of ever smaller bounces, which lose less. A ball at rest stays while its push is below
//! 7/5 of what rolling loses, which is what vanishing impacts give.

pub mod arc;
pub mod decide;
pub mod domain;
mod equations;
pub mod group;
pub mod held;
pub mod meet;
mod row;
pub mod touching;
