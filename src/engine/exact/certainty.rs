//! How certain each event of a finished run is: the margin to the next candidate, the condition, and the error of the time.
//!
//! The error is estimated by taking the run again in dual numbers whose lanes are probes: at the start and after every event each
//! probe disturbs centre, velocity and clock by all the rounding that one event can do to them, with random signs, and the dual
//! arithmetic carries every disturbance to every later event. The estimate is [`DEVIATIONS`] times the root mean square of the
//! probes. It is linear, so it holds as long as the error stays small, which is up to the horizon.
//!
//! The work of an event does not depend on how many events the run has, and it has a bound: beyond the horizon nothing is searched
//! that could not change what is said.

use super::derived::{self, Errors, Found, Seeds, Task, holds_balls};
use super::encounter::Encounter;
use super::kinematics::Kinematics;
use super::predict::Row;
use super::rerun::follow;
use super::simultaneous::Cluster;
use super::spin::Moving;
use super::tangent::{Replay, Script};
use crate::engine::Limits;
use crate::math::random::Draws;
use crate::scene::{Scene, Simultaneous};
use crate::trace::{Certainty, Ending, Event, EventKind, Trace};
use std::cell::Cell;

/// Certainty is not computed for more balls than this: the margin of an event looks at all of them.
pub const MOST_BALLS: usize = 1000;

/// Random combinations of roundings that are followed.
const PROBES: usize = 16;

/// Estimated error, in root mean squares of the probes. Four, because 16 probes tell a deviation to a fifth or so, and an error is
/// beyond three deviations once in 400 events.
const DEVIATIONS: f64 = 4.0;

/// Balls within reach of each other, at most, whose impacts are tried in every order: beyond, the order is taken to matter. No
/// instant of a run before its horizon has so many.
const MOST_IN_REACH: usize = 32;

/// Up to so many balls every order is tried, however long the error of a time is.
const FEW_BALLS: usize = 8;

/// Seed of the signs; any number would do.
const SEED: u64 = 7;

/// Roundings of a velocity in one impact, relative.
const SPEED_ROUNDINGS: f64 = 2.0;

/// Roundings of the clock in one event.
const CLOCK: f64 = 2.0;

/// Certainty of every event of a trace of the exact engine, in a scalar whose unit in the last place is `ulp`.
///
/// Empty for more than [`MOST_BALLS`] balls, for a run that the user stopped, and where the user asks to stop meanwhile: a list that is
/// not whole would be taken for one.
pub fn certify(scene: &Scene, trace: &Trace, ulp: f64, limits: &Limits<'_>) -> Vec<Certainty> {
    if scene.balls.len() > MOST_BALLS || trace.ending == Ending::Cancelled {
        return Vec::new();
    }
    let script = Script::new(scene, trace);
    certified(&script, ulp, limits).0
}

/// Certifies a run. One that the user stops meanwhile ends as stopped: it has not done all that it was asked for.
pub(super) fn certify_run(scene: &Scene, trace: &mut Trace, ulp: f64, limits: &Limits<'_>) {
    trace.certainty = certify(scene, trace, ulp, limits);
    let due = scene.balls.len() <= MOST_BALLS && !trace.events.is_empty();
    if due && trace.certainty.is_empty() {
        trace.ending = Ending::Cancelled;
    }
}

/// The certainty of all events, and the work that it took.
fn certified(script: &Script<'_>, ulp: f64, limits: &Limits<'_>) -> (Vec<Certainty>, Work) {
    let events = &script.trace.events;
    let through = holds_balls(script.trace, ulp).then(|| errors(script, ulp, limits));
    let mut probes = through.is_none().then(|| Probes::new(script, ulp));
    let through = through.unwrap_or_default();
    let mut table = Table::new(script);
    let later = next_times(events, script.scene.balls.len());
    let mut found = Vec::with_capacity(events.len());
    for (index, event) in events.iter().enumerate() {
        if limits.is_cancelled() {
            return (Vec::new(), table.work);
        }
        let time_error = match &mut probes {
            Some(probes) => probes.error(event, ulp),
            None => through.get(index).copied().flatten(),
        };
        if time_error.is_none() {
            // what follows an event without a derivative has none either
            probes = None;
        }
        let after = Some(later[index] - event.time);
        let mut certainty = table.certainty(event, after);
        certainty.time_error = time_error;
        if !certainty.is_clear() && !table.order_matters(event, time_error.unwrap_or_default()) {
            // what else there is at this instant makes no difference
            certainty.margin = after;
        }
        table.pass(index);
        table.work.events += 1;
        found.push(certainty);
    }
    (found, table.work)
}

/// Errors of the times of the events of a run in which balls stay in contact; `None` of one that has no derivative.
fn errors(script: &Script<'_>, ulp: f64, limits: &Limits<'_>) -> Vec<Option<f64>> {
    let (scene, trace) = (script.scene, script.trace);
    let Some(Found {
        task: Task::Errors(errors),
        same,
        ..
    }) = followed(scene, trace, ulp, limits)
    else {
        return Vec::new();
    };
    errors.found.into_iter().take(same).collect()
}

/// Estimated errors of where the balls are in the end, in scene order, length, of a run in which balls stay in contact: through all rounding, and through what
/// was left of approaches when contacts began. NaN of a ball whose place has no derivative. Empty for other runs, and where the run cannot be taken again.
pub fn place_errors(scene: &Scene, trace: &Trace, ulp: f64, limits: &Limits<'_>) -> Vec<f64> {
    if !holds_balls(trace, ulp) {
        return Vec::new();
    }
    let found = followed(scene, trace, ulp, limits);
    let whole = found.filter(|found| found.same == trace.events.len());
    whole.map_or_else(Vec::new, |found| derived::place_errors(&found, DEVIATIONS))
}

/// A run taken again with the errors of its events.
fn followed(scene: &Scene, trace: &Trace, ulp: f64, limits: &Limits<'_>) -> Option<Found> {
    let task = Task::Errors(Box::new(Errors {
        draws: Draws::new(SEED, 0),
        roundings: [SPEED_ROUNDINGS, CLOCK],
        deviations: DEVIATIONS,
        found: Vec::new(),
        of_law: 0.0,
        taken: Vec::new(),
    }));
    let seeds = Seeds {
        estimates: true,
        ..Seeds::default()
    };
    follow(scene, trace, ulp, seeds, task, limits)
}

/// For each event the time of the first one later than it of any of its balls, s; infinite where there is none. One pass from the end.
fn next_times(events: &[Event], balls: usize) -> Vec<f64> {
    // of each ball the time of its next event, and that of the first one which is later than that
    let mut next = vec![[f64::INFINITY; 2]; balls];
    let mut times = vec![f64::INFINITY; events.len()];
    for (event, found) in events.iter().zip(&mut times).rev() {
        let (a, b) = event.kind.balls();
        for ball in std::iter::once(a).chain(b) {
            let [first, second] = &mut next[ball];
            if *first > event.time {
                *second = *first;
            }
            *first = event.time;
            *found = found.min(*second);
        }
    }
    times
}

/// What was done to certify a run: it grows as the number of events does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Work {
    /// Events.
    events: u64,
    /// Balls whose way was looked at, for one event after another.
    looks: u64,
    /// Clusters of which every order was tried.
    searches: u64,
    /// Searches for the root of a contact.
    root_searches: u64,
}

/// The run with the roundings of every event.
struct Probes<'a> {
    replay: Replay<'a, PROBES>,
    /// Rounding of a coordinate, length.
    length: f64,
    /// Rounding of a velocity, as a part of it.
    speed: f64,
    draws: Draws,
}

impl<'a> Probes<'a> {
    fn new(script: &'a Script<'a>, ulp: f64) -> Self {
        let effects = script.scene.effects.lift();
        let replay = Replay::new(script, &effects, |_, _| {});
        let mut probes = Probes {
            length: ulp * replay.world.extent,
            speed: SPEED_ROUNDINGS * ulp,
            draws: Draws::new(SEED, 0),
            replay,
        };
        for ball in 0..script.scene.balls.len() {
            probes.disturb(ball, 0.0);
        }
        probes
    }

    /// Error of the time of the next event, s; `None` if it has no derivative.
    fn error(&mut self, event: &Event, ulp: f64) -> Option<f64> {
        let time = self.replay.step()?.ok()?;
        let clock = CLOCK * ulp * event.time;
        let (a, b) = event.kind.balls();
        for ball in std::iter::once(a).chain(b) {
            self.disturb(ball, clock);
        }
        let squares: f64 = time.partials.iter().map(|x| x * x).sum();
        let deviation = (squares / PROBES as f64).sqrt();
        Some(DEVIATIONS * deviation + clock)
    }

    /// Disturbs what a ball does by one rounding of everything that it consists of.
    fn disturb(&mut self, ball: usize, clock: f64) {
        let flight = &self.replay.flights[ball];
        let fastest = flight.fastest.value;
        let (length, speed) = (self.length, self.speed * fastest + self.replay.law_error);
        let spin = speed / self.replay.world.radius[ball].value;
        let turning = !self.replay.spins.is_empty();
        let mut moving = self.replay.set_out(ball);
        let mut start = flight.start;
        for lane in 0..PROBES {
            let mut signs = self.draws.bits();
            let mut signed = |size: f64| {
                signs >>= 1;
                if signs & 1 == 0 { size } else { -size }
            };
            for axis in 0..2 {
                moving.position[axis].partials[lane] += signed(length);
                moving.velocity[axis].partials[lane] += signed(speed);
            }
            if turning {
                for w in &mut moving.spin {
                    w.partials[lane] += signed(spin);
                }
            }
            start.partials[lane] += signed(clock);
        }
        self.replay.depart(ball, start, moving);
    }
}

/// Where every ball is between two events, in f64.
struct Table<'a> {
    script: &'a Script<'a>,
    balls: Kinematics<'a, f64>,
    work: Work,
}

impl<'a> Table<'a> {
    fn new(script: &'a Script<'a>) -> Self {
        Table {
            script,
            balls: Kinematics::new(script.scene),
            work: Work::default(),
        }
    }

    /// Margin and condition of the event that is next, seen from before it. `after`: s to the next later event of its balls.
    fn certainty(&mut self, event: &Event, after: Option<f64>) -> Certainty {
        self.balls.advance(event.time);
        let (a, b) = event.kind.balls();
        let known = encounter(event.kind);
        let margin = match event.kind {
            EventKind::BallBall(..) | EventKind::BallCushion(..) => {
                let balls = std::iter::once(a).chain(b);
                let next = balls.map(|ball| self.next(ball, known));
                Some(next.fold(f64::INFINITY, f64::min))
            }
            _ => after,
        };
        Certainty {
            margin,
            condition: self.condition(event),
            time_error: None,
        }
    }

    /// Time until something else than the encounter at hand happens to a ball that goes on as it does, s.
    fn next(&mut self, ball: usize, known: Option<Encounter>) -> f64 {
        let all = 0..self.balls.count();
        self.work.looks += all.len() as u64;
        let row = Row::of(&self.balls, ball);
        let row = match known {
            None => row,
            Some(encounter) => row.without(encounter),
        };
        let next = row.next_event(all, None, &mut self.work.root_searches);
        let end = match self.script.trace.ending {
            // an event can also fall out of the run
            Ending::Duration => self.script.trace.end_time,
            _ => f64::INFINITY,
        };
        (next.time.min(end) - self.balls.now()).max(0.0)
    }

    fn condition(&self, event: &Event) -> Option<f64> {
        let state = |ball: usize| self.balls.at(ball);
        let (along, normal) = match event.kind {
            EventKind::BallBall(a, b) => {
                let ((p, v), (q, w)) = (state(a as usize), state(b as usize));
                let (x, y) = (q[0] - p[0], q[1] - p[1]);
                let (vx, vy) = (v[0] - w[0], v[1] - w[1]);
                let normal = (vx * x + vy * y) / x.hypot(y);
                (vx.hypot(vy), normal)
            }
            EventKind::BallCushion(a, side) => {
                let (_, v) = state(a as usize);
                (v[0].hypot(v[1]), v[side.axis()].abs())
            }
            _ => return None,
        };
        (normal > 0.0).then(|| (along / normal).max(1.0))
    }

    /// True if impacts within `window` seconds of this one could come in another order with another result.
    ///
    /// Also where that is not tried: among more than a few balls, within as much time as the whole run took, anything could have come
    /// first; and so it could among more than [`MOST_IN_REACH`] of them.
    fn order_matters(&mut self, event: &Event, window: f64) -> bool {
        if self.script.scene.simultaneous == Simultaneous::GeneralizedReflections {
            // the convention takes them all at once
            return false;
        }
        if self.balls.count() > FEW_BALLS && window > self.script.trace.end_time {
            return true;
        }
        let looks = Cell::new(0);
        let state = |ball: usize| {
            looks.set(looks.get() + 1);
            self.balls.at(ball)
        };
        let everyone = |_: usize| (0..self.balls.count()).collect();
        let (a, b) = event.kind.balls();
        let seeds: Vec<usize> = std::iter::once(a).chain(b).collect();
        self.work.searches += 1;
        let cluster = Cluster::around(
            self.balls.world(),
            &seeds,
            &state,
            &everyone,
            window,
            MOST_IN_REACH,
        );
        self.work.looks += looks.get();
        cluster.order_matters()
    }

    /// Takes the balls of an event to its far side.
    fn pass(&mut self, index: usize) {
        for (ball, state) in self.script.far(index) {
            let course = self.balls.course(ball, Moving::lifted(state));
            self.balls.set_off(ball, &course);
        }
    }
}

/// The encounter that an event is.
fn encounter(kind: EventKind) -> Option<Encounter> {
    match kind {
        EventKind::BallBall(a, b) => Some(Encounter::Pair(a as usize, b as usize)),
        EventKind::BallCushion(a, side) => Some(Encounter::Cushion(a as usize, side)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::exact::solve;
    use crate::scene::generate::{Recipe, generate};
    use crate::scene::{catalogue, parse};
    use std::sync::atomic::AtomicBool;

    fn gas(balls: usize) -> Scene {
        let recipe = Recipe {
            balls,
            duration: 1e6,
            ..Recipe::default()
        };
        let text = generate(&recipe).unwrap_or_else(|error| panic!("{error}"));
        parse("gas.toml", &text).unwrap_or_else(|error| panic!("{error}"))
    }

    fn of(scene: &Scene, events: u64) -> (Trace, Work) {
        let limits = Limits {
            max_events: events,
            ..Limits::NONE
        };
        let trace = solve::<f64>(scene, &limits).trace;
        let script = Script::new(scene, &trace);
        let (found, work) = certified(&script, f64::EPSILON, &Limits::NONE);
        assert_eq!((found.len() as u64, work.events), (events, events));
        (trace, work)
    }

    #[test]
    fn ten_times_the_events_are_ten_times_the_work() {
        let bouncing = catalogue::scene("bounces-100000").unwrap_or_else(|e| panic!("{e}"));
        for (scene, least) in [(bouncing, 1_000), (gas(16), 1_000), (gas(100), 2_000)] {
            let (_, few) = of(&scene, least);
            let (_, many) = of(&scene, 10 * least);
            // beyond the horizon every event is in doubt, and a search ends as soon as too many balls are within reach: each of
            // those looks at all once, and all are looked at once more for the next event of either ball
            let balls = scene.balls.len() as u64;
            let each = 2 * balls + (MOST_IN_REACH as u64 + 1) * (balls + 2);
            for (work, events) in [(few, least), (many, 10 * least)] {
                assert!(
                    work.searches <= events && work.looks <= events * each,
                    "{work:?}"
                );
            }
        }
    }

    #[test]
    fn the_next_times_are_those_that_a_search_of_all_events_finds() {
        let scene = gas(16);
        let (trace, _) = of(&scene, 2_000);
        let mut together = trace.events.clone();
        // several at one time
        for (index, event) in together.iter_mut().enumerate() {
            event.time = (index / 3) as f64;
        }
        for events in [&trace.events, &together] {
            let found = next_times(events, scene.balls.len());
            for (event, found) in events.iter().zip(found) {
                let later = events
                    .iter()
                    .find(|other| other.time > event.time && other.kind.shares_ball(event.kind));
                assert_eq!(later.map_or(f64::INFINITY, |later| later.time), found);
            }
        }
    }

    #[test]
    fn a_certification_that_is_asked_to_stop_leaves_nothing_half_done() {
        let scene = gas(16);
        let (mut trace, _) = of(&scene, 500);
        let stop = AtomicBool::new(true);
        let limits = Limits {
            cancelled: &stop,
            ..Limits::NONE
        };
        let script = Script::new(&scene, &trace);
        let mut run = trace.clone();
        certify_run(&scene, &mut run, f64::EPSILON, &limits);
        assert_eq!((run.ending, run.certainty), (Ending::Cancelled, Vec::new()));
        let (found, work) = certified(&script, f64::EPSILON, &limits);
        assert_eq!((found.len(), work.events), (0, 0));
        assert_eq!(certify(&scene, &trace, f64::EPSILON, &limits), []);
        let whole = certify(&scene, &trace, f64::EPSILON, &Limits::NONE);
        assert_eq!(whole.len(), 500);
        // a run that was stopped is not certified at all
        trace.ending = Ending::Cancelled;
        assert_eq!(certify(&scene, &trace, f64::EPSILON, &Limits::NONE), []);
    }
}
