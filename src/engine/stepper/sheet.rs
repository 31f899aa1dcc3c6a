//! What the stepper says of itself before it runs: what it holds, for the audit, and every parameter that changes physics.

use super::balls::Balls;
use super::{ContactRule, Launch, Settings};
use crate::engine::{Inside, PairMaterial, Parameter, Partner as Meets, Role};
use crate::physics::{Cloth, Contact, Cushion, Effects, Friction, friction};
use crate::scene::{Scene, Shot};

/// What is inside a run, read back from its arrays and from the laws that its loop applies. `scene`: for what a run has no use for, the ids
/// of the balls and their heights.
pub fn inside(scene: &Scene, settings: &Settings, held: &Balls, laws: &Effects) -> Inside {
    let energy = (0..held.len()).map(|i| held.energy(i)).sum();
    let mut balls = scene.balls.clone();
    let mut inertia = vec![None; balls.len()];
    for (i, &ball) in held.scene_index.iter().enumerate() {
        balls[ball].state = held.state(i);
        balls[ball].mass = held.mass[i];
        balls[ball].radius = held.radius[i];
        inertia[ball] = held.rotation.get(i).map(|rotation| rotation.inertia);
    }
    let met = met(laws);
    let materials = (0..balls.len()).flat_map(|ball| {
        met.iter()
            .map(move |&(partner, friction, restitution)| PairMaterial {
                ball,
                partner,
                friction,
                restitution,
            })
    });
    Inside {
        materials: materials.collect(),
        inertia,
        balls,
        energy,
        ulp: f64::EPSILON,
        contact_time: match settings.launch {
            Launch::ContactTime => None,
            Launch::AsWritten => Some(settings.dt),
        },
    }
}

/// Friction and restitution of a ball with everything it can meet. Friction that depends on the slip speed: that of balls
/// that stick.
fn met(effects: &Effects) -> Vec<(Meets, f64, f64)> {
    let mut met = Vec::new();
    if let Some(contact) = effects.contact {
        let restitution = match contact {
            Contact::Elastic {} => 1.0,
            Contact::Inelastic { e } => e,
        };
        let rubbing = effects.friction;
        let mu = rubbing.map_or(0.0, |law| friction::coefficient(law, 0.0));
        met.push((Meets::Ball, mu, restitution));
    }
    if let Some(cloth) = effects.cloth {
        let mu = match cloth {
            Cloth::Translational { mu } => mu,
            Cloth::Rotational { mu_slide, .. } => mu_slide,
        };
        met.push((Meets::Cloth, mu, 0.0));
    }
    if let Some(cushion) = effects.cushion {
        let (mu, restitution) = match cushion {
            Cushion::Elastic {} => (0.0, 1.0),
            Cushion::Restitution { e } => (0.0, e),
            Cushion::Han2005 { e, mu, .. } | Cushion::Mathavan2010 { e, mu, .. } => (mu, e),
        };
        met.push((Meets::Cushion, mu, restitution));
    }
    met
}

/// Every parameter that changes physics.
pub fn sheet(scene: &Scene, settings: &Settings) -> Vec<Parameter> {
    let rotation = if scene.effects.rotates() {
        "free"
    } else {
        "none"
    };
    let mut sheet = vec![
        Parameter::new(Role::TimeStep, "dt", settings.dt, "s"),
        Parameter::new(Role::Precision, "scalar", "f64", ""),
        Parameter::new(Role::Rotation, "rotation", rotation, ""),
        Parameter::new(
            Role::PositionCorrection,
            "walls",
            "a ball past a wall is moved to it",
            "",
        ),
        Parameter::new(Role::Rest, "speed clamped at", 0, &scene.units.speed()),
    ];
    let launch = launch(scene, settings);
    sheet.push(Parameter::new(Role::Launch, "launch", launch, ""));
    balls(scene, settings, &mut sheet);
    cloth(scene, &mut sheet);
    cushions(scene, &mut sheet);
    if let Some(pockets) = &scene.effects.pockets {
        let value = format!(
            "{} circles, tested at the end of a step",
            pockets.circles.len()
        );
        sheet.push(Parameter::new(Role::Other, "pockets", value, ""));
    }
    sheet
}

fn launch(scene: &Scene, settings: &Settings) -> String {
    match (scene.shot, settings.launch) {
        (Some(Shot::Force { force, .. }), Launch::AsWritten) => format!("{force} * dt / m"),
        (
            Some(Shot::Force {
                force,
                contact_time,
                ..
            }),
            Launch::ContactTime,
        ) => {
            format!("{force} * {contact_time} s / m")
        }
        (Some(Shot::Strike { .. }), _) => "velocity and spin of the scene's strike".to_owned(),
        (Some(Shot::Velocity { .. }) | None, _) => "velocity of the scene".to_owned(),
    }
}

fn balls(scene: &Scene, settings: &Settings, sheet: &mut Vec<Parameter>) {
    let Some(contact) = scene.effects.contact else {
        return;
    };
    let detection = match settings.contact {
        ContactRule::AsWritten => "overlap at a step, every step",
        ContactRule::ApproachingOnly => "overlap at a step, if approaching",
    };
    let mut row = |role, name: &str, value: &str| {
        sheet.push(Parameter::new(role, name, value, ""));
    };
    row(Role::ContactDetection, "contact", detection);
    let friction = scene.effects.friction;
    match contact {
        Contact::Elastic {} if friction.is_none() => {
            row(
                Role::BallRestitution,
                "exchange of normal velocities",
                "e = 1",
            );
        }
        Contact::Elastic {} => row(Role::BallRestitution, "elastic impulse", "e = 1"),
        Contact::Inelastic { e } => {
            row(
                Role::BallRestitution,
                "impulse with loss",
                &format!("e = {e}"),
            );
        }
    }
    match friction {
        None => row(Role::BallFriction, "tangential impulse", "0"),
        Some(Friction::Constant { mu }) => {
            row(Role::BallFriction, "mu", &mu.to_string());
        }
        Some(Friction::Alciatore {
            a,
            b,
            c,
            length_in_metres,
        }) => {
            let value = format!("{a} + {b} exp(-{c} u), u in units of {length_in_metres} m/s");
            row(Role::BallFriction, "mu of slip speed u", &value);
        }
    }
}

fn cloth(scene: &Scene, sheet: &mut Vec<Parameter>) {
    let Some(cloth) = scene.effects.cloth else {
        return;
    };
    let coefficients = match cloth {
        Cloth::Translational { mu } => vec![("mu", mu)],
        Cloth::Rotational {
            mu_slide,
            mu_roll,
            mu_spin,
        } => vec![
            ("mu_slide", mu_slide),
            ("mu_roll", mu_roll),
            ("mu_spin", mu_spin),
        ],
    };
    for (name, mu) in coefficients {
        sheet.push(Parameter::new(Role::ClothFriction, name, mu, ""));
    }
    let unit = scene.units.acceleration();
    sheet.push(Parameter::new(Role::Gravity, "g", scene.gravity, &unit));
}

fn cushions(scene: &Scene, sheet: &mut Vec<Parameter>) {
    let Some(cushion) = scene.effects.cushion else {
        return;
    };
    let ((name, restitution), (kind, friction)) = match cushion {
        Cushion::Elastic {} => (
            ("component turned inward", "e = 1".to_owned()),
            ("tangential impulse", "0".to_owned()),
        ),
        Cushion::Restitution { e } => (
            ("component turned inward and reduced", format!("e = {e}")),
            ("tangential impulse", "0".to_owned()),
        ),
        Cushion::Han2005 { e, mu, height } => (
            ("Han 2005", format!("e = {e}, nose at {height} R")),
            ("mu", mu.to_string()),
        ),
        Cushion::Mathavan2010 {
            e,
            mu,
            mu_cloth,
            height,
        } => (
            (
                "Mathavan 2010",
                format!("e = {e} of work, nose at {height} R"),
            ),
            ("mu, mu_cloth", format!("{mu}, {mu_cloth}")),
        ),
    };
    sheet.push(Parameter::new(
        Role::CushionRestitution,
        name,
        restitution,
        "",
    ));
    sheet.push(Parameter::new(Role::CushionFriction, kind, friction, ""));
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::engine::audit::differences;
    use crate::engine::stepper::Settings;
    use crate::engine::stepper::run::Stepping;
    use crate::engine::{Limits, Run};
    use crate::physics::{Cloth, Contact, Cushion, Effects, Friction};
    use crate::scene::parse;
    use crate::trace::Record;

    const SCENE: &str = r#"
name = "every-material"
duration = 4.0
gravity = 9.81
table = { width = 3.0, length = 2.0 }
ball = { radius = 0.2, mass = 0.1 }
balls = [
    { id = "cue", position = [1.0, 1.0], velocity = [3.0, 0.4] },
    { id = "1", position = [1.8, 1.0] },
]
[effects.cloth.rotational]
mu_slide = 0.2
mu_roll = 0.01
mu_spin = 0.02
[effects.contact.inelastic]
e = 0.9
[effects.friction.constant]
mu = 0.05
[effects.cushion.restitution]
e = 0.8
"#;

    #[test]
    fn a_law_that_is_another_inside_is_told_and_is_the_one_that_acts() {
        type Plant = fn(&mut Effects);
        let plants: [(&str, Plant); 7] = [
            ("friction of ball cue with a Cloth", |laws| {
                laws.cloth = Some(Cloth::Rotational {
                    mu_slide: 0.3,
                    mu_roll: 0.01,
                    mu_spin: 0.02,
                });
            }),
            ("no material of ball cue with a Cloth", |laws| {
                laws.cloth = None;
            }),
            ("restitution of ball cue with a Ball", |laws| {
                laws.contact = Some(Contact::Inelastic { e: 0.8 });
            }),
            ("restitution of ball cue with a Ball", |laws| {
                laws.contact = Some(Contact::Elastic {});
            }),
            ("friction of ball cue with a Ball", |laws| {
                laws.friction = Some(Friction::Constant { mu: 0.1 });
            }),
            ("friction of ball cue with a Ball", |laws| {
                laws.friction = None;
            }),
            ("restitution of ball cue with a Cushion", |laws| {
                laws.cushion = Some(Cushion::Elastic {});
            }),
        ];
        let scene = parse("every-material.toml", SCENE).unwrap();
        let fresh = || Stepping::new(&scene, Settings::default(), String::new());
        let simulate = |run: Stepping<'_>| Box::new(run).simulate(Record::Final, &Limits::NONE);
        assert_eq!(differences(&scene, &fresh().inside()), [""; 0]);
        let right = simulate(fresh()).final_states();
        for (told, plant) in plants {
            let mut run = fresh();
            plant(&mut run.laws);
            let found = differences(&scene, &run.inside());
            assert!(
                found.iter().any(|words| words.starts_with(told)),
                "{found:?}"
            );
            assert_ne!(simulate(run).final_states(), right, "{told}");
        }
    }
}
