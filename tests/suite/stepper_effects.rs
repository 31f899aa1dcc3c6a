//! Rotation, losses, throw, cushions and pockets in the report's scheme, held against closed forms with the errors that the
//! scheme must have.
//!
//! What a step leaves exact is held to rounding. What it does not is held to bounds that follow from the scheme: a phase ends
//! at the first step end after its time, so up to dt late; a position in a phase of deceleration a falls short by a t dt/2; a
//! contact is found up to one step late, so the line of centres of a hit with offset b is turned by at most v dt b / D^2.

use crate::support::{Scenario, run, scenario};
use carom::engine::{Setting, find, prepare};
use carom::math::Vec3;
use carom::physics::cloth::rotational::{self, Coefficients, roll_distance, slid, slide_time};
use carom::physics::contact;
use carom::physics::{Body, Cloth, Contact, Cushion, Effects, Friction, Motion, Pockets, State};
use carom::scene::{Scene, Table};
use carom::trace::{Ending, EventKind, Record, Trace};

/// A pool ball and its cloth, SI.
const R: f64 = 0.028575;
const M: f64 = 0.170097;
const G: f64 = 9.81;
const MU: Coefficients = Coefficients {
    mu_slide: 0.2,
    mu_roll: 0.01,
    mu_spin: 0.0117,
};

/// Some tens of roundings of numbers near 1.
const ROUNDING: f64 = 1e-13;

const APPROACHING: &str = "contact=approaching-only";

fn cloth(mu: Coefficients) -> Cloth {
    Cloth::Rotational {
        mu_slide: mu.mu_slide,
        mu_roll: mu.mu_roll,
        mu_spin: mu.mu_spin,
    }
}

/// Pool balls with velocity and spin on a pool cloth.
fn pool(name: &str, mu: Coefficients, balls: &[([f64; 2], [f64; 2], [f64; 3])]) -> Scene {
    let start = |scene: Scenario, (i, (p, v, _)): (usize, &([f64; 2], [f64; 2], [f64; 3]))| {
        scene.moving(&i.to_string(), *p, *v)
    };
    let mut scene = balls
        .iter()
        .enumerate()
        .fold(scenario(name), start)
        .duration(100.0)
        .build();
    for (ball, (_, _, spin)) in scene.balls.iter_mut().zip(balls) {
        (ball.radius, ball.mass) = (R, M);
        ball.state.position.z = R;
        ball.state.spin = Vec3::from(*spin);
    }
    scene.effects = Effects {
        cloth: Some(cloth(mu)),
        contact: Some(Contact::Elastic {}),
        ..Effects::default()
    };
    scene
}

fn one_ball(velocity: [f64; 2], spin: [f64; 3]) -> Scene {
    pool("one-ball", MU, &[([0.0, 0.0], velocity, spin)])
}

fn rolling(velocity: [f64; 2]) -> [f64; 3] {
    rotational::rolling_spin(&Vec3::new(velocity[0], velocity[1], 0.0), R).into()
}

fn simulate(scene: &Scene, dt: f64, record: Record) -> Trace {
    run(
        "stepper",
        &[&format!("dt={dt}"), APPROACHING],
        scene,
        record,
    )
}

fn time_of(trace: &Trace, kind: EventKind) -> f64 {
    let found: Vec<f64> = trace
        .events
        .iter()
        .filter(|e| e.kind == kind)
        .map(|e| e.time)
        .collect();
    assert_eq!(found.len(), 1, "{kind:?} in {:?}", trace.events);
    found[0]
}

/// Both sides of what an event did to a ball.
fn sides(trace: &Trace, ball: usize, event: usize) -> (State, State) {
    let knots = &trace.paths[ball].knots;
    let far = knots.iter().position(|k| k.after == Some(event as u32));
    let far = far.unwrap_or_else(|| panic!("no knot of event {event} for ball {ball}"));
    (knots[far - 1].state, knots[far].state)
}

fn within(what: &str, got: f64, want: f64, bound: f64) {
    let error = (got - want).abs();
    assert!(
        error <= bound,
        "{what}: got {got}, expected {want}, error {error:e}, bound {bound:e}"
    );
}

#[test]
fn centre_hit_rolls_after_2v_over_7_mu_g_with_five_sevenths_of_speed_and_energy() {
    let a = MU.mu_slide * G;
    for v in [0.5, 2.0] {
        for dt in [1e-2, 1e-3, 1e-4] {
            let case = format!("v {v}, dt {dt}");
            let scene = one_ball([0.0, v], [0.0; 3]);
            let trace = simulate(&scene, dt, Record::Events);
            let t_s = 2.0 * v / (7.0 * a);
            let t = time_of(&trace, EventKind::SlideToRoll(0));
            assert!(
                t >= t_s - ROUNDING && t <= t_s + dt + ROUNDING,
                "{case}: rolls at {t}, exact {t_s}"
            );
            let state = trace.paths[0].state_at(t).unwrap();
            within(
                &format!("{case}: speed"),
                state.velocity.y,
                5.0 / 7.0 * v,
                ROUNDING,
            );
            let left = scene.kinetic_energy(&[state]) / scene.initial_energy();
            within(&format!("{case}: energy left"), left, 5.0 / 7.0, ROUNDING);
            // 12 v^2 / (49 mu g) at t_s, and on from there
            let late = t - t_s;
            let rolled = 5.0 / 7.0 * v * late - 0.5 * MU.mu_roll * G * late * late;
            let exact = 12.0 * v * v / (49.0 * a) + rolled;
            // n whole steps of sliding fall short by a n dt^2 / 2, the step in which the slide ends by at most (a + a_roll) dt^2 / 2
            let short = exact - state.position.y;
            within(
                &format!("{case}: distance"),
                short,
                0.5 * a * (t - dt) * dt,
                0.5 * (MU.mu_slide + MU.mu_roll) * G * dt * dt + ROUNDING,
            );
        }
    }
}

#[test]
fn any_spin_ends_as_natural_roll_v_minus_two_sevenths_of_the_slip() {
    let dt = 1e-3;
    for (v, w) in [
        ([0.0, 1.5], [30.0, 40.0, 25.0]),
        ([1.2, -0.7], [-80.0, 15.0, -60.0]),
        ([0.0, 0.0], [50.0, -20.0, 0.0]),
        ([0.3, 0.4], [0.0, 0.0, 90.0]),
    ] {
        let scene = one_ball(v, w);
        let start = scene.balls[0].state;
        let trace = simulate(&scene, dt, Record::Every(0.01));
        let slip = rotational::slip_velocity(&start.velocity, &start.spin, R);
        let t_s = slide_time(slip.norm(), MU.mu_slide, G);
        let t = time_of(&trace, EventKind::SlideToRoll(0));
        assert!(
            t >= t_s - ROUNDING && t <= t_s + dt + ROUNDING,
            "{v:?} {w:?}: {t}, {t_s}"
        );
        let state = trace.paths[0].state_at(t).unwrap();
        let roll = start.velocity - slip * (2.0 / 7.0);
        // one rounding a step of sliding
        let steps = t / dt;
        let off = (state.velocity - roll).norm();
        assert!(off <= steps * 1e-15, "{v:?} {w:?}: rolls {off:e} off");
        // the parabola on the way: a t dt/2 short along the slip, whose direction never changes
        for part in [0.3, 0.9] {
            let at = (part * t_s / dt).floor() * dt;
            let exact = slid(&start, R, MU, G, at);
            let lag = slip.normalize() * (0.5 * MU.mu_slide * G * at * dt);
            let got = trace.paths[0].state_at(at).unwrap();
            // between samples the trace is the cubic of constant acceleration, whose own error is of the size of a step's
            let bound = 0.5 * MU.mu_slide * G * 0.011 * dt;
            let off = (exact.position - lag - got.position).norm();
            assert!(
                off <= bound,
                "{v:?} {w:?} at {at}: {off:e}, bound {bound:e}"
            );
        }
    }
}

#[test]
fn draw_slows_stops_dead_at_five_halves_and_comes_back_beyond() {
    let v = 1.0;
    for k in [0.0, 1.0, 2.0, 2.5, 3.0, 4.0] {
        let scene = one_ball([0.0, v], [k * v / R, 0.0, 0.0]);
        let trace = simulate(&scene, 1e-3, Record::Events);
        let rolled = v * (5.0 - 2.0 * k) / 7.0;
        let speed = if k == 2.5 {
            // what is left is rounding: the ball stops at once or within a step
            let slide = slide_time((1.0 + k) * v, MU.mu_slide, G);
            let stop = trace.stop_times[0].unwrap();
            assert!(
                stop >= slide - ROUNDING && stop <= slide + 2e-3,
                "{stop} after {slide}"
            );
            0.0
        } else {
            let t = time_of(&trace, EventKind::SlideToRoll(0));
            trace.paths[0].state_at(t).unwrap().velocity.y
        };
        within(&format!("draw {k}"), speed, rolled, ROUNDING);
        // the halt of a ball that comes back is no stop
        time_of(&trace, EventKind::Stop(0));
    }
}

#[test]
fn a_ball_that_rolls_from_the_start_stops_after_v_over_mu_g_and_v_squared_over_2_mu_g() {
    let a = MU.mu_roll * G;
    for v in [[0.0, 0.3], [-0.24, 0.18]] {
        for dt in [1e-2, 1e-3] {
            let trace = simulate(&one_ball(v, rolling(v)), dt, Record::Events);
            let kinds: Vec<EventKind> = trace.events.iter().map(|e| e.kind).collect();
            assert_eq!(kinds, [EventKind::Stop(0)], "a rolling ball only stops");
            let stop = trace.stop_times[0].unwrap();
            let exact = 0.3 / a;
            // one rounding a step may move the end by a step
            assert!(
                stop >= exact - 1e-9 && stop <= exact + dt + 1e-9,
                "dt {dt}: stops at {stop}, exact {exact}"
            );
            let travelled = trace.final_states()[0].unwrap().position.xy().norm();
            // v = (N + f) a dt stops after N steps, v dt / 2 short but for a dt^2 (f - f^2) / 2
            within(
                &format!("dt {dt}: distance"),
                travelled,
                0.3 * 0.3 / (2.0 * a) - 0.3 * dt / 2.0,
                a * dt * dt / 8.0 + 1e-11,
            );
        }
    }
}

#[test]
fn spin_about_the_vertical_ends_after_2_r_w_over_5_mu_g_and_counts_as_stopped() {
    for w in [12.0, -30.0] {
        for dt in [1e-2, 1e-3] {
            let trace = simulate(&one_ball([0.0, 0.0], [0.0, 0.0, w]), dt, Record::Events);
            let exact = 2.0 * R * w.abs() / (5.0 * MU.mu_spin * G);
            let t = time_of(&trace, EventKind::SpinEnd(0));
            assert!(
                t >= exact - 1e-9 && t <= exact + dt + 1e-9,
                "{t}, exact {exact}"
            );
            assert_eq!(trace.events.len(), 1);
            assert_eq!(
                (trace.stop_times[0], &trace.ending),
                (Some(0.0), &Ending::Rest)
            );
            assert_eq!(trace.end_time, t);
            assert!(trace.final_states()[0].unwrap().is_at_rest());
        }
    }
}

/// Direction of the cue ball once it rolls again, degrees from its first: equal masses, no ball friction.
fn deflection(phi: f64, e: f64) -> f64 {
    let (sin, cos) = phi.sin_cos();
    let across = 5.0 / 7.0 * sin * cos * (1.0 + e) / 2.0;
    let along = 5.0 / 7.0 * (cos * cos * (1.0 - e) / 2.0 + sin * sin) + 2.0 / 7.0;
    across.atan2(along).to_degrees()
}

/// Cut angle of a hit as the trace has it, and the greatest that finding it a step late allows.
fn cut(trace: &Trace, v: f64, b: f64, dt: f64) -> (f64, f64) {
    let (cue, _) = sides(trace, 0, 0);
    let (object, _) = sides(trace, 1, 0);
    let apart = object.position - cue.position;
    let phi = (b / (2.0 * R)).asin();
    let found = apart.x.atan2(apart.y);
    let bound = phi + v * dt * b / apart.norm_squared();
    assert!(
        found >= phi - ROUNDING && found <= bound + ROUNDING,
        "found at {found}, touching at {phi}, at most {bound}"
    );
    (found, bound)
}

#[test]
fn rolling_cue_ball_is_deflected_by_the_angle_of_its_cut() {
    // sine of the cut angle, e, published angle in degrees and half its last digit
    for (sin, e, published, digits) in [
        (0.5, 1.0, 33.6705, 5e-5),
        (28.13_f64.to_radians().sin(), 1.0, 33.749, 5e-4),
        (0.75, 1.0, 27.267, 5e-4),
        (0.25, 1.0, 27.626, 5e-4),
        (0.5, 0.95, 32.26, 5e-3),
    ] {
        let (v, b) = (1.0, 2.0 * R * sin);
        within("the law", deflection(sin.asin(), e), published, digits);
        for dt in [1e-3, 1e-4, 1e-5] {
            let balls = [
                ([0.0, 0.0], [0.0, v], rolling([0.0, v])),
                ([b, 0.1], [0.0, 0.0], [0.0; 3]),
            ];
            let mut scene = pool("cut", MU, &balls);
            scene.effects.contact = Some(Contact::Inelastic { e });
            scene.duration = 1.0;
            let trace = simulate(&scene, dt, Record::Events);
            let (found, bound) = cut(&trace, v, b, dt);
            let t = time_of(&trace, EventKind::SlideToRoll(0));
            let direction = trace.paths[0].state_at(t).unwrap().velocity;
            let angle = (-direction.x).atan2(direction.y).to_degrees();
            // exact for the line of centres that the step found
            let case = format!("sin {sin}, e {e}, dt {dt}");
            within(&case, angle, deflection(found, e), 1e-10);
            // and so no further from the right angle than that line can be: the angle changes by less than the cut, twice
            let late = (bound - sin.asin()).to_degrees();
            within(&case, angle, deflection(sin.asin(), e), 2.0 * late + 1e-10);
        }
    }
}

/// A stun shot without a cloth: cue ball with spin `w_z`, object ball at rest at the cut angle `phi`.
fn stun(phi: f64, w_z: f64, e: f64, friction: Friction) -> Scene {
    let balls = [
        ([0.0, 0.0], [0.0, 1.0], [0.0, 0.0, w_z]),
        ([2.0 * R * phi.sin(), 0.1], [0.0, 0.0], [0.0; 3]),
    ];
    let mut scene = pool("stun", MU, &balls);
    scene.effects = Effects {
        contact: Some(Contact::Inelastic { e }),
        friction: Some(friction),
        ..Effects::default()
    };
    scene.duration = 0.3;
    scene
}

#[test]
fn throw_is_mu_while_balls_slip_and_two_sevenths_of_the_cut_while_they_stick() {
    let constant = |mu| Friction::Constant { mu };
    let alciatore = Friction::Alciatore {
        a: 9.951e-3,
        b: 0.108,
        c: 1.088,
        length_in_metres: 1.0,
    };
    let mut slipped = 0;
    for (degrees, e, law) in [
        (10.0, 1.0, constant(0.06)),
        (20.0, 0.94, constant(0.06)),
        (30.0, 1.0, constant(0.06)),
        (45.0, 0.94, constant(0.06)),
        (60.0, 0.5, constant(0.1)),
        (15.0, 0.94, alciatore),
        (50.0, 0.94, alciatore),
    ] {
        for dt in [1e-3, 1e-4] {
            let phi = f64::to_radians(degrees);
            let trace = simulate(&stun(phi, 0.0, e, law), dt, Record::Events);
            let (found, bound) = cut(&trace, 1.0, 2.0 * R * phi.sin(), dt);
            let v = trace.final_states()[1].unwrap().velocity;
            // towards the cue ball's motion: its surface drags the object ball along
            let thrown = found - v.x.atan2(v.y);
            let mu = match law {
                Friction::Constant { mu } => mu,
                Friction::Alciatore { a, b, c, .. } => a + b * (-c * found.sin()).exp(),
            };
            let slips = found.tan() >= 3.5 * mu * (1.0 + e);
            slipped += u64::from(slips);
            let tan = if slips {
                mu
            } else {
                2.0 * found.tan() / (7.0 * (1.0 + e))
            };
            // the object ball leaves to the side that the cue ball moves to: less cut, so the throw turns it back
            let case = format!("cut {degrees}, e {e}, {law:?}, dt {dt}");
            within(&case, thrown.abs(), tan.atan(), ROUNDING);
            assert!(bound - phi < 2.0 * dt / R, "{case}: {bound}");
        }
    }
    assert!(
        (4..=10).contains(&slipped),
        "{slipped} of 14 slip: both branches are met"
    );
}

#[test]
fn gearing_spin_throws_nothing_but_for_the_late_contact() {
    for degrees in [20.0, 45.0] {
        for dt in [1e-3, 1e-4] {
            let phi = f64::to_radians(degrees);
            // w_z = -v_t / R with t = z x n = (-cos phi, sin phi), so v_t = v sin phi
            let scene = stun(phi, -phi.sin() / R, 1.0, Friction::Constant { mu: 0.06 });
            let trace = simulate(&scene, dt, Record::Events);
            let (found, _) = cut(&trace, 1.0, 2.0 * R * phi.sin(), dt);
            let v = trace.final_states()[1].unwrap().velocity;
            let thrown = (found - v.x.atan2(v.y)).abs();
            // the slip that the turned line of centres leaves: both balls stick
            let slip = found.sin() - phi.sin();
            within("throw", thrown.tan(), slip / (7.0 * found.cos()), ROUNDING);
        }
    }
}

#[test]
fn head_on_impacts_follow_masses_radii_and_restitution_and_lose_what_they_should() {
    for (m2, r2, e) in [
        (M, R, 0.9),
        (0.5 * M, R, 1.0),
        (3.0 * M, 1.5 * R, 0.6),
        (M, 0.7 * R, 0.0),
    ] {
        let balls = [
            ([0.0, 0.0], [0.0, 1.0], [0.0; 3]),
            ([0.0, 0.2], [0.0, 0.0], [0.0; 3]),
        ];
        let mut scene = pool("head-on", MU, &balls);
        scene.effects.cloth = None;
        scene.effects.contact = Some(Contact::Inelastic { e });
        (scene.balls[1].mass, scene.balls[1].radius) = (m2, r2);
        scene.balls[1].state.position.z = r2;
        scene.duration = 0.3;
        let dt = 1e-3;
        let trace = simulate(&scene, dt, Record::Events);
        let case = format!("m2 {m2}, r2 {r2}, e {e}");
        let (cue, after) = sides(&trace, 0, 0);
        let (_, object) = sides(&trace, 1, 0);
        within(&case, after.velocity.y, (M - e * m2) / (M + m2), ROUNDING);
        within(&case, object.velocity.y, (1.0 + e) * M / (M + m2), ROUNDING);
        // centres at the heights of their radii
        let gap = 0.2 - cue.position.y - 2.0 * (R * r2).sqrt();
        assert!(gap < 0.0 && gap >= -dt, "{case}: found at a gap of {gap}");
        let lost = scene.initial_energy() - scene.kinetic_energy(&[after, object]);
        let law = (1.0 - e * e) * M * m2 / (2.0 * (M + m2));
        within(&case, lost, law, ROUNDING);
    }
}

#[test]
fn a_halt_after_an_impact_is_a_stop_unless_the_cloth_drives_the_ball_on() {
    // spin of the cue ball in v / R, and whether there is a cloth: draw, follow and stun
    for (k, on_cloth, stops) in [
        (0.0, false, true),
        (1.0, false, true),
        (1.0, true, false),
        (-0.5, true, false),
    ] {
        let balls = [
            ([0.0, 0.0], [0.0, 1.0], [k / R, 0.0, 0.0]),
            ([0.0, 2.0 * R + 1e-4], [0.0, 0.0], [0.0; 3]),
        ];
        let mut scene = pool("halt", MU, &balls);
        if !on_cloth {
            scene.effects.cloth = None;
            // balls that can turn, and do not rub when they do not slip
            scene.effects.friction = Some(Friction::Constant { mu: 0.0 });
        }
        scene.duration = 0.2;
        let trace = simulate(&scene, 1e-3, Record::Events);
        assert_eq!(trace.events[0].kind, EventKind::BallBall(0, 1));
        let (_, after) = sides(&trace, 0, 0);
        assert_eq!(after.speed(), 0.0, "draw {k}, cloth {on_cloth}");
        let stopped = trace
            .events
            .iter()
            .any(|e| e.kind == EventKind::Stop(0) && e.time == trace.events[0].time);
        assert_eq!(stopped, stops, "draw {k}, cloth {on_cloth}");
    }
}

#[test]
fn a_dead_ball_at_a_cushion_stops_there_and_then() {
    let mut scene = pool("dead-cushion", MU, &[([0.5, 0.5], [1.0, 0.0], [0.0; 3])]);
    scene.effects.cloth = None;
    scene.effects.cushion = Some(Cushion::Restitution { e: 0.0 });
    scene.table = Some(Table {
        min: [0.0, 0.0],
        max: [1.0, 1.0],
    });
    let trace = simulate(&scene, 1e-3, Record::Events);
    let kinds: Vec<(&str, f64)> = trace.events.iter().map(|e| (e.kind.id(), e.time)).collect();
    assert_eq!(kinds[0].0, "ball-cushion");
    assert_eq!(kinds[1], ("stop", kinds[0].1));
    assert_eq!((kinds.len(), &trace.ending), (2, &Ending::Rest));
}

/// Both sides of a ball that meets the cushion x1 with this velocity and spin: no cloth changes them on the way.
fn at_cushion(law: Cushion, v: [f64; 2], spin: [f64; 3]) -> (State, State) {
    let mut scene = pool("cushion", MU, &[([0.5, 0.5], v, spin)]);
    scene.effects.cloth = None;
    // one ball rubs at nothing; the law lets it turn
    scene.effects.friction = Some(Friction::Constant { mu: 0.06 });
    scene.effects.cushion = Some(law);
    scene.table = Some(Table {
        min: [0.0, 0.0],
        max: [1.0, 2.0],
    });
    scene.duration = 0.6 / v[0];
    let trace = simulate(&scene, 1e-3, Record::Events);
    assert_eq!(trace.events.len(), 1, "{:?}", trace.events);
    sides(&trace, 0, 0)
}

#[test]
fn cushions_rebound_as_their_laws_say() {
    let (before, after) = at_cushion(
        Cushion::Restitution { e: 0.85 },
        [1.0, 0.4],
        [1.0, 2.0, 3.0],
    );
    within("restitution", after.velocity.x, -0.85, ROUNDING);
    assert_eq!(after.velocity.y, 0.4);
    assert_eq!(after.spin, before.spin);

    // Han 2005, square onto the cushion without spin: slip (sin^2, 0, -sin cos) v, so the friction slows it and turns it about y
    for (mu, e, height) in [(0.2, 0.85, 1.28), (0.02, 0.85, 1.28), (0.3, 0.7, 1.4)] {
        let (_, after) = at_cushion(Cushion::Han2005 { e, mu, height }, [1.0, 0.0], [0.0; 3]);
        let sin: f64 = height - 1.0;
        let cos = (1.0 - sin * sin).sqrt();
        let push = f64::min(mu * (1.0 + e) * cos, 2.0 / 7.0 * sin);
        let x = 1.0 - (1.0 + e) * cos * cos - push * sin;
        within("Han 2005, speed", after.velocity.x, x, ROUNDING);
        within(
            "Han 2005, spin",
            after.spin.y,
            -2.5 / R * push,
            ROUNDING / R,
        );
        assert_eq!(
            after.velocity.z, 0.0,
            "the table keeps the ball in its plane"
        );
    }

    // Mathavan 2010 has no closed form; the law's own tests hold it against published data
    let law = Cushion::Mathavan2010 {
        e: 0.98,
        mu: 0.14,
        mu_cloth: 0.212,
        height: 1.4,
    };
    let (before, after) = at_cushion(law, [1.0, 0.5], [0.0, 0.0, 20.0]);
    let ball = Body {
        velocity: before.velocity,
        spin: before.spin,
        mass: M,
        radius: R,
    };
    let wanted = carom::physics::cushion::impact(law, &ball, carom::physics::Side::X1);
    assert_eq!(
        (after.velocity, after.spin),
        (wanted.motion.velocity, wanted.motion.spin)
    );
    assert!(after.velocity.x < -0.5 && after.speed() < before.speed());
}

#[test]
fn strikes_arrive_with_the_speed_and_spin_of_their_offset() {
    for (top, speed, spin) in [(0.0, 1.53847, 0.0), (0.4, 1.17647, 41.171)] {
        let text = format!(
            "name = \"strike\"\ndescription = \"\"\nduration = 100.0\ngravity = 9.81\n[ball]\nradius = {R}\nmass = {M}\n\
             [[balls]]\nid = \"cue\"\nposition = [0.0, 0.0]\n[shot.strike]\nball = \"cue\"\nspeed = 1.0\nangle_deg = 90.0\n\
             elevation_deg = 0.0\ncue_mass = 0.567\nside = 0.0\ntop = {top}\n\
             [effects.cloth.rotational]\nmu_slide = 0.2\nmu_roll = 0.01\nmu_spin = 0.01\n"
        );
        let scene = carom::scene::parse("strike.toml", &text).unwrap();
        let trace = simulate(&scene, 1e-3, Record::Events);
        let start = trace.paths[0].knots[0].state;
        // the digits of the published numbers
        within("speed", start.velocity.y, speed, 5e-6);
        within("spin", -start.spin.x, spin, 5e-4);
        let slides = trace
            .events
            .iter()
            .any(|e| e.kind == EventKind::SlideToRoll(0));
        assert_eq!(slides, top != 0.4, "a strike at 2/5 R rolls from the start");
    }
}

/// Observed order between each step size and the next: log2 of the ratio of errors where steps halve.
fn orders(errors: &[f64]) -> Vec<f64> {
    errors
        .windows(2)
        .map(|pair| (pair[0] / pair[1]).log2())
        .collect()
}

const STEPS: [f64; 6] = [8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4];

/// Phases of an event within its step that are averaged over: the error of one run is a saw tooth in the step size.
const PHASES: u32 = 16;

fn phase(k: u32) -> f64 {
    (f64::from(k) + 0.5) / f64::from(PHASES)
}

#[test]
fn time_to_roll_and_final_position_converge_with_order_one() {
    let mut mu = MU;
    // a short roll, so that the run is short
    mu.mu_roll = 0.05;
    let (a, a_roll) = (mu.mu_slide * G, mu.mu_roll * G);
    let (mut times, mut places) = (Vec::new(), Vec::new());
    for dt in STEPS {
        let (mut time, mut place) = (0.0, 0.0);
        for k in 0..PHASES {
            let t_s = 0.32 + phase(k) * dt;
            let v = 3.5 * a * t_s;
            let trace = simulate(
                &pool("order", mu, &[([0.0, 0.0], [0.0, v], [0.0; 3])]),
                dt,
                Record::Events,
            );
            time += time_of(&trace, EventKind::SlideToRoll(0)) - t_s;
            let roll = 5.0 / 7.0 * v;
            let exact = 12.0 * v * v / (49.0 * a) + roll * roll / (2.0 * a_roll);
            let short = exact - trace.final_states()[0].unwrap().position.y;
            // slide: a t dt/2 short, and at most v_roll dt too far for rolling on in the step that ends it; roll: v_roll dt/2 short
            assert!(
                short.abs() <= 0.5 * v * dt + 2.0 * a * dt * dt,
                "dt {dt}: {short:e}"
            );
            place += short;
        }
        times.push(time / f64::from(PHASES));
        places.push(place / f64::from(PHASES));
    }
    for (dt, time) in STEPS.iter().zip(&times) {
        within("mean lateness of rolling in steps", time / dt, 0.5, 1e-9);
    }
    // what is left is of relative size dt over the time to roll, 0.025 at the coarsest step
    for order in orders(&times).into_iter().chain(orders(&places)) {
        within("order", order, 1.0, 0.03);
    }
}

/// Where a ball ends that leaves an impact with this state, and the speed with which it begins to roll: slide, then roll, in
/// closed form.
fn ends(state: &State, mu: Coefficients) -> (Vec3, f64) {
    let slip = rotational::slip_velocity(&state.velocity, &state.spin, R);
    let rolls = slid(state, R, mu, G, slide_time(slip.norm(), mu.mu_slide, G));
    let speed = rolls.velocity.norm();
    let way = rolls.velocity * (roll_distance(speed, mu.mu_roll, G) / speed);
    (rolls.position + way, speed)
}

#[test]
fn a_shot_with_throw_converges_with_order_one() {
    let mut mu = MU;
    mu.mu_roll = 0.05;
    let a = mu.mu_slide * G;
    let (v, b) = (1.0, R);
    let law = Contact::Inelastic { e: 0.94 };
    let friction = Friction::Constant { mu: 0.06 };
    let body = |s: &State| Body {
        velocity: s.velocity,
        spin: s.spin,
        mass: M,
        radius: R,
    };
    // by ball and step size: mean distance from the closed form, and the most by which a saw tooth moves it, relative
    let mut errors = [Vec::new(), Vec::new()];
    let mut teeth = [0.0_f64; 2];
    for dt in STEPS {
        let (mut error, mut tooth) = ([0.0; 2], [0.0; 2]);
        for k in 0..PHASES {
            // the contact lies at another place within the step each time: phases of the way that the ball makes in it
            let object = 0.1;
            let nominal = object - (4.0 * R * R - b * b).sqrt();
            let start = -phase(k) * (v * v - 2.0 * a * nominal).sqrt() * dt;
            let balls = [
                ([0.0, start], [0.0, v], [0.0, 0.0, 10.0]),
                ([b, object], [0.0, 0.0], [0.0; 3]),
            ];
            let mut scene = pool("throw", mu, &balls);
            scene.effects.contact = Some(law);
            scene.effects.friction = Some(friction);
            let trace = simulate(&scene, dt, Record::Events);
            assert_eq!(trace.collisions().count(), 1, "dt {dt}, phase {k}");

            let t = (v - (v * v - 2.0 * a * (nominal - start)).sqrt()) / a;
            let hit = slid(&scene.balls[0].state, R, mu, G, t);
            let at_rest = scene.balls[1].state;
            let n = (at_rest.position - hit.position).normalize();
            let (one, two) = contact::impact(law, Some(friction), &body(&hit), &body(&at_rest), &n);
            for (i, (ball, motion)) in [(hit, one), (at_rest, two)].into_iter().enumerate() {
                let (Motion { velocity, spin }, _) = motion.on_cloth();
                let state = State {
                    position: ball.position,
                    velocity,
                    spin,
                };
                let (end, roll_speed) = ends(&state, mu);
                let got = trace.final_states()[i].unwrap().position;
                error[i] += (got - end).norm() / f64::from(PHASES);
                // slides begin at step ends, so they end at one place within their last step in all phases alike
                tooth[i] = 0.5 * roll_speed * dt;
            }
        }
        for i in 0..2 {
            errors[i].push(error[i]);
            teeth[i] = teeth[i].max(tooth[i] / error[i]);
        }
    }
    let halvings = (STEPS.len() - 1) as f64;
    for (errors, tooth) in errors.iter().zip(teeth) {
        assert!(
            tooth < 0.25,
            "the saw tooth drowns the order: {tooth} of {errors:?}"
        );
        let slope = (errors[0] / errors[STEPS.len() - 1]).log2() / halvings;
        let bound = ((1.0 + tooth) / (1.0 - tooth)).log2() / halvings;
        within(&format!("order of {errors:?}"), slope, 1.0, bound);
    }
}

/// Five balls, every law: inelastic contacts with throw, the cushion of Mathavan 2010, pockets at both sides.
fn busy() -> Scene {
    let balls = [
        ([-0.05, -0.3], [0.5, 4.0], [20.0, -15.0, 40.0]),
        ([0.0, 0.1], [0.0, 0.0], [0.0; 3]),
        ([-0.2, 0.3], [0.0, 0.0], [0.0; 3]),
        ([0.25, 0.25], [-0.8, -0.3], [0.0, 0.0, -30.0]),
        ([0.3, -0.35], [-0.6, 0.9], [-10.0, 0.0, 0.0]),
    ];
    let mut mu = MU;
    mu.mu_roll = 0.03;
    let mut scene = pool("busy", mu, &balls);
    scene.effects = Effects {
        cloth: Some(cloth(mu)),
        contact: Some(Contact::Inelastic { e: 0.93 }),
        friction: Some(Friction::Alciatore {
            a: 9.951e-3,
            b: 0.108,
            c: 1.088,
            length_in_metres: 1.0,
        }),
        cushion: Some(Cushion::Mathavan2010 {
            e: 0.98,
            mu: 0.14,
            mu_cloth: 0.212,
            height: 1.28,
        }),
        pockets: Some(Pockets {
            circles: vec![[-0.4, 0.0, 0.07], [0.4, 0.0, 0.07]],
        }),
    };
    scene.table = Some(Table {
        min: [-0.4, -0.5],
        max: [0.4, 0.5],
    });
    scene
}

#[test]
fn energy_never_grows_with_every_law_under_both_contact_rules() {
    let scene = busy();
    let mut pocketed = 0;
    for rule in ["contact=as-written", APPROACHING] {
        for dt in [4e-3, 1e-3] {
            let trace = run(
                "stepper",
                &[&format!("dt={dt}"), rule],
                &scene,
                Record::Every(dt),
            );
            let collisions = trace.collisions().count();
            assert!(
                collisions >= 8,
                "{rule}, dt {dt}: only {collisions} collisions"
            );
            let steps = (trace.end_time / dt).round() as u64;
            // one rounding of each ball in a step
            let slack = 16.0 * f64::EPSILON * scene.initial_energy();
            let mut last = scene.initial_energy();
            for step in 0..=steps {
                let time = step as f64 * dt;
                let in_play = |i: &usize| trace.paths[*i].knots.last().unwrap().time >= time;
                let energy: f64 = (0..scene.balls.len())
                    .filter(in_play)
                    .map(|i| {
                        let state = trace.paths[i].state_at(time).unwrap();
                        let mass = scene.balls[i].mass;
                        carom::physics::invariants::kinetic_energy(&state, mass, scene.inertia(i))
                    })
                    .sum();
                assert!(
                    energy <= last + slack,
                    "{rule}, dt {dt}: grows by {:e} at {time}",
                    energy - last
                );
                last = energy;
            }
            assert!(trace.extrema.energy_gained.value <= slack * collisions as f64);
            assert_eq!(trace.ending, Ending::Rest);
            pocketed += (0..scene.balls.len())
                .filter(|&i| trace.pocketed(i))
                .count();
        }
    }
    assert!(pocketed > 0, "no ball met a pocket");
}

#[test]
fn mirrored_shots_with_spin_are_mirror_images_and_reruns_are_the_same_bits() {
    let scene = busy();
    let mut mirrored = scene.clone();
    for ball in &mut mirrored.balls {
        let State {
            position,
            velocity,
            spin,
        } = &mut ball.state;
        position.x = -position.x;
        velocity.x = -velocity.x;
        // an axial vector keeps its part across the mirror
        (spin.y, spin.z) = (-spin.y, -spin.z);
    }
    let circles = mirrored.effects.pockets.as_mut().unwrap();
    for circle in &mut circles.circles {
        circle[0] = -circle[0];
    }
    let (one, other) = (
        simulate(&scene, 1e-3, Record::Events),
        simulate(&mirrored, 1e-3, Record::Events),
    );
    assert_eq!(one, simulate(&scene, 1e-3, Record::Events));
    assert_eq!(one.events.len(), other.events.len());
    assert!(one.events.len() > 20, "{} events", one.events.len());
    for (a, b) in one.paths.iter().zip(&other.paths) {
        let (a, b) = (a.last().unwrap(), b.last().unwrap());
        let mirror = Vec3::new(-b.position.x, b.position.y, b.position.z);
        // every operation of the scheme and of the laws is the same but for signs
        assert_eq!(a.position, mirror);
    }
}

#[test]
fn a_pocketed_ball_leaves_play_and_the_next_one_follows_it_in() {
    let (v, dt) = (0.5, 1e-3);
    let balls = [
        ([0.0, 0.0], [0.0, v], rolling([0.0, v])),
        ([0.0, -0.07], [0.0, v], rolling([0.0, v])),
        ([0.0, 1.0], [0.0, 0.0], [0.0; 3]),
    ];
    let mut scene = pool("pocket", MU, &balls);
    scene.effects.pockets = Some(Pockets {
        circles: vec![[5.0, 5.0, 0.1], [0.02, 0.4, 0.06]],
    });
    let trace = simulate(&scene, dt, Record::Every(0.01));
    let kinds: Vec<EventKind> = trace.events.iter().map(|e| e.kind).collect();
    assert_eq!(kinds, [EventKind::Pocket(0, 1), EventKind::Pocket(1, 1)]);
    let a = MU.mu_roll * G;
    let rim = 0.4 - (0.06_f64.powi(2) - 0.02 * 0.02).sqrt();
    for (ball, way) in [(0, rim), (1, rim + 0.07)] {
        let entry = (v - (v * v - 2.0 * a * way).sqrt()) / a;
        let event = trace.events[ball];
        // found at the first step end inside; the roll is a t dt/2 behind, less than a step's way
        let behind = 0.5 * a * entry * dt / (v - a * entry);
        assert!(
            event.time >= entry && event.time <= entry + behind + dt,
            "ball {ball} at {}, exact {entry}",
            event.time
        );
        let last = trace.paths[ball].knots.last().unwrap();
        assert_eq!((last.time, last.after), (event.time, Some(ball as u32)));
        assert_eq!(
            (trace.final_states()[ball], trace.stop_times[ball]),
            (None, None)
        );
    }
    assert_eq!(
        (trace.stop_times[2], &trace.ending),
        (Some(0.0), &Ending::Rest)
    );
    assert_eq!(trace.end_time, trace.events[1].time);

    let mut pared = trace;
    pared.pare();
    let short = simulate(&scene, dt, Record::Final);
    assert_eq!(short.paths, pared.paths);
    assert_eq!(short.stop_times, pared.stop_times);
}

#[test]
fn with_rotation_too_unexplained_is_at_most_a_h_dt_over_2() {
    for scene in [busy(), one_ball([0.3, 1.5], [40.0, 10.0, 30.0])] {
        let (dt, cadence) = (1e-3, 0.02);
        let trace = simulate(&scene, dt, Record::Every(cadence));
        // a piece is at most one cadence long, and one step longer where a sample falls between two steps
        let bound = MU.mu_slide * G * (cadence + dt) * dt / 2.0;
        let found = trace.unexplained();
        assert!(
            found > 0.1 * bound && found <= bound * (1.0 + 1e-9),
            "{}: {found:e}, bound {bound:e}",
            scene.name
        );
    }
}

#[test]
fn every_law_arrives_inside_and_stands_on_the_sheet() {
    let scene = busy();
    let stepper = find("stepper").unwrap();
    assert_eq!(stepper.missing(&scene), Vec::<&str>::new());
    let prepared = prepare(stepper, &scene, &Setting::default()).unwrap();
    for inertia in prepared.inside().inertia {
        within(
            "moment of inertia",
            inertia.unwrap(),
            0.4 * M * R * R,
            1e-20,
        );
    }
    let sheet = prepared.sheet();
    for (name, value) in [
        ("mu_slide", "0.2"),
        ("mu_roll", "0.03"),
        ("mu_spin", "0.0117"),
        ("impulse with loss", "e = 0.93"),
        ("Mathavan 2010", "e = 0.98 of work, nose at 1.28 R"),
        ("rotation", "free"),
        ("pockets", "2 circles, tested at the end of a step"),
    ] {
        let row = sheet.iter().find(|row| row.name == name);
        assert_eq!(row.map(|row| row.value.as_str()), Some(value), "{name}");
    }
}
