//! Markdown that is readable as text too: pipes aligned, units in the heading.

use super::cell::{only_pictures, shown};
use super::names::{Page, Pages};
use super::words::{pieces, plain};
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
        parts.push(strong(stopped));
    }
    for page in &pages.list {
        let hashes = |level: usize| "#".repeat((page.depth + level).min(6));
        parts.push(format!("{} {}\n", hashes(1), heading(&page.document.title)));
        parts.push(strong(&page.document.lead));
        for (block, name) in page.document.blocks.iter().zip(&page.blocks) {
            parts.push(match block {
                Block::Heading(words) => format!("{} {}\n", hashes(2), heading(words)),
                Block::Text(words) => format!("{}\n", paragraph(words)),
                Block::List(items) => items
                    .iter()
                    .map(|item| format!("- {}\n", paragraph(item)))
                    .collect(),
                Block::Command(command) => format!("{}\n", fence(command)),
                Block::Table(content) => table_in(content, &pages),
                Block::Figure(figure) => {
                    let words = format!(
                        "*{}.* {}",
                        escape(figure.title.trim_end_matches('.'), TextPlace::Line),
                        escape(&figure.caption, TextPlace::Line)
                    );
                    match picture(page, name) {
                        Some(file) => {
                            let title = escape(&figure.title, TextPlace::Link);
                            format!("![{title}]({file})\n\n{words}\n")
                        }
                        None => format!("{words}\n"),
                    }
                }
                Block::Replay(replay) => format!("{}\n", paragraph(&replay.summary())),
            });
        }
    }
    parts.retain(|part| !part.is_empty());
    parts.join("\n")
}

/// One table with its title and note.
fn table_in(table: &Table, pages: &Pages) -> String {
    let mut text = String::new();
    let title = strong(&table.title);
    if !title.is_empty() {
        text += &format!("{title}\n");
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
    let title = escape(&column.title, TextPlace::Cell);
    let heading = match column.unit.as_str() {
        "" => title,
        unit => format!("{title} ({})", escape(unit, TextPlace::Cell)),
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
    let page = match cell {
        Cell::Page(id, _) => pages.find(id),
        _ => None,
    };
    match page {
        Some(page) => format!(
            "[{}](#{})",
            escape(&shown(cell), TextPlace::Link),
            anchor(&page.document.title)
        ),
        None => escape(&shown(cell), TextPlace::Cell),
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

/// Where words stand, which decides what is markup among them.
#[derive(Clone, Copy, PartialEq, Eq)]
enum TextPlace {
    /// In a line of their own, or after the sign of a heading.
    Line,
    /// In a cell of a table: it ends at a bar.
    Cell,
    /// In the words of a link or picture, maybe in a cell: they end at a bracket too.
    Link,
}

/// A block whose first characters do not make it a heading, list, quotation, code or rule.
fn paragraph(words: &str) -> String {
    let words = escape(words, TextPlace::Line);
    let digits = words.bytes().take_while(u8::is_ascii_digit).count();
    let (number, rest) = words.split_at(digits);
    if words.starts_with(['#', '-', '+', '>', '=', '~']) {
        format!("\\{words}")
    } else if digits > 0 && is_mark(rest) {
        format!("{number}\\{rest}")
    } else {
        words
    }
}

/// True for what makes the number before it that of a list.
fn is_mark(rest: &str) -> bool {
    let after = rest.strip_prefix(['.', ')']);
    after.is_some_and(|after| after.is_empty() || after.starts_with(' '))
}

/// A heading: one that ends in `#` would lose it.
fn heading(words: &str) -> String {
    let words = escape(words, TextPlace::Line);
    match words.strip_suffix('#') {
        Some(words) => format!("{words}\\#"),
        None => words,
    }
}

/// Words in bold print; nothing if there are none.
fn strong(words: &str) -> String {
    match escape(words, TextPlace::Line).as_str() {
        "" => String::new(),
        words => format!("**{words}**\n"),
    }
}

/// One line whose characters mean themselves, except that text between two backticks is code.
fn escape(words: &str, place: TextPlace) -> String {
    let words = plain(words);
    // spaces at the ends have no meaning, and would keep signs around them from having theirs
    let words = words.trim();
    let mut escaped = String::with_capacity(words.len());
    for (is_code, piece) in pieces(words) {
        let bar = piece.contains('|') && place != TextPlace::Line;
        if is_code && !bar {
            escaped += &format!("`{piece}`");
        } else if is_code {
            // a bar ends a cell within code too
            escaped += &literal(&format!("`{piece}`"), place);
        } else {
            escaped += &literal(piece, place);
        }
    }
    escaped
}

/// Words without code.
fn literal(words: &str, place: TextPlace) -> String {
    let mut escaped = String::with_capacity(words.len());
    let mut previous = ' ';
    for (at, c) in words.char_indices() {
        let after = &words[at + c.len_utf8()..];
        let is_markup = match c {
            // those of GitHub too: struck out words, sums
            '\\' | '*' | '<' | '[' | '`' | '&' | '~' | '$' => true,
            '|' => place != TextPlace::Line,
            ']' => place == TextPlace::Link,
            // within a word an underscore means itself
            '_' => {
                let next = after.chars().next().unwrap_or(' ');
                !previous.is_alphanumeric() || !next.is_alphanumeric()
            }
            // viewers make links of addresses
            ':' => after.starts_with("//"),
            '.' => words[..at].to_ascii_lowercase().ends_with("www"),
            _ => false,
        };
        if is_markup {
            escaped.push('\\');
        }
        escaped.push(c);
        previous = c;
    }
    escaped
}

/// True for words with signs that have to be escaped in a cell of a table.
pub fn has_markup(words: &str) -> bool {
    literal(words, TextPlace::Cell) != words
}

/// A command as a block of code, whatever backticks it has.
fn fence(command: &str) -> String {
    let mut fence = "```".to_owned();
    let command = plain(command);
    while command.contains(&fence) {
        fence.push('`');
    }
    format!("{fence}sh\n{}\n{fence}", command.trim())
}

fn length(words: &str) -> usize {
    words.chars().count()
}
