//! Accepted findings as files, in a folder or built in: what `check` and `stability` do alike with them.

use super::exit::Exit;
use super::{Failure, output, scene, terminal};
use crate::carried;
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

/// What a command does with accepted findings.
#[derive(Debug)]
pub struct Use {
    /// The command, such as `carom check`.
    pub command: &'static str,
    /// The option that names a folder of them, such as `--baseline`.
    pub option: &'static str,
    /// The folder below `validation/` whose files travel with the program.
    pub built_in: &'static str,
}

/// Where accepted findings are.
#[derive(Debug)]
pub struct AcceptedPlace<'a> {
    of: &'a Use,
    /// The folder that the user named; without one, the files that travel with the program.
    folder: Option<&'a Path>,
}

impl<'a> AcceptedPlace<'a> {
    /// The folder that was named, or what is built in. `accept`: whether findings are to be accepted, for which there must be a folder.
    pub fn new(of: &'a Use, folder: Option<&'a Path>, accept: bool) -> Result<Self, Failure> {
        let place = AcceptedPlace { of, folder };
        if accept && folder.is_none() {
            return Err(Failure::Message(format!(
                "what is built in cannot be written; name a folder: `{}`. carom's own files are in validation/{} of its sources",
                place.command(""),
                of.built_in
            )));
        }
        Ok(place)
    }

    /// What it is called, after words such as "held against".
    pub fn words(&self) -> String {
        match self.folder {
            Some(folder) => folder.display().to_string(),
            None => concat!("those built into carom ", env!("CARGO_PKG_VERSION")).to_owned(),
        }
    }

    /// The same with its preposition: in a folder, among what is built in.
    pub fn within(&self) -> String {
        let link = if self.folder.is_some() { "in" } else { "among" };
        format!("{link} {}", self.words())
    }

    /// The command that accepts what is found. `scenes`: their names, each after a blank; empty for all.
    pub fn command(&self, scenes: &str) -> String {
        let folder = match self.folder {
            Some(folder) => folder.display().to_string(),
            None => "DIR".to_owned(),
        };
        let Use {
            command, option, ..
        } = self.of;
        format!("{command}{scenes} --accept --reason \"...\" {option} {folder}")
    }

    /// The file of a scene; `None` where it is built in.
    pub fn file(&self, scene: &str) -> Option<PathBuf> {
        Some(self.folder?.join(format!("{scene}.csv")))
    }

    /// The accepted findings of each scene of `names`; `None` where there are none.
    pub fn read(&self, names: &[String]) -> Result<Vec<Option<Accepted>>, Failure> {
        let read = || names.iter().map(|name| self.read_one(name)).collect();
        match self.folder {
            Some(folder) => output::undisturbed(folder, read)?,
            None => read(),
        }
    }

    fn read_one(&self, name: &str) -> Result<Option<Accepted>, Failure> {
        let (file, text) = match self.file(name) {
            None => {
                let file = format!("{}/{name}.csv", self.of.built_in);
                let text = carried::text(&file).map(str::to_owned);
                (format!("{file}, built in"), text)
            }
            Some(file) => {
                let shown = file.display().to_string();
                match fs::read_to_string(&file) {
                    Ok(text) => (shown, Some(text)),
                    Err(error) if error.kind() == ErrorKind::NotFound => (shown, None),
                    Err(error) => {
                        return Err(Failure::Message(format!("cannot read {shown}: {error}")));
                    }
                }
            }
        };
        let accepted = text.map(|text| gate::read(&text)).transpose();
        accepted.map_err(|malformed| {
            Failure::Message(format!(
                "{file}, {malformed}; mend it, or remove it and run `{}`",
                self.command(&format!(" {name}"))
            ))
        })
    }

    /// Names of files that no scene of `names` reads: what they hold is held by nothing, and looks as if it were.
    pub fn unread(&self, names: &[String]) -> Vec<String> {
        let own = |file: &str| {
            let stem = file.strip_suffix(".csv");
            stem.is_some_and(|stem| !names.iter().any(|name| name == stem))
        };
        let Some(folder) = self.folder else {
            let all = carried::below(self.of.built_in).map(|(name, _)| name);
            return all.filter(|name| own(name)).map(str::to_owned).collect();
        };
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        let mut unread: Vec<String> = entries
            .filter(|entry| own(&entry.file_name().to_string_lossy()))
            .map(|entry| entry.path().display().to_string())
            .collect();
        unread.sort();
        unread
    }

    /// Writes the accepted findings of scenes, all of them by this writer, and says how many they are of those that could have changed.
    pub fn write(&self, changed: &[Accepted], of: usize) -> Result<(), Failure> {
        let file = |accepted: &Accepted| Some((self.file(&accepted.scene)?, gate::write(accepted)));
        let files: Vec<(PathBuf, String)> = changed.iter().filter_map(file).collect();
        // it is never asked where nothing can be written
        if let Some(folder) = self.folder.filter(|_| !files.is_empty()) {
            output::write_at(folder, &files)?;
        }
        terminal::say(&format!(
            "Accepted: {} of {of} files written below {}.",
            files.len(),
            self.words()
        ));
        Ok(())
    }

    /// Says that the findings are not as accepted, and what to do if they are right.
    pub fn not_met(&self) -> ExitCode {
        let command = self.command("");
        terminal::say(&format!("Not as accepted. If it is right: `{command}`."));
        Exit::NotMet.into()
    }
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
