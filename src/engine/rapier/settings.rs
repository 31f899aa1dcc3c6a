//! The knobs of `--set` for rapier: two presets, and every parameter of rapier that changes how such a scene moves.
//!
//! Materials, combination rules, locks and gravity are not here: they are the scene.

use crate::engine::setting::refuse;
use crate::engine::stepped::check_step;
use crate::engine::{Refusal, Setting};
use crate::scene::Scene;
use rapier3d_f64::dynamics::IntegrationParameters;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The key of the step.
pub(super) const STEP: &str = "dt";

/// The key that stands for the defaults of the others.
pub(super) const PRESET: &str = "preset";

/// More steps than this in one run are refused: half an hour at the least.
const MOST_STEPS: f64 = 1e8;

/// Which defaults the other knobs start from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Preset {
    /// The equivalent scene, set up so that the error falls with the step.
    #[default]
    Converging,
    /// rapier as it comes.
    Stock,
}

/// Which balls are swept along their path, so that they cannot pass through something in one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Ccd {
    /// None.
    Off,
    /// None while the largest initial speed moves a ball less than R/2 in a step; else as `cue`.
    Auto,
    /// Fast balls against what does not move.
    Fixed,
    /// Also the cue ball against balls.
    Cue,
    /// Every ball against balls.
    All,
}

/// rapier's two models of friction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Friction {
    /// One friction constraint a contact manifold, and one against twist.
    Simplified,
    /// One friction constraint a contact point.
    Coulomb,
}

/// Settings of rapier.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Settings {
    /// Where the other knobs start from: `converging` (the equivalent scene, set up so that its error falls with dt) or
    /// `stock` (rapier's own defaults for integration, sleep and CCD: dt = 1/60, contact_recycling, can_sleep, speed capped
    /// at 400 length units/s, rotation at a quarter of pi a step, ccd=fixed). Materials, combination rules and locks come from the scene in both.
    pub preset: Preset,
    /// Step, s, > 0: how often contact is looked for, and what event times are good to. rapier: dt.
    pub dt: f64,
    /// Substeps in a step, 1 to 1000: friction acts and positions move in each; restitution acts once, after the last.
    /// rapier: num_solver_iterations.
    pub substeps: u64,
    /// Sweeps over all contacts in a substep, 1 to 1000. rapier: num_internal_pgs_iterations.
    pub internal_iterations: u64,
    /// Sweeps without position correction after each substep's motion, 0 to 1000; with 0, correcting an overlap leaves a
    /// velocity behind. rapier: num_internal_stabilization_iterations.
    pub stabilization_iterations: u64,
    /// Keeps contact normals while two bodies moved less than contact_recycle_distance. The direction of an oblique hit then
    /// stops converging.
    pub contact_recycling: bool,
    /// See contact_recycling; length_units, >= 0. rapier: normalized_contact_recycle_distance.
    pub contact_recycle_distance: f64,
    /// Merges contact manifolds with one normal; balls have none to merge.
    pub contact_clustering: bool,
    /// Gap below which a contact is handed to the solver before it closes, length_units, > 0. A ball that moves farther in a
    /// step is found only once it overlaps. rapier: normalized_prediction_distance.
    pub prediction_distance: f64,
    /// Distance up to which a fast ball's contacts are predicted along its path, length, >= 0; 0 is off. Catches hits that a
    /// step would jump over, and turns their direction.
    pub soft_ccd_prediction: f64,
    /// Which balls are swept along their path: `off`; `auto` (off while the largest initial speed moves a ball less than R/2
    /// in a step, else `cue`); `fixed` (fast balls against cloth and cushions); `cue` (also the cue ball against balls); `all`
    /// (every ball is a bullet, and bullets do not sweep bullets).
    pub ccd: Ccd,
    /// Speed at which every ball is cut off, length_units/s, > 0; 1.7976931348623157e308 is no cap.
    pub normalized_max_linear_velocity: f64,
    /// Length of one metre in the scene's unit, > 0: scales sleep, prediction, recycling, correction and the speed cap.
    pub length_unit: f64,
    /// Lets slow balls fall asleep: they stop at once, and one that is hit falls freely for a step.
    pub can_sleep: bool,
    /// Lets a ball turn more than a quarter of pi in a step. Nothing turns where the scene has no rotation.
    pub allow_fast_rotation: bool,
    /// Slop kept by the sweep of ccd, length_units, >= 0; overlaps are corrected whatever it is. rapier:
    /// normalized_allowed_linear_error.
    pub allowed_linear_error: f64,
    /// Speed at which an overlap is pushed out at most, length_units/s, >= 0. rapier: normalized_max_corrective_velocity.
    pub max_corrective_velocity: f64,
    /// Stiffness of a contact of two balls, Hz, >= 0; it acts on overlaps only. rapier: contact_softness.
    pub contact_natural_frequency: f64,
    /// Damping ratio of a contact of two balls, >= 0. rapier: contact_softness.
    pub contact_damping_ratio: f64,
    /// Stiffness f of a contact with cloth or cushion, Hz, >= 0. A ball lies g / (2 pi f)^2 deep in its cloth at any step, and where
    /// balls turn it rolls on a lever that is shorter by half of that. rapier: static_contact_softness.
    pub static_contact_natural_frequency: f64,
    /// Damping ratio of a contact with cloth or cushion, >= 0. rapier: static_contact_softness.
    pub static_contact_damping_ratio: f64,
    /// Part of the last step's impulse that a contact starts from, 0 to 1.
    pub warmstart_coefficient: f64,
    /// Applies friction also while overlaps are being corrected.
    pub friction_in_bias_pass: bool,
    /// `simplified` (one friction constraint a contact manifold) or `coulomb` (one a contact point). The same for balls.
    pub friction_model: Friction,
}

impl Default for Settings {
    fn default() -> Self {
        Settings::of(Preset::Converging)
    }
}

/// Above 0 in f32 as well, where a smaller number is 0; the upper ends keep every product finite there.
const LEAST: f64 = f32::MIN_POSITIVE as f64;

impl Settings {
    /// The defaults of a preset.
    pub fn of(preset: Preset) -> Self {
        let stock = Settings::stock();
        match preset {
            Preset::Stock => stock,
            Preset::Converging => Settings {
                preset,
                dt: 1e-3,
                contact_recycling: false,
                ccd: Ccd::Auto,
                normalized_max_linear_velocity: f64::MAX,
                can_sleep: false,
                allow_fast_rotation: true,
                ..stock
            },
        }
    }

    /// rapier's own defaults, asked of rapier.
    fn stock() -> Self {
        let own = IntegrationParameters::default();
        Settings {
            preset: Preset::Stock,
            dt: own.dt,
            substeps: own.num_solver_iterations as u64,
            internal_iterations: own.num_internal_pgs_iterations as u64,
            stabilization_iterations: own.num_internal_stabilization_iterations as u64,
            contact_recycling: own.contact_recycling,
            contact_recycle_distance: own.normalized_contact_recycle_distance,
            contact_clustering: own.contact_clustering,
            prediction_distance: own.normalized_prediction_distance,
            soft_ccd_prediction: 0.0,
            ccd: Ccd::Fixed,
            normalized_max_linear_velocity: own.normalized_max_linear_velocity,
            length_unit: own.length_unit,
            can_sleep: true,
            allow_fast_rotation: false,
            allowed_linear_error: own.normalized_allowed_linear_error,
            max_corrective_velocity: own.normalized_max_corrective_velocity,
            contact_natural_frequency: own.contact_softness.natural_frequency,
            contact_damping_ratio: own.contact_softness.damping_ratio,
            static_contact_natural_frequency: own.static_contact_softness.natural_frequency,
            static_contact_damping_ratio: own.static_contact_softness.damping_ratio,
            warmstart_coefficient: own.warmstart_coefficient,
            friction_in_bias_pass: own.friction_in_bias_pass,
            friction_model: Friction::Simplified,
        }
    }

    /// Reads a setting: the preset first, then everything else over its defaults. Refuses what cannot run.
    pub fn read(setting: &Setting) -> Result<Self, Refusal> {
        let preset = match setting.values.get(PRESET).map(String::as_str) {
            None | Some("converging") => Preset::Converging,
            Some("stock") => Preset::Stock,
            Some(other) => {
                let message = format!("`{PRESET}={other}`: expected converging or stock");
                return Err(refuse(Some(PRESET), message));
            }
        };
        let settings: Settings = setting.read_over(&Settings::of(preset))?;
        settings.check()?;
        Ok(settings)
    }

    /// The same settings with everything that depends on the scene decided.
    pub fn for_scene(mut self, scene: &Scene) -> Result<Self, Refusal> {
        check_step(STEP, self.dt, scene, MOST_STEPS)?;
        if self.ccd == Ccd::Auto {
            let slow = scene.largest_speed() * self.dt < 0.5 * scene.smallest_radius();
            self.ccd = if slow { Ccd::Off } else { Ccd::Cue };
        }
        Ok(self)
    }

    /// Holds every number against its range.
    fn check(&self) -> Result<(), Refusal> {
        let counts = [
            ("substeps", self.substeps, 1),
            ("internal_iterations", self.internal_iterations, 1),
            ("stabilization_iterations", self.stabilization_iterations, 0),
        ];
        for (key, value, least) in counts {
            if !(least..=1000).contains(&value) {
                let message =
                    format!("`{key}={value}`: expected a whole number from {least} to 1000");
                return Err(refuse(Some(key), message));
            }
        }
        for (key, value, least, most) in self.numbers() {
            if !(least..=most).contains(&value) {
                let least = if least == LEAST {
                    "more than 0".to_owned()
                } else {
                    format!("{least} or more")
                };
                let message =
                    format!("`{key}={value}`: expected a number, {least} and at most {most:e}");
                return Err(refuse(Some(key), message));
            }
        }
        Ok(())
    }

    /// Each number by its key, with the least and the greatest that it may be.
    fn numbers(&self) -> [(&'static str, f64, f64, f64); 13] {
        [
            (STEP, self.dt, LEAST, 1e9),
            ("prediction_distance", self.prediction_distance, LEAST, 1e6),
            ("length_unit", self.length_unit, 1e-6, 1e6),
            (
                "normalized_max_linear_velocity",
                self.normalized_max_linear_velocity,
                LEAST,
                f64::MAX,
            ),
            (
                "contact_recycle_distance",
                self.contact_recycle_distance,
                0.0,
                1e9,
            ),
            ("soft_ccd_prediction", self.soft_ccd_prediction, 0.0, 1e9),
            ("allowed_linear_error", self.allowed_linear_error, 0.0, 1e9),
            (
                "max_corrective_velocity",
                self.max_corrective_velocity,
                0.0,
                1e9,
            ),
            (
                "contact_natural_frequency",
                self.contact_natural_frequency,
                0.0,
                1e9,
            ),
            (
                "contact_damping_ratio",
                self.contact_damping_ratio,
                0.0,
                1e9,
            ),
            (
                "static_contact_natural_frequency",
                self.static_contact_natural_frequency,
                0.0,
                1e9,
            ),
            (
                "static_contact_damping_ratio",
                self.static_contact_damping_ratio,
                0.0,
                1e9,
            ),
            (
                "warmstart_coefficient",
                self.warmstart_coefficient,
                0.0,
                1.0,
            ),
        ]
    }
}
