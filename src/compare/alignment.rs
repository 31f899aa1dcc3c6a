//! Aligns two collision orders: how long they agree, and where they first differ.

use crate::trace::{Event, EventKind, Trace};
use std::collections::{BTreeMap, HashMap};

/// Two collision orders side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// Collisions of the trace.
    pub collisions: usize,
    /// Collisions of the reference.
    pub reference_collisions: usize,
    /// Length of the common prefix, event for event.
    pub strict: usize,
    /// Length of the common prefix when two events may swap that share no ball and lie closer together in the reference
    /// than the resolution. Pairs are tested one by one: ties never chain. Two hits of the same two are never a tie, not even where they
    /// come faster than the resolution on their way into a contact that lasts: an engine has one episode of many impacts there long before
    /// that, and where orders part for this reason it is told ([`super::contact_phases`]).
    pub tolerant: usize,
    /// Index in the trace's collisions and in the reference's of each matched event, ordered by the trace.
    pub matched: Vec<(usize, usize)>,
    /// Collisions of the reference that the trace never has.
    pub missed: usize,
    /// Collisions of the trace that the reference never has.
    pub phantom: usize,
    /// Matched collisions that come later than the reference's by more than the resolution.
    pub late: usize,
    /// What event times can be held to, s: the sum of both resolutions.
    pub resolution: f64,
    /// Where the orders first differ; `None` if they are the same.
    pub parting: Option<Parting>,
}

/// The first place where two collision orders differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Parting {
    /// Index among the collisions, from 0: the number of events that agree.
    pub index: usize,
    /// The trace's event there; `None` if it has no more.
    pub event: Option<Event>,
    /// The reference's event there; `None` if it has no more.
    pub reference: Option<Event>,
    /// Time in the reference between its event and the one that the trace has instead, s; `None` if the reference never
    /// has that one.
    pub margin: Option<f64>,
}

impl Parting {
    /// The earlier time of the two events, s.
    pub fn time(&self) -> f64 {
        let time = |event: &Option<Event>| event.map_or(f64::INFINITY, |e| e.time);
        time(&self.event).min(time(&self.reference))
    }
}

/// Aligns the collision order of `trace` with that of `reference`.
///
/// The k-th occurrence of an event in one matches the k-th in the other. Where one of the traces ends early, collisions
/// after that end are left out of both.
pub fn align(trace: &Trace, reference: &Trace) -> Order {
    align_until(trace, reference, super::common_end(trace, reference))
}

/// The same for the collisions up to `end`, s, in both.
fn align_until(trace: &Trace, reference: &Trace, end: f64) -> Order {
    let collisions =
        |t: &Trace| -> Vec<Event> { t.collisions().filter(|e| e.time <= end).copied().collect() };
    let (ours, theirs) = (collisions(trace), collisions(reference));
    let resolution = trace.provenance.resolution + reference.provenance.resolution;
    let matched = matches(&ours, &theirs);
    let strict = ours
        .iter()
        .zip(&theirs)
        .take_while(|(a, b)| a.kind == b.kind)
        .count();
    let late = |&&(i, j): &&(usize, usize)| ours[i].time - theirs[j].time > resolution;
    Order {
        collisions: ours.len(),
        reference_collisions: theirs.len(),
        strict,
        tolerant: tolerant_prefix(&ours, &theirs, &matched, resolution).max(strict),
        missed: theirs.len() - matched.len(),
        phantom: ours.len() - matched.len(),
        late: matched.iter().filter(late).count(),
        resolution,
        parting: parting(&ours, &theirs, &matched, strict),
        matched,
    }
}

/// The alignment up to the first place where the orders differ and what event times can be held to after it: of what comes later nobody
/// can say whether it is missed. The whole alignment where they do not differ.
pub fn align_to_parting(trace: &Trace, reference: &Trace) -> Order {
    let whole = align(trace, reference);
    match &whole.parting {
        None => whole,
        Some(parting) => align_until(trace, reference, parting.time() + whole.resolution),
    }
}

/// Pairs the k-th occurrence of each kind in one list with the k-th in the other.
fn matches(ours: &[Event], theirs: &[Event]) -> Vec<(usize, usize)> {
    let mut places: HashMap<EventKind, Vec<usize>> = HashMap::new();
    for (j, event) in theirs.iter().enumerate() {
        places.entry(event.kind).or_default().push(j);
    }
    let mut seen: HashMap<EventKind, usize> = HashMap::new();
    let mut matched = Vec::new();
    for (i, event) in ours.iter().enumerate() {
        let k = seen.entry(event.kind).or_insert(0);
        if let Some(&j) = places.get(&event.kind).and_then(|p| p.get(*k)) {
            matched.push((i, j));
        }
        *k += 1;
    }
    matched
}

/// The largest n for which the first n of both are the same events and every inverted pair among them is a tie.
fn tolerant_prefix(
    ours: &[Event],
    theirs: &[Event],
    matched: &[(usize, usize)],
    resolution: f64,
) -> usize {
    longest_prefix(matched, |(p, q), (i, j)| {
        let close = (theirs[q].time - theirs[j].time).abs() < resolution;
        close && !ours[p].kind.shares_ball(ours[i].kind)
    })
}

/// The same, given which inverted pairs of `matched` are ties. Asks of each inverted pair once, and of no other.
fn longest_prefix(
    matched: &[(usize, usize)],
    mut tie: impl FnMut((usize, usize), (usize, usize)) -> bool,
) -> usize {
    let mut best = 0;
    // what both have beyond the longest prefix so far, by its place in theirs
    let mut ahead: BTreeMap<usize, usize> = BTreeMap::new();
    for (n, &(i, j)) in matched.iter().enumerate() {
        // matched in order without a gap, or some event of ours has no partner
        if i != n {
            break;
        }
        // those that they have later are inverted
        if !ahead.range(j + 1..).all(|(&q, &p)| tie((p, q), (i, j))) {
            break;
        }
        ahead.insert(j, i);
        // the first n + 1 of ours are the first n + 1 of theirs exactly when none of them lies farther out
        if ahead.last_key_value().is_some_and(|(q, _)| *q == n) {
            best = n + 1;
            ahead.clear();
        }
    }
    best
}

fn parting(
    ours: &[Event],
    theirs: &[Event],
    matched: &[(usize, usize)],
    index: usize,
) -> Option<Parting> {
    let (event, reference) = (ours.get(index).copied(), theirs.get(index).copied());
    if event.is_none() && reference.is_none() {
        return None;
    }
    let elsewhere = matched
        .iter()
        .find(|(i, _)| *i == index)
        .map(|&(_, j)| theirs[j].time);
    let margin = match (elsewhere, reference) {
        (Some(time), Some(reference)) => Some(time - reference.time),
        _ => None,
    };
    Some(Parting {
        index,
        event,
        reference,
        margin,
    })
}

#[cfg(test)]
mod tests {
    use super::{longest_prefix, matches, tolerant_prefix};
    use crate::physics::Side;
    use crate::trace::{Event, EventKind};

    fn hits(list: &[(f64, usize, usize)]) -> Vec<Event> {
        let event = |&(time, a, b): &(f64, usize, usize)| Event {
            time,
            kind: EventKind::ball_ball(a, b),
            exchanges: Some(1),
        };
        list.iter().map(event).collect()
    }

    fn prefix(ours: &[Event], theirs: &[Event], resolution: f64) -> usize {
        tolerant_prefix(ours, theirs, &matches(ours, theirs), resolution)
    }

    #[test]
    fn events_without_a_common_ball_may_swap_within_the_resolution() {
        let theirs = hits(&[(1.0, 0, 1), (1.0005, 2, 3), (2.0, 0, 2)]);
        let ours = hits(&[(1.0, 2, 3), (1.0, 0, 1), (2.0, 0, 2)]);
        assert_eq!(prefix(&ours, &theirs, 1e-3), 3);
        assert_eq!(
            prefix(&ours, &theirs, 1e-4),
            0,
            "farther apart than the resolution"
        );
    }

    #[test]
    fn events_with_a_common_ball_may_not_swap() {
        let theirs = hits(&[(1.0, 0, 1), (1.0001, 1, 3)]);
        let ours = hits(&[(1.0, 1, 3), (1.0, 0, 1)]);
        assert_eq!(prefix(&ours, &theirs, 1e-3), 0);
    }

    #[test]
    fn ties_do_not_chain() {
        // each neighbour is a tie, the outer two are not
        let theirs = hits(&[(1.0, 0, 1), (1.0008, 2, 3), (1.0016, 4, 5)]);
        let ours = hits(&[(1.0, 4, 5), (1.0, 2, 3), (1.0, 0, 1)]);
        assert_eq!(prefix(&ours, &theirs, 1e-3), 0);
    }

    #[test]
    fn a_repeated_hit_matches_by_its_count() {
        let theirs = hits(&[(1.0, 0, 1), (2.0, 0, 1)]);
        let ours = hits(&[(1.0, 0, 1), (2.0, 0, 1), (3.0, 0, 1)]);
        assert_eq!(matches(&ours, &theirs), vec![(0, 0), (1, 1)]);
        assert_eq!(prefix(&ours, &theirs, 1e-3), 2);
    }

    #[test]
    fn only_inverted_pairs_are_looked_at() {
        // neighbours swapped all along: one inverted pair in two events
        let asked = |events: usize| {
            let matched: Vec<(usize, usize)> = (0..events).map(|i| (i, i ^ 1)).collect();
            let mut asked = 0;
            let prefix = longest_prefix(&matched, |_, _| {
                asked += 1;
                true
            });
            assert_eq!(prefix, events);
            asked
        };
        assert_eq!((asked(100), asked(100_000)), (50, 50_000));
    }

    #[test]
    fn a_phantom_ends_the_prefix() {
        let theirs = hits(&[(1.0, 0, 1), (2.0, 0, 2)]);
        let mut ours = hits(&[(1.0, 0, 1), (2.0, 0, 2)]);
        ours.insert(
            1,
            Event {
                time: 1.5,
                kind: EventKind::BallCushion(0, Side::X0),
                exchanges: Some(1),
            },
        );
        assert_eq!(prefix(&ours, &theirs, 1e-3), 1);
    }
}
