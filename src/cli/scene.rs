//! `carom scene`: the catalogue, the check of a file, the schema; and how a SCENE on the command line becomes a scene.

use super::exit::Exit;
use super::scene_list::{self, ListArguments};
use super::{Failure, bounds, terminal};
use crate::report::{self, Format};
use crate::scene::generate::{GenerateError, Recipe, generate};
use crate::scene::{
    Diagnostic, Diagnostics, Kind, Scene, SceneError, catalogue, is_kebab_case, parse_bytes,
    printable, schema, spelled,
};
use clap::{Args, Subcommand};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use thiserror::Error;

/// What `carom scene` can do.
#[derive(Clone, Debug, Subcommand)]
pub enum SceneCommand {
    /// List the scenes of the catalogue, one a line: name, number of balls, what it is.
    ///
    /// What is asked for together must hold together. CSV and JSON have whole descriptions, all sets and effects.
    List(ListArguments),
    /// Print a scene of the catalogue as written, ready to be saved and changed.
    Show {
        /// Name of the scene.
        name: String,
    },
    /// Check scene files; says `ok` for each or what is wrong with it, and where.
    Check {
        /// Scene files, or names of catalogue scenes.
        #[arg(required = true, value_name = "FILE")]
        files: Vec<String>,
    },
    /// Print the JSON Schema of the scene format, for editors.
    Schema,
    /// Print a scene of many discs in a box, ready to be saved: a jittered lattice with random velocities.
    Generate(GenerateArguments),
}

/// What `carom scene generate` is told.
#[derive(Clone, Debug, Args)]
pub struct GenerateArguments {
    /// Number of balls.
    #[arg(long, value_name = "N")]
    pub balls: usize,
    /// Part of the box that the discs cover; up to about 0.85 for many discs.
    #[arg(long, value_name = "D")]
    pub density: f64,
    /// Seed of positions and velocities; the same seed gives the same file.
    #[arg(long, value_name = "S", default_value_t = Recipe::default().seed)]
    pub seed: u64,
    /// Friction of the cloth, with a gravity of 9.81 length/s^2; without it there is no cloth.
    #[arg(long, value_name = "MU")]
    pub mu: Option<f64>,
    /// Root mean square of the speeds, length/s.
    #[arg(long, value_name = "V", default_value_t = Recipe::default().speed)]
    pub speed: f64,
    /// Radius of every ball, length.
    #[arg(long, value_name = "R", default_value_t = Recipe::default().radius)]
    pub radius: f64,
    /// Mass of every ball.
    #[arg(long, value_name = "M", default_value_t = Recipe::default().mass)]
    pub mass: f64,
    /// Longest simulated time, s.
    #[arg(long, value_name = "T", default_value_t = Recipe::default().duration)]
    pub duration: f64,
}

impl GenerateArguments {
    /// The recipe that the arguments are.
    pub fn recipe(&self) -> Recipe {
        Recipe {
            balls: self.balls,
            density: self.density,
            seed: self.seed,
            mu: self.mu,
            speed: self.speed,
            radius: self.radius,
            mass: self.mass,
            duration: self.duration,
        }
    }
}

/// Why a SCENE on the command line is not a scene.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LoadError {
    /// The file cannot be read.
    #[error("cannot read {}: {why}", printable(&.path.display().to_string()))]
    Unreadable {
        /// The path as given.
        path: PathBuf,
        /// The reason.
        why: String,
    },
    /// The file is not a scene, or no scene has the name.
    #[error("{0}")]
    Scene(#[from] SceneError),
}

impl LoadError {
    /// The message as shown to a person, with `error:` before it, in colour if `colour`.
    pub fn render(&self, colour: bool) -> String {
        match self {
            LoadError::Scene(SceneError::Invalid(diagnostics)) => diagnostics.render(colour),
            other => format!("error: {other}"),
        }
    }
}

/// Does one of the commands below `carom scene`.
pub(super) fn scene(command: &SceneCommand, format: &Format) -> Result<ExitCode, Failure> {
    match command {
        SceneCommand::List(arguments) => scene_list::list(arguments, format),
        SceneCommand::Show { name } => terminal::print(show(name)?),
        SceneCommand::Schema => terminal::print(&schema_text()),
        SceneCommand::Generate(arguments) => match generate(&arguments.recipe()) {
            Ok(text) => terminal::print(&text),
            Err(error @ GenerateError::Balls(_)) => Err(bounds::refused("--balls", &error)),
            Err(error) => Err(Failure::Message(error.to_string())),
        },
        SceneCommand::Check { files } => {
            let (mut out, mut err) = (Vec::new(), Vec::new());
            let all_right = check(files, terminal::colour_on_stderr(), &mut out, &mut err)
                .map_err(|error| Failure::Message(error.to_string()))?;
            let printed = terminal::print(&String::from_utf8_lossy(&out))?;
            if !err.is_empty() {
                terminal::say_rendered(String::from_utf8_lossy(&err).trim_end());
            }
            Ok(match all_right {
                true => printed,
                false => Exit::CouldNotRun.into(),
            })
        }
    }
}

/// The scene that SCENE names: a catalogue name or a path.
///
/// A word that could be meant as a name is one; anything with a dot or a slash is a path, as is a name that only a file has.
pub fn resolve(scene: &str) -> Result<Scene, LoadError> {
    if let Some(entry) = catalogue::find(scene) {
        return Ok(entry.scene()?);
    }
    let path = Path::new(scene);
    let could_be_a_name = !scene.is_empty() && !scene.contains(['.', '/', '\\']);
    if (is_kebab_case(scene) && !path.is_file()) || (could_be_a_name && !path.exists()) {
        return Err(catalogue::unknown(scene).into());
    }
    load(path)
}

/// The text of the scene that SCENE names, as written; it is a scene.
pub fn text(scene: &str) -> Result<String, LoadError> {
    if let Some(entry) = catalogue::find(scene) {
        return Ok(entry.text.to_owned());
    }
    resolve(scene)?;
    let bytes = read(Path::new(scene))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The scene in the file at `path`.
pub fn load(path: &Path) -> Result<Scene, LoadError> {
    Ok(parse_bytes(&path.display().to_string(), &read(path)?)?)
}

fn read(path: &Path) -> Result<Vec<u8>, LoadError> {
    let unreadable = |why: String| LoadError::Unreadable {
        path: path.to_owned(),
        why,
    };
    if path.is_dir() {
        return Err(unreadable("it is a directory, not a file".to_owned()));
    }
    fs::read(path).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => unreadable("there is no such file".to_owned()),
        io::ErrorKind::PermissionDenied => unreadable("permission denied".to_owned()),
        _ => unreadable(error.to_string()),
    })
}

/// The text of the catalogue scene called `name`, as written.
pub fn show(name: &str) -> Result<&'static str, LoadError> {
    let entry = catalogue::find(name).ok_or_else(|| catalogue::unknown(name))?;
    Ok(entry.text)
}

/// Checks every file; writes `ok` lines to `out`, errors and warnings to `err`. True if all are scenes.
pub fn check(
    files: &[String],
    colour: bool,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> io::Result<bool> {
    let mut all_right = true;
    for file in files {
        match resolve(file) {
            Ok(scene) => {
                let balls = scene.balls.len();
                let plural = if balls == 1 { "" } else { "s" };
                let name = printable(file);
                writeln!(out, "{name}: ok, {} with {balls} ball{plural}", scene.name)?;
                if let Some(warnings) = warnings(file) {
                    writeln!(err, "{}\n", warnings.render(colour))?;
                }
            }
            Err(error) => {
                all_right = false;
                writeln!(err, "{}\n", error.render(colour))?;
            }
        }
    }
    Ok(all_right)
}

/// Words of a scene that tables for people show otherwise than they are written.
fn warnings(scene: &str) -> Option<Diagnostics> {
    let text = text(scene).ok()?;
    let problems = spelled(&text).into_iter().filter_map(|spelled| {
        let is_id = spelled.path.ends_with(".id");
        let trouble = report::trouble(&spelled.words, is_id)?;
        let what = spelled.path.rsplit('.').next().unwrap_or_default();
        let message = format!("{what} {trouble}");
        let help = "it is shown escaped in tables for people, and to the bit in files for programs; letters, digits and single \
                    hyphens are shown as they are";
        Some(Diagnostic::new(Kind::Spelling, spelled.span, message, help))
    });
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let warnings = Diagnostics::of(scene, text, problems);
    (!warnings.problems.is_empty()).then_some(warnings)
}

/// The JSON Schema of the scene format, as text.
pub fn schema_text() -> String {
    format!("{:#}\n", schema())
}
