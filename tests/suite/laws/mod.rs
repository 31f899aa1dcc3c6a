//! The laws one by one: against independent data, closed forms, conservation, symmetry, and in every scalar.

mod closed_forms;
mod conservation;
mod cushion_data;
mod data;
mod replayed_impacts;
mod scalars;
mod table;

use crate::random::Random;
use carom::math::Vec3;
use carom::physics::{Body, Contact, Cushion, Effects, Friction, Motion};

/// A pool ball in SI units.
pub const M: f64 = 0.170097;
pub const R: f64 = 0.028575;
pub const G: f64 = 9.81;

/// A pool ball on its way.
pub fn ball(velocity: Vec3, spin: Vec3) -> Body {
    Body {
        velocity,
        spin,
        mass: M,
        radius: R,
    }
}

/// Largest difference of two vectors' components.
pub fn off(got: &Vec3, want: &Vec3) -> f64 {
    let parts = (got - want).abs();
    parts.iter().copied().fold(0.0, carom::math::worse)
}

/// Kinetic energy of a ball with a motion.
pub fn energy(body: &Body, motion: &Motion) -> f64 {
    let inertia = 0.4 * body.mass * body.radius * body.radius;
    (body.mass * motion.velocity.norm_squared() + inertia * motion.spin.norm_squared()) / 2.0
}

/// The motion that a body has.
pub fn motion(body: &Body) -> Motion {
    Motion {
        velocity: body.velocity,
        spin: body.spin,
    }
}

/// The speed that scales the rounding of an impact: that of a point of the surface at most.
pub fn surface_speed(body: &Body) -> f64 {
    body.velocity.norm() + body.radius * body.spin.norm()
}

/// A vector with components within a size.
pub fn vector(random: &mut Random, size: f64) -> Vec3 {
    let mut part = || random.between(-size, size);
    Vec3::new(part(), part(), part())
}

/// Every law of ball-ball impacts with every law of friction, with random numbers.
pub fn contacts(random: &mut Random) -> Vec<Effects> {
    let mut all = Vec::new();
    for contact in [
        Contact::Elastic {},
        Contact::Inelastic {
            e: random.between(0.0, 1.0),
        },
    ] {
        let frictions = [
            None,
            Some(Friction::Constant {
                mu: random.between(0.0, 0.5),
            }),
            Some(Friction::Alciatore {
                a: random.between(0.0, 0.1),
                b: random.between(0.0, 0.3),
                c: random.between(0.0, 2.0),
                length_in_metres: random.between(0.1, 2.0),
            }),
        ];
        all.extend(frictions.map(|friction| Effects {
            contact: Some(contact),
            friction,
            ..Effects::default()
        }));
    }
    all
}

/// Every law of cushions, with random numbers.
pub fn cushions(random: &mut Random) -> [Cushion; 4] {
    let e = random.between(0.0, 1.0);
    let height = random.between(0.7, 1.6);
    [
        Cushion::Elastic {},
        Cushion::Restitution { e },
        Cushion::Han2005 {
            e,
            mu: random.between(0.0, 0.5),
            height,
        },
        Cushion::Mathavan2010 {
            e,
            mu: random.between(0.0, 0.5),
            mu_cloth: random.between(0.0, 0.5),
            height,
        },
    ]
}

/// Two balls of any masses, radii and spins that close in along the unit vector.
pub fn meeting(random: &mut Random) -> (Body, Body, Vec3) {
    let angle = random.between(0.0, std::f64::consts::TAU);
    let n = Vec3::new(angle.cos(), angle.sin(), 0.0);
    let mut body = || {
        let radius = random.between(0.5, 2.0);
        Body {
            velocity: vector(random, 1.0),
            spin: vector(random, 2.0 / radius),
            mass: random.between(0.2, 3.0),
            radius,
        }
    };
    let (first, second) = (body(), body());
    if (first.velocity - second.velocity).dot(&n) > 0.0 {
        (first, second, n)
    } else {
        (first, second, -n)
    }
}

/// A ball that moves towards larger x with any spin; on the cloth.
pub fn arriving(random: &mut Random) -> Body {
    let radius = random.between(0.5, 2.0);
    let mut velocity = vector(random, 1.0);
    velocity.x = velocity.x.abs();
    velocity.z = 0.0;
    Body {
        velocity,
        spin: vector(random, 2.0 / radius),
        mass: random.between(0.2, 3.0),
        radius,
    }
}
