//! Ball-ball impacts, cue strikes and the rotating cloth against independent data and a published table.

use super::table::{Row, Table};
use super::{G, M, R, ball, off};
use carom::math::Vec3;
use carom::physics::cloth::rotational;
use carom::physics::cue::Strike;
use carom::physics::{Body, Contact, Friction, Motion, State, contact};

/// The cue ball of a row: speed V at the cut angle to the line of centres, which is x.
fn cue(row: &Row<'_>) -> Body {
    let (speed, cut) = (row.number("V"), row.number("cut_deg").to_radians());
    let velocity = Vec3::new(cut.cos(), cut.sin(), 0.0) * speed;
    let rolling = Vec3::new(-velocity.y, velocity.x, 0.0) / R;
    let spin = match row.text("spin_case") {
        "stun" => Vec3::zeros(),
        "rolling" => rolling,
        "draw_-rolling" => -rolling,
        "left_side_0.5" => Vec3::new(0.0, 0.0, -0.5 * speed / R),
        "right_side_0.5" => Vec3::new(0.0, 0.0, 0.5 * speed / R),
        other => panic!("{row}: {other}"),
    };
    ball(velocity, spin)
}

#[test]
fn every_ball_ball_impact_of_the_forty_digit_file_is_ours() {
    let table = Table::read("b2_ball_ball_exact.csv");
    let mut held = 0;
    for row in table.rows() {
        let (e, mu) = (row.number("e"), row.number("mu_b"));
        let law = if e == 1.0 {
            Contact::Elastic {}
        } else {
            Contact::Inelastic { e }
        };
        let friction = (mu > 0.0).then_some(Friction::Constant { mu });
        let resting = ball(Vec3::zeros(), Vec3::zeros());
        let (one, two) = contact::impact(law, friction, &cue(&row), &resting, &Vec3::x());
        for (which, motion) in [("1", one), ("2", two)] {
            let v = off(&motion.velocity, &row.vector(&format!("v{which}"), ""));
            let w = off(&motion.spin, &row.vector(&format!("w{which}"), ""));
            // rounding of f64 at speeds up to 10 m/s and spins up to 350 rad/s
            assert!(
                v <= 1e-12 && w <= 1e-11,
                "{row}, ball {which}: {v:e}, {w:e}"
            );
        }
        held += 1;
    }
    assert_eq!(held, 405);
}

#[test]
fn the_closed_form_contact_is_within_two_percent_of_the_paper_that_integrates_the_cloth_as_well() {
    let radius = 0.02625;
    let table = Table::read("b_mathavan2014_paper.csv");
    let mut held = 0;
    for row in table.rows().filter(|row| row.text("N_iter") == "1000") {
        let (speed, cut) = (row.number("V0"), row.number("cut_deg").to_radians());
        let ahead = Vec3::new(cut.cos(), cut.sin(), 0.0);
        let body = |velocity: Vec3, spin: Vec3| Body {
            velocity,
            spin,
            mass: 0.1406,
            radius,
        };
        let top = Vec3::new(-ahead.y, ahead.x, 0.0) * row.number("topspin_rad_s");
        let (one, two) = contact::impact(
            Contact::Inelastic { e: 0.89 },
            Some(Friction::Constant { mu: 0.05 }),
            &body(ahead * speed, top),
            &body(Vec3::zeros(), Vec3::zeros()),
            &Vec3::x(),
        );
        for (motion, which) in [(one, "1"), (two, "2")] {
            let (motion, _) = motion.on_cloth();
            let slip = rotational::slip_velocity(&motion.velocity, &motion.spin, radius);
            let rolls = rotational::natural_roll(&motion.velocity, &slip);
            let pairs = [
                ("paper_v", rolls.norm()),
                ("paper_theta", rolls.angle(&ahead).to_degrees()),
            ];
            for (column, got) in pairs {
                let want = row.number(&format!("{column}{which}"));
                let error = (got - want).abs() / want;
                // what cloth friction does during the impact: 1.4 % at most in these five shots
                assert!(
                    error <= 0.02,
                    "{row}, {column}{which}: {got} against {want}"
                );
            }
        }
        held += 1;
    }
    assert_eq!(held, 5);
}

#[test]
fn every_cue_strike_of_the_independent_program_is_ours() {
    let table = Table::read("f_cue_strike.csv");
    let mut held = 0;
    for row in table.rows() {
        let strike = Strike {
            speed: row.number("V0_cue"),
            angle_deg: 90.0,
            elevation_deg: row.number("theta_deg"),
            cue_mass: 0.567,
            end_mass: Some(M / 30.0),
            side: row.number("a_side"),
            top: row.number("b_top"),
        };
        let Motion { velocity, spin } = strike.motion(M, R);
        let v = off(&velocity, &row.vector("v", ""));
        let w = off(&spin, &row.vector("w", "")) * R;
        // rounding of f64 at speeds up to 12 m/s
        assert!(v <= 1e-12 && w <= 1e-12, "{row}: {v:e}, {w:e}");
        held += 1;
    }
    assert_eq!(held, 75);
}

#[test]
fn slides_and_rolls_of_single_balls_are_those_of_the_independent_program() {
    let mu = rotational::Coefficients {
        mu_slide: 0.2,
        mu_roll: 0.01,
        mu_spin: 0.0127,
    };
    let table = Table::read("a_slide_roll.csv");
    let mut held = 0;
    for row in table.rows() {
        let start = State {
            position: Vec3::new(2000.0, 2000.0, R),
            velocity: row.vector("v", "0"),
            spin: row.vector("w", "0"),
        };
        let slip = rotational::slip_velocity(&start.velocity, &start.spin, R);
        let slide = rotational::slide_time(slip.norm(), mu.mu_slide, G);
        let rolls = rotational::natural_roll(&start.velocity, &slip);
        let slid = if slip.norm() > 0.0 {
            rotational::slid(&start, R, mu, G, slide)
        } else {
            start
        };
        let speed = rolls.norm();
        let end = slide + rotational::roll_time(speed, mu.mu_roll, G);
        let roll = rotational::roll_distance(speed, mu.mu_roll, G);
        let last = match speed {
            0.0 => slid.position,
            speed => slid.position + rolls / speed * roll,
        };
        let spin = rotational::spin_time(start.spin.z, R, mu.mu_spin, G);
        let mut pairs = vec![
            ("slip_speed0", slip.norm()),
            ("t_slide_end_analytic", slide),
            ("vx_roll_analytic", rolls.x),
            ("vy_roll_analytic", rolls.y),
            ("x_roll_analytic", slid.position.x),
            ("y_roll_analytic", slid.position.y),
            ("t_zspin_end_analytic", spin),
            ("x_final_analytic", last.x),
            ("y_final_analytic", last.y),
        ];
        if !row.text("t_roll_end_analytic").is_empty() {
            pairs.push(("t_roll_end_analytic", end));
        }
        for (column, got) in pairs {
            let want = row.number(column);
            // an ulp of the coordinate 2000 is 2.3e-13
            let error = (got - want).abs();
            assert!(
                error <= 1e-12 * want.abs().max(1.0),
                "{row}, {column}: {got}"
            );
        }
        let rolling = rotational::after_slide(
            &Motion {
                velocity: start.velocity,
                spin: start.spin,
            },
            R,
            mu,
            G,
        );
        assert!(off(&rolling.velocity, &slid.velocity) <= 1e-14, "{row}");
        assert!(off(&rolling.spin, &slid.spin) * R <= 1e-13, "{row}");
        held += 1;
    }
    assert_eq!(held, 11);
}
