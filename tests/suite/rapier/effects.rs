//! Balls that turn on a cloth, and pockets: rapier against closed forms, and where it does not reach them.
//!
//! Two errors are derived and held. The step: friction acts in substeps, resistance and events in steps, so times are good to `dt`
//! and lengths to `v dt`. The sink: rapier's cloth is a spring of `f` hertz, a ball lies `g / (2 pi f)^2` deep in it at any step, and
//! friction acts halfway up that depth. Its lever is shorter than `R` by the share `eps = depth / 2R`, which no step removes.

use super::{BOTH, final_velocity};
use crate::support::{G, Scenario, run, scenario};
use carom::engine::{self, Role, Setting};
use carom::math::Vec3;
use carom::physics::cloth::rotational::{natural_roll, roll_distance, roll_time, slide_time};
use carom::physics::cloth::rotational::{slip_velocity, spin_time};
use carom::physics::{Cloth, Contact, Cushion, Friction, Pockets};
use carom::scene::{Scene, Table};
use carom::trace::{Ending, EventKind, Record, Trace};

/// A pool ball, m and kg, and a pool cloth.
pub const POOL_R: f64 = 0.028575;
const POOL_M: f64 = 0.170097;
const MU_SLIDE: f64 = 0.2;
const MU_SPIN: f64 = 0.01;

/// Makes the cloth a hundred times stiffer than rapier does, and the sink so much smaller.
const STIFF: &str = "static_contact_natural_frequency=600";

/// The scene with pool balls.
pub fn pool(scenario: Scenario) -> Scene {
    let mut scene = scenario.build();
    for ball in &mut scene.balls {
        ball.radius = POOL_R;
        ball.mass = POOL_M;
        ball.state.position.z = POOL_R;
    }
    scene
}

/// A cloth on which balls turn.
pub fn with_cloth(mut scene: Scene, mu_roll: f64) -> Scene {
    scene.effects.cloth = Some(Cloth::Rotational {
        mu_slide: MU_SLIDE,
        mu_roll,
        mu_spin: MU_SPIN,
    });
    scene
}

/// One pool ball at the origin.
fn one(velocity: [f64; 2], spin: [f64; 3], mu_roll: f64, duration: f64) -> Scene {
    let ball = scenario("one").moving("cue", [0.0, 0.0], velocity);
    let mut scene = with_cloth(pool(ball.duration(duration)), mu_roll);
    scene.balls[0].state.spin = Vec3::from(spin);
    scene
}

/// The share by which the lever of friction is shorter than the radius at the deepest knot of the first ball.
fn eps(trace: &Trace) -> f64 {
    let depths = trace.paths[0].knots.iter();
    let deepest = depths.fold(0.0_f64, |d, k| d.max(POOL_R - k.state.position.z));
    0.5 * deepest / POOL_R
}

/// Time of the only event of a kind.
fn time_of(trace: &Trace, kind: EventKind) -> f64 {
    let times: Vec<f64> = trace
        .events
        .iter()
        .filter(|event| event.kind == kind)
        .map(|event| event.time)
        .collect();
    assert_eq!(times.len(), 1, "{kind:?}: {:?}", trace.events);
    times[0]
}

#[test]
fn a_sliding_ball_rolls_at_five_sevenths_of_its_speed() {
    for (engine, rounding) in [("rapier-f64", 1e-9), ("rapier-f32", 1e-3)] {
        for (speed, dt, settings) in [
            (2.0, 1e-3, &[][..]),
            (2.0, 1e-3, &[STIFF]),
            (0.5, 1e-3, &[STIFF]),
            (8.0, 5e-4, &[STIFF]),
            (8.0, 1e-3, &["friction_model=coulomb"]),
        ] {
            let dt_setting = format!("dt={dt}");
            let mut all = vec![dt_setting.as_str()];
            all.extend(settings);
            let scene = one([speed, 0.0], [0.0; 3], 0.01, 3.0);
            let trace = run(engine, &all, &scene, Record::Every(0.01));
            let (case, eps) = (format!("{engine}, v {speed}, {all:?}"), eps(&trace));
            let time = time_of(&trace, EventKind::SlideToRoll(0));
            let law = slide_time(speed, MU_SLIDE, G);
            // the slip falls at mu g (1 + 5/2 (1 - eps)^2); its end is seen at the end of a step, and a step later where the last
            // substep of the step did not press the ball onto the cloth
            let late = law * (10.0 / 7.0 * eps + rounding) + 2.0 * dt;
            assert!(
                time >= law * (1.0 - rounding) && time <= law + late,
                "{case}: rolls at {time}, law {law} to {}",
                law + late
            );
            let got = trace.paths[0].state_at(time).unwrap();
            let v = got.velocity.x / speed;
            // angular momentum about the raised point of contact: the speed that is left is smaller by 4/7 eps
            assert!(
                (v - 5.0 / 7.0).abs() <= 4.0 / 7.0 * eps + rounding,
                "{case}: rolls at {v} of its speed, eps {eps}"
            );
            let rolling = got.spin.y * POOL_R / got.velocity.x;
            assert!(
                (rolling - 1.0).abs() <= 2.0 * eps + rounding,
                "{case}: {got:?}"
            );
        }
    }
}

#[test]
fn draw_and_follow_leave_what_coriolis_says() {
    for (engine, rounding) in [("rapier-f64", 1e-9), ("rapier-f32", 1e-3)] {
        for k in [-2.0, -1.0, 0.0, 1.0, 2.0, 2.5, 4.0] {
            let speed = 2.0;
            let scene = one([speed, 0.0], [0.0, -k * speed / POOL_R, 0.0], 0.01, 2.0);
            let trace = run(engine, &[STIFF], &scene, Record::Events);
            let v = if k == -1.0 {
                // it rolls from the start
                trace.paths[0].state_at(0.01).unwrap().velocity.x
            } else {
                let time = time_of(&trace, EventKind::SlideToRoll(0));
                trace.paths[0].state_at(time).unwrap().velocity.x
            };
            let law = speed * (5.0 - 2.0 * k) / 7.0;
            // what a lever of (1 - eps) R changes, and rolling resistance for the time until it is looked at
            let bound = speed * (0.7 * (1.0 + k.abs()) * eps(&trace) + rounding) + 0.01 * G * 0.011;
            assert!(
                (v - law).abs() <= bound,
                "{engine}, draw {k}: rolls at {v}, law {law}, bound {bound}"
            );
        }
    }
}

#[test]
fn a_ball_with_spin_across_its_way_curves_to_the_side_that_the_law_says() {
    for (engine, rounding) in [("rapier-f64", 1e-9), ("rapier-f32", 1e-3)] {
        for spin in [[90.0, 0.0, 0.0], [-60.0, 40.0, 25.0], [30.0, -120.0, -80.0]] {
            let scene = one([2.0, 0.5], spin, 0.01, 2.0);
            let trace = run(engine, &[STIFF], &scene, Record::Events);
            let start = &scene.balls[0].state;
            let slip = slip_velocity(&start.velocity, &start.spin, POOL_R);
            let law = natural_roll(&start.velocity, &slip);
            let time = time_of(&trace, EventKind::SlideToRoll(0));
            let got = trace.paths[0].state_at(time).unwrap().velocity;
            let bound = 1.4 * eps(&trace) * (start.velocity.norm() + slip.norm());
            let bound = bound + rounding * slip.norm() + 0.01 * G * 1e-3;
            assert!(
                (got - law).xy().norm() <= bound,
                "{engine}, spin {spin:?}: {got:?}, law {law:?}, bound {bound}"
            );
        }
    }
}

#[test]
fn a_rolling_ball_stops_after_v_squared_over_two_mu_g_and_does_not_come_back() {
    for (engine, rounding) in [("rapier-f64", 1e-9), ("rapier-f32", 2e-3)] {
        // f32: half an ulp of the velocity in each substep, all to one side, is up to 1e-3 of what resistance takes in it
        for (speed, mu, dt) in [(1.0, 0.05, 1e-3), (0.3, 0.01, 1e-3), (3.0, 0.1, 5e-4)] {
            let scene = one([speed, 0.0], [0.0, speed / POOL_R, 0.0], mu, 20.0);
            let settings = [format!("dt={dt}")];
            let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
            let trace = run(engine, &settings, &scene, Record::Every(0.01));
            let (case, eps) = (format!("{engine}, v {speed}, mu {mu}"), eps(&trace));
            assert_eq!(trace.ending, Ending::Rest, "{case}");
            let kinds: Vec<EventKind> = trace.events.iter().map(|e| e.kind).collect();
            assert_eq!(kinds, [EventKind::Stop(0)], "{case}");
            let (time, law) = (trace.stop_times[0].unwrap(), roll_time(speed, mu, G));
            // sinking takes 2/7 eps of the speed; a stop is seen at the end of a step, once it is slower than the rest speed; while
            // the ball falls to where it touches, about v / sqrt(g R) steps, it may slip and have no resistance
            let falling = dt * (1.0 + speed / (G * POOL_R).sqrt());
            let early = law * (2.0 / 7.0 * eps + rounding) + dt;
            assert!(
                time >= law - early && time <= law * (1.0 + rounding) + falling,
                "{case}: stops at {time}, law {law}"
            );
            let end = trace.final_states()[0].unwrap();
            let distance = roll_distance(speed, mu, G);
            let short = distance * (4.0 / 7.0 * eps + 2.0 * rounding) + speed * falling;
            assert!(
                (end.position.x - distance).abs() <= short,
                "{case}: at {}, law {distance}, bound {short}",
                end.position.x
            );
            let knots = &trace.paths[0].knots;
            assert!(knots.len() > 20, "{case}");
            let back = knots
                .iter()
                .any(|k| k.state.velocity.x < -trace.provenance.rest_speed);
            assert!(!back, "{case}: it comes back");
        }
    }
}

#[test]
fn spin_about_the_vertical_is_gone_after_its_time_and_moves_nothing() {
    for (engine, rounding) in [("rapier-f64", 1e-9), ("rapier-f32", 1e-3)] {
        // f32: half an ulp of the spin in each substep, all to one side, is up to 9e-4 of what friction takes in it
        for (spin, dt) in [(40.0, 1e-3), (-7.0, 1e-3), (150.0, 5e-3)] {
            let scene = one([0.0, 0.0], [0.0, 0.0, spin], 0.01, 30.0);
            let trace = run(engine, &[&format!("dt={dt}")], &scene, Record::Events);
            let case = format!("{engine}, spin {spin}, dt {dt}");
            let kinds: Vec<EventKind> = trace.events.iter().map(|e| e.kind).collect();
            assert_eq!(kinds, [EventKind::SpinEnd(0)], "{case}");
            let law = spin_time(spin, POOL_R, MU_SPIN, G);
            let time = trace.events[0].time;
            assert!(
                time >= law * (1.0 - rounding) - dt && time <= law * (1.0 + rounding) + dt,
                "{case}: {time}, law {law}"
            );
            assert_eq!(
                (trace.ending.id(), trace.end_time),
                ("rest", time),
                "{case}"
            );
            assert_eq!(trace.stop_times, [Some(0.0)], "{case}");
            let end = trace.final_states()[0].unwrap();
            assert_eq!(
                end.position.xy(),
                scene.balls[0].state.position.xy(),
                "{case}"
            );
            assert!(end.spin.z.abs() * POOL_R <= 1e-5, "{case}: {end:?}");
        }
    }
}

#[test]
fn the_place_where_a_ball_comes_to_rest_converges_at_first_order_on_a_stiff_cloth() {
    // 8 speeds, so that the ends of slides and rolls fall everywhere within a step
    let error = |dt: f64| {
        let mut sum = 0.0;
        for phase in 0..8 {
            let speed = 2.0 + 0.013 * f64::from(phase);
            let scene = one([speed, 0.0], [0.0; 3], 0.1, 5.0);
            let settings = [
                format!("dt={dt}"),
                "static_contact_natural_frequency=6000".into(),
            ];
            let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
            let trace = run("rapier-f64", &settings, &scene, Record::Final);
            let law = 12.0 * speed * speed / (49.0 * MU_SLIDE * G)
                + roll_distance(5.0 / 7.0 * speed, 0.1, G);
            sum += (trace.final_states()[0].unwrap().position.x - law).abs();
        }
        sum / 8.0
    };
    let (coarse, fine) = (error(4e-3), error(2.5e-4));
    let order = (coarse / fine).log2() / 4.0;
    assert!(
        (order - 1.0).abs() <= 0.3,
        "order {order}: {coarse} at 4e-3, {fine} at 2.5e-4"
    );
    assert!(fine <= 2.0 * 2.5e-4, "{fine}: more than v dt");
}

#[test]
fn rapiers_own_cloth_is_so_soft_that_no_step_reaches_the_place_where_a_ball_comes_to_rest() {
    let law = 12.0 * 4.0 / (49.0 * MU_SLIDE * G) + roll_distance(10.0 / 7.0, 0.05, G);
    let short = |dt: f64, settings: &[&str]| {
        let dt = format!("dt={dt}");
        let mut all = vec![dt.as_str()];
        all.extend(settings);
        let scene = one([2.0, 0.0], [0.0; 3], 0.05, 10.0);
        let trace = run("rapier-f64", &all, &scene, Record::Final);
        let end = trace.final_states()[0].unwrap();
        (law - end.position.x, POOL_R - end.position.z)
    };
    for dt in [1e-3, 2.5e-4] {
        let (missing, depth) = short(dt, &[]);
        let sink = G / (2.0 * std::f64::consts::PI * 60.0).powi(2);
        assert!(
            (depth - sink).abs() <= 1e-3 * sink,
            "{depth} deep, spring {sink}"
        );
        // 8/7 eps of the way that it rolls would be 1.4e-3 of it; a ball takes a while to sink
        let share = missing / law;
        assert!((2e-4..2e-3).contains(&share), "dt {dt}: short by {share}");
    }
    let (soft, stiff) = (short(2.5e-4, &[]).0, short(2.5e-4, &[STIFF]).0);
    assert!(stiff.abs() < 0.3 * soft.abs(), "{stiff} and {soft}");
}

#[test]
fn stock_rapier_caps_the_rotation_and_a_fast_ball_never_rolls_as_it_should() {
    let scene = one([5.0, 0.0], [0.0; 3], 0.01, 3.0);
    for (engine, _) in BOTH {
        let stock = run(engine, &["preset=stock"], &scene, Record::Every(0.05));
        let fastest = stock.paths[0].knots.iter();
        let fastest = fastest.fold(0.0_f64, |w, k| w.max(k.state.spin.norm()));
        let cap = std::f64::consts::FRAC_PI_4 * 60.0;
        assert!(
            fastest <= cap && fastest > 0.97 * cap,
            "{engine}: turns at {fastest}, cap {cap}"
        );
        let v = stock.paths[0].state_at(1.5).unwrap().velocity.x;
        let law = 5.0 * 5.0 / 7.0;
        assert!(v < 0.75 * law, "{engine}: {v}, law {law}");
        let sheet = engine::prepare(
            crate::support::find(engine).unwrap().as_ref(),
            &scene,
            &Setting::parse(["preset=stock"]).unwrap(),
        );
        let sheet = sheet.unwrap().sheet();
        let cap = sheet.iter().find(|row| row.name == "cap of the rotation");
        assert_eq!(cap.unwrap().value, "pi/4 a step", "{engine}");
    }
}

#[test]
fn a_ball_leaves_play_with_the_step_in_which_its_centre_enters_a_pocket() {
    for (engine, _) in BOTH {
        for (speed, settings) in [(1.0, &[][..]), (9.0, &[]), (40.0, &["preset=stock"])] {
            let balls = scenario("pocket").moving("cue", [0.0, 0.02], [speed, 0.0]);
            let balls = balls
                .resting("1", [2.0, 0.0])
                .moving("2", [0.5, 3.0], [0.0, -1.5]);
            let mut scene = pool(balls.duration(4.0));
            scene.effects.pockets = Some(Pockets {
                circles: vec![[5.0, 5.0, 0.1], [0.5, 0.0, 0.06]],
            });
            let trace = run(engine, settings, &scene, Record::Every(0.1));
            let case = format!("{engine}, v {speed}, {settings:?}");
            let time = time_of(&trace, EventKind::Pocket(0, 1));
            let law = (0.5 - (0.06_f64.powi(2) - 0.02_f64.powi(2)).sqrt()) / speed;
            let dt = trace.provenance.resolution;
            // f32 rounds the way to it
            assert!(
                time >= law - 1e-6 && time <= law + dt + 1e-6,
                "{case}: in at {time}, law {law}"
            );
            assert!(trace.pocketed(0) && !trace.pocketed(1), "{case}");
            assert_eq!(trace.paths[0].knots.last().unwrap().time, time, "{case}");
            assert_eq!(trace.final_states()[0], None, "{case}");
            assert_eq!(trace.stop_times[0], None, "{case}");
            // gone: it meets neither the ball behind the pocket nor the one that comes to the pocket later
            assert_eq!(trace.collisions().count(), 0, "{case}: {:?}", trace.events);
            assert!(trace.pocketed(2), "{case}: {:?}", trace.events);
            for record in [Record::Final, Record::Events] {
                let other = run(engine, settings, &scene, record);
                assert_eq!(other.final_states(), trace.final_states(), "{case}");
                assert_eq!(other.stop_times, trace.stop_times, "{case}");
                assert_eq!(other.extrema, trace.extrema, "{case}");
            }
        }
    }
}

/// A break of six balls with every law that rapier has: it turns, rubs, loses energy, meets cushions and falls into pockets.
pub fn everything() -> Scene {
    let mut balls = scenario("everything").moving("cue", [0.6, 0.5], [0.02, 6.0]);
    for (k, (x, y)) in [
        (0.0, 0.0),
        (-1.0, 1.0),
        (1.0, 1.0),
        (-2.0, 2.0),
        (0.0, 2.0),
        (2.0, 2.0),
    ]
    .into_iter()
    .enumerate()
    {
        let pitch = POOL_R + 1e-4;
        let place = [0.635 + x * pitch, 1.5 + y * pitch * 3.0_f64.sqrt()];
        balls = balls.resting(&(k + 1).to_string(), place);
    }
    let mut scene = with_cloth(pool(balls.duration(4.0)), 0.01);
    scene.balls[0].state.spin = Vec3::new(-150.0, 10.0, 60.0);
    scene.table = Some(Table {
        min: [0.0, 0.0],
        max: [1.27, 2.54],
    });
    scene.effects.contact = Some(Contact::Inelastic { e: 0.95 });
    scene.effects.friction = Some(Friction::Constant { mu: 0.06 });
    scene.effects.cushion = Some(Cushion::Restitution { e: 0.8 });
    let corners = [[0.0, 0.0], [1.27, 0.0], [0.0, 2.54], [1.27, 2.54]];
    let circles = corners.into_iter().map(|[x, y]| [x, y, 0.09]).collect();
    scene.effects.pockets = Some(Pockets { circles });
    scene
}

#[test]
fn every_effect_together_explains_itself_and_runs_again_to_the_same_bits() {
    let mut alciatore = everything();
    alciatore.effects.friction = Some(Friction::Alciatore {
        a: 9.951e-3,
        b: 0.108,
        c: 1.088,
        length_in_metres: 1.0,
    });
    for (engine, tolerance) in BOTH {
        for scene in [&everything(), &alciatore] {
            for dt in [1e-3, 2.5e-4] {
                let settings = [format!("dt={dt}")];
                let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
                let trace = run(engine, &settings, scene, Record::Events);
                let case = format!("{engine}, {:?}, dt {dt}", scene.effects.friction);
                for kind in ["ball-ball", "ball-cushion", "slide-to-roll", "spin-end"] {
                    let seen = trace.events.iter().any(|event| event.kind.id() == kind);
                    assert!(seen, "{case}: no {kind}");
                }
                // derived in the engine's journal.rs: v dt in the step of an impact, g dt a time by vertical chatter
                let pieces = trace.paths.iter().flat_map(|path| path.knots.windows(2));
                let longest = pieces.fold(0.0_f64, |t, pair| t.max(pair[1].time - pair[0].time));
                let bound = scene.largest_speed() * dt * (1.0 + 0.5 / 4.0) + G * dt * longest;
                let rounding = if tolerance < 1e-9 { 0.0 } else { 2e-3 };
                let got = trace.unexplained();
                assert!(
                    got <= bound + rounding,
                    "{case}: unexplained {got}, bound {bound}"
                );
                assert_eq!(trace.counters["unattributed"], 0, "{case}");
                let p0 = POOL_M * 6.0;
                let lost = trace.extrema.momentum.value / p0;
                assert!(lost <= tolerance, "{case}: momentum off by {lost}");
                let again = run(engine, &settings, scene, Record::Events);
                assert_eq!(again, trace, "{case}");
                let last = run(engine, &settings, scene, Record::Final);
                assert_eq!(last.final_states(), trace.final_states(), "{case}");
                assert_eq!(last.stop_times, trace.stop_times, "{case}");
            }
        }
    }
}

#[test]
fn every_law_but_the_cushions_of_a_paper_is_simulated() {
    let paper = [
        Cushion::Han2005 {
            e: 0.85,
            mu: 0.2,
            height: 1.28,
        },
        Cushion::Mathavan2010 {
            e: 0.98,
            mu: 0.14,
            mu_cloth: 0.212,
            height: 1.4,
        },
    ];
    for (id, _) in BOTH {
        let rapier = crate::support::find(id).unwrap();
        assert_eq!(rapier.missing(&everything()), [""; 0], "{id}");
        for law in paper {
            let mut scene = everything();
            scene.effects.cushion = Some(law);
            assert_eq!(rapier.missing(&scene), [law.id()], "{id}");
        }
    }
}

#[test]
fn the_sheet_says_what_is_added_to_rapier() {
    for (id, _) in BOTH {
        let scene = everything();
        let run = engine::prepare(
            crate::support::find(id).unwrap().as_ref(),
            &scene,
            &Setting::default(),
        )
        .unwrap();
        let sheet = run.sheet();
        for role in Role::ALL {
            assert!(
                sheet.iter().any(|row| row.role == role),
                "{id}: no {}",
                role.title()
            );
        }
        let value = |name: &str| {
            let mut rows = sheet.iter().filter(|row| row.name.contains(name));
            let row = rows.next();
            row.unwrap_or_else(|| panic!("{id}: no row {name}"))
                .value
                .clone()
        };
        let number = |name: &str| value(name).parse::<f64>().unwrap();
        assert_eq!(value("locked_axes"), "none");
        assert_eq!(value("explicit force and torque on a rolling ball"), "0.01");
        assert_eq!(value("explicit torque about the vertical"), "0.01");
        for (name, want) in [
            ("friction of the half-space, rule Max", MU_SLIDE),
            ("friction of two balls, rule Average", 0.06),
            ("friction of a cushion, rule Min", 0.0),
            ("restitution of the half-space, rule Min", 0.0),
            ("restitution of two balls, rule Min", 0.95),
            ("restitution of a cushion, rule Min", 0.8),
        ] {
            // f32 rounds by 6e-8
            assert!(
                (number(name) - want).abs() <= 1e-7,
                "{id}: {name} is {}",
                value(name)
            );
        }
        assert!(number("rolls at or below a slip") > 0.0, "{id}");
        let velocity = final_velocity(&run.simulate(Record::Events, &engine::Limits::NONE), 1);
        assert!(velocity.norm() < 1.0, "{id}: {velocity:?}");
    }
}
