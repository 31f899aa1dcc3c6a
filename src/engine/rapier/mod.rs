//! The engines `rapier-f64` and `rapier-f32`: the scene in rapier3d, by its own solver.
//!
//! | file | what lives there |
//! |---|---|
//! | `settings.rs` | the knobs and the two presets |
//! | `world.rs` | the equivalent scene inside rapier; compiled twice, in `double.rs` and `single.rs` |
//! | `materials.rs` | the rules by which rapier combines coefficients |
//! | `sheet.rs` | rapier's parameters by its own names |
//!
//! Loop, journal, and what of the cloth rapier lacks are those of every engine that steps: [`super::stepped`].

mod double;
mod materials;
mod settings;
mod sheet;
mod single;

pub use settings::{Ccd, Friction, Preset, Settings};

use super::built::{Built, built};
use super::setting::{knobs_of, parameters};
use super::stepped::{Setup, Stepped, World};
use super::{About, Engine, Knob, KnobRole, Name, Pace, Preset as Known, Refusal, Run, Setting};
use crate::physics::invariants::Invariant;
use crate::physics::{self, Cloth, Contact, Cushion};
use crate::scene::Scene;
use settings::{PRESET, STEP};

/// The scene in rapier, in one precision.
#[derive(Debug)]
pub struct Rapier {
    id: &'static str,
    name: &'static str,
    package: &'static str,
    precision: Precision,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Precision {
    Double,
    Single,
}

/// rapier in f64.
pub const RAPIER_F64: Rapier = Rapier {
    id: "rapier-f64",
    name: "rapier",
    package: "rapier3d-f64",
    precision: Precision::Double,
};

/// rapier in f32.
pub const RAPIER_F32: Rapier = Rapier {
    id: "rapier-f32",
    name: "rapier in f32",
    package: "rapier3d",
    precision: Precision::Single,
};

impl Rapier {
    fn crate_of_it(&self) -> Built {
        let compiled = match self.precision {
            Precision::Double => double::world::compiled_at(),
            Precision::Single => single::world::compiled_at(),
        };
        built(self.package, compiled)
    }

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
    fn id(&self) -> &str {
        self.id
    }

    fn version(&self) -> String {
        self.crate_of_it().to_string()
    }

    fn built(&self) -> Vec<Built> {
        vec![self.crate_of_it()]
    }

    fn about(&self) -> About {
        About {
            name: self.name.into(),
            method: "Fixed steps of the rapier physics engine: contacts are predicted once a step, a sequential-impulse \
                     solver moves the balls in substeps, and restitution acts once at the end of the step."
                .into(),
            shares: "With stepper and exact nothing but the scene: sliding, contacts and cushions are rapier's own solver. What \
                     rapier lacks uses rates and coefficients of the workbench: rolling resistance and spin-down (as stepper), \
                     friction between balls that depends on their slip speed, and who is in a pocket (as all). The two rapier \
                     engines are one source in two precisions."
                .into(),
        }
    }

    fn family(&self) -> &str {
        "rapier"
    }

    fn ulp(&self, _setting: &Setting) -> f64 {
        match self.precision {
            Precision::Double => f64::EPSILON,
            Precision::Single => f64::from(f32::EPSILON),
        }
    }

    fn knobs(&self) -> Vec<Knob> {
        knobs_of::<Settings>(&[(STEP, KnobRole::Step), (PRESET, KnobRole::Preset)])
    }

    fn presets(&self) -> Vec<Known> {
        let converging = Known {
            id: "converging".into(),
            ..Known::default()
        };
        let stock = Known {
            id: "stock".into(),
            words: "stock".into(),
            setting: Setting::default().with(PRESET, "stock"),
            compared: false,
            // its step is one of the defaults that it is made of
            swept: false,
            ..Known::default()
        };
        vec![converging, stock]
    }

    fn missing(&self, scene: &Scene) -> Vec<Name> {
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
                missing.push(law.id().into());
            }
        }
        if scene.effects.contact.is_some() && !scene.equal_radii() {
            missing.push(
                "balls of unequal radii that meet (the tilted impact would lift one off the table)"
                    .into(),
            );
        }
        if !self.fits(scene) {
            let numbers = "numbers as large or as small as the scene's in its arithmetic";
            missing.push(numbers.into());
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

    fn ladders(&self) -> Vec<(Name, Vec<Setting>)> {
        let steps = [
            60.0, 120.0, 250.0, 500.0, 1000.0, 2000.0, 4000.0, 8000.0, 16000.0, 32000.0, 64000.0,
        ];
        let over_dt = |fixed: &[(&str, &str)]| {
            let base = fixed
                .iter()
                .fold(Setting::default(), |s, (key, value)| s.with(key, value));
            steps
                .iter()
                .map(|rate| base.clone().with(STEP, 1.0 / rate))
                .collect::<Vec<_>>()
        };
        let over = |key: &str, values: &[&str]| {
            values
                .iter()
                .map(|value| Setting::default().with(key, value))
                .collect::<Vec<_>>()
        };
        vec![
            ("converging".into(), over_dt(&[])),
            ("stock".into(), over_dt(&[(PRESET, "stock")])),
            (
                "recycling".into(),
                over_dt(&[("contact_recycling", "true")]),
            ),
            (
                "substeps".into(),
                over("substeps", &["1", "2", "4", "8", "16", "32"]),
            ),
            ("soft-ccd".into(), over_dt(&[("soft_ccd_prediction", "10")])),
            (
                "prediction".into(),
                over(
                    "prediction_distance",
                    &["0.16", "0.08", "0.04", "0.02", "0.01", "0.005"],
                ),
            ),
        ]
    }

    fn pace(&self, scene: &Scene, setting: &Setting) -> Result<Pace, Refusal> {
        let settings = Settings::read(setting)?.for_scene(scene)?;
        let a_ball = 350.0 + 300.0 * settings.substeps as f64;
        let nanoseconds = 1500.0 + a_ball * scene.balls.len() as f64;
        Ok(Pace {
            step: settings.dt,
            cost: nanoseconds / settings.dt,
        })
    }

    fn step(&self, setting: &Setting) -> Option<f64> {
        Some(Settings::read(setting).ok()?.dt)
    }

    fn awake(&self, setting: &Setting) -> Setting {
        match Settings::read(setting) {
            Ok(settings) if settings.can_sleep => setting.clone().with("can_sleep", false),
            _ => setting.clone(),
        }
    }

    fn ablations(&self, scene: &Scene, setting: &Setting) -> Vec<(Name, Setting)> {
        let Ok(settings) = Settings::read(setting).and_then(|settings| settings.for_scene(scene))
        else {
            return Vec::new();
        };
        let with = |key: &str, value: &str| setting.clone().with(key, value);
        let mut ablations: Vec<(Name, Setting)> = Vec::new();
        let meet = scene.effects.contact.is_some() && scene.balls.len() > 1;
        if settings.contact_recycling && meet {
            ablations.push((
                "contact recycling".into(),
                with("contact_recycling", "false"),
            ));
        }
        if settings.can_sleep {
            ablations.push(("sleep".into(), with("can_sleep", "false")));
        }
        let fastest = scene.fastest();
        if fastest > settings.normalized_max_linear_velocity * settings.length_unit {
            let none = format!("{:e}", f64::MAX);
            ablations.push((
                "the cap on speed".into(),
                with("normalized_max_linear_velocity", &none),
            ));
        }
        // rolling turns a ball by its speed over its radius
        let turn = settings.dt * fastest / scene.smallest_radius();
        if !settings.allow_fast_rotation
            && scene.effects.rotates()
            && turn > std::f64::consts::FRAC_PI_4
        {
            ablations.push((
                "the cap on rotation".into(),
                with("allow_fast_rotation", "true"),
            ));
        }
        let jumps = fastest * settings.dt > 2.0 * scene.smallest_radius();
        let sweeps = matches!(settings.ccd, Ccd::Cue);
        if jumps && !sweeps && meet {
            ablations.push(("the sweep of the cue ball".into(), with("ccd", "cue")));
        }
        let finer = setting.clone().with(STEP, settings.dt / 8.0);
        ablations.push(("the time step".into(), finer));
        ablations
    }

    fn prepare<'a>(
        &self,
        scene: &'a Scene,
        setting: &Setting,
    ) -> Result<Box<dyn Run + 'a>, Refusal> {
        let settings = Settings::read(setting)?.for_scene(scene)?;
        Ok(match self.precision {
            Precision::Double => {
                let world = double::world::Billiard::new(scene, &settings);
                let gravity = world.gravity();
                Box::new(self.run(scene, &settings, world, gravity))
            }
            Precision::Single => {
                let world = single::world::Billiard::new(scene, &settings);
                let gravity = world.gravity();
                Box::new(self.run(scene, &settings, world, gravity))
            }
        })
    }
}

impl Rapier {
    /// A run of what is in `world`; `gravity`, length/s^2, as it holds it.
    fn run<'a, W: World>(
        &self,
        scene: &'a Scene,
        settings: &Settings,
        world: W,
        gravity: f64,
    ) -> Stepped<'a, W> {
        Stepped::new(scene, world, |inside| Setup {
            engine: self.id.to_owned(),
            version: self.version(),
            parameters: parameters(settings),
            sheet: sheet::sheet(scene, settings, inside, gravity),
            dt: settings.dt,
            substeps: settings.substeps,
        })
    }
}
