//! Up to which event anybody can be right: the horizon of a run in one precision, with a finer one as the witness.
//!
//! It is the last event up to which three things hold: both precisions have the same events in the same order, ball by ball; they
//! differ by less than [`BAND`]; and the margin of each event exceeds the error of its time, estimated and seen. Beyond
//! it the order of events, and with it everything else, is decided by rounding.
//!
//! Impacts that shrink to a contact are of no account among themselves: a scalar with more digits has more of them, and their margins fall below every
//! error. Where both precisions reach the contact, with its balls at the same places and as fast, it is one event of which all this is asked.

use super::places::Places;
use crate::compare::contact_phases;
use crate::engine::Limits;
use crate::engine::exact::sensitivity::{Growth, growth};
use crate::engine::exact::{Precision, Solution, certify, solve};
use crate::math::{DoubleDouble, Octuple, Real, worse};
use crate::physics::State;
use crate::scene::Scene;
use crate::trace::{Ending, Event, EventKind, Trace};

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
    /// Largest difference of time, position and velocity of its balls, in the units of [`BAND`]; at the instant at which a contact of one of them
    /// begins, of places and velocities once it has in both.
    pub apart: Option<f64>,
    /// Whether it is one of impacts that shrink to a contact which both precisions reach alike: which of them are told, and in which order, is then of no
    /// account.
    pub shrinks: bool,
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
    let (sights, all_told) = sights(scene, &run, &witness, limits);
    let failing = sights
        .iter()
        .enumerate()
        .find_map(|(index, sight)| Some((index, fault(sight)?)));
    let at_the_end = || at_the_end(scene, &run, &witness, all_told);
    let (certain, limit) = failing.unwrap_or_else(|| (sights.len(), at_the_end()));
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
    if sight.shrinks {
        return None;
    }
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

/// Whether the runs also end alike. `all_told`: whether the witness has no further events.
fn at_the_end<T: Real, W: Real>(
    scene: &Scene,
    run: &Solution<T>,
    witness: &Solution<W>,
    all_told: bool,
) -> Limit {
    let (ours, theirs) = (&run.trace, &witness.trace);
    if !all_told || ours.ending.id() != theirs.ending.id() {
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

/// What both precisions make of every event, and whether the witness has no others.
fn sights<T: Real, W: Real>(
    scene: &Scene,
    run: &Solution<T>,
    witness: &Solution<W>,
    limits: &Limits<'_>,
) -> (Vec<Sight>, bool) {
    let certainty = certify(scene, &run.trace, T::ULP, limits);
    let mut places = Places::of(&run.trace, &witness.trace);
    let length = scene.smallest_radius();
    let speed = scene.largest_speed().max(f64::MIN_POSITIVE);
    let mut begun = vec![f64::NAN; scene.balls.len()];
    let mut sights = Vec::with_capacity(run.trace.events.len());
    for (index, event) in run.trace.events.iter().enumerate() {
        let known = certainty.get(index).copied().unwrap_or_default();
        let begins = matches!(event.kind, EventKind::ContactBegin(..));
        if begins {
            event
                .kind
                .each_ball()
                .for_each(|ball| begun[ball] = event.time);
        }
        let same = places.find(index).or_else(|| {
            let error = known.time_error.filter(|_| begins)?;
            places.find_later(index, error)
        });
        let seen = same.map(|other| {
            (run.times[index].widen::<W>() - witness.times[other])
                .abs()
                .to_f64()
        });
        let apart = same.zip(seen).map(|(other, seen)| {
            let far = |(a, b): (State, State)| {
                let position = (a.position - b.position).norm() / length;
                worse(position, (a.velocity - b.velocity).norm() / speed)
            };
            if event.kind.each_ball().any(|ball| begun[ball] == event.time) {
                // the time at which a contact begins is no better than what is left of the approach, and so is that of what else happens then
                let both = once_begun([&run.trace, &witness.trace], [index, other]);
                return both
                    .into_iter()
                    .map(|both| both.map_or(f64::INFINITY, far))
                    .fold(0.0, worse);
            }
            let sides = sides(&run.trace, index, event).zip(sides(&witness.trace, other, event));
            sides.map(far).fold(seen * speed / length, worse)
        });
        sights.push(Sight {
            event: *event,
            margin: known.margin,
            condition: known.condition,
            estimated: known.time_error,
            seen,
            apart,
            shrinks: false,
        });
    }
    let from: Vec<f64> = contact_phases(&run.trace)
        .iter()
        .map(|phase| phase.from)
        .collect();
    shrink(&mut sights, &from);
    let all_told = places.all_told();
    (sights, all_told)
}

/// Marks the events that lead to a contact that begins in both runs, of which no scalar of so many digits tells the order or the number: events of its own
/// balls alone, since the first of the impacts that shrink to it. A fault of anything else, or earlier, stays one. `from`: when those began, s, of each
/// contact in the order in which they begin.
fn shrink(sights: &mut [Sight], from: &[f64]) {
    let begins = |sight: &Sight| matches!(sight.event.kind, EventKind::ContactBegin(..));
    let ends: Vec<usize> = (0..sights.len())
        .filter(|index| begins(&sights[*index]))
        .collect();
    for (end, from) in ends.into_iter().zip(from) {
        if fault(&sights[end]).is_some() {
            continue;
        }
        let own: Vec<usize> = sights[end].event.kind.each_ball().collect();
        let first = sights[..end].partition_point(|sight| sight.event.time < *from);
        for sight in &mut sights[first..end] {
            let is_own = sight.event.kind.each_ball().all(|ball| own.contains(&ball));
            sight.shrinks |= is_own && fault(sight).is_some();
        }
    }
}

/// How the balls of an event move in two runs, once it has happened in both; `None` of one that is nowhere.
fn once_begun(traces: [&Trace; 2], events: [usize; 2]) -> Vec<Option<(State, State)>> {
    let times = [0, 1].map(|i| traces[i].events[events[i]].time);
    let time = times[0].max(times[1]);
    let state = |i: usize, ball: usize| traces[i].paths[ball].state_at(time);
    let kind = traces[0].events[events[0]].kind;
    kind.each_ball()
        .map(|ball| state(0, ball).zip(state(1, ball)))
        .collect()
}

/// States of an event's balls on its far side, in the order of its kind.
fn sides(trace: &Trace, index: usize, event: &Event) -> impl Iterator<Item = State> {
    let side = move |ball: usize| {
        let knots = &trace.paths[ball].knots;
        let first = knots.partition_point(|knot| knot.time < trace.events[index].time);
        let far = knots[first..]
            .iter()
            .find(|knot| knot.after == Some(index as u32));
        far.map(|knot| knot.state)
    };
    event.kind.each_ball().filter_map(side)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::catalogue;
    use crate::trace::Partner;

    fn scene(name: &str) -> Scene {
        catalogue::scene(name).unwrap_or_else(|error| panic!("{error}"))
    }

    #[test]
    fn only_what_shrinks_to_a_contact_of_its_own_balls_is_of_no_account() {
        let sight = |time: f64, kind: EventKind, same: bool| Sight {
            event: Event {
                time,
                kind,
                exchanges: None,
            },
            margin: Some(1.0),
            condition: None,
            estimated: Some(1e-9),
            seen: same.then_some(0.0),
            apart: same.then_some(0.0),
            shrinks: false,
        };
        let begins = |time: f64| sight(time, EventKind::ContactBegin(0, Partner::Ball(1)), true);
        let marked = |fault: Sight| {
            let mut sights = vec![fault, begins(1.0)];
            shrink(&mut sights, &[0.5]);
            sights[0].shrinks
        };
        let hit = EventKind::BallBall(0, 1);
        // since the first of its impacts
        assert!(marked(sight(1.0 - 5e-8, hit, false)));
        assert!(marked(sight(1.0 - 5e-8, EventKind::SlideToRoll(1), false)));
        // before them; of a third ball; and what is no fault
        assert!(!marked(sight(0.4, hit, false)));
        assert!(!marked(sight(0.1, EventKind::Stop(0), false)));
        assert!(!marked(sight(1.0 - 5e-8, EventKind::BallBall(1, 2), false)));
        assert!(!marked(sight(1.0 - 5e-8, hit, true)));
        // nor does a contact excuse anything that is not reached alike
        let mut apart = vec![sight(1.0 - 5e-8, hit, false), begins(1.0)];
        apart[1].apart = Some(BAND);
        shrink(&mut apart, &[0.5]);
        assert!(!apart[0].shrinks);
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
