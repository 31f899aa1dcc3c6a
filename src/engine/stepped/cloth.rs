//! The cloth under balls that rotate: what an engine does of it by itself, what is added as loads, and what a step that only the
//! cloth touches leaves of a motion.
//!
//! Sliding friction is the engine's: gravity presses the ball onto a plane with the scene's coefficient, and the solver slows
//! the ball, turns it, and holds it at rolling. Rolling resistance and the decay of spin about the vertical are in few engines.
//! Both are applied once a step as a force at the centre and a torque, from the state at the start of the step, so they are
//! first order in the step; neither takes more than what is there, so that they stop a ball and do not reverse it. Rolling
//! resistance comes with the torque that keeps the ball rolling, so that friction has nothing to correct.

use super::rest::slip_rest;
use crate::math::Vec3;
use crate::physics::cloth::rotational::{
    Coefficients, rolling, rolling_spin, slip_velocity, spin_deceleration,
};
use crate::physics::cloth::translational;
use crate::physics::invariants::sphere_inertia;
use crate::physics::{Cloth, Motion, State};
use crate::scene::Scene;

/// What acts on a ball besides the engine's own forces: a force at its centre, and a torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// mass * length/s^2.
    pub force: Vec3,
    /// mass * length^2/s^2.
    pub torque: Vec3,
}

impl Load {
    /// Nothing acts.
    pub const NONE: Load = Load {
        force: Vec3::new(0.0, 0.0, 0.0),
        torque: Vec3::new(0.0, 0.0, 0.0),
    };
}

/// The scene's cloth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Felt {
    law: Law,
    gravity: f64,
    slip_rest: f64,
}

#[derive(Clone, Copy, Debug)]
enum Law {
    None,
    Translational { drag: f64 },
    Rotational(Coefficients),
}

impl Felt {
    /// The cloth of a scene. `ulp`: spacing of the engine's numbers just above 1.
    pub fn new(scene: &Scene, ulp: f64) -> Self {
        let gravity = scene.gravity;
        let law = match scene.effects.cloth {
            None => Law::None,
            Some(Cloth::Translational { mu }) => Law::Translational {
                drag: translational::deceleration(mu, gravity),
            },
            Some(Cloth::Rotational {
                mu_slide,
                mu_roll,
                mu_spin,
            }) => Law::Rotational(Coefficients {
                mu_slide,
                mu_roll,
                mu_spin,
            }),
        };
        Felt {
            law,
            gravity,
            slip_rest: slip_rest(scene, ulp),
        }
    }

    /// The numbers of the law under which balls rotate, where the scene has one.
    pub fn rotational(&self) -> Option<Coefficients> {
        match self.law {
            Law::Rotational(mu) => Some(mu),
            Law::None | Law::Translational { .. } => None,
        }
    }

    /// True when the ball slips over the cloth at the end of a step. `lever`: of the state in which that step began.
    pub fn slides(&self, state: &State, lever: f64) -> bool {
        slip_velocity(&state.velocity, &state.spin, lever).norm() > self.slip_rest
    }

    /// True when the ball spins about the vertical.
    pub fn spins(&self, state: &State, radius: f64) -> bool {
        radius * state.spin.z.abs() > self.slip_rest
    }

    /// What an engine may lack, for a ball of `mass` and `radius` that is in `state` when a step of `dt` begins.
    pub fn load(&self, state: &State, slides: bool, mass: f64, radius: f64, dt: f64) -> Load {
        let Some(mu) = self.rotational() else {
            return Load::NONE;
        };
        let (mut acceleration, mut turn) = (Vec3::zeros(), Vec3::zeros());
        let flat = Vec3::new(state.velocity.x, state.velocity.y, 0.0);
        let speed = flat.norm();
        if !slides && speed > 0.0 {
            acceleration = rolling(&flat, &state.spin, radius, mu, self.gravity).acceleration;
            // not more than there is
            acceleration *= (speed / (acceleration.norm() * dt)).min(1.0);
            turn = rolling_spin(&acceleration, lever(state, radius));
        }
        let decay = spin_deceleration(mu.mu_spin, self.gravity, radius);
        turn.z = -decay.min(state.spin.z.abs() / dt).copysign(state.spin.z);
        Load {
            force: acceleration * mass,
            torque: turn * sphere_inertia(mass, radius),
        }
    }

    /// Largest mean deceleration by the cloth in a step of `dt`, length/s^2.
    ///
    /// `press`: normal impulse of the cloth in that step divided by the mass, length/s.
    pub fn most_drag(&self, press: f64, dt: f64) -> f64 {
        match self.law {
            Law::None => 0.0,
            Law::Translational { drag } => drag,
            Law::Rotational(mu) => mu.mu_slide * press / dt + mu.mu_roll * self.gravity,
        }
    }

    /// Motion after a step of `dt` in which only the cloth acts, from that in `state`.
    pub fn coast(&self, state: &State, slides: bool, radius: f64, dt: f64) -> Motion {
        let velocity = &state.velocity;
        match self.law {
            Law::None => Motion {
                velocity: *velocity,
                spin: state.spin,
            },
            Law::Translational { drag } => {
                let speed = velocity.xy().norm();
                let lost = drag * dt;
                Motion {
                    velocity: if speed <= lost {
                        Vec3::zeros()
                    } else {
                        velocity * (1.0 - lost / speed)
                    },
                    spin: state.spin,
                }
            }
            Law::Rotational(mu) => self.turn_on(state, slides, radius, mu, dt),
        }
    }

    /// [`Felt::coast`] of a ball that rotates: what the engine's friction and the added load leave.
    fn turn_on(
        &self,
        state: &State,
        slides: bool,
        radius: f64,
        mu: Coefficients,
        dt: f64,
    ) -> Motion {
        let arm = lever(state, radius);
        let load = self.load(state, slides, 1.0, radius, dt);
        let mut velocity = state.velocity + load.force * dt;
        let mut spin = state.spin + load.torque * (dt / sphere_inertia(1.0, radius));
        if slides {
            let slip = slip_velocity(&velocity, &spin, arm);
            // what friction can take, or what ends the slip
            let most = mu.mu_slide * self.gravity * dt / slip.norm();
            let needed = 1.0 / (1.0 + 2.5 * (arm / radius).powi(2));
            let push = slip * -most.min(needed);
            velocity += push;
            let turn = 2.5 * arm / (radius * radius);
            spin += Vec3::new(turn * push.y, -turn * push.x, 0.0);
        }
        Motion { velocity, spin }
    }
}

/// Distance from the centre to the point at which friction acts on a ball, length.
///
/// Where the cloth is a soft constraint, a ball lies deep in it: by `g / (2 pi f)^2` in one of natural frequency `f`, whatever the
/// step. The point is then halfway between the cloth and the lowest point of the ball, which rolls on a lever that is shorter by half
/// of that depth than its radius. Slip is what the engine holds at zero, so it is taken at this point.
pub(super) fn lever(state: &State, radius: f64) -> f64 {
    0.5 * (radius + state.position.z.min(radius))
}

/// True when a ball is clear of the cloth.
pub(super) fn is_aloft(state: &State, radius: f64) -> bool {
    // a position in f32 rounds by 1e-7 at most
    state.position.z > radius * (1.0 + 1e-6)
}
