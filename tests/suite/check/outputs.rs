//! What pipelines read: JUnit XML, Markdown, annotations, JSON.

use super::{accept, check, command, said};
use carom::report::FORMATS;
use roxmltree::{Document, Node};
use std::fs;
use std::path::Path;

/// Baselines of a soft and a hard scene, of which one row is not what is found.
fn with_a_change(folder: &Path) {
    accept(folder, &["slide", "through-a-ball"]);
    let file = folder.join("slide.csv");
    let good = fs::read_to_string(&file).unwrap();
    let steps = good
        .lines()
        .find(|l| l.starts_with("stepper,work,steps,"))
        .unwrap();
    fs::write(&file, good.replacen(steps, "stepper,work,steps,7.0,", 1)).unwrap();
}

/// Attribute of a node as a number.
fn number(node: Node<'_, '_>, name: &str) -> usize {
    let text = node.attribute(name).unwrap_or_else(|| panic!("no {name}"));
    text.parse().unwrap()
}

/// The common schema of JUnit files; see validation/references/README.md.
const SCHEMA: &str = include_str!("../../../validation/references/junit-4.xsd");

/// Holds an element and all below it against the schema: attributes that it may and must have, elements below it and their order.
fn hold(node: Node<'_, '_>, schema: &Document<'_>) {
    let name = node.tag_name().name();
    let mut definitions = schema.root_element().children();
    let definition = definitions
        .find(|d| d.has_tag_name("element") && d.attribute("name") == Some(name))
        .unwrap_or_else(|| panic!("the schema has no <{name}>"));
    let of = |tag| {
        definition
            .descendants()
            .filter(move |d| d.tag_name().name() == tag)
    };
    for attribute in node.attributes() {
        let known = of("attribute").any(|a| a.attribute("name") == Some(attribute.name()));
        assert!(known, "<{name}> may not have {attribute:?}");
    }
    for required in of("attribute").filter(|a| a.attribute("use") == Some("required")) {
        let wanted = required.attribute("name").unwrap();
        assert!(node.has_attribute(wanted), "<{name}> has no {wanted}");
    }
    let order: Vec<&str> = of("element").filter_map(|e| e.attribute("ref")).collect();
    let mut reached = 0;
    for child in node.children().filter(Node::is_element) {
        let inside = child.tag_name().name();
        let place = order.iter().position(|known| *known == inside);
        let place = place.unwrap_or_else(|| panic!("<{name}> may not hold <{inside}>"));
        assert!(place >= reached, "<{inside}> comes too late in <{name}>");
        reached = place;
        hold(child, schema);
    }
}

/// Holds a file against the schema, and its counts against what they count.
fn valid(text: &str) -> Document<'_> {
    let document = Document::parse(text).unwrap();
    let root = document.root_element();
    assert_eq!(root.tag_name().name(), "testsuites");
    hold(root, &Document::parse(SCHEMA).unwrap());
    let (mut tests, mut failures, mut errors) = (0, 0, 0);
    for suite in root.children().filter(Node::is_element) {
        let cases: Vec<Node<'_, '_>> = suite.children().filter(Node::is_element).collect();
        assert!(!cases.is_empty());
        for case in &cases {
            for name in ["name", "classname"] {
                assert!(case.attribute(name).is_some_and(|text| !text.is_empty()));
            }
            let inside: Vec<Node<'_, '_>> = case.children().filter(Node::is_element).collect();
            assert!(inside.len() <= 1, "one outcome a case");
            for outcome in inside {
                let words = outcome.attribute("message").or(outcome.text());
                assert!(words.is_some_and(|words| !words.is_empty()));
            }
        }
        let of = |name: &str| {
            let own = cases
                .iter()
                .filter(|case| case.children().any(|node| node.tag_name().name() == name));
            own.count()
        };
        assert_eq!(number(suite, "tests"), cases.len());
        assert_eq!(number(suite, "failures"), of("failure"));
        assert_eq!(number(suite, "errors"), of("error"));
        assert_eq!(number(suite, "skipped"), of("skipped"));
        tests += cases.len();
        failures += of("failure");
        errors += of("error");
    }
    assert_eq!(number(root, "tests"), tests);
    assert_eq!(number(root, "failures"), failures);
    assert_eq!(number(root, "errors"), errors);
    document
}

#[test]
fn junit_has_one_case_a_scene_engine_and_level_and_says_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("junit.xml");
    let baseline = folder.path().join("baselines");
    with_a_change(&baseline);
    let junit = ["--junit", file.to_str().unwrap()];
    let output = check(
        &baseline,
        &[&["slide", "through-a-ball"], &junit[..]].concat(),
    );
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    let text = fs::read_to_string(&file).unwrap();
    let document = valid(&text);
    // the oracle, five columns on three levels, on four in the hard scene, which asks for seven settings more
    assert_eq!(number(document.root_element(), "tests"), 2 + 15 + 20 + 28);
    let failures: Vec<Node<'_, '_>> = document
        .descendants()
        .filter(|node| node.has_tag_name("failure"))
        .collect();
    let [failure] = &failures[..] else {
        panic!("{text}");
    };
    assert_eq!(
        failure.parent().and_then(|case| case.attribute("name")),
        Some("stepper / work")
    );
    let words = failure.text().unwrap();
    for part in [
        "work steps in stepper of slide: moved, was 7, is ",
        "it may not move",
        "accepted because: for a test (carom ",
        "to see it: carom run slide --engine stepper --out DIR",
        "if it is right: carom check slide --accept --reason",
    ] {
        assert!(words.contains(part), "{part}: {words}");
    }
}

#[test]
fn an_engine_that_refuses_is_skipped_with_its_reason() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("junit.xml");
    let baseline = folder.path().join("baselines");
    // rapier has no cushion of a paper
    accept(&baseline, &["bank"]);
    let output = check(&baseline, &["bank", "--junit", file.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let text = fs::read_to_string(&file).unwrap();
    let document = valid(&text);
    let skipped: Vec<&str> = document
        .descendants()
        .filter(|node| node.has_tag_name("skipped"))
        .filter_map(|node| node.text())
        .collect();
    // two of rapier's scalars, on promise and work; that it refuses is held as an error
    assert_eq!(skipped.len(), 4, "{text}");
    assert!(skipped.iter().all(|why| why.contains("cannot simulate")));
}

#[test]
fn a_runner_of_github_gets_a_summary_and_annotations_with_file_and_line() {
    let folder = tempfile::tempdir().unwrap();
    let baseline = folder.path().join("baselines");
    with_a_change(&baseline);
    let job_summary = folder.path().join("job.md");
    fs::write(&job_summary, "before\n").unwrap();
    let markdown = folder.path().join("own.md");
    let own = ["--markdown", markdown.to_str().unwrap()];
    let arguments = [&["slide", "through-a-ball"], &own[..]].concat();
    let output = command(&baseline, &arguments)
        .env("GITHUB_ACTIONS", "true")
        .env("GITHUB_STEP_SUMMARY", &job_summary)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    let own = fs::read_to_string(&markdown).unwrap();
    assert!(own.contains("1 finding differs: 1 moved"), "{own}");
    assert!(own.contains("| slide "), "{own}");
    let job = fs::read_to_string(&job_summary).unwrap();
    assert_eq!(job, format!("before\n{own}"));
    let stderr = String::from_utf8(output.stderr).unwrap();
    let marks: Vec<&str> = stderr.lines().filter(|l| l.starts_with("::")).collect();
    let [mark] = &marks[..] else {
        panic!("{stderr}");
    };
    let rows = fs::read_to_string(baseline.join("slide.csv")).unwrap();
    let line = 1 + rows
        .lines()
        .position(|l| l.starts_with("stepper,work,steps,"))
        .unwrap();
    assert!(
        mark.contains(&format!("slide.csv,line={line},title=")),
        "{mark}"
    );
    assert!(
        mark.contains("::work steps in stepper of slide: moved"),
        "{mark}"
    );
}

#[test]
fn every_format_prints_the_change_and_a_terminal_is_wide_enough() {
    let folder = tempfile::tempdir().unwrap();
    let baseline = folder.path().join("baselines");
    let out = folder.path().join("page");
    with_a_change(&baseline);
    for format in FORMATS {
        let arguments = ["slide", "--verbose", "--format", format.id, "--out"];
        let output = check(
            &baseline,
            &[&arguments[..], &[out.to_str().unwrap()]].concat(),
        );
        assert_eq!(output.status.code(), Some(1), "{}", said(&output));
        let shown = String::from_utf8(output.stdout).unwrap();
        for words in ["moved", "steps", "stepper", "final-position"] {
            assert!(shown.contains(words), "{}: {shown}", format.id);
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
    let page = fs::read_to_string(out.join("index.html")).unwrap();
    for words in ["Every case", "By how much each may move", "2^22 ulp"] {
        assert!(page.contains(words), "{words}");
    }
}

#[test]
fn every_option_in_the_instructions_is_one_of_the_program() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let help = check(root, &["--help"]);
    let help = String::from_utf8(help.stdout).unwrap();
    let mut options = 0;
    for (file, marks) in [
        ("validation/CI.md", &["-- check ", ".ci/fork "][..]),
        (".github/actions/carom-check/run", &["/.ci/fork\" "]),
        (".ci/run", &["installed check "]),
        (".ci/broken-rapier", &["/.ci/fork\" "]),
    ] {
        let text = fs::read_to_string(root.join(file)).unwrap();
        // an action's command goes on in the next line
        let text = text.replace("\\\n", " ");
        for mark in marks {
            let mut found = 0;
            let lines = text.lines().filter_map(|line| line.split_once(mark));
            for (_, own) in lines {
                found += 1;
                for option in own.split(' ').filter(|word| word.starts_with("--")) {
                    options += 1;
                    assert!(help.contains(option), "{file}: {option}");
                }
            }
            assert!(found > 0, "{file} has no command after {mark}");
        }
    }
    assert!(options >= 10, "{options}");
}

#[test]
fn a_fork_is_checked_in_every_crate_that_an_engine_is_built_from() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let built = crate::support::roster().iter().flat_map(|e| e.built());
    let crates: Vec<&str> = built.map(|built| built.name).collect();
    assert_eq!(crates, ["rapier3d-f64", "rapier3d"]);
    let page = fs::read_to_string(root.join("validation/CI.md")).unwrap();
    let action = fs::read_to_string(root.join(".github/actions/carom-check/action.yml")).unwrap();
    let gate = fs::read_to_string(root.join(".ci/run")).unwrap();
    for name in crates {
        let by_action = format!("\n      {name}=");
        assert!(
            page.contains(&by_action),
            "the action's example lacks {name}"
        );
        let by_script = page
            .lines()
            .find(|line| line.starts_with(".ci/fork "))
            .unwrap();
        assert!(by_script.contains(&format!(" {name}=")), "{by_script}");
        assert!(
            action.contains(&format!("{name}=")),
            "the action does not speak of {name}"
        );
        assert!(
            gate.contains(&format!("--built-from {name}=registry")),
            "{name}"
        );
    }
    // each input arrives under the name that the script reads
    let script = fs::read_to_string(root.join(".github/actions/carom-check/run")).unwrap();
    let inputs = action
        .split("inputs:")
        .nth(1)
        .unwrap()
        .split("runs:")
        .next()
        .unwrap();
    let inputs = inputs
        .lines()
        .filter(|l| l.starts_with("  ") && !l.starts_with("   "));
    let mut read = 0;
    for input in inputs.map(|line| line.trim().trim_end_matches(':')) {
        let variable = input.to_uppercase();
        let given = format!("{variable}: ${{{{ inputs.{input} }}}}\n");
        assert!(action.contains(&given), "{input} is not handed on");
        assert!(
            script.contains(&format!("${{{variable}:-")),
            "{input} is not read"
        );
        read += 1;
    }
    assert!(read >= 4, "{read} inputs");
}

#[test]
fn a_ball_whatever_it_is_called_is_words_to_a_pipeline() {
    const ID: &str = "<b>|&%0A::error::\u{202e}x";
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let (scene, baseline) = (path("ids.toml"), path("baselines"));
    let text = format!(
        "name = \"ids\"\nduration = 2.0\ngravity = 9.81\n[ball]\nradius = 0.1\nmass = 1.0\n[[balls]]\nid = '{ID}'\n\
         position = [0.0, 0.0]\nvelocity = [1.0, 0.0]\n[effects.cloth.translational]\nmu = 0.2\n"
    );
    fs::write(&scene, text).unwrap();
    let scene = scene.to_str().unwrap();
    accept(&baseline, &[scene]);
    let file = baseline.join("ids.csv");
    let good = fs::read_to_string(&file).unwrap();
    // to the bit in the file
    let row = good
        .lines()
        .find(|line| line.starts_with("stepper,") && line.contains(ID))
        .unwrap_or_else(|| panic!("no row names the ball:\n{good}"));
    let (head, _) = row.split_once(ID).unwrap();
    let rest = row[head.len() + ID.len()..].splitn(3, ',').nth(2).unwrap();
    let changed = format!("{head}{ID},12345.0,{rest}");
    fs::write(&file, good.replacen(row, &changed, 1)).unwrap();
    let (junit, markdown) = (path("junit.xml"), path("own.md"));
    let files = [
        "--junit",
        junit.to_str().unwrap(),
        "--markdown",
        markdown.to_str().unwrap(),
    ];
    let output = command(&baseline, &[&[scene][..], &files].concat())
        .env("GITHUB_ACTIONS", "true")
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert!(!said(&output).contains('\u{202e}'), "{}", said(&output));
    let shown = ID.replace('\u{202e}', "\\u{202e}");
    let xml = fs::read_to_string(&junit).unwrap();
    let document = valid(&xml);
    let mut failures = document
        .descendants()
        .filter(|node| node.has_tag_name("failure"));
    assert!(
        failures.any(|node| node.text().is_some_and(|words| words.contains(&shown))),
        "{xml}"
    );
    let summary = fs::read_to_string(&markdown).unwrap();
    assert!(summary.contains("\\<b>\\|\\&%0A"), "{summary}");
    assert!(!summary.contains('\u{202e}'), "{summary:?}");
    let stderr = String::from_utf8(output.stderr).unwrap();
    let marks: Vec<&str> = stderr
        .lines()
        .filter(|line| line.starts_with("::"))
        .collect();
    assert_eq!(marks.len(), 1, "{stderr}");
    assert!(marks[0].contains("<b>|&%250A::error::"), "{}", marks[0]);
}
