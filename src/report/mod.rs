//! Writers of documents: one file a format, each writes any [`Document`], and no study knows a format.

mod cell;
pub mod csv;
pub mod html;
pub mod json;
pub mod markdown;
mod names;
pub mod replay;
pub mod svg;
pub mod text;
pub mod words;

use crate::finding::{Block, Document};
use crate::scene::is_hidden;
use names::Pages;

/// One format that fits into one stream, as `--format` names it.
#[derive(Clone, Copy, Debug)]
pub struct Format {
    /// Unique kebab-case name.
    pub id: &'static str,
    /// What it is for, in a few words.
    pub what: &'static str,
    /// Writes any document. The number is the longest line of a format that aligns its columns, in characters; [`text::WIDTH`] where
    /// nobody tells.
    pub write: fn(&Document, usize) -> String,
    /// True where long tables are cut to what a reader of a terminal takes in.
    pub is_cut: bool,
    /// False for tables alone, which have no place for words.
    pub has_words: bool,
}

/// Every format of `--format`; the first is the default.
pub static FORMATS: &[Format] = &[
    Format {
        id: "text",
        what: "aligned tables for a terminal",
        write: text::write,
        is_cut: true,
        has_words: true,
    },
    Format {
        id: "json",
        what: "one JSON document with the same content and every digit",
        write: |document, _| json::write(document),
        is_cut: false,
        has_words: true,
    },
    Format {
        id: "csv",
        what: "the tables with every digit",
        write: |document, _| csv::write(document),
        is_cut: false,
        has_words: false,
    },
    Format {
        id: "markdown",
        what: "tables that are readable as text too",
        write: |document, _| markdown::write(document),
        is_cut: false,
        has_words: true,
    },
];

/// The format called `id`.
pub fn format(id: &str) -> Option<&'static Format> {
    FORMATS.iter().find(|format| format.id == id)
}

/// A document in the format called `id`, in lines of at most [`text::WIDTH`] where it aligns columns; `None` if there is no such format.
pub fn render(document: &Document, id: &str) -> Option<String> {
    format(id).map(|format| (format.write)(document, text::WIDTH))
}

/// Why words are shown otherwise than they are in a table for people, in words that follow the name of the thing; `None` where they
/// are shown as they are. `as_name`: the words are a name, in which signs of markup are rarely meant.
pub fn trouble(name: &str, as_name: bool) -> Option<String> {
    if let Some(c) = name
        .chars()
        .find(|&c| is_hidden(c) && !matches!(c, '\n' | '\r' | '\t'))
    {
        let shown = c.escape_default();
        return Some(format!("has the hidden character {shown}"));
    }
    if words::is_formula(name) {
        return Some("begins as a formula of a spreadsheet does".to_owned());
    }
    (as_name && markdown::has_markup(name)).then(|| "has signs that are markup".to_owned())
}

/// A whole report as files: relative path and content of each.
///
/// `index.html` and `pages/` for a browser, `report.md` and `report.json` with everything, `tables/` and `figures/` with
/// one CSV file a table and figure and one SVG file a figure. `index.html` comes last, so that it never links to a file
/// that is not yet written.
pub fn site(document: &Document) -> Vec<(String, String)> {
    let mut files = Vec::new();
    for page in &Pages::of(document).list {
        for (block, name) in page.document.blocks.iter().zip(&page.blocks) {
            match block {
                Block::Table(table) => {
                    files.push((html::file(page, "tables", name, "csv"), csv::table(table)));
                }
                Block::Figure(figure) => {
                    files.push((
                        html::file(page, "figures", name, "csv"),
                        csv::figure(figure),
                    ));
                    files.push((
                        html::file(page, "figures", name, "svg"),
                        svg::standalone(figure),
                    ));
                }
                Block::Heading(_)
                | Block::Text(_)
                | Block::List(_)
                | Block::Command(_)
                | Block::Replay(_) => {}
            }
        }
    }
    let picture = |page: &names::Page, name: &str| Some(html::file(page, "figures", name, "svg"));
    files.push((
        "report.md".to_owned(),
        markdown::write_with(document, picture),
    ));
    files.push(("report.json".to_owned(), json::write(document)));
    files.extend(html::write(document));
    files
}
