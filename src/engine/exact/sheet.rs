//! What the engine was told: its side of the parameter-equivalence sheet, and the materials that the audit reads back.

use super::Prepared;
use super::flight::Ground;
use crate::engine::sheet::Role;
use crate::engine::{PairMaterial, Parameter, Partner};
use crate::math::Real;
use crate::physics::{Cloth, Contact, Cushion, Friction, friction};
use crate::scene::Scene;

impl<T: Real> Prepared<'_, T> {
    /// Every parameter that changes physics.
    pub(super) fn parameters(&self) -> Vec<Parameter> {
        let scene = self.scene;
        let unit = &scene.units;
        let (speed, acceleration) = (unit.speed(), unit.acceleration());
        let row = Parameter::new;
        let world = self.solver.balls().world();
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
        sheet.extend(cloth(scene));
        sheet.extend(contact(scene));
        sheet.extend(cushion(scene));
        if let Some(pockets) = &scene.effects.pockets {
            let count = pockets.circles.len().to_string();
            sheet.push(row(Role::Other, "pockets", count, ""));
        }
        sheet.sort_by_key(|parameter| parameter.role);
        sheet
    }

    /// What the engine's laws do, as friction and restitution of every kind of pair.
    pub(super) fn materials(&self, balls: usize) -> Vec<PairMaterial> {
        let world = self.solver.balls().world();
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

fn number(role: Role, name: &str, value: f64) -> Parameter {
    Parameter::new(role, name, value.to_string(), "")
}

fn words(role: Role, name: &str, value: &str) -> Parameter {
    Parameter::new(role, name, value.to_owned(), "")
}

fn cloth(scene: &Scene) -> Vec<Parameter> {
    let mu = |name, value| number(Role::ClothFriction, name, value);
    match scene.effects.cloth {
        Some(Cloth::Translational { mu: of_cloth }) => vec![mu("mu", of_cloth)],
        Some(Cloth::Rotational {
            mu_slide,
            mu_roll,
            mu_spin,
        }) => vec![
            mu("mu_slide", mu_slide),
            mu("mu_roll", mu_roll),
            mu("mu_spin", mu_spin),
        ],
        None => vec![words(Role::ClothFriction, "cloth", "none")],
    }
}

fn contact(scene: &Scene) -> Vec<Parameter> {
    let restitution = |e| number(Role::BallRestitution, "restitution", e);
    let restitution = match scene.effects.contact {
        Some(Contact::Elastic {}) => restitution(1.0),
        Some(Contact::Inelastic { e }) => restitution(e),
        None => return vec![words(Role::BallRestitution, "contact", "none")],
    };
    let friction = match scene.effects.friction {
        None => number(Role::BallFriction, "friction", 0.0),
        Some(Friction::Constant { mu }) => number(Role::BallFriction, "friction", mu),
        Some(Friction::Alciatore { a, b, c, .. }) => words(
            Role::BallFriction,
            "friction",
            &format!("{a} + {b} exp(-{c} u), u in m/s"),
        ),
    };
    vec![restitution, friction]
}

fn cushion(scene: &Scene) -> Vec<Parameter> {
    let Some(law) = scene.effects.cushion else {
        return vec![words(Role::CushionRestitution, "cushion", "none")];
    };
    let (e, mu, height, of_cloth) = match law {
        Cushion::Elastic {} => (1.0, 0.0, None, None),
        Cushion::Restitution { e } => (e, 0.0, None, None),
        Cushion::Han2005 { e, mu, height } => (e, mu, Some(height), None),
        Cushion::Mathavan2010 {
            e,
            mu,
            mu_cloth,
            height,
        } => (e, mu, Some(height), Some(mu_cloth)),
    };
    let mut rows = vec![
        words(Role::CushionRestitution, "law", law.id()),
        number(Role::CushionRestitution, "restitution", e),
        number(Role::CushionFriction, "friction", mu),
    ];
    let height = height.map(|h| h.to_string());
    rows.extend(height.map(|h| Parameter::new(Role::CushionFriction, "height", h, "R")));
    rows.extend(of_cloth.map(|mu| number(Role::CushionFriction, "mu_cloth", mu)));
    rows
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
