//! `carom cost`: what accuracy costs, how errors fall, and which setting holds them where they do not.

use crate::support::scenario;
use assert_cmd::Command;
use carom::engine::Setting;
use carom::finding::{Block, Cell, Document, Table};
use carom::page::cost::{listing, page, summary};
use carom::scene::{Scene, catalogue};
use carom::study::cost::{
    CostOutcome, Grid, Kind, Measured, Offer, PriceList, Quantity, THRESHOLDS, front, offers, study,
};
use carom::study::{Configuration, Watch};
use std::process::Output;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

fn of(engines: &[&str], scene: &Scene) -> CostOutcome {
    let column = |id: &&str| Configuration::of(crate::support::find(id).unwrap());
    let named: Vec<Configuration> = engines.iter().map(column).collect();
    study(
        crate::support::roster(),
        scene,
        &named,
        Grid::Small,
        Watch::NONE,
    )
}

fn family<'a>(outcome: &'a CostOutcome, label: &str) -> &'a Measured {
    let mut families = outcome.families.iter();
    let found = families.find(|measured| measured.family.label() == label);
    found.unwrap_or_else(|| panic!("no family {label}"))
}

fn table<'a>(document: &'a Document, id: &str) -> &'a Table {
    let mut tables = document.blocks.iter().filter_map(|block| match block {
        Block::Table(table) => Some(table),
        _ => None,
    });
    tables
        .find(|table| table.id == id)
        .unwrap_or_else(|| panic!("no table {id}"))
}

fn column(table: &Table, key: &str) -> usize {
    let place = table.columns.iter().position(|column| column.key == key);
    place.unwrap_or_else(|| panic!("no column {key}"))
}

/// One ball that slides into another off centre, on a cloth so rough that all is over in a third of a second.
fn oblique_hit() -> Scene {
    scenario("oblique-hit")
        .moving("a", [0.0, 0.0], [6.0, 0.0])
        .resting("b", [0.5, 0.03])
        .cloth(2.0)
        .duration(1.0)
        .build()
}

#[test]
fn the_stepper_is_of_first_order_over_nine_steps_or_more() {
    // why: the scheme is of first order; averaging over starts leaves little of the saw-tooth of hits, and none of a slide's
    for (name, tolerance) in [("slide", 0.05), ("oblique", 0.15), ("cushions", 0.15)] {
        let outcome = of(&["stepper"], &catalogue::scene(name).unwrap());
        for label in ["stepper as-written", "stepper approaching-only"] {
            let verdict = family(&outcome, label).verdict.unwrap();
            let fit = verdict.fit.unwrap();
            assert_eq!(verdict.kind, Kind::Converging, "{name}, {label}");
            assert!(fit.sizes >= 9, "{name}, {label}: {fit:?}");
            assert!(
                (fit.order - 1.0).abs() <= tolerance,
                "{name}, {label}: {fit:?}"
            );
        }
    }
}

#[test]
fn stock_rapier_stalls_because_contacts_are_recycled() {
    let outcome = of(&["rapier-f64"], &oblique_hit());
    let converging = family(&outcome, "rapier-f64 converging").verdict.unwrap();
    assert_eq!(converging.kind, Kind::Converging);
    let fit = converging.fit.unwrap();
    // first order, with what is left of the saw-tooth of one hit over eight starts
    assert!((fit.order - 1.0).abs() <= 0.15 && fit.sizes >= 8, "{fit:?}");
    for label in ["rapier-f64 stock", "rapier-f64 recycling"] {
        let measured = family(&outcome, label);
        assert_eq!(measured.verdict.unwrap().kind, Kind::Floor, "{label}");
        let cause = measured.cause.as_ref().unwrap();
        let responsible = cause.responsible().unwrap();
        assert_eq!(responsible.knob, "contact_recycling", "{label}: {cause:?}");
        // alone among everything that was tried
        let others = cause.tried.iter().filter(|tried| tried.is_responsible());
        assert_eq!(others.count(), 1, "{label}: {cause:?}");
    }
    let stock = family(&outcome, "rapier-f64 stock");
    assert!(
        stock.cause.as_ref().unwrap().tried.len() >= 4,
        "every knob of the preset is tried"
    );
    let substeps = family(&outcome, "rapier-f64 substeps");
    assert_eq!(substeps.verdict.unwrap().kind, Kind::Floor);
    let cause = substeps.cause.as_ref().unwrap();
    assert_eq!(
        cause.responsible().unwrap().knob,
        "dt",
        "contacts are looked for once a step"
    );
    // a reader finds the words
    let families = summary(&outcome);
    let families = table(&families, "families");
    let (verdict, why) = (column(families, "verdict"), column(families, "why"));
    let rows = families.rows.iter().filter(|row| {
        matches!(&row[verdict], Cell::Verdict(_, words) if words == "floor")
            && matches!(&row[why], Cell::Text(words) if words.contains("contact_recycling=true is responsible"))
    });
    assert_eq!(rows.count(), 2);
}

#[test]
fn touching_balls_that_gain_energy_are_called_that_whatever_the_setting() {
    let mut scene = catalogue::scene("triple-hit").unwrap();
    scene.duration = 0.6;
    let outcome = of(&["rapier-f64"], &scene);
    assert!(
        outcome.no_oracle.is_some(),
        "touching balls have no single answer"
    );
    for measured in &outcome.families {
        let label = measured.family.label();
        let verdict = measured
            .verdict
            .unwrap_or_else(|| panic!("{label} has no verdict"));
        assert_eq!(verdict.kind, Kind::GainingEnergy, "{label}");
        // an eighth of the energy is far beyond rounding
        assert!(verdict.gained.unwrap() > 0.05, "{label}: {verdict:?}");
    }
    let page = page(&outcome);
    assert!(
        page.lead.contains("nothing to hold errors against"),
        "{}",
        page.lead
    );
}

#[test]
fn prices_fall_with_the_error_and_hold_it() {
    let outcome = of(&["stepper", "exact"], &oblique_hit());
    let page = page(&outcome);
    let prices = table(&page, "cheapest");
    // final position, stop time, order, energy
    assert_eq!(prices.rows.len(), 4 * THRESHOLDS.len());
    let [quantity, error, reached, time] =
        ["quantity", "error", "reached", "time"].map(|key| column(prices, key));
    let number = |cell: &Cell| match cell {
        Cell::Number(x) => Some(*x),
        _ => None,
    };
    let mut priced = 0;
    for pair in prices.rows.windows(2) {
        let (wanted, got) = (number(&pair[1][error]).unwrap(), number(&pair[1][reached]));
        if let Some(got) = got {
            assert!(got <= wanted, "{:?}", pair[1]);
            priced += 1;
        }
        let (before, after) = (number(&pair[0][time]), number(&pair[1][time]));
        if pair[0][quantity] == pair[1][quantity]
            && let (Some(before), Some(after)) = (before, after)
        {
            assert!(
                before <= after,
                "a smaller error cannot be cheaper: {pair:?}"
            );
        }
    }
    assert!(priced > 30, "{priced}");
    // exact has every digit
    let last = prices.rows.last().unwrap();
    assert!(
        matches!(&last[column(prices, "setting")], Cell::Text(words) if words.starts_with("exact"))
    );
}

#[test]
fn runs_without_an_answer_stay_in_the_picture() {
    // in f32 the break is undecidable
    let outcome = of(&["exact"], &catalogue::scene("report-break").unwrap());
    let coarse = &family(&outcome, "exact precision").points[0];
    assert_eq!(
        (coarse.failed(), coarse.error(Quantity::FinalPosition)),
        (1, None)
    );
    let page = page(&outcome);
    let mut figures = page.blocks.iter().filter_map(|block| match block {
        Block::Figure(figure) => Some(figure),
        _ => None,
    });
    let figure = figures
        .find(|figure| figure.id == "cost-final-position")
        .unwrap();
    let crosses = figure
        .series
        .iter()
        .find(|series| series.name == "no answer")
        .unwrap();
    assert_eq!(crosses.points.len(), 1);
    let drawn: usize = figure
        .series
        .iter()
        .filter(|series| series.style == carom::finding::Style::Points)
        .map(|series| series.points.len())
        .sum();
    assert_eq!(drawn + 1, family(&outcome, "exact precision").points.len());
}

#[test]
fn what_is_timed_does_not_sleep() {
    let stock = Setting::default().with("preset", "stock");
    for id in ["rapier-f64", "rapier-f32"] {
        let awake = crate::support::find(id).unwrap().awake(&stock);
        assert_eq!(
            awake.values.get("can_sleep").map(String::as_str),
            Some("false"),
            "{id}"
        );
    }
    for id in ["exact", "stepper", "rapier-f64"] {
        let default = Setting::default();
        assert_eq!(
            crate::support::find(id).unwrap().awake(&default),
            default,
            "{id} is awake already"
        );
    }
}

#[test]
fn times_within_the_noise_do_not_change_a_front() {
    let outcome = of(&["stepper", "exact"], &oblique_hit());
    let all = offers(&outcome, Quantity::FinalPosition);
    // times by the number of steps, twice as many from level to level: no clock, and far apart for a noise of a fifth
    let noise = 0.2;
    let names = |offers: &[Offer<'_>]| -> Vec<String> {
        let front = front(offers, noise).into_iter();
        front
            .map(|offer| offer.point.level.column.label())
            .collect()
    };
    let mut steps: Vec<Offer<'_>> = all
        .iter()
        .filter(|offer| {
            offer
                .point
                .level
                .column
                .label()
                .contains("approaching-only")
        })
        .copied()
        .collect();
    for offer in &mut steps {
        offer.seconds = 1e-6 / offer.point.level.pace.step;
    }
    let mut shaken = steps.clone();
    for (k, offer) in shaken.iter_mut().enumerate() {
        offer.seconds *= 1.0 + 0.05 * if k % 2 == 0 { 1.0 } else { -1.0 };
    }
    assert_eq!(names(&steps), names(&shaken));
    assert!(names(&steps).len() >= 9, "{:?}", names(&steps));
    // errors fall along a front
    let front = front(&steps, noise);
    assert!(front.windows(2).all(|pair| pair[0].error >= pair[1].error));
}

#[test]
fn verdicts_and_errors_are_the_same_in_every_run() {
    let scene = oblique_hit();
    let conclusions = |outcome: &CostOutcome| -> Vec<String> {
        let families = outcome.families.iter();
        families
            .map(|m| {
                let errors: Vec<_> = m.points.iter().map(|p| &p.errors).collect();
                format!(
                    "{} {:?} {:?} {errors:?}",
                    m.family.label(),
                    m.verdict,
                    m.cause
                )
            })
            .collect()
    };
    let [one, two] = [(); 2].map(|()| conclusions(&of(&["stepper", "exact"], &scene)));
    assert_eq!(one, two);
}

#[test]
fn a_study_that_is_stopped_concludes_from_what_it_has() {
    let stop = AtomicBool::new(false);
    let told = AtomicUsize::new(0);
    let progress = |_: usize, _: usize, what: &str| {
        // after the errors, among the times
        if what.starts_with("timing") && told.fetch_add(1, Ordering::Relaxed) == 2 {
            stop.store(true, Ordering::Relaxed);
        }
    };
    let watch = Watch {
        progress: &progress,
        cancelled: &stop,
    };
    let named = [Configuration::of(crate::support::find("stepper").unwrap())];
    let outcome = study(
        crate::support::roster(),
        &oblique_hit(),
        &named,
        Grid::Small,
        watch,
    );
    assert!(outcome.stopped);
    let points = || outcome.families.iter().flat_map(|m| &m.points);
    let timed = points().filter(|point| point.timed.is_some()).count();
    assert!((2..=3).contains(&timed) && points().count() > 3, "{timed}");
    let text = carom::report::render(&summary(&outcome), "text").unwrap();
    assert!(text.contains("stopped early"), "{text}");
}

#[test]
fn a_given_setting_holds_at_every_level() {
    let setting = Setting::default().with("dt", "2e-3");
    let named = [Configuration {
        engine: crate::support::find("rapier-f64").unwrap().clone(),
        setting,
    }];
    let mut scene = oblique_hit();
    scene.duration = 0.3;
    let outcome = study(
        crate::support::roster(),
        &scene,
        &named,
        Grid::Small,
        Watch::NONE,
    );
    let points: Vec<_> = outcome.families.iter().flat_map(|m| &m.points).collect();
    assert!(points.len() > 5);
    for point in points {
        let dt = point.level.column.setting.values.get("dt");
        assert_eq!(dt.map(String::as_str), Some("2e-3"));
    }
    // a ladder over dt has one rung left, and is none
    assert!(
        outcome
            .families
            .iter()
            .all(|m| m.family.name != "converging")
    );
}

#[test]
fn a_report_lists_prices_of_the_scene_as_it_is() {
    let scene = oblique_hit();
    let outcome = of(&["stepper", "exact"], &scene);
    let list = carom::page::cost::price_list(&outcome, &scene);
    let read: PriceList = serde_json::from_str(&serde_json::to_string(&list).unwrap()).unwrap();
    assert_eq!(read, list);
    let known = listing(std::slice::from_ref(&scene), std::slice::from_ref(&list));
    assert!(matches!(&known[..], [Block::Table(table)] if table.rows.len() == 1));
    // another scene of that name has other prices
    let mut changed = scene.clone();
    changed.balls[0].state.velocity.x *= 1.01;
    let blocks = listing(&[changed], &[list]);
    let command = blocks.iter().find_map(|block| match block {
        Block::Command(command) => Some(command.as_str()),
        _ => None,
    });
    assert_eq!(command, Some("carom cost oblique-hit"));
    assert!(!blocks.iter().any(|block| matches!(block, Block::Table(_))));
}

fn carom(arguments: &[&str]) -> Output {
    Command::cargo_bin("carom")
        .unwrap()
        .args(arguments)
        .output()
        .unwrap()
}

#[test]
fn the_command_leaves_prices_for_the_report() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let output = carom(&[
        "cost",
        "slide",
        "--engines",
        "stepper,exact",
        "--out",
        out,
        "--format",
        "json",
    ]);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let text = json.to_string();
    for word in ["\"cheapest\"", "converging", "\"settings\"", "ranking-high"] {
        assert!(text.contains(word), "{word} is missing");
    }
    let page = folder.path().join("cost/slide/index.html");
    assert!(page.is_file());
    let report = carom(&["report", "slide", "--engines", "stepper", "--out", out]);
    assert!(report.status.success());
    let shown = String::from_utf8(report.stdout).unwrap();
    assert!(
        shown.contains("The cheapest setting for an error of the final position"),
        "{shown}"
    );
    let without = carom(&["report", "head-on", "--engines", "stepper", "--out", out]);
    let shown = String::from_utf8(without.stdout).unwrap();
    assert!(shown.contains("carom cost head-on"), "{shown}");
}

#[test]
fn text_of_a_study_fits_a_terminal() {
    let outcome = of(&["stepper", "exact"], &oblique_hit());
    let text = carom::report::render(&summary(&outcome), "text").unwrap();
    for line in text.lines() {
        assert!(line.chars().count() <= 100, "{line}");
    }
}

#[test]
fn bad_usage_is_answered_with_what_would_be_right() {
    for (arguments, expected) in [
        (vec!["cost", "slide", "--grid", "huge"], "small"),
        (vec!["cost", "nothing"], "nothing"),
        (
            vec!["cost", "slide", "--engines", "box2d"],
            "no engine is called",
        ),
    ] {
        let output = carom(&arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(message.contains(expected), "{arguments:?}: {message}");
    }
}
