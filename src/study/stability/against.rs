//! A run against the exact one: the order of collisions, distances, stop times; and whether the step explains what differs.

use super::oracle::Oracle;
use super::rules::{Evidence, Judgement, Place, short};
use crate::compare::{Comparison, common_end, largest_distance_at_end};
use crate::finding::Verdict;
use crate::physics::Cloth;
use crate::study::compare::{describe_kind, describe_span};
use crate::trace::{Event, EventKind, Trace};

/// Part of a radius that a ball may go in a step if an engine is to see what it hits.
const SEEN: f64 = 0.5;

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
fn parting(comparison: &Comparison<'_>, until: f64) -> Option<Parting> {
    let order = &comparison.order;
    let agree = order.tolerant;
    let end = comparison.common_end();
    let nth = |trace: &Trace| {
        trace
            .collisions()
            .filter(|e| e.time <= end)
            .nth(agree)
            .copied()
    };
    let found = Parting {
        agree,
        ours: nth(comparison.trace),
        exact: nth(comparison.reference),
    };
    (found.time() < until).then_some(found)
}

/// How an engine's error at an event is judged.
struct Bound<'a> {
    evidence: &'a Evidence<'a>,
    oracle: &'a Oracle,
    /// What a position may be off by, length.
    length: f64,
    /// The step, s.
    dt: f64,
}

impl<'a> Bound<'a> {
    fn after(evidence: &'a Evidence<'a>, oracle: &'a Oracle, collisions: usize) -> Self {
        Bound {
            length: oracle.allowance(evidence.scene, &evidence.allowance, collisions),
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

    /// By how much an event may come at another time, s: the error of a position over the speed at which the gap closes, and a step.
    fn time(&self, event: &Event) -> f64 {
        let (_, normal) = self.approach(event.kind, event.time);
        self.dt
            + if normal > 0.0 {
                self.length / normal
            } else {
                f64::INFINITY
            }
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

    /// How far from a hit the exact run is where the engine has one, length.
    fn gap(&self, event: &Event) -> f64 {
        let (scene, trace) = (self.evidence.scene, &self.oracle.trace);
        let at = |ball: usize| {
            trace
                .paths
                .get(ball)
                .and_then(|path| path.state_at(event.time))
        };
        match event.kind {
            EventKind::BallBall(a, b) => {
                let (a, b) = (a as usize, b as usize);
                let apart = at(a)
                    .zip(at(b))
                    .map(|(p, q)| (p.position - q.position).norm());
                apart.map_or(f64::INFINITY, |d| d - scene.contact_distance(a, b))
            }
            EventKind::BallCushion(ball, side) => {
                let ball = ball as usize;
                let reach = scene.reach(side, scene.balls[ball].radius);
                let here = at(ball).map(|state| state.position[side.axis()]);
                let gap = reach
                    .zip(here)
                    .map(|(reach, x)| f64::from(side.sign()) * (reach - x));
                gap.unwrap_or(f64::INFINITY)
            }
            _ => f64::INFINITY,
        }
    }
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
    let end = comparison.common_end();
    let known = |wanted: &Event, list: &Trace| -> bool {
        list.collisions().filter(|e| e.time <= end).any(|e| {
            // at its place or after it
            e.kind == wanted.kind && e.time >= wanted.time - bound.time(wanted)
        })
    };
    if let (Some(ours), Some(exact)) = (&parting.ours, &parting.exact)
        && let Some(margin) = margin(comparison, parting.agree)
    {
        let allowed = bound.time(ours) + bound.time(exact);
        if margin <= allowed {
            return Explained {
                explained: true,
                why: format!(
                    "has {} before {}, {} apart, where its step explains {}",
                    name(ours),
                    name(exact),
                    describe_span(margin),
                    describe_span(allowed)
                ),
                event: Some(*ours),
            };
        }
    }
    if let Some(exact) = &parting.exact
        && !known(exact, trace)
    {
        return missed(parting, exact, bound, end, &name(exact));
    }
    match (&parting.ours, &parting.exact) {
        (Some(ours), _) if !known(ours, comparison.reference) => phantom(ours, bound, &name(ours)),
        (Some(ours), Some(exact)) => Explained {
            explained: false,
            why: format!("has {} instead of {}", name(ours), name(exact)),
            event: Some(*ours),
        },
        (ours, exact) => Explained {
            explained: false,
            why: "has another number of collisions".to_owned(),
            event: ours.or(*exact),
        },
    }
}

/// Time in the exact run between its event and the one that the engine has instead, s.
fn margin(comparison: &Comparison<'_>, agree: usize) -> Option<f64> {
    let theirs: Vec<&Event> = comparison.reference.collisions().collect();
    let matched = comparison.order.matched.iter();
    let (_, j) = matched.clone().find(|(i, _)| *i == agree)?;
    Some((theirs.get(*j)?.time - theirs.get(agree)?.time).abs())
}

/// A collision that the engine never has.
fn missed(parting: &Parting, exact: &Event, bound: &Bound<'_>, end: f64, name: &str) -> Explained {
    let radius = bound.evidence.scene.smallest_radius();
    let late = bound.time(exact);
    let explained = |why: String| Explained {
        explained: true,
        why,
        event: Some(*exact),
    };
    if exact.time + late >= end {
        return explained(format!("has no time left for {name}"));
    }
    // a different event of the same balls came first, as early as its error allows
    if let Some(ours) = parting.ours
        && ours.kind.shares_ball(exact.kind)
        && ours.time + bound.time(&ours) < exact.time
    {
        return phantom(&ours, bound, &describe_kind(ours.kind, &bound.oracle.trace));
    }
    let (relative, normal) = bound.approach(exact.kind, exact.time);
    let in_a_step = relative * bound.dt;
    let deep = bound.depth(exact);
    let why = match deep {
        Some(depth) => format!(
            "never has {name}, {} R deep; it goes {} R in a step",
            short(depth / radius),
            short(in_a_step / radius)
        ),
        None => format!("never has {name}, met at {} length/s", short(normal)),
    };
    // a graze less deep than a step goes, by an engine that sees what it hits; or one that its own error moves it away from
    let graze = deep.is_some_and(|depth| {
        let seen = depth <= in_a_step && in_a_step <= SEEN * radius;
        seen || depth <= 2.0 * bound.length.min(radius * SEEN)
    });
    Explained {
        explained: graze,
        why,
        event: Some(*exact),
    }
}

/// A collision that the exact engine never has.
fn phantom(ours: &Event, bound: &Bound<'_>, name: &str) -> Explained {
    let radius = bound.evidence.scene.smallest_radius();
    let gap = bound.gap(ours).max(0.0);
    Explained {
        explained: gap <= 2.0 * bound.length.min(radius),
        why: format!(
            "has {name}, which misses by {} R; it may be off by {} R",
            short(gap / radius),
            short(bound.length / radius)
        ),
        event: Some(*ours),
    }
}

/// The order of collisions.
pub fn order(e: &Evidence<'_>) -> Option<Judgement> {
    let oracle = e.oracle?;
    let Some(comparison) = &e.comparison else {
        // the exact run itself: how many of its events can be believed
        let own = e.events && e.trace.provenance.resolution == 0.0;
        return own.then(|| Judgement::holds(oracle.certain.0 as f64));
    };
    let Some(parting) = parting(comparison, oracle.until) else {
        let certain = comparison
            .reference
            .collisions()
            .filter(|event| event.time < oracle.until && event.time <= comparison.common_end())
            .count();
        return Some(Judgement::holds(certain as f64));
    };
    let bound = Bound::after(e, oracle, parting.agree);
    let found = explain(comparison, &parting, &bound);
    let verdict = if found.explained {
        Verdict::Drifts
    } else {
        Verdict::Breaks
    };
    let place = found.event.map(|event| {
        let (a, b) = event.kind.balls();
        Place {
            time: event.time,
            balls: [Some(a), b].into_iter().flatten().collect(),
        }
    });
    let why = format!(
        "at collision {} of {}, t = {} s, {}",
        parting.agree + 1,
        comparison.order.reference_collisions,
        short(parting.time()),
        found.why
    );
    Some(Judgement::of(verdict, parting.agree as f64, place, why))
}

/// The largest distance from the exact run before the orders part and before the horizon.
pub fn distance(e: &Evidence<'_>) -> Option<Judgement> {
    let oracle = e.oracle?;
    let radius = e.scene.smallest_radius();
    let (value, collisions, when) = match &e.comparison {
        Some(comparison) => {
            let parted = parting(comparison, oracle.until);
            let until = parted.as_ref().map_or(oracle.until, Parting::time);
            let agree = comparison.order.tolerant;
            (
                comparison.divergence.largest_before(until) / radius,
                agree,
                until,
            )
        }
        // only the ends were kept, which the exact run can speak of where it is whole
        None if !e.events && oracle.is_whole() && oracle.is_complete() => {
            let apart = largest_distance_at_end(e.scene, e.trace, &oracle.trace)?;
            let all = oracle.trace.collisions().count();
            (apart, all, common_end(e.trace, &oracle.trace))
        }
        None => return None,
    };
    let bound = (oracle.allowance(e.scene, &e.allowance, collisions) / radius).min(1.0);
    if value <= bound {
        return Some(Judgement::holds(value));
    }
    let place = e
        .comparison
        .as_ref()
        .and_then(|c| owner(c, when, value * radius));
    let who = place.as_ref().map_or(String::new(), |p| {
        format!(", ball {} at t = {} s", e.names(&p.balls), short(p.time))
    });
    let why = format!(
        "is {} R from exact{who}; its step explains {} R",
        short(value),
        short(bound)
    );
    Some(Judgement::of(Verdict::Drifts, value, place, why))
}

/// The ball and the time of the largest distance before `until`.
fn owner(comparison: &Comparison<'_>, until: f64, largest: f64) -> Option<Place> {
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
        of(far).max(of(near))
    };
    let distances: Vec<f64> = pairs.map(apart).collect();
    let ball = (0..distances.len()).max_by(|&a, &b| distances[a].total_cmp(&distances[b]))?;
    Some(Place {
        time: *time,
        balls: vec![ball],
    })
}

/// When balls stop, where the orders agree and the exact run can be believed to its end.
pub fn stop_time(e: &Evidence<'_>) -> Option<Judgement> {
    let (oracle, comparison) = (e.oracle?, e.comparison.as_ref()?);
    if !oracle.is_whole() || !oracle.is_complete() || parting(comparison, oracle.until).is_some() {
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
    let (ball, value) =
        differences.reduce(|worst, next| if next.1 > worst.1 { next } else { worst })?;
    // in the units of growth an error of a length in R is one of a speed in the fastest
    let length = oracle.allowance(e.scene, &e.allowance, comparison.order.tolerant);
    let speed = length / e.scene.smallest_radius() * oracle.fastest;
    let bound = 2.0 * e.allowance.dt + speed / slows;
    if value <= bound {
        return Some(Judgement::holds(value));
    }
    let why = format!(
        "ball {} stops {} from when it should; its step explains {}",
        e.names(&[ball]),
        describe_span(value),
        describe_span(bound)
    );
    let place = Place {
        time: e.trace.stop_times[ball].unwrap_or(e.trace.end_time),
        balls: vec![ball],
    };
    Some(Judgement::of(Verdict::Drifts, value, Some(place), why))
}
