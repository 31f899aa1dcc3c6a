//! Cushions against the rebounds of an independent program.

use super::table::{Row, Table};
use super::{ball, off};
use carom::math::Vec3;
use carom::physics::{Cushion, Side, cushion};

/// What pooltool calls our laws, with the tolerance of velocity and of spin by the radius, in units of the speed.
const LAWS: [(&str, f64, &str); 4] = [
    ("unrealistic_elastic", 0.0, "a sign"),
    ("unrealistic_e0.85", 0.0, "a sign and one product"),
    ("han_2005", 1e-12, "closed form in f64 on both sides"),
    (
        "mathavan_2010_ms20000_dp1e-6",
        1e-4,
        "the rows are good to 5e-5: a fixed step of 1e-6",
    ),
];

/// Rows of the file that we leave out, by model, and why.
const LEFT_OUT: [(&str, &str); 3] = [
    ("impulse_frictional_inelastic", "a law that carom lacks"),
    ("stronge_omega1.8", "a law that carom lacks"),
    (
        "mathavan_2010_default",
        "a step so coarse that it is up to 1.2 % off",
    ),
];

fn law(row: &Row<'_>) -> Cushion {
    let (e, mu, height) = (row.number("e_c"), row.number("f_c"), row.number("h_over_R"));
    match row.text("model") {
        "unrealistic_elastic" => Cushion::Elastic {},
        "unrealistic_e0.85" => Cushion::Restitution { e },
        "han_2005" => Cushion::Han2005 { e, mu, height },
        "mathavan_2010_ms20000_dp1e-6" => Cushion::Mathavan2010 {
            e,
            mu,
            mu_cloth: row.number("mu_s_table"),
            height,
        },
        other => panic!("{other}"),
    }
}

#[test]
fn every_rebound_of_the_independent_program_is_ours() {
    let table = Table::read("c_cushion.csv");
    let mut held = [0; LAWS.len()];
    let mut left_out = [0; LEFT_OUT.len()];
    for row in table.rows() {
        let model = row.text("model");
        if let Some(i) = LEFT_OUT.iter().position(|(name, _)| *name == model) {
            left_out[i] += 1;
            continue;
        }
        let i = LAWS.iter().position(|(name, _, _)| *name == model).unwrap();
        let (_, tolerance, why) = LAWS[i];
        let speed = row.number("V");
        let before = Vec3::new(row.number("vx0"), row.number("vy0"), 0.0);
        let spin = Vec3::new(row.number("wx0"), row.number("wy0"), row.number("wz0"));
        // x0 of the file's frame is our x1: the ball moves towards larger x
        let rebound = cushion::impact(law(&row), &ball(before, spin), Side::X1);
        let (after, _) = rebound.motion.on_cloth();
        let velocity = off(&after.velocity, &row.vector("v", "")) / speed;
        let turning = off(&after.spin, &row.vector("w", "")) * super::R / speed;
        let error = velocity.max(turning);
        assert!(
            error <= tolerance,
            "{row}, {model}: {after:?}, off by {error:e}, allowed {tolerance:e}: {why}"
        );
        held[i] += 1;
    }
    assert_eq!(held, [49; 4], "rows of each law");
    assert_eq!(left_out, [49; 3], "rows left out: {LEFT_OUT:?}");
}
