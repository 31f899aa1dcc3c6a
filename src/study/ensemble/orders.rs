//! Which collision orders occur, how often in which engine, and where they part.

use super::{EnsembleEntry, EnsembleOutcome, Order};
use crate::engine::Refusal;
use crate::scene::Scene;
use crate::study::matrix::{self, Timing, Watch};
use crate::trace::{EventKind, Record, Trace};
use crate::words::describe_kind;
use std::collections::{BTreeMap, BTreeSet};

/// Orders that are told in full.
const MOST: usize = 6;
/// Collisions of an order that are told.
const TOLD: usize = 12;

/// A collision order, and how often it occurs.
#[derive(Clone, Debug, PartialEq)]
pub struct Frequent {
    /// The order.
    pub order: Order,
    /// In how many samples each engine has it.
    pub counts: Vec<usize>,
    /// Index of the first sample that has it, and of the first engine in which.
    pub first: (usize, usize),
    /// The collisions, as far as a reader needs them.
    pub words: String,
}

/// Number of distinct collision orders among the complete runs.
pub(super) fn distinct(entry: &EnsembleEntry) -> usize {
    let orders: BTreeSet<Order> = entry.complete().map(|(_, l)| l.collisions).collect();
    orders.len()
}

/// The orders that occur most often: in the reference, then in all; of equals the one that occurs first.
pub(super) fn most_frequent(entries: &[EnsembleEntry], reference: Option<usize>) -> Vec<Frequent> {
    let mut known: BTreeMap<Order, Frequent> = BTreeMap::new();
    for (engine, entry) in entries.iter().enumerate() {
        for (sample, landing) in entry.complete() {
            let order = landing.collisions;
            let frequent = known.entry(order).or_insert_with(|| Frequent {
                order,
                counts: vec![0; entries.len()],
                first: (sample, engine),
                words: String::new(),
            });
            frequent.counts[engine] += 1;
            frequent.first = frequent.first.min((sample, engine));
        }
    }
    let mut orders: Vec<Frequent> = known.into_values().collect();
    orders.sort_by_key(|frequent| {
        let all: usize = frequent.counts.iter().sum();
        let in_reference = reference.map_or(0, |index| frequent.counts[index]);
        (usize::MAX - in_reference, usize::MAX - all, frequent.first)
    });
    orders.truncate(MOST);
    orders
}

/// Runs the sample that shows each of the most frequent orders again, and puts the orders into words: the first in full, the
/// others from where they leave it.
pub(super) fn spell_out(
    outcome: &mut EnsembleOutcome,
    sample: impl Fn(usize) -> Scene,
    watch: Watch<'_>,
) {
    let silent = Watch {
        progress: &|_, _, _| {},
        ..watch
    };
    let mut main: Option<Vec<EventKind>> = None;
    for frequent in &mut outcome.frequent {
        let (index, engine) = frequent.first;
        let column = std::slice::from_ref(&outcome.entries[engine].column);
        let scene = sample(index);
        let cells = matrix::run_row(&scene, column, Record::Events, Timing::None, silent);
        let cell = cells.into_iter().next();
        let stopped = matches!(cell, Some(Err(Refusal::Stopped)));
        outcome.spelled.count(!stopped);
        let Some(Ok(ran)) = cell else {
            continue;
        };
        if !ran.trace.ending.is_complete() {
            continue;
        }
        let kinds: Vec<EventKind> = ran.trace.collisions().map(|event| event.kind).collect();
        frequent.words = match &main {
            None => told(&ran.trace, &kinds, 0),
            Some(main) => {
                let same = main.iter().zip(&kinds).take_while(|(a, b)| a == b).count();
                told(&ran.trace, &kinds, same)
            }
        };
        main.get_or_insert(kinds);
    }
}

/// `cue-1 1-2 ...`, or `from event 4: 2-5 ...`.
fn told(trace: &Trace, kinds: &[EventKind], same: usize) -> String {
    let some = kinds.iter().skip(same).take(TOLD);
    let mut words: Vec<String> = some.map(|kind| describe_kind(*kind, trace)).collect();
    if kinds.len() > same + TOLD {
        words.push("...".to_owned());
    }
    if words.is_empty() {
        words.push("nothing more".to_owned());
    }
    let list = words.join(" ");
    if same == 0 {
        list
    } else {
        format!("from event {}: {list}", same + 1)
    }
}
