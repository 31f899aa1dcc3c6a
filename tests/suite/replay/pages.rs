//! The pages of a report: what they weigh, what they may load and run, and whose numbers they show.

use super::{compared, scene};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use carom::finding::{Block, Document};
use carom::page::compare::LengthUnit;
use carom::report;
use carom::scene::{SetName, catalogue};
use carom::study::compare::ComparisonOutcome;
use serde_json::Value;
use sha2::{Digest, Sha256};

/// What a page may weigh, bytes.
const MOST: usize = 1_500_000;

/// The page of a comparison in a report that has nothing else.
fn page_of(outcome: &ComparisonOutcome) -> String {
    let document = Document {
        stopped_early: None,
        id: "index".to_owned(),
        title: "a report".to_owned(),
        pages: vec![carom::page::compare::page(outcome)],
        ..Document::default()
    };
    let site = report::site(&document);
    let page = site
        .into_iter()
        .find(|(path, _)| path.starts_with("pages/"));
    page.expect("the page of the scene").1
}

/// The text between two others.
fn between<'a>(text: &'a str, from: &str, to: &str) -> &'a str {
    let rest = text
        .split_once(from)
        .unwrap_or_else(|| panic!("no `{from}`"))
        .1;
    rest.split_once(to)
        .unwrap_or_else(|| panic!("no `{to}` after `{from}`"))
        .0
}

fn hash(text: &str) -> String {
    format!(
        "'sha256-{}'",
        STANDARD.encode(Sha256::digest(text.as_bytes()))
    )
}

/// The replay's data in a page.
fn data(page: &str) -> Value {
    let text = between(page, "class=\"replay-data\">", "</script>");
    serde_json::from_str(text).unwrap()
}

/// Every scene of the default report, and those of the catalogue whose replays are the largest.
#[test]
fn a_page_of_every_kind_plays_and_weighs_less_than_one_and_a_half_megabytes() {
    let mut scenes = catalogue::set(SetName::Report).unwrap();
    let default = scenes.len();
    scenes.extend(["throw", "report-break-tight", "rack-lossy", "galperin-314"].map(scene));
    assert!(default > 10, "only {default} scenes in the report");
    for scene in scenes {
        let page = page_of(&compared(&scene, None));
        let name = &scene.name;
        assert!(page.len() < MOST, "{name}: {} bytes", page.len());
        assert_eq!(
            page.matches("<div class=\"replay\"").count(),
            1,
            "{name} has no replay"
        );
        assert_eq!(data(&page)["scene"]["name"], name.as_str());
        for foreign in [
            "http:",
            "https:",
            " src=",
            "@import",
            "url(",
            " style=\"",
            " onclick",
        ] {
            let own = page.replace(include_str!("../../../src/client/dist/replay.js"), "");
            assert!(!own.contains(foreign), "{name} has `{foreign}`");
        }
    }
}

#[test]
fn a_page_runs_only_the_script_and_wears_only_the_style_that_its_policy_names() {
    let outcome = compared(&scene("head-on"), None);
    let with = page_of(&outcome);
    let mut document = carom::page::compare::page(&outcome);
    document
        .blocks
        .retain(|block| !matches!(block, Block::Replay(_)));
    let without = report::site(&document).pop().unwrap().1;
    for (page, scripts) in [(&with, 1), (&without, 0)] {
        let policy = between(page, "Content-Security-Policy\" content=\"", "\"");
        assert!(policy.starts_with("default-src 'none';"), "{policy}");
        assert!(!policy.contains("unsafe"), "{policy}");
        assert_eq!(page.matches("<style>").count(), 1);
        let style = hash(between(page, "<style>", "</style>"));
        assert!(
            policy.contains(&format!("style-src {style};")),
            "{policy} lacks {style}"
        );
        assert_eq!(
            page.matches("<script>").count(),
            scripts,
            "scripts that run"
        );
        assert_eq!(
            page.matches("<script").count(),
            2 * scripts,
            "scripts, and data"
        );
        if scripts > 0 {
            let script = between(page, "<script>", "</script>");
            assert!(
                policy.contains(&format!("script-src {};", hash(script))),
                "{policy}"
            );
            assert_eq!(script, include_str!("../../../src/client/dist/replay.js"));
        } else {
            assert!(!policy.contains("script-src"), "{policy}");
        }
    }
}

#[test]
fn words_in_a_replay_cannot_end_its_element() {
    let mut outcome = compared(&scene("head-on"), Some("exact"));
    let evil = "</script><script>alert(1)</script><!--";
    outcome.scene.balls[0].id = evil.to_owned();
    outcome.scene.units.length = evil.to_owned();
    let page = page_of(&outcome);
    assert_eq!(data(&page)["balls"][0]["id"], evil);
    assert_eq!(
        page.matches("<script").count(),
        2,
        "the data and the one script"
    );
    assert!(!page.contains("alert(1)</script>"));
}

/// The first screen shows what `compare --format json` says: each number to the digits shown.
#[test]
fn a_page_shows_the_numbers_of_compare() {
    let mut numbers = 0;
    for name in ["report-break", "discs-in-a-box", "report-break-frozen"] {
        let outcome = compared(&scene(name), None);
        let page = page_of(&outcome);
        let summary = carom::page::compare::summary(&outcome, LengthUnit::Radius);
        let json: Value = serde_json::from_str(&report::json::write(&summary)).unwrap();
        let tables = &json["tables"];
        let rows = match outcome.reference {
            Some(_) => tables["comparison"]["rows"].as_array().unwrap(),
            None => tables["pairs"]["rows"].as_array().unwrap(),
        };
        let first = between(&page, "id=\"divergences\"", "</table>");
        for row in rows {
            let label = row["engine"].as_str().or(row["pair"].as_str()).unwrap();
            let Some(shown) = first
                .split("<tr>")
                .find(|line| line.contains(&format!(">{label}</th>")))
            else {
                assert!(label.ends_with("(reference)"), "{name}: no row of {label}");
                continue;
            };
            assert!(
                shown.contains(row["order-strict"].as_str().unwrap()),
                "{name}: {label}"
            );
            for key in ["stop-time", "final-position"] {
                let Some(exact) = row[key].as_f64() else {
                    continue;
                };
                let three = format!("{exact:.2e}");
                let digits: f64 = three.parse().unwrap();
                let owner = row[format!("{key}-owner")].as_str().unwrap();
                let found = shown.split("<td").filter_map(|cell| {
                    let cell = cell.split_once('>')?.1;
                    let (number, rest) = cell.split_once(' ')?;
                    rest.contains(&format!("({owner})"))
                        .then(|| number.parse::<f64>().ok())?
                });
                // the decimal shown is the same one, however it is written
                assert!(
                    found.clone().any(|number| number == digits),
                    "{name}: {label} has {key} {three}, its row {:?}",
                    found.collect::<Vec<_>>()
                );
                numbers += 1;
            }
        }
        // the time to which the replay jumps is that of the first difference, to the digits that the table has
        let jump = data(&page)["partings"][0]["time"].as_f64().unwrap();
        let differences = tables["first-difference"]["rows"].as_array().unwrap();
        let at = format!(" at {jump:.7} s");
        assert!(
            differences.iter().any(|row| {
                ["reference", "engine-has"]
                    .iter()
                    .any(|key| row[key].as_str().unwrap().ends_with(&at))
            }),
            "{name}: no difference{at}"
        );
    }
    assert!(numbers > 20, "only {numbers}");
}

#[test]
fn a_shot_in_which_nobody_parts_has_no_picture_of_a_parting() {
    for (name, parts) in [
        ("report-break", true),
        ("discs-in-a-box", true),
        ("head-on", false),
    ] {
        let document = carom::page::compare::page(&compared(&scene(name), None));
        let id = format!("parting-{name}");
        let figure = document.blocks.iter().find_map(|block| match block {
            Block::Figure(figure) if figure.id == id => Some(figure),
            _ => None,
        });
        assert_eq!(figure.is_some(), parts, "{name}");
        let Some(figure) = figure else { continue };
        let contacts = figure
            .series
            .iter()
            .filter(|series| series.name == "contact")
            .count();
        assert!(
            contacts >= 2,
            "{name}: {contacts} versions of who meets whom"
        );
    }
}

#[test]
fn a_fragment_links_to_no_file_and_has_every_table() {
    let outcome = compared(&scene("head-on"), Some("stepper"));
    let fragment =
        report::html::fragment(&carom::page::compare::summary(&outcome, LengthUnit::Radius));
    assert!(!fragment.contains("href="), "{fragment}");
    assert!(fragment.contains("class=\"lead\"") && fragment.contains("id=\"comparison\""));
    assert!(!fragment.contains("<html") && !fragment.contains("<script"));
}

#[test]
fn too_much_for_a_page_is_said_on_the_page() {
    let outcome = compared(&scene("discs-in-a-box"), Some("exact"));
    let mut document = carom::page::compare::page(&outcome);
    for block in &mut document.blocks {
        if let Block::Replay(replay) = block {
            let event = replay.runs[0].events[0].clone();
            replay.runs[0].events = vec![event; 20_000];
        }
    }
    let page = report::site(&document).pop().unwrap().1;
    assert!(page.contains("There is no replay: its "), "nothing is said");
    assert!(!page.contains("<script"));
}
