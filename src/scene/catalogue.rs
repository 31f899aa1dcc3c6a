//! The scenes that come with the program: every file of `validation/scenes/`, built in.
//!
//! A new scene is one file and one line in [`all`]; a test compares the two.

use super::{Scene, SceneError, nearest, parse};

/// One scene of the catalogue, as written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Name of the scene, which is the name of its file.
    pub name: &'static str,
    /// The TOML file.
    pub text: &'static str,
}

impl Entry {
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
        &[$(Entry {
            name: $name,
            text: include_str!(concat!("../../validation/scenes/", $name, ".toml")),
        }),*]
    };
}

/// Every scene, in the order in which reports list them: the report's shot, single laws, several balls, known answers,
/// then the shots that call for rotation, one at a time, the effect ladder and real breaks.
pub fn all() -> &'static [Entry] {
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
        "bank",
        "bank-side",
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
    ]
}

/// The entry called `name`.
pub fn find(name: &str) -> Option<Entry> {
    all().iter().copied().find(|entry| entry.name == name)
}

/// The resolved scene called `name`; an unknown name is answered with the known ones.
pub fn scene(name: &str) -> Result<Scene, SceneError> {
    find(name).ok_or_else(|| unknown(name))?.scene()
}

/// The resolved scenes of one set, such as `report`, in catalogue order.
pub fn set(set: &str) -> Result<Vec<Scene>, SceneError> {
    let mut scenes = Vec::new();
    for entry in all() {
        let scene = entry.scene()?;
        if scene.sets.iter().any(|member| member == set) {
            scenes.push(scene);
        }
    }
    Ok(scenes)
}

/// The error that says that there is no scene called `name`, and which there are.
pub fn unknown(name: &str) -> SceneError {
    let names: Vec<&str> = all().iter().map(|entry| entry.name).collect();
    SceneError::Unknown {
        name: name.to_owned(),
        nearest: nearest(name, names.iter().copied()).map(str::to_owned),
        known: names.join(", "),
    }
}
