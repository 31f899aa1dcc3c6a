//! `carom`: a cross-validation workbench for rigid-body engines.
//!
//! It takes a billiards scene, runs it in several engines that share nothing but the scene, and says where, when and
//! why they part:
//!
//! ```text
//! scene file ─▶ Scene ─▶ prepare ─▶ Run ─▶ Trace ─▶ metrics ─▶ Findings ─▶ Document ─▶ html, md, csv, json
//!                (asks, builds, audits)      ▲
//!                              exact: reference, once per scene
//! ```
//!
//! The modules below are listed in the order of that pipeline, and a module imports only from modules listed above it
//! (`tests/architecture.rs` reads the source and holds that). Everything is in the scene's own consistent units; x runs
//! across the table, y along it, z up, and a ball at rest has its centre at z = R.

pub mod carried;
pub mod cli;
pub mod compare;
pub mod engine;
pub mod finding;
pub mod gate;
pub mod law;
pub mod math;
pub mod oracle;
pub mod physics;
pub mod report;
pub mod scene;
pub mod study;
pub mod trace;
pub mod web;
