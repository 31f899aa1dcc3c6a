//! Small damage to a text, drawn from a seed: bytes, pieces, words and lines changed, lost, doubled and moved.

use crate::math::random::Draws;

/// Words that reach deep into the formats, and numbers at the edges of f64.
const WORDS: &[&str] = &[
    "nan",
    "-inf",
    "inf",
    "1e308",
    "-1e308",
    "1e-320",
    "1e400",
    "1e999",
    "1e30",
    "-1e30",
    "1e31",
    "1e-30",
    "1e-31",
    "0",
    "-0.0",
    "-1",
    "1e20",
    "4294967295",
    "4294967296",
    "9223372036854775807",
    "99999999999999999999",
    "0x10",
    "\"",
    "'''",
    "[",
    "]",
    "{",
    "}",
    "[[",
    "]]",
    "=",
    ".",
    ",",
    ":",
    "#",
    "\n",
    "\r\n",
    "\t",
    "\u{0}",
    "\u{e9}",
    "\u{feff}",
    "\u{1f3b1}",
    "true",
    "null",
    "\"cue\"",
    "cue",
    "1979-05-27",
    "[rack]\n",
    "[[balls]]\n",
    "[ball]\n",
    "[table]\n",
    "[effects.pockets]\n",
    "[effects.cloth.rotational]\n",
    "[shot.velocity]\n",
    "[shot.strike]\n",
    "name = ",
    "radius = ",
    "mass = ",
    "position = [1.0, 2.0]\n",
    "spin = [0.0, 0.0, 1.0]\n",
    "jitter = ",
    "seed = 1\n",
    "gap = ",
    "rows = 5\n",
    "gravity = 9.81\n",
    "origin = [1e8, 0.0]\n",
    "\\",
    "\\u0000",
    "_",
    "e",
    "+",
    "ball-ball",
    "ball-cushion",
    "pocket",
    "p0",
    "x1",
    "stop",
    "spin-end",
    "rest",
    "\"spot\": null",
    "",
];

/// A whole number below `n`.
pub(super) fn below(draws: &mut Draws, n: usize) -> usize {
    (draws.uniform() * n as f64) as usize
}

/// Damages a text once. `names`: words that mean something to its reader, besides those of every format.
pub fn mutate(bytes: &mut Vec<u8>, draws: &mut Draws, names: &[String]) {
    if bytes.is_empty() {
        bytes.push(b'\n');
    }
    let at = below(draws, bytes.len());
    let end = (at + below(draws, 12)).min(bytes.len());
    let drawn = below(draws, WORDS.len() + names.len());
    let word = match WORDS.get(drawn) {
        Some(word) => word.as_bytes(),
        None => names[drawn - WORDS.len()].as_bytes(),
    };
    match below(draws, 8) {
        0 => bytes[at] = draws.bits() as u8,
        1 => drop(bytes.drain(at..end)),
        2 => drop(bytes.splice(at..at, word.iter().copied())),
        3 | 4 => replace_number(bytes, at, word.to_vec()),
        5 => {
            let piece = bytes[at..end].to_vec();
            let to = below(draws, bytes.len());
            bytes.splice(to..to, piece);
        }
        6 => double_line(bytes, draws),
        _ => swap_lines(bytes, draws),
    }
}

/// Puts `word` in the place of the first number after `at`.
pub fn replace_number(bytes: &mut Vec<u8>, at: usize, word: Vec<u8>) {
    let in_number = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'e');
    if let Some(start) = bytes[at..].iter().position(u8::is_ascii_digit) {
        let start = at + start;
        let length = bytes[start..]
            .iter()
            .take_while(|byte| in_number(byte))
            .count();
        bytes.splice(start..start + length, word);
    }
}

fn lines(bytes: &[u8]) -> Vec<Vec<u8>> {
    bytes.split(|b| *b == b'\n').map(<[u8]>::to_vec).collect()
}

fn double_line(bytes: &mut Vec<u8>, draws: &mut Draws) {
    let mut lines = lines(bytes);
    let (from, to) = (below(draws, lines.len()), below(draws, lines.len()));
    lines.insert(to, lines[from].clone());
    *bytes = lines.join(&b'\n');
}

fn swap_lines(bytes: &mut Vec<u8>, draws: &mut Draws) {
    let mut lines = lines(bytes);
    let (a, b) = (below(draws, lines.len()), below(draws, lines.len()));
    lines.swap(a, b);
    *bytes = lines.join(&b'\n');
}
