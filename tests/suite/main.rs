//! One test binary: what the crate promises, held from outside.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

mod architecture;
mod rapier;
mod stepper;
mod support;
mod trace_files;
mod transcription;
