//! `carom stability` as CI meets it: exit codes, files, formats.

use crate::accepting::kill_while_accepting;
use assert_cmd::cargo::cargo_bin;
use carom::gate;
use carom::report::FORMATS;
use carom::scene::{SetName, catalogue};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// A scene in which every engine takes a moment.
const SCENE: &str = "thin-cut-1e-2";

pub fn stability(folder: &Path, arguments: &[&str]) -> Output {
    command(folder, arguments).output().unwrap()
}

pub fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(cargo_bin("carom"));
    command.arg("stability").args(arguments);
    command.arg("--accepted").arg(folder);
    command
}

pub fn accept(folder: &Path, scenes: &[&str]) {
    let arguments = [scenes, &["--accept", "--reason", "for a test"]].concat();
    let output = stability(folder, &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn what_was_accepted_is_held_in_both_directions() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    accept(folder, &[SCENE]);
    let file = folder.join(format!("{SCENE}.csv"));
    let good = fs::read_to_string(&file).unwrap();
    assert!(good.contains("# reason: for a test\n"), "{good}");
    let rows = gate::read(&good).unwrap().rows;
    let verdicts = rows.iter().filter(|row| row.check == "verdict");
    assert!(verdicts.count() > 10, "{good}");
    let exact = ["--engines", "exact"];
    let held = |text: &str| {
        fs::write(&file, text).unwrap();
        stability(folder, &[&[SCENE], &exact[..]].concat())
    };
    let end = good
        .lines()
        .find(|l| l.starts_with("exact,ending,"))
        .unwrap();
    for (old, new, code, words) in [
        ("", "", 0, "everything is as accepted"),
        // an accepted break is an expectation, and an engine that does better does not meet it
        (
            "exact,verdict,,,holds",
            "exact,verdict,,,breaks",
            1,
            "better",
        ),
        ("exact,verdict,,,holds\n", "", 1, "appeared"),
        (end, "exact,ending,rest,1.0,", 1, "vanished"),
        (
            "# hash: ",
            "# hash: f",
            1,
            "changed since they were accepted",
        ),
        (
            "exact,verdict,,,holds",
            "exact,verdict,,,passes",
            2,
            ".csv, line ",
        ),
        (
            "exact,verdict,,,holds",
            "exact,verdict,,holds",
            2,
            "--accept --reason",
        ),
    ] {
        let output = held(&good.replacen(old, new, 1));
        let said = text(&output.stdout) + &text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{new}: {said}");
        assert!(said.contains(words), "{new}: {said}");
    }
}

#[test]
fn nothing_is_accepted_without_a_reason_and_what_is_missing_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().join("accepted");
    let exact = ["--engines", "exact"];
    for (arguments, words) in [
        (vec![SCENE, "--accept"], "--reason"),
        (vec![SCENE, "--accept", "--reason", "  "], "is empty"),
        (vec![SCENE, "--reason", "why"], "--accept"),
        // whole files are written, so every engine must have run
        (
            vec![SCENE, "--accept", "--reason", "why", "--engines", "exact"],
            "cannot be used",
        ),
        (
            [&[SCENE], &exact[..]].concat(),
            "carom stability thin-cut-1e-2 --accept --reason",
        ),
        (vec![SCENE, SCENE, "--engines", "exact"], "named twice"),
        (vec!["no-such-scene"], "no-such-scene"),
    ] {
        let output = stability(&folder, &arguments);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(words), "{arguments:?}: {said}");
        assert!(!folder.exists(), "{arguments:?} wrote a file");
    }
}

#[test]
fn a_kill_while_accepting_leaves_whole_files() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let scenes = ["slide", "head-on", SCENE];
    accept(folder, &scenes);
    kill_while_accepting(folder, &scenes, command);
}

#[test]
fn every_format_prints_the_matrix_and_a_terminal_is_wide_enough() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("page");
    accept(folder.path(), &[SCENE, "through-a-ball"]);
    for format in FORMATS {
        let arguments = [
            SCENE,
            "through-a-ball",
            "--engines",
            "exact,stepper",
            "--format",
            format.id,
            "--out",
        ];
        let output = stability(
            folder.path(),
            &[&arguments[..], &[out.to_str().unwrap()]].concat(),
        );
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        let shown = text(&output.stdout);
        for words in [
            "breaks",
            "holds",
            "through-a-ball",
            "everything is as accepted",
        ] {
            let tables_alone = format.id == "csv" && words.starts_with("everything");
            assert!(
                tables_alone || shown.contains(words),
                "{}: {shown}",
                format.id
            );
        }
        match format.id {
            "text" => assert!(
                shown.lines().all(|line| line.chars().count() <= 100),
                "{shown}"
            ),
            "json" => assert!(
                serde_json::from_str::<serde_json::Value>(&shown)
                    .unwrap()
                    .is_object()
            ),
            _ => {}
        }
    }
    let page = fs::read_to_string(out.join("pages/through-a-ball.html")).unwrap();
    assert!(
        page.contains("<svg") && page.contains("misses cue-1"),
        "no picture of what breaks"
    );
    assert!(
        fs::read_to_string(out.join("index.html"))
            .unwrap()
            .contains("pages/through-a-ball.html")
    );
}

#[test]
fn every_hard_scene_has_an_accepted_file_and_no_other_is_there() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("validation/hard");
    let mut files: Vec<String> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    let mut expected = Vec::new();
    for scene in catalogue::set(SetName::Hard).unwrap() {
        if scene.is_in(SetName::Full) {
            continue;
        }
        let text = fs::read_to_string(folder.join(format!("{}.csv", scene.name))).unwrap();
        let accepted = gate::read(&text).unwrap_or_else(|e| panic!("{}: {e}", scene.name));
        assert_eq!(accepted.scene, scene.name);
        assert_eq!(
            accepted.hash,
            scene.hash(),
            "{} has changed: accept it anew",
            scene.name
        );
        assert_eq!(
            gate::write(&accepted),
            text,
            "{} was edited by hand",
            scene.name
        );
        expected.push(format!("{}.csv", scene.name));
    }
    expected.sort();
    assert_eq!(files, expected);
}

#[test]
fn the_program_has_the_accepted_findings_of_its_version_with_it() {
    let empty = tempfile::tempdir().unwrap();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("validation/hard");
    let json = [SCENE, "--format", "json"];
    let alone = |arguments: &[&str]| {
        let mut command = Command::new(cargo_bin("carom"));
        command.env_clear().current_dir(empty.path());
        command.arg("stability").args(arguments).output().unwrap()
    };
    let (built_in, named) = (alone(&json), stability(&folder, &json));
    for output in [&built_in, &named] {
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    }
    let words = concat!("those built into carom ", env!("CARGO_PKG_VERSION"));
    let same = text(&named.stdout).replace(&folder.display().to_string(), words);
    assert!(same.contains(words), "{same}");
    assert_eq!(text(&built_in.stdout), same);
    let refused = alone(&[SCENE, "--accept", "--reason", "why"]);
    let said = text(&refused.stderr);
    assert_eq!(refused.status.code(), Some(2), "{said}");
    let command = "carom stability --accept --reason \"...\" --accepted DIR";
    assert!(said.contains(command), "{said}");
    assert_eq!(fs::read_dir(empty.path()).unwrap().count(), 0);
}
