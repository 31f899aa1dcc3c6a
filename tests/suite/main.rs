//! One test binary: what the crate promises, held from outside.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

mod scene_cli;
mod scene_errors;
mod scene_fuzz;
mod scenes;
mod support;
