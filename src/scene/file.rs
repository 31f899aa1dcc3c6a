//! The scene as a person writes it: what may stand in a TOML file, and nothing of what it means.
//!
//! These types are the only list of keys. The JSON Schema, the check of a file and its error messages derive from them: the
//! comment of a field is its description, and what follows the last semicolon of that comment is the advice that an error on
//! this field gives. Ranges are given as JSON Schema keywords.

use super::choices::{SetName, Simultaneous, TimeUnit};
use crate::physics::Effects;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A billiards scene for carom: balls on a table, what sets them in motion, and the effects that act on them.
///
/// Numbers are in any consistent units; x runs across the table, y along it, z up.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "carom scene")]
pub struct SceneFile {
    /// Unique name in kebab-case; `name = "my-shot"`.
    pub name: String,
    /// What the scene is and what would be right, in one or two sentences.
    #[serde(default)]
    pub description: String,
    /// Sets that the scene belongs to; `sets = ["report"]`.
    #[serde(default)]
    pub sets: Vec<SetName>,
    /// Longest simulated time, s, greater than 0, a run ends earlier once everything is at rest; the report's is 20.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub duration: f64,
    /// Whether the run goes on to `duration` after everything has come to rest; false if absent.
    #[serde(default)]
    pub run_to_duration: bool,
    /// Gravity, length/s^2, 0 or greater, required where a law uses it; 9.81 in metres.
    #[schemars(range(min = 0))]
    pub gravity: Option<f64>,
    /// What the numbers are measured in.
    #[serde(default)]
    pub units: UnitsFile,
    /// The table, an unbounded plane if absent; a `[table]` has a `width` along x and a `length` along y.
    pub table: Option<TableFile>,
    /// Radius and mass of every ball that does not say otherwise; a `[ball]` has `radius` and `mass`.
    #[serde(default)]
    pub ball: BallDefaults,
    /// Balls one by one, in scene order; each begins with the line `[[balls]]`.
    #[serde(default)]
    pub balls: Vec<BallFile>,
    /// A triangle of balls "1" to "15", after `[[balls]]` in scene order; a `[rack]` has `apex`, `rows` and `gap`.
    pub rack: Option<RackFile>,
    /// How one ball is set in motion; one of `[shot.force]`, `[shot.velocity]` and `[shot.strike]`.
    pub shot: Option<ShotFile>,
    /// The effects that act; what is not named is not simulated.
    #[serde(default)]
    pub effects: Effects,
    /// What the exact engine does when an impact involves touching balls.
    #[serde(default)]
    pub simultaneous: Simultaneous,
    /// Name of the scene with more effects that this one is a model of; `richer = "other-scene"`.
    pub richer: Option<String>,
    /// Engine settings that the scene wants to be tried besides the presets; `try = ["stepper dt=0.1"]`.
    #[serde(default)]
    #[schemars(rename = "try")]
    pub r#try: Vec<String>,
}

impl SceneFile {
    /// The text of the file: what parses to the same scene.
    ///
    /// Errors: none is known; what a file cannot hold has no place in these types.
    pub fn text(&self) -> Result<String, toml::ser::Error> {
        toml::to_string(self)
    }
}

/// Names of the units, and their size where a law needs it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnitsFile {
    /// Name of the length unit; `length = "m"`.
    pub length: Option<String>,
    /// Metres per length unit, greater than 0; required only by laws with SI constants.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub length_in_metres: Option<f64>,
    /// Name of the mass unit; `mass = "kg"`.
    pub mass: Option<String>,
    /// Kilograms per mass unit, greater than 0; required only by laws with SI constants.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mass_in_kg: Option<f64>,
    /// The time unit, which is the second; `time = "s"`.
    pub time: Option<TimeUnit>,
}

/// Edges of the playing surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TableFile {
    /// Extent along x, length, greater than 0; a pool table has 1.27 m between the cushions.
    #[schemars(extend("exclusiveMinimum" = 0, "examples" = [1.27]))]
    pub width: f64,
    /// Extent along y, length, greater than 0; a pool table has 2.54 m between the cushions.
    #[schemars(extend("exclusiveMinimum" = 0, "examples" = [2.54]))]
    pub length: f64,
    /// Corner with the smallest x and y, length, `[0, 0]` if absent; `origin = [0.0, 0.0]`.
    #[serde(default)]
    pub origin: [f64; 2],
}

/// What every ball is, unless it says otherwise.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallDefaults {
    /// Radius, length, greater than 0; a pool ball has 0.028575 m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Mass, greater than 0; a pool ball has 0.170097 kg.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mass: Option<f64>,
}

/// One ball.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallFile {
    /// Name of the ball, unique in the scene; `id = "cue"`.
    pub id: String,
    /// Centre at time 0, length; `position = [x, y]`.
    pub position: [f64; 2],
    /// Velocity of the centre at time 0, length/s, at rest if absent; `velocity = [vx, vy]`.
    #[schemars(extend("anySize" = true))]
    pub velocity: Option<[f64; 2]>,
    /// Angular velocity at time 0, rad/s, none if absent; `spin = [wx, wy, wz]`. Written in six digits or fewer, that of rolling is rolling to
    /// six digits.
    #[schemars(extend("anySize" = true))]
    pub spin: Option<[f64; 3]>,
    /// Radius, length, greater than 0, that of `[ball]` if absent; a pool ball has 0.028575 m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Mass, greater than 0, that of `[ball]` if absent; a pool ball has 0.170097 kg.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mass: Option<f64>,
}

/// A triangle of balls, row by row from the apex, x ascending; rows are (2 R + gap) sqrt(3)/2 apart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RackFile {
    /// Centre of ball "1", the one with the smallest y, length; `apex = [x, y]`.
    #[schemars(extend("examples" = [[0.635, 1.905]]))]
    pub apex: [f64; 2],
    /// Number of rows, 1 to 5; 5 rows are the 15 balls of pool.
    #[schemars(range(min = 1, max = 5), extend("examples" = [5]))]
    pub rows: u8,
    /// Distance between the surfaces of neighbours, length, 0 or greater; 0 is a frozen rack.
    #[schemars(range(min = 0), extend("examples" = [0.0002]))]
    pub gap: f64,
    /// Largest displacement of each ball, length, 0 or greater, none if absent; half the gap keeps balls apart.
    #[schemars(range(min = 0))]
    pub jitter: Option<f64>,
    /// Seed of the displacements, a whole number, required with `jitter`; any whole number will do.
    #[schemars(range(min = 0))]
    pub seed: Option<u64>,
}

/// How one ball is set in motion; one at most.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum ShotFile {
    /// A force that acts for a time: v = force * `contact_time` / mass.
    Force {
        /// Id of the ball; `ball = "cue"`.
        ball: String,
        /// Direction, degrees counter-clockwise from +x, -360 to 360; 90 is straight along the table.
        #[schemars(range(min = -360, max = 360), extend("examples" = [90.0]))]
        angle_deg: f64,
        /// Force, mass * length/s^2, 0 or greater; the report's is 108.
        #[schemars(range(min = 0), extend("examples" = [108.0]))]
        force: f64,
        /// Time for which the force acts, s, greater than 0; the report's is 0.01.
        #[schemars(extend("exclusiveMinimum" = 0, "examples" = [0.01]))]
        contact_time: f64,
    },
    /// A speed given directly.
    Velocity {
        /// Id of the ball; `ball = "cue"`.
        ball: String,
        /// Speed, length/s, 0 or greater; a brisk shot has 2 m/s.
        #[schemars(range(min = 0), extend("anySize" = true, "examples" = [2.0]))]
        speed: f64,
        /// Direction, degrees counter-clockwise from +x, -360 to 360; 90 is straight along the table.
        #[schemars(range(min = -360, max = 360), extend("examples" = [90.0]))]
        angle_deg: f64,
    },
    /// A cue that strikes the ball at rest, off its centre or not; in scenes that turn balls.
    Strike {
        /// Id of the ball; `ball = "cue"`.
        ball: String,
        /// Speed of the cue, length/s, 0 or greater; a brisk shot has 2 m/s.
        #[schemars(range(min = 0), extend("examples" = [2.0]))]
        speed: f64,
        /// Direction of the cue, degrees counter-clockwise from +x, -360 to 360; 90 is straight along the table.
        #[schemars(range(min = -360, max = 360), extend("examples" = [90.0]))]
        angle_deg: f64,
        /// How far the butt of the cue is raised, degrees, from 0 to 90, 0 if absent; a level shot has 5.
        #[serde(default)]
        #[schemars(range(min = 0, max = 90))]
        elevation_deg: f64,
        /// Mass of the cue, greater than 0; a pool cue has 0.567 kg.
        #[schemars(extend("exclusiveMinimum" = 0, "examples" = [0.567]))]
        cue_mass: f64,
        /// Mass at the tip that gives way sideways and deflects the ball (squirt), greater than 0, no deflection if absent; a thirtieth of the ball is typical.
        #[schemars(extend("exclusiveMinimum" = 0))]
        end_mass: Option<f64>,
        /// Offset of the tip to the left of the centre, in radii, from -1 to 1, 0 if absent; a tip slips beyond about 0.5.
        #[serde(default)]
        #[schemars(range(min = -1, max = 1))]
        side: f64,
        /// Offset of the tip above the centre, in radii, from -1 to 1, 0 if absent; 0.4 makes the ball roll at once.
        #[serde(default)]
        #[schemars(range(min = -1, max = 1))]
        top: f64,
    },
}

/// The JSON Schema of a scene file.
pub fn schema() -> serde_json::Value {
    schemars::schema_for!(SceneFile).to_value()
}
