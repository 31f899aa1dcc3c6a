//! Quantities that laws conserve or never increase.

use super::State;
use crate::math::Vec3;

/// Moment of inertia of a uniform solid sphere about an axis through its centre: `2/5 m R^2`.
pub fn sphere_inertia(mass: f64, radius: f64) -> f64 {
    0.4 * mass * radius * radius
}

/// Kinetic energy of one ball, mass * length^2/s^2: `m v^2/2`, and `I w^2/2` where `inertia` is given.
///
/// `inertia` is `None` in scenes that do not call for rotation.
pub fn kinetic_energy(state: &State, mass: f64, inertia: Option<f64>) -> f64 {
    let translation = 0.5 * mass * state.velocity.norm_squared();
    translation + inertia.map_or(0.0, |i| 0.5 * i * state.spin.norm_squared())
}

/// Momentum of one ball, mass * length/s.
pub fn momentum(state: &State, mass: f64) -> Vec3 {
    state.velocity * mass
}

/// What an engine can promise of a trace. A promise is hard: a trace that breaks it is a defect of the engine.
///
/// "The same trace" means the same states at the same times, within rounding and its growth. A run that collapses ends with the
/// last of infinitely many impacts that rounding still tells apart; when that is, and how many impacts there were, is no part of
/// the promise, so two such runs are the same up to the earlier of their ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Invariant {
    /// No NaN and no infinity in any state.
    Finite,
    /// A ball-ball impact keeps the momentum of its two balls.
    Momentum,
    /// A ball-ball impact keeps the kinetic energy of its two balls.
    ImpactEnergy,
    /// Kinetic energy never grows.
    EnergyNeverGrows,
    /// No ball's centre is further outside the table's reach than the scheme's bound.
    Bounds,
    /// Balls overlap no deeper than the scheme's bound.
    Overlap,
    /// Under friction every ball comes to rest.
    EverythingStops,
    /// A rerun gives the same bits.
    Rerun,
    /// A mirrored scene gives the mirrored trace.
    Mirror,
    /// The scene with its balls in another order gives the same trace.
    Relabelling,
    /// The scene turned by a quarter turn gives the turned trace.
    QuarterTurn,
    /// Lengths, speeds and gravity scaled together leave times unchanged.
    Scaling,
    /// Without friction or losses, the reversed end state runs back to the start.
    TimeReversal,
    /// Every impact, and every motion between events, is what the laws of the scene make of it.
    Laws,
}

impl Invariant {
    /// Kebab-case name, as printed.
    pub fn id(self) -> &'static str {
        match self {
            Invariant::Finite => "finite",
            Invariant::Momentum => "momentum",
            Invariant::ImpactEnergy => "impact-energy",
            Invariant::EnergyNeverGrows => "energy-never-grows",
            Invariant::Bounds => "bounds",
            Invariant::Overlap => "overlap",
            Invariant::EverythingStops => "everything-stops",
            Invariant::Rerun => "rerun",
            Invariant::Mirror => "mirror",
            Invariant::Relabelling => "relabelling",
            Invariant::QuarterTurn => "quarter-turn",
            Invariant::Scaling => "scaling",
            Invariant::TimeReversal => "time-reversal",
            Invariant::Laws => "laws",
        }
    }
}
