//! Blocks of a page as HTML.

use super::super::cell::{shown, significant};
use super::super::csv;
use super::super::names::{Page, Pages};
use super::super::replay::data as replay_data;
use super::super::svg;
use super::super::words::{in_cell, pieces};
use super::{escape, file, link, root};
use crate::finding::{Align, Block, Cell, Column, Figure, Replay, Table, Tone};
use crate::trace::files::shortest;

/// A longer table scrolls within the page, its heading in sight.
const LONG: usize = 24;

/// A figure with more points shows a summary of them here, and all in its CSV file.
const MOST_POINTS: usize = 300;

/// Largest data of a replay, bytes: with the script and all else a page stays below 1.5 MB.
const MOST_DATA: usize = 620_000;

/// How the element of a replay begins; no words can, since they are escaped.
pub const REPLAY: &str = "<div class=\"replay\"";

/// Where a block stands.
pub struct BlockPlace<'a> {
    /// The page.
    pub page: &'a Page<'a>,
    /// All pages.
    pub pages: &'a Pages<'a>,
    /// Whether the files of the site are beside it, to be linked to.
    pub in_site: bool,
}

/// All blocks of a page. A table and a bare picture that follows it stand beside each other where there is room.
pub fn all(place: &BlockPlace) -> String {
    let blocks = &place.page.document.blocks;
    let bare =
        |k: usize| matches!(blocks.get(k), Some(Block::Figure(figure)) if svg::is_bare(figure));
    let mut html = String::new();
    for (k, name) in place.page.blocks.iter().enumerate() {
        let pair = matches!(blocks[k], Block::Table(_)) && bare(k + 1);
        if pair {
            html += "<div class=\"beside\">\n";
        }
        html += &block(&blocks[k], name, place);
        if k > 0 && matches!(blocks[k - 1], Block::Table(_)) && bare(k) {
            html += "</div>\n";
        }
    }
    html
}

/// One block; `name`: its anchor.
fn block(block: &Block, name: &str, place: &BlockPlace) -> String {
    match block {
        Block::Heading(words) => format!("<h2 id=\"{name}\">{}</h2>\n", inline(words)),
        Block::Text(words) => format!("<p>{}</p>\n", inline(words)),
        Block::List(items) => {
            let items = items
                .iter()
                .map(|item| format!("<li>{}</li>\n", inline(item)));
            format!("<ul>\n{}</ul>\n", items.collect::<String>())
        }
        Block::Command(command) => format!("<pre><code>{}</code></pre>\n", escape(command)),
        Block::Table(content) => table(content, name, place),
        Block::Figure(content) => figure(content, name, place),
        Block::Replay(content) => replay(content, name),
    }
}

impl BlockPlace<'_> {
    /// The way to a file of the site.
    fn file(&self, kind: &str, name: &str, extension: &str) -> String {
        root(self.page).to_owned() + &file(self.page, kind, name, extension)
    }
}

/// Words; what stands between two backticks is code.
pub fn inline(words: &str) -> String {
    let piece = |(is_code, words): (bool, &str)| match is_code {
        false => escape(words),
        true => format!("<code>{}</code>", escape(words)),
    };
    pieces(words).into_iter().map(piece).collect()
}

/// The same words with numbers and their short units on one line: large type breaks early.
pub fn together(words: &str) -> String {
    let parts: Vec<&str> = words.split(' ').collect();
    let mut text = String::new();
    for (i, part) in parts.iter().enumerate() {
        let before = i.checked_sub(1).and_then(|i| parts[i].chars().last());
        let short = part.trim_end_matches(|c: char| c.is_ascii_punctuation());
        let unit = short.chars().count() <= 2 && short.chars().all(char::is_alphabetic);
        if before.is_some_and(|c| c.is_ascii_digit()) && unit && !short.is_empty() {
            text.push('\u{a0}');
        } else if i > 0 {
            text.push(' ');
        }
        text += part;
    }
    text
}

fn table(table: &Table, name: &str, place: &BlockPlace) -> String {
    let title = if table.title.is_empty() {
        String::new()
    } else {
        format!("<h3>{}</h3>", inline(&table.title))
    };
    let label = if table.title.is_empty() {
        &table.id
    } else {
        &table.title
    };
    let get = match place.in_site {
        true => format!(
            "<span class=\"get\"><a href=\"{}\">CSV</a></span>",
            place.file("tables", name, "csv")
        ),
        false => String::new(),
    };
    let mut html = format!(
        "<section class=\"block\" id=\"{name}\">\n<div class=\"head\">{title}{get}</div>\n\
         <div class=\"table{}\" role=\"region\" aria-label=\"{}\" tabindex=\"0\">\n<table>\n<thead><tr>",
        if table.rows.len() > LONG { " long" } else { "" },
        escape(label)
    );
    html += &table.columns.iter().map(heading).collect::<String>();
    html += "</tr></thead>\n<tbody>\n";
    for row in &table.rows {
        let pictures = row.iter().any(|cell| matches!(cell, Cell::Picture(_)));
        html += if pictures {
            "<tr class=\"pics\">"
        } else {
            "<tr>"
        };
        for (i, column) in table.columns.iter().enumerate() {
            let content = row.get(i).unwrap_or(&Cell::Empty);
            let class = match (column.align, content) {
                (Align::Right, _) => " class=\"r\"",
                (_, Cell::Text(words) | Cell::Verdict(_, words) | Cell::Page(_, words))
                    if words.chars().count() > 24 =>
                {
                    " class=\"w\""
                }
                (Align::Left, _) => " class=\"k\"",
            };
            let names_row = i == 0 && matches!(content, Cell::Text(_) | Cell::Page(..));
            html += &match names_row {
                true => format!("<th scope=\"row\"{class}>{}</th>", cell(content, place)),
                false => format!("<td{class}>{}</td>", cell(content, place)),
            };
        }
        html += "</tr>\n";
    }
    html += "</tbody>\n</table>\n</div>\n";
    if !table.note.is_empty() {
        html += &format!("<p class=\"note\">{}</p>\n", inline(&table.note));
    }
    html + "</section>\n"
}

fn heading(column: &Column) -> String {
    let class = match column.align {
        Align::Left => "",
        Align::Right => " class=\"r\"",
    };
    let unit = if column.unit.is_empty() {
        String::new()
    } else {
        format!(" <span class=\"unit\">{}</span>", escape(&column.unit))
    };
    format!(
        "<th scope=\"col\"{class}>{}{unit}</th>",
        inline(&column.title)
    )
}

fn cell(cell: &Cell, place: &BlockPlace) -> String {
    match cell {
        Cell::Empty => "<span class=\"none\" aria-label=\"no value\">–</span>".to_owned(),
        Cell::Text(words) => inline(&in_cell(words)),
        Cell::Verdict(tone, words) => {
            let class = match tone {
                Tone::Good => "good",
                Tone::Notice => "notice",
                Tone::Bad => "bad",
                Tone::Quiet => "quiet",
            };
            format!(
                "<span class=\"v {class}\">{}</span>",
                inline(&in_cell(words))
            )
        }
        Cell::Page(id, words) => match place.pages.find(id).filter(|_| place.in_site) {
            Some(to) => {
                let to = link(place.page, to);
                format!("<a href=\"{to}\">{}</a>", escape(&in_cell(words)))
            }
            None => escape(&in_cell(words)),
        },
        Cell::Owned(x, owner) if !owner.is_empty() => {
            format!(
                "{} <span class=\"owner\">({})</span>",
                significant(*x),
                escape(owner)
            )
        }
        Cell::Picture(figure) => svg::thumbnail(figure),
        Cell::Number(_) | Cell::Fixed(..) | Cell::Count(_) | Cell::Owned(..) => {
            escape(&shown(cell))
        }
    }
}

fn figure(figure: &Figure, name: &str, place: &BlockPlace) -> String {
    let drawing = svg::draw(figure, name);
    let remarks: String = drawing
        .remarks
        .iter()
        .map(|remark| format!(" {}", escape(remark)))
        .collect();
    let title = figure.title.trim_end_matches('.');
    let bare = match svg::is_bare(figure) {
        true => " class=\"bare\"",
        false => "",
    };
    let get = match place.in_site {
        true => format!(
            "<p class=\"note\"><a href=\"{}\">every point as CSV</a> · <a href=\"{}\">picture as SVG</a></p>\n",
            place.file("figures", name, "csv"),
            place.file("figures", name, "svg")
        ),
        false => String::new(),
    };
    format!(
        "<figure id=\"{name}\"{bare}>\n<div class=\"picture\" tabindex=\"0\">{}</div>\n\
         <figcaption><b>{}.</b> {}{remarks}</figcaption>\n\
         <details><summary>Data</summary>\n{}{get}</details>\n</figure>\n",
        drawing.svg,
        inline(title),
        inline(&figure.caption),
        data(figure)
    )
}

/// The points of a figure, or what they span where they are many; and its marks.
fn data(figure: &Figure) -> String {
    let points: usize = figure.series.iter().map(|series| series.points.len()).sum();
    let named = |label: &str, unit: &str| match unit {
        "" => escape(label),
        unit => format!(
            "{} <span class=\"unit\">{}</span>",
            escape(label),
            escape(unit)
        ),
    };
    let (x, y) = (
        named(&figure.x.label, &figure.x.unit),
        named(&figure.y.label, &figure.y.unit),
    );
    let mut rows = String::new();
    let headings = if points <= MOST_POINTS {
        for series in &figure.series {
            for [x, y] in &series.points {
                let places = [(&figure.x, *x), (&figure.y, *y)];
                let places = places.map(|(axis, x)| escape(&csv::place(axis, x)));
                rows += &line(&series.name, &places);
            }
        }
        vec![x, y]
    } else {
        for series in &figure.series {
            let range = |axis: usize| {
                let finite = series
                    .points
                    .iter()
                    .map(|point| point[axis])
                    .filter(|x| x.is_finite());
                let (lo, hi) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| {
                    (lo.min(x), hi.max(x))
                });
                let on = if axis == 0 { &figure.x } else { &figure.y };
                let at = |x: f64| match on.name_at(x) {
                    Some(name) => escape(name),
                    None => significant(x),
                };
                if lo > hi {
                    String::new()
                } else {
                    format!("{} to {}", at(lo), at(hi))
                }
            };
            rows += &line(
                &series.name,
                &[series.points.len().to_string(), range(0), range(1)],
            );
        }
        vec!["points".to_owned(), x, y]
    };
    let headings: String = headings
        .iter()
        .map(|h| format!("<th scope=\"col\" class=\"r\">{h}</th>"))
        .collect();
    let mut html = format!(
        "<div class=\"table\" tabindex=\"0\"><table><thead><tr><th scope=\"col\">series</th>{headings}</tr></thead>\n\
         <tbody>\n{rows}</tbody></table></div>\n"
    );
    if !figure.marks.is_empty() {
        let mark = |mark: &crate::finding::Mark| {
            format!("{} {}", shortest(mark.at), escape(&mark.label))
                .trim_end()
                .to_owned()
        };
        // of many, those without words are only counted; JSON has them all
        let many = figure.marks.len() > MOST_POINTS;
        let (listed, counted): (Vec<_>, Vec<_>) = figure
            .marks
            .iter()
            .partition(|mark| !many || !mark.label.is_empty());
        let mut marks: Vec<String> = listed.into_iter().map(mark).collect();
        if !counted.is_empty() {
            marks.push(format!("{} without words", counted.len()));
        }
        html += &format!("<p class=\"note\">Marks: {}.</p>\n", marks.join("; "));
    }
    html
}

fn line(series: &str, numbers: &[String]) -> String {
    let numbers: String = numbers
        .iter()
        .map(|n| format!("<td class=\"r\">{n}</td>"))
        .collect();
    format!(
        "<tr><th scope=\"row\">{}</th>{numbers}</tr>\n",
        escape(&in_cell(series))
    )
}

/// The place where the script mounts a replay, and its data; until then, and on paper, a sentence stands there.
fn replay(replay: &Replay, name: &str) -> String {
    let data = replay_data(replay);
    if data.len() > MOST_DATA {
        return format!(
            "<p id=\"{name}\">There is no replay: its {} kB of knots and events are too many for a page.</p>\n",
            data.len() / 1000
        );
    }
    let remark = match replay.remark.as_str() {
        "" => String::new(),
        words => format!("<p class=\"note\">{}</p>\n", inline(words)),
    };
    format!(
        "{REPLAY} id=\"{name}\">\n<script type=\"application/json\" class=\"replay-data\">{}</script>\n\
         <p class=\"replay-static note\">Where scripts may run, this page plays the shot in every engine. The pictures below show \
         the same.</p>\n</div>\n{remark}",
        inert(&data)
    )
}

/// JSON that no browser takes for the end of its element, nor for a comment.
fn inert(json: &str) -> String {
    json.replace('<', "\\u003c")
}
