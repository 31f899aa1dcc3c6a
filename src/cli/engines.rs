//! `carom engines`.

use super::{Failure, terminal};
use crate::engine::Roster;
use crate::finding::{Block, Cell, Column, Document, Table};
use crate::page::validation::engine_table;
use crate::report::Format;
use std::process::ExitCode;

/// Prints every engine and the keys of its `--set`.
pub fn engines(format: &Format, roster: &Roster) -> Result<ExitCode, Failure> {
    let mut blocks = vec![Block::Table(engine_table(roster.iter()))];
    for engine in roster {
        let rows: Vec<Vec<Cell>> = engine
            .knobs()
            .into_iter()
            .map(|knob| {
                vec![
                    Cell::Text(knob.key),
                    Cell::Text(knob.default),
                    Cell::Text(knob.what),
                ]
            })
            .collect();
        if rows.is_empty() {
            continue;
        }
        blocks.push(Block::Table(Table {
            id: format!("settings-{}", engine.id()),
            title: format!("Settings of {}", engine.id()),
            columns: vec![
                Column::words("key", "key"),
                Column::words("default", "default"),
                Column::words("what", "meaning"),
            ],
            rows,
            note: String::new(),
        }));
    }
    let document = Document {
        id: "engines".to_owned(),
        stopped_early: None,
        title: "Engines".to_owned(),
        lead: String::new(),
        blocks,
        pages: Vec::new(),
    };
    terminal::show(&document, format)
}
