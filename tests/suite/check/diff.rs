//! `carom diff`: two result folders with the metrics of the gate.

use super::{accept, said};
use assert_cmd::cargo::cargo_bin;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

pub fn carom(arguments: &[&str]) -> Output {
    Command::new(cargo_bin("carom"))
        .args(arguments)
        .output()
        .unwrap()
}

pub fn run(out: &Path, scene: &str, engine: &str, settings: &[&str]) {
    let fixed = [
        "run",
        scene,
        "--engine",
        engine,
        "--out",
        out.to_str().unwrap(),
    ];
    let settings: Vec<&str> = settings.iter().flat_map(|s| ["--set", s]).collect();
    let output = carom(&[&fixed[..], &settings].concat());
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
}

fn diff(a: &Path, b: &Path) -> (Option<i32>, String) {
    let output = carom(&["diff", a.to_str().unwrap(), b.to_str().unwrap()]);
    let words = said(&output);
    let words = words.split_whitespace().collect::<Vec<_>>().join(" ");
    (output.status.code(), words)
}

#[test]
fn two_runs_differ_by_what_changed_between_them_and_not_by_what_did_not() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    run(&at("a"), "head-on", "stepper", &[]);
    run(&at("again"), "head-on", "stepper", &[]);
    run(&at("finer"), "head-on", "stepper", &["dt=5e-4"]);
    run(&at("other"), "slide", "stepper", &[]);
    for (other, code, words) in [
        ("again", 0, "nothing differs"),
        ("finer", 1, "Other settings: dt 0.0005 instead of 0.001"),
        ("finer", 1, "final-position"),
        ("finer", 1, "steps"),
        ("other", 2, "different scenes"),
        ("nowhere", 2, "cannot read"),
    ] {
        let (got, said) = diff(&at("a"), &at(other));
        assert_eq!(got, Some(code), "{other}: {said}");
        assert!(said.contains(words), "{other}: {said}");
    }
}

#[test]
fn a_stop_that_moved_in_one_file_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    for name in ["a", "b"] {
        run(&at(name), "slide", "exact", &[]);
    }
    let file = at("b").join("final.csv");
    let text = fs::read_to_string(&file).unwrap();
    let row = text.lines().nth(1).unwrap();
    let (start, stop) = row.rsplit_once(',').unwrap();
    let later = stop.parse::<f64>().unwrap() + 1e-6;
    fs::write(&file, text.replace(row, &format!("{start},{later:?}"))).unwrap();
    let (code, said) = diff(&at("a"), &at("b"));
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("1 finding differs: 1 moved"), "{said}");
    assert!(said.contains("stop-time"), "{said}");
}

#[test]
fn two_folders_of_baselines_are_held_against_each_other() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    accept(&at("a"), &["slide"]);
    fs::create_dir(at("b")).unwrap();
    let text = fs::read_to_string(at("a").join("slide.csv")).unwrap();
    fs::write(at("b").join("slide.csv"), &text).unwrap();
    assert_eq!(diff(&at("a"), &at("b")).0, Some(0));
    let steps = text
        .lines()
        .find(|l| l.starts_with("stepper,work,steps,"))
        .unwrap();
    let moved = text.replacen(steps, "stepper,work,steps,7.0,", 1);
    fs::write(at("b").join("slide.csv"), moved).unwrap();
    let (code, said) = diff(&at("a"), &at("b"));
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("1 finding differs: 1 moved"), "{said}");
    // what stands above the findings is held or told
    for (old, new, code, words) in [
        (
            "# hash: ",
            "# hash: f",
            1,
            "2 findings differ: 1 vanished, 1 appeared",
        ),
        (
            "# scene: slide",
            "# scene: head-on",
            2,
            "it says that it is of the scene head-on",
        ),
        (
            "# reason: ",
            "# reason: not ",
            0,
            "in 1 the reason is another",
        ),
        (
            "# version of target: ",
            "# version of target: not ",
            0,
            "Of other versions: target was ",
        ),
        (
            ",work,steps,",
            ",work,steps,inf,holds\nhavok,work,steps,",
            1,
            "differ",
        ),
    ] {
        assert!(text.contains(old), "{old}");
        fs::write(at("b").join("slide.csv"), text.replacen(old, new, 1)).unwrap();
        let (got, said) = diff(&at("a"), &at("b"));
        assert_eq!(got, Some(code), "{new}: {said}");
        assert!(said.contains(words), "{new}: {said}");
    }
    fs::write(at("b").join("slide.csv"), "no baseline").unwrap();
    assert_eq!(diff(&at("a"), &at("b")).0, Some(2));
}
