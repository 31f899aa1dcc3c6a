//! A run against the exact one: the order of collisions, distances, stop times; and whether the step explains what differs.

use super::evidence::{Evidence, FoundAt, Judgement, short};
use crate::compare::{Comparison, largest_distance_at_end};
use crate::finding::Verdict;
use crate::math::{within, worse};
use crate::oracle::Oracle;
use crate::physics::Cloth;
use crate::scene::Simultaneous;
use crate::trace::{Event, EventKind, Trace};
use crate::words::{describe_kind, describe_span};

/// Part of a radius that a ball may go in a step if an engine is to see what it hits.
const SEEN: f64 = 0.5;

/// Points in a step, before and after, at which the gap of a miss is looked at.
const NEARBY: i32 = 8;

/// Where two orders of collisions differ beyond a tie: the number that agree, and what each has next.
struct Parting {
    agree: usize,
    ours: Option<Event>,
    exact: Option<Event>,
}

impl Parting {
    fn time(&self) -> f64 {
        let time = |event: &Option<Event>| event.map_or(f64::INFINITY, |e| e.time);
        time(&self.ours).min(time(&self.exact))
    }
}

/// The first difference beyond ties, within the horizon and the time of both runs.
fn parting(e: &Evidence<'_>, oracle: &Oracle, comparison: &Comparison<'_>) -> Option<Parting> {
    let agree = comparison.order.tolerant;
    let end = comparison.common_end();
    let nth = |trace: &Trace| {
        let mut within = trace.collisions().filter(|e| e.time <= end);
        within.nth(agree).copied()
    };
    let found = Parting {
        agree,
        ours: nth(comparison.trace),
        exact: nth(comparison.reference),
    };
    // what the engine may be late for is no difference where one of the runs has ended
    let bound = Bound::after(e, oracle, comparison, found.time());
    let cut_off = match (&found.ours, &found.exact) {
        (_, Some(exact)) => exact.time + bound.time(exact) >= end,
        (Some(ours), None) => ours.time + bound.dt >= end,
        (None, None) => true,
    };
    (found.time() < oracle.until && !cut_off).then_some(found)
}

/// What an engine may get wrong about an event, given how far off it is by then.
struct Bound<'a> {
    evidence: &'a Evidence<'a>,
    oracle: &'a Oracle,
    /// What a position is off by before the event, length.
    length: f64,
    /// What the times of the collisions so far are off by, s.
    late: f64,
    /// The step, s.
    dt: f64,
}

impl<'a> Bound<'a> {
    fn after(
        evidence: &'a Evidence<'a>,
        oracle: &'a Oracle,
        comparison: &Comparison<'_>,
        time: f64,
    ) -> Self {
        Bound {
            length: comparison.divergence.largest_before(time),
            late: lateness(comparison),
            dt: evidence.allowance.dt,
            evidence,
            oracle,
        }
    }

    /// Relative velocity of an event's parties just before `time`, and its part along their normal, length/s.
    fn approach(&self, kind: EventKind, time: f64) -> (f64, f64) {
        let state = |ball: usize| {
            self.oracle
                .trace
                .paths
                .get(ball)
                .and_then(|p| p.before(time))
        };
        let (a, b) = kind.balls();
        let (Some(p), q) = (state(a), b.and_then(state)) else {
            return (0.0, 0.0);
        };
        match (q, kind) {
            (Some(q), _) => {
                let (apart, relative) = (q.position - p.position, p.velocity - q.velocity);
                let distance = apart.norm();
                let normal = if distance > 0.0 {
                    (relative.dot(&apart) / distance).abs()
                } else {
                    0.0
                };
                (relative.norm(), normal)
            }
            (None, EventKind::BallCushion(_, side)) => {
                (p.velocity.norm(), p.velocity[side.axis()].abs())
            }
            (None, _) => (p.velocity.norm(), 0.0),
        }
    }

    /// By how much an event may come at another time, s: the errors of two positions over the speed at which the gap closes, or what earlier
    /// ones were off by; and a step.
    fn time(&self, event: &Event) -> f64 {
        let (_, normal) = self.approach(event.kind, event.time);
        let shift = 2.0 * self.length;
        let moved = if shift > 0.0 { shift / normal } else { 0.0 };
        self.dt + worse(moved, self.late)
    }

    /// How deep the balls of a hit would go into each other if they met nothing, length; `None` for a cushion.
    fn depth(&self, event: &Event) -> Option<f64> {
        let EventKind::BallBall(a, b) = event.kind else {
            return None;
        };
        let (relative, normal) = self.approach(event.kind, event.time);
        let cosine = if relative > 0.0 {
            (normal / relative).min(1.0)
        } else {
            0.0
        };
        let distance = self.evidence.scene.contact_distance(a as usize, b as usize);
        // D (1 - sin), written so that a graze keeps its digits
        Some(distance * cosine * cosine / (1.0 + (1.0 - cosine * cosine).sqrt()))
    }

    /// How far from a hit the exact run is within a step of where the engine has one, length, >= 0.
    fn gap(&self, event: &Event) -> f64 {
        let steps = (-NEARBY..=NEARBY).map(|k| f64::from(k) / f64::from(NEARBY));
        let times = steps.map(|part| event.time + part * self.dt);
        let gaps = times
            .filter(|t| *t >= 0.0)
            .map(|t| self.gap_at(event.kind, t));
        gaps.fold(f64::INFINITY, f64::min).max(0.0)
    }

    fn gap_at(&self, kind: EventKind, time: f64) -> f64 {
        let scene = self.evidence.scene;
        let paths = &self.oracle.trace.paths;
        let at = |ball: u32| Some(paths.get(ball as usize)?.state_at(time)?.position);
        let gap = match kind {
            EventKind::BallBall(a, b) => at(a)
                .zip(at(b))
                .map(|(p, q)| (p - q).norm() - scene.contact_distance(a as usize, b as usize)),
            EventKind::BallCushion(ball, side) => {
                let reach = scene.reach(side, scene.balls[ball as usize].radius);
                let here = at(ball).map(|p| p[side.axis()]);
                reach
                    .zip(here)
                    .map(|(reach, x)| f64::from(side.sign()) * (reach - x))
            }
            _ => None,
        };
        gap.unwrap_or(f64::INFINITY)
    }
}

/// The largest difference of time among the collisions that agree, s.
fn lateness(comparison: &Comparison<'_>) -> f64 {
    let times = |trace: &Trace| -> Vec<f64> { trace.collisions().map(|e| e.time).collect() };
    let (ours, theirs) = (times(comparison.trace), times(comparison.reference));
    let agreeing = comparison
        .order
        .matched
        .iter()
        .take(comparison.order.tolerant);
    let off = agreeing.filter_map(|&(i, j)| Some((ours.get(i)? - theirs.get(j)?).abs()));
    off.fold(0.0, worse)
}

/// What a difference of two orders is, in words, and whether the step explains it.
struct Explained {
    explained: bool,
    why: String,
    event: Option<Event>,
}

fn explain(comparison: &Comparison<'_>, parting: &Parting, bound: &Bound<'_>) -> Explained {
    let trace = comparison.trace;
    let name = |event: &Event| describe_kind(event.kind, trace);
    let (ours, exact) = (parting.ours.as_ref(), parting.exact.as_ref());
    let matched = &comparison.order.matched;
    let later_in_exact = matched.iter().find(|(i, _)| *i == parting.agree);
    let later_in_ours = matched.iter().find(|(_, j)| *j == parting.agree);
    let nth = |trace: &Trace, n: usize| trace.collisions().nth(n).copied();
    let later = later_in_exact.and_then(|(_, j)| nth(comparison.reference, *j));
    let margin = later
        .zip(exact)
        .map(|(later, exact)| (later.time - exact.time).abs());
    if let (Some(ours), Some(exact), Some(later), Some(margin)) = (ours, exact, later, margin) {
        let allowed = bound.time(&later) + bound.time(exact);
        if margin <= allowed {
            return Explained {
                explained: true,
                why: match margin {
                    0.0 => format!(
                        "has {} before {}, which are at one instant",
                        name(ours),
                        name(exact)
                    ),
                    _ => format!(
                        "has {} before {}, {} apart; step and error make {}",
                        name(ours),
                        name(exact),
                        describe_span(margin),
                        describe_span(allowed)
                    ),
                },
                event: Some(*ours),
            };
        }
    }
    match (ours, exact) {
        (None, Some(exact)) => missed(exact, bound, &name(exact)),
        (Some(ours), None) => phantom(ours, bound, &name(ours)),
        (Some(ours), Some(exact)) if later_in_ours.is_none() => {
            // the earlier of the two is what went wrong first
            let first = ours.time + bound.time(ours) < exact.time && later_in_exact.is_none();
            if first {
                phantom(ours, bound, &name(ours))
            } else {
                missed(exact, bound, &name(exact))
            }
        }
        (Some(ours), Some(_)) if later_in_exact.is_none() => phantom(ours, bound, &name(ours)),
        (ours, exact) => Explained {
            explained: false,
            why: format!(
                "has {} before {}, {} apart; step and error make less",
                ours.map_or(String::new(), name),
                exact.map_or(String::new(), name),
                margin.map_or(String::new(), describe_span)
            ),
            event: ours.or(exact).copied(),
        },
    }
}

/// A collision that the engine does not have in its place.
fn missed(exact: &Event, bound: &Bound<'_>, name: &str) -> Explained {
    let (scene, exact_trace) = (bound.evidence.scene, &bound.oracle.trace);
    let radius = scene.smallest_radius();
    let (relative, normal) = bound.approach(exact.kind, exact.time);
    let in_a_step = relative * bound.dt;
    let off = 2.0 * bound.length;
    let depth = bound.depth(exact);
    let why = match depth {
        Some(depth) => format!(
            "misses {name}, {} R deep; it goes {} R in a step and is off by {} R",
            short(depth / radius),
            short(in_a_step / radius),
            short(bound.length / radius)
        ),
        None => format!("misses {name}, met at {} length/s", short(normal)),
    };
    // an engine that sees what it hits may step over a graze less deep than a step, be moved away from it by its own error, or not tell apart
    // what follows within what it may be late
    let sees = in_a_step <= SEEN * radius && off <= radius;
    let graze = depth.is_some_and(|depth| depth <= in_a_step || depth <= off);
    let late = bound.time(exact);
    let unresolved = exact_trace.collisions().any(|other| {
        let other_one = other.time != exact.time || other.kind != exact.kind;
        let close = (other.time - exact.time).abs() <= late;
        other_one && close && other.kind.shares_ball(exact.kind)
    });
    // nor does it matter whether what goes less far than rounding meets
    let left = exact_trace.end_time - exact.time;
    let creeps = relative * left.max(0.0) <= scene.touching();
    Explained {
        explained: creeps || (sees && (graze || unresolved)),
        why,
        event: Some(*exact),
    }
}

/// A collision that the exact engine does not have in its place.
fn phantom(ours: &Event, bound: &Bound<'_>, name: &str) -> Explained {
    let radius = bound.evidence.scene.smallest_radius();
    let gap = bound.gap(ours);
    let (relative, _) = bound.approach(ours.kind, ours.time);
    let off = 2.0 * bound.length + relative * bound.dt;
    Explained {
        explained: gap <= off && off <= radius,
        why: format!(
            "has {name}, which exact misses by {} R; step and error make {} R",
            short(gap / radius),
            short(off / radius)
        ),
        event: Some(*ours),
    }
}

/// The order of collisions.
pub fn order(e: &Evidence<'_>) -> Option<Judgement> {
    let oracle = e.oracle?;
    let Some(comparison) = &e.comparison else {
        // the exact run itself: how many of its collisions can be believed
        let own = e.events && e.trace.provenance.resolution == 0.0;
        let certain = e.trace.collisions().filter(|c| c.time < oracle.until);
        return own.then(|| Judgement::holds(certain.count() as f64));
    };
    let Some(parting) = parting(e, oracle, comparison) else {
        let certain = comparison
            .reference
            .collisions()
            .filter(|event| event.time < oracle.until && event.time <= comparison.common_end())
            .count();
        return Some(Judgement::holds(
            certain.min(comparison.order.tolerant) as f64
        ));
    };
    let bound = Bound::after(e, oracle, comparison, parting.time());
    let found = explain(comparison, &parting, &bound);
    // where a convention makes the answer, another convention is no defect
    let convention = e.scene.simultaneous == Simultaneous::GeneralizedReflections;
    let verdict = if found.explained || convention {
        Verdict::Drifts
    } else {
        Verdict::Breaks
    };
    let place = found.event.map(|event| FoundAt {
        time: event.time,
        balls: event.kind.each_ball().collect(),
    });
    let all = comparison.order.reference_collisions;
    let place_in_order = match (parting.agree < all, all) {
        (true, _) => format!("at collision {} of {all}", parting.agree + 1),
        (false, 0) => "where nothing meets".to_owned(),
        (false, _) => format!("after all {all} collisions"),
    };
    let why = format!(
        "{place_in_order}, t = {} s, {}",
        short(parting.time()),
        found.why
    );
    Some(Judgement::of(verdict, parting.agree as f64, place, why))
}

/// The largest distance from the exact run before the orders part and before the horizon.
pub fn distance(e: &Evidence<'_>) -> Option<Judgement> {
    let oracle = e.oracle?;
    let radius = e.scene.smallest_radius();
    let (length, collisions, place) = match &e.comparison {
        Some(comparison) => {
            let parted = parting(e, oracle, comparison);
            let until = parted.as_ref().map_or(oracle.until, Parting::time);
            let length = comparison.divergence.largest_before(until);
            (
                length,
                comparison.order.tolerant,
                owner(comparison, until, length),
            )
        }
        // only the ends were kept, which the exact run can speak of where it is whole
        None if !e.events && oracle.is_whole() && oracle.is_complete() => {
            let apart = largest_distance_at_end(e.scene, e.trace, &oracle.trace)?;
            (apart * radius, oracle.trace.collisions().count(), None)
        }
        None => return None,
    };
    let value = length / radius;
    let explained = oracle.allowance(e.scene, &e.allowance, collisions) / radius;
    if within(value, explained.min(1.0)) {
        return Some(Judgement::holds(value));
    }
    let who = place.as_ref().map_or(String::new(), |p| {
        format!(", ball {} at t = {} s", e.names(&p.balls), short(p.time))
    });
    let bound = if explained < 1.0 {
        format!("step and rounding make {} R", short(explained))
    } else {
        "more than a radius".to_owned()
    };
    let why = format!("is {} R from exact{who}; {bound}", short(value));
    Some(Judgement::of(Verdict::Drifts, value, place, why))
}

/// The ball and the time of the largest distance before `until`.
fn owner(comparison: &Comparison<'_>, until: f64, largest: f64) -> Option<FoundAt> {
    let points = &comparison.divergence.points;
    let (time, _) = points.iter().find(|(t, d)| *t < until && *d == largest)?;
    let pairs = comparison
        .trace
        .paths
        .iter()
        .zip(&comparison.reference.paths);
    let apart = |(a, b): (&crate::trace::Path, &crate::trace::Path)| {
        let far = a.state_at(*time).zip(b.state_at(*time));
        let near = a.before(*time).zip(b.before(*time));
        let of = |sides: Option<(crate::physics::State, crate::physics::State)>| {
            sides.map_or(0.0, |(p, q)| (p.position - q.position).norm())
        };
        worse(of(far), of(near))
    };
    let distances: Vec<f64> = pairs.map(apart).collect();
    let ball = (0..distances.len()).max_by(|&a, &b| distances[a].total_cmp(&distances[b]))?;
    Some(FoundAt {
        time: *time,
        balls: vec![ball],
    })
}

/// When balls stop, where the orders agree and the exact run can be believed to its end.
pub fn stop_time(e: &Evidence<'_>) -> Option<Judgement> {
    let (oracle, comparison) = (e.oracle?, e.comparison.as_ref()?);
    if !oracle.is_whole() || !oracle.is_complete() || parting(e, oracle, comparison).is_some() {
        return None;
    }
    let mu = match e.scene.effects.cloth? {
        Cloth::Translational { mu } => mu,
        Cloth::Rotational { mu_roll, .. } => mu_roll,
    };
    let slows = mu * e.scene.gravity;
    if slows == 0.0 {
        return None;
    }
    let pairs = e.trace.stop_times.iter().zip(&oracle.trace.stop_times);
    let differences = pairs
        .enumerate()
        .filter_map(|(ball, (a, b))| Some((ball, (a.as_ref()? - b.as_ref()?).abs())));
    let (ball, value) = differences.reduce(|largest, next| {
        let replaces = next.1 > largest.1 || next.1.is_nan();
        if replaces { next } else { largest }
    })?;
    // in the units of growth an error of a length in R is one of a speed in the fastest
    let length = oracle.allowance(e.scene, &e.allowance, comparison.order.tolerant);
    let speed = length / e.scene.smallest_radius() * oracle.fastest;
    let bound = 2.0 * e.allowance.dt + speed / slows;
    // where growth is not known the bound is infinite, and still no ball stops at infinity as it should
    if value.is_finite() && value <= bound {
        return Some(Judgement::holds(value));
    }
    let why = format!(
        "ball {} stops {} from when it should; its step explains {}",
        e.names(&[ball]),
        describe_span(value),
        describe_span(bound)
    );
    let place = FoundAt {
        time: e.trace.stop_times[ball].unwrap_or(e.trace.end_time),
        balls: vec![ball],
    };
    Some(Judgement::of(Verdict::Drifts, value, Some(place), why))
}
