//! The document of an ensemble: what the terminal shows, and the whole page.

mod figures;
mod spread;

pub use spread::{surround, surroundings};

use crate::finding::{Block, Cell, Column, Document, Table, Tone};
use crate::math::statistics::Distribution;
use crate::study::ensemble::{
    EnsembleEntry, EnsembleOutcome, Farthest, LEVEL, NEGLIGIBLE, Quantity, Test,
};
use crate::words::describe_scene;
use std::collections::{BTreeMap, BTreeSet};

/// What the terminal shows.
pub fn summary(outcome: &EnsembleOutcome) -> Document {
    let plan = &outcome.plan;
    let mut blocks = vec![Block::Text(describe_scene(&plan.scene))];
    let mut law = outcome.law.clone();
    law.push(format!(
        "{} sample{}, seed {}; a sample depends on the seed and its number alone",
        plan.samples,
        plural(plan.samples),
        plan.seed
    ));
    blocks.push(Block::List(law));
    blocks.push(Block::Table(engine_table(outcome)));
    blocks.extend(agreement_table(outcome).map(Block::Table));
    blocks.push(Block::Table(ball_table(outcome)));
    blocks.push(Block::Table(order_table(outcome)));
    Document {
        id: format!("ensemble-{}", plan.scene.name),
        stopped_early: outcome.stopped_early(),
        title: format!("{}: an ensemble", plan.scene.name),
        lead: headline(outcome),
        blocks,
        pages: Vec::new(),
    }
}

/// The whole page: also quantiles, tests and pictures.
pub fn page(outcome: &EnsembleOutcome) -> Document {
    let mut document = summary(outcome);
    let blocks = &mut document.blocks;
    blocks.insert(0, Block::Text(outcome.plan.scene.description.clone()));
    blocks.push(Block::Heading("Pictures".to_owned()));
    blocks.extend(figures::landings(outcome).into_iter().map(Block::Figure));
    blocks.extend(figures::telling(outcome).map(Block::Figure));
    blocks.push(Block::Heading("Distributions, ball by ball".to_owned()));
    for (which, quantity) in Quantity::ALL.into_iter().enumerate() {
        blocks.push(Block::Table(quantity_table(outcome, which, quantity)));
    }
    blocks.push(Block::Heading("Run it yourself".to_owned()));
    blocks.push(Block::Command(command(outcome)));
    document
}

/// Over which samples means and deviations are taken: where an engine does not reach the end in all of them, its outcome has chosen them.
fn covered(outcome: &EnsembleOutcome) -> String {
    let done = outcome.done;
    let each = outcome.entries.iter().map(|entry| {
        let complete = entry.complete().count();
        (complete, format!("{} {complete} of {done}", entry.label()))
    });
    let (counts, parts): (Vec<usize>, Vec<String>) = each.unzip();
    let mean = "Mean and standard deviation are over the samples whose run reaches the end";
    if counts.iter().all(|complete| *complete == done) {
        return format!("{mean}: all {done}.");
    }
    let parts = parts.join(", ");
    format!(
        "{mean}: {parts}. What is left out is chosen by its outcome, so these are no means over all samples."
    )
}

/// The command that prints the same.
fn command(outcome: &EnsembleOutcome) -> String {
    let plan = &outcome.plan;
    let engines: Vec<String> = plan
        .columns
        .iter()
        .map(|column| column.label().replace(' ', ":"))
        .collect();
    let mut command = format!(
        "carom ensemble {} --samples {} --seed {} --engines {}",
        plan.scene.name,
        plan.samples,
        plan.seed,
        engines.join(",")
    );
    let law = plan.law;
    for (flag, size) in [("aim", law.aim), ("speed", law.speed), ("gap", law.gap)] {
        if size > 0.0 {
            command += &format!(" --{flag} {size}");
        }
    }
    command
}

fn plural(n: usize) -> &'static str {
    if n == 1 { "" } else { "s" }
}

/// The sentence a person came for.
fn headline(outcome: &EnsembleOutcome) -> String {
    let mut sentences = Vec::new();
    let reference = outcome.reference.map(|index| &outcome.entries[index]);
    for (index, entry) in outcome.entries.iter().enumerate() {
        if entry.complete().next().is_none() {
            sentences.push(format!(
                "{} reaches the end in none of {} samples.",
                entry.label(),
                outcome.done
            ));
        } else if let Some(reference) = reference.filter(|_| entry.agreement.is_some()) {
            sentences.push(against(outcome, reference, index, entry));
        }
    }
    let compared = !outcome.tests.is_empty();
    if let Some(reference) = reference.filter(|_| !compared) {
        sentences.push(alone(outcome, reference));
    }
    sentences.join(" ")
}

/// What one engine by itself says: how wide its answers are spread.
fn alone(outcome: &EnsembleOutcome, entry: &EnsembleEntry) -> String {
    let complete = entry.complete().count();
    let scene = &outcome.plan.scene;
    let widest = figures::widest(entry);
    let spread = widest.map_or(String::new(), |(ball, which, deviation)| {
        let quantity = Quantity::ALL[which];
        let (scale, unit) = quantity.scale(scene);
        format!(
            ", and where a ball ends deviates by up to {:.2} {unit} (ball {}, {})",
            deviation / scale,
            scene.balls[ball].id,
            quantity.id()
        )
    });
    format!(
        "In {complete} of {} samples {} reaches the end: there are {} different collision orders{spread}.",
        outcome.done,
        entry.label(),
        entry.orders
    )
}

/// What an engine says against the reference.
fn against(
    outcome: &EnsembleOutcome,
    reference: &EnsembleEntry,
    index: usize,
    entry: &EnsembleEntry,
) -> String {
    let scene = &outcome.plan.scene;
    let label = entry.label();
    let Some(agreement) = entry.agreement.as_ref().filter(|a| a.both > 0) else {
        return format!(
            "{label} and {} have no sample in common.",
            reference.label()
        );
    };
    let apart = agreement.apart.map_or(String::new(), |farthest| {
        format!(
            ", and final positions differ by up to {} R",
            short(farthest.value)
        )
    });
    let both = agreement.both;
    if agreement.same_events == both {
        return format!(
            "{label} has the order of all events of {} in {both} of {both} samples{apart}.",
            reference.label()
        );
    }
    let differing: BTreeSet<usize> = outcome
        .tests
        .iter()
        .filter(|test| test.entry == index && test.differs)
        .map(|test| test.ball)
        .collect();
    format!(
        "{label} has the collision order of {} in {} of {both} samples{apart}; the distributions of where or when a ball stops are \
         found to differ for {} of {} balls.",
        reference.label(),
        agreement.same_collisions,
        differing.len(),
        scene.balls.len()
    )
}

/// Three significant digits.
pub(super) fn short(x: f64) -> String {
    if x == 0.0 || (1e-3..1e4).contains(&x) {
        format!("{x:.3}")
    } else {
        format!("{x:.2e}")
    }
}

/// What became of the samples in each engine.
fn engine_table(outcome: &EnsembleOutcome) -> Table {
    let columns = vec![
        Column::words("engine", "engine"),
        Column::number("samples", "samples", ""),
        Column::number("complete", "complete", ""),
        Column::words("otherwise", "ended otherwise"),
        Column::number("orders", "collision orders", ""),
    ];
    let mut rows = Vec::new();
    for entry in &outcome.entries {
        let mut otherwise: BTreeMap<&str, usize> = BTreeMap::new();
        let mut refusals: BTreeMap<String, usize> = BTreeMap::new();
        for cell in entry.cells.iter().flatten() {
            match cell {
                Ok(landing) if landing.complete => {}
                Ok(landing) => *otherwise.entry(landing.ending).or_default() += 1,
                Err(refusal) => *refusals.entry(refusal.to_string()).or_default() += 1,
            }
        }
        let endings = otherwise.iter().map(|(ending, n)| format!("{ending} {n}"));
        let refused = refusals
            .iter()
            .map(|(why, n)| format!("refused {n}: {why}"));
        rows.push(vec![
            Cell::text(entry.label()),
            Cell::Count(outcome.done as u64),
            Cell::Count(entry.complete().count() as u64),
            Cell::Text(endings.chain(refused).collect::<Vec<_>>().join(", ")),
            Cell::Count(entry.orders as u64),
        ]);
    }
    Table {
        id: "engines".to_owned(),
        columns,
        rows,
        note: "Complete: everything at rest, or the scene's duration reached. All that follows is of complete runs.".to_owned(),
        ..Table::default()
    }
}

/// Each engine against the reference, sample by sample.
fn agreement_table(outcome: &EnsembleOutcome) -> Option<Table> {
    let reference = &outcome.entries[outcome.reference?];
    let others = || {
        outcome
            .entries
            .iter()
            .filter_map(|e| Some((e, e.agreement.as_ref()?)))
    };
    others().next()?;
    let columns = vec![
        Column::words("engine", "engine"),
        Column::number("both", "samples complete in both", ""),
        Column::number("same-collisions", "same collision order", ""),
        Column::number("same-events", "same order of all events", ""),
        Column::number("apart", "final position, worst (sample, ball)", "R"),
        Column::number(
            "delayed",
            "stop time, worst (sample, ball)",
            &outcome.plan.scene.units.time,
        ),
    ];
    let owned = |farthest: Option<Farthest>| {
        farthest.map_or(Cell::Empty, |f| {
            let ball = &outcome.plan.scene.balls[f.ball].id;
            Cell::Owned(f.value, format!("{}, {ball}", f.sample))
        })
    };
    let mut rows = Vec::new();
    for (entry, agreement) in others() {
        rows.push(vec![
            Cell::text(entry.label()),
            Cell::Count(agreement.both as u64),
            Cell::Count(agreement.same_collisions as u64),
            Cell::Count(agreement.same_events as u64),
            owned(agreement.apart),
            owned(agreement.delayed),
        ]);
    }
    Some(Table {
        id: "agreement".to_owned(),
        title: format!("Against {}, sample by sample", reference.label()),
        columns,
        rows,
        note: "The largest difference of any ball over all samples. Samples are numbered from 0."
            .to_owned(),
    })
}

/// Mean and deviation of every ball in every engine.
fn ball_table(outcome: &EnsembleOutcome) -> Table {
    let scene = &outcome.plan.scene;
    let mut columns = vec![
        Column::words("ball", "ball"),
        Column::words("engine", "engine"),
    ];
    let scales = Quantity::ALL.map(|quantity| quantity.scale(scene));
    for (quantity, (_, unit)) in Quantity::ALL.into_iter().zip(scales) {
        let id = quantity.id();
        columns.push(Column::number(
            &format!("{id}-mean"),
            quantity.title(),
            unit,
        ));
        columns.push(Column::number(&format!("{id}-deviation"), "+-", unit));
    }
    let several = outcome.entries.len() > 1;
    if several {
        columns.push(Column::words("differs", "differs in"));
    }
    let mut rows = Vec::new();
    for (ball, id) in scene.balls.iter().map(|ball| &ball.id).enumerate() {
        for (index, entry) in outcome.entries.iter().enumerate() {
            let mut row = vec![Cell::text(id.clone()), Cell::text(entry.label())];
            for (distribution, (scale, _)) in entry.distributions[ball].iter().zip(scales) {
                row.push(fixed(distribution, |d| Some(d.mean() / scale)));
                row.push(fixed(distribution, |d| Some(d.deviation()? / scale)));
            }
            if several {
                row.push(differences(outcome, index, ball));
            }
            rows.push(row);
        }
    }
    let reference = outcome
        .reference
        .map(|index| outcome.entries[index].label());
    let note = if let Some(reference) = reference.filter(|_| several) {
        format!(
            "{} Differs: by Kolmogorov and Smirnov against {reference}, with a \
             p-value below {LEVEL} after Holm's correction for all {} tests here, and by more than {NEGLIGIBLE:e} R.",
            covered(outcome),
            outcome.tests.len()
        )
    } else {
        covered(outcome)
    };
    Table {
        id: "balls".to_owned(),
        title: "Where and when the balls stopped".to_owned(),
        columns,
        rows,
        note,
    }
}

fn fixed(
    distribution: &Option<Distribution>,
    number: impl Fn(&Distribution) -> Option<f64>,
) -> Cell {
    let number = distribution.as_ref().and_then(number);
    number.map_or(Cell::Empty, |x| Cell::Fixed(x, 4))
}

/// The quantities in which a ball is distributed differently from the reference.
fn differences(outcome: &EnsembleOutcome, entry: usize, ball: usize) -> Cell {
    let own: Vec<&Test> = outcome
        .tests
        .iter()
        .filter(|test| test.entry == entry && test.ball == ball)
        .collect();
    let differing = own.iter().filter(|test| test.differs);
    let words: Vec<&str> = differing.map(|test| test.quantity.id()).collect();
    match (own.is_empty(), words.is_empty()) {
        (true, _) => Cell::Empty,
        (false, true) => Cell::verdict(Tone::Good, "nothing"),
        (false, false) => Cell::verdict(Tone::Bad, words.join(", ")),
    }
}

/// The most frequent collision orders.
fn order_table(outcome: &EnsembleOutcome) -> Table {
    let mut columns = vec![
        Column::number("rank", "#", ""),
        Column::number("collisions", "collisions", ""),
    ];
    for entry in &outcome.entries {
        let label = entry.label();
        columns.push(Column::number(&label.replace([' ', '='], "-"), &label, ""));
    }
    columns.push(Column::number("sample", "first in sample", ""));
    columns.push(Column::words("order", "order"));
    let rows = outcome.frequent.iter().enumerate().map(|(rank, frequent)| {
        let mut row = vec![
            Cell::Count(rank as u64 + 1),
            Cell::Count(u64::from(frequent.order.count)),
        ];
        row.extend(frequent.counts.iter().map(|n| Cell::Count(*n as u64)));
        row.push(Cell::Count(frequent.first.0 as u64));
        row.push(Cell::text(frequent.words.clone()));
        row
    });
    Table {
        id: "orders".to_owned(),
        title: "The most frequent collision orders".to_owned(),
        columns,
        rows: rows.collect(),
        note: "Number of samples with the order in each engine; below the first, orders are told from where they leave it."
            .to_owned(),
    }
}

/// Quantiles of one quantity, and its test against the reference.
fn quantity_table(outcome: &EnsembleOutcome, which: usize, quantity: Quantity) -> Table {
    const SHARES: [(&str, f64); 5] = [
        ("5", 0.05),
        ("25", 0.25),
        ("50", 0.5),
        ("75", 0.75),
        ("95", 0.95),
    ];
    let scene = &outcome.plan.scene;
    let (scale, unit) = quantity.scale(scene);
    let mut columns = vec![
        Column::words("ball", "ball"),
        Column::words("engine", "engine"),
        Column::number("samples", "samples", ""),
        Column::number("mean", "mean", unit),
        Column::number("deviation", "+-", unit),
    ];
    columns.extend(
        SHARES.map(|(share, _)| Column::number(&format!("q{share}"), &format!("{share} %"), unit)),
    );
    columns.extend([
        Column::number("distance", "KS distance", ""),
        Column::number("p", "p", ""),
        Column::number("corrected", "p, corrected", ""),
        Column::number("transport", "moved by", unit),
        Column::words("verdict", "against the reference"),
    ]);
    let mut rows = Vec::new();
    for (ball, id) in scene.balls.iter().map(|ball| &ball.id).enumerate() {
        for (index, entry) in outcome.entries.iter().enumerate() {
            let distribution = &entry.distributions[ball][which];
            let count = distribution.as_ref().map_or(0, Distribution::count);
            let mut row = vec![
                Cell::text(id.clone()),
                Cell::text(entry.label()),
                Cell::Count(count as u64),
                fixed(distribution, |d| Some(d.mean() / scale)),
                fixed(distribution, |d| Some(d.deviation()? / scale)),
            ];
            let quantile = |share: f64| fixed(distribution, |d| Some(d.quantile(share) / scale));
            row.extend(SHARES.map(|(_, share)| quantile(share)));
            let test = outcome
                .tests
                .iter()
                .find(|test| (test.entry, test.ball, test.quantity) == (index, ball, quantity));
            row.extend(match test {
                Some(test) => [
                    Cell::Number(test.distance),
                    Cell::Number(test.p),
                    Cell::Number(test.corrected),
                    Cell::Number(test.transport / scale),
                    if test.differs {
                        Cell::verdict(Tone::Bad, "differs")
                    } else {
                        Cell::verdict(Tone::Good, "no difference found")
                    },
                ],
                None => [const { Cell::Empty }; 5],
            });
            rows.push(row);
        }
    }
    let note = format!(
        "{} Quantiles are linear between order statistics (definition 7 of Hyndman and Fan). KS: largest distance of the \
         distribution functions. p is for independent samples, and engines share the samples here, which makes it too large \
         rather than too small. Corrected: after Holm, for all {} tests of this ensemble. Moved by: mean distance by which \
         the one distribution has to be moved to become the other.",
        covered(outcome),
        outcome.tests.len()
    );
    Table {
        id: format!("quantiles-{}", quantity.id()),
        title: quantity.title().to_owned(),
        columns,
        rows,
        note,
    }
}
