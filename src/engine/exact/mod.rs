//! The event-driven engine.

use super::setting::knobs_of;
use super::{About, Engine, Knob, Refusal, Run, Setting};
use crate::physics::invariants::Invariant;
use crate::scene::Scene;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The event-driven engine.
#[derive(Debug)]
pub struct Exact;

/// Settings.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
pub struct Settings {}

impl Engine for Exact {
    fn id(&self) -> &'static str {
        "exact"
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
