//! What the scene's laws make of balls, cloth and cushions as materials: coefficients and the rules that combine them.
//!
//! rapier gives every collider one coefficient of friction and one of restitution, and combines those of two that meet by the
//! stronger of their rules: `Average`, then `Min`, then `Max`. The scene says what each pair should have. Balls carry the
//! numbers of ball-ball contacts, by weak rules; cloth and cushions carry theirs and choose, of `Min` and `Max`, the rule that
//! picks their own.

use crate::physics::{Cloth, Contact, Cushion, Effects, friction};

/// How two coefficients become one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rule {
    /// Their mean; the weakest.
    Average,
    /// The smaller.
    Min,
    /// The larger; the strongest of the three.
    Max,
}

/// A coefficient and the rule that it brings along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coefficient {
    pub value: f64,
    pub rule: Rule,
}

/// The material of one collider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Material {
    pub friction: Coefficient,
    pub restitution: Coefficient,
}

impl Rule {
    /// rapier's name of it.
    pub fn name(self) -> &'static str {
        match self {
            Rule::Average => "Average",
            Rule::Min => "Min",
            Rule::Max => "Max",
        }
    }

    /// The rule that acts between colliders that bring `self` and `other`.
    pub fn between(self, other: Rule) -> Rule {
        if other as u8 > self as u8 {
            other
        } else {
            self
        }
    }

    /// The rule that picks `own` and not `other`.
    fn picking(own: f64, other: f64) -> Rule {
        if own < other { Rule::Min } else { Rule::Max }
    }
}

/// Material of every ball. Where friction depends on the slip speed, its coefficient is that of balls that stick.
pub(super) fn ball(effects: &Effects) -> Material {
    let friction = effects.friction;
    let restitution = match effects.contact {
        Some(Contact::Elastic {}) | None => 1.0,
        Some(Contact::Inelastic { e }) => e,
    };
    Material {
        friction: Coefficient {
            value: friction.map_or(0.0, |law| friction::coefficient(law, 0.0)),
            rule: Rule::Average,
        },
        restitution: Coefficient {
            value: restitution,
            rule: Rule::Min,
        },
    }
}

/// Material of the cloth, if the scene has one.
pub(super) fn cloth(effects: &Effects) -> Option<Material> {
    let mu = match effects.cloth? {
        Cloth::Translational { mu } => mu,
        Cloth::Rotational { mu_slide, .. } => mu_slide,
    };
    Some(Material {
        friction: Coefficient {
            value: mu,
            rule: Rule::picking(mu, ball(effects).friction.value),
        },
        restitution: Coefficient {
            value: 0.0,
            rule: Rule::Min,
        },
    })
}

/// Material of the cushions, if the scene has some that rapier can be told of.
pub(super) fn cushion(effects: &Effects) -> Option<Material> {
    let e = match effects.cushion? {
        Cushion::Elastic {} => 1.0,
        Cushion::Restitution { e } => e,
        // `missing` names them
        Cushion::Han2005 { .. } | Cushion::Mathavan2010 { .. } => return None,
    };
    Some(Material {
        friction: Coefficient {
            value: 0.0,
            rule: Rule::Min,
        },
        restitution: Coefficient {
            value: e,
            rule: Rule::picking(e, ball(effects).restitution.value),
        },
    })
}
