//! Which setting is responsible where errors do not fall: the family's finest run again, with one parameter at a time taken from
//! the family of the same engine that does best.

use super::verdict::{Kind, in_order, median};
use super::{CostOutcome, Errors, Level, Measured, Point, Quantity, Runs};
use crate::engine::{Knob, KnobRole};
use crate::math::statistics::Distribution;
use crate::study::Configuration;
use serde_json::Value;
use std::collections::BTreeMap;

/// Every effective parameter of a run, by its key.
pub type Parameters = BTreeMap<String, Value>;

/// A parameter is responsible if changing it alone divides the error, or the gain of energy, by this or more.
const DIVIDES: f64 = 2.0;

/// Starts from which each change is run.
const STARTS: usize = 2;

/// A run for this search may take this much longer than the family's own finest one.
const LONGER: f64 = 4.0;

/// What was found about a family whose errors do not fall.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// The setting that parameters were taken from; `None` if no family of the engine does better.
    pub better: Option<String>,
    /// What was tried, the most effective first.
    pub tried: Vec<Substitution>,
    /// The same setting in the other precision of the engine, and its error, R, if it divides the error.
    pub arithmetic: Option<(String, f64)>,
}

/// One parameter changed alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Substitution {
    /// Its key.
    pub knob: String,
    /// Its value in the family, and the one tried.
    pub values: [String; 2],
    /// What it is judged by before and after: error of the final position, R, or energy gained, E0.
    pub measure: [f64; 2],
}

impl Substitution {
    /// True if it makes the difference.
    pub fn is_responsible(&self) -> bool {
        self.measure[1] * DIVIDES <= self.measure[0]
    }
}

impl Cause {
    /// The parameter that makes the most difference, if one does.
    pub fn responsible(&self) -> Option<&Substitution> {
        self.tried.first().filter(|first| first.is_responsible())
    }
}

/// Looks for the cause of every family that needs one.
pub fn find(outcome: &mut CostOutcome, runs: &mut Runs<'_>) {
    let causes: Vec<Option<Cause>> = (0..outcome.families.len())
        .map(|k| of_family(outcome, k, runs))
        .collect();
    for (measured, cause) in outcome.families.iter_mut().zip(causes) {
        measured.cause = cause;
    }
}

fn of_family(outcome: &CostOutcome, index: usize, runs: &mut Runs<'_>) -> Option<Cause> {
    let measured = &outcome.families[index];
    let kind = measured.verdict?.kind;
    if kind == Kind::Converging {
        return None;
    }
    let finest = measured.points.last()?;
    let mut cause = Cause {
        better: None,
        tried: Vec::new(),
        arithmetic: other_precision(outcome, measured),
    };
    // errors of runs that go another way than the oracle say nothing about a parameter
    let searched = kind == Kind::GainingEnergy || in_order(finest);
    let Some(model) = model(outcome, measured, finest).filter(|_| searched) else {
        return Some(cause);
    };
    cause.better = Some(model.level.column.label());
    let before = judged(kind, &first_starts(finest))?;
    let differing = differing(measured, finest, model);
    let levels: Vec<Level> = differing
        .iter()
        .map(|change| change.level.clone())
        .collect();
    // what was not tried is not innocent
    let errors: Option<Vec<_>> = runs.errors(&levels).into_iter().collect();
    for (change, (errors, _)) in differing.into_iter().zip(errors?) {
        if let Some(after) = judged(kind, &errors) {
            cause.tried.push(Substitution {
                knob: change.knob,
                values: change.values,
                measure: [before, after],
            });
        }
    }
    cause
        .tried
        .sort_by(|a, b| a.measure[1].total_cmp(&b.measure[1]));
    Some(cause)
}

/// What a family is judged by here.
fn judged(kind: Kind, errors: &[Errors]) -> Option<f64> {
    let of = |errors: &Errors| match kind {
        Kind::GainingEnergy => errors.gained,
        _ => errors.get(Quantity::FinalPosition),
    };
    let values: Option<Vec<f64>> = errors.iter().map(of).collect();
    Some(Distribution::of(values?)?.quantile(0.5))
}

/// The errors of the starts that a level with [`STARTS`] starts has too.
fn first_starts(point: &Point) -> Vec<Errors> {
    let all = point.errors.len();
    (0..STARTS)
        .filter_map(|k| point.errors.get(k * all / STARTS).copied())
        .collect()
}

/// The level to take parameters from: of the families of the engine that converge, or of its other precision if none does, the one
/// with the smallest error, as fine as a search may take.
fn model<'a>(outcome: &'a CostOutcome, measured: &Measured, finest: &Point) -> Option<&'a Point> {
    let engine = &measured.family.given.engine;
    // an engine in two precisions has one set of parameters
    let others = outcome.families.iter().filter(|other| {
        other.family.given.engine.family() == engine.family()
            && other
                .verdict
                .is_some_and(|verdict| verdict.kind == Kind::Converging)
    });
    let rank = |m: &Measured| {
        let error = m.verdict.and_then(|v| v.finest).unwrap_or(f64::INFINITY);
        (m.family.given.engine.id() != engine.id(), error)
    };
    let best = others.min_by(|a, b| {
        let (a, b) = (rank(a), rank(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    })?;
    let affordable = |point: &&Point| point.level.pace.cost <= LONGER * finest.level.pace.cost;
    best.points.iter().rev().find(affordable)
}

/// One parameter of the finest level with the value of the model.
struct Change {
    knob: String,
    values: [String; 2],
    level: Level,
}

fn differing(measured: &Measured, finest: &Point, model: &Point) -> Vec<Change> {
    let own = &finest.parameters;
    let engine = &finest.level.column.engine;
    let knobs = engine.knobs();
    let stands_for_others = |key: &String| {
        let is_preset = |knob: &Knob| knob.key == *key && knob.role == KnobRole::Preset;
        knobs.iter().any(is_preset)
    };
    let mut changes = Vec::new();
    for (knob, theirs) in &model.parameters {
        let swept = measured.family.knob.as_ref() == Some(knob);
        let Some(ours) = own.get(knob).filter(|ours| *ours != theirs && !swept) else {
            continue;
        };
        if stands_for_others(knob) {
            continue;
        }
        let setting = finest
            .level
            .column
            .setting
            .clone()
            .with(knob, plain(theirs));
        changes.push(Change {
            knob: knob.clone(),
            values: [plain(ours), plain(theirs)],
            level: Level {
                // the step is the one parameter that changes where the starts are
                pace: match engine.step(&setting) {
                    Some(step) if step != finest.level.pace.step => model.level.pace,
                    _ => finest.level.pace,
                },
                column: Configuration::with(engine, setting),
                phases: STARTS,
                size: None,
            },
        });
    }
    changes
}

/// The same setting in the engine's other precision, where its error is smaller by what counts.
fn other_precision(outcome: &CostOutcome, measured: &Measured) -> Option<(String, f64)> {
    let point = measured.points.last()?;
    let error = median(point, Quantity::FinalPosition)?;
    let own = &point.level.column;
    let points = outcome.families.iter().flat_map(|other| &other.points);
    let mut twins = points.filter(|twin| {
        let column = &twin.level.column;
        let (ours, theirs) = (
            own.engine.ulp(&own.setting),
            column.engine.ulp(&column.setting),
        );
        column.engine.family() == own.engine.family()
            && column.setting == own.setting
            && theirs < ours
    });
    let twin = twins.next()?;
    let other = median(twin, Quantity::FinalPosition)?;
    (other * DIVIDES <= error).then(|| (twin.level.column.engine.id().to_owned(), other))
}

/// A value as it is written after `=`.
fn plain(value: &Value) -> String {
    match value {
        Value::String(word) => word.clone(),
        other => other.to_string(),
    }
}
