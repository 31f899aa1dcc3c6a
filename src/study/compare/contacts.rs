//! Contacts that last, engine by engine: what each has in place of one, what it makes of it by itself, and why.
//!
//! The places at the end of a contact have all errors before it in them. So each engine is started once more where the contact begins, in
//! the states of the reference, and run to its end: what it is off by then is its own. Two things are tried on that: the ablations of the
//! engine, each alone, and each ball of the contact without the other.

use super::ComparisonOutcome;
use crate::compare::{
    self, Comparison, ContactHits, ContactPhase, believed_phases, error_at_begin, error_at_end,
};
use crate::engine::{Name, Setting};
use crate::math::worse;
use crate::scene::Scene;
use crate::study::matrix::{Configuration, Timing, Watch, run_row};
use crate::trace::{EventKind, Record, Trace};

/// What one engine has in place of a contact of the reference that lasts. Lengths in R.
#[derive(Clone, Debug)]
pub struct ContactStanding {
    /// The contact.
    pub phase: ContactPhase,
    /// Hits of the same two.
    pub hits: ContactHits,
    /// Farthest that they are apart while the reference has them in contact; negative where they overlap throughout.
    pub apart: Option<f64>,
    /// Distance from the reference where the contact begins.
    pub error_at_begin: Option<f64>,
    /// The same where it ends.
    pub error_at_end: Option<f64>,
    /// True where the contact is over before a step of the engine is.
    pub is_short: bool,
    /// What the engine makes of it by itself; `None` where it does not step, for a contact that is short, and for those after the first 12.
    pub own: Option<OwnError>,
}

/// What an engine is off by at the end of a contact when it is started in the states of the reference where it begins. Lengths in R.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnError {
    /// Distance from the reference at the end, the farther ball's.
    pub error: f64,
    /// The same of a ball of the contact that is alone on the table, from where the reference has such a ball; `None` for a ball at a
    /// cushion, which goes elsewhere without it.
    pub alone: Option<f64>,
    /// Exchanges between the two on the way.
    pub exchanges: u64,
    /// The ablations of the engine that ran.
    pub ablations: Vec<Ablated>,
}

/// An error with one source of it removed.
#[derive(Clone, Debug, PartialEq)]
pub struct Ablated {
    /// What is removed, or made smaller.
    pub what: Name,
    /// The setting that does so.
    pub setting: Setting,
    /// By what factor the step is smaller; 1 for what does not touch it.
    pub finer: f64,
    /// The error that is left, R.
    pub error: f64,
}

impl Ablated {
    /// True if so little of `error` is left that it comes from there: of an error of first order the part by which the step is finer, here
    /// no more than twice that; of anything else no more than half.
    pub fn explains(&self, error: f64) -> bool {
        let parts = match self.finer > 1.0 {
            true => self.finer / MOSTLY,
            false => MOSTLY,
        };
        self.error * parts <= error
    }
}

/// An error is mostly what more than one in so many parts of it are.
pub const MOSTLY: f64 = 2.0;

/// Contacts of a scene that are run once more, the first ones: each takes some runs of every engine, with all balls.
const MOST_ASKED: usize = 12;

impl ContactStanding {
    /// What a trace has in place of each contact of the reference that can be believed; what the engine makes of it is asked later.
    pub(super) fn of(comparison: &Comparison<'_>) -> Vec<Self> {
        let standing = |phase: ContactPhase| ContactStanding {
            hits: compare::hits_in(comparison, &phase),
            apart: compare::apart(comparison, comparison.trace, &phase),
            error_at_begin: error_at_begin(comparison, &phase),
            error_at_end: error_at_end(comparison, &phase),
            is_short: phase.end - phase.begin < comparison.trace.provenance.resolution,
            own: None,
            phase,
        };
        believed_phases(comparison)
            .into_iter()
            .map(standing)
            .collect()
    }
}

/// Runs each engine that steps through each contact once more, from where the reference has it begin.
pub(super) fn find_own_errors(outcome: &mut ComparisonOutcome, watch: Watch<'_>) {
    let Some((index, reference)) = outcome
        .reference
        .and_then(|i| Some((i, outcome.entries[i].trace()?)))
    else {
        return;
    };
    let solver = &outcome.entries[index].column;
    let mut found = Vec::new();
    for (i, entry) in outcome.entries.iter().enumerate() {
        let Some((standing, trace)) = entry.standing.as_ref().zip(entry.trace()) else {
            continue;
        };
        for (k, contact) in standing.contacts.iter().enumerate().take(MOST_ASKED) {
            let is_told = contact.error_at_end.is_some() && !contact.is_short;
            if !is_told || trace.provenance.resolution == 0.0 {
                continue;
            }
            let again = Again::new(&outcome.scene, reference, contact.phase);
            let own =
                watch.whole(|| again.and_then(|again| again.own(&entry.column, solver, watch)));
            outcome.extent.count(own.is_some());
            found.push((i, k, own.flatten()));
        }
    }
    for (i, k, own) in found {
        if let Some(standing) = outcome.entries[i].standing.as_mut() {
            standing.contacts[k].own = own;
        }
    }
}

/// A contact once more: from the states in which it begins to its end, with the balls that are in play there.
struct Again<'a> {
    scene: Scene,
    /// Index in the scene of the comparison of each ball.
    balls: Vec<usize>,
    phase: ContactPhase,
    reference: &'a Trace,
    /// R of the scene of the comparison, length.
    radius: f64,
}

impl<'a> Again<'a> {
    /// `None` where a ball of the contact leaves play.
    fn new(scene: &Scene, reference: &'a Trace, phase: ContactPhase) -> Option<Self> {
        let mut again = Again {
            scene: Scene {
                duration: phase.end - phase.begin,
                run_to_duration: false,
                shot: None,
                balls: Vec::new(),
                ..scene.clone()
            },
            balls: Vec::new(),
            phase,
            reference,
            radius: scene.smallest_radius(),
        };
        for (index, ball) in scene.balls.iter().enumerate() {
            let Some(state) = reference.in_play_at(index, phase.begin) else {
                continue;
            };
            let mut ball = ball.clone();
            ball.state = state;
            again.scene.balls.push(ball);
            again.balls.push(index);
        }
        let stays = |ball| reference.in_play_at(ball, phase.end).is_some();
        let held = phase
            .balls()
            .all(|ball| again.balls.contains(&ball) && stays(ball));
        held.then_some(again)
    }

    /// What an engine makes of it. `solver`: the column of the reference.
    fn own(
        &self,
        column: &Configuration,
        solver: &Configuration,
        watch: Watch<'_>,
    ) -> Option<OwnError> {
        let step = |setting: &Setting| {
            let pace = column.engine.pace(&self.scene, setting);
            pace.map_or(0.0, |pace| pace.step)
        };
        let ablations = column.engine.ablations(&self.scene, &column.setting);
        let mut columns = vec![column.clone()];
        let settings = ablations.iter().map(|(_, setting)| setting.clone());
        columns.extend(settings.map(|setting| Configuration::with(&column.engine, setting)));
        let mut runs = runs(&self.scene, &columns, watch).into_iter();
        let own = runs.next()??;
        let ran = ablations.into_iter().zip(runs);
        let ablated = ran.filter_map(|((what, setting), trace)| {
            Some(Ablated {
                what,
                finer: step(&column.setting) / step(&setting),
                setting,
                error: self.error(&trace?)?,
            })
        });
        let hits = own.events.iter().filter(|event| event.kind == self.hit());
        Some(OwnError {
            error: self.error(&own)?,
            alone: match self.phase.hit {
                EventKind::BallBall(..) => self.alone(column, solver, watch),
                _ => None,
            },
            exchanges: hits.filter_map(|event| event.exchanges).sum(),
            ablations: ablated.collect(),
        })
    }

    /// Index of a ball among those of this run.
    fn place(&self, ball: usize) -> Option<usize> {
        self.balls.iter().position(|own| *own == ball)
    }

    /// What a hit of the two is in this run.
    fn hit(&self) -> EventKind {
        let place = |ball: u32| self.place(ball as usize).unwrap_or_default();
        match self.phase.hit {
            EventKind::BallBall(a, b) => EventKind::ball_ball(place(a), place(b)),
            EventKind::BallCushion(a, side) => EventKind::BallCushion(place(a) as u32, side),
            other => other,
        }
    }

    /// Distance from the reference at the end of the farther ball of the contact, R. `None` where one left play, or the run did not come so far.
    fn error(&self, trace: &Trace) -> Option<f64> {
        if !trace.ending.is_complete() {
            return None;
        }
        let distance = |ball: usize| {
            let ours = trace.in_play_at(self.place(ball)?, self.scene.duration)?;
            let theirs = self.reference.in_play_at(ball, self.phase.end)?;
            Some((ours.position - theirs.position).xy().norm())
        };
        let distances: Option<Vec<f64>> = self.phase.balls().map(distance).collect();
        Some(distances?.into_iter().reduce(worse)? / self.radius)
    }

    /// The largest distance between the ends of an engine and of the reference for a ball of the contact that is alone on the table, R.
    fn alone(
        &self,
        column: &Configuration,
        solver: &Configuration,
        watch: Watch<'_>,
    ) -> Option<f64> {
        let mut largest = None;
        for ball in self.phase.balls() {
            let mut scene = self.scene.clone();
            scene.balls = vec![scene.balls[self.place(ball)?].clone()];
            let ends: Option<Vec<Trace>> = runs(&scene, &[column.clone(), solver.clone()], watch)
                .into_iter()
                .collect();
            let ends = ends?;
            let [ours, theirs] = ends.as_slice() else {
                return None;
            };
            let place = |trace: &Trace| trace.in_play_at(0, scene.duration);
            let apart = (place(ours)?.position - place(theirs)?.position)
                .xy()
                .norm();
            largest = Some(largest.map_or(apart, |known| worse(known, apart)));
        }
        Some(largest? / self.radius)
    }
}

/// The traces of a scene in each column; `None` for one that did not run.
fn runs(scene: &Scene, columns: &[Configuration], watch: Watch<'_>) -> Vec<Option<Trace>> {
    let silent = Watch {
        progress: &|_, _, _| {},
        cancelled: watch.cancelled,
    };
    run_row(scene, columns, Record::Events, Timing::None, silent)
        .into_iter()
        .map(|cell| cell.ok().map(|ran| ran.trace))
        .collect()
}
