//! Exit codes: commands against situations, and one sentence about them wherever they are told.

use assert_cmd::Command;
use carom::cli::exit::{Exit, sentence};
use std::path::Path;
use std::process::Output;

fn carom(arguments: &str, folder: &Path) -> Output {
    let out = folder.to_str().unwrap();
    let arguments: Vec<String> = arguments
        .split_whitespace()
        .map(|word| word.replace("OUT", out))
        .collect();
    Command::cargo_bin("carom")
        .unwrap()
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(arguments)
        .output()
        .unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn in_one_line(words: &str) -> String {
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// `head-on` is a scene of the catalogue; `pool-break` has cushions that rapier lacks; dt = -1 is refused by every engine that steps, and
/// `exact` knows no dt.
const TABLE: &[(&str, Exit, &str, &str)] = &[
    // a divergence, an ending, refusals
    (
        "run head-on --engine exact --out OUT/run",
        Exit::Finished,
        "ran for 4 s",
        "a run to its end",
    ),
    (
        "run report-break --engine exact --max-events 3 --out OUT/few",
        Exit::Finished,
        "budget",
        "an ending",
    ),
    (
        "run report-break-frozen --engine exact --out OUT/ind",
        Exit::Finished,
        "indeterminate",
        "an ending",
    ),
    (
        "run head-on --engine stepper --set dt=-1 --out OUT/refused",
        Exit::CouldNotRun,
        "dt",
        "its one engine refuses",
    ),
    (
        "run pool-break --engine rapier-f64 --out OUT/lacks",
        Exit::CouldNotRun,
        "cannot simulate",
        "its one engine lacks something",
    ),
    (
        "compare head-on --engines exact,stepper",
        Exit::Finished,
        "stepper",
        "all run",
    ),
    (
        "compare head-on --engines stepper,rapier-f64:dt=-1",
        Exit::Finished,
        "rapier-f64 dt=-1",
        "one of several refuses",
    ),
    (
        "compare head-on --engines stepper:dt=-1,exact:precision=f8",
        Exit::Finished,
        "stepper dt=-1",
        "all refuse",
    ),
    (
        "compare pool-break --engines rapier-f64",
        Exit::Finished,
        "cannot simulate",
        "one of several lacks something",
    ),
    (
        "report head-on --engines stepper:dt=-1,exact --out OUT/report",
        Exit::Finished,
        "dt",
        "one of several refuses",
    ),
    (
        "report head-on --engines stepper:dt=-1,exact:precision=f8 --out OUT/none",
        Exit::Finished,
        "dt",
        "all refuse",
    ),
    (
        "cost head-on --engines exact,stepper:dt=-1 --out OUT/cost",
        Exit::Finished,
        "does not run",
        "one of several refuses",
    ),
    (
        "cost head-on --engines stepper:dt=-1 --out OUT/cost",
        Exit::Finished,
        "does not run",
        "all refuse",
    ),
    (
        "effects draw --engines exact,rapier-f64:dt=-1",
        Exit::Finished,
        "refused",
        "one of several refuses",
    ),
    (
        "effects draw --engines exact:precision=f8",
        Exit::Finished,
        "f8",
        "all refuse",
    ),
    (
        "effects --curves --engines stepper:dt=-1",
        Exit::Finished,
        "dt",
        "all refuse",
    ),
    (
        "ensemble head-on --samples 4 --engines exact,stepper:dt=-1",
        Exit::Finished,
        "refused 4",
        "one of several refuses",
    ),
    (
        "ensemble head-on --samples 4 --engines stepper:dt=-1",
        Exit::Finished,
        "refused 4",
        "all refuse",
    ),
    (
        "fuzz --scenes 2 --engines exact,stepper:dt=-1",
        Exit::Finished,
        "refused",
        "one of several refuses",
    ),
    (
        "fuzz --scenes 2",
        Exit::Finished,
        "held",
        "nothing is found",
    ),
    (
        "fuzz --inputs 20",
        Exit::Finished,
        "read",
        "nothing is found",
    ),
    (
        "horizon head-on",
        Exit::Finished,
        "whole shot",
        "it is known",
    ),
    (
        "stability near-miss-1e-2 --engines exact,stepper:dt=-1",
        Exit::Finished,
        "1 cannot be expressed",
        "one of several refuses",
    ),
    (
        "stability near-miss-1e-2 --engines stepper:dt=-1",
        Exit::Finished,
        "1 cannot be expressed",
        "all refuse",
    ),
    (
        "stability near-miss-1e-2 --engines exact",
        Exit::Finished,
        "as accepted",
        "as accepted",
    ),
    (
        "stability near-miss-1e-2 --engines exact,stepper:dt=-1 --accepted OUT/acc",
        Exit::CouldNotRun,
        "nothing is accepted",
        "no baseline",
    ),
    (
        "check head-on",
        Exit::Finished,
        "everything is as accepted",
        "as accepted",
    ),
    ("engines", Exit::Finished, "stepper", "a list"),
    ("scene list", Exit::Finished, "head-on", "a list"),
    ("scene check head-on", Exit::Finished, "ok", "a scene"),
    (
        "diff OUT/run OUT/run",
        Exit::Finished,
        "nothing differs",
        "the same",
    ),
    // an expectation is not met
    (
        "diff OUT/run OUT/other",
        Exit::NotMet,
        "Beyond tolerance",
        "not the same",
    ),
    // it could not run
    (
        "check head-on --baseline OUT/nowhere",
        Exit::CouldNotRun,
        "nothing is accepted of head-on",
        "no baseline",
    ),
    (
        "stability near-miss-1e-2 --engines exact --accepted OUT/nowhere",
        Exit::CouldNotRun,
        "nothing is accepted",
        "no baseline",
    ),
    (
        "diff OUT/run OUT/nowhere",
        Exit::CouldNotRun,
        "cannot read",
        "no such folder",
    ),
    (
        "diff OUT/run OUT/few",
        Exit::CouldNotRun,
        "different scenes",
        "nothing to compare",
    ),
    (
        "run nowhere --engine exact --out OUT/x",
        Exit::CouldNotRun,
        "nowhere",
        "no such scene",
    ),
    (
        "run head-on --engine none --out OUT/x",
        Exit::CouldNotRun,
        "none",
        "no such engine",
    ),
    (
        "compare head-on --engines none",
        Exit::CouldNotRun,
        "no engine is called",
        "no such engine",
    ),
    (
        "compare head-on --engines stepper:dt",
        Exit::CouldNotRun,
        "dt",
        "no setting at all",
    ),
    (
        "cost head-on --engines stepper:dt",
        Exit::CouldNotRun,
        "dt",
        "no setting at all",
    ),
    (
        "report head-on --engines stepper,stepper --out OUT/x",
        Exit::CouldNotRun,
        "twice",
        "bad usage",
    ),
    (
        "effects head-on --engines none",
        Exit::CouldNotRun,
        "no engine is called",
        "no such engine",
    ),
    (
        "ensemble head-on --samples 0",
        Exit::CouldNotRun,
        "samples",
        "bad usage",
    ),
    (
        "horizon pool-break --precision f256",
        Exit::CouldNotRun,
        "f256",
        "bad usage",
    ),
    (
        "fuzz --engines none",
        Exit::CouldNotRun,
        "no engine is called",
        "no such engine",
    ),
    (
        "scene check OUT/nowhere.toml",
        Exit::CouldNotRun,
        "no such file",
        "no scene",
    ),
    (
        "scene generate --balls 3 --density 7",
        Exit::CouldNotRun,
        "density",
        "no scene",
    ),
    ("nonsense", Exit::CouldNotRun, "nonsense", "bad usage"),
    ("--help", Exit::Finished, "Exit codes", "help"),
];

#[test]
fn every_situation_has_its_code_and_its_words() {
    let folder = tempfile::tempdir().unwrap();
    // what one of the rows is held against
    let other = "run head-on --engine stepper --out OUT/other";
    assert_eq!(carom(other, folder.path()).status.code(), Some(0));
    let mut wrong = Vec::new();
    for (arguments, exit, words, why) in TABLE {
        let output = carom(arguments, folder.path());
        let (out, err) = (text(&output.stdout), text(&output.stderr));
        let all = in_one_line(&(out + &err));
        if output.status.code() != Some(exit.code().into()) || !all.contains(words) {
            let code = output.status.code();
            wrong.push(format!(
                "`{arguments}` ({why}): {code:?}, no {} with `{words}`: {all}",
                exit.code()
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
    for nothing in ["refused", "lacks", "x", "nowhere"] {
        assert!(!folder.path().join(nothing).exists(), "{nothing}");
    }
    for exit in [Exit::Finished, Exit::NotMet, Exit::CouldNotRun] {
        assert!(TABLE.iter().any(|row| row.1 == exit), "{exit:?}");
    }
}

#[test]
fn help_and_readme_tell_every_code_in_the_words_of_one_list() {
    let sentence = in_one_line(&sentence());
    for exit in Exit::ALL {
        let part = format!("{} {}", exit.code(), in_one_line(exit.when()));
        assert!(sentence.contains(&part), "{part}");
    }
    let help = carom("--help", Path::new("."));
    let help = in_one_line(&text(&help.stdout));
    assert!(help.contains(&sentence), "{help}");
    let readme = include_str!("../../../README.md");
    assert!(in_one_line(readme).contains(&sentence), "{sentence}");
}
