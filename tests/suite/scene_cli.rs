//! `carom scene` and SCENE arguments: names, paths, and what is said when neither leads to a scene.

use carom::cli::scene::{check, load, resolve, schema_text, show};
use carom::cli::scene_list::{ListArguments, document, found, lines};
use carom::finding::{Block, Cell};
use carom::report::text;
use carom::scene::{Scene, SetName, catalogue};
use std::fs;
use std::process::Output;

#[test]
fn a_scene_is_named_by_the_catalogue_or_by_a_path() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    fs::write(&path, show("slide").unwrap()).unwrap();
    let by_path = resolve(path.to_str().unwrap()).unwrap();
    assert_eq!(by_path, resolve("slide").unwrap());
}

#[test]
fn what_is_not_a_scene_is_answered_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let folder_path = folder.path().to_str().unwrap();
    let directory = format!("cannot read {folder_path}: it is a directory, not a file");
    let cases = [
        (folder_path, directory.as_str()),
        (
            "no/such.toml",
            "cannot read no/such.toml: there is no such file",
        ),
        (
            "slde",
            "no scene is called `slde`; did you mean `slide` or `side`? `carom scene list` prints all names",
        ),
        (
            "Slide",
            "no scene is called `Slide`; did you mean `slide`? `carom scene list` prints all names",
        ),
    ];
    for (argument, expected) in cases {
        let error = resolve(argument).unwrap_err();
        assert_eq!(error.to_string(), expected);
        assert_eq!(error.render(false), format!("error: {expected}"));
    }
    let binary = folder.path().join("binary.toml");
    fs::write(&binary, [0x00, 0xff]).unwrap();
    let error = load(&binary).unwrap_err().render(false);
    assert!(
        error.starts_with("error: the file is not UTF-8 text"),
        "{error}"
    );
}

#[test]
fn check_says_ok_on_one_stream_and_errors_on_the_other() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.toml");
    fs::write(&path, show("slide").unwrap().replace("0.107", "-0.107")).unwrap();
    let bad = path.to_str().unwrap().to_owned();
    let (mut out, mut err) = (Vec::new(), Vec::new());
    assert!(check(&["slide".to_owned()], false, &mut out, &mut err).unwrap());
    assert!(err.is_empty());
    let files = [bad.clone(), "three-ball".to_owned()];
    assert!(!check(&files, false, &mut out, &mut err).unwrap());
    let out = String::from_utf8(out).unwrap();
    assert_eq!(
        out,
        "slide: ok, slide with 1 ball\nthree-ball: ok, three-ball with 3 balls\n"
    );
    let err = String::from_utf8(err).unwrap();
    assert!(
        err.starts_with("error: mass must be a finite number greater than 0\n"),
        "{err}"
    );
    assert!(err.contains(&format!("--> {bad}:")), "{err}");
}

#[test]
fn the_table_of_scenes_has_a_row_for_every_one() {
    let document = document(&every_scene());
    let Some(Block::Table(table)) = document.blocks.first() else {
        panic!("no table in {document:?}");
    };
    assert_eq!(table.rows.len(), catalogue::all().len());
    for (row, entry) in table.rows.iter().zip(catalogue::all()) {
        assert_eq!(row.len(), table.columns.len());
        assert_eq!(row[0], Cell::text(entry.name));
        assert_eq!(row[4], Cell::text(&entry.scene().unwrap().description));
    }
}

fn every_scene() -> Vec<Scene> {
    found(&ListArguments::default()).unwrap()
}

fn program(arguments: &[&str]) -> Output {
    let mut carom = assert_cmd::Command::cargo_bin("carom").unwrap();
    carom.args(arguments).output().unwrap()
}

/// What `carom scene list` prints with these options besides.
fn listed(options: &[&str]) -> String {
    let output = program(&[&["scene", "list"], options].concat());
    assert_eq!(output.status.code(), Some(0), "{options:?}");
    assert!(output.stderr.is_empty(), "{options:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// Names of the scenes of a printed list, in order.
fn names(list: &str) -> Vec<&str> {
    let scenes = list
        .lines()
        .skip(1)
        .filter_map(|line| line.strip_prefix("  "));
    scenes.map(|line| line.split(' ').next().unwrap()).collect()
}

#[test]
fn the_list_has_one_line_a_scene_below_the_first_set_of_it() {
    let list = listed(&[]);
    let scenes = every_scene();
    // the heading; a blank line and a heading a set; a blank line and the last one
    let sets = SetName::ALL.len();
    assert_eq!(list.lines().count(), 1 + 2 * sets + scenes.len() + 2);
    for line in list.lines() {
        assert!(line.chars().count() <= text::WIDTH, "{line}");
    }
    assert!(
        list.lines()
            .last()
            .unwrap()
            .contains("`carom scene show NAME`"),
        "{list}"
    );
    let mut expected = Vec::new();
    for set in SetName::ALL {
        let first = |scene: &&Scene| scene.sets.first() == Some(&set);
        let names: Vec<&str> = scenes
            .iter()
            .filter(first)
            .map(|scene| scene.name.as_str())
            .collect();
        let heading = format!("{} ({}): {}\n", set.id(), names.len(), set.what());
        assert!(list.contains(&heading), "no {heading}");
        expected.extend(names);
    }
    assert_eq!(names(&list), expected);
    for scene in &scenes {
        let begins = format!("  {} ", scene.name);
        let line = list.lines().find(|line| line.starts_with(&begins)).unwrap();
        let rest = line[begins.len()..].trim_start();
        let (balls, what) = rest.split_once("  ").unwrap();
        assert_eq!(balls, scene.balls.len().to_string(), "{line}");
        let kept = what.trim_end_matches('…');
        assert!(
            kept.len() > 10 && scene.description.starts_with(kept),
            "{line}"
        );
        // whole sentences end, others are marked
        let after = &scene.description[kept.len()..];
        let ends = after.is_empty() || after == "." || after.starts_with(". ");
        assert_eq!(ends, kept == what, "{line}");
    }
}

#[test]
fn a_wider_terminal_shows_more_of_a_description() {
    let scenes = every_scene();
    let mut shown = 0;
    for width in [text::NARROWEST, 80, 100, 130, text::WIDEST] {
        let list = lines(&scenes, None, width);
        let longest = list.lines().map(|line| line.chars().count()).max();
        assert!(longest <= Some(width), "{width}: {longest:?}\n{list}");
        assert_eq!(names(&list).len(), scenes.len(), "{width}");
        assert!(list.len() > shown, "{width} shows no more\n{list}");
        shown = list.len();
    }
}

#[test]
fn filters_of_the_list_hold_together() {
    let scenes = every_scene();
    let has = |scene: &Scene, word: &str| {
        scene.name.contains(word) || scene.description.to_lowercase().contains(word)
    };
    let of = |scene: &Scene, id: &str| scene.effects.named().iter().any(|one| one.starts_with(id));
    type Wanted<'a> = Box<dyn Fn(&Scene) -> bool + 'a>;
    let cases: [(&[&str], Wanted); 9] = [
        (&["rack"], Box::new(|scene| has(scene, "rack"))),
        (&["RACK"], Box::new(|scene| has(scene, "rack"))),
        (
            &["rack", "loss"],
            Box::new(|scene| has(scene, "rack") && has(scene, "loss")),
        ),
        (
            &["--set", "gate"],
            Box::new(|scene| scene.is_in(SetName::Gate)),
        ),
        (
            &["--set", "full"],
            Box::new(|scene| scene.is_in(SetName::Full)),
        ),
        (
            &["--effect", "contact"],
            Box::new(|scene| of(scene, "contact.")),
        ),
        (
            &["--effect", "cloth.rotational"],
            Box::new(|scene| of(scene, "cloth.rotational")),
        ),
        (
            &["--effect", "pockets"],
            Box::new(|scene| of(scene, "pockets")),
        ),
        (
            &["throw", "--effect", "friction.constant", "--set", "gate"],
            Box::new(|scene| {
                has(scene, "throw") && of(scene, "friction.constant") && scene.is_in(SetName::Gate)
            }),
        ),
    ];
    for (options, wanted) in cases {
        let mut expected: Vec<&str> = scenes
            .iter()
            .filter(|scene| wanted(scene))
            .map(|scene| scene.name.as_str())
            .collect();
        assert!(
            !expected.is_empty() && expected.len() < scenes.len(),
            "{options:?} chooses nothing"
        );
        let csv = listed(&[options, &["--format", "csv"]].concat());
        let mut reader = csv::Reader::from_reader(csv.as_bytes());
        let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        let found: Vec<&str> = rows.iter().map(|row| &row[0]).collect();
        assert_eq!(found, expected, "{options:?}");
        for row in &rows {
            let scene = catalogue::scene(&row[0]).unwrap();
            assert_eq!(row[4], scene.description);
        }
        let text = listed(options);
        let mut shown = names(&text);
        // by sets there, in the order of the catalogue here
        shown.sort_unstable();
        expected.sort_unstable();
        assert_eq!(shown, expected, "{options:?}");
    }
    // whoever asks for a set sees that set
    let gate = listed(&["--set", "gate"]);
    assert!(
        gate.contains("\ngate (") && !gate.contains("\nreport ("),
        "{gate}"
    );
}

#[test]
fn an_unknown_set_or_effect_is_answered_with_the_known_ones() {
    for (option, known) in [
        ("--set", ["report", "gate", "hard", "full"]),
        (
            "--effect",
            ["contact", "cloth.rotational", "friction", "pockets"],
        ),
    ] {
        let output = program(&["scene", "list", option, "snooker"]);
        assert_eq!(output.status.code(), Some(2), "{option}");
        assert!(output.stdout.is_empty(), "{option}");
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(
            said.contains("`snooker`") || said.contains("'snooker'"),
            "{said}"
        );
        for word in known {
            assert!(said.contains(word), "{option} does not name {word}: {said}");
        }
    }
}

#[test]
fn a_list_without_scenes_says_so_in_every_format() {
    for format in ["text", "json", "markdown", "csv"] {
        let output = program(&["scene", "list", "snooker", "--format", format]);
        assert_eq!(output.status.code(), Some(0), "{format}");
        let said = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        assert!(
            said.contains("No scene has all of that"),
            "{format}: {said}"
        );
    }
}

/// The errors named all 150 scenes.
#[test]
fn every_command_answers_an_unknown_scene_with_at_most_three_names() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let out = out.to_str().unwrap();
    let commands: [&[&str]; 12] = [
        &["run", "NAME", "--engine", "exact", "--out", out],
        &["compare", "NAME"],
        &["report", "slide", "NAME", "--out", out],
        &["cost", "NAME"],
        &["horizon", "NAME"],
        &["ensemble", "NAME", "--samples", "10", "--seed", "1"],
        &["effects", "NAME"],
        &["play", "NAME"],
        &["check", "NAME"],
        &["stability", "NAME"],
        &["scene", "show", "NAME"],
        &["scene", "check", "NAME"],
    ];
    for (name, nearest) in [
        ("report-brake", "did you mean `report-break`"),
        ("rack", "did you mean `rack-frozen-central`"),
        ("snooker", ""),
    ] {
        for command in commands {
            let arguments: Vec<&str> = command
                .iter()
                .map(|&word| if word == "NAME" { name } else { word })
                .collect();
            let output = program(&arguments);
            assert_eq!(output.status.code(), Some(2), "{arguments:?}");
            let said = String::from_utf8(output.stderr).unwrap();
            assert!(
                said.contains(&format!("no scene is called `{name}`; {nearest}")),
                "{arguments:?}: {said}"
            );
            assert!(said.contains("`carom scene list`"), "{arguments:?}: {said}");
            // the name itself, three others and the command
            assert!(said.matches('`').count() <= 10, "{arguments:?}: {said}");
            let list = "known are";
            assert!(!said.contains(list), "{arguments:?}: {said}");
        }
    }
}

#[test]
fn show_prints_the_file_as_written_and_the_schema_is_json() {
    for entry in catalogue::all() {
        assert_eq!(show(entry.name).unwrap(), entry.text);
    }
    let schema: serde_json::Value = serde_json::from_str(&schema_text()).unwrap();
    assert_eq!(schema["title"], "carom scene");
}

/// A scene with these ids, far apart.
fn scene_of(ids: &[&str]) -> String {
    let ball = |(i, id)| format!("[[balls]]\nid = '{id}'\nposition = [{i}.0, 0.0]\n");
    let balls: String = ids.iter().enumerate().map(ball).collect();
    format!(
        "name = \"ids\"\ndescription = \"Of <any> *kind*.\"\nduration = 1.0\n[ball]\nradius = 0.1\nmass = 1.0\n{balls}"
    )
}

#[test]
fn check_warns_of_words_that_tables_for_people_cannot_show_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ids.toml");
    let name = path.to_str().unwrap().to_owned();
    let said = |text: &str| {
        fs::write(&path, text).unwrap();
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let right = check(std::slice::from_ref(&name), false, &mut out, &mut err).unwrap();
        assert!(right, "{text}\n{}", String::from_utf8_lossy(&err));
        assert!(String::from_utf8(out).unwrap().contains(": ok, ids with "));
        String::from_utf8(err).unwrap()
    };
    // what needs no care, and markup in prose
    assert_eq!(
        said(&scene_of(&["cue", "a_b", "7", "b-2", "-7", "\u{e9}"])),
        ""
    );
    for (id, why) in [
        ("<img/src=x>", "id has signs that are markup"),
        ("a|b", "id has signs that are markup"),
        ("`x`", "id has signs that are markup"),
        ("[x](y)", "id has signs that are markup"),
        ("=1+1", "id begins as a formula of a spreadsheet does"),
        ("@x", "id begins as a formula of a spreadsheet does"),
        ("+x", "id begins as a formula of a spreadsheet does"),
        ("a\u{202e}b", "id has the hidden character \\u{202e}"),
        ("a\u{200b}b", "id has the hidden character \\u{200b}"),
    ] {
        let warned = said(&scene_of(&["cue", id]));
        assert!(
            warned.starts_with(&format!("warning: {why}\n")),
            "{id}: {warned}"
        );
        // at its line and column
        assert!(
            warned.contains(&format!("--> {name}:11:6")),
            "{id}: {warned}"
        );
        assert_eq!(warned.matches("warning:").count(), 1, "{warned}");
        assert!(!warned.contains(['\u{202e}', '\u{200b}']), "{warned:?}");
    }
    let units = scene_of(&["cue"]).replace("[ball]", "units = { length = \"=1+1\" }\n[ball]");
    let warned = said(&units);
    assert!(
        warned.starts_with("warning: length begins as a formula"),
        "{warned}"
    );
    let ids: Vec<String> = (0..25).map(|i| format!("<{i}>")).collect();
    let ids: Vec<&str> = ids.iter().map(String::as_str).collect();
    assert!(
        said(&scene_of(&ids))
            .trim_end()
            .ends_with("5 more warnings")
    );
}

#[test]
fn a_warning_does_not_change_the_exit_code() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ids.toml");
    fs::write(&path, scene_of(&["<b>"])).unwrap();
    let program = |command: &[&str]| {
        let mut carom = assert_cmd::Command::cargo_bin("carom").unwrap();
        carom.args(command).arg(&path).output().unwrap()
    };
    let output = program(&["scene", "check"]);
    assert_eq!(output.status.code(), Some(0));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.starts_with("warning: id has signs"), "{said}");
    assert!(!program(&["scene", "check"]).stdout.is_empty());
}

#[test]
fn ids_are_to_the_bit_in_files_and_shown_safely_to_people() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ids.toml");
    let ids = ["<b>x</b>", "=1+1", "a\u{202e}b", "p|q"];
    fs::write(&path, scene_of(&ids)).unwrap();
    let out = folder.path().join("out");
    let run = |format: &str| {
        let mut carom = assert_cmd::Command::cargo_bin("carom").unwrap();
        let command = carom
            .arg("run")
            .arg(&path)
            .args(["--engine", "exact", "--out"]);
        let output = command
            .arg(&out)
            .args(["--format", format])
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(0));
        String::from_utf8(output.stdout).unwrap()
    };
    let text = run("text");
    for shown in ["<b>x</b>", "'=1+1", "a\\u{202e}b", "p|q"] {
        assert!(text.contains(shown), "{text}");
    }
    assert!(!text.contains('\u{202e}'), "{text:?}");
    let markdown = run("markdown");
    for shown in ["\\<b>x\\</b>", "'=1+1", "p\\|q"] {
        assert!(markdown.contains(shown), "{markdown}");
    }
    let json: serde_json::Value = serde_json::from_str(&run("json")).unwrap();
    let rows = json["tables"]["final"]["rows"].as_array().unwrap();
    let named: Vec<&str> = rows
        .iter()
        .map(|row| row["ball"].as_str().unwrap())
        .collect();
    assert_eq!(named, ids);
    for sheet in [
        run("csv"),
        fs::read_to_string(out.join("final.csv")).unwrap(),
    ] {
        let mut reader = csv::Reader::from_reader(sheet.as_bytes());
        let named: Vec<String> = reader
            .records()
            .map(|row| row.unwrap()[0].to_owned())
            .collect();
        assert_eq!(named, ids);
    }
}

#[cfg(unix)]
#[test]
fn no_name_of_a_file_and_no_argument_commands_a_terminal() {
    const NAME: &str = "a\u{1b}[2J\u{202e}b";
    let folder = tempfile::tempdir().unwrap();
    let there = folder.path().join(NAME);
    fs::create_dir(&there).unwrap();
    let there = there.to_str().unwrap();
    let commands: [&[&str]; 8] = [
        &["scene", "check", there],
        &["run", "slide", "--engine", NAME, "--out", there],
        &[
            "run", "slide", "--engine", "exact", "--set", NAME, "--out", there,
        ],
        &["run", "slide", "--engine", "exact", "--out", there],
        &["compare", "slide", "--engines", NAME],
        &["diff", there, there],
        &["diff", there, NAME],
        &["report", "slide", NAME, "--out", there],
    ];
    for command in commands {
        let output = assert_cmd::Command::cargo_bin("carom")
            .unwrap()
            .args(command)
            .output()
            .unwrap();
        let said = [output.stdout, output.stderr].concat();
        let said = String::from_utf8(said).unwrap();
        assert!(
            !said.contains(['\u{1b}', '\u{202e}']),
            "{command:?}: {said:?}"
        );
        // clap takes the first away by itself
        assert!(said.contains("\\u{202e}b"), "{command:?}: {said}");
    }
}
