//! What each impact and each motion between events must be, written apart from the laws that engines apply.
//!
//! Nothing here calls an impulse or a rate of `physics`, nor what the exact engine writes of them: each closed form is derived anew
//! from momentum, Coulomb's cone and a uniform solid sphere, in components along and across the contact. So a law that is wrong in
//! `physics` is wrong here no more, and engines that share it are seen to be wrong together. What is read is a trace: both sides
//! of every jump, and the two ends of every piece of a path. It holds for engines that promise [`Invariant::Laws`].
//!
//! Bounds are those of rounding: so many ulp of the speeds that a number is made of, times what the law makes of them. A clock has
//! its own ulp, which moves what changes with time. A stepped engine takes the cloth in whole steps, and at an impact its clock may
//! be a step from its friction: two steps of the cloth's rates.
//!
//! [`Invariant::Laws`]: crate::physics::invariants::Invariant::Laws

mod cloth;
mod cushion;
mod facing;
mod hit;
mod integral;
mod pockets;

use super::{Fault, Held, Law, Reads, Run, finite};
use crate::math::{Vec3, worse};
use crate::physics::invariants::Invariant;
use crate::physics::{Side, State};
use crate::scene::{Scene, Table};
use crate::trace::{Contacts, Counter, Event, EventKind, Knot, Trace};
use nalgebra::Vector2;
use std::collections::BTreeMap;

/// A number is good to so many ulp of what it is made of: an engine and these closed forms each take some twenty operations, and the exact
/// engine calls a speed none that is 8 ulp of what cancelled.
const ULPS: f64 = 64.0;

/// So many impacts of [`ULPS`] each are left open where a convention made several at one instant: it works them out as a chain whose
/// length a trace does not tell. An allowance and no derived bound for equal masses: of forty thousand scenes (seed 1) the worst
/// took three quarters of it. A light ball between two heavy ones adds its own: see [`Audit::chain`].
const LINKS: f64 = 128.0;

/// Speeds below this are none: their squares are no numbers. length/s.
const NONE: f64 = 1e-150;

/// Why an impact at an instant with several is looked at for its direction only: its size is that of a convention.
const TOGETHER: &str = "several impacts at one instant of a convention";

/// Why a motion is left out, or the end of a phase in one.
const IN_CONTACT: &str = "a motion in contact";

/// What was held against the laws, and what of it is wrong.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Laws {
    /// Impacts that were held whole.
    pub impacts: u64,
    /// The worst of them, in what is allowed.
    pub impact: f64,
    /// Impacts on a cushion without a closed form that were integrated again.
    pub integrated: u64,
    /// The worst of them, in what is allowed.
    pub integral: f64,
    /// Pieces of paths between events.
    pub pieces: u64,
    /// The worst of them, in what is allowed.
    pub piece: f64,
    /// What could not be held whole, by the reason.
    pub left_out: BTreeMap<&'static str, u64>,
    /// What is wrong: the first of each kind.
    pub faults: Vec<Fault>,
}

/// What a figure belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Impact,
    Integral,
    Piece,
}

/// Both sides of what an event did to one ball.
#[derive(Clone, Copy, Debug)]
struct Jump {
    time: f64,
    near: State,
    far: State,
}

/// A trace beside its scene.
struct Audit<'a> {
    scene: &'a Scene,
    trace: &'a Trace,
    /// Relative error of a number.
    grain: f64,
    /// What a place is good to, length.
    place: f64,
    /// Length of a step, s; 0 for an engine that solves for its events.
    step: f64,
    /// Whether the trace holds numbers of more digits than it can tell.
    rounded: bool,
    /// How far a ball is moved where a gap that is rounding is closed, length.
    closed: f64,
    /// When balls are in contact.
    contacts: Contacts,
    found: Laws,
}

/// The invariant. Its figure counts kinds of faults: each impact and each motion has a bound of its own.
pub const LAW: Law = Law {
    invariant: Invariant::Laws,
    unit: "",
    what: "every impact, and every motion between events, is what closed forms make of it that share nothing with the engines' laws",
    reads: Reads::Run(|run| Some(Held::none_of(check(run.scene, run.trace).faults.len()))),
};

/// Holds a trace of `scene` against closed forms of its laws.
pub fn check(scene: &Scene, trace: &Trace) -> Laws {
    if finite::strange(trace).next().is_some() {
        return Laws::default();
    }
    // how near is near enough for an impact is decided before a run, by its longest way
    let run = Run::of(scene, trace);
    let place = run.rounding(scene.duration);
    let contacts = Contacts::of(trace);
    let handed_over = trace.counters.contains_key(Counter::Handovers.id());
    let mut audit = Audit {
        scene,
        trace,
        grain: ULPS * f64::EPSILON,
        place,
        step: trace.provenance.resolution,
        rounded: handed_over || trace.provenance.ulp != f64::EPSILON,
        closed: run.closed(),
        contacts,
        found: Laws::default(),
    };
    audit.events();
    audit.pieces();
    audit.found
}

impl Audit<'_> {
    /// Notes how far off a figure is; says so if that is more than is allowed. What is no number is farther off than any.
    fn off(&mut self, part: Part, off: f64, allowed: f64) -> Option<String> {
        let worst = match part {
            Part::Impact => &mut self.found.impact,
            Part::Integral => &mut self.found.integral,
            Part::Piece => &mut self.found.piece,
        };
        if off > 0.0 || off.is_nan() {
            *worst = worse(*worst, off / allowed);
        }
        let within = off <= allowed;
        (!within).then(|| format!("off by {off:e}, allowed {allowed:e}"))
    }

    /// The largest speed of a ball at a time, s, length/s: of what several impacts at one instant exchange, which may be more than it has before or after.
    fn loudest_at(&self, ball: usize, time: f64) -> f64 {
        let knots = &self.trace.paths[ball].knots;
        let from = knots.partition_point(|knot| knot.time < time);
        let then = knots[from..].iter().take_while(|knot| knot.time == time);
        then.fold(0.0, |most, knot| worse(most, knot.state.velocity.norm()))
    }

    /// What the speeds after several impacts at one instant of a convention are good to.
    fn chain(&self) -> f64 {
        // so often does a light ball between two heavy ones hit them before they part (Galperin)
        let between = std::f64::consts::PI * self.scene.mass_ratio().sqrt();
        (LINKS + between) * ULPS * f64::EPSILON * self.scene.fastest()
    }

    fn fault(&mut self, what: &'static str, words: String) {
        if self.found.faults.iter().all(|known| known.what != what) {
            self.found.faults.push(Fault::new(what, words));
        }
    }

    fn leave_out(&mut self, why: &'static str) {
        *self.found.left_out.entry(why).or_default() += 1;
    }

    fn name(&self, ball: usize) -> &str {
        self.trace.balls.get(ball).map_or("", String::as_str)
    }

    /// Each event with what it did to its balls.
    fn events(&mut self) {
        let mut jumps: BTreeMap<(usize, u32), Vec<Jump>> = BTreeMap::new();
        for (ball, path) in self.trace.paths.iter().enumerate() {
            for pair in path.knots.windows(2) {
                if let Some(event) = pair[1].after {
                    jumps.entry((ball, event)).or_default().push(Jump {
                        time: pair[1].time,
                        near: pair[0].state,
                        far: pair[1].state,
                    });
                    if pair[0].time != pair[1].time {
                        let words = format!(
                            "ball {} changes at {:e} s, and its near side is that of {:e} s",
                            self.name(ball),
                            pair[1].time,
                            pair[0].time
                        );
                        self.fault("told", words);
                    }
                }
            }
        }
        let none: &[Jump] = &[];
        for (index, event) in self.trace.events.iter().enumerate() {
            let of = |ball: u32| {
                jumps
                    .get(&(ball as usize, index as u32))
                    .map_or(none, Vec::as_slice)
            };
            let together = self.together(index);
            match event.kind {
                EventKind::BallBall(a, b) => {
                    self.meetings(event, [a as usize, b as usize], [of(a), of(b)], together);
                }
                EventKind::BallCushion(a, side) => {
                    self.told(event, of(a).len() == 1);
                    for jump in of(a) {
                        self.cushion(event, a as usize, side, jump, together);
                    }
                    self.corner(index);
                }
                EventKind::Stop(a) | EventKind::SlideToRoll(a) | EventKind::SpinEnd(a) => {
                    self.told(event, of(a).len() == 1);
                    for jump in of(a) {
                        if self.contacts.during(a as usize, [event.time; 2]) {
                            self.leave_out(IN_CONTACT);
                        } else {
                            self.phase(event.kind, a as usize, jump);
                        }
                    }
                }
                EventKind::Pocket(a, pocket) => {
                    self.told(event, of(a).len() == 1);
                    for jump in of(a) {
                        self.falls(a as usize, pocket, jump);
                    }
                }
                EventKind::ContactBegin(..) | EventKind::ContactEnd(..) => {
                    let (a, b) = event.kind.balls();
                    let alone = |ball: usize| of(ball as u32).len() == 1;
                    self.told(event, alone(a) && b.is_none_or(alone));
                }
            }
        }
    }

    fn told(&mut self, event: &Event, told: bool) {
        if !told {
            let (a, b) = event.kind.parties(|ball| self.name(ball));
            let words = format!(
                "{} of {a} {b} at {:e} s is not what their paths show",
                event.kind.id(),
                event.time
            );
            self.fault("told", words);
        }
    }

    /// The exchanges of two balls in one contact: the first with the first, and so on.
    fn meetings(
        &mut self,
        event: &Event,
        balls: [usize; 2],
        [one, two]: [&[Jump]; 2],
        together: bool,
    ) {
        let alike = one.len() == two.len() && !one.is_empty();
        self.told(
            event,
            alike && one.iter().zip(two).all(|(a, b)| a.time == b.time),
        );
        for (a, b) in one.iter().zip(two) {
            self.hit(balls, [a, b], together);
        }
    }

    /// True where several impacts at the time of this event are resolved together, by a convention or because their balls are in contact: each has a part of
    /// the impulse of all.
    fn together(&self, index: usize) -> bool {
        use crate::scene::Simultaneous;
        if self.step > 0.0 {
            return false;
        }
        let event = &self.trace.events[index];
        let (a, b) = event.kind.balls();
        let held = |ball: usize| self.contacts.during(ball, [event.time; 2]);
        if held(a) || b.is_some_and(held) {
            return true;
        }
        // what has begun to touch is resolved together wherever it meets again
        let named = self.scene.simultaneous == Simultaneous::GeneralizedReflections;
        if !named && self.contacts.is_empty() {
            return false;
        }
        let events = &self.trace.events;
        let time = events[index].time;
        let mut before = events[..index].iter().rev().take_while(|e| e.time == time);
        let mut after = events[index + 1..].iter().take_while(|e| e.time == time);
        before.any(|e| e.kind.is_collision())
            || after.any(|e| e.kind.is_collision())
            || self.is_crowded(&events[index])
    }

    /// True where a ball of this event touches something else, as the engine that solves for its events calls it: then the convention has
    /// resolved that contact too, with an impulse that need not leave an event.
    fn is_crowded(&self, event: &Event) -> bool {
        // what both places are good to over the whole run
        let reach = 2.0 * self.scene.position_uncertainty();
        let place = |ball: usize| {
            let state = self.trace.paths[ball].state_at(event.time)?;
            Some(plan(&state.position))
        };
        let (a, b) = event.kind.balls();
        let own = [Some(a), b];
        let side = match event.kind {
            EventKind::BallCushion(_, side) => Some(side),
            _ => None,
        };
        own.into_iter().flatten().any(|ball| {
            let Some(at) = place(ball) else {
                return false;
            };
            let radius = self.scene.balls[ball].radius;
            let others = (0..self.scene.balls.len()).filter(|other| !own.contains(&Some(*other)));
            let near_ball = |other: usize| {
                let touch = 2.0 * radius.sqrt() * self.scene.balls[other].radius.sqrt();
                place(other).is_some_and(|there| (there - at).norm() - touch <= reach)
            };
            let near_cushion = |other: Side, table: &Table| {
                let edge = table.reach(other, radius);
                Some(other) != side && f64::from(other.sign()) * (edge - at[other.axis()]) <= reach
            };
            let table = self
                .scene
                .table
                .filter(|_| self.scene.effects.cushion.is_some());
            others.into_iter().any(near_ball)
                || table.is_some_and(|table| Side::ALL.into_iter().any(|s| near_cushion(s, &table)))
        })
    }

    /// In a corner x comes before y, where a ball is at both cushions and moves into both.
    fn corner(&mut self, index: usize) {
        let event = self.trace.events[index];
        let EventKind::BallCushion(ball, second) = event.kind else {
            return;
        };
        let own = self.trace.events[..index]
            .iter()
            .enumerate()
            .rev()
            .take_while(|(_, e)| e.time == event.time)
            .find(|(_, e)| {
                e.kind.balls().0 == ball as usize || e.kind.balls().1 == Some(ball as usize)
            });
        let Some((earlier, _)) = own else {
            return;
        };
        let EventKind::BallCushion(_, first) = self.trace.events[earlier].kind else {
            return;
        };
        if (first.axis(), second.axis()) != (1, 0) {
            return;
        }
        let knots = &self.trace.paths[ball as usize].knots;
        let at = knots
            .iter()
            .position(|knot| knot.after == Some(earlier as u32));
        let Some(near) = at.and_then(|at| knots.get(at.checked_sub(1)?)) else {
            return;
        };
        let into = |axis: usize, sign: i8| f64::from(sign) * near.state.velocity[axis];
        let along = into(0, second.sign());
        if along > self.grain * near.state.velocity.norm() && self.step > 0.0 {
            let words = format!(
                "ball {} meets {} before {} at {:e} s, and moves into both",
                self.name(ball as usize),
                first.id(),
                second.id(),
                event.time
            );
            self.fault("corner-order", words);
        }
    }

    /// Each piece of a path between two events.
    fn pieces(&mut self) {
        for (ball, path) in self.trace.paths.iter().enumerate() {
            for pair in path.knots.windows(2) {
                if pair[1].after.is_none() {
                    self.piece(ball, &pair[0], &pair[1]);
                }
            }
        }
    }

    fn piece(&mut self, ball: usize, start: &Knot, end: &Knot) {
        if self.contacts.during(ball, [start.time, end.time]) {
            self.leave_out(IN_CONTACT);
        } else {
            self.found.pieces += 1;
            self.cloth(ball, start, end);
        }
        self.passes(ball, start, end);
    }
}

/// The part of a vector in the plane of the table.
fn plan(v: &Vec3) -> Vector2<f64> {
    Vector2::new(v.x, v.y)
}

/// A quarter turn to the left.
fn left(v: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-v.y, v.x)
}
