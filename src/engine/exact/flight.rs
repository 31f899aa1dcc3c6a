//! A ball between two events: where it is and how it moves at any time, in closed form.
//!
//! Under every cloth law a ball between events has constant acceleration and constant spin rate, so one type serves all
//! of them; a law is matched once, when a flight begins. The closed forms are written here from the laws themselves and never
//! call the rates of `physics::cloth`, so that the two can be held against each other.

use crate::math::Real;
use crate::physics::{Cloth, Effects, State};
use nalgebra::Vector3;

/// What a ball does until its flight ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// At rest until something hits it.
    Rest,
    /// Constant velocity for ever: there is no cloth.
    Free,
    /// Slides along a line and comes to rest at the end of the flight.
    Slide,
}

/// A ball between two events. Times are absolute, s; x and y in the plane of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flight<T> {
    /// When it began: the time of the ball's last event.
    pub start: T,
    /// When the phase ends by itself; infinite if it does not.
    pub end: T,
    /// Centre at `start`.
    pub position: [T; 2],
    /// Velocity at `start`.
    pub velocity: [T; 2],
    /// Constant acceleration until `end`.
    pub acceleration: [T; 2],
    /// Largest speed of the flight.
    pub fastest: T,
    /// What the ball does.
    pub phase: Phase,
}

/// The cloth in closed form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ground<T> {
    /// No cloth, or one without friction.
    Frictionless,
    /// Coulomb friction on the centre: this deceleration, length/s^2, along the velocity.
    Coulomb(T),
}

impl<T: Real> Ground<T> {
    /// The cloth of a scene. `gravity` in length/s^2.
    pub fn new(effects: &Effects<T>, gravity: T) -> Self {
        match effects.cloth {
            Some(Cloth::Translational { mu }) if mu * gravity > T::zero() => {
                Ground::Coulomb(mu * gravity)
            }
            Some(Cloth::Translational { .. }) | None => Ground::Frictionless,
        }
    }
}

impl<T: Real> Flight<T> {
    /// The flight of a ball from `position` with `velocity` at time `start`.
    pub fn new(ground: Ground<T>, start: T, position: [T; 2], velocity: [T; 2]) -> Self {
        let zero = T::zero();
        let at_rest = Flight {
            start,
            end: T::lift(f64::INFINITY),
            position,
            velocity: [zero; 2],
            acceleration: [zero; 2],
            fastest: zero,
            phase: Phase::Rest,
        };
        let square = velocity[0] * velocity[0] + velocity[1] * velocity[1];
        // also a speed whose square is too small for the scalar: it moves nothing in any time
        if square == zero {
            return at_rest;
        }
        let speed = square.sqrt();
        let moving = Flight {
            velocity,
            fastest: speed,
            phase: Phase::Free,
            ..at_rest
        };
        match ground {
            Ground::Frictionless => moving,
            Ground::Coulomb(deceleration) => {
                let duration = speed / deceleration;
                Flight {
                    end: start + duration,
                    acceleration: [-velocity[0] / duration, -velocity[1] / duration],
                    phase: Phase::Slide,
                    ..moving
                }
            }
        }
    }

    /// True while the centre moves.
    pub fn moves(&self) -> bool {
        self.phase != Phase::Rest
    }

    /// Centre and velocity at time `t`, `start <= t <= end`.
    #[inline]
    pub fn at(&self, t: T) -> ([T; 2], [T; 2]) {
        let h = t - self.start;
        let half = h * T::lift(0.5);
        let along =
            |i: usize| self.position[i] + h * (self.velocity[i] + self.acceleration[i] * half);
        let speed = |i: usize| self.velocity[i] + self.acceleration[i] * h;
        ([along(0), along(1)], [speed(0), speed(1)])
    }

    /// Centre at the end of a flight that ends by itself, where the velocity is exactly zero.
    pub fn rest_position(&self) -> [T; 2] {
        let half = (self.end - self.start) * T::lift(0.5);
        [0, 1].map(|i| self.position[i] + self.velocity[i] * half)
    }
}

/// A state in f64, at height `z`, from centre and velocity in the plane. No law that is built turns balls.
pub fn state<T: Real>(position: [T; 2], velocity: [T; 2], z: f64, spin: Vector3<f64>) -> State {
    State {
        position: Vector3::new(position[0].to_f64(), position[1].to_f64(), z),
        velocity: Vector3::new(velocity[0].to_f64(), velocity[1].to_f64(), 0.0),
        spin,
    }
}
