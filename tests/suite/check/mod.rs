//! `carom check`: its levels, its baselines, the program, what pipelines read.

mod baselines;
mod columns;
mod diff;
mod levels;
mod outputs;
mod program;
mod random;
mod standing;

use assert_cmd::cargo::cargo_bin;
use std::path::Path;
use std::process::{Command, Output};

/// Scenes that take a moment in every engine; the last one is hard.
const SCENES: [&str; 3] = ["slide", "head-on", "through-a-ball"];

/// The program on a folder of baselines, outside any pipeline.
fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(cargo_bin("carom"));
    command.arg("check").args(arguments);
    command.arg("--baseline").arg(folder);
    command
        .env_remove("GITHUB_ACTIONS")
        .env_remove("GITHUB_STEP_SUMMARY");
    command
}

fn check(folder: &Path, arguments: &[&str]) -> Output {
    command(folder, arguments).output().unwrap()
}

fn accept(folder: &Path, scenes: &[&str]) {
    let arguments = [scenes, &["--accept", "--reason", "for a test"]].concat();
    let output = check(folder, &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
}

/// Everything that a run printed.
fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

/// The baselines of the repository.
fn baselines() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("validation/baselines")
}
