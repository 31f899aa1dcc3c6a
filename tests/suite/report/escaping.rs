//! Words that are markup somewhere come back as themselves from every format: to the bit where programs read, as the same words
//! where people do.

use carom::finding::{Axis, Block, Cell, Column, Document, Figure, Series, Style, Table, Tone};
use carom::report::words::{in_cell, is_formula, plain};
use carom::report::{self, csv as sheets, html, markdown, text};
use carom::scene::is_hidden;
use proptest::prelude::*;
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

/// What somebody who wants trouble makes names of.
const NASTY: [&str; 44] = [
    "<img src=x>",
    "</td>",
    "<!--",
    "|",
    "\\|",
    "`",
    "``",
    "*",
    "**",
    "_",
    "__",
    "[x](y)",
    "![x](y)",
    "](",
    "]",
    "[^1]",
    "\\",
    "~",
    "~~",
    "$",
    "&amp;",
    "&#42;",
    "#",
    "##",
    "- ",
    "+ ",
    "-",
    "1. ",
    "1)",
    "> ",
    "=1+1",
    "@",
    "=",
    "---",
    "http://x.y",
    "www.x.y",
    "\u{1b}[2J",
    "\u{202e}",
    "\u{200b}",
    "\n",
    "\t",
    "::error::",
    "\u{645}\u{200c}",
    "x",
];

fn joined(pieces: Vec<&'static str>) -> String {
    pieces.concat()
}

/// Words of pieces; a name has no spaces.
fn words() -> impl Strategy<Value = String> {
    prop_oneof![
        prop::collection::vec(prop::sample::select(NASTY.to_vec()), 1..7).prop_map(joined),
        prop::collection::vec(prop::sample::select(NASTY.to_vec()), 1..7)
            .prop_map(|pieces| pieces.join(" ")),
        "[ -~]{1,16}",
    ]
}

fn name() -> impl Strategy<Value = String> {
    words().prop_filter_map("a name has letters", |words| {
        let name: String = words.split_whitespace().collect();
        (!name.is_empty()).then_some(name)
    })
}

/// The words wherever a document can have them; cells in one row.
fn document(name: &str, words: &str) -> Document {
    let table = Table {
        id: "table".into(),
        title: words.into(),
        columns: vec![
            Column::words("name", name),
            Column::words("words", words),
            Column::number("owned", name, name),
            Column::words("page", "page"),
            Column::words("verdict", "verdict"),
        ],
        rows: vec![vec![
            Cell::text(name),
            Cell::text(words),
            Cell::Owned(1.0, name.into()),
            Cell::Page("below".into(), name.into()),
            Cell::verdict(Tone::Bad, words),
        ]],
        note: words.into(),
    };
    let figure = Figure {
        id: "figure".into(),
        title: name.into(),
        caption: words.into(),
        x: Axis::linear(name, name),
        y: Axis::linear(words, ""),
        equal_scale: false,
        outline: None,
        series: vec![Series {
            name: name.into(),
            points: vec![[0.0, 0.0], [1.0, 1.0]],
            style: Style::Line,
        }],
        marks: Vec::new(),
    };
    Document {
        stopped_early: None,
        id: "report".into(),
        title: name.into(),
        lead: words.into(),
        blocks: vec![
            Block::Heading(words.into()),
            Block::Text(words.into()),
            Block::List(vec![words.into(), name.into()]),
            Block::Table(table),
            Block::Figure(figure),
        ],
        pages: vec![Document {
            id: "below".into(),
            title: "below".into(),
            ..Document::default()
        }],
    }
}

/// The same words whatever stands between them, and whether they are code: in sentences a pair of backticks is the house's own sign.
fn bare(words: &str) -> String {
    let words: Vec<&str> = words.split_whitespace().collect();
    words.join(" ").replace('`', "")
}

/// Blocks of Markdown as kind and words, in order, those without words left out; what is not the words of a block is an error.
fn blocks(source: &str) -> Result<Vec<(&'static str, String)>, String> {
    let github = Options::ENABLE_TABLES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_MATH
        | Options::ENABLE_GFM;
    let mut found = Vec::new();
    let mut now = String::new();
    let mut kind = "";
    for event in Parser::new_ext(source, github) {
        let mut end = |kind: &'static str, now: &mut String| {
            if !now.trim().is_empty() {
                found.push((kind, now.trim().to_owned()));
            }
            now.clear();
        };
        match event {
            Event::Start(Tag::Paragraph) => kind = "words",
            Event::Start(Tag::Item) => kind = "item",
            Event::Start(Tag::Heading { .. }) => kind = "heading",
            Event::Start(Tag::TableCell) => kind = "cell",
            Event::Start(Tag::Link { dest_url, .. }) if dest_url.starts_with('#') => {}
            Event::Start(
                Tag::Table(_) | Tag::TableHead | Tag::TableRow | Tag::List(None) | Tag::Strong,
            ) => {}
            // the title before a caption
            Event::Start(Tag::Emphasis) if now.is_empty() && kind == "words" => {}
            Event::Text(words) | Event::Code(words) => now += &words,
            Event::End(TagEnd::Paragraph) => end("words", &mut now),
            Event::End(TagEnd::Heading(_)) => end("heading", &mut now),
            Event::End(TagEnd::TableCell) => end("cell", &mut now),
            Event::End(TagEnd::Item) => end("item", &mut now),
            Event::End(_) => {}
            other => return Err(format!("{other:?}")),
        }
    }
    Ok(found)
}

/// Cells of the table of a page, each with its words.
fn cells(page: &str) -> Result<Vec<String>, String> {
    let page = format!("<page>{page}</page>");
    let parsed = roxmltree::Document::parse(&page).map_err(|error| error.to_string())?;
    let table = parsed
        .descendants()
        .find(|node| node.has_tag_name("section"))
        .ok_or("no table")?;
    for node in table.descendants().filter(roxmltree::Node::is_element) {
        let name = node.tag_name().name();
        let known = [
            "section", "div", "h3", "table", "thead", "tbody", "tr", "th", "td", "span", "code",
            "p", "a",
        ];
        if !known.contains(&name) {
            return Err(format!("an element `{name}`"));
        }
    }
    let body = table.descendants().find(|node| node.has_tag_name("tbody"));
    let cells = body.into_iter().flat_map(|body| body.descendants());
    Ok(cells
        .filter(|node| node.has_tag_name("td") || node.has_tag_name("th"))
        .map(|cell| {
            cell.descendants()
                .filter_map(|node| node.text().filter(|_| node.is_text()))
                .collect()
        })
        .collect())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn words_come_back_from_markdown(name in name(), words in words()) {
        let source = markdown::write(&document(&name, &words));
        let found = blocks(&source).map_err(|markup| {
            TestCaseError::fail(format!("{name:?}, {words:?}: {markup} in\n{source}"))
        })?;
        let (line, cell) = (plain(&words).into_owned(), in_cell(&words).into_owned());
        let (name, own) = (plain(&name).into_owned(), in_cell(&name).into_owned());
        let title = name.trim_end_matches('.');
        let expected: Vec<(&str, String)> = [
            ("heading", name.clone()),
            ("words", line.clone()),
            ("heading", line.clone()),
            ("words", line.clone()),
            ("item", line.clone()),
            ("item", name.clone()),
            ("words", line.clone()),
            ("cell", name.clone()),
            ("cell", line.clone()),
            ("cell", format!("{name} ({name})")),
            ("cell", "page".into()),
            ("cell", "verdict".into()),
            ("cell", own.clone()),
            ("cell", cell.clone()),
            ("cell", format!("1.00 ({name})")),
            ("cell", own.clone()),
            ("cell", cell),
            ("words", line.clone()),
            ("words", format!("{title}. {line}")),
            ("heading", "below".into()),
        ]
        .into_iter()
        .filter(|(_, words)| !words.trim().is_empty())
        .collect();
        let same = |(kind, words): &(&str, String)| (kind.to_string(), bare(words));
        prop_assert_eq!(
            found.iter().map(same).collect::<Vec<_>>(),
            expected.iter().map(same).collect::<Vec<_>>(),
            "{}", source
        );
        // a name has its own backticks too
        let names = found.iter().filter(|(kind, words)| *kind == "cell" && *words == own);
        prop_assert!(names.count() >= 2, "{}", source);
        if !name.contains(is_hidden) && !is_formula(&name) {
            prop_assert_eq!(&own, &name);
        }
    }

    #[test]
    fn words_come_back_from_pages(name in name(), words in words()) {
        let page = html::fragment(&document(&name, &words));
        let found = cells(&page).map_err(|why| {
            TestCaseError::fail(format!("{name:?}, {words:?}: {why} in\n{page}"))
        })?;
        let (own, words) = (in_cell(&name), in_cell(&words));
        let owned = format!("1.00 ({})", plain(&name));
        prop_assert_eq!([&found[0], &found[2], &found[3]], [&*own, &owned, &*own]);
        prop_assert_eq!([bare(&found[1]), bare(&found[4])], [bare(&words), bare(&words)]);
        prop_assert!(!page.contains(|c| is_hidden(c) && c != '\n'), "{:?}", page);
    }

    #[test]
    fn text_commands_no_terminal_and_hides_nothing(name in name(), words in words()) {
        let document = document(&name, &words);
        let shown = report::render(&document, "text").unwrap();
        prop_assert!(!shown.contains(|c| is_hidden(c) && c != '\n'), "{:?}", shown);
        let Block::Table(table) = &document.blocks[3] else { unreachable!("it is the fourth") };
        let one = Table { columns: table.columns[..1].to_vec(), rows: vec![vec![Cell::text(&name)]], ..Table::default() };
        let close = |text: &str| text.split_whitespace().collect::<String>();
        prop_assert!(close(&text::table(&one, text::WIDTH)).contains(&close(&in_cell(&name))));
    }

    #[test]
    fn names_come_back_to_the_bit_where_programs_read(name in name(), words in words()) {
        let document = document(&name, &words);
        let json: serde_json::Value = serde_json::from_str(&report::render(&document, "json").unwrap()).unwrap();
        let row = &json["tables"]["table"]["rows"][0];
        prop_assert_eq!(row["name"].as_str(), Some(name.as_str()));
        prop_assert_eq!(row["words"].as_str(), Some(words.as_str()));
        prop_assert_eq!(row["owned-owner"].as_str(), Some(name.as_str()));
        let Block::Table(table) = &document.blocks[3] else { unreachable!("it is the fourth") };
        let sheet = sheets::table(table);
        for comment in [None, Some(b'#')] {
            let mut reader = csv::ReaderBuilder::new().comment(comment).from_reader(sheet.as_bytes());
            let rows: Vec<csv::StringRecord> = reader.records().collect::<Result<_, _>>().unwrap();
            prop_assert_eq!(rows.len(), 1);
            prop_assert_eq!([&rows[0][0], &rows[0][1]], [name.as_str(), words.as_str()]);
        }
    }
}

#[test]
fn only_what_is_markup_where_it_stands_is_escaped() {
    let cell = |words: &str| {
        let table = Table {
            columns: vec![Column::words("x", "x")],
            rows: vec![vec![Cell::text(words)]],
            ..Table::default()
        };
        let document = Document {
            blocks: vec![Block::Table(table)],
            ..Document::default()
        };
        let source = markdown::write(&document);
        let row = source.lines().last().unwrap();
        row.trim_matches(['|', ' ']).to_owned()
    };
    for same in [
        "cue",
        "my_ball_1",
        "a-b",
        "-",
        "1. first",
        "x > y",
        "3 - 4",
        "(a) b: c, d; e!",
        "50 %",
        "x^2",
        "a#1",
        "`dt` of it",
        "it's \"so\"",
        "-1.5",
    ] {
        assert_eq!(cell(same), same);
    }
    for (words, escaped) in [
        ("a|b", "a\\|b"),
        ("<b>", "\\<b>"),
        ("*x*", "\\*x\\*"),
        ("_x_", "\\_x\\_"),
        ("`x`", "\\`x\\`"),
        ("[x](y)", "\\[x](y)"),
        ("=1+1", "'=1+1"),
        ("of `a|b`", "of \\`a\\|b\\`"),
        ("a\u{202e}b", "a\\\\u{202e}b"),
    ] {
        assert_eq!(cell(words), escaped);
    }
    let line = |words: &str| {
        let document = Document {
            blocks: vec![Block::Text(words.into())],
            ..Document::default()
        };
        markdown::write(&document)
            .lines()
            .last()
            .unwrap()
            .to_owned()
    };
    for (words, escaped) in [
        ("2.84 m x 1.42 m", "2.84 m x 1.42 m"),
        ("a | b", "a | b"),
        ("1. first", "1\\. first"),
        ("2)", "2\\)"),
        ("- first", "\\- first"),
        ("# first", "\\# first"),
    ] {
        assert_eq!(line(words), escaped);
    }
}
