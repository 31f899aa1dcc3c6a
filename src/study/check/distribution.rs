//! Scenes that nobody can predict to their end: distributions over a seeded ensemble.

use super::item::{COMPLETE, KS, QUANTILE};
use super::unit_of;
use crate::finding::Finding;
use crate::math::statistics::{Distribution, kolmogorov_smirnov};
use crate::oracle;
use crate::scene::Scene;
use crate::scene::perturb::{Law, Perturbation};
use crate::study::ensemble::{Landing, Quantity};
use crate::study::matrix::{Configuration, Runner};
use crate::trace::Record;

/// Samples of an ensemble. Seed and index fix every one of them, so that their number sets what is seen and not how wide a bound is.
pub const SAMPLES: usize = 100;

/// Their seed.
pub const SEED: u64 = 1;

/// An engine whose samples take longer than this does without, ns: rapier takes more than a second for what the stepper does in a tenth.
const MOST: f64 = 1e10;

/// Parts of a distribution whose bounds are held, with their names.
const QUANTILES: [(f64, &str); 3] = [(0.1, "10 %"), (0.5, "50 %"), (0.9, "90 %")];

/// True where an engine can afford the samples of a scene.
pub fn runs(scene: &Scene, column: &Configuration) -> bool {
    let expressible = column.engine.missing(scene).is_empty();
    expressible && SAMPLES as f64 * super::cost(scene, column) <= MOST
}

/// The samples of one scene.
pub struct Ensemble(Perturbation);

impl Ensemble {
    /// By the law that suits the scene; `None` where nothing in it can vary.
    pub fn of(scene: &Scene) -> Option<Ensemble> {
        Perturbation::new(scene, Law::default_for(scene))
            .ok()
            .map(Ensemble)
    }

    /// Where every sample ends in a column, or in the exact engine; `None` for one that has no complete run.
    pub fn run(&self, column: Option<&Configuration>, runner: Runner<'_>) -> Vec<Option<Landing>> {
        let exact = Configuration::of(oracle::engine());
        let column = column.unwrap_or(&exact);
        let landing = |index: usize| {
            let sample = self.0.sample(SEED, index as u64);
            let ran = runner.run(&sample, column, Record::Events).ok()?;
            Some(Landing::of(&ran.trace)).filter(|landing| landing.complete)
        };
        (0..SAMPLES).map(landing).collect()
    }
}

/// Quantiles over all balls and samples, and each ball's distance from the oracle's distribution.
pub fn findings(
    scene: &Scene,
    engine: &str,
    landings: &[Option<Landing>],
    reference: Option<&[Option<Landing>]>,
) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut add = |metric: &'static str, subject: String, value: f64, unit: &'static str| {
        findings.push(Finding {
            scene: scene.name.clone(),
            engine: engine.to_owned(),
            metric,
            subject,
            value: Some(value),
            unit,
            verdict: None,
        });
    };
    let complete = landings.iter().flatten().count();
    add(COMPLETE, String::new(), complete as f64, unit_of(COMPLETE));
    let balls = 0..scene.balls.len();
    for quantity in Quantity::ALL {
        let (scale, unit) = match quantity {
            Quantity::X | Quantity::Y => (scene.smallest_radius(), "R"),
            Quantity::StopTime => (1.0, "s"),
        };
        let values = landings.iter().flatten().flat_map(|landing| {
            let of = |ball| quantity.of(landing, ball);
            balls.clone().filter_map(of)
        });
        let Some(all) = Distribution::of(values) else {
            continue;
        };
        for (part, name) in QUANTILES {
            let value = all.quantile(part) / scale;
            add(QUANTILE, format!("{} {name}", quantity.id()), value, unit);
        }
    }
    for (ball, id) in scene.balls.iter().map(|ball| &ball.id).enumerate() {
        for quantity in Quantity::ALL {
            let of = |landings: &[Option<Landing>]| {
                let own = landings.iter().flatten();
                Distribution::of(own.filter_map(|landing| quantity.of(landing, ball)))
            };
            let (Some(ours), Some(theirs)) = (of(landings), reference.and_then(of)) else {
                continue;
            };
            let distance = kolmogorov_smirnov(&ours, &theirs).distance;
            add(KS, format!("{id} {}", quantity.id()), distance, unit_of(KS));
        }
    }
    findings
}
