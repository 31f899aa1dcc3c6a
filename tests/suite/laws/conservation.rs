//! What every law conserves or never increases, and its symmetries, over random impacts of any masses, radii and spins.

use super::{arriving, contacts, cushions, energy, meeting, motion, off, surface_speed};
use crate::random::Random;
use carom::math::Vec3;
use carom::physics::{Body, Cushion, Effects, Motion, Side, contact, cushion};

const ULP: f64 = f64::EPSILON;

/// Impacts of each combination of laws.
const IMPACTS: usize = 100_000;

fn collide(laws: &Effects, first: &Body, second: &Body, n: &Vec3) -> (Motion, Motion) {
    contact::impact(laws.contact.unwrap(), laws.friction, first, second, n)
}

/// Angular momentum of a ball about the point at `arm` from its centre.
fn about(body: &Body, motion: &Motion, arm: Vec3) -> Vec3 {
    let inertia = 0.4 * body.mass * body.radius * body.radius;
    motion.spin * inertia - arm.cross(&motion.velocity) * body.mass
}

#[test]
fn ball_ball_impacts_keep_momentum_and_never_gain_energy() {
    let mut random = Random(61);
    let laws = contacts(&mut random);
    for _ in 0..IMPACTS {
        let (first, second, n) = meeting(&mut random);
        let total = first.velocity * first.mass + second.velocity * second.mass;
        let before = energy(&first, &motion(&first)) + energy(&second, &motion(&second));
        let speed = surface_speed(&first) + surface_speed(&second);
        let mass = first.mass + second.mass;
        for laws in &laws {
            let (one, two) = collide(laws, &first, &second, &n);
            let after = one.velocity * first.mass + two.velocity * second.mass;
            // some ten operations on numbers of this size
            assert!(off(&after, &total) <= 16.0 * ULP * mass * speed, "{laws:?}");
            let left = energy(&first, &one) + energy(&second, &two);
            let rounding = 32.0 * ULP * mass * speed * speed;
            assert!(
                left <= before + rounding,
                "{laws:?}: {before} became {left}"
            );
            let arms = [
                (&first, &one, n * first.radius),
                (&second, &two, -n * second.radius),
            ];
            for (body, motion, arm) in arms {
                let kept = about(body, &super::motion(body), arm);
                let rounding = 16.0 * ULP * mass * body.radius * speed;
                assert!(
                    off(&about(body, motion, arm), &kept) <= rounding,
                    "{laws:?}"
                );
            }
            // what the cloth takes is counted
            let (flat, lost) = one.on_cloth();
            let counted = energy(&first, &flat) + lost * first.mass;
            assert!(
                (counted - energy(&first, &one)).abs() <= rounding,
                "{laws:?}"
            );
        }
    }
}

#[test]
fn cushions_never_give_energy_and_keep_the_angular_momentum_about_their_nose() {
    let mut random = Random(62);
    for _ in 0..IMPACTS {
        let body = arriving(&mut random);
        let before = energy(&body, &motion(&body));
        let speed = surface_speed(&body);
        for law in cushions(&mut random) {
            let rebound = cushion::impact(law, &body, Side::X1);
            let after = energy(&body, &rebound.motion);
            let slack = 32.0 * ULP * speed + 2.0 * rebound.error;
            assert!(
                after <= before + slack * body.mass * speed,
                "{law:?} {body:?}: {before} became {after}"
            );
            // Han's nose presses a ball down without turning it back where it is far above or below the centre
            if !matches!(law, Cushion::Han2005 { .. }) {
                let outward = rebound.motion.velocity.x;
                assert!(outward <= rebound.error, "{law:?}: {outward:e}");
            }
            let height = match law {
                Cushion::Elastic {} | Cushion::Restitution { .. } => 1.0,
                Cushion::Han2005 { height, .. } => height,
                // friction at the cloth has a moment about the nose
                Cushion::Mathavan2010 { .. } => continue,
            };
            let sin = height - 1.0;
            let arm = Vec3::new((1.0 - sin * sin).sqrt(), 0.0, sin) * body.radius;
            let kept = about(&body, &motion(&body), arm);
            let change = about(&body, &rebound.motion, arm) - kept;
            let rounding = 32.0 * ULP * body.mass * body.radius * speed;
            assert!(change.norm() <= rounding, "{law:?}: {change:?}");
        }
    }
}

fn mirrored(v: &Vec3) -> Vec3 {
    Vec3::new(v.x, -v.y, v.z)
}

/// The mirror image in the plane y = 0: a spin is turned the other way round.
fn image(body: &Body) -> Body {
    Body {
        velocity: mirrored(&body.velocity),
        spin: -mirrored(&body.spin),
        ..*body
    }
}

#[test]
fn mirrored_impacts_have_mirrored_results_to_the_bit() {
    let mut random = Random(63);
    for _ in 0..2000 {
        let (first, second, n) = meeting(&mut random);
        for laws in contacts(&mut random) {
            let (one, two) = collide(&laws, &first, &second, &n);
            let (three, four) = collide(&laws, &image(&first), &image(&second), &mirrored(&n));
            for (got, of) in [(three, one), (four, two)] {
                assert_eq!(got.velocity, mirrored(&of.velocity), "{laws:?}");
                assert_eq!(got.spin, -mirrored(&of.spin), "{laws:?}");
            }
        }
        let body = arriving(&mut random);
        for law in cushions(&mut random) {
            let of = cushion::impact(law, &body, Side::X1).motion;
            let got = cushion::impact(law, &image(&body), Side::X1).motion;
            assert_eq!(got.velocity, mirrored(&of.velocity), "{law:?}");
            assert_eq!(got.spin, -mirrored(&of.spin), "{law:?}");
        }
    }
}

#[test]
fn the_four_cushions_are_quarter_turns_of_each_other_to_the_bit() {
    let mut random = Random(64);
    let turn = |v: &Vec3| Vec3::new(-v.y, v.x, v.z);
    for _ in 0..500 {
        for law in cushions(&mut random) {
            let mut body = arriving(&mut random);
            let mut want = cushion::impact(law, &body, Side::X1).motion;
            for side in [Side::Y1, Side::X0, Side::Y0] {
                body.velocity = turn(&body.velocity);
                body.spin = turn(&body.spin);
                want = Motion {
                    velocity: turn(&want.velocity),
                    spin: turn(&want.spin),
                };
                let got = cushion::impact(law, &body, side).motion;
                assert_eq!(got, want, "{law:?} at {side:?}");
            }
        }
    }
}

#[test]
fn it_does_not_matter_which_ball_is_called_the_first() {
    let mut random = Random(65);
    for _ in 0..5000 {
        let (first, second, n) = meeting(&mut random);
        let speed = surface_speed(&first) + surface_speed(&second);
        for laws in contacts(&mut random) {
            let (one, two) = collide(&laws, &first, &second, &n);
            let (b, a) = collide(&laws, &second, &first, &-n);
            for (got, want, body) in [(a, one, &first), (b, two, &second)] {
                // sums in another order; light balls take the larger part of an impulse, masses differ by up to 15
                let rounding = 64.0 * ULP * speed;
                assert!(off(&got.velocity, &want.velocity) <= rounding, "{laws:?}");
                let turning = off(&got.spin, &want.spin) * body.radius;
                assert!(turning <= 2.5 * rounding, "{laws:?}: {turning:e}");
            }
        }
    }
}
