//! Studies: each is a plan that makes a matrix of runs and a conclusion that reads what came out.

pub mod answer;
pub mod check;
pub mod claims;
pub mod compare;
pub mod cost;
pub mod curves;
pub mod effects;
pub mod ensemble;
mod extent;
pub mod horizon;
pub mod matrix;
pub mod mutation;
pub mod random;
pub mod stability;
pub mod validation;

pub use answer::Answer;
pub use extent::Extent;
pub use matrix::{Cell, Configuration, ListError, Ran, Timing, Watch};
