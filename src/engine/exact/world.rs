//! What stays the same during a run: balls, edges and laws in the scalar of the run, and what that scalar can tell apart.

use super::flight::{Flight, Ground};
use super::spin::{Moving, Rotation, Spin};
use crate::math::Real;
use crate::math::first_root::Blur;
use crate::physics::contact::plan_distance;
use crate::physics::{Contact, Cushion, Effects, Friction, Side};
use crate::scene::Scene;

/// Roundings that a coordinate has seen when it enters a decision: two products, two sums.
const ROUNDINGS: f64 = 4.0;

/// Surfaces that touch by a scalar's own account are this many errors of a position apart, at most.
const RESOLVED: f64 = 16.0;

/// What turns while it ends is over at this many roundings of the speeds of its balls.
const OVER: f64 = 64.0;

/// Rounding will soon say how impacts go on when an approach is this many times what it makes of one.
const NOISE: f64 = 100.0;

/// Impacts faster than this part of the fastest ball are none of those that shrink.
pub const SHRINKS: f64 = 1e-3;

/// The unchanging part of a run. Inputs are the scene's f64 numbers lifted exactly; what follows from them is computed in `T`.
#[derive(Clone, Debug)]
pub struct World<T> {
    /// Radii, length.
    pub radius: Vec<T>,
    /// Masses.
    pub mass: Vec<T>,
    /// Where a centre may be: for each ball the limits at x0, x1, y0, y1. Empty without cushions.
    pub reach: Vec<[T; 4]>,
    /// Where the centre of every ball may be: the same limits for the largest. `None` without cushions.
    pub within_all_reach: Option<[T; 4]>,
    /// The cloth under balls that do not turn.
    pub ground: Ground<T>,
    /// The cloth under balls that do; `None` in a scene that does not call for rotation.
    pub rotation: Option<Rotation<T>>,
    /// The law of ball-ball impacts; without one, balls pass through each other.
    pub contact: Option<Contact<T>>,
    /// Friction between balls that meet.
    pub friction: Option<Friction<T>>,
    /// The law of cushions.
    pub cushion: Option<Cushion<T>>,
    /// Change of the restitution of elastic balls, and of elastic cushions: 0 with its derivatives.
    pub restitution: [T; 2],
    /// Whether derivatives are those of errors, for which any of several that there are will do.
    pub estimates: bool,
    /// Pockets: x, y and radius.
    pub pockets: Vec<[T; 3]>,
    /// Contact distance if all radii are equal.
    same_distance: Option<T>,
    /// Gap within which surfaces touch, length.
    pub touching: T,
    /// Simulated time, s.
    pub duration: T,
    /// Largest coordinate that a centre can have, length.
    pub extent: f64,
    /// What positions and velocities are good to.
    pub blur: Blur<T>,
    /// No ball is ever faster, length/s: all energy in the lightest.
    pub fastest: T,
    /// What a stretch of contact may leave out, in parts of the largest speed.
    pub accuracy: f64,
    /// The longest stretch of contact, s.
    pub longest: T,
    /// A slip or a speed that is no more than this is none to a contact, length/s.
    pub none: T,
}

/// What a run tells that another takes over from.
#[derive(Clone, Copy, Debug)]
pub struct Coarser<T> {
    /// The spacing of its numbers.
    pub ulp: f64,
    /// What rounding of a gap makes of an approach there, length/s.
    pub noise: T,
    /// The time, s, for which a contact is followed at once.
    pub longest: T,
}

/// No part of the fastest speed is told below this.
const FAINT: f64 = 1e-130;

/// An approach is nothing to a run if it is no more than this part of what rounding makes of one.
pub const NONE: f64 = 1e-4;

impl<T: Real> World<T> {
    /// The world of a scene.
    pub fn new(scene: &Scene) -> Self {
        let lift = T::lift;
        let reach = |radius: T| {
            scene.table.map(|table| {
                Side::ALL.map(|side| {
                    let axis = side.axis();
                    if side.sign() < 0 {
                        lift(table.min[axis]) + radius
                    } else {
                        lift(table.max[axis]) - radius
                    }
                })
            })
        };
        let radius: Vec<T> = scene.balls.iter().map(|b| lift(b.radius)).collect();
        let bounded = scene.effects.cushion.is_some();
        let fastest = scene.fastest();
        let effects = scene.effects.lift();
        let ground = Ground::new(&effects, lift(scene.gravity));
        let extent = scene.farthest_coordinate();
        let largest = radius.iter().copied().fold(T::zero(), T::at_least);
        World {
            within_all_reach: reach(largest).filter(|_| bounded),
            mass: scene.balls.iter().map(|b| lift(b.mass)).collect(),
            reach: if bounded {
                radius.iter().filter_map(|r| reach(*r)).collect()
            } else {
                Vec::new()
            },
            ground,
            rotation: Rotation::new(&effects, lift(scene.gravity)),
            contact: effects.contact,
            friction: effects.friction,
            cushion: effects.cushion,
            restitution: [T::zero(); 2],
            estimates: false,
            pockets: effects
                .pockets
                .map_or_else(Vec::new, |pockets| pockets.circles),
            same_distance: scene
                .equal_radii()
                .then(|| plan_distance(radius[0], radius[0])),
            radius,
            touching: lift(scene.touching()),
            duration: lift(scene.duration),
            extent,
            blur: Blur {
                length: lift(ROUNDINGS * T::ULP * extent),
                speed: lift(2.0 * ROUNDINGS * T::ULP * fastest),
            },
            fastest: lift(fastest),
            accuracy: T::ULP,
            longest: lift(f64::INFINITY),
            none: T::zero(),
        }
    }

    /// The same for a run that takes over from another: surfaces touch as far as this scalar tells, and what is nothing to the other run is none.
    pub fn taking_over(self, from: &Coarser<T>) -> Self {
        let noise = from.noise.at_most(self.fastest * T::lift(SHRINKS));
        World {
            touching: self.blur.length * T::lift(RESOLVED),
            accuracy: T::ULP.max(from.ulp * from.ulp.sqrt()),
            longest: from.longest,
            none: (noise * T::lift(NONE)).at_least(self.blurs()),
            ..self
        }
    }

    /// The same with laws whose numbers have derivatives.
    pub fn with_laws(self, effects: &Effects<T>, gravity: f64, restitution: [T; 2]) -> Self {
        let gravity = T::lift(gravity);
        World {
            ground: Ground::new(effects, gravity),
            rotation: Rotation::new(effects, gravity),
            contact: effects.contact,
            friction: effects.friction,
            cushion: effects.cushion,
            restitution,
            ..self
        }
    }

    /// Distance of the centres of two balls at contact, seen in plan.
    #[inline]
    pub fn distance(&self, a: usize, b: usize) -> T {
        match self.same_distance {
            Some(distance) => distance,
            None => plan_distance(self.radius[a], self.radius[b]),
        }
    }

    /// The largest distance of two centres at contact.
    pub fn widest_distance(&self) -> f64 {
        let largest = self.radius.iter().copied().fold(T::zero(), T::at_least);
        plan_distance(largest, largest).to_f64()
    }

    /// The largest acceleration that the cloth gives; without one, that of a ball turned round by another, length/s^2.
    pub fn strongest(&self) -> T {
        match (self.rotation, self.ground) {
            (Some(rotation), _) if rotation.slide > T::zero() => rotation.slide,
            (_, Ground::Coulomb(deceleration)) => deceleration,
            _ => self.fastest * self.fastest / T::lift(self.widest_distance()),
        }
    }

    /// The larger of a ball's speed and that of its surface about its centre, length/s.
    pub fn loudness(&self, ball: usize, moving: &Moving<T>) -> T {
        let square = |parts: &[T]| parts.iter().fold(T::zero(), |sum, x| sum + *x * *x);
        let (speed, turn) = (square(&moving.velocity), square(&moving.spin));
        speed.sqrt().at_least(turn.sqrt() * self.radius[ball])
    }

    /// What rounding makes of speeds of this size, length/s.
    pub fn grain(&self, speed: T) -> T {
        speed * T::lift(2.0 * ROUNDINGS * T::ULP)
    }

    /// What rounding makes of the rate of a gap between parties of this speed: that of the normal, too, which the places give.
    pub fn grain_of_rate(&self, speed: T, distance: T) -> T {
        self.grain(speed) + speed * (self.blur.length / distance)
    }

    /// A speed that moves nobody by anything that any of the scalars can tell, and whose square is still a number, length/s.
    pub fn faint(&self) -> T {
        self.fastest * T::lift(T::ULP.powi(4).max(FAINT))
    }

    /// A slip or a speed that turns while it ends, in contact, of balls of this speed is over when it is no more than this, length/s.
    pub fn over(&self, speed: T) -> T {
        (self.grain(speed) * T::lift(OVER * (self.accuracy / T::ULP))).at_least(self.none)
    }

    /// What rounding of a gap makes of an approach, length/s.
    pub fn noise(&self) -> T {
        (self.blur.length * self.strongest() * T::lift(2.0)).sqrt()
    }

    /// The speed of an approach below which rounding will soon say how impacts go on that shrink, length/s.
    pub fn blurs(&self) -> T {
        (self.noise() * T::lift(NOISE)).at_most(self.fastest * T::lift(SHRINKS))
    }

    /// Whether the cloth may press balls together.
    pub fn presses(&self) -> bool {
        match (&self.rotation, self.ground) {
            (Some(rotation), _) => rotation.slide > T::zero(),
            (None, Ground::Coulomb(_)) => true,
            (None, Ground::Frictionless) => false,
        }
    }

    /// What the place of a ball is good to at a time that is itself rounded, length.
    pub fn position_uncertainty(&self) -> f64 {
        let clock = T::ULP * self.duration.to_f64();
        self.blur.length.to_f64() + ROUNDINGS * clock * self.fastest.to_f64()
    }

    /// What all balls do at time 0: flights, and spins where the scene calls for rotation.
    pub fn first_flights(&self, scene: &Scene) -> (Vec<Flight<T>>, Vec<Spin<T>>) {
        let starts = 0..scene.balls.len();
        let states = starts.map(|ball| Moving::lifted(&scene.start(ball)));
        match &self.rotation {
            None => {
                let flight =
                    |m: Moving<T>| Flight::new(self.ground, T::zero(), m.position, m.velocity);
                (states.map(flight).collect(), Vec::new())
            }
            Some(rotation) => {
                let depart = |(moving, radius): (Moving<T>, &T)| {
                    let meant = rotation.as_meant(*radius, moving);
                    rotation.depart(*radius, T::zero(), meant)
                };
                states.zip(&self.radius).map(depart).unzip()
            }
        }
    }

    /// Error of the time of an impact at time `t` with normal speed `speed`: that of the positions, and an ulp of the clock.
    pub fn time_error(&self, t: T, speed: T) -> T {
        self.blur.length / speed + t * T::lift(2.0 * T::ULP)
    }
}
