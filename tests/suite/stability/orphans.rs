//! Accepted files and findings that no run holds.

use super::program::{accept, command, stability, text};
use carom::gate::{self, hold_cases};
use carom::scene::{SetName, catalogue};
use std::fs;
use std::path::Path;

/// The accepted file of a hard case.
fn accepted(scene: &str) -> gate::Accepted {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("validation/hard");
    gate::read(&fs::read_to_string(folder.join(format!("{scene}.csv"))).unwrap()).unwrap()
}

#[test]
fn a_file_that_no_scene_reads_is_told_and_one_of_full_is_none() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let hard = Path::new(env!("CARGO_MANIFEST_DIR")).join("validation/hard");
    for entry in fs::read_dir(hard).unwrap() {
        let path = entry.unwrap().path();
        fs::copy(&path, folder.join(path.file_name().unwrap())).unwrap();
    }
    // a scene that only --full runs has a file of its own, which no other run reads
    let set = catalogue::set(SetName::Hard).unwrap();
    let is_full = |scene: &&carom::scene::Scene| scene.is_in(SetName::Full);
    for scene in set.iter().filter(is_full) {
        let own = folder.join(format!("{}.csv", scene.name));
        fs::copy(folder.join("cradle.csv"), own).unwrap();
    }
    // one engine that takes a moment; that its runs hold is held elsewhere
    let whole_set = || stability(folder, &["--engines", "exact"]);
    let output = whole_set();
    let said = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert!(!said.contains("read by no scene"), "{said}");
    fs::copy(folder.join("cradle.csv"), folder.join("gone.csv")).unwrap();
    let output = whole_set();
    let said = text(&output.stdout);
    let words = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(output.status.code(), Some(1), "{words}");
    assert!(
        words.contains("read by no scene: ") && words.contains("gone.csv"),
        "{words}"
    );
    // where scenes are named, the others' files are not looked at
    let output = stability(folder, &["cradle", "--engines", "exact"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stdout));
}

#[test]
fn a_finding_of_a_run_that_no_matrix_has_is_no_longer_found_whatever_engines_are_named() {
    let scene = "thin-cut-1e-2";
    let good = accepted(scene);
    let row = |engine: &str| gate::Row {
        engine: engine.to_owned(),
        check: "overlap".to_owned(),
        subject: String::new(),
        value: Some(0.1),
        verdict: None,
    };
    for presets in [&["exact"][..], &[]] {
        let outcome = super::outcome(&[scene], presets);
        let some = !presets.is_empty();
        let changes = |accepted: &gate::Accepted| {
            let held = hold_cases(&outcome, 0, accepted, some);
            let changes = held.changes.into_iter();
            changes
                .map(|c| c.row().unwrap().engine.clone())
                .collect::<Vec<_>>()
        };
        assert_eq!(changes(&good), [""; 0]);
        for gone in ["havok", "rapier-f64 preset=arcade", "stepper dt=7"] {
            let mut altered = good.clone();
            altered.rows.push(row(gone));
            assert_eq!(changes(&altered), [gone], "{presets:?}");
        }
    }
}

#[test]
fn a_file_of_another_scene_or_with_bits_is_not_what_was_accepted() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let scene = "thin-cut-1e-2";
    accept(folder, &[scene]);
    let file = folder.join(format!("{scene}.csv"));
    let good = fs::read_to_string(&file).unwrap();
    for (old, new, code, expected) in [
        (
            "# scene: thin-cut-1e-2\n",
            "# scene: cradle\n",
            1,
            "says that it is of cradle",
        ),
        (
            "engine,check",
            "# bits of exact: 0123456789abcdef\nengine,check",
            1,
            "has the bits of exact, of which there is no run",
        ),
        (
            "# version of target: ",
            "# version of target: abacus and ",
            0,
            "accepted of other versions: target was abacus and ",
        ),
    ] {
        fs::write(&file, good.replacen(old, new, 1)).unwrap();
        let output = command(folder, &[scene, "--engines", "exact"])
            .output()
            .unwrap();
        let said = text(&output.stdout);
        let words = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(output.status.code(), Some(code), "{new}: {words}");
        assert!(words.contains(expected), "{new}: {words}");
    }
}
