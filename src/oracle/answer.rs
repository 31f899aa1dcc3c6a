//! What the exact engine knows of a scene, and what a first-order engine may miss of it.
//!
//! An engine with a step finds a collision up to one step late, by which two balls have come up to `2 v dt` too near, v the largest speed
//! of the exact run. Each collision i hands such an error on, grown by the largest factor G_i by which a perturbation just after it has
//! grown at the end of the run. So after k collisions a position may be off by `2 v dt (1 + G_1 + ... + G_k)`. To it comes rounding: each step and
//! each collision rounds positions and velocities once, which adds up to `(steps + k + 1) ulp (X + v t) G`, X the largest
//! coordinate and G the growth from the start.

use super::horizon::{BAND, Horizon, Sight, horizon};
use super::{Growth, Precision, engine, growth};
use crate::engine::Limits;
use crate::engine::exact::solve;
use crate::scene::{Scene, Simultaneous};
use crate::trace::{Ending, Trace};

/// The run is started anew after no more collisions than this.
const MOST_RESTARTS: usize = 64;

/// What the exact engine knows of a scene.
#[derive(Clone, Debug)]
pub struct Oracle {
    /// Its run in f64.
    pub trace: Trace,
    /// Time up to which two precisions agree about it, s; infinite for the whole run.
    pub until: f64,
    /// Events up to there, and of the run.
    pub certain: (usize, usize),
    /// Largest factor by which a perturbation of the start grows, at least 1.
    pub grown: f64,
    /// The same from just after each collision to the end of the run.
    pub handed_on: Vec<f64>,
    /// Largest speed of a ball at any event, length/s.
    pub fastest: f64,
}

impl Oracle {
    /// Asks the exact engine; `None` where it lacks something that the scene calls for, or cannot say how far its own run can be believed.
    pub fn ask(scene: &Scene, limits: &Limits<'_>) -> Option<Oracle> {
        if !engine().missing(scene).is_empty() {
            return None;
        }
        let found = horizon(scene, Precision::F64, false, limits)?;
        if found.trace.ending == Ending::Cancelled {
            return None;
        }
        let (certain, until) = match scene.simultaneous {
            Simultaneous::Refuse | Simultaneous::Ensemble => (found.certain, found.until),
            // a convention resolves contacts that have no margin
            Simultaneous::GeneralizedReflections => by_agreement(&found),
        };
        Some(Oracle {
            until,
            certain: (certain, found.sights.len()),
            grown: factor(scene, &found.trace, found.growth.as_ref()),
            handed_on: handed_on(scene, &found.trace, limits),
            fastest: found.trace.fastest(),
            trace: found.trace,
        })
    }

    /// True where the run reached the end that the scene asks for.
    pub fn is_complete(&self) -> bool {
        self.trace.ending.is_complete()
    }

    /// True where the scene has one answer, to its end: the run reached the end that the scene asks for, and can be believed up to there.
    pub fn is_single(&self) -> bool {
        self.is_whole() && self.is_complete()
    }

    /// True where the run can be believed to its end.
    pub fn is_whole(&self) -> bool {
        self.until.is_infinite()
    }

    /// By how much a position may be off after `collisions`, before the next one, length.
    pub fn allowance(&self, scene: &Scene, allowance: &Allowance, collisions: usize) -> f64 {
        let handed_on: f64 = self.handed_on.iter().take(collisions).sum();
        let n = collisions.min(self.handed_on.len()) as f64 + 1.0;
        let stepping = 2.0 * self.fastest * allowance.dt * (1.0 + handed_on);
        let time = self.trace.end_time.min(scene.duration);
        let operations = allowance.steps as f64 + n;
        let rounding = rounding(scene, operations, allowance.ulp, self.fastest, time);
        stepping + rounding * self.grown
    }
}

/// Number of events about which two precisions agree, and the time of the next, s, whatever their margins.
fn by_agreement(found: &Horizon) -> (usize, f64) {
    let differs = |sight: &Sight| !sight.shrinks && !sight.apart.is_some_and(|apart| apart < BAND);
    let first = found.sights.iter().position(differs);
    let time = |index: usize| found.sights[index].event.time;
    (
        first.unwrap_or(found.sights.len()),
        first.map_or(f64::INFINITY, time),
    )
}

/// Growth from just after each collision to the end. Of many collisions a few speak for those that follow them.
fn handed_on(scene: &Scene, trace: &Trace, limits: &Limits<'_>) -> Vec<f64> {
    let times: Vec<f64> = trace.collisions().map(|event| event.time).collect();
    let stride = times.len().div_ceil(MOST_RESTARTS).max(1);
    let mut grown = Vec::with_capacity(times.len());
    for chunk in times.chunks(stride) {
        let rest = from(scene, trace, chunk[0]).map(|rest| {
            let again = solve::<f64>(&rest, limits).trace;
            factor(&rest, &again, growth(&rest, &again, false, limits).as_ref())
        });
        grown.extend(chunk.iter().map(|_| rest.unwrap_or(1.0)));
    }
    grown
}

/// The scene from `time` on; `None` once a ball has left play.
fn from(scene: &Scene, trace: &Trace, time: f64) -> Option<Scene> {
    let mut rest = scene.clone();
    rest.duration = trace.end_time - time;
    rest.shot = None;
    for (i, ball) in rest.balls.iter_mut().enumerate() {
        ball.state = trace.in_play_at(i, time)?;
    }
    (rest.duration > 0.0).then_some(rest)
}

/// Growth up to the last event, and on the flight from there to the end: a velocity that is off by part of the largest speed moves its ball
/// by as much in units of that speed and a radius.
fn factor(scene: &Scene, trace: &Trace, growth: Option<&Growth>) -> f64 {
    let last = trace.events.last().map_or(0.0, |event| event.time);
    let flight = scene.largest_speed() * (trace.end_time - last) / scene.smallest_radius();
    if growth.is_some_and(|growth| growth.differs || !growth.lost.is_empty()) {
        // of a ball without a derivative it is not known
        return f64::INFINITY;
    }
    let factor = growth.map_or(1.0, Growth::last) * (1.0 + flight.max(0.0));
    // one that overflowed bounds nothing
    if factor.is_nan() {
        f64::INFINITY
    } else {
        factor.max(1.0)
    }
}

/// What of an engine an error may come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Allowance {
    /// Step, s; 0 without one.
    pub dt: f64,
    /// Steps taken.
    pub steps: u64,
    /// Rounding of the scalar.
    pub ulp: f64,
}

/// What rounding makes of a position in a run, before it grows, length.
///
/// Each of `operations` (steps and collisions, one more for the start) rounds positions and velocities once: `ulp` of the largest coordinate
/// and of the longest way, `fastest` (length/s) times `time` (s).
pub fn rounding(scene: &Scene, operations: f64, ulp: f64, fastest: f64, time: f64) -> f64 {
    operations * ulp * (scene.largest_coordinate() + fastest * time)
}
