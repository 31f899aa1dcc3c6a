//! A ball between two events: where it is and how it moves at any time, in closed form.
//!
//! Under every cloth law a ball between events has constant acceleration and constant spin rate, so one type serves all
//! of them; a law is matched once, when a flight begins. The closed forms are written here from the laws themselves and never
//! call the rates of `physics::cloth`, so that the two can be held against each other.

use crate::math::Real;
use crate::physics::{Cloth, Effects};

/// What a ball does until its flight ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// At rest until something hits it.
    Rest,
    /// Constant velocity for ever: there is no cloth.
    Free,
    /// Slides along a line and comes to rest at the end of the flight.
    Slide,
    /// Slides or rolls over a cloth that turns it: constant acceleration, whatever its direction and whatever comes after.
    Curve,
    /// Held by contacts: how it moves is for its group to say, until the end of the flight.
    Held,
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

/// The cloth in closed form, under balls that do not turn.
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
            // what turns balls has flights of its own, see `spin`
            Some(Cloth::Translational { .. } | Cloth::Rotational { .. }) | None => {
                Ground::Frictionless
            }
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

    /// The same flight with the derivatives of another.
    pub fn following(self, other: &Self) -> Self {
        let plane = |own: [T; 2], other: [T; 2]| [0, 1].map(|i| own[i].following(other[i]));
        Flight {
            start: self.start.following(other.start),
            end: self.end.following(other.end),
            position: plane(self.position, other.position),
            velocity: plane(self.velocity, other.velocity),
            acceleration: plane(self.acceleration, other.acceleration),
            ..self
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

    /// The same as [`Flight::at`], without arithmetic at the start.
    #[inline]
    pub fn from(&self, t: T) -> ([T; 2], [T; 2]) {
        if t == self.start {
            (self.position, self.velocity)
        } else {
            self.at(t)
        }
    }

    /// Centre at the end of a flight that ends by itself, where the velocity is exactly zero.
    pub fn rest_position(&self) -> [T; 2] {
        let half = (self.end - self.start) * T::lift(0.5);
        [0, 1].map(|i| self.position[i] + self.velocity[i] * half)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::cloth::translational::{deceleration, stop_distance, stop_time};

    const MU: f64 = 0.2;
    const G: f64 = 9.81;

    fn flight(velocity: [f64; 2]) -> Flight<f64> {
        let effects = Effects {
            cloth: Some(Cloth::Translational { mu: MU }),
            ..Effects::default()
        };
        Flight::new(Ground::new(&effects, G), 1.0, [3.0, 4.0], velocity)
    }

    #[test]
    fn its_derivative_is_the_rate_of_the_cloth_law() {
        for velocity in [[3.0, 0.0], [-1.0, 2.0], [0.3, -7.0]] {
            let flight = flight(velocity);
            let h = 1e-3;
            for part in [0.01, 0.3, 0.7, 0.99] {
                let t = flight.start + part * (flight.end - flight.start - h);
                let ((p0, v0), (p1, v1)) = (flight.at(t), flight.at(t + h));
                let speed = v0[0].hypot(v0[1]);
                for axis in 0..2 {
                    let rate = -deceleration(MU, G) * v0[axis] / speed;
                    let found = (v1[axis] - v0[axis]) / h;
                    // the difference of two numbers of size v, divided by h
                    let rounding = 8.0 * f64::EPSILON * 10.0 / h;
                    assert!(
                        (found - rate).abs() <= rounding,
                        "{velocity:?} at {t}: {found} instead of {rate}"
                    );
                    // constant acceleration: the mean of both velocities is exact
                    let mean = 0.5 * (v0[axis] + v1[axis]);
                    assert!(((p1[axis] - p0[axis]) / h - mean).abs() <= rounding);
                }
            }
        }
    }

    #[test]
    fn it_ends_where_the_law_says_with_no_velocity_left() {
        let flight = flight([3.0, -4.0]);
        assert!((flight.end - 1.0 - stop_time(5.0, MU, G)).abs() < 1e-15);
        let rest = flight.rest_position();
        let distance = (rest[0] - 3.0).hypot(rest[1] - 4.0);
        assert!((distance - stop_distance(5.0, MU, G)).abs() < 1e-14);
        let (position, velocity) = flight.at(flight.end);
        assert!((position[0] - rest[0]).hypot(position[1] - rest[1]) < 1e-14);
        assert!(velocity[0].hypot(velocity[1]) < 1e-14);
    }

    #[test]
    fn without_friction_it_never_ends() {
        for ground in [
            Ground::<f64>::Frictionless,
            Ground::new(
                &Effects {
                    cloth: Some(Cloth::Translational { mu: 0.0 }),
                    ..Effects::default()
                },
                G,
            ),
        ] {
            let flight = Flight::new(ground, 0.0, [0.0, 0.0], [1.0, 2.0]);
            assert_eq!((flight.phase, flight.end), (Phase::Free, f64::INFINITY));
            assert_eq!(flight.at(10.0), ([10.0, 20.0], [1.0, 2.0]));
        }
    }
}
