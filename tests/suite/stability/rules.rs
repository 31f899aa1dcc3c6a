//! Each rule on a trace with one thing planted in it, and each verdict reached.

use super::outcome;
use crate::support::{R, run, scenario};
use carom::compare::Comparison;
use carom::engine::Limits;
use carom::finding::{Tolerance, Verdict};
use carom::gate::{Kind, Row, diff};
use carom::math::Vec3;
use carom::oracle::{Allowance, Oracle};
use carom::physics::invariants::Invariant;
use carom::scene::{Scene, SetName, catalogue};
use carom::study::Watch;
use carom::study::stability::{
    Evidence, Judged, Judgement, Question, RULES, judge, presets, rule, study,
};
use carom::trace::{Ending, EventKind, Extremum, Record, Trace};
use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

/// Two balls head-on between cushions, on cloth: hits, a bounce, stops. Not in the middle, so that mirrors differ.
fn shot() -> Scene {
    scenario("planted")
        .moving("cue", [1.0, 1.0], [3.0, 0.0])
        .resting("1", [2.0, 1.0])
        .cloth(0.2)
        .cushions(4.0, 2.0)
        .build()
}

/// The same without anything that takes energy.
fn lossless() -> Scene {
    scenario("planted-lossless")
        .moving("cue", [1.0, 1.0], [3.0, 0.0])
        .resting("1", [2.0, 1.0])
        .duration(2.0)
        .build()
}

fn approaching(scene: &Scene) -> Trace {
    run(
        "stepper",
        &["contact=approaching-only"],
        scene,
        Record::Every(0.01),
    )
}

/// What is planted beside the trace.
#[derive(Default)]
struct Beside {
    promises: Vec<Invariant>,
    mirror: Option<f64>,
    relabelled: Option<f64>,
    reversal: Option<f64>,
}

fn judged(scene: &Scene, trace: &Trace, beside: &Beside) -> Judged {
    let oracle = Oracle::ask(scene, &Limits::NONE);
    let evidence = Evidence {
        scene,
        trace,
        promises: &beside.promises,
        allowance: Allowance {
            dt: trace.provenance.resolution,
            steps: trace.counters.get("steps").copied().unwrap_or(0),
            ulp: f64::EPSILON,
        },
        oracle: oracle.as_ref(),
        comparison: oracle
            .as_ref()
            .map(|o| Comparison::new(scene, trace, &o.trace).up_to(o.until)),
        events: true,
        mirror: beside.mirror,
        relabelled: beside.relabelled,
        reversal: beside.reversal,
    };
    judge(&evidence)
}

fn says(judged: &Judged, id: &str) -> Option<Judgement> {
    let own = judged.judgements.iter().find(|(r, _)| RULES[*r].id == id);
    own.map(|(_, judgement)| judgement.clone())
}

fn extremum(value: f64) -> Extremum {
    Extremum {
        value,
        time: 0.3,
        ball: Some(0),
        other: Some(1),
    }
}

#[test]
fn a_run_without_a_fault_holds_by_every_rule() {
    for scene in [shot(), lossless()] {
        let judged = judged(&scene, &approaching(&scene), &Beside::default());
        assert_eq!(judged.verdict, Verdict::Holds, "{judged:?}");
        assert_eq!(judged.why, "");
    }
}

#[test]
fn every_rule_finds_what_is_planted_for_it() {
    type Plant = fn(&mut Trace, &mut Beside);
    let unit = |scene: &Scene| scene.initial_energy();
    let whole = unit(&shot());
    assert!((whole - 0.5 * 0.107 * 9.0).abs() < 1e-12);
    let cases: [(&str, Scene, Plant, Verdict, &str); 18] = [
        (
            "finite",
            shot(),
            |t, _| t.paths[1].knots[1].state.position.x = f64::NAN,
            Verdict::Breaks,
            "ball 1",
        ),
        (
            "finite",
            shot(),
            |t, _| {
                t.ending = Ending::NotFinite(carom::trace::Spot {
                    time: 0.2,
                    balls: vec![0],
                    why: "planted".to_owned(),
                });
            },
            Verdict::Breaks,
            "planted",
        ),
        // 1e-3 of m v^2 / 2 = 0.4815
        (
            "energy-gained",
            shot(),
            |t, _| t.extrema.energy_gained = extremum(4.815e-4),
            Verdict::Breaks,
            "cue-1",
        ),
        (
            "energy-lost",
            lossless(),
            |t, _| halve_the_end(t),
            Verdict::Drifts,
            "loses",
        ),
        // a step moves the fastest ball by 0.003
        (
            "outside",
            shot(),
            |t, _| t.extrema.outside = extremum(0.01),
            Verdict::Breaks,
            "outside",
        ),
        // two balls are a group of two: beyond 2 v dt = 0.006 there is no drift
        (
            "overlap",
            shot(),
            |t, _| t.extrema.overlap = extremum(0.01),
            Verdict::Breaks,
            "cue-1",
        ),
        (
            "momentum",
            shot(),
            |t, _| t.extrema.momentum = extremum(1e-3),
            Verdict::Drifts,
            "cue-1",
        ),
        (
            "momentum",
            shot(),
            |t, b| {
                t.extrema.momentum = extremum(1e-3);
                b.promises.push(Invariant::Momentum);
            },
            Verdict::Breaks,
            "cue-1",
        ),
        (
            "still-moving",
            shot(),
            |t, _| {
                t.ending = Ending::Duration;
                let last = t.paths[1].knots.last_mut().unwrap();
                last.state.velocity.x = 0.1;
            },
            Verdict::Breaks,
            "by the law of friction",
        ),
        // head-on, so 2 R deep: no graze
        (
            "order",
            shot(),
            |t, _| t.events.retain(|e| e.kind != EventKind::BallBall(0, 1)),
            Verdict::Breaks,
            "misses cue-1",
        ),
        (
            "order",
            lossless(),
            |t, _| {
                let mut again = *t.collisions().next().unwrap();
                again.time += 1.0;
                t.events.push(again);
            },
            Verdict::Breaks,
            "which exact misses by",
        ),
        // more than a radius is more than any step explains
        (
            "from-exact",
            lossless(),
            |t, _| move_the_end(t, 1.5 * R),
            Verdict::Drifts,
            "ball 1",
        ),
        (
            "stop-time",
            shot(),
            |t, _| t.stop_times[1] = t.stop_times[1].map(|s| s + 5.0),
            Verdict::Drifts,
            "stops",
        ),
        (
            "mirror",
            shot(),
            |_, b| b.mirror = Some(3.0),
            Verdict::Drifts,
            "3.00 R",
        ),
        (
            "mirror",
            shot(),
            |_, b| {
                b.mirror = Some(3.0);
                b.promises.push(Invariant::Mirror);
            },
            Verdict::Breaks,
            "3.00 R",
        ),
        (
            "relabelling",
            shot(),
            |_, b| b.relabelled = Some(3.0),
            Verdict::Drifts,
            "in reverse",
        ),
        (
            "time-reversal",
            lossless(),
            |_, b| {
                b.reversal = Some(3.0);
                b.promises.push(Invariant::TimeReversal);
            },
            Verdict::Breaks,
            "forth and back",
        ),
        (
            "answer",
            shot(),
            |t, _| {
                t.ending = Ending::Indeterminate(carom::trace::Spot {
                    time: 0.2,
                    balls: vec![0, 1],
                    why: "planted".to_owned(),
                });
            },
            Verdict::Indeterminate,
            "planted",
        ),
    ];
    let mut seen = BTreeSet::new();
    for (id, scene, plant, verdict, words) in cases {
        let mut trace = approaching(&scene);
        let mut beside = Beside::default();
        plant(&mut trace, &mut beside);
        let judged = judged(&scene, &trace, &beside);
        let said = says(&judged, id).unwrap_or_else(|| panic!("{id} says nothing: {judged:?}"));
        assert_eq!(said.verdict, Some(verdict), "{id}: {said:?}");
        assert!(said.why.contains(words), "{id}: {}", said.why);
        assert!(judged.verdict >= verdict, "{id}: {judged:?}");
        seen.insert(id);
    }
    let all: BTreeSet<&str> = RULES.iter().map(|rule| rule.id).collect();
    assert_eq!(seen, all);
}

fn halve_the_end(trace: &mut Trace) {
    for path in &mut trace.paths {
        path.knots.last_mut().unwrap().state.velocity *= 0.5;
    }
}

fn move_the_end(trace: &mut Trace, by: f64) {
    trace.paths[1].knots.last_mut().unwrap().state.position += Vec3::new(0.0, by, 0.0);
}

#[test]
fn the_worst_verdict_speaks_and_of_several_the_first_rule() {
    let scene = shot();
    let mut trace = approaching(&scene);
    trace.extrema.momentum = extremum(1e-3);
    trace.extrema.outside = extremum(0.01);
    trace.extrema.energy_gained = extremum(4.815e-4);
    let judged = judged(&scene, &trace, &Beside::default());
    assert_eq!(judged.verdict, Verdict::Breaks);
    assert_eq!(judged.spoken().unwrap().0.id, "energy-gained");
    assert!(
        judged.why.contains("gains 0.00100 of its energy"),
        "{}",
        judged.why
    );
}

#[test]
fn a_reversal_that_nobody_promised_is_a_figure_without_a_verdict() {
    let scene = lossless();
    let beside = Beside {
        reversal: Some(3.0),
        ..Beside::default()
    };
    let judged = judged(&scene, &approaching(&scene), &beside);
    let said = says(&judged, "time-reversal").unwrap();
    assert_eq!((said.verdict, said.value), (None, Some(3.0)));
    assert_eq!(judged.verdict, Verdict::Holds);
}

#[test]
fn an_order_that_the_step_explains_drifts_and_a_step_over_a_ball_breaks() {
    // two hits 82 us apart, looked at every 1000 us
    let drifts = outcome(&["report-break"], &["stepper contact=approaching-only"]);
    // a ball that goes seven radii in a step, over the ball in its way
    let breaks = outcome(&["through-a-ball"], &["stepper contact=approaching-only"]);
    for (outcome, verdict, words) in [
        (drifts, Verdict::Drifts, "has 1-2 before 1-3"),
        (breaks, Verdict::Breaks, "misses cue-1"),
    ] {
        let judged = outcome.cases[0].judged.as_ref().unwrap();
        assert_eq!(judged.verdict, verdict, "{judged:?}");
        assert_eq!(judged.spoken().unwrap().0.id, "order");
        assert!(judged.why.contains(words), "{}", judged.why);
    }
}

#[test]
fn a_refusal_cannot_be_expressed_and_nothing_is_measured_of_it() {
    let outcome = outcome(&["heavy-into-light"], &["stepper"]);
    let judged = outcome.cases[0].judged.as_ref().unwrap();
    assert_eq!(judged.verdict, Verdict::CannotExpress);
    assert!(judged.why.contains("equal masses"), "{}", judged.why);
    let findings = outcome.findings(0);
    assert!(findings.iter().all(|finding| finding.value.is_none()));
}

#[test]
fn our_models_break_no_promise_in_any_hard_case() {
    let scenes: Vec<&str> = catalogue::all()
        .iter()
        .filter(|entry| {
            let sets = entry.scene().unwrap().sets;
            sets.contains(&SetName::Hard) && !sets.contains(&SetName::Full)
        })
        .map(|entry| entry.name)
        .collect();
    assert!(scenes.len() >= 40, "{}", scenes.len());
    let outcome = outcome(&scenes, &["exact"]);
    assert_eq!(outcome.broken_promises(), Vec::<String>::new());
    assert_eq!(outcome.count(Verdict::Breaks, |_| true), 0);
    assert_eq!(outcome.done(), outcome.asked);
}

#[test]
fn findings_are_the_same_for_one_thread_and_for_two() {
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            let outcome = outcome(
                &["thin-cut-1e-6", "cradle-3", "triple-hit"],
                &["stepper", "exact", "rapier-f32 preset=stock"],
            );
            (0..3)
                .map(|scene| outcome.findings(scene))
                .collect::<Vec<_>>()
        })
    };
    let (one, two) = (with(1), with(2));
    assert!(one.iter().all(|findings| findings.len() > 20));
    assert_eq!(one, two);
}

#[test]
fn every_number_is_held_to_less_than_one_percent_and_a_thousandth() {
    let outcome = outcome(
        &["cradle-3", "thin-cut-1e-6"],
        &["stepper", "exact", "rapier-f64 preset=stock", "rapier-f32"],
    );
    let mut held = 0;
    for scene in 0..2 {
        let rows: Vec<Row> = outcome.findings(scene).iter().map(Row::from).collect();
        let tolerance = |row: &Row| outcome.tolerance(&row.engine, &row.check);
        assert_eq!(diff(&rows, &rows, tolerance), []);
        for at in 0..rows.len() {
            let Some(value) = rows[at].value else {
                continue;
            };
            for sign in [1.0, -1.0] {
                let mut moved = rows.clone();
                moved[at].value = Some(value + sign * (0.01 * value.abs() + 1e-3));
                let changes = diff(&rows, &moved, tolerance);
                let kinds: Vec<Kind> = changes.iter().map(|change| change.kind).collect();
                assert_eq!(kinds, [Kind::Moved], "{:?}", rows[at]);
                held += 1;
            }
        }
    }
    assert!(held > 100, "{held}");
}

#[test]
fn a_matrix_that_is_stopped_says_so_and_keeps_what_it_has() {
    let stop = AtomicBool::new(false);
    let progress = |_: usize, total: usize, _: &str| {
        // the oracle is one task; the first cell stops the rest
        if total > 1 {
            stop.store(true, std::sync::atomic::Ordering::Relaxed);
        }
    };
    let question = Question {
        roster: crate::support::roster().clone(),
        scenes: vec![catalogue::scene("head-on").unwrap()],
        presets: presets(crate::support::roster()),
        full: false,
        pictures: false,
    };
    let watch = Watch {
        progress: &progress,
        cancelled: &stop,
    };
    let outcome = study(question, watch).unwrap();
    assert!(outcome.is_cut_short());
    assert!(
        outcome.done() >= 1 && outcome.done() < outcome.asked,
        "{}",
        outcome.done()
    );
    assert!(!Watch::NONE.is_cancelled());
}

#[test]
fn every_rule_has_a_name_a_meaning_and_a_unit_or_counts() {
    let names: BTreeSet<&str> = RULES.iter().map(|rule| rule.id).collect();
    assert_eq!(names.len(), RULES.len());
    for known in RULES {
        assert!(carom::scene::is_kebab_case(known.id), "{}", known.id);
        assert!(!known.what().is_empty(), "{}", known.id);
        assert_eq!(known.unit.is_empty(), known.counts, "{}", known.id);
        let tolerance = known.tolerance(f64::EPSILON);
        assert_eq!(tolerance == Tolerance::None, known.counts, "{}", known.id);
        assert!(rule(known.id).is_some());
    }
}
