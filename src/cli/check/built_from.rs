//! What the engines of a check were built from: said, and held to what the user wants.

use crate::cli::Failure;
use crate::engine::{Built, Roster, built};

/// Where a crate can come from, as `--built-from` says it.
const SOURCES: [&str; 3] = ["registry", "git", "path"];

/// What the engines are, whose findings these are.
pub fn sentence(roster: &Roster) -> String {
    let built = roster.iter().flat_map(|engine| engine.built());
    let built: Vec<String> = built.map(|built| built.to_string()).collect();
    format!("Built with {}.", built.join(", "))
}

/// Refuses to hold engines that were built from other sources than the user says. Each of `wanted`: `CRATE=SOURCE`.
pub fn demand(roster: &Roster, wanted: &[String]) -> Result<(), Failure> {
    for wanted in wanted {
        let usage = || {
            let sources = SOURCES.join(", ");
            Failure::Message(format!(
                "`--built-from {wanted}`: expected CRATE=SOURCE with a source of {sources}"
            ))
        };
        let (name, source) = wanted.split_once('=').ok_or_else(usage)?;
        if !SOURCES.contains(&source) {
            return Err(usage());
        }
        let engines = roster.iter().flat_map(|engine| engine.built());
        let mut found: Vec<Built> = engines.filter(|built| built.name == name).collect();
        if found.is_empty() {
            found = built::locked(name);
        }
        if found.is_empty() {
            let message = format!("`--built-from {wanted}`: no engine needs a crate {name}");
            return Err(Failure::Message(message));
        }
        if let Some(other) = found.iter().find(|built| built.word() != source) {
            return Err(Failure::Message(format!(
                "this program was not built with {name} from `{source}`: it has {other}. Cargo leaves a patch out whose folder has \
                 another version than the one that is asked for, and only warns that it `was not used in the crate graph`",
            )));
        }
    }
    Ok(())
}
