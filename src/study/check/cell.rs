//! One scene in one column: its findings on every level but the ensembles'.

use super::item::{ENDING, PARTING, REFUSED, VERDICT, WORK};
use super::promises::{self, Broken};
use super::unit_of;
use crate::compare::{self, Comparison, Parting};
use crate::finding::{Finding, Verdict};
use crate::law::rerun::digest;
use crate::oracle::Oracle;
use crate::physics::invariants::Invariant;
use crate::scene::{Scene, SetName};
use crate::study::matrix::{Configuration, Runner};
use crate::study::stability::examine;
use crate::trace::{Event, Record, Trace};
use crate::words::describe_kind;

/// Time between two recorded samples of a stepping engine, s of simulated time.
const CADENCE: f64 = 0.01;

/// Metrics that mean something although the orders of collisions have parted: they look only at what came before.
const BEFORE_PARTING: [&str; 3] = ["until-parting", "order-strict", "order-tolerant"];

/// Metrics that say what is different where the orders part, counted up to there. Where they do not part both are 0, and held as such.
const AT_PARTING: [&str; 2] = ["order-missed", "order-phantom"];

/// What a cell found.
pub struct Found {
    /// Its findings.
    pub findings: Vec<Finding>,
    /// Promises that do not hold.
    pub broken: Vec<Broken>,
    /// Why nothing ran.
    pub refused: Option<String>,
    /// Digest of the run.
    pub bits: Option<String>,
    /// Rounding of the engine's scalar.
    pub ulp: f64,
}

/// Runs a cell and says what it finds.
pub fn run(
    scene: &Scene,
    column: &Configuration,
    oracle: Option<&Oracle>,
    runner: Runner<'_>,
) -> Found {
    let hard = scene.is_in(SetName::Hard);
    let promised = column.engine.promises(scene, &column.setting);
    // a verdict speaks of every image, a promise of those that are promised
    let wanted = |invariant: Invariant| hard || promised.contains(&invariant);
    let record = Record::Every(CADENCE.min(scene.duration / 4.0));
    let examined = match examine(scene, column, oracle, record, &wanted, runner) {
        Ok(examined) => examined,
        Err(why) => return refused(scene, column, why),
    };
    let trace = &examined.ran.trace;
    let (mut findings, broken) = promises::hold(scene, column, &examined, oracle, record, runner);
    let mut cell = Writer {
        scene,
        label: column.label(),
        findings: Vec::new(),
    };
    cell.errors(trace, oracle);
    if hard {
        cell.add(VERDICT, "", None, Some(examined.judged.verdict));
    }
    for (counter, count) in &trace.counters {
        cell.add(WORK, counter, Some(*count as f64), None);
    }
    findings.extend(cell.findings);
    Found {
        findings,
        broken,
        refused: None,
        bits: Some(digest(trace)),
        ulp: examined.judged.ulp,
    }
}

fn refused(scene: &Scene, column: &Configuration, why: String) -> Found {
    let mut cell = Writer {
        scene,
        label: column.label(),
        findings: Vec::new(),
    };
    cell.add(REFUSED, &why, None, Some(Verdict::CannotExpress));
    Found {
        findings: cell.findings,
        broken: Vec::new(),
        refused: Some(why),
        bits: None,
        ulp: f64::EPSILON,
    }
}

struct Writer<'a> {
    scene: &'a Scene,
    label: String,
    findings: Vec<Finding>,
}

impl Writer<'_> {
    fn add(
        &mut self,
        metric: &'static str,
        subject: &str,
        value: Option<f64>,
        verdict: Option<Verdict>,
    ) {
        self.findings.push(Finding {
            scene: self.scene.name.clone(),
            engine: self.label.clone(),
            metric,
            subject: subject.to_owned(),
            value,
            unit: unit_of(metric),
            verdict,
        });
    }

    /// Errors against the oracle up to the earlier of its horizon and the first different collision; what the trace says against itself
    /// as far as it can be believed.
    fn errors(&mut self, trace: &Trace, oracle: Option<&Oracle>) {
        let whole = oracle.is_none_or(Oracle::is_whole);
        let Some(oracle) = oracle.filter(|oracle| oracle.is_complete()) else {
            // no single answer: the run stands for itself
            self.add(ENDING, trace.ending.id(), Some(trace.end_time), None);
            let own = compare::of_trace(self.scene, &self.label, trace);
            self.findings.extend(own);
            return;
        };
        let comparison = Comparison::new(self.scene, trace, &oracle.trace).up_to(oracle.until);
        // collisions that swap within what the engine resolves are no parting
        let order = &comparison.order;
        let differs = order.tolerant < order.collisions.max(order.reference_collisions);
        let parting = order.parting.as_ref().filter(|_| differs);
        let parting = parting.filter(|parting| parting.time() < oracle.until);
        let believed = whole && parting.is_none();
        let end = believed.then_some(trace.end_time);
        self.add(ENDING, trace.ending.id(), end, None);
        if let Some(parting) = parting {
            let words = instead(parting, trace, &oracle.trace);
            self.add(PARTING, &words, Some(parting.time()), None);
        }
        if whole {
            let own = compare::of_trace(self.scene, &self.label, trace);
            self.findings.extend(own);
        }
        let within = oracle.trace.collisions();
        let within = within.filter(|event| event.time < oracle.until).count() as f64;
        let last = parting.map_or(oracle.until, Parting::time);
        let parted = parting.is_some();
        for mut finding in compare::of_pair(&comparison, &self.label) {
            let before = BEFORE_PARTING.contains(&finding.metric);
            if finding.metric.starts_with("order-") && before && !whole {
                finding.value = finding.value.map(|count| count.min(within));
            }
            let stopped = finding.metric == "stop-time"
                && stops_before(&finding.subject, trace, &oracle.trace, last);
            if believed || before || stopped {
                self.findings.push(finding);
            }
        }
        if parted {
            let found = compare::of_pair(&comparison.to_parting(), &self.label);
            let there = found.into_iter().filter(|f| AT_PARTING.contains(&f.metric));
            self.findings.extend(there);
        }
    }
}

/// True for a ball that has come to rest in both runs before `time`.
fn stops_before(ball: &str, trace: &Trace, reference: &Trace, time: f64) -> bool {
    let Some(index) = trace.balls.iter().position(|id| id == ball) else {
        return false;
    };
    let before = |trace: &Trace| {
        let stop = trace.stop_times.get(index).copied().flatten();
        stop.is_some_and(|stop| stop < time)
    };
    before(trace) && before(reference)
}

/// `2-5 instead of 2-4`.
fn instead(parting: &Parting, trace: &Trace, reference: &Trace) -> String {
    let name = |event: Option<Event>, trace: &Trace| {
        event.map_or("nothing".to_owned(), |e| describe_kind(e.kind, trace))
    };
    format!(
        "{} instead of {}",
        name(parting.event, trace),
        name(parting.reference, reference)
    )
}
