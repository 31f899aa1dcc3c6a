//! In which scenes contacts are followed: those whose quantities differ by no more than they do between balls, cloths and tables that people build.
//!
//! Beyond that a contact is decided by what rounding leaves of numbers that cancel: a ball that weighs a thousandth of another, a cloth on which a ball
//! rolls where it cannot slip, a table of a million balls across. There a run ends where impacts accumulate, as it does without a cloth.

use crate::math::Vec3;
use crate::physics::{Cloth, Side};
use crate::scene::{Ball, Scene};

/// The heaviest ball weighs no more than this many of the lightest.
const MASSES: f64 = 10.0;

/// The largest ball is no wider than this many of the smallest.
const RADII: f64 = 4.0;

/// No coordinate is larger than this many of the smallest radius.
const ACROSS: f64 = 1e4;

/// Friction of a cloth on a ball that slips, or does not turn.
const FRICTION: [f64; 2] = [1e-3, 1.0];

/// Loss of spin about the vertical by a cloth is no more than this.
const SPIN: f64 = 1.0;

/// Contacts of balls that move or turn at the start, at most.
const PRESSED: usize = 3;

/// Gaps of so many of those that count as touching belong to them.
const NEARLY: f64 = 64.0;

/// Whether a scene starts with so many contacts of balls that move or turn that what begins there is decided by what rounding leaves of their gaps.
pub fn starts_pressed(scene: &Scene) -> bool {
    let touching = NEARLY * scene.touching();
    let stirs =
        |ball: &Ball| ball.state.velocity != Vec3::zeros() || ball.state.spin != Vec3::zeros();
    let meets = |a: &Ball, b: &Ball| {
        let apart = (a.state.position - b.state.position).xy().norm();
        apart - 2.0 * (a.radius * b.radius).sqrt() <= touching
    };
    let lies_at = |ball: &Ball| {
        let Some(table) = scene.table.filter(|_| scene.effects.cushion.is_some()) else {
            return 0;
        };
        let beyond = |side: &Side| {
            let edge = table.reach(*side, ball.radius);
            f64::from(side.sign()) * (edge - ball.state.position[side.axis()]) <= touching
        };
        Side::ALL.iter().filter(|side| beyond(side)).count()
    };
    let mut contacts = 0;
    for (i, ball) in scene.balls.iter().enumerate() {
        if stirs(ball) {
            contacts += lies_at(ball);
        }
        let later = scene.balls[i + 1..].iter();
        let later = later.filter(|other| (stirs(ball) || stirs(other)) && meets(ball, other));
        contacts += later.count();
        if contacts > PRESSED {
            return true;
        }
    }
    false
}

/// Whether a run follows contacts in this scene, unless it starts with many of them.
pub fn is_followed(scene: &Scene) -> bool {
    let spread = |of: fn(&Ball) -> f64| {
        let least = scene.balls.iter().map(of).fold(f64::INFINITY, f64::min);
        let most = scene.balls.iter().map(of).fold(0.0, f64::max);
        most / least
    };
    let grips = |mu: f64| (FRICTION[0]..=FRICTION[1]).contains(&mu);
    let presses = match scene.effects.cloth {
        Some(Cloth::Rotational {
            mu_slide,
            mu_roll,
            mu_spin,
        }) => grips(mu_slide) && mu_roll <= mu_slide && mu_spin <= SPIN,
        Some(Cloth::Translational { mu }) => grips(mu),
        // nothing presses balls together
        None => false,
    };
    presses
        && spread(|ball| ball.mass) <= MASSES
        && spread(|ball| ball.radius) <= RADII
        && scene.largest_coordinate() <= ACROSS * scene.smallest_radius()
}
