//! The derivative of a run: its events taken once more in dual numbers.
//!
//! A trace says which events happened, in which order. As long as a small change of the inputs does not change that order, the
//! run depends smoothly on them, and its derivative is that of the same events: flights in closed form, times from one Newton step,
//! impacts by their laws, each in dual numbers with one lane an input. Values are taken from the trace at every event, so
//! that the derivative belongs to the run that was recorded and not to one beside it.
//!
//! A perturbation is compared at equal times: `states_at` evaluates flights whose start moves with the inputs at a time that
//! does not, which is the saltation matrix of an impact without writing it down.

use super::flight::{Flight, Ground, Phase};
use super::spin::{Moving, Rotation, Spin, Turn};
use super::world::World;
use crate::math::{Dual, Real};
use crate::physics::{Body, Effects, Motion, Side, State, contact, cushion};
use crate::scene::Scene;
use crate::trace::{EventKind, Trace};
use nalgebra::Vector3;
use num_traits::{One, Zero};

/// The velocity that a law leaves and the one in the trace agree to rounding; one that a convention left does not. In units of the
/// largest speed that there can be.
const SAME_VELOCITY: f64 = 1e-9;

/// A trace ready to be taken again: what each event left behind.
#[derive(Debug)]
pub struct Script<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its run.
    pub trace: &'a Trace,
    /// Where in `sides` those of each event begin; one more at the end.
    first: Vec<usize>,
    /// The far sides of all events, one after another: ball, and index of the knot in its path.
    sides: Vec<(u32, u32)>,
}

impl<'a> Script<'a> {
    /// Finds the far sides of all events: two passes over the knots.
    pub fn new(scene: &'a Scene, trace: &'a Trace) -> Self {
        let events = trace.events.len();
        let far = || {
            trace
                .paths
                .iter()
                .enumerate()
                .flat_map(move |(ball, path)| {
                    let knots = path.knots.iter().enumerate();
                    knots.filter_map(move |(knot, found)| {
                        let event = found.after.map(|event| event as usize)?;
                        (event < events).then_some((event, (ball as u32, knot as u32)))
                    })
                })
        };
        let mut first = vec![0; events + 1];
        for (event, _) in far() {
            first[event + 1] += 1;
        }
        for event in 0..events {
            first[event + 1] += first[event];
        }
        let mut sides = vec![(0, 0); first[events]];
        let mut next = first.clone();
        for (event, side) in far() {
            sides[next[event]] = side;
            next[event] += 1;
        }
        Script {
            scene,
            trace,
            first,
            sides,
        }
    }

    /// The balls of an event with their states on its far side, by scene order.
    pub fn far(&self, event: usize) -> impl Iterator<Item = (usize, &'a State)> {
        let sides = &self.sides[self.first[event]..self.first[event + 1]];
        let trace = self.trace;
        sides.iter().map(move |(ball, knot)| {
            let ball = *ball as usize;
            (ball, &trace.paths[ball].knots[*knot as usize].state)
        })
    }
}

/// A run being taken again, with `N` derivatives.
#[derive(Debug)]
pub struct Replay<'a, const N: usize> {
    script: &'a Script<'a>,
    /// What stays the same.
    pub world: World<Dual<f64, N>>,
    /// What every ball does, since its own last event.
    pub flights: Vec<Flight<Dual<f64, N>>>,
    /// How every ball turns meanwhile; empty where the scene does not call for rotation.
    pub spins: Vec<Spin<Dual<f64, N>>>,
    /// Change of the restitution of ball-ball impacts, and of ball-cushion impacts: 0 with its derivatives.
    pub restitution: [Dual<f64, N>; 2],
    /// What the law of the last event may be off by, length/s; 0 for a law in closed form.
    pub law_error: f64,
    next: usize,
}

/// An event that has no derivative: a convention resolved it together with others, or its balls were not closing in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rough {
    /// Its index in the trace.
    pub index: usize,
}

impl<'a, const N: usize> Replay<'a, N> {
    /// The run at time 0. `start` seeds the derivatives of how a ball moves.
    pub fn new(
        script: &'a Script<'a>,
        effects: &Effects<Dual<f64, N>>,
        start: impl Fn(usize, &mut Moving<Dual<f64, N>>),
    ) -> Self {
        let scene = script.scene;
        let gravity = Dual::lift(scene.gravity);
        let mut world = World::<Dual<f64, N>>::new(scene);
        world.ground = Ground::new(effects, gravity);
        world.rotation = Rotation::new(effects, gravity);
        world.contact = effects.contact;
        world.friction = effects.friction;
        world.cushion = effects.cushion;
        let (flights, spins) = world.first_flights(scene);
        let mut replay = Replay {
            script,
            world,
            flights,
            spins,
            restitution: [Dual::zero(); 2],
            law_error: 0.0,
            next: 0,
        };
        for (ball, path) in script.trace.paths.iter().enumerate() {
            let state = path.state_at(0.0).unwrap_or(scene.balls[ball].state);
            let mut moving = Moving::lifted(&state);
            start(ball, &mut moving);
            replay.depart(ball, Dual::zero(), moving);
        }
        replay
    }

    /// Takes the next event and answers its time, s; `None` after the last.
    pub fn step(&mut self) -> Option<Result<Dual<f64, N>, Rough>> {
        let index = self.next;
        let event = self.script.trace.events.get(index)?;
        self.next += 1;
        self.law_error = 0.0;
        let time = match event.kind {
            EventKind::BallBall(a, b) => self.meet(index, event.time, a as usize, b as usize),
            EventKind::BallCushion(a, side) => self.rebound(index, event.time, a as usize, side),
            EventKind::Stop(a) | EventKind::SlideToRoll(a) | EventKind::SpinEnd(a) => {
                Some(self.end(index, event.time, a as usize))
            }
            EventKind::Pocket(a, pocket) => self.fall(event.time, a as usize, pocket as usize),
            // how long balls are held, and what they do meanwhile, is for `derived`
            EventKind::ContactBegin(..) | EventKind::ContactEnd(..) => None,
        };
        Some(time.ok_or(Rough { index }))
    }

    /// How every ball moves at time `t`, s, which does not change with the inputs.
    pub fn states_at(&self, t: f64) -> Vec<Moving<Dual<f64, N>>> {
        let t = Dual::constant(t);
        (0..self.flights.len())
            .map(|ball| self.state_at(ball, t))
            .collect()
    }

    fn state_at(&self, ball: usize, t: Dual<f64, N>) -> Moving<Dual<f64, N>> {
        let flight = &self.flights[ball];
        let (position, velocity) = flight.at(t);
        let spin = match self.spins.get(ball) {
            None => [Dual::zero(); 3],
            Some(spin) => spin.after(t - flight.start),
        };
        Moving {
            position,
            velocity,
            spin,
        }
    }

    /// How a ball set out on its flight.
    pub fn set_out(&self, ball: usize) -> Moving<Dual<f64, N>> {
        let flight = &self.flights[ball];
        Moving {
            position: flight.position,
            velocity: flight.velocity,
            spin: self
                .spins
                .get(ball)
                .map_or([Dual::zero(); 3], |spin| spin.start),
        }
    }

    /// Puts a ball on another flight. Without friction a ball at rest moves as soon as its velocity is changed; on a cloth such a
    /// change is gone before it has moved the ball at first order.
    pub fn depart(&mut self, ball: usize, start: Dual<f64, N>, moving: Moving<Dual<f64, N>>) {
        let Moving {
            position, velocity, ..
        } = moving;
        let (flight, free) = match &self.world.rotation {
            None => {
                let ground = self.world.ground;
                let free = ground == Ground::Frictionless;
                (Flight::new(ground, start, position, velocity), free)
            }
            Some(rotation) => {
                let radius = self.world.radius[ball];
                let (flight, spin) = rotation.depart(radius, start, moving);
                self.spins[ball] = spin;
                (flight, rotation.slide.is_zero() && rotation.roll.is_zero())
            }
        };
        self.flights[ball] = match free {
            true => Flight {
                velocity,
                phase: Phase::Free,
                ..flight
            },
            false => flight,
        };
    }

    fn meet(&mut self, index: usize, t: f64, a: usize, b: usize) -> Option<Dual<f64, N>> {
        let law = self.world.contact?;
        let now = Dual::constant(t);
        let ((p, v), (q, w)) = (self.flights[a].at(now), self.flights[b].at(now));
        let (p, v) = ([q[0] - p[0], q[1] - p[1]], [w[0] - v[0], w[1] - v[1]]);
        let distance = self.world.distance(a, b);
        let f = p[0] * p[0] + p[1] * p[1] - distance * distance;
        let slope = (p[0] * v[0] + p[1] * v[1]).value;
        let time = moved(t, &f, slope + slope)?;
        let (one, other) = (self.state_at(a, time), self.state_at(b, time));
        let (x, y) = (
            other.position[0] - one.position[0],
            other.position[1] - one.position[1],
        );
        let apart = (x * x + y * y).sqrt();
        let n = Vector3::new(x / apart, y / apart, Dual::zero());
        let (first, second) = (self.body(a, &one), self.body(b, &other));
        let motions = contact::impact(law, self.world.friction, &first, &second, &n);
        let change = self.restitution[0];
        let sides = [
            (a, left(&one, &motions.0, change)),
            (b, left(&other, &motions.1, change)),
        ];
        self.leave(index, time, &sides)?;
        Some(time)
    }

    fn rebound(&mut self, index: usize, t: f64, a: usize, side: Side) -> Option<Dual<f64, N>> {
        let law = self.world.cushion?;
        let axis = side.axis();
        let outward = |x: Dual<f64, N>| if side.sign() < 0 { -x } else { x };
        let (position, velocity) = self.flights[a].at(Dual::constant(t));
        let beyond = outward(position[axis] - self.world.reach[a][side as usize]);
        let time = moved(t, &-beyond, -outward(velocity[axis]).value)?;
        let before = self.state_at(a, time);
        let rebound = cushion::impact(law, &self.body(a, &before), side);
        self.law_error = rebound.error;
        let after = left(&before, &rebound.motion, self.restitution[1]);
        self.leave(index, time, &[(a, after)])?;
        Some(time)
    }

    /// The end of a flight by itself; where an impact left the ball at rest, there is nothing more to do.
    fn end(&mut self, index: usize, t: f64, a: usize) -> Dual<f64, N> {
        let flight = self.flights[a];
        let ends = match self.spins.get(a) {
            None => flight.phase == Phase::Slide,
            // the second of two ends at one time finds the ball on its way already
            Some(spin) => spin.turn != Turn::Never && flight.start.value < t,
        };
        if !ends {
            return flight.start;
        }
        let time = Dual {
            value: t,
            ..flight.end
        };
        let mut moving = match (&self.world.rotation, self.spins.get(a)) {
            (Some(rotation), Some(spin)) => rotation.turned(self.world.radius[a], &flight, spin),
            _ => Moving {
                position: flight.rest_position(),
                velocity: [Dual::zero(); 2],
                spin: [Dual::zero(); 3],
            },
        };
        self.anchor(index, a, &mut moving);
        self.depart(a, time, moving);
        time
    }

    /// A ball enters a pocket, and stays where it left play.
    fn fall(&mut self, t: f64, a: usize, pocket: usize) -> Option<Dual<f64, N>> {
        let [x, y, radius] = *self.world.pockets.get(pocket)?;
        let (position, velocity) = self.flights[a].at(Dual::constant(t));
        let p = [x - position[0], y - position[1]];
        let f = p[0] * p[0] + p[1] * p[1] - radius * radius;
        let slope = -(p[0] * velocity[0] + p[1] * velocity[1]).value;
        let time = moved(t, &f, slope + slope)?;
        let mut moving = self.state_at(a, time);
        moving.velocity = [Dual::zero(); 2];
        moving.spin = [Dual::zero(); 3];
        self.depart(a, time, moving);
        self.flights[a].phase = Phase::Rest;
        Some(time)
    }

    fn body(&self, ball: usize, moving: &Moving<Dual<f64, N>>) -> Body<Dual<f64, N>> {
        let [x, y] = moving.velocity;
        Body {
            velocity: Vector3::new(x, y, Dual::zero()),
            spin: moving.spin.into(),
            mass: self.world.mass[ball],
            radius: self.world.radius[ball],
        }
    }

    /// Puts balls on their flights after an impact; `None` where the trace says that the law alone did not do it.
    fn leave(
        &mut self,
        index: usize,
        time: Dual<f64, N>,
        sides: &[(usize, Moving<Dual<f64, N>>)],
    ) -> Option<()> {
        let most = SAME_VELOCITY * self.world.fastest.value;
        for (ball, after) in sides {
            let mut moving = *after;
            self.anchor(index, *ball, &mut moving);
            let off = [0, 1].map(|i| (moving.velocity[i].value - after.velocity[i].value).abs());
            if off[0] > most || off[1] > most {
                return None;
            }
            self.depart(*ball, time, moving);
        }
        Some(())
    }

    /// Sets the values to those of the trace on the far side of an event.
    fn anchor(&self, index: usize, ball: usize, moving: &mut Moving<Dual<f64, N>>) {
        let known = self.script.far(index).find(|side| side.0 == ball);
        if let Some((_, state)) = known {
            for axis in 0..2 {
                moving.position[axis].value = state.position[axis];
                moving.velocity[axis].value = state.velocity[axis];
            }
            for axis in 0..3 {
                moving.spin[axis].value = state.spin[axis];
            }
        }
    }
}

/// The time `t` of a root of `f`, which falls there with `slope` < 0, with the derivatives that `f` gives it.
fn moved<const N: usize>(t: f64, f: &Dual<f64, N>, slope: f64) -> Option<Dual<f64, N>> {
    (slope < 0.0).then(|| Dual {
        value: t,
        partials: f.partials.map(|partial| -partial / slope),
    })
}

/// How a ball moves after an impact whose restitution changes by `change`: an elastic impulse goes with 1 + e, and e is 1.
fn left<const N: usize>(
    before: &Moving<Dual<f64, N>>,
    motion: &Motion<Dual<f64, N>>,
    change: Dual<f64, N>,
) -> Moving<Dual<f64, N>> {
    let factor = Dual::one() + change / Dual::lift(2.0);
    let velocity =
        [0, 1].map(|i| before.velocity[i] + (motion.velocity[i] - before.velocity[i]) * factor);
    Moving {
        position: before.position,
        velocity,
        spin: motion.spin.into(),
    }
}
