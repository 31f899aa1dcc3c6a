//! Pages: what each study found, as a document. Every table, figure and sentence of a study is made here, and nothing is run.

pub mod answer;
mod certainty;
pub mod check;
pub mod claims;
pub mod compare;
pub mod cost;
pub mod curves;
pub mod effects;
pub mod ensemble;
pub mod horizon;
mod logarithm;
pub mod mutation;
pub mod random;
pub mod stability;
pub mod validation;
