//! Pictures: no words over other words, whatever the figure; series that can be told apart without colour.

use super::random::SIGNS;
use super::sample;
use carom::engine::Setting;
use carom::finding::{Axis, Block, Cell, Document, Figure, Mark, Series, Style};
use carom::report::{self, svg};
use carom::scene::catalogue;
use carom::study::matrix::Timing;
use carom::study::{Configuration, Watch, compare, curves, effects, horizon, stability};
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

static NEVER: AtomicBool = AtomicBool::new(false);

/// Advance of the characters from space to tilde in DejaVu Sans 2.37, the widest face that a page asks for, thousandths of its size.
const ADVANCE: [u16; 95] = [
    318, 401, 460, 838, 637, 951, 780, 275, 391, 391, 500, 838, 318, 361, 318, 337, 637, 637, 637,
    637, 637, 637, 637, 637, 637, 637, 337, 337, 838, 838, 838, 531, 1000, 685, 687, 699, 771, 632,
    576, 775, 752, 295, 295, 656, 558, 863, 749, 788, 604, 788, 695, 635, 611, 732, 685, 989, 686,
    611, 686, 391, 337, 391, 838, 500, 500, 613, 635, 550, 635, 616, 353, 635, 634, 278, 278, 580,
    278, 975, 634, 612, 635, 635, 412, 521, 393, 634, 592, 818, 592, 592, 525, 637, 337, 637, 838,
];

fn width(words: &str, size: f64) -> f64 {
    let advance = |c: char| match c {
        ' '..='~' => f64::from(ADVANCE[c as usize - 32]),
        '⁰' | '¹' | '²' | '³' | '⁴'..='⁹' => 401.0,
        '⁻' => 528.0,
        '−' => 838.0,
        // an ellipsis, and whatever else: a full square
        _ => 1000.0,
    };
    words.chars().map(advance).sum::<f64>() * 1e-3 * size
}

/// Words in a picture, with what they cover: left, top, right, bottom, px.
struct Words {
    words: String,
    covers: [f64; 4],
}

/// Every piece of text of a picture, and its width and height.
fn words(svg: &str) -> (Vec<Words>, [f64; 2]) {
    let document = roxmltree::Document::parse(svg).unwrap_or_else(|e| panic!("{e}\n{svg}"));
    let root = document.root_element();
    let size = ["width", "height"].map(|key| root.attribute(key).unwrap().parse().unwrap());
    let texts = root.descendants().filter(|node| node.has_tag_name("text"));
    let words = texts.map(|node| {
        let words = node.text().unwrap_or_default().to_owned();
        let classes: Vec<&str> = node
            .attribute("class")
            .unwrap_or_default()
            .split(' ')
            .collect();
        let size = if classes.contains(&"n") { 11.0 } else { 13.0 };
        let long = width(&words, size);
        let start = match () {
            () if classes.contains(&"a") => -0.5 * long,
            () if classes.contains(&"e") => -long,
            () => 0.0,
        };
        // capitals and what hangs below the line, parts of the size: DejaVu Sans has .73 and .24
        let (up, down) = (0.73 * size, 0.24 * size);
        let number = |key: &str| {
            node.attribute(key)
                .map_or(0.0, |x| x.parse::<f64>().unwrap())
        };
        let covers = match node.attribute("transform") {
            None => {
                let (x, y) = (number("x") + start, number("y"));
                [x, y - up, x + long, y + down]
            }
            // upwards
            Some(turned) => {
                assert!(turned.ends_with("rotate(-90)"), "{turned}");
                let inside = turned.split(['(', ')']).nth(1).unwrap();
                let place: Vec<f64> = inside.split(' ').map(|x| x.parse().unwrap()).collect();
                let (x, y) = (place[0], place[1] - start);
                [x - up, y - long, x + down, y]
            }
        };
        Words { words, covers }
    });
    (words.collect(), size)
}

/// What is wrong with the words of a picture, one sentence each; and how many there are.
fn faults(figure: &Figure) -> (Vec<String>, usize) {
    let (words, [width, height]) = words(&svg::standalone(figure));
    let mut faults = Vec::new();
    for (k, a) in words.iter().enumerate() {
        let [left, top, right, bottom] = a.covers;
        if left < 0.0 || top < 0.0 || right > width || bottom > height {
            faults.push(format!(
                "{}: `{}` leaves the paper: {:?} of {width} x {height}",
                figure.id, a.words, a.covers
            ));
        }
        for b in &words[k + 1..] {
            let [l, t, r, d] = b.covers;
            if left < r && l < right && top < d && t < bottom {
                faults.push(format!(
                    "{}: `{}` and `{}` overlap: {:?} and {:?}",
                    figure.id, a.words, b.words, a.covers, b.covers
                ));
            }
        }
    }
    (faults, words.len())
}

/// Every figure of a document and the pages below it, those in tables too.
fn figures(document: &Document, into: &mut Vec<Figure>) {
    for block in &document.blocks {
        match block {
            Block::Figure(figure) => into.push(figure.clone()),
            Block::Table(table) => {
                let pictures = table.rows.iter().flatten().filter_map(|cell| match cell {
                    Cell::Picture(figure) => Some((**figure).clone()),
                    _ => None,
                });
                into.extend(pictures);
            }
            _ => {}
        }
    }
    for page in &document.pages {
        figures(page, into);
    }
}

fn column(engine: &str) -> Configuration {
    Configuration::of(crate::support::find(engine).unwrap())
}

/// Figures of every kind that the program draws, flat and far tables among them.
fn drawn() -> Vec<Figure> {
    let mut found = Vec::new();
    figures(&sample::report(), &mut found);
    let approaching = Configuration {
        setting: Setting::default().with("contact", "approaching-only"),
        ..column("stepper")
    };
    let columns = [column("exact"), approaching];
    for name in [
        "report-break",
        "cradle",
        "oblique",
        "head-on",
        "cushions",
        "discs-in-a-box",
        "table-far-away",
        "lengths-1e6",
        "lengths-1e-6",
        "pool-break",
    ] {
        let scene = catalogue::scene(name).unwrap();
        let outcome = compare::study(&scene, None, &columns, Timing::None, Watch::NONE);
        figures(&carom::page::compare::page(&outcome), &mut found);
    }
    for name in ["report-break", "discs-in-a-box"] {
        let scene = catalogue::scene(name).unwrap();
        let outcome = horizon::study(&scene, Default::default(), &NEVER).unwrap();
        figures(&carom::page::horizon::page(&outcome), &mut found);
    }
    let scene = catalogue::scene("ladder-pockets").unwrap();
    let outcome = effects::study(&scene, &columns, 0.1, Watch::NONE).unwrap();
    figures(&carom::page::effects::page(&outcome), &mut found);
    let outcome = curves::study(&columns, Watch::NONE).unwrap();
    figures(&carom::page::curves::page(&outcome), &mut found);
    let names = ["thin-cut-1e-2", "report-break-frozen", "through-a-ball"];
    let question = stability::Question {
        roster: crate::support::roster().clone(),
        scenes: names.map(|name| catalogue::scene(name).unwrap()).to_vec(),
        presets: columns.to_vec(),
        full: false,
        pictures: true,
    };
    let outcome = stability::study(question, Watch::NONE).unwrap();
    figures(
        &carom::page::stability::page(&outcome, &|_, _| false),
        &mut found,
    );
    found
}

#[test]
fn no_words_of_any_picture_lie_over_others_or_leave_the_paper() {
    let figures = drawn();
    let ids: BTreeSet<&str> = figures.iter().map(|figure| figure.id.as_str()).collect();
    for id in [
        "paths-cradle-exact",
        "growth-report-break",
        "margins-discs-in-a-box",
        "apart-discs-in-a-box",
        "without",
        "ladder",
        "matrix-picture",
        "steps-picture",
        "throw",
    ] {
        assert!(ids.contains(id), "no {id} among {ids:?}");
    }
    let mut all = 0;
    let mut found = Vec::new();
    for figure in &figures {
        let (faults, words) = faults(figure);
        found.extend(faults);
        all += words;
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
    assert!(all > 500, "only {all} words in {} figures", figures.len());
}

/// A table of any shape with a ball on it.
fn table(width: f64, length: f64, far: f64) -> Figure {
    Figure {
        id: "table".into(),
        title: "A table".into(),
        caption: String::new(),
        x: Axis::linear("x", "scaled foot (2.5 x ft)"),
        y: Axis::linear("y", "scaled foot (2.5 x ft)"),
        equal_scale: true,
        outline: Some([[far, far], [far + width, far + length]]),
        series: vec![Series {
            name: "cue ball".into(),
            points: vec![[far + 0.5 * width, far + 0.5 * length]],
            style: Style::Discs(0.1 * width.min(length)),
        }],
        marks: Vec::new(),
    }
}

/// A plot of numbers from `lo` to `hi` along both axes, with marks and a guide.
fn plot(lo: f64, hi: f64, log: bool) -> Figure {
    let axis = |label: &str| match log {
        true => Axis::log(label, "R"),
        false => Axis::linear(label, "R"),
    };
    let line = |name: &str, points: Vec<[f64; 2]>, style: Style| Series {
        name: name.into(),
        points,
        style,
    };
    Figure {
        id: format!("plot-{lo:e}-{hi:e}"),
        x: axis("horizontal"),
        y: axis("vertical"),
        equal_scale: false,
        outline: None,
        series: vec![
            line("a", vec![[lo, lo], [hi, hi]], Style::Line),
            line("order 1", vec![[lo, hi], [hi, lo]], Style::Guide),
            line("order 2", vec![[lo, hi], [hi, lo]], Style::Guide),
        ],
        marks: [lo, hi]
            .map(|at| Mark {
                at,
                label: "here".into(),
            })
            .to_vec(),
        ..table(1.0, 1.0, 0.0)
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn words_stay_apart_on_tables_of_any_shape_and_place(
        width in -6.0..6.0f64, shape in -3.0..3.0f64, far in prop::sample::select(vec![0.0, -3.0, 1e4, -1e8]),
    ) {
        let width = 10f64.powf(width);
        let figure = table(width, width * 10f64.powf(shape), far);
        let (faults, words) = faults(&figure);
        prop_assert!(faults.is_empty(), "{}", faults.join("\n"));
        // both axes have a name and a number, or nothing could be read off
        prop_assert!(words >= 4, "{} words", words);
    }

    #[test]
    fn words_stay_apart_along_axes_of_any_range(lo in -12.0..9.0f64, decades in 0.0..24.0f64, log in any::<bool>()) {
        let lo = 10f64.powf(lo);
        let hi = lo * 10f64.powf(decades);
        let (faults, words) = faults(&plot(lo, hi, log));
        prop_assert!(faults.is_empty(), "{}", faults.join("\n"));
        prop_assert!(words >= 4, "{} words", words);
    }
}

/// Series of these styles, each style with the same points for all names.
fn alike(count: usize, styles: &[Style]) -> Figure {
    let series = (0..count).flat_map(|k| {
        styles.iter().map(move |style| Series {
            name: format!("series {k}"),
            points: vec![[0.0, 0.0], [0.5, 0.5], [1.0, 1.0]],
            style: *style,
        })
    });
    Figure {
        series: series.collect(),
        ..plot(0.0, 1.0, false)
    }
}

/// How each name is drawn, colour and width taken away.
fn looks(figure: &Figure) -> Vec<String> {
    let svg = svg::standalone(figure);
    let document = roxmltree::Document::parse(&svg).unwrap();
    let groups = document.root_element().children();
    let groups = groups.filter(|node| node.has_tag_name("g"));
    let mut looks: Vec<(String, String)> = Vec::new();
    for group in groups {
        let class = group.attribute("class").unwrap().to_owned();
        // a sample in the legend is followed by its name
        let next = group.next_sibling_element();
        if next.is_some_and(|next| next.has_tag_name("text") && !class.starts_with('t')) {
            continue;
        }
        let shapes = group.children().map(|shape| {
            let attributes = shape.attributes();
            let kept = attributes.filter(|a| !["class", "stroke-width"].contains(&a.name()));
            let kept: Vec<String> = kept
                .map(|a| format!("{}={}", a.name(), a.value()))
                .collect();
            kept.join(" ")
        });
        looks.push((class, shapes.collect::<Vec<_>>().join("|")));
    }
    looks.into_iter().map(|(_, look)| look).collect()
}

#[test]
fn series_can_be_told_apart_without_colour() {
    for (count, styles, why) in [
        (6, &[Style::Line][..], "six kinds of dashes"),
        (10, &[Style::Points], "ten kinds of points"),
        (
            12,
            &[Style::Line],
            "dashes and signs together, of which the signs are ten",
        ),
    ] {
        let looks = looks(&alike(count, styles));
        assert_eq!(looks.len(), count, "{why}");
        let distinct: BTreeSet<&String> = looks.iter().collect();
        assert_eq!(distinct.len(), count, "{why}: {looks:#?}");
    }
    // lines with their points: two groups a name, and thirty pairs
    let looks = looks(&alike(30, &[Style::Line, Style::Points]));
    let pairs: Vec<String> = looks.chunks(2).map(|pair| pair.join(" ")).collect();
    assert_eq!(pairs.len(), 30);
    assert_eq!(
        pairs.iter().collect::<BTreeSet<_>>().len(),
        30,
        "{pairs:#?}"
    );
}

#[test]
fn fields_of_a_matrix_can_be_told_apart_without_colour() {
    let field = |style: Style| Figure {
        x: Axis::of_names("", vec!["engine".into()]),
        y: Axis::of_names("", vec!["scene".into()]),
        series: vec![Series {
            name: "verdict".into(),
            points: vec![[1.0, 1.0]],
            style,
        }],
        marks: Vec::new(),
        ..plot(0.0, 1.0, false)
    };
    let signs: BTreeSet<String> = SIGNS
        .iter()
        .map(|sign| {
            let figure = field(Style::Tiles(*sign));
            let svg = svg::standalone(&figure);
            // the last one is in the plot, its fellow in the legend
            svg.split("class=\"i\" d=\"").last().unwrap().to_owned()
        })
        .collect();
    assert_eq!(signs.len(), SIGNS.len());
}

#[test]
fn a_list_of_words_is_read_from_the_top_down_and_its_words_are_in_the_data() {
    let figure = Figure {
        x: Axis::log("change", "R"),
        y: Axis::of_names("left out", vec!["throw".into(), "spin".into()]),
        series: vec![Series {
            name: "exact".into(),
            points: vec![[1.0, 1.0], [10.0, 2.0]],
            style: Style::Points,
        }],
        marks: Vec::new(),
        ..plot(1.0, 10.0, true)
    };
    let (words, _) = words(&svg::standalone(&figure));
    let top = |name: &str| {
        let found = words.iter().find(|w| w.words == name);
        found.unwrap_or_else(|| panic!("no {name}")).covers[1]
    };
    assert!(top("throw") < top("spin"));
    assert_eq!(
        report::csv::figure(&figure),
        "series,x,y\nexact,1,throw\nexact,10,spin\n"
    );
}
