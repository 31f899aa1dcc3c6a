//! A scene whose touching balls are an ensemble, in a comparison: the spread of the exact answers over random gaps, and where
//! the single answer of each engine lies in it.

use super::{EnsembleError, Outcome, Plan, study};
use crate::engine;
use crate::finding::{Block, Cell, Column, Document, Table, Tone};
use crate::math::statistics::Distribution;
use crate::scene::Simultaneous;
use crate::scene::perturb::Law;
use crate::study::compare;
use crate::study::matrix::{self, Watch};

/// Samples of the exact engine behind a comparison.
const SAMPLES: usize = 200;
/// Their seed.
const SEED: u64 = 1;

/// What a comparison says of a scene that asks for an ensemble; nothing for any other scene.
pub fn surroundings(compared: &compare::Outcome, watch: Watch<'_>) -> Vec<Block> {
    let scene = &compared.scene;
    let exact = engine::find("exact").map(matrix::Column::of);
    let (Simultaneous::Ensemble, Some(exact)) = (scene.simultaneous, exact) else {
        return Vec::new();
    };
    let plan = Plan {
        scene: scene.clone(),
        law: Law::default_for(scene),
        samples: SAMPLES,
        seed: SEED,
        columns: vec![exact],
    };
    match study(plan, watch) {
        Ok(outcome) => blocks(compared, &outcome),
        Err(
            error @ (EnsembleError::Law(_) | EnsembleError::Samples(_) | EnsembleError::NoEngine),
        ) => {
            vec![Block::Text(format!("There is no ensemble: {error}."))]
        }
    }
}

/// Puts blocks before the first table of a page, where its reader looks for the right answer.
pub fn surround(page: &mut Document, blocks: Vec<Block>) {
    let tables = page
        .blocks
        .iter()
        .position(|b| matches!(b, Block::Table(_)));
    let at = tables.unwrap_or(page.blocks.len());
    page.blocks.splice(at..at, blocks);
}

fn blocks(compared: &compare::Outcome, ensemble: &Outcome) -> Vec<Block> {
    let Some(exact) = ensemble.entries.first() else {
        return Vec::new();
    };
    let complete = exact.complete().count();
    let mut text = format!(
        "The scene asks for an ensemble: {}; {} samples in exact, seed {SEED}, of which {complete} are complete and have {} \
         different collision orders.",
        ensemble.law.join("; "),
        ensemble.done,
        exact.orders
    );
    for entry in &compared.entries {
        let places = places(compared, entry, ensemble);
        if entry.column.engine.id() != "exact" && !places.is_empty() {
            let within = places.iter().filter(|place| place.outside == 0.0).count();
            text += &format!(
                " {} ends within the range of the samples for {within} of {} balls.",
                entry.label(),
                places.len()
            );
        }
    }
    vec![
        Block::Text(text),
        Block::Table(table(compared, ensemble)),
        Block::Command(format!(
            "carom ensemble {} --samples {SAMPLES} --seed {SEED} --engines exact",
            compared.scene.name
        )),
    ]
}

/// Where the single answer of an engine lies in the ensemble, for one ball.
struct Place {
    ball: usize,
    /// Part of the samples at or below it in x and in y.
    shares: [f64; 2],
    /// How far it is outside the range of the samples, R; 0 inside.
    outside: f64,
}

fn places(compared: &compare::Outcome, entry: &compare::Entry, ensemble: &Outcome) -> Vec<Place> {
    let Some(trace) = entry.trace().filter(|trace| trace.ending.is_complete()) else {
        return Vec::new();
    };
    let radius = compared.scene.smallest_radius();
    let mut places = Vec::new();
    for (ball, state) in trace.final_states().iter().enumerate() {
        let [x, y, _] = &ensemble.entries[0].distributions[ball];
        let (Some(state), Some(x), Some(y)) = (state, x, y) else {
            continue;
        };
        let beyond = |d: &Distribution, at: f64| (d.least() - at).max(at - d.most()).max(0.0);
        let (at_x, at_y) = (state.position.x, state.position.y);
        places.push(Place {
            ball,
            shares: [x.share_up_to(at_x), y.share_up_to(at_y)],
            outside: beyond(x, at_x).hypot(beyond(y, at_y)) / radius,
        });
    }
    places
}

fn table(compared: &compare::Outcome, ensemble: &Outcome) -> Table {
    let scene = &compared.scene;
    let unit = &scene.units.length;
    let mut columns = vec![
        Column::words("ball", "ball"),
        Column::number("x-mean", "x at the end", unit),
        Column::number("x-deviation", "+-", unit),
        Column::number("y-mean", "y at the end", unit),
        Column::number("y-deviation", "+-", unit),
    ];
    let mut shown = Vec::new();
    for entry in &compared.entries {
        let places = places(compared, entry, ensemble);
        if entry.column.engine.id() == "exact" || places.is_empty() {
            continue;
        }
        let label = entry.label();
        columns.push(Column::words(&label.replace([' ', '='], "-"), &label));
        shown.push(places);
    }
    let mut rows = Vec::new();
    for (ball, id) in scene.balls.iter().map(|ball| &ball.id).enumerate() {
        let mut row = vec![Cell::text(id.clone())];
        for distribution in ensemble.entries[0].distributions[ball].iter().take(2) {
            let number = |x: Option<f64>| x.map_or(Cell::Empty, |x| Cell::Fixed(x, 4));
            row.push(number(distribution.as_ref().map(Distribution::mean)));
            row.push(number(distribution.as_ref().and_then(|d| d.deviation())));
        }
        for places in &shown {
            let place = places.iter().find(|place| place.ball == ball);
            row.push(place.map_or(Cell::Empty, verdict));
        }
        rows.push(row);
    }
    Table {
        id: format!("ensemble-{}", scene.name),
        title: "The ensemble, and each engine's single answer in it".to_owned(),
        columns,
        rows,
        note: format!(
            "Mean and standard deviation over the samples. An answer is within the range of n samples in both coordinates, and \
             then stands with the part of them at or below it, or outside by so much; one more sample is outside in a given \
             coordinate with probability 2/(n + 1), here {:.3}.",
            2.0 / (ensemble.entries[0].complete().count() as f64 + 1.0)
        ),
    }
}

fn verdict(place: &Place) -> Cell {
    if place.outside > 0.0 {
        return Cell::verdict(Tone::Notice, format!("{:.3} R outside", place.outside));
    }
    let percent = place.shares.map(|share| format!("{:.0} %", 100.0 * share));
    Cell::verdict(
        Tone::Good,
        format!("within: x {}, y {}", percent[0], percent[1]),
    )
}
