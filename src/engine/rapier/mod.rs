//! The rapier engine.

use super::setting::knobs_of;
use super::{About, Engine, Knob, Refusal, Run, Setting};
use crate::physics::invariants::Invariant;
use crate::scene::Scene;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The rapier engine.
#[derive(Debug)]
pub struct Rapier(&'static str);

/// f64.
pub static RAPIER_F64: Rapier = Rapier("rapier-f64");
/// f32.
pub static RAPIER_F32: Rapier = Rapier("rapier-f32");

/// Settings.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
pub struct Settings {}

impl Engine for Rapier {
    fn id(&self) -> &'static str {
        self.0
    }
    fn version(&self) -> String {
        String::new()
    }
    fn about(&self) -> About {
        About {
            method: "",
            shares: "",
        }
    }
    fn knobs(&self) -> Vec<Knob> {
        knobs_of::<Settings>()
    }
    fn missing(&self, _scene: &Scene) -> Vec<&'static str> {
        vec!["anything yet"]
    }
    fn promises(&self, _scene: &Scene, _setting: &Setting) -> Vec<Invariant> {
        Vec::new()
    }
    fn ladders(&self) -> Vec<(&'static str, Vec<Setting>)> {
        Vec::new()
    }
    fn remedies(&self, _setting: &Setting) -> Vec<(&'static str, Setting)> {
        Vec::new()
    }
    fn prepare<'a>(
        &self,
        scene: &'a Scene,
        _setting: &Setting,
    ) -> Result<Box<dyn Run + 'a>, Refusal> {
        Err(Refusal::NotComparable {
            missing: self.missing(scene),
        })
    }
}
