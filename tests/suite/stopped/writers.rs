//! Where a document says that it was stopped early: first, in every format and on every page; and what a trace's files say.

use super::STOPPED;
use carom::engine::{Limits, prepare};
use carom::finding::{Block, Column, Document, Table};
use carom::report::{FORMATS, render, site};
use carom::scene::catalogue;
use carom::trace::files::{read, write};
use carom::trace::{Ending, Record, Trace};
use serde_json::Value;
use std::sync::atomic::AtomicBool;

fn page(id: &str, below: Vec<Document>) -> Document {
    let table = Table {
        id: "numbers".to_owned(),
        columns: vec![Column::words("what", "what")],
        ..Table::default()
    };
    Document {
        id: id.to_owned(),
        title: format!("Title of {id}"),
        lead: "What was found.".to_owned(),
        blocks: vec![Block::Table(table)],
        pages: below,
        ..Document::default()
    }
}

fn stopped() -> Document {
    let deep = page("deep", vec![page("deeper", Vec::new())]);
    Document {
        stopped_early: Some(format!("This was {STOPPED}: 1 of 2 <things> & no more.")),
        ..page("index", vec![deep])
    }
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap()
}

#[test]
fn every_format_says_it_first_and_says_nothing_of_it_otherwise() {
    for format in FORMATS {
        let said = render(&stopped(), format.id).unwrap();
        match format.id {
            // rows and columns only; the program says it on stderr
            "csv" => assert!(!said.contains(STOPPED), "{said}"),
            "json" => {
                let json: Value = serde_json::from_str(&said).unwrap();
                let (key, value) = json.as_object().unwrap().iter().next().unwrap();
                assert_eq!(key, "stopped_early");
                assert!(value.as_str().unwrap().contains(STOPPED), "{value}");
            }
            id => assert!(first_line(&said).contains(STOPPED), "{id}: {said}"),
        }
        let whole = Document {
            stopped_early: None,
            ..stopped()
        };
        let whole = render(&whole, format.id).unwrap();
        let words = whole.replace('_', " ");
        assert!(!words.contains(STOPPED), "{}: {whole}", format.id);
    }
}

#[test]
fn every_page_of_a_report_says_it_before_its_title() {
    let files = site(&stopped());
    let mut pages = 0;
    for (path, text) in &files {
        if path.ends_with(".html") {
            pages += 1;
            let main = text.split_once("<main id=\"main\">\n").unwrap().1;
            let first = first_line(main);
            assert!(first.contains(STOPPED), "{path}: {first}");
            assert!(first.contains("&lt;things&gt; &amp; no more"), "{first}");
        }
        if path == "report.md" {
            assert!(first_line(text).contains(STOPPED), "{text}");
        }
        if path == "report.json" {
            let json: Value = serde_json::from_str(text).unwrap();
            assert!(json["stopped_early"].is_string(), "{text}");
        }
    }
    assert_eq!(pages, 3);
    let whole = Document {
        stopped_early: None,
        ..stopped()
    };
    for (path, text) in site(&whole) {
        assert!(!text.contains(STOPPED), "{path}");
    }
}

fn traced(engine: &str, stop: bool) -> Trace {
    let scene = catalogue::scene("head-on").unwrap();
    let stop = AtomicBool::new(stop);
    let limits = Limits {
        cancelled: &stop,
        ..Limits::NONE
    };
    let run = prepare(
        crate::support::find(engine).unwrap().as_ref(),
        &scene,
        &Default::default(),
    )
    .unwrap();
    run.simulate(Record::Every(0.01), &limits)
}

#[test]
fn the_files_of_a_run_say_whether_it_was_stopped_and_never_otherwise() {
    for engine in ["exact", "stepper", "rapier-f64"] {
        let cut = traced(engine, true);
        assert_eq!(cut.ending, Ending::Cancelled, "{engine}");
        let files = write(&cut).unwrap();
        let json: Value = serde_json::from_str(&files.run).unwrap();
        assert_eq!(json["stopped_early"], true, "{engine}");
        assert_eq!(read(&files).unwrap(), cut, "{engine}");
        // files of a version that did not say so
        let mut silent = files.clone();
        silent.run = files.run.replacen("\"stopped_early\": true,", "", 1);
        assert_eq!(read(&silent).unwrap(), cut, "{engine}");

        let files = write(&traced(engine, false)).unwrap();
        assert!(!files.run.contains("stopped_early"), "{}", files.run);
        let mut false_alarm = files.clone();
        false_alarm.run = files.run.replacen('{', "{ \"stopped_early\": true,", 1);
        let error = read(&false_alarm).unwrap_err().to_string();
        assert!(error.contains("`stopped_early`"), "{error}");
    }
}
