//! The price list of one scene as a file, for a report made later.

use crate::scene::Scene;
use serde::{Deserialize, Serialize};

/// The price list of one scene as a file, for a report made later.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PriceList {
    /// Name of the scene.
    pub scene: String,
    /// Its fingerprint; a scene that changed since has other prices.
    pub scene_hash: String,
    /// Version of carom that made it.
    pub version: String,
    /// The command that makes it again.
    pub command: String,
    /// One entry a quantity and error; those that no setting reaches are left out.
    pub prices: Vec<Price>,
}

/// The cheapest setting for an error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Price {
    /// Id of the quantity.
    pub quantity: String,
    /// The error asked for, in the unit of the quantity.
    pub error: f64,
    /// The engine.
    pub engine: String,
    /// Its setting, as `--set` takes it.
    pub setting: String,
    /// The same with numbers of three digits.
    pub label: String,
    /// The error that it has.
    pub reached: f64,
    /// Time of a shot, s.
    pub seconds: f64,
}

impl PriceList {
    /// True if it belongs to this scene and this version.
    pub fn is_of(&self, scene: &Scene) -> bool {
        self.scene_hash == scene.hash() && self.version == env!("CARGO_PKG_VERSION")
    }
}
