//! One test binary: what the crate promises, held from outside.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

mod architecture;
mod claims;
mod cli;
mod compare;
mod contract;
mod effects;
mod ensemble;
mod exact;
mod exact_certainty;
mod exact_effects;
mod exact_endings;
mod exact_laws;
mod exact_reflections;
mod exact_scale;
mod exact_symmetries;
mod horizon;
mod missed_collisions;
mod perturb;
mod precision;
mod random;
mod rapier;
mod references;
mod registries;
mod report;
mod roots;
mod scene_cli;
mod scene_errors;
mod scene_fuzz;
mod scenes;
mod shots;
mod stepper;
mod support;
mod trace_files;
mod transcription;
