//! What the comparison says of traces whose differences are known.

use crate::support::{G, MU, R, report_break, run, scenario};
use approx::assert_relative_eq;
use carom::compare::{Comparison, METRICS, attribute, deepest_overlap, of_pair, of_trace, timing};
use carom::engine::{Limits, Setting};
use carom::finding::{Block, Cell};
use carom::math::Vec3;
use carom::oracle::Precision;
use carom::oracle::{BAND, horizon};
use carom::scene::{Scene, catalogue};
use carom::study::compare::{Cause, ComparisonOutcome, default_columns, plan, study};
use carom::study::{Configuration, Timing, Watch};
use carom::trace::{EventKind, Record, Trace};

fn exact(scene: &Scene) -> Trace {
    run("exact", &[], scene, Record::Events)
}

fn compared(scene: &Scene, columns: &[(&str, &str)]) -> ComparisonOutcome {
    let column = |&(engine, setting): &(&str, &str)| Configuration {
        engine: crate::support::find(engine).unwrap().clone(),
        setting: Setting::parse(setting.split_whitespace()).unwrap(),
    };
    let columns: Vec<Configuration> = columns.iter().map(column).collect();
    let watch = Watch::NONE;
    study(
        scene,
        None,
        &plan(crate::support::roster(), &columns),
        Timing::None,
        watch,
    )
}

#[test]
fn a_trace_does_not_differ_from_itself() {
    let scene = report_break(1e-2 * R, 90.2);
    let trace = exact(&scene);
    let comparison = Comparison::new(&scene, &trace, &trace);
    assert_eq!(comparison.order.strict, trace.collisions().count());
    assert!(comparison.order.strict > 10 && comparison.order.parting.is_none());
    let (zero, count) = ("is 0 against itself", comparison.order.strict as f64);
    for finding in of_pair(&comparison, "exact") {
        let wanted = match finding.metric {
            "order-strict" | "order-tolerant" | "order-of" => count,
            _ => 0.0,
        };
        assert_eq!(
            finding.value,
            Some(wanted),
            "{} {}: {zero}",
            finding.metric,
            finding.subject
        );
    }
}

#[test]
fn a_slide_is_a_t_dt_over_2_short_and_stops_within_a_step() {
    let scene = scenario("slide")
        .moving("cue", [0.0, 0.0], [0.0, 4.0])
        .cloth(MU)
        .build();
    let (dt, a) = (1e-3, MU * G);
    let trace = run("stepper", &["dt=1e-3"], &scene, Record::Every(0.01));
    let reference = exact(&scene);
    let findings = of_pair(&Comparison::new(&scene, &trace, &reference), "stepper");
    let value = |metric: &str| {
        findings
            .iter()
            .find(|f| f.metric == metric)
            .unwrap()
            .value
            .unwrap()
    };
    // at the stop t = v/a, so the error a t dt / 2 is v dt / 2, up to a dt^2 / 8 in the last step: a dt / (4 v) of it
    let predicted = 4.0 * dt / 2.0 / R;
    assert_relative_eq!(
        value("final-position"),
        predicted,
        max_relative = a * dt / 4.0
    );
    assert!(
        value("stop-time") <= dt,
        "stops {} s late",
        value("stop-time")
    );
}

#[test]
fn timing_is_the_shift_of_a_hit_times_its_closing_speed() {
    let scene = scenario("hit")
        .moving("a", [0.0, 0.0], [2.0, 0.0])
        .resting("b", [1.0, 0.0])
        .duration(1.0)
        .build();
    let reference = exact(&scene);
    let mut late = reference.clone();
    let hit = late
        .events
        .iter()
        .position(|e| e.kind == EventKind::BallBall(0, 1))
        .unwrap();
    late.events[hit].time += 0.01;
    let comparison = Comparison::new(&scene, &late, &reference);
    // 10 ms late at a closing speed of 2
    assert_relative_eq!(timing(&comparison).unwrap(), 0.02, max_relative = 1e-12);
    assert_relative_eq!(
        attribute(&comparison).timing.unwrap(),
        0.02 / R,
        max_relative = 1e-12
    );
    assert_eq!(
        (
            comparison.order.late,
            comparison.order.missed,
            comparison.order.phantom
        ),
        (1, 0, 0)
    );
}

#[test]
fn a_moved_ball_is_found_with_its_owner_and_distance() {
    let scene = report_break(1e-2 * R, 90.2);
    let reference = exact(&scene);
    let mut moved = reference.clone();
    let last = moved.paths[7].knots.last_mut().unwrap();
    last.state.position += Vec3::new(0.3 * R, 0.4 * R, 0.0);
    let findings = of_pair(&Comparison::new(&scene, &moved, &reference), "moved");
    let far = findings
        .iter()
        .filter(|f| f.metric == "final-position" && f.value.unwrap() > 0.0);
    let far: Vec<_> = far
        .map(|f| (f.subject.as_str(), f.value.unwrap()))
        .collect();
    assert_eq!(far.len(), 1);
    assert_eq!(far[0].0, moved.balls[7]);
    assert_relative_eq!(far[0].1, 0.5, max_relative = 1e-12);
}

#[test]
fn swapped_hits_within_the_step_are_explained_by_the_resolution() {
    // two pairs far apart, hit 0.3 ms after each other: a step of 10 ms cannot order them, and they share no ball
    let scene = scenario("two-pairs")
        .moving("a", [0.0, 0.0], [1.0, 0.0])
        .resting("b", [1.0003, 0.0])
        .moving("c", [0.0, 5.0], [1.0, 0.0])
        .resting("d", [1.0, 5.0])
        .duration(2.0)
        .build();
    let outcome = compared(&scene, &[("stepper", "dt=0.01")]);
    let standing = outcome.entries[1].standing.as_ref().unwrap();
    assert_eq!(
        (standing.order.strict, standing.order.tolerant),
        (0, 2),
        "scene order against order in time"
    );
    match standing.cause.as_ref().unwrap() {
        Cause::Resolution { margin, resolution } => {
            assert_relative_eq!(*margin, 3e-4, max_relative = 1e-9);
            assert_eq!(*resolution, 0.01);
        }
        other => panic!("cause {other:?}"),
    }
}

#[test]
fn a_difference_that_a_setting_moves_is_explained_by_the_setting() {
    // a graze that a coarse step jumps over: no margin explains it, a finer step cures it
    let offset = 2.0 * R * 0.995;
    let scene = scenario("graze")
        .moving("a", [0.0, 0.0], [20.0, 0.0])
        .resting("b", [3.0, offset])
        .duration(0.5)
        .build();
    let outcome = compared(&scene, &[("stepper", "dt=0.02")]);
    let standing = outcome.entries[1].standing.as_ref().unwrap();
    assert_eq!((standing.order.missed, standing.order.strict), (1, 0));
    match standing.cause.as_ref().unwrap() {
        Cause::Setting { what, setting } => {
            assert_eq!(*what, "the time step");
            assert!(setting.values.contains_key("dt"));
        }
        other => panic!("cause {other:?}"),
    }
}

#[test]
fn without_an_exact_answer_the_engines_are_held_against_each_other() {
    let scene = report_break(0.0, 90.0);
    let outcome = compared(
        &scene,
        &[("stepper", ""), ("stepper", "contact=approaching-only")],
    );
    assert!(outcome.reference.is_none());
    assert!(
        outcome
            .no_reference
            .as_ref()
            .unwrap()
            .1
            .contains("indeterminate")
    );
    assert!(outcome.entries.iter().all(|entry| entry.standing.is_none()));
    assert_eq!(outcome.pairs.len(), 1);
}

#[test]
fn what_is_not_unique_and_what_the_reference_does_not_reach_are_told_apart() {
    for (name, solver, begins, unique) in [
        (
            "report-break-frozen",
            "",
            "No single right answer from t = ",
            true,
        ),
        (
            "accumulate-three",
            "contacts=collapse",
            "exact stopped at t = ",
            false,
        ),
    ] {
        let columns = [("exact", solver), ("stepper", "")];
        let outcome = compared(&catalogue::scene(name).unwrap(), &columns);
        assert!(outcome.reference.is_none(), "{name}");
        let headline = carom::page::compare::headline(&outcome);
        assert!(headline.starts_with(begins), "{name}: {headline}");
        assert_eq!(
            headline.contains("right answer"),
            unique,
            "{name}: {headline}"
        );
    }
}

#[test]
fn the_page_of_a_scene_has_every_metric_of_every_engine() {
    let scene = catalogue::scene("oblique").unwrap();
    let outcome = compared(
        &scene,
        &[("exact", ""), ("stepper", ""), ("rapier-f64", "")],
    );
    let page = carom::page::compare::page(&outcome);
    let table = page.blocks.iter().find_map(|block| match block {
        Block::Table(table) if table.id == "metrics" => Some(table),
        _ => None,
    });
    let table = table.unwrap();
    let ids: Vec<String> = table
        .rows
        .iter()
        .map(|row| format!("{:?}", row[0]))
        .collect();
    for (metric, id) in METRICS.iter().zip(&ids) {
        assert!(id.contains(metric.id), "{id}");
    }
    assert_eq!(ids.len(), METRICS.len());
    // by the findings themselves, read without the table
    let engines = 2..table.columns.len() - 1;
    assert_eq!(engines.len(), outcome.entries.len());
    for column in engines.clone() {
        let head = &table.columns[column];
        for (metric, row) in METRICS.iter().zip(&table.rows) {
            let own = outcome.findings.iter();
            let own = own.filter(|f| f.engine == head.title && f.metric == metric.id);
            let values: Vec<f64> = own.filter_map(|f| f.value).collect();
            let worst = values.iter().copied().reduce(f64::max);
            assert_eq!(
                row[column],
                Cell::maybe(worst),
                "{} {}",
                head.title,
                metric.id
            );
        }
    }
    let told = |id: &str, column: usize| {
        let row = METRICS.iter().position(|metric| metric.id == id).unwrap();
        table.rows[row][column] != Cell::Empty
    };
    for column in engines {
        assert!(
            told("momentum", column) || told("overlap", column),
            "{column}"
        );
    }
}

#[test]
fn richer_scene_measures_what_the_poorer_one_leaves_out() {
    let shot = |mu: f64| {
        scenario("shot")
            .moving("cue", [0.0, 0.0], [0.0, 4.0])
            .cloth(mu)
            .build()
    };
    let (scene, richer) = (shot(0.2), shot(0.25));
    let columns = plan(
        crate::support::roster(),
        &[Configuration::of(crate::support::find("stepper").unwrap())],
    );
    let watch = Watch::NONE;
    let outcome = study(&scene, Some(&richer), &columns, Timing::None, watch);
    let distance = |mu: f64| 16.0 / (2.0 * mu * G);
    let model = outcome.entries[1]
        .standing
        .as_ref()
        .unwrap()
        .attribution
        .model
        .unwrap();
    assert_relative_eq!(
        model,
        (distance(0.2) - distance(0.25)) / R,
        max_relative = 1e-12
    );
}

#[test]
fn default_columns_cover_every_engine_and_exact_comes_first() {
    let columns = plan(
        crate::support::roster(),
        &default_columns(crate::support::roster()),
    );
    assert_eq!(columns[0].engine.id(), "exact");
    for engine in crate::support::roster() {
        assert!(
            columns
                .iter()
                .any(|column| column.engine.id() == engine.id()),
            "{}",
            engine.id()
        );
    }
}

#[test]
fn parry_in_both_precisions_agrees_on_an_overlap() {
    use parry3d::{math::Pose, query::contact, shape::Ball};
    let depth = 0.125 * R;
    // two overlapping balls at rest; contact is judged at the knots
    let mut scene = scenario("overlap")
        .resting("a", [0.0, 0.0])
        .resting("b", [2.0 * R - depth, 0.0])
        .build();
    scene.duration = 0.01;
    let trace = run(
        "stepper",
        &["contact=approaching-only"],
        &scene,
        Record::Events,
    );
    let double = deepest_overlap(&scene, &trace);
    assert_relative_eq!(double, depth, max_relative = 1e-12);
    let (a, b) = (Ball::new(R as f32), Ball::new(R as f32));
    let apart = Pose::translation((2.0 * R - depth) as f32, 0.0, 0.0);
    let single = contact(&Pose::translation(0.0, 0.0, 0.0), &a, &apart, &b, 0.0)
        .unwrap()
        .unwrap();
    assert_relative_eq!(f64::from(-single.dist), depth, max_relative = 1e-5);
    let by_engine = of_trace(&scene, "stepper", &trace)
        .into_iter()
        .find(|f| f.metric == "overlap-by-parry")
        .unwrap();
    assert_relative_eq!(by_engine.value.unwrap(), 0.125, max_relative = 1e-12);
}

#[test]
fn errors_are_quoted_up_to_the_horizon() {
    // chaotic, and both engines keep the order far beyond the time at which nobody can be right
    let scene = catalogue::scene("discs-in-a-box").unwrap();
    let reference = run("exact", &["precision=dd"], &scene, Record::Events);
    let trace = run("exact", &[], &scene, Record::Events);
    let horizon = horizon(&scene, Precision::F64, false, &Limits::NONE).unwrap();
    assert!(!horizon.is_whole(), "{:?}", horizon.limit);
    let until = |comparison: &Comparison<'_>| {
        let findings = of_pair(comparison, "exact");
        let found = findings.iter().find(|f| f.metric == "until-parting");
        found.and_then(|finding| finding.value).unwrap()
    };
    let whole = Comparison::new(&scene, &trace, &reference);
    let parting = whole.parting_time().unwrap_or(f64::INFINITY);
    assert!(parting > horizon.until, "the orders part at {parting}");
    let before = until(&whole);
    let within = until(&whole.up_to(horizon.until));
    // the horizon is where the two precisions leave a band of 1e-9
    assert!(
        within < BAND && before > 1e3 * BAND,
        "{within:e} and {before:e}"
    );
}

#[test]
fn a_ball_that_falls_elsewhere_is_counted() {
    let scene = catalogue::scene("ladder-pockets").unwrap();
    let reference = exact(&scene);
    let fallen = |trace: &Trace| {
        let findings = of_pair(&Comparison::new(&scene, trace, &reference), "exact");
        let found = findings.iter().find(|f| f.metric == "pocket-disagreements");
        found.and_then(|finding| finding.value).unwrap()
    };
    assert_eq!(fallen(&reference), 0.0);
    // the scene says that ball 1 falls into p5
    let ball = scene.ball_index("1").unwrap();
    assert_eq!(reference.pocket_of(ball), Some(5));
    let mut elsewhere = reference.clone();
    for event in &mut elsewhere.events {
        if let EventKind::Pocket(_, pocket) = &mut event.kind {
            *pocket = 4;
        }
    }
    assert_eq!(fallen(&elsewhere), 1.0);
}

#[test]
fn hits_that_overlap_in_real_balls_are_named_and_others_are_not() {
    let said = |name: &str| -> Option<String> {
        let outcome = compared(&catalogue::scene(name).unwrap(), &[("exact", "")]);
        let unit = carom::page::compare::LengthUnit::Radius;
        let page = carom::page::compare::summary(&outcome, unit);
        page.blocks.iter().find_map(|block| match block {
            Block::Text(words) if words.contains("is hit twice within") => Some(words.clone()),
            _ => None,
        })
    };
    let scene = catalogue::scene("report-break").unwrap();
    let trace = run("exact", &[], &scene, Record::Events);
    let mut least = (f64::INFINITY, 0, 0.0);
    for ball in 0..scene.balls.len() as u32 {
        let own = trace.events.iter().filter(|event| match event.kind {
            EventKind::BallBall(a, b) => a == ball || b == ball,
            _ => false,
        });
        let times: Vec<f64> = own.map(|event| event.time).collect();
        for pair in times.windows(2) {
            if pair[1] - pair[0] < least.0 {
                least = (pair[1] - pair[0], ball, pair[1]);
            }
        }
    }
    assert!(least.0 > 0.0 && least.0 < 200e-6, "{least:?}");
    let words = said("report-break").unwrap();
    let id = &scene.balls[least.1 as usize].id;
    let time = format!("t = {:.4} s", least.2);
    assert!(words.contains(&time), "{words} {time}");
    assert!(words.starts_with(&format!("Ball {id} ")), "{words}");
    assert_eq!(said("oblique"), None);
}
