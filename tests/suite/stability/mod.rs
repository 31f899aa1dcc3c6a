//! `carom stability`: its rules on planted traces, its diff, the program, and what rapier is known to do.

mod known;
mod orphans;
mod program;
mod rules;

use carom::finding::{Block, Cell, Figure};
use carom::study::Watch;
use carom::study::stability::{Question, StabilityOutcome, study};
use carom::study::{Configuration, stability};
use carom::{engine, scene::catalogue};
use std::collections::BTreeSet;

/// Columns by their labels.
fn columns(labels: &[&str]) -> Vec<Configuration> {
    let column = |label: &&str| {
        let mut words = label.split(' ');
        let engine = crate::support::find(words.next().unwrap()).unwrap();
        let setting = engine::Setting::parse(words).unwrap();
        Configuration::with(engine, setting)
    };
    labels.iter().map(column).collect()
}

/// The matrix of catalogue scenes in some presets; every preset where none are named.
fn outcome(scenes: &[&str], presets: &[&str]) -> StabilityOutcome {
    let scenes = scenes.iter().map(|name| catalogue::scene(name).unwrap());
    let question = Question {
        roster: crate::support::roster().clone(),
        scenes: scenes.collect(),
        presets: match presets {
            [] => stability::presets(crate::support::roster()),
            named => columns(named),
        },
        full: false,
        pictures: false,
    };
    let watch = Watch::NONE;
    study(question, watch).unwrap()
}

#[test]
fn the_pictures_of_the_matrix_show_every_verdict_of_their_tables() {
    let outcome = outcome(
        &["thin-cut-1e-2", "report-break-frozen", "through-a-ball"],
        &["exact", "stepper"],
    );
    let document = carom::page::stability::page(&outcome, &|_, _| false);
    let table = |id: &str| {
        let mut tables = document.blocks.iter().filter_map(|block| match block {
            Block::Table(table) if table.id == id => Some(table),
            _ => None,
        });
        tables.next().unwrap()
    };
    let drawn = |id: &str| {
        let mut figures = document.blocks.iter().filter_map(|block| match block {
            Block::Figure(figure) if figure.id == id => Some(figure),
            _ => None,
        });
        figures.next().unwrap()
    };
    let at = |figure: &Figure, column: usize, row: usize| -> Option<String> {
        let place = [column as f64 + 1.0, row as f64 + 1.0];
        let mut named = figure.series.iter().filter(|s| s.points.contains(&place));
        let found = named.next().map(|series| series.name.clone());
        assert!(named.next().is_none(), "two verdicts at {place:?}");
        found
    };
    let (matrix, picture) = (table("matrix"), drawn("matrix-picture"));
    let mut seen = BTreeSet::new();
    for (row, cells) in matrix.rows.iter().enumerate() {
        assert!(matches!(&cells[0], Cell::Page(_, name) if *name == picture.y.names[row]));
        for (column, cell) in cells[1..].iter().enumerate() {
            let Cell::Verdict(_, word) = cell else {
                panic!("{cell:?}");
            };
            let name = at(picture, column, row).unwrap();
            // `indet.` and `cannot` are short
            assert!(
                name.starts_with(word.trim_end_matches('.')),
                "{name}: {word}"
            );
            seen.insert(name);
        }
    }
    assert!(seen.len() > 1, "only {seen:?}");
    // one letter a step in the table, one field in the picture
    let (steps, picture) = (table("steps"), drawn("steps-picture"));
    let mut letters = 0;
    for (row, cells) in steps.rows.iter().enumerate() {
        let Cell::Text(word) = &cells[1] else {
            panic!("{cells:?}");
        };
        assert_eq!(word.chars().count(), picture.x.names.len());
        for (column, letter) in word.chars().enumerate() {
            let first = at(picture, column, row).and_then(|name| name.chars().next());
            let ran = letter.is_ascii_lowercase().then_some(letter);
            assert_eq!(first, ran, "row {row}, step {column}: `{word}`");
            letters += usize::from(ran.is_some());
        }
    }
    assert!(letters > 10, "only {letters} steps ran");
}
