//! A rerun gives the same bits.

use super::{Law, Reads};
use crate::physics::invariants::Invariant;
use crate::trace::Trace;
use sha2::{Digest, Sha256};
use std::fmt::Write;

/// The invariant. No bound: a bit is the same or not.
pub const LAW: Law = Law {
    invariant: Invariant::Rerun,
    unit: "",
    what: "a rerun gives the same bits of every event, final state and stop time",
    reads: Reads::Rerun,
};

/// Bytes of a digest that are kept: no two of a few hundred runs share them by chance.
const BYTES: usize = 8;

/// Hexadecimal digits of a digest.
pub const DIGITS: usize = 2 * BYTES;

/// True for what can be a digest of a run.
pub fn is_digest(text: &str) -> bool {
    let digit = |c: char| c.is_ascii_digit() || ('a'..='f').contains(&c);
    text.len() == DIGITS && text.chars().all(digit)
}

/// Equal digests mean equal bits: 64 bits of the SHA-256 digest of events, final states, stop times and end, as hexadecimal digits.
pub fn digest(trace: &Trace) -> String {
    let mut hash = Sha256::new();
    for event in &trace.events {
        let name = |ball: usize| trace.balls.get(ball).map_or("", String::as_str);
        let (a, b) = event.kind.parties(name);
        hash.update(event.time.to_bits().to_le_bytes());
        for word in [event.kind.id(), &a, &b] {
            hash.update(word);
            hash.update([0]);
        }
        hash.update(event.exchanges.unwrap_or(0).to_le_bytes());
    }
    for state in trace.final_states() {
        hash.update([u8::from(state.is_some())]);
        for vector in state.iter().flat_map(|s| [s.position, s.velocity, s.spin]) {
            for x in vector.iter() {
                hash.update(x.to_bits().to_le_bytes());
            }
        }
    }
    for time in &trace.stop_times {
        hash.update(time.unwrap_or(f64::NAN).to_bits().to_le_bytes());
    }
    hash.update(trace.end_time.to_bits().to_le_bytes());
    let bytes = hash.finalize();
    bytes.iter().take(BYTES).fold(String::new(), |mut hex, b| {
        // writing to a string cannot fail
        let _ = write!(hex, "{b:02x}");
        hex
    })
}
