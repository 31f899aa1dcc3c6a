//! The document of an ablation: what the terminal shows, and the whole page.

mod figures;
mod tables;
mod words;

use crate::finding::{Block, Document};
use crate::study::effects::EffectsOutcome;
use crate::words::describe_scene;

/// What the terminal shows.
pub fn summary(outcome: &EffectsOutcome) -> Document {
    let plan = &outcome.plan;
    let mut blocks = vec![Block::Text(describe_scene(&plan.scene))];
    blocks.extend(words::time(outcome).map(Block::Text));
    let found = [
        tables::without(outcome),
        tables::alone(outcome),
        tables::ladder(outcome),
        tables::engines(outcome),
    ];
    blocks.extend(figures::without(outcome).map(Block::Figure));
    blocks.extend(figures::ladder(outcome).map(Block::Figure));
    blocks.extend(found.into_iter().flatten().map(Block::Table));
    Document {
        id: format!("effects-{}", plan.scene.name),
        stopped_early: outcome.stopped_early(),
        title: format!("{}: what its effects are worth", plan.scene.name),
        lead: words::sentence(outcome),
        blocks,
        pages: Vec::new(),
    }
}

/// The whole page: also the scene in words and the pictures.
pub fn page(outcome: &EffectsOutcome) -> Document {
    let mut document = summary(outcome);
    let blocks = &mut document.blocks;
    blocks.insert(0, Block::Text(outcome.plan.scene.description.clone()));
    blocks.extend(figures::paths(outcome).into_iter().map(Block::Figure));
    blocks.push(Block::Command(command(outcome)));
    document
}

/// The command that prints the same.
fn command(outcome: &EffectsOutcome) -> String {
    let engines: Vec<String> = outcome
        .columns
        .iter()
        .map(|column| column.label().replace(' ', ":"))
        .collect();
    format!(
        "carom effects {} --engines {} --threshold {}",
        outcome.plan.scene.name,
        engines.join(","),
        outcome.threshold
    )
}
