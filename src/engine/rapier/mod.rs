//! The engines `rapier-f64` and `rapier-f32`: the scene in rapier3d, by its own solver.
//!
//! | file | what lives there |
//! |---|---|
//! | `settings.rs` | the knobs and the two presets |
//! | `world.rs` | the equivalent scene inside rapier; compiled twice, in `double.rs` and `single.rs` |
//! | `interface.rs` | what the stepping loop sees of it |
//! | `materials.rs` | coefficients of balls, cloth and cushions, and the rules that combine them |
//! | `cloth.rs` | what of the cloth rapier lacks, as forces; what a step without impact leaves |
//! | `run.rs` | the stepping loop |
//! | `journal.rs` | impacts from impulses, both sides of each, extrema |
//! | `sheet.rs` | rapier's parameters by its own names |

mod cloth;
mod double;
mod interface;
mod journal;
mod materials;
mod run;
mod settings;
mod sheet;
mod single;

pub use settings::{Ccd, Friction, Preset, Settings};

use super::setting::knobs_of;
use super::{About, Engine, Knob, Refusal, Run, Setting};
use crate::physics::invariants::Invariant;
use crate::physics::{self, Cloth, Contact, Cushion};
use crate::scene::Scene;
use run::Simulation;

/// Version of both crates, as pinned in Cargo.toml.
const VERSION: &str = "0.36.1";

/// The scene in rapier, in one precision.
#[derive(Debug)]
pub struct Rapier {
    id: &'static str,
    package: &'static str,
    precision: Precision,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Precision {
    Double,
    Single,
}

/// rapier in f64.
pub static RAPIER_F64: Rapier = Rapier {
    id: "rapier-f64",
    package: "rapier3d-f64",
    precision: Precision::Double,
};

/// rapier in f32.
pub static RAPIER_F32: Rapier = Rapier {
    id: "rapier-f32",
    package: "rapier3d",
    precision: Precision::Single,
};

impl Rapier {
    /// Smallest and largest size of a number whose fourth power the scalar still holds: energies, quartic distances and
    /// inverse inertias stay finite and above zero.
    fn range(&self) -> (f64, f64) {
        match self.precision {
            Precision::Double => (1e-76, 1e76),
            Precision::Single => (1e-9, 1e9),
        }
    }

    fn fits(&self, scene: &Scene) -> bool {
        let (least, most) = self.range();
        let sizes = scene.balls.iter().flat_map(|b| [b.radius, b.mass]);
        let sizes_fit = sizes.into_iter().all(|x| (least..=most).contains(&x));
        let speed = scene.largest_speed();
        let mut spins = scene.balls.iter().map(|ball| ball.state.spin.amax());
        let spins_fit = spins.all(|spin| spin <= most);
        sizes_fit
            && spins_fit
            && speed <= most
            && scene.largest_coordinate() <= most
            && scene.gravity <= most
    }
}

impl Engine for Rapier {
    fn id(&self) -> &'static str {
        self.id
    }

    fn version(&self) -> String {
        format!("{} {VERSION}", self.package)
    }

    fn about(&self) -> About {
        About {
            method: "Fixed steps of the rapier physics engine: contacts are predicted once a step, a sequential-impulse \
                     solver moves the balls in substeps, and restitution acts once at the end of the step.",
            shares: "With stepper and exact nothing but the scene: sliding, contacts and cushions are rapier's own solver. What \
                     rapier lacks uses rates and coefficients of the workbench: rolling resistance and spin-down (as stepper), \
                     friction between balls that depends on their slip speed, and who is in a pocket (as all). The two rapier \
                     engines are one source in two precisions.",
        }
    }

    fn knobs(&self) -> Vec<Knob> {
        knobs_of::<Settings>()
    }

    fn missing(&self, scene: &Scene) -> Vec<&'static str> {
        // exhaustive, so that a new law does not compile until it is answered here
        let mut missing = Vec::new();
        match scene.effects.cloth {
            None | Some(Cloth::Translational { .. } | Cloth::Rotational { .. }) => {}
        }
        match scene.effects.contact {
            None | Some(Contact::Elastic {} | Contact::Inelastic { .. }) => {}
        }
        match scene.effects.friction {
            None
            | Some(physics::Friction::Constant { .. } | physics::Friction::Alciatore { .. }) => {}
        }
        match scene.effects.cushion {
            None | Some(Cushion::Elastic {} | Cushion::Restitution { .. }) => {}
            // laws of a paper: an impulse at a nose that rapier's half-spaces do not have
            Some(law @ (Cushion::Han2005 { .. } | Cushion::Mathavan2010 { .. })) => {
                missing.push(law.id());
            }
        }
        if scene.effects.contact.is_some() && !scene.equal_radii() {
            missing.push(
                "balls of unequal radii that meet (the tilted impact would lift one off the table)",
            );
        }
        if !self.fits(scene) {
            missing.push("numbers as large or as small as the scene's in its arithmetic");
        }
        missing
    }

    fn promises(&self, _scene: &Scene, setting: &Setting) -> Vec<Invariant> {
        let mut promised = vec![Invariant::Finite, Invariant::Rerun];
        // a sleeping ball that is hit falls onto the cloth, which then takes more momentum than friction would
        if Settings::read(setting).is_ok_and(|settings| !settings.can_sleep) {
            promised.push(Invariant::Momentum);
        }
        promised
    }

    fn ladders(&self) -> Vec<(&'static str, Vec<Setting>)> {
        let steps = [
            60.0, 120.0, 250.0, 500.0, 1000.0, 2000.0, 4000.0, 8000.0, 16000.0,
        ];
        let over_dt = |fixed: &[(&str, &str)]| {
            let base = fixed
                .iter()
                .fold(Setting::default(), |s, (key, value)| s.with(key, value));
            steps
                .iter()
                .map(|rate| base.clone().with("dt", 1.0 / rate))
                .collect::<Vec<_>>()
        };
        let over = |key: &str, values: &[&str]| {
            values
                .iter()
                .map(|value| Setting::default().with(key, value))
                .collect::<Vec<_>>()
        };
        vec![
            ("dt", over_dt(&[])),
            (
                "substeps",
                over("substeps", &["1", "2", "4", "8", "16", "32"]),
            ),
            ("recycling", over_dt(&[("contact_recycling", "true")])),
            ("soft-ccd", over_dt(&[("soft_ccd_prediction", "10")])),
            (
                "prediction",
                over(
                    "prediction_distance",
                    &["0.16", "0.08", "0.04", "0.02", "0.01", "0.005"],
                ),
            ),
            ("stock", over_dt(&[("preset", "stock")])),
        ]
    }

    fn remedies(&self, setting: &Setting) -> Vec<(&'static str, Setting)> {
        let Ok(settings) = Settings::read(setting) else {
            return Vec::new();
        };
        let mut remedies = Vec::new();
        if settings.contact_recycling {
            let fresh = setting.clone().with("contact_recycling", false);
            remedies.push(("contact recycling", fresh));
        }
        if settings.can_sleep {
            let awake = setting.clone().with("can_sleep", false);
            remedies.push(("sleep", awake));
        }
        let finer = setting.clone().with("dt", settings.dt / 8.0);
        remedies.push(("the time step", finer));
        remedies
    }

    fn prepare<'a>(
        &self,
        scene: &'a Scene,
        setting: &Setting,
    ) -> Result<Box<dyn Run + 'a>, Refusal> {
        let settings = Settings::read(setting)?.for_scene(scene)?;
        let version = self.version();
        Ok(match self.precision {
            Precision::Double => {
                let world = double::world::Billiard::new(scene, &settings);
                Box::new(Simulation::new(scene, settings, world, self.id, version))
            }
            Precision::Single => {
                let world = single::world::Billiard::new(scene, &settings);
                Box::new(Simulation::new(scene, settings, world, self.id, version))
            }
        })
    }
}
