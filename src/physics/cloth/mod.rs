//! Rates: what the cloth does to a ball between impacts. One file per law.

pub mod rotational;
pub mod translational;
