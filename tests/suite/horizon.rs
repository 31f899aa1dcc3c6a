//! What `carom horizon` says: the sentence, the tables, and that they agree with what the engine found.

use carom::engine::Refusal;
use carom::finding::{Block, Cell, Document, Figure, Table};
use carom::oracle::Precision;
use carom::scene::generate::{Recipe, generate};
use carom::scene::{Scene, catalogue, parse};
use carom::study::horizon::study;
use std::sync::atomic::AtomicBool;

static NEVER: AtomicBool = AtomicBool::new(false);

fn page(name: &str, precision: Precision) -> Document {
    let outcome = study(&catalogue::scene(name).unwrap(), precision, &NEVER);
    carom::page::horizon::page(&outcome.unwrap())
}

fn table<'a>(document: &'a Document, id: &str) -> &'a Table {
    let tables = document.blocks.iter().filter_map(|block| match block {
        Block::Table(table) => Some(table),
        _ => None,
    });
    let mut found = tables.filter(|table| table.id == id);
    found.next().unwrap_or_else(|| panic!("no table {id}"))
}

fn texts(document: &Document) -> String {
    let text = |block: &Block| match block {
        Block::Text(text) => text.clone(),
        _ => String::new(),
    };
    document.blocks.iter().map(text).collect()
}

#[test]
fn a_whole_shot_is_said_to_be_whole() {
    let document = page("report-break", Precision::F64);
    let lead = &document.lead;
    assert!(
        lead.starts_with("f64 is right about the whole shot: all 38 events."),
        "{lead}"
    );
    let events = table(&document, "events");
    assert_eq!(events.rows.len(), 38);
    // every row has a time, an error and a growth; a whole shot needs no column for the horizon
    assert!(events.columns.iter().all(|column| column.key != "horizon"));
    assert!(
        events
            .rows
            .iter()
            .all(|row| matches!(row[5], Cell::Number(error) if error > 0.0))
    );
    assert!(
        texts(&document).contains("matters most"),
        "{}",
        texts(&document)
    );
    // aim, speed, mu and both restitutions, for each of 16 balls
    let influences = table(&document, "influences");
    assert_eq!((influences.rows.len(), influences.columns.len()), (16, 6));
}

#[test]
fn a_chaotic_run_has_a_horizon_and_its_rows_say_which_side_they_are_on() {
    let document = page("discs-in-a-box", Precision::F64);
    assert!(
        document.lead.contains("f64 is right up to event"),
        "{}",
        document.lead
    );
    let events = table(&document, "events");
    let place = events
        .columns
        .iter()
        .position(|column| column.key == "horizon")
        .unwrap();
    let within = |row: &&Vec<Cell>| row[place] == Cell::text("within");
    let count = events.rows.iter().take_while(within).count();
    // the reference demands 50 events of an f64 program within 1e-8; ours is a band of 1e-9
    assert!(
        (45..60).contains(&count),
        "{count} events within the horizon"
    );
    assert!(
        events.rows[count..]
            .iter()
            .all(|row| row[place] == Cell::text("beyond"))
    );
    assert!(
        texts(&document).contains("at the horizon"),
        "{}",
        texts(&document)
    );
}

#[test]
fn what_has_no_derivative_or_no_answer_is_said() {
    let reflected = page("cradle-reflections", Precision::F64);
    assert!(reflected.lead.contains("whole shot"), "{}", reflected.lead);
    assert!(
        reflected.lead.contains("a convention resolved"),
        "{}",
        reflected.lead
    );
    assert!(texts(&reflected).contains("no derivative"));
    let refused = page("report-break-frozen", Precision::F64);
    assert!(
        refused.lead.contains("ends as indeterminate"),
        "{}",
        refused.lead
    );
}

#[test]
fn a_precision_without_a_witness_and_too_many_balls_are_refused() {
    let scene = catalogue::scene("slide").unwrap();
    let crowd: Scene = {
        let recipe = Recipe {
            balls: 1001,
            ..Recipe::default()
        };
        parse("crowd.toml", &generate(&recipe).unwrap()).unwrap()
    };
    for (scene, precision) in [
        (&scene, Precision::F256),
        (&scene, Precision::Auto),
        (&crowd, Precision::F64),
    ] {
        let refusal = study(scene, precision, &NEVER).unwrap_err();
        let Refusal::Setting { message, .. } = refusal else {
            panic!("{refusal:?}");
        };
        assert!(message.contains("at most 1000 balls"), "{message}");
    }
}

fn figure<'a>(document: &'a Document, id: &str) -> &'a Figure {
    let figures = document.blocks.iter().filter_map(|block| match block {
        Block::Figure(figure) => Some(figure),
        _ => None,
    });
    let mut found = figures.filter(|figure| figure.id == id);
    found.next().unwrap_or_else(|| panic!("no figure {id}"))
}

#[test]
fn the_pictures_show_what_the_table_of_events_has_and_mark_the_horizon() {
    let document = page("discs-in-a-box", Precision::F64);
    let events = table(&document, "events");
    let place = |key: &str| events.columns.iter().position(|c| c.key == key).unwrap();
    let numbers = |key: &str| -> Vec<Option<f64>> {
        let cells = events.rows.iter().map(|row| match row[place(key)] {
            Cell::Number(x) | Cell::Fixed(x, _) => Some(x),
            _ => None,
        });
        cells.collect()
    };
    let (times, growth, margins) = (numbers("time"), numbers("growth"), numbers("margin"));
    let shown = figure(&document, "growth-discs-in-a-box");
    assert!(shown.y.log && times.len() > 100);
    let expected: Vec<[f64; 2]> = times
        .iter()
        .zip(&growth)
        .map(|(time, growth)| [time.unwrap(), growth.unwrap()])
        .collect();
    assert_eq!(shown.series[0].points, expected);
    let shown = figure(&document, "margins-discs-in-a-box");
    let expected: Vec<[f64; 2]> = margins
        .iter()
        .enumerate()
        .filter_map(|(k, margin)| Some([k as f64 + 1.0, margin.filter(|m| *m > 0.0)?]))
        .collect();
    assert_eq!(shown.series[0].points, expected);
    // the horizon lies between the last event within it and the first beyond
    let within = events
        .rows
        .iter()
        .filter(|row| row[place("horizon")] == Cell::text("within"))
        .count();
    for (id, least, most) in [
        ("growth", times[within - 1].unwrap(), times[within].unwrap()),
        ("margins", within as f64, within as f64 + 1.0),
        ("apart", within as f64, within as f64 + 1.0),
    ] {
        let shown = figure(&document, &format!("{id}-discs-in-a-box"));
        let [mark] = &shown.marks[..] else {
            panic!("{id}: {:?}", shown.marks);
        };
        assert_eq!(mark.label, "horizon");
        assert!(least < mark.at && mark.at <= most, "{id}: {}", mark.at);
    }
    // a whole shot has none
    let whole = page("report-break", Precision::F64);
    assert!(figure(&whole, "growth-report-break").marks.is_empty());
}
