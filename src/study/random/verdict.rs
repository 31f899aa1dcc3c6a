//! What must hold of every run, whatever the scene: finite, no energy out of nothing, nobody outside, no overlap, no collision
//! passed over. Reads a trace and asks parry; knows no engine.
//!
//! Bounds follow from the scheme that a trace states by its `resolution` `h`: 0 for an engine that solves for its events, else its step.
//!
//! - *Rounding*: what the place of a ball is good to ([`Scene::place_blur_within`]), with the largest coordinate of scene and
//!   trace, heights included.
//! - *Outside*: rounding, and `|v| h`: a step moves a ball after it has looked at the cushions. `|v|` is the largest speed of the ball
//!   at any knot. Between knots a velocity is linear in time, so that its size is largest at one of them.
//! - *Overlap*: rounding, and `n (|v1| + |v2|) h`, where `n` is the largest number of steps for which any pair stayed in contact. A
//!   pair that is apart closes in by at most `(|v1| + |v2|) h` in the step in which it meets, and by no more in each step until it
//!   parts; twice that where there are cushions, which put a ball back by what it went too far and let it move on in the same step. With one contact at a time `n` is 1 or 2; in a group of contacts each exchange can undo the one before, and no bound
//!   without `n` holds: a light ball between heavy ones needs about `sqrt(M/m)` exchanges to stop them. Parry is asked at knots,
//!   between which a stepped path is not quite the cubic through them: half a step more for each ball.

use super::laws::{self, Laws};
use crate::compare::{Sweep, sweep, worst_overlap};
use crate::math::{within, worse};
use crate::physics::State;
use crate::physics::invariants::kinetic_energy;
use crate::scene::Scene;
use crate::trace::{Counter, Ending, Trace};

/// Largest rise of the energy above its start, in the energy at the start.
pub const MOST_ENERGY: f64 = 1e-12;

/// Part by which a bound may be missed because it is itself rounded.
const ROUNDED: f64 = 1e-9;

/// Something that must not be.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Kebab-case name of what is broken.
    pub what: &'static str,
    /// When, who and how much.
    pub words: String,
}

impl Fault {
    /// A fault with its words.
    pub fn new(what: &'static str, words: String) -> Self {
        Fault { what, words }
    }
}

/// What a check of one trace saw.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// What must not be; empty if all is well.
    pub faults: Vec<Fault>,
    /// Largest rise of the energy above its start, in the energy at the start.
    pub energy: f64,
    /// Farthest outside, in what is allowed.
    pub outside: f64,
    /// Deepest overlap, in what is allowed.
    pub overlap: f64,
    /// What the sweep for collisions that were passed over saw, where there was one.
    pub sweep: Option<Sweep>,
    /// What was held against the laws, where the engine promises them.
    pub laws: Option<Laws>,
}

/// Holds a trace of `scene` against closed forms of its laws as well; for engines that promise [`Invariant::Laws`].
///
/// [`Invariant::Laws`]: crate::physics::invariants::Invariant::Laws
pub fn check_laws(scene: &Scene, trace: &Trace) -> Laws {
    if not_finite(trace).is_some() {
        return Laws::default();
    }
    // how near is near enough for an impact is decided before a run, by its longest way
    let place = rounding(scene, trace, scene.duration);
    laws::check(scene, trace, place)
}

/// Checks a trace of `scene`; `sweeps`: also for collisions that it passed over.
pub fn check(scene: &Scene, trace: &Trace, sweeps: bool) -> Verdict {
    let mut verdict = Verdict::default();
    if let Some(fault) = not_finite(trace) {
        verdict.faults.push(fault);
        // nothing else can be said of numbers that are none
        return verdict;
    }
    let bounds = Bounds::of(scene, trace);
    energy(scene, trace, &mut verdict);
    outside(scene, trace, &bounds, &mut verdict);
    overlap(scene, trace, &bounds, &mut verdict);
    if sweeps && trace.provenance.resolution == 0.0 && scene.effects.contact.is_some() {
        let seen = sweep(scene, trace, bounds.rounding);
        for (a, b, time) in &seen.overlaps {
            let words = format!("{} and {} at {time:e} s", trace.balls[*a], trace.balls[*b]);
            verdict.faults.push(Fault::new("passed-over", words));
        }
        verdict.sweep = Some(seen);
    }
    verdict
}

/// What is allowed of one trace.
struct Bounds {
    /// Of a position, length.
    rounding: f64,
    /// Largest speed of each ball times the step, length.
    step: Vec<f64>,
    /// Most steps for which a pair stayed in contact.
    steps: f64,
    /// How often a ball can move in a step: twice where a cushion may put it back.
    moves: f64,
}

impl Bounds {
    fn of(scene: &Scene, trace: &Trace) -> Self {
        let h = trace.provenance.resolution;
        let fastest = |knots: &[crate::trace::Knot]| {
            let speeds = knots.iter().map(|knot| knot.state.speed());
            speeds.fold(0.0, worse)
        };
        Bounds {
            rounding: rounding(scene, trace, trace.end_time),
            step: trace
                .paths
                .iter()
                .map(|path| fastest(&path.knots) * h)
                .collect(),
            steps: trace
                .count(Counter::LongestOverlap)
                .map_or(1.0, |steps| steps.max(1) as f64),
            moves: if scene.effects.cushion.is_some() {
                2.0
            } else {
                1.0
            },
        }
    }

    /// What two balls may overlap by, length; `more`: steps besides those in contact.
    fn overlap(&self, a: usize, b: usize, more: f64) -> f64 {
        let closing = self.moves * (self.step[a] + self.step[b]);
        (self.rounding + (self.steps + more) * closing) * (1.0 + ROUNDED)
    }
}

/// What the place of a ball is good to in a trace up to `time`, s; length.
fn rounding(scene: &Scene, trace: &Trace, time: f64) -> f64 {
    let knots = trace.paths.iter().flat_map(|path| &path.knots);
    let extent = knots.fold(scene.largest_coordinate(), |largest, knot| {
        worse(largest, knot.state.position.amax())
    });
    scene.place_blur_within(extent, time)
}

fn not_finite(trace: &Trace) -> Option<Fault> {
    let finite = |s: &State| {
        let parts = s.position.iter().chain(&s.velocity).chain(&s.spin);
        parts.into_iter().all(|x| x.is_finite())
    };
    for (path, id) in trace.paths.iter().zip(&trace.balls) {
        let all = path.knots.iter();
        if let Some(knot) = all
            .into_iter()
            .find(|k| !(finite(&k.state) && k.time.is_finite()))
        {
            let words = format!("ball {id} at {:e} s: {:?}", knot.time, knot.state);
            return Some(Fault::new("not-finite", words));
        }
    }
    match &trace.ending {
        // an engine that steps has no excuse: legal numbers are far from where their products overflow
        Ending::NotFinite(spot) if trace.provenance.resolution > 0.0 => {
            let words = format!("ended so at {:e} s: {}", spot.time, spot.why);
            Some(Fault::new("not-finite", words))
        }
        _ => None,
    }
}

/// No cloth and no impact adds energy, so that what a ball has left is at most what it had at its last knot.
fn energy(scene: &Scene, trace: &Trace, verdict: &mut Verdict) {
    let of = |ball: usize, state: &State| {
        kinetic_energy(state, scene.balls[ball].mass, scene.inertia(ball))
    };
    let mut now: Vec<f64> = (0..scene.balls.len())
        .map(|ball| of(ball, &scene.balls[ball].state))
        .collect();
    let start: f64 = now.iter().sum();
    let mut knots: Vec<(f64, usize, usize)> = Vec::new();
    for (ball, path) in trace.paths.iter().enumerate() {
        knots.extend(
            path.knots
                .iter()
                .enumerate()
                .map(|(i, k)| (k.time, i, ball)),
        );
    }
    // by time; at one time each ball's knots in their order, and nothing is concluded before the last
    knots.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let (mut most, mut when) = (start, 0.0);
    for (i, (time, knot, ball)) in knots.iter().enumerate() {
        now[*ball] = of(*ball, &trace.paths[*ball].knots[*knot].state);
        if knots.get(i + 1).is_none_or(|next| next.0 > *time) {
            let total: f64 = now.iter().sum();
            if total > most {
                (most, when) = (total, *time);
            }
        }
    }
    if most == start {
        return;
    }
    verdict.energy = if start > 0.0 {
        (most - start) / start
    } else {
        f64::INFINITY
    };
    if !within(verdict.energy, MOST_ENERGY) {
        let gained = verdict.energy;
        let words = format!("{gained:e} of the {start:e} at the start, at {when:e} s");
        verdict.faults.push(Fault::new("energy", words));
    }
}

fn outside(scene: &Scene, trace: &Trace, bounds: &Bounds, verdict: &mut Verdict) {
    if scene.effects.cushion.is_none() {
        return;
    }
    let mut report = |ball: usize, time: f64, beyond: f64| {
        let allowed = (bounds.rounding + bounds.step[ball]) * (1.0 + ROUNDED);
        let part = beyond / allowed;
        verdict.outside = worse(verdict.outside, part);
        if !within(beyond, allowed) && verdict.faults.iter().all(|fault| fault.what != "outside") {
            let id = &trace.balls[ball];
            let words = format!("ball {id} by {beyond:e} at {time:e} s, allowed {allowed:e}");
            verdict.faults.push(Fault::new("outside", words));
        }
    };
    let own = &trace.extrema.outside;
    if let Some(ball) = own.ball {
        report(ball as usize, own.time, own.value);
    }
    for (ball, path) in trace.paths.iter().enumerate() {
        let radius = scene.balls[ball].radius;
        for side in crate::physics::Side::ALL {
            let (axis, outward) = (side.axis(), f64::from(side.sign()));
            let Some(reach) = scene.reach(side, radius) else {
                continue;
            };
            for pair in path.knots.windows(2) {
                let (start, end) = (&pair[0].state, &pair[1].state);
                let h = pair[1].time - pair[0].time;
                let (v0, v1) = (outward * start.velocity[axis], outward * end.velocity[axis]);
                let beyond = |x: f64| outward * (x - reach);
                let mut far = worse(beyond(start.position[axis]), beyond(end.position[axis]));
                // where it turns back between two knots
                if v0 > 0.0 && v1 < 0.0 && h > 0.0 {
                    let turn = 0.5 * v0 * (v0 / (v0 - v1)) * h;
                    far = worse(far, beyond(start.position[axis]) + turn);
                }
                report(ball, pair[0].time, far);
            }
        }
    }
}

fn overlap(scene: &Scene, trace: &Trace, bounds: &Bounds, verdict: &mut Verdict) {
    if scene.effects.contact.is_none() {
        return;
    }
    let mut report = |who: &str, (a, b): (usize, usize), time: f64, depth: f64, more: f64| {
        let allowed = bounds.overlap(a, b, more);
        verdict.overlap = worse(verdict.overlap, depth / allowed);
        if !within(depth, allowed) {
            let (first, second) = (&trace.balls[a], &trace.balls[b]);
            let words = format!(
                "{first} and {second} by {depth:e} at {time:e} s by {who}, allowed {allowed:e}"
            );
            verdict.faults.push(Fault::new("overlap", words));
        }
    };
    let own = &trace.extrema.overlap;
    if let Some((a, b)) = own.ball.zip(own.other) {
        let pair = (a as usize, b as usize);
        report("its own account", pair, own.time, own.value, 0.0);
    }
    if let Some(worst) = worst_overlap(scene, trace, &|a, b| bounds.overlap(a, b, 1.0)) {
        report("parry", worst.balls, worst.time, worst.depth, 1.0);
    }
}
