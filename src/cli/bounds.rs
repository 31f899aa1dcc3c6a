//! Counts and times of the command line that would drive a loop or take memory without end: each is refused by the name of its flag,
//! with the largest value that is taken.

use super::Failure;
use crate::engine::{Engine, Limits, MOST_EVENTS, Setting};
use crate::scene::Scene;

/// States that a run records at a cadence, at most: some gigabytes in memory and on disk.
const MOST_STATES: f64 = 2e7;

/// Events after which a random scene of `fuzz` ends, unless told otherwise: what goes on for longer shows nothing new.
pub const FUZZ_EVENTS: u64 = 1_000;

/// Refuses `--FLAG VALUE` above `most`; `why`: what ends there.
fn at_most(flag: &str, value: u64, most: u64, why: &str) -> Result<(), Failure> {
    if value <= most {
        return Ok(());
    }
    Err(Failure::Message(format!(
        "`{flag} {value}`: expected at most {most}: {why}"
    )))
}

/// Number of events after which a run ends.
pub fn events(most: u64) -> Result<u64, Failure> {
    let why = "what belongs to an event names it by 32 bits";
    at_most("--max-events", most, MOST_EVENTS, why)?;
    Ok(most)
}

/// Number of events after which each of many runs ends.
pub fn events_of_each(most: u64) -> Result<u64, Failure> {
    let why = "no other command runs a scene for longer";
    at_most("--max-events", most, Limits::NONE.max_events, why)?;
    Ok(most)
}

/// So many indices from `first` on, asked for by `flag`.
pub fn indices(flag: &str, count: u64, first: u64) -> Result<u64, Failure> {
    let why = format!("indices from `--first {first}` on end at {}", u64::MAX - 1);
    at_most(flag, count, u64::MAX - first, &why)?;
    Ok(count)
}

/// Simulated time between two samples of a run, s.
pub fn cadence(
    every: f64,
    engine: &dyn Engine,
    scene: &Scene,
    setting: &Setting,
) -> Result<f64, Failure> {
    if !(every > 0.0 && every.is_finite()) {
        return Err(Failure::Message(format!(
            "`--every {every}`: expected a time above 0 s"
        )));
    }
    // what cannot be asked for its step is refused with words of its own
    let step = engine.pace(scene, setting).map_or(0.0, |pace| pace.step);
    let balls = scene.balls.len() as f64;
    let states = scene.duration / every.max(step) * balls;
    // an engine that solves for its events adds no samples, and a step no more than one
    if step == 0.0 || states <= MOST_STATES {
        return Ok(every);
    }
    Err(Failure::Message(format!(
        "`--every {every}`: up to {states:.1e} states would be recorded, more than {MOST_STATES:.0e}; expected at least {:.1e} s",
        // rounded up, so that what is named is taken
        1.05 * scene.duration * balls / MOST_STATES
    )))
}

/// A number that a study refused, by the flag that gave it.
pub fn refused(flag: &str, error: &impl std::fmt::Display) -> Failure {
    Failure::Message(format!("`{flag}`: {error}"))
}
