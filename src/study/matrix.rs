//! The run matrix: scenes, or samples of one, are rows; engines with a setting are columns. The only place for threads and the stopwatch.

use crate::engine::{
    self, Engine, Limits, Parameter, Preset, Refusal, Roster, Run, Setting, UnknownEngine,
};
use crate::math::statistics::Distribution;
use crate::scene::{Scene, Tried, printable};
use crate::trace::{Record, Trace};
use rayon::prelude::*;
use std::collections::{BTreeMap, HashSet};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::time::Instant;
use thiserror::Error;

/// Most engines with settings in one list.
pub const MOST_COLUMNS: usize = 256;

/// One engine with one setting.
#[derive(Clone)]
pub struct Configuration {
    /// The engine.
    pub engine: Arc<dyn Engine>,
    /// Its setting; empty for the defaults.
    pub setting: Setting,
}

impl Configuration {
    /// A column with every default.
    pub fn of(engine: &Arc<dyn Engine>) -> Self {
        Configuration::with(engine, Setting::default())
    }

    /// A column with a setting.
    pub fn with(engine: &Arc<dyn Engine>, setting: Setting) -> Self {
        Configuration {
            engine: Arc::clone(engine),
            setting,
        }
    }

    /// A column for each preset of the roster's engines that is wanted, in order.
    pub fn presets(roster: &Roster, wanted: impl Fn(&Preset) -> bool) -> Vec<Configuration> {
        let mut columns = Vec::new();
        for engine in roster {
            let presets = engine.presets().into_iter().filter(&wanted);
            columns.extend(presets.map(|preset| Configuration::with(engine, preset.setting)));
        }
        columns
    }

    /// The columns in which engines solve before those in which they step; the order of each is kept.
    pub fn solvers_first(columns: &mut [Configuration]) {
        columns.sort_by_key(|column| !column.engine.solves());
    }

    /// The preset of the engine that the setting extends, and what is set besides: of several the one that sets most.
    pub fn preset(&self) -> Option<(Preset, Setting)> {
        let presets = self.engine.presets().into_iter();
        let extended = presets.filter_map(|preset| {
            let besides = self.setting.besides(&preset.setting)?;
            Some((preset, besides))
        });
        extended.min_by_key(|(_, besides)| besides.values.len())
    }

    /// What the engine says of its setting, if that is a preset of its own and nothing more.
    pub fn is_preset(&self, wanted: impl Fn(&Preset) -> bool) -> bool {
        let own = self.preset();
        own.is_some_and(|(preset, besides)| besides.values.is_empty() && wanted(&preset))
    }

    /// As in a list of engines: `ID:KEY=VALUE`.
    pub fn spec(&self) -> String {
        let id = self.engine.id().to_owned();
        let pairs = self.setting.values.iter();
        pairs.fold(id, |spec, (key, value)| format!("{spec}:{key}={value}"))
    }

    /// Reads a list of engines: `ID[:KEY=VALUE]...[,...]`.
    pub fn list(roster: &Roster, list: &str) -> Result<Vec<Configuration>, ListError> {
        let mut columns: Vec<Configuration> = Vec::new();
        let mut labels = HashSet::new();
        for item in list.split(',').map(str::trim) {
            let mut parts = item.split(':');
            let id = parts.next().unwrap_or_default();
            let engine = roster.named(id)?;
            let item = item.to_owned();
            let setting = match Setting::parse(parts) {
                Ok(setting) => setting,
                Err(refusal) => return Err(ListError::Setting { item, refusal }),
            };
            let column = Configuration::with(engine, setting);
            if !labels.insert(column.label()) {
                return Err(ListError::Twice { item });
            }
            if columns.len() == MOST_COLUMNS {
                return Err(ListError::TooMany);
            }
            columns.push(column);
        }
        Ok(columns)
    }

    /// The column that a scene wants tried. Errors: the roster has no such engine.
    pub fn tried(roster: &Roster, tried: &Tried) -> Result<Configuration, UnknownEngine> {
        let setting = Setting {
            values: tried.values().clone(),
        };
        Ok(Configuration::with(roster.named(tried.engine())?, setting))
    }

    /// The column with what the scene's `try` asks of its engine, such as `stepper dt=0.1`; the column's own setting goes first.
    pub fn as_tried(&self, scene: &Scene) -> Self {
        let mut column = self.clone();
        let asked = scene.try_settings.iter();
        for tried in asked.filter(|tried| tried.engine() == self.engine.id()) {
            for (key, value) in tried.values() {
                let own = column.setting.values.entry(key.clone());
                own.or_insert_with(|| value.clone());
            }
        }
        column
    }

    /// Name of engine and setting: `stepper contact=approaching-only`.
    pub fn label(&self) -> String {
        format!("{} {}", self.engine.id(), self.setting)
            .trim_end()
            .to_owned()
    }
}

impl fmt::Debug for Configuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.label())
    }
}

/// Why a text is no list of engines.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ListError {
    /// It names an engine that the roster has not.
    #[error(transparent)]
    Engine(#[from] UnknownEngine),
    /// What stands after an engine is no setting.
    #[error("{}: {refusal}", printable(.item))]
    Setting {
        /// The engine and what stands after it.
        item: String,
        /// What is wrong.
        refusal: Refusal,
    },
    /// An engine is there twice with the same setting.
    #[error("`{}` is listed twice", printable(.item))]
    Twice {
        /// The second of the two.
        item: String,
    },
    /// It is longer than [`MOST_COLUMNS`].
    #[error("more than {MOST_COLUMNS} engines are listed: every pair of them would be compared")]
    TooMany,
}

/// The result of one cell that ran.
#[derive(Clone, Debug)]
pub struct Ran {
    /// What happened.
    pub trace: Trace,
    /// Every parameter that changes physics.
    pub sheet: Vec<Parameter>,
    /// Shortest time of a run without recording samples, s; `None` where it was not timed.
    pub seconds: Option<f64>,
}

/// One cell: what ran to its own end, or why nothing did; [`Refusal::Stopped`] where the user asked to stop before, so that nobody takes
/// part of a run for the whole.
pub type Cell = Result<Ran, Refusal>;

/// What the person at the terminal is told and may ask for while a matrix runs.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Called with the number of cells that are done, the number of all, and the label of the one just done.
    pub progress: &'a (dyn Fn(usize, usize, &str) + Sync),
    /// Set when the user asks to stop.
    pub cancelled: &'a AtomicBool,
}

/// A flag that nobody sets.
static NEVER: AtomicBool = AtomicBool::new(false);

impl Watch<'static> {
    /// Nobody watches, and nobody stops it.
    pub const NONE: Watch<'static> = Watch {
        progress: &|_, _, _| {},
        cancelled: &NEVER,
    };
}

impl Watch<'_> {
    /// True once the user asked to stop.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// What `work` answers; `None` where the user asked to stop before it was done: what was cut short says nothing.
    pub fn whole<T>(&self, work: impl FnOnce() -> T) -> Option<T> {
        let limits = Limits {
            cancelled: self.cancelled,
            ..Limits::NONE
        };
        limits.whole(work)
    }
}

/// Whether and how cells are timed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timing {
    /// Cells run in parallel and are not timed.
    None,
    /// Cells run one by one, each alone on the machine, and are timed.
    Alone,
}

/// How much time goes into timing one cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Runs that are timed even if they take longer than `seconds`.
    pub least_runs: usize,
    /// Runs that are timed at most.
    pub most_runs: usize,
    /// Between these, as many runs as fit into this time, s.
    pub seconds: f64,
}

/// For times that stand beside a result.
const IN_PASSING: Effort = Effort {
    least_runs: 1,
    most_runs: 20,
    seconds: 0.05,
};

/// How long a cell takes, alone on the machine, without recording samples and without set-up.
#[derive(Clone, Debug, PartialEq)]
pub struct Timed {
    /// The shortest of the runs, s.
    pub seconds: f64,
    /// By how much the median of the runs was longer, relative: what a time is good to. `None` for a single run.
    pub noise: Option<f64>,
    /// Number of runs.
    pub runs: usize,
    /// Work counters of a run.
    pub counters: BTreeMap<String, u64>,
    /// Simulated time of a run, s.
    pub simulated: f64,
}

/// Runs one scene in every column. Answers one cell a column, in order, for any number of threads.
pub fn run_row(
    scene: &Scene,
    columns: &[Configuration],
    record: Record,
    timing: Timing,
    watch: Watch<'_>,
) -> Vec<Cell> {
    let limits = Limits {
        cancelled: watch.cancelled,
        ..Limits::NONE
    };
    run_row_within(scene, columns, record, timing, &limits, watch)
}

/// The same with runs that end early where `limits` say so.
pub fn run_row_within(
    scene: &Scene,
    columns: &[Configuration],
    record: Record,
    timing: Timing,
    limits: &Limits<'_>,
    watch: Watch<'_>,
) -> Vec<Cell> {
    let done = AtomicUsize::new(0);
    let run = |column: &Configuration| {
        let cell = run_within(scene, column, record, timing, limits);
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        (watch.progress)(
            count,
            columns.len(),
            &format!("{} in {}", scene.name, column.label()),
        );
        cell
    };
    match timing {
        Timing::None => columns.par_iter().map(run).collect(),
        Timing::Alone => columns.iter().map(run).collect(),
    }
}

/// One run of a list.
#[derive(Clone, Debug)]
pub struct Job<'a> {
    /// What is run.
    pub scene: &'a Scene,
    /// In which engine, with which setting.
    pub column: Configuration,
    /// Roughly how long it takes, ns; the longest start first.
    pub weight: f64,
}

/// Runs a list of jobs untimed and keeps of each only what `reduce` makes of it, given the number of the job. `done` is told the weight
/// of each job that has finished.
///
/// Answers in the order of the jobs, the same for any number of threads. `None`: not run to its end because the user asked to stop.
pub fn run_jobs<T: Send>(
    jobs: &[Job<'_>],
    record: Record,
    cancelled: &AtomicBool,
    done: impl Fn(&Job<'_>) + Sync,
    reduce: impl Fn(usize, Result<Trace, Refusal>) -> T + Sync,
) -> Vec<Option<T>> {
    let run = |k: usize| {
        let job = &jobs[k];
        let ran = run_cell(job.scene, &job.column, record, Timing::None, cancelled);
        if let Err(Refusal::Stopped) = ran {
            return None;
        }
        let reduced = reduce(k, ran.map(|ran| ran.trace));
        done(job);
        Some(reduced)
    };
    let weights: Vec<f64> = jobs.iter().map(|job| job.weight).collect();
    largest_first(&weights, cancelled, run)
}

/// Calls `run` with each index, in parallel, the largest of `works` first, so that none is left to run alone at the end. Answers in
/// the order of the indices; `None` also for what was not begun when the user asked to stop.
fn largest_first<T: Send>(
    works: &[f64],
    cancelled: &AtomicBool,
    run: impl Fn(usize) -> Option<T> + Sync,
) -> Vec<Option<T>> {
    let mut order: Vec<usize> = (0..works.len()).collect();
    order.sort_by(|&a, &b| works[b].total_cmp(&works[a]));
    let unless_cancelled = |index: usize| {
        let stop = cancelled.load(Ordering::Relaxed);
        (index, if stop { None } else { run(index) })
    };
    // a bridge hands them out one by one in this order: a thread that took a stretch of the list would end it alone
    let mut answers: Vec<(usize, Option<T>)> = order
        .into_iter()
        .par_bridge()
        .map(unless_cancelled)
        .collect();
    answers.sort_by_key(|(index, _)| *index);
    answers.into_iter().map(|(_, answer)| answer).collect()
}

/// Times one cell: a run to warm up, then several; nothing else runs meanwhile.
///
/// `None` where the user asked to stop before as many runs were timed as must be.
pub fn time_alone(
    scene: &Scene,
    column: &Configuration,
    effort: Effort,
    cancelled: &AtomicBool,
) -> Result<Option<Timed>, Refusal> {
    let limits = Limits {
        cancelled,
        ..Limits::NONE
    };
    let once = || -> Result<(f64, Trace), Refusal> {
        // set-up is outside the stopwatch
        let run = engine::prepare(column.engine.as_ref(), scene, &column.setting)?;
        let start = Instant::now();
        let trace = to_its_end(run, Record::Final, &limits)?;
        Ok((start.elapsed().as_secs_f64(), trace))
    };
    // a run that was told to stop is short for that reason
    let (first, warm) = match once() {
        Err(Refusal::Stopped) => return Ok(None),
        other => other?,
    };
    let (mut all, mut spent) = (Vec::new(), 0.0);
    // where one run is long, it has been warm for most of it
    if effort.least_runs == 1 || first > effort.seconds {
        (all, spent) = (vec![first], first);
    }
    while all.len() < effort.most_runs {
        if all.len() >= effort.least_runs && spent + first > effort.seconds {
            break;
        }
        match once() {
            Err(Refusal::Stopped) if all.len() < effort.least_runs => return Ok(None),
            Err(Refusal::Stopped) => break,
            Err(other) => return Err(other),
            Ok((seconds, _)) => {
                all.push(seconds);
                spent += seconds;
            }
        }
    }
    let Some(times) = Distribution::of(all) else {
        return Ok(None);
    };
    Ok(Some(Timed {
        seconds: times.least(),
        noise: (times.count() > 1).then(|| times.quantile(0.5) / times.least() - 1.0),
        runs: times.count(),
        counters: warm.counters,
        simulated: warm.end_time,
    }))
}

/// How often the progress of many short cells is told.
const TOLD: usize = 200;

/// Runs samples of one scene in every column, untimed, and keeps of each cell only what `reduce` makes of it.
///
/// `sample`: the scene of a sample; it must depend on the index alone. Answers for each sample one value a column, in order,
/// the same for any number of threads. `None`: a cell that was not run to its end because the user asked to stop.
pub fn run_samples<T: Send>(
    samples: usize,
    sample: impl Fn(usize) -> Scene + Sync,
    columns: &[Configuration],
    record: Record,
    watch: Watch<'_>,
    reduce: impl Fn(Result<Trace, Refusal>) -> T + Sync,
) -> Vec<Option<T>> {
    let cells = samples * columns.len();
    let (done, often) = (AtomicUsize::new(0), cells.div_ceil(TOLD).max(1));
    let run = |cell: usize| {
        if watch.is_cancelled() {
            return None;
        }
        let (index, column) = (cell / columns.len(), &columns[cell % columns.len()]);
        let scene = sample(index);
        let ran = run_cell(&scene, column, record, Timing::None, watch.cancelled);
        if let Err(Refusal::Stopped) = ran {
            return None;
        }
        let trace = ran.map(|ran| ran.trace);
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        if count.is_multiple_of(often) || count == cells {
            (watch.progress)(count, cells, &format!("samples of {}", scene.name));
        }
        Some(reduce(trace))
    };
    (0..cells).into_par_iter().map(run).collect()
}

/// Items that one call of a block does: few enough that a block is done soon after the user asks to stop.
const BLOCK: u64 = 64;

/// Blocks for each thread between two foldings: so many that threads seldom wait for each other, and no more than these are ever held.
const ROUND: u64 = 64;

/// Does the things with these indices in blocks, in parallel, and hands what `block` answers to `fold` in their order, the same for any
/// number of threads. `block` does those with the indices that it is given, fewer once [`Watch::is_cancelled`]; then no more are begun.
///
/// The answers of a few blocks are held at a time, however many things there are.
pub fn fold_blocks<T: Send>(
    indices: Range<u64>,
    what: &str,
    watch: Watch<'_>,
    block: impl Fn(Range<u64>) -> T + Sync,
    mut fold: impl FnMut(T),
) {
    let items = indices.end.saturating_sub(indices.start);
    let (done, often) = (
        AtomicU64::new(0),
        // now and then, however many there are
        items.div_ceil(BLOCK * TOLD as u64).clamp(1, ROUND),
    );
    let run = |range: Range<u64>| {
        let answer = block(range);
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        if count.is_multiple_of(often) || count == items.div_ceil(BLOCK) {
            let of = |items: u64| usize::try_from(items).unwrap_or(usize::MAX);
            let so_far = items.min(count.saturating_mul(BLOCK));
            (watch.progress)(of(so_far), of(items), what);
        }
        answer
    };
    let round = BLOCK * ROUND * rayon::current_num_threads() as u64;
    let mut from = indices.start;
    while from < indices.end && !watch.is_cancelled() {
        let to = from.saturating_add(round).min(indices.end);
        let blocks = (to - from).div_ceil(BLOCK);
        let answers: Vec<T> = (0..blocks)
            .into_par_iter()
            .map(|number| {
                let start = from + number * BLOCK;
                run(start..start.saturating_add(BLOCK).min(to))
            })
            .collect();
        answers.into_iter().for_each(&mut fold);
        from = to;
    }
}

/// Runs one scene in one column within a number of events, untimed. Errors: why there is no run that came to its own end.
pub fn run_one(
    scene: &Scene,
    column: &Configuration,
    record: Record,
    limits: &Limits<'_>,
) -> Result<Trace, Refusal> {
    let run = engine::prepare(column.engine.as_ref(), scene, &column.setting)?;
    to_its_end(run, record, limits)
}

/// The only way from a run to a result: a trace that came to its own end, whichever that is.
fn to_its_end(
    run: Box<dyn Run + '_>,
    record: Record,
    limits: &Limits<'_>,
) -> Result<Trace, Refusal> {
    let trace = limits.whole(|| run.simulate(record, limits));
    trace.ok_or(Refusal::Stopped)
}

/// A cell that takes several runs, for [`run_tasks`].
#[derive(Clone, Debug)]
pub struct Task {
    /// Work to expect, in any unit: the largest begin first, so that none is left to run alone at the end.
    pub cost: f64,
    /// What the person is told when it is done.
    pub label: String,
}

/// How a task runs its scenes.
#[derive(Clone, Copy, Debug)]
pub struct Runner<'a> {
    limits: Limits<'a>,
}

impl Runner<'_> {
    /// Runs one scene in one column.
    pub fn run(&self, scene: &Scene, column: &Configuration, record: Record) -> Cell {
        run_within(scene, column, record, Timing::None, &self.limits)
    }

    /// What may end a run early.
    pub fn limits(&self) -> &Limits<'_> {
        &self.limits
    }
}

/// Runs cells that take several runs each and keeps of each only what `conclude` makes of it.
///
/// `max_events`: see [`Limits`]. `conclude`: gets the index of a task, on which alone its answer must depend. Answers one value a task, in
/// order, the same for any number of threads. `None`: a task that was not run to its end because the user asked to stop.
pub fn run_tasks<T: Send>(
    tasks: &[Task],
    max_events: u64,
    watch: Watch<'_>,
    conclude: impl Fn(usize, Runner<'_>) -> T + Sync,
) -> Vec<Option<T>> {
    let runner = Runner {
        limits: Limits {
            max_events,
            cancelled: watch.cancelled,
        },
    };
    let done = AtomicUsize::new(0);
    let run = |index: usize| {
        let answer = conclude(index, runner);
        // what was cut short says nothing
        if watch.is_cancelled() {
            return None;
        }
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        (watch.progress)(count, tasks.len(), &tasks[index].label);
        Some(answer)
    };
    let costs: Vec<f64> = tasks.iter().map(|task| task.cost).collect();
    largest_first(&costs, watch.cancelled, run)
}

/// Runs one scene in one column.
fn run_cell(
    scene: &Scene,
    column: &Configuration,
    record: Record,
    timing: Timing,
    cancelled: &AtomicBool,
) -> Cell {
    let limits = Limits {
        cancelled,
        ..Limits::NONE
    };
    run_within(scene, column, record, timing, &limits)
}

fn run_within(
    scene: &Scene,
    column: &Configuration,
    record: Record,
    timing: Timing,
    limits: &Limits<'_>,
) -> Cell {
    if limits.is_cancelled() {
        return Err(Refusal::Stopped);
    }
    let run = engine::prepare(column.engine.as_ref(), scene, &column.setting)?;
    // what many balls are told takes its time too
    let sheet = limits.whole(|| run.sheet()).ok_or(Refusal::Stopped)?;
    let start = Instant::now();
    let trace = to_its_end(run, record, limits)?;
    let first = start.elapsed().as_secs_f64();
    let seconds = match timing {
        Timing::None => None,
        // a long run is not repeated for its time alone
        Timing::Alone if first > IN_PASSING.seconds => Some(first),
        Timing::Alone => {
            let timed = time_alone(scene, column, IN_PASSING, limits.cancelled)?;
            Some(timed.ok_or(Refusal::Stopped)?.seconds)
        }
    };
    Ok(Ran {
        trace,
        sheet,
        seconds,
    })
}
