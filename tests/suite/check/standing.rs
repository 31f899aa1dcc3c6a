//! What a check says of scenes of which nothing is accepted, of files that no scene reads, and of what stands above the findings.

use super::{accept, check, command, said};
use std::fs;
use std::path::Path;

fn words(output: &std::process::Output) -> String {
    let said = said(output);
    said.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The row of a scene in a table of words.
fn row<'a>(text: &'a str, scene: &str) -> &'a str {
    let mut rows = text.lines().filter(|line| {
        let start = line.trim_start_matches(['|', ' ', '"']);
        start
            .strip_prefix(scene)
            .is_some_and(|rest| rest.starts_with([' ', ',']))
    });
    rows.next().unwrap_or_else(|| panic!("{scene}: {text}"))
}

#[test]
fn a_scene_without_a_baseline_is_never_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let baselines = folder.path().join("baselines");
    let junit = folder.path().join("junit.xml");
    // of one scene something is accepted, of the other nothing; then of neither
    accept(&baselines, &["slide"]);
    for known in [true, false] {
        if !known {
            fs::remove_file(baselines.join("slide.csv")).unwrap();
        }
        for format in ["text", "markdown", "csv", "json"] {
            let arguments = ["slide", "head-on", "--format", format];
            let output = check(&baselines, &arguments);
            let text = String::from_utf8(output.stdout.clone()).unwrap();
            assert_eq!(output.status.code(), Some(2), "{format}: {text}");
            if format == "json" {
                let lone = "\"no baseline\"";
                let empty = if known { 1 } else { 2 } * 3;
                assert_eq!(text.matches(lone).count(), empty, "{text}");
                assert_eq!(text.contains("\"same\""), known, "{text}");
                continue;
            }
            let of_known = row(&text, "slide");
            assert_eq!(of_known.contains("same"), known, "{format}: {of_known}");
            assert_eq!(
                of_known.contains("no baseline"),
                !known,
                "{format}: {of_known}"
            );
            let of_other = row(&text, "head-on");
            assert!(!of_other.contains("same"), "{format}: {of_other}");
            assert_eq!(
                of_other.matches("no baseline").count(),
                3,
                "{format}: {of_other}"
            );
        }
        let arguments = ["slide", "head-on", "--junit", junit.to_str().unwrap()];
        check(&baselines, &arguments);
        let xml = fs::read_to_string(&junit).unwrap();
        let document = roxmltree::Document::parse(&xml).unwrap();
        for case in document
            .descendants()
            .filter(|n| n.has_tag_name("testcase"))
        {
            let of = case.attribute("classname").unwrap();
            let failed = case.children().any(|n| n.has_tag_name("failure"));
            assert_eq!(failed, of == "carom.head-on" || !known, "{of}");
        }
    }
}

#[test]
fn a_baseline_that_no_scene_reads_fails_and_junit_says_so() {
    // the whole set is needed for a file to be nobody's; the accepted ones are met
    let folder = tempfile::tempdir().unwrap();
    let baselines = folder.path().join("baselines");
    fs::create_dir(&baselines).unwrap();
    for entry in fs::read_dir(super::baselines()).unwrap() {
        let path = entry.unwrap().path();
        fs::copy(&path, baselines.join(path.file_name().unwrap())).unwrap();
    }
    fs::copy(baselines.join("slide.csv"), baselines.join("gone.csv")).unwrap();
    let junit = folder.path().join("junit.xml");
    let output = check(&baselines, &["--junit", junit.to_str().unwrap()]);
    let said = words(&output);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("read by no scene: "), "{said}");
    let xml = fs::read_to_string(&junit).unwrap();
    let document = roxmltree::Document::parse(&xml).unwrap();
    let failures: Vec<_> = document
        .descendants()
        .filter(|n| n.has_tag_name("failure"))
        .collect();
    let [failure] = &failures[..] else {
        panic!("{xml}");
    };
    assert!(failure.text().unwrap().contains("gone.csv: remove it"));
}

/// The accepted file of a scene with one line in the place of another, and what a check says of it.
fn with(folder: &Path, good: &str, old: &str, new: &str) -> (Option<i32>, String) {
    assert!(good.contains(old), "{old}");
    fs::write(folder.join("slide.csv"), good.replacen(old, new, 1)).unwrap();
    let output = check(folder, &["slide"]);
    (output.status.code(), words(&output))
}

#[test]
fn every_line_above_the_findings_is_held_or_told() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    accept(folder, &["slide"]);
    let good = fs::read_to_string(folder.join("slide.csv")).unwrap();
    let line = |start: &str| {
        let mut lines = good.lines().filter(|line| line.starts_with(start));
        lines
            .next()
            .unwrap_or_else(|| panic!("{start}: {good}"))
            .to_owned()
            + "\n"
    };
    let digest = line("# bits of stepper: ");
    let carom = line("# version of carom: ");
    let rapier = line("# version of rapier-f64: ");
    let target = line("# version of target: ");
    let compiler = line("# version of compiler: ");
    let reason = line("# reason: ");
    for (old, new, code, expected) in [
        ("", String::new(), 0, "everything is as accepted"),
        (
            "# scene: slide",
            "# scene: head-on".into(),
            1,
            "the file of slide says that it is of head-on",
        ),
        (
            "# hash: ",
            "# hash: 0".into(),
            1,
            "changed since they were accepted: slide",
        ),
        (&reason, "# reason: \n".into(), 2, "lack `# reason"),
        (
            &carom,
            "# version of carom: 0.0.9\n".into(),
            0,
            "accepted of other versions: carom was 0.0.9 and is ",
        ),
        (
            &rapier,
            "# version of rapier-f64: a fork\n".into(),
            0,
            "rapier-f64 was a fork and is ",
        ),
        (&rapier, String::new(), 0, "and was not told"),
        (
            &target,
            "# version of target: abacus\n".into(),
            0,
            "target was abacus and is ",
        ),
        (
            &compiler,
            "# version of compiler: rustc 1.0\n".into(),
            0,
            "compiler was rustc 1.0 and is ",
        ),
        (
            &carom,
            format!("{carom}# version of havok: 1\n"),
            0,
            "havok was 1 and is not there",
        ),
        (
            &digest,
            String::new(),
            1,
            "the file of slide lacks the bits of stepper",
        ),
        (
            &digest,
            "# bits of steppes: 0123456789abcdef\n".into(),
            1,
            "has the bits of steppes, of which there is no run",
        ),
        (
            &digest,
            "# bits of stepper: 0123456789abcdef\n".into(),
            0,
            "1 the same physics in different bits",
        ),
        (
            &digest,
            "# bits of stepper: 0123\n".into(),
            2,
            "is no digest",
        ),
        (&digest, format!("{digest}{digest}"), 2, "listed twice"),
        (
            "stepper,work,",
            "stepper dt=7,work,".into(),
            1,
            "is no longer found",
        ),
    ] {
        let (got, said) = with(folder, &good, old, &new);
        assert_eq!(got, Some(code), "{old} became {new}: {said}");
        assert!(said.contains(expected), "{old} became {new}: {said}");
    }
    // a file that contradicts itself is written anew when its findings are accepted
    fs::write(folder.join("slide.csv"), good.replace(&digest, "")).unwrap();
    accept(folder, &["slide"]);
    let again = fs::read_to_string(folder.join("slide.csv")).unwrap();
    assert!(again.contains(&digest), "{again}");
}

#[test]
fn a_finding_of_an_engine_that_is_no_more_has_a_failing_case() {
    let folder = tempfile::tempdir().unwrap();
    let baselines = folder.path().join("baselines");
    accept(&baselines, &["slide"]);
    let file = baselines.join("slide.csv");
    let good = fs::read_to_string(&file).unwrap();
    fs::write(&file, good + "havok,work,steps,7.0,\n").unwrap();
    let junit = folder.path().join("junit.xml");
    let output = command(&baselines, &["slide", "--junit", junit.to_str().unwrap()])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    let xml = fs::read_to_string(&junit).unwrap();
    assert!(xml.contains("work steps in havok of slide: was 7"), "{xml}");
    let text = said(&output);
    assert!(row(&text, "slide").contains("1 changed"), "{text}");
}
