//! What the scene's laws make of balls, cloth and cushions as materials: one coefficient of friction and one of restitution for the
//! contact of a ball with each of them. Engines that keep a material a body say by themselves how those of two bodies combine.

use crate::engine::{Inside, PairMaterial, Partner};
use crate::physics::invariants::kinetic_energy;
use crate::physics::{Cloth, Contact, Cushion, Effects, friction};
use crate::scene::Ball;

/// What a contact does, in the two numbers that most engines know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Coefficient of friction.
    pub friction: f64,
    /// Coefficient of restitution.
    pub restitution: f64,
}

/// The contact of two balls; elastic where the scene has none. Where friction depends on the slip speed, its coefficient is that of
/// balls that stick.
pub fn balls(effects: &Effects) -> Material {
    Material {
        friction: (effects.friction).map_or(0.0, |law| friction::coefficient(law, 0.0)),
        restitution: match effects.contact {
            Some(Contact::Elastic {}) | None => 1.0,
            Some(Contact::Inelastic { e }) => e,
        },
    }
}

/// The contact of a ball with the cloth, if the scene has one.
pub fn cloth(effects: &Effects) -> Option<Material> {
    Some(Material {
        friction: match effects.cloth? {
            Cloth::Translational { mu } => mu,
            Cloth::Rotational { mu_slide, .. } => mu_slide,
        },
        restitution: 0.0,
    })
}

/// The contact of a ball with a cushion, if the scene has some that two numbers describe: not those of a paper, which push at a nose.
pub fn cushion(effects: &Effects) -> Option<Material> {
    let restitution = match effects.cushion? {
        Cushion::Elastic {} => 1.0,
        Cushion::Restitution { e } => e,
        Cushion::Han2005 { .. } | Cushion::Mathavan2010 { .. } => return None,
    };
    Some(Material {
        friction: 0.0,
        restitution,
    })
}

/// What is inside a world in f64 whose balls do not turn, and that has one material for each kind of partner: `balls` and `met` as it
/// holds them.
pub fn inside(balls: &[Ball], met: &[(Partner, Option<Material>)]) -> Inside {
    let energy = |ball: &Ball| kinetic_energy(&ball.state, ball.mass, None);
    let of = |ball: usize| {
        met.iter().filter_map(move |(partner, material)| {
            let Material {
                friction,
                restitution,
            } = (*material)?;
            Some(PairMaterial {
                ball,
                partner: *partner,
                friction,
                restitution,
            })
        })
    };
    Inside {
        balls: balls.to_vec(),
        inertia: vec![None; balls.len()],
        energy: balls.iter().map(energy).sum(),
        materials: (0..balls.len()).flat_map(of).collect(),
        ulp: f64::EPSILON,
        contact_time: None,
    }
}
