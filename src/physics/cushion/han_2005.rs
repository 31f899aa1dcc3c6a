//! Cushion with a nose at height h and friction: I. Han, "Dynamics in carom and three cushion billiards", Journal of Mechanical
//! Science and Technology 19 (2005), 976-984, with the slip condition as published corrected to that of a solid sphere.

use super::{facing, nose, turned_back};
use crate::math::Real;
use crate::physics::{Body, Motion, Side};
use nalgebra::Vector3;

/// Motion of a ball after it meets the cushion `side`. `[e, mu, height]`: restitution, friction, height of the nose in radii.
///
/// With x into the cushion, `sin th = height - 1` and `N = (cos th, 0, sin th)` from the centre to the nose, per unit of mass:
/// normal impulse `P = (1 + e) v_x cos th` along `-N`; slip `u = v + R w x N` without its part along `N`; tangential impulse
/// `min(mu P, 2/7 |u|)` against `u`; the spin changes by `5 / (2 R) N x J`. The vertical velocity is kept for the cloth to take.
///
/// Without slip `v_x' = v_x (1 - (1 + e) cos^2 th)` in plan: where `cos^2 th < 1 / (1 + e)` the law lets a ball go on into the cushion,
/// more slowly. A pool cushion (`height` 1.28, `cos^2 th` .92) is far from that.
pub fn impact<T: Real>([e, mu, height]: [T; 3], ball: &Body<T>, side: Side) -> Motion<T> {
    let (v, w) = (facing(side, &ball.velocity), facing(side, &ball.spin));
    let (sin, cos) = nose(height);
    let n = Vector3::new(cos, T::zero(), sin);
    let closing = v.dot(&n);
    let normal = (T::one() + e) * closing;
    let slip = v - n * closing + w.cross(&n) * ball.radius;
    let speed = slip.dot(&slip).sqrt();
    let sticking = T::lift(2.0) / T::lift(7.0);
    let limit = mu * normal;
    let push = if limit < sticking * speed {
        slip * (-(limit / speed))
    } else {
        slip * -sticking
    };
    let turn = n.cross(&push) * (T::lift(2.5) / ball.radius);
    Motion {
        velocity: turned_back(side, &(v - n * normal + push)),
        spin: turned_back(side, &(w + turn)),
    }
}
