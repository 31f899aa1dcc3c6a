//! Every law in every scalar: the same numbers to the rounding of the coarser one, and derivatives that are those of difference
//! quotients.

use super::{arriving, contacts, cushions, meeting, surface_speed};
use crate::random::Random;
use carom::math::{DoubleDouble, Dual, Octuple, Real};
use carom::physics::{Body, Cushion, Effects, Motion, Side, contact, cushion};
use nalgebra::Vector3;

fn lift<T: Real>(v: &Vector3<f64>) -> Vector3<T> {
    v.map(T::lift)
}

fn body<T: Real>(body: &Body) -> Body<T> {
    Body {
        velocity: lift(&body.velocity),
        spin: lift(&body.spin),
        mass: T::lift(body.mass),
        radius: T::lift(body.radius),
    }
}

/// Velocity, and spin times radius, of a motion in f64.
fn numbers<T: Real>(motion: &Motion<T>, radius: f64) -> [f64; 6] {
    let (v, w) = (motion.velocity, motion.spin);
    let spin = [w.x, w.y, w.z].map(|x| x.to_f64() * radius);
    let [vx, vy, vz] = [v.x, v.y, v.z].map(T::to_f64);
    [vx, vy, vz, spin[0], spin[1], spin[2]]
}

fn collide<T: Real>(laws: &Effects, first: &Body, second: &Body, n: &Vector3<f64>) -> Vec<f64> {
    let laws: Effects<T> = laws.lift();
    let (one, two) = contact::impact(
        laws.contact.unwrap(),
        laws.friction,
        &body(first),
        &body(second),
        &lift(n),
    );
    let (one, two) = (numbers(&one, first.radius), numbers(&two, second.radius));
    one.into_iter().chain(two).collect()
}

fn rebound<T: Real>(law: Cushion, ball: &Body) -> Vec<f64> {
    let effects = Effects {
        cushion: Some(law),
        ..Effects::default()
    };
    let law = effects.lift::<T>().cushion.unwrap();
    let motion = cushion::impact(law, &body(ball), Side::X1).motion;
    numbers(&motion, ball.radius).to_vec()
}

/// The same body with numbers that f32 holds.
fn coarse(body: &Body) -> Body {
    let round = |x: f64| f64::from(x as f32);
    Body {
        velocity: body.velocity.map(round),
        spin: body.spin.map(round),
        mass: round(body.mass),
        radius: round(body.radius),
    }
}

fn hold(what: &str, got: &[f64], want: &[f64], allowed: f64) {
    assert_eq!(got.len(), want.len());
    for (got, want) in got.iter().zip(want) {
        let error = (got - want).abs();
        assert!(
            error <= allowed,
            "{what}: {got} instead of {want}, {error:e}"
        );
    }
}

/// A speed in f64 and in f32: some dozens of operations; unequal masses put up to 15 times the impulse on the light ball.
const F64: f64 = 128.0 * f64::EPSILON;
const F32: f64 = 128.0 * f32::EPSILON as f64;

#[test]
fn every_ball_ball_law_agrees_in_every_scalar() {
    let mut random = Random(71);
    for _ in 0..300 {
        let (first, second, n) = meeting(&mut random);
        let (first, second) = (coarse(&first), coarse(&second));
        let n = n.map(|x| f64::from(x as f32));
        let speed = surface_speed(&first) + surface_speed(&second);
        for laws in contacts(&mut random) {
            let laws = laws.map(|_, x| f64::from(x as f32));
            let name = format!("{laws:?}");
            let wide = collide::<Octuple>(&laws, &first, &second, &n);
            let double = collide::<f64>(&laws, &first, &second, &n);
            hold(&name, &double, &wide, F64 * speed);
            hold(
                &name,
                &collide::<f32>(&laws, &first, &second, &n),
                &wide,
                F32 * speed,
            );
            // both are rounded to f64 at the end
            let dd = collide::<DoubleDouble>(&laws, &first, &second, &n);
            hold(&name, &dd, &wide, f64::EPSILON * speed);
            assert_eq!(collide::<Dual<f64, 3>>(&laws, &first, &second, &n), double);
        }
    }
}

#[test]
fn every_cushion_agrees_in_every_scalar() {
    let mut random = Random(72);
    for _ in 0..300 {
        let ball = coarse(&arriving(&mut random));
        let speed = surface_speed(&ball);
        for law in cushions(&mut random) {
            let effects = Effects {
                cushion: Some(law),
                ..Effects::default()
            };
            let law = effects.map(|_, x| f64::from(x as f32)).cushion.unwrap();
            let name = format!("{law:?}");
            let wide = rebound::<Octuple>(law, &ball);
            let double = rebound::<f64>(law, &ball);
            // an integrated law runs in f64 in every scalar, so that its result is the same to the rounding of R w
            hold(&name, &double, &wide, F64 * speed);
            hold(&name, &rebound::<f32>(law, &ball), &wide, F32 * speed);
            hold(
                &name,
                &rebound::<DoubleDouble>(law, &ball),
                &wide,
                F64 * speed,
            );
            let dual = rebound::<Dual<f64, 3>>(law, &ball);
            hold(&name, &dual, &double, F64 * speed);
        }
    }
}

/// Derivatives of all results by the velocity and spin of the first ball, in dual numbers and by quotients in 106 bits.
#[test]
fn every_ball_ball_law_has_its_derivative() {
    let mut random = Random(73);
    let mut held = 0;
    for _ in 0..200 {
        let (first, second, n) = meeting(&mut random);
        for laws in contacts(&mut random) {
            let speed = surface_speed(&first) + surface_speed(&second);
            let result = |moved: usize, by: f64| {
                let (mut one, two) = (body::<DoubleDouble>(&first), body(&second));
                let part = DoubleDouble::lift(by);
                if moved < 3 {
                    one.velocity[moved] += part;
                } else {
                    one.spin[moved - 3] += part;
                }
                let laws: Effects<DoubleDouble> = laws.lift();
                let law = laws.contact.unwrap();
                let (a, b) = contact::impact(law, laws.friction, &one, &two, &lift(&n));
                [a.velocity, a.spin, b.velocity, b.spin]
            };
            let mut one = body::<Dual<f64, 6>>(&first);
            for i in 0..3 {
                one.velocity[i] = Dual::input(first.velocity[i], i);
                one.spin[i] = Dual::input(first.spin[i], i + 3);
            }
            let lifted: Effects<Dual<f64, 6>> = laws.lift();
            let law = lifted.contact.unwrap();
            let (a, b) = contact::impact(law, lifted.friction, &one, &body(&second), &lift(&n));
            let got = [a.velocity, a.spin, b.velocity, b.spin];
            for input in 0..6 {
                // in 106 bits a step of 1e-12 leaves 1e-24 of curvature and 1e-20 of rounding
                let h = 1e-12;
                let (back, forth) = (result(input, -h), result(input, h));
                for (which, dual) in got.iter().enumerate() {
                    for axis in 0..3 {
                        let rise = (forth[which][axis] - back[which][axis]).to_f64();
                        let want = rise / (2.0 * h);
                        let error = (dual[axis].partials[input] - want).abs();
                        // slips of a hundredth of the speed magnify the rounding of a direction a hundredfold, and the light
                        // ball's spin some tens of times more
                        let allowed = 1e-10 * (1.0 + want.abs());
                        assert!(error <= allowed, "{laws:?}: {error:e} at speed {speed}");
                        held += 1;
                    }
                }
            }
        }
    }
    assert_eq!(held, 200 * 6 * 6 * 12);
}
