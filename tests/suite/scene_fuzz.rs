//! No input makes the scene reader panic, and no scene that it accepts holds a number that is not finite.
//!
//! Inputs come from the project's own generator with fixed seeds: a failure names the seed's index and can be repeated.

use carom::math::random::Draws;
use carom::scene::{Scene, SceneError, catalogue, parse, parse_bytes};

const RUNS: u64 = 10_000;

/// Words that reach deep into the format, and numbers at the edges of f64.
const WORDS: &[&str] = &[
    "nan",
    "-inf",
    "1e308",
    "-1e308",
    "1e-320",
    "1e400",
    "1e30",
    "-1e30",
    "1e-30",
    "0",
    "-0.0",
    "-1",
    "1e20",
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
    "#",
    "\n",
    "\r\n",
    "\t",
    "\u{0}",
    "\u{e9}",
    "\u{1f3b1}",
    "true",
    "\"cue\"",
    "1979-05-27",
    "[rack]\n",
    "[[balls]]\n",
    "[ball]\n",
    "[effects.pockets]\n",
    "[shot.velocity]\n",
    "name = ",
    "radius = ",
    "position = [1.0, 2.0]\n",
    "jitter = ",
    "seed = 1\n",
    "gap = ",
    "rows = 5\n",
    "\\",
    "\\u0000",
    "_",
    "e",
    "+",
];

fn below(draws: &mut Draws, n: usize) -> usize {
    (draws.uniform() * n as f64) as usize
}

/// Holds everything that engines calculate with, and its square, to be finite.
fn assert_finite(scene: &Scene, what: &str) {
    let mut numbers = vec![
        scene.duration,
        scene.gravity,
        scene.touching(),
        scene.initial_energy(),
        scene.largest_speed() * scene.duration,
    ];
    for ball in &scene.balls {
        let state = &ball.state;
        numbers.extend([
            ball.radius,
            ball.mass,
            ball.mass.recip(),
            ball.radius.recip(),
        ]);
        numbers.extend(
            state
                .position
                .iter()
                .chain(&state.velocity)
                .chain(&state.spin),
        );
    }
    if let Some(table) = scene.table {
        numbers.extend(table.min.iter().chain(&table.max));
    }
    scene.effects.map(|_, number| numbers.push(number));
    for x in numbers {
        assert!((x * x).is_finite(), "{what}: {x:e} in {scene:?}");
    }
    assert!(!scene.balls.is_empty(), "{what}: no ball");
    assert!(
        scene.balls.iter().all(|b| b.radius > 0.0 && b.mass > 0.0),
        "{what}: {scene:?}"
    );
}

/// Reads `bytes`; whatever comes of it must be a finite scene or errors that can be shown. True for a scene.
fn survives(bytes: &[u8], what: &str) -> bool {
    match parse_bytes("fuzz.toml", bytes) {
        Ok(scene) => {
            assert_finite(&scene, what);
            true
        }
        Err(SceneError::Invalid(found)) => {
            assert!(
                !found.problems.is_empty(),
                "{what}: an error without a cause"
            );
            assert!(
                !found.to_string().is_empty() && !found.render(true).is_empty(),
                "{what}"
            );
            false
        }
        Err(other) => panic!("{what}: {other}"),
    }
}

#[test]
fn random_bytes_never_panic() {
    for index in 0..RUNS {
        let mut draws = Draws::new(2, index);
        let length = below(&mut draws, 200);
        // every third input from the characters that TOML is made of, which come further
        let alphabet = b"abe=.[]{}\"'#,\n\r \t0123456789-+_\\";
        let byte = |draws: &mut Draws| match index % 3 {
            0 => alphabet[below(draws, alphabet.len())],
            _ => draws.bits() as u8,
        };
        let bytes: Vec<u8> = (0..length).map(|_| byte(&mut draws)).collect();
        assert!(
            !survives(&bytes, &format!("random bytes {index}")),
            "noise was a scene"
        );
    }
}

#[test]
fn mutated_scenes_never_panic_and_never_hold_a_number_that_is_not_finite() {
    let mut scenes = 0;
    for index in 0..RUNS {
        let mut draws = Draws::new(3, index);
        let entries = catalogue::all();
        let mut bytes = entries[below(&mut draws, entries.len())]
            .text
            .as_bytes()
            .to_vec();
        for _ in 0..=below(&mut draws, 4) {
            mutate(&mut bytes, &mut draws);
        }
        scenes += u64::from(survives(&bytes, &format!("mutated scene {index}")));
    }
    // both ends must be reached, or the test sees only one of them
    assert!(
        scenes > RUNS / 100 && scenes < RUNS * 99 / 100,
        "{scenes} of {RUNS} were scenes"
    );
}

fn mutate(bytes: &mut Vec<u8>, draws: &mut Draws) {
    let at = below(draws, bytes.len());
    let end = (at + below(draws, 12)).min(bytes.len());
    let word = WORDS[below(draws, WORDS.len())].bytes();
    match below(draws, 6) {
        0 => bytes[at] = draws.bits() as u8,
        1 => drop(bytes.drain(at..end)),
        2 => drop(bytes.splice(at..at, word)),
        3 => replace_number(bytes, at, word.collect()),
        4 => {
            let piece = bytes[at..end].to_vec();
            let to = below(draws, bytes.len());
            bytes.splice(to..to, piece);
        }
        _ => swap_lines(bytes, draws),
    }
    if bytes.is_empty() {
        bytes.push(b'\n');
    }
}

/// Puts `word` in the place of the first number after `at`.
fn replace_number(bytes: &mut Vec<u8>, at: usize, word: Vec<u8>) {
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

fn swap_lines(bytes: &mut Vec<u8>, draws: &mut Draws) {
    let mut lines: Vec<Vec<u8>> = bytes.split(|b| *b == b'\n').map(<[u8]>::to_vec).collect();
    let (a, b) = (below(draws, lines.len()), below(draws, lines.len()));
    lines.swap(a, b);
    *bytes = lines.join(&b'\n');
}

#[test]
fn every_number_replaced_by_every_edge_of_f64_is_answered() {
    let edges = [
        "nan", "inf", "-inf", "1e308", "-1e308", "1e-320", "1e400", "1e30", "-1e30", "1e-30",
        "0.0", "-1.0",
    ];
    let mut cases = 0;
    for entry in catalogue::all() {
        let bytes = entry.text.as_bytes();
        let starts =
            (1..bytes.len()).filter(|&i| bytes[i].is_ascii_digit() && bytes[i - 1] == b' ');
        for start in starts {
            for edge in edges {
                let mut changed = bytes.to_vec();
                replace_number(&mut changed, start, edge.into());
                survives(&changed, &format!("{} with {edge} at {start}", entry.name));
                cases += 1;
            }
        }
    }
    assert!(cases > 1000, "only {cases} numbers were found");
}

#[test]
fn deep_nesting_does_not_overflow_the_stack() {
    let n = 100_000;
    let deep = [
        ("lists", format!("a = {}", "[".repeat(n))),
        (
            "closed lists",
            format!("a = {}{}", "[".repeat(n), "]".repeat(n)),
        ),
        ("tables", format!("a = {}", "{a = ".repeat(n))),
        ("dotted keys", format!("{}a = 1", "a.".repeat(n))),
        ("headers", format!("[{}a]", "a.".repeat(n))),
        ("lists of tables", format!("[[{}a]]", "a.".repeat(n))),
        ("effects", format!("[effects.{}a]", "cloth.".repeat(n))),
        (
            "lists at the limit",
            format!("try = {}{}", "[".repeat(79), "]".repeat(79)),
        ),
        (
            "tables within lists at the limit",
            format!("balls = {}", "[{id = ".repeat(39)),
        ),
    ];
    for (what, text) in deep {
        assert!(
            parse("deep.toml", &text).is_err(),
            "{what} were read as a scene"
        );
        survives(text.as_bytes(), what);
    }
}

#[test]
fn a_long_file_full_of_errors_is_answered_with_the_first_of_them() {
    let ball = "[[balls]]\nid = \"c\"\nposition = [0.0, 0.0]\n";
    let head = "name = \"a\"\nduration = 1.0\nball = { radius = 1.0, mass = 1.0 }\n";
    let text = format!("{head}{}", ball.repeat(5_000));
    let error = parse("long.toml", &text).unwrap_err().to_string();
    assert!(
        error.lines().count() < 300,
        "{} lines",
        error.lines().count()
    );
    assert!(error.ends_with("more errors"), "{error}");
}
