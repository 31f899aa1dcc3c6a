//! A run with derivatives: the solver once more, in dual numbers, where balls stay in contact.
//!
//! Order and equality of dual numbers are those of their values, so the run takes every branch of the one that it is held against, bit by bit, through
//! accumulations and contact phases; its derivatives go along. They are right where a small change of the inputs leaves the order of events as
//! it is: the time of every event moves by one step of Newton, gaps and approaches of contacts that hold have no derivatives any more, and a phase
//! is the series of its equations.
//!
//! Where there is no derivative the numbers of the balls concerned have none (NaN) from then on, and so has every ball that meets them; the
//! others go on. That is so where contacts that a change would open are resolved at one instant, and where two changes in a group of
//! balls come at one time and would not for another start.
//!
//! For an estimate of errors every event adds those of its own: rounding, what a law may be off by, and what is left of an approach when contact begins,
//! which is taken out as a whole and counted as a whole.

use super::AtContacts;
use super::cluster_impact::{ClusterImpact, Met};
use super::contact::group::{Member, Touch};
use super::contact::touching::{keep_slopes, rate};
use super::encounter::Encounter;
use super::flight::Flight;
use super::kinematics::{Course, Kinematics};
use super::queue::What;
use super::solve::{Loop, Played, Solver};
use super::spin::Moving;
use super::sustained::stretch;
use super::world::World;
use crate::engine::Limits;
use crate::math::random::Draws;
use crate::math::{DoubleDouble, Dual, Octuple, Real};
use crate::physics::Effects;
use crate::scene::Scene;
use crate::trace::{EventKind, Provenance, Record, Trace};

/// Derivatives that one run carries.
pub const LANES: usize = 16;

/// Coordinates of a ball: centre, velocity, spin.
pub const PARTS: usize = 7;

/// A gap whose derivative is less than this part of those of its parties is that of a contact that holds: its rounding, and that of what came before.
const HOLDS: f64 = 1e-6;

/// Whether a run, in numbers of this spacing, had balls that stay in contact and can be followed through that: not in fewer digits than f64.
pub fn holds_balls(trace: &Trace, ulp: f64) -> bool {
    let lasts = |kind| {
        matches!(
            kind,
            EventKind::ContactBegin(..) | EventKind::ContactEnd(..)
        )
    };
    ulp <= f64::EPSILON && trace.events.iter().any(|event| lasts(event.kind))
}

/// What has which derivative at the start.
#[derive(Clone, Debug, Default)]
pub struct Seeds {
    /// Coordinates of balls: ball, part, lane, slope.
    pub start: Vec<(usize, usize, usize, f64)>,
    /// Numbers of effects: key, lane, slope.
    pub effects: Vec<(&'static str, usize, f64)>,
    /// Lanes of the restitution of elastic balls, and of elastic cushions.
    pub restitution: [Option<usize>; 2],
    /// Whether derivatives are those of errors, for which any of several will do.
    pub estimates: bool,
}

impl Seeds {
    fn effects<T: Real>(&self, scene: &Scene) -> Effects<T> {
        scene.effects.map(|key, value| {
            let own = self.effects.iter().filter(|(of, ..)| *of == key);
            own.fold(T::lift(value), |x, (_, lane, slope)| {
                x.nudged(*lane, *slope)
            })
        })
    }

    /// The world of a scene with these derivatives.
    pub fn of_world<T: Real>(&self, scene: &Scene, world: World<T>) -> World<T> {
        let lane = |lane: Option<usize>| lane.map_or(T::zero(), |lane| T::zero().nudged(lane, 1.0));
        let restitution = self.restitution.map(lane);
        let mut world = world.with_laws(&self.effects(scene), scene.gravity, restitution);
        world.estimates = self.estimates;
        world
    }

    /// A scene at time 0 with these derivatives.
    fn kinematics<'a, T: Real>(&self, scene: &'a Scene) -> Kinematics<'a, T> {
        let world = self.of_world(scene, World::<T>::new(scene));
        let (mut flights, mut spins) = (Vec::new(), Vec::new());
        for (ball, known) in scene.balls.iter().enumerate() {
            let radius = world.radius[ball];
            let mut moving = Moving::lifted(&known.state);
            if let Some(rotation) = &world.rotation {
                moving = rotation.as_meant(radius, moving);
            }
            for (_, part, lane, slope) in self.start.iter().filter(|seed| seed.0 == ball) {
                let part = moving.part(*part);
                *part = part.nudged(*lane, *slope);
            }
            let course = departing(&world, ball, T::zero(), moving);
            flights.push(course.flight);
            spins.extend(course.spin);
        }
        Kinematics::begin(scene, world, flights, spins)
    }
}

/// How a ball sets off at a time of its own.
fn departing<T: Real>(world: &World<T>, ball: usize, start: T, moving: Moving<T>) -> Course<T> {
    match &world.rotation {
        None => Course {
            flight: Flight::new(world.ground, start, moving.position, moving.velocity),
            spin: None,
        },
        Some(rotation) => {
            let moving = rotation.unspun(moving);
            let (flight, spin) = rotation.depart(world.radius[ball], start, moving);
            Course {
                flight,
                spin: Some(spin),
            }
        }
    }
}

/// What a run with derivatives is for.
#[derive(Clone, Debug)]
pub enum Task {
    /// How everything moves just after the events of a range: rows of a ball by its parts, `LANES` columns.
    Maps {
        /// The range.
        range: std::ops::Range<usize>,
        /// What was found, event by event.
        found: Vec<Vec<f64>>,
    },
    /// Where balls are at a time, s.
    Places(f64),
    /// Errors of the times of events.
    Errors(Box<Errors>),
}

/// Errors that every event adds, and what came of them.
#[derive(Clone, Debug)]
pub struct Errors {
    /// Their signs.
    pub draws: Draws,
    /// Roundings of a velocity in one impact, and of the clock in one event.
    pub roundings: [f64; 2],
    /// Root mean squares of an error.
    pub deviations: f64,
    /// What was found, s; `None` of an event whose time has no derivative.
    pub found: Vec<Option<f64>>,
    /// What laws of the event at hand may be off by, length/s.
    pub of_law: f64,
    /// What was left of the approach of balls, and is taken out now, length/s.
    pub taken: Vec<(usize, f64)>,
}

/// A ball whose place no longer has a derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lost {
    /// Index in scene order.
    pub ball: usize,
    /// The event from which on.
    pub event: usize,
    /// Why.
    pub why: Why,
}

/// Why a ball has no derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Why {
    /// The event has none: a convention resolved contacts at one instant that a small change would set apart, or two changes of balls in contact come
    /// at one time.
    Together,
    /// It met a ball that had none.
    Met,
}

/// What goes along with a run in dual numbers.
#[derive(Clone, Debug)]
pub struct Derived {
    seeds: Seeds,
    task: Task,
    /// Rows of the trace so far.
    seen: usize,
    /// Counts of changes of the balls when they were last looked at.
    versions: Vec<u32>,
    /// Derivatives of the places at which balls left play.
    fallen: Vec<Option<[[f64; LANES]; 2]>>,
    /// By ball and lane, when it was lost.
    lost: Vec<[Option<(usize, Why)>; LANES]>,
}

/// What a run with derivatives found.
#[derive(Clone, Debug)]
pub struct Found {
    /// What it was for.
    pub task: Task,
    /// Events that are those of the trace.
    pub same: usize,
    /// Derivatives of where balls are in the end, length.
    pub places: Vec<[[f64; LANES]; 2]>,
    /// Balls that were lost, by lane.
    lost: Vec<[Option<(usize, Why)>; LANES]>,
}

impl Found {
    /// The map of an event, counted from the first that was asked for.
    pub fn map(&self, place: usize) -> Option<&[f64]> {
        match &self.task {
            Task::Maps { found, .. } => found.get(place).map(Vec::as_slice),
            _ => None,
        }
    }

    /// The balls that have no derivative in a lane.
    pub fn lost(&self, lane: usize) -> Vec<Lost> {
        let lost = self.lost.iter().enumerate();
        let lost = lost.filter_map(|(ball, lanes)| {
            let (event, why) = lanes[lane]?;
            Some(Lost { ball, event, why })
        });
        lost.collect()
    }
}

/// Takes a run again with derivatives; `None` for one in fewer digits than f64.
pub fn follow(
    scene: &Scene,
    trace: &Trace,
    ulp: f64,
    seeds: Seeds,
    task: Task,
    limits: &Limits<'_>,
) -> Option<Found> {
    if ulp <= Octuple::ULP {
        Some(run::<Octuple>(scene, trace, seeds, task, limits))
    } else if ulp <= DoubleDouble::ULP {
        Some(run::<DoubleDouble>(scene, trace, seeds, task, limits))
    } else if ulp <= f64::EPSILON {
        Some(run::<f64>(scene, trace, seeds, task, limits))
    } else {
        None
    }
}

fn run<T: Real>(
    scene: &Scene,
    trace: &Trace,
    seeds: Seeds,
    task: Task,
    limits: &Limits<'_>,
) -> Found {
    let balls = seeds.kinematics::<Dual<T, LANES>>(scene);
    let mut derived = Derived {
        seeds,
        task,
        seen: 0,
        versions: vec![0; balls.count()],
        fallen: vec![None; balls.count()],
        lost: vec![[None; LANES]; balls.count()],
    };
    let mut balls = balls;
    derived.disturb_all(&mut balls);
    let limits = Limits {
        max_events: trace.events.len() as u64,
        ..*limits
    };
    let solver = Solver::of(balls).at_contacts(AtContacts::Follow);
    let solver = solver.deriving(derived);
    let mut played = solver.play(Provenance::default(), Record::Events, &limits, false);
    let until = match played.derived() {
        Some(Derived {
            task: Task::Places(until),
            ..
        }) => until.min(trace.end_time),
        _ => trace.end_time,
    };
    let places = places(&played, until);
    let derived = played.take_derived();
    let events = played.trace().events;
    let both = events.iter().zip(&trace.events);
    let same = both.take_while(|(ours, theirs)| ours == theirs).count();
    match derived {
        Some(derived) => Found {
            task: derived.task,
            same,
            places,
            lost: derived.lost,
        },
        None => Found {
            task: Task::Places(until),
            same: 0,
            places,
            lost: Vec::new(),
        },
    }
}

fn slopes<T: Real>(x: T) -> [f64; LANES] {
    std::array::from_fn(|lane| x.partial(lane))
}

/// Estimated errors of where balls are in the end, length; NaN of one that has no derivative.
pub fn place_errors(found: &Found, deviations: f64) -> Vec<f64> {
    let error = |place: &[[f64; LANES]; 2]| {
        let squares: f64 = place.iter().flatten().map(|x| x * x).sum();
        deviations * (squares / LANES as f64).sqrt()
    };
    found.places.iter().map(error).collect()
}

/// Derivatives of where all balls are at a time that has none, s.
fn places<T: Real>(played: &Played<'_, T>, until: f64) -> Vec<[[f64; LANES]; 2]> {
    let balls = played.balls();
    let at = |ball: usize| {
        let fallen = played.derived().and_then(|derived| derived.fallen[ball]);
        fallen.unwrap_or_else(|| balls.moving_at(ball, T::lift(until)).position.map(slopes))
    };
    (0..balls.count()).map(at).collect()
}

impl Derived {
    /// The world of a run that takes over.
    pub fn of_world<T: Real>(&self, scene: &Scene, world: World<T>) -> World<T> {
        self.seeds.of_world(scene, world)
    }

    /// Balls are from now on those of another run.
    pub fn look_at<T: Real>(&mut self, balls: &Kinematics<'_, T>) {
        self.versions = (0..balls.count()).map(|ball| balls.version(ball)).collect();
    }

    /// Whether nothing after `time`, s, is asked for.
    fn is_past(&self, time: f64) -> bool {
        match &self.task {
            Task::Maps { range, .. } => self.seen >= range.end,
            Task::Places(until) => time >= *until,
            Task::Errors(_) => false,
        }
    }

    /// Looks at the balls after an event.
    fn note<T: Real>(&mut self, balls: &mut Kinematics<'_, T>, events: usize) {
        let all = 0..balls.count();
        let changed = |ball: &usize| balls.version(*ball) != self.versions[*ball];
        let changed: Vec<usize> = all.filter(changed).collect();
        self.note_losses(balls, &changed);
        let rows = self.seen..events;
        let balls_fallen = &self.fallen;
        match &mut self.task {
            Task::Maps { range, found } => {
                let asked = rows.filter(|row| range.contains(row)).count();
                if asked > 0 {
                    let map = map(balls, balls_fallen);
                    found.extend(std::iter::repeat_n(map, asked));
                }
            }
            Task::Places(_) => {}
            Task::Errors(errors) => {
                let now = balls.now();
                let squares: f64 = slopes(now).iter().map(|x| x * x).sum();
                let deviation = (squares / LANES as f64).sqrt();
                let clock = errors.roundings[1] * T::ULP * now.to_f64();
                let error = errors.deviations * deviation + clock;
                let error = error.is_finite().then_some(error);
                errors.found.extend(rows.map(|_| error));
            }
        }
        self.disturb(balls, &changed);
        self.seen = events;
        self.look_at(balls);
    }

    fn note_losses<T: Real>(&mut self, balls: &Kinematics<'_, T>, changed: &[usize]) {
        let here = balls.now().detached();
        let before = self.lost.clone();
        for ball in changed {
            let mut moving = balls.moving_at(*ball, here);
            for lane in 0..LANES {
                let is_lost = (0..PARTS).any(|part| moving.part(part).partial(lane).is_nan());
                if is_lost && self.lost[*ball][lane].is_none() {
                    let met = changed.iter().any(|other| before[*other][lane].is_some());
                    let why = if met { Why::Met } else { Why::Together };
                    self.lost[*ball][lane] = Some((self.seen, why));
                }
            }
        }
    }

    /// Adds the errors of the start.
    fn disturb_all<T: Real>(&mut self, balls: &mut Kinematics<'_, T>) {
        let all: Vec<usize> = (0..balls.count()).collect();
        self.disturb(balls, &all);
    }

    /// Adds the errors of an event to balls that have set off now.
    fn disturb<T: Real>(&mut self, balls: &mut Kinematics<'_, T>, changed: &[usize]) {
        let Task::Errors(errors) = &mut self.task else {
            return;
        };
        let length = T::ULP * balls.world().extent;
        let clock = errors.roundings[1] * T::ULP * balls.now().to_f64();
        let mut done: Vec<usize> = Vec::new();
        for &ball in changed {
            if done.contains(&ball) || !balls.flight(ball).position[0].is_finite() {
                continue;
            }
            if balls.is_held(ball) {
                errors.disturb_group(balls, ball, [length, clock], &mut done);
                continue;
            }
            let flight = *balls.flight(ball);
            let mut moving = Moving {
                position: flight.position,
                velocity: flight.velocity,
                spin: balls
                    .course_of(ball)
                    .spin
                    .map_or([T::zero(); 3], |spin| spin.start),
            };
            let mut start = flight.start;
            let speed = errors.speed_of::<T>(ball, flight.fastest.to_f64());
            let radius = balls.world().radius[ball].to_f64();
            errors.nudge(
                &mut moving,
                &mut start,
                [length, speed, speed / radius, clock],
            );
            let course = departing(balls.world(), ball, start, moving);
            balls.derive(ball, &course);
        }
        errors.taken.clear();
        errors.of_law = 0.0;
    }
}

impl Errors {
    /// What the velocity of a ball may be off by, length/s.
    fn speed_of<T: Real>(&self, ball: usize, fastest: f64) -> f64 {
        let taken = self.taken.iter().filter(|(of, _)| *of == ball);
        let taken = taken.fold(0.0, |sum, (_, speed)| sum + speed);
        self.roundings[0] * T::ULP * fastest + self.of_law + taken
    }

    /// Moves everything by one error with a sign of its own; `[length, speed, turn, clock]`.
    fn nudge<T: Real>(&mut self, moving: &mut Moving<T>, start: &mut T, sizes: [f64; 4]) {
        for lane in 0..LANES {
            let mut signs = self.draws.bits();
            let mut signed = |x: &mut T, size: f64| {
                signs >>= 1;
                *x = x.nudged(lane, if signs & 1 == 0 { size } else { -size });
            };
            for part in 0..PARTS {
                let size = sizes[(part / 2).min(2)];
                signed(moving.part(part), size);
            }
            signed(start, sizes[3]);
        }
    }

    /// The same for the balls of a group that has just begun a stretch: none of it opens a contact.
    fn disturb_group<T: Real>(
        &mut self,
        balls: &mut Kinematics<'_, T>,
        ball: usize,
        [length, clock]: [f64; 2],
        done: &mut Vec<usize>,
    ) {
        let Some(held) = balls.contacts().of(ball) else {
            return;
        };
        let (mut group, mut start) = (held.group.clone(), held.start);
        let fastest = held.arc.series.iter().map(|series| series.fastest.to_f64());
        let fastest: Vec<f64> = fastest.collect();
        for (m, fastest) in group.members.iter_mut().zip(fastest) {
            done.push(m.ball);
            let speed = self.speed_of::<T>(m.ball, fastest);
            let radius = balls.world().radius[m.ball].to_f64();
            let sizes = [length, speed, speed / radius, 0.0];
            self.nudge(&mut m.moving, &mut T::zero(), sizes);
        }
        self.nudge(&mut Moving::at_rest(), &mut start, [0.0, 0.0, 0.0, clock]);
        let touches = group.touches();
        keep_slopes(balls.world(), &mut group.members, &touches);
        for (m, was) in group.members.iter_mut().zip(&held.group.members) {
            m.moving = was.moving.following(&m.moving);
        }
        let arc = stretch(balls, &group);
        if let Some(held) = balls.derive_held(ball) {
            (held.group, held.arc, held.start) = (group, arc, start);
        }
    }
}

/// How everything moves now, by ball, part and lane.
fn map<T: Real>(balls: &Kinematics<'_, T>, fallen: &[Option<[[f64; LANES]; 2]>]) -> Vec<f64> {
    let now = balls.now().detached();
    let mut map = Vec::with_capacity(balls.count() * PARTS * LANES);
    for (ball, fallen) in fallen.iter().enumerate() {
        if let Some(place) = fallen {
            map.extend(place.iter().flatten());
            map.extend([0.0; (PARTS - 2) * LANES]);
            continue;
        }
        let mut moving = balls.moving_at(ball, now);
        for part in 0..PARTS {
            map.extend(slopes(*moving.part(part)));
        }
    }
    map
}

impl<T: Real> Loop<'_, T> {
    /// The time of an event, s, with the derivatives that what happens gives it.
    pub(super) fn moved(&self, time: T, what: What) -> T {
        let at = time.detached();
        let encounter = match what {
            What::Pair(a, b) | What::UnclearPair(a, b) => Encounter::Pair(a as usize, b as usize),
            What::Cushion(a, side) | What::UnclearCushion(a, side) => {
                Encounter::Cushion(a as usize, side)
            }
            What::Pocket(a, pocket) => return self.moved_fall(at, a as usize, pocket as usize),
            What::End(a) => {
                let ball = a as usize;
                let held = self.balls.contacts().of(ball);
                let held = held.filter(|_| self.balls.is_held(ball));
                let end = held.map_or(self.balls.flight(ball).end, |held| {
                    held.start + held.arc.length
                });
                return time.following(end);
            }
            What::UnclearPocket(..) | What::Leaving(..) | What::Nothing => return at,
        };
        let (gap, rate) = self.balls.gap_at(encounter, at);
        step(at, gap, rate)
    }

    fn moved_fall(&self, at: T, ball: usize, pocket: usize) -> T {
        let [x, y, radius] = self.balls.world().pockets[pocket];
        let Moving {
            position, velocity, ..
        } = self.balls.moving_at(ball, at);
        let p = [x - position[0], y - position[1]];
        let apart = (p[0] * p[0] + p[1] * p[1]).sqrt();
        let rate = -(p[0] * velocity[0] + p[1] * velocity[1]) / apart;
        step(at, apart - radius, rate)
    }

    /// Whether nothing from `time` on is asked for.
    pub(super) fn is_past(&self, time: T) -> bool {
        let derived = self.derived.as_ref();
        derived.is_some_and(|derived| derived.is_past(time.to_f64()))
    }

    /// Looks at what an event has done.
    pub(super) fn note(&mut self) {
        if let Some(mut derived) = self.derived.take() {
            derived.note(&mut self.balls, self.journal.events() as usize);
            self.derived = Some(derived);
        }
    }

    /// A ball leaves play: where it does keeps its derivatives.
    pub(super) fn note_fall(&mut self, ball: usize) {
        let place = self.balls.place(ball).map(slopes);
        if let Some(derived) = &mut self.derived {
            derived.fallen[ball] = Some(place);
        }
    }

    /// What the law of an event may be off by, length/s.
    pub(super) fn note_error(&mut self, error: f64) {
        if let Some(Derived {
            task: Task::Errors(errors),
            ..
        }) = self.derived.as_deref_mut()
        {
            errors.of_law = errors.of_law.max(error);
        }
    }

    /// What is left of the approaches of balls that touch is taken out.
    pub(super) fn note_taken(&mut self, members: &[Member<T>], touches: &[Touch]) {
        if let Some(Derived {
            task: Task::Errors(errors),
            ..
        }) = self.derived.as_deref_mut()
        {
            for touch in touches {
                let speed = rate(members, *touch).to_f64().abs();
                let balls = touch.members().map(|(m, _)| (members[m].ball, speed));
                errors.taken.extend(balls);
            }
        }
    }

    /// Contacts that are resolved at one instant: in which lanes a change of the input opens one of them.
    fn opening(&self, encounters: impl Iterator<Item = Encounter>) -> [bool; LANES] {
        let mut lanes = [false; LANES];
        let estimates = self.balls.world().estimates;
        for encounter in encounters.filter(|_| !estimates) {
            let (gap, _) = self.balls.gap_at(encounter, self.balls.now());
            let places = encounter.balls().flat_map(|ball| self.balls.place(ball));
            let places: Vec<T> = places.collect();
            for (lane, opens) in lanes.iter_mut().enumerate() {
                let each = places.iter().map(|x| x.partial(lane).abs());
                let size = each.fold(0.0_f64, f64::max);
                // NaN opens
                *opens |= !(gap.partial(lane).abs() <= HOLDS * size);
            }
        }
        lanes
    }

    /// Balls that an instant with several contacts concerns have no derivative by an input that opens one of them.
    pub(super) fn note_together(&self, members: &mut [Member<T>], touches: &[Touch]) {
        let lanes = self.opening(touches.iter().map(|touch| touch.encounter(members)));
        for m in members {
            lose(&mut m.moving, &lanes);
        }
    }

    /// The same of an instant that a convention resolves.
    pub(super) fn note_cluster(&self, cluster: &mut ClusterImpact<T>) {
        let sides = &cluster.sides;
        let rows = cluster.rows.iter().map(|row| {
            let first = sides[row.first.member].ball;
            match &row.second {
                Met::Ball(second) => Encounter::Pair(first, sides[second.member].ball),
                Met::Cushion(side) => Encounter::Cushion(first, *side),
            }
        });
        let lanes = self.opening(rows);
        if !lanes.contains(&true) {
            return;
        }
        for side in &mut cluster.sides {
            let mut far = Moving {
                position: side.position,
                velocity: side.after,
                spin: side.spin_after,
            };
            lose(&mut far, &lanes);
            let course = self.balls.course(side.ball, far);
            side.course = Course {
                flight: side.course.flight.following(&course.flight),
                spin: side
                    .course
                    .spin
                    .zip(course.spin)
                    .map(|(own, other)| own.following(&other)),
            };
        }
    }
}

/// Takes the derivatives by these inputs from a motion.
fn lose<T: Real>(moving: &mut Moving<T>, lanes: &[bool; LANES]) {
    for (lane, _) in lanes.iter().enumerate().filter(|(_, lost)| **lost) {
        for part in 0..PARTS {
            let part = moving.part(part);
            *part = part.nudged(lane, f64::NAN);
        }
    }
}

/// The time at which a gap closes that is `gap` at time `at`, s, and falls at `rate`.
fn step<T: Real>(at: T, gap: T, rate: T) -> T {
    if rate < T::zero() {
        // by its derivatives alone
        at - T::zero().following(gap) / rate.detached()
    } else {
        at
    }
}
