//! One scene in several engines: where they part, when and why.
//!
//! Plan: one row of the matrix, the exact engine first. Conclusion: every engine against the exact one where it has an
//! answer, and every pair of the others; the first difference with its cause; what the divergence is made of.

mod causes;
mod contacts;

pub use causes::Cause;
pub use contacts::{Ablated, ContactStanding, MOSTLY, OwnError};

use super::Extent;
use super::matrix::{self, Cell, Configuration, Ran, Timing, Watch};
use crate::compare::{self, Attribution, Comparison, Order, attribute, largest_distance_at_end};
use crate::engine::{Limits, Refusal, Roster};
use crate::finding::Finding;
use crate::oracle::{self, Absence, Growth, Horizon, Lack, growth, horizon};
use crate::scene::Scene;
use crate::trace::{Ending, Record, Trace};

/// Time between two recorded samples of a stepping engine, s of simulated time.
const CADENCE: f64 = 0.01;

/// Growth is told of a scene of at most so many balls and events; `carom horizon` tells it for more.
const FEW_BALLS: usize = 32;
/// See [`FEW_BALLS`].
const FEW_EVENTS: usize = 400;

/// Everything that a comparison of one scene found.
#[derive(Debug)]
pub struct ComparisonOutcome {
    /// The scene.
    pub scene: Scene,
    /// One entry a column, the reference's among them.
    pub entries: Vec<ComparisonEntry>,
    /// Index of the entry that all others are held against; `None` where the exact engine has no answer.
    pub reference: Option<usize>,
    /// Why there is no reference: the kind of reason, and in one sentence.
    pub no_reference: Option<(Lack, String)>,
    /// Up to which event the reference can be believed; `None` without a reference, or with one in a precision that has no finer one.
    pub horizon: Option<Horizon>,
    /// How a perturbation of the reference grows: of a scene of few balls and events, since it takes a matrix an event.
    pub growth: Option<Growth>,
    /// Every pair of engines that ran, apart from the reference; those of different families first.
    pub pairs: Vec<PairOutcome>,
    /// Every number, with its address.
    pub findings: Vec<Finding>,
    /// Runs, searches and horizons that were done, of those that were to be done.
    pub extent: Extent,
}

/// One engine with one setting.
#[derive(Debug)]
pub struct ComparisonEntry {
    /// Engine and setting.
    pub column: Configuration,
    /// What ran, or why nothing did.
    pub cell: Cell,
    /// How it stands against the reference; `None` for the reference itself, without one, and after a refusal.
    pub standing: Option<Standing>,
}

/// How one trace stands against another.
#[derive(Clone, Debug)]
pub struct Standing {
    /// Both collision orders, aligned.
    pub order: Order,
    /// Why the orders differ where they first do.
    pub cause: Option<Cause>,
    /// What the divergence is made of.
    pub attribution: Attribution,
    /// Distance over time, s and R.
    pub divergence: Vec<[f64; 2]>,
    /// Largest distance between final positions, R.
    pub final_position: Option<f64>,
    /// What it has in place of each contact of the other that lasts.
    pub contacts: Vec<ContactStanding>,
}

/// Two engines of which neither is the reference.
#[derive(Debug)]
pub struct PairOutcome {
    /// Indices of the two entries.
    pub entries: (usize, usize),
    /// How the first stands against the second.
    pub standing: Standing,
}

impl ComparisonEntry {
    /// The trace, if the engine ran.
    pub fn trace(&self) -> Option<&Trace> {
        self.cell.as_ref().ok().map(|ran| &ran.trace)
    }

    /// Engine and setting as one label.
    pub fn label(&self) -> String {
        self.column.label()
    }
}

impl ComparisonOutcome {
    /// Every two runs that are held against each other: all against the reference, or all pairs without one.
    pub fn held(&self) -> Vec<(usize, usize, &Standing)> {
        match self.reference {
            Some(reference) => {
                let entries = self.entries.iter().enumerate();
                entries
                    .filter_map(|(i, entry)| Some((i, reference, entry.standing.as_ref()?)))
                    .collect()
            }
            None => {
                let pairs = self.pairs.iter();
                pairs
                    .map(|pair| (pair.entries.0, pair.entries.1, &pair.standing))
                    .collect()
            }
        }
    }

    /// The findings of one metric for one engine or pair.
    pub fn findings_of<'a>(
        &'a self,
        engine: &'a str,
        metric: &'a str,
    ) -> impl Iterator<Item = &'a Finding> {
        self.findings
            .iter()
            .filter(move |f| f.engine == engine && f.metric == metric)
    }

    /// Time up to which the reference can be believed, s; infinite for a whole shot, and where nothing is known.
    pub fn certain_until(&self) -> f64 {
        self.horizon.as_ref().map_or(f64::INFINITY, |h| h.until)
    }

    /// The worst value of a metric for one engine or pair, with the ball or event that owns it.
    pub fn worst(&self, engine: &str, metric: &str) -> Option<(f64, &str)> {
        let own = self
            .findings
            .iter()
            .filter(|f| f.engine == engine && f.metric == metric);
        let values = own.filter_map(|f| Some((f.value?, f.subject.as_str())));
        values.reduce(|worst, next| {
            if next.0 > worst.0 || next.0.is_nan() {
                next
            } else {
                worst
            }
        })
    }
}

/// The columns of a comparison when none are named: those of every engine that say so of themselves.
pub fn default_columns(roster: &Roster) -> Vec<Configuration> {
    Configuration::presets(roster, |preset| preset.compared)
}

/// The columns that run: the named ones, after the reference if it is not among them.
pub fn plan(roster: &Roster, named: &[Configuration]) -> Vec<Configuration> {
    let mut columns = named.to_vec();
    if !columns.iter().any(is_reference) {
        columns.extend(roster.find(oracle::engine().id()).map(Configuration::of));
    }
    // the reference stands first
    columns.sort_by_key(|column| !is_reference(column));
    columns
}

/// Runs the comparison of one scene.
///
/// `richer`: the scene that this one is a model of, if it is to be measured what this one leaves out.
pub fn study(
    scene: &Scene,
    richer: Option<&Scene>,
    columns: &[Configuration],
    timing: Timing,
    watch: Watch<'_>,
) -> ComparisonOutcome {
    let limits = Limits {
        cancelled: watch.cancelled,
        ..Limits::NONE
    };
    study_within(scene, richer, columns, timing, &limits, watch)
}

/// The same with runs that end early where `limits` say so.
pub fn study_within(
    scene: &Scene,
    richer: Option<&Scene>,
    columns: &[Configuration],
    timing: Timing,
    limits: &Limits<'_>,
    watch: Watch<'_>,
) -> ComparisonOutcome {
    let record = Record::Every(CADENCE);
    let cells = matrix::run_row_within(scene, columns, record, timing, limits, watch);
    let model =
        richer.map(|richer| limits.whole(|| model_error(scene, richer, columns, &cells, watch)));
    let mut outcome = conclude(scene, columns, cells, limits);
    if let Some(model) = &model {
        outcome.extent.count(model.is_some());
    }
    let model = model.flatten().flatten();
    for standing in outcome
        .entries
        .iter_mut()
        .filter_map(|entry| entry.standing.as_mut())
    {
        standing.attribution.model = model;
    }
    causes::find_causes(&mut outcome, watch);
    contacts::find_own_errors(&mut outcome, watch);
    outcome
}

/// Concludes from the cells of one scene. Reads only; causes that need further runs stay open.
fn conclude(
    scene: &Scene,
    columns: &[Configuration],
    cells: Vec<Cell>,
    limits: &Limits<'_>,
) -> ComparisonOutcome {
    let entries = columns.iter().cloned().zip(cells);
    let entries = entries
        .map(|(column, cell)| ComparisonEntry {
            column,
            cell,
            standing: None,
        })
        .collect();
    let mut outcome = ComparisonOutcome {
        scene: scene.clone(),
        entries,
        reference: None,
        no_reference: None,
        horizon: None,
        growth: None,
        pairs: Vec::new(),
        findings: Vec::new(),
        extent: Extent::default(),
    };
    for entry in &outcome.entries {
        let stopped = matches!(entry.cell, Err(Refusal::Stopped));
        outcome.extent.count(!stopped);
    }
    match reference(&outcome.entries) {
        Ok(index) => {
            outcome.reference = Some(index);
            if let Some(precision) = oracle::precision(&columns[index].setting) {
                let found = limits.whole(|| horizon(scene, precision, false, limits));
                outcome.extent.count(found.is_some());
                outcome.horizon = found.flatten();
                outcome.growth = growth_of(&outcome, limits);
            }
        }
        Err(absence) => {
            let why = absence.in_words(crate::words::describe_ending);
            outcome.no_reference = Some((absence.lack(), why));
        }
    }
    stand_alone(&mut outcome);
    against_reference(&mut outcome);
    in_pairs(&mut outcome);
    arithmetic(&mut outcome);
    outcome
}

/// The growth beside the horizon; `None` where that takes long, or the user asks to stop.
fn growth_of(outcome: &ComparisonOutcome, limits: &Limits<'_>) -> Option<Growth> {
    let horizon = outcome.horizon.as_ref()?;
    let scene = &outcome.scene;
    let small = scene.balls.len() <= FEW_BALLS && horizon.sights.len() <= FEW_EVENTS;
    let found = small.then(|| limits.whole(|| growth(scene, &horizon.trace, true, limits)));
    found.flatten().flatten()
}

/// True for a column of the engine that the others are held against.
fn is_reference(column: &Configuration) -> bool {
    oracle::is_reference(&*column.engine)
}

/// The reference's entry, if it reached the end that the scene asks for; else why not.
fn reference(entries: &[ComparisonEntry]) -> Result<usize, Absence<'_>> {
    let index = entries.iter().position(|entry| is_reference(&entry.column));
    let index = index.ok_or(Absence::NotAsked)?;
    let ran = entries[index].cell.as_ref().map(|ran| &ran.trace);
    oracle::answer(ran).map(|_| index)
}

fn stand_alone(outcome: &mut ComparisonOutcome) {
    for entry in &outcome.entries {
        if let Some(trace) = entry.trace() {
            outcome
                .findings
                .extend(compare::of_trace(&outcome.scene, &entry.label(), trace));
        }
    }
}

fn against_reference(outcome: &mut ComparisonOutcome) {
    let Some(index) = outcome.reference else {
        return;
    };
    let mut standings = Vec::new();
    for (i, entry) in outcome.entries.iter().enumerate() {
        let pair = entry
            .trace()
            .zip(outcome.entries[index].trace())
            .filter(|_| i != index);
        standings.push(pair.map(|(trace, reference)| {
            let comparison =
                Comparison::new(&outcome.scene, trace, reference).up_to(outcome.certain_until());
            let findings = compare::of_pair(&comparison, &entry.label());
            let attribution = attribute(&comparison);
            (Standing::new(comparison, attribution), findings)
        }));
    }
    for (entry, standing) in outcome.entries.iter_mut().zip(standings) {
        let Some((standing, findings)) = standing else {
            continue;
        };
        entry.standing = Some(standing);
        outcome.findings.extend(findings);
    }
}

impl Standing {
    fn new(comparison: Comparison<'_>, attribution: Attribution) -> Self {
        let radius = comparison.scene.smallest_radius();
        let in_radii = |&(time, distance): &(f64, f64)| [time, distance / radius];
        Standing {
            final_position: largest_distance_at_end(
                comparison.scene,
                comparison.trace,
                comparison.reference,
            ),
            divergence: comparison.divergence.points.iter().map(in_radii).collect(),
            contacts: ContactStanding::of(&comparison),
            order: comparison.order,
            cause: None,
            attribution,
        }
    }
}

/// Every pair of engines that ran, apart from the reference.
fn in_pairs(outcome: &mut ComparisonOutcome) {
    let ran: Vec<usize> = (0..outcome.entries.len())
        .filter(|&i| is_contender(outcome, i))
        .collect();
    let mut pairs: Vec<(usize, usize)> = Vec::new();
    for (k, &i) in ran.iter().enumerate() {
        pairs.extend(ran[k + 1..].iter().map(|&j| (i, j)));
    }
    // engines of different families first
    let family = |i: usize| outcome.entries[i].column.engine.family();
    pairs.sort_by_key(|&(i, j)| family(i) == family(j));
    for (i, j) in pairs {
        let (a, b) = (&outcome.entries[i], &outcome.entries[j]);
        let Some((ours, theirs)) = a.trace().zip(b.trace()) else {
            continue;
        };
        let comparison =
            Comparison::new(&outcome.scene, ours, theirs).up_to(outcome.certain_until());
        outcome
            .findings
            .extend(compare::of_pair(&comparison, &pair_label(a, b)));
        let standing = Standing::new(comparison, Attribution::default());
        outcome.pairs.push(PairOutcome {
            entries: (i, j),
            standing,
        });
    }
}

/// Label of a pair in findings.
pub fn pair_label(a: &ComparisonEntry, b: &ComparisonEntry) -> String {
    format!("{} | {}", a.label(), b.label())
}

fn is_contender(outcome: &ComparisonOutcome, i: usize) -> bool {
    outcome.entries[i].cell.is_ok() && !is_reference(&outcome.entries[i].column)
}

/// |the same engine in two precisions|, for engines of one family that have the same setting.
fn arithmetic(outcome: &mut ComparisonOutcome) {
    for k in 0..outcome.pairs.len() {
        let (i, j) = outcome.pairs[k].entries;
        let (a, b) = (&outcome.entries[i].column, &outcome.entries[j].column);
        let twins = a.engine.family() == b.engine.family() && a.engine.id() != b.engine.id();
        if twins && a.setting == b.setting {
            let apart = outcome.pairs[k].standing.final_position;
            outcome.pairs[k].standing.attribution.arithmetic = apart;
            for index in [i, j] {
                if let Some(standing) = outcome.entries[index].standing.as_mut() {
                    standing.attribution.arithmetic = apart;
                }
            }
        }
    }
}

/// |exact(scene) - exact(richer)|, R; `None` where either has no complete run.
fn model_error(
    scene: &Scene,
    richer: &Scene,
    columns: &[Configuration],
    cells: &[Cell],
    watch: Watch<'_>,
) -> Option<f64> {
    let exact = columns.iter().position(is_reference)?;
    let complete = |ran: &Ran| matches!(ran.trace.ending, Ending::Rest | Ending::Duration);
    let ours = cells[exact].as_ref().ok().filter(|ran| complete(ran))?;
    let cells = matrix::run_row(
        richer,
        &columns[exact..=exact],
        Record::Events,
        Timing::None,
        watch,
    );
    let theirs = cells.first()?.as_ref().ok().filter(|ran| complete(ran))?;
    largest_distance_at_end(scene, &ours.trace, &theirs.trace)
}
