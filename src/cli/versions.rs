//! What gave accepted findings: program, engines, target, compiler, commit.

use crate::engine::Roster;
use std::process::Command;

/// Names and versions, without compiler and commit.
pub fn of_engines(roster: &Roster) -> Vec<(String, String)> {
    let own = ("carom".to_owned(), env!("CARGO_PKG_VERSION").to_owned());
    let target = format!("{} {}", std::env::consts::ARCH, std::env::consts::OS);
    let engines = roster
        .iter()
        .map(|engine| (engine.id().to_owned(), engine.version()));
    std::iter::once(own)
        .chain(engines)
        .chain([("target".to_owned(), target)])
        .collect()
}

/// The same with the compiler that made the program.
pub fn with_compiler(roster: &Roster) -> Vec<(String, String)> {
    let mut versions = of_engines(roster);
    let compiler = env!("CAROM_COMPILER");
    versions.push(("compiler".to_owned(), compiler.to_owned()));
    versions.retain(|(_, version)| !version.is_empty());
    versions
}

/// The same with the commit of the current folder where there is one.
pub fn with_commit(roster: &Roster) -> Vec<(String, String)> {
    let mut versions = with_compiler(roster);
    let said = Command::new("git")
        .args(["rev-parse", "--short=12", "HEAD"])
        .output();
    let commit = said.ok().filter(|said| said.status.success());
    let commit = commit.map(|said| String::from_utf8_lossy(&said.stdout).trim().to_owned());
    versions.extend(commit.map(|commit| ("commit".to_owned(), commit)));
    versions.retain(|(_, version)| !version.is_empty());
    versions
}
