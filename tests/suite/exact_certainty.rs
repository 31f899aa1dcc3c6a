//! Certainty, growth, sensitivity and horizon of the exact engine, held against runs in more digits and against perturbed runs.

use crate::support::{G, MU, R, report_break, run, scenario};
use carom::engine::Limits;
use carom::engine::exact::sensitivity::{Influence, Input, growth, influences};
use carom::engine::exact::{Precision, Solution, solve};
use carom::math::random::Draws;
use carom::math::{DoubleDouble, Octuple, Real};
use carom::oracle::{BAND, Horizon, Limit, horizon};
use carom::physics::Cloth;
use carom::scene::{Scene, catalogue};
use carom::trace::{Ending, Record, Trace};
use nalgebra::DMatrix;

fn wide(scene: &Scene) -> Solution<DoubleDouble> {
    solve(scene, &Limits::NONE)
}

fn of(scene: &Scene) -> Horizon {
    horizon(scene, Precision::F64, true, &Limits::NONE).unwrap()
}

fn traced(scene: &Scene) -> Trace {
    run("exact", &[], scene, Record::Events)
}

/// A break of the report with every racked ball displaced by up to a hundredth of the gap, at another friction.
fn jittered(index: u64, mu: f64) -> Scene {
    let gap = 1e-2 * R;
    let mut scene = report_break(gap, 90.2);
    scene.effects.cloth = Some(Cloth::Translational { mu });
    let mut draws = Draws::new(11, index);
    for ball in &mut scene.balls[1..] {
        let (dx, dy) = draws.in_disc(0.4 * gap);
        ball.state.position.x += dx;
        ball.state.position.y += dy;
    }
    scene
}

/// What a relative change of the cue ball's speed, a turn of it, or a relative change of mu makes of the scene.
fn changed(scene: &Scene, input: Input, by: f64) -> Scene {
    let mut scene = scene.clone();
    let cue = scene.cue_ball();
    match input {
        Input::Aim => {
            let v = scene.balls[cue].state.velocity;
            scene.balls[cue].state.velocity.x = v.x - by * v.y;
            scene.balls[cue].state.velocity.y = v.y + by * v.x;
        }
        Input::Speed => scene.balls[cue].state.velocity *= 1.0 + by,
        Input::Effect(_) => {
            scene.effects = scene.effects.map(|_, value| value * (1.0 + by));
        }
        Input::BallRestitution | Input::CushionRestitution => panic!("no elastic law takes it"),
    }
    scene
}

fn influence(found: &[Influence], input: Input) -> &Influence {
    let named = |influence: &&Influence| influence.input == input;
    found
        .iter()
        .find(named)
        .unwrap_or_else(|| panic!("no {}", input.name()))
}

#[test]
fn derivatives_of_final_positions_are_those_of_perturbed_pairs() {
    let scenes = [
        "report-break",
        "six-balls",
        "three-ball",
        "cushions",
        "oblique",
        "break-36-events",
    ];
    let inputs = [
        Input::Aim,
        Input::Speed,
        Input::Effect("cloth.translational.mu"),
    ];
    let mut compared = 0;
    for name in scenes {
        let scene = catalogue::scene(name).unwrap();
        let found = influences(&scene, &traced(&scene), f64::INFINITY, &Limits::NONE);
        let before = wide(&scene);
        for input in inputs {
            // in 106 bits the difference keeps its digits; second order leaves a part of by x growth, 1e-10 x 1e5
            let by = 1e-10;
            let after = wide(&changed(&scene, input, by));
            // the change that the f64 numbers of the scene really took is by to 1e-16 / 1e-10
            let derivative = &influence(&found, input).derivative;
            let largest = derivative
                .iter()
                .flatten()
                .fold(0.0_f64, |most, d| most.max(d.abs()));
            for (ball, d) in derivative.iter().enumerate() {
                for (axis, d) in d.iter().enumerate() {
                    let moved = after.positions[ball][axis] - before.positions[ball][axis];
                    let quotient = moved.to_f64() / by;
                    let error = (quotient - d).abs();
                    assert!(
                        error <= 0.01 * d.abs() + 1e-4 * largest,
                        "{name}, {}, ball {ball}: {} instead of {quotient}",
                        input.name(),
                        d
                    );
                    compared += usize::from(d.abs() > 1e-3 * largest);
                }
            }
        }
    }
    assert!(
        compared > 60,
        "only {compared} derivatives were large enough to mean anything"
    );
}

#[test]
fn restitution_moves_stop_positions_as_the_closed_forms_say() {
    // head on: the struck ball leaves with v (1 + e) / 2 and slides v'^2 / (2 mu g); by e, at e = 1: v^2 / (2 mu g)
    let (v0, gap) = (3.0, 1.0);
    let scene = scenario("head-on")
        .moving("cue", [0.0, 0.0], [v0, 0.0])
        .resting("1", [2.0 * R + gap, 0.0])
        .cloth(MU)
        .build();
    let v = (v0 * v0 - 2.0 * MU * G * gap).sqrt();
    let found = influences(&scene, &traced(&scene), f64::INFINITY, &Limits::NONE);
    let by_e = &influence(&found, Input::BallRestitution).derivative;
    assert!(
        (by_e[1][0] - v * v / (2.0 * MU * G)).abs() < 1e-12,
        "{by_e:?}"
    );
    // the cue ball keeps v (1 - e) / 2, whose square has no first order
    assert!(by_e[0][0].abs() < 1e-12, "{by_e:?}");
    // straight into a cushion: it comes back e^2 v^2 / (2 mu g); by e: v^2 / (mu g), away from the cushion
    let scene = scenario("cushion")
        .moving("cue", [10.0 - R - gap, 5.0], [v0, 0.0])
        .cloth(MU)
        .cushions(10.0, 10.0)
        .build();
    let found = influences(&scene, &traced(&scene), f64::INFINITY, &Limits::NONE);
    let by_e = &influence(&found, Input::CushionRestitution).derivative;
    assert!((by_e[0][0] + v * v / (MU * G)).abs() < 1e-12, "{by_e:?}");
}

#[test]
fn growth_is_the_largest_singular_value_of_a_map_made_of_differences() {
    let mut steps = 0;
    for name in ["three-ball", "six-balls", "oblique"] {
        let scene = catalogue::scene(name).unwrap();
        let trace = traced(&scene);
        let found = growth(&scene, &trace, true, &Limits::NONE).unwrap();
        assert_eq!(found.factors.len(), trace.events.len(), "{name}");
        let (length, speed) = (scene.smallest_radius(), scene.largest_speed());
        let n = scene.balls.len();
        let nudge = 1e-9;
        // one column a coordinate, from two runs; a resting ball keeps its place when its velocity is nudged
        let nudged = |column: usize| {
            let (ball, of, axis) = (column / 4, column % 4 / 2, column % 2);
            let mut scene = scene.clone();
            match of {
                0 => scene.balls[ball].state.position[axis] += nudge * length,
                _ if scene.balls[ball].state.speed() > 0.0 => {
                    scene.balls[ball].state.velocity[axis] += nudge * speed;
                }
                _ => {}
            }
            wide(&scene).trace
        };
        let columns: Vec<Trace> = (0..4 * n).map(nudged).collect();
        let plain = wide(&scene).trace;
        // a little after the event, so that both runs of a pair have it behind them; not where another is as close
        for (index, event) in trace.events.iter().enumerate() {
            let t = event.time + 1e-6;
            if trace
                .events
                .get(index + 1)
                .is_some_and(|next| next.time < t + 1e-6)
            {
                continue;
            }
            let coordinate = |trace: &Trace, row: usize| {
                let state = trace.paths[row / 4].state_at(t).unwrap();
                match row % 4 / 2 {
                    0 => state.position[row % 2] / length,
                    _ => state.velocity[row % 2] / speed,
                }
            };
            let map = DMatrix::from_fn(4 * n, 4 * n, |row, column| {
                (coordinate(&columns[column], row) - coordinate(&plain, row)) / nudge
            });
            let want = map.singular_values().max();
            let error = (found.factors[index] / want - 1.0).abs();
            assert!(
                error < 0.01,
                "{name} after event {index}: {} instead of {want}",
                found.factors[index]
            );
            steps += 1;
        }
    }
    assert!(steps >= 15, "only {steps} events were compared");
}

#[test]
fn the_estimated_error_of_a_time_covers_the_error_seen() {
    let (mut events, mut tight) = (0, 0);
    for index in 0..60 {
        let mu = [0.2, 0.05, 0.002][index as usize % 3];
        let found = of(&jittered(index, mu));
        for (number, sight) in found.sights[..found.certain].iter().enumerate() {
            let (seen, estimated) = (sight.seen.unwrap(), sight.estimated.unwrap());
            assert!(
                seen <= estimated,
                "shot {index} at mu {mu}, event {number}: {seen:e} seen, {estimated:e} estimated"
            );
            events += 1;
            tight += usize::from(estimated < 100.0 * seen);
        }
    }
    // an estimate that is always far too large would be of no use
    assert!(
        2 * tight > events,
        "{tight} of {events} estimates within a factor of 100"
    );
}

/// Number of events of the f64 run before it leaves the band around the run in 237 bits, or its order.
fn kept(scene: &Scene) -> usize {
    let (run, truth) = (
        solve::<f64>(scene, &Limits::NONE),
        solve::<Octuple>(scene, &Limits::NONE),
    );
    let (length, speed) = (scene.smallest_radius(), scene.largest_speed());
    // ball by ball: events that share no ball may come in either order
    let history = |trace: &Trace, ball: usize| -> Vec<usize> {
        let of_ball = |index: &usize| {
            let (a, b) = trace.events[*index].kind.balls();
            a == ball || b == Some(ball)
        };
        (0..trace.events.len()).filter(of_ball).collect()
    };
    let mut first = run.trace.events.len();
    for ball in 0..scene.balls.len() {
        let (ours, theirs) = (history(&run.trace, ball), history(&truth.trace, ball));
        for (place, &index) in ours.iter().enumerate() {
            let same = theirs.get(place).filter(|other| {
                let other = truth.trace.events[**other];
                other.kind == run.trace.events[index].kind
                    && (other.time - run.trace.events[index].time).abs() * speed / length < BAND
            });
            let near = same.is_some_and(|&other| {
                let far = |trace: &Trace, event: usize| {
                    let knots = &trace.paths[ball].knots;
                    let side = knots.iter().find(|knot| knot.after == Some(event as u32));
                    side.unwrap().state
                };
                let (a, b) = (far(&run.trace, index), far(&truth.trace, other));
                (a.position - b.position).norm() / length < BAND
                    && (a.velocity - b.velocity).norm() / speed < BAND
            });
            if !near {
                first = first.min(index);
                break;
            }
        }
    }
    first
}

#[test]
fn the_horizon_is_never_past_the_event_where_237_bits_part_from_f64() {
    let (mut finite, mut shots) = (0, 0);
    for index in 0..60 {
        let mu = if index % 2 == 0 { 0.05 } else { 0.002 };
        let scene = jittered(index, mu);
        let found = of(&scene);
        let kept = kept(&scene);
        assert!(
            found.certain <= kept,
            "shot {index} at mu {mu}: horizon {}, f64 keeps {kept}",
            found.certain
        );
        // it gives up little: half of what f64 keeps, at the least
        assert!(
            2 * found.certain >= kept,
            "shot {index} at mu {mu}: horizon {} of {kept}",
            found.certain
        );
        finite += usize::from(!found.is_whole());
        shots += 1;
    }
    assert!(
        shots == 60 && finite >= 20,
        "{finite} of {shots} shots have a horizon within the run"
    );
}

#[test]
fn a_coarse_precision_has_a_near_horizon_and_a_fine_one_sees_the_whole_shot() {
    let scene = catalogue::scene("report-break").unwrap();
    let near = horizon(&scene, Precision::F32, false, &Limits::NONE).unwrap();
    assert!(
        !near.is_whole() && near.certain < 10,
        "{} {:?}",
        near.certain,
        near.limit
    );
    for precision in [Precision::F64, Precision::Dd] {
        let far = horizon(&scene, precision, false, &Limits::NONE).unwrap();
        assert_eq!(far.limit, Limit::Whole, "{}", precision.id());
        assert_eq!(far.until, f64::INFINITY);
    }
    for precision in [Precision::F256, Precision::Auto] {
        assert_eq!(horizon(&scene, precision, false, &Limits::NONE), None);
    }
}

#[test]
fn auto_takes_more_digits_only_where_they_are_needed() {
    let bits = |scene: &Scene| {
        let trace = run("exact", &["precision=auto"], scene, Record::Events);
        (trace.counters["bits"], trace.ending, trace.events.len())
    };
    // a rack ball grazed at 1e-15 of the contact distance: f64 cannot tell, double-double can
    let graze = |miss: f64| {
        scenario("graze")
            .moving("cue", [0.0, 0.0], [4.0, 0.0])
            .resting("1", [1.0, 2.0 * R * (1.0 - miss)])
            .cloth(MU)
            .build()
    };
    let undecided = traced(&graze(2e-16));
    assert!(
        matches!(undecided.ending, Ending::Undecidable(_)),
        "{:?}",
        undecided.ending
    );
    let (digits, ending, _) = bits(&graze(2e-16));
    assert_eq!((digits, ending), (106, Ending::Rest));
    let (digits, ending, _) = bits(&graze(1e-3));
    assert_eq!((digits, ending), (53, Ending::Rest));
    // hits in a corner at one instant may come in any order, and need no digits
    let corner = scenario("corner")
        .moving("cue", [2.0, 2.0], [-4.0, -4.0])
        .cloth(MU)
        .cushions(4.0, 4.0)
        .build();
    let (digits, ending, events) = bits(&corner);
    assert_eq!((digits, ending), (53, Ending::Rest));
    assert!(events >= 3, "{events} events");
    // order decides the result in any precision
    let scene = catalogue::scene("triple-hit").unwrap();
    let (digits, ending, _) = bits(&scene);
    assert!(
        digits == 237 && matches!(ending, Ending::Indeterminate(_)),
        "{digits} {ending:?}"
    );
    // a chaotic run needs more digits for its late events
    let late = catalogue::scene("discs-in-a-box").unwrap();
    let (digits, ending, _) = bits(&late);
    assert!(
        digits > 53 && ending == Ending::Duration,
        "{digits} {ending:?}"
    );
}

#[test]
fn auto_answers_what_the_precision_it_chose_answers() {
    let scene = catalogue::scene("discs-in-a-box").unwrap();
    let auto = run("exact", &["precision=auto"], &scene, Record::Events);
    let chosen = match auto.counters["bits"] {
        106 => "precision=dd",
        237 => "precision=f256",
        bits => panic!("{bits} bits"),
    };
    let plain = run("exact", &[chosen], &scene, Record::Events);
    assert_eq!((&auto.events, &auto.paths), (&plain.events, &plain.paths));
    // a record without events is the same one, pared
    let last = run("exact", &["precision=auto"], &scene, Record::Final);
    assert_eq!(last.final_states(), auto.final_states());
    assert!(last.events.is_empty() && last.certainty.is_empty());
}

#[test]
fn margins_say_when_the_ball_would_have_met_something_else() {
    // the cue ball hits "1" and would, had it not, have hit "2" behind it
    let scene = scenario("two-in-a-row")
        .moving("cue", [0.0, 0.0], [4.0, 0.0])
        .resting("1", [1.0, 0.0])
        .resting("2", [1.0 + 1e-3, 2.0 * R * 0.999_999])
        .build();
    let trace = run("exact", &[], &scene, Record::Every(0.1));
    assert_eq!(trace.certainty.len(), trace.events.len());
    let first = trace.certainty[0];
    // closed forms: contact where the distance is 2R, at constant speed
    let offset: f64 = 2.0 * R * 0.999_999;
    let meets = |x: f64, y: f64| (x - (4.0 * R * R - y * y).sqrt()) / 4.0;
    let margin = meets(1.0 + 1e-3, offset) - meets(1.0, 0.0);
    let found = first.margin.unwrap();
    // a grazing time is conditioned like 1 / sin of the angle, here 700
    assert!(
        (found - margin).abs() < 1e-12,
        "{found} instead of {margin}"
    );
    assert!((first.condition.unwrap() - 1.0).abs() < 1e-12);
    // the plane is as wide as the ball can go in 20 s: 80, whose rounding is 2e-14
    assert!(first.time_error.unwrap() < 1e-13);
}
