//! What a page needs to show again what the engines did: the knots of their traces, and where they part.

use crate::trace::Path;
use serde::Serialize;

/// One scene as every engine ran it. Lengths, speeds and times in the units of the scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Replay {
    /// Name of the scene.
    pub scene: String,
    /// Longest simulated time that the scene asks for, s.
    pub duration: f64,
    /// Name of the length unit.
    pub length_unit: String,
    /// Name of the time unit.
    pub time_unit: String,
    /// Where coordinates are counted from, so that few digits are enough for them: the middle of the table at height 0.
    pub origin: [f64; 3],
    /// Unit of lengths in reports: the smallest radius, > 0.
    pub radius: f64,
    /// Unit of speeds in reports: the largest initial speed, or 1 where nothing moves, > 0.
    pub speed_scale: f64,
    /// Smallest and largest corner of the playing surface; `None` is an unbounded plane.
    pub table: Option<[[f64; 2]; 2]>,
    /// Pockets as x, y and radius.
    pub pockets: Vec<[f64; 3]>,
    /// Whether the scene calls for rotation: only then do balls turn.
    pub rotates: bool,
    /// All balls in scene order.
    pub balls: Vec<ReplayBall>,
    /// Every engine that ran, in the order of the comparison.
    pub runs: Vec<ReplayRun>,
    /// Where collision orders first differ, by time.
    pub partings: Vec<ReplayParting>,
    /// Time up to which the reference can be believed, s; `None` for a whole shot and where nothing is known.
    pub horizon: Option<f64>,
    /// Distance between runs over time.
    pub divergence: Vec<ReplayDivergence>,
    /// What the replay does not show, in one sentence; empty where it shows all.
    pub remark: String,
}

impl Replay {
    /// What is there to be played, in one sentence, for those who cannot play it here.
    pub fn summary(&self) -> String {
        let many = |n: usize, what: &str| match n {
            1 => format!("1 {what}"),
            n => format!("{n} {what}s"),
        };
        format!(
            "{} in {}; the page of this scene in a report plays them. {}",
            many(self.balls.len(), "ball"),
            many(self.runs.len(), "run"),
            self.remark
        )
        .trim_end()
        .to_owned()
    }
}

/// One ball.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReplayBall {
    /// Its name.
    pub id: String,
    /// Radius, length.
    pub radius: f64,
    /// Mass.
    pub mass: f64,
    /// Moment of inertia, mass * length^2; 0 where the scene does not call for rotation.
    pub inertia: f64,
}

/// One engine's run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReplayRun {
    /// Engine and setting.
    pub label: String,
    /// Engine id.
    pub engine: String,
    /// Whether the others are held against it.
    pub reference: bool,
    /// Simulated time at which it ended, s.
    pub end: f64,
    /// Why it ended, in a few words.
    pub ending: String,
    /// What its event times are good to, s.
    pub resolution: f64,
    /// What happened, by time; the remark of the replay says where there is more.
    pub events: Vec<ReplayEvent>,
    /// One path a ball. The document's JSON leaves them out: they are what `carom run` writes.
    #[serde(skip)]
    pub paths: Vec<Path>,
    /// Knots that the paths lack because the others give them.
    pub left_out: usize,
    /// How far those may be from what the others give, in R; speeds in `speed_scale`, spins in `speed_scale` / R.
    pub tolerance: f64,
}

/// One event.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReplayEvent {
    /// s.
    pub time: f64,
    /// Kind, as in `events.csv`.
    pub kind: &'static str,
    /// First party, as in `events.csv`.
    pub a: String,
    /// Second party, as in `events.csv`; empty for none.
    pub b: String,
}

/// A first difference between the collision orders of two runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReplayParting {
    /// The earlier of the two events, s.
    pub time: f64,
    /// Indices of both runs; the second stands for what is right, if one of them does.
    pub runs: [usize; 2],
    /// The balls of both events.
    pub balls: Vec<String>,
    /// What differs and why, in one sentence.
    pub words: String,
}

/// Largest distance of any ball between two runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReplayDivergence {
    /// Index of the run.
    pub run: usize,
    /// Index of the run that it is held against.
    pub against: usize,
    /// Time in s and distance in R, by time; fewer than were measured, within what a picture shows.
    pub points: Vec<[f64; 2]>,
}
