//! Closed forms of single impacts and strikes that books and papers give.

use super::{M, R, ball, energy, motion, off};
use crate::random::Random;
use carom::math::Vec3;
use carom::physics::cloth::rotational;
use carom::physics::cue::Strike;
use carom::physics::{
    Body, Contact, Cushion, Friction, Motion, Side, State, contact, cushion, pockets,
};

const ULP: f64 = f64::EPSILON;

/// A resting pool ball.
fn resting() -> Body {
    ball(Vec3::zeros(), Vec3::zeros())
}

/// A pool ball that arrives at the cut angle `phi`, rad, to the line of centres, which is x.
fn cut(speed: f64, phi: f64, spin: impl Fn(Vec3) -> Vec3) -> Body {
    let velocity = Vec3::new(phi.cos(), phi.sin(), 0.0) * speed;
    ball(velocity, spin(velocity))
}

fn rolling(velocity: Vec3) -> Vec3 {
    rotational::rolling_spin(&velocity, R)
}

#[test]
fn equal_elastic_balls_part_at_a_right_angle_and_exchange_their_normal_velocities() {
    let mut random = Random(51);
    for _ in 0..1000 {
        let phi = random.between(-1.5, 1.5);
        let cue = cut(3.0, phi, |_| Vec3::zeros());
        let law = Contact::Elastic {};
        let (one, two) = contact::impact(law, None, &cue, &resting(), &Vec3::x());
        // one product and one difference of numbers up to 3
        assert!(one.velocity.dot(&two.velocity).abs() <= 9.0 * 4.0 * ULP);
        assert_eq!(two.velocity, Vec3::new(cue.velocity.x, 0.0, 0.0));
    }
}

#[test]
fn head_on_masses_and_restitution_give_newtons_velocities_and_loss() {
    let mut random = Random(52);
    for _ in 0..1000 {
        let (m1, m2) = (random.between(0.1, 3.0), random.between(0.1, 3.0));
        let (e, v) = (random.between(0.0, 1.0), random.between(0.1, 9.0));
        let first = Body {
            mass: m1,
            ..ball(Vec3::new(v, 0.0, 0.0), Vec3::zeros())
        };
        let second = Body {
            mass: m2,
            ..resting()
        };
        let law = Contact::Inelastic { e };
        let (one, two) = contact::impact(law, None, &first, &second, &Vec3::x());
        let want = [
            (m1 - e * m2) / (m1 + m2) * v,
            (1.0 + e) * m1 / (m1 + m2) * v,
        ];
        for (got, want) in [one, two].iter().zip(want) {
            // half a dozen roundings of numbers up to 2 v
            assert!(
                (got.velocity.x - want).abs() <= 16.0 * ULP * v,
                "{m1} {m2} {e}"
            );
        }
        let loss = energy(&first, &motion(&first)) - energy(&first, &one) - energy(&second, &two);
        let predicted = (1.0 - e * e) * m1 * m2 * v * v / (2.0 * (m1 + m2));
        assert!((loss - predicted).abs() <= 32.0 * ULP * m1 * v * v);
    }
}

#[test]
fn restitution_of_one_is_the_elastic_law_to_the_bit() {
    let mut random = Random(53);
    for _ in 0..1000 {
        let (first, second, n) = super::meeting(&mut random);
        let elastic = contact::impact(Contact::Elastic {}, None, &first, &second, &n);
        let one = contact::impact(Contact::Inelastic { e: 1.0 }, None, &first, &second, &n);
        assert_eq!(elastic, one);
        let arriving = super::arriving(&mut random);
        for side in Side::ALL {
            let mirror = cushion::impact(Cushion::Elastic {}, &arriving, side);
            let lossless = cushion::impact(Cushion::Restitution { e: 1.0 }, &arriving, side);
            assert_eq!(mirror, lossless);
        }
    }
}

/// Direction of the cue ball once it rolls again after a smooth hit with restitution `e`, degrees from where it came.
fn deflection(phi: f64, e: f64) -> f64 {
    let cue = cut(2.0, phi, rolling);
    let law = Contact::Inelastic { e };
    let (one, _) = contact::impact(law, None, &cue, &resting(), &Vec3::x());
    let slip = rotational::slip_velocity(&one.velocity, &one.spin, R);
    let rolls = rotational::natural_roll(&one.velocity, &slip);
    rolls.angle(&cue.velocity).to_degrees()
}

#[test]
fn a_rolling_cue_ball_is_deflected_by_the_thirty_degree_rule() {
    for i in 1..90 {
        let phi = f64::from(i).to_radians();
        let tan = phi.sin() * phi.cos() / (phi.sin().powi(2) + 0.4);
        let want = tan.atan().to_degrees();
        // the angle of two vectors by its cosine: an ulp under a square root
        assert!((deflection(phi, 1.0) - want).abs() <= 1e-6, "{i} degrees");
    }
    for (name, phi, e, want, digits) in [
        ("half ball", 0.5_f64.asin(), 1.0, 33.6705, 5e-5),
        ("largest", 28.13_f64.to_radians(), 1.0, 33.749, 5e-4),
        ("quarter ball", 0.75_f64.asin(), 1.0, 27.267, 5e-4),
        ("three-quarter ball", 0.25_f64.asin(), 1.0, 27.626, 5e-4),
        ("half ball, e = .95", 0.5_f64.asin(), 0.95, 32.26, 5e-3),
    ] {
        let got = deflection(phi, e);
        // half a unit of the last digit given
        assert!(
            (got - want).abs() <= digits,
            "{name}: {got} instead of {want}"
        );
    }
}

/// Angle by which friction throws a resting object ball off the line of centres, as its tangent.
fn throw(cue: &Body, e: f64, mu: f64) -> f64 {
    let friction = Some(Friction::Constant { mu });
    let law = Contact::Inelastic { e };
    let (_, two) = contact::impact(law, friction, cue, &resting(), &Vec3::x());
    two.velocity.y / two.velocity.x
}

#[test]
fn a_stun_shot_throws_by_mu_while_it_slips_and_by_the_cut_while_it_sticks() {
    let (mut slipping, mut sticking) = (0, 0);
    for (e, mu) in [(1.0, 0.06), (0.95, 0.05), (0.89, 0.03), (0.5, 0.1)] {
        for i in 1..85 {
            let phi = f64::from(i).to_radians();
            let tan = throw(&cut(1.0, phi, |_| Vec3::zeros()), e, mu);
            let want = if phi.tan() >= 3.5 * mu * (1.0 + e) {
                slipping += 1;
                mu
            } else {
                sticking += 1;
                2.0 * phi.tan() / (7.0 * (1.0 + e))
            };
            // a quotient of components; tan phi up to 11 brings its rounding with it
            assert!((tan - want).abs() <= 64.0 * ULP, "{e} {mu} {i}: {tan}");
        }
    }
    assert!(slipping > 100 && sticking > 30, "{slipping} {sticking}");
}

#[test]
fn gearing_side_throws_nothing() {
    for i in 1..85 {
        let phi = f64::from(i).to_radians();
        let geared = |v: Vec3| Vec3::new(0.0, 0.0, -v.y / R);
        let tan = throw(&cut(1.0, phi, geared), 0.95, 0.06);
        assert!(tan.abs() <= 8.0 * ULP * phi.tan(), "{i} degrees: {tan:e}");
    }
}

#[test]
fn published_constants_give_the_published_friction_of_balls() {
    let [a, b, c] = carom::physics::friction::alciatore::PUBLISHED;
    for (u, want) in [(0.0, 0.117951), (1.0, 0.046335), (f64::INFINITY, 0.009951)] {
        let law = Friction::Alciatore {
            a,
            b,
            c,
            length_in_metres: 0.5,
        };
        // u is in m/s, two length units each second
        let mu = carom::physics::friction::coefficient(law, 2.0 * u);
        assert!((mu - want).abs() <= 1e-6, "{u} m/s: {mu}");
    }
}

#[test]
fn han_has_its_closed_form_for_a_ball_that_stuns_into_the_cushion() {
    let mut random = Random(54);
    let (mut slipping, mut sticking) = (0, 0);
    for _ in 0..2000 {
        let (e, mu) = (random.between(0.0, 1.0), random.between(0.0, 0.3));
        let height = random.between(0.7, 1.6);
        let v = random.between(0.1, 5.0);
        let sin = height - 1.0;
        let cos = f64::sqrt(1.0 - sin * sin);
        let law = Cushion::Han2005 { e, mu, height };
        let rebound = cushion::impact(law, &ball(Vec3::new(v, 0.0, 0.0), Vec3::zeros()), Side::X1);
        let (got, _) = rebound.motion.on_cloth();
        // the slip is down the cushion with sin th v, whatever the sign of sin th
        let (limit, rest) = (mu * (1.0 + e) * cos, 2.0 / 7.0 * sin.abs());
        if limit < rest {
            slipping += 1;
        } else {
            sticking += 1;
        }
        let up = f64::min(limit, rest) * sin.signum();
        let want = v * (1.0 - (1.0 + e) * cos * cos - sin * up);
        let turn = -2.5 / R * up * v;
        assert!(
            (got.velocity.x - want).abs() <= 32.0 * ULP * v,
            "{height} {mu}"
        );
        assert!(
            (got.spin.y - turn).abs() * R <= 32.0 * ULP * v,
            "{height} {mu}"
        );
        assert_eq!(rebound.error, 0.0);
    }
    assert!(slipping > 200 && sticking > 200, "{slipping} {sticking}");
}

#[test]
fn mathavan_without_friction_returns_the_share_e_of_the_speed() {
    let mut random = Random(55);
    for _ in 0..500 {
        let e = random.between(0.0, 1.0);
        let body = super::arriving(&mut random);
        // without friction a nose at any height gives the same, and at the height of the centre the cloth is not pressed
        for (mu_cloth, height) in [(0.0, random.between(0.5, 1.8)), (0.4, 1.0)] {
            let law = Cushion::Mathavan2010 {
                e,
                mu: 0.0,
                mu_cloth,
                height,
            };
            let rebound = cushion::impact(law, &body, Side::X1);
            let mut want = body.velocity;
            want.x *= -e;
            let allowed = rebound.error + 8.0 * ULP * body.velocity.norm();
            assert!(off(&rebound.motion.velocity, &want) <= allowed, "{height}");
            assert!(off(&rebound.motion.spin, &body.spin) * body.radius <= allowed);
        }
    }
}

#[test]
fn an_impact_with_a_cushion_is_of_the_first_degree_in_the_speeds() {
    let mut random = Random(56);
    for _ in 0..300 {
        let body = super::arriving(&mut random);
        let scaled = Body {
            velocity: body.velocity * 7.0,
            spin: body.spin * 7.0,
            ..body
        };
        for law in super::cushions(&mut random) {
            let (one, seven) = (
                cushion::impact(law, &body, Side::Y0),
                cushion::impact(law, &scaled, Side::Y0),
            );
            let allowed =
                7.0 * one.error + seven.error + 64.0 * ULP * super::surface_speed(&scaled);
            let error = off(&seven.motion.velocity, &(one.motion.velocity * 7.0));
            assert!(error <= allowed, "{law:?}: {error:e}");
        }
    }
}

#[test]
fn a_cue_gives_the_speeds_and_spins_of_its_closed_form() {
    let strike = |top: f64| {
        let strike = Strike {
            speed: 1.0,
            angle_deg: 90.0,
            elevation_deg: 0.0,
            cue_mass: 0.567,
            end_mass: None,
            side: 0.0,
            top,
        };
        strike.motion(M, R)
    };
    let centre = strike(0.0);
    assert!((centre.velocity.y - 1.53847).abs() <= 5e-6, "{centre:?}");
    assert_eq!(centre.spin, Vec3::zeros());
    let high = strike(0.4);
    assert!((high.velocity.y - 1.17647).abs() <= 5e-6, "{high:?}");
    assert!((high.spin.norm() - 41.171).abs() <= 5e-4, "{high:?}");
    // at two fifths of the radius the ball rolls at once
    let slip = rotational::slip_velocity(&high.velocity, &high.spin, R);
    assert!(slip.norm() <= 4.0 * ULP, "{slip:?}");
}

#[test]
fn a_level_cue_loses_no_energy_and_left_english_deflects_to_the_right() {
    let mut random = Random(57);
    for _ in 0..1000 {
        let strike = Strike {
            speed: random.between(0.1, 10.0),
            angle_deg: random.between(-360.0, 360.0),
            elevation_deg: 0.0,
            cue_mass: random.between(0.3, 0.8),
            end_mass: None,
            side: random.between(-0.6, 0.6),
            top: random.between(-0.6, 0.6),
        };
        let got = strike.motion(M, R);
        let (cos, sin) = carom::math::angle::unit_vector(strike.angle_deg);
        let left = Vec3::new(-sin, cos, 0.0);
        // what the cue keeps, from momentum along it
        let kept = strike.speed - M * got.velocity.norm() / strike.cue_mass;
        let before = strike.cue_mass * strike.speed.powi(2) / 2.0;
        let after = strike.cue_mass * kept * kept / 2.0 + energy(&resting(), &got);
        assert!((after - before).abs() <= 64.0 * ULP * before, "{strike:?}");
        assert!(got.velocity.dot(&left).abs() <= 4.0 * ULP * got.velocity.norm());
        // side to the left turns the ball clockwise, seen from above: its right side comes forward
        assert!(got.spin.z * strike.side <= 0.0, "{strike:?}");
        let squirted = Strike {
            end_mass: Some(M / 30.0),
            ..strike
        };
        let aside = squirted.motion(M, R).velocity.dot(&left);
        assert!(aside * strike.side <= 0.0, "{strike:?}");
        assert!(aside.abs() > 0.0);
    }
}

#[test]
fn general_spin_settles_to_the_natural_roll_of_coriolis() {
    for (k, want) in [(0.0, 5.0 / 7.0), (-1.0, 1.0), (2.5, 0.0), (3.0, -1.0 / 7.0)] {
        // draw with w R / v = k
        let velocity = Vec3::new(0.0, 2.0, 0.0);
        let spin = Vec3::new(k * 2.0 / R, 0.0, 0.0);
        let slip = rotational::slip_velocity(&velocity, &spin, R);
        let rolls = rotational::natural_roll(&velocity, &slip);
        assert!((rolls.y - 2.0 * want).abs() <= 8.0 * ULP, "{k}: {rolls:?}");
    }
}

#[test]
fn the_rates_of_the_rotating_cloth_keep_the_angular_momentum_about_the_contact() {
    let mut random = Random(58);
    let mu = rotational::Coefficients {
        mu_slide: 0.2,
        mu_roll: 0.01,
        mu_spin: 0.0127,
    };
    for _ in 0..1000 {
        let velocity = Vec3::new(random.between(-3.0, 3.0), random.between(-3.0, 3.0), 0.0);
        let spin = super::vector(&mut random, 100.0);
        let slip = rotational::slip_velocity(&velocity, &spin, R);
        let rates = rotational::sliding(&slip, &spin, R, mu, super::G);
        // I w + R z x m v, per mass, in the plane
        let about =
            Vec3::z().cross(&rates.acceleration) * R + rates.angular_acceleration * (0.4 * R * R);
        assert!(about.xy().norm() <= 8.0 * ULP * R * mu.mu_slide * super::G);
        // the slip falls at 7/2 mu g along itself
        let change = rotational::slip_velocity(&rates.acceleration, &rates.angular_acceleration, R);
        let want = slip.normalize() * (-3.5 * mu.mu_slide * super::G);
        assert!(off(&change, &want) <= 16.0 * ULP * want.norm());
        let rolls = rotational::rolling(&velocity, &rolling(velocity), R, mu, super::G);
        let kept = rotational::slip_velocity(&rolls.acceleration, &rolls.angular_acceleration, R);
        assert!(
            kept.norm() <= 4.0 * ULP,
            "a rolling ball keeps rolling: {kept:?}"
        );
    }
}

#[test]
fn a_centre_hit_rolls_after_twelve_forty_ninths_and_keeps_five_sevenths_of_its_energy() {
    let (v, mu, g) = (2.0, 0.2, super::G);
    let start = State {
        position: Vec3::new(0.0, 0.0, R),
        velocity: Vec3::new(v, 0.0, 0.0),
        spin: Vec3::zeros(),
    };
    let numbers = rotational::Coefficients {
        mu_slide: mu,
        mu_roll: 0.01,
        mu_spin: 0.01,
    };
    let time = rotational::slide_time(v, mu, g);
    assert!((time - 2.0 * v / (7.0 * mu * g)).abs() <= 4.0 * ULP * time);
    let end = rotational::slid(&start, R, numbers, g, time);
    let distance = 12.0 * v * v / (49.0 * mu * g);
    assert!((end.position.x - distance).abs() <= 8.0 * ULP * distance);
    let body = ball(start.velocity, start.spin);
    let before = energy(&body, &motion(&body));
    let after = Motion {
        velocity: end.velocity,
        spin: end.spin,
    };
    assert!((energy(&body, &after) / before - 5.0 / 7.0).abs() <= 8.0 * ULP);
}

#[test]
fn a_pocket_holds_what_is_inside_its_circle() {
    let pockets = carom::physics::Pockets {
        circles: vec![[0.0, 0.0, 0.5], [2.0, 0.0, 0.25]],
    };
    for (x, y, held) in [
        (0.3, 0.4, Some(0)),
        (0.3, 0.401, None),
        (1.75, 0.0, Some(1)),
        (1.0, 0.0, None),
    ] {
        let at = Vec3::new(x, y, 0.1);
        assert_eq!(pockets::holding(&pockets, &at), held, "{x} {y}");
        let deepest = pockets
            .circles
            .iter()
            .map(|circle| pockets::depth(circle, &at))
            .fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(deepest >= 0.0, held.is_some(), "{x} {y}: {deepest}");
    }
}
