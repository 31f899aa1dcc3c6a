//! What is known of one run, and what can be said of it.

use crate::compare::Comparison;
use crate::finding::Verdict;
use crate::law;
use crate::oracle::{Allowance, Oracle};
use crate::physics::invariants::Invariant;
use crate::scene::Scene;
use crate::trace::Trace;

/// Everything that is known of one run.
pub struct Evidence<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The run.
    pub trace: &'a Trace,
    /// What the engine promises of it.
    pub promises: &'a [Invariant],
    /// What an error may come from.
    pub allowance: Allowance,
    /// What the exact engine knows of the scene.
    pub oracle: Option<&'a Oracle>,
    /// The run against the exact one; `None` without one, for the exact run itself, and where no events were kept.
    pub comparison: Option<Comparison<'a>>,
    /// True where events were kept.
    pub events: bool,
    /// Distance of the mirrored run's end from the mirrored end, R.
    pub mirror: Option<f64>,
    /// Distance between the ends with the balls in another order, R.
    pub relabelled: Option<f64>,
    /// Distance from the start after running forth and back, R.
    pub reversal: Option<f64>,
}

/// When and where something was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FoundAt {
    /// s.
    pub time: f64,
    /// Balls concerned, by index in the scene.
    pub balls: Vec<usize>,
}

/// What a rule says of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The verdict; `None` for a figure that nothing forbids and nothing demands.
    pub verdict: Option<Verdict>,
    /// The figure, in the unit of the rule.
    pub value: Option<f64>,
    /// Where it was found.
    pub place: Option<FoundAt>,
    /// The verdict in words, with its figure; empty for one that holds.
    pub why: String,
}

impl Judgement {
    /// A figure within its bound.
    pub fn holds(value: impl Into<Option<f64>>) -> Self {
        Judgement {
            verdict: Some(Verdict::Holds),
            value: value.into(),
            place: None,
            why: String::new(),
        }
    }

    /// A figure that is not.
    pub fn of(
        verdict: Verdict,
        value: impl Into<Option<f64>>,
        place: Option<FoundAt>,
        why: String,
    ) -> Self {
        Judgement {
            verdict: Some(verdict),
            value: value.into(),
            place,
            why,
        }
    }
}

/// Of more balls only so many are named.
const NAMED: usize = 3;

impl Evidence<'_> {
    /// True if the engine promises an invariant.
    pub fn promises(&self, invariant: Invariant) -> bool {
        self.promises.contains(&invariant)
    }

    /// The run as it is held against invariants.
    pub(super) fn run(&self) -> law::Run<'_> {
        law::Run {
            scene: self.scene,
            trace: self.trace,
            ulp: self.allowance.ulp,
            events: self.events,
        }
    }

    /// Ball ids, `cue-1` for two; of many the first ones.
    pub fn names(&self, balls: &[usize]) -> String {
        let name = |&ball: &usize| self.scene.balls.get(ball).map_or("?", |b| b.id.as_str());
        let named: Vec<&str> = balls.iter().take(NAMED).map(name).collect();
        match balls.len().saturating_sub(NAMED) {
            0 => named.join("-"),
            more => format!("{} and {more} more", named.join("-")),
        }
    }
}

/// A number for a sentence: three significant digits, two where it is far from 1.
pub fn short(x: f64) -> String {
    if x != 0.0 && (1e-3..1e5).contains(&x.abs()) {
        let digits = (2 - x.abs().log10().floor() as i32).clamp(0, 5) as usize;
        format!("{x:.digits$}")
    } else if x == 0.0 {
        "0".to_owned()
    } else {
        format!("{x:.1e}")
    }
}
