//! What rolls at the start.

use super::run;
use carom::math::Vec3;
use carom::math::random::Draws;
use carom::physics::{Cloth, State};
use carom::scene::{Scene, parse};
use carom::trace::EventKind;

const ENGINES: [&str; 4] = ["exact", "stepper", "rapier-f64", "rapier-f32"];
const R: f64 = 0.028575;

/// One ball on a pool cloth.
fn scene(velocity: [f64; 2], spin: [f64; 3]) -> Scene {
    let text = format!(
        "name = \"one-ball\"\ndescription = \"A ball on a cloth.\"\nduration = 30.0\ngravity = 9.81\n\
         [ball]\nradius = {R}\nmass = 0.17\n\
         [[balls]]\nid = \"cue\"\nposition = [0.0, 0.0]\nvelocity = {velocity:?}\nspin = {spin:?}\n\
         [effects.cloth.rotational]\nmu_slide = 0.2\nmu_roll = 0.01\nmu_spin = 0.0127\n"
    );
    parse("one-ball", &text).unwrap_or_else(|error| panic!("{error}"))
}

fn six_digits(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap()
}

fn slides(id: &str, scene: &Scene) -> bool {
    let trace = run(id, scene).unwrap_or_else(|refusal| panic!("{id}: {refusal}"));
    let begins = |kind: EventKind| matches!(kind, EventKind::SlideToRoll(_));
    trace.events.iter().any(|event| begins(event.kind))
}

fn slip(state: &State) -> f64 {
    let (v, w) = (state.velocity, state.spin);
    (v.x - R * w.y).hypot(v.y + R * w.x)
}

#[test]
fn rolling_given_to_six_digits_rolls_in_every_engine() {
    let mut draws = Draws::new(7, 0);
    let mut taken = 0;
    for round in 0..40 {
        let v = [draws.between(-2.0, 2.0), draws.between(-2.0, 2.0)];
        // one part small beside the other
        let v = [v[0], if round % 4 == 0 { 1e-3 * v[1] } else { v[1] }];
        let spin = [-v[1] / R, v[0] / R, draws.between(-9.0, 9.0)];
        let scene = scene(v.map(six_digits), spin.map(six_digits));
        let start = scene.start(0);
        taken += usize::from(start != scene.balls[0].state);
        let rolls = slip(&start) <= 4.0 * f64::EPSILON * start.speed();
        assert!(rolls, "{start:?} slips by {:e}", slip(&start));
        assert_eq!(start.spin.z, scene.balls[0].state.spin.z);
        let energy = scene.kinetic_energy(&[start]);
        assert!(energy <= scene.initial_energy() * (1.0 + 4.0 * f64::EPSILON));
        for id in ENGINES {
            assert!(
                !slides(id, &scene),
                "{id}: {:?} slides",
                scene.balls[0].state
            );
        }
        let trace = run("exact", &scene).unwrap();
        let first = trace.paths[0].knots[0].state;
        assert_eq!(first.velocity, start.velocity, "the trace begins elsewhere");
        assert!(slip(&first) <= 4.0 * f64::EPSILON * first.speed());
    }
    assert!(taken >= 30, "{taken} of 40 needed the rule");
}

#[test]
fn a_slip_of_more_than_six_digits_stays_and_so_does_a_smaller_one_in_more_digits() {
    let v = [1.0, 0.5];
    let rolling = [-v[1] / R, v[0] / R];
    // twice what the rounding of both numbers can make, along the velocity
    let more = rolling.map(|w| six_digits(w * (1.0 + 2.5e-5)));
    // a state of a trace: less than six digits tell, but it is there
    let less = rolling.map(|w| w * (1.0 + 1.234_567_891e-7));
    for spin in [more, less] {
        let scene = scene(v, [spin[0], spin[1], 0.0]);
        assert_eq!(scene.start(0), scene.balls[0].state);
        let trace = run("exact", &scene).unwrap();
        assert_eq!(trace.paths[0].knots[0].state, scene.balls[0].state);
        for id in ["exact", "stepper"] {
            assert!(slides(id, &scene), "{id}: {spin:?} rolls");
        }
    }
}

#[test]
fn a_component_that_is_small_beside_the_velocity_may_be_off_by_its_own_roundings() {
    // one component is off by 1e-14 of itself, which is nothing beside the other: from the spin that another program computed
    let off = scene(
        [0.5, 0.001],
        [-0.034_995_625_546_807, 17.497_812_773_403_325, 0.0],
    );
    assert_eq!(off.start(0), off.balls[0].state);
    for id in ENGINES {
        let trace = run(id, &off).unwrap_or_else(|refusal| panic!("{id}: {refusal}"));
        let place = trace.paths[0].last().unwrap().position;
        // v^2 / (2 mu_r g), and a step more or less
        let way = (0.5 * 0.5 + 1e-6) / (2.0 * 0.01 * 9.81);
        let allowed = if id == "exact" { 1e-12 } else { 2e-3 };
        assert!(
            (place.xy().norm() - way).abs() < allowed,
            "{id}: {}",
            place.norm()
        );
    }
}

#[test]
fn a_spin_about_the_vertical_has_no_say_and_without_a_grip_nothing_is_taken_for_rolling() {
    let v = [1.234_57, 0.0];
    let spin = [0.0, six_digits(v[0] / R), 0.0];
    let plain = scene(v, spin);
    let turned = scene(v, [spin[0], spin[1], 1e-30]);
    assert_eq!(plain.start(0).velocity, turned.start(0).velocity);
    assert_eq!(turned.start(0).spin.z, 1e-30);
    assert_ne!(plain.start(0), plain.balls[0].state);
    let mut loose = plain.clone();
    loose.effects.cloth = Some(Cloth::Rotational {
        mu_slide: 0.0,
        mu_roll: 0.0,
        mu_spin: 0.0,
    });
    assert_eq!(loose.start(0), loose.balls[0].state);
    // one that turns where it stands has no velocity to which its slip is small
    let stands = scene([0.0, 0.0], [0.0, 1e-9, 0.0]);
    assert_eq!(stands.start(0), stands.balls[0].state);
    let rests = scene([0.0, 0.0], [0.0; 3]);
    assert_eq!(rests.start(0).spin, Vec3::zeros());
}
