//! JSON: one document with the same content, every digit, one table row and one curve a line.
//!
//! `stopped_early` is there, before everything else, only where the user asked to stop before it had finished. `blocks` gives the
//! order of a page and refers to its `tables` and `figures` by id; a table's rows are objects keyed by column, with its units beside
//! them. There is no NaN in JSON: a number that is none is the text `"NaN"`, `"inf"` or `"-inf"`, and a missing one is `null`.

use super::cell::{Exact, exact_columns};
use crate::finding::{Axis, Block, Document, Figure, Replay, Table};
use crate::trace::files::shortest;
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;

/// The whole document.
pub fn write(document: &Document) -> String {
    page(document, 0) + "\n"
}

fn page(document: &Document, depth: usize) -> String {
    let (mut tables, mut figures, mut blocks) = (Vec::new(), Vec::new(), Vec::new());
    let mut taken = BTreeSet::new();
    for block in &document.blocks {
        blocks.push(match block {
            Block::Heading(words) => json!({ "heading": words }).to_string(),
            Block::Text(words) => json!({ "text": words }).to_string(),
            Block::List(items) => json!({ "list": items }).to_string(),
            Block::Command(command) => json!({ "command": command }).to_string(),
            Block::Table(content) => {
                let id = unused(&content.id, &mut taken);
                let reference = json!({ "table": id }).to_string();
                tables.push((id, table(content, depth + 2)));
                reference
            }
            Block::Figure(content) => {
                let id = unused(&content.id, &mut taken);
                let reference = json!({ "figure": id }).to_string();
                figures.push((id, figure(content, depth + 2)));
                reference
            }
            Block::Replay(content) => json!({ "replay": replay(content) }).to_string(),
        });
    }
    let pages = document.pages.iter().map(|p| page(p, depth + 2)).collect();
    let stopped = document.stopped_early.iter();
    let stopped = stopped.map(|words| ("stopped_early", text(words)));
    let fields = [
        ("id", text(&document.id)),
        ("title", text(&document.title)),
        ("lead", text(&document.lead)),
        ("blocks", array(blocks, depth + 1)),
        ("tables", object(tables, depth + 1)),
        ("figures", object(figures, depth + 1)),
        ("pages", array(pages, depth + 1)),
    ];
    let fields = stopped.chain(fields);
    object(fields.map(|(k, v)| (k.to_owned(), v)).collect(), depth)
}

fn table(table: &Table, depth: usize) -> String {
    let columns = exact_columns(table);
    let mut units = Map::new();
    let mut titles = Map::new();
    for column in &columns {
        units.insert(column.key(), json!(column.unit()));
        titles.insert(column.key(), json!(column.column.title));
    }
    let row = |row: &Vec<crate::finding::Cell>| {
        let mut object = Map::new();
        for column in &columns {
            object.insert(column.key(), value(column.value(row)));
        }
        Value::Object(object).to_string()
    };
    let rows = table.rows.iter().map(row).collect();
    let fields = [
        ("title", text(&table.title)),
        ("note", text(&table.note)),
        ("columns", Value::Object(titles).to_string()),
        ("units", Value::Object(units).to_string()),
        ("rows", array(rows, depth + 1)),
    ];
    object(fields.map(|(k, v)| (k.to_owned(), v)).into(), depth)
}

fn figure(figure: &Figure, depth: usize) -> String {
    let axis = |axis: &Axis| {
        let mut fields = json!({ "label": axis.label, "unit": axis.unit, "log": axis.log });
        if !axis.names.is_empty() {
            fields["names"] = json!(axis.names);
        }
        fields.to_string()
    };
    let corner = |corner: [f64; 2]| corner.map(number);
    let outline = figure
        .outline
        .map(|[low, high]| json!([corner(low), corner(high)]));
    let series = figure.series.iter().map(|series| {
        let points: Vec<_> = series.points.iter().map(|&point| corner(point)).collect();
        json!({ "name": series.name, "style": series.style, "points": points }).to_string()
    });
    let marks = figure
        .marks
        .iter()
        .map(|mark| json!({ "at": number(mark.at), "label": mark.label }).to_string());
    let fields = [
        ("title", text(&figure.title)),
        ("caption", text(&figure.caption)),
        ("x", axis(&figure.x)),
        ("y", axis(&figure.y)),
        ("equal-scale", json!(figure.equal_scale).to_string()),
        ("outline", json!(outline).to_string()),
        ("series", array(series.collect(), depth + 1)),
        ("marks", array(marks.collect(), depth + 1)),
    ];
    object(fields.map(|(k, v)| (k.to_owned(), v)).into(), depth)
}

/// What a replay shows, without its knots: those are what `carom run` writes.
fn replay(replay: &Replay) -> Value {
    let runs = replay.runs.iter().map(|run| {
        json!({
            "label": run.label, "reference": run.reference, "end": number(run.end),
            "events": run.events.len(), "knots": run.paths.iter().map(|path| path.knots.len()).sum::<usize>(),
            "left-out": run.left_out, "tolerance": number(run.tolerance)
        })
    });
    let partings = replay.partings.iter().map(|parting| {
        let label = |i: usize| replay.runs.get(i).map(|run| run.label.as_str());
        json!({
            "time": number(parting.time), "runs": parting.runs.map(label),
            "balls": parting.balls, "words": parting.words
        })
    });
    json!({
        "runs": runs.collect::<Vec<_>>(), "partings": partings.collect::<Vec<_>>(),
        "horizon": replay.horizon.map(number), "remark": replay.remark
    })
}

fn value(exact: Exact) -> Value {
    match exact {
        Exact::Nothing => Value::Null,
        Exact::Words(words) => json!(words),
        Exact::Number(x) => number(x),
        Exact::Whole(n) => json!(n),
    }
}

fn number(x: f64) -> Value {
    if x.is_finite() {
        json!(x)
    } else {
        json!(shortest(x))
    }
}

fn text(words: &str) -> String {
    json!(words).to_string()
}

/// An id that the page does not use yet: ids are unique, and if they are not, nothing is lost.
fn unused(id: &str, taken: &mut BTreeSet<String>) -> String {
    let mut candidate = id.to_owned();
    let mut number = 2;
    while !taken.insert(candidate.clone()) {
        candidate = format!("{id}-{number}");
        number += 1;
    }
    candidate
}

/// Entries that are JSON already, one a line.
fn array(entries: Vec<String>, depth: usize) -> String {
    lines('[', entries, ']', depth)
}

fn object(entries: Vec<(String, String)>, depth: usize) -> String {
    let entry = |(key, value): (String, String)| format!("{}: {value}", text(&key));
    lines('{', entries.into_iter().map(entry).collect(), '}', depth)
}

fn lines(open: char, entries: Vec<String>, close: char, depth: usize) -> String {
    if entries.is_empty() {
        return format!("{open}{close}");
    }
    let (outer, inner) = ("  ".repeat(depth), "  ".repeat(depth + 1));
    let body = entries.join(&format!(",\n{inner}"));
    format!("{open}\n{inner}{body}\n{outer}{close}")
}
