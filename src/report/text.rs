//! Text for a terminal: aligned columns, units in the heading, no line longer than it is told, no colour.

use super::cell::{only_pictures, shown};
use super::words::plain;
use crate::finding::{Align, Block, Cell, Column, Document, Figure, Table};

/// Longest line where nobody tells how wide the terminal is, in characters. Prose is never wider: longer lines are hard to read.
pub const WIDTH: usize = 100;

/// Longest line of a table, in characters, on however wide a terminal: beyond it the eye loses the row.
pub const WIDEST: usize = 160;

/// A narrower terminal breaks lines itself: two columns of the widest words stand side by side in this, in characters.
pub const NARROWEST: usize = 2 * WIDEST_WORD + GAP;

/// A space at which no line is broken; written as an ordinary one.
const NO_BREAK: &str = "\u{a0}";

/// Space between two columns.
const GAP: usize = 2;

/// A column of words is not made narrower than this to fit beside others.
const SYLLABLES: usize = 16;

/// A longer word is broken where its column has to be narrow. Three such columns fit side by side.
const WIDEST_WORD: usize = 30;

/// A document and all pages below it, in lines of at most `width` characters, taken as [`NARROWEST`] where it is less.
pub fn write(document: &Document, width: usize) -> String {
    let width = width.max(NARROWEST);
    let mut text = page(document, width);
    for below in &document.pages {
        text += &format!("\n{}\n\n", "═".repeat(width));
        text += &write(below, width);
    }
    text
}

/// A document without the pages below it, in lines as those of [`write()`].
pub fn page(document: &Document, width: usize) -> String {
    let width = width.max(NARROWEST);
    let mut parts = Vec::new();
    let stopped = document.stopped_early.iter();
    let opening = stopped.chain([&document.title, &document.lead]);
    parts.extend(
        opening
            .filter(|words| !words.is_empty())
            .map(|words| paragraph("", words, width)),
    );
    parts.extend(document.blocks.iter().map(|content| block(content, width)));
    parts.join("\n")
}

fn block(block: &Block, width: usize) -> String {
    match block {
        Block::Heading(words) => {
            let lines = paragraph("", words, width);
            let longest = lines.lines().map(length).max().unwrap_or(0);
            format!("\n{lines}{}\n", "─".repeat(longest))
        }
        Block::Text(words) => paragraph("", words, width),
        Block::List(items) => items
            .iter()
            .map(|item| paragraph("  - ", item, width))
            .collect(),
        Block::Command(command) => shell(command, width),
        Block::Table(content) => table(content, width),
        Block::Figure(content) => figure(content, width),
        Block::Replay(replay) => paragraph("replay  ", &replay.summary(), width),
    }
}

/// One table with its title and note, in lines as those of [`write()`].
pub fn table(table: &Table, width: usize) -> String {
    let width = width.max(NARROWEST);
    let mut text = String::new();
    if !table.title.is_empty() {
        text += &paragraph("", &table.title, width);
    }
    let columns: Vec<Sized> = (0..table.columns.len())
        .filter(|&i| !only_pictures(table, i))
        .map(|i| Sized::of(table, i))
        .collect();
    for (number, group) in groups(&columns, width).into_iter().enumerate() {
        if number > 0 {
            text.push('\n');
        }
        text += &grid(&columns, &group);
    }
    if table.rows.is_empty() {
        text += "  (no rows)\n";
    }
    if !table.note.is_empty() {
        text += &format!("\n{}", paragraph("", &table.note, width));
    }
    text
}

/// What a picture shows, for those who cannot see it here.
fn figure(figure: &Figure, width: usize) -> String {
    let points: usize = figure.series.iter().map(|series| series.points.len()).sum();
    let words = format!(
        "{}. {} ({points} points; the report and json have them)",
        figure.title.trim_end_matches('.'),
        figure.caption
    );
    paragraph("figure  ", &words, width)
}

/// One column with the text of its cells and the widths that it can live with.
struct Sized<'a> {
    column: &'a Column,
    cells: Vec<String>,
    narrowest: usize,
    natural: usize,
}

impl<'a> Sized<'a> {
    fn of(table: &'a Table, index: usize) -> Self {
        let column = &table.columns[index];
        let owners = table.rows.iter().map(|row| match row.get(index) {
            Some(Cell::Owned(_, owner)) => length(&plain(owner)),
            _ => 0,
        });
        let owners = owners.max().unwrap_or(0);
        let cell = |row: &Vec<Cell>| match row.get(index) {
            // numbers stand below each other, whoever owns them
            Some(cell @ Cell::Owned(_, owner)) => {
                let space = if owner.is_empty() {
                    3 + owners
                } else {
                    owners - length(&plain(owner))
                };
                shown(cell) + &NO_BREAK.repeat(if owners == 0 { 0 } else { space })
            }
            Some(cell) => shown(cell),
            None => String::new(),
        };
        let cells: Vec<String> = table.rows.iter().map(cell).collect();
        let longest = cells.iter().map(|cell| length(cell)).max().unwrap_or(0);
        let words = |text: &str| text.split(' ').map(length).max().unwrap_or(0);
        let heading = words(&plain(&column.title)).max(length(&unit(column)));
        let content = match column.align {
            Align::Left => cells.iter().map(|cell| words(cell)).max().unwrap_or(0),
            Align::Right => longest,
        };
        // words may be wrapped, but not into a column of syllables
        let readable = match column.align {
            Align::Left => longest.min(SYLLABLES),
            Align::Right => 1,
        };
        let narrowest = content.max(heading).max(readable).clamp(1, WIDEST_WORD);
        Sized {
            column,
            narrowest,
            natural: longest.max(narrowest),
            cells,
        }
    }
}

/// Columns that fit side by side into `room`, each with its width. Every group begins with the first column, which names the rows.
fn groups(columns: &[Sized], room: usize) -> Vec<Vec<(usize, usize)>> {
    let mut groups: Vec<Vec<(usize, usize)>> = Vec::new();
    let mut group: Vec<(usize, usize)> = Vec::new();
    let width = |group: &[(usize, usize)]| group.iter().map(|(_, w)| w + GAP).sum::<usize>();
    for (index, column) in columns.iter().enumerate() {
        if !group.is_empty() && width(&group) + column.narrowest > room {
            let first = group[0];
            groups.push(std::mem::replace(&mut group, vec![first]));
        }
        group.push((index, column.narrowest));
    }
    if !group.is_empty() {
        groups.push(group);
    }
    for group in &mut groups {
        let mut spare = (room + GAP).saturating_sub(width(group));
        // narrow wishes first: a word too many beside a paragraph costs nothing
        let mut wishes: Vec<usize> = (0..group.len()).collect();
        wishes.sort_by_key(|&i| columns[group[i].0].natural.saturating_sub(group[i].1));
        for i in wishes {
            let (index, width) = &mut group[i];
            let more = columns[*index].natural.saturating_sub(*width).min(spare);
            *width += more;
            spare -= more;
        }
    }
    groups
}

/// Heading, rule and rows of the columns of one group.
fn grid(columns: &[Sized], group: &[(usize, usize)]) -> String {
    let heading =
        |&(index, width): &(usize, usize)| wrap(&plain(&columns[index].column.title), width);
    let headings: Vec<Vec<String>> = group.iter().map(heading).collect();
    let height = headings.iter().map(Vec::len).max().unwrap_or(0);
    let bottom_aligned = headings.into_iter().map(|mut lines| {
        let missing = height - lines.len();
        lines.splice(0..0, vec![String::new(); missing]);
        lines
    });
    let mut text = row(columns, group, &bottom_aligned.collect::<Vec<_>>());
    let units: Vec<Vec<String>> = group
        .iter()
        .map(|&(index, width)| wrap(&unit(columns[index].column), width))
        .collect();
    if group
        .iter()
        .any(|&(index, _)| !columns[index].column.unit.is_empty())
    {
        text += &row(columns, group, &units);
    }
    let rules: Vec<Vec<String>> = group.iter().map(|&(_, w)| vec!["─".repeat(w)]).collect();
    text += &row(columns, group, &rules);
    for number in 0..columns.first().map_or(0, |column| column.cells.len()) {
        let cells = group
            .iter()
            .map(|&(index, width)| wrap(&columns[index].cells[number], width));
        text += &row(columns, group, &cells.collect::<Vec<_>>());
    }
    text
}

/// One row of cells, each of one or more lines.
fn row(columns: &[Sized], group: &[(usize, usize)], cells: &[Vec<String>]) -> String {
    let height = cells.iter().map(Vec::len).max().unwrap_or(0);
    let mut text = String::new();
    for number in 0..height {
        let mut line = String::new();
        for (i, (&(index, width), lines)) in group.iter().zip(cells).enumerate() {
            if i > 0 {
                line += &" ".repeat(GAP);
            }
            let words = lines.get(number).map_or("", String::as_str);
            let space = " ".repeat(width.saturating_sub(length(words)));
            line += &match columns[index].column.align {
                Align::Left => format!("{words}{space}"),
                Align::Right => format!("{space}{words}"),
            };
        }
        text += line.replace(NO_BREAK, " ").trim_end();
        text.push('\n');
    }
    text
}

fn unit(column: &Column) -> String {
    if column.unit.is_empty() {
        String::new()
    } else {
        format!("({})", plain(&column.unit))
    }
}

/// Prose in lines no longer than `width` and [`WIDTH`]; the first begins with `bullet`, the others below its text.
fn paragraph(bullet: &str, words: &str, width: usize) -> String {
    let indent = length(bullet);
    let room = width.min(WIDTH) - indent;
    let mut text = String::new();
    for (i, line) in wrap(&plain(words), room).into_iter().enumerate() {
        let margin = if i == 0 {
            bullet.to_owned()
        } else {
            " ".repeat(indent)
        };
        text += format!("{margin}{line}").trim_end();
        text.push('\n');
    }
    text
}

/// A command, which stays one command when it is copied: long ones continue after a backslash, at the margin within a word.
fn shell(command: &str, width: usize) -> String {
    let room = width - 8;
    let mut text = "   ".to_owned();
    let mut used = 0;
    for word in plain(command).split(' ') {
        if used > 0 && used + 1 + length(word) > room {
            text += " \\\n     ";
            used = 0;
        }
        text.push(' ');
        used += 1;
        for c in word.chars() {
            if used >= room {
                text += "\\\n";
                used = 0;
            }
            text.push(c);
            used += 1;
        }
    }
    text + "\n"
}

/// Breaks at spaces into lines of at most `width` characters, and within words that are longer. One line at least.
fn wrap(words: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    for word in words.split(' ') {
        let mut word = word;
        if !line.is_empty() && length(&line) + 1 + length(word) <= width {
            line.push(' ');
            line += word;
            continue;
        }
        if !line.is_empty() {
            lines.push(std::mem::take(&mut line));
        }
        while let Some((at, _)) = word.char_indices().nth(width) {
            let (head, tail) = word.split_at(at);
            lines.push(head.to_owned());
            word = tail;
        }
        line = word.to_owned();
    }
    lines.push(line);
    lines
}

fn length(words: &str) -> usize {
    words.chars().count()
}
