//! Mutated inputs: damaged scene files, trace files, engine lists and arguments of generated scenes, and how they are read.
//!
//! Plan: input by input, an example damaged a few times, read as a user's would be. Conclusion: how many were accepted and refused,
//! and every fault with the number of its input, which anybody can make again.

mod examine;
mod mutate;

pub use examine::{Examined, engine_list, recipe, scene_file, trace_files};
pub use mutate::{mutate, replace_number};

use super::matrix::{self, Configuration, Watch};
use super::random::caught;
use crate::engine::{Knob, KnobRole, Limits, Roster, Setting};
use crate::law::Fault;
use crate::math::random::Draws;
use crate::oracle;
use crate::scene::adversarial::adversarial;
use crate::scene::generate::Recipe;
use crate::scene::{Scene, catalogue};
use crate::trace::Record;
use crate::trace::files::{self, Files};
use mutate::below;
use std::ops::Range;

/// Faults that are kept with their words; the rest is counted.
const KEPT: usize = 1000;

/// Random scenes among the examples.
const EXAMPLES: u64 = 100;

/// Catalogue scenes whose traces are examples: small ones, with every kind of event among them.
const TRACED: [&str; 3] = ["head-on", "bank-side", "ladder-pockets"];

/// Step of the traces of an engine that steps, s: some hundred knots.
const STEP: f64 = 0.01;

/// What reads an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reader {
    /// The scene parser.
    Scene,
    /// The reader of traces.
    Trace,
    /// The parser of `--engines` and `--set`.
    Engines,
    /// The generator of scenes.
    Recipe,
}

impl Reader {
    /// Every reader.
    pub const ALL: [Reader; 4] = [
        Reader::Scene,
        Reader::Trace,
        Reader::Engines,
        Reader::Recipe,
    ];

    /// What it reads, in words.
    pub fn words(self) -> &'static str {
        match self {
            Reader::Scene => "scene files",
            Reader::Trace => "trace files",
            Reader::Engines => "engine lists",
            Reader::Recipe => "generated scenes",
        }
    }
}

/// One damaged input.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// The bytes of a scene file.
    Scene(Vec<u8>),
    /// The texts of a trace.
    Trace(Box<Files>),
    /// What stands after `--engines`.
    Engines(String),
    /// What stands after `carom scene generate`.
    Recipe(Recipe),
}

/// What is damaged.
#[derive(Debug)]
pub struct Examples {
    scenes: Vec<Vec<u8>>,
    traces: Vec<Files>,
    lists: Vec<String>,
    /// Words that mean something in a list of engines.
    names: Vec<String>,
    roster: Roster,
    /// The scene for which settings are read.
    scene: Scene,
}

/// Lists of engines: every preset, the finest setting of each ladder, and each engine with the last word of all its choices.
fn lists(roster: &Roster) -> Vec<String> {
    let presets = Configuration::presets(roster, |_| true);
    let mut lists = vec![specs(&presets)];
    for engine in roster {
        let ladders = engine.ladders().into_iter();
        let finest = ladders.filter_map(|(_, settings)| settings.into_iter().next_back());
        lists.extend(finest.map(|setting| Configuration::with(engine, setting).spec()));
        let last = |setting: Setting, knob: Knob| match knob.choices.last() {
            Some(word) => setting.with(&knob.key, word),
            None => setting,
        };
        let chosen = engine.knobs().into_iter().fold(Setting::default(), last);
        let with_all = [
            Configuration::with(engine, chosen),
            Configuration::of(engine),
        ];
        lists.push(specs(&with_all[..]));
    }
    lists
}

fn specs(columns: &[Configuration]) -> String {
    let specs: Vec<String> = columns.iter().map(Configuration::spec).collect();
    specs.join(",")
}

/// Ids of engines, and the keys of steps and choices as they begin a setting.
fn names(roster: &Roster) -> Vec<String> {
    let mut names = Vec::new();
    for engine in roster {
        names.push(engine.id().to_owned());
        for knob in engine.knobs() {
            let name = format!("{}=", knob.key);
            let telling = knob.role == KnobRole::Step || !knob.choices.is_empty();
            if telling && !names.contains(&name) {
                names.push(name);
            }
        }
    }
    names
}

/// The engines whose traces are examples: the reference, and the first that steps, with a step that leaves few knots.
fn traced(roster: &Roster) -> Vec<Configuration> {
    let reference = roster.find(oracle::engine().id());
    let reference = reference.map(Configuration::of);
    let stepping = roster.iter().find_map(|engine| {
        let setting = engine.with_step(&Setting::default(), STEP)?;
        Some(Configuration::with(engine, setting))
    });
    reference.into_iter().chain(stepping).collect()
}

impl Examples {
    /// The examples; `None` only where a catalogue scene or its trace cannot be had.
    pub fn new(roster: &Roster) -> Option<Self> {
        let written = catalogue::all()
            .iter()
            .map(|entry| entry.text.as_bytes().to_vec());
        let random = (0..EXAMPLES).filter_map(|index| adversarial(1, index).text().ok());
        let mut traces = Vec::new();
        for name in TRACED {
            let scene = catalogue::scene(name).ok()?;
            for column in traced(roster) {
                // a cadence longer than the run: with certainty, where an engine states it, and without further samples
                let record = Record::Every(scene.duration);
                let trace = matrix::run_one(&scene, &column, record, &Limits::NONE).ok()?;
                traces.push(files::write(&trace).ok()?);
            }
        }
        Some(Examples {
            scenes: written.chain(random.map(String::into_bytes)).collect(),
            traces,
            lists: lists(roster),
            names: names(roster),
            roster: roster.clone(),
            scene: catalogue::scene("head-on").ok()?,
        })
    }

    /// Input number `index` under `seed`.
    pub fn input(&self, seed: u64, index: u64) -> (Reader, Input) {
        let mut draws = Draws::new(seed, index);
        let draws = &mut draws;
        let times = match below(draws, 8) {
            0..=4 => 1,
            5..=6 => 2,
            _ => 3 + below(draws, 3),
        };
        match index % 10 {
            0..=4 => {
                let mut bytes = self.scenes[below(draws, self.scenes.len())].clone();
                (0..times).for_each(|_| mutate(&mut bytes, draws, &self.names));
                (Reader::Scene, Input::Scene(bytes))
            }
            5..=7 => {
                let mut texts = self.traces[below(draws, self.traces.len())].clone();
                for _ in 0..times.div_ceil(2) {
                    let text = match below(draws, 4) {
                        0 => &mut texts.events,
                        1 => &mut texts.samples,
                        2 => &mut texts.final_states,
                        _ => &mut texts.run,
                    };
                    let mut bytes = std::mem::take(text).into_bytes();
                    mutate(&mut bytes, draws, &self.names);
                    *text = String::from_utf8_lossy(&bytes).into_owned();
                }
                (Reader::Trace, Input::Trace(Box::new(texts)))
            }
            8 => {
                let mut bytes = self.lists[below(draws, self.lists.len())]
                    .as_bytes()
                    .to_vec();
                (0..times.div_ceil(2)).for_each(|_| mutate(&mut bytes, draws, &self.names));
                let list = String::from_utf8_lossy(&bytes).into_owned();
                (Reader::Engines, Input::Engines(list))
            }
            _ => (Reader::Recipe, Input::Recipe(drawn_recipe(draws))),
        }
    }

    /// Reads an input and holds the answer to what must be true of it.
    pub fn examine(&self, input: &Input) -> Examined {
        match input {
            Input::Scene(bytes) => scene_file(bytes),
            Input::Trace(texts) => trace_files(texts),
            Input::Engines(list) => engine_list(&self.roster, list, &self.scene),
            Input::Recipe(arguments) => recipe(arguments),
        }
    }
}

/// Arguments of any size, most of them near what makes sense.
fn drawn_recipe(draws: &mut Draws) -> Recipe {
    const EDGES: [f64; 12] = [
        0.0,
        -1.0,
        1e-9,
        1e9,
        1e-10,
        1e10,
        1e-300,
        1e300,
        5e-324,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
    ];
    let mut number = |low: f64, high: f64| match below(draws, 12) {
        0 => EDGES[below(draws, EDGES.len())],
        1 => 10_f64.powf(draws.between(-12.0, 12.0)),
        _ => draws.between(low, high),
    };
    let numbers = [
        number(0.0, 0.95),
        number(0.0, 1.0),
        number(0.0, 10.0),
        number(0.01, 2.0),
        number(0.01, 2.0),
        number(0.1, 20.0),
    ];
    let balls = match below(draws, 8) {
        0 => below(draws, 3),
        1 => usize::MAX - below(draws, 2),
        _ => below(draws, 40),
    };
    let [density, mu, speed, radius, mass, duration] = numbers;
    Recipe {
        balls,
        density,
        seed: draws.bits(),
        mu: (below(draws, 2) == 0).then_some(mu),
        speed,
        radius,
        mass,
        duration,
    }
}

/// What to read.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// Index of the first input.
    pub first: u64,
    /// Number of inputs; those whose index would be beyond [`u64::MAX`] - 1 do not exist.
    pub inputs: u64,
    /// Seed of all of them.
    pub seed: u64,
}

impl Plan {
    /// The indices of the inputs.
    pub fn indices(&self) -> Range<u64> {
        self.first..self.first.saturating_add(self.inputs)
    }
}

/// An input that shows a fault.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// Index of the input.
    pub input: u64,
    /// What reads it.
    pub reader: Reader,
    /// What must not be.
    pub fault: Fault,
}

/// Everything that was found.
#[derive(Clone, Debug)]
pub struct MutationOutcome {
    /// What was asked for.
    pub plan: Plan,
    /// Inputs that were accepted and refused, for each of [`Reader::ALL`].
    pub counts: [[u64; 2]; 4],
    /// Faults in the order of inputs, the first thousand.
    pub failures: Vec<Failure>,
    /// Number of all faults.
    pub faults: u64,
}

impl MutationOutcome {
    fn empty(plan: Plan) -> Self {
        MutationOutcome {
            plan,
            counts: [[0; 2]; 4],
            failures: Vec::new(),
            faults: 0,
        }
    }

    /// Inputs that were read.
    pub fn done(&self) -> u64 {
        self.faults + self.counts.iter().flatten().sum::<u64>()
    }

    fn see(&mut self, input: u64, reader: Reader, examined: Examined) {
        match examined {
            Ok(accepted) => self.counts[reader as usize][usize::from(!accepted)] += 1,
            Err(fault) => {
                self.faults += 1;
                if self.failures.len() < KEPT {
                    self.failures.push(Failure {
                        input,
                        reader,
                        fault,
                    });
                }
            }
        }
    }

    fn add(&mut self, later: MutationOutcome) {
        for (count, more) in self
            .counts
            .iter_mut()
            .flatten()
            .zip(later.counts.iter().flatten())
        {
            *count += more;
        }
        self.faults += later.faults;
        let room = KEPT - self.failures.len();
        self.failures.extend(later.failures.into_iter().take(room));
    }
}

/// Reads the inputs of a plan. Answers the same for any number of threads.
pub fn study(plan: Plan, examples: &Examples, watch: Watch<'_>) -> MutationOutcome {
    let block = |range: Range<u64>| {
        let mut found = MutationOutcome::empty(plan);
        for index in range {
            if watch.is_cancelled() {
                break;
            }
            let (reader, input) = examples.input(plan.seed, index);
            let examined = caught(|| examples.examine(&input)).unwrap_or_else(Err);
            found.see(index, reader, examined);
        }
        found
    };
    let mut outcome = MutationOutcome::empty(plan);
    let what = "mutated inputs";
    matrix::fold_blocks(plan.indices(), what, watch, block, |found| {
        outcome.add(found);
    });
    outcome
}
