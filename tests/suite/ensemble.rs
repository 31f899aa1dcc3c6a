//! Ensembles: the same for every number of threads, known distributions, and what two precisions agree on.

use crate::support::{R, report_break};
use assert_cmd::Command;
use carom::engine::Setting;
use carom::finding::{Block, Document};
use carom::math::random::Draws;
use carom::math::statistics::{Distribution, holm, kolmogorov_smirnov};
use carom::page::ensemble::{page, summary, surround};
use carom::report::render;
use carom::scene::perturb::Law;
use carom::scene::{Scene, catalogue};
use carom::study::compare;
use carom::study::ensemble::{EnsembleEntry, EnsembleOutcome, Plan, Quantity, study, surroundings};
use carom::study::{Configuration, Timing, Watch};
use serde_json::Value;
use std::process::Output;
use std::sync::atomic::{AtomicBool, Ordering};

fn columns(engines: &[(&str, &str)]) -> Vec<Configuration> {
    let column = |&(engine, setting): &(&str, &str)| Configuration {
        engine: crate::support::find(engine).unwrap().clone(),
        setting: Setting::parse(setting.split_whitespace()).unwrap(),
    };
    engines.iter().map(column).collect()
}

fn plan(scene: &Scene, samples: usize, engines: &[(&str, &str)]) -> Plan {
    Plan {
        scene: scene.clone(),
        law: Law::default_for(scene),
        samples,
        seed: 1,
        columns: columns(engines),
    }
}

fn ensemble(scene: &Scene, samples: usize, engines: &[(&str, &str)]) -> EnsembleOutcome {
    study(plan(scene, samples, engines), Watch::NONE).unwrap()
}

/// Final position of a ball in every complete sample.
fn ends(entry: &EnsembleEntry, ball: usize) -> Vec<[f64; 2]> {
    entry
        .complete()
        .map(|(_, landing)| landing.at[ball].unwrap())
        .collect()
}

fn carom(arguments: &[&str], threads: &str) -> Output {
    Command::cargo_bin("carom")
        .unwrap()
        .args(arguments)
        .env("RAYON_NUM_THREADS", threads)
        .output()
        .unwrap()
}

#[test]
fn the_output_is_the_same_to_the_bit_for_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let run = |threads: &str| {
        let out = folder.path().join(threads);
        let output = carom(
            &[
                "ensemble",
                "report-break",
                "--samples",
                "41",
                "--seed",
                "3",
                "--engines",
                "exact,stepper:dt=4e-3",
                "--format",
                "json",
                "--out",
                out.to_str().unwrap(),
            ],
            threads,
        );
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        (
            output.stdout,
            std::fs::read(out.join("report.json")).unwrap(),
        )
    };
    let one = run("1");
    let document: Value = serde_json::from_slice(&one.0).unwrap();
    assert!(document.to_string().contains("41 samples, seed 3"));
    for threads in ["2", "5"] {
        assert!(run(threads) == one, "{threads} threads differ from one");
    }
}

#[test]
fn more_samples_begin_with_those_that_were_there() {
    let scene = catalogue::scene("report-break").unwrap();
    let engines = [("exact", "")];
    let (few, many) = (
        ensemble(&scene, 10, &engines),
        ensemble(&scene, 25, &engines),
    );
    assert_eq!(few.entries[0].cells, many.entries[0].cells[..10]);
    let mut other = plan(&scene, 10, &engines);
    other.seed = 2;
    let other = study(other, Watch::NONE).unwrap();
    assert_ne!(few.entries[0].cells, other.entries[0].cells);
}

#[test]
fn f64_and_double_double_agree_on_jittered_breaks_in_every_order_and_to_1e_11_r() {
    let scene = catalogue::scene("report-break").unwrap();
    let outcome = ensemble(&scene, 100, &[("exact", ""), ("exact", "precision=dd")]);
    let agreement = outcome.entries[1].agreement.clone().unwrap();
    assert_eq!(
        (
            agreement.both,
            agreement.same_collisions,
            agreement.same_events
        ),
        (100, 100, 100)
    );
    // rounding of coordinates of 100 R times a growth of up to 1000: 2^-53 x 100 x 1000
    let apart = agreement.apart.unwrap();
    assert!(
        apart.value > 0.0 && apart.value <= 1e-11,
        "sample {}, ball {}: {:e} R",
        apart.sample,
        apart.ball,
        apart.value
    );
    assert!(outcome.entries[0].orders > 50, "the samples do vary");
    assert!(outcome.tests.iter().all(|test| !test.differs));
    let lead = summary(&outcome).lead;
    assert!(
        lead.contains("the order of all events of exact in 100 of 100 samples"),
        "{lead}"
    );
}

#[test]
fn a_ball_into_two_that_almost_touch_hits_one_first_and_both_mirror_images_come_equally_often() {
    let scene = catalogue::scene("triple-hit-ensemble").unwrap();
    let outcome = ensemble(&scene, 400, &[("exact", "")]);
    let exact = &outcome.entries[0];
    let samples = exact.complete().count();
    assert_eq!((samples, exact.orders), (400, 2));
    // The cue ball comes along y at speed 1 and touches both when its centre is sqrt(3) R before theirs; lines of centres are
    // (-+1/2, sqrt(3)/2). It gives the first its speed along that line, sqrt(3)/2, then the second what it has left along
    // the other line, sqrt(3)/4; the two leave each other behind.
    let root = 3.0_f64.sqrt();
    let first = [-root / 4.0, 0.75];
    let second = [root / 8.0, 0.375];
    let cue = [root / 8.0, -0.125];
    let radius = scene.balls[0].radius;
    let meeting = 0.5 - root * radius;
    let left = scene.duration - meeting;
    let end = |from: [f64; 2], velocity: [f64; 2], mirrored: bool| {
        let sign = if mirrored { -1.0 } else { 1.0 };
        [
            from[0] + sign * velocity[0] * left,
            from[1] + velocity[1] * left,
        ]
    };
    // With gaps of size g R, no centre is off by more than g R in x and in y. The first line of centres then turns by at most
    // g / sqrt(3), and what the cue ball keeps changes by twice that. Where the second ball is seen from it is off by less than
    // 2.8 g R, and the way there is at most 3.2 g R at right angles: the second line turns by 3 g at most, and twice that of the
    // speed 1/2 that is left adds up to 4.2 g. All balls fly for 4 s, from places that are off by less than 10 g R.
    let g = outcome.plan.law.gap;
    let tolerance = 4.2 * g * scene.duration + 10.0 * g * radius;
    let (cues, lefts, rights) = (ends(exact, 0), ends(exact, 1), ends(exact, 2));
    let mut left_first = 0_u32;
    for i in 0..samples {
        let to_the_right = cues[i][0] > 0.0;
        left_first += u32::from(to_the_right);
        // a ball that hit the left one first goes to the right
        let (of_left, of_right) = if to_the_right {
            (first, second)
        } else {
            ([-second[0], second[1]], [-first[0], first[1]])
        };
        for (what, got, want) in [
            ("cue", cues[i], end([0.0, meeting], cue, !to_the_right)),
            ("left", lefts[i], end([-radius, 0.5], of_left, false)),
            ("right", rights[i], end([radius, 0.5], of_right, false)),
        ] {
            let error = (got[0] - want[0]).hypot(got[1] - want[1]);
            assert!(
                error <= tolerance,
                "sample {i}, {what}: {got:?} instead of {want:?}, off by {error:e}"
            );
        }
    }
    // a fair coin: five deviations
    let n = samples as f64;
    let off = (f64::from(left_first) - 0.5 * n).abs();
    assert!(off <= 2.5 * n.sqrt(), "left first in {left_first} of {n}");
    assert_eq!(
        outcome.frequent.iter().map(|f| f.counts[0]).sum::<usize>(),
        samples
    );
    let mut words: Vec<&str> = outcome.frequent.iter().map(|f| f.words.as_str()).collect();
    words.sort_unstable();
    assert_eq!(words, ["cue-left cue-right", "cue-right cue-left"]);
}

#[test]
fn a_central_break_of_a_frozen_rack_is_mirror_symmetric_in_distribution() {
    let axis = 6.315;
    let mut plan = plan(&report_break(0.0, 90.0), 300, &[("exact", "")]);
    plan.law = Law {
        gap: 1e-5,
        ..Law::default()
    };
    let outcome = study(plan, Watch::NONE).unwrap();
    let entry = &outcome.entries[0];
    assert!(entry.complete().count() > 200);
    for row in 0..5 {
        let start = 1 + row * (row + 1) / 2;
        for place in 0..=row {
            let (ours, theirs) = (ends(entry, start + place), ends(entry, start + row - place));
            let pairs = ours.iter().zip(&theirs);
            let sums: Vec<f64> = pairs.map(|(a, b)| (a[0] + b[0] - 2.0 * axis) / R).collect();
            let n = sums.len() as f64;
            let mean = sums.iter().sum::<f64>() / n;
            let variance = sums.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
            // positions of a ball and of its mirror image cancel on average: five standard errors
            assert!(
                mean.abs() <= 5.0 * (variance / n).sqrt(),
                "row {row}, place {place}: {mean} R off the axis, deviation {}",
                variance.sqrt()
            );
            assert!(variance > 0.0);
        }
    }
}

#[test]
fn where_the_balls_of_a_frozen_break_end_does_not_depend_on_the_size_of_small_gaps() {
    let scene = catalogue::scene("report-break-frozen-ensemble").unwrap();
    // Opening the rack moves its corners by 2.8 gaps, and many samples end in nearly the same place: positions are blurred by
    // 0.1 R to either side, so that shifts of 1e-3 R make no more than half a percent of a distribution function. Stop times do
    // not have this limit: the smaller the gap, the slower a neighbour may be and still reach a ball, which then hardly moves.
    let places = |gap: f64, seed: u64| -> Vec<Distribution> {
        let mut plan = plan(&scene, 500, &[("exact", "")]);
        (plan.law.gap, plan.seed) = (gap, seed);
        let entry = study(plan, Watch::NONE).unwrap().entries.remove(0);
        let mut places = Vec::new();
        for i in 0..scene.balls.len() {
            for axis in 0..2 {
                let mut draws = Draws::new(seed, (2 * i + axis) as u64);
                let ends = ends(&entry, i).into_iter();
                let blurred = ends.map(|at| at[axis] / R + draws.between(-0.1, 0.1));
                places.push(Distribution::of(blurred).unwrap());
            }
        }
        places
    };
    let p_of = |a: &[Distribution], b: &[Distribution]| -> f64 {
        assert_eq!((a.len(), b.len()), (32, 32));
        let pairs = a.iter().zip(b);
        let p_values: Vec<f64> = pairs.map(|(a, b)| kolmogorov_smirnov(a, b).p).collect();
        holm(&p_values).into_iter().fold(1.0, f64::min)
    };
    // independent samples: the smallest of the corrected p-values is below 1e-3 with at most that probability
    let (small, smaller) = (places(1e-4, 1), places(1e-6, 2));
    let p = p_of(&small, &smaller);
    assert!(p > 1e-3, "gaps of 1e-4 R and 1e-6 R: {p:e}");
    // and the test does see gaps that are not small
    let p = p_of(&small, &places(0.3, 3));
    assert!(p < 1e-3, "gaps of 1e-4 R and 0.3 R: {p:e}");
}

#[test]
fn an_engine_differs_from_itself_in_nothing_and_from_one_that_steps_coarsely_in_much() {
    let scene = catalogue::scene("report-break").unwrap();
    let outcome = ensemble(
        &scene,
        60,
        &[
            ("exact", ""),
            ("exact", "precision=f64"),
            ("stepper", "dt=2e-2"),
        ],
    );
    let same = outcome.entries[1].agreement.as_ref().unwrap();
    assert_eq!((same.both, same.same_events), (60, 60));
    assert_eq!(same.apart.unwrap().value, 0.0);
    assert_eq!(same.delayed.unwrap().value, 0.0);
    let of = |entry: usize| outcome.tests.iter().filter(move |t| t.entry == entry);
    assert_eq!(of(1).count(), 16 * Quantity::ALL.len());
    assert!(of(1).all(|t| t.distance == 0.0 && t.p == 1.0 && t.transport == 0.0 && !t.differs));
    let coarse = outcome.entries[2].agreement.as_ref().unwrap();
    assert_eq!(coarse.same_events, 0);
    assert!(coarse.apart.unwrap().value > 1.0);
    // a step of 20 ms is a ball's way of a radius: every ball that moves far tells
    assert!(of(2).filter(|t| t.differs).count() > 16);
    let text = render(&summary(&outcome), "text").unwrap();
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("for all 96 tests"), "{text}");
}

#[test]
fn runs_that_do_not_reach_the_end_are_counted_by_their_ending_and_refusals_by_their_reason() {
    // touching balls in every sample: only the aim varies
    let mut plan = plan(
        &report_break(0.0, 90.2),
        12,
        &[("exact", ""), ("exact", "precision=f128")],
    );
    plan.law = Law {
        aim: 0.1,
        ..Law::default()
    };
    let outcome = study(plan, Watch::NONE).unwrap();
    assert_eq!(outcome.entries[0].complete().count(), 0);
    let document = summary(&outcome);
    assert!(
        document.lead.contains("in none of 12 samples"),
        "{}",
        document.lead
    );
    let text = render(&document, "csv").unwrap();
    assert!(text.contains("indeterminate 12"), "{text}");
    assert!(text.contains("refused 12: "), "{text}");
    assert_eq!(outcome.reference, None);
}

#[test]
fn where_exact_has_no_answer_the_next_engine_stands_in_its_place() {
    let mut plan = plan(
        &report_break(0.0, 90.2),
        12,
        &[
            ("exact", ""),
            ("stepper", "dt=1e-2"),
            ("stepper", "dt=1e-2 contact=approaching-only"),
        ],
    );
    plan.law = Law {
        aim: 0.1,
        ..Law::default()
    };
    let outcome = study(plan, Watch::NONE).unwrap();
    assert_eq!(outcome.reference, Some(1));
    let agreements: Vec<bool> = outcome
        .entries
        .iter()
        .map(|e| e.agreement.is_some())
        .collect();
    assert_eq!(agreements, [true, false, true]);
    assert_eq!(outcome.entries[0].agreement.as_ref().unwrap().both, 0);
    assert_eq!(outcome.entries[2].agreement.as_ref().unwrap().both, 12);
    assert_eq!(outcome.tests.len(), 48);
    assert!(outcome.tests.iter().all(|test| test.entry == 2));
    let text = render(&summary(&outcome), "text").unwrap();
    assert!(
        text.contains("exact reaches the end in none of 12 samples"),
        "{text}"
    );
    assert!(
        text.contains("Against stepper dt=1e-2, sample by sample"),
        "{text}"
    );
}

#[test]
fn a_cancelled_ensemble_concludes_from_what_it_has_and_says_so() {
    let scene = catalogue::scene("report-break").unwrap();
    let cancelled = AtomicBool::new(false);
    let stop_in_the_middle = |done: usize, total: usize, _: &str| {
        if done >= total / 2 {
            cancelled.store(true, Ordering::Relaxed);
        }
    };
    let watch = Watch {
        progress: &stop_in_the_middle,
        cancelled: &cancelled,
    };
    let samples = 400;
    let engines = [("exact", ""), ("exact", "precision=dd")];
    let outcome = study(plan(&scene, samples, &engines), watch).unwrap();
    assert!(
        outcome.done > 0 && outcome.done < samples,
        "{} samples",
        outcome.done
    );
    for entry in &outcome.entries {
        assert_eq!(entry.cells.iter().flatten().count(), outcome.done);
    }
    let words = format!("stopped early: {} of {samples} samples", outcome.done);
    let text = render(&summary(&outcome), "text").unwrap();
    assert!(text.contains(&words), "{text}");
}

#[test]
fn the_page_has_every_distribution_and_its_command_prints_the_same() {
    let scene = catalogue::scene("three-ball").unwrap();
    let outcome = ensemble(&scene, 20, &[("exact", ""), ("stepper", "dt=1e-2")]);
    let page = page(&outcome);
    let tables = ["engines", "agreement", "balls", "orders"];
    let quantiles = Quantity::ALL.map(|q| format!("quantiles-{}", q.id()));
    for id in tables
        .iter()
        .copied()
        .chain(quantiles.iter().map(String::as_str))
    {
        let found = page.blocks.iter().any(|block| match block {
            Block::Table(table) => table.id == id && !table.rows.is_empty(),
            _ => false,
        });
        assert!(found, "no table {id}");
    }
    let figures = page
        .blocks
        .iter()
        .filter(|block| matches!(block, Block::Figure(figure) if !figure.series.is_empty()));
    assert_eq!(figures.count(), 3);
    for block in &page.blocks {
        let units: Vec<&str> = match block {
            Block::Table(table) => table.columns.iter().map(|c| c.unit.as_str()).collect(),
            Block::Figure(figure) => vec![&figure.x.unit, &figure.y.unit],
            _ => continue,
        };
        let one = |unit: &&str| ["", "R", "s"].contains(unit);
        assert!(units.iter().all(one), "{units:?}");
    }
    let note = |id: &str| {
        page.blocks.iter().find_map(|block| match block {
            Block::Table(table) if table.id == id => Some(table.note.clone()),
            _ => None,
        })
    };
    for id in ["balls", "quantiles-x"] {
        assert!(
            note(id).unwrap().contains("reaches the end: all 20."),
            "{id}"
        );
    }
    let command = page.blocks.iter().find_map(|block| match block {
        Block::Command(command) => Some(command.clone()),
        _ => None,
    });
    let command = command.unwrap();
    let arguments: Vec<&str> = command.split(' ').skip(1).collect();
    let printed = carom(&arguments, "2");
    let expected = render(&summary(&outcome), "text").unwrap();
    assert_eq!(String::from_utf8(printed.stdout).unwrap(), expected);
}

#[test]
fn a_comparison_shows_the_ensemble_where_the_scene_asks_for_one_and_nowhere_else() {
    let blocks = |name: &str| -> (Document, usize) {
        let scene = catalogue::scene(name).unwrap();
        let columns = compare::plan(
            crate::support::roster(),
            &columns(&[("stepper", "dt=1e-2")]),
        );
        let outcome = compare::study(&scene, None, &columns, Timing::None, Watch::NONE);
        let mut document =
            carom::page::compare::summary(&outcome, carom::page::compare::LengthUnit::Radius);
        let (found, _) = surroundings(&outcome, Watch::NONE);
        let blocks = found.map(|found| carom::page::ensemble::surroundings(&outcome, &found));
        let blocks = blocks.unwrap_or_default();
        let count = blocks.len();
        surround(&mut document, blocks);
        (document, count)
    };
    assert_eq!(blocks("triple-hit").1, 0);
    assert_eq!(blocks("triple-hit-reflections").1, 0);
    let (document, count) = blocks("triple-hit-ensemble");
    assert!(count > 0);
    let first_table = document.blocks.iter().find_map(|block| match block {
        Block::Table(table) => Some(table),
        _ => None,
    });
    let table = first_table.unwrap();
    assert_eq!(table.id, "ensemble-triple-hit-ensemble");
    assert_eq!(table.rows.len(), 3);
    let text = render(&document, "text").unwrap();
    assert!(
        text.contains("200 are complete and have 2 different"),
        "{text}"
    );
    assert!(text.contains("`carom ensemble` runs"), "{text}");
}

#[test]
fn what_cannot_run_ends_with_2_and_says_what_would_be_right() {
    for (arguments, wanted) in [
        (
            vec!["triple-hit", "--samples", "0"],
            "1 to 10000000 samples",
        ),
        (vec!["triple-hit", "--aim", "0"], "above 0"),
        (vec!["triple-hit", "--speed", "1.5"], "below 1"),
        (vec!["triple-hit", "--aim", "x"], "invalid value"),
        (
            vec!["discs-in-a-box", "--gap", "1e-3"],
            "give an aim or a speed",
        ),
        (vec!["triple-hit", "--engines", "jolt"], "there are stepper"),
        (vec!["tripel-hit"], "triple-hit"),
    ] {
        let all: Vec<&str> = std::iter::once("ensemble").chain(arguments).collect();
        let output = carom(&all, "1");
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{all:?}: {message}");
        assert!(message.contains(wanted), "{all:?}: {message}");
        assert!(output.stdout.is_empty(), "{all:?}");
    }
}

#[test]
fn a_mean_over_samples_that_their_outcome_has_chosen_says_so() {
    let scene = catalogue::scene("accumulate-three").unwrap();
    let outcome = ensemble(
        &scene,
        3,
        &[("exact", "contacts=collapse"), ("stepper", "dt=1e-2")],
    );
    let text = render(&summary(&outcome), "text").unwrap();
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let complete = outcome.entries[0].complete().count();
    assert!(complete < 3, "{complete}");
    let counted = format!("exact contacts=collapse {complete} of 3, stepper dt=1e-2 3 of 3");
    for part in [&*counted, "is chosen by its outcome"] {
        assert!(words.contains(part), "{part}: {text}");
    }
}
