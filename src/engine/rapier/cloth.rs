//! The cloth under balls that rotate: what rapier does of it by itself, what is added as forces, and what a step that only the
//! cloth touches leaves of a motion.
//!
//! Sliding friction is rapier's: gravity presses the ball onto a half-space with the scene's coefficient, and the solver slows
//! the ball, turns it, and holds it at rolling. Rolling resistance and the decay of spin about the vertical are not in rapier.
//! Both are applied once a step as a force at the centre and a torque, from the state at the start of the step, so they are
//! first order in the step; neither takes more than what is there, so that they stop a ball and do not reverse it. Rolling
//! resistance comes with the torque that keeps the ball rolling, so that friction has nothing to correct.

use super::run::rest_speed;
use crate::math::Vec3;
use crate::physics::cloth::rotational::{
    Coefficients, natural_roll, rolling, rolling_spin, slip_velocity, spin_deceleration,
};
use crate::physics::cloth::translational;
use crate::physics::{Cloth, Motion, State};
use crate::scene::Scene;

/// Slip speeds and spins that rapier cannot tell from zero are below this many ulp of the largest speed of the scene: its solver
/// holds the velocity of the contact point to a handful of roundings in every substep.
const ROLLING_ULPS: f64 = 64.0;

/// A force at the centre, mass * length/s^2, and a torque, mass * length^2/s^2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Load {
    pub force: Vec3,
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
    /// The cloth of a scene. `ulp`: spacing of rapier's numbers just above 1.
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

    /// True when the lowest point of the ball slips over the cloth.
    pub fn slides(&self, state: &State, radius: f64) -> bool {
        slip_velocity(&state.velocity, &state.spin, radius).norm() > self.slip_rest
    }

    /// True when the ball spins about the vertical.
    pub fn spins(&self, state: &State, radius: f64) -> bool {
        radius * state.spin.z.abs() > self.slip_rest
    }

    /// What rapier lacks, for a ball of `mass` and `radius` that is in `state` when a step of `dt` begins.
    pub fn load(&self, state: &State, mass: f64, radius: f64, dt: f64) -> Option<Load> {
        let mu = self.rotational()?;
        let inertia = crate::physics::invariants::sphere_inertia(mass, radius);
        let flat = Vec3::new(state.velocity.x, state.velocity.y, 0.0);
        let (mut acceleration, mut turn) = (Vec3::zeros(), Vec3::zeros());
        if !self.slides(state, radius) {
            let rates = rolling(&flat, &state.spin, radius, mu, self.gravity);
            let most = flat.norm() / dt;
            let share = (most / rates.acceleration.norm()).min(1.0);
            if share.is_finite() {
                acceleration = rates.acceleration * share;
                turn = rolling_spin(&acceleration, radius);
            }
        }
        let most = state.spin.z.abs() / dt;
        let decay = spin_deceleration(mu.mu_spin, self.gravity, radius).min(most);
        turn.z = -decay.copysign(state.spin.z);
        Some(Load {
            force: acceleration * mass,
            torque: turn * inertia,
        })
    }

    /// Largest change of the velocity, length/s, by the cloth in a step of `dt`.
    ///
    /// `press`: normal impulse of the cloth in that step divided by the mass, length/s.
    pub fn most_drag(&self, press: f64, dt: f64) -> f64 {
        match self.law {
            Law::None => 0.0,
            Law::Translational { drag } => drag * dt,
            Law::Rotational(mu) => mu.mu_slide * press + mu.mu_roll * self.gravity * dt,
        }
    }

    /// Motion after a step of `dt` in which only the cloth acts, from that in `state`.
    pub fn coast(&self, state: &State, radius: f64, dt: f64) -> Motion {
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
            Law::Rotational(mu) => self.roll_on(state, radius, mu, dt),
        }
    }

    /// [`Felt::coast`] of a ball that rotates: what rapier's friction and the added load would leave.
    fn roll_on(&self, state: &State, radius: f64, mu: Coefficients, dt: f64) -> Motion {
        let slip = slip_velocity(&state.velocity, &state.spin, radius);
        let (mut velocity, mut spin) = (state.velocity, state.spin);
        if let Some(load) = self.load(state, 1.0, radius, dt) {
            velocity += load.force * dt;
            let inertia = crate::physics::invariants::sphere_inertia(1.0, radius);
            spin += load.torque * (dt / inertia);
        }
        if self.slides(state, radius) {
            let ends = 3.5 * mu.mu_slide * self.gravity * dt >= slip.norm();
            if ends {
                velocity = natural_roll(&velocity, &slip);
                let z = spin.z;
                spin = rolling_spin(&velocity, radius);
                spin.z = z;
            } else {
                let push = slip * (-mu.mu_slide * self.gravity * dt / slip.norm());
                velocity += push;
                let turn = 2.5 / radius;
                spin += Vec3::new(turn * push.y, -turn * push.x, 0.0);
            }
        }
        Motion { velocity, spin }
    }
}

/// Slip speed, and surface speed by spin about the vertical, at or below which there is none, length/s: the speed below which a
/// ball counts as stopped, or what rounding leaves where that is more.
pub(super) fn slip_rest(scene: &Scene, ulp: f64) -> f64 {
    rest_speed(scene).max(ROLLING_ULPS * ulp * top_speed(scene))
}

/// An upper bound of the speeds that a scene starts with, length/s: of centres, and of surfaces where balls rotate.
pub(super) fn top_speed(scene: &Scene) -> f64 {
    let rotates = scene.effects.rotates();
    let surface = |ball: &crate::scene::Ball| {
        let turning = if rotates {
            ball.radius * ball.state.spin.norm()
        } else {
            0.0
        };
        ball.state.speed() + turning
    };
    scene.balls.iter().map(surface).fold(0.0, f64::max)
}
