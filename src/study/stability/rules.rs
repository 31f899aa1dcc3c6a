//! The rules by which one run is judged: each reads the evidence and says in one sentence, with a figure, what it finds.
//!
//! Hard laws break: states that are no numbers, energy that grows, balls beyond cushions, balls that never stop, collisions that
//! are passed through. What is only less exact than its step or its scalar explains drifts.

use super::against;
use super::evidence::{Evidence, FoundAt, Judgement, short};
use crate::finding::{Hold, Tolerance, Verdict};
use crate::law::{self, Held, Law, energy, finite, image, momentum, outside, overlap, rest};
use crate::math::within;
use crate::oracle::{self, Oracle};
use crate::physics::State;
use crate::physics::invariants::Invariant;
use crate::trace::{Ending, Extremum, Trace};

/// One rule.
#[derive(Clone, Copy)]
pub struct Rule {
    /// Unique kebab-case name.
    pub id: &'static str,
    /// Unit of its figure; empty for a count.
    pub unit: &'static str,
    /// The invariant that it looks at; where an engine promises it, breaking the rule is a defect.
    pub law: Option<&'static Law>,
    /// What it demands, with the bound, in one sentence; of an invariant, what the rule adds to what that demands.
    pub adds: &'static str,
    /// Whether the figure counts something.
    pub counts: bool,
    /// Says what it finds; `None` where it does not apply.
    pub judge: fn(&Evidence<'_>) -> Option<Judgement>,
}

/// Every rule. Of several with the worst verdict the first speaks for the run.
pub const RULES: &[Rule] = &[
    Rule {
        adds: "the figure counts balls",
        ..of_law("finite", &finite::LAW, judge_finite)
    },
    of_law("energy-gained", &energy::LAW, judge_energy),
    Rule {
        id: "energy-lost",
        unit: "E0",
        law: None,
        adds: "where no law takes energy, as much is left at the end as there was, within the same rounding",
        counts: false,
        judge: lost,
    },
    of_law("outside", &outside::LAW, judge_outside),
    Rule {
        id: "order",
        unit: "",
        law: None,
        adds: "the collisions are those of the exact engine, in its order, up to the horizon; the figure counts those that agree. Another order \
               drifts where the step explains it: the two lie closer together than the engine may be late, a hit is missed that is a graze less \
               deep than a step goes, a miss becomes a hit by less than the engine may be off. It breaks where it does not",
        counts: true,
        judge: against::order,
    },
    Rule {
        adds: "the figure counts those that do not",
        ..of_law("still-moving", &rest::LAW, judge_rest)
    },
    Rule {
        adds: "deeper is a break, in between a drift",
        ..of_law("overlap", &overlap::LAW, judge_overlap)
    },
    Rule {
        adds: "where the engine promises it, more is a break, else a drift",
        ..of_law("momentum", &momentum::LAW, judge_momentum)
    },
    Rule {
        id: "from-exact",
        unit: "R",
        law: None,
        adds: "up to the first differing collision and the horizon no ball is farther from the exact engine's than first order explains, \
               2 v dt (1 + G_1 + ... + G_k) after k of them, and rounding; and never by more than R",
        counts: false,
        judge: against::distance,
    },
    Rule {
        id: "stop-time",
        unit: "s",
        law: None,
        adds: "balls stop when the exact engine's do, within a step and the time that friction takes for the error of a speed",
        counts: false,
        judge: against::stop_time,
    },
    of_law("mirror", &law::mirror::LAW, |e| {
        judge_image(e, e.mirror, Invariant::Mirror, "mirrored")
    }),
    of_law("relabelling", &law::relabelling::LAW, |e| {
        judge_image(e, e.relabelled, Invariant::Relabelling, "listed in reverse")
    }),
    Rule {
        adds: "demanded only of an engine that promises it",
        ..of_law("time-reversal", &law::time_reversal::LAW, reversal)
    },
    Rule {
        id: "answer",
        unit: "s",
        law: None,
        adds: "there is a single right answer: neither the engine nor the exact one ends because the scene has none; the figure is the time up \
               to which there is one",
        counts: false,
        judge: answer,
    },
];

/// A rule that judges by an invariant.
const fn of_law(
    id: &'static str,
    law: &'static Law,
    judge: fn(&Evidence<'_>) -> Option<Judgement>,
) -> Rule {
    Rule {
        id,
        unit: law.unit,
        law: Some(law),
        adds: "",
        counts: law.unit.is_empty(),
        judge,
    }
}

impl Rule {
    /// What it demands, with the bound, in one sentence.
    pub fn what(&self) -> String {
        let demands = self.law.map_or("", |law| law.what);
        let both = [demands, self.adds].into_iter();
        both.filter(|part| !part.is_empty())
            .collect::<Vec<_>>()
            .join("; ")
    }

    /// The invariant that it looks at.
    pub fn invariant(&self) -> Option<Invariant> {
        self.law.map(|law| law.invariant)
    }

    /// By how much an accepted figure of this rule may move, in an engine with rounding `ulp`.
    pub fn tolerance(&self, ulp: f64) -> Tolerance {
        let hold = if self.counts {
            Hold::Count
        } else {
            Hold::Figure
        };
        hold.tolerance(ulp)
    }
}

/// The rule called `id`.
pub fn rule(id: &str) -> Option<&'static Rule> {
    RULES.iter().find(|rule| rule.id == id)
}

fn place(extremum: &Extremum) -> FoundAt {
    let balls = [extremum.ball, extremum.other].into_iter().flatten();
    FoundAt {
        time: extremum.time,
        balls: balls.map(|ball| ball as usize).collect(),
    }
}

fn judge_finite(e: &Evidence<'_>) -> Option<Judgement> {
    if let Ending::NotFinite(spot) = &e.trace.ending {
        let balls: Vec<usize> = spot.balls.iter().map(|&ball| ball as usize).collect();
        let why = format!(
            "ball {} is no number at t = {} s: {}",
            e.names(&balls),
            short(spot.time),
            spot.why
        );
        let found = FoundAt {
            time: spot.time,
            balls,
        };
        let count = found.balls.len() as f64;
        return Some(Judgement::of(Verdict::Breaks, count, Some(found), why));
    }
    let strange: Vec<(usize, f64)> = finite::strange(e.trace)
        .map(|(ball, knot)| (ball, knot.time))
        .collect();
    let Some(&(ball, time)) = strange.first() else {
        return Some(Judgement::holds(0.0));
    };
    let why = format!(
        "ball {} is no number at t = {} s",
        e.names(&[ball]),
        short(time)
    );
    let found = FoundAt {
        time,
        balls: vec![ball],
    };
    let count = strange.len() as f64;
    Some(Judgement::of(Verdict::Breaks, count, Some(found), why))
}

/// What an invariant says of the run alone.
fn held(e: &Evidence<'_>, law: &Law) -> Option<Held> {
    match law.reads {
        law::Reads::Run(held) => held(&e.run()),
        law::Reads::Image(_) | law::Reads::Rerun => None,
    }
}

fn judge_energy(e: &Evidence<'_>) -> Option<Judgement> {
    let held = held(e, &energy::LAW)?;
    let part = held.seen.value;
    if held.holds() {
        return Some(Judgement::holds(part));
    }
    let unit = match energy::unit(e.scene)? {
        energy::Unit::Initial(_) => "of its energy",
        energy::Unit::Fall(_) => "m g R out of nothing",
    };
    let found = place(&held.seen);
    let why = format!(
        "gains {} {unit} at t = {} s, {}",
        short(part),
        short(found.time),
        whose(e, &found)
    );
    Some(Judgement::of(Verdict::Breaks, part, Some(found), why))
}

fn lost(e: &Evidence<'_>) -> Option<Judgement> {
    let whole = e.scene.initial_energy();
    if !energy::is_kept(e.scene) || whole == 0.0 || !e.trace.ending.is_complete() {
        return None;
    }
    let states: Option<Vec<State>> = e.trace.final_states().into_iter().collect();
    let part = 1.0 - e.scene.kinetic_energy(&states?) / whole;
    // an impact rounds down as easily as up
    if within(part.abs(), energy::bound(&e.run())) || (part < 0.0 && part.is_finite()) {
        return Some(Judgement::holds(part));
    }
    let why = format!("loses {} of its energy, which nothing takes", short(part));
    Some(Judgement::of(Verdict::Drifts, part, None, why))
}

/// `balls cue-1`.
fn whose(e: &Evidence<'_>, found: &FoundAt) -> String {
    let word = if found.balls.len() == 1 {
        "ball"
    } else {
        "balls"
    };
    format!("{word} {}", e.names(&found.balls))
}

fn judge_outside(e: &Evidence<'_>) -> Option<Judgement> {
    let held = held(e, &outside::LAW)?;
    let value = held.seen.value / e.scene.smallest_radius();
    if held.holds() {
        return Some(Judgement::holds(value));
    }
    let found = place(&held.seen);
    let why = format!(
        "ball {} is {} R outside at t = {} s, farther than it goes in a step",
        e.names(&found.balls),
        short(value),
        short(found.time)
    );
    Some(Judgement::of(Verdict::Breaks, value, Some(found), why))
}

fn judge_rest(e: &Evidence<'_>) -> Option<Judgement> {
    let (by_law, when) = must_rest_at(e)?;
    if !rest::applies(e.trace) {
        return None;
    }
    let moving = rest::moving(e.trace);
    if moving.is_empty() {
        return Some(Judgement::holds(0.0));
    }
    let verdict = if by_law {
        Verdict::Breaks
    } else {
        Verdict::Drifts
    };
    let why = format!(
        "ball {} still moves at the end, t = {} s; {} everything rests by {} s",
        e.names(&moving[..1]),
        short(e.trace.end_time),
        if by_law {
            "by the law of friction"
        } else {
            "in the exact engine"
        },
        short(when)
    );
    let count = moving.len() as f64;
    let found = FoundAt {
        time: e.trace.end_time,
        balls: moving,
    };
    Some(Judgement::of(verdict, count, Some(found), why))
}

/// When everything must have come to rest, s, and whether by law; `None` where nothing says so within the scene's time.
fn must_rest_at(e: &Evidence<'_>) -> Option<(bool, f64)> {
    let late = e.allowance.dt;
    let by_law = rest::latest(e.scene).filter(|latest| latest + late <= e.scene.duration);
    if let Some(latest) = by_law {
        return Some((true, latest));
    }
    if e.promises(Invariant::EverythingStops) {
        return Some((true, e.scene.duration));
    }
    let rest = e.oracle?;
    let known = rest.trace.ending == Ending::Rest && rest.is_whole();
    // an engine that is late by part of the time may end a little later
    let soon = rest.trace.end_time * (1.0 + f64::from(f32::EPSILON)) + late <= e.scene.duration;
    (known && soon).then_some((false, rest.trace.end_time))
}

fn judge_overlap(e: &Evidence<'_>) -> Option<Judgement> {
    let held = held(e, &overlap::LAW)?;
    let radius = e.scene.smallest_radius();
    let value = held.seen.value / radius;
    let pair = overlap::of_a_pair(&e.run());
    if within(held.seen.value, pair) {
        return Some(Judgement::holds(value));
    }
    let verdict = if !held.holds() || e.allowance.dt == 0.0 {
        Verdict::Breaks
    } else {
        Verdict::Drifts
    };
    let found = place(&held.seen);
    let why = format!(
        "balls {} overlap by {} R at t = {} s; a step explains {} R",
        e.names(&found.balls),
        short(value),
        short(found.time),
        short(pair / radius)
    );
    Some(Judgement::of(verdict, value, Some(found), why))
}

fn judge_momentum(e: &Evidence<'_>) -> Option<Judgement> {
    let held = held(e, &momentum::LAW)?;
    let unit = momentum::heaviest(e.scene) * e.scene.largest_speed();
    if unit == 0.0 {
        return None;
    }
    let value = held.seen.value / unit;
    if held.holds() {
        return Some(Judgement::holds(value));
    }
    let verdict = if e.promises(Invariant::Momentum) {
        Verdict::Breaks
    } else {
        Verdict::Drifts
    };
    let found = place(&held.seen);
    let why = format!(
        "the impact of {} at t = {} s misses {} m v0 of momentum",
        e.names(&found.balls),
        short(found.time),
        short(value)
    );
    Some(Judgement::of(verdict, value, Some(found), why))
}

/// Rounding grown over the whole run, R; infinite where its growth is not known.
pub fn rounding_grown(e: &Evidence<'_>) -> f64 {
    let Some(oracle) = e.oracle else {
        return f64::INFINITY;
    };
    let operations = e.allowance.steps as f64 + oracle.trace.collisions().count() as f64 + 1.0;
    let time = oracle.trace.end_time.min(e.scene.duration);
    let rounding = oracle::rounding(e.scene, operations, e.allowance.ulp, oracle.fastest, time);
    rounding * oracle.grown / e.scene.smallest_radius()
}

/// What steps make of the whole run, R; 0 without an oracle.
fn stepping(e: &Evidence<'_>) -> f64 {
    let radius = e.scene.smallest_radius();
    let off = |oracle: &Oracle| oracle.allowance(e.scene, &e.allowance, usize::MAX) / radius;
    let stepped = e.allowance.dt > 0.0;
    e.oracle.filter(|_| stepped).map_or(0.0, off)
}

fn judge_image(
    e: &Evidence<'_>,
    apart: Option<f64>,
    invariant: Invariant,
    how: &str,
) -> Option<Judgement> {
    let apart = apart?;
    let bound = image::bound(rounding_grown(e), stepping(e));
    if within(apart, bound) {
        return Some(Judgement::holds(apart));
    }
    // beyond the horizon nothing is demanded
    let known = e.oracle.is_some_and(Oracle::is_whole);
    let verdict = if e.promises(invariant) && known {
        Verdict::Breaks
    } else {
        Verdict::Drifts
    };
    let why = format!(
        "{how}, the scene ends {} R from where it should; step and rounding make {} R",
        short(apart),
        short(bound)
    );
    Some(Judgement::of(verdict, apart, None, why))
}

fn reversal(e: &Evidence<'_>) -> Option<Judgement> {
    let apart = e.reversal?;
    let oracle = e.oracle?;
    let known = e.promises(Invariant::TimeReversal) && oracle.is_whole();
    let bound = law::time_reversal::bound(rounding_grown(e), oracle.grown);
    if !known {
        return Some(Judgement {
            verdict: None,
            value: Some(apart),
            place: None,
            why: String::new(),
        });
    }
    // where growth is not known its bound is infinite, and still no place at infinity is the start
    if apart.is_finite() && apart <= bound {
        return Some(Judgement::holds(apart));
    }
    let why = format!(
        "forth and back it ends {} R from its start; rounding makes {} R",
        short(apart),
        short(bound)
    );
    Some(Judgement::of(Verdict::Breaks, apart, None, why))
}

fn answer(e: &Evidence<'_>) -> Option<Judgement> {
    let by = |who: &str, trace: &Trace| {
        let spot = trace.ending.spot()?;
        let balls: Vec<usize> = spot.balls.iter().map(|&ball| ball as usize).collect();
        let why = format!(
            "{who} ends as {} at t = {} s, balls {}: {}",
            trace.ending.id(),
            short(spot.time),
            e.names(&balls),
            spot.why
        );
        let found = FoundAt {
            time: spot.time,
            balls,
        };
        Some(Judgement::of(
            Verdict::Indeterminate,
            spot.time,
            Some(found),
            why,
        ))
    };
    if let Some(own) = by("it", e.trace).filter(|_| !matches!(e.trace.ending, Ending::NotFinite(_)))
    {
        return Some(own);
    }
    match e.oracle {
        None => Some(Judgement::of(
            Verdict::Indeterminate,
            None,
            None,
            oracle::NOTHING.to_owned(),
        )),
        Some(oracle) if !oracle.is_complete() => {
            by("no answer to hold it against: exact", &oracle.trace)
        }
        Some(_) => Some(Judgement::holds(None)),
    }
}
