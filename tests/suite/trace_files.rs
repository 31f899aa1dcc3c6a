//! Trace files: whatever a trace holds comes back to the bit, and no text makes the reader panic.

use carom::math::Vec3;
use carom::physics::{Side, State};
use carom::trace::files::{self, Files};
use carom::trace::{
    Certainty, Ending, Event, EventKind, Extrema, Extremum, Knot, Partner, Path, Provenance, Spot,
    Trace,
};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// Two traces are equal to the bit when their debug texts are: those spell every float with all its digits, tell -0 from 0,
/// and make every NaN equal to every other.
fn bits(trace: &Trace) -> String {
    format!("{trace:?}")
}

/// Any f64: every class of number, and the ones that text formats get wrong.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => any::<f64>(),
        4 => -10.0..10.0f64,
        1 => prop::sample::select(vec![
            0.0, -0.0, 5e-324, -5e-324, 2.225_073_858_507_201_4e-308, f64::MAX, f64::MIN, f64::INFINITY,
            f64::NEG_INFINITY, f64::NAN, 0.1, 1e21, 1e22, 1e23, 9_007_199_254_740_993.0, 1e-5, 123_456.0,
        ]),
    ]
}

/// Any finite f64, as every time is, and every state of a run that did not end because one was not.
fn finite() -> impl Strategy<Value = f64> {
    number().prop_map(|x| if x.is_finite() { x } else { f64::MAX })
}

fn state() -> impl Strategy<Value = State> {
    prop::array::uniform9(number()).prop_map(|n| State {
        position: Vec3::new(n[0], n[1], n[2]),
        velocity: Vec3::new(n[3], n[4], n[5]),
        spin: Vec3::new(n[6], n[7], n[8]),
    })
}

/// A run that ended otherwise than as not-finite has finite states.
fn tidy(trace: &mut Trace) {
    if matches!(trace.ending, Ending::NotFinite(_)) {
        return;
    }
    for knot in trace.paths.iter_mut().flat_map(|path| &mut path.knots) {
        let state = &mut knot.state;
        for vector in [&mut state.position, &mut state.velocity, &mut state.spin] {
            for x in vector.iter_mut().filter(|x| !x.is_finite()) {
                *x = -f64::MAX;
            }
        }
    }
}

/// Times of a path or of events: sorted, with repetitions and both zeros.
fn times(longest: usize) -> impl Strategy<Value = Vec<f64>> {
    let time = prop_oneof![4 => 0.0..20.0f64, 2 => Just(0.0), 1 => Just(-0.0), 2 => Just(7.5)];
    prop::collection::vec(time, 1..longest).prop_map(|mut times| {
        times.sort_by(|a, b| a.partial_cmp(b).unwrap());
        times
    })
}

fn kind(balls: u32) -> impl Strategy<Value = EventKind> {
    let side = prop::sample::select(Side::ALL.to_vec());
    prop_oneof![
        (0..balls, 1..balls.max(2)).prop_map(move |(a, d)| {
            let b = (a + d) % balls;
            if a == b {
                EventKind::Stop(a)
            } else {
                EventKind::ball_ball(a as usize, b as usize)
            }
        }),
        (0..balls, side).prop_map(|(a, side)| EventKind::BallCushion(a, side)),
        (0..balls).prop_map(EventKind::Stop),
        (0..balls).prop_map(EventKind::SlideToRoll),
        (0..balls).prop_map(EventKind::SpinEnd),
        (0..balls, any::<u32>()).prop_map(|(a, p)| EventKind::Pocket(a, p)),
        lasting(balls).prop_map(|(a, with)| EventKind::ContactBegin(a, with)),
        lasting(balls).prop_map(|(a, with)| EventKind::ContactEnd(a, with)),
    ]
}

/// A ball and what it lies against: a later ball, or a cushion.
fn lasting(balls: u32) -> impl Strategy<Value = (u32, Partner)> {
    let side = prop::sample::select(Side::ALL.to_vec());
    (0..balls, 0..2 * balls, side).prop_map(move |(a, b, side)| match a < b && b < balls {
        true => (a, Partner::Ball(b)),
        false => (a, Partner::Cushion(side)),
    })
}

fn events(balls: u32) -> impl Strategy<Value = Vec<Event>> {
    let row = (kind(balls), prop::option::of(any::<u64>()));
    (times(9), prop::collection::vec(row, 9)).prop_map(|(times, rows)| {
        let event = |(time, (kind, exchanges))| Event {
            time,
            kind,
            exchanges,
        };
        times.into_iter().zip(rows).map(event).collect()
    })
}

fn ending(balls: u32) -> impl Strategy<Value = Ending> {
    let spot = (finite(), prop::collection::vec(0..balls, 0..3), ".*")
        .prop_map(|(time, balls, why)| Spot { time, balls, why });
    (0..8, spot).prop_map(|(which, spot)| match which {
        0 => Ending::Rest,
        1 => Ending::Duration,
        2 => Ending::Cancelled,
        3 => Ending::Budget(spot),
        4 => Ending::Indeterminate(spot),
        5 => Ending::Undecidable(spot),
        6 => Ending::Collapsed(spot),
        _ => Ending::NotFinite(spot),
    })
}

fn extremum(balls: u32) -> impl Strategy<Value = Extremum> {
    let ball = || prop::option::of(0..balls);
    (number(), finite(), ball(), ball()).prop_map(|(value, time, ball, other)| Extremum {
        value,
        time,
        ball,
        other,
    })
}

/// A path whose knots name events of its ball.
fn path(ball: usize, events: Vec<Event>) -> impl Strategy<Value = Path> {
    let knot = (state(), any::<prop::sample::Index>(), any::<bool>());
    (times(6), prop::collection::vec(knot, 6)).prop_map(move |(times, knots)| {
        let mine: Vec<u32> = (0..events.len() as u32)
            .filter(|&i| {
                let (a, b) = events[i as usize].kind.balls();
                a == ball || b == Some(ball)
            })
            .collect();
        let knot = |(time, (state, pick, named)): (f64, (State, prop::sample::Index, bool))| Knot {
            time,
            state,
            after: (named && !mine.is_empty()).then(|| mine[pick.index(mine.len())]),
        };
        Path {
            knots: times.into_iter().zip(knots).map(knot).collect(),
        }
    })
}

fn parameters() -> impl Strategy<Value = BTreeMap<String, serde_json::Value>> {
    let value = prop_oneof![
        any::<bool>().prop_map(serde_json::Value::from),
        any::<u64>().prop_map(serde_json::Value::from),
        any::<i64>().prop_map(serde_json::Value::from),
        number().prop_map(serde_json::Value::from),
        ".*".prop_map(serde_json::Value::from),
    ];
    prop::collection::btree_map(".*", value, 0..4)
}

/// The certainty of every event, or of none.
fn certainty(events: usize) -> impl Strategy<Value = Vec<Certainty>> {
    // margin and condition are sizes, maybe without bound
    let size = || {
        number().prop_map(|x| match x {
            x if x.is_nan() => f64::INFINITY,
            x => x.abs(),
        })
    };
    let known = (
        prop::option::of(size()),
        prop::option::of(size()),
        prop::option::of(number()),
    );
    let one = known.prop_map(|(margin, condition, time_error)| Certainty {
        margin,
        condition,
        time_error,
    });
    let all = prop::collection::vec(one, events).prop_map(|mut all| {
        // nothing known of any event is written as nothing at all
        if all.iter().all(|known| *known == Certainty::default()) {
            all.clear();
        }
        all
    });
    prop_oneof![Just(Vec::new()), all]
}

fn trace() -> impl Strategy<Value = Trace> {
    let ids = prop::collection::hash_set(".{0,6}", 1..5);
    let with_events = ids.prop_flat_map(|ids| {
        let balls: Vec<String> = ids.into_iter().collect();
        let events = prop_oneof![Just(Vec::new()), events(balls.len() as u32)];
        (Just(balls), events)
    });
    with_events.prop_flat_map(|(balls, events)| {
        let n = balls.len() as u32;
        let paths: Vec<_> = (0..balls.len())
            .map(|ball| path(ball, events.clone()))
            .collect();
        let provenance = ([".*", ".*", ".*", ".*"], parameters(), finite(), finite()).prop_map(
            |([engine, version, scene, scene_hash], parameters, resolution, rest_speed)| {
                Provenance {
                    engine,
                    version,
                    parameters,
                    scene,
                    scene_hash,
                    resolution,
                    rest_speed,
                    ulp: f64::EPSILON,
                }
            },
        );
        let extrema = [
            extremum(n),
            extremum(n),
            extremum(n),
            extremum(n),
            extremum(n),
        ];
        let stops = prop::collection::vec(prop::option::of(finite()), balls.len());
        let counters = prop::collection::btree_map(".*", any::<u64>(), 0..4);
        let rest = (
            paths,
            provenance,
            extrema,
            stops,
            counters,
            ending(n),
            finite(),
            certainty(events.len()),
        );
        rest.prop_map(
            move |(
                paths,
                provenance,
                extrema,
                stop_times,
                counters,
                ending,
                end_time,
                certainty,
            )| {
                let [energy_gained, momentum, overlap, outside, displaced] = extrema;
                let mut trace = Trace {
                    provenance,
                    balls: balls.clone(),
                    paths,
                    events: events.clone(),
                    certainty,
                    stop_times,
                    extrema: Extrema {
                        energy_gained,
                        momentum,
                        overlap,
                        outside,
                        displaced,
                    },
                    counters,
                    ending,
                    end_time,
                };
                tidy(&mut trace);
                trace
            },
        )
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn files_read_back_as_the_same_trace_to_the_bit(trace in trace()) {
        let files = files::write(&trace).map_err(|e| TestCaseError::fail(e.to_string()))?;
        let read = files::read(&files).map_err(|e| TestCaseError::fail(format!("{e}\n{files:?}")))?;
        prop_assert_eq!(bits(&read), bits(&trace));
        // and what is read is written as the same bytes
        let again = files::write(&read).map_err(|e| TestCaseError::fail(e.to_string()))?;
        prop_assert_eq!(again, files);
    }

    #[test]
    fn the_shortest_decimal_of_a_number_reads_back_to_its_bits(x in number()) {
        let text = files::shortest(x);
        let read: f64 = text.parse().map_err(|_| TestCaseError::fail(format!("`{text}` is no number")))?;
        prop_assert!(read.to_bits() == x.to_bits() || (read.is_nan() && x.is_nan()), "{x:e} became {read:e}");
        let other = x.to_string().len().min(format!("{x:e}").len());
        prop_assert!(text.len() <= other, "`{}` is not the shortest", text);
    }
}

/// Two balls that meet once: small enough to be written out.
fn example() -> Trace {
    let at = |x: f64, v: f64| State {
        position: Vec3::new(x, 0.1, 0.25),
        velocity: Vec3::new(v, -0.0, 0.0),
        spin: Vec3::zeros(),
    };
    let knot = |time: f64, state: State, after: Option<u32>| Knot { time, state, after };
    let path = |knots: Vec<Knot>| Path { knots };
    Trace {
        provenance: Provenance {
            engine: "stepper".into(),
            version: "carom 0.1.0".into(),
            parameters: BTreeMap::from([("dt".into(), 1e-3.into())]),
            scene: "head-on".into(),
            scene_hash: "0123456789abcdef".into(),
            resolution: 1e-3,
            rest_speed: 0.0,
            ulp: f64::EPSILON,
        },
        balls: vec!["cue".into(), "a, \"b\"".into()],
        paths: vec![
            path(vec![
                knot(0.0, at(0.0, 3.0), None),
                knot(0.5, at(1.5, 3.0), None),
                knot(0.5, at(1.5, 0.0), Some(0)),
                knot(2.0, at(1.5, 0.0), None),
            ]),
            path(vec![
                knot(0.0, at(2.0, 0.0), None),
                knot(0.5, at(2.0, 0.0), None),
                knot(0.5, at(2.0, 3.0), Some(0)),
                knot(2.0, at(6.5, 3.0), None),
            ]),
        ],
        events: vec![
            Event {
                time: 0.5,
                kind: EventKind::BallBall(0, 1),
                exchanges: Some(1),
            },
            Event {
                time: 0.5,
                kind: EventKind::Stop(0),
                exchanges: None,
            },
        ],
        certainty: vec![
            Certainty {
                margin: Some(f64::INFINITY),
                condition: Some(1.25),
                time_error: Some(3e-17),
            },
            Certainty::default(),
        ],
        stop_times: vec![Some(0.5), None],
        extrema: Extrema {
            overlap: Extremum {
                value: 1e-17,
                time: 0.5,
                ball: Some(0),
                other: Some(1),
            },
            momentum: Extremum {
                value: f64::NAN,
                ..Extremum::default()
            },
            ..Extrema::default()
        },
        counters: BTreeMap::from([("steps".into(), 2000)]),
        ending: Ending::Duration,
        end_time: 2.0,
    }
}

#[test]
fn files_have_the_columns_and_keys_that_other_programs_rely_on() {
    let files = files::write(&example()).unwrap();
    insta::assert_snapshot!(files.events, @r#"
    index,time,kind,a,b,exchanges,margin,condition,time_error
    0,0.5,ball-ball,cue,"a, ""b""",1,inf,1.25,3e-17
    1,0.5,stop,cue,,,,,
    "#);
    insta::assert_snapshot!(files.samples, @r#"
    time,ball,x,y,z,vx,vy,vz,wx,wy,wz,event
    0,cue,0,0.1,0.25,3,-0,0,0,0,0,
    0,"a, ""b""",2,0.1,0.25,0,-0,0,0,0,0,
    0.5,cue,1.5,0.1,0.25,3,-0,0,0,0,0,
    0.5,cue,1.5,0.1,0.25,0,-0,0,0,0,0,0
    0.5,"a, ""b""",2,0.1,0.25,0,-0,0,0,0,0,
    0.5,"a, ""b""",2,0.1,0.25,3,-0,0,0,0,0,0
    2,cue,1.5,0.1,0.25,0,-0,0,0,0,0,
    2,"a, ""b""",6.5,0.1,0.25,3,-0,0,0,0,0,
    "#);
    insta::assert_snapshot!(files.final_states, @r#"
    ball,x,y,z,vx,vy,vz,wx,wy,wz,stop_time
    cue,1.5,0.1,0.25,0,-0,0,0,0,0,0.5
    "a, ""b""",6.5,0.1,0.25,3,-0,0,0,0,0,
    "#);
    insta::assert_snapshot!(files.run, @r#"
    {
      "engine": "stepper",
      "version": "carom 0.1.0",
      "parameters": {
        "dt": 0.001
      },
      "scene": "head-on",
      "scene_hash": "0123456789abcdef",
      "resolution": 0.001,
      "rest_speed": 0.0,
      "ulp": 2.220446049250313e-16,
      "ending": {
        "kind": "duration"
      },
      "end_time": 2.0,
      "counters": {
        "steps": 2000
      },
      "extrema": {
        "energy_gained": {
          "value": 0.0,
          "time": 0.0,
          "ball": null,
          "other": null
        },
        "momentum": {
          "value": "NaN",
          "time": 0.0,
          "ball": null,
          "other": null
        },
        "overlap": {
          "value": 1e-17,
          "time": 0.5,
          "ball": "cue",
          "other": "a, \"b\""
        },
        "outside": {
          "value": 0.0,
          "time": 0.0,
          "ball": null,
          "other": null
        },
        "displaced": {
          "value": 0.0,
          "time": 0.0,
          "ball": null,
          "other": null
        }
      }
    }
    "#);
}

#[test]
fn a_pocketed_ball_has_empty_numbers_and_keeps_its_path() {
    let mut trace = example();
    trace.events[1].kind = EventKind::Pocket(0, 3);
    trace.stop_times[0] = None;
    let files = files::write(&trace).unwrap();
    assert_eq!(files.events.lines().nth(2), Some("1,0.5,pocket,cue,p3,,,,"));
    assert_eq!(files.final_states.lines().nth(1), Some("cue,,,,,,,,,,"));
    assert_eq!(bits(&files::read(&files).unwrap()), bits(&trace));
}

#[test]
fn certainty_is_unknown_where_its_columns_are_missing() {
    let trace = example();
    let mut files = files::write(&trace).unwrap();
    let without = |line: &str| line.rsplitn(4, ',').last().unwrap().to_owned() + "\n";
    files.events = files.events.lines().map(without).collect();
    assert!(files.events.starts_with("index,time,kind,a,b,exchanges\n"));
    let read = files::read(&files).unwrap();
    assert_eq!(read.certainty, []);
    assert_eq!(read.events, trace.events);
}

#[test]
fn later_versions_may_append_columns_and_keys() {
    let trace = example();
    let files = files::write(&trace).unwrap();
    let append = |text: &str| {
        let rows = text.lines().enumerate();
        rows.map(|(i, row)| format!("{row},{}\n", if i == 0 { "new" } else { "?" }))
            .collect::<String>()
    };
    let later = Files {
        events: append(&files.events),
        samples: append(&files.samples),
        final_states: append(&files.final_states),
        run: files.run.replacen('{', "{\n  \"new\": [1],", 1),
    };
    assert_eq!(bits(&files::read(&later).unwrap()), bits(&trace));
}

#[test]
fn every_fault_is_named_by_file_line_and_column() {
    type Edit = fn(&mut Files);
    let faults: &[(Edit, &str)] = &[
        (
            |f| f.events = String::new(),
            "events.csv:1: there is no column `index`; the first line must name index,time,kind,a,b,exchanges",
        ),
        (
            |f| f.samples = f.samples.replace(",vz,", ",v3,"),
            "samples.csv:1: there is no column `vz`; the first line must name time,ball,x,y,z,vx,vy,vz,wx,wy,wz,event",
        ),
        (
            |f| f.events = f.events.replace("1,0.5,stop,cue,,", "1,0.5,stop"),
            "events.csv:3: expected 9 fields, as many as the first line has, and found 6",
        ),
        (
            |f| f.events = f.events.replace("\n1,", "\n2,"),
            "events.csv:3: column `index`: `2`: events are numbered from 0; expected 1",
        ),
        (
            |f| f.events = f.events.replace("1,0.5,", "1,0.4,"),
            "events.csv:3: column `time`: 0.4 is earlier than the event before",
        ),
        (
            |f| f.events = f.events.replace("1,0.5,", "1,later,"),
            "events.csv:3: column `time`: `later`: expected a number",
        ),
        (
            |f| f.events = f.events.replace("stop", "halt"),
            "events.csv:3: column `kind`: unknown kind `halt`; known are ball-ball, ball-cushion, stop, slide-to-roll, spin-end, pocket, contact-begin, contact-end",
        ),
        (
            |f| f.events = f.events.replace("stop,cue", "stop,8"),
            "events.csv:3: column `a`: there is no ball `8`; final.csv names cue, a, \"b\"",
        ),
        (
            |f| f.events = f.events.replace("stop,cue,", "ball-cushion,cue,z0"),
            "events.csv:3: column `b`: `z0`: expected a cushion, x0, x1, y0 or y1",
        ),
        (
            |f| f.events = f.events.replace("stop,cue,", "pocket,cue,3"),
            "events.csv:3: column `b`: `3`: expected a pocket, p0, p1, ...",
        ),
        (
            |f| f.events = f.events.replace("stop,cue,", "stop,cue,x0"),
            "events.csv:3: column `b`: `x0`: expected nothing for this kind",
        ),
        (
            |f| f.events = f.events.replace(r#""a, ""b""",1"#, "cue,1"),
            "events.csv:2: column `b`: `cue` with `cue`: expected two balls in the order of final.csv",
        ),
        (
            |f| f.events = f.events.replace(",1,inf", ",-1,inf"),
            "events.csv:2: column `exchanges`: `-1`: expected a whole number, 0 or more",
        ),
        (
            |f| f.events = f.events.replace("1.25", "often"),
            "events.csv:2: column `condition`: `often`: expected a number",
        ),
        (
            |f| f.events = f.events.replace(",1,inf", ",1,-inf"),
            "events.csv:2: column `margin`: `-inf`: expected a number, 0 or more, or inf",
        ),
        (
            |f| f.events = f.events.replace("1.25", "NaN"),
            "events.csv:2: column `condition`: `NaN`: expected a number, 0 or more, or inf",
        ),
        (
            |f| f.events = f.events.replace("1,0.5,", "1,inf,"),
            "events.csv:3: column `time`: `inf`: expected a finite number",
        ),
        (
            |f| f.samples = f.samples.replace("2,cue", "inf,cue"),
            "samples.csv:8: column `time`: `inf`: expected a finite number",
        ),
        // a decimal beyond the largest number is infinite
        (
            |f| f.samples = f.samples.replace("2,cue,1.5,0.1", "2,cue,1.5,1e999"),
            "samples.csv:8: column `y`: `1e999`: expected a finite number; only a run that ends as not-finite in run.json may hold others",
        ),
        (
            |f| {
                f.samples = f
                    .samples
                    .replace("2,cue,1.5,0.1,0.25,0", "2,cue,1.5,0.1,0.25,NaN")
            },
            "samples.csv:8: column `vx`: `NaN`: expected a finite number; only a run that ends as not-finite in run.json may hold others",
        ),
        (
            |f| f.final_states = f.final_states.replace("0,0.5\n", "0,inf\n"),
            "final.csv:2: column `stop_time`: `inf`: expected a finite number",
        ),
        (
            |f| f.final_states = f.final_states.replace("cue,1.5", "cue,inf"),
            "final.csv:2: column `x`: inf, but the last row of the ball in samples.csv says 1.5",
        ),
        (
            |f| f.samples = f.samples.replace("2,cue", "0.2,cue"),
            "samples.csv:8: column `time`: 0.2 is earlier than the ball's row before",
        ),
        (
            |f| {
                f.samples = f
                    .samples
                    .replace("0,0,0,0\n", "0,0,0,7\n")
                    .replace(",0,0,0,\n", ",0,0,0,7\n")
            },
            "samples.csv:2: column `event`: events.csv has 2 rows, no event 7",
        ),
        (
            |f| {
                f.samples = f
                    .samples
                    .replace(",0\n0.5,\"a", ",1\n0.5,\"a")
                    .replace("3,-0,0,0,0,0,0\n", "3,-0,0,0,0,0,1\n")
            },
            "samples.csv:7: column `event`: event 1 is not one of ball `a, \"b\"`",
        ),
        (
            |f| {
                f.samples = f
                    .samples
                    .lines()
                    .filter(|l| !l.contains("cue"))
                    .map(|l| format!("{l}\n"))
                    .collect()
            },
            "samples.csv:5: the file has no row of ball `cue`; every ball of final.csv has at least its first state",
        ),
        (
            |f| f.final_states = f.final_states.replace("cue,1.5", "cue,1.25"),
            "final.csv:2: column `x`: 1.25, but the last row of the ball in samples.csv says 1.5",
        ),
        (
            |f| f.final_states = f.final_states.replace("\"a, \"\"b\"\"\"", "cue"),
            "final.csv:3: column `ball`: ball `cue` is already on line 2",
        ),
        (
            |f| f.final_states = f.final_states.replace("cue,1.5", "cue,"),
            "final.csv:2: column `x`: ``: expected a number",
        ),
        (
            |f| {
                f.final_states = "ball,x,y,z,vx,vy,vz,wx,wy,wz,stop_time\ncue,,,,,,,,,,0.5\n\"a, \"\"b\"\"\",6.5,0.1,0.25,3,-0,0,0,0,0,\n".into()
            },
            "final.csv:2: column `x`: empty, but the ball is in play: expected the last state in samples.csv",
        ),
        (
            |f| f.events = f.events.replace("stop,cue,", "pocket,cue,p0"),
            "final.csv:2: column `x`: the ball is pocketed in events.csv: expected empty numbers",
        ),
        (
            |f| f.run = f.run.replace("\"end_time\"", "\"end\""),
            "run.json:51:1: missing field `end_time`",
        ),
        (
            |f| f.run = f.run.replace("2000", "-2000"),
            "run.json:17:18: invalid value: integer `-2000`, expected u64",
        ),
        (
            |f| f.run = f.run.replace("\"NaN\"", "\"none\""),
            "run.json:27:21: invalid value: string \"none\", expected a number, \"NaN\", \"inf\" or \"-inf\"",
        ),
        (
            |f| f.run = f.run.replace("\"end_time\": 2.0", "\"end_time\": \"inf\""),
            "run.json:15:19: invalid value: string \"inf\", expected a finite number",
        ),
        (
            |f| {
                f.run = f
                    .run
                    .replace("\"rest_speed\": 0.0", "\"rest_speed\": \"NaN\"")
            },
            "run.json:10:21: invalid value: string \"NaN\", expected a finite number",
        ),
        (
            |f| f.run = f.run.replace("\"time\": 0.5", "\"time\": \"inf\""),
            "run.json:34:19: invalid value: string \"inf\", expected a finite number",
        ),
        (
            |f| f.run = f.run.replace("\"duration\"", "\"collapsed\""),
            "run.json: `ending`: kind `collapsed`: expected rest, duration or cancelled without a spot, or budget, indeterminate, undecidable, collapsed or not-finite with one",
        ),
        (
            |f| f.run = f.run.replace("\"cue\"", "\"8\""),
            "run.json: `extrema.overlap`: there is no ball `8`; final.csv names cue, a, \"b\"",
        ),
    ];
    let valid = files::write(&example()).unwrap();
    for (edit, expected) in faults {
        let mut files = valid.clone();
        edit(&mut files);
        assert_ne!(files, valid, "the edit for `{expected}` changed nothing");
        let got = files::read(&files).expect_err(expected).to_string();
        assert_eq!(got, *expected);
    }
}
