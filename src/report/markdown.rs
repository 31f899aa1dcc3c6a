//! Markdown that is readable as text too: pipes aligned, units in the heading.

use super::cell::{only_pictures, shown};
use super::names::{Page, Pages};
use crate::finding::{Align, Block, Cell, Document, Table};

/// A document and all pages below it, without pictures.
pub fn write(document: &Document) -> String {
    write_with(document, |_, _| None)
}

/// The same, with pictures: `picture` answers where the picture of a figure is, given its page and its name.
pub fn write_with(document: &Document, picture: impl Fn(&Page, &str) -> Option<String>) -> String {
    let pages = Pages::of(document);
    let mut parts = Vec::new();
    if let Some(stopped) = &document.stopped_early {
        parts.push(format!("**{}**\n", escape(stopped)));
    }
    for page in &pages.list {
        let hashes = |level: usize| "#".repeat((page.depth + level).min(6));
        parts.push(format!("{} {}\n", hashes(1), escape(&page.document.title)));
        if !page.document.lead.is_empty() {
            parts.push(format!("**{}**\n", escape(&page.document.lead)));
        }
        for (block, name) in page.document.blocks.iter().zip(&page.blocks) {
            parts.push(match block {
                Block::Heading(words) => format!("{} {}\n", hashes(2), escape(words)),
                Block::Text(words) => format!("{}\n", paragraph(words)),
                Block::List(items) => items
                    .iter()
                    .map(|item| format!("- {}\n", escape(item)))
                    .collect(),
                Block::Command(command) => format!("{}\n", fence(command)),
                Block::Table(content) => table_in(content, &pages),
                Block::Figure(figure) => {
                    let words = format!(
                        "*{}.* {}",
                        escape(figure.title.trim_end_matches('.')),
                        escape(&figure.caption)
                    );
                    match picture(page, name) {
                        Some(file) => format!("![{}]({file})\n\n{words}\n", escape(&figure.title)),
                        None => format!("{words}\n"),
                    }
                }
                Block::Replay(replay) => format!("{}\n", escape(&replay.summary())),
            });
        }
    }
    parts.join("\n")
}

/// One table with its title and note.
fn table_in(table: &Table, pages: &Pages) -> String {
    let mut text = String::new();
    if !table.title.is_empty() {
        text += &format!("**{}**\n\n", escape(&table.title));
    }
    let columns: Vec<Vec<String>> = (0..table.columns.len())
        .filter(|&i| !only_pictures(table, i))
        .map(|i| column(table, i, pages))
        .collect();
    for line in 0..table.rows.len() + 2 {
        let cells: String = columns
            .iter()
            .map(|cells| format!(" {} |", cells[line]))
            .collect();
        text += &format!("|{cells}\n");
    }
    if !table.note.is_empty() {
        text += &format!("\n{}\n", paragraph(&table.note));
    }
    text
}

/// Heading, rule and cells of one column, all equally long.
fn column(table: &Table, index: usize, pages: &Pages) -> Vec<String> {
    let column = &table.columns[index];
    let title = cell_text(&column.title);
    let heading = match column.unit.as_str() {
        "" => title,
        unit => format!("{title} ({})", cell_text(unit)),
    };
    let mut cells = vec![heading];
    for row in &table.rows {
        cells.push(
            row.get(index)
                .map(|cell| linked(cell, pages))
                .unwrap_or_default(),
        );
    }
    let width = cells
        .iter()
        .map(|cell| length(cell))
        .max()
        .unwrap_or(0)
        .max(3);
    for cell in &mut cells {
        let space = " ".repeat(width - length(cell));
        *cell = match column.align {
            Align::Left => format!("{cell}{space}"),
            Align::Right => format!("{space}{cell}"),
        };
    }
    let rule = match column.align {
        Align::Left => "-".repeat(width),
        Align::Right => format!("{}:", "-".repeat(width - 1)),
    };
    cells.insert(1, rule);
    cells
}

/// A cell; a page as a link to its heading.
fn linked(cell: &Cell, pages: &Pages) -> String {
    let words = cell_text(&shown(cell));
    match cell {
        Cell::Page(id, _) => match pages.find(id) {
            Some(page) => format!("[{words}](#{})", anchor(&page.document.title)),
            None => words,
        },
        _ => words,
    }
}

/// The anchor that Markdown viewers give a heading.
fn anchor(title: &str) -> String {
    let kept = title
        .chars()
        .filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c })
        .flat_map(char::to_lowercase)
        .collect()
}

fn cell_text(words: &str) -> String {
    escape(words).replace('|', "\\|")
}

/// A paragraph whose first character does not make it a heading, list or quotation.
fn paragraph(words: &str) -> String {
    let words = escape(words);
    if words.starts_with(['#', '-', '+', '>', '=', '~']) {
        format!("\\{words}")
    } else {
        words
    }
}

/// One line whose characters mean themselves, except that text between two backticks stays code.
fn escape(words: &str) -> String {
    let words = words.replace(['\n', '\r', '\t'], " ");
    let code_allowed = words.matches('`').count().is_multiple_of(2);
    let mut escaped = String::with_capacity(words.len());
    let (mut in_code, mut previous) = (false, ' ');
    for (at, c) in words.char_indices() {
        match c {
            '`' if code_allowed => in_code = !in_code,
            _ if in_code => {}
            '\\' | '*' | '<' | '[' | '`' | '&' => escaped.push('\\'),
            // within a word an underscore means itself
            '_' => {
                let next = words[at + 1..].chars().next().unwrap_or(' ');
                if !previous.is_alphanumeric() || !next.is_alphanumeric() {
                    escaped.push('\\');
                }
            }
            _ => {}
        }
        escaped.push(c);
        previous = c;
    }
    escaped
}

/// A command as a block of code, whatever backticks it has.
fn fence(command: &str) -> String {
    let mut fence = "```".to_owned();
    while command.contains(&fence) {
        fence.push('`');
    }
    format!("{fence}sh\n{}\n{fence}", command.trim_end())
}

fn length(words: &str) -> usize {
    words.chars().count()
}
