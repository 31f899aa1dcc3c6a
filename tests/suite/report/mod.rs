//! Reports: what a document says, every format says, safely and within its limits.

mod colour;
mod escaping;
mod pictures;
mod random;
pub mod sample;

use carom::finding::{
    Axis, Block, Cell, Column, Document, Figure, Mark, Replay, ReplayBall, ReplayDivergence,
    ReplayEvent, ReplayParting, ReplayRun, Series, Style, Table, Tone,
};
use carom::math::Vec3;
use carom::physics::State;
use carom::report::{self, FORMATS, svg, text};
use carom::trace::{Knot, Path};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// A document with every kind of block and cell, small enough to be read here.
fn small() -> Document {
    let figure = Figure {
        id: "errors".into(),
        title: "Errors".into(),
        caption: "Of one engine.".into(),
        x: Axis::linear("time", "s"),
        y: Axis::log("error", "R"),
        equal_scale: false,
        outline: None,
        series: vec![Series {
            name: "stepper".into(),
            points: vec![[0.0, 0.0], [1.0, 1e-3], [2.0, f64::NAN], [3.0, 1e-2]],
            style: Style::Line,
        }],
        marks: vec![Mark {
            at: 1.5,
            label: "1-2".into(),
        }],
    };
    let below = Document {
        stopped_early: None,
        id: "break".into(),
        title: "The break".into(),
        lead: String::new(),
        blocks: vec![
            Block::Text("Nothing else.".into()),
            Block::Replay(Box::new(replay())),
        ],
        pages: Vec::new(),
    };
    Document {
        stopped_early: None,
        id: "report".into(),
        title: "A report".into(),
        lead: "Two of two scenes agree to 1e-3 R.".into(),
        blocks: vec![
            Block::Table(Table {
                id: "scenes".into(),
                title: "Scenes".into(),
                columns: vec![
                    Column::words("scene", "scene"),
                    Column::words("verdict", "verdict"),
                    Column::number("stop", "stop time, worst (ball)", "s"),
                    Column::number("energy", "energy gained", ""),
                    Column::number("events", "events", ""),
                    Column::number("time", "time per shot", "us"),
                ],
                rows: vec![
                    vec![
                        Cell::Page("break".into(), "the break".into()),
                        Cell::verdict(Tone::Good, "agrees"),
                        Cell::Owned(0.123456789, "cue".into()),
                        Cell::Number(1.23456789e-12),
                        Cell::Count(36),
                        Cell::Fixed(17.26, 1),
                    ],
                    vec![
                        Cell::text("a|b, \"c\" <d>"),
                        Cell::verdict(Tone::Bad, "parts"),
                        Cell::Owned(12.0, "7".into()),
                        Cell::Empty,
                        Cell::Count(0),
                        Cell::Number(f64::NAN),
                    ],
                ],
                note: "Up to the horizon.".into(),
            }),
            Block::Heading("Why".into()),
            Block::Text("The `dt` of one is 1000 us.".into()),
            Block::List(vec!["first".into(), "second".into()]),
            Block::Command("carom report --out DIR".into()),
            Block::Figure(figure),
        ],
        pages: vec![below],
    }
}

/// One ball that slides in one engine.
fn replay() -> Replay {
    let knot = |time: f64| Knot {
        time,
        state: State {
            position: Vec3::new(time, 0.5, 0.25),
            velocity: Vec3::new(1.0, 0.0, 0.0),
            spin: Vec3::zeros(),
        },
        after: None,
    };
    Replay {
        scene: "break".into(),
        duration: 2.0,
        length_unit: "foot".into(),
        time_unit: "s".into(),
        origin: [0.0; 3],
        radius: 0.25,
        speed_scale: 1.0,
        table: None,
        pockets: Vec::new(),
        rotates: false,
        balls: vec![ReplayBall {
            id: "cue".into(),
            radius: 0.25,
            mass: 1.0,
            inertia: 0.0,
        }],
        runs: vec![ReplayRun {
            label: "exact".into(),
            engine: "exact".into(),
            reference: true,
            end: 2.0,
            ending: "everything at rest".into(),
            resolution: 0.0,
            events: vec![ReplayEvent {
                time: 2.0,
                kind: "stop",
                a: "cue".into(),
                b: String::new(),
            }],
            paths: vec![Path {
                knots: vec![knot(0.0), knot(2.0)],
            }],
            left_out: 3,
            tolerance: 1e-3,
        }],
        partings: vec![ReplayParting {
            time: 1.0,
            runs: [0, 0],
            balls: vec!["cue".into()],
            words: "One has it, one has not.".into(),
        }],
        horizon: Some(1.5),
        divergence: vec![ReplayDivergence {
            run: 0,
            against: 0,
            points: vec![[0.0, 1e-3]],
        }],
        remark: String::new(),
    }
}

fn render(document: &Document, format: &str) -> String {
    report::render(document, format).unwrap()
}

#[test]
fn text_is_aligned_with_units_in_the_heading() {
    insta::assert_snapshot!(render(&small(), "text"));
}

#[test]
fn markdown_is_readable_as_text() {
    insta::assert_snapshot!(render(&small(), "markdown"));
}

#[test]
fn csv_has_keys_and_every_digit() {
    insta::assert_snapshot!(render(&small(), "csv"), @r#"
    scene,scene-page,verdict,stop,stop-owner,energy,events,time
    the break,break,agrees,0.123456789,cue,1.23456789e-12,36,17.26
    "a|b, ""c"" <d>",,parts,12,7,,0,NaN
    "#);
}

#[test]
fn json_has_the_same_content_and_every_digit() {
    insta::assert_snapshot!(render(&small(), "json"));
}

#[test]
fn formats_have_unique_kebab_case_ids() {
    let mut seen = std::collections::BTreeSet::new();
    for format in FORMATS {
        assert!(seen.insert(format.id), "`{}` is there twice", format.id);
        assert!(
            format
                .id
                .chars()
                .all(|c| c.is_ascii_lowercase() || c == '-'),
            "`{}`",
            format.id
        );
        assert!(
            !format.what.is_empty(),
            "`{}` says nothing about itself",
            format.id
        );
    }
    assert_eq!(seen.len(), 4);
    assert_eq!(report::render(&small(), "docx"), None);
}

/// Every cell of every table as a reader and as a program should find it.
fn expected_cells(document: &Document) -> Vec<(String, String)> {
    let mut cells = Vec::new();
    for block in &document.blocks {
        let Block::Table(table) = block else { continue };
        for cell in table.rows.iter().flatten() {
            let pair = match cell {
                Cell::Text(words) | Cell::Verdict(_, words) | Cell::Page(_, words) => {
                    (words.clone(), words.clone())
                }
                Cell::Count(n) => (n.to_string(), n.to_string()),
                Cell::Fixed(x, digits) => (format!("{x:.*}", usize::from(*digits)), x.to_string()),
                // three digits: the first two are the same in any way of writing them
                Cell::Number(x) | Cell::Owned(x, _) if *x > 0.0 => {
                    let exact = carom::trace::files::shortest(*x);
                    let digits: String = format!("{x:.2e}")
                        .chars()
                        .take(3)
                        .filter(|c| *c != '.')
                        .collect();
                    (digits, exact)
                }
                _ => continue,
            };
            cells.push(pair);
        }
    }
    document
        .pages
        .iter()
        .for_each(|page| cells.extend(expected_cells(page)));
    cells
}

#[test]
fn every_format_has_every_cell_of_every_table() {
    let document = sample::report();
    let expected = expected_cells(&document);
    assert!(
        expected.len() > 500,
        "the sample has only {} cells",
        expected.len()
    );
    let site = report::site(&document);
    let html: String = site
        .iter()
        .filter(|(path, _)| path.ends_with(".html"))
        .map(|(_, page)| page.as_str())
        .collect();
    let (text, markdown) = (render(&document, "text"), render(&document, "markdown"));
    let (csv, json) = (render(&document, "csv"), render(&document, "json"));
    for (shown, exact) in expected {
        // the point of a number and the line breaks of a long text may fall anywhere
        for word in shown.split(' ').filter(|word| word.len() <= 28) {
            let plain = |text: &str| {
                text.contains(word)
                    || (word.len() == 2 && text.contains(&format!("{}.{}", &word[..1], &word[1..])))
            };
            assert!(plain(&text), "text lacks `{word}`");
            assert!(plain(&markdown), "markdown lacks `{word}`");
            assert!(
                plain(&html.replace("<code>", "`").replace("</code>", "`")),
                "html lacks `{word}`"
            );
        }
        assert!(csv.contains(&exact), "csv lacks `{exact}`");
        let number: Result<f64, _> = exact.parse();
        let in_json = number.map_or(exact.clone(), |x| {
            serde_json::json!(x)
                .to_string()
                .trim_end_matches(".0")
                .to_owned()
        });
        assert!(json.contains(&in_json), "json lacks `{in_json}`");
    }
}

#[test]
fn text_is_never_wider_than_a_terminal_and_uses_what_it_has() {
    let document = sample::report();
    assert_eq!(
        render(&document, "text"),
        text::write(&document, text::WIDTH)
    );
    let longest = |width: usize| {
        let text = text::write(&document, width);
        text.lines().map(|line| line.chars().count()).max()
    };
    for width in [text::NARROWEST, 80, text::WIDTH, 132, text::WIDEST] {
        // the rule between two pages is as long as a line may be
        assert_eq!(longest(width), Some(width));
    }
    assert_eq!(longest(0), Some(text::NARROWEST));
}

#[test]
fn a_wide_terminal_has_tables_of_its_width_and_prose_that_can_be_read() {
    let words = "of many words ".repeat(30);
    let table = Table {
        id: "wide".into(),
        columns: vec![Column::words("a", "a"), Column::words("b", "b")],
        rows: vec![vec![Cell::text("name"), Cell::text(words.trim_end())]],
        note: words.clone(),
        ..Table::default()
    };
    let longest = |text: &str| text.lines().map(|line| line.chars().count()).max();
    for width in [text::WIDTH, text::WIDEST] {
        let text = text::table(&table, width);
        let (grid, note) = text.split_once("\n\n").unwrap();
        // the rule below the heading is as long as its columns are wide
        assert_eq!(longest(grid), Some(width), "{text}");
        assert!(longest(note) <= Some(text::WIDTH), "{text}");
        let document = Document {
            blocks: vec![
                Block::Text(words.clone()),
                Block::List(vec![words.clone()]),
                Block::Heading(words.clone()),
            ],
            ..Document::default()
        };
        let prose = text::write(&document, width);
        assert!(longest(&prose) <= Some(text::WIDTH), "{prose}");
    }
}

#[test]
fn a_wide_table_is_split_and_every_part_names_its_rows() {
    let table = Table {
        id: "wide".into(),
        title: String::new(),
        columns: (0..12)
            .map(|i| Column::number(&format!("c{i}"), &format!("column-{i}"), "s"))
            .collect(),
        rows: vec![(0..12).map(|i| Cell::Fixed(f64::from(i), 6)).collect()],
        note: String::new(),
    };
    let text = text::table(&table, text::WIDTH);
    let headings: Vec<&str> = text
        .lines()
        .filter(|line| line.contains("column-"))
        .collect();
    assert!(headings.len() > 1, "12 columns of 8 fit into 100?\n{text}");
    for heading in headings {
        assert!(heading.contains("column-0"), "no names in: {heading}");
    }
    let wide = text::table(&table, text::WIDEST);
    assert_eq!(
        wide.matches("column-0").count(),
        1,
        "12 columns of 9 do not fit into 160?\n{wide}"
    );
}

#[test]
fn a_long_command_stays_one_command() {
    let command = format!("carom compare {} --engines exact", "x".repeat(150));
    let document = Document {
        stopped_early: None,
        blocks: vec![Block::Command(command.clone())],
        ..Document::default()
    };
    let text = render(&document, "text");
    assert!(text.lines().count() > 2, "{text}");
    // what a shell makes of it
    let joined = text.replace("\\\n", "");
    assert_eq!(
        joined.split_whitespace().collect::<Vec<_>>(),
        command.split_whitespace().collect::<Vec<_>>()
    );
}

#[test]
fn a_report_asks_nothing_of_any_other_place_and_all_its_links_lead_somewhere() {
    let site: BTreeMap<String, String> = report::site(&sample::report()).into_iter().collect();
    let mut links = 0;
    for (path, page) in site.iter().filter(|(path, _)| path.ends_with(".html")) {
        assert!(page.contains("default-src 'none'"), "{path} has no policy");
        for foreign in [
            "http:",
            "https:",
            "src=",
            "@import",
            "url(",
            "<script",
            "<link rel=\"stylesheet",
        ] {
            assert!(!page.contains(foreign), "{path} has `{foreign}`");
        }
        assert!(page.len() < 1_500_000, "{path} has {} bytes", page.len());
        let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
        for target in page
            .split("href=\"")
            .skip(1)
            .filter_map(|rest| rest.split('"').next())
        {
            links += 1;
            if let Some(anchor) = target.strip_prefix('#') {
                assert!(
                    page.contains(&format!("id=\"{anchor}\"")),
                    "{path} has no `{anchor}`"
                );
            } else if target != "data:," {
                let file = match target.strip_prefix("../") {
                    Some(up) => up.to_owned(),
                    None if folder.is_empty() => target.to_owned(),
                    None => format!("{folder}/{target}"),
                };
                assert!(
                    site.contains_key(&file),
                    "{path} links to {file}, which is not there"
                );
            }
        }
    }
    assert!(links > 100, "only {links} links");
    for file in [
        "index.html",
        "report.md",
        "report.json",
        "pages/six-balls.html",
        "tables/scenes.csv",
        "figures/cost.svg",
    ] {
        assert!(site.contains_key(file), "no {file}");
    }
}

#[test]
fn the_same_document_gives_the_same_bytes() {
    assert_eq!(report::site(&small()), report::site(&small()));
}

#[test]
fn words_never_become_markup() {
    const EVIL: &str = "<script>alert('1')</script>\"><b onload=x> & ../../up";
    let mut document = small();
    for text in [&mut document.id, &mut document.title, &mut document.lead] {
        *text = EVIL.into();
    }
    for block in &mut document.blocks {
        match block {
            Block::Heading(words) | Block::Text(words) | Block::Command(words) => {
                *words = EVIL.into()
            }
            Block::List(items) => items.push(EVIL.into()),
            Block::Table(table) => {
                for text in [&mut table.id, &mut table.title, &mut table.note] {
                    *text = EVIL.into();
                }
                table.columns[0] = Column::number(EVIL, EVIL, EVIL);
                table.rows.push(vec![
                    Cell::text(EVIL),
                    Cell::verdict(Tone::Quiet, EVIL),
                    Cell::Owned(1.0, EVIL.into()),
                    Cell::Page(EVIL.into(), EVIL.into()),
                    Cell::Page("break".into(), EVIL.into()),
                ]);
            }
            Block::Figure(figure) => {
                for text in [&mut figure.id, &mut figure.title, &mut figure.caption] {
                    *text = EVIL.into();
                }
                figure.x = Axis::linear(EVIL, EVIL);
                figure.series[0].name = EVIL.into();
                figure.marks[0].label = EVIL.into();
            }
            Block::Replay(_) => unreachable!("it is on the page below"),
        }
    }
    let Some(Block::Replay(replay)) = document.pages[0].blocks.last_mut() else {
        unreachable!("the page below ends with its replay");
    };
    let run = &mut replay.runs[0];
    for text in [
        &mut replay.scene,
        &mut replay.length_unit,
        &mut replay.remark,
        &mut replay.balls[0].id,
        &mut run.label,
        &mut run.ending,
        &mut run.events[0].a,
        &mut replay.partings[0].words,
    ] {
        *text = EVIL.into();
    }
    document.pages[0].id = EVIL.into();
    document.pages[0].title = EVIL.into();
    for (path, content) in report::site(&document) {
        assert!(
            path.split('/')
                .all(|part| !part.starts_with('.') && !part.is_empty()),
            "{path}"
        );
        assert!(
            path.chars()
                .all(|c| c.is_ascii_alphanumeric() || "/.-".contains(c)),
            "{path}"
        );
        if path.ends_with(".html") || path.ends_with(".svg") {
            // the replay has its data, and a script of its own
            let scripts = content.matches("<script").count();
            let own = content
                .matches("<script type=\"application/json\" class=\"replay-data\">")
                .count();
            assert_eq!(scripts, 2 * own, "{path}");
            for markup in ["<script>alert", "<b onload", "\"><b"] {
                assert!(!content.contains(markup), "{path} has `{markup}`");
            }
        }
        if path.ends_with(".md") {
            assert!(
                !content.replace("```sh\n<script", "").contains("\n<script"),
                "{path}"
            );
        }
    }
}

/// The picture as XML, which only well-formed text is.
fn parsed(figure: &Figure) -> String {
    let svg = svg::standalone(figure);
    if let Err(error) = roxmltree::Document::parse(&svg) {
        panic!("{error}\n{svg}");
    }
    svg
}

fn figure_of(points: Vec<[f64; 2]>) -> Figure {
    let Some(Block::Figure(mut figure)) = small().blocks.pop() else {
        unreachable!("the small document ends with its figure");
    };
    figure.y = Axis::linear("error", "R");
    figure.series[0].points = points;
    figure.marks.clear();
    figure
}

#[test]
fn a_point_that_is_no_number_interrupts_the_line() {
    let whole = parsed(&figure_of(vec![
        [0.0, 0.0],
        [1.0, 2.0],
        [2.0, 0.0],
        [3.0, 2.0],
        [4.0, 0.0],
    ]));
    let broken = parsed(&figure_of(vec![
        [0.0, 0.0],
        [1.0, 2.0],
        [2.0, f64::NAN],
        [3.0, 2.0],
        [4.0, 0.0],
    ]));
    let pieces = |svg: &str| {
        // the first such path is the sample in the legend
        let line = svg
            .split("<path class=\"l\" d=\"")
            .nth(2)
            .and_then(|rest| rest.split('"').next());
        line.map(|d| d.matches('M').count())
    };
    assert_eq!((pieces(&whole), pieces(&broken)), (Some(1), Some(2)));
    let remarks = svg::draw(&figure_of(vec![[0.0, 1.0], [f64::INFINITY, 0.0]]), "f").remarks;
    assert_eq!(
        remarks,
        ["1 point with a value that is no number interrupt the lines."]
    );
}

#[test]
fn a_figure_without_points_says_so() {
    for points in [vec![], vec![[f64::NAN, 1.0]]] {
        assert!(parsed(&figure_of(points)).contains("no points to show"));
    }
}

#[test]
fn a_million_points_make_a_small_picture() {
    let wave = |i: u32| [f64::from(i) * 1e-5, (f64::from(i) * 1e-3).sin()];
    let svg = parsed(&figure_of((0..1_000_000).map(wave).collect()));
    // 160 waves over 800 px: a few dozen points a wave, 12 bytes each
    assert!(svg.len() < 100_000, "{} bytes", svg.len());
    assert!(
        svg.len() > 10_000,
        "only {} bytes are left of 160 waves",
        svg.len()
    );
}

#[test]
fn labels_of_marks_do_not_overlap() {
    let mut figure = figure_of(vec![[0.0, 0.0], [1.0, 1.0]]);
    figure.marks = (0..40)
        .map(|i| Mark {
            at: f64::from(i * i) / 1600.0,
            label: format!("{i}-{}", i + 1),
        })
        .collect();
    let drawing = svg::draw(&figure, "f");
    let labels: Vec<(f64, f64, f64)> = drawing
        .svg
        .split("<text class=\"n\" ")
        .skip(1)
        .map(|text| {
            let number = |key: &str| {
                text.split(key)
                    .nth(1)
                    .and_then(|t| t.split('"').next())
                    .unwrap()
                    .parse::<f64>()
                    .unwrap()
            };
            let words = text.split('>').nth(1).unwrap().trim_end_matches("</text");
            // a digit of 11 px is 6.4 px wide at most
            (number("x=\""), number("y=\""), 6.4 * words.len() as f64)
        })
        .collect();
    assert!(
        labels.len() > 10,
        "only {} of 40 labels are shown",
        labels.len()
    );
    for (i, a) in labels.iter().enumerate() {
        for b in &labels[i + 1..] {
            assert!(
                a.1 != b.1 || a.0 + a.2 <= b.0 || b.0 + b.2 <= a.0,
                "{a:?} and {b:?} overlap"
            );
        }
    }
    let dropped = 40 - labels.len();
    assert_eq!(drawing.remarks.len(), usize::from(dropped > 0));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_document_can_be_written_in_any_format(document in random::document()) {
        let text = render(&document, "text");
        prop_assert!(text.lines().all(|line| line.chars().count() <= text::WIDTH), "{}", text);
        for width in [text::NARROWEST, text::WIDEST] {
            let text = text::write(&document, width);
            prop_assert!(text.lines().all(|line| line.chars().count() <= width), "{}: {}", width, text);
        }
        let json: Result<serde_json::Value, _> = serde_json::from_str(&render(&document, "json"));
        prop_assert!(json.is_ok(), "{:?}", json);
        for (path, content) in report::site(&document) {
            if path.ends_with(".csv") {
                // as many fields in every row as in the first
                let mut reader = csv::Reader::from_reader(content.as_bytes());
                let bad = reader.records().find_map(Result::err);
                prop_assert!(bad.is_none(), "{}: {:?}\n{}", path, bad, content);
            }
            if path.ends_with(".svg") {
                let parsed = roxmltree::Document::parse(&content);
                prop_assert!(parsed.is_ok(), "{}: {:?}\n{}", path, parsed.err(), content);
            }
        }
        prop_assert!(!render(&document, "markdown").is_empty());
    }
}
