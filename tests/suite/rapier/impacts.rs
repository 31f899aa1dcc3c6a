//! Impacts with losses, friction and turning balls: rapier against the laws, and what it makes of them instead.

use super::effects::{POOL_R, everything, pool, with_cloth};
use super::{BOTH, cut_shot, final_energy, final_momentum, final_velocity, rack};
use crate::support::{R, run, scenario};
use carom::engine::{self, Setting};
use carom::math::Vec3;
use carom::physics::{Cloth, Contact, Cushion, Friction, friction};
use carom::scene::Scene;
use carom::trace::{Record, Trace};

/// What the position of a hit within a step may turn its direction by: the normal is that of the step's start.
fn turned(cut: f64, speed: f64, dt: f64, radius: f64) -> f64 {
    1.3 * cut.sin() * speed * dt / (2.0 * radius)
}

#[test]
fn a_hit_keeps_the_share_e_of_the_closing_speed_at_any_speed_and_step() {
    for (engine, tolerance) in BOTH {
        for e in [0.0, 0.1, 0.5, 0.9, 0.95, 1.0] {
            for (speed, dt) in [0.05, 0.3, 3.0]
                .into_iter()
                .flat_map(|v| [(v, 1.0 / 60.0), (v, 1e-3)])
            {
                for (phase, mass) in [(0.0, 0.107), (0.3, 0.107), (0.7, 0.3)] {
                    let lead = 0.05 + phase * speed * dt;
                    let shot = cut_shot(0.0, speed, lead).with_mass(mass);
                    let mut scene = shot.duration(lead / speed + 20.0 * dt).build();
                    scene.effects.contact = Some(Contact::Inelastic { e });
                    let trace = run(engine, &[&format!("dt={dt}")], &scene, Record::Events);
                    let case = format!("{engine}, e {e}, v {speed}, dt {dt}, mass {mass}");
                    let parting = final_velocity(&trace, 1).x - final_velocity(&trace, 0).x;
                    assert!(
                        (parting / speed - e).abs() <= tolerance,
                        "{case}: parts at {} of the speed",
                        parting / speed
                    );
                    let p = final_momentum(&scene, &trace).x / (0.107 * speed);
                    assert!((p - 1.0).abs() <= tolerance, "{case}: momentum {p}");
                    let reduced = 0.107 * mass / (0.107 + mass);
                    let lost = 0.5 * (1.0 - e * e) * reduced * speed * speed;
                    let got = scene.initial_energy() - final_energy(&scene, &trace);
                    assert!(
                        (got - lost).abs() <= tolerance * scene.initial_energy(),
                        "{case}: lost {got}, law {lost}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_cushion_returns_the_share_e_whatever_the_balls_are_made_of() {
    for (engine, tolerance) in BOTH {
        for (e, balls) in [
            (0.85, 0.95),
            (0.95, 0.5),
            (0.5, 1.0),
            (0.0, 0.9),
            (1.0, 0.2),
        ] {
            for (v, dt) in [
                ([3.0, 1.0], 1e-3),
                ([0.3, -0.1], 1e-3),
                ([0.05, 0.0], 1.0 / 60.0),
            ] {
                let ball = scenario("cushion").moving("cue", [3.6, 2.0], v);
                let mut scene = ball.cushions(4.0, 4.0).duration(0.4 / v[0]).build();
                scene.effects.contact = Some(Contact::Inelastic { e: balls });
                scene.effects.cushion = Some(Cushion::Restitution { e });
                let trace = run(engine, &[&format!("dt={dt}")], &scene, Record::Events);
                let case = format!("{engine}, e {e}, balls {balls}, v {v:?}");
                let got = final_velocity(&trace, 0);
                let want = Vec3::new(-e * v[0], v[1], 0.0);
                assert!(
                    (got - want).norm() <= tolerance * v[0],
                    "{case}: {got:?}, law {want:?}"
                );
            }
        }
    }
}

#[test]
fn a_row_of_touching_balls_loses_more_energy_than_its_restitution_takes() {
    // below 1 only contacts that are new in a step bounce, and one that the step before pressed is not new
    let kept = |e: f64| {
        let mut row = scenario("cradle").moving("cue", [-1.0, 0.0], [5.0, 0.0]);
        for k in 0..4 {
            row = row.resting(&k.to_string(), [2.0 * R * f64::from(k), 0.0]);
        }
        let mut scene = row.duration(0.5).build();
        scene.effects.contact = Some(Contact::Inelastic { e });
        let trace = run("rapier-f64", &[], &scene, Record::Final);
        final_energy(&scene, &trace) / scene.initial_energy()
    };
    let (elastic, barely) = (kept(1.0), kept(0.999));
    assert!((0.43..0.95).contains(&elastic), "e 1 keeps {elastic}");
    // four hits one after the other would keep 0.996
    assert!((0.2..0.9).contains(&barely), "e .999 keeps {barely}");
    assert!(barely < 0.9 * elastic, "{barely} and {elastic}");
}

/// A stun shot without cloth at speed 1.
#[derive(Clone, Copy)]
struct Stun {
    cut_deg: f64,
    law: Friction,
    e: f64,
    /// About the vertical.
    spin: f64,
    dt: f64,
    /// Where in a step the hit falls.
    phase: f64,
}

impl Stun {
    fn new(cut_deg: f64, mu: f64) -> Self {
        Stun {
            cut_deg,
            law: Friction::Constant { mu },
            e: 1.0,
            spin: 0.0,
            dt: 1e-4,
            phase: 0.5,
        }
    }

    /// Tangential over normal velocity of the object ball: the tangent of the angle of throw.
    fn throw(self, engine: &str) -> (f64, Trace) {
        let cut = self.cut_deg.to_radians();
        let mut scene = pool_cut(cut, 1.0, 0.03 + self.phase * self.dt);
        scene.effects.contact = Some(Contact::Inelastic { e: self.e });
        scene.effects.friction = Some(self.law);
        scene.balls[0].state.spin.z = self.spin;
        let trace = run(
            engine,
            &[&format!("dt={}", self.dt)],
            &scene,
            Record::Events,
        );
        let v = final_velocity(&trace, 1);
        let normal = v.x * cut.cos() + v.y * cut.sin();
        let across = v.x * cut.sin() - v.y * cut.cos();
        (across / normal, trace)
    }

    /// What the place of the hit within a step may change.
    fn bound(self) -> f64 {
        turned(self.cut_deg.to_radians(), 1.0, self.dt, POOL_R)
    }
}

/// A pool ball that meets another at the angle `cut`.
fn pool_cut(cut: f64, speed: f64, lead: f64) -> Scene {
    let from = [-2.0 * POOL_R * cut.cos() - lead, -2.0 * POOL_R * cut.sin()];
    let balls = scenario("cut").moving("cue", from, [speed, 0.0]);
    pool(balls.resting("1", [0.0, 0.0]).duration(lead / speed + 0.01))
}

#[test]
fn a_slipping_stun_shot_throws_by_mu_over_one_plus_e_and_not_by_mu() {
    // rapier limits friction by the normal impulse that stops the approach; restitution acts after it, with 1 + e times as much
    for (engine, rounding) in [("rapier-f64", 0.0), ("rapier-f32", 4e-3)] {
        for (cut, e, mu) in [
            (20.0, 1.0, 0.05),
            (45.0, 1.0, 0.05),
            (45.0, 0.9, 0.08),
            (60.0, 0.5, 0.05),
        ] {
            let shot = Stun {
                e,
                ..Stun::new(cut, mu)
            };
            let bound = shot.bound() + rounding;
            let (got, trace) = shot.throw(engine);
            let native = mu / (1.0 + e);
            assert!(
                (got - native).abs() <= bound,
                "{engine}, cut {cut}, e {e}: throws {got}, expected {native} to {bound}"
            );
            assert!(
                mu - got > 2.0 * bound,
                "{engine}, cut {cut}, e {e}: the law's {got}"
            );
            // the same scene with a coefficient 1 + e times as large throws as the law does with mu
            let law = Friction::Constant { mu: mu * (1.0 + e) };
            let (got, _) = Stun { law, ..shot }.throw(engine);
            assert!(
                (got - mu).abs() <= (1.0 + e) * bound,
                "{engine}, cut {cut}, e {e}: scaled throws {got}, law {mu} to {bound}"
            );
            // both balls turn the same way, as one impulse at arms R does
            let spins = [0, 1].map(|i| trace.final_states()[i].unwrap().spin.z);
            assert!(
                (spins[0] - spins[1]).abs() <= 1e-5 * spins[0].abs() && spins[0] != 0.0,
                "{engine}: {spins:?}"
            );
        }
    }
}

#[test]
fn a_hit_in_the_last_substep_throws_less_whatever_the_step() {
    // the first substep that could reach the other ball takes the part of the approach that the gap does not need, the next one the
    // rest; of a hit in the last substep the rest is left to restitution, which has no friction
    for (substeps, seldom, often) in [(1, 24, 32), (4, 4, 12), (16, 0, 4)] {
        for dt in [1e-4, 1e-5] {
            let throws: Vec<f64> = (0..32)
                .map(|k| {
                    let cut = f64::to_radians(30.0);
                    let lead = 0.03 + (f64::from(k) + 0.5) / 32.0 * dt;
                    let mut scene = pool_cut(cut, 1.0, lead);
                    scene.effects.friction = Some(Friction::Constant { mu: 0.05 });
                    scene.duration = lead + 20.0 * dt;
                    let settings = [format!("dt={dt}"), format!("substeps={substeps}")];
                    let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
                    let v =
                        final_velocity(&run("rapier-f64", &settings, &scene, Record::Events), 1);
                    (v.x * cut.sin() - v.y * cut.cos()) / (v.x * cut.cos() + v.y * cut.sin())
                })
                .collect();
            let (least, most) = throws
                .iter()
                .fold((f64::INFINITY, 0.0_f64), |(l, m), x| (l.min(*x), m.max(*x)));
            // the earliest of the 32 is a 64th of a step late
            let bound = turned(f64::to_radians(30.0), 1.0, dt, POOL_R) + 0.025 / 64.0;
            let case = format!("{substeps} substeps, dt {dt}: {least} to {most}");
            assert!((most - 0.025).abs() <= bound, "{case}, bound {bound}");
            assert!(least < 0.5 * most, "{case}");
            let weak = throws.iter().filter(|x| **x < 0.9 * most).count();
            assert!((seldom..=often).contains(&weak), "{case}: {weak} of 32");
        }
    }
}

#[test]
fn a_sticking_stun_shot_throws_by_two_sevenths_over_one_plus_e() {
    for (engine, rounding) in [("rapier-f64", 0.0), ("rapier-f32", 4e-3)] {
        for (cut, e) in [(5.0, 1.0), (12.0, 1.0), (12.0, 0.8)] {
            let shot = Stun {
                e,
                ..Stun::new(cut, 0.2)
            };
            let (got, _) = shot.throw(engine);
            let law = 2.0 * f64::to_radians(cut).tan() / (7.0 * (1.0 + e));
            let bound = shot.bound() + rounding;
            assert!(
                (got - law).abs() <= bound,
                "{engine}, cut {cut}, e {e}: throws {got}, law {law} to {bound}"
            );
        }
    }
}

#[test]
fn gearing_spin_throws_nothing_and_twice_as_much_throws_the_other_way() {
    let shot = Stun::new(30.0, 0.05);
    // the cue ball's surface passes the object ball's at sin(cut): a spin of that over R takes it away
    let gearing = f64::to_radians(30.0).sin() / POOL_R;
    let at = |spin| Stun { spin, ..shot }.throw("rapier-f64").0;
    let (geared, none, twice) = (at(gearing), at(0.0), at(2.0 * gearing));
    let bound = shot.bound();
    assert!(geared.abs() <= bound, "{geared}, bound {bound}");
    assert!(
        (none - 0.025).abs() <= bound && (twice + 0.025).abs() <= bound,
        "{none}, {twice}"
    );
}

#[test]
fn friction_that_depends_on_the_slip_speed_is_that_of_the_hit() {
    let law = Friction::Alciatore {
        a: 9.951e-3,
        b: 0.108,
        c: 1.088,
        length_in_metres: 1.0,
    };
    for (engine, rounding) in [("rapier-f64", 0.0), ("rapier-f32", 4e-3)] {
        for cut in [45.0, 60.0] {
            let shot = Stun {
                law,
                ..Stun::new(cut, 0.0)
            };
            let slip = f64::to_radians(cut).sin();
            let native = friction::coefficient(law, slip) / 2.0;
            let bound = shot.bound() + rounding;
            let (got, _) = shot.throw(engine);
            assert!(
                (got - native).abs() <= bound,
                "{engine}, cut {cut}: throws {got}, expected {native} to {bound}"
            );
            // the coefficient of balls that stick, which the audit reads, would throw more
            let sticking = friction::coefficient(law, 0.0) / 2.0;
            assert!(sticking - got > bound, "{engine}, cut {cut}: {got}");
        }
    }
}

/// Direction of a rolling cue ball once it rolls again after a hit at the angle `cut`, radians.
fn deflection(engine: &str, cut: f64, dt: f64, phase: f64) -> f64 {
    let speed = 2.0;
    let lead = 0.05 + speed * dt * phase;
    let mut scene = with_cloth(pool_cut(cut, speed, lead), 0.0);
    scene.balls[0].state.spin.y = speed / POOL_R;
    scene.duration = 0.8;
    let trace = run(engine, &[&format!("dt={dt}")], &scene, Record::Events);
    let v = final_velocity(&trace, 0);
    let turned = final_velocity(&trace, 0).xy().norm();
    assert!(turned > 0.1, "{engine}: {v:?}");
    -v.y.atan2(v.x)
}

#[test]
fn a_rolling_cue_ball_is_deflected_as_the_closed_form_says() {
    for (engine, rounding) in [("rapier-f64", 0.0), ("rapier-f32", 2e-3)] {
        for cut_deg in [14.4775, 28.13, 30.0, 48.59] {
            let cut = f64::to_radians(cut_deg);
            let law = (cut.sin() * cut.cos()).atan2(cut.sin().powi(2) + 0.4);
            let dt = 5e-4;
            // the angle follows the normal by at most 1: d(law)/d(cut) is between -1 and 1 here
            let bound = turned(cut, 2.0, dt, POOL_R) + 2.0 * dt + rounding;
            for phase in [0.0, 0.25, 0.5, 0.75] {
                let got = deflection(engine, cut, dt, phase);
                assert!(
                    (got - law).abs() <= bound,
                    "{engine}, cut {cut_deg}: deflected by {got}, law {law} to {bound}"
                );
            }
        }
    }
}

#[test]
fn the_deflection_converges_at_first_order() {
    let cut = f64::to_radians(48.59);
    let law = (cut.sin() * cut.cos()).atan2(cut.sin().powi(2) + 0.4);
    let error = |dt: f64| {
        let phases = (0..8).map(|k| f64::from(k) / 8.0);
        let errors = phases.map(|phase| (deflection("rapier-f64", cut, dt, phase) - law).abs());
        errors.sum::<f64>() / 8.0
    };
    let (coarse, fine) = (error(2e-3), error(2.5e-4));
    let order = (coarse / fine).log2() / 3.0;
    assert!(
        (order - 1.0).abs() <= 0.3,
        "order {order}: {coarse}, {fine}"
    );
}

#[test]
fn friction_of_a_rolling_ball_makes_it_hop_where_the_laws_drop_the_vertical_velocity() {
    // of eight hits all over the step: one in the last substep rubs less
    let (mut lifted, mut pressed) = (0.0_f64, 0.0_f64);
    for phase in 0..8 {
        let dt = 1.25e-4;
        let lead = 0.05 + 2.0 * dt * (f64::from(phase) + 0.5) / 8.0;
        let mut scene = with_cloth(pool_cut(0.0, 2.0, lead), 0.01);
        scene.effects.friction = Some(Friction::Constant { mu: 0.05 });
        scene.balls[0].state.spin.y = 2.0 / POOL_R;
        let trace = run("rapier-f64", &["dt=1.25e-4"], &scene, Record::Every(dt));
        let highest = |i: usize| {
            let knots = trace.paths[i].knots.iter();
            knots.fold(0.0_f64, |h, knot| h.max(knot.state.velocity.z))
        };
        lifted = lifted.max(highest(0));
        pressed = pressed.max(highest(1));
    }
    // mu times the part of the normal impulse that friction sees, v/2; the ball that is hit is pressed down instead
    assert!((0.8..1.2).contains(&(lifted / (0.05 * 1.0))), "{lifted} up");
    assert!(pressed < 0.1 * lifted, "{pressed} up");
}

#[test]
fn the_audit_finds_the_materials_of_the_scene_whichever_is_larger() {
    for (id, _) in BOTH {
        let rapier = crate::support::find(id).unwrap();
        for mu_slide in [0.0, 0.05, 0.4] {
            for mu in [0.0, 0.05, 0.3] {
                for (balls, cushion) in [(0.0, 0.9), (0.9, 0.0), (0.5, 0.5), (1.0, 0.7)] {
                    let mut scene = everything();
                    scene.effects.cloth = Some(Cloth::Rotational {
                        mu_slide,
                        mu_roll: 0.01,
                        mu_spin: 0.01,
                    });
                    scene.effects.friction = Some(Friction::Constant { mu });
                    scene.effects.contact = Some(Contact::Inelastic { e: balls });
                    scene.effects.cushion = Some(Cushion::Restitution { e: cushion });
                    let prepared = engine::prepare(rapier.as_ref(), &scene, &Setting::default());
                    assert!(
                        prepared.is_ok(),
                        "{id}: mu {mu_slide}, {mu}, e {balls}, {cushion}: {:?}",
                        prepared.err()
                    );
                }
            }
        }
    }
}

#[test]
fn a_scene_without_turning_balls_is_told_of_nothing_that_is_added() {
    let cue = scenario("break").moving("cue", [0.0, -1.0], [0.0, 5.0]);
    let scene = rack(cue, [0.0, 0.0], 2, 1e-3).cloth(0.2).build();
    for (id, _) in BOTH {
        let run = engine::prepare(
            crate::support::find(id).unwrap().as_ref(),
            &scene,
            &Setting::default(),
        )
        .unwrap();
        let sheet = run.sheet();
        assert!(!sheet.is_empty(), "{id}");
        let added = sheet.iter().find(|row| row.name.contains("explicit"));
        assert_eq!(added, None, "{id}");
    }
}
