//! The document of a study of cost: what the terminal shows, and the whole page.

mod figures;
mod listing;
mod tables;
mod words;

pub use listing::listing;

use crate::finding::{Block, Document};
use crate::scene::Scene;
use crate::study::cost::{CostOutcome, Price, PriceList, Quantity, THRESHOLDS, cheapest, offers};
use crate::words::{describe_scene, describe_span};

/// What the terminal shows.
pub fn summary(outcome: &CostOutcome) -> Document {
    let mut blocks = opening(outcome);
    if outcome.levels.is_cut_short() {
        blocks.extend(what_was_run(outcome));
        return document(outcome, blocks);
    }
    blocks.push(Block::Table(tables::cheapest_in_short(outcome)));
    blocks.extend(tables::rankings(outcome).into_iter().map(Block::Table));
    blocks.push(Block::Table(tables::families(outcome)));
    blocks.extend(tables::fronts(outcome).map(Block::Table));
    document(outcome, blocks)
}

/// The whole page: also the pictures and every setting.
pub fn page(outcome: &CostOutcome) -> Document {
    let mut blocks = vec![Block::Text(outcome.scene.description.clone())];
    blocks.extend(opening(outcome));
    if outcome.levels.is_cut_short() {
        blocks.extend(what_was_run(outcome));
        blocks.push(Block::Command(command(outcome)));
        return document(outcome, blocks);
    }
    blocks.extend(figures::main(outcome).map(Block::Figure));
    blocks.push(Block::Table(tables::cheapest(outcome)));
    blocks.extend(tables::rankings(outcome).into_iter().map(Block::Table));
    blocks.push(Block::Table(tables::families(outcome)));
    blocks.extend(tables::causes(outcome).map(Block::Table));
    blocks.extend(tables::fronts(outcome).map(Block::Table));
    blocks.extend(figures::all(outcome).into_iter().skip(1).map(Block::Figure));
    blocks.push(Block::Table(tables::settings(outcome)));
    blocks.push(Block::Command(command(outcome)));
    document(outcome, blocks)
}

/// What a study says that was stopped: which setting is cheapest takes all of them, what each does takes itself alone.
fn what_was_run(outcome: &CostOutcome) -> [Block; 2] {
    [tables::families(outcome), tables::settings(outcome)].map(Block::Table)
}

fn document(outcome: &CostOutcome, blocks: Vec<Block>) -> Document {
    Document {
        id: format!("cost-{}", outcome.scene.name),
        stopped_early: outcome.stopped_early(),
        title: format!("{}: what accuracy costs", outcome.scene.name),
        lead: words::sentence(outcome),
        blocks,
        pages: Vec::new(),
    }
}

fn opening(outcome: &CostOutcome) -> Vec<Block> {
    let mut blocks = vec![Block::Text(describe_scene(&outcome.scene))];
    if let Some(until) = outcome.certain_until {
        blocks.push(Block::Text(format!(
            "The scene is studied up to {}: beyond, the oracle itself cannot be believed (carom horizon {}).",
            describe_span(until),
            outcome.scene.name
        )));
    }
    blocks.push(Block::Text(format!(
        "Oracle: exact with 237 bits. Grid: {}. {} of simulated time a shot.",
        outcome.grid.id(),
        describe_span(outcome.simulated)
    )));
    blocks
}

/// The command that prints the same.
pub fn command(outcome: &CostOutcome) -> String {
    let mut command = format!(
        "carom cost {} --grid {}",
        outcome.scene.name,
        outcome.grid.id()
    );
    if !outcome.named.is_empty() {
        let engines: Vec<String> = outcome
            .named
            .iter()
            .map(|column| column.label().replace(' ', ":"))
            .collect();
        command += &format!(" --engines {}", engines.join(","));
    }
    command
}

/// The price list of a study. `scene`: as it was given, before the study shortened it to what can be believed.
pub fn price_list(outcome: &CostOutcome, scene: &Scene) -> PriceList {
    let mut prices = Vec::new();
    for quantity in Quantity::ALL {
        let offers = offers(outcome, quantity);
        for error in THRESHOLDS {
            prices.extend(cheapest(offers.iter().copied(), error).map(|offer| Price {
                quantity: quantity.id().to_owned(),
                error,
                engine: offer.engine().to_owned(),
                setting: offer.point.level.column.setting.to_string(),
                label: words::short_label(offer.point),
                reached: offer.error,
                seconds: offer.seconds,
            }));
        }
    }
    PriceList {
        scene: scene.name.clone(),
        scene_hash: scene.hash(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        command: command(outcome),
        prices,
    }
}
