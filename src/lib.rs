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
//! A program begins with a scene ([`scene::parse`], [`scene::Scene::builder`], [`scene::catalogue`]) and the engines that it may name
//! ([`engine::Roster`]). [`engine::prepare`] is the only way to a run, [`study::Answer`] compares a scene in several engines, and
//! [`engine::stepped::World`] is what an engine of one's own has to be. `validation/examples/` has a program of each kind, and one that
//! reads the trace that another program wrote ([`trace::files`]).
//!
//! A module imports only from those before it: `carried`, `math`, `physics`, `scene`, `trace`, `engine`, `finding`, `compare`, `oracle`,
//! `law`, `words`, `study`, `page`, `gate`, `report`, `web`, and the command line (`tests/suite/architecture.rs` reads the sources and holds that).
//! Everything is in the scene's own consistent units and in seconds; x runs across the table, y along it, z up, and a ball at rest has its
//! centre at z = R.

pub mod carried;
#[doc(hidden)]
pub mod cli;
pub mod compare;
pub mod engine;
pub mod finding;
pub mod gate;
pub mod law;
pub mod math;
pub mod oracle;
pub mod page;
pub mod physics;
pub mod report;
pub mod scene;
pub mod study;
pub mod trace;
pub mod web;
pub mod words;
