//! Contacts that last, in terms in which any trace can be asked for them.
//!
//! The exact engine has such a contact as a phase: impacts that shrink without end, and then two that press on each other. An engine
//! that steps has nothing of the kind, it exchanges impulses all the while. Both have hits of these two at some times, with a number of
//! exchanges, a distance between them, and places at the two times at which the phase of the reference begins and ends.

use super::{Comparison, Measured, Metric, Reads};
use crate::finding::Hold;
use crate::math::worse;
use crate::scene::Scene;
use crate::trace::{EventKind, Partner, Trace};
use std::collections::HashMap;

/// Hits of a trace where the reference has a contact that lasts.
pub const EPISODES: Metric = Metric {
    id: "contact-episodes",
    unit: "",
    hold: Hold::Count,
    what: "hits of two that the reference has in contact, from the first impact that leads to it to its end, widened by the resolution",
    reads: Reads::Pair(|c| of_phases(c, |phase| Some(hits_in(c, phase).episodes as f64))),
};

/// Exchanges of velocities in these hits.
pub const EXCHANGES: Metric = Metric {
    id: "contact-exchanges",
    unit: "",
    hold: Hold::Count,
    what: "exchanges of velocities that the hits counted in contact-episodes tell of",
    reads: Reads::Pair(|c| of_phases(c, |phase| Some(hits_in(c, phase).exchanges as f64))),
};

/// How far two are apart that the reference has in contact.
pub const APART: Metric = Metric {
    id: "contact-apart",
    unit: "R",
    hold: Hold::Figure,
    what: "largest gap, at the knots of the trace, between two that the reference has in contact; negative where they overlap throughout",
    reads: Reads::Pair(|c| of_phases(c, |phase| apart(c, c.trace, phase))),
};

/// Distance from the reference when a contact begins.
pub const ERROR_AT_BEGIN: Metric = Metric {
    id: "contact-error-begin",
    unit: "R",
    hold: Hold::Figure,
    what: "distance of the balls of a contact from the reference when it begins there, the farther one's",
    reads: Reads::Pair(|c| of_phases(c, |phase| error_at(c, phase, phase.begin))),
};

/// Distance from the reference when a contact ends.
pub const ERROR_AT_END: Metric = Metric {
    id: "contact-error-end",
    unit: "R",
    hold: Hold::Figure,
    what: "distance of the balls of a contact from the reference when it ends there, the farther one's; none where the horizon lies between",
    reads: Reads::Pair(|c| of_phases(c, |phase| error_at_end(c, phase))),
};

/// One contact that lasts: what leads to it, and from when to when it is there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPhase {
    /// What a hit of the same two is.
    pub hit: EventKind,
    /// Which of their contacts it is, from 1.
    pub number: usize,
    /// Hits of the run that leads to it; 0 where they touch before they ever hit.
    pub hits: usize,
    /// The first of these hits, s; [`ContactPhase::begin`] without one.
    pub from: f64,
    /// When it begins, s.
    pub begin: f64,
    /// When nothing holds the two together any more, s; the end of the trace where something still does.
    pub end: f64,
}

impl ContactPhase {
    /// `cue-1`, `cue-x1` for a cushion, and `cue-1 #2` for the second contact of these two.
    pub fn name(&self, trace: &Trace) -> String {
        let (a, b) = self.hit.parties(|ball| &trace.balls[ball]);
        match self.number {
            1 => format!("{a}-{b}"),
            number => format!("{a}-{b} #{number}"),
        }
    }

    /// Its balls: one or two.
    pub fn balls(&self) -> impl Iterator<Item = usize> {
        self.hit.each_ball()
    }
}

/// The hits that a trace has in place of a contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactHits {
    /// Number of them: an engine that steps has one for as long as two overlap.
    pub episodes: usize,
    /// Exchanges of velocities in them.
    pub exchanges: u64,
    /// The first of them, s; `None` without one.
    pub first: Option<f64>,
    /// The last exchange in them, or the end of a contact that the trace has itself, s; `None` without either.
    pub until: Option<f64>,
}

/// Every contact of a trace that lasts, in the order in which they begin.
pub fn contact_phases(trace: &Trace) -> Vec<ContactPhase> {
    let mut phases: Vec<ContactPhase> = Vec::new();
    let begins = |kind| matches!(kind, EventKind::ContactBegin(..));
    if !trace.events.iter().any(|event| begins(event.kind)) {
        return phases;
    }
    let mut hits: HashMap<EventKind, Vec<f64>> = HashMap::new();
    let mut latest: HashMap<EventKind, usize> = HashMap::new();
    for event in &trace.events {
        match event.kind {
            kind if kind.is_collision() => hits.entry(kind).or_default().push(event.time),
            EventKind::ContactBegin(ball, partner) => {
                let hit = hit_of(ball, partner);
                let run = run_to(event.time, hits.get(&hit).map_or(&[], Vec::as_slice));
                let number = latest.get(&hit).map_or(1, |last| phases[*last].number + 1);
                latest.insert(hit, phases.len());
                phases.push(ContactPhase {
                    hit,
                    number,
                    hits: run.len(),
                    from: run.first().copied().unwrap_or(event.time),
                    begin: event.time,
                    end: trace.end_time,
                });
            }
            EventKind::ContactEnd(ball, partner) => {
                let hit = hit_of(ball, partner);
                // hits before it lead to no later contact
                hits.remove(&hit);
                if let Some(open) = latest.get(&hit) {
                    phases[*open].end = event.time;
                }
            }
            _ => {}
        }
    }
    phases
}

/// What a hit of the two is that are in contact.
fn hit_of(ball: u32, partner: Partner) -> EventKind {
    match partner {
        Partner::Ball(other) => EventKind::BallBall(ball, other),
        Partner::Cushion(side) => EventKind::BallCushion(ball, side),
    }
}

/// An interval that is longer than the next one by more than this factor lies before a run of impacts that shrink: from the ratio of
/// 1/100 on three impacts take a speed from that of a break to what is nothing, so that whatever lies before is no part of a run.
const LONGEST_BEFORE: f64 = 100.0;

/// Those at the end of `hits`, s, of two that come into contact at `begin` that lead to it: seen from there, the intervals between
/// one and the next grow. The first interval, from the last hit to the contact, stands for all hits that it leaves out and may be longer.
fn run_to(begin: f64, hits: &[f64]) -> &[f64] {
    let rounding = 4.0 * f64::EPSILON * begin;
    let mut start = hits.len();
    let (mut next, mut interval) = (begin, f64::INFINITY);
    while start > 0 {
        let before = next - hits[start - 1];
        let behind = hits.len() - start;
        let longest = LONGEST_BEFORE * interval.max(rounding);
        if before > longest || (behind > 1 && before < interval - rounding) {
            break;
        }
        (next, interval) = (hits[start - 1], before);
        start -= 1;
    }
    &hits[start..]
}

/// The contacts of the reference that it can be believed about: those that begin before the horizon.
pub fn believed_phases(c: &Comparison<'_>) -> Vec<ContactPhase> {
    let mut phases = contact_phases(c.reference);
    phases.retain(|phase| phase.begin < c.horizon);
    phases
}

fn of_phases(c: &Comparison<'_>, value: impl Fn(&ContactPhase) -> Option<f64>) -> Vec<Measured> {
    let measured = |phase: &ContactPhase| Measured {
        subject: phase.name(c.reference),
        value: value(phase),
    };
    believed_phases(c).iter().map(measured).collect()
}

/// The hits of the trace in place of a contact of the reference: those of the same two that begin, or still exchange, between the first
/// impact that leads to it and its end, widened by what event times are good to.
pub fn hits_in(c: &Comparison<'_>, phase: &ContactPhase) -> ContactHits {
    let (from, to) = (
        phase.from - c.order.resolution,
        phase.end.min(c.horizon) + c.order.resolution,
    );
    let exchanged = last_exchanges(c.trace, phase.hit.balls().0);
    let mut found = ContactHits::default();
    let mut extend = |first: f64, until: f64| {
        found.first = Some(found.first.map_or(first, |known| known.min(first)));
        found.until = Some(found.until.map_or(until, |known| known.max(until)));
    };
    let own = c.trace.events.iter().enumerate();
    for (index, event) in own.filter(|(_, event)| event.kind == phase.hit) {
        let last = exchanged.get(&(index as u32)).copied();
        let until = last.unwrap_or(event.time);
        if event.time <= to && until >= from {
            found.episodes += 1;
            found.exchanges += event.exchanges.unwrap_or(0);
            extend(event.time, until);
        }
    }
    let contacts = contact_phases(c.trace).into_iter();
    for own in contacts.filter(|own| own.hit == phase.hit) {
        if own.begin <= to && own.end >= from {
            extend(own.from, own.end);
        }
    }
    found
}

/// When each event that changed the velocity of a ball last did so, s, by the index of the event.
fn last_exchanges(trace: &Trace, ball: usize) -> HashMap<u32, f64> {
    let knots = trace.paths[ball].knots.iter();
    knots
        .filter_map(|knot| Some((knot.after?, knot.time)))
        .collect()
}

/// Largest gap in `trace` between two that the reference has in contact, R, at its knots and at both ends; negative where they
/// overlap throughout. `None` where one of them has left play, or the trace has ended.
pub fn apart(c: &Comparison<'_>, trace: &Trace, phase: &ContactPhase) -> Option<f64> {
    let end = phase.end.min(c.common_end()).min(c.horizon);
    if phase.begin > end {
        return None;
    }
    let knots = phase.balls().flat_map(|ball| &trace.paths[ball].knots);
    let within = knots
        .map(|knot| knot.time)
        .filter(|time| (phase.begin..=end).contains(time));
    let gaps = within
        .chain([phase.begin, end])
        .filter_map(|time| gap(c.scene, trace, phase.hit, time));
    Some(gaps.reduce(worse)? / c.scene.smallest_radius())
}

/// Gap between two at `time`, length; negative where they overlap.
fn gap(scene: &Scene, trace: &Trace, hit: EventKind, time: f64) -> Option<f64> {
    let (a, b) = hit.balls();
    let first = trace.in_play_at(a, time)?.position;
    match (hit, b) {
        (EventKind::BallCushion(_, side), _) => {
            let reach = scene.reach(side, scene.balls[a].radius)?;
            Some(f64::from(side.sign()) * (reach - first[side.axis()]))
        }
        (_, Some(b)) => {
            let second = trace.in_play_at(b, time)?.position;
            Some((second - first).norm() - scene.contact_distance(a, b))
        }
        (_, None) => None,
    }
}

/// Distance of the balls of a contact from the reference at `time`, seen in plan; the farther one's, R. `None` where one of them has
/// left play, or one of the traces has ended.
fn error_at(c: &Comparison<'_>, phase: &ContactPhase, time: f64) -> Option<f64> {
    if time > c.common_end() {
        return None;
    }
    let distances: Option<Vec<f64>> = phase
        .balls()
        .map(|ball| {
            let ours = c.trace.in_play_at(ball, time)?;
            let theirs = c.reference.in_play_at(ball, time)?;
            Some((ours.position - theirs.position).xy().norm())
        })
        .collect();
    Some(distances?.into_iter().reduce(worse)? / c.scene.smallest_radius())
}

/// Distance of the balls of a contact from the reference when it begins there, seen in plan; the farther one's, R.
pub fn error_at_begin(c: &Comparison<'_>, phase: &ContactPhase) -> Option<f64> {
    error_at(c, phase, phase.begin)
}

/// The same when it ends there; `None` where the horizon lies between.
pub fn error_at_end(c: &Comparison<'_>, phase: &ContactPhase) -> Option<f64> {
    let between = phase.begin < c.horizon && c.horizon < phase.end;
    if between {
        return None;
    }
    error_at(c, phase, phase.end)
}

#[cfg(test)]
mod tests {
    use super::run_to;

    #[test]
    fn a_run_is_what_shrinks_towards_the_contact() {
        // intervals of 8, 4, 2 and 1, and as long again until the contact
        let run = [0.0, 8.0, 12.0, 14.0, 15.0];
        assert_eq!(run_to(16.0, &run), run);
        // a shorter interval before them is that of another run
        let after_another = [-3.0, 0.0, 8.0, 12.0, 14.0, 15.0];
        assert_eq!(run_to(16.0, &after_another), run);
    }

    #[test]
    fn impacts_without_end_leave_out_the_rest_of_them() {
        // ratio 0.9: what is left takes nine times as long as the last interval
        let hits = [0.0, 1.0, 1.9, 2.71];
        assert_eq!(run_to(10.0, &hits), hits);
    }

    #[test]
    fn an_impact_without_rebound_needs_none_before_it() {
        assert_eq!(run_to(5.0, &[1.0, 5.0]), [5.0]);
        assert_eq!(run_to(5.0, &[]), [0.0; 0]);
        // the same impacts in more digits than a time has
        let next = 5.0_f64.next_down();
        assert_eq!(run_to(5.0, &[next, 5.0, 5.0]), [next, 5.0, 5.0]);
    }
}
