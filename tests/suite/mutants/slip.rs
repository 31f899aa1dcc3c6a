//! What can slip in the writing of a stepper: each is one line of the plain copy that says something else.

use carom::math::Vec3;
use carom::physics::cloth::rotational::Coefficients;
use carom::physics::{Contact, Cushion, Motion, Side};
use nalgebra::Vector2;

/// One slip of the pen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slip {
    /// None: the copy is the stepper.
    None,
    RestitutionSquared,
    CushionLosesTwice,
    FrictionPushes,
    RollAtFourSevenths,
    PairDropped,
    CushionLate,
    NormalTurned,
    HalfGravity,
    ContactToldLate,
    StaleContact,
    EnergyLeaks,
    NotQuiteElastic,
    SpinningDoubled,
    WallMissing,
    FrictionOnOneAxis,
    SpinReversed,
    SideForgotten,
    ThrowOff,
    MassIgnored,
    SleepsEarly,
    PocketMissed,
    PairsReversed,
    WallsFirst,
    CornerReversed,
    WallForgetsPlace,
    RollingDoubled,
    StepDoubled,
    NotANumber,
}

/// Angle by which a normal is turned: a tenth of a degree, rad.
const TURNED: f64 = 0.1 * std::f64::consts::PI / 180.0;

/// Part of the kinetic energy that leaks in each hit; what is missing in a restitution of 1.
const LEAK: f64 = 1e-6;

/// Speed below which an early sleeper sleeps, length/s: a thousandth of a usual shot.
const SLEEP: f64 = 1e-2;

impl Slip {
    /// The normal of a contact.
    pub fn normal(self, n: Vector2<f64>) -> Vector2<f64> {
        match self {
            Slip::NormalTurned => {
                let (s, c) = TURNED.sin_cos();
                Vector2::new(c * n.x - s * n.y, s * n.x + c * n.y)
            }
            _ => n,
        }
    }

    /// The law of a contact.
    pub fn contact(self, law: Contact) -> Contact {
        match (self, law) {
            (Slip::RestitutionSquared, Contact::Inelastic { e }) => Contact::Inelastic { e: e * e },
            (Slip::NotQuiteElastic, Contact::Elastic {}) => Contact::Inelastic { e: 1.0 - LEAK },
            _ => law,
        }
    }

    /// The law of a cushion.
    pub fn cushion(self, law: Cushion) -> Cushion {
        match (self, law) {
            (Slip::CushionLosesTwice, Cushion::Han2005 { e, mu, height }) => Cushion::Han2005 {
                e: e * e,
                mu,
                height,
            },
            _ => law,
        }
    }

    /// What a hit leaves of a ball's motion.
    pub fn after_hit(self, mut motion: Motion) -> Motion {
        match self {
            Slip::EnergyLeaks => motion.velocity *= (1.0 - LEAK).sqrt(),
            Slip::SpinReversed => motion.spin = -motion.spin,
            Slip::NotANumber if motion.velocity.x < 0.0 => motion.velocity.y = f64::NAN,
            _ => {}
        }
        motion
    }

    /// What a cushion leaves of a ball's motion.
    pub fn after_cushion(self, mut motion: Motion) -> Motion {
        if self == Slip::SideForgotten {
            motion.spin = Vec3::new(motion.spin.x, motion.spin.y, 0.0);
        }
        motion
    }

    /// Gravity, length/s^2.
    pub fn gravity(self, gravity: f64) -> f64 {
        match self {
            Slip::HalfGravity => gravity / 2.0,
            Slip::FrictionPushes => -gravity,
            _ => gravity,
        }
    }

    /// The numbers of the cloth.
    pub fn cloth(self, mut mu: Coefficients) -> Coefficients {
        if self == Slip::RollingDoubled {
            mu.mu_roll *= 2.0;
        }
        if self == Slip::SpinningDoubled {
            mu.mu_spin *= 2.0;
        }
        mu
    }

    /// `I / (m R^2)`, of which a ball that slides to roll keeps `1 / (1 + I / (m R^2))` of its speed.
    pub fn inertia(self) -> f64 {
        match self {
            Slip::RollAtFourSevenths => 0.75,
            _ => 0.4,
        }
    }

    /// Speed at or below which a ball is put to rest, length/s.
    pub fn sleeps_below(self) -> f64 {
        match self {
            Slip::SleepsEarly => SLEEP,
            _ => 0.0,
        }
    }

    /// What is left of each component of a velocity that is slowed by `factor`.
    pub fn factors(self, factor: f64) -> [f64; 2] {
        match self {
            Slip::FrictionOnOneAxis => [factor, 1.0],
            _ => [factor, factor],
        }
    }

    /// The walls that are there.
    pub fn walls(self) -> Vec<Side> {
        let there = |side: &Side| !(self == Slip::WallMissing && *side == Side::X1);
        let mut walls: Vec<Side> = Side::ALL.into_iter().filter(there).collect();
        if self == Slip::CornerReversed {
            walls.reverse();
        }
        walls
    }
}
