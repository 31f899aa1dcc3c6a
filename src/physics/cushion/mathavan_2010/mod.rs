//! Cushion with a nose at height h and friction at the cushion and at the cloth, integrated through the impact.
//!
//! Source: S. Mathavan, M. R. Jackson, R. M. Parkin, "A theoretical analysis of billiard ball dynamics under cushion impacts",
//! Proc. IMechE C 224 (2010), 1863-1873. It has no closed form. It runs in f64 (in dual numbers where derivatives are asked for)
//! and states what its result may be off by.
//!
//! Per unit of mass, x into the cushion, y along it, z up, `sin th = height - 1`: the independent variable is the normal impulse
//! `P` at the nose, along `-N = -(cos th, 0, sin th)`. Friction at the nose, at most `mu dP`, acts against the slip there; friction
//! at the cloth, at most `mu_cloth dQ`, against the slip there, where `dQ >= 0` is the impulse of the cloth that keeps the ball from
//! moving down. Compression ends when `v_x = 0`; restitution when the work returned, `dW = |v_x| cos th dP`, is `e^2` times
//! that of compression.
//!
//! Where a slip ends the paper's fixed steps make it chatter about zero. The limit of small steps is Coulomb's law: the contact
//! sticks with whatever friction holds it while that is within its limit, and slips again where it is not. So each contact
//! has modes (`contacts`), and a step of the integration (`integration`) stays in them.

mod contacts;
mod integration;

use super::{Rebound, facing, turned_back};
use crate::math::Real;
use crate::physics::{Body, Motion, Side};
use integration::{Accuracy, rebound};
use nalgebra::Vector3;

/// Motion of a ball after it meets the cushion `side`. `[e, mu, mu_cloth, height]`: restitution of work, friction at the nose
/// and at the cloth, height of the nose in radii.
pub fn impact<T: Real>(numbers: [T; 4], ball: &Body<T>, side: Side) -> Rebound<T> {
    let (v, w) = (facing(side, &ball.velocity), facing(side, &ball.spin));
    let surface = w * ball.radius;
    let start = [v.x, v.y, surface.x, surface.y, surface.z];
    let plain = (numbers.map(T::to_f64), start.map(T::to_f64));
    let (end, error) = rebound(plain.0, plain.1, Accuracy::F64);
    let mut end = end.map(T::lift);
    if T::DIFFERENTIATES {
        // the numbers are those of a run without derivatives
        let (moving, _) = rebound(numbers, start, Accuracy::F64);
        for (end, moving) in end.iter_mut().zip(moving) {
            *end = end.following(moving);
        }
    }
    let [vx, vy, sx, sy, sz] = end;
    let spin = Vector3::new(sx, sy, sz) / ball.radius;
    let motion = Motion {
        velocity: turned_back(side, &Vector3::new(vx, vy, T::zero())),
        spin: turned_back(side, &spin),
    };
    Rebound { motion, error }
}
