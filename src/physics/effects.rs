//! The only list of effects: what a scene may call for, and what it calls for.
//!
//! [`EFFECTS`] names every law of the scene format; [`Effects`] holds the ones that a scene names. Help, schema, `missing` and
//! reports derive from these two.

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
    /// What it does, in one line.
    pub what: &'static str,
}

/// Every effect of the scene format, in the order of the effect ladder.
pub const EFFECTS: &[EffectEntry] = &[
    entry(
        "cloth.translational",
        &["mu"],
        "sliding friction on the centre only; no rotation",
    ),
    entry(
        "cloth.rotational",
        &["mu_slide", "mu_roll", "mu_spin"],
        "slide, roll and spin-down",
    ),
    entry(
        "contact.elastic",
        &[],
        "ball-ball impacts that keep their energy",
    ),
    entry(
        "contact.inelastic",
        &["e"],
        "ball-ball impacts with restitution e",
    ),
    entry(
        "friction.constant",
        &["mu"],
        "throw: friction between balls",
    ),
    entry(
        "friction.alciatore",
        &["a", "b", "c"],
        "throw with mu falling with slip speed",
    ),
    entry(
        "cushion.elastic",
        &[],
        "cushions that reverse the normal velocity",
    ),
    entry("cushion.restitution", &["e"], "cushions with restitution e"),
    entry(
        "cushion.han-2005",
        &["e", "mu", "height"],
        "cushion of Han 2005",
    ),
    entry(
        "cushion.mathavan-2010",
        &["e", "mu", "mu_cloth", "height"],
        "cushion of Mathavan 2010",
    ),
    entry(
        "pockets",
        &["circles"],
        "balls whose centre enters a circle leave play",
    ),
];

const fn entry(
    id: &'static str,
    numbers: &'static [&'static str],
    what: &'static str,
) -> EffectEntry {
    EffectEntry { id, numbers, what }
}

/// The effects that a scene calls for. What is absent is not simulated.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Effects")]
pub struct Effects<T = f64> {
    /// What the table does to a ball that moves on it. Absent: free flight.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cloth: Option<Cloth<T>>,
    /// What happens when two balls meet. Absent: balls pass through each other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact: Option<Contact<T>>,
    /// Friction between balls that meet. Absent: they are smooth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<Friction<T>>,
    /// What happens when a ball meets an edge of the table. Absent: balls leave the table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cushion: Option<Cushion<T>>,
    /// Where balls leave play. Absent: nowhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pockets: Option<Pockets<T>>,
}

/// Laws of the cloth; one at most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(rename = "Cloth")]
pub enum Cloth<T = f64> {
    /// Coulomb friction on the centre, without rotation: the report's law.
    Translational {
        /// Coefficient of friction, >= 0; sliding cloth is typically 0.2.
        #[schemars(range(min = 0), extend("examples" = [0.2]))]
        mu: T,
    },
    /// Balls slide, roll and spin.
    Rotational {
        /// Coefficient of sliding friction, >= 0; sliding cloth is typically 0.2.
        #[schemars(range(min = 0), extend("examples" = [0.2]))]
        mu_slide: T,
        /// Coefficient of rolling resistance, >= 0; a pool cloth has 0.005 to 0.015.
        #[schemars(range(min = 0), extend("examples" = [0.01]))]
        mu_roll: T,
        /// Coefficient of friction against spin about the vertical, in radii, >= 0; a pool cloth has about 0.01.
        #[schemars(range(min = 0), extend("examples" = [0.01]))]
        mu_spin: T,
    },
}

/// Laws of ball-ball impacts; one at most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(rename = "Contact")]
pub enum Contact<T = f64> {
    /// No energy is lost.
    Elastic {},
    /// The normal velocity is reduced.
    Inelastic {
        /// Restitution, from 0 to 1; pool balls have 0.92 to 0.98.
        #[schemars(range(min = 0, max = 1), extend("examples" = [0.95]))]
        e: T,
    },
}

/// Laws of friction between balls that meet; one at most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(rename = "Friction")]
pub enum Friction<T = f64> {
    /// One coefficient at every slip speed.
    Constant {
        /// Coefficient of friction between balls, >= 0; pool balls have 0.03 to 0.08.
        #[schemars(range(min = 0), extend("examples" = [0.06]))]
        mu: T,
    },
    /// A coefficient that falls with the slip speed u in m/s: mu = a + b exp(-c u).
    Alciatore {
        /// Coefficient at high slip speed, >= 0; published is 0.009951.
        #[schemars(range(min = 0), extend("examples" = [0.009951]))]
        a: T,
        /// What is added to it at low slip speed, >= 0; published is 0.108.
        #[schemars(range(min = 0), extend("examples" = [0.108]))]
        b: T,
        /// How fast it falls with the slip speed, s/m, >= 0; published is 1.088.
        #[schemars(range(min = 0), extend("examples" = [1.088]))]
        c: T,
        /// Metres per length unit of the scene: no key of its own, the scene's units give it.
        #[serde(skip, default = "one_metre")]
        #[schemars(skip)]
        length_in_metres: f64,
    },
}

fn one_metre() -> f64 {
    1.0
}

/// Laws of ball-cushion impacts; one at most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(rename = "Cushion")]
pub enum Cushion<T = f64> {
    /// The velocity component into the cushion is reversed.
    Elastic {},
    /// The velocity component into the cushion is reversed and reduced.
    Restitution {
        /// Restitution, from 0 to 1; a pool rail has 0.6 to 0.9.
        #[schemars(range(min = 0, max = 1), extend("examples" = [0.75]))]
        e: T,
    },
    /// A nose above the ball's centre, with friction: Han 2005, with its slip condition corrected.
    #[serde(rename = "han-2005")]
    Han2005 {
        /// Restitution along the line from the ball's centre to the nose, from 0 to 1; 0.85 is typical.
        #[schemars(range(min = 0, max = 1), extend("examples" = [0.85]))]
        e: T,
        /// Coefficient of friction between ball and cushion, >= 0; 0.2 is typical.
        #[schemars(range(min = 0), extend("examples" = [0.2]))]
        mu: T,
        /// Height of the nose above the cloth, in radii of the ball that meets it, greater than 0 and less than 2; a pool cushion has 1.28.
        #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 2, "examples" = [1.28]))]
        height: T,
    },
    /// A nose above the ball's centre, with friction at the cushion and at the cloth during the impact: Mathavan 2010.
    #[serde(rename = "mathavan-2010")]
    Mathavan2010 {
        /// Square root of the share of the work of compression that is returned, from 0 to 1; published is 0.98.
        #[schemars(range(min = 0, max = 1), extend("examples" = [0.98]))]
        e: T,
        /// Coefficient of friction between ball and cushion, from 0 to 0.5; published is 0.14.
        #[schemars(extend("minimum" = 0, "maximum" = 0.5, "examples" = [0.14]))]
        mu: T,
        /// Coefficient of friction between ball and cloth, from 0 to 0.5; published is 0.212.
        #[schemars(extend("minimum" = 0, "maximum" = 0.5, "examples" = [0.212]))]
        mu_cloth: T,
        /// Height of the nose above the cloth, in radii of the ball that meets it, from 0.1 to 1.9: nearer to the cloth or to the top the ball slips past it; published is 1.4 for snooker.
        #[schemars(extend("minimum" = 0.1, "maximum" = 1.9, "examples" = [1.4]))]
        height: T,
    },
}

/// Where balls leave play.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Pockets")]
pub struct Pockets<T = f64> {
    /// Circles in plan, length, called p0, p1, ... in this order; `circles = [[x, y, r], ...]`.
    pub circles: Vec<[T; 3]>,
}

impl<T> Cloth<T> {
    /// Its key below `[effects]`.
    pub fn id(&self) -> &'static str {
        match self {
            Cloth::Translational { .. } => "cloth.translational",
            Cloth::Rotational { .. } => "cloth.rotational",
        }
    }
}

impl<T> Contact<T> {
    /// Its key below `[effects]`.
    pub fn id(&self) -> &'static str {
        match self {
            Contact::Elastic {} => "contact.elastic",
            Contact::Inelastic { .. } => "contact.inelastic",
        }
    }
}

impl<T> Friction<T> {
    /// Its key below `[effects]`.
    pub fn id(&self) -> &'static str {
        match self {
            Friction::Constant { .. } => "friction.constant",
            Friction::Alciatore { .. } => "friction.alciatore",
        }
    }
}

impl<T> Cushion<T> {
    /// Its key below `[effects]`.
    pub fn id(&self) -> &'static str {
        match self {
            Cushion::Elastic {} => "cushion.elastic",
            Cushion::Restitution { .. } => "cushion.restitution",
            Cushion::Han2005 { .. } => "cushion.han-2005",
            Cushion::Mathavan2010 { .. } => "cushion.mathavan-2010",
        }
    }

    /// True when it turns balls.
    pub fn rotates(&self) -> bool {
        match self {
            Cushion::Elastic {} | Cushion::Restitution { .. } => false,
            Cushion::Han2005 { .. } | Cushion::Mathavan2010 { .. } => true,
        }
    }
}

impl<T> Pockets<T> {
    /// Their key below `[effects]`.
    pub const ID: &'static str = "pockets";
}

impl<T: Copy> Effects<T> {
    /// The same effects with every number passed through `f`, which also receives its key (`cloth.translational.mu`).
    ///
    /// One walk serves three purposes: it lifts a scene to another scalar, seeds derivatives, and lists the numbers. The
    /// numbers of all pockets share the key `pockets.circles`.
    pub fn map<U>(&self, mut f: impl FnMut(&'static str, T) -> U) -> Effects<U> {
        Effects {
            cloth: self.cloth.map(|cloth| match cloth {
                Cloth::Translational { mu } => Cloth::Translational {
                    mu: f("cloth.translational.mu", mu),
                },
                Cloth::Rotational {
                    mu_slide,
                    mu_roll,
                    mu_spin,
                } => Cloth::Rotational {
                    mu_slide: f("cloth.rotational.mu_slide", mu_slide),
                    mu_roll: f("cloth.rotational.mu_roll", mu_roll),
                    mu_spin: f("cloth.rotational.mu_spin", mu_spin),
                },
            }),
            contact: self.contact.map(|contact| match contact {
                Contact::Elastic {} => Contact::Elastic {},
                Contact::Inelastic { e } => Contact::Inelastic {
                    e: f("contact.inelastic.e", e),
                },
            }),
            friction: self.friction.map(|friction| match friction {
                Friction::Constant { mu } => Friction::Constant {
                    mu: f("friction.constant.mu", mu),
                },
                Friction::Alciatore {
                    a,
                    b,
                    c,
                    length_in_metres,
                } => Friction::Alciatore {
                    a: f("friction.alciatore.a", a),
                    b: f("friction.alciatore.b", b),
                    c: f("friction.alciatore.c", c),
                    length_in_metres,
                },
            }),
            cushion: self.cushion.map(|cushion| match cushion {
                Cushion::Elastic {} => Cushion::Elastic {},
                Cushion::Restitution { e } => Cushion::Restitution {
                    e: f("cushion.restitution.e", e),
                },
                Cushion::Han2005 { e, mu, height } => Cushion::Han2005 {
                    e: f("cushion.han-2005.e", e),
                    mu: f("cushion.han-2005.mu", mu),
                    height: f("cushion.han-2005.height", height),
                },
                Cushion::Mathavan2010 {
                    e,
                    mu,
                    mu_cloth,
                    height,
                } => Cushion::Mathavan2010 {
                    e: f("cushion.mathavan-2010.e", e),
                    mu: f("cushion.mathavan-2010.mu", mu),
                    mu_cloth: f("cushion.mathavan-2010.mu_cloth", mu_cloth),
                    height: f("cushion.mathavan-2010.height", height),
                },
            }),
            pockets: self.pockets.as_ref().map(|pockets| Pockets {
                circles: pockets
                    .circles
                    .iter()
                    .map(|circle| circle.map(|number| f("pockets.circles", number)))
                    .collect(),
            }),
        }
    }

    /// Ids of the effects that are called for, in the order of [`EFFECTS`].
    pub fn named(&self) -> Vec<&'static str> {
        let pockets = self.pockets.as_ref().map(|_| Pockets::<T>::ID);
        let all = [
            self.cloth.map(|law| law.id()),
            self.contact.map(|law| law.id()),
            self.friction.map(|law| law.id()),
            self.cushion.map(|law| law.id()),
            pockets,
        ];
        all.into_iter().flatten().collect()
    }

    /// True when some effect turns balls; without one, spin is not simulated and rotation carries no energy.
    pub fn rotates(&self) -> bool {
        let cloth = match self.cloth {
            Some(Cloth::Rotational { .. }) => true,
            Some(Cloth::Translational { .. }) | None => false,
        };
        // every law of friction has a tangential impulse
        cloth || self.friction.is_some() || self.cushion.is_some_and(|law| law.rotates())
    }
}

impl Effects<f64> {
    /// The same effects in the scalar `T`, exactly.
    pub fn lift<T: Real>(&self) -> Effects<T> {
        self.map(|_, x| T::lift(x))
    }
}
