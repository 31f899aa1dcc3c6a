//! The study behind the gate: what it finds on which level, with engines that do wrong planted in it.

use super::SCENES;
use carom::engine::stepper::Stepper;
use carom::engine::{
    About, Engine, Inside, Knob, Limits, Name, Pace, Parameter, Refusal, Run, Setting,
};
use carom::gate::{Accepted, Held, Refused};
use carom::physics::invariants::Invariant;
use carom::scene::{Scene, catalogue};
use carom::study::check::{CheckOutcome, HELD, Level, ORACLE, State, WRITTEN, level, study};
use carom::study::compare::default_columns;
use carom::study::{Configuration, Watch};
use carom::trace::{Record, Trace};
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

fn outcome(scenes: &[&str], columns: &[Configuration]) -> CheckOutcome {
    let named = scenes.iter().map(|name| catalogue::scene(name).unwrap());
    let watch = Watch::NONE;
    study(
        crate::support::roster(),
        &named.collect::<Vec<_>>(),
        columns,
        watch,
    )
    .unwrap()
}

/// A stepper whose trace is changed after the run, under the stepper's own name.
struct Planted(fn(&mut Trace));

struct PlantedRun<'a> {
    run: Box<dyn Run + 'a>,
    plant: fn(&mut Trace),
}

impl Engine for Planted {
    fn id(&self) -> &str {
        Stepper.id()
    }
    fn version(&self) -> String {
        Stepper.version()
    }
    fn about(&self) -> About {
        Stepper.about()
    }
    fn knobs(&self) -> Vec<Knob> {
        Stepper.knobs()
    }
    fn missing(&self, scene: &Scene) -> Vec<Name> {
        Stepper.missing(scene)
    }
    fn promises(&self, scene: &Scene, setting: &Setting) -> Vec<Invariant> {
        Stepper.promises(scene, setting)
    }
    fn ladders(&self) -> Vec<(Name, Vec<Setting>)> {
        Stepper.ladders()
    }
    fn pace(&self, scene: &Scene, setting: &Setting) -> Result<Pace, Refusal> {
        Stepper.pace(scene, setting)
    }
    fn ablations(&self, scene: &Scene, setting: &Setting) -> Vec<(Name, Setting)> {
        Stepper.ablations(scene, setting)
    }
    fn prepare<'a>(
        &self,
        scene: &'a Scene,
        setting: &Setting,
    ) -> Result<Box<dyn Run + 'a>, Refusal> {
        Ok(Box::new(PlantedRun {
            run: Stepper.prepare(scene, setting)?,
            plant: self.0,
        }))
    }
}

impl Run for PlantedRun<'_> {
    fn inside(&self) -> Inside {
        self.run.inside()
    }
    fn sheet(&self) -> Vec<Parameter> {
        self.run.sheet()
    }
    fn simulate(self: Box<Self>, record: Record, limits: &Limits<'_>) -> Trace {
        let mut trace = self.run.simulate(record, limits);
        (self.plant)(&mut trace);
        trace
    }
}

/// A run of the stepper with something planted, held against the plain one.
fn held(scenes: &[&str], planted: &Planted) -> Held {
    let column = |engine: Arc<dyn Engine>| [Configuration::of(&engine)];
    let plain = outcome(scenes, &column(Arc::new(Stepper)));
    let accepted = |scene: &Scene| {
        Some(Accepted {
            scene: scene.name.clone(),
            hash: scene.hash(),
            reason: "for a test".to_owned(),
            versions: Vec::new(),
            bits: Vec::new(),
            rows: plain
                .of_scene(&scene.name)
                .map(carom::gate::Row::from)
                .collect(),
        })
    };
    let accepted = plain.scenes.iter().map(accepted).collect();
    Held::new(
        outcome(scenes, &column(Arc::new(Planted(planted.0)))),
        accepted,
        Vec::new(),
    )
}

/// Levels of what changed.
fn levels(held: &Held) -> BTreeSet<Level> {
    let rows = held.changes.iter().filter_map(|l| l.change.row());
    rows.map(|row| level(&row.check)).collect()
}

#[test]
fn each_level_sees_what_is_planted_for_it() {
    static NOTHING: Planted = Planted(|_| {});
    static MOMENTUM: Planted = Planted(|trace| trace.extrema.momentum.value = 1.0);
    static STOPS_LATER: Planted = Planted(|trace| {
        for time in trace.stop_times.iter_mut().flatten() {
            *time += 1e-6;
        }
    });
    static ONE_STEP_MORE: Planted = Planted(|trace| {
        *trace.counters.get_mut("steps").unwrap() += 1;
    });
    let cases: [(&'static Planted, &[Level]); 4] = [
        (&NOTHING, &[]),
        (&MOMENTUM, &[Level::Promise, Level::Error]),
        (&STOPS_LATER, &[Level::Error]),
        (&ONE_STEP_MORE, &[Level::Work]),
    ];
    for (planted, expected) in cases {
        let held = held(&["head-on"], planted);
        assert_eq!(levels(&held), expected.iter().copied().collect());
        let standing = held.standing();
        assert_eq!(
            standing.broken_promises > 0,
            expected.contains(&Level::Promise)
        );
    }
}

#[test]
fn a_broken_promise_is_named_and_never_accepted() {
    static MOMENTUM: Planted = Planted(|trace| trace.extrema.momentum.value = 1.0);
    let held = held(&["head-on"], &MOMENTUM);
    let [broken] = &held.outcome.broken[..] else {
        panic!("{:?}", held.outcome.broken);
    };
    assert_eq!(broken.what, Invariant::Momentum.id());
    assert!(broken.why.contains("m v0"), "{}", broken.why);
    assert_eq!(held.standing().acceptance(), Err(Refused::BrokenPromise(1)));
}

#[test]
fn a_rerun_with_other_bits_breaks_the_promise_of_a_rerun() {
    static TURN: AtomicBool = AtomicBool::new(false);
    // every other run ends an instant later
    static FICKLE: Planted = Planted(|trace| {
        if TURN.fetch_xor(true, Ordering::Relaxed) {
            trace.end_time += 1e-12;
        }
    });
    let held = held(&["head-on"], &FICKLE);
    let broken: Vec<&str> = held.outcome.broken.iter().map(|b| b.what).collect();
    assert_eq!(broken, [Invariant::Rerun.id()]);
}

#[test]
fn every_case_of_the_small_scenes_runs_or_says_why_not() {
    let outcome = outcome(&SCENES, &default_columns(crate::support::roster()));
    assert_eq!(outcome.missing(), 0);
    assert_eq!(outcome.broken, []);
    // per scene: the oracle, and five columns on three levels or, if hard, four; the hard one asks for seven settings more
    assert_eq!(outcome.cases.len(), 3 + 2 * 15 + 20 + 28);
    for case in &outcome.cases {
        let found = outcome.findings.iter().any(|f| {
            f.scene == case.scene && f.engine == case.engine && level(f.metric) == case.level
        });
        assert_eq!(found, case.state == State::Ran, "{case:?}");
    }
    let oracle = outcome.findings.iter().filter(|f| f.engine == ORACLE);
    assert!(oracle.count() > 10);
}

#[test]
fn what_was_stopped_has_missing_cases_and_is_held_against_nothing() {
    let scenes = [catalogue::scene("head-on").unwrap()];
    let stopped = AtomicBool::new(true);
    let watch = Watch {
        progress: &|_, _, _| {},
        cancelled: &stopped,
    };
    let outcome = study(
        crate::support::roster(),
        &scenes,
        &default_columns(crate::support::roster()),
        watch,
    )
    .unwrap();
    assert!(!outcome.cases.is_empty());
    assert_eq!(outcome.missing(), outcome.cases.len());
    let held = Held::new(outcome, vec![Some(Accepted::default())], Vec::new());
    assert_eq!(held.changes, []);
    // nothing is held of what did run, either
    for level in Level::ALL {
        let against = held.against("slide", "exact", level);
        assert_eq!(against, carom::page::check::Against::NotHeld);
    }
    assert_eq!(held.standing().acceptance(), Err(Refused::CutShort));
}

#[test]
fn what_is_held_has_unique_names_apart_from_those_of_metrics() {
    let ids: Vec<&str> = HELD
        .iter()
        .map(|held| held.id)
        .chain(WRITTEN.iter().map(|held| held.id))
        .chain(carom::compare::METRICS.iter().map(|metric| metric.id))
        .collect();
    let unique: BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(unique.len(), ids.len());
    let all = HELD.iter().chain(WRITTEN);
    assert!(all.clone().count() > 20 && all.clone().all(|held| !held.what.is_empty()));
}
