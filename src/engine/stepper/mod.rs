//! The report's hand-written model: fixed steps, exchange of normal velocities, Coulomb friction, walls.
//!
//! Steps are cut by the clock of every engine that steps. Every step does, in this order: the ball that was shot against each other ball; each pair of the others; friction;
//! walls; positions. The order is the report's and part of the model. What the report leaves open is a setting.
//!
//! What the report leaves out is simulated in its own spirit where a scene calls for it. Rotation: rates times dt in the
//! friction step, with clamps (see `cloth`). Losses and friction of impacts: the impulses of the scene's laws in place of the
//! exchange. Pockets: tested after the positions. The table holds every ball in its plane, with or without a cloth: what an
//! impact gives it of vertical motion is lost at once. All of it is first order in dt.

mod balls;
mod cloth;
mod contact;
mod overlaps;
mod pairs;
mod run;
mod sheet;
mod walls;

use super::setting::{knobs_of, refuse};
use super::stepped::check_step;
use super::{About, Engine, Knob, KnobRole, Name, Pace, Preset, Refusal, Run, Setting};
use crate::physics::invariants::Invariant;
use crate::physics::{Cloth, Contact};
use crate::scene::{Scene, Shot};
use run::Stepping;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The report's model as an engine.
#[derive(Debug)]
pub struct Stepper;

/// Settings of the report's model. Each default is the report's own rule.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// Time step, s, > 0. The scheme is first order: halving it halves the error.
    pub dt: f64,
    /// as-written: an overlapping pair exchanges in every step, with friction only while it approaches; approaching-only: only
    /// while it approaches.
    pub contact: ContactRule,
    /// contact-time: v = F contact_time / m, independent of dt; as-written: v = F dt / m.
    pub launch: Launch,
    /// Pairs that the search for overlaps looks at: auto, those nearby where there are many balls; all; near, those nearby.
    /// Changes cost only.
    pub partners: Partners,
}

/// When an overlapping pair exchanges its normal velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ContactRule {
    /// In every step in which it overlaps: the report's rule.
    AsWritten,
    /// Only if the normal velocities approach.
    ApproachingOnly,
}

/// What sets the shot's ball in motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Launch {
    /// The force acts for the scene's contact time.
    ContactTime,
    /// The force acts for one step: the report's rule, by which the shot depends on dt.
    AsWritten,
}

/// Which pairs the search for overlaps looks at. The trace is the same to the bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Partners {
    /// Those nearby in scenes of many balls, all in others.
    #[default]
    Auto,
    /// All.
    All,
    /// Those nearby.
    Near,
}

/// The engine's id.
const ID: &str = "stepper";

/// The key of the step.
const STEP: &str = "dt";

/// More steps than this are refused: at 100 ns a step they would take hours.
const MOST_STEPS: f64 = 1e11;

impl Default for Settings {
    fn default() -> Self {
        Settings {
            dt: 1e-3,
            contact: ContactRule::AsWritten,
            launch: Launch::ContactTime,
            partners: Partners::Auto,
        }
    }
}

impl Settings {
    /// Reads a setting whose step comes to an end in a scene.
    fn read(setting: &Setting, scene: &Scene) -> Result<Self, Refusal> {
        let settings: Settings = setting.read()?;
        check_step(STEP, settings.dt, scene, MOST_STEPS)?;
        Ok(settings)
    }

    /// Refuses rules that have no meaning in a scene.
    fn for_scene(self, scene: &Scene) -> Result<Self, Refusal> {
        let settings = self;
        if settings.launch == Launch::AsWritten && !matches!(scene.shot, Some(Shot::Force { .. })) {
            let message = "`launch=as-written` needs a scene with [shot.force]: v = F dt / m";
            return Err(refuse(Some("launch"), message.to_owned()));
        }
        if settings.contact == ContactRule::AsWritten && !scene.equal_masses() {
            let message = "`contact=as-written` exchanges velocities of equal masses, and the balls' masses differ; \
                           `contact=approaching-only` takes masses into account";
            return Err(refuse(Some("contact"), message.to_owned()));
        }
        Ok(settings)
    }
}

/// A deceleration, length/s^2, with which a ball that has all the energy is at rest before balls that share it; `None` where
/// something is not slowed.
///
/// Without rotation the root of the energy falls at least as fast as that of the lightest ball alone: mu g. A ball that turns slips
/// at up to sqrt(7/2) of the speed that its energy stands for, for 2/7 of that by `mu_slide g`, then rolls or spins for at most that
/// speed by the smaller of `mu_roll g` and `mu_spin g`.
fn slowest(scene: &Scene) -> Option<f64> {
    let mu = match scene.effects.cloth? {
        Cloth::Translational { mu } => mu,
        Cloth::Rotational {
            mu_slide,
            mu_roll,
            mu_spin,
        } => 1.0 / (2.0 / 7.0 * 3.5_f64.sqrt() / mu_slide + 1.0 / mu_roll.min(mu_spin)),
    };
    let slowest = mu * scene.gravity;
    (slowest > 0.0).then_some(slowest)
}

impl Engine for Stepper {
    fn id(&self) -> &str {
        ID
    }

    fn version(&self) -> String {
        format!("carom {}", env!("CARGO_PKG_VERSION"))
    }

    fn about(&self) -> About {
        About {
            name: "the report's model".into(),
            method: "the report's model: fixed steps, velocity exchange of overlapping balls, walls that push back; what the \
                     report leaves out goes by rates and impulses in the same steps"
                .into(),
            shares: "impact laws (but the report's exchange) and cushion laws with exact; nothing with rapier"
                .into(),
        }
    }

    fn knobs(&self) -> Vec<Knob> {
        knobs_of::<Settings>(&[(STEP, KnobRole::Step)])
    }

    fn presets(&self) -> Vec<Preset> {
        let as_written = Preset {
            id: "as-written".into(),
            words: "as written".into(),
            sampled: true,
            ..Preset::default()
        };
        let approaching_only = Preset {
            id: "approaching-only".into(),
            words: "approach check".into(),
            setting: Setting::default().with("contact", "approaching-only"),
            sound: true,
            ..Preset::default()
        };
        vec![as_written, approaching_only]
    }

    fn missing(&self, _scene: &Scene) -> Vec<Name> {
        // every law of the list: the matches on laws in this folder and in physics are exhaustive
        Vec::new()
    }

    fn promises(&self, scene: &Scene, setting: &Setting) -> Vec<Invariant> {
        let mut promises = vec![
            Invariant::Finite,
            Invariant::Momentum,
            Invariant::EnergyNeverGrows,
            Invariant::Bounds,
            Invariant::Rerun,
        ];
        let effects = &scene.effects;
        let lossless = match effects.contact {
            None | Some(Contact::Elastic {}) => effects.friction.is_none(),
            Some(Contact::Inelastic { .. }) => false,
        };
        if lossless {
            promises.push(Invariant::ImpactEnergy);
        }
        // a pair that separates and exchanges all the same has no law
        let rule = setting.read().map(|settings: Settings| settings.contact);
        if let Ok(ContactRule::ApproachingOnly) = rule {
            promises.push(Invariant::Laws);
        }
        if let Some(slowest) = slowest(scene)
            && scene.fastest() / slowest <= scene.duration
        {
            promises.push(Invariant::EverythingStops);
        }
        promises
    }

    fn ladders(&self) -> Vec<(Name, Vec<Setting>)> {
        let steps = [
            "0.02", "0.01", "5e-3", "2e-3", "1e-3", "5e-4", "2e-4", "1e-4", "5e-5", "2e-5", "1e-5",
            "5e-6", "2e-6", "1e-6",
        ];
        let dt = |base: &Setting| steps.iter().map(|dt| base.clone().with(STEP, dt)).collect();
        let as_written = Setting::default();
        let approaching = Setting::default().with("contact", "approaching-only");
        vec![
            ("as-written".into(), dt(&as_written)),
            ("approaching-only".into(), dt(&approaching)),
        ]
    }

    fn pace(&self, scene: &Scene, setting: &Setting) -> Result<Pace, Refusal> {
        let dt = Settings::read(setting, scene)?.dt;
        let nanoseconds = 10.0 + 5.0 * scene.balls.len() as f64;
        Ok(Pace {
            step: dt,
            cost: nanoseconds / dt,
        })
    }

    fn ablations(&self, _scene: &Scene, setting: &Setting) -> Vec<(Name, Setting)> {
        let Ok(settings) = setting.read::<Settings>() else {
            return Vec::new();
        };
        let mut ablations: Vec<(Name, Setting)> = Vec::new();
        if settings.contact == ContactRule::AsWritten {
            let approaching = setting.clone().with("contact", "approaching-only");
            ablations.push(("the overlap rule as written".into(), approaching));
        }
        let finer = setting.clone().with(STEP, settings.dt / 16.0);
        ablations.push(("the time step".into(), finer));
        ablations
    }

    fn prepare<'a>(
        &self,
        scene: &'a Scene,
        setting: &Setting,
    ) -> Result<Box<dyn Run + 'a>, Refusal> {
        let settings = Settings::read(setting, scene)?.for_scene(scene)?;
        Ok(Box::new(Stepping::new(scene, settings, self.version())))
    }
}
