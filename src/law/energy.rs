//! No cloth and no impact adds energy: kinetic energy never grows.

use super::{Held, Law, Reads, Run};
use crate::physics::State;
use crate::physics::invariants::{Invariant, kinetic_energy};
use crate::physics::{Cloth, Contact, Cushion};
use crate::scene::Scene;
use crate::trace::{Extremum, Trace};

/// An impact may raise the energy by so many ulp of it: an energy is a sum of squares of speeds, each of which is good to four ulp after a
/// projection and a sum, for each of two balls.
const ULPS: f64 = 16.0;

/// By what part of itself the energy that the knots of a trace show ([`highest`]) may rise above its start.
///
/// An allowance and no derived bound: besides impacts, for which [`bound`] is, each step of a cloth rounds velocities and spins, and how that
/// adds up depends on the run. In a million random scenes the largest rise was 5.95e-13.
pub const ABOVE_START: f64 = 1e-12;

/// The same of one run: what a convention rounds in proportion to the square roots of masses ([`super::amplified`]), and what a clock of f64 leaves open:
/// late in a run of slow balls the cloth changes a speed by more within one tick than it is.
pub fn above_start(scene: &Scene, time: f64) -> f64 {
    let start = scene.initial_energy();
    let pull = match scene.effects.cloth {
        None => 0.0,
        Some(Cloth::Translational { mu }) => mu * scene.gravity,
        // a slip ends by its centre and its surface together
        Some(Cloth::Rotational {
            mu_slide, mu_roll, ..
        }) => 3.5 * mu_slide.max(mu_roll) * scene.gravity,
    };
    let changed = pull * 4.0 * f64::EPSILON * time;
    let each = scene.balls.iter().map(|ball| {
        (2.0 * ball.mass * start).sqrt() * changed + 0.5 * ball.mass * changed * changed
    });
    let ticks = if start > 0.0 {
        each.sum::<f64>() / start
    } else {
        0.0
    };
    ABOVE_START * super::amplified(scene) + ticks
}

/// The invariant.
pub const LAW: Law = Law {
    invariant: Invariant::EnergyNeverGrows,
    unit: "E0",
    what: "kinetic energy rises above an earlier level by no more than rounding, 16 ulp an impact in each substep; where nothing moves, in m g R",
    reads: Reads::Run(|run| {
        let gained = run.trace.extrema.energy_gained;
        let seen = Extremum {
            value: gained.value / unit(run.scene)?.size(),
            ..gained
        };
        let bound = bound(run);
        Some(Held { seen, bound })
    }),
};

/// What energies of a scene are measured in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// The initial energy.
    Initial(f64),
    /// Where nothing moves: that of a fall of the heaviest ball by the smallest radius.
    Fall(f64),
}

impl Unit {
    /// mass * length^2/s^2, > 0.
    pub fn size(self) -> f64 {
        let (Unit::Initial(size) | Unit::Fall(size)) = self;
        size
    }
}

/// What energies of a scene are measured in; `None` where nothing moves or falls.
pub fn unit(scene: &Scene) -> Option<Unit> {
    let initial = scene.initial_energy();
    if initial > 0.0 {
        return Some(Unit::Initial(initial));
    }
    let fall = super::momentum::heaviest(scene) * scene.gravity * scene.smallest_radius();
    (fall > 0.0).then_some(Unit::Fall(fall))
}

/// By what part of itself rounding may raise an energy: 16 ulp for each impact, in each substep in which it is solved.
pub fn bound(run: &Run<'_>) -> f64 {
    ULPS * run.ulp * run.impacts() * run.substeps()
}

/// The largest energy that the knots of a trace show, and when, s, where it is above that at the start; an account that asks no engine.
///
/// What a ball has left between two knots is at most what it had at the first, so that the sum over the last knots of all balls is one that
/// the run never exceeds. At one time each ball's knots come in their order, and nothing is concluded before the last.
pub fn highest(scene: &Scene, trace: &Trace) -> Option<(f64, f64)> {
    let of = |ball: usize, state: &State| {
        kinetic_energy(state, scene.balls[ball].mass, scene.inertia(ball))
    };
    let balls = scene.balls.iter().enumerate();
    let mut now: Vec<f64> = balls.map(|(ball, b)| of(ball, &b.state)).collect();
    let start: f64 = now.iter().sum();
    let mut knots: Vec<(f64, usize, usize)> = Vec::new();
    for (ball, path) in trace.paths.iter().enumerate() {
        let own = path.knots.iter().enumerate();
        knots.extend(own.map(|(i, knot)| (knot.time, i, ball)));
    }
    knots.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let (mut most, mut when) = (start, 0.0);
    for (i, (time, knot, ball)) in knots.iter().enumerate() {
        now[*ball] = of(*ball, &trace.paths[*ball].knots[*knot].state);
        if knots.get(i + 1).is_none_or(|next| next.0 > *time) {
            let total: f64 = now.iter().sum();
            if total > most {
                (most, when) = (total, *time);
            }
        }
    }
    (most != start).then_some((most, when))
}

/// True where no law of the scene takes energy, so that all of it is left and motion can run backward.
pub fn is_kept(scene: &Scene) -> bool {
    let effects = &scene.effects;
    let smooth = scene.gravity == 0.0
        || match effects.cloth {
            None => true,
            Some(Cloth::Translational { mu }) => mu == 0.0,
            Some(Cloth::Rotational {
                mu_slide,
                mu_roll,
                mu_spin,
            }) => mu_slide == 0.0 && mu_roll == 0.0 && mu_spin == 0.0,
        };
    let contact = matches!(effects.contact, None | Some(Contact::Elastic {}));
    let cushion = matches!(effects.cushion, None | Some(Cushion::Elastic {}));
    smooth && contact && cushion && effects.friction.is_none() && effects.pockets.is_none()
}
