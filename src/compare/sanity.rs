//! What a trace says against itself: energy, momentum, overlap, bounds, motion that its events do not explain.

use super::{Measured, Metric, Reads};
use crate::finding::Hold;
use crate::math::{Vec3, worse};
use crate::physics::State;
use crate::scene::Scene;
use crate::trace::Trace;

/// Largest rise of kinetic energy above an earlier level.
pub const ENERGY_GAINED: Metric = Metric {
    id: "energy-gained",
    unit: "E0",
    hold: Hold::Figure,
    what: "largest rise of kinetic energy above an earlier level, in the initial energy",
    reads: Reads::Trace(|scene, trace| {
        Measured::of_run(ratio(
            trace.extrema.energy_gained.value,
            scene.initial_energy(),
        ))
    }),
};

/// Difference of the energies that are left at the end.
pub const ENERGY_LEFT_OUT: Metric = Metric {
    id: "energy-at-end",
    unit: "E0",
    hold: Hold::Figure,
    what: "difference of the kinetic energies at the end, in the initial energy",
    reads: Reads::Pair(|c| {
        let energy = |trace: &Trace| -> f64 {
            let end = c.common_end().min(trace.end_time);
            // a ball that left play took its energy with it
            let at_rest = State::at_rest(Vec3::zeros());
            let states: Vec<_> = (0..trace.paths.len())
                .map(|ball| trace.in_play_at(ball, end).unwrap_or(at_rest))
                .collect();
            c.scene.kinetic_energy(&states)
        };
        Measured::of_run(ratio(
            (energy(c.trace) - energy(c.reference)).abs(),
            c.scene.initial_energy(),
        ))
    }),
};

/// Largest momentum error of a ball-ball impact.
pub const MOMENTUM: Metric = Metric {
    id: "momentum",
    unit: "m v0",
    hold: Hold::Figure,
    what: "largest change of momentum in a ball-ball impact, in the largest mass x the largest initial speed",
    reads: Reads::Trace(|scene, trace| {
        let mass = scene.balls.iter().map(|ball| ball.mass).fold(0.0, f64::max);
        Measured::of_run(ratio(
            trace.extrema.momentum.value,
            mass * scene.largest_speed(),
        ))
    }),
};

/// Deepest overlap, by the engine's own account.
pub const OVERLAP: Metric = Metric {
    id: "overlap",
    unit: "R",
    hold: Hold::Figure,
    what: "deepest overlap of two balls, as the engine recorded it",
    reads: Reads::Trace(|scene, trace| of_radius(scene, trace.extrema.overlap.value)),
};

/// Farthest outside the table.
pub const OUTSIDE: Metric = Metric {
    id: "outside",
    unit: "R",
    hold: Hold::Figure,
    what: "farthest that a centre was beyond where the cushions let it be",
    reads: Reads::Trace(|scene, trace| of_radius(scene, trace.extrema.outside.value)),
};

/// Largest jump of a position.
pub const DISPLACED: Metric = Metric {
    id: "displaced",
    unit: "R",
    hold: Hold::Figure,
    what: "largest jump of a position at one time",
    reads: Reads::Trace(|scene, trace| {
        let seen = trace
            .paths
            .iter()
            .map(|path| path.displaced())
            .fold(0.0, worse);
        of_radius(scene, worse(seen, trace.extrema.displaced.value))
    }),
};

/// Motion that the trace's events do not explain.
pub const UNEXPLAINED: Metric = Metric {
    id: "unexplained",
    unit: "R",
    hold: Hold::Figure,
    what: "largest motion between two knots that their velocities do not explain",
    reads: Reads::Trace(|scene, trace| of_radius(scene, trace.unexplained())),
};

fn of_radius(scene: &Scene, length: f64) -> Vec<Measured> {
    Measured::of_run(length / scene.smallest_radius())
}

/// `part / whole`, or nothing where there is no whole.
fn ratio(part: f64, whole: f64) -> Option<f64> {
    (whole > 0.0).then(|| part / whole)
}
