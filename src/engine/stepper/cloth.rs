//! What the cloth does in one step. It acts on every ball in every step, so it is the stepper's one type parameter.

use crate::physics::cloth::translational;
use crate::physics::{Cloth, Effects};

/// The report's friction step for the effects of a scene.
pub trait ClothStep {
    /// Speed after one step, length/s, for a ball of the given mass. At or below zero the ball stops.
    fn slowed(&self, speed: f64, mass: f64) -> f64;

    /// False when the cloth never changes a speed.
    const ACTS: bool;
}

/// Free flight.
#[derive(Clone, Copy, Debug)]
pub struct NoCloth;

impl ClothStep for NoCloth {
    const ACTS: bool = false;
    fn slowed(&self, speed: f64, _mass: f64) -> f64 {
        speed
    }
}

/// `v <- (-mu g m dt + m v) / m`, to the letter: the mass is divided out after the sum, as the report does it.
#[derive(Clone, Copy, Debug)]
pub struct Translational {
    mu: f64,
    /// mu g, length/s^2.
    deceleration: f64,
    dt: f64,
}

impl Translational {
    /// The coefficient of friction.
    pub fn mu(&self) -> f64 {
        self.mu
    }
}

impl ClothStep for Translational {
    const ACTS: bool = true;
    fn slowed(&self, speed: f64, mass: f64) -> f64 {
        (-self.deceleration * mass * self.dt + mass * speed) / mass
    }
}

/// The scene's cloth as a step of length `dt`, or `None` where nothing slows a ball.
pub fn translational(effects: &Effects, gravity: f64, dt: f64) -> Option<Translational> {
    match effects.cloth {
        Some(Cloth::Translational { mu }) => Some(Translational {
            mu,
            deceleration: translational::deceleration(mu, gravity),
            dt,
        }),
        // not built; `missing` names it
        Some(Cloth::Rotational { .. }) | None => None,
    }
}
