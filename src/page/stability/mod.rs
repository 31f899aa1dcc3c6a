//! The document of a matrix of hard cases: what the terminal shows, and the whole page.

mod broken;
mod figures;
mod tables;
mod words;

use crate::finding::{Block, Document};
use crate::study::Extent;
use crate::study::stability::{StabilityOutcome, short};
use crate::words::{describe_ending, describe_scene};

/// No more scenes than this are shown run by run without a folder for their pages.
const FEW: usize = 3;

/// What the terminal shows. `changed`: whether a cell of a scene differs from what was accepted.
pub fn summary(outcome: &StabilityOutcome, changed: &dyn Fn(usize, &str) -> bool) -> Document {
    let mut blocks = Vec::new();
    let broken = outcome.broken_promises();
    if !broken.is_empty() {
        blocks.push(Block::Text("Promised, and broken:".to_owned()));
        blocks.push(Block::List(broken));
    }
    blocks.push(Block::Table(tables::matrix(outcome, changed)));
    blocks.extend(tables::steps(outcome).map(Block::Table));
    blocks.extend(words::left_out(outcome).map(Block::Text));
    if outcome.question.scenes.len() <= FEW {
        for scene in 0..outcome.question.scenes.len() {
            blocks.extend(about(outcome, scene));
            blocks.push(Block::Table(tables::scene(outcome, scene)));
        }
    }
    let extent = Extent::of(outcome.done() as u64, outcome.asked as u64);
    Document {
        id: "index".to_owned(),
        stopped_early: extent.stopped_early("runs were judged"),
        title: "Hard cases".to_owned(),
        lead: words::sentence(outcome),
        blocks,
        pages: Vec::new(),
    }
}

/// The whole page: also the rules, and a page a scene with its pictures.
pub fn page(outcome: &StabilityOutcome, changed: &dyn Fn(usize, &str) -> bool) -> Document {
    let mut document = summary(outcome, changed);
    // each beside its table
    for (table, figure) in [
        ("steps", figures::steps(outcome)),
        ("matrix", figures::matrix(outcome)),
    ] {
        let is_it = |block: &Block| matches!(block, Block::Table(known) if known.id == table);
        let place = document.blocks.iter().position(is_it);
        if let (Some(place), Some(figure)) = (place, figure) {
            document.blocks.insert(place, Block::Figure(figure));
        }
    }
    document.blocks.push(Block::Table(tables::rules()));
    document
        .blocks
        .extend(tables::absent_cells(outcome).map(Block::Table));
    document
        .blocks
        .push(Block::Command("carom stability".to_owned()));
    document.pages = (0..outcome.question.scenes.len())
        .map(|scene| of_scene(outcome, scene))
        .collect();
    document
}

/// What a scene is, and what the exact engine says of it.
fn about(outcome: &StabilityOutcome, index: usize) -> Vec<Block> {
    let scene = &outcome.question.scenes[index];
    let mut blocks = vec![
        Block::Heading(scene.name.clone()),
        Block::Text(
            scene
                .description
                .split_whitespace()
                .collect::<Vec<_>>()
                .join(" "),
        ),
        Block::Text(describe_scene(scene)),
    ];
    blocks.extend(outcome.oracles[index].as_ref().map(|oracle| {
        let (certain, all) = oracle.certain;
        Block::Text(format!(
            "{}; right about {certain} of {all} events; growth {}.",
            describe_ending(&oracle.trace),
            short(oracle.grown)
        ))
    }));
    blocks
}

fn of_scene(outcome: &StabilityOutcome, index: usize) -> Document {
    let scene = &outcome.question.scenes[index];
    let mut blocks = about(outcome, index);
    // the title says it
    blocks.remove(0);
    blocks.push(Block::Table(tables::scene(outcome, index)));
    let pictures = outcome.of_scene(index).filter_map(|case| {
        let judged = case.judged.as_ref()?;
        let label = case.planned.column.label();
        Some(broken::picture(
            scene,
            &label,
            judged.broken.as_ref()?,
            judged,
        ))
    });
    let pictures: Vec<Block> = pictures.map(Block::Figure).collect();
    if !pictures.is_empty() {
        blocks.push(Block::Heading("Where it breaks".to_owned()));
        blocks.push(Block::Text(
            "One picture for each preset and each setting that the scene asks for; steps have none."
                .to_owned(),
        ));
        blocks.extend(pictures);
    }
    blocks.push(Block::Heading("Figures".to_owned()));
    blocks.push(Block::Table(tables::figures(outcome, index)));
    blocks.push(Block::Command(format!("carom stability {}", scene.name)));
    Document {
        id: scene.name.clone(),
        stopped_early: None,
        title: scene.name.clone(),
        lead: String::new(),
        blocks,
        pages: Vec::new(),
    }
}
