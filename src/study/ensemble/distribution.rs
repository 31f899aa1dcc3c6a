//! Distributions of where and when each ball stopped, and whether an engine's differ from the reference's.

use super::{EnsembleEntry, Landing};
use crate::math::statistics::{Distribution, holm, kolmogorov_smirnov, transport};
use crate::scene::Scene;

/// A corrected p-value below this counts as a difference.
pub const LEVEL: f64 = 0.05;

/// Distributions closer than this are equal but for rounding: in R, or for times in R over the largest initial speed.
pub const NEGLIGIBLE: f64 = 1e-6;

/// What is looked at of each ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Final position across the table.
    X,
    /// Final position along the table.
    Y,
    /// When it stopped.
    StopTime,
}

impl Quantity {
    /// Every quantity, in the order of [`EnsembleEntry::distributions`].
    pub const ALL: [Quantity; 3] = [Quantity::X, Quantity::Y, Quantity::StopTime];

    /// Kebab-case name.
    pub fn id(self) -> &'static str {
        match self {
            Quantity::X => "x",
            Quantity::Y => "y",
            Quantity::StopTime => "stop-time",
        }
    }

    /// In words.
    pub fn title(self) -> &'static str {
        match self {
            Quantity::X => "x at the end",
            Quantity::Y => "y at the end",
            Quantity::StopTime => "stop time",
        }
    }

    /// What it is printed in, everywhere: R, or the scene's time.
    pub fn scale(self, scene: &Scene) -> (f64, &str) {
        match self {
            Quantity::X | Quantity::Y => (scene.smallest_radius(), "R"),
            Quantity::StopTime => (1.0, &scene.units.time),
        }
    }

    /// A difference that is no more than rounding, in the unit of the quantity.
    fn negligible(self, scene: &Scene) -> f64 {
        let radius = scene.smallest_radius();
        match self {
            Quantity::X | Quantity::Y => NEGLIGIBLE * radius,
            Quantity::StopTime => NEGLIGIBLE * radius / scene.largest_speed(),
        }
    }

    /// Its value in one landing; `None` where the ball left play, or still moves.
    pub fn of(self, landing: &Landing, ball: usize) -> Option<f64> {
        match self {
            Quantity::X => landing.at[ball].map(|[x, _]| x),
            Quantity::Y => landing.at[ball].map(|[_, y]| y),
            Quantity::StopTime => landing.stopped[ball],
        }
    }
}

/// One quantity of one ball in one engine, against the reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Test {
    /// Index of the entry.
    pub entry: usize,
    /// Index of the ball in scene order.
    pub ball: usize,
    /// What is compared.
    pub quantity: Quantity,
    /// Largest distance of the two empirical distribution functions, 0 to 1.
    pub distance: f64,
    /// Probability of at least this distance if both were independent samples of one distribution.
    pub p: f64,
    /// The same, corrected for the number of tests of the ensemble (Holm).
    pub corrected: f64,
    /// How far the one distribution has to be moved to become the other, on average; in the unit of the quantity.
    pub transport: f64,
    /// Whether the distributions differ: by the corrected p, and by more than rounding.
    pub differs: bool,
}

/// The distributions of every ball over the complete runs of an entry.
pub(super) fn of(entry: &EnsembleEntry, balls: usize) -> Vec<[Option<Distribution>; 3]> {
    let of_ball = |ball: usize| {
        Quantity::ALL.map(|quantity| {
            let runs = entry.complete();
            Distribution::of(runs.filter_map(|(_, landing)| quantity.of(landing, ball)))
        })
    };
    (0..balls).map(of_ball).collect()
}

/// Every quantity of every ball of the other entries against the reference.
pub(super) fn tests(
    entries: &[EnsembleEntry],
    reference: Option<usize>,
    scene: &Scene,
) -> Vec<Test> {
    let mut tests = Vec::new();
    let Some(reference) = reference else {
        return tests;
    };
    let others = entries.iter().enumerate().filter(|(k, _)| *k != reference);
    for (k, entry) in others {
        for ball in 0..scene.balls.len() {
            for (which, quantity) in Quantity::ALL.into_iter().enumerate() {
                let (ours, theirs) = (
                    &entry.distributions[ball][which],
                    &entries[reference].distributions[ball][which],
                );
                let Some((ours, theirs)) = ours.as_ref().zip(theirs.as_ref()) else {
                    continue;
                };
                let test = kolmogorov_smirnov(ours, theirs);
                tests.push(Test {
                    entry: k,
                    ball,
                    quantity,
                    distance: test.distance,
                    p: test.p,
                    corrected: test.p,
                    transport: transport(ours, theirs),
                    differs: false,
                });
            }
        }
    }
    let p_values: Vec<f64> = tests.iter().map(|test| test.p).collect();
    for (test, corrected) in tests.iter_mut().zip(holm(&p_values)) {
        test.corrected = corrected;
        test.differs = corrected < LEVEL && test.transport > test.quantity.negligible(scene);
    }
    tests
}
