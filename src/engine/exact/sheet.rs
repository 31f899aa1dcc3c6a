//! What the engine was told: its side of the parameter-equivalence sheet, and the materials that the audit reads back.

use super::Prepared;
use super::flight::Ground;
use crate::engine::sheet::Role;
use crate::engine::{PairMaterial, Parameter, Partner};
use crate::math::Real;
use crate::physics::{Cloth, Contact, Cushion, Friction, friction};

impl<T: Real> Prepared<'_, T> {
    /// Every parameter that changes physics.
    pub(super) fn parameters(&self) -> Vec<Parameter> {
        let scene = self.scene;
        let unit = &scene.units;
        let (speed, acceleration) = (unit.speed(), unit.acceleration());
        let row =
            |role, name: &str, value: String, unit: &str| Parameter::new(role, name, value, unit);
        let number = |role, name: &str, value: f64| row(role, name, value.to_string(), "");
        let words = |role, name: &str, value: &str| row(role, name, value.to_owned(), "");
        let world = &self.solver.world;
        let rotation = match world.rotation {
            None => "not simulated",
            Some(_) => "uniform solid sphere",
        };
        let mut sheet = vec![
            words(Role::TimeStep, "none", "solves for the time of each event"),
            words(Role::Precision, "precision", self.precision.id()),
            row(
                Role::Gravity,
                "gravity",
                scene.gravity.to_string(),
                &acceleration,
            ),
            row(Role::Mass, "mass", range(&world.mass), &unit.mass),
            row(Role::Radius, "radius", range(&world.radius), &unit.length),
            words(Role::Rotation, "rotation", rotation),
            words(
                Role::ContactDetection,
                "contact",
                "first root of the distance",
            ),
            words(Role::PositionCorrection, "correction", "none"),
            row(Role::Rest, "rest speed", 0.0.to_string(), &speed),
        ];
        if let Some(shot) = scene.shot {
            let launched = scene.balls[shot.ball()].state.speed();
            sheet.push(row(Role::Launch, "speed", launched.to_string(), &speed));
        }
        match scene.effects.cloth {
            Some(Cloth::Translational { mu }) => {
                sheet.push(number(Role::ClothFriction, "mu", mu));
            }
            Some(Cloth::Rotational {
                mu_slide,
                mu_roll,
                mu_spin,
            }) => {
                sheet.push(number(Role::ClothFriction, "mu_slide", mu_slide));
                sheet.push(number(Role::ClothFriction, "mu_roll", mu_roll));
                sheet.push(number(Role::ClothFriction, "mu_spin", mu_spin));
            }
            None => sheet.push(words(Role::ClothFriction, "cloth", "none")),
        }
        match scene.effects.contact {
            Some(Contact::Elastic {}) => {
                sheet.push(number(Role::BallRestitution, "restitution", 1.0));
            }
            Some(Contact::Inelastic { e }) => {
                sheet.push(number(Role::BallRestitution, "restitution", e));
            }
            None => sheet.push(words(Role::BallRestitution, "contact", "none")),
        }
        if scene.effects.contact.is_some() {
            sheet.push(match scene.effects.friction {
                None => number(Role::BallFriction, "friction", 0.0),
                Some(Friction::Constant { mu }) => number(Role::BallFriction, "friction", mu),
                Some(Friction::Alciatore { a, b, c, .. }) => words(
                    Role::BallFriction,
                    "friction",
                    &format!("{a} + {b} exp(-{c} u), u in m/s"),
                ),
            });
        }
        let cushion = |law: &str, e: f64, mu: f64, height: Option<f64>| {
            let mut rows = vec![
                words(Role::CushionRestitution, "law", law),
                number(Role::CushionRestitution, "restitution", e),
                number(Role::CushionFriction, "friction", mu),
            ];
            rows.extend(height.map(|h| row(Role::CushionFriction, "height", h.to_string(), "R")));
            rows
        };
        match scene.effects.cushion {
            Some(law @ Cushion::Elastic {}) => sheet.extend(cushion(law.id(), 1.0, 0.0, None)),
            Some(law @ Cushion::Restitution { e }) => {
                sheet.extend(cushion(law.id(), e, 0.0, None));
            }
            Some(law @ Cushion::Han2005 { e, mu, height }) => {
                sheet.extend(cushion(law.id(), e, mu, Some(height)));
            }
            Some(
                law @ Cushion::Mathavan2010 {
                    e,
                    mu,
                    mu_cloth,
                    height,
                },
            ) => {
                sheet.extend(cushion(law.id(), e, mu, Some(height)));
                sheet.push(number(Role::CushionFriction, "mu_cloth", mu_cloth));
            }
            None => sheet.push(words(Role::CushionRestitution, "cushion", "none")),
        }
        if let Some(pockets) = &scene.effects.pockets {
            let count = pockets.circles.len().to_string();
            sheet.push(row(Role::Other, "pockets", count, ""));
        }
        sheet.sort_by_key(|parameter| parameter.role);
        sheet
    }

    /// What the engine's laws do, as friction and restitution of every kind of pair.
    pub(super) fn materials(&self, balls: usize) -> Vec<PairMaterial> {
        let world = &self.solver.world;
        let rub = world
            .friction
            .map_or(0.0, |law| friction::coefficient(law, T::zero()).to_f64());
        let contact = match world.contact {
            Some(Contact::Elastic {}) => Some((rub, 1.0)),
            Some(Contact::Inelastic { e }) => Some((rub, e.to_f64())),
            None => None,
        };
        let cushion = match world.cushion {
            Some(Cushion::Elastic {}) => Some((0.0, 1.0)),
            Some(Cushion::Restitution { e }) => Some((0.0, e.to_f64())),
            Some(Cushion::Han2005 { e, mu, .. } | Cushion::Mathavan2010 { e, mu, .. }) => {
                Some((mu.to_f64(), e.to_f64()))
            }
            None => None,
        };
        // what acts is mu g; the scene's gravity makes it comparable
        let per_gravity = |deceleration: T| deceleration.to_f64() / self.scene.gravity;
        let cloth = match (&world.rotation, world.ground) {
            (_, Ground::Coulomb(deceleration)) => per_gravity(deceleration),
            (Some(rotation), _) if !rotation.slide.is_zero() => per_gravity(rotation.slide),
            _ => self.scene.effects.cloth.map_or(0.0, |cloth| match cloth {
                Cloth::Translational { mu } => mu,
                Cloth::Rotational { mu_slide, .. } => mu_slide,
            }),
        };
        let pairs = [
            (Partner::Ball, contact),
            (Partner::Cushion, cushion),
            (Partner::Cloth, Some((cloth, 0.0))),
        ];
        let mut found = Vec::new();
        for ball in 0..balls {
            for (partner, material) in pairs {
                found.extend(material.map(|(friction, restitution)| PairMaterial {
                    ball,
                    partner,
                    friction,
                    restitution,
                }));
            }
        }
        found
    }
}

/// One number if all are equal, else the smallest and the largest.
fn range<T: Real>(values: &[T]) -> String {
    let numbers = values.iter().map(|x| x.to_f64());
    let (least, most) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| {
        (a.min(x), b.max(x))
    });
    if least == most {
        least.to_string()
    } else {
        format!("{least} to {most}")
    }
}
