//! `carom cost`.

use super::arguments::{CostArguments, parse_engines};
use super::{Failure, publish_with, scene, terminal};
use crate::engine::Roster;
use crate::page;
use crate::study::cost::{self, PriceList};
use crate::study::{Configuration, Watch};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Folder of the studies of cost below that of a report, one folder a scene.
const FOLDER: &str = "cost";

/// The price list of a study, for a report to read.
const PRICES: &str = "prices.json";

/// Studies what accuracy costs in one scene, prints the price list and writes the page below the report's folder.
pub fn cost(arguments: &CostArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    let named: Vec<Configuration> = match &arguments.engines {
        Some(list) => parse_engines(roster, list)?,
        None => Vec::new(),
    };
    let grid = arguments.grid;
    let scene = scene::resolve(&arguments.scene)?;
    let progress = terminal::Progress::new();
    let show = |done: usize, total: usize, what: &str| progress.show(done, total, what);
    let watch = Watch {
        progress: &show,
        cancelled: terminal::cancelled(),
    };
    let outcome = cost::study(roster, &scene, &named, grid, watch);
    drop(progress);
    let folder = folder(&arguments.out, &scene.name);
    // everything for programs, what a reader can take in for a terminal
    let shown = if arguments.format.is_cut {
        page::cost::summary(&outcome)
    } else {
        page::cost::page(&outcome)
    };
    let mut prices = Vec::new();
    if !outcome.stopped {
        let list = serde_json::to_string_pretty(&page::cost::price_list(&outcome, &scene))
            .map_err(|error| Failure::Message(error.to_string()))?;
        prices.push((PRICES.to_owned(), list));
    }
    publish_with(
        &shown,
        &arguments.format,
        || page::cost::page(&outcome),
        Some(&folder),
        prices,
    )
}

fn folder(report: &Path, scene: &str) -> PathBuf {
    report.join(FOLDER).join(scene)
}

/// The price lists that studies left below the folder of a report, of the scenes named. One that is missing or cannot be read is left
/// out: the report names the command that makes it.
pub fn price_lists<'a>(report: &Path, scenes: impl Iterator<Item = &'a str>) -> Vec<PriceList> {
    let read = |scene: &str| {
        let text = std::fs::read_to_string(folder(report, scene).join(PRICES)).ok()?;
        serde_json::from_str(&text).ok()
    };
    scenes.filter_map(read).collect()
}
