//! The only writer of traces: knots, events, stop times and extrema, the same for every engine.

use super::{Counter, Ending, Event, EventKind, Extrema, Extremum, Knot, Path, Provenance, Trace};
use crate::physics::State;
use crate::scene::Scene;

/// How much of a run is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Record {
    /// First and last states, stop times, extrema and counters; of the events only those in which a ball left play.
    Final,
    /// Also every event with both its sides.
    Events,
    /// Also the states of moving balls every so many seconds, and the certainty of the events where the engine knows it. An engine
    /// whose knots are exact needs no such states and adds none.
    Every(f64),
}

/// Collects a trace while an engine runs.
#[derive(Debug)]
pub struct Recorder {
    record: Record,
    provenance: Provenance,
    balls: Vec<String>,
    paths: Vec<Path>,
    events: Vec<Event>,
    event_count: u32,
    stop_times: Vec<Option<f64>>,
    pocketed: Vec<bool>,
    extrema: Extrema,
    ledger: Ledger,
    next_sample: f64,
    samples: u64,
}

/// Energy relative to the start, and the lowest level so far.
#[derive(Clone, Copy, Debug, Default)]
struct Ledger {
    level: f64,
    lowest: f64,
}

impl Recorder {
    /// A recorder for a run of `scene`, holding the first knot of every ball.
    ///
    /// `initial`: the states inside the engine at time 0, in scene order (an f32 engine's are not quite the scene's).
    pub fn new(scene: &Scene, provenance: Provenance, record: Record, initial: &[State]) -> Self {
        let first_knot = |state: &State| Path {
            knots: vec![Knot {
                time: 0.0,
                state: *state,
                after: None,
            }],
        };
        let rest_speed = provenance.rest_speed;
        Recorder {
            record,
            balls: scene.balls.iter().map(|ball| ball.id.clone()).collect(),
            paths: initial.iter().map(first_knot).collect(),
            events: Vec::new(),
            event_count: 0,
            stop_times: initial
                .iter()
                .map(|s| (s.speed() <= rest_speed).then_some(0.0))
                .collect(),
            pocketed: vec![false; initial.len()],
            extrema: Extrema::default(),
            ledger: Ledger::default(),
            next_sample: match record {
                Record::Every(cadence) => cadence,
                Record::Final | Record::Events => f64::INFINITY,
            },
            samples: 0,
            provenance,
        }
    }

    /// Adds an event and answers its index.
    pub fn event(&mut self, time: f64, kind: EventKind, exchanges: Option<u64>) -> u32 {
        let index = self.event_count;
        // a run without a record may have more than can be named, and nobody asks for their names
        self.event_count = self.event_count.saturating_add(1);
        let kept = self.record != Record::Final || matches!(kind, EventKind::Pocket(..));
        if kept {
            self.events.push(Event {
                time,
                kind,
                exchanges,
            });
        }
        index
    }

    /// Sets the number of exchanges of an event, once its contact episode has seen another.
    pub fn set_exchanges(&mut self, event: u32, exchanges: u64) {
        if self.record == Record::Final {
            return;
        }
        if let Some(event) = self.events.get_mut(event as usize) {
            event.exchanges = Some(exchanges);
        }
    }

    /// Whether knots between the first and the last are kept.
    pub fn keeps_knots(&self) -> bool {
        self.record != Record::Final
    }

    /// A state that belongs to no event: where the step began in which a stepping engine found one, or stopped a ball, or
    /// one of those by which a trace follows a motion whose acceleration changes.
    ///
    /// It keeps the interpolation honest: without it a ball that rests until it is hit would creep toward the place where
    /// the step with the hit left it.
    pub fn pin(&mut self, ball: usize, time: f64, state: &State) {
        if self.record != Record::Final {
            add_knot(&mut self.paths[ball], time, state);
        }
    }

    /// Both sides of what an event did to one ball.
    #[inline]
    pub fn jump(&mut self, ball: usize, time: f64, before: &State, after: &State, event: u32) {
        if after.velocity.norm_squared() > 0.0 {
            self.stop_times[ball] = None;
        }
        let moved = (after.position - before.position).norm();
        raise(&mut self.extrema.displaced, moved, time, ball, None);
        if self.record != Record::Final {
            self.keep(ball, time, before, after, event);
        }
    }

    /// Both sides as knots, kept out of the code of runs of which only the end is asked for.
    #[inline(never)]
    fn keep(&mut self, ball: usize, time: f64, before: &State, after: &State, event: u32) {
        add_knot(&mut self.paths[ball], time, before);
        self.paths[ball].knots.push(Knot {
            time,
            state: *after,
            after: Some(event),
        });
    }

    /// A ball began to roll or lost its spin: adds the event and both its sides. Whether the centre rests is not touched.
    pub fn phase(
        &mut self,
        ball: usize,
        time: f64,
        before: &State,
        after: &State,
        kind: EventKind,
    ) -> u32 {
        let event = self.event(time, kind, None);
        let stop_time = self.stop_times[ball];
        self.jump(ball, time, before, after, event);
        self.stop_times[ball] = stop_time;
        event
    }

    /// The centre of a ball came to rest: adds the `stop` event, both sides, and the stop time.
    pub fn stop(&mut self, ball: usize, time: f64, before: &State, after: &State) -> u32 {
        let event = self.event(time, EventKind::Stop(ball as u32), None);
        self.jump(ball, time, before, after, event);
        self.stop_times[ball] = Some(time);
        event
    }

    /// A ball left play in `state`: adds the `pocket` event and ends the path there.
    pub fn pocket(&mut self, ball: usize, time: f64, state: &State, pocket: u32) -> u32 {
        let event = self.event(time, EventKind::Pocket(ball as u32, pocket), None);
        self.jump(ball, time, state, state, event);
        if self.record == Record::Final {
            add_knot(&mut self.paths[ball], time, state);
        }
        self.stop_times[ball] = None;
        self.pocketed[ball] = true;
        event
    }

    /// True when a cadence sample is due at `time`.
    pub fn due(&self, time: f64) -> bool {
        time >= self.next_sample
    }

    /// Adds a knot for every ball that moved since its last one, and schedules the next sample.
    pub fn sample(&mut self, time: f64, states: &[State]) {
        let Record::Every(cadence) = self.record else {
            return;
        };
        let balls = self.paths.iter_mut().zip(states).zip(&self.pocketed);
        for ((path, state), _) in balls.filter(|(_, pocketed)| !**pocketed) {
            let resting = path.knots.last().is_some_and(|knot| knot.state == *state);
            if !resting {
                add_knot(path, time, state);
            }
        }
        // counted, not accumulated: the cadence must not drift
        self.samples = self.samples.max((time / cadence) as u64).saturating_add(1);
        self.next_sample = self.samples as f64 * cadence;
    }

    /// Books a change of kinetic energy. Losses lower the level, gains above the lowest level are the extremum.
    pub fn energy_change(&mut self, time: f64, change: f64, ball: usize, other: Option<usize>) {
        self.ledger.level += change;
        if self.ledger.level < self.ledger.lowest {
            self.ledger.lowest = self.ledger.level;
        } else {
            raise(
                &mut self.extrema.energy_gained,
                self.ledger.level - self.ledger.lowest,
                time,
                ball,
                other,
            );
        }
    }

    /// Books the momentum, mass * length/s, by which a ball-ball impact missed conservation.
    pub fn momentum_error(&mut self, time: f64, error: f64, ball: usize, other: usize) {
        raise(&mut self.extrema.momentum, error, time, ball, Some(other));
    }

    /// Books the overlap of two balls, length; negative for a gap.
    pub fn overlap(&mut self, time: f64, depth: f64, ball: usize, other: usize) {
        raise(&mut self.extrema.overlap, depth, time, ball, Some(other));
    }

    /// Books how far a centre is beyond where the cushions let it be, length; negative inside.
    pub fn outside(&mut self, time: f64, distance: f64, ball: usize) {
        raise(&mut self.extrema.outside, distance, time, ball, None);
    }

    /// Ends the trace: a last knot for every ball still in play, and nothing after it.
    pub fn finish(
        mut self,
        time: f64,
        states: &[State],
        ending: Ending,
        counters: impl IntoIterator<Item = (Counter, u64)>,
    ) -> Trace {
        for (ball, state) in states.iter().enumerate() {
            if self.pocketed[ball] {
                continue;
            }
            add_knot(&mut self.paths[ball], time, state);
            // a speed that is no number is no rest
            if state.speed().is_nan() || state.speed() > self.provenance.rest_speed {
                self.stop_times[ball] = None;
            }
        }
        Trace {
            provenance: self.provenance,
            balls: self.balls,
            paths: self.paths,
            events: self.events,
            certainty: Vec::new(),
            stop_times: self.stop_times,
            extrema: self.extrema,
            counters: counters
                .into_iter()
                .map(|(counter, count)| (counter.id().to_owned(), count))
                .collect(),
            ending,
            end_time: time,
        }
    }
}

/// A knot that belongs to no event, unless the last one says the same already.
fn add_knot(path: &mut Path, time: f64, state: &State) {
    let known = path
        .knots
        .last()
        .is_some_and(|knot| knot.time == time && knot.state == *state);
    if !known {
        path.knots.push(Knot {
            time,
            state: *state,
            after: None,
        });
    }
}

/// Replaces an extremum by a worse value (NaN is the worst of all).
fn raise(extremum: &mut Extremum, value: f64, time: f64, ball: usize, other: Option<usize>) {
    if value > extremum.value || (value.is_nan() && !extremum.value.is_nan()) {
        *extremum = Extremum {
            value,
            time,
            ball: Some(ball as u32),
            other: other.map(|b| b as u32),
        };
    }
}
