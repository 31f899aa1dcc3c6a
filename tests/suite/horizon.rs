//! What `carom horizon` says: the sentence, the tables, and that they agree with what the engine found.

use carom::engine::Refusal;
use carom::engine::exact::Precision;
use carom::finding::{Block, Cell, Document, Table};
use carom::scene::generate::{Recipe, generate};
use carom::scene::{Scene, catalogue, parse};
use carom::study::horizon::study;
use std::sync::atomic::AtomicBool;

static NEVER: AtomicBool = AtomicBool::new(false);

fn page(name: &str, precision: Precision) -> Document {
    study(&catalogue::scene(name).unwrap(), precision, &NEVER).unwrap()
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
        let Refusal::Setting { message } = refusal else {
            panic!("{refusal:?}");
        };
        assert!(message.contains("at most 1000 balls"), "{message}");
    }
}
