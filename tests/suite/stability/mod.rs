//! `carom stability`: its rules on planted traces, its diff, the program, and what rapier is known to do.

mod known;
mod program;
mod rules;

use carom::study::Watch;
use carom::study::stability::{Outcome, Question, study};
use carom::study::{Column, stability};
use carom::{engine, scene::catalogue};
use std::sync::atomic::AtomicBool;

static NEVER: AtomicBool = AtomicBool::new(false);

/// Columns by their labels.
fn columns(labels: &[&str]) -> Vec<Column> {
    let column = |label: &&str| {
        let mut words = label.split(' ');
        let engine = engine::find(words.next().unwrap()).unwrap();
        let setting = engine::Setting::parse(words).unwrap();
        Column { engine, setting }
    };
    labels.iter().map(column).collect()
}

/// The matrix of catalogue scenes in some presets; every preset where none are named.
fn outcome(scenes: &[&str], presets: &[&str]) -> Outcome {
    let scenes = scenes.iter().map(|name| catalogue::scene(name).unwrap());
    let question = Question {
        scenes: scenes.collect(),
        presets: match presets {
            [] => stability::presets(),
            named => columns(named),
        },
        full: false,
        pictures: false,
    };
    let watch = Watch {
        progress: &|_, _, _| {},
        cancelled: &NEVER,
    };
    study(question, watch).unwrap()
}
