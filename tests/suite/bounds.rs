//! What a command line, a file or a scene asks for has a bound, in work and in memory: it is done in what it takes, or refused with
//! words. Work is counted, never timed.

use crate::support::{R, run, scenario};
use assert_cmd::Command;
use carom::engine::{Refusal, Setting, prepare};
use carom::physics::Cloth;
use carom::scene::generate::{Recipe, generate};
use carom::scene::{Diagnostics, Kind, Scene, SceneError, catalogue, parse};
use carom::study::matrix::{MOST_COLUMNS, fold_blocks};
use carom::study::mutation::Examples;
use carom::study::{Configuration, Watch, ensemble, mutation, random};
use carom::trace::Record;
use carom::trace::files::{self, Files, read};
use std::process::Output;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

fn carom(arguments: &[&str]) -> Output {
    Command::cargo_bin("carom")
        .unwrap()
        .args(arguments)
        .output()
        .unwrap()
}

/// Asks to stop as soon as something is told to be done.
fn stopping_at_once<'a>(
    stop: &'a (dyn Fn(usize, usize, &str) + Sync),
    flag: &'a AtomicBool,
) -> Watch<'a> {
    Watch {
        progress: stop,
        cancelled: flag,
    }
}

#[test]
fn as_many_scenes_and_inputs_as_there_are_indices_take_no_memory_of_their_own() {
    let flag = AtomicBool::new(false);
    let stop = |_: usize, _: usize, _: &str| flag.store(true, Ordering::Relaxed);
    let watch = stopping_at_once(&stop, &flag);
    // told of every so many blocks: here the flag is set by the blocks instead
    let begun = AtomicUsize::new(0);
    let mut folded = 0;
    fold_blocks(
        0..u64::MAX,
        "things",
        stopping_at_once(&|_, _, _| {}, &flag),
        |range| {
            if begun.fetch_add(1, Ordering::Relaxed) > 2000 {
                flag.store(true, Ordering::Relaxed);
            }
            range
        },
        |range| {
            assert_eq!((range.start, range.end), (folded, folded + 64));
            folded = range.end;
        },
    );
    assert!(folded > 64 * 1000, "{folded}");

    for first in [0, u64::MAX - 100, u64::MAX] {
        // what was asked to stop before it began runs nothing, and ends
        let plan = random::Plan {
            first,
            scenes: u64::MAX,
            seed: 1,
            columns: Configuration::list(crate::support::roster(), "exact").unwrap(),
            max_events: 10,
        };
        let outcome = random::study(plan, watch);
        assert_eq!((outcome.done, outcome.faults), (0, 0));
        let lead = carom::page::random::summary(&outcome).lead;
        assert!(lead.contains("0 of 0"), "{lead}");
        let plan = mutation::Plan {
            first,
            inputs: u64::MAX,
            seed: 1,
        };
        let outcome = mutation::study(
            plan,
            &Examples::new(crate::support::roster()).unwrap(),
            watch,
        );
        assert_eq!(outcome.done(), 0);
        let _ = carom::page::mutation::summary(&outcome);
    }
    // the last indices that there are
    let never = AtomicBool::new(false);
    let quiet = |_: usize, _: usize, _: &str| {};
    let plan = random::Plan {
        first: u64::MAX - 70,
        scenes: 70,
        seed: 1,
        columns: Configuration::list(crate::support::roster(), "exact").unwrap(),
        max_events: 10,
    };
    assert_eq!(
        random::study(plan, stopping_at_once(&quiet, &never)).done,
        70
    );
}

#[test]
fn answers_are_folded_as_they_come_in_order_and_few_are_held_at_a_time() {
    struct Held<'a>(u64, &'a AtomicUsize);
    impl Drop for Held<'_> {
        fn drop(&mut self) {
            self.1.fetch_sub(1, Ordering::Relaxed);
        }
    }
    let (held, most) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let never = AtomicBool::new(false);
    let quiet = |_: usize, _: usize, _: &str| {};
    let mut seen = Vec::new();
    fold_blocks(
        5..1_000_005,
        "things",
        stopping_at_once(&quiet, &never),
        |range| {
            let now = held.fetch_add(1, Ordering::Relaxed) + 1;
            most.fetch_max(now, Ordering::Relaxed);
            Held(range.start, &held)
        },
        |answer| seen.push(answer.0),
    );
    assert!(seen.iter().copied().eq((5..1_000_005).step_by(64)));
    // 64 blocks a thread, of the 15625 that there are
    let bound = 64 * std::thread::available_parallelism().unwrap().get();
    assert!(most.into_inner() <= bound.max(64));
}

#[test]
fn a_count_that_is_too_large_is_refused_by_its_flag_with_the_largest_that_is_taken() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let out = out.to_str().unwrap();
    let huge = "18446744073709551615";
    let many: Vec<String> = (0..=MOST_COLUMNS)
        .map(|i| format!("stepper:dt=1e-{i}"))
        .collect();
    let many = many.join(",");
    let run = ["run", "slide", "--engine", "stepper", "--out", out];
    let cases: [(Vec<&str>, &[&str]); 9] = [
        (
            vec!["fuzz", "--first", huge, "--scenes", "1"],
            &["`--scenes 1`", "at most 0", "--first"],
        ),
        (
            vec!["fuzz", "--first", "2", "--scenes", huge],
            &["`--scenes", "at most 18446744073709551613"],
        ),
        (
            vec!["fuzz", "--first", "2", "--inputs", huge],
            &["`--inputs", "at most 18446744073709551613"],
        ),
        (
            vec!["fuzz", "--scenes", "1", "--max-events", huge],
            &["`--max-events", "at most 10000000"],
        ),
        (
            [&run[..], &["--max-events", huge]].concat(),
            &["`--max-events", "at most 1000000000"],
        ),
        (
            [
                "run", "slide", "--engine", "stepper", "--set", "dt=1e-9", "--every", "1e-300",
                "--out", out,
            ]
            .to_vec(),
            &["`--every", "at least"],
        ),
        (
            vec!["ensemble", "report-break", "--samples", huge],
            &["`--samples`", "1 to 3125000 samples"],
        ),
        (
            vec!["scene", "generate", "--density", "0.3", "--balls", huge],
            &["`--balls`", "1 to 10000000"],
        ),
        (
            vec!["compare", "slide", "--engines", &many],
            &["more than 256 engines"],
        ),
    ];
    for (arguments, wanted) in cases {
        let output = carom(&arguments);
        let words = String::from_utf8(output.stderr).unwrap();
        let shown = &arguments[..arguments.len().min(4)];
        assert_eq!(output.status.code(), Some(2), "{shown:?}: {words}");
        for part in wanted {
            assert!(words.contains(part), "{shown:?}: {words}");
        }
        assert!(!words.contains("panicked"), "{words}");
    }
    assert!(!folder.path().join("out").exists());
}

#[test]
fn the_cadence_that_a_refusal_names_is_taken() {
    // a step of 1e-5 over 20 s, 16 balls: 3.2e7 states, of which 2e7 may be recorded
    let folder = tempfile::tempdir().unwrap();
    let run = |every: &str| {
        carom(&[
            "run",
            "report-break",
            "--engine",
            "stepper",
            "--set",
            "dt=1e-5",
            "--set",
            "contact=approaching-only",
            "--every",
            every,
            "--out",
            folder.path().to_str().unwrap(),
        ])
    };
    let refused = run("1e-6");
    let words = String::from_utf8(refused.stderr).unwrap();
    let (_, rest) = words.split_once("expected at least ").unwrap();
    let least: f64 = rest.split_once(" s").unwrap().0.parse().unwrap();
    assert!((1.6e-5..2e-5).contains(&least), "{words}");
}

#[test]
fn a_cadence_below_the_step_records_every_step_once() {
    // the number of samples that are due does not fit an integer
    let scene = catalogue::scene("slide").unwrap();
    let trace = run("stepper", &["dt=0.01"], &scene, Record::Every(1e-300));
    let steps = trace.counters["steps"] as usize;
    let knots = trace.paths[0].knots.len();
    assert!(
        (steps / 2..=steps + 4).contains(&knots),
        "{knots} knots in {steps} steps"
    );
}

#[test]
fn samples_that_cannot_be_kept_are_refused_with_their_number() {
    let scene = catalogue::scene("report-break").unwrap();
    let never = AtomicBool::new(false);
    let quiet = |_: usize, _: usize, _: &str| {};
    let plan = ensemble::Plan {
        law: carom::scene::perturb::Law::default_for(&scene),
        scene,
        samples: usize::MAX,
        seed: 1,
        columns: Configuration::list(crate::support::roster(), "exact,stepper").unwrap(),
    };
    let refused = ensemble::study(plan, stopping_at_once(&quiet, &never)).unwrap_err();
    assert_eq!(
        refused.to_string(),
        format!(
            "an ensemble of 16 balls in 2 engines has 1 to 3125000 samples, not {}",
            usize::MAX
        )
    );
}

/// Two balls on an unbounded plane, without friction, for so long.
fn for_so_long(duration: f64) -> Scene {
    let mut scene = scenario("long")
        .moving("cue", [0.0, 0.0], [3.0, 0.0])
        .resting("1", [2.0 * R + 0.5, 0.0])
        .build();
    scene.duration = duration;
    scene
}

#[test]
fn a_duration_beyond_the_clock_is_refused_by_every_engine_with_the_same_words() {
    let step = |engine: &str, duration: f64| {
        // so few steps that their number is no reason
        match engine {
            "exact" => Setting::default(),
            _ => Setting::default().with("dt", (duration / 1e3).min(1e9)),
        }
    };
    let refusal = |id: &str, duration: f64| {
        let engine = crate::support::find(id).unwrap();
        let scene = for_so_long(duration);
        prepare(engine.as_ref(), &scene, &step(id, duration)).err()
    };
    // 3 length/s for this long is a way of which 8 roundings are a tenth of R
    let most = 0.1 * R / (8.0 * f64::EPSILON * 3.0);
    for engine in crate::support::roster() {
        let id = engine.id();
        for duration in [1.01 * most, 1e16, 1e30] {
            let found = refusal(id, duration);
            assert!(
                matches!(found, Some(Refusal::TooLong { duration: d, most: m }) if d == duration && (m / most - 1.0).abs() < 1e-9),
                "{id} for {duration:e} s: {found:?}"
            );
        }
        assert_eq!(refusal(id, 0.99 * most), None, "{id}");
    }
    // friction ends it within seconds, so that its clock never gets there
    for engine in crate::support::roster()
        .iter()
        .filter(|engine| engine.id() == "exact")
    {
        let mut scene = for_so_long(1e30);
        scene.effects.cloth = Some(Cloth::Translational { mu: 0.2 });
        scene.gravity = 9.81;
        assert!(prepare(engine.as_ref(), &scene, &Setting::default()).is_ok());
    }
}

#[test]
fn no_scene_that_comes_with_the_program_is_too_long_for_its_clock() {
    let mut prepared = 0;
    for entry in catalogue::all() {
        let scene = entry.scene().unwrap();
        for engine in crate::support::roster() {
            let refused = prepare(engine.as_ref(), &scene, &Setting::default()).err();
            let too_long = matches!(refused, Some(Refusal::TooLong { .. }));
            assert!(!too_long, "{} in {}: {refused:?}", scene.name, engine.id());
            prepared += usize::from(refused.is_none());
        }
    }
    assert!(prepared > 100, "{prepared}");
}

#[test]
fn a_step_that_takes_too_many_is_refused_by_every_stepping_engine_with_the_same_words() {
    let scene = for_so_long(1e4);
    let mut refused = 0;
    for engine in crate::support::roster() {
        let setting = Setting::default().with("dt", "1e-30");
        match prepare(engine.as_ref(), &scene, &setting).err() {
            Some(Refusal::Setting { message, .. }) if message.contains("unknown setting") => {}
            Some(Refusal::Setting { message, .. }) => {
                let words = "the 10000 s of scene long would take 1.0e34 steps, more than 1e";
                assert!(message.contains(words), "{}: {message}", engine.id());
                refused += 1;
            }
            other => panic!("{}: {other:?}", engine.id()),
        }
    }
    assert_eq!(refused, 3);
}

const HEAD: &str = "name = \"many\"\nduration = 1.0\n[ball]\nradius = 0.25\nmass = 1.0\n";

fn errors(text: &str) -> Diagnostics {
    match parse("many.toml", text) {
        Err(SceneError::Invalid(found)) => found,
        other => panic!(
            "expected errors, got {:?}",
            other.map(|scene| scene.balls.len())
        ),
    }
}

#[test]
fn of_a_hundred_thousand_errors_the_first_are_kept_and_the_rest_is_counted() {
    const MANY: usize = 100_000;
    let list = |line: &dyn Fn(usize) -> String| -> String { (0..MANY).map(line).collect() };
    let ball = |i: usize| format!("[[balls]]\nid = \"{i}\"\nposition = [{i}.0, 0.0]\n");
    let cases: [(&str, String, Kind, usize); 6] = [
        (
            "wrong keys",
            format!("{HEAD}{}", list(&|i| format!("wrong{i} = {i}\n"))),
            Kind::UnknownKey,
            MANY,
        ),
        (
            "wrong keys of balls",
            format!("{HEAD}{}", list(&|i| format!("{}velocit = 1\n", ball(i)))),
            Kind::UnknownKey,
            MANY,
        ),
        (
            "ids used twice",
            format!(
                "{HEAD}{}",
                list(&|i| ball(i).replace(&format!("\"{i}\""), "\"a\""))
            ),
            Kind::Duplicate,
            MANY - 1,
        ),
        (
            "bad names",
            format!(
                "{HEAD}{}",
                list(&|i| ball(i).replace(&format!("\"{i}\""), &format!("\"a {i}\"")))
            ),
            Kind::BadName,
            MANY,
        ),
        (
            "no mass",
            format!("{}{}", HEAD.replace("mass = 1.0\n", ""), list(&ball)),
            Kind::Missing,
            MANY,
        ),
        (
            "no TOML",
            format!("{HEAD}{}", list(&|i| format!("a{i} = what\n"))),
            Kind::Syntax,
            MANY,
        ),
    ];
    for (what, text, kind, count) in cases {
        let mut found = None;
        let used = allocation_counter::measure(|| found = Some(errors(&text)));
        let found = found.unwrap();
        assert_eq!(found.problems.len() + found.more, count, "{what}");
        assert_eq!(found.problems.len(), 1000, "{what}");
        assert!(
            found.problems.iter().all(|problem| problem.kind == kind),
            "{what}: {:?}",
            found.problems[0]
        );
        let mut shown = String::new();
        let rendered = allocation_counter::measure(|| shown = found.render(false));
        assert!(
            shown.ends_with(&format!("{} more errors", count - 20)),
            "{what}: {}",
            &shown[shown.len() - 60..]
        );
        // the parser's own tree is some hundred bytes a key; words of an error are half a thousand
        let bytes = used.bytes_max / MANY as u64;
        assert!(bytes < 2_500, "{what}: {bytes} bytes each");
        // each is shown from the lines that it marks, not from the whole text
        assert!(
            rendered.bytes_max < 200_000,
            "{what}: {} bytes to show 20",
            rendered.bytes_max
        );
    }
}

/// A file of so many balls: larger than what is read as a whole.
fn large(balls: usize) -> String {
    let recipe = Recipe {
        balls,
        mu: Some(0.01),
        ..Recipe::default()
    };
    generate(&recipe).unwrap() + "\n[shot.velocity]\nball = \"7\"\nspeed = 2.0\nangle_deg = 30.0\n"
}

/// The same file in a spelling by which it must be read as a whole.
fn as_a_whole(text: &str) -> String {
    text.replace("[[balls]]", "[[ balls ]]")
}

#[test]
fn a_large_file_is_the_same_scene_in_pieces_and_takes_less_than_a_kilobyte_a_ball() {
    const BALLS: usize = 20_000;
    let text = large(BALLS).replace(
        "[[balls]]\nid = \"7\"\n",
        "[[balls]]\nid = \"7\"\nmass = 2\n",
    );
    // the shot's ball has a velocity of its own in the list: one of the two must go
    let (ball, rest) = text.split_once("id = \"7\"").unwrap();
    let (velocity, rest) = rest.split_once("velocity = ").unwrap();
    let rest = rest.split_once('\n').unwrap().1;
    let text = format!("{ball}id = \"7\"{velocity}{rest}");
    assert!(text.len() > 1 << 21);
    let mut scene = None;
    let used = allocation_counter::measure(|| scene = Some(parse("large.toml", &text).unwrap()));
    let scene = scene.unwrap();
    assert_eq!(scene.balls.len(), BALLS);
    assert_eq!(scene, parse("large.toml", &as_a_whole(&text)).unwrap());
    let bytes = used.bytes_max / BALLS as u64;
    assert!(bytes < 1_000, "{bytes} bytes a ball");
}

#[test]
fn errors_of_a_large_file_stand_where_they_do_when_it_is_read_as_a_whole() {
    let text = large(20_000);
    let changes = [
        ("id = \"19000\"", "id = 19000"),
        ("id = \"19000\"", "idd = \"19000\""),
        ("id = \"19000\"", "id = \"18000\""),
        ("id = \"19000\"", "id = \"19000\"\nradius = 5.0"),
        ("id = \"19000\"", "id = \"19000\"\nspin = [0.0, 0.0, 1.0]"),
        ("id = \"19000\"", "id = \"19000\"\nmass = -1.0"),
        ("duration = 20.0", "duration = -20.0"),
        ("speed = 2.0", "speed = -2.0"),
        ("speed = 2.0", "spede = 2.0"),
        ("ball = \"7\"", "ball = \"seven\""),
        ("duration = 20.0", ""),
        ("[shot.velocity]", "[balls.more]\na = 1\n[shot.velocity]"),
        ("id = \"19000\"", "id = \"\"\"\n[[balls]]\nid = 3\"\"\""),
        ("id = \"19000\"", "id = "),
    ];
    for (from, to) in changes {
        let wrong = text.replacen(from, to, 1);
        assert_ne!(wrong, text, "{from}");
        let (found, want) = (errors(&wrong), errors(&as_a_whole(&wrong)));
        let seen = |found: &Diagnostics| -> Vec<_> {
            let problems = found.problems.iter();
            problems
                .map(|p| {
                    let text = found.text[p.span.clone()].replace("[[ balls ]]", "[[balls]]");
                    (
                        p.kind,
                        p.message.clone(),
                        found.position(p.span.start),
                        text,
                        p.help.clone(),
                        p.also.len(),
                    )
                })
                .collect()
        };
        assert_eq!(seen(&found), seen(&want), "{to}");
        let shown = want.render(false).replace("[[ balls ]]", "[[balls]]");
        assert_eq!(
            found.render(false).lines().count(),
            shown.lines().count(),
            "{to}"
        );
    }
}

#[test]
fn an_error_in_a_trace_of_very_many_balls_does_not_name_them_all() {
    const MANY: usize = 100_000;
    let columns = ["ball,x,y,z,vx,vy,vz,wx,wy,wz,stop_time\n".to_owned()].into_iter();
    let rows = (0..MANY).map(|ball| format!("{ball},0,0,0,0,0,0,0,0,0,0\n"));
    let wrong = (0..MANY).map(|row| format!("{row},0,stop,nobody{row},,\n"));
    let files = Files {
        events: format!(
            "index,time,kind,a,b,exchanges\n{}",
            wrong.collect::<String>()
        ),
        final_states: columns.chain(rows).collect(),
        run: files::write(&run(
            "exact",
            &[],
            &catalogue::scene("head-on").unwrap(),
            Record::Events,
        ))
        .unwrap()
        .run,
        ..Files::default()
    };
    let words = read(&files).unwrap_err().to_string();
    assert!(words.contains("there is no ball `"), "{words}");
    assert!(words.ends_with("and 99984 more"), "{} bytes", words.len());
}
