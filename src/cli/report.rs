//! `carom report`, and `carom` alone.

use super::arguments::ReportArguments;
use super::compare::columns;
use super::cost::price_lists;
use super::{Failure, scene, terminal, write_site};
use crate::engine::Roster;
use crate::finding::{Block, Cell, Document, Table};
use crate::page;
use crate::scene::{SetName, catalogue};
use crate::study::{Watch, validation};
use std::process::ExitCode;

/// Runs the report's scenes, prints the summary and writes every file.
pub fn report(arguments: &ReportArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    let scenes = if arguments.scenes.is_empty() {
        catalogue::set(SetName::Report)?
    } else {
        arguments
            .scenes
            .iter()
            .map(|scene| scene::resolve(scene))
            .collect::<Result<_, _>>()?
    };
    let columns = columns(roster, arguments.engines.as_deref())?;
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
    let outcome = validation::study(roster, &scenes, &columns, watch)?;
    let document = page::validation::page(roster, &outcome, &prices);
    drop(progress);
    let shown = first_screen(&document);
    let site = write_site(&shown, || document, &arguments.out, Vec::new())?;
    let shown = Document {
        stopped_early: site.stopped_early.clone(),
        ..shown
    };
    let printed = terminal::show(&shown, &arguments.format);
    if !site.files.is_empty() {
        terminal::say(&format!(
            "Report: {}",
            arguments.out.join("index.html").display()
        ));
        terminal::say(&weights(&site.files));
    }
    printed
}

/// What the pages of a site weigh, in one line.
fn weights(files: &[(String, String)]) -> String {
    let pages = files.iter().filter(|(path, _)| path.ends_with(".html"));
    let kilobytes = |bytes: usize| (bytes as f64 / 1000.0).round();
    let all: usize = pages.clone().map(|(_, page)| page.len()).sum();
    let largest = pages.clone().max_by_key(|(_, page)| page.len());
    let largest = largest.map_or(String::new(), |(path, page)| {
        format!("; the largest {} kB, {path}", kilobytes(page.len()))
    });
    format!(
        "Pages: {} with {} kB in all{largest}",
        pages.count(),
        kilobytes(all)
    )
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
