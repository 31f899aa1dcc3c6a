//! The shots of the catalogue that call for rotation: what their descriptions say is what the closed forms say, and what `exact` does.

use crate::support::run;
use carom::compare::deepest_overlap;
use carom::engine::Limits;
use carom::math::Vec3;
use carom::oracle::Precision;
use carom::oracle::{Limit, horizon};
use carom::physics::cloth::rotational::{
    Coefficients, after_slide, natural_roll, roll_distance, roll_time, rolling_spin, slid,
    slide_time, slip_velocity, spin_time, spun_down,
};
use carom::physics::{Body, Cloth, Contact, Motion, Side, State, cushion};
use carom::scene::{Scene, catalogue};
use carom::trace::{Ending, Record, Trace, UNEXPLAINED_IN_CONTACT};

/// What an f64 program attains of these closed forms, relative to the quantity: see the README of the references.
const CLOSE: f64 = 1e-12;

/// Every scene of this file in the order of the catalogue; the last one has no end.
const SHOTS: [&str; 18] = [
    "draw",
    "stun",
    "follow",
    "side",
    "curve",
    "throw",
    "bank",
    "bank-side",
    "ladder-report",
    "ladder-rotation",
    "ladder-rolling",
    "ladder-losses",
    "ladder-throw",
    "ladder-cushions",
    "ladder-pockets",
    "pool-break",
    "report-break-real",
    "report-break-pressed",
];

fn scene(name: &str) -> Scene {
    catalogue::scene(name).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn exact(scene: &Scene) -> Trace {
    run("exact", &[], scene, Record::Events)
}

fn cloth(scene: &Scene) -> Coefficients {
    match scene.effects.cloth {
        Some(Cloth::Rotational {
            mu_slide,
            mu_roll,
            mu_spin,
        }) => Coefficients {
            mu_slide,
            mu_roll,
            mu_spin,
        },
        other => panic!("{} has the cloth {other:?}", scene.name),
    }
}

/// The number as the description must have it.
fn says(scene: &Scene, number: &str) {
    assert!(
        scene.description.contains(number),
        "{} does not say {number}: {}",
        scene.name,
        scene.description
    );
}

fn close(scene: &Scene, what: &str, got: f64, expected: f64, scale: f64) {
    let error = (got - expected).abs();
    assert!(
        error <= CLOSE * scale,
        "{}: {what} is {got}, not {expected}, off by {error:e}",
        scene.name
    );
}

/// Where a ball that nothing meets stops, by the closed forms of slide and roll, and when.
fn stops(scene: &Scene, start: &State) -> (Vec3, f64) {
    let (mu, g, radius) = (cloth(scene), scene.gravity, scene.balls[0].radius);
    let slip = slip_velocity(&start.velocity, &start.spin, radius).norm();
    let (mut at, mut time) = (*start, 0.0);
    if slip > 0.0 {
        time = slide_time(slip, mu.mu_slide, g);
        at.position = slid(start, radius, mu, g, time).position;
        let motion = Motion {
            velocity: start.velocity,
            spin: start.spin,
        };
        let rolls = after_slide(&motion, radius, mu, g);
        (at.velocity, at.spin) = (rolls.velocity, rolls.spin);
    }
    let speed = at.velocity.norm();
    let way = roll_distance(speed, mu.mu_roll, g);
    (
        at.position + at.velocity * (way / speed),
        time + roll_time(speed, mu.mu_roll, g),
    )
}

/// State of the first ball of a scene after it went `way` along its own direction, sliding and then rolling.
fn after_way(scene: &Scene, way: f64) -> (State, f64) {
    let (mu, g, radius) = (cloth(scene), scene.gravity, scene.balls[0].radius);
    let start = scene.balls[0].state;
    let direction = start.velocity.normalize();
    let slip = slip_velocity(&start.velocity, &start.spin, radius);
    // along the direction: negative for a ball with more spin than it rolls with
    let slipping = slip.dot(&direction);
    assert!(
        (slip - direction * slipping).norm() < 1e-12,
        "{} does not go straight",
        scene.name
    );
    let ends = slide_time(slip.norm(), mu.mu_slide, g);
    let rolls = slid(&start, radius, mu, g, ends);
    let slid_way = (rolls.position - start.position).norm();
    if way < slid_way {
        // v^2 = v0^2 - 2 a s
        let a = mu.mu_slide * g * slipping.signum();
        let v = start.velocity.norm();
        let time = (v - (v * v - 2.0 * a * way).sqrt()) / a;
        return (slid(&start, radius, mu, g, time), time);
    }
    let v = natural_roll(&start.velocity, &slip).norm();
    let left = (v * v - 2.0 * mu.mu_roll * g * (way - slid_way)).sqrt();
    let time = ends + (v - left) / (mu.mu_roll * g);
    let velocity = direction * left;
    let mut spin = rolling_spin(&velocity, radius);
    spin.z = spun_down(start.spin.z, radius, mu.mu_spin, g, time);
    let position = start.position + direction * way;
    (
        State {
            position,
            velocity,
            spin,
        },
        time,
    )
}

#[test]
fn draw_stun_and_follow_end_where_slide_roll_and_restitution_take_them() {
    // how far the cue ball goes after the impact, and the struck ball; as the description has them
    let cases = [
        ("draw", "comes back by 0.75829 m", -0.75829, 5e-6),
        ("stun", "goes on by 4.653 mm", 4.653e-3, 5e-7),
        ("follow", "goes on by 1.01848 m", 1.01848, 5e-6),
    ];
    for (name, words, said, half_a_digit) in cases {
        let scene = scene(name);
        let radius = scene.balls[0].radius;
        let met = scene.balls[1].state.position.y - 2.0 * radius;
        let (mut cue, time) = after_way(&scene, met);
        let Some(Contact::Inelastic { e }) = scene.effects.contact else {
            panic!("{name}: {:?}", scene.effects.contact);
        };
        let speed = cue.velocity.norm();
        let mut struck = scene.balls[1].state;
        cue.velocity *= (1.0 - e) / 2.0;
        struck.velocity = Vec3::new(0.0, (1.0 + e) / 2.0 * speed, 0.0);
        let (cue_end, cue_time) = stops(&scene, &cue);
        let (struck_end, struck_time) = stops(&scene, &struck);
        let trace = exact(&scene);
        for (ball, end, after) in [(0, cue_end, cue_time), (1, struck_end, struck_time)] {
            let got = trace.paths[ball].last().unwrap().position;
            close(&scene, "where it ends", got.y, end.y, struck_end.y);
            assert!(got.x.abs() < CLOSE, "{name}: {got}");
            let stop = trace.stop_times[ball].unwrap();
            close(
                &scene,
                "when it ends",
                stop,
                time + after,
                time + struck_time,
            );
        }
        let way = cue_end.y - met;
        assert!((way - said).abs() < half_a_digit, "{name}: {way}");
        says(&scene, words);
        if name == "stun" {
            let slip = slip_velocity(&cue.velocity, &cue.spin, radius) - cue.velocity;
            assert!(
                slip.norm() < 1e-12,
                "the ball turns by {slip} when it meets"
            );
            assert!((struck_end.y - 0.5 - 7.0771).abs() < 5e-5, "{struck_end}");
            says(&scene, "7.0771 m");
        }
    }
}

#[test]
fn side_deflects_and_spins_down_and_a_raised_cue_bends_the_path() {
    // TP A.31 with a = 0.4 and an end mass of a thirtieth of the ball, which the file rounds to 8 digits
    let deflection = (2.5 * 0.4 * 0.84_f64.sqrt() / (1.0 + 30.0 + 2.5 * 0.84)).atan();
    assert_eq!(format!("{:.4}", deflection.to_degrees()), "1.5861");
    for name in ["side", "curve"] {
        let scene = scene(name);
        let v = scene.balls[0].state.velocity;
        assert!((v.x.atan2(v.y) - deflection).abs() < 1e-8, "{name}: {v}");
        says(&scene, "1.5861 degrees to the right");
    }
    let side = scene("side");
    let (mu, g, start) = (cloth(&side), side.gravity, side.balls[0].state);
    let spun = spin_time(start.spin.z, side.balls[0].radius, mu.mu_spin, g);
    let (end, time) = stops(&side, &start);
    let trace = exact(&side);
    let got = trace.paths[0].last().unwrap();
    close(&side, "x", got.position.x, end.x, end.y);
    close(&side, "y", got.position.y, end.y, end.y);
    close(&side, "the stop", trace.stop_times[0].unwrap(), time, time);
    let ends = trace.events.iter().find(|e| e.kind.id() == "spin-end");
    close(&side, "the end of spin", ends.unwrap().time, spun, spun);
    says(&side, &format!("{spun:.4} s"));
    says(&side, &format!("{time:.4} s"));
    // no bend: the path has one direction
    assert!((got.position.x.atan2(got.position.y) - deflection).abs() < 1e-8);

    let curve = scene("curve");
    let start = curve.balls[0].state;
    let slip = slip_velocity(&start.velocity, &start.spin, curve.balls[0].radius);
    let slides = slide_time(slip.norm(), mu.mu_slide, g);
    let rolls = natural_roll(&start.velocity, &slip);
    let trace = exact(&curve);
    let event = trace.events.iter().find(|e| e.kind.id() == "slide-to-roll");
    close(&curve, "the slide", event.unwrap().time, slides, slides);
    let (end, _) = stops(&curve, &start);
    let got = trace.paths[0].last().unwrap().position;
    close(&curve, "x", got.x, end.x, end.y);
    close(&curve, "y", got.y, end.y, end.y);
    says(&curve, &format!("slides for {slides:.5} s"));
    let left = (-rolls.x).atan2(rolls.y).to_degrees();
    says(&curve, &format!("rolls {left:.4} degrees to the left"));
}

/// Velocity of a ball after the first collision that it takes part in.
fn after_hit(trace: &Trace, ball: usize) -> State {
    let hit = trace.events.iter().position(|event| {
        let (a, b) = event.kind.balls();
        event.kind.is_collision() && (a == ball || b == Some(ball))
    });
    let far = hit.map(|hit| hit as u32);
    let mut knots = trace.paths[ball].knots.iter();
    knots
        .find(|knot| knot.after == far && far.is_some())
        .unwrap()
        .state
}

#[test]
fn throw_is_the_smaller_of_sticking_and_slipping_and_side_that_gears_throws_nothing() {
    let scene = scene("throw");
    let (speed, gap, e, mu) = (1.5, 1e-5, 0.95, 0.06_f64);
    // on the way to the contact the cloth takes this part of the speed, and gives 5/2 of it as spin about a horizontal axis
    let cloth = 0.2 * scene.gravity * gap / (speed * speed);
    let trace = exact(&scene);
    let sticking = |cut: f64| 2.0 * cut.tan() / (7.0 * (1.0 + e));
    // (ball, cut in degrees, tan of the throw, what the cloth changes of it, in the description)
    let cases = [
        // in the plane all speeds are smaller by the same part, and the angle is the same; rounding of coordinates of 1e-2 R
        (1, 10.0, sticking(10_f64.to_radians()), 1e-12, "1.4799"),
        // friction turns out of the plane by the angle of 5/2 of that part over the slip sin(cut), and its cosine is less than 1
        (3, 30.0, mu, mu * (2.5 * cloth / 0.5).powi(2), "3.4336"),
        (5, 45.0, mu, mu * (2.5 * cloth / 0.7).powi(2), "3.4336"),
        // the gears miss each other by what the cloth takes of the speed, and stick
        (7, 30.0, 0.0, cloth, "gear"),
    ];
    for (ball, cut, tan, allowed, words) in cases {
        let v = after_hit(&trace, ball).velocity;
        let throw = f64::to_radians(cut) - v.x.atan2(v.y);
        let error = (throw.tan() - tan).abs();
        assert!(
            error <= allowed,
            "cut {cut}: tan {} not {tan}, {error:e}",
            throw.tan()
        );
        says(&scene, words);
    }
    assert!(sticking(10_f64.to_radians()) < mu && sticking(30_f64.to_radians()) > mu);
}

#[test]
fn banks_leave_and_bend_as_the_cushion_and_the_slide_say() {
    for (name, leaves, rolls) in [
        ("bank", "45.9942", "30.1501"),
        ("bank-side", "37.6971", "27.5376"),
    ] {
        let scene = scene(name);
        let ball = &scene.balls[0];
        let reach = scene.reach(Side::X1, ball.radius).unwrap();
        let way = (reach - ball.state.position.x) * 2.0_f64.sqrt();
        let (met, time) = after_way(&scene, way);
        let body = Body {
            velocity: met.velocity,
            spin: met.spin,
            mass: ball.mass,
            radius: ball.radius,
        };
        let law = scene.effects.cushion.unwrap();
        let (after, _) = cushion::impact(law, &body, Side::X1).motion.on_cloth();
        let trace = exact(&scene);
        let hit = trace.collisions().next().unwrap();
        close(
            &scene,
            "the time of the first cushion",
            hit.time,
            time,
            time,
        );
        let got = after_hit(&trace, 0);
        assert!(
            (got.velocity - after.velocity).norm() < CLOSE,
            "{name}: {}",
            got.velocity
        );
        let slip = slip_velocity(&after.velocity, &after.spin, ball.radius);
        let rolling = natural_roll(&after.velocity, &slip);
        let angle = |v: Vec3| format!("{:.4}", (-v.x).atan2(v.y).to_degrees());
        assert_eq!(
            (angle(after.velocity), angle(rolling)),
            (leaves.into(), rolls.into())
        );
        says(&scene, leaves);
        says(&scene, rolls);
        if name == "bank-side" {
            says(
                &scene,
                &format!("{:.4} left when it meets", met.spin.z.abs()),
            );
        }
    }
}

#[test]
fn every_shot_ends_gains_nothing_and_misses_no_contact() {
    let mut events = 0;
    for name in SHOTS {
        let scene = scene(name);
        let trace = exact(&scene);
        assert!(trace.ending.is_complete(), "{name}: {:?}", trace.ending);
        events += trace.events.len();
        // each event rounds each of the balls' energies a few times
        let rounding = 64.0 * f64::EPSILON * trace.events.len() as f64;
        let gained = trace.extrema.energy_gained.value / scene.initial_energy();
        assert!(gained <= rounding, "{name} gains {gained:e}");
        let path = scene.largest_speed() * trace.end_time;
        let mut length = 16.0 * f64::EPSILON * (scene.largest_coordinate() + path);
        if trace.follows_contacts() {
            // balls that stay in contact move on no parabolas
            length += UNEXPLAINED_IN_CONTACT * scene.balls[0].radius;
        }
        assert!(
            trace.unexplained() <= length,
            "{name}: {:e}",
            trace.unexplained()
        );
        let overlap = deepest_overlap(&scene, &trace);
        assert!(
            overlap <= scene.touching(),
            "{name}: parry sees {overlap:e}"
        );
    }
    assert!(events > 500, "{events} events");
}

#[test]
fn two_precisions_have_the_same_events_of_every_shot() {
    for name in SHOTS {
        let scene = scene(name);
        let found = horizon(&scene, Precision::F64, false, &Limits::NONE).unwrap();
        // real breaks let rounding grow beyond the band before they end; their events are the same all the same
        let allowed: &[Limit] = match name {
            "pool-break" | "report-break-real" | "report-break-pressed" => &[Limit::Apart],
            _ => &[Limit::Whole],
        };
        assert!(
            allowed.contains(&found.limit),
            "{name}: {:?} at event {} of {}",
            found.limit,
            found.certain,
            found.sights.len()
        );
    }
}

#[test]
fn the_real_break_pockets_and_everything_rests() {
    let trace = exact(&scene("pool-break"));
    assert_eq!(trace.ending, Ending::Rest);
    let fell = trace
        .events
        .iter()
        .filter(|e| e.kind.id() == "pocket")
        .count();
    let stopped = trace.stop_times.iter().flatten().count();
    assert!(fell > 0, "no ball falls");
    assert_eq!(fell + stopped, 16, "a ball is nowhere or still moves");
}
