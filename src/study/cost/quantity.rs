//! What a user wants right, and how wrong a run is about it.

use crate::compare::{align, common_end, largest_distance_at_end};
use crate::math::{Vec3, worse};
use crate::physics::State;
use crate::scene::Scene;
use crate::trace::Trace;

/// Times at which energies are compared.
pub const ENERGY_TIMES: usize = 64;

/// A quantity that people read off a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// Where the balls are at the end.
    FinalPosition,
    /// When they come to rest.
    StopTime,
    /// Who meets whom, in which order.
    Order,
    /// How much kinetic energy there is, over the run.
    Energy,
}

impl Quantity {
    /// All of them, in the order of tables.
    pub const ALL: [Quantity; 4] = [
        Quantity::FinalPosition,
        Quantity::StopTime,
        Quantity::Order,
        Quantity::Energy,
    ];

    /// Kebab-case name.
    pub fn id(self) -> &'static str {
        match self {
            Quantity::FinalPosition => "final-position",
            Quantity::StopTime => "stop-time",
            Quantity::Order => "collision-order",
            Quantity::Energy => "energy",
        }
    }

    /// As in a heading.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::FinalPosition => "final position",
            Quantity::StopTime => "stop time",
            Quantity::Order => "collision order",
            Quantity::Energy => "energy",
        }
    }

    /// Unit of its error; empty for a share.
    pub fn unit(self) -> &'static str {
        match self {
            Quantity::FinalPosition => "R",
            Quantity::StopTime => "s",
            Quantity::Order => "",
            Quantity::Energy => "E0",
        }
    }

    /// What its error is, in one clause.
    pub fn what(self) -> &'static str {
        match self {
            Quantity::FinalPosition => {
                "largest distance of a ball from where it should be at the end"
            }
            Quantity::StopTime => "largest difference of a ball's stop time",
            Quantity::Order => {
                "share of the collisions from the first wrong one on, ties within the resolution allowed"
            }
            Quantity::Energy => {
                "difference of the kinetic energy, averaged over the time of the run"
            }
        }
    }
}

/// How wrong one run is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Error of each of [`Quantity::ALL`], in its unit; `None` where the scene has no such quantity or the run no answer.
    pub by_quantity: [Option<f64>; 4],
    /// Kinetic energy gained, E0; `None` without an initial energy.
    pub gained: Option<f64>,
    /// Whether the run reached the end that the scene asks for.
    pub complete: bool,
}

impl Errors {
    /// The errors of `trace` against the oracle's; without an oracle, what the trace says against itself.
    pub fn of(scene: &Scene, trace: &Trace, oracle: Option<&Trace>) -> Self {
        let energy = scene.initial_energy();
        let mut errors = Errors {
            by_quantity: [None; 4],
            gained: (energy > 0.0).then(|| trace.extrema.energy_gained.value / energy),
            complete: trace.ending.is_complete(),
        };
        if let Some(oracle) = oracle.filter(|_| errors.complete) {
            errors.by_quantity = [
                final_position(scene, trace, oracle),
                stop_time(scene, trace, oracle),
                order(trace, oracle),
                (energy > 0.0).then(|| energy_apart(scene, trace, oracle) / energy),
            ];
        }
        errors
    }

    /// The error of one quantity.
    pub fn get(&self, quantity: Quantity) -> Option<f64> {
        self.by_quantity[quantity as usize]
    }
}

/// Largest distance at the end, R. Infinite where a ball left play in only one of the two.
fn final_position(scene: &Scene, trace: &Trace, oracle: &Trace) -> Option<f64> {
    let same = (0..scene.balls.len()).all(|ball| trace.pocket_of(ball) == oracle.pocket_of(ball));
    if same {
        largest_distance_at_end(scene, trace, oracle)
    } else {
        Some(f64::INFINITY)
    }
}

/// Largest difference of a stop time, s; `None` where nothing stops. Infinite where a ball stops in only one of the two.
fn stop_time(scene: &Scene, trace: &Trace, oracle: &Trace) -> Option<f64> {
    let error = |ball: usize| match (trace.stop_times[ball], oracle.stop_times[ball]) {
        (None, None) => None,
        // a ball that nothing touched
        (Some(0.0), Some(0.0)) if scene.balls[ball].state.speed() == 0.0 => None,
        (Some(ours), Some(theirs)) => Some((ours - theirs).abs()),
        _ => Some(f64::INFINITY),
    };
    (0..scene.balls.len()).filter_map(error).reduce(worse)
}

/// Share of the collisions from the first wrong one on; `None` where there are none.
fn order(trace: &Trace, oracle: &Trace) -> Option<f64> {
    let order = align(trace, oracle);
    let all = order.collisions.max(order.reference_collisions);
    (all > 0).then(|| 1.0 - order.tolerant as f64 / all as f64)
}

/// Mean over the time of the run of the difference of the kinetic energies.
fn energy_apart(scene: &Scene, trace: &Trace, oracle: &Trace) -> f64 {
    let end = common_end(trace, oracle).min(oracle.end_time);
    let energy = |trace: &Trace, time: f64| -> f64 {
        let at_rest = State::at_rest(Vec3::zeros());
        let state = |ball| trace.in_play_at(ball, time).unwrap_or(at_rest);
        scene.kinetic_energy(&(0..trace.paths.len()).map(state).collect::<Vec<_>>())
    };
    let times = (0..ENERGY_TIMES).map(|k| end * (k as f64 + 0.5) / ENERGY_TIMES as f64);
    let apart = times.map(|time| (energy(trace, time) - energy(oracle, time)).abs());
    apart.sum::<f64>() / ENERGY_TIMES as f64
}
