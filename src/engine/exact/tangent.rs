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
    /// The balls of each event with their states on its far side.
    pub far: Vec<Vec<(usize, State)>>,
}

impl<'a> Script<'a> {
    /// Reads the far sides of all events.
    pub fn new(scene: &'a Scene, trace: &'a Trace) -> Self {
        let mut far = vec![Vec::new(); trace.events.len()];
        for (ball, path) in trace.paths.iter().enumerate() {
            for knot in &path.knots {
                if let Some(sides) = knot.after.and_then(|event| far.get_mut(event as usize)) {
                    sides.push((ball, knot.state));
                }
            }
        }
        Script { scene, trace, far }
    }
}

/// Centre and velocity of a ball in the plane, with derivatives.
pub type Motion2<const N: usize> = [[Dual<f64, N>; 2]; 2];

/// A run being taken again, with `N` derivatives.
#[derive(Debug)]
pub struct Replay<'a, const N: usize> {
    script: &'a Script<'a>,
    /// What stays the same.
    pub world: World<Dual<f64, N>>,
    /// What every ball does, since its own last event.
    pub flights: Vec<Flight<Dual<f64, N>>>,
    /// Change of the restitution of ball-ball impacts, and of ball-cushion impacts: 0 with its derivatives.
    pub restitution: [Dual<f64, N>; 2],
    next: usize,
}

/// An event that has no derivative: a convention resolved it together with others, or its balls were not closing in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rough {
    /// Its index in the trace.
    pub index: usize,
}

impl<'a, const N: usize> Replay<'a, N> {
    /// The run at time 0. `start` seeds the derivatives of a ball's centre and velocity.
    pub fn new(
        script: &'a Script<'a>,
        effects: &Effects<Dual<f64, N>>,
        start: impl Fn(usize, &mut Motion2<N>),
    ) -> Self {
        let scene = script.scene;
        let mut world = World::<Dual<f64, N>>::new(scene);
        world.ground = Ground::new(effects, Dual::lift(scene.gravity));
        let flight = |(ball, path): (usize, &crate::trace::Path)| {
            let state = path.state_at(0.0).unwrap_or(scene.balls[ball].state);
            let (r, v) = (state.position, state.velocity);
            let mut motion = [[r.x, r.y], [v.x, v.y]].map(|pair| pair.map(Dual::constant));
            start(ball, &mut motion);
            depart(world.ground, Dual::zero(), motion)
        };
        let flights = script.trace.paths.iter().enumerate().map(flight).collect();
        Replay {
            script,
            world,
            flights,
            restitution: [Dual::zero(); 2],
            next: 0,
        }
    }

    /// Takes the next event and answers its time, s; `None` after the last.
    pub fn step(&mut self) -> Option<Result<Dual<f64, N>, Rough>> {
        let index = self.next;
        let event = self.script.trace.events.get(index)?;
        self.next += 1;
        let time = match event.kind {
            EventKind::BallBall(a, b) => self.meet(index, event.time, a as usize, b as usize),
            EventKind::BallCushion(a, side) => self.rebound(index, event.time, a as usize, side),
            EventKind::Stop(a) => Some(self.stop(index, event.time, a as usize)),
            // no law that is built has them
            EventKind::SlideToRoll(_) | EventKind::SpinEnd(_) | EventKind::Pocket(..) => None,
        };
        Some(time.ok_or(Rough { index }))
    }

    /// Centre and velocity of every ball at time `t`, s, which does not move with the inputs.
    pub fn states_at(&self, t: f64) -> Vec<Motion2<N>> {
        let at = |flight: &Flight<Dual<f64, N>>| {
            let (position, velocity) = flight.at(Dual::constant(t));
            [position, velocity]
        };
        self.flights.iter().map(at).collect()
    }

    /// Puts a ball on another flight.
    pub fn restart(&mut self, ball: usize, start: Dual<f64, N>, motion: Motion2<N>) {
        self.flights[ball] = depart(self.world.ground, start, motion);
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
        let ((p, before), (q, other)) = (self.flights[a].at(time), self.flights[b].at(time));
        let (x, y) = (q[0] - p[0], q[1] - p[1]);
        let apart = (x * x + y * y).sqrt();
        let n = Vector3::new(x / apart, y / apart, Dual::zero());
        let (one, two) =
            contact::impact(law, None, &self.body(a, before), &self.body(b, other), &n);
        let change = self.restitution[0];
        let sides = [
            (a, p, restored(before, &one, change)),
            (b, q, restored(other, &two, change)),
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
        let (position, before) = self.flights[a].at(time);
        let after = cushion::impact(law, &self.body(a, before), side).motion;
        let after = restored(before, &after, self.restitution[1]);
        self.leave(index, time, &[(a, position, after)])?;
        Some(time)
    }

    /// The end of a slide; where an impact left the ball at rest, there is nothing more to do.
    fn stop(&mut self, index: usize, t: f64, a: usize) -> Dual<f64, N> {
        let flight = self.flights[a];
        if flight.phase != Phase::Slide {
            return flight.start;
        }
        let time = Dual {
            value: t,
            ..flight.end
        };
        let mut motion = [flight.rest_position(), [Dual::zero(); 2]];
        self.anchor(index, a, &mut motion);
        self.flights[a] = depart(self.world.ground, time, motion);
        time
    }

    fn body(&self, ball: usize, velocity: [Dual<f64, N>; 2]) -> Body<Dual<f64, N>> {
        Body {
            velocity: Vector3::new(velocity[0], velocity[1], Dual::zero()),
            spin: Vector3::new(Dual::zero(), Dual::zero(), Dual::zero()),
            mass: self.world.mass[ball],
            radius: self.world.radius[ball],
        }
    }

    /// Puts balls on their flights after an impact; `None` where the trace says that the law alone did not do it.
    fn leave(
        &mut self,
        index: usize,
        time: Dual<f64, N>,
        sides: &[(usize, [Dual<f64, N>; 2], [Dual<f64, N>; 2])],
    ) -> Option<()> {
        let most = SAME_VELOCITY * self.world.fastest.value;
        for (ball, position, velocity) in sides {
            let mut motion = [*position, *velocity];
            self.anchor(index, *ball, &mut motion);
            let off = [0, 1].map(|i| (motion[1][i].value - velocity[i].value).abs());
            if off[0] > most || off[1] > most {
                return None;
            }
            self.flights[*ball] = depart(self.world.ground, time, motion);
        }
        Some(())
    }

    /// Sets the values to those of the trace on the far side of an event.
    fn anchor(&self, index: usize, ball: usize, motion: &mut Motion2<N>) {
        let known = self.script.far[index].iter().find(|side| side.0 == ball);
        if let Some((_, state)) = known {
            for axis in 0..2 {
                motion[0][axis].value = state.position[axis];
                motion[1][axis].value = state.velocity[axis];
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

/// The velocity after an impact whose restitution changes by `change`: every law's impulse goes with 1 + e, and e is 1.
fn restored<const N: usize>(
    before: [Dual<f64, N>; 2],
    motion: &Motion<Dual<f64, N>>,
    change: Dual<f64, N>,
) -> [Dual<f64, N>; 2] {
    let factor = Dual::one() + change / Dual::lift(2.0);
    [0, 1].map(|i| before[i] + (motion.velocity[i] - before[i]) * factor)
}

/// A flight with its derivatives. Without friction a ball at rest moves as soon as its velocity is changed; on a cloth such a
/// change is gone before it has moved the ball at first order.
fn depart<const N: usize>(
    ground: Ground<Dual<f64, N>>,
    start: Dual<f64, N>,
    [position, velocity]: Motion2<N>,
) -> Flight<Dual<f64, N>> {
    let flight = Flight::new(ground, start, position, velocity);
    match ground {
        Ground::Coulomb(_) => flight,
        Ground::Frictionless => Flight {
            velocity,
            phase: Phase::Free,
            ..flight
        },
    }
}
