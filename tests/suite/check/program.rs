//! `carom check` as CI meets it: exit codes and files.

use super::{SCENES, accept, baselines, check, command, said};
use crate::accepting::kill_while_accepting;
use std::fs;
use std::path::Path;
use std::process::Command;

#[test]
fn the_baselines_of_the_repository_are_met_to_the_bit() {
    // tests and release builds optimise differently: the same numbers and verdicts, and on the target of the baselines the same bits
    let output = check(&baselines(), &SCENES);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert!(said.contains("everything is as accepted"), "{said}");
    if cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        let words = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            words.contains("bits: 22 runs the same, 0 the same"),
            "{said}"
        );
    }
}

#[test]
fn what_was_accepted_is_held_in_both_directions() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    accept(folder, &["slide"]);
    let file = folder.join("slide.csv");
    let good = fs::read_to_string(&file).unwrap();
    assert!(good.contains("# reason: for a test\n"), "{good}");
    for built in crate::support::roster().iter().flat_map(|e| e.built()) {
        assert!(built.word() != "unknown", "{built}");
        assert!(good.contains(&format!(": {built}\n")), "{built}: {good}");
    }
    let line = |start: &str| good.lines().find(|l| l.starts_with(start)).unwrap();
    let steps = line("stepper,work,steps,");
    let stop = line("oracle,stopped-at,");
    let bits = line("# bits of stepper: ");
    let moved = |line: &str| {
        let (start, value) = line.trim_end_matches(',').rsplit_once(',').unwrap();
        format!("{start},{:?},", 1.01 * value.parse::<f64>().unwrap() + 1e-3)
    };
    for (old, new, code, words) in [
        ("", String::new(), 0, "everything is as accepted"),
        (
            steps,
            moved(steps),
            1,
            "work steps in stepper of slide: moved",
        ),
        (stop, moved(stop), 1, "in oracle of slide: moved"),
        (
            stop,
            "oracle,stopped-at,nobody,1.0,".to_owned(),
            1,
            "is no longer found",
        ),
        (
            "stepper,promise,finite,,holds\n",
            String::new(),
            1,
            "was not there",
        ),
        (
            "stepper,promise,finite,,holds",
            "stepper,promise,finite,,breaks".to_owned(),
            1,
            "better",
        ),
        (
            "# hash: ",
            "# hash: f".to_owned(),
            1,
            "changed since they were accepted",
        ),
        // bits only inform
        (
            bits,
            "# bits of stepper: 0123456789abcdef".to_owned(),
            0,
            "1 the same physics in different bits",
        ),
        (
            "stepper,promise,finite,,holds",
            "stepper,promise,finite,holds".to_owned(),
            2,
            ".csv, line ",
        ),
        ("# scene: slide\n", String::new(), 2, "lack `# scene"),
    ] {
        fs::write(&file, good.replacen(old, &new, 1)).unwrap();
        let output = check(folder, &["slide"]);
        let said = said(&output)
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ");
        assert_eq!(output.status.code(), Some(code), "{new}: {said}");
        assert!(said.contains(words), "{new}: {said}");
    }
}

#[test]
fn nothing_is_accepted_without_a_reason_and_what_is_missing_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().join("baselines");
    for (arguments, words) in [
        (vec!["slide", "--accept"], "--reason"),
        (vec!["slide", "--accept", "--reason", "  "], "is empty"),
        (vec!["slide", "--reason", "why"], "--accept"),
        (vec!["slide"], "carom check slide --accept --reason"),
        (vec!["slide", "slide"], "named twice"),
        (vec!["no-such-scene"], "no-such-scene"),
    ] {
        let output = check(&folder, &arguments);
        let said = said(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(words), "{arguments:?}: {said}");
        assert!(!folder.exists(), "{arguments:?} wrote a file");
    }
}

#[test]
fn accepting_shows_old_and_new_and_writes_only_what_changed() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    accept(folder, &["slide", "head-on"]);
    let file = folder.join("slide.csv");
    let other = fs::read_to_string(folder.join("head-on.csv")).unwrap();
    let good = fs::read_to_string(&file).unwrap();
    let steps = good
        .lines()
        .find(|l| l.starts_with("stepper,work,steps,"))
        .unwrap();
    fs::write(&file, good.replacen(steps, "stepper,work,steps,7.0,", 1)).unwrap();
    let output = check(
        folder,
        &["slide", "head-on", "--accept", "--reason", "the second"],
    );
    let said = said(&output)
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert!(said.contains("was 7, is "), "{said}");
    assert!(said.contains("1 of 2 files written"), "{said}");
    assert!(
        fs::read_to_string(&file)
            .unwrap()
            .contains("# reason: the second\n")
    );
    assert_eq!(
        fs::read_to_string(folder.join("head-on.csv")).unwrap(),
        other
    );
}

#[test]
fn a_kill_while_accepting_leaves_whole_baselines() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    accept(folder, &SCENES);
    kill_while_accepting(folder, &SCENES, command);
}

/// The program in a folder of its own, with nothing in its environment and no folder of baselines named.
fn alone(folder: &Path, arguments: &[&str]) -> std::process::Output {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin("carom"));
    command.env_clear().current_dir(folder).arg("check");
    command.args(arguments).output().unwrap()
}

#[test]
fn the_program_has_the_baselines_of_its_version_with_it() {
    let empty = tempfile::tempdir().unwrap();
    let json = [&SCENES[..], &["--format", "json"]].concat();
    let built_in = alone(empty.path(), &json);
    let named = check(&baselines(), &json);
    for output in [&built_in, &named] {
        assert_eq!(output.status.code(), Some(0), "{}", said(output));
    }
    let words = "those built into carom ";
    let from_folder = baselines().display().to_string();
    let (built_in, named) = (
        String::from_utf8(built_in.stdout).unwrap(),
        String::from_utf8(named.stdout).unwrap(),
    );
    assert!(
        built_in.contains(words) && !named.contains(words),
        "{built_in}"
    );
    let version = env!("CARGO_PKG_VERSION");
    let same = named.replace(&from_folder, &format!("{words}{version}"));
    assert_eq!(built_in, same);
    assert!(built_in.contains("everything is as accepted"), "{built_in}");
    assert_eq!(fs::read_dir(empty.path()).unwrap().count(), 0);
}

#[test]
fn what_is_built_in_is_not_accepted_over() {
    let empty = tempfile::tempdir().unwrap();
    let output = alone(empty.path(), &["slide", "--accept", "--reason", "why"]);
    let told = said(&output);
    assert_eq!(output.status.code(), Some(2), "{told}");
    let command = "carom check --accept --reason \"...\" --baseline DIR";
    assert!(told.contains(command), "{told}");
    // a folder that is not there is not taken for the one that is built in
    let output = alone(
        empty.path(),
        &["slide", "--baseline", "validation/baselines"],
    );
    let told = said(&output);
    assert_eq!(output.status.code(), Some(2), "{told}");
    assert!(
        told.contains("nothing is accepted of slide in validation/baselines"),
        "{told}"
    );
    // a scene of the catalogue that is not in the gate
    let output = alone(empty.path(), &["cradle"]);
    let told = said(&output);
    assert_eq!(output.status.code(), Some(2), "{told}");
    assert!(
        told.contains("nothing is accepted of cradle among those built into"),
        "{told}"
    );
    assert_eq!(fs::read_dir(empty.path()).unwrap().count(), 0);
}

#[test]
fn nothing_is_held_of_an_engine_that_was_built_from_elsewhere() {
    let empty = tempfile::tempdir().unwrap();
    let is = engine_sources();
    for (wanted, code, words) in [
        (is.clone(), 0, "everything is as accepted".to_owned()),
        (
            is.replace("=registry", "=path"),
            2,
            "was not used in the crate graph".to_owned(),
        ),
        (
            is.replace("=registry", "=git"),
            2,
            "was not built with rapier3d".to_owned(),
        ),
        // what an engine needs is part of it
        (
            "parry3d-f64=path".to_owned(),
            2,
            "parry3d-f64 0.".to_owned(),
        ),
        (
            "rapier2d=path".to_owned(),
            2,
            "no engine needs a crate rapier2d".to_owned(),
        ),
        ("rapier3d".to_owned(), 2, "expected CRATE=SOURCE".to_owned()),
        (
            "rapier3d=folder".to_owned(),
            2,
            "registry, git, path".to_owned(),
        ),
    ] {
        let mut arguments = vec!["slide"];
        for wanted in wanted.split(' ') {
            arguments.extend(["--built-from", wanted]);
        }
        let output = alone(empty.path(), &arguments);
        let told = said(&output)
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ");
        assert_eq!(output.status.code(), Some(code), "{wanted}: {told}");
        assert!(told.contains(&words), "{wanted}: {told}");
    }
}

/// What the engines are built from, as `--built-from` says it.
fn engine_sources() -> String {
    let built = crate::support::roster()
        .iter()
        .flat_map(|engine| engine.built());
    let sources = built.map(|built| format!("{}={}", built.name, built.word()));
    sources.collect::<Vec<_>>().join(" ")
}
