//! Rows of the parameter-equivalence sheet: rapier's own names and values for everything that changes physics.

use super::materials;
use super::settings::Settings;
use crate::engine::stepped::{rest_speed, slip_rest};
use crate::engine::{Inside, Parameter, Partner, Role};
use crate::physics::{self, Cloth};
use crate::scene::Scene;

/// Every parameter that changes physics; materials, masses and motion as read back from `inside`.
pub(super) fn sheet(
    scene: &Scene,
    settings: &Settings,
    inside: &Inside,
    gravity: f64,
) -> Vec<Parameter> {
    let mut rows = Rows {
        rows: Vec::new(),
        length: scene.units.length.clone(),
        time: scene.units.time.clone(),
        mass: scene.units.mass.clone(),
    };
    rows.time(settings);
    let precision = if inside.ulp == f64::EPSILON {
        "f64"
    } else {
        "f32"
    };
    rows.add(Role::Precision, "Real", precision, "");
    rows.balls(scene, inside, gravity);
    rows.materials(scene, inside);
    rows.explicit(scene, settings, inside.ulp);
    rows.contacts(settings);
    rows.rest_and_other(scene, settings);
    rows.rows
}

struct Rows {
    rows: Vec<Parameter>,
    length: String,
    time: String,
    mass: String,
}

impl Rows {
    fn add(&mut self, role: Role, name: &str, value: impl ToString, unit: &str) {
        self.rows.push(Parameter::new(role, name, value, unit));
    }

    fn time(&mut self, settings: &Settings) {
        let unit = self.time.clone();
        self.add(Role::TimeStep, "dt", settings.dt, &unit);
        self.add(
            Role::TimeStep,
            "num_solver_iterations (substeps)",
            settings.substeps,
            "",
        );
    }

    fn balls(&mut self, scene: &Scene, inside: &Inside, gravity: f64) {
        let (length, time, mass) = (self.length.clone(), self.time.clone(), self.mass.clone());
        let cue = scene.cue_ball();
        let linvel = inside.balls.get(cue).map(|ball| ball.state.velocity);
        let linvel = linvel.map_or(String::new(), |v| format!("({}, {}, {})", v.x, v.y, v.z));
        self.add(
            Role::Launch,
            &format!("linvel of ball {}", scene.balls[cue].id),
            linvel,
            &format!("{length}/{time}"),
        );
        self.add(
            Role::Gravity,
            "gravity along -z",
            gravity,
            &format!("{length}/{time}^2"),
        );
        let masses = inside.balls.iter().map(|ball| ball.mass);
        self.add(Role::Mass, "collider mass", range(masses), &mass);
        let radii = inside.balls.iter().map(|ball| ball.radius);
        self.add(Role::Radius, "ball shape radius", range(radii), &length);
        let locked = inside.inertia.iter().all(Option::is_none);
        let rotation = if locked { "ROTATION_LOCKED" } else { "none" };
        self.add(Role::Rotation, "locked_axes", rotation, "");
    }

    fn materials(&mut self, scene: &Scene, inside: &Inside) {
        let effects = &scene.effects;
        let ball = materials::ball(effects);
        let partners = [
            (
                Partner::Cloth,
                "the half-space",
                materials::cloth(effects),
                Role::ClothFriction,
                Role::ClothFriction,
            ),
            (
                Partner::Ball,
                "two balls",
                Some(ball),
                Role::BallFriction,
                Role::BallRestitution,
            ),
            (
                Partner::Cushion,
                "a cushion",
                materials::cushion(effects),
                Role::CushionFriction,
                Role::CushionRestitution,
            ),
        ];
        for (partner, with, material, friction_role, restitution_role) in partners {
            let met = || inside.materials.iter().filter(|m| m.partner == partner);
            let material = material.filter(|_| met().next().is_some());
            let Some(material) = material else {
                self.add(
                    restitution_role,
                    &format!("restitution of {with}"),
                    "no contact",
                    "",
                );
                continue;
            };
            let rule = ball.friction.rule.between(material.friction.rule).name();
            let name = format!("friction of {with}, rule {rule}");
            self.add(friction_role, &name, range(met().map(|m| m.friction)), "");
            let rule = ball.restitution.rule.between(material.restitution.rule);
            let name = format!("restitution of {with}, rule {}", rule.name());
            let values = range(met().map(|m| m.restitution));
            self.add(restitution_role, &name, values, "");
        }
        if let Some(law @ physics::Friction::Alciatore { a, b, c, .. }) = effects.friction {
            self.add(
                Role::BallFriction,
                "modify_solver_contacts: friction at the slip speed of each step",
                format!("{}: {a} + {b} exp(-{c} u)", law.id()),
                "u in m/s",
            );
        }
    }

    /// What is added to rapier, and what it does of itself that the laws do not.
    fn explicit(&mut self, scene: &Scene, settings: &Settings, ulp: f64) {
        let speed = format!("{}/{}", self.length, self.time);
        if let Some(Cloth::Rotational {
            mu_roll, mu_spin, ..
        }) = scene.effects.cloth
        {
            let role = Role::ClothFriction;
            let name = "explicit force and torque on a rolling ball, of mu_roll m g";
            self.add(role, name, mu_roll, "mu_roll");
            let name = "explicit torque about the vertical, of mu_spin m g R";
            self.add(role, name, mu_spin, "mu_spin");
            let rest = slip_rest(scene, ulp);
            self.add(role, "rolls at or below a slip of", rest, &speed);
            self.add(Role::Rest, "spin about z ends at R w of", rest, &speed);
        }
        if scene.effects.rotates() {
            let cap = if settings.allow_fast_rotation {
                "none".to_owned()
            } else {
                "pi/4 a step".to_owned()
            };
            self.add(Role::Rotation, "cap of the rotation", cap, "");
        }
        if scene.effects.friction.is_some() {
            let role = Role::BallFriction;
            let name = "normal impulse that friction is limited by";
            self.add(role, name, "without the part of restitution", "");
            let name = "vertical velocity after an impact";
            self.add(role, name, "kept: a ball hops or is pressed down", "");
        }
        if scene.effects.pockets.is_some() {
            let name = "pockets: centre on its way of a step";
            self.add(Role::Other, name, "looked at by the workbench", "");
        }
    }

    fn contacts(&mut self, settings: &Settings) {
        let length = self.length.clone();
        let role = Role::ContactDetection;
        self.add(
            role,
            "normalized_prediction_distance",
            settings.prediction_distance,
            "length_unit",
        );
        self.add(role, "contact_recycling", settings.contact_recycling, "");
        if settings.contact_recycling {
            self.add(
                role,
                "normalized_contact_recycle_distance",
                settings.contact_recycle_distance,
                "length_unit",
            );
        }
        self.add(role, "contact_clustering", settings.contact_clustering, "");
        self.add(role, "ccd", word(&settings.ccd), "");
        self.add(
            role,
            "soft_ccd_prediction",
            settings.soft_ccd_prediction,
            &length,
        );
        let role = Role::PositionCorrection;
        let springs = [
            (
                "contact_softness.natural_frequency",
                settings.contact_natural_frequency,
                "Hz",
            ),
            (
                "contact_softness.damping_ratio",
                settings.contact_damping_ratio,
                "",
            ),
            (
                "static_contact_softness.natural_frequency",
                settings.static_contact_natural_frequency,
                "Hz",
            ),
            (
                "static_contact_softness.damping_ratio",
                settings.static_contact_damping_ratio,
                "",
            ),
        ];
        for (name, value, unit) in springs {
            self.add(role, name, value, unit);
        }
        self.add(
            role,
            "normalized_max_corrective_velocity",
            settings.max_corrective_velocity,
            "length_unit/s",
        );
        self.add(
            role,
            "normalized_allowed_linear_error",
            settings.allowed_linear_error,
            "length_unit",
        );
    }

    fn rest_and_other(&mut self, scene: &Scene, settings: &Settings) {
        let speed = format!("{}/{}", self.length, self.time);
        self.add(Role::Rest, "stopped at or below", rest_speed(scene), &speed);
        self.add(Role::Rest, "can_sleep", settings.can_sleep, "");
        let role = Role::Other;
        let unit = format!("{} per metre", self.length);
        self.add(role, "length_unit", settings.length_unit, &unit);
        let cap = if settings.normalized_max_linear_velocity == f64::MAX {
            "none".to_owned()
        } else {
            settings.normalized_max_linear_velocity.to_string()
        };
        self.add(role, "normalized_max_linear_velocity", cap, "length_unit/s");
        self.add(
            role,
            "num_internal_pgs_iterations",
            settings.internal_iterations,
            "",
        );
        self.add(
            role,
            "num_internal_stabilization_iterations",
            settings.stabilization_iterations,
            "",
        );
        self.add(
            role,
            "warmstart_coefficient",
            settings.warmstart_coefficient,
            "",
        );
        self.add(
            role,
            "friction_in_bias_pass",
            settings.friction_in_bias_pass,
            "",
        );
        self.add(role, "friction_model", word(&settings.friction_model), "");
        self.add(
            role,
            "allow_fast_rotation",
            settings.allow_fast_rotation,
            "",
        );
    }
}

/// One number, or the smallest and the largest where they differ.
fn range(values: impl Iterator<Item = f64>) -> String {
    let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), x| {
        (l.min(x), m.max(x))
    });
    if least == most {
        least.to_string()
    } else {
        format!("{least} to {most}")
    }
}

/// A choice as it is written after `=`.
fn word(choice: &impl serde::Serialize) -> String {
    match serde_json::to_value(choice) {
        Ok(serde_json::Value::String(word)) => word,
        _ => String::new(),
    }
}
