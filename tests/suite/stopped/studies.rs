//! Each study, stopped at several moments that progress names: what it says is part of what the whole study says.

use super::{STOPPED, moments, stopped_after, undisturbed};
use carom::engine::{Limits, Refusal};
use carom::finding::{Block, Document, Finding};
use carom::oracle::Lack;
use carom::page::compare::LengthUnit;
use carom::scene::perturb::Law;
use carom::scene::{Scene, catalogue};
use carom::study::compare::default_columns;
use carom::study::cost::Grid;
use carom::study::matrix::{Effort, run_one, run_row, time_alone};
use carom::study::{
    Answer, Configuration, Timing, Watch, check, compare, cost, curves, effects, ensemble, horizon,
    mutation, random, stability, validation,
};
use carom::trace::Record;
use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

fn scene(name: &str) -> Scene {
    catalogue::scene(name).unwrap()
}

fn columns(list: &str) -> Vec<Configuration> {
    Configuration::list(crate::support::roster(), list).unwrap()
}

/// Whether a document says first that it was stopped; where it does, in words that name how much was done.
fn says_so(document: &Document, stopped: bool, case: &str) {
    let said = document.stopped_early.as_deref();
    assert_eq!(said.is_some(), stopped, "{case}: {said:?}");
    assert!(said.is_none_or(|words| words.contains(STOPPED)), "{case}");
}

/// Number of rows of each table of a page.
fn tables(document: &Document) -> BTreeMap<String, usize> {
    let table = |block: &Block| match block {
        Block::Table(table) => Some((table.id.clone(), table.rows.len())),
        _ => None,
    };
    document.blocks.iter().filter_map(table).collect()
}

#[test]
fn the_matrix_gives_no_trace_that_was_cut_short() {
    let (scene, columns) = (
        scene("report-break"),
        default_columns(crate::support::roster()),
    );
    let stop = AtomicBool::new(true);
    let limits = Limits {
        cancelled: &stop,
        ..Limits::NONE
    };
    for column in &columns {
        let ran = run_one(&scene, column, Record::Events, &limits);
        assert_eq!(ran.err(), Some(Refusal::Stopped), "{}", column.label());
        let effort = Effort {
            least_runs: 1,
            most_runs: 3,
            seconds: 0.0,
        };
        let timed = time_alone(&scene, column, effort, &stop);
        assert_eq!(timed, Ok(None), "{}", column.label());
    }
    for timing in [Timing::None, Timing::Alone] {
        let cells = stopped_after(0, |watch| {
            run_row(&scene, &columns, Record::Events, timing, watch)
        });
        for cell in cells {
            assert_eq!(cell.err(), Some(Refusal::Stopped));
        }
    }
}

/// Findings that both have in common with what an undisturbed study finds.
fn all_among(found: &[Finding], whole: &[Finding], case: &str) {
    for finding in found {
        assert!(whole.contains(finding), "{case}: {finding:?}");
    }
}

#[test]
fn a_comparison_compares_no_engine_that_did_not_come_to_its_end() {
    let scene = scene("head-on");
    // the exact one first, and each alone, so that they run one after the other
    let list = compare::plan(
        crate::support::roster(),
        &default_columns(crate::support::roster()),
    );
    let ask = |watch: Watch<'_>| compare::study(&scene, None, &list, Timing::Alone, watch);
    let whole = undisturbed(ask);
    let all = whole.entries.len();
    says_so(
        &carom::page::compare::summary(&whole, LengthUnit::Radius),
        false,
        "whole",
    );
    for k in 0..=all {
        let case = format!("stopped after {k} of {all}");
        let outcome = stopped_after(k, ask);
        for (i, entry) in outcome.entries.iter().enumerate() {
            assert_eq!(entry.trace().is_some(), i < k, "{case}: {}", entry.label());
            let stopped = matches!(entry.cell, Err(Refusal::Stopped));
            assert_eq!(stopped, i >= k, "{case}: {}", entry.label());
            assert!(i < k || entry.standing.is_none(), "{case}");
            let label = entry.label();
            let of_it = |f: &Finding| f.engine.split(" | ").any(|engine| engine == label);
            assert!(i < k || !outcome.findings.iter().any(of_it), "{case}");
        }
        assert!(
            outcome
                .pairs
                .iter()
                .all(|pair| pair.entries.0.max(pair.entries.1) < k),
            "{case}"
        );
        assert!(outcome.horizon.is_none(), "{case}");
        all_among(&outcome.findings, &whole.findings, &case);
        let unasked = matches!(outcome.no_reference, Some((Lack::NotAsked, _)));
        assert_eq!(unasked, k == 0, "{case}");
        // after the last engine the horizon is still open
        assert!(outcome.extent.is_cut_short(), "{case}");
        says_so(&carom::page::compare::page(&outcome), true, &case);
        let lead = carom::page::compare::summary(&outcome, LengthUnit::Radius).lead;
        assert!(k > 1 || !lead.contains("as exact"), "{case}: {lead}");
    }
}

#[test]
fn an_ensemble_around_a_comparison_is_whole_or_not_there() {
    let scene = scene("triple-hit-ensemble");
    assert!(scene.simultaneous == carom::scene::Simultaneous::Ensemble);
    let ask = |watch: Watch<'_>| {
        let columns = columns("exact");
        let answer = Answer::to(&scene, &columns, Timing::None, 10_000, watch);
        carom::page::answer::summary(&answer.unwrap(), LengthUnit::Radius)
    };
    let whole = undisturbed(ask);
    says_so(&whole, false, "whole");
    let name = format!("ensemble-{}", scene.name);
    assert!(tables(&whole).contains_key(&name));
    // the first is the exact run, those after it are samples
    for k in [0, 1, 2, 50] {
        let document = stopped_after(k, ask);
        says_so(&document, true, &format!("{k}"));
        assert!(!tables(&document).contains_key(&name), "{k}");
    }
}

#[test]
fn a_horizon_that_was_stopped_says_nothing_else() {
    let scene = scene("head-on");
    for (stop, stopped) in [(false, false), (true, true)] {
        let stop = AtomicBool::new(stop);
        let outcome = horizon::study(&scene, Default::default(), &stop).unwrap();
        let document = carom::page::horizon::page(&outcome);
        says_so(&document, stopped, "");
        assert_eq!(document.lead.is_empty(), stopped, "{}", document.lead);
        assert_eq!(tables(&document).is_empty(), stopped);
    }
}

#[test]
fn an_ensemble_counts_only_samples_that_every_engine_ran() {
    let scene = scene("head-on");
    let samples = 400;
    let ask = |watch: Watch<'_>| {
        let plan = ensemble::Plan {
            law: Law::default_for(&scene),
            scene: scene.clone(),
            samples,
            seed: 3,
            columns: columns("exact,stepper:dt=0.01"),
        };
        ensemble::study(plan, watch).unwrap()
    };
    let whole = undisturbed(ask);
    says_so(&carom::page::ensemble::summary(&whole), false, "whole");
    // progress is told for every fourth cell
    for k in [0, 1, 20, 100, 199] {
        let case = format!("stopped after {k}");
        let outcome = stopped_after(k, ask);
        assert!(outcome.done < samples, "{case}: {}", outcome.done);
        for (entry, all) in outcome.entries.iter().zip(&whole.entries) {
            assert_eq!(entry.cells.iter().flatten().count(), outcome.done, "{case}");
            for (cell, same) in entry.cells.iter().zip(&all.cells) {
                assert!(cell.is_none() || cell == same, "{case}");
            }
            let counted = entry.distributions.iter().flatten().flatten();
            for distribution in counted {
                assert!(distribution.count() <= outcome.done, "{case}");
            }
        }
        for frequent in &outcome.frequent {
            assert_eq!(frequent.words, "", "{case}");
        }
        says_so(&carom::page::ensemble::page(&outcome), true, &case);
        let words = carom::page::ensemble::summary(&outcome)
            .stopped_early
            .unwrap();
        let count = match outcome.done {
            0 => format!("none of {samples} samples"),
            done => format!("{done} of {samples} samples"),
        };
        assert!(words.contains(&count), "{case}: {words}");
    }
    // the last sample is done, its orders are not yet in words
    let outcome = stopped_after(200, ask);
    assert_eq!(outcome.done, samples);
    says_so(
        &carom::page::ensemble::page(&outcome),
        !outcome.frequent.is_empty(),
        "200",
    );
}

#[test]
fn an_ablation_concludes_from_combinations_that_every_engine_ran() {
    let scene = scene("draw");
    let list = columns("exact,stepper:contact=approaching-only");
    let ask = |watch: Watch<'_>| effects::study(&scene, &list, 0.1, watch).unwrap();
    let whole = undisturbed(ask);
    says_so(&carom::page::effects::summary(&whole), false, "whole");
    let rows = whole.plan.rows.len();
    assert!(rows > 3);
    for k in 0..=rows {
        let case = format!("stopped after {k} of {rows}");
        let outcome = stopped_after(k, ask);
        // it is told which row comes next
        assert_eq!(outcome.cells.len(), k.saturating_sub(1), "{case}");
        for cell in outcome.cells.iter().flatten() {
            assert!(!matches!(cell, Err(Refusal::Stopped)), "{case}");
        }
        says_so(&carom::page::effects::page(&outcome), true, &case);
    }
}

#[test]
fn curves_are_whole_or_not_there() {
    let list = columns("exact");
    let ask = |watch: Watch<'_>| carom::page::curves::page(&curves::study(&list, watch).unwrap());
    let whole = undisturbed(ask);
    says_so(&whole, false, "whole");
    for k in 0..=4 {
        let document = stopped_after(k, ask);
        says_so(&document, true, &format!("{k}"));
        let departures = tables(&document)["departures"];
        let all = tables(&whole)["departures"];
        assert!(departures < all || k == 4, "{k}: {departures} of {all}");
        assert_eq!(departures == 0, k < 2, "{k}");
        assert_eq!(tables(&document).len(), 1, "{k}");
        // what is said of a curve is what the whole says of it
        let lead = document.lead.trim_end_matches('.');
        assert!(whole.lead.starts_with(lead), "{k}: {lead}");
    }
}

#[test]
fn cost_judges_only_ladders_that_were_run_from_every_start() {
    let scene = scene("head-on");
    let named = columns("exact,stepper");
    let ask = |watch: Watch<'_>| {
        cost::study(crate::support::roster(), &scene, &named, Grid::Small, watch)
    };
    let whole = undisturbed(ask);
    says_so(&carom::page::cost::page(&whole), false, "whole");
    assert!(!whole.stopped && whole.families.iter().all(|m| m.whole));
    let (mut judged, mut cut) = (0, 0);
    // errors first, then causes, then times
    let all = moments(ask);
    for part in 0..10 {
        let k = all * part / 10;
        let case = format!("stopped after {k} of {all}");
        let outcome = stopped_after(k, ask);
        says_so(
            &carom::page::cost::summary(&outcome),
            outcome.stopped,
            &case,
        );
        says_so(&carom::page::cost::page(&outcome), outcome.stopped, &case);
        for (measured, all) in outcome.families.iter().zip(&whole.families) {
            for (point, same) in measured.points.iter().zip(&all.points) {
                assert!(
                    point.errors.is_empty() || point.errors == same.errors,
                    "{case}"
                );
                assert!(point.whole || point.errors.is_empty(), "{case}");
            }
            if measured.whole {
                judged += usize::from(measured.verdict.is_some());
                assert_eq!(measured.verdict, all.verdict, "{case}");
            } else {
                cut += 1;
                assert_eq!(measured.verdict, None, "{case}");
                assert_eq!(measured.cause, None, "{case}");
            }
        }
        if outcome.levels.is_cut_short() {
            assert!(outcome.stopped, "{case}");
            let page = carom::page::cost::page(&outcome);
            let shown: Vec<String> = tables(&page).into_keys().collect();
            assert_eq!(shown, ["families", "settings"], "{case}");
        }
    }
    assert!(judged > 0 && cut > 0, "{judged} judged, {cut} cut short");
}

#[test]
fn random_scenes_count_where_every_engine_ran_them() {
    let plan = random::Plan {
        first: 0,
        scenes: 640,
        seed: 5,
        columns: columns("exact,stepper:contact=approaching-only"),
        max_events: 100,
    };
    let ask = |watch: Watch<'_>| random::study(plan.clone(), watch);
    let whole = undisturbed(ask);
    assert_eq!((whole.seen, whole.stopped_early()), (640, None));
    for k in [0, 1, 4, 9] {
        let outcome = stopped_after(k, ask);
        assert!(outcome.seen < 640, "{k}");
        for entry in &outcome.entries {
            let endings: u64 = entry.endings.values().sum();
            assert_eq!(endings, outcome.done, "{k}: {:?}", entry.endings);
            assert!(!entry.endings.contains_key("cancelled"), "{k}");
        }
        says_so(
            &carom::page::random::summary(&outcome),
            true,
            &format!("{k}"),
        );
    }
    // after the last of them there is nothing left to stop
    assert_eq!(stopped_after(10, ask).stopped_early(), None);
}

#[test]
fn mutated_inputs_count_once_they_were_read() {
    let examples = mutation::Examples::new(crate::support::roster()).unwrap();
    let plan = mutation::Plan {
        first: 0,
        inputs: 640,
        seed: 5,
    };
    let ask =
        |watch: Watch<'_>| carom::page::mutation::summary(&mutation::study(plan, &examples, watch));
    for k in [0, 1, 4, 9, 10] {
        says_so(&stopped_after(k, ask), k < 10, &format!("{k}"));
    }
}

#[test]
fn hard_cases_are_judged_by_whole_runs() {
    let ask = |watch: Watch<'_>| {
        let question = stability::Question {
            roster: crate::support::roster().clone(),
            scenes: vec![scene("head-on"), scene("slide")],
            presets: columns("exact,stepper"),
            full: false,
            pictures: false,
        };
        stability::study(question, watch).unwrap()
    };
    let whole = undisturbed(ask);
    let none = |_: usize, _: &str| false;
    says_so(&carom::page::stability::page(&whole, &none), false, "whole");
    for k in [0, 1, 2, 3, 5, 9] {
        let case = format!("stopped after {k}");
        let outcome = stopped_after(k, ask);
        assert!(outcome.is_cut_short(), "{case}");
        for index in 0..2 {
            all_among(&outcome.findings(index), &whole.findings(index), &case);
        }
        says_so(
            &carom::page::stability::summary(&outcome, &none),
            true,
            &case,
        );
    }
}

#[test]
fn a_check_finds_what_whole_runs_say() {
    let scenes = [scene("head-on"), scene("slide")];
    let ask = |watch: Watch<'_>| {
        check::study(
            crate::support::roster(),
            &scenes,
            &default_columns(crate::support::roster()),
            watch,
        )
        .unwrap()
    };
    let whole = undisturbed(ask);
    let none = |_: &str, _: &str, _: check::Level| carom::page::check::Against::Changed(0);
    says_so(&carom::page::check::summary(&whole, &none), false, "whole");
    for k in [0, 1, 2, 3, 5, 8] {
        let case = format!("stopped after {k}");
        let outcome = stopped_after(k, ask);
        assert!(outcome.missing() > 0, "{case}");
        all_among(&outcome.findings, &whole.findings, &case);
        says_so(&carom::page::check::page(&outcome, &none), true, &case);
        let document = carom::page::check::summary(&outcome, &none);
        let text = carom::report::render(&document, "text").unwrap();
        assert!(!text.contains("same"), "{case}: {text}");
    }
}

#[test]
fn a_report_has_the_scenes_that_were_compared_to_the_end() {
    let scenes = [scene("head-on"), scene("slide"), scene("three-ball")];
    let list = columns("exact,stepper");
    let ask = |watch: Watch<'_>| {
        let roster = crate::support::roster();
        let outcome = validation::study(roster, &scenes, &list, watch).unwrap();
        carom::page::validation::page(roster, &outcome, &[])
    };
    // it is told which scene comes next, then that the claims do
    for k in 0..=4 {
        let case = format!("stopped after {k}");
        let document = stopped_after(k, ask);
        says_so(&document, true, &case);
        let compared = k.saturating_sub(1).min(scenes.len());
        assert_eq!(tables(&document)["scenes"], compared, "{case}");
        let pages: Vec<&str> = document.pages.iter().map(|page| &*page.id).collect();
        let expected: Vec<&str> = scenes[..compared].iter().map(|s| &*s.name).collect();
        assert_eq!(pages, expected, "{case}");
        for page in &document.pages {
            says_so(page, false, &case);
        }
    }
    says_so(&stopped_after(5, ask), false, "after everything was done");
}
