//! Impulses of ball-cushion impacts. One file per law.

pub mod elastic;

use super::{Body, Cushion, Motion, Side};
use crate::math::Real;

/// Motion of a ball after it meets the cushion `side`, moving outward.
pub fn impact<T: Real>(law: Cushion, ball: &Body<T>, side: Side) -> Motion<T> {
    match law {
        Cushion::Elastic {} => elastic::impact(ball, side),
    }
}
