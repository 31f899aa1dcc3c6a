//! Two engines held against each other sample by sample: the same scene to the bit in both.

use super::{EnsembleEntry, Landing};

/// How an engine agrees with the reference over all samples that both ran to the end.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Agreement {
    /// Samples that both ran to the end.
    pub both: usize,
    /// Samples of these with the same collision order.
    pub same_collisions: usize,
    /// Samples of these with the same order of all events.
    pub same_events: usize,
    /// The largest distance of the final positions of a ball, R.
    pub apart: Option<Farthest>,
    /// The largest difference of the stop times of a ball, s.
    pub delayed: Option<Farthest>,
}

/// The largest difference of an ensemble, and whose it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Farthest {
    /// The difference.
    pub value: f64,
    /// Index of the sample.
    pub sample: usize,
    /// Index of the ball in scene order.
    pub ball: usize,
}

/// Holds `entry` against `reference`. `radius`: the scene's smallest, the unit of distances.
pub fn agreement(reference: &EnsembleEntry, entry: &EnsembleEntry, radius: f64) -> Agreement {
    let mut found = Agreement::default();
    let pairs = reference.cells.iter().zip(&entry.cells).enumerate();
    for (sample, pair) in pairs {
        let (Some(Ok(ours)), Some(Ok(theirs))) = pair else {
            continue;
        };
        if !(ours.complete && theirs.complete) {
            continue;
        }
        found.both += 1;
        found.same_collisions += usize::from(ours.collisions == theirs.collisions);
        found.same_events += usize::from(ours.events == theirs.events);
        farther(&mut found.apart, sample, distances(ours, theirs, radius));
        farther(&mut found.delayed, sample, delays(ours, theirs));
    }
    found
}

/// Distance of the final positions of each ball, R.
fn distances(ours: &Landing, theirs: &Landing, radius: f64) -> impl Iterator<Item = Option<f64>> {
    let distance = move |([a, b], [c, d]): ([f64; 2], [f64; 2])| (a - c).hypot(b - d) / radius;
    let pairs = ours.at.iter().zip(&theirs.at);
    pairs.map(move |(a, b)| a.zip(*b).map(distance))
}

/// Difference of the stop times of each ball, s.
fn delays(ours: &Landing, theirs: &Landing) -> impl Iterator<Item = Option<f64>> {
    let pairs = ours.stopped.iter().zip(&theirs.stopped);
    pairs.map(|(a, b)| a.zip(*b).map(|(a, b)| (a - b).abs()))
}

/// Raises `farthest` to the largest of the values, which are those of the balls.
fn farther(
    farthest: &mut Option<Farthest>,
    sample: usize,
    values: impl Iterator<Item = Option<f64>>,
) {
    for (ball, value) in values.enumerate() {
        let Some(value) = value else { continue };
        let known = farthest.map_or(f64::NEG_INFINITY, |known| known.value);
        // not a number is the farthest of all
        let raises = value > known || (value.is_nan() && !known.is_nan());
        if raises {
            *farthest = Some(Farthest {
                value,
                sample,
                ball,
            });
        }
    }
}
