//! `carom report`, and `carom` alone.

use super::arguments::ReportArguments;
use super::compare::columns;
use super::cost::price_lists;
use super::{Failure, output, scene, terminal};
use crate::finding::{Block, Cell, Document, Table};
use crate::report;
use crate::scene::catalogue;
use crate::study::{Watch, validation};
use std::process::ExitCode;

/// Runs the report's scenes, prints the summary and writes every file.
pub fn report(arguments: &ReportArguments) -> Result<ExitCode, Failure> {
    let scenes = if arguments.scenes.is_empty() {
        catalogue::set("report")?
    } else {
        arguments
            .scenes
            .iter()
            .map(|scene| scene::resolve(scene))
            .collect::<Result<_, _>>()?
    };
    let columns = columns(arguments.engines.as_deref())?;
    let progress = terminal::Progress::new();
    let show = |done: usize, total: usize, what: &str| progress.show(done, total, what);
    let watch = Watch {
        progress: &show,
        cancelled: terminal::cancelled(),
    };
    let prices = price_lists(
        &arguments.out,
        scenes.iter().map(|scene| scene.name.as_str()),
    );
    let document = validation::study(&scenes, &columns, &prices, watch)?;
    drop(progress);
    output::write_files(&arguments.out, report::site(&document))?;
    let printed = terminal::print(
        &report::render(&first_screen(&document), &arguments.format).unwrap_or_default(),
    );
    terminal::say(&format!(
        "Report: {}",
        arguments.out.join("index.html").display()
    ));
    printed
}

/// The first page without its pictures, for a terminal.
fn first_screen(document: &Document) -> Document {
    let readable = |block: &Block| match block {
        Block::Figure(_) | Block::Replay(_) => None,
        Block::Table(table) => Some(Block::Table(without_pictures(table))),
        other => Some(other.clone()),
    };
    Document {
        blocks: document.blocks.iter().filter_map(readable).collect(),
        pages: Vec::new(),
        ..document.clone()
    }
}

fn without_pictures(table: &Table) -> Table {
    let has_picture = |k: usize| {
        table
            .rows
            .iter()
            .any(|row| matches!(row.get(k), Some(Cell::Picture(_))))
    };
    let kept: Vec<usize> = (0..table.columns.len())
        .filter(|&k| !has_picture(k))
        .collect();
    let words = |cell: &Cell| match cell {
        // there is nothing to link to
        Cell::Page(_, words) => Cell::Text(words.clone()),
        other => other.clone(),
    };
    Table {
        columns: kept.iter().map(|&k| table.columns[k].clone()).collect(),
        rows: table
            .rows
            .iter()
            .map(|row| kept.iter().filter_map(|&k| row.get(k).map(words)).collect())
            .collect(),
        ..table.clone()
    }
}
