//! Replays: what is left out is given by the rest, what a browser decodes is what the engines did, and pages keep to their policy.

mod bytes;
mod pages;
mod thinning;

use carom::scene::{Scene, catalogue};
use carom::study::compare::{self, ComparisonOutcome};
use carom::study::{Configuration, Timing, Watch};

/// A scene compared in the engines of a list, or in those of a report.
fn compared(scene: &Scene, engines: Option<&str>) -> ComparisonOutcome {
    let named = engines.map_or_else(
        || compare::default_columns(crate::support::roster()),
        |list| Configuration::list(crate::support::roster(), list).unwrap(),
    );
    let columns: Vec<Configuration> = compare::plan(crate::support::roster(), &named)
        .iter()
        .map(|column| column.as_tried(scene))
        .collect();
    compare::study(scene, None, &columns, Timing::None, Watch::NONE)
}

fn scene(name: &str) -> Scene {
    catalogue::scene(name).unwrap()
}
