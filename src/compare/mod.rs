//! Where two traces part. Reads traces, writes findings.
//!
//! [`METRICS`] is the list of what is measured; each metric is a file and one line here. The reference of a comparison is
//! an ordinary trace: the exact engine's wherever it has an answer.

mod alignment;
mod attribution;
mod closest;
mod contact;
mod divergence;
mod final_position;
mod judge;
mod order;
mod phase;
mod sanity;
mod stop_time;
mod sweep;
mod turned;

pub use alignment::{Order, Parting, align, align_to_parting};
pub use attribution::{Attribution, attribute, largest_distance_at_end, timing};
pub use closest::{ClosestHits, closest_hits};
pub use contact::{
    ContactHits, ContactPhase, apart, believed_phases, contact_phases, error_at_begin,
    error_at_end, hits_in,
};
pub use divergence::{Divergence, divergence};
pub use judge::{Overlap, deepest_overlap, worst_overlap};
pub use stop_time::stop_times;
pub use sweep::{Sweep, first_overlap, outside, sweep};

use crate::finding::{Finding, Hold};
use crate::scene::Scene;
use crate::trace::{Ending, Trace};

/// Two traces of one scene, with their collision orders aligned.
#[derive(Debug)]
pub struct Comparison<'a> {
    /// The scene of both.
    pub scene: &'a Scene,
    /// The trace in question.
    pub trace: &'a Trace,
    /// What it is held against.
    pub reference: &'a Trace,
    /// Their collision orders, aligned.
    pub order: Order,
    /// Their distance over time.
    pub divergence: Divergence,
    /// Time beyond which nobody can be right about the scene, s; infinite where the whole run can be believed.
    pub horizon: f64,
}

impl<'a> Comparison<'a> {
    /// Aligns `trace` with `reference`.
    pub fn new(scene: &'a Scene, trace: &'a Trace, reference: &'a Trace) -> Self {
        let order = align(trace, reference);
        let divergence = divergence(trace, reference);
        Comparison {
            scene,
            trace,
            reference,
            order,
            divergence,
            horizon: f64::INFINITY,
        }
    }

    /// The same comparison with the horizon of its reference, s: errors are quoted up to it.
    pub fn up_to(self, horizon: f64) -> Self {
        Comparison { horizon, ..self }
    }

    /// Latest time at which both traces say where the balls are, s; infinite when both ended at rest.
    pub fn common_end(&self) -> f64 {
        common_end(self.trace, self.reference)
    }

    /// The same comparison with its collision orders cut off where they have first differed.
    pub fn to_parting(self) -> Self {
        let order = align_to_parting(self.trace, self.reference);
        Comparison { order, ..self }
    }

    /// When the collision orders first differ, s: the earlier of the two events. `None` while they agree.
    pub fn parting_time(&self) -> Option<f64> {
        self.order.parting.as_ref().map(Parting::time)
    }
}

/// Latest time at which both traces say where the balls are, s; infinite when both ended at rest.
pub fn common_end(a: &Trace, b: &Trace) -> f64 {
    let end = |trace: &Trace| match trace.ending {
        Ending::Rest => f64::INFINITY,
        _ => trace.end_time,
    };
    end(a).min(end(b))
}

/// One value of a metric.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The ball or event concerned; empty for the whole run.
    pub subject: String,
    /// The value; `None` where there is none.
    pub value: Option<f64>,
}

impl Measured {
    fn of_run(value: impl Into<Option<f64>>) -> Vec<Measured> {
        vec![Measured {
            subject: String::new(),
            value: value.into(),
        }]
    }
}

/// What is read: one trace, or two.
#[derive(Clone, Copy)]
pub enum Reads {
    /// A property of a trace by itself.
    Trace(fn(&Scene, &Trace) -> Vec<Measured>),
    /// A difference between a trace and its reference.
    Pair(fn(&Comparison<'_>) -> Vec<Measured>),
}

/// One thing that is measured.
#[derive(Clone, Copy)]
pub struct Metric {
    /// Unique kebab-case name.
    pub id: &'static str,
    /// Unit; empty for a count or a ratio. `R` is the scene's smallest radius.
    pub unit: &'static str,
    /// How an accepted value is held.
    pub hold: Hold,
    /// Meaning, in one sentence.
    pub what: &'static str,
    /// How it is measured.
    pub reads: Reads,
}

/// Everything that is measured, in the order of reports.
pub const METRICS: &[Metric] = &[
    stop_time::STOP_TIME,
    stop_time::STILL_MOVING,
    final_position::FINAL_POSITION,
    final_position::UNTIL_PARTING,
    final_position::POCKETS,
    turned::TURNED,
    phase::PHASE_TIME,
    phase::PHASES,
    order::STRICT,
    order::TOLERANT,
    order::COLLISIONS,
    order::MISSED,
    order::PHANTOM,
    order::LATE,
    order::EXCHANGES,
    contact::EPISODES,
    contact::EXCHANGES,
    contact::APART,
    contact::ERROR_AT_BEGIN,
    contact::ERROR_AT_END,
    sanity::ENERGY_GAINED,
    sanity::ENERGY_LEFT_OUT,
    sanity::MOMENTUM,
    sanity::OVERLAP,
    judge::OVERLAP_BY_PARRY,
    sanity::OUTSIDE,
    sanity::DISPLACED,
    sanity::UNEXPLAINED,
];

/// The metric called `id`.
pub fn metric(id: &str) -> Option<&'static Metric> {
    METRICS.iter().find(|metric| metric.id == id)
}

/// Findings about one trace by itself. `engine`: label of the engine and its setting.
pub fn of_trace(scene: &Scene, engine: &str, trace: &Trace) -> Vec<Finding> {
    collect(scene, engine, |reads| match reads {
        Reads::Trace(measure) => measure(scene, trace),
        Reads::Pair(_) => Vec::new(),
    })
}

/// Findings about a trace against its reference. `engine`: label of the engine and its setting, or `a | b`.
pub fn of_pair(comparison: &Comparison<'_>, engine: &str) -> Vec<Finding> {
    collect(comparison.scene, engine, |reads| match reads {
        Reads::Trace(_) => Vec::new(),
        Reads::Pair(measure) => measure(comparison),
    })
}

fn collect(scene: &Scene, engine: &str, measure: impl Fn(Reads) -> Vec<Measured>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for metric in METRICS {
        findings.extend(measure(metric.reads).into_iter().map(|measured| Finding {
            scene: scene.name.clone(),
            engine: engine.to_owned(),
            metric: metric.id,
            subject: measured.subject,
            value: measured.value,
            unit: metric.unit,
            verdict: None,
        }));
    }
    findings
}
