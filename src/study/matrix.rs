//! The run matrix: scenes, or samples of one, are rows; engines with a setting are columns. The only place for threads and the stopwatch.

use crate::engine::{self, Engine, Limits, Parameter, Refusal, Setting};
use crate::scene::Scene;
use crate::trace::{Ending, Record, Trace};
use rayon::prelude::*;
use std::fmt;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Instant;

/// One engine with one setting.
#[derive(Clone)]
pub struct Column {
    /// The engine.
    pub engine: &'static dyn Engine,
    /// Its setting; empty for the defaults.
    pub setting: Setting,
}

impl Column {
    /// A column with every default.
    pub fn of(engine: &'static dyn Engine) -> Self {
        Column {
            engine,
            setting: Setting::default(),
        }
    }

    /// Name of engine and setting: `stepper contact=approaching-only`.
    pub fn label(&self) -> String {
        format!("{} {}", self.engine.id(), self.setting)
            .trim_end()
            .to_owned()
    }
}

impl fmt::Debug for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.label())
    }
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

/// One cell: what ran, or why nothing did.
pub type Cell = Result<Ran, Refusal>;

/// What the person at the terminal is told and may ask for while a matrix runs.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Called with the number of cells that are done, the number of all, and the label of the one just done.
    pub progress: &'a (dyn Fn(usize, usize, &str) + Sync),
    /// Set when the user asks to stop.
    pub cancelled: &'a AtomicBool,
}

impl Watch<'_> {
    /// True once the user asked to stop.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
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

/// Runs that take longer than this are timed once, s; shorter ones as often as fits into it.
const ENOUGH_SECONDS: f64 = 0.05;
const MOST_REPEATS: usize = 20;

/// Runs one scene in every column. Answers one cell a column, in order, for any number of threads.
pub fn run_row(
    scene: &Scene,
    columns: &[Column],
    record: Record,
    timing: Timing,
    watch: Watch<'_>,
) -> Vec<Cell> {
    let done = AtomicUsize::new(0);
    let run = |column: &Column| {
        let cell = run_cell(scene, column, record, timing, watch.cancelled);
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

/// How often the progress of many short cells is told.
const TOLD: usize = 200;

/// Runs samples of one scene in every column, untimed, and keeps of each cell only what `reduce` makes of it.
///
/// `sample`: the scene of a sample; it must depend on the index alone. Answers for each sample one value a column, in order,
/// the same for any number of threads. `None`: a cell that was not run to its end because the user asked to stop.
pub fn run_samples<T: Send>(
    samples: usize,
    sample: impl Fn(usize) -> Scene + Sync,
    columns: &[Column],
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
        let trace = ran.map(|ran| ran.trace);
        if matches!(&trace, Ok(trace) if trace.ending == Ending::Cancelled) {
            return None;
        }
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        if count.is_multiple_of(often) || count == cells {
            (watch.progress)(count, cells, &format!("samples of {}", scene.name));
        }
        Some(reduce(trace))
    };
    (0..cells).into_par_iter().map(run).collect()
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
    pub fn run(&self, scene: &Scene, column: &Column, record: Record) -> Cell {
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
    let mut longest_first: Vec<usize> = (0..tasks.len()).collect();
    longest_first.sort_by(|&a, &b| tasks[b].cost.total_cmp(&tasks[a].cost));
    let done = AtomicUsize::new(0);
    let run = |index: usize| {
        if watch.is_cancelled() {
            return (index, None);
        }
        let answer = conclude(index, runner);
        // what was cut short says nothing
        if watch.is_cancelled() {
            return (index, None);
        }
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        (watch.progress)(count, tasks.len(), &tasks[index].label);
        (index, Some(answer))
    };
    // a bridge hands tasks out one by one in this order
    let mut answers: Vec<(usize, Option<T>)> =
        longest_first.into_iter().par_bridge().map(run).collect();
    answers.sort_by_key(|(index, _)| *index);
    answers.into_iter().map(|(_, answer)| answer).collect()
}

/// Runs one scene in one column.
fn run_cell(
    scene: &Scene,
    column: &Column,
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
    column: &Column,
    record: Record,
    timing: Timing,
    limits: &Limits<'_>,
) -> Cell {
    let run = engine::prepare(column.engine, scene, &column.setting)?;
    let sheet = run.sheet();
    let start = Instant::now();
    let trace = run.simulate(record, limits);
    let first = start.elapsed().as_secs_f64();
    let seconds = match timing {
        Timing::None => None,
        Timing::Alone => Some(shortest_of_several(scene, column, first, limits)),
    };
    Ok(Ran {
        trace,
        sheet,
        seconds,
    })
}

/// The shortest time of a run, s: of the first one if that was long, else of as many as fit into a moment.
fn shortest_of_several(scene: &Scene, column: &Column, first: f64, limits: &Limits<'_>) -> f64 {
    let (mut best, mut spent) = (first, first);
    for _ in 0..MOST_REPEATS {
        if spent + best > ENOUGH_SECONDS || limits.is_cancelled() {
            break;
        }
        // set-up is outside the stopwatch
        let Ok(run) = engine::prepare(column.engine, scene, &column.setting) else {
            break;
        };
        let start = Instant::now();
        run.simulate(Record::Final, limits);
        let seconds = start.elapsed().as_secs_f64();
        spent += seconds;
        best = best.min(seconds);
    }
    best
}
