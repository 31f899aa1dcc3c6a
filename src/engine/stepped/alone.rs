//! An engine that is a world and nothing else: what an author needs who has written one and wants to see it compared.

use super::clock::check_step;
use super::run::{Setup, Stepped};
use super::world::World;
use crate::engine::setting::parameters;
use crate::engine::{
    About, Engine, Knob, KnobRole, Name, Pace, Parameter, Refusal, Role, Run, Setting,
};
use crate::physics::invariants::Invariant;
use crate::scene::Scene;
use serde::{Deserialize, Serialize};

/// The key of the step.
const STEP: &str = "dt";

/// More steps than this in one run are refused.
const MOST_STEPS: f64 = 1e9;

/// Parts of the default step in which a study of cost runs it, from coarse to fine.
const LADDER: [f64; 7] = [8.0, 4.0, 2.0, 1.0, 0.5, 0.25, 0.125];

/// An engine made of a [`World`]: its step is its one setting.
#[derive(Clone, Debug)]
pub struct WorldEngine<W> {
    /// Unique kebab-case name.
    pub id: Name,
    /// Name and version of what does the work.
    pub version: Name,
    /// What it is.
    pub about: About,
    /// Its step unless told otherwise, s, > 0.
    pub dt: f64,
    /// Roughly what a step costs for each ball, ns.
    pub cost: f64,
    /// What the scene calls for and the world cannot simulate.
    pub missing: fn(&Scene) -> Vec<Name>,
    /// Invariants that hold for every run.
    pub promises: Vec<Invariant>,
    /// Puts a scene into a new world.
    pub world: fn(&Scene) -> W,
}

/// What `--set` gives.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Settings {
    dt: f64,
}

impl<W> WorldEngine<W> {
    /// An engine called `id` whose world is made by `world`: steps of a millisecond, some hundred nanoseconds a ball, every law
    /// simulated, and promised what every sound program keeps: numbers, momentum in impacts, the same again.
    pub fn new(id: impl Into<Name>, world: fn(&Scene) -> W) -> Self {
        let id = id.into();
        WorldEngine {
            version: id.clone(),
            about: About {
                name: id.clone(),
                method: "Fixed steps.".into(),
                shares: "Nothing but the scene.".into(),
            },
            id,
            dt: 1e-3,
            cost: 100.0,
            missing: |_| Vec::new(),
            promises: vec![Invariant::Finite, Invariant::Momentum, Invariant::Rerun],
            world,
        }
    }

    fn read(&self, scene: &Scene, setting: &Setting) -> Result<Settings, Refusal> {
        let settings = setting.read_over(&Settings { dt: self.dt })?;
        check_step(STEP, settings.dt, scene, MOST_STEPS)?;
        Ok(settings)
    }
}

impl<W: World + 'static> Engine for WorldEngine<W> {
    fn id(&self) -> &str {
        &self.id
    }

    fn version(&self) -> String {
        self.version.to_string()
    }

    fn about(&self) -> About {
        self.about.clone()
    }

    fn knobs(&self) -> Vec<Knob> {
        vec![Knob {
            key: STEP.to_owned(),
            default: self.dt.to_string(),
            what: "Step, s, > 0.".to_owned(),
            choices: Vec::new(),
            role: KnobRole::Step,
        }]
    }

    fn missing(&self, scene: &Scene) -> Vec<Name> {
        (self.missing)(scene)
    }

    fn promises(&self, _scene: &Scene, _setting: &Setting) -> Vec<Invariant> {
        self.promises.clone()
    }

    fn ladders(&self) -> Vec<(Name, Vec<Setting>)> {
        let steps = LADDER.iter();
        let steps = steps.filter_map(|part| self.with_step(&Setting::default(), part * self.dt));
        vec![("steps".into(), steps.collect())]
    }

    fn pace(&self, scene: &Scene, setting: &Setting) -> Result<Pace, Refusal> {
        let step = self.read(scene, setting)?.dt;
        Ok(Pace {
            step,
            cost: self.cost * scene.balls.len() as f64 / step,
        })
    }

    fn ablations(&self, _scene: &Scene, setting: &Setting) -> Vec<(Name, Setting)> {
        let step = self.step(setting);
        let finer = step.and_then(|step| self.with_step(setting, step / 16.0));
        finer
            .map(|finer| ("the time step".into(), finer))
            .into_iter()
            .collect()
    }

    fn prepare<'a>(
        &self,
        scene: &'a Scene,
        setting: &Setting,
    ) -> Result<Box<dyn Run + 'a>, Refusal> {
        let settings = self.read(scene, setting)?;
        let run = Stepped::new(scene, (self.world)(scene), |_| Setup {
            engine: self.id.to_string(),
            version: self.version.to_string(),
            parameters: parameters(&settings),
            sheet: vec![Parameter::new(Role::TimeStep, STEP, settings.dt, "s")],
            dt: settings.dt,
            substeps: 1,
        });
        Ok(Box::new(run))
    }
}
