//! Infinity and NaN are like themselves alone, wherever numbers are held against each other.

mod cells;
mod engines;
mod traces;
