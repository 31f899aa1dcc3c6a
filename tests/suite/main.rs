//! One test binary: what the crate promises, held from outside.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

mod report;
mod support;
mod trace_files;
