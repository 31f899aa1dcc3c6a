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

mod notes;

use super::contact::touching::keep_slopes;
use super::flight::Flight;
use super::kinematics::{Course, Kinematics};
use super::spin::Moving;
use super::stretch::stretch;
use super::world::World;
use crate::math::Real;
use crate::math::random::Draws;
use crate::physics::Effects;
use crate::scene::Scene;
use crate::trace::{EventKind, Trace};

/// Derivatives that one run carries.
pub const LANES: usize = 16;

/// Coordinates of a ball: centre, velocity, spin.
pub const PARTS: usize = 7;

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
    pub(super) fn kinematics<'a, T: Real>(&self, scene: &'a Scene) -> Kinematics<'a, T> {
        let world = self.of_world(scene, World::<T>::new(scene));
        let (mut flights, mut spins) = (Vec::new(), Vec::new());
        for ball in 0..scene.balls.len() {
            let radius = world.radius[ball];
            let mut moving = Moving::lifted(&scene.start(ball));
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
    /// Its derivatives within a stretch of contact are not told to the end.
    Untold,
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
    /// By ball, when its group last changed, s.
    turned: Vec<f64>,
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
    pub(super) lost: Vec<[Option<(usize, Why)>; LANES]>,
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

/// The derivatives of a number.
pub(super) fn slopes<T: Real>(x: T) -> [f64; LANES] {
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

impl Derived {
    /// The time, s, at which places are asked for.
    pub(super) fn until(&self) -> Option<f64> {
        match self.task {
            Task::Places(until) => Some(until),
            _ => None,
        }
    }

    /// Derivatives of the place at which a ball left play.
    pub(super) fn fallen(&self, ball: usize) -> Option<[[f64; LANES]; 2]> {
        self.fallen[ball]
    }

    /// What was found. `same`: events that are those of the trace; `places`: derivatives of where balls are in the end, length.
    pub(super) fn into_found(mut self, same: usize, places: Vec<[[f64; LANES]; 2]>) -> Found {
        for (place, lost) in places.iter().zip(&mut self.lost) {
            for (lane, lost) in lost.iter_mut().enumerate() {
                if lost.is_none() && place.iter().any(|axis| !axis[lane].is_finite()) {
                    *lost = Some((same, Why::Untold));
                }
            }
        }
        Found {
            task: self.task,
            same,
            places,
            lost: self.lost,
        }
    }

    /// Nothing seen yet of so many balls.
    pub(super) fn new(seeds: Seeds, task: Task, balls: usize) -> Self {
        Derived {
            seeds,
            task,
            seen: 0,
            versions: vec![0; balls],
            fallen: vec![None; balls],
            lost: vec![[None; LANES]; balls],
            turned: vec![f64::NEG_INFINITY; balls],
        }
    }

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
            for (lane, lost) in self.lost[*ball].iter_mut().enumerate() {
                let is_lost = (0..PARTS).any(|part| moving.part(part).partial(lane).is_nan());
                if is_lost && lost.is_none() {
                    let met = changed.iter().any(|other| before[*other][lane].is_some());
                    let why = if met { Why::Met } else { Why::Together };
                    *lost = Some((self.seen, why));
                }
            }
        }
    }

    /// Adds the errors of the start.
    pub(super) fn disturb_all<T: Real>(&mut self, balls: &mut Kinematics<'_, T>) {
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
