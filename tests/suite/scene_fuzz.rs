//! No input makes the scene reader panic, and no scene that it accepts holds a number that is not finite.
//!
//! Damaged scenes are in `random_inputs`. Inputs come from the project's own generator with fixed seeds: a failure names the seed's index and can be repeated.

use carom::math::random::Draws;
use carom::scene::{catalogue, parse};
use carom::study::mutation::{replace_number, scene_file};

const RUNS: u64 = 10_000;

fn below(draws: &mut Draws, n: usize) -> usize {
    (draws.uniform() * n as f64) as usize
}

/// Reads `bytes`; whatever comes of it must be a finite scene that reads back, or errors that can be shown. True for a scene.
fn survives(bytes: &[u8], what: &str) -> bool {
    scene_file(bytes).unwrap_or_else(|fault| panic!("{what}: {fault:?}"))
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

#[test]
fn no_control_character_of_a_file_reaches_the_terminal() {
    let controls = (0..0xa0)
        .filter_map(char::from_u32)
        .filter(|c| c.is_control());
    let mut shown = 0;
    for c in controls.filter(|c| *c != '\n') {
        let text = format!("name = \"a{c}b\"\nduration = 1.0{c}\n\"k{c}\" = 1\n");
        let error = parse("control.toml", &text).unwrap_err().to_string();
        let passed = error.chars().find(|c| c.is_control() && *c != '\n');
        assert_eq!(passed, None, "{c:?} in {error:?}");
        shown += 1;
    }
    assert_eq!(shown, 32 + 1 + 32 - 1);
    // an id that is wrong already is named beside the balls that it overlaps
    let ball = |id: &str, x: f64| format!("[[balls]]\nid = \"{id}\"\nposition = [{x:?}, 0.0]\n");
    let text = format!(
        "name = \"a\"\nduration = 1.0\nball = {{ radius = 1.0, mass = 1.0 }}\n{}{}",
        ball("\\u0000\\u001b", 0.0),
        ball("b", 1.0)
    );
    let error = parse("control.toml", &text).unwrap_err().to_string();
    assert!(error.contains("overlap"), "{error}");
    assert!(
        !error.contains(|c: char| c.is_control() && c != '\n'),
        "{error:?}"
    );
}

#[test]
fn a_law_that_is_no_table_is_told_what_it_holds() {
    let head = "name = \"a\"\nduration = 1.0\nball = { radius = 1.0, mass = 1.0 }\n\n";
    for (text, help) in [
        (
            "[shot]\nforce = 3.0\n",
            "`ball`, `angle_deg`, `force`, `contact_time`",
        ),
        (
            "[effects.cloth]\ntranslational = 0.2\n",
            "write it as `[effects.cloth.translational]` with `mu`",
        ),
        (
            "[effects.contact]\nelastic = true\n",
            "write it as `[effects.contact.elastic]`, which takes no keys",
        ),
    ] {
        let error = parse("law.toml", &format!("{head}{text}"))
            .unwrap_err()
            .to_string();
        assert!(error.contains(help), "{error}");
    }
}
