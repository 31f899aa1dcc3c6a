//! `carom scene` and SCENE arguments: names, paths, and what is said when neither leads to a scene.

use carom::cli::scene::{check, list_document, load, resolve, schema_text, show};
use carom::finding::{Block, Cell};
use carom::scene::catalogue;
use std::fs;

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
        ("slde", "no scene is called `slde`; did you mean `slide`?"),
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
fn the_list_has_a_row_for_every_scene() {
    let document = list_document().unwrap();
    let Some(Block::Table(table)) = document.blocks.first() else {
        panic!("no table in {document:?}");
    };
    assert_eq!(table.rows.len(), catalogue::all().len());
    for (row, entry) in table.rows.iter().zip(catalogue::all()) {
        assert_eq!(row.len(), table.columns.len());
        assert_eq!(row[0], Cell::text(entry.name));
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
