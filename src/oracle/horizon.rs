//! Up to which event anybody can be right: the horizon of a run in one precision, with a finer one as the witness.
//!
//! It is the last event up to which three things hold: both precisions have the same events in the same order, ball by ball; they
//! differ by less than [`BAND`]; and the margin of each event exceeds the error of its time, estimated and seen. Beyond
//! it the order of events, and with it everything else, is decided by rounding.

use crate::engine::Limits;
use crate::engine::exact::sensitivity::{Growth, growth};
use crate::engine::exact::{Precision, Solution, certify, solve};
use crate::math::{DoubleDouble, Octuple, Real, worse};
use crate::scene::Scene;
use crate::trace::{Ending, Event, EventKind, Trace};
use std::collections::HashMap;

pub use crate::engine::exact::MOST_BALLS;

/// Two precisions agree while they differ by less than this: positions in R, velocities in the largest initial speed, times in R
/// over that speed.
pub const BAND: f64 = 1e-9;

/// Why the horizon is where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// There is none within the run.
    Whole,
    /// The two precisions have another event next.
    Order,
    /// They differ by more than [`BAND`].
    Apart,
    /// An event is closer to another than the error of its time.
    Margin,
}

/// One event, as both precisions see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// The event, in the precision in question.
    pub event: Event,
    /// Time to the next other candidate, s.
    pub margin: Option<f64>,
    /// Condition number of its time.
    pub condition: Option<f64>,
    /// Estimated error of its time, s.
    pub estimated: Option<f64>,
    /// Difference of its time from the witness's, s; `None` where the witness does not have it in this place.
    pub seen: Option<f64>,
    /// Largest difference of time, position and velocity of its balls, in the units of [`BAND`].
    pub apart: Option<f64>,
}

/// How far a run can be believed.
#[derive(Clone, Debug, PartialEq)]
pub struct Horizon {
    /// The precision in question.
    pub precision: Precision,
    /// The one that it was held against.
    pub witness: Precision,
    /// Every event of the run.
    pub sights: Vec<Sight>,
    /// Number of events within the horizon.
    pub certain: usize,
    /// Time of the first event beyond it, s; infinite if there is none.
    pub until: f64,
    /// Why.
    pub limit: Limit,
    /// Growth of perturbations; `None` for more balls than it is computed for.
    pub growth: Option<Growth>,
    /// The run.
    pub trace: Trace,
}

impl Horizon {
    /// True if the whole run is within it.
    pub fn is_whole(&self) -> bool {
        self.limit == Limit::Whole
    }
}

/// The horizon of `scene` in `precision`. `whole_growth`: growth at every event, not at the last alone. The run of one that the user
/// stopped has the ending `Cancelled`.
///
/// `None` where there is no wider scalar to hold it against, for `auto`, which has no precision of its own, and for more balls than
/// [`MOST_BALLS`].
pub fn horizon(
    scene: &Scene,
    precision: Precision,
    whole_growth: bool,
    limits: &Limits<'_>,
) -> Option<Horizon> {
    if scene.balls.len() > MOST_BALLS {
        return None;
    }
    let mut horizon = match precision {
        Precision::F32 => held_against::<f32, f64>(scene, [precision, Precision::F64], limits),
        Precision::F64 => {
            held_against::<f64, DoubleDouble>(scene, [precision, Precision::Dd], limits)
        }
        Precision::Dd => {
            held_against::<DoubleDouble, Octuple>(scene, [precision, Precision::F256], limits)
        }
        Precision::F256 | Precision::Auto => return None,
    };
    horizon.trace.provenance.engine = super::engine().id().to_owned();
    horizon.trace.provenance.ulp = precision.ulp();
    horizon.growth = growth(scene, &horizon.trace, whole_growth, limits);
    if limits.is_cancelled() {
        // what was cut short says nothing, wherever it was cut
        horizon.trace.ending = Ending::Cancelled;
    }
    Some(horizon)
}

/// When a run in `precision` can no longer be believed, s; `None` where it can to its end or to that of the scene, where it has no answer
/// anyway, and where nothing is known.
pub fn believed_until(scene: &Scene, precision: Precision, limits: &Limits<'_>) -> Option<f64> {
    let horizon = horizon(scene, precision, false, limits)?;
    let whole = horizon.is_whole() || !horizon.trace.ending.is_complete();
    (!whole && horizon.until < scene.duration).then_some(horizon.until)
}

/// A run in `T` against one in `W`; `precisions`: their names.
fn held_against<T: Real, W: Real>(
    scene: &Scene,
    precisions: [Precision; 2],
    limits: &Limits<'_>,
) -> Horizon {
    let (run, witness) = (solve::<T>(scene, limits), solve::<W>(scene, limits));
    let sights = sights(scene, &run, &witness, limits);
    let failing = sights
        .iter()
        .enumerate()
        .find_map(|(index, sight)| Some((index, fault(sight)?)));
    let (certain, limit) = failing.unwrap_or((sights.len(), at_the_end(scene, &run, &witness)));
    let until = match limit {
        Limit::Whole => f64::INFINITY,
        _ => sights
            .get(certain)
            .map_or(run.trace.end_time, |sight| sight.event.time),
    };
    Horizon {
        precision: precisions[0],
        witness: precisions[1],
        sights,
        certain,
        until,
        limit,
        growth: None,
        trace: run.trace,
    }
}

/// What is wrong with an event, if anything is.
fn fault(sight: &Sight) -> Option<Limit> {
    let (Some(seen), Some(apart)) = (sight.seen, sight.apart) else {
        return Some(Limit::Order);
    };
    // a NaN is no agreement
    if apart.is_nan() || apart >= BAND {
        return Some(Limit::Apart);
    }
    let error = worse(sight.estimated.unwrap_or_default(), seen);
    let clear = sight.margin.is_none_or(|margin| margin > error);
    (!clear).then_some(Limit::Margin)
}

/// Whether the runs also end alike.
fn at_the_end<T: Real, W: Real>(scene: &Scene, run: &Solution<T>, witness: &Solution<W>) -> Limit {
    let (ours, theirs) = (&run.trace, &witness.trace);
    if ours.events.len() != theirs.events.len() || ours.ending.id() != theirs.ending.id() {
        return Limit::Order;
    }
    let ends = run.positions.iter().zip(&witness.positions);
    // a ball that left play in both is nowhere
    let in_play = ends
        .zip(ours.final_states())
        .filter(|(_, state)| state.is_some());
    let apart = in_play.map(|((p, q), _)| {
        let [x, y] = [0, 1].map(|i| (p[i].widen::<W>() - q[i]).to_f64());
        x.hypot(y) / scene.smallest_radius()
    });
    if apart.fold(0.0, worse) < BAND {
        Limit::Whole
    } else {
        Limit::Apart
    }
}

fn sights<T: Real, W: Real>(
    scene: &Scene,
    run: &Solution<T>,
    witness: &Solution<W>,
    limits: &Limits<'_>,
) -> Vec<Sight> {
    let certainty = certify(scene, &run.trace, T::ULP, limits);
    let (ours, theirs) = (Places::new(&run.trace), Places::new(&witness.trace));
    let length = scene.smallest_radius();
    let speed = scene.largest_speed().max(f64::MIN_POSITIVE);
    let mut sights = Vec::with_capacity(run.trace.events.len());
    for (index, event) in run.trace.events.iter().enumerate() {
        let known = certainty.get(index).copied().unwrap_or_default();
        let same = theirs.find(&ours, index);
        let seen = same.map(|other| {
            (run.times[index].widen::<W>() - witness.times[other])
                .abs()
                .to_f64()
        });
        let apart = same.zip(seen).map(|(other, seen)| {
            let sides = sides(&run.trace, index, event).zip(sides(&witness.trace, other, event));
            let worst = sides.map(|(a, b)| {
                let position = (a.position - b.position).norm() / length;
                worse(position, (a.velocity - b.velocity).norm() / speed)
            });
            worst.fold(seen * speed / length, worse)
        });
        sights.push(Sight {
            event: *event,
            margin: known.margin,
            condition: known.condition,
            estimated: known.time_error,
            seen,
            apart,
        });
    }
    sights
}

/// States of an event's balls on its far side, in the order of its kind.
fn sides(
    trace: &Trace,
    index: usize,
    event: &Event,
) -> impl Iterator<Item = crate::physics::State> {
    let (a, b) = event.kind.balls();
    let side = move |ball: usize| {
        let knots = &trace.paths[ball].knots;
        let first = knots.partition_point(|knot| knot.time < trace.events[index].time);
        let far = knots[first..]
            .iter()
            .find(|knot| knot.after == Some(index as u32));
        far.map(|knot| knot.state)
    };
    [Some(a), b]
        .into_iter()
        .flatten()
        .filter_map(side)
        .collect::<Vec<_>>()
        .into_iter()
}

/// Where each event stands: which occurrence of its kind it is, and its place among the events of each of its balls.
struct Places {
    by_occurrence: HashMap<(EventKind, usize), usize>,
    occurrence: Vec<(EventKind, usize)>,
    place: Vec<(usize, Option<usize>)>,
}

impl Places {
    fn new(trace: &Trace) -> Self {
        let mut counts: HashMap<EventKind, usize> = HashMap::new();
        let mut so_far = vec![0; trace.balls.len()];
        let mut places = Places {
            by_occurrence: HashMap::new(),
            occurrence: Vec::new(),
            place: Vec::new(),
        };
        for (index, event) in trace.events.iter().enumerate() {
            let count = counts.entry(event.kind).or_insert(0);
            places.by_occurrence.insert((event.kind, *count), index);
            places.occurrence.push((event.kind, *count));
            *count += 1;
            let (a, b) = event.kind.balls();
            let mut place = |ball: usize| {
                so_far[ball] += 1;
                so_far[ball]
            };
            let first = place(a);
            places.place.push((first, b.map(place)));
        }
        places
    }

    /// The event that is `other`'s event `index`, at the same place in the history of its balls.
    fn find(&self, other: &Places, index: usize) -> Option<usize> {
        let found = *self.by_occurrence.get(other.occurrence.get(index)?)?;
        (self.place[found] == other.place[index]).then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::catalogue;

    fn scene(name: &str) -> Scene {
        catalogue::scene(name).unwrap_or_else(|error| panic!("{error}"))
    }

    #[test]
    fn a_scene_is_cut_off_where_its_horizon_is_and_only_there() {
        let believed = |scene: &Scene| believed_until(scene, Precision::F64, &Limits::NONE);
        assert_eq!(believed(&scene("report-break")), None);
        let chaotic = scene("discs-in-a-box");
        let Some(until) = believed(&chaotic) else {
            panic!("f64 has a horizon in discs-in-a-box");
        };
        let found = horizon(&chaotic, Precision::F64, false, &Limits::NONE);
        assert_eq!(found.map(|found| found.until), Some(until));
        assert!(until > 0.0 && until < chaotic.duration);
        // what ends before its horizon is whole
        let short = Scene {
            duration: 0.5 * until,
            ..chaotic
        };
        assert_eq!(believed(&short), None);
    }
}
