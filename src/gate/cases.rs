//! Hard cases held against what was accepted of them: one scene of a matrix.

use super::{Accepted, Change, Row, contradictions, diff};
use crate::finding::Verdict;
use crate::study::stability::{Reach, StabilityOutcome, reach_of};
use std::collections::BTreeMap;

/// How one scene of a matrix stands to what was accepted of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HeldCases {
    /// The scene is not what it was when its findings were accepted.
    pub stale: bool,
    /// What its file says of itself that is not so.
    pub contradictions: Vec<String>,
    /// What differs.
    pub changes: Vec<Change>,
    /// Findings of runs that only a full matrix makes, of which nothing was accepted.
    pub new: usize,
    /// Accepted findings that are not held, because only a full matrix makes their runs.
    pub left_out: usize,
}

/// Holds the scene with this index. `some`: only some engines were asked, so that the others are not missed.
///
/// A run that was left out is not missed. One that no matrix has any more, or that is out of every matrix's reach, is: what was accepted of
/// it would be held by nothing.
pub fn hold_cases(
    outcome: &StabilityOutcome,
    scene: usize,
    accepted: &Accepted,
    some: bool,
) -> HeldCases {
    let own_scene = &outcome.question.scenes[scene];
    let case = |row: &Row| {
        let mut own = outcome.of_scene(scene);
        own.find(|case| case.planned.column.label() == row.engine)
    };
    let oracle = outcome.oracles[scene].as_ref();
    let mut reaches: BTreeMap<&str, Option<Reach>> = BTreeMap::new();
    let mut held = HeldCases {
        stale: accepted.hash != own_scene.hash(),
        // files of hard cases have no digests
        contradictions: contradictions(accepted, &own_scene.name, &[]),
        ..HeldCases::default()
    };
    let mut old: Vec<Row> = Vec::new();
    for row in &accepted.rows {
        let is_held = match case(row) {
            Some(case) => case.judged.is_some() || case.planned.reach == Reach::Never,
            None if some => reaches
                .entry(row.engine.as_str())
                .or_insert_with(|| {
                    reach_of(&outcome.question.roster, own_scene, oracle, &row.engine)
                })
                .is_none(),
            None => true,
        };
        if is_held {
            old.push(row.clone());
        } else if case(row).is_some() {
            held.left_out += 1;
        }
    }
    // an engine that refuses the scene, and of which nothing was ever accepted, is shown and holds nothing
    let refused = |row: &Row| {
        let judged = case(row).and_then(|case| case.judged.as_ref());
        let cannot = judged.is_some_and(|judged| judged.verdict == Verdict::CannotExpress);
        cannot && !old.iter().any(|known| known.engine == row.engine)
    };
    let found = outcome.findings(scene);
    let found = found.iter().map(Row::from).filter(|row| !refused(row));
    let only_full = |row: &Row| case(row).is_some_and(|case| case.planned.reach == Reach::Full);
    let (new, now): (Vec<Row>, Vec<Row>) = found
        .partition(|row| only_full(row) && !old.iter().any(|known| known.engine == row.engine));
    held.new = new.len();
    held.changes = diff(&old, &now, |row| outcome.tolerance(&row.engine, &row.check));
    held
}
