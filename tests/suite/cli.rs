//! The program as other programs meet it: exit codes, streams, files.

use assert_cmd::Command;
use carom::trace::files::{Files, read};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Output;

fn carom(arguments: &[&str]) -> Output {
    Command::cargo_bin("carom")
        .unwrap()
        .args(arguments)
        .output()
        .unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn files_in(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn run_writes_four_files_that_read_back_as_the_same_trace() {
    let folder = tempfile::tempdir().unwrap();
    for engine in ["stepper", "exact", "rapier-f64"] {
        let out = folder.path().join(engine);
        let output = carom(&[
            "run",
            "head-on",
            "--engine",
            engine,
            "--out",
            out.to_str().unwrap(),
        ]);
        assert_eq!(
            output.status.code(),
            Some(0),
            "{engine}: {}",
            text(&output.stderr)
        );
        assert_eq!(
            files_in(&out),
            ["events.csv", "final.csv", "run.json", "samples.csv"],
            "{engine}"
        );
        let file = |name: &str| fs::read_to_string(out.join(name)).unwrap();
        let written = Files {
            events: file("events.csv"),
            samples: file("samples.csv"),
            final_states: file("final.csv"),
            run: file("run.json"),
        };
        let trace = read(&written).unwrap();
        assert_eq!(trace.provenance.engine, engine);
        assert_eq!(
            carom::trace::files::write(&trace).unwrap(),
            written,
            "{engine}: not the same files again"
        );
        let header = |name: &str| file(name).lines().next().unwrap().to_owned();
        assert_eq!(
            header("events.csv"),
            "index,time,kind,a,b,exchanges,margin,condition,time_error"
        );
        // the exact engine knows how certain its events are
        let certain = trace.certainty.iter().filter(|c| c.time_error.is_some());
        let expected = if engine == "exact" {
            trace.events.len()
        } else {
            0
        };
        assert_eq!(certain.count(), expected, "{engine}");
        assert_eq!(
            header("samples.csv"),
            "time,ball,x,y,z,vx,vy,vz,wx,wy,wz,event"
        );
        assert_eq!(
            header("final.csv"),
            "ball,x,y,z,vx,vy,vz,wx,wy,wz,stop_time"
        );
    }
}

#[test]
fn two_runs_write_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str| {
        let out = folder.path().join(name);
        assert!(
            carom(&[
                "run",
                "three-ball",
                "--engine",
                "rapier-f32",
                "--out",
                out.to_str().unwrap()
            ])
            .status
            .success()
        );
        files_in(&out)
            .into_iter()
            .map(|file| fs::read(out.join(file)).unwrap())
            .collect::<Vec<_>>()
    };
    assert_eq!(write("a"), write("b"));
}

#[test]
fn a_budget_of_events_ends_a_run_and_says_where() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("few");
    let output = carom(&[
        "run",
        "report-break",
        "--engine",
        "exact",
        "--max-events",
        "5",
        "--out",
        out.to_str().unwrap(),
    ]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    assert!(
        printed.contains("budget") && printed.contains("limit of 5 events"),
        "{printed}"
    );
    let events = fs::read_to_string(out.join("events.csv")).unwrap();
    assert_eq!(events.lines().count(), 1 + 5, "{events}");
    let run: Value =
        serde_json::from_str(&fs::read_to_string(out.join("run.json")).unwrap()).unwrap();
    assert_eq!(run["ending"]["kind"], "budget");
    assert_eq!(run["ending"]["spot"]["time"], run["end_time"]);
    assert!(
        !run["ending"]["spot"]["balls"]
            .as_array()
            .unwrap()
            .is_empty()
    );
}

#[test]
fn what_cannot_run_ends_with_2_and_says_why_on_stderr() {
    let out = tempfile::tempdir().unwrap();
    let out = out.path().join("x");
    let out = out.to_str().unwrap();
    for (arguments, wanted) in [
        (vec!["compare", "report-brake"], "report-break"),
        (vec!["compare", "no/such/file.toml"], "no such file"),
        (
            vec!["compare", "slide", "--engines", "jolt"],
            "there are stepper, exact, rapier-f64, rapier-f32",
        ),
        (
            vec!["compare", "slide", "--engines", "stepper,stepper"],
            "listed twice",
        ),
        (vec!["compare", "slide", "--format", "pdf"], "json"),
        (
            vec![
                "run", "slide", "--engine", "stepper", "--set", "dt=0", "--out", out,
            ],
            "expected a step above 0",
        ),
        (
            vec![
                "run", "slide", "--engine", "stepper", "--set", "dt", "--out", out,
            ],
            "KEY=VALUE",
        ),
        (
            vec![
                "run",
                "slide",
                "--engine",
                "rapier-f64",
                "--set",
                "drag=1",
                "--out",
                out,
            ],
            "known are",
        ),
        (
            vec![
                "run", "slide", "--engine", "exact", "--every", "0", "--out", out,
            ],
            "above 0 s",
        ),
        (vec!["run", "slide", "--out", out], "--engine"),
        (vec!["horizon", "slide", "--precision", "f256"], "f64"),
        (vec!["horizon", "no/such/file.toml"], "no such file"),
        (vec!["juggle"], "juggle"),
    ] {
        let output = carom(&arguments);
        assert_eq!(
            output.status.code(),
            Some(2),
            "{arguments:?}: {}",
            text(&output.stdout)
        );
        let said = text(&output.stderr);
        assert!(said.contains(wanted), "{arguments:?}: {said}");
        assert!(output.stdout.is_empty(), "{arguments:?}: wrote to stdout");
    }
    assert!(!Path::new(out).exists(), "a run that failed left files");
}

#[test]
fn compare_names_the_first_difference_and_its_cause_in_every_format() {
    let shown = |format: &str| {
        let output = carom(&[
            "compare",
            "six-balls",
            "--format",
            format,
            "--engines",
            "stepper,rapier-f64",
        ]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    for format in ["text", "markdown", "csv", "json"] {
        let shown = shown(format);
        for wanted in ["stepper", "rapier-f64", "exact", "strict", "unexplained"] {
            assert!(shown.contains(wanted), "{format} lacks {wanted}: {shown}");
        }
    }
    let json: Value = serde_json::from_str(&shown("json")).unwrap();
    assert!(json.is_object());
    assert!(
        shown("text")
            .lines()
            .all(|line| line.chars().count() <= 100)
    );
}

#[test]
fn horizon_prints_in_every_format_and_writes_a_page_where_it_is_told_to() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("horizon");
    let shown = |format: &str| {
        let arguments = ["horizon", "discs-in-a-box", "--format", format, "--out"];
        let output = carom(&[&arguments[..], &[out.to_str().unwrap()]].concat());
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    for format in ["text", "markdown", "csv", "json"] {
        let shown = shown(format);
        for wanted in ["margin", "condition", "growth", "beyond"] {
            assert!(shown.contains(wanted), "{format} lacks {wanted}: {shown}");
        }
    }
    let json: Value = serde_json::from_str(&shown("json")).unwrap();
    assert!(json.is_object());
    let wide = |line: &str| line.chars().count() > 100;
    assert!(!shown("text").lines().any(wide), "{}", shown("text"));
    assert!(files_in(&out).contains(&"index.html".to_owned()));
}

#[test]
fn scenes_without_an_answer_compare_the_engines_with_each_other() {
    let output = carom(&[
        "compare",
        "report-break-frozen",
        "--engines",
        "stepper,stepper:contact=approaching-only",
    ]);
    let shown = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0));
    assert!(shown.contains("indeterminate"), "{shown}");
    assert!(
        shown.contains("stepper | stepper contact=approaching-only"),
        "{shown}"
    );
}

#[test]
fn report_writes_a_site_that_needs_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("report");
    let output = carom(&["report", "slide", "head-on", "--out", out.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let page =
        |name: &str| fs::read_to_string(out.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
    let index = page("index.html");
    for wanted in [
        "What the report got wrong",
        "slide",
        "head-on",
        "pages/slide.html",
        &crate::support::find("rapier-f64").unwrap().version(),
    ] {
        assert!(index.contains(wanted), "index.html lacks {wanted}");
    }
    for text in [&index, &page("pages/head-on.html")] {
        for outside in ["http://", "https://", "src=\"//", "@import"] {
            // the namespaces of SVG and HTML, which the script of the replay names too, are names and not addresses
            let text = text
                .replace("http://www.w3.org/2000/svg", "")
                .replace("http://www.w3.org/1999/xhtml", "");
            assert!(!text.contains(outside), "a page names {outside}");
        }
    }
    let json: Value = serde_json::from_str(&page("report.json")).unwrap();
    assert!(json.is_object());
    assert!(page("report.md").contains("What the report got wrong"));
}

#[test]
fn lists_derive_from_the_registries() {
    let engines = text(&carom(&["engines"]).stdout);
    for engine in crate::support::roster() {
        assert!(engines.contains(engine.id()));
        for knob in engine.knobs() {
            assert!(engines.contains(&knob.key), "{}", knob.key);
            assert!(
                !knob.what.is_empty(),
                "{} of {} has no meaning",
                knob.key,
                engine.id()
            );
        }
    }
    let scenes: Value =
        serde_json::from_slice(&carom(&["scene", "list", "--format", "json"]).stdout).unwrap();
    for entry in carom::scene::catalogue::all() {
        assert!(scenes.to_string().contains(entry.name), "{}", entry.name);
    }
    assert!(text(&carom(&["completions", "bash"]).stdout).contains("carom"));
    assert_eq!(carom(&["--version"]).status.code(), Some(0));
    assert_eq!(carom(&["--help"]).status.code(), Some(0));
}

#[test]
fn fuzz_exits_with_one_when_something_breaks_and_saves_the_scenes_that_show_it() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("found");
    let saved = ["--save", out.to_str().unwrap()];
    let holds = carom(&[&["fuzz", "--scenes", "20"], &saved[..]].concat());
    assert_eq!(holds.status.code(), Some(0), "{}", text(&holds.stdout));
    assert!(text(&holds.stdout).contains("held in 20 of 20 random scenes"));
    assert!(files_in(&out).is_empty());
    // 24 bits do not hold what 53 are held to
    let narrow = ["--scenes", "30", "--engines", "exact:precision=f32"];
    let breaks = carom(&[&["fuzz"], &narrow[..], &saved[..]].concat());
    assert_eq!(breaks.status.code(), Some(1), "{}", text(&breaks.stdout));
    let names = files_in(&out);
    assert!(!names.is_empty());
    for name in names {
        // a saved scene is a scene, the one that `--show` prints
        let index = name
            .trim_start_matches("random-1-")
            .trim_end_matches(".toml");
        let shown = carom(&["fuzz", "--show", index]);
        assert_eq!(shown.stdout, fs::read(out.join(&name)).unwrap(), "{name}");
        let path = out.join(&name);
        let checked = carom(&["scene", "check", path.to_str().unwrap()]);
        assert_eq!(checked.status.code(), Some(0), "{}", text(&checked.stderr));
    }
    let read = carom(&["fuzz", "--inputs", "200"]);
    assert_eq!(read.status.code(), Some(0), "{}", text(&read.stdout));
}
