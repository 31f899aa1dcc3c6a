//! The rules by which one run is judged: each reads the evidence and says in one sentence, with a figure, what it finds.
//!
//! Hard laws break: states that are no numbers, energy that grows, balls beyond cushions, balls that never stop, collisions that
//! are passed through. What is only less exact than its step or its scalar explains drifts.

use super::against;
use super::images::{is_finite, is_reversible};
use crate::compare::Comparison;
use crate::finding::{Hold, Tolerance, Verdict};
use crate::math::{within, worse};
use crate::oracle::{self, Allowance, Oracle, fastest};
use crate::physics::invariants::Invariant;
use crate::physics::{Cloth, State};
use crate::scene::Scene;
use crate::trace::{Ending, Extremum, Trace};

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
pub struct Place {
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
    pub place: Option<Place>,
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
        place: Option<Place>,
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

/// One rule.
#[derive(Clone, Copy)]
pub struct Rule {
    /// Unique kebab-case name.
    pub id: &'static str,
    /// Unit of its figure; empty for a count.
    pub unit: &'static str,
    /// What it demands, with the bound, in one sentence.
    pub what: &'static str,
    /// The invariant that it looks at; where an engine promises it, breaking the rule is a defect.
    pub invariant: Option<Invariant>,
    /// Whether the figure counts something.
    pub counts: bool,
    /// Says what it finds; `None` where it does not apply.
    pub judge: fn(&Evidence<'_>) -> Option<Judgement>,
}

/// Every rule. Of several with the worst verdict the first speaks for the run.
pub const RULES: &[Rule] = &[
    Rule {
        id: "finite",
        unit: "",
        what: "no state is NaN or infinite; the figure counts balls",
        invariant: Some(Invariant::Finite),
        counts: true,
        judge: finite,
    },
    Rule {
        id: "energy-gained",
        unit: "E0",
        what: "kinetic energy rises above an earlier level by no more than rounding, 16 ulp an impact in each substep; where nothing moves, in m g R",
        invariant: Some(Invariant::EnergyNeverGrows),
        counts: false,
        judge: energy,
    },
    Rule {
        id: "energy-lost",
        unit: "E0",
        what: "where no law takes energy, as much is left at the end as there was, within the same rounding",
        invariant: None,
        counts: false,
        judge: lost,
    },
    Rule {
        id: "outside",
        unit: "R",
        what: "no centre is farther beyond where the cushions let it be than the fastest ball goes in a step, and rounding",
        invariant: Some(Invariant::Bounds),
        counts: false,
        judge: outside,
    },
    Rule {
        id: "order",
        unit: "",
        what: "the collisions are those of the exact engine, in its order, up to the horizon; the figure counts those that agree. Another order \
               drifts where the step explains it: the two lie closer together than the engine may be late, a hit is missed that is a graze less \
               deep than a step goes, a miss becomes a hit by less than the engine may be off. It breaks where it does not",
        invariant: None,
        counts: true,
        judge: against::order,
    },
    Rule {
        id: "still-moving",
        unit: "",
        what: "balls that the law of friction stops within the scene's time do stop; the figure counts those that do not",
        invariant: Some(Invariant::EverythingStops),
        counts: true,
        judge: stops,
    },
    Rule {
        id: "overlap",
        unit: "R",
        what: "balls overlap by no more than two of the fastest approach in a step, and by that times one less than their number in a group, \
               whose exchanges sort its velocities in as many steps; deeper is a break, in between a drift",
        invariant: Some(Invariant::Overlap),
        counts: false,
        judge: overlap,
    },
    Rule {
        id: "momentum",
        unit: "m v0",
        what: "impacts of two balls keep their momentum within 64 ulp; where the engine promises it, more is a break, else a drift",
        invariant: Some(Invariant::Momentum),
        counts: false,
        judge: momentum,
    },
    Rule {
        id: "from-exact",
        unit: "R",
        what: "up to the first differing collision and the horizon no ball is farther from the exact engine's than first order explains, \
               2 v dt (1 + G_1 + ... + G_k) after k of them, and rounding; and never by more than R",
        invariant: None,
        counts: false,
        judge: against::distance,
    },
    Rule {
        id: "stop-time",
        unit: "s",
        what: "balls stop when the exact engine's do, within a step and the time that friction takes for the error of a speed",
        invariant: None,
        counts: false,
        judge: against::stop_time,
    },
    Rule {
        id: "mirror",
        unit: "R",
        what: "the mirrored scene ends in the mirrored places, within rounding times the growth, or twice what its steps make of it, and R",
        invariant: Some(Invariant::Mirror),
        counts: false,
        judge: |e| image(e, e.mirror, Invariant::Mirror, "mirrored"),
    },
    Rule {
        id: "relabelling",
        unit: "R",
        what: "the scene with its balls listed in reverse ends in the same places, within the same",
        invariant: Some(Invariant::Relabelling),
        counts: false,
        judge: |e| image(e, e.relabelled, Invariant::Relabelling, "listed in reverse"),
    },
    Rule {
        id: "time-reversal",
        unit: "R",
        what: "where nothing dissipates, running back from the end leads to the start: demanded only of an engine that promises it",
        invariant: Some(Invariant::TimeReversal),
        counts: false,
        judge: reversal,
    },
    Rule {
        id: "answer",
        unit: "s",
        what: "there is a single right answer: neither the engine nor the exact one ends because the scene has none; the figure is the time up \
               to which there is one",
        invariant: None,
        counts: false,
        judge: answer,
    },
];

impl Rule {
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

impl Evidence<'_> {
    /// True if the engine promises an invariant.
    pub fn promises(&self, invariant: Invariant) -> bool {
        self.promises.contains(&invariant)
    }

    /// By what part rounding may raise an energy: 16 ulp for each impact, in each substep in which it is solved.
    fn energy_rounding(&self) -> f64 {
        let count = |name: &str| self.trace.counters.get(name).copied();
        let impacts = count("exchanges")
            .unwrap_or(0)
            .max(self.trace.events.len() as u64);
        let substeps = match (count("substeps"), count("steps")) {
            (Some(substeps), Some(steps)) if steps > 0 => (substeps / steps).max(1),
            _ => 1,
        };
        16.0 * self.allowance.ulp * (impacts as f64 + 1.0) * substeps as f64
    }

    /// The largest speed that was seen, length/s; the largest possible one where only the ends were.
    fn fastest(&self) -> f64 {
        if self.events {
            fastest(self.trace)
        } else {
            self.scene.fastest()
        }
    }

    /// Rounding of a coordinate, length.
    fn rounding(&self) -> f64 {
        self.scene.touching() + 8.0 * self.allowance.ulp * self.scene.largest_coordinate()
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

fn place(extremum: &Extremum) -> Place {
    let balls = [extremum.ball, extremum.other].into_iter().flatten();
    Place {
        time: extremum.time,
        balls: balls.map(|ball| ball as usize).collect(),
    }
}

fn finite(e: &Evidence<'_>) -> Option<Judgement> {
    if let Ending::NotFinite(spot) = &e.trace.ending {
        let balls: Vec<usize> = spot.balls.iter().map(|&ball| ball as usize).collect();
        let why = format!(
            "ball {} is no number at t = {} s: {}",
            e.names(&balls),
            short(spot.time),
            spot.why
        );
        let found = Place {
            time: spot.time,
            balls,
        };
        let count = found.balls.len() as f64;
        return Some(Judgement::of(Verdict::Breaks, count, Some(found), why));
    }
    let first_bad = |(ball, path): (usize, &crate::trace::Path)| {
        let knot = path.knots.iter().find(|knot| !is_finite(&knot.state))?;
        Some((ball, knot.time))
    };
    let bad: Vec<(usize, f64)> = e
        .trace
        .paths
        .iter()
        .enumerate()
        .filter_map(first_bad)
        .collect();
    let Some(&(ball, time)) = bad.first() else {
        return Some(Judgement::holds(0.0));
    };
    let why = format!(
        "ball {} is no number at t = {} s",
        e.names(&[ball]),
        short(time)
    );
    let found = Place {
        time,
        balls: vec![ball],
    };
    Some(Judgement::of(
        Verdict::Breaks,
        bad.len() as f64,
        Some(found),
        why,
    ))
}

fn energy(e: &Evidence<'_>) -> Option<Judgement> {
    let gained = e.trace.extrema.energy_gained;
    let (whole, unit) = energy_unit(e)?;
    let part = gained.value / whole;
    if within(part, e.energy_rounding()) {
        return Some(Judgement::holds(part));
    }
    let found = place(&gained);
    let why = format!(
        "gains {} {unit} at t = {} s, {}",
        short(part),
        short(found.time),
        whose(e, &found)
    );
    Some(Judgement::of(Verdict::Breaks, part, Some(found), why))
}

/// What energies are measured in, and its name: the initial energy, or where nothing moves that of a fall by a radius; `None` without either.
fn energy_unit(e: &Evidence<'_>) -> Option<(f64, &'static str)> {
    let initial = e.scene.initial_energy();
    if initial > 0.0 {
        return Some((initial, "of its energy"));
    }
    let heaviest = e.scene.balls.iter().map(|b| b.mass).fold(0.0, f64::max);
    let fall = heaviest * e.scene.gravity * e.scene.smallest_radius();
    (fall > 0.0).then_some((fall, "m g R out of nothing"))
}

fn lost(e: &Evidence<'_>) -> Option<Judgement> {
    let whole = e.scene.initial_energy();
    if !is_reversible(e.scene) || whole == 0.0 || !e.trace.ending.is_complete() {
        return None;
    }
    let states: Option<Vec<State>> = e.trace.final_states().into_iter().collect();
    let part = 1.0 - e.scene.kinetic_energy(&states?) / whole;
    // an impact rounds down as easily as up
    if within(part.abs(), e.energy_rounding()) || (part < 0.0 && part.is_finite()) {
        return Some(Judgement::holds(part));
    }
    let why = format!("loses {} of its energy, which nothing takes", short(part));
    Some(Judgement::of(Verdict::Drifts, part, None, why))
}

/// `balls cue-1`.
fn whose(e: &Evidence<'_>, found: &Place) -> String {
    let word = if found.balls.len() == 1 {
        "ball"
    } else {
        "balls"
    };
    format!("{word} {}", e.names(&found.balls))
}

fn outside(e: &Evidence<'_>) -> Option<Judgement> {
    e.scene.effects.cushion?;
    e.scene.table?;
    let farthest = e.trace.extrema.outside;
    let radius = e.scene.smallest_radius();
    let value = worse(0.0, farthest.value);
    if within(value, e.fastest() * e.allowance.dt + e.rounding()) {
        return Some(Judgement::holds(value / radius));
    }
    let found = place(&farthest);
    let why = format!(
        "ball {} is {} R outside at t = {} s, farther than the fastest ball goes in a step",
        e.names(&found.balls),
        short(value / radius),
        short(found.time)
    );
    Some(Judgement::of(
        Verdict::Breaks,
        value / radius,
        Some(found),
        why,
    ))
}

fn stops(e: &Evidence<'_>) -> Option<Judgement> {
    let (by_law, when) = must_rest_at(e)?;
    if !matches!(e.trace.ending, Ending::Rest | Ending::Duration) {
        return None;
    }
    let rest = e.trace.provenance.rest_speed;
    let states = e.trace.final_states();
    let moving: Vec<usize> = states
        .iter()
        .enumerate()
        .filter(|(_, state)| state.is_some_and(|s| s.speed().is_nan() || s.speed() > rest))
        .map(|(ball, _)| ball)
        .collect();
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
    let found = Place {
        time: e.trace.end_time,
        balls: moving.clone(),
    };
    Some(Judgement::of(
        verdict,
        moving.len() as f64,
        Some(found),
        why,
    ))
}

/// When everything must have come to rest, s, and whether by law; `None` where nothing says so within the scene's time.
fn must_rest_at(e: &Evidence<'_>) -> Option<(bool, f64)> {
    let late = e.allowance.dt;
    if let Some(Cloth::Translational { mu }) = e.scene.effects.cloth {
        // d/dt sqrt(E) is at most -mu g sqrt(m/2) with the lightest mass while anything moves
        let latest = e.scene.fastest() / (mu * e.scene.gravity);
        if latest + late <= e.scene.duration {
            return Some((true, latest));
        }
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

fn overlap(e: &Evidence<'_>) -> Option<Judgement> {
    e.scene.effects.contact?;
    let deepest = e.trace.extrema.overlap;
    let radius = e.scene.smallest_radius();
    let value = worse(0.0, deepest.value);
    let pair = 2.0 * e.fastest() * e.allowance.dt + e.rounding();
    if within(value, pair) {
        return Some(Judgement::holds(value / radius));
    }
    let group = pair * (e.scene.balls.len() as f64 - 1.0);
    let verdict = if !within(value, group) || e.allowance.dt == 0.0 {
        Verdict::Breaks
    } else {
        Verdict::Drifts
    };
    let found = place(&deepest);
    let why = format!(
        "balls {} overlap by {} R at t = {} s; a step explains {} R",
        e.names(&found.balls),
        short(value / radius),
        short(found.time),
        short(pair / radius)
    );
    Some(Judgement::of(verdict, value / radius, Some(found), why))
}

fn momentum(e: &Evidence<'_>) -> Option<Judgement> {
    let missed = e.trace.extrema.momentum;
    let heaviest = e.scene.balls.iter().map(|b| b.mass).fold(0.0, f64::max);
    let unit = heaviest * e.scene.largest_speed();
    if unit == 0.0 {
        return None;
    }
    let value = missed.value / unit;
    if within(
        missed.value,
        64.0 * e.allowance.ulp * heaviest * e.scene.fastest(),
    ) {
        return Some(Judgement::holds(value));
    }
    let verdict = if e.promises(Invariant::Momentum) {
        Verdict::Breaks
    } else {
        Verdict::Drifts
    };
    let found = place(&missed);
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
    let rounding = Allowance {
        dt: 0.0,
        ..e.allowance
    };
    let collisions = e
        .trace
        .collisions()
        .count()
        .max(oracle.trace.collisions().count());
    oracle.allowance(e.scene, &rounding, collisions) / e.scene.smallest_radius()
}

/// What steps make of the whole run, R; 0 without an oracle.
fn stepping(e: &Evidence<'_>) -> f64 {
    let radius = e.scene.smallest_radius();
    let off = |oracle: &Oracle| oracle.allowance(e.scene, &e.allowance, usize::MAX) / radius;
    let stepped = e.allowance.dt > 0.0;
    e.oracle.filter(|_| stepped).map_or(0.0, off)
}

fn image(
    e: &Evidence<'_>,
    apart: Option<f64>,
    invariant: Invariant,
    how: &str,
) -> Option<Judgement> {
    let apart = apart?;
    // where more than a radius would be explained nothing is
    let bound = rounding_grown(e).max(2.0 * stepping(e)).min(1.0);
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
    // what the way out left grows on the way back
    let bound = rounding_grown(e) * oracle.grown;
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
        let found = Place {
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
