//! One test binary: what the crate promises, held from outside.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

mod exact;
mod exact_endings;
mod exact_laws;
mod exact_symmetries;
mod random;
mod references;
mod support;
