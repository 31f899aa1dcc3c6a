//! What a newcomer gets who has written a `World` and adds it to the roster: every study, without a line anywhere else.
//!
//! The engine is in `discs.rs`; nothing but this folder knows it. The same with friction along each axis by itself must be found out.

mod discs;

use crate::contract::hold_contract;
use carom::engine::{Refusal, Roster, Setting, prepare};
use carom::finding::{Finding, Verdict};
use carom::gate::{Accepted, Held, Row};
use carom::scene::{Scene, catalogue};
use carom::study::cost::{self, Grid};
use carom::study::stability::{self, Question};
use carom::study::{Configuration, Timing, Watch, check, compare, validation};
use carom::trace::{Counter, Record};
use carom::web::{self, Request, Site, Turn, Turns};
use std::sync::atomic::AtomicBool;

static NEVER: AtomicBool = AtomicBool::new(false);

const ID: &str = "discs";

fn right() -> Roster {
    let discs = discs::along_the_motion();
    Roster::built_in().with(discs).unwrap()
}

fn wrong() -> Roster {
    let discs = discs::along_each_axis();
    Roster::built_in().with(discs).unwrap()
}

/// The newcomer's column.
fn column(roster: &Roster) -> Configuration {
    Configuration::of(roster.find(ID).unwrap())
}

fn scene(name: &str) -> Scene {
    catalogue::scene(name).unwrap()
}

#[test]
fn an_engine_is_at_most_120_lines_and_names_nothing_of_a_built_in_one() {
    let source = include_str!("discs.rs");
    let lines = source.lines().count();
    assert!(lines <= 120, "{lines} lines");
    for engine in &Roster::built_in() {
        assert!(!source.contains(engine.id()), "{}", engine.id());
    }
    let twice = right().with(discs::along_the_motion()).unwrap_err();
    assert_eq!(
        twice.to_string(),
        "there is an engine called `discs` already"
    );
}

#[test]
fn it_keeps_the_contract() {
    hold_contract(&right(), &[]);
}

#[test]
fn it_is_compared_and_its_order_is_that_of_the_exact_engine() {
    let roster = right();
    let columns = compare::plan(&roster, &compare::default_columns(&roster));
    assert!(columns.iter().any(|column| column.label() == ID));
    let named = [columns[0].clone(), column(&roster)];
    for name in ["head-on", "oblique"] {
        let outcome = compare::study(&scene(name), None, &named, Timing::None, Watch::NONE);
        let entry = &outcome.entries[1];
        let standing = entry.standing.as_ref().unwrap();
        assert!(
            standing.order.parting.is_none(),
            "{name}: {:?}",
            standing.order
        );
        // first order: some steps' worth of the fastest ball's way
        let error = standing.final_position.unwrap();
        assert!(error < 1.0, "{name}: {error} R");
        assert_eq!(entry.trace().unwrap().count(Counter::Unattributed), Some(0));
        let unexplained = entry.trace().unwrap().unexplained();
        assert!(unexplained < 0.1, "{name}: {unexplained}");
    }
}

#[test]
fn its_errors_fall_with_its_step() {
    let roster = right();
    let named = [column(&roster)];
    let outcome = cost::study(&roster, &scene("oblique"), &named, Grid::Small, Watch::NONE);
    assert_eq!(outcome.families.len(), 1);
    let family = &outcome.families[0];
    let verdict = family.verdict.as_ref().unwrap();
    assert_eq!(verdict.kind, cost::Kind::Converging, "{verdict:?}");
    assert!(family.points.iter().all(|point| point.timed.is_some()));
}

fn hard(roster: &Roster, names: &[&str]) -> stability::StabilityOutcome {
    let question = Question {
        roster: roster.clone(),
        scenes: names.iter().map(|name| scene(name)).collect(),
        presets: vec![column(roster)],
        full: false,
        pictures: false,
    };
    stability::study(question, Watch::NONE).unwrap()
}

fn verdict(outcome: &stability::StabilityOutcome, scene: usize, label: &str) -> Verdict {
    let mut cases = outcome.of_scene(scene);
    let case = cases.find(|case| case.planned.column.label() == label);
    case.unwrap().judged.as_ref().unwrap().verdict
}

#[test]
fn hard_cases_run_in_it_with_every_step_and_hold() {
    let roster = right();
    let presets = stability::presets(&roster);
    assert!(presets.iter().any(|preset| preset.label() == ID));
    let outcome = hard(
        &roster,
        &["diagonal-slide-30", "cradle-gap-1e-2", "thin-cut-1e-2"],
    );
    assert_eq!(outcome.broken_promises(), [""; 0]);
    for scene in 0..3 {
        let verdict = verdict(&outcome, scene, ID);
        assert_ne!(verdict, Verdict::CannotExpress, "{scene}");
        assert_ne!(verdict, Verdict::Breaks, "{scene}");
        let labels: Vec<String> = (outcome.of_scene(scene))
            .map(|case| case.planned.column.label())
            .collect();
        assert!(labels.contains(&"discs dt=1e-1".to_owned()), "{labels:?}");
    }
}

#[test]
fn friction_along_each_axis_is_found_out_by_the_diagonal_slides() {
    let slides = ["diagonal-slide-30", "diagonal-slide-45"];
    let (good, bad) = (hard(&right(), &slides), hard(&wrong(), &slides));
    for (k, name) in slides.iter().enumerate() {
        assert_eq!(verdict(&good, k, ID), Verdict::Holds, "{name}");
        let found = verdict(&bad, k, ID);
        assert!(
            found > Verdict::Holds && found != Verdict::Indeterminate,
            "{name}: {found:?}"
        );
    }
}

/// The gate's findings of the newcomer in some scenes.
fn checked(roster: &Roster, names: &[&str]) -> check::CheckOutcome {
    let scenes: Vec<Scene> = names.iter().map(|name| scene(name)).collect();
    check::study(roster, &scenes, &[column(roster)], Watch::NONE).unwrap()
}

#[test]
fn the_gate_holds_it_and_finds_out_friction_along_each_axis() {
    let scenes = ["oblique", "slide", "head-on"];
    let accepted: Vec<Option<Accepted>> = {
        let outcome = checked(&right(), &scenes);
        assert_eq!(outcome.missing(), 0);
        assert!(outcome.broken.is_empty(), "{:?}", outcome.broken);
        let accepted = |scene: &Scene| Accepted {
            scene: scene.name.clone(),
            hash: scene.hash(),
            reason: "for a test".to_owned(),
            versions: Vec::new(),
            bits: Vec::new(),
            rows: outcome.of_scene(&scene.name).map(Row::from).collect(),
        };
        outcome.scenes.iter().map(|s| Some(accepted(s))).collect()
    };
    let held = Held::new(checked(&right(), &scenes), accepted.clone(), Vec::new());
    assert!(held.changes.is_empty(), "{:?}", held.changes);
    let held = Held::new(checked(&wrong(), &scenes), accepted, Vec::new());
    let changed: Vec<&str> = held.changes.iter().map(|l| l.scene.as_str()).collect();
    assert!(changed.contains(&"oblique") && changed.contains(&"slide"));
    // along an axis both are the same
    assert!(!changed.contains(&"head-on"), "{changed:?}");
}

#[test]
fn a_report_shows_it_and_says_what_it_is() {
    let roster = right();
    let columns = compare::plan(&roster, &[column(&roster)]);
    let scenes = [scene("head-on")];
    let outcome = validation::study(&roster, &scenes, &columns, Watch::NONE).unwrap();
    let report = carom::page::validation::page(&roster, &outcome, &[]);
    let pages = carom::report::site(&report);
    let (_, index) = pages.iter().find(|(name, _)| name == "index.html").unwrap();
    assert!(
        index.contains("discs") && index.contains("Fixed steps."),
        "{index}"
    );
}

/// Runs at once.
struct AtOnce;

impl Turns for AtOnce {
    fn take(&self, run: &mut dyn FnMut(&AtomicBool)) -> Turn {
        run(&NEVER);
        Turn::Done
    }
}

#[test]
fn the_live_page_offers_it_runs_it_and_names_its_step_where_that_is_wrong() {
    let site = Site {
        port: 4147,
        start: catalogue::find("head-on").unwrap().text.to_owned(),
        roster: right(),
    };
    let ask = |body: &str| {
        let headers = [
            ("Host", "127.0.0.1:4147"),
            ("Content-Type", "application/json"),
        ];
        let request = Request {
            method: "POST".to_owned(),
            path: "/shot".to_owned(),
            query: String::new(),
            headers: headers.map(|(n, v)| (n.to_owned(), v.to_owned())).to_vec(),
            body: body.as_bytes().to_vec(),
        };
        let response = web::handle(&request, &site, &AtOnce);
        (response.status, String::from_utf8(response.body).unwrap())
    };
    let (status, body) = ask(r#"{"fields": {"engine": ["exact", "discs"]}}"#);
    assert_eq!(status, 200, "{body}");
    assert!(body.contains("step of discs"), "{body}");
    let (status, body) = ask(r#"{"fields": {"engine": ["discs"], "dt.discs": "0"}}"#);
    assert_eq!(status, 400, "{body}");
    assert!(body.contains("\"dt.discs\""), "{body}");
}

#[test]
fn what_it_lacks_is_refused_and_what_it_cannot_read_names_the_key() {
    let roster = right();
    let discs = roster.find(ID).unwrap().as_ref();
    let refused = prepare(discs, &scene("draw"), &Setting::default()).err();
    assert!(
        matches!(refused, Some(Refusal::NotComparable { .. })),
        "{refused:?}"
    );
    for (pair, wanted) in [("dt=0", "dt"), ("dt=x", "dt"), ("h=1", "h")] {
        let setting = Setting::parse([pair]).unwrap();
        let refused = prepare(discs, &scene("slide"), &setting).err();
        match refused {
            Some(Refusal::Setting { key, .. }) => assert_eq!(key.as_deref(), Some(wanted)),
            other => panic!("{pair}: {other:?}"),
        }
    }
    let slide = scene("slide");
    let run = prepare(discs, &slide, &Setting::default()).unwrap();
    let trace = run.simulate(Record::Final, &carom::engine::Limits::NONE);
    assert_eq!(trace.provenance.ulp, f64::EPSILON);
}

#[test]
fn findings_of_it_bear_its_label() {
    let outcome = checked(&right(), &["slide"]);
    let own = |finding: &&Finding| finding.engine == ID;
    assert!(outcome.of_scene("slide").filter(own).count() > 5);
}

#[test]
fn programs_that_use_the_library_are_under_forty_lines() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("validation/examples");
    let manifest = include_str!("../../../Cargo.toml");
    let mut programs = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let lines = std::fs::read_to_string(&path).unwrap().lines().count();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        assert!(lines < 40, "{name}: {lines} lines");
        assert!(
            manifest.contains(&format!("path = \"validation/examples/{name}\"")),
            "{name}"
        );
        programs += 1;
    }
    assert_eq!(programs, 3);
}
