//! The scenes that come with the program: every file of `validation/scenes/`, built in.
//!
//! A new scene is one file and one line in [`all`]; a test compares the two.

use super::{Scene, SceneError, SetName, nearest_names, parse};
use crate::carried;

/// One scene of the catalogue, as written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CatalogueEntry {
    /// Name of the scene, which is the name of its file.
    pub name: &'static str,
    /// The TOML file.
    pub text: &'static str,
}

impl CatalogueEntry {
    /// Name of the file below `validation/scenes/`.
    pub fn file_name(&self) -> String {
        format!("{}.toml", self.name)
    }

    /// The resolved scene.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        parse(&self.file_name(), self.text)
    }
}

macro_rules! entries {
    ($($name:literal),* $(,)?) => {
        const { &[$(CatalogueEntry {
            name: $name,
            text: match carried::text(concat!("scenes/", $name, ".toml")) {
                Some(text) => text,
                // the compiler says so, not the program
                None => panic!(concat!("validation/scenes has no ", $name, ".toml")),
            },
        }),*] }
    };
}

/// Every scene, in the order in which reports list them: the report's shot, single laws, several balls, known answers,
/// then the shots that call for rotation, one at a time, what the gate needs to go through every branch and key, the effect ladder and
/// real breaks; last the hard cases by what they provoke: simultaneous contacts, impacts that shrink and contacts that last, grazes, speeds, cloths, masses, lengths, restitution, rotation, habits of engines.
// long: the list of scenes, one a line
pub fn all() -> &'static [CatalogueEntry] {
    entries![
        "report-break",
        "report-break-central",
        "report-break-frozen",
        "report-break-frozen-reflections",
        "report-break-frozen-ensemble",
        "report-break-tight",
        "report-break-tight-mirrored",
        "slide",
        "head-on",
        "oblique",
        "cushions",
        "three-ball",
        "cradle",
        "cradle-reflections",
        "triple-hit",
        "triple-hit-reflections",
        "triple-hit-ensemble",
        "six-balls",
        "break-36-events",
        "discs-in-a-box",
        "draw",
        "stun",
        "follow",
        "side",
        "curve",
        "throw",
        "throw-masses",
        "throw-radii",
        "throw-unequal",
        "throw-alciatore",
        "throw-alciatore-masses",
        "throw-alciatore-radii",
        "throw-alciatore-unequal",
        "smooth-radii",
        "spin-brings-together",
        "bank",
        "bank-side",
        "cushion-restitution",
        "lively-cushions",
        "cushions-han",
        "cushions-mathavan",
        "cushions-mathavan-rough",
        "cushions-mathavan-gearing",
        "cushions-mathavan-creeping",
        "cushions-mathavan-high",
        "pocket-drops",
        "launched",
        "slow-roller",
        "keys-of-rapier",
        "ladder-report",
        "ladder-rotation",
        "ladder-rolling",
        "ladder-losses",
        "ladder-throw",
        "ladder-cushions",
        "ladder-pockets",
        "pool-break",
        "report-break-real",
        "report-break-pressed",
        "rack-frozen-central",
        "rack-frozen-central-reflections",
        "rack-frozen-oblique",
        "rack-hair-gaps",
        "rack-lossy",
        "rack-at-rest",
        "rack-at-rest-long",
        "cradle-3",
        "cradle-15",
        "cradle-gap-1e-2",
        "cradle-gap-1e-4",
        "cradle-gap-1e-6",
        "cradle-gap-1e-9",
        "cradle-15-gap-1e-6",
        "cradle-two-in",
        "cradle-two-in-gap-1e-6",
        "cradle-nearly-elastic",
        "cradle-nearly-elastic-gap-1e-4",
        "triple-hit-off-centre",
        "frozen-to-cushion",
        "frozen-to-cushion-oblique",
        "frozen-to-ball",
        "frozen-to-ball-oblique",
        "frozen-to-ball-and-cushion",
        "frozen-in-corner",
        "corner-double-hit",
        "soft-break-2ms",
        "soft-break-4ms",
        "accumulate-three",
        "accumulate-four-lossy",
        "press-plastic",
        "clay-follow",
        "press-follow",
        "press-off-line",
        "press-three",
        "press-cushion",
        "one-on-two-lossy",
        "two-at-once-lossy",
        "frozen-pair-combination",
        "thin-cut-1e-2",
        "thin-cut-1e-6",
        "thin-cut-1e-12",
        "thin-cut-1e-15",
        "near-miss-1e-2",
        "near-miss-1e-6",
        "near-miss-1e-12",
        "near-miss-1e-15",
        "catch-up-1e-6",
        "catch-up-1e-12",
        "catch-up-on-cloth",
        "residual-1e-8",
        "residual-1e-8-on-cloth",
        "residual-1e-300-on-cloth",
        "residual-1e-160",
        "residual-1e-300",
        "speed-1e6",
        "speed-cap",
        "through-a-ball",
        "through-a-ball-oblique",
        "through-a-cushion",
        "long-step",
        "cloth-mu-0",
        "cloth-mu-1e-9",
        "cloth-mu-10",
        "heavy-into-light",
        "light-into-heavy",
        "galperin-314",
        "galperin-99345",
        "bounces-1000",
        "bounces-100000",
        "table-far-away",
        "lengths-1e-6",
        "lengths-1e6",
        "diagonal-slide-30",
        "diagonal-slide-45",
        "cushion-slow",
        "cushion-medium",
        "restitution-fast",
        "restitution-slow",
        "restitution-creeping",
        "plastic-hit",
        "collapse-three",
        "collapse-chain",
        "spin-far-above-rolling",
        "spin-in-place",
        "rolling-into-sleep",
        "rotation-cap",
        "contact-recycling",
        "prediction-distance",
        "hit-a-sleeper",
        "fine-steps-in-f32",
    ]
}

/// The entry called `name`.
pub fn find(name: &str) -> Option<CatalogueEntry> {
    all().iter().copied().find(|entry| entry.name == name)
}

/// The resolved scene called `name`; an unknown name is answered with the nearest.
pub fn scene(name: &str) -> Result<Scene, SceneError> {
    find(name).ok_or_else(|| unknown(name))?.scene()
}

/// The resolved scenes of one set, in catalogue order.
pub fn set(set: SetName) -> Result<Vec<Scene>, SceneError> {
    let mut scenes = Vec::new();
    for entry in all() {
        let scene = entry.scene()?;
        if scene.is_in(set) {
            scenes.push(scene);
        }
    }
    Ok(scenes)
}

/// The error that says that there is no scene called `name`, and which names are near.
pub fn unknown(name: &str) -> SceneError {
    let near = nearest_names(name, all().iter().map(|entry| entry.name));
    SceneError::Unknown {
        name: name.to_owned(),
        nearest: near.into_iter().map(str::to_owned).collect(),
    }
}
