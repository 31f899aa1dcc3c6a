//! The event loop: take the earliest event, advance its balls to it, apply its law, predict again.
//!
//! Only the balls of an event are touched. Every other ball stays where its own last event left it, so nothing is
//! accumulated. The loop never decides what the scalar cannot tell: it ends with the reason instead.

use super::flight::{Flight, Phase, state};
use super::predict::{Near, Notes, View};
use super::queue::{Candidate, Queue, What};
use super::simultaneous::Cluster;
use super::world::World;
use crate::engine::Limits;
use crate::math::Real;
use crate::physics::invariants::{kinetic_energy, momentum};
use crate::physics::{Body, Contact, Cushion, Motion, Side, State, contact, cushion};
use crate::scene::Scene;
use crate::trace::{Ending, EventKind, Provenance, Record, Recorder, Spot, Trace};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Impacts of one ball at one instant beyond which it counts as collapsed. Elastic balls can need many (a light ball between two
/// heavy ones), but no finite cluster of a real scene comes near it.
const MOST_IMPACTS_AT_ONCE: u32 = 10_000;

/// A velocity that an impact cancels down to this many ulps of what was cancelled is zero.
const CANCELLED: f64 = 8.0;

/// A run in the scalar `T`.
#[derive(Debug)]
pub struct Solver<'a, T: Real> {
    scene: &'a Scene,
    world: World<T>,
    flights: Vec<Flight<T>>,
}

impl<'a, T: Real> Solver<'a, T> {
    /// A scene at time 0.
    pub fn new(scene: &'a Scene) -> Self {
        let world = World::new(scene);
        let flights = world.first_flights(scene);
        Solver {
            scene,
            world,
            flights,
        }
    }

    /// States at time 0, read back from the flights.
    pub fn states(&self) -> Vec<State> {
        let read =
            |(i, flight): (usize, &Flight<T>)| self.state(i, flight.position, flight.velocity);
        self.flights.iter().enumerate().map(read).collect()
    }

    /// The unchanging part.
    pub fn world(&self) -> &World<T> {
        &self.world
    }

    fn state(&self, ball: usize, position: [T; 2], velocity: [T; 2]) -> State {
        let given = &self.scene.balls[ball].state;
        state(position, velocity, given.position.z, given.spin)
    }

    /// Runs to an ending.
    pub fn run(self, provenance: Provenance, record: Record, limits: &Limits<'_>) -> Trace {
        let recorder = Recorder::new(self.scene, provenance, record, &self.states());
        let n = self.flights.len();
        let mut run = Loop {
            versions: vec![0; n],
            queue: Queue::new(n),
            notes: Notes {
                root_calls: 0,
                watch: None,
                known: usize::MAX,
                near: Vec::new(),
            },
            now: T::zero(),
            moving: self.flights.iter().filter(|f| f.moves()).count(),
            streaks: vec![(T::zero(), 0); n],
            recorder,
            counts: Counts::default(),
            solver: self,
        };
        let ending = run.to_the_end(limits);
        run.finish(ending)
    }
}

#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    events: u64,
    ball_ball: u64,
    ball_cushion: u64,
}

struct Loop<'a, T: Real> {
    solver: Solver<'a, T>,
    versions: Vec<u32>,
    queue: Queue<T>,
    notes: Notes<T>,
    now: T,
    moving: usize,
    /// For each ball: since when, and how often, it was hit without time passing.
    streaks: Vec<(T, u32)>,
    recorder: Recorder,
    counts: Counts,
}

/// A ball on both sides of an impact.
#[derive(Clone, Copy)]
struct Side2<T> {
    ball: usize,
    flight: Flight<T>,
    position: [T; 2],
    before: [T; 2],
    after: [T; 2],
}

impl<T: Real> Loop<'_, T> {
    fn to_the_end(&mut self, limits: &Limits<'_>) -> Ending {
        if let Some(ending) = self.unfit() {
            return ending;
        }
        for ball in 0..self.versions.len() {
            // each pair once: the row of the larger index holds it
            self.predict(ball, 0..ball, usize::MAX);
        }
        loop {
            let (ball, next) = self.queue.first();
            if next.what == What::Nothing {
                return self.nothing_left();
            }
            if self.is_stale(ball, &next) {
                self.now_is(next.time);
                self.predict(ball, 0..self.versions.len(), usize::MAX);
                continue;
            }
            if limits.is_cancelled() {
                return Ending::Cancelled;
            }
            if self.counts.events >= limits.max_events {
                return Ending::Budget;
            }
            self.now_is(next.time);
            let ended = match next.what {
                What::Pair(a, b) => self.pair(a as usize, b as usize),
                What::Cushion(a, side) => self.cushion(a as usize, side),
                What::End(a) => self.phase_end(a as usize),
                What::UnclearPair(a, b) => Some(Ending::Undecidable(self.spot(
                    &[a as usize, b as usize],
                    "they pass so closely, or so slowly, that rounding decides whether they touch",
                ))),
                What::UnclearCushion(a, side) => Some(Ending::Undecidable(self.spot(
                    &[a as usize],
                    &format!(
                        "it stops so close to {} that rounding decides whether it touches",
                        side.id()
                    ),
                ))),
                What::Nothing => None,
            };
            if let Some(ending) = ended {
                return ending;
            }
        }
    }

    /// The end of a run in which nothing happens any more.
    fn nothing_left(&mut self) -> Ending {
        if self.moving == 0 && !self.solver.scene.run_to_duration {
            return Ending::Rest;
        }
        self.now = self.solver.world.duration;
        Ending::Duration
    }

    fn now_is(&mut self, time: T) {
        self.now = self.now.at_least(time);
    }

    fn is_stale(&self, ball: usize, candidate: &Candidate<T>) -> bool {
        match candidate.what {
            What::Pair(a, b) | What::UnclearPair(a, b) => {
                let other = if a as usize == ball { b } else { a };
                self.versions[other as usize] != candidate.stamp
            }
            What::Cushion(..) | What::UnclearCushion(..) | What::End(_) | What::Nothing => false,
        }
    }

    fn predict(&mut self, ball: usize, partners: std::ops::Range<usize>, skip: usize) {
        let view = View {
            world: &self.solver.world,
            flights: &self.solver.flights,
            versions: &self.versions,
        };
        let next = view.next_event(ball, self.now, partners, skip, &mut self.notes);
        self.queue.set(ball, next);
    }

    fn body(&self, side: &Side2<T>) -> Body<T> {
        let zero = T::zero();
        let lift = |v: &Vector3<f64>| Vector3::new(T::lift(v.x), T::lift(v.y), T::lift(v.z));
        Body {
            velocity: Vector3::new(side.before[0], side.before[1], zero),
            spin: lift(&self.solver.scene.balls[side.ball].state.spin),
            mass: self.solver.world.mass[side.ball],
            radius: self.solver.world.radius[side.ball],
        }
    }

    /// A ball as it is when an event reaches it.
    fn arrival(&self, ball: usize) -> Side2<T> {
        let flight = self.solver.flights[ball];
        let (position, before) = flight.at(self.now);
        Side2 {
            ball,
            flight,
            position,
            before,
            after: before,
        }
    }

    #[inline(never)]
    fn pair(&mut self, a: usize, b: usize) -> Option<Ending> {
        let law = self.solver.world.contact?;
        let (mut one, mut other) = (self.arrival(a), self.arrival(b));
        let x = other.position[0] - one.position[0];
        let y = other.position[1] - one.position[1];
        let apart = (x * x + y * y).sqrt();
        let n = Vector3::new(x / apart, y / apart, T::zero());
        let closing =
            (one.before[0] - other.before[0]) * n.x + (one.before[1] - other.before[1]) * n.y;
        if closing <= self.solver.world.blur.speed {
            return Some(Ending::Collapsed(self.spot(
                &[a, b],
                "they are pressed together without closing in: impacts follow each other without end",
            )));
        }
        collide(
            law,
            &self.body(&one),
            &self.body(&other),
            &n,
            &mut one,
            &mut other,
        );
        if !finite(&one) || !finite(&other) {
            return Some(Ending::NotFinite(
                self.spot(&[a, b], "the impact left no finite velocity"),
            ));
        }
        if let Some(ending) = self.streak(&[a, b]) {
            return Some(ending);
        }
        let window = self.solver.world.time_error(self.now, closing) * T::lift(2.0);
        if let Some(ending) = self.commit(&[one, other], window) {
            return self.indeterminate(ending, |run| run.record_pair(&one, &other, apart));
        }
        self.record_pair(&one, &other, apart);
        None
    }

    #[inline(never)]
    fn cushion(&mut self, a: usize, side: Side) -> Option<Ending> {
        let law = self.solver.world.cushion?;
        let mut one = self.arrival(a);
        bounce(law, &self.body(&one), side, &mut one);
        if !finite(&one) {
            return Some(Ending::NotFinite(
                self.spot(&[a], "the cushion left no finite velocity"),
            ));
        }
        if let Some(ending) = self.streak(&[a]) {
            return Some(ending);
        }
        let closing = one.before[side.axis()].abs();
        let window = self.solver.world.time_error(self.now, closing) * T::lift(2.0);
        if let Some(ending) = self.commit(&[one], window) {
            return self.indeterminate(ending, |run| run.record_cushion(&one, side));
        }
        self.record_cushion(&one, side);
        None
    }

    /// Puts the balls of an impact on their new flights and predicts their next events. Answers when the order of
    /// impacts at this instant would decide the result.
    fn commit(&mut self, sides: &[Side2<T>], window: T) -> Option<Doubt> {
        let watch = self.solver.world.touching + self.solver.world.fastest * window;
        self.notes.watch = Some(watch);
        self.notes.near.clear();
        for side in sides {
            let flight = Flight::new(
                self.solver.world.ground,
                self.now,
                side.position,
                side.after,
            );
            self.moving += usize::from(flight.moves());
            self.moving -= usize::from(side.flight.moves());
            self.solver.flights[side.ball] = flight;
            self.versions[side.ball] = self.versions[side.ball].wrapping_add(1);
        }
        let all = 0..self.versions.len();
        for (i, side) in sides.iter().enumerate() {
            let partner = sides.get(1 - i).map_or(usize::MAX, |s| s.ball);
            self.notes.known = partner;
            // the pair itself belongs to the row of the first
            let skip = if i == 0 { usize::MAX } else { partner };
            self.predict(side.ball, all.clone(), skip);
        }
        self.notes.watch = None;
        self.notes.known = usize::MAX;
        if self.notes.near.is_empty() {
            return None;
        }
        self.doubt(sides, window)
    }

    /// Something else is within reach of an impact: does the order matter?
    #[cold]
    fn doubt(&mut self, sides: &[Side2<T>], window: T) -> Option<Doubt> {
        let near = std::mem::take(&mut self.notes.near);
        let live = |velocity: &dyn Fn(usize) -> [T; 2]| {
            let closes = |near: &&Near| self.closes(near, velocity, window);
            near.iter().filter(closes).count()
        };
        let now = |ball: usize| self.solver.flights[ball].at(self.now).1;
        let earlier = |ball: usize| {
            let side = sides.iter().find(|side| side.ball == ball);
            side.map_or_else(|| now(ball), |side| side.before)
        };
        let (before, after) = (live(&earlier), live(&now));
        if before == 0 && after < 2 {
            return None;
        }
        let n = self.versions.len();
        let positions: Vec<_> = (0..n)
            .map(|i| self.solver.flights[i].at(self.now).0)
            .collect();
        let velocities: Vec<_> = if before > 0 {
            (0..n).map(earlier).collect()
        } else {
            (0..n).map(now).collect()
        };
        let seeds: Vec<usize> = sides.iter().map(|side| side.ball).collect();
        let cluster = Cluster::around(&self.solver.world, &seeds, &positions, &velocities, window);
        if !cluster.order_matters() {
            return None;
        }
        let balls = cluster.balls;
        if before > 0 {
            // the impact itself is in doubt: take it back
            for side in sides {
                self.moving += usize::from(side.flight.moves());
                self.moving -= usize::from(self.solver.flights[side.ball].moves());
                self.solver.flights[side.ball] = side.flight;
            }
        }
        Some(Doubt {
            balls,
            happened: before == 0,
        })
    }

    /// True if a neighbour is reached within the window, at the velocities given.
    fn closes(&self, near: &Near, velocity: &dyn Fn(usize) -> [T; 2], window: T) -> bool {
        let world = &self.solver.world;
        let (gap, closing) = match *near {
            Near::Pair(a, b) => {
                let (p, q) = (self.place(a), self.place(b));
                let (v, w) = (velocity(a), velocity(b));
                let (x, y) = (q[0] - p[0], q[1] - p[1]);
                let apart = (x * x + y * y).sqrt();
                let closing = ((v[0] - w[0]) * x + (v[1] - w[1]) * y) / apart;
                (apart - world.distance(a, b), closing)
            }
            Near::Cushion(a, side) => {
                let axis = side.axis();
                let outward = |x: T| if side.sign() < 0 { -x } else { x };
                let reach = world.reach[a][side as usize];
                (
                    outward(reach - self.place(a)[axis]),
                    outward(velocity(a)[axis]),
                )
            }
        };
        closing > world.blur.speed && gap <= world.touching + closing * window
    }

    fn place(&self, ball: usize) -> [T; 2] {
        self.solver.flights[ball].at(self.now).0
    }

    #[cold]
    fn indeterminate(&mut self, doubt: Doubt, record: impl FnOnce(&mut Self)) -> Option<Ending> {
        if doubt.happened {
            record(self);
        }
        Some(Ending::Indeterminate(self.spot(
            &doubt.balls,
            "several impacts at one instant: their order decides the result",
        )))
    }

    #[inline(never)]
    fn phase_end(&mut self, ball: usize) -> Option<Ending> {
        let flight = self.solver.flights[ball];
        let zero = [T::zero(); 2];
        let position = match flight.phase {
            Phase::Slide => flight.rest_position(),
            Phase::Free | Phase::Rest => flight.at(self.now).0,
        };
        self.solver.flights[ball] = Flight::new(self.solver.world.ground, self.now, position, zero);
        self.versions[ball] = self.versions[ball].wrapping_add(1);
        self.moving -= 1;
        self.counts.events += 1;
        let at_rest = self.solver.state(ball, position, zero);
        let time = self.now.to_f64();
        self.recorder.stop(ball, time, &at_rest, &at_rest);
        self.notes.watch = Some(self.solver.world.blur.length);
        self.notes.near.clear();
        self.predict(ball, 0..self.versions.len(), usize::MAX);
        self.notes.watch = None;
        if self.notes.near.is_empty() {
            return None;
        }
        self.stop_in_doubt(ball, &flight)
    }

    /// A ball stopped within the blur of another: did it reach it?
    #[cold]
    fn stop_in_doubt(&mut self, ball: usize, flight: &Flight<T>) -> Option<Ending> {
        let from = self.place(ball);
        let near = std::mem::take(&mut self.notes.near);
        for neighbour in near {
            let Near::Pair(_, other) = neighbour else {
                continue;
            };
            let to = self.place(other);
            let (x, y) = (to[0] - from[0], to[1] - from[1]);
            let approached = flight.velocity[0] * x + flight.velocity[1] * y;
            let (sx, sy) = (to[0] - flight.position[0], to[1] - flight.position[1]);
            let apart = (sx * sx + sy * sy).sqrt() - self.solver.world.distance(ball, other);
            let blur = self.solver.world.blur.length;
            if approached > T::zero() && apart > blur + blur {
                return Some(Ending::Undecidable(self.spot(
                    &[ball.min(other), ball.max(other)],
                    "one stops so close to the other that rounding decides whether it touches",
                )));
            }
        }
        None
    }

    fn streak(&mut self, balls: &[usize]) -> Option<Ending> {
        let resolution = self.now * T::lift(16.0 * T::ULP);
        for ball in balls {
            let (since, count) = &mut self.streaks[*ball];
            if self.now - *since > resolution {
                *since = self.now;
                *count = 0;
            }
            *count += 1;
            if *count > MOST_IMPACTS_AT_ONCE {
                return Some(Ending::Collapsed(self.spot(
                    balls,
                    &format!("more than {MOST_IMPACTS_AT_ONCE} impacts without time passing"),
                )));
            }
        }
        None
    }

    /// Numbers whose products leave the range of the scalar cannot be run.
    fn unfit(&self) -> Option<Ending> {
        let solver = &self.solver;
        let fit = |flight: &Flight<T>| {
            let [x, y] = flight.position;
            let [vx, vy] = flight.velocity;
            let [ax, ay] = flight.acceleration;
            let (p, v, a) = (x * x + y * y, vx * vx + vy * vy, ax * ax + ay * ay);
            (p * v).is_finite() && (p * a).is_finite() && (v * v).is_finite() && (a * a).is_finite()
        };
        let unfit: Vec<usize> = (0..solver.flights.len())
            .filter(|ball| !fit(&solver.flights[*ball]))
            .collect();
        let range = solver.world.fastest.is_finite() && solver.world.blur.length.is_finite();
        if unfit.is_empty() && range && solver.world.duration.is_finite() {
            return None;
        }
        Some(Ending::NotFinite(self.spot(
            &unfit,
            "its position or velocity is not a number, or too large to compute with",
        )))
    }

    fn spot(&self, balls: &[usize], why: &str) -> Spot {
        Spot {
            time: self.now.to_f64(),
            balls: balls.iter().map(|b| *b as u32).collect(),
            why: why.to_owned(),
        }
    }

    fn both(&self, side: &Side2<T>) -> (State, State) {
        (
            self.solver.state(side.ball, side.position, side.before),
            self.solver.state(side.ball, side.position, side.after),
        )
    }

    fn record_pair(&mut self, one: &Side2<T>, other: &Side2<T>, apart: T) {
        let (a, b) = (one.ball, other.ball);
        let time = self.now.to_f64();
        let ((a0, a1), (b0, b1)) = (self.both(one), self.both(other));
        self.counts.events += 1;
        self.counts.ball_ball += 1;
        let event = self
            .recorder
            .event(time, EventKind::ball_ball(a, b), Some(1));
        self.recorder.jump(a, time, &a0, &a1, event);
        self.recorder.jump(b, time, &b0, &b1, event);
        let (ma, mb) = (
            self.solver.scene.balls[a].mass,
            self.solver.scene.balls[b].mass,
        );
        let energy = |state: &State, mass: f64| kinetic_energy(state, mass, None);
        let gained = (energy(&a1, ma) - energy(&a0, ma)) + (energy(&b1, mb) - energy(&b0, mb));
        self.recorder.energy_change(time, gained, a, Some(b));
        let change =
            (momentum(&a1, ma) - momentum(&a0, ma)) + (momentum(&b1, mb) - momentum(&b0, mb));
        self.recorder.momentum_error(time, change.norm(), a, b);
        let overlap = self.solver.world.distance(a, b) - apart;
        self.recorder.overlap(time, overlap.to_f64(), a, b);
        self.record_stop(one, time);
        self.record_stop(other, time);
    }

    fn record_cushion(&mut self, one: &Side2<T>, side: Side) {
        let a = one.ball;
        let time = self.now.to_f64();
        let (before, after) = self.both(one);
        self.counts.events += 1;
        self.counts.ball_cushion += 1;
        let kind = EventKind::BallCushion(a as u32, side);
        let event = self.recorder.event(time, kind, Some(1));
        self.recorder.jump(a, time, &before, &after, event);
        let mass = self.solver.scene.balls[a].mass;
        let gained = kinetic_energy(&after, mass, None) - kinetic_energy(&before, mass, None);
        self.recorder.energy_change(time, gained, a, None);
        let beyond = one.position[side.axis()] - self.solver.world.reach[a][side as usize];
        let beyond = if side.sign() < 0 { -beyond } else { beyond };
        self.recorder.outside(time, beyond.to_f64(), a);
        self.record_stop(one, time);
    }

    /// A moving ball that an impact brought to rest.
    fn record_stop(&mut self, side: &Side2<T>, time: f64) {
        let zero = [T::zero(); 2];
        if side.flight.moves() && side.before != zero && side.after == zero {
            let at_rest = self.solver.state(side.ball, side.position, zero);
            self.counts.events += 1;
            self.recorder.stop(side.ball, time, &at_rest, &at_rest);
        }
    }

    fn finish(self, ending: Ending) -> Trace {
        let read = |ball: usize| {
            let (position, velocity) = self.solver.flights[ball].at(self.now);
            self.solver.state(ball, position, velocity)
        };
        let states: Vec<State> = (0..self.versions.len()).map(read).collect();
        let counters = BTreeMap::from([
            ("events".to_owned(), self.counts.events),
            ("ball_ball".to_owned(), self.counts.ball_ball),
            ("ball_cushion".to_owned(), self.counts.ball_cushion),
            ("root_calls".to_owned(), self.notes.root_calls),
        ]);
        self.recorder
            .finish(self.now.to_f64(), &states, ending, counters)
    }
}

/// Impacts at one instant whose order decides the result.
struct Doubt {
    balls: Vec<usize>,
    /// Whether the impact under which it showed is itself beyond doubt.
    happened: bool,
}

/// Applies the law of an impact of two balls.
#[inline(never)]
fn collide<T: Real>(
    law: Contact,
    a: &Body<T>,
    b: &Body<T>,
    n: &Vector3<T>,
    one: &mut Side2<T>,
    other: &mut Side2<T>,
) {
    let (motion, reaction) = contact::impact(law, a, b, n);
    one.after = settled(one.before, &motion);
    other.after = settled(other.before, &reaction);
}

/// Applies the law of a cushion.
#[inline(never)]
fn bounce<T: Real>(law: Cushion, a: &Body<T>, side: Side, one: &mut Side2<T>) {
    one.after = settled(one.before, &cushion::impact(law, a, side));
}

/// The velocity after an impact; zero where nothing but the rounding of a cancellation is left.
///
/// Without this a head-on hit off the axes would leave the cue ball creeping at 1e-17 in a direction that is noise.
fn settled<T: Real>(before: [T; 2], motion: &Motion<T>) -> [T; 2] {
    let after = [motion.velocity.x, motion.velocity.y];
    let square = |v: [T; 2]| v[0] * v[0] + v[1] * v[1];
    let cancelled = square(before) + square([after[0] - before[0], after[1] - before[1]]);
    let rounding = T::lift(CANCELLED * T::ULP);
    if square(after) <= rounding * rounding * cancelled {
        [T::zero(); 2]
    } else {
        after
    }
}

fn finite<T: Real>(side: &Side2<T>) -> bool {
    (side.after[0] + side.after[1] + side.position[0] + side.position[1]).is_finite()
}
