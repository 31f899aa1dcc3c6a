//! Balls while they are being resolved, each with the place in the file that it comes from; and words that stand twice.

use super::Ball;
use std::collections::HashMap;

/// A ball and the place in the file that it comes from.
pub(super) struct Placed {
    pub ball: Ball,
    /// Path of what gives its position: `balls[0].position` or `rack`.
    pub path: String,
}

/// For each word that occurs more than once: the index of its first occurrence and that of each repetition.
pub(super) fn repetitions<'a>(words: impl Iterator<Item = &'a str>) -> Vec<(usize, usize)> {
    let mut first: HashMap<&str, usize> = HashMap::new();
    let mut repeated = Vec::new();
    for (i, word) in words.enumerate() {
        let earliest = *first.entry(word).or_insert(i);
        if earliest != i {
            repeated.push((earliest, i));
        }
    }
    repeated
}
