//! What a study of cost runs: families of settings from coarse to fine, and how often each.
//!
//! An error of a stepping engine depends on where within a step each hit falls, so a single run at each step gives a saw-tooth. Each
//! level is run from several starts, shifted by parts of its step along the exact motion. That moves all hits within their steps
//! together; hits of a rack that follow each other within some steps keep their places relative to each other, and with them part of
//! the saw-tooth.

use crate::engine::{self, Name, Pace, Refusal, Roster, Setting};
use crate::scene::Scene;
use crate::study::Configuration;
use crate::trace::Trace;

/// How much is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grid {
    /// Every family; of each as many levels as fit into seconds.
    Small,
    /// Every level of every family, from more starts.
    Full,
}

/// What a grid spends. Work is counted by [`Pace::cost`], not by the clock, so that a slow machine runs the same grid.
struct Budget {
    /// Shifted starts of a level.
    phases: usize,
    /// The fewest of them, where a run is long.
    least_phases: usize,
    /// Work for all starts of a level, ns.
    level: f64,
    /// Work of the families that go deep, ns: the first ones whose work together fits into it.
    deep: f64,
    /// Work of one run beyond which a level of them is left out, ns.
    deep_run: f64,
    /// The same for all other families, ns.
    run: f64,
}

impl Grid {
    /// Word of `--grid`.
    pub fn id(self) -> &'static str {
        match self {
            Grid::Small => "small",
            Grid::Full => "full",
        }
    }

    /// Both grids.
    pub const ALL: [Grid; 2] = [Grid::Small, Grid::Full];

    /// The grid called `id`.
    pub fn find(id: &str) -> Option<Grid> {
        Grid::ALL.into_iter().find(|grid| grid.id() == id)
    }

    fn budget(self) -> Budget {
        match self {
            Grid::Small => Budget {
                phases: 8,
                least_phases: 4,
                level: 1e9,
                deep: 28e9,
                deep_run: 0.5e9,
                run: 0.08e9,
            },
            Grid::Full => Budget {
                phases: 32,
                least_phases: 8,
                level: 20e9,
                deep: f64::INFINITY,
                deep_run: f64::INFINITY,
                run: f64::INFINITY,
            },
        }
    }
}

/// Work that a level costs beyond its starts, in runs: warming up and timing.
pub const TIMING_RUNS: f64 = 3.0;

/// Settings of one engine from coarse to fine.
#[derive(Clone, Debug)]
pub struct Family {
    /// Name of the ladder.
    pub name: Name,
    /// The key that is refined; `None` if more than one differs.
    pub knob: Option<String>,
    /// From coarse to fine; all of one engine.
    pub levels: Vec<Level>,
    /// Settings of the ladder that the grid leaves out because they take too long.
    pub left_out: Vec<Setting>,
    /// Why none of it can run; `None` if it can.
    pub refusal: Option<Refusal>,
    /// The engine, with what is the same at all levels because the user said so.
    pub given: Configuration,
}

/// One setting of a family.
#[derive(Clone, Debug)]
pub struct Level {
    /// Engine and setting.
    pub column: Configuration,
    /// What is refined, getting smaller from level to level: the value of the knob, or one over it. `None` if it is no number.
    pub size: Option<f64>,
    /// How the engine goes through time.
    pub pace: Pace,
    /// Number of shifted starts.
    pub phases: usize,
}

impl Family {
    /// `ENGINE LADDER`, unique among the families of one set of columns.
    pub fn label(&self) -> String {
        format!(
            "{} {} {}",
            self.given.engine.id(),
            self.name,
            self.given.setting
        )
        .trim_end()
        .to_owned()
    }

    /// What stands for an engine that refuses what was set for it, whatever the ladder.
    fn refused(column: &Configuration, refusal: Refusal) -> Family {
        Family {
            name: "any".into(),
            knob: None,
            levels: Vec::new(),
            left_out: Vec::new(),
            refusal: Some(refusal),
            given: column.clone(),
        }
    }

    fn leave_out(&mut self, too_long: impl Fn(&Level) -> bool) {
        let (out, kept): (Vec<Level>, Vec<Level>) = self.levels.drain(..).partition(too_long);
        self.levels = kept;
        let out = out.into_iter().map(|level| level.column.setting);
        self.left_out = out.chain(self.left_out.drain(..)).collect();
    }
}

impl Level {
    /// Work of all its runs, ns. `until`: simulated time of the scene, s.
    pub fn work(&self, until: f64) -> f64 {
        self.pace.cost * until * (self.phases as f64 + TIMING_RUNS)
    }
}

/// The families of every column, or of every engine if none is named. What a column sets is the same at every level.
///
/// `until`: simulated time of the scene, s.
pub fn families(
    roster: &Roster,
    scene: &Scene,
    named: &[Configuration],
    grid: Grid,
    until: f64,
) -> Vec<Family> {
    let all: Vec<Configuration> = roster.iter().map(Configuration::of).collect();
    let columns = if named.is_empty() { &all } else { named };
    let budget = grid.budget();
    let mut families: Vec<Family> = Vec::new();
    let mut deep = 0.0;
    for column in columns {
        let ready = column.engine.prepare(scene, &column.setting);
        // what it lacks is said of each ladder
        if let Err(refusal @ Refusal::Setting { .. }) = ready {
            families.push(Family::refused(column, refusal));
            continue;
        }
        for (name, ladder) in column.engine.ladders() {
            let mut settings: Vec<Setting> = Vec::new();
            for step in ladder {
                let setting = over(step, &column.setting);
                if !settings.contains(&setting) {
                    settings.push(setting);
                }
            }
            let same = |family: &Family| {
                let kept = family.levels.iter().map(|level| &level.column.setting);
                let known = kept.chain(&family.left_out);
                family.given.engine.id() == column.engine.id() && known.eq(settings.iter())
            };
            // a given key can make two ladders the same, or leave one rung
            if (settings.len() > 1 || named.is_empty()) && !families.iter().any(same) {
                let mut family = family(scene, column, name, settings, &budget, until);
                family.leave_out(|level| level.pace.cost * until > budget.deep_run);
                let work: f64 = family.levels.iter().map(|level| level.work(until)).sum();
                if deep + work <= budget.deep {
                    deep += work;
                } else {
                    family.leave_out(|level| level.pace.cost * until > budget.run);
                }
                families.push(family);
            }
        }
    }
    families
}

/// `ladder` with the keys of `given` in place of its own.
fn over(ladder: Setting, given: &Setting) -> Setting {
    let pairs = given.values.iter();
    pairs.fold(ladder, |setting, (key, value)| setting.with(key, value))
}

fn family(
    scene: &Scene,
    column: &Configuration,
    name: Name,
    settings: Vec<Setting>,
    budget: &Budget,
    until: f64,
) -> Family {
    let knob = knob(&settings);
    let mut family = Family {
        name,
        levels: Vec::new(),
        left_out: Vec::new(),
        refusal: None,
        given: column.clone(),
        knob: knob.clone(),
    };
    let values = knob.as_ref().and_then(|knob| numbers(&settings, knob));
    for (k, setting) in settings.into_iter().enumerate() {
        // what cannot be prepared at all says so at its coarsest level
        let ready = match k {
            0 => engine::prepare(column.engine.as_ref(), scene, &setting).map(|_| ()),
            _ => Ok(()),
        };
        let pace = match ready.and_then(|()| column.engine.pace(scene, &setting)) {
            Ok(pace) => pace,
            Err(refusal) => {
                family.refusal = Some(refusal);
                return family;
            }
        };
        let affordable = (budget.level / (pace.cost * until)) as usize;
        let phases = if pace.step > 0.0 {
            affordable.clamp(budget.least_phases, budget.phases)
        } else {
            1
        };
        family.levels.push(Level {
            column: Configuration::with(&column.engine, setting),
            size: values.as_ref().map(|values| values[k]),
            pace,
            phases,
        });
    }
    family
}

/// The one key whose value differs between the settings.
fn knob(settings: &[Setting]) -> Option<String> {
    let first = settings.first()?;
    let differs = |key: &&String| {
        let value = |setting: &Setting| setting.values.get(*key).cloned();
        settings
            .iter()
            .any(|setting| value(setting) != value(first))
    };
    let mut keys: Vec<&String> = settings
        .iter()
        .flat_map(|setting| setting.values.keys())
        .collect();
    keys.sort();
    keys.dedup();
    let mut differing = keys.into_iter().filter(differs);
    match (differing.next(), differing.next()) {
        (Some(key), None) => Some(key.clone()),
        _ => None,
    }
}

/// Values of a knob as sizes that fall from level to level; `None` if they are no numbers or go both ways.
fn numbers(settings: &[Setting], knob: &str) -> Option<Vec<f64>> {
    let value = |setting: &Setting| {
        setting
            .values
            .get(knob)?
            .parse::<f64>()
            .ok()
            .filter(|x| *x > 0.0)
    };
    let values: Vec<f64> = settings.iter().map(value).collect::<Option<_>>()?;
    let falls = |values: &[f64]| values.windows(2).all(|pair| pair[1] < pair[0]);
    if falls(&values) {
        return Some(values);
    }
    // a number of substeps rises as they get shorter
    let inverse: Vec<f64> = values.iter().map(|x| 1.0 / x).collect();
    falls(&inverse).then_some(inverse)
}

/// The scene as it is on its exact way, part `phase` of `step` after its start; `None` where the exact run does not say.
///
/// `exact`: the run of the scene. Where it ends before `step`, as with touching balls, the shift goes up to half of it.
pub fn shifted(scene: &Scene, exact: &Trace, step: f64, phase: f64) -> Option<Scene> {
    let reach = if exact.ending.is_complete() {
        step
    } else {
        step.min(0.5 * exact.end_time)
    };
    let mut shifted = scene.clone();
    for (i, ball) in shifted.balls.iter_mut().enumerate() {
        ball.state = exact.in_play_at(i, phase * reach)?;
    }
    Some(shifted)
}
