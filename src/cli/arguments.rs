//! The command line as types. Choices derive from the lists of engines and formats.

use super::Failure;
use super::choice::choice;
use super::scene::SceneCommand;
use crate::engine::{Limits, Preset, Roster};
use crate::oracle::Precision;
use crate::page::compare::LengthUnit;
use crate::report::{FORMATS, Format};
use crate::study::Configuration;
use crate::study::cost::Grid;
use clap::builder::TypedValueParser;
use clap::{Args, Parser, Subcommand};
use clap_complete::Shell;
use std::path::PathBuf;

/// Cross-validates rigid-body engines: one billiards scene, several engines, and where, when and why they part.
///
/// Without a command it runs the report's scenes in every engine and writes a report to carom-report/.
#[derive(Debug, Parser)]
#[command(name = "carom", version, max_term_width = 100, after_help = super::exit::sentence())]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run one scene in one engine and write the trace as files.
    Run(RunArguments),
    /// Compare one scene in several engines: where they part, when and why.
    Compare(CompareArguments),
    /// Compare many scenes and write a report: HTML, Markdown, CSV, JSON.
    Report(ReportArguments),
    /// What accuracy costs in one scene: errors and times of every engine along its ladders of settings, and the cheapest setting for
    /// each error.
    ///
    /// Ctrl-C stops it early: it says what was run and timed, and leaves open which setting is the cheapest. What is timed runs alone; a
    /// machine that does something else is seen in the column `noise`.
    Cost(CostArguments),
    /// Up to which event anybody can be right about a scene, how perturbations grow, and which input matters most.
    Horizon(HorizonArguments),
    /// Run many samples of one scene, varied by a stated law, and compare how the answers of engines are distributed.
    ///
    /// Without --aim, --speed and --gap: aim 0.1, speed 0.01 and gap 1e-2, or 1e-5 where balls touch, as far as the scene has a
    /// ball that moves or rests; gaps alone where the scene says `simultaneous = "ensemble"`. What is given varies alone.
    Ensemble(EnsembleArguments),
    /// Say which effects a shot needs and what leaving each out would cost; or draw the curves of the impact laws.
    ///
    /// Runs the scene without each of its effects, with each alone on the bare model, and along the scenes that `richer` links with it.
    Effects(EffectsArguments),
    /// Serve a page on this machine: a shot's inputs, every engine run live, the replay and the comparison.
    ///
    /// Prints the address and opens a browser; Ctrl-C ends it. Only this machine can reach it.
    Play(PlayArguments),
    /// Run random scenes that look for trouble, or read mutated inputs, and check what must hold of every one of them.
    ///
    /// Without --scenes and --inputs: ten thousand scenes. Exits with 1 if something is broken, and says which scene or input
    /// shows it.
    Fuzz(FuzzArguments),
    /// Run every hard case on every engine and say what holds, what drifts, what breaks; hold it against what was accepted.
    Stability(StabilityArguments),
    /// Run the scenes of the gate in every engine and hold what is found against baselines.
    ///
    /// Exits with 1 if a promised invariant does not hold or anything is not as accepted, in either direction; with 2 if it did not
    /// run to its end, or a baseline is missing or malformed.
    Check(CheckArguments),
    /// Say what of two result folders is not the same beyond tolerance: two versions of an engine, two machines, two settings.
    ///
    /// Folders of `carom run --out` of one scene, or of baselines that `carom check --accept --baseline` wrote. Exits with 1 if
    /// something differs, with 2 if a folder cannot be read.
    Diff(DiffArguments),
    /// List the engines and the settings of each.
    Engines {
        /// How to print it.
        #[arg(long, value_parser = formats(), default_value = "text")]
        format: Format,
    },
    /// List, show and check scenes.
    Scene {
        /// What to do.
        #[command(subcommand)]
        command: SceneCommand,
        /// How to print the list.
        #[arg(long, global = true, value_parser = formats(), default_value = "text")]
        format: Format,
    },
    /// Print a completion script for a shell.
    Completions {
        /// The shell.
        shell: Shell,
    },
}

/// Arguments of `carom run`.
#[derive(Debug, Args)]
pub struct RunArguments {
    /// A scene of the catalogue, or a scene file.
    pub scene: String,
    /// The engine.
    #[arg(long, value_name = "ID", help = engine_help())]
    pub engine: String,
    /// A setting of the engine; see `carom engines`.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub settings: Vec<String>,
    /// Folder for events.csv, samples.csv, final.csv and run.json.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Simulated time between two recorded samples of a stepping engine, s.
    #[arg(long, value_name = "SECONDS", default_value_t = 0.01)]
    pub every: f64,
    /// Most events of an event-driven engine; a run that reaches it ends there and says so.
    #[arg(long, value_name = "N", default_value_t = Limits::NONE.max_events)]
    pub max_events: u64,
    /// How to print the summary.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Arguments of `carom compare`.
#[derive(Debug, Args)]
pub struct CompareArguments {
    /// A scene of the catalogue, or a scene file.
    pub scene: String,
    /// Engines with optional settings: stepper,stepper:contact=approaching-only,rapier-f64:preset=stock:dt=1e-3.
    /// The exact engine always runs: it is the reference.
    #[arg(long, value_name = "LIST")]
    pub engines: Option<String>,
    /// Unit of lengths: R is the smallest radius, `scene` the scene's own unit.
    #[arg(long, value_parser = units(), default_value = LengthUnit::Radius.id())]
    pub units: LengthUnit,
    /// How to print it.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Arguments of `carom ensemble`.
#[derive(Debug, Args)]
pub struct EnsembleArguments {
    /// A scene of the catalogue, or a scene file.
    pub scene: String,
    /// Number of samples.
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub samples: usize,
    /// Seed of all draws; the same seed gives the same samples.
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Engines with optional settings, as in `carom compare`; exact ones first, and the first that reaches the end is what
    /// the others are held against. Rapier needs hundreds of times as long as the others.
    #[arg(long, value_name = "LIST", default_value_t = listed(|preset| preset.sampled))]
    pub engines: String,
    /// Aim of the cue ball: uniform within so many degrees to either side.
    #[arg(long, value_name = "DEGREES")]
    pub aim: Option<f64>,
    /// Speed of the cue ball: uniform within this part of it, up and down.
    #[arg(long, value_name = "PART")]
    pub speed: Option<f64>,
    /// Size of the gaps, in R: touching balls are opened to it, and every resting ball is displaced uniformly within a disc of
    /// half this radius, or half its smallest gap where that is less.
    #[arg(long, value_name = "R")]
    pub gap: Option<f64>,
    /// Folder for the page with all distributions and pictures.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// How to print the summary.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Arguments of `carom report`.
#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Scenes: catalogue names or files. Without any: the set `report`.
    pub scenes: Vec<String>,
    /// Folder of the report.
    #[arg(long, value_name = "DIR", default_value = DEFAULT_FOLDER)]
    pub out: PathBuf,
    /// Engines with optional settings, as in `carom compare`.
    #[arg(long, value_name = "LIST")]
    pub engines: Option<String>,
    /// How to print the summary.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Arguments of `carom cost`.
#[derive(Debug, Args)]
pub struct CostArguments {
    /// A scene of the catalogue, or a scene file.
    pub scene: String,
    /// Engines to sweep, all of them if none is named; settings given with one hold at every level: rapier-f64:substeps=8.
    #[arg(long, value_name = "LIST")]
    pub engines: Option<String>,
    /// small: seconds to a minute; full: every level of every ladder from more starts, which takes many minutes.
    #[arg(long, value_parser = grids(), default_value = Grid::Small.id())]
    pub grid: Grid,
    /// Folder of the report that shows the prices; the page of the study goes to cost/SCENE below it.
    #[arg(long, value_name = "DIR", default_value = DEFAULT_FOLDER)]
    pub out: PathBuf,
    /// How to print it; other formats than text have every setting.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Arguments of `carom horizon`.
#[derive(Debug, Args)]
pub struct HorizonArguments {
    /// A scene of the catalogue, or a scene file.
    pub scene: String,
    /// The precision in question; the next finer one is the witness.
    #[arg(long, value_parser = precisions(), default_value = Precision::F64.id())]
    pub precision: Precision,
    /// Folder for the same as a page with its pictures; none is written without it.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// How to print it.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Arguments of `carom effects`.
#[derive(Debug, Args)]
pub struct EffectsArguments {
    /// A scene of the catalogue, or a scene file.
    #[arg(required_unless_present = "curves")]
    pub scene: Option<String>,
    /// Instead of a scene: throw, squirt and rebound against published curves.
    #[arg(long, conflicts_with_all = ["scene", "threshold"])]
    pub curves: bool,
    /// Engines with optional settings, as in `carom compare`; the exact engine always runs, and the first that reaches the end of the
    /// whole scene is what all else is held against. The stepper as the report wrote it lets pairs stick, which hides what effects do.
    #[arg(long, value_name = "LIST", default_value_t = listed(|preset| preset.sound))]
    pub engines: String,
    /// A shot needs an effect when leaving it out moves a ball by more than this.
    #[arg(long, value_name = "R", default_value_t = 0.1)]
    pub threshold: f64,
    /// Folder for the page with its pictures.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// How to print the summary.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Arguments of `carom play`.
#[derive(Debug, Args)]
pub struct PlayArguments {
    /// The scene that the page opens with: of the catalogue, or a scene file.
    #[arg(default_value = "report-break")]
    pub scene: String,
    /// Port; 0 is any that is free. Without it: 4147, or the next that is free.
    #[arg(long, value_name = "N")]
    pub port: Option<u16>,
    /// Do not open a browser.
    #[arg(long)]
    pub no_open: bool,
}

/// Arguments of `carom fuzz`.
#[derive(Debug, Args)]
pub struct FuzzArguments {
    /// Number of random scenes.
    #[arg(long, value_name = "N", conflicts_with = "inputs")]
    pub scenes: Option<u64>,
    /// Read so many mutated scene files, trace files, engine lists and arguments of generated scenes instead.
    #[arg(long, value_name = "N")]
    pub inputs: Option<u64>,
    /// Index of the first scene or input.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub first: u64,
    /// Seed; a scene or input depends on the seed and its index alone.
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Engines with optional settings, as in `carom compare`; what a setting leaves open is what the scene's `try` says.
    #[arg(long, value_name = "LIST", default_value_t = listed(|preset| preset.sound))]
    pub engines: String,
    /// Most events of a run of an event-driven engine.
    #[arg(long, value_name = "N", default_value_t = super::bounds::FUZZ_EVENTS)]
    pub max_events: u64,
    /// Print the scene with this index and run nothing.
    #[arg(long, value_name = "INDEX")]
    pub show: Option<u64>,
    /// Folder for the files of the scenes or inputs that break something.
    #[arg(long, value_name = "DIR")]
    pub save: Option<PathBuf>,
    /// How to print it.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Arguments of `carom check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// Scenes: catalogue names or files, and `random-scenes` for some thousand of one seed. Without any: the set `gate` and those.
    pub scenes: Vec<String>,
    /// Folder of the baselines, one CSV file a scene. Without it: those of carom itself, which are built in.
    #[arg(long, value_name = "DIR")]
    pub baseline: Option<PathBuf>,
    /// Hold nothing unless the program was built with this crate from `registry`, `git` or `path`; several may be given. Cargo
    /// leaves a patch out that does not fit, and only warns.
    #[arg(long, value_name = "CRATE=SOURCE")]
    pub built_from: Vec<String>,
    /// Accept what is found: show old and new, write the files of the scenes in which something changed, to the folder of
    /// `--baseline`. Refused while a promised invariant is broken.
    #[arg(long, requires = "reason")]
    pub accept: bool,
    /// Why it is accepted; written into the files.
    #[arg(long, value_name = "WHY", requires = "accept")]
    pub reason: Option<String>,
    /// Write JUnit XML: one case a scene, engine and level.
    #[arg(long, value_name = "FILE")]
    pub junit: Option<PathBuf>,
    /// Write a Markdown summary. It is appended to the file that GITHUB_STEP_SUMMARY names as well.
    #[arg(long, value_name = "FILE")]
    pub markdown: Option<PathBuf>,
    /// Also print by how much each metric may move, and why.
    #[arg(long)]
    pub verbose: bool,
    /// Folder for the page, with every change and every bound.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// How to print the summary.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Arguments of `carom diff`.
#[derive(Debug, Args)]
pub struct DiffArguments {
    /// The folder to hold the other one against.
    #[arg(value_name = "A")]
    pub first: PathBuf,
    /// The other one.
    #[arg(value_name = "B")]
    pub second: PathBuf,
    /// The scene of both runs, if it is none of the catalogue.
    #[arg(long, value_name = "FILE")]
    pub scene: Option<String>,
    /// How to print what differs.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Arguments of `carom stability`.
#[derive(Debug, Args)]
pub struct StabilityArguments {
    /// Scenes: catalogue names or files. Without any: the set `hard`.
    pub scenes: Vec<String>,
    /// Engines with optional settings, as in `carom compare`. Without it: every engine and preset.
    #[arg(long, value_name = "LIST")]
    pub engines: Option<String>,
    /// Also scenes and steps that take more than their share: about a minute a scene.
    #[arg(long)]
    pub full: bool,
    /// Folder of the accepted findings, one CSV file a scene. Without it: those of carom itself, which are built in.
    #[arg(long, value_name = "DIR")]
    pub accepted: Option<PathBuf>,
    /// Accept what is found: write the files of the scenes in which something changed, to the folder of `--accepted`. Refused while
    /// a promised invariant is broken.
    #[arg(long, requires = "reason", conflicts_with = "engines")]
    pub accept: bool,
    /// Why it is accepted; written into the files.
    #[arg(long, value_name = "WHY", requires = "accept")]
    pub reason: Option<String>,
    /// Folder for the pages of all scenes, with a picture of each run that breaks.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// How to print the summary.
    #[arg(long, value_parser = formats(), default_value = "text")]
    pub format: Format,
}

/// Where a report goes unless told otherwise.
const DEFAULT_FOLDER: &str = "carom-report";

impl Default for ReportArguments {
    fn default() -> Self {
        ReportArguments {
            scenes: Vec::new(),
            out: PathBuf::from(DEFAULT_FOLDER),
            engines: None,
            format: FORMATS[0],
        }
    }
}

fn formats() -> impl TypedValueParser<Value = Format> {
    choice(FORMATS, |format| format.id)
}

fn units() -> impl TypedValueParser<Value = LengthUnit> {
    choice(&LengthUnit::ALL, |unit| unit.id())
}

/// The precisions that have a finer one to be held against.
fn precisions() -> impl TypedValueParser<Value = Precision> {
    choice(&Precision::WITNESSED, |precision| precision.id())
}

fn grids() -> impl TypedValueParser<Value = Grid> {
    choice(&Grid::ALL, |grid| grid.id())
}

fn engine_help() -> String {
    format!("The engine: {}", Roster::built_in().ids())
}

/// The presets of the built-in engines that are wanted, as a list of engines: those that solve for their events first.
fn listed(wanted: fn(&Preset) -> bool) -> String {
    let mut columns = Configuration::presets(&Roster::built_in(), wanted);
    Configuration::solvers_first(&mut columns);
    let specs: Vec<String> = columns.iter().map(Configuration::spec).collect();
    specs.join(",")
}

/// Reads a list of engines: `ID[:KEY=VALUE]...[,...]`.
pub fn parse_engines(roster: &Roster, list: &str) -> Result<Vec<Configuration>, Failure> {
    Configuration::list(roster, list).map_err(|error| Failure::Message(error.to_string()))
}
