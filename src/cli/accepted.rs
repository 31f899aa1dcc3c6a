//! Accepted findings as files: what `check` and `stability` do alike with them.

use super::exit::Exit;
use super::{Failure, output, scene, terminal};
use crate::gate::{self, Accepted, Refused};
use crate::scene::Scene;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// A terminal shows no more changes than this.
pub const MOST_CHANGES: usize = 40;

/// Why findings are accepted; `None` if they are to be held. `given`: as `--reason` gives it.
pub fn reason(given: Option<&str>) -> Result<Option<String>, Failure> {
    let Some(reason) = given.map(str::trim) else {
        return Ok(None);
    };
    if reason.is_empty() {
        return Err(Failure::Message(
            "`--reason` is empty: say why these findings are right, or why they stay as they are"
                .to_owned(),
        ));
    }
    Ok(Some(reason.to_owned()))
}

/// The scenes that are named, each once: a scene has one file.
pub fn named(names: &[String]) -> Result<Vec<Scene>, Failure> {
    let mut scenes: Vec<Scene> = Vec::new();
    for name in names {
        let scene = scene::resolve(name)?;
        if scenes.iter().any(|known| known.name == scene.name) {
            let message = format!("scene {} is named twice", scene.name);
            return Err(Failure::Message(message));
        }
        scenes.push(scene);
    }
    Ok(scenes)
}

/// The file of each scene in a folder.
pub fn files(folder: &Path, scenes: &[Scene]) -> Vec<PathBuf> {
    let file = |scene: &Scene| folder.join(format!("{}.csv", scene.name));
    scenes.iter().map(file).collect()
}

/// The accepted findings in each file; `None` where there is none. `command`: the one that writes them, such as `carom check`.
pub fn read(files: &[PathBuf], command: &str) -> Result<Vec<Option<Accepted>>, Failure> {
    let read = || files.iter().map(|file| read_one(file, command)).collect();
    match files.first().and_then(|file| file.parent()) {
        Some(folder) => output::undisturbed(folder, read)?,
        None => read(),
    }
}

fn read_one(file: &Path, command: &str) -> Result<Option<Accepted>, Failure> {
    let text = match fs::read_to_string(file) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => {
            let message = format!("cannot read {}: {error}", file.display());
            return Err(Failure::Message(message));
        }
    };
    let accepted = gate::read(&text).map_err(|malformed| {
        let scene = file.file_stem().unwrap_or_default().to_string_lossy();
        Failure::Message(format!(
            "{}, {malformed}; mend it, or remove it and run `{command} {scene} --accept --reason \"...\"`",
            file.display()
        ))
    })?;
    Ok(Some(accepted))
}

/// Says why nothing is accepted.
pub fn refuse(refused: &Refused) -> ExitCode {
    terminal::say(&format!("error: {refused}"));
    let exit = match refused {
        Refused::CutShort => Exit::CouldNotRun,
        _ => Exit::NotMet,
    };
    exit.into()
}

/// Whether a command was stopped early, by what printing answered; says that nothing is accepted if that was asked for.
pub fn was_stopped(printed: ExitCode, reason: Option<&str>) -> bool {
    let stopped = printed == ExitCode::from(Exit::StoppedEarly);
    if stopped && reason.is_some() {
        terminal::say("Nothing is accepted: it was stopped early.");
    }
    stopped
}

/// Says that the findings are not as accepted, and what to do if they are right.
pub fn not_met(command: &str) -> ExitCode {
    terminal::say(&format!(
        "Not as accepted. If it is right: `{command} --accept --reason \"...\"`."
    ));
    Exit::NotMet.into()
}

/// Writes the files that changed, all of them by this writer, and says how many they are. `files`: those that could have.
pub fn write(
    changes: &[(&PathBuf, String)],
    files: &[PathBuf],
    folder: &Path,
) -> Result<(), Failure> {
    if !changes.is_empty() {
        output::write_at(folder, changes)?;
    }
    terminal::say(&format!(
        "Accepted: {} of {} files written below {}.",
        changes.len(),
        files.len(),
        folder.display()
    ));
    Ok(())
}
