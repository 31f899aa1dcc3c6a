//! The rest of an accumulation: infinitely many impacts of one encounter before a time that is near.
//!
//! Two balls that the cloth presses together, or one that it presses to a cushion, hit again and again, each time with about the same part of the
//! speed before: the impacts have a limit, in time and in state. The run's own events cannot get there, because the gap between two
//! impacts sinks below the rounding of a coordinate long before. Here the two are taken by themselves, from one of their impacts on, in coordinates of
//! their own: what is followed is the gap, from exactly zero at an impact, and times from zero. So nothing cancels, each impact follows from the one
//! before by the same laws as in the run (phases of the cloth between them included), and the limit is reached when the approach is rounding.
//!
//! That makes no use of what the ratio of two approaches should be, and so holds for any masses and laws. A run of impacts that is finite shows by
//! itself: the two part and do not come back, or their approach does not shrink.

use crate::engine::exact::encounter::Encounter;
use crate::engine::exact::flight::Flight;
use crate::engine::exact::spin::{Moving, Spin, Turn};
use crate::engine::exact::world::World;
use crate::math::Real;
use crate::physics::{Body, Motion, Side, contact, cushion};
use nalgebra::Vector3;

/// Impacts beyond which a sequence counts as endless without shrinking.
const MOST_IMPACTS: u32 = 100_000;

/// The approach at which the sequence is over, in roundings of the fastest ball.
const OVER: f64 = 4.0;

/// Impacts in which the approach must have shrunk.
const SHRINKS_WITHIN: u32 = 64;

/// Newton steps for one impact.
const STEPS: usize = 60;

/// Where an accumulation leads.
#[derive(Clone, Debug)]
pub struct Limit<T> {
    /// Time from the impact it was asked for, s.
    pub after: T,
    /// How the parties move then, in the order of the encounter.
    pub states: Vec<Moving<T>>,
    /// Impacts up to then, the first included.
    pub impacts: u32,
}

/// One of the two: a ball on its course since a time of its own.
#[derive(Clone, Copy, Debug)]
struct Party<T> {
    radius: T,
    mass: T,
    flight: Flight<T>,
    spin: Spin<T>,
}

impl<T: Real> Party<T> {
    fn set_off(&mut self, world: &World<T>, start: T, moving: Moving<T>) {
        (self.flight, self.spin) = match &world.rotation {
            None => (
                Flight::new(world.ground, start, moving.position, moving.velocity),
                Spin::none(),
            ),
            Some(rotation) => rotation.depart(self.radius, start, moving),
        };
    }

    fn at(&self, t: T) -> Moving<T> {
        let (position, velocity) = self.flight.at(t);
        Moving {
            position,
            velocity,
            spin: self.spin.after(t - self.flight.start),
        }
    }

    /// Passes the end of its phase.
    fn turn(&mut self, world: &World<T>) {
        let end = self.flight.end;
        let next = match &world.rotation {
            Some(rotation) => rotation.turned(self.radius, &self.flight, &self.spin),
            None => Moving {
                position: self.flight.rest_position(),
                velocity: [T::zero(); 2],
                spin: [T::zero(); 3],
            },
        };
        self.set_off(world, end, next);
    }

    fn body(&self, moving: &Moving<T>) -> Body<T> {
        Body {
            velocity: Vector3::new(moving.velocity[0], moving.velocity[1], T::zero()),
            spin: moving.spin.into(),
            mass: self.mass,
            radius: self.radius,
        }
    }
}

/// Two parties by themselves.
struct Alone<'a, T: Real> {
    world: &'a World<T>,
    parties: Vec<Party<T>>,
    side: Option<Side>,
    /// From the first centre to the second at an impact; without a second ball, nothing.
    apart: [T; 2],
    /// What the square of the distance, or the distance to the cushion, is above that of contact.
    above: T,
    now: T,
}

/// The limit of the impacts of `encounter` that begin with the one at hand, whose parties move as `states`; `None` if they have none.
pub fn limit<T: Real>(
    world: &World<T>,
    encounter: Encounter,
    states: &[Moving<T>],
) -> Option<Limit<T>> {
    let mut alone = Alone::new(world, encounter, states);
    let impacts = alone.play(None)?;
    Some(Limit {
        after: alone.now,
        states: alone.states(states),
        impacts,
    })
}

/// How the parties of an impact move `after` seconds, before the limit of their impacts; `None` if they have no more impacts before.
pub fn until<T: Real>(
    world: &World<T>,
    encounter: Encounter,
    states: &[Moving<T>],
    after: T,
) -> Option<Vec<Moving<T>>> {
    let mut alone = Alone::new(world, encounter, states);
    alone.play(Some(after))?;
    Some(alone.states(states))
}

impl<'a, T: Real> Alone<'a, T> {
    /// The parties at their impact, each where it is from there on.
    fn new(world: &'a World<T>, encounter: Encounter, states: &[Moving<T>]) -> Self {
        let (balls, side) = match encounter {
            Encounter::Pair(a, b) => (vec![a, b], None),
            Encounter::Cushion(a, side) => (vec![a], Some(side)),
        };
        let zero = T::zero();
        let apart = match states {
            [one, other] => [0, 1].map(|i| other.position[i] - one.position[i]),
            _ => [zero; 2],
        };
        let parties = balls.iter().zip(states).map(|(ball, state)| {
            let mut party = Party {
                radius: world.radius[*ball],
                mass: world.mass[*ball],
                flight: Flight::new(world.ground, zero, [zero; 2], [zero; 2]),
                spin: Spin::none(),
            };
            let moving = Moving {
                position: [zero; 2],
                ..*state
            };
            party.set_off(world, zero, moving);
            party
        });
        Alone {
            world,
            parties: parties.collect(),
            side,
            apart,
            above: zero,
            now: zero,
        }
    }

    /// How the parties move now; `starts`: where they were at the first impact.
    fn states(&self, starts: &[Moving<T>]) -> Vec<Moving<T>> {
        let ends = self.parties.iter().map(|party| party.at(self.now));
        let states = ends.zip(starts).map(|(moving, start)| Moving {
            position: [0, 1].map(|i| start.position[i] + moving.position[i]),
            ..moving
        });
        states.collect()
    }

    /// Plays until the approach is rounding, or up to a time, s; answers how many impacts that took.
    fn play(&mut self, until: Option<T>) -> Option<u32> {
        let over = self.world.blur.speed * T::lift(OVER);
        let mut mark = self.closing();
        for impact in 1..=MOST_IMPACTS {
            self.hit()?;
            self.come_back(until)?;
            if until.is_some_and(|until| self.now >= until) {
                return Some(impact);
            }
            let closing = self.closing();
            if closing <= over {
                return Some(impact);
            }
            if impact % SHRINKS_WITHIN == 0 {
                if closing >= mark {
                    return None;
                }
                mark = closing;
            }
        }
        None
    }

    /// Speed at which the parties approach now.
    fn closing(&self) -> T {
        let motion = self.motion();
        match self.side {
            None => {
                let along = motion[0] * self.apart[0] + motion[1] * self.apart[1];
                let square = self.apart[0] * self.apart[0] + self.apart[1] * self.apart[1];
                -(along / square.sqrt())
            }
            Some(side) => -motion[side.axis()],
        }
    }

    /// Velocity of the second as the first sees it; towards the table's inside where there is a cushion.
    fn motion(&self) -> [T; 2] {
        let of = |party: &Party<T>| party.flight.at(self.now).1;
        self.between(of)
    }

    fn between(&self, of: impl Fn(&Party<T>) -> [T; 2]) -> [T; 2] {
        let first = of(&self.parties[0]);
        match (self.parties.get(1), self.side) {
            (Some(second), _) => {
                let second = of(second);
                [second[0] - first[0], second[1] - first[1]]
            }
            (None, Some(side)) if side.sign() > 0 => [-first[0], -first[1]],
            (None, _) => first,
        }
    }

    /// The impact of the law, now.
    fn hit(&mut self) -> Option<()> {
        let states: Vec<Moving<T>> = self.parties.iter().map(|p| p.at(self.now)).collect();
        let after: Vec<Motion<T>> = match self.side {
            Some(side) => {
                let body = self.parties[0].body(&states[0]);
                vec![cushion::impact(self.world.cushion?, &body, side).motion]
            }
            None => {
                let [x, y] = self.apart;
                let size = (x * x + y * y).sqrt();
                let n = Vector3::new(x / size, y / size, T::zero());
                let friction = self
                    .world
                    .friction
                    .filter(|_| self.world.rotation.is_some());
                let (one, other) = (
                    self.parties[0].body(&states[0]),
                    self.parties[1].body(&states[1]),
                );
                let (one, other) = contact::impact(self.world.contact?, friction, &one, &other, &n);
                vec![one, other]
            }
        };
        let now = self.now;
        for ((party, before), motion) in self.parties.iter_mut().zip(&states).zip(&after) {
            let moving = Moving {
                position: before.position,
                velocity: [motion.velocity.x, motion.velocity.y],
                spin: match self.world.rotation {
                    Some(_) => motion.spin.into(),
                    None => before.spin,
                },
            };
            party.set_off(self.world, now, moving);
        }
        self.above = T::zero();
        Some(())
    }

    /// Goes on to the next impact, through the ends of phases, or up to a time, s.
    fn come_back(&mut self, until: Option<T>) -> Option<()> {
        loop {
            let end = self
                .parties
                .iter()
                .map(|party| party.flight.end)
                .reduce(T::at_most)?;
            let end = until.map_or(end, |until| end.at_most(until));
            let within = end - self.now;
            if let Some(after) = self.meets(within) {
                self.advance(after, None);
                return Some(());
            }
            if !end.is_finite() {
                return None;
            }
            self.advance(within, Some(end));
            if until.is_some_and(|until| self.now >= until) {
                return Some(());
            }
            for party in &mut self.parties {
                if party.flight.end <= end {
                    let turned = party.spin.turn != Turn::Never || self.world.rotation.is_none();
                    if !turned {
                        return None;
                    }
                    party.turn(self.world);
                }
            }
        }
    }

    /// Moves on by `after`, s; `to`: where the clock then stands, if that is known.
    fn advance(&mut self, after: T, to: Option<T>) {
        let [c1, c2, c3, c4] = self.rise();
        self.above += after * (c1 + after * (c2 + after * (c3 + after * c4)));
        let motion = self.motion();
        let acceleration = self.between(|party| party.flight.acceleration);
        let half = T::lift(0.5);
        if self.side.is_none() {
            for i in 0..2 {
                self.apart[i] += after * (motion[i] + acceleration[i] * half * after);
            }
        }
        self.now = to.unwrap_or(self.now + after);
    }

    /// How far above contact the parties get, by powers of the time from now, from the first on.
    fn rise(&self) -> [T; 4] {
        let v = self.motion();
        let a = self.between(|party| party.flight.acceleration);
        let half = T::lift(0.5);
        match self.side {
            Some(side) => {
                let axis = side.axis();
                [v[axis], a[axis] * half, T::zero(), T::zero()]
            }
            None => {
                let dot = |a: [T; 2], b: [T; 2]| a[0] * b[0] + a[1] * b[1];
                let p = self.apart;
                [
                    dot(p, v) * T::lift(2.0),
                    dot(p, a) + dot(v, v),
                    dot(v, a),
                    dot(a, a) * half * half,
                ]
            }
        }
    }

    /// When the parties are back at contact, s from now, if that is within `within`. The times are so short that the rise is nearly a parabola:
    /// its root is where Newton's steps begin.
    fn meets(&self, within: T) -> Option<T> {
        let zero = T::zero();
        let [c1, c2, c3, c4] = self.rise();
        let c0 = self.above.at_least(zero);
        let root = c1 * c1 - c2 * c0 * T::lift(4.0);
        if root < zero || (c1 >= zero && c2 >= zero) {
            return None;
        }
        let root = root.sqrt();
        // the larger root where the parabola opens downwards, the smaller one where it opens upwards
        let mut t = if c1 >= zero {
            (c1 + root) / (-(c2 + c2))
        } else {
            (c0 + c0) / (root - c1)
        };
        for _ in 0..STEPS {
            let value = c0 + t * (c1 + t * (c2 + t * (c3 + t * c4)));
            let slope = c1 + t * (c2 + c2 + t * (c3 * T::lift(3.0) + t * c4 * T::lift(4.0)));
            let next = t - value / slope;
            let step = (next - t).abs();
            t = next;
            if step <= t.abs() * T::lift(4.0 * T::ULP) {
                break;
            }
        }
        (t > zero && t <= within).then_some(t)
    }
}
