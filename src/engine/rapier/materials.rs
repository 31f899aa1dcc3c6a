//! How rapier is brought to give each pair the coefficients that the scene says.
//!
//! rapier gives every collider one coefficient of friction and one of restitution, and combines those of two that meet by the
//! stronger of their rules: `Average`, then `Min`, then `Max`. The scene says what each pair should have. Balls carry the
//! numbers of ball-ball contacts, by weak rules; cloth and cushions carry theirs and choose, of `Min` and `Max`, the rule that
//! picks their own.

use crate::engine::stepped::materials as scene;
use crate::physics::Effects;

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

/// Material of every ball.
pub(super) fn ball(effects: &Effects) -> Material {
    let material = scene::balls(effects);
    Material {
        friction: Coefficient {
            value: material.friction,
            rule: Rule::Average,
        },
        restitution: Coefficient {
            value: material.restitution,
            rule: Rule::Min,
        },
    }
}

/// Material of the cloth, if the scene has one.
pub(super) fn cloth(effects: &Effects) -> Option<Material> {
    let (cloth, ball) = (scene::cloth(effects)?, scene::balls(effects));
    Some(Material {
        friction: Coefficient {
            value: cloth.friction,
            rule: Rule::picking(cloth.friction, ball.friction),
        },
        restitution: Coefficient {
            value: cloth.restitution,
            rule: Rule::Min,
        },
    })
}

/// Material of the cushions, if the scene has some that rapier can be told of; `missing` names the others.
pub(super) fn cushion(effects: &Effects) -> Option<Material> {
    let (cushion, ball) = (scene::cushion(effects)?, scene::balls(effects));
    Some(Material {
        friction: Coefficient {
            value: cushion.friction,
            rule: Rule::Min,
        },
        restitution: Coefficient {
            value: cushion.restitution,
            rule: Rule::picking(cushion.restitution, ball.restitution),
        },
    })
}
