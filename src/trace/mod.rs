//! What a run left behind: paths of knots, events, extrema. Every engine writes it through the one [`Recorder`].

mod certainty;
mod contacts;
mod counter;
mod event;
pub mod files;
mod path;
mod recorder;
pub mod thin;

pub use certainty::Certainty;
pub use contacts::{Contacts, UNEXPLAINED_IN_CONTACT};
pub use counter::Counter;
pub use event::{Event, EventKind, Partner};
pub use path::{Knot, Path};
pub use recorder::{Record, Recorder};

use crate::math::worse;
use crate::physics::State;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The complete result of one run.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// What was run, with which version and which parameters.
    pub provenance: Provenance,
    /// Ball ids in scene order; index i of everything below belongs to `balls[i]`.
    pub balls: Vec<String>,
    /// One path a ball, from time 0 to `end_time` or to the pocket.
    pub paths: Vec<Path>,
    /// All events in the order in which they happened.
    pub events: Vec<Event>,
    /// How certain each event is, in the order of `events`; empty where the engine does not say.
    pub certainty: Vec<Certainty>,
    /// When the centre velocity of each ball last became zero, s; `None` while it moves at the end or when pocketed.
    pub stop_times: Vec<Option<f64>>,
    /// The worst values of quantities that should stay small.
    pub extrema: Extrema,
    /// Deterministic counts of the work done, by name: the ids of [`Counter`], and what other programs count.
    pub counters: BTreeMap<String, u64>,
    /// Why the run ended.
    pub ending: Ending,
    /// Simulated time at which it ended, s.
    pub end_time: f64,
}

/// Where a trace comes from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Provenance {
    /// Engine id, such as `rapier-f64`.
    pub engine: String,
    /// The engine's own name and version.
    pub version: String,
    /// Every effective parameter, by the key of `--set`.
    pub parameters: BTreeMap<String, serde_json::Value>,
    /// Name of the scene.
    pub scene: String,
    /// Hash of the resolved scene.
    pub scene_hash: String,
    /// What the engine's event times are good to, s: its step, or 0 for an engine that solves for them.
    pub resolution: f64,
    /// Speed at or below which the engine calls a ball stopped, length/s.
    pub rest_speed: f64,
    /// Spacing of the engine's numbers just above 1; finer than f64's where it computes in more digits than the trace holds.
    pub ulp: f64,
}

impl Provenance {
    /// Relative rounding of the numbers of the trace, which is f64 at the finest.
    pub fn rounding(&self) -> f64 {
        self.ulp.max(f64::EPSILON)
    }
}

/// The worst value of one quantity over a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Extremum {
    /// The value; 0 when nothing happened.
    pub value: f64,
    /// When, s.
    pub time: f64,
    /// The ball concerned, if one is.
    pub ball: Option<u32>,
    /// The second ball, if two are.
    pub other: Option<u32>,
}

/// The worst values of quantities that should stay small, taken at every step or event.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Extrema {
    /// Largest rise of kinetic energy above an earlier level, mass * length^2/s^2. Time and balls: when it was reached.
    pub energy_gained: Extremum,
    /// Largest change of momentum in a ball-ball impact beyond what other forces can explain, mass * length/s.
    pub momentum: Extremum,
    /// Deepest overlap of two balls, length.
    pub overlap: Extremum,
    /// Farthest that a centre was beyond where the cushions let it be, length.
    pub outside: Extremum,
    /// Largest jump of a position at one time, length.
    pub displaced: Extremum,
}

/// A place in a run: when and which balls.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spot {
    /// s.
    pub time: f64,
    /// Balls concerned, indices in scene order.
    pub balls: Vec<u32>,
    /// What was found there, in one sentence.
    pub why: String,
}

/// Why a run ended. None of them is an error: the trace up to that point stands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ending {
    /// Everything came to rest.
    Rest,
    /// The scene's duration was reached.
    Duration,
    /// The user asked to stop.
    Cancelled,
    /// The limit on events was reached; the balls are those of the event that would have come next.
    Budget(Spot),
    /// An impact left a ball approaching several balls at once: the order would decide the result.
    Indeterminate(Spot),
    /// A graze or stop at rounding level: the scalar cannot tell whether it happens.
    Undecidable(Spot),
    /// Infinitely many impacts in finite time.
    Collapsed(Spot),
    /// A state stopped being a number.
    NotFinite(Spot),
}

impl Ending {
    /// Kebab-case name.
    pub fn id(&self) -> &'static str {
        match self {
            Ending::Rest => "rest",
            Ending::Duration => "duration",
            Ending::Cancelled => "cancelled",
            Ending::Budget(_) => "budget",
            Ending::Indeterminate(_) => "indeterminate",
            Ending::Undecidable(_) => "undecidable",
            Ending::Collapsed(_) => "collapsed",
            Ending::NotFinite(_) => "not-finite",
        }
    }

    /// Where it ended, for the endings that have a place.
    pub fn spot(&self) -> Option<&Spot> {
        match self {
            Ending::Budget(spot)
            | Ending::Indeterminate(spot)
            | Ending::Undecidable(spot)
            | Ending::Collapsed(spot)
            | Ending::NotFinite(spot) => Some(spot),
            Ending::Rest | Ending::Duration | Ending::Cancelled => None,
        }
    }

    /// True when the run reached the end that the scene asks for.
    pub fn is_complete(&self) -> bool {
        matches!(self, Ending::Rest | Ending::Duration)
    }
}

impl Trace {
    /// Largest speed of any ball at any knot, length/s.
    pub fn fastest(&self) -> f64 {
        self.paths.iter().map(Path::fastest).fold(0.0, worse)
    }

    /// Last state of every ball, in scene order; `None` for a pocketed ball, which is no longer on the table.
    pub fn final_states(&self) -> Vec<Option<State>> {
        let mut last: Vec<Option<State>> = self.paths.iter().map(Path::last).collect();
        for event in &self.events {
            if let EventKind::Pocket(ball, _) = event.kind
                && let Some(state) = last.get_mut(ball as usize)
            {
                *state = None;
            }
        }
        last
    }

    /// Keeps what [`Record::Final`] keeps of a fuller record: first and last states, stop times, extrema and counters.
    pub fn pare(&mut self) {
        for path in &mut self.paths {
            let (first, last) = (path.knots.first().copied(), path.knots.last().copied());
            path.knots = first.into_iter().collect();
            path.knots.extend(
                last.map(|knot| Knot {
                    after: None,
                    ..knot
                })
                .filter(|last| first.is_none_or(|first| *last != first)),
            );
        }
        self.events
            .retain(|event| matches!(event.kind, EventKind::Pocket(..)));
        self.certainty.clear();
    }

    /// How much of one kind of work was done; `None` where the engine does not count it.
    pub fn count(&self, counter: Counter) -> Option<u64> {
        self.counters.get(counter.id()).copied()
    }

    /// Number of the pocket into which ball `i` fell; `None` while it is in play.
    pub fn pocket_of(&self, i: usize) -> Option<u32> {
        self.events.iter().find_map(|event| match event.kind {
            EventKind::Pocket(ball, pocket) if ball as usize == i => Some(pocket),
            _ => None,
        })
    }

    /// True when ball `i` left play.
    pub fn pocketed(&self, i: usize) -> bool {
        self.pocket_of(i).is_some()
    }

    /// State of ball `i` at time `t`; `None` from the moment at which it left play.
    pub fn in_play_at(&self, i: usize, t: f64) -> Option<State> {
        let path = self.paths.get(i)?;
        // the cheap question first: the other one reads all events
        let left = path.knots.last().is_some_and(|last| t >= last.time) && self.pocketed(i);
        if left { None } else { path.state_at(t) }
    }

    /// The collision order: every ball-ball and ball-cushion event, in order.
    pub fn collisions(&self) -> impl Iterator<Item = &Event> {
        self.events.iter().filter(|event| event.kind.is_collision())
    }

    /// The largest motion over all balls that the knots do not explain, length: the trace's check on itself.
    pub fn unexplained(&self) -> f64 {
        self.paths.iter().map(Path::unexplained).fold(0.0, worse)
    }
}
