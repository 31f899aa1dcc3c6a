//! Impacts of whole shots of an independent program, one by one.
//!
//! It moves each pair apart after a hit, so its replays differ from ours; its impacts do not, once the normal is taken from the
//! positions that it took it from. One of the files carries a defect of its ball-ball friction, which a test reproduces.

use super::{M, R, off};
use crate::references::text;
use carom::math::Vec3;
use carom::physics::{Body, Contact, Cushion, Friction, Motion, Side, contact, cushion, friction};
use serde_json::Value;

/// One ball on both sides of an event.
struct Party {
    body: Body,
    /// Where the program puts it afterwards.
    position: Vec3,
    after: Motion,
}

fn vector(value: &Value) -> Vec3 {
    Vec3::from_fn(|i, _| value[i].as_f64().unwrap())
}

/// Every event of a kind, with its index and the balls that take part.
fn events(name: &str, kind: &str) -> Vec<(u64, Vec<Party>, String)> {
    let file: Value = serde_json::from_str(&text(&format!("{name}.json"))).unwrap();
    let all = file["events"].as_array().unwrap().iter();
    let of_kind = all.filter(|event| event["type"] == kind);
    let found: Vec<_> = of_kind
        .map(|event| {
            let party = |ball: &Value| {
                let (before, after) = (&ball["before"], &ball["after"]);
                Party {
                    body: Body {
                        velocity: vector(&before["v"]),
                        spin: vector(&before["w"]),
                        mass: M,
                        radius: R,
                    },
                    position: vector(&after["r"]),
                    after: Motion {
                        velocity: vector(&after["v"]),
                        spin: vector(&after["w"]),
                    },
                }
            };
            let parties = event["balls"].as_array().unwrap().iter().map(party);
            let other = event["ids"][1].as_str().unwrap().to_owned();
            (event["i"].as_u64().unwrap(), parties.collect(), other)
        })
        .collect();
    assert!(!found.is_empty(), "{name} has no {kind}");
    found
}

fn side(id: &str) -> Side {
    match id {
        "9" => Side::Y1,
        "18" => Side::Y0,
        "12" => Side::X1,
        other => panic!("cushion {other}"),
    }
}

/// Largest difference of a motion on the cloth from what the file says: velocity, and spin times the radius, m/s.
fn error(got: Motion, want: &Motion) -> f64 {
    let (got, _) = got.on_cloth();
    off(&got.velocity, &want.velocity).max(off(&got.spin, &want.spin) * R)
}

fn normal(parties: &[Party]) -> Vec3 {
    (parties[1].position - parties[0].position).normalize()
}

/// Rounding of the positions that give the normal, 1e-16 / 2R, times speeds of 3 m/s, and of the file's own arithmetic.
const ROUNDING: f64 = 1e-12;

#[test]
fn elastic_impacts_and_cushions_are_those_of_the_stun_shot() {
    let name = "d4_si_3ball_stun_elastic";
    for (i, parties, _) in events(name, "ball_ball") {
        let (one, two) = contact::impact(
            Contact::Elastic {},
            None,
            &parties[0].body,
            &parties[1].body,
            &normal(&parties),
        );
        let off = error(one, &parties[0].after).max(error(two, &parties[1].after));
        assert!(off <= ROUNDING, "event {i}: {off:e}");
    }
    for (i, parties, wall) in events(name, "ball_linear_cushion") {
        let law = Cushion::Elastic {};
        let off = error(
            cushion::impact(law, &parties[0].body, side(&wall)).motion,
            &parties[0].after,
        );
        assert!(off <= ROUNDING, "event {i}: {off:e}");
    }
}

#[test]
fn cushions_of_the_follow_shot_are_those_of_han() {
    for (i, parties, wall) in events("d4_si_3ball_follow_han", "ball_linear_cushion") {
        let law = Cushion::Han2005 {
            e: 0.85,
            mu: 0.2,
            height: 1.28,
        };
        let rebound = cushion::impact(law, &parties[0].body, side(&wall));
        let off = error(rebound.motion, &parties[0].after);
        assert!(off <= ROUNDING, "event {i}: {off:e}");
    }
}

/// The ball-ball friction of that program: its Coulomb limit is `mu e v_n` per unit of mass, where `J_n / m` is `(1 + e) v_n / 2`.
fn defective(e: f64, mu: f64, one: &Body, two: &Body, n: &Vec3) -> (Motion, Motion) {
    let closing = (one.velocity - two.velocity).dot(n);
    let push = n * (-(1.0 + e) / 2.0 * closing);
    let slip = friction::slip_velocity(one, two, n);
    let rub = -slip * f64::min(mu * e * closing / slip.norm(), 1.0 / 7.0);
    let turn = n.cross(&rub) * (2.5 / R);
    let moved = |body: &Body, sign: f64| Motion {
        velocity: body.velocity + (push + rub) * sign,
        spin: body.spin + turn,
    };
    (moved(one, 1.0), moved(two, -1.0))
}

#[test]
fn the_friction_of_the_follow_shot_is_defective_and_ours_differs_by_the_predicted_impulse() {
    let (e, mu) = (0.95, 0.05);
    for (i, parties, _) in events("d4_si_3ball_follow_han", "ball_ball") {
        let n = normal(&parties);
        let (first, second) = (&parties[0].body, &parties[1].body);
        let (one, two) = defective(e, mu, first, second, &n);
        let reproduced = error(one, &parties[0].after).max(error(two, &parties[1].after));
        assert!(reproduced <= ROUNDING, "event {i}: {reproduced:e}");
        // our law gives the same numbers with a coefficient that is smaller by 2 e / (1 + e)
        let ours = |mu: f64| {
            let friction = Some(Friction::Constant { mu });
            contact::impact(Contact::Inelastic { e }, friction, first, second, &n)
        };
        let (one, two) = ours(mu * 2.0 * e / (1.0 + e));
        let scaled = error(one, &parties[0].after).max(error(two, &parties[1].after));
        assert!(scaled <= ROUNDING, "event {i}: {scaled:e}");
        // with its own coefficient the tangential impulse is larger by mu (1 - e) / 2 v_n while the balls slip
        let closing = (first.velocity - second.velocity).dot(&n);
        let slip = friction::slip_velocity(first, second, &n);
        assert!(slip.norm() / 7.0 > mu * closing, "event {i} does not slip");
        let predicted = slip.normalize() * (-mu * (1.0 - e) / 2.0 * closing);
        let (whole, _) = ours(mu);
        let (defective, _) = defective(e, mu, first, second, &n);
        let difference = whole.velocity - defective.velocity;
        assert!(off(&difference, &predicted) <= ROUNDING, "event {i}");
        assert!(predicted.norm() > 1e-3, "event {i}: {}", predicted.norm());
    }
}
