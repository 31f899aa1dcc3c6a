//! Engines with one thing wrong: in the scene that they run, in the trace that they hand over, or in a step.
//!
//! Each answers to the id of the engine that it stands for. What it holds, as the audit reads it, is what that engine holds: the fault is in
//! what it does.

use super::plain;
use super::slip::Slip;
use carom::engine::stepper::Settings;
use carom::engine::{
    self, About, Engine, Inside, Knob, Limits, Name, Pace, Parameter, Preset, Refusal, Run, Setting,
};
use carom::physics::invariants::Invariant;
use carom::scene::Scene;
use carom::trace::{Provenance, Record, Trace};
use std::sync::Arc;

/// What is wrong.
#[derive(Clone, Copy)]
pub enum Fault {
    /// It runs another scene.
    Scene(fn(&mut Scene)),
    /// It hands over another trace.
    Trace(fn(&Scene, &mut Trace)),
    /// It runs with another setting.
    Setting(&'static str, &'static str),
    /// A number of a law, by its key, is this many times what the scene says.
    Number(&'static str, f64),
    /// A step of the report's model is another.
    Step(Slip),
}

/// An engine with a fault.
pub struct Wrong {
    of: Arc<dyn Engine>,
    fault: Fault,
}

impl Wrong {
    /// The engine called `id` with a fault.
    pub fn engine(id: &str, fault: Fault) -> Arc<dyn Engine> {
        let of = Arc::clone(crate::support::find(id).unwrap());
        Arc::new(Wrong { of, fault })
    }

    /// The plain copy of the stepper with a slip.
    pub fn stepping(slip: Slip) -> Arc<dyn Engine> {
        Wrong::engine("stepper", Fault::Step(slip))
    }
}

/// Runs a scene in an engine that is in no list.
pub fn run(engine: &dyn Engine, settings: &[&str], scene: &Scene, record: Record) -> Trace {
    let setting = Setting::parse(settings.iter().copied()).unwrap();
    let run = engine::prepare(engine, scene, &setting)
        .unwrap_or_else(|refusal| panic!("{} on {}: {refusal}", engine.id(), scene.name));
    run.simulate(record, &Limits::NONE)
}

impl Engine for Wrong {
    fn id(&self) -> &str {
        self.of.id()
    }

    fn version(&self) -> String {
        self.of.version()
    }

    fn about(&self) -> About {
        self.of.about()
    }

    fn knobs(&self) -> Vec<Knob> {
        self.of.knobs()
    }

    fn family(&self) -> &str {
        self.of.family()
    }

    fn solves(&self) -> bool {
        self.of.solves()
    }

    fn ulp(&self, setting: &Setting) -> f64 {
        self.of.ulp(setting)
    }

    fn presets(&self) -> Vec<Preset> {
        self.of.presets()
    }

    fn step(&self, setting: &Setting) -> Option<f64> {
        self.of.step(setting)
    }

    fn missing(&self, scene: &Scene) -> Vec<Name> {
        self.of.missing(scene)
    }

    fn promises(&self, scene: &Scene, setting: &Setting) -> Vec<Invariant> {
        self.of.promises(scene, setting)
    }

    fn ladders(&self) -> Vec<(Name, Vec<Setting>)> {
        self.of.ladders()
    }

    fn pace(&self, scene: &Scene, setting: &Setting) -> Result<Pace, Refusal> {
        self.of.pace(scene, setting)
    }

    fn awake(&self, setting: &Setting) -> Setting {
        self.of.awake(setting)
    }

    fn ablations(&self, scene: &Scene, setting: &Setting) -> Vec<(Name, Setting)> {
        self.of.ablations(scene, setting)
    }

    fn prepare<'a>(
        &self,
        scene: &'a Scene,
        setting: &Setting,
    ) -> Result<Box<dyn Run + 'a>, Refusal> {
        Ok(Box::new(Prepared {
            right: self.of.prepare(scene, setting)?,
            of: Arc::clone(&self.of),
            fault: self.fault,
            scene,
            setting: setting.clone(),
        }))
    }
}

struct Prepared<'a> {
    right: Box<dyn Run + 'a>,
    of: Arc<dyn Engine>,
    fault: Fault,
    scene: &'a Scene,
    setting: Setting,
}

impl Prepared<'_> {
    /// Runs another scene under the name of the right one.
    fn instead(&self, other: &Scene, record: Record, limits: &Limits<'_>) -> Trace {
        let run = self.of.prepare(other, &self.setting).unwrap();
        let mut trace = run.simulate(record, limits);
        trace.provenance.scene_hash = self.scene.hash();
        trace
    }
}

impl Run for Prepared<'_> {
    fn inside(&self) -> Inside {
        self.right.inside()
    }

    fn sheet(&self) -> Vec<Parameter> {
        self.right.sheet()
    }

    fn simulate(self: Box<Self>, record: Record, limits: &Limits<'_>) -> Trace {
        match self.fault {
            Fault::Scene(change) => {
                let mut other = self.scene.clone();
                change(&mut other);
                self.instead(&other, record, limits)
            }
            Fault::Number(wanted, factor) => {
                let mut other = self.scene.clone();
                let change = |key, x: f64| if key == wanted { factor * x } else { x };
                other.effects = other.effects.map(change);
                self.instead(&other, record, limits)
            }
            Fault::Trace(change) => {
                let mut trace = self.right.simulate(record, limits);
                change(self.scene, &mut trace);
                trace
            }
            Fault::Setting(key, value) => {
                let other = self.setting.with(key, value);
                // where the wrong setting cannot run, the fault cannot show
                let run = self.of.prepare(self.scene, &other);
                run.unwrap_or(self.right).simulate(record, limits)
            }
            Fault::Step(slip) => {
                let settings: Settings = self.setting.read().unwrap();
                let provenance = Provenance {
                    engine: self.of.id().to_owned(),
                    version: self.of.version(),
                    parameters: parameters(&settings),
                    scene: self.scene.name.clone(),
                    scene_hash: self.scene.hash(),
                    resolution: settings.dt,
                    rest_speed: 0.0,
                    ulp: f64::EPSILON,
                };
                plain::simulate(self.scene, settings, slip, provenance, record, limits)
            }
        }
    }
}

fn parameters(settings: &Settings) -> std::collections::BTreeMap<String, serde_json::Value> {
    let value = serde_json::to_value(settings).unwrap();
    value.as_object().unwrap().clone().into_iter().collect()
}
