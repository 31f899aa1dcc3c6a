//! `carom check` as CI meets it: exit codes and files.

use super::{SCENES, accept, baselines, check, command, said};
use crate::accepting::kill_while_accepting;
use std::fs;

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
            words.contains("bits: 15 runs the same, 0 the same"),
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
