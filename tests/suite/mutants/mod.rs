//! The gate tests itself: engines with one thing wrong, each of which `check` must catch, and right ones that it must not.
//!
//! `cargo test --test suite mutants -- --nocapture` prints the table of `validation/MUTANTS.md`.

pub mod engines;
mod held;
mod laws;
mod missed;
mod plain;
mod roster;
mod slip;
mod told;

pub use engines::{Fault, Wrong};
pub use held::{caught, hold as held};

use crate::support::run;
use carom::engine::Setting;
use carom::scene::{SetName, catalogue};
use carom::study::check::Level;
use carom::study::matrix::Configuration;
use carom::trace::Record;
use held::Caught;
use missed::MISSED;
use roster::{MUTANTS, Mutant};
use slip::Slip;
use std::collections::BTreeSet;

/// The table, and what it says in words.
const PAGE: &str = include_str!("../../../validation/MUTANTS.md");

/// Where the table begins.
const TABLE: &str = "| mutant |";

/// Reruns of what is not mutated.
const REPETITIONS: usize = 50;

#[test]
fn the_plain_copy_without_a_slip_is_the_stepper_to_the_bit() {
    let scenes = catalogue::set(SetName::Gate).unwrap();
    assert!(scenes.len() > 20, "{} scenes", scenes.len());
    let copy = Wrong::stepping(Slip::None);
    for scene in &scenes {
        for setting in [&[][..], &["contact=approaching-only"]] {
            if setting.is_empty() && !scene.equal_masses() {
                continue;
            }
            let want = run("stepper", setting, scene, Record::Every(0.01));
            let got = engines::run(copy.as_ref(), setting, scene, Record::Every(0.01));
            let case = format!("{} {setting:?}", scene.name);
            assert_eq!(got.events, want.events, "{case}: events");
            assert_eq!(got.counters, want.counters, "{case}: counters");
            assert_eq!(got, want, "{case}");
        }
    }
}

#[test]
#[allow(clippy::print_stdout)]
fn every_mutant_is_caught_by_the_level_that_the_page_says() {
    let mut table = heading();
    let mut missed = Vec::new();
    for mutant in all() {
        let columns = [mutant.column()];
        let held = held::hold(&held::gate_scenes(mutant.scenes), &columns, 0);
        let caught = held::caught(&held);
        if caught.is_empty() {
            missed.push(mutant.id);
        }
        table += &line(mutant, &caught);
    }
    println!("{table}");
    assert!(missed.is_empty(), "not caught: {missed:?}");
    let begins = &PAGE[PAGE.find(TABLE).unwrap()..];
    let ends = begins.find("\n\n").map_or(begins.len(), |end| end + 1);
    assert_eq!(
        table,
        begins[..ends],
        "validation/MUTANTS.md says something else; the table above is what was found"
    );
}

#[test]
fn mutants_are_many_and_different() {
    let ids: BTreeSet<&str> = all().map(|mutant| mutant.id).collect();
    assert_eq!(ids.len(), all().count(), "two mutants share a name");
    assert!(ids.len() >= 60, "{} mutants", ids.len());
    assert!(all().all(|mutant| !mutant.scenes.is_empty()));
}

#[test]
fn what_is_not_mutated_is_never_flagged_for_any_number_of_threads() {
    // every scene and engine in which a mutant runs
    let mut jobs: BTreeSet<(&str, &[&str], &str)> = BTreeSet::new();
    for mutant in all() {
        let of = |scene| (mutant.engine, mutant.setting, scene);
        jobs.extend(mutant.scenes.iter().copied().map(of));
    }
    let mut columns: BTreeSet<(&str, &[&str])> = BTreeSet::new();
    columns.extend(jobs.iter().map(|&(engine, setting, _)| (engine, setting)));
    assert!(columns.len() >= 4, "{columns:?}");
    let pools: Vec<rayon::ThreadPool> = (1..=4)
        .map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            pool.build().unwrap()
        })
        .collect();
    let mut first = Vec::new();
    for repetition in 0..REPETITIONS {
        let pool = &pools[repetition % pools.len()];
        let mut bits = Vec::new();
        for &(id, setting) in &columns {
            let names = jobs.iter().filter(|job| (job.0, job.1) == (id, setting));
            let names: Vec<&str> = names.map(|job| job.2).collect();
            let column = [Configuration {
                engine: crate::support::find(id).unwrap().clone(),
                setting: Setting::parse(setting.iter().copied()).unwrap(),
            }];
            let held = pool.install(|| held::hold(&held::gate_scenes(&names), &column, 0));
            let flagged = held::caught(&held);
            assert!(
                flagged.is_empty(),
                "repetition {repetition} with {} threads: {flagged:?}",
                pool.current_num_threads()
            );
            bits.extend(held.outcome.bits);
        }
        if repetition == 0 {
            first = bits;
        } else {
            assert_eq!(bits, first, "repetition {repetition}: other bits");
        }
    }
    assert!(first.len() > 20, "{} runs", first.len());
}

#[test]
fn an_event_that_is_not_told_is_seen_in_the_motion_that_it_leaves_unexplained() {
    let mutant = MUTANTS.iter().find(|mutant| mutant.id == "event-not-told");
    let mutant = mutant.unwrap();
    let held = held::hold(&held::gate_scenes(mutant.scenes), &[mutant.column()], 0);
    let noticed = held.changes.iter().filter_map(|located| {
        let row = located.change.row()?;
        (row.check == "unexplained").then_some(row.value?)
    });
    let most = noticed.fold(0.0, f64::max);
    // the ball that was hit is somewhere else by the next event: more than its radius
    assert!(most > 1.0, "unexplained: {most} R");
}

fn all() -> impl Iterator<Item = &'static Mutant> {
    MUTANTS.iter().chain(MISSED)
}

fn heading() -> String {
    let levels: Vec<&str> = Level::ALL.iter().map(|level| level.id()).collect();
    let columns = levels.len() + 4;
    format!(
        "{TABLE} engine | what is wrong | {} | first finding |\n|{}\n",
        levels.join(" | "),
        "---|".repeat(columns)
    )
}

/// One mutant: how many findings of each level caught it, and the first of the first level.
fn line(mutant: &Mutant, caught: &Caught) -> String {
    let counts = Level::ALL.map(|level| {
        let count = caught.get(&level).map(|(count, _)| count.to_string());
        count.unwrap_or_default()
    });
    let first = caught.values().next().map_or("", |(_, words)| words);
    let engine = [mutant.engine, &mutant.setting.join(" ")].join(" ");
    format!(
        "| {} | {} | {} | {} | {} |\n",
        mutant.id,
        engine.trim_end(),
        mutant.what,
        counts.join(" | "),
        first.replace('|', "/")
    )
}
