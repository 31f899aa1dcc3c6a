//! The only list of effects: what a scene may call for, and what it calls for.
//!
//! [`EFFECTS`] names every law that the scene format reserves, built or not; [`Effects`] holds the ones that a scene
//! names. Help, schema, `missing` and reports derive from these two.

use crate::math::Real;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One law that a scene can name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectEntry {
    /// Key below `[effects]`, such as `cloth.translational`. Also the name used by `missing`.
    pub id: &'static str,
    /// The numbers it takes, as keys of the scene file.
    pub numbers: &'static [&'static str],
    /// False while the key is only reserved: naming it in a scene is an error that says so.
    pub built: bool,
    /// What it does, in one line.
    pub what: &'static str,
}

/// Every effect of the scene format, in the order of the effect ladder.
pub const EFFECTS: &[EffectEntry] = &[
    entry(
        "cloth.translational",
        &["mu"],
        true,
        "sliding friction on the centre only; no rotation",
    ),
    entry(
        "cloth.rotational",
        &["mu_slide", "mu_roll", "mu_spin"],
        false,
        "slide, roll and spin-down",
    ),
    entry(
        "contact.elastic",
        &[],
        true,
        "ball-ball impacts that keep their energy",
    ),
    entry(
        "contact.inelastic",
        &["e"],
        false,
        "ball-ball impacts with restitution e",
    ),
    entry(
        "friction.constant",
        &["mu"],
        false,
        "throw: friction between balls",
    ),
    entry(
        "friction.alciatore",
        &["a", "b", "c"],
        false,
        "throw with mu falling with slip speed",
    ),
    entry(
        "cushion.elastic",
        &[],
        true,
        "cushions that reverse the normal velocity",
    ),
    entry(
        "cushion.restitution",
        &["e"],
        false,
        "cushions with restitution e",
    ),
    entry(
        "cushion.han-2005",
        &["e", "mu", "height"],
        false,
        "cushion of Han 2005",
    ),
    entry(
        "cushion.mathavan-2010",
        &["e", "mu", "mu_cloth", "height"],
        false,
        "cushion of Mathavan 2010",
    ),
    entry(
        "pockets",
        &["circles"],
        false,
        "balls whose centre enters a circle leave play",
    ),
];

const fn entry(
    id: &'static str,
    numbers: &'static [&'static str],
    built: bool,
    what: &'static str,
) -> EffectEntry {
    EffectEntry {
        id,
        numbers,
        built,
        what,
    }
}

/// The effects that a scene calls for. What is absent is not simulated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Effects")]
pub struct Effects<T = f64> {
    /// What the table does to a ball that moves on it. Absent: free flight.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cloth: Option<Cloth<T>>,
    /// What happens when two balls meet. Absent: balls pass through each other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact: Option<Contact>,
    /// What happens when a ball meets an edge of the table. Absent: balls leave the table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cushion: Option<Cushion>,
}

/// Laws of the cloth; one at most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(rename = "Cloth")]
pub enum Cloth<T = f64> {
    /// Coulomb friction on the centre, without rotation: the report's law.
    Translational {
        /// Coefficient of friction, >= 0; sliding cloth is typically 0.2.
        #[schemars(range(min = 0))]
        mu: T,
    },
}

/// Laws of ball-ball impacts; one at most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Contact {
    /// No energy is lost and there is no friction between balls.
    Elastic {},
}

/// Laws of ball-cushion impacts; one at most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Cushion {
    /// The velocity component into the cushion is reversed.
    Elastic {},
}

impl<T: Copy> Effects<T> {
    /// The same effects with every number passed through `f`, which also receives its key (`cloth.translational.mu`).
    ///
    /// One walk serves three purposes: it lifts a scene to another scalar, seeds derivatives, and lists the numbers.
    pub fn map<U>(&self, mut f: impl FnMut(&'static str, T) -> U) -> Effects<U> {
        Effects {
            cloth: self.cloth.map(|cloth| match cloth {
                Cloth::Translational { mu } => Cloth::Translational {
                    mu: f("cloth.translational.mu", mu),
                },
            }),
            contact: self.contact,
            cushion: self.cushion,
        }
    }

    /// Ids of the effects that are called for, in the order of [`EFFECTS`].
    pub fn named(&self) -> Vec<&'static str> {
        let mut ids = Vec::new();
        match self.cloth {
            Some(Cloth::Translational { .. }) => ids.push("cloth.translational"),
            None => {}
        }
        match self.contact {
            Some(Contact::Elastic {}) => ids.push("contact.elastic"),
            None => {}
        }
        match self.cushion {
            Some(Cushion::Elastic {}) => ids.push("cushion.elastic"),
            None => {}
        }
        ids
    }

    /// True when some effect turns balls; without one, spin is not simulated and rotation carries no energy.
    pub fn rotates(&self) -> bool {
        match self.cloth {
            Some(Cloth::Translational { .. }) | None => false,
        }
    }
}

impl Effects<f64> {
    /// The same effects in the scalar `T`, exactly.
    pub fn lift<T: Real>(&self) -> Effects<T> {
        self.map(|_, x| T::lift(x))
    }
}
