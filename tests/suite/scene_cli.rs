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
