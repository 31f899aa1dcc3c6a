//! CSV: one table a file, every digit, keys in the first line.

use super::cell::exact_columns;
use super::names::Pages;
use crate::finding::{Axis, Block, Document, Figure, Table};
use crate::trace::files::shortest;

/// Every table of a document with its file name: `ID.csv` on the first page, `PAGE/ID.csv` on the others.
pub fn files(document: &Document) -> Vec<(String, String)> {
    let pages = Pages::of(document);
    let mut files = Vec::new();
    for page in &pages.list {
        for (block, name) in page.document.blocks.iter().zip(&page.blocks) {
            if let Block::Table(content) = block {
                let folder = if page.depth == 0 {
                    String::new()
                } else {
                    format!("{}/", page.name)
                };
                files.push((format!("{folder}{name}.csv"), table(content)));
            }
        }
    }
    files
}

/// All tables of a document in one stream. A single table stands alone; several are each preceded by a line with `#`, the
/// file name that it would have and its title, and parted by an empty line.
pub fn write(document: &Document) -> String {
    let files = files(document);
    if let [(_, only)] = files.as_slice() {
        return only.clone();
    }
    let part = |(name, content): &(String, String)| format!("# {name}\n{content}");
    files.iter().map(part).collect::<Vec<_>>().join("\n")
}

/// One table.
pub fn table(table: &Table) -> String {
    let columns = exact_columns(table);
    let mut text = line(columns.iter().map(|column| column.key()));
    for row in &table.rows {
        text += &line(columns.iter().map(|column| column.value(row).field()));
    }
    text
}

/// The points of a figure, every one: `series,x,y`. On an axis of words a place is its words.
pub fn figure(figure: &Figure) -> String {
    let mut text = line(["series", "x", "y"].map(str::to_owned));
    for series in &figure.series {
        for [x, y] in &series.points {
            let (x, y) = (place(&figure.x, *x), place(&figure.y, *y));
            text += &line([series.name.clone(), x, y]);
        }
    }
    text
}

/// A number of an axis with every digit, or the words that stand there.
pub fn place(axis: &Axis, x: f64) -> String {
    axis.name_at(x).map_or_else(|| shortest(x), str::to_owned)
}

/// One row. A field is quoted where it must be, and where a reader might take it for a title between two tables.
fn line(fields: impl IntoIterator<Item = String>) -> String {
    let quoted = |field: String| {
        if field.contains([',', '"', '\n', '\r']) || field.starts_with('#') {
            format!("\"{}\"", field.replace('"', "\"\""))
        } else {
            field
        }
    };
    let fields: Vec<String> = fields.into_iter().map(quoted).collect();
    // a row of one empty field would be an empty line, which readers skip
    if fields == [""] {
        return "\"\"\n".to_owned();
    }
    fields.join(",") + "\n"
}
