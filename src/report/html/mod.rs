//! An offline site: `index.html` and one file a page, which ask nothing of any other place.
//!
//! No script, no font, no picture from elsewhere: the policy in every page forbids it, and lets run only the script that plays a
//! replay, where there is one. All words are escaped, whatever the ids of a scene are.

mod blocks;
mod policy;

pub use blocks::inline;
pub use policy::{embeddable, hash};

use super::names::{Page, Pages};
use super::svg;
use super::words::plain;
use crate::finding::{Block, Cell, Document};
use blocks::BlockPlace;
use policy::Shell;

/// What the first page is called where its title would be too long.
const HOME: &str = "carom";

/// Every page with its path: those below first, `index.html` last.
pub fn write(document: &Document) -> Vec<(String, String)> {
    let pages = Pages::of(document);
    let file = |index: usize| (path(&pages.list[index]), page(&pages, index));
    (1..pages.list.len()).chain([0]).map(file).collect()
}

/// What a document's first page says, to be put into a page of another making: lead and blocks, no links to files of a site.
///
/// The page has to hold [`style`], and whatever script is to play a replay.
pub fn fragment(document: &Document) -> String {
    let pages = Pages::of(document);
    let page = &pages.list[0];
    let place = BlockPlace {
        page,
        pages: &pages,
        in_site: false,
    };
    stopped(document) + &lead(document) + &blocks::all(&place)
}

/// What stands first where the user asked to stop.
fn stopped(document: &Document) -> String {
    let words = document.stopped_early.as_deref();
    words.map_or_else(String::new, |words| {
        format!("<p role=\"note\"><strong>{}</strong></p>\n", escape(words))
    })
}

/// Words of a page, in one line: what is markup is itself, and what nobody would see is shown.
fn escape(words: &str) -> String {
    svg::escape(&plain(words))
}

/// The sheet of every page and of [`fragment`].
pub fn style() -> String {
    policy::sheet()
}

fn lead(document: &Document) -> String {
    if document.lead.is_empty() {
        return String::new();
    }
    format!(
        "<p class=\"lead\">{}</p>\n",
        blocks::inline(&blocks::together(&document.lead))
    )
}

/// Path of a page in the site.
pub fn path(page: &Page) -> String {
    match page.depth {
        0 => "index.html".to_owned(),
        _ => format!("pages/{}.html", page.name),
    }
}

/// Path of the CSV file of a table or figure, or of its picture, in the site.
pub fn file(page: &Page, kind: &str, name: &str, extension: &str) -> String {
    match page.depth {
        0 => format!("{kind}/{name}.{extension}"),
        _ => format!("{kind}/{}/{name}.{extension}", page.name),
    }
}

/// The way from a page to the folder of the site.
fn root(page: &Page) -> &'static str {
    if page.depth == 0 { "" } else { "../" }
}

fn page(pages: &Pages, index: usize) -> String {
    let page = &pages.list[index];
    let place = BlockPlace {
        page,
        pages,
        in_site: true,
    };
    let document = page.document;
    let first = &pages.list[0];
    let title = if index == 0 {
        escape(&document.title)
    } else {
        format!(
            "{} · {}",
            escape(&document.title),
            escape(&first.document.title)
        )
    };
    let contents = contents(page);
    let blocks = blocks::all(&place);
    let shell = Shell::of(blocks.contains(blocks::REPLAY));
    let mut html = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n\
         <link rel=\"icon\" href=\"data:,\">\n{}\n</head>\n<body>\n\
         <a class=\"skip\" href=\"#main\">To the contents</a>\n<div class=\"shell{}\">\n",
        shell.policy,
        shell.style,
        if contents.is_empty() { "" } else { " has-toc" }
    );
    html += &bar(pages, index);
    html += &contents;
    // a part of what was stopped is read by itself
    html += &format!(
        "<main id=\"main\">\n{}<h1>{}</h1>\n",
        stopped(first.document),
        escape(&document.title)
    );
    html += &lead(document);
    html += &blocks;
    html += &unlinked(pages, index);
    html += &turn(pages, index);
    html + "</main>\n</div>\n" + &shell.script + "</body>\n</html>\n"
}

/// Where a reader is, and what else there is.
fn bar(pages: &Pages, index: usize) -> String {
    let page = &pages.list[index];
    let mut above = Vec::new();
    let mut at = index;
    while at != 0 {
        at = pages.list[at].parent;
        above.push(at);
    }
    let mut crumbs = String::new();
    for &at in above.iter().rev() {
        let to = &pages.list[at];
        let words = if at == 0 { HOME } else { &to.document.title };
        crumbs += &format!(
            "<a href=\"{}\">{}</a><span aria-hidden=\"true\">/</span>",
            link(page, to),
            escape(words)
        );
    }
    crumbs += &escape(if index == 0 {
        HOME
    } else {
        &page.document.title
    });
    let root = root(page);
    format!(
        "<header class=\"bar\"><nav class=\"crumbs\" aria-label=\"Where you are\">{crumbs}</nav>\
         <span class=\"get\">this report as <a href=\"{root}report.md\">Markdown</a> or \
         <a href=\"{root}report.json\">JSON</a></span></header>\n"
    )
}

/// Section titles of a long page.
fn contents(page: &Page) -> String {
    let blocks = page.document.blocks.iter().zip(&page.blocks);
    let headings: Vec<String> = blocks
        .filter_map(|(block, name)| match block {
            Block::Heading(words) => Some(format!(
                "<li><a href=\"#{name}\">{}</a></li>",
                blocks::inline(words)
            )),
            _ => None,
        })
        .collect();
    if headings.len() < 3 {
        return String::new();
    }
    format!(
        "<nav class=\"toc\" aria-label=\"On this page\"><p>On this page</p><ul>{}</ul></nav>\n",
        headings.concat()
    )
}

/// The pages below this one that no table links to.
fn unlinked(pages: &Pages, index: usize) -> String {
    let document = pages.list[index].document;
    let cells = document.blocks.iter().filter_map(|block| match block {
        Block::Table(table) => Some(table.rows.iter().flatten()),
        _ => None,
    });
    let linked: Vec<&str> = cells
        .flatten()
        .filter_map(|cell| match cell {
            Cell::Page(id, _) => Some(id.as_str()),
            _ => None,
        })
        .collect();
    let below = pages.list.iter().enumerate().filter(|(i, page)| {
        *i != index && page.parent == index && !linked.contains(&page.document.id.as_str())
    });
    let items: Vec<String> = below
        .map(|(_, page)| {
            let (to, words) = (link(&pages.list[index], page), escape(&page.document.title));
            format!("<li><a href=\"{to}\">{words}</a></li>")
        })
        .collect();
    if items.is_empty() {
        return String::new();
    }
    format!(
        "<nav class=\"pages\"><h2>Pages</h2><ul>{}</ul></nav>\n",
        items.concat()
    )
}

/// To the page before, the page above and the page after.
fn turn(pages: &Pages, index: usize) -> String {
    if index == 0 {
        return String::new();
    }
    let page = &pages.list[index];
    let siblings: Vec<usize> = (1..pages.list.len())
        .filter(|&i| pages.list[i].parent == page.parent)
        .collect();
    let here = siblings.iter().position(|&i| i == index).unwrap_or(0);
    let to = |at: usize, before: &str, after: &str| {
        let (to, words) = (
            link(page, &pages.list[at]),
            escape(&pages.list[at].document.title),
        );
        format!("<a href=\"{to}\">{before}{words}{after}</a>")
    };
    let mut links = String::new();
    if let Some(before) = here.checked_sub(1) {
        links += &to(siblings[before], "← ", "");
    }
    links += &to(page.parent, "↑ ", "");
    if let Some(&after) = siblings.get(here + 1) {
        links += &to(after, "", " →");
    }
    format!("<nav class=\"pages turn\" aria-label=\"Other pages\">{links}</nav>\n")
}

/// The way from one page to another.
fn link(from: &Page, to: &Page) -> String {
    match (from.depth, to.depth) {
        (0, _) | (_, 0) => format!("{}{}", root(from), path(to)),
        _ => format!("{}.html", to.name),
    }
}
