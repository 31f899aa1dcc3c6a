//! The document of a comparison: what the terminal shows, and the page of a report.

mod contacts;
mod figures;
mod metrics;
mod parting;
mod replay;
mod scale;
mod tables;

pub use figures::{TABLE_CAPTION, table_picture};
pub use replay::replay;
pub use scale::LengthUnit;

use crate::compare::closest_hits;
use crate::finding::{Block, Cell, Document};
use crate::oracle::{self, Lack};
use crate::study::compare::{ComparisonOutcome, PairOutcome, Standing};
use crate::words::{describe_ending, describe_horizon, describe_scene, describe_span, listed};
use scale::Scale;
use tables::{
    CONTACTS, attribution_table, ball_table, comparison_table, contact_table, divergence_table,
    event_table, first_differences, pair_table, sanity_table, settings, sheet,
};

/// What the parts of a comparison are, for one that was stopped.
pub const PARTS: &str = "runs and searches of the comparison came to their end";

/// What the terminal shows of one scene.
pub fn summary(outcome: &ComparisonOutcome, unit: LengthUnit) -> Document {
    let scale = Scale::new(outcome, unit);
    let mut blocks = vec![
        Block::Text(describe_scene(&outcome.scene)),
        Block::Text(reference_line(outcome)),
    ];
    blocks.extend(overlapping_hits(outcome).map(Block::Text));
    blocks.push(Block::Table(comparison_table(outcome, &scale)));
    blocks.extend(first_differences(outcome).map(Block::Table));
    blocks.extend(contact_table(outcome, &scale).map(Block::Table));
    if outcome.reference.is_some() {
        blocks.push(Block::Table(attribution_table(outcome, &scale)));
    }
    blocks.extend(pair_table(outcome, &scale).map(Block::Table));
    Document {
        id: outcome.scene.name.clone(),
        stopped_early: outcome.extent.stopped_early(PARTS),
        title: outcome.scene.name.clone(),
        lead: headline(outcome),
        blocks,
        pages: Vec::new(),
    }
}

/// Rows of a table of contacts that a reader of a terminal takes in.
const MOST_CONTACTS: usize = 12;

/// Cuts a summary to what a reader of a terminal takes in, and says what it leaves out.
pub fn shorten(document: &mut Document) {
    for block in &mut document.blocks {
        let Block::Table(table) = block else { continue };
        let more = table.rows.len().saturating_sub(MOST_CONTACTS);
        if table.id == CONTACTS && more > 0 {
            table.rows.truncate(MOST_CONTACTS);
            table.note = format!(
                "And {more} more rows; csv and json have them. {}",
                table.note
            );
        }
    }
}

/// The page of one scene in a report.
pub fn page(outcome: &ComparisonOutcome) -> Document {
    let scale = Scale::new(outcome, LengthUnit::Radius);
    let summary = summary(outcome, LengthUnit::Radius);
    // the first screen: what differs, where it begins, and the shot itself
    let first = divergence_table(outcome, &scale).or_else(|| pair_table(outcome, &scale));
    let mut blocks: Vec<Block> = first.into_iter().map(Block::Table).collect();
    blocks.extend(parting::first_parting(outcome).map(Block::Figure));
    blocks.push(match replay(outcome) {
        Ok(replay) => Block::Replay(Box::new(replay)),
        Err(why) => Block::Text(format!("There is no replay: {why}.")),
    });
    blocks.push(Block::Heading("The scene".to_owned()));
    blocks.push(Block::Text(outcome.scene.description.clone()));
    blocks.extend(summary.blocks);
    blocks.push(Block::Heading("Pictures".to_owned()));
    blocks.extend(
        outcome
            .entries
            .iter()
            .filter_map(|entry| figures::paths(outcome, entry))
            .map(Block::Figure),
    );
    blocks.push(Block::Figure(figures::cue_speed(outcome)));
    blocks.push(Block::Figure(figures::rms_speed(outcome)));
    blocks.extend(figures::divergence(outcome).map(Block::Figure));
    let certainty = figures::certainty(outcome);
    if !certainty.is_empty() {
        blocks.push(Block::Heading("How far it can be believed".to_owned()));
        blocks.extend(certainty.into_iter().map(Block::Figure));
    }
    blocks.push(Block::Heading("Ball by ball".to_owned()));
    blocks.push(Block::Table(ball_table(outcome)));
    blocks.push(Block::Table(event_table(outcome)));
    blocks.push(Block::Heading(
        "What each run says against itself".to_owned(),
    ));
    blocks.push(Block::Table(sanity_table(outcome, &scale)));
    blocks.push(Block::Heading("Everything that was measured".to_owned()));
    blocks.push(Block::Table(metrics::table(outcome)));
    blocks.push(Block::Heading("What each engine was told".to_owned()));
    blocks.push(Block::Table(sheet(outcome)));
    blocks.push(Block::Table(settings(outcome)));
    blocks.push(Block::Heading("Run it yourself".to_owned()));
    for command in ["compare", "horizon"] {
        let line = format!("carom {command} {}", outcome.scene.name);
        blocks.push(Block::Command(line));
    }
    Document { blocks, ..summary }
}

/// The picture of a scene for a table of scenes.
pub fn thumbnail(outcome: &ComparisonOutcome) -> Cell {
    figures::thumbnail(outcome).map_or(Cell::Empty, |figure| Cell::Picture(Box::new(figure)))
}

/// The sentence a person came for.
pub fn headline(outcome: &ComparisonOutcome) -> String {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    for entry in &outcome.entries {
        let Some(standing) = &entry.standing else {
            continue;
        };
        let what = behaviour(standing);
        match groups.iter_mut().find(|(known, _)| *known == what) {
            Some((_, labels)) => labels.push(entry.label()),
            None => groups.push((what, vec![entry.label()])),
        }
    }
    let sentences = groups.into_iter().map(|(what, labels)| {
        let ending = if labels.len() == 1 { "s" } else { "" };
        format!("{} {}", listed(&labels), what.replace('~', ending))
    });
    let mut sentences: Vec<String> = sentences.collect();
    if let Some((lack, why)) = &outcome.no_reference {
        sentences.push(format!("{}: {why}", lacking(*lack)));
        sentences.extend(
            outcome
                .pairs
                .first()
                .map(|pair| pair_sentence(outcome, pair)),
        );
    }
    let text = sentences.join("; ");
    if text.is_empty() { text } else { text + "." }
}

/// Why there is nothing to hold the engines against: the physics has no one answer, or the reference stopped, refused, or was not asked.
fn lacking(lack: Lack) -> String {
    let solver = oracle::engine().id();
    match lack {
        Lack::NotUnique(time) => format!("No single right answer from t = {time:.4} s on"),
        Lack::StoppedAt(time) => format!("{solver} stopped at t = {time:.4} s"),
        Lack::Refused => format!("{solver} refuses the scene"),
        Lack::NotAsked => "Nothing to hold the engines against".to_owned(),
    }
}

/// What an engine does to the exact order of collisions, as the rest of a sentence; `~` stands for the s of one engine.
fn behaviour(standing: &Standing) -> String {
    let total = standing.order.reference_collisions;
    match &standing.order.parting {
        Some(parting) if parting.reference.is_none() => format!(
            "keep~ the exact order of all {total} collisions and add~ {} from t = {:.4} s",
            standing.order.collisions - total,
            parting.time()
        ),
        Some(parting) => format!(
            "leave~ the exact order of collisions at event {} of {total}, t = {:.4} s",
            parting.index + 1,
            parting.time()
        ),
        None if total == 0 => "meet~ nothing, as exact".to_owned(),
        None => format!("keep~ the exact order of all {total} collisions"),
    }
}

fn pair_sentence(outcome: &ComparisonOutcome, pair: &PairOutcome) -> String {
    let (a, b) = (
        outcome.entries[pair.entries.0].label(),
        outcome.entries[pair.entries.1].label(),
    );
    match &pair.standing.order.parting {
        Some(parting) => format!(
            "{a} and {b} part at event {}, t = {:.4} s",
            parting.index + 1,
            parting.time()
        ),
        None => format!("{a} and {b} have the same collision order"),
    }
}

fn reference_line(outcome: &ComparisonOutcome) -> String {
    let reference = outcome.reference.map(|i| &outcome.entries[i]);
    match reference.and_then(|entry| Some((entry.label(), entry.trace()?))) {
        Some((label, trace)) => format!(
            "Reference: {label}, {} events of which {} collisions. {}.{}",
            trace.events.len(),
            trace.collisions().count(),
            describe_ending(trace),
            horizon_line(outcome)
        ),
        None => format!(
            "No reference: {}.",
            outcome
                .no_reference
                .as_ref()
                .map_or("no run is complete", |(_, why)| why)
        ),
    }
}

/// Two phenolic balls of some 3 cm touch for about this long, s (Hertz).
const TOUCH: f64 = 200e-6;
/// Radii of balls of which that is true, m.
const OF_BILLIARDS: std::ops::Range<f64> = 0.02..0.04;

/// That hits are closer in the reference than real balls touch: it has one right answer for impulses, which take no time.
fn overlapping_hits(outcome: &ComparisonOutcome) -> Option<String> {
    let scene = &outcome.scene;
    let units = &scene.units;
    let metre = (units.length == "m").then_some(1.0);
    let metres = scene.smallest_radius() * units.length_in_metres.or(metre)?;
    let trace = outcome.entries[outcome.reference?].trace()?;
    let hits = closest_hits(trace, false)?;
    (OF_BILLIARDS.contains(&metres) && hits.apart < TOUCH).then(|| {
        format!(
            "Ball {} is hit twice within {} at t = {:.4} s: real balls touch for some {}, so their hits overlap there, and the one right answer is \
             that of impulses.",
            scene.balls[hits.ball].id,
            describe_span(hits.apart),
            hits.time,
            describe_span(TOUCH)
        )
    })
}

/// How far the reference can be believed, and what to do beyond.
fn horizon_line(outcome: &ComparisonOutcome) -> String {
    let Some(horizon) = &outcome.horizon else {
        return String::new();
    };
    let mut line = format!(" Horizon: {}.", describe_horizon(horizon));
    if !horizon.is_whole() {
        line += &format!(
            " Beyond it final positions are noise, in every engine: compare them as distributions with carom ensemble {}.",
            outcome.scene.name
        );
    }
    line
}
