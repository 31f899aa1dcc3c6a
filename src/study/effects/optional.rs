//! What of a scene's effects can be left out, and what is left then.
//!
//! The bare model of a scene is what remains without any of them: balls that slide and do not turn, impacts and cushions that keep
//! their energy, no pockets. One walk over [`Effects`] with exhaustive matches answers everything else, so a new law does not compile
//! until it has its place here.

use crate::physics::{Cloth, Contact, Cushion, Effects, Friction};

/// An effect that a scene can do without, in the order of the effect ladder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Optional {
    /// Balls turn: they slide until they roll. Without it they slide all the way, with the same friction.
    Rotation,
    /// A rolling ball is slowed. Without it it rolls on.
    RollingResistance,
    /// Spin about the vertical falls by friction. Without it only impacts change it.
    SpinDown,
    /// A ball-ball impact takes energy.
    Losses,
    /// Balls that meet rub.
    Throw,
    /// Cushions do more than reverse the normal velocity.
    CushionLaw,
    /// Balls fall.
    Pockets,
}

impl Optional {
    /// All of them, in the order of the ladder: none needs one that comes later.
    pub const ALL: [Optional; 7] = [
        Optional::Rotation,
        Optional::RollingResistance,
        Optional::SpinDown,
        Optional::Losses,
        Optional::Throw,
        Optional::CushionLaw,
        Optional::Pockets,
    ];

    /// Kebab-case name.
    pub fn id(self) -> &'static str {
        match self {
            Optional::Rotation => "rotation",
            Optional::RollingResistance => "rolling-resistance",
            Optional::SpinDown => "spin-down",
            Optional::Losses => "losses",
            Optional::Throw => "throw",
            Optional::CushionLaw => "cushion-law",
            Optional::Pockets => "pockets",
        }
    }

    /// In words, as in "this shot needs ...".
    pub fn name(self) -> &'static str {
        match self {
            Optional::Rotation => "rotation",
            Optional::RollingResistance => "rolling resistance",
            Optional::SpinDown => "spin-down",
            Optional::Losses => "losses of contact",
            Optional::Throw => "throw",
            Optional::CushionLaw => "the cushion law",
            Optional::Pockets => "pockets",
        }
    }

    /// What stands for it in "without ...".
    pub fn pronoun(self) -> &'static str {
        match self {
            Optional::Losses | Optional::Pockets => "them",
            Optional::Rotation
            | Optional::RollingResistance
            | Optional::SpinDown
            | Optional::Throw
            | Optional::CushionLaw => "it",
        }
    }

    /// The effect without which this one cannot act in a scene with these effects, if there is one.
    pub fn needs(self, effects: &Effects) -> Option<Optional> {
        let turning_cloth = match effects.cloth {
            Some(Cloth::Rotational { .. }) => true,
            // nothing to be left out of the cloth
            Some(Cloth::Translational { .. }) | None => false,
        };
        let needs_rotation = match self {
            Optional::RollingResistance | Optional::SpinDown | Optional::Throw => true,
            Optional::CushionLaw => effects.cushion.is_some_and(|law| law.rotates()),
            Optional::Rotation | Optional::Losses | Optional::Pockets => false,
        };
        (turning_cloth && needs_rotation).then_some(Optional::Rotation)
    }
}

/// The optional effects that a scene calls for, in the order of the ladder: those without which it is another scene.
pub fn present(effects: &Effects) -> Vec<Optional> {
    let acts = |effect: &Optional| {
        let others: Vec<Optional> = Optional::ALL.into_iter().filter(|e| e != effect).collect();
        reduced(effects, &others) != *effects
    };
    Optional::ALL.into_iter().filter(acts).collect()
}

/// The present effects that cannot act without `effect`.
pub fn dependents(effects: &Effects, effect: Optional) -> Vec<Optional> {
    let mut found = present(effects);
    found.retain(|other| other.needs(effects) == Some(effect));
    found
}

/// The same effects with of the optional ones only those in `kept`, which must hold what each of them needs.
pub fn reduced(effects: &Effects, kept: &[Optional]) -> Effects {
    let has = |effect: Optional| kept.contains(&effect);
    let number = |effect: Optional, x: f64| if has(effect) { x } else { 0.0 };
    let cloth = effects.cloth.map(|law| match law {
        Cloth::Translational { mu } => Cloth::Translational { mu },
        Cloth::Rotational {
            mu_slide,
            mu_roll,
            mu_spin,
        } if has(Optional::Rotation) => Cloth::Rotational {
            mu_slide,
            mu_roll: number(Optional::RollingResistance, mu_roll),
            mu_spin: number(Optional::SpinDown, mu_spin),
        },
        Cloth::Rotational { mu_slide, .. } => Cloth::Translational { mu: mu_slide },
    });
    let contact = effects.contact.map(|law| match law {
        Contact::Elastic {} => law,
        Contact::Inelastic { .. } if has(Optional::Losses) => law,
        Contact::Inelastic { .. } => Contact::Elastic {},
    });
    let friction = effects.friction.filter(|law| match law {
        Friction::Constant { .. } | Friction::Alciatore { .. } => has(Optional::Throw),
    });
    let cushion = effects.cushion.map(|law| match law {
        Cushion::Elastic {} => law,
        Cushion::Restitution { .. } | Cushion::Han2005 { .. } | Cushion::Mathavan2010 { .. } => {
            if has(Optional::CushionLaw) {
                law
            } else {
                Cushion::Elastic {}
            }
        }
    });
    Effects {
        cloth,
        contact,
        friction,
        cushion,
        pockets: effects.pockets.clone().filter(|_| has(Optional::Pockets)),
    }
}
