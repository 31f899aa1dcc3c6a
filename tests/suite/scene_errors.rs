//! What a wrong scene file is answered with: kind, position and text of every error that the format can have.
//!
//! One scene that is right, and one change a case that makes it wrong. Positions are asserted here; texts are held byte for
//! byte in `snapshots/suite__scene_errors__texts.snap`.

use carom::physics::{EFFECTS, EffectEntry, Friction};
use carom::scene::{Diagnostics, Kind, SceneError, parse, parse_bytes};
use std::collections::BTreeSet;

/// A scene without fault, on which every case works a change.
const RIGHT: &str = r#"name = "shot"
duration = 5.0
gravity = 9.81
[table]
width = 10.0
length = 20.0
[ball]
radius = 0.25
mass = 0.107
[[balls]]
id = "cue"
position = [5.0, 5.0]
[shot.velocity]
ball = "cue"
speed = 2.0
angle_deg = 90.0
[effects.cloth.translational]
mu = 0.2
[effects.cushion.elastic]
"#;

/// The last lines of [`RIGHT`].
const LAWS: &str = "[effects.cloth.translational]\nmu = 0.2\n[effects.cushion.elastic]\n";

struct Case {
    kind: Kind,
    what: &'static str,
    from: &'static str,
    to: &'static str,
    position: (usize, usize),
}

const fn case(
    kind: Kind,
    what: &'static str,
    from: &'static str,
    to: &'static str,
    position: (usize, usize),
) -> Case {
    Case {
        kind,
        what,
        from,
        to,
        position,
    }
}

/// Kind, what is wrong, the words of the right scene that are changed, the change, line and column of the error.
#[rustfmt::skip]
const CASES: &[Case] = &[
    case(Kind::Syntax, "a value that is not TOML", "speed = 2.0", "speed = fast", (15, 9)),
    case(Kind::Syntax, "a missing value", "mass = 0.107", "mass =", (9, 7)),
    case(Kind::Duplicate, "a key given twice", "mass = 0.107", "mass = 0.107\nmass = 0.2", (10, 1)),
    case(Kind::Duplicate, "a table given twice", "[effects.cushion.elastic]", "[effects.cushion.elastic]\n[ball]", (20, 2)),
    case(Kind::UnknownKey, "a key with a typing error", "radius = 0.25", "raduis = 0.25\nradius = 0.25", (8, 1)),
    case(Kind::UnknownKey, "a key like no other", "radius = 0.25", "radius = 0.25\ncolour = 3", (9, 1)),
    case(Kind::UnknownKey, "a key that slipped below a header", "mass = 0.107", "mass = 0.107\nrun_to_duration = true", (10, 1)),
    case(Kind::UnknownKey, "a law that does not exist", "[effects.cushion.elastic]", "[effects.cushion.rubber]", (19, 18)),
    case(Kind::UnknownKey, "a number given to a law that has none", "[effects.cushion.elastic]", "[effects.cushion.elastic]\ne = 0.9", (20, 1)),
    case(Kind::WrongType, "text for a number", "duration = 5.0", "duration = \"5 s\"", (2, 12)),
    case(Kind::WrongType, "another unit of time", "duration = 5.0", "duration = 5.0\nunits = { time = \"ms\" }", (3, 18)),
    case(Kind::WrongType, "a number for text", "id = \"cue\"", "id = 7", (11, 6)),
    case(Kind::WrongType, "three coordinates", "position = [5.0, 5.0]", "position = [5.0, 5.0, 0.25]", (12, 12)),
    case(Kind::WrongType, "text for a coordinate", "position = [5.0, 5.0]", "position = [5.0, \"five\"]", (12, 18)),
    case(Kind::WrongType, "a number for a table", "[table]\nwidth = 10.0\nlength = 20.0\n", "table = 10.0\n", (4, 9)),
    case(Kind::WrongType, "a table for a list of tables", "[[balls]]", "[balls]", (10, 1)),
    case(Kind::WrongType, "a fraction for a whole number", "[shot.velocity]", "[rack]\napex = [5.0, 15.0]\nrows = 2.5\ngap = 0.0\n[shot.velocity]", (15, 8)),
    case(Kind::WrongType, "a set that does not exist", "duration = 5.0", "sets = [\"reports\"]\nduration = 5.0", (2, 9)),
    case(Kind::WrongType, "a word for a truth value", "duration = 5.0", "run_to_duration = \"yes\"\nduration = 5.0", (2, 19)),
    case(Kind::NotFinite, "NaN", "mu = 0.2", "mu = nan", (18, 6)),
    case(Kind::NotFinite, "an infinity", "speed = 2.0", "speed = inf", (15, 9)),
    case(Kind::NotFinite, "an infinite coordinate", "position = [5.0, 5.0]", "position = [5.0, -inf]", (12, 18)),
    case(Kind::OutOfRange, "friction below zero", "mu = 0.2", "mu = -0.2", (18, 6)),
    case(Kind::OutOfRange, "a negative mass", "mass = 0.107", "mass = -0.107", (9, 8)),
    case(Kind::OutOfRange, "a radius of zero", "radius = 0.25", "radius = 0", (8, 10)),
    case(Kind::OutOfRange, "no duration", "duration = 5.0", "duration = 0.0", (2, 12)),
    case(Kind::OutOfRange, "negative gravity", "gravity = 9.81", "gravity = -9.81", (3, 11)),
    case(Kind::OutOfRange, "a table without width", "width = 10.0", "width = 0.0", (5, 9)),
    case(Kind::OutOfRange, "a table of negative length", "length = 20.0", "length = -20.0", (6, 10)),
    case(Kind::OutOfRange, "a negative speed", "speed = 2.0", "speed = -2.0", (15, 9)),
    case(Kind::OutOfRange, "an angle beyond a turn", "angle_deg = 90.0", "angle_deg = 1e6", (16, 13)),
    case(Kind::OutOfRange, "a negative gap", "[shot.velocity]", "[rack]\napex = [5.0, 15.0]\nrows = 2\ngap = -0.1\n[shot.velocity]", (16, 7)),
    case(Kind::OutOfRange, "too many rows", "[shot.velocity]", "[rack]\napex = [5.0, 15.0]\nrows = 6\ngap = 0.0\n[shot.velocity]", (15, 8)),
    case(Kind::OutOfRange, "a number whose square overflows", "speed = 2.0", "speed = 1e200", (15, 9)),
    case(Kind::OutOfRange, "a number larger than f64", "mass = 0.107", "mass = 1e999", (9, 8)),
    case(Kind::OutOfRange, "a number whose square vanishes", "radius = 0.25", "radius = 1e-200", (8, 10)),
    case(Kind::OutOfRange, "an integer beyond 64 bits", "mass = 0.107", "mass = 100000000000000000000", (9, 8)),
    case(Kind::OutOfRange, "coordinates that f64 cannot resolve", "[table]", "[table]\norigin = [1e9, 0.0]", (4, 1)),
    case(Kind::Missing, "a name", "name = \"shot\"\n", "", (1, 1)),
    case(Kind::Missing, "a duration", "duration = 5.0\n", "", (1, 1)),
    case(Kind::Missing, "a key of a law", "mu = 0.2\n", "", (17, 1)),
    case(Kind::Missing, "gravity for the cloth", "gravity = 9.81\n", "", (16, 1)),
    case(Kind::Missing, "a table for the cushions", "[table]\nwidth = 10.0\nlength = 20.0\n", "", (16, 10)),
    case(Kind::Missing, "a radius", "radius = 0.25\n", "", (9, 1)),
    case(Kind::Missing, "a seed for the jitter", "[shot.velocity]", "[rack]\napex = [5.0, 15.0]\nrows = 2\ngap = 0.1\njitter = 0.01\n[shot.velocity]", (17, 10)),
    case(Kind::Missing, "a law", "[effects.cushion.elastic]", "[effects.cushion]", (19, 1)),
    case(Kind::Missing, "a ball", "[[balls]]\nid = \"cue\"\nposition = [5.0, 5.0]\n[shot.velocity]\nball = \"cue\"\nspeed = 2.0\nangle_deg = 90.0\n", "", (1, 1)),
    case(Kind::Overlap, "two balls", "[shot.velocity]", "[[balls]]\nid = \"1\"\nposition = [5.25, 5.0]\n[shot.velocity]", (15, 12)),
    case(Kind::Overlap, "a ball and the rack", "[shot.velocity]", "[rack]\napex = [5.0, 5.25]\nrows = 2\ngap = 0.0\n[shot.velocity]", (12, 12)),
    case(Kind::Overlap, "unequal balls, which touch at 2 sqrt(R1 R2)", "[shot.velocity]", "[[balls]]\nid = \"1\"\nposition = [5.0, 6.0]\nradius = 1.0001\n[shot.velocity]", (15, 12)),
    case(Kind::Outside, "a ball", "position = [5.0, 5.0]", "position = [9.8, 5.0]", (12, 12)),
    case(Kind::Outside, "a rack", "[shot.velocity]", "[rack]\napex = [5.0, 19.5]\nrows = 2\ngap = 0.0\n[shot.velocity]", (13, 1)),
    case(Kind::TwoLaws, "two cushions", "[effects.cushion.elastic]", "[effects.cushion.elastic]\n[effects.cushion.han-2005]", (20, 18)),
    case(Kind::TwoLaws, "two shots", "[effects.cloth.translational]", "[shot.force]\nball = \"cue\"\nforce = 1.0\ncontact_time = 0.1\nangle_deg = 90.0\n[effects.cloth.translational]", (17, 7)),
    case(Kind::TwoLaws, "a velocity and a shot", "position = [5.0, 5.0]", "position = [5.0, 5.0]\nvelocity = [0.0, 1.0]", (14, 7)),
    case(Kind::Duplicate, "an id", "[shot.velocity]", "[[balls]]\nid = \"cue\"\nposition = [7.0, 7.0]\n[shot.velocity]", (14, 6)),
    case(Kind::Duplicate, "an id of the rack", "[shot.velocity]", "[[balls]]\nid = \"2\"\nposition = [7.0, 7.0]\n[rack]\napex = [5.0, 15.0]\nrows = 2\ngap = 0.0\n[shot.velocity]", (14, 6)),
    case(Kind::Duplicate, "a set", "duration = 5.0", "sets = [\"gate\", \"report\", \"gate\"]\nduration = 5.0", (2, 27)),
    case(Kind::WrongType, "a convention for touching balls that nobody knows", "duration = 5.0", "simultaneous = \"generalised-reflections\"\nduration = 5.0", (2, 16)),
    case(Kind::BadName, "a scene", "name = \"shot\"", "name = \"My first shot!\"", (1, 8)),
    case(Kind::BadName, "a richer scene", "duration = 5.0", "richer = \"rolling_ball\"\nduration = 5.0", (2, 10)),
    case(Kind::BadName, "a richer scene that is itself", "duration = 5.0", "richer = \"shot\"\nduration = 5.0", (2, 10)),
    case(Kind::Duplicate, "a key of a setting", "duration = 5.0", "try = [\"stepper dt=0.1\", \"stepper dt=0.1 dt=0.2\"]\nduration = 5.0", (2, 26)),
    case(Kind::BadName, "a setting", "duration = 5.0", "try = [\"stepper dt=0.1\", \"dt=0.1\"]\nduration = 5.0", (2, 26)),
    case(Kind::BadName, "a ball called like a cushion", "[shot.velocity]", "[[balls]]\nid = \"x0\"\nposition = [7.0, 7.0]\n[shot.velocity]", (14, 6)),
    case(Kind::BadName, "a ball called like a pocket", "[shot.velocity]", "[[balls]]\nid = \"p12\"\nposition = [7.0, 7.0]\n[shot.velocity]", (14, 6)),
    case(Kind::BadName, "a ball with a comma", "[shot.velocity]", "[[balls]]\nid = \"a,b\"\nposition = [7.0, 7.0]\n[shot.velocity]", (14, 6)),
    case(Kind::BadName, "a ball without a name", "[shot.velocity]", "[[balls]]\nid = \"\"\nposition = [7.0, 7.0]\n[shot.velocity]", (14, 6)),
    case(Kind::UnknownBall, "a typing error in the shot", "ball = \"cue\"", "ball = \"ceu\"", (14, 8)),
    case(Kind::UnknownBall, "a ball that is not there", "ball = \"cue\"", "ball = \"eight\"", (14, 8)),
    case(Kind::NoEffect, "spin where nothing turns", "position = [5.0, 5.0]", "position = [5.0, 5.0]\nspin = [0.0, 0.0, 10.0]", (13, 8)),
    case(Kind::Missing, "a contact for the friction", "[effects.cloth.translational]\nmu = 0.2\n[effects.cushion.elastic]", "[effects.friction.constant]\nmu = 0.06", (17, 1)),
    case(Kind::Missing, "metres for constants in metres", "[effects.cloth.translational]\nmu = 0.2\n[effects.cushion.elastic]", "[effects.contact.elastic]\n[effects.friction.alciatore]\na = 0.01\nb = 0.1\nc = 1.1", (18, 1)),
    case(Kind::Missing, "a pocket", "[effects.cushion.elastic]", "[effects.pockets]\ncircles = []", (20, 11)),
    case(Kind::Missing, "the mass of a cue", "[shot.velocity]", "[shot.strike]", (13, 1)),
    case(Kind::Incompatible, "friction between balls on a cloth without rotation", "[effects.cushion.elastic]", "[effects.contact.elastic]\n[effects.friction.constant]\nmu = 0.06", (20, 1)),
    case(Kind::Incompatible, "a nose above a cloth without rotation", "[effects.cushion.elastic]", "[effects.cushion.han-2005]\ne = 0.85\nmu = 0.2\nheight = 1.28", (19, 1)),
    case(Kind::Incompatible, "Mathavan's cushion on a cloth without rotation", "[effects.cushion.elastic]", "[effects.cushion.mathavan-2010]\ne = 0.98\nmu = 0.14\nmu_cloth = 0.212\nheight = 1.28", (19, 1)),
    case(Kind::OutOfRange, "a restitution above 1", "[effects.cushion.elastic]", "[effects.cushion.restitution]\ne = 1.1", (20, 5)),
    case(Kind::OutOfRange, "a restitution of balls below 0", "[effects.cushion.elastic]", "[effects.contact.inelastic]\ne = -0.1", (20, 5)),
    case(Kind::OutOfRange, "a nose as high as the ball", "[effects.cushion.elastic]", "[effects.cushion.han-2005]\ne = 0.85\nmu = 0.2\nheight = 2.0", (22, 10)),
    case(Kind::OutOfRange, "a nose on the cloth", "[effects.cushion.elastic]", "[effects.cushion.mathavan-2010]\ne = 0.98\nmu = 0.14\nmu_cloth = 0.212\nheight = 0.0", (23, 10)),
    case(Kind::OutOfRange, "more friction than the cushion's law is made for", "[effects.cushion.elastic]", "[effects.cushion.mathavan-2010]\ne = 0.98\nmu = 1.5\nmu_cloth = 0.212\nheight = 1.28", (21, 6)),
    case(Kind::OutOfRange, "rolling resistance below 0", "[effects.cloth.translational]\nmu = 0.2", "[effects.cloth.rotational]\nmu_slide = 0.2\nmu_roll = -0.01\nmu_spin = 0.01", (19, 11)),
    case(Kind::OutOfRange, "a pocket without a radius", "[effects.cushion.elastic]", "[effects.pockets]\ncircles = [[0.0, 0.0, 0.6], [10.0, 0.0, 0.0]]", (20, 41)),
    case(Kind::OutOfRange, "a tip that does not meet the ball", "[shot.velocity]", "[shot.strike]\ncue_mass = 0.5\nside = -0.7\ntop = 0.8", (16, 7)),
    case(Kind::OutOfRange, "a cue from below", "[shot.velocity]", "[shot.strike]\ncue_mass = 0.5\nelevation_deg = -5.0", (15, 17)),
    case(Kind::OutOfRange, "a strike without a cue", "[shot.velocity]", "[shot.strike]\ncue_mass = 0.0", (14, 12)),
    case(Kind::WrongType, "a pocket without a radius", "[effects.cushion.elastic]", "[effects.pockets]\ncircles = [[0.0, 0.0]]", (20, 12)),
    case(Kind::Overlap, "a ball and a pocket", "[effects.cushion.elastic]", "[effects.pockets]\ncircles = [[0.0, 0.0, 0.6], [5.0, 5.3, 0.4]]", (12, 12)),
    case(Kind::TwoLaws, "a spin and a strike", "position = [5.0, 5.0]\n[shot.velocity]", "position = [5.0, 5.0]\nspin = [0.0, 0.0, 3.0]\n[shot.strike]\ncue_mass = 0.5", (14, 7)),
    case(Kind::NoEffect, "a strike where nothing turns", "[shot.velocity]", "[shot.strike]\ncue_mass = 0.5", (13, 7)),
];

/// The errors of `text`; a scene without any fails the test.
fn errors(what: &str, text: &str) -> Diagnostics {
    match parse("scenes/mine.toml", text) {
        Err(SceneError::Invalid(diagnostics)) => diagnostics,
        other => panic!("{what}: expected errors, got {other:?}"),
    }
}

fn kinds(found: &Diagnostics) -> Vec<Kind> {
    found.problems.iter().map(|problem| problem.kind).collect()
}

fn changed(case: &Case) -> String {
    let places = RIGHT.matches(case.from).count();
    assert_eq!(places, 1, "{}: ambiguous change", case.what);
    RIGHT.replace(case.from, case.to)
}

#[test]
fn the_scene_that_every_case_changes_is_right() {
    let scene = parse("scenes/mine.toml", RIGHT).unwrap();
    assert_eq!(scene.balls.len(), 1);
}

#[test]
fn every_error_has_its_kind_and_its_position() {
    for case in CASES {
        let found = errors(case.what, &changed(case));
        let of_kind = found.problems.iter().find(|p| p.kind == case.kind);
        let kinds = kinds(&found);
        let problem = of_kind.unwrap_or_else(|| panic!("{}: got {kinds:?}", case.what));
        let (line, column) = found.position(problem.span.start);
        assert_eq!(
            (line, column),
            case.position,
            "{:?}: {}",
            case.kind,
            case.what
        );
        let (arrow, text) = (
            format!("--> scenes/mine.toml:{line}:{column}\n"),
            found.to_string(),
        );
        assert!(
            text.contains(&arrow),
            "{}: no {arrow} in\n{text}",
            case.what
        );
    }
}

#[test]
fn every_kind_of_error_has_a_case() {
    let seen: BTreeSet<Kind> = CASES.iter().map(|case| case.kind).collect();
    // Kind::Encoding cannot be written as a change of text; it has a test of its own
    let all = [
        Kind::Syntax,
        Kind::UnknownKey,
        Kind::WrongType,
        Kind::NotFinite,
        Kind::OutOfRange,
        Kind::Missing,
        Kind::Overlap,
        Kind::Outside,
        Kind::TwoLaws,
        Kind::Duplicate,
        Kind::Incompatible,
        Kind::BadName,
        Kind::UnknownBall,
        Kind::NoEffect,
    ];
    assert_eq!(seen, all.into_iter().collect());
}

#[test]
fn every_error_says_what_is_wrong_and_what_would_be_right() {
    let mut texts = String::new();
    for case in CASES {
        let found = errors(case.what, &changed(case));
        for problem in &found.problems {
            assert!(!problem.message.is_empty(), "{}: no message", case.what);
            assert!(!problem.help.is_empty(), "{}: no help", case.what);
        }
        texts += &format!("{:?}: {}\n\n{found}\n\n\n", case.kind, case.what);
    }
    insta::assert_snapshot!("texts", texts);
}

#[test]
fn an_error_looks_as_it_was_designed() {
    let thirteen_lines = "\n".repeat(13);
    let text = thirteen_lines + &RIGHT.replace("mu = 0.2", "mu = -0.2");
    let designed = "\
error: mu must be a finite number, 0 or greater
  --> scenes/mine.toml:31:6
   |
31 | mu = -0.2
   |      ^^^^ here
   = help: sliding cloth is typically 0.2";
    assert_eq!(errors("design", &text).to_string(), designed);
}

#[test]
fn all_errors_of_a_stage_are_reported_at_once_in_the_order_of_the_text() {
    let shape = RIGHT
        .replace("radius = 0.25", "raduis = 0.25")
        .replace("mu = 0.2", "mu = nan")
        .replace("width = 10.0", "width = \"wide\"")
        .replace("speed = 2.0\n", "");
    let expected = [
        Kind::WrongType,
        Kind::UnknownKey,
        Kind::Missing,
        Kind::NotFinite,
    ];
    assert_eq!(kinds(&errors("shape", &shape)), expected);
    let meaning = RIGHT
        .replace("\"shot\"", "\"Shot\"")
        .replace("gravity = 9.81\n", "")
        .replace("[5.0, 5.0]", "[15.0, 5.0]\nspin = [1.0, 0.0, 0.0]")
        .replace("ball = \"cue\"", "ball = \"8\"");
    let expected = [
        Kind::BadName,
        Kind::Outside,
        Kind::NoEffect,
        Kind::UnknownBall,
        Kind::Missing,
    ];
    assert_eq!(kinds(&errors("meaning", &meaning)), expected);
}

#[test]
fn columns_count_characters_and_neither_line_ends_nor_a_byte_order_mark_move_them() {
    // before the 3 stand `units = { length = "` (20), two letters of two and three bytes, and `", mass = ` (10)
    let text = format!("units = {{ length = \"\u{e9}\u{65e5}\", mass = 3 }}\n{RIGHT}");
    let texts = [
        ("LF", text.clone()),
        ("CRLF", text.replace('\n', "\r\n")),
        ("byte order mark", format!("\u{feff}{text}")),
    ];
    for (how, text) in texts {
        let found = errors(how, &text);
        assert_eq!(
            found.position(found.problems[0].span.start),
            (1, 33),
            "{how}"
        );
        let shown = found.to_string();
        assert!(shown.contains("scenes/mine.toml:1:33\n"), "{how}: {shown}");
        assert!(!shown.contains('\r'), "{how}: {shown:?}");
    }
}

#[test]
fn bytes_that_are_not_utf8_are_an_error_with_a_position() {
    let mut bytes = RIGHT.as_bytes().to_vec();
    bytes[RIGHT.find("cue").unwrap()] = 0xff;
    let Err(SceneError::Invalid(found)) = parse_bytes("scenes/mine.toml", &bytes) else {
        panic!("bytes that are not UTF-8 were read as a scene");
    };
    assert_eq!(kinds(&found), [Kind::Encoding]);
    let expected = "\
error: the file is not UTF-8 text: byte 0xff
  --> scenes/mine.toml:11:7
   |
11 | id = \"\u{fffd}ue\"
   |       ^ here
   = help: save it as UTF-8";
    assert_eq!(found.to_string(), expected);
}

#[test]
fn a_file_cannot_command_the_terminal() {
    let text = RIGHT.replace("mass = 0.107", "mass = 0.107\n\"\\u001b[2J\\u0007\" = 1");
    let shown = errors("escape sequences", &text).to_string();
    assert!(shown.contains("`\\u{1b}[2J\\u{7}`"), "{shown}");
    assert!(!shown.contains(['\u{1b}', '\u{7}']), "{shown:?}");
}

/// The tables of one effect, and of what it needs.
fn tables_of(effect: &EffectEntry) -> String {
    let numbers = effect.numbers.iter().map(|number| match *number {
        "circles" => "circles = [[0.0, 0.0, 0.5]]\n".to_owned(),
        number => format!("{number} = 0.5\n"),
    });
    let own = format!("[effects.{}]\n{}", effect.id, numbers.collect::<String>());
    if effect.id.starts_with("friction.") {
        format!("{own}[effects.contact.elastic]\n[units]\nlength_in_metres = 0.5\n")
    } else {
        own
    }
}

#[test]
fn every_effect_is_accepted_and_has_its_numbers() {
    for effect in EFFECTS {
        let scene = parse("scenes/mine.toml", &RIGHT.replace(LAWS, &tables_of(effect)));
        let scene = scene.unwrap_or_else(|error| panic!("{}: {error}", effect.id));
        assert!(scene.effects.named().contains(&effect.id), "{}", effect.id);
        let mut keys = BTreeSet::new();
        scene.effects.map(|key, _| keys.insert(key));
        let expected: BTreeSet<String> = effect
            .numbers
            .iter()
            .map(|number| format!("{}.{number}", effect.id))
            .collect();
        assert_eq!(keys, expected.iter().map(String::as_str).collect());
        if let Some(Friction::Alciatore {
            length_in_metres, ..
        }) = scene.effects.friction
        {
            assert_eq!(length_in_metres, 0.5);
        }
    }
}

#[test]
fn every_number_of_every_effect_is_required() {
    let mut count = 0;
    for effect in EFFECTS {
        for number in effect.numbers {
            let tables = tables_of(effect);
            let line = tables
                .lines()
                .find(|line| line.starts_with(&format!("{number} =")))
                .unwrap();
            let without = tables.replacen(&format!("{line}\n"), "", 1);
            let found = errors(effect.id, &RIGHT.replace(LAWS, &without));
            assert_eq!(kinds(&found), [Kind::Missing], "{}: {found}", effect.id);
            assert!(found.to_string().contains(number), "{found}");
            count += 1;
        }
    }
    let all: usize = EFFECTS.iter().map(|effect| effect.numbers.len()).sum();
    assert_eq!(count, all);
    assert!(count > 15, "{count}");
}

#[test]
fn pockets_need_a_table() {
    let without = RIGHT.replace("[table]\nwidth = 10.0\nlength = 20.0\n", "");
    let laws = "[effects.pockets]\ncircles = [[0.0, 0.0, 0.5]]\n";
    let found = errors("pockets", &without.replace(LAWS, laws));
    assert_eq!(kinds(&found), [Kind::Missing]);
    assert_eq!(found.position(found.problems[0].span.start), (14, 10));
    assert!(
        found.problems[0]
            .message
            .contains("pockets need a `[table]`")
    );
}

#[test]
fn laws_that_turn_balls_go_with_every_cloth_that_lets_them() {
    let turning = [
        "[effects.contact.elastic]\n[effects.friction.constant]\nmu = 0.06\n",
        "[effects.cushion.han-2005]\ne = 0.85\nmu = 0.2\nheight = 1.28\n",
        "[effects.cushion.mathavan-2010]\ne = 0.98\nmu = 0.14\nmu_cloth = 0.212\nheight = 1.28\n",
    ];
    let cloths = [
        "",
        "[effects.cloth.rotational]\nmu_slide = 0.2\nmu_roll = 0.01\nmu_spin = 0.01\n",
    ];
    for law in turning {
        for cloth in cloths {
            let text = RIGHT
                .replace(LAWS, &format!("{cloth}{law}"))
                .replace("[5.0, 5.0]", "[5.0, 5.0]\nspin = [0.0, 3.0, 1.0]");
            let scene = parse("scenes/mine.toml", &text);
            let scene = scene.unwrap_or_else(|error| panic!("{law}: {error}"));
            assert!(scene.effects.rotates());
            assert_eq!(scene.balls[0].state.spin.y, 3.0);
            assert!(scene.inertia(0).is_some(), "{law}");
        }
    }
}

#[test]
fn two_laws_of_one_choice_are_an_error_whichever_they_are() {
    let mut count = 0;
    for (i, one) in EFFECTS.iter().enumerate() {
        for other in &EFFECTS[i + 1..] {
            let group = |id: &str| id.split_once('.').map(|(group, _)| group.to_owned());
            if group(one.id).is_none() || group(one.id) != group(other.id) {
                continue;
            }
            let laws = format!("[effects.{}]\n[effects.{}]\n", one.id, other.id);
            let found = errors(other.id, &RIGHT.replace(LAWS, &laws));
            let two = found.problems.iter().find(|p| p.kind == Kind::TwoLaws);
            let two = two.unwrap_or_else(|| panic!("{} and {}: {found}", one.id, other.id));
            let lines = [&two.also[0].0, &two.span].map(|span| found.position(span.start).0);
            assert_eq!(lines, [17, 18], "{} and {}", one.id, other.id);
            count += 1;
        }
    }
    assert!(
        count >= 9,
        "{count} pairs: cloth 1, contact 1, friction 1, cushion 6"
    );
}
