//! Any laws for a scene, with numbers from the middle and from the edges of their ranges.

use super::dice::Dice;
use super::layout::{Placed, across, plus, times};
use super::{Scale, edges, legal};
use crate::physics::{Cloth, Contact, Cushion, Effects, Friction, Pockets};
use crate::scene::file::TableFile;

/// Effects of any kind that fit together. `bounded`: there is a table.
pub(super) fn draw(dice: &mut Dice, scale: &Scale, bounded: bool) -> Effects {
    let cloth = match dice.below(10) {
        0..=2 => None,
        3..=6 => Some(Cloth::Translational {
            mu: coefficient(dice),
        }),
        _ => Some(Cloth::Rotational {
            mu_slide: coefficient(dice),
            mu_roll: coefficient(dice),
            mu_spin: coefficient(dice),
        }),
    };
    let turns = !matches!(cloth, Some(Cloth::Translational { .. }));
    let contact = match dice.below(20) {
        0 => None,
        1..=11 => Some(Contact::Elastic {}),
        _ => Some(Contact::Inelastic {
            e: restitution(dice),
        }),
    };
    let friction = match dice.below(4) {
        0 => Some(Friction::Constant {
            mu: coefficient(dice),
        }),
        1 => Some(Friction::Alciatore {
            a: coefficient(dice),
            b: coefficient(dice),
            c: coefficient(dice),
            length_in_metres: 1.0,
        }),
        _ => None,
    };
    let height = dice.pick(&[1.28, 1.4, 1.0, 0.6, 1.95, 1.999_999, 0.05, 1e-9]);
    let cushion = match dice.below(20) {
        0..=1 => None,
        2..=9 => Some(Cushion::Elastic {}),
        10..=13 => Some(Cushion::Restitution {
            e: restitution(dice),
        }),
        14..=18 if turns => Some(Cushion::Han2005 {
            e: restitution(dice),
            mu: coefficient(dice),
            height,
        }),
        19 if turns => Some(Cushion::Mathavan2010 {
            e: restitution(dice),
            mu: coefficient(dice).min(0.5),
            mu_cloth: coefficient(dice).min(0.5),
            height: height.clamp(0.1, 1.9),
        }),
        _ => Some(Cushion::Elastic {}),
    };
    let _ = scale;
    Effects {
        cloth,
        contact,
        friction: friction.filter(|_| turns && contact.is_some()),
        cushion: cushion.filter(|_| bounded),
        pockets: None,
    }
}

/// A coefficient of friction.
fn coefficient(dice: &mut Dice) -> f64 {
    match dice.below(8) {
        0..=3 => dice.between(0.005, 0.4),
        4 => 0.0,
        5 => dice.pick(&[1e-9, 1.0, 10.0]),
        6 => dice.decades(-6.0, 2.0),
        _ => dice.decades(-30.0, 6.0),
    }
}

/// A coefficient of restitution.
fn restitution(dice: &mut Dice) -> f64 {
    match dice.below(8) {
        0 => 0.0,
        1 => 1.0,
        2..=4 => dice.between(0.5, 1.0),
        5 => dice.between(0.0, 1.0),
        6 => 1.0 - dice.tiny(),
        _ => dice.decades(-30.0, 0.0),
    }
}

/// Gravity under which a ball with a coefficient of 0.2 stops within some hundred radii; now and then any.
pub(super) fn gravity(dice: &mut Dice, scale: &Scale) -> f64 {
    let distance = scale.radius * dice.decades(0.5, 3.0);
    let fitting = scale.speed * (scale.speed / distance) / 0.4;
    legal(match dice.below(8) {
        0 => 9.81,
        1 => dice.pick(&[0.0, 1e-9 * fitting, 1e9 * fitting]),
        _ => fitting,
    })
}

/// True where the laws lose energy in impacts.
pub(super) fn lossy(effects: &Effects) -> bool {
    let contact = matches!(effects.contact, Some(Contact::Inelastic { .. }));
    let cushion = !matches!(effects.cushion, None | Some(Cushion::Elastic {}));
    contact || cushion || effects.friction.is_some()
}

/// Pockets at corners, in the open, or beside the way of a ball that they miss or catch by next to nothing.
pub(super) fn pockets(
    dice: &mut Dice,
    table: &TableFile,
    balls: &[Placed],
    scale: &Scale,
) -> Option<Pockets> {
    if !dice.chance(0.2) {
        return None;
    }
    let [min, max] = edges(table);
    let r = scale.radius;
    let circle = |dice: &mut Dice| {
        let size = r * dice.pick(&[0.1, 0.5, 1.0, 2.0]);
        let place = match dice.below(3) {
            0 => [
                dice.pick(&[min[0], max[0]]),
                dice.pick(&[min[1], max[1], 0.5 * (min[1] + max[1])]),
            ],
            1 => [dice.between(min[0], max[0]), dice.between(min[1], max[1])],
            _ => {
                let ball = balls[dice.below(balls.len())];
                let speed = ball.velocity[0].hypot(ball.velocity[1]);
                let ahead = if speed > 0.0 {
                    times(1.0 / speed, ball.velocity)
                } else {
                    [1.0, 0.0]
                };
                let miss = size * (1.0 + dice.tiny() * dice.pick(&[-1.0, 0.0, 1.0]));
                plus(
                    plus(ball.position, times(4.0 * r, ahead)),
                    times(miss, across(ahead)),
                )
            }
        };
        [legal(place[0]), legal(place[1]), legal(size).max(1e-30)]
    };
    let count = dice.count(1, 6);
    Some(Pockets {
        circles: (0..count).map(|_| circle(dice)).collect(),
    })
}

/// Angular velocity: none, that of rolling, of a slide, about the vertical, far beyond rolling.
pub(super) fn spin(dice: &mut Dice, ball: &Placed, scale: &Scale) -> [f64; 3] {
    let [vx, vy] = ball.velocity;
    let rate = scale.speed / ball.radius;
    let rolling = [-vy / ball.radius, vx / ball.radius, 0.0];
    match dice.below(8) {
        0..=2 => [0.0; 3],
        3 => rolling,
        4 => rolling.map(|w| w * (1.0 + dice.tiny())),
        5 => [0.0, 0.0, rate * dice.pick(&[-1.0, 1.0, 1e-9, 100.0])],
        6 => [0; 3].map(|_| rate * dice.between(-3.0, 3.0)),
        _ => {
            let fast = dice.decades(-6.0, 4.0);
            [0; 3].map(|_| rate * fast * dice.between(-1.0, 1.0))
        }
    }
}
