//! The cushion of Mathavan 2010 a second time, in equal small steps of the push at the nose: first order, and as plain as can be.
//!
//! In each step friction takes, at each of the two contacts, its limit or what would end the slip there, whichever is less. The error
//! falls with the step, so that twice as many steps tell it.

use super::facing::{Facing, nose};
use crate::math::Vec3;

/// Steps of the push that would stop the ball if only the nose pushed; half as many in the run that tells the error.
const STEPS: u32 = 4000;

/// The push after which nothing settles any more, in that one.
const MOST: u32 = 20;

/// Difference of both runs, in the size of the motion, above which they do not tell an error.
const UNSETTLED: f64 = 0.02;

/// An error of first order is the difference of the two runs; what is not so smooth may be some times as large.
const TIMES: f64 = 8.0;

/// A speed into the cushion below this part of the motion leaves too little of a push to be told from its error.
const SLOW: f64 = 1e-3;

/// The motion after the impact and what each of its numbers may be off by; `None` where that is not known. `numbers`: as of the law.
pub(super) fn rebound(motion: Facing, numbers: [f64; 4]) -> Option<(Facing, f64)> {
    let size = motion.velocity.norm() + motion.surface.norm();
    let scaled = Facing {
        velocity: motion.velocity / size,
        surface: motion.surface / size,
    };
    if scaled.velocity.x < SLOW {
        return None;
    }
    let coarse = run(scaled, numbers, STEPS / 2)?;
    let fine = run(scaled, numbers, STEPS)?;
    let change = (fine.velocity - coarse.velocity).norm() + (fine.surface - coarse.surface).norm();
    // one step moves each number by no more than a few of its pushes
    let step = 8.0 / f64::from(STEPS) * scaled.velocity.x;
    let error = TIMES * change + step;
    let far = Facing {
        velocity: fine.velocity * size,
        surface: fine.surface * size,
    };
    (change < UNSETTLED).then_some((far, error * size))
}

fn run(motion: Facing, [e, mu, mu_cloth, height]: [f64; 4], steps: u32) -> Option<Facing> {
    let (sin, cos) = nose(height);
    let Facing {
        mut velocity,
        mut surface,
    } = motion;
    let push = velocity.x / cos / f64::from(steps);
    let (mut work, mut compressed) = (0.0, None);
    for _ in 0..MOST * steps {
        let before = velocity.x;
        let goal = compressed.map(|whole: f64| e * e * whole);
        if goal.is_some_and(|goal| work >= goal) {
            return Some(Facing { velocity, surface });
        }
        // at the nose: along the cushion, and from below over it
        let nose = [
            velocity.y + surface.z * cos - surface.x * sin,
            -(velocity.x * sin) - surface.y,
        ];
        let [y, q] = rubbed(nose, mu * push, 1.0 / 3.5);
        // the cloth keeps it from moving down
        let press = (push * sin - q * cos).max(0.0);
        let cloth = [velocity.x - surface.y, velocity.y + surface.x];
        let [f, g] = rubbed(cloth, mu_cloth * press, 1.0 / 3.5);
        velocity.x += -push * cos - q * sin + f;
        velocity.y += y + g;
        surface += Vec3::new(-sin * y + g, -q - f, cos * y) * 2.5;
        work += 0.5 * (before + velocity.x).abs() * cos * push;
        if compressed.is_none() && velocity.x <= 0.0 {
            compressed = Some(work);
            work = 0.0;
        }
    }
    None
}

/// Impulse of friction against a slip: no more than `limit`, nor than `yields` times the slip.
fn rubbed(slip: [f64; 2], limit: f64, yields: f64) -> [f64; 2] {
    let size = slip[0].hypot(slip[1]);
    if size == 0.0 {
        return [0.0; 2];
    }
    let part = limit.min(yields * size) / size;
    [-part * slip[0], -part * slip[1]]
}
