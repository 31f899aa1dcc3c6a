//! Rotation, losses, throw, cushions and pockets in the report's scheme, held against closed forms with the errors that the
//! scheme must have.
//!
//! What a step leaves exact is held to rounding. What it does not is held to bounds that follow from the scheme: a phase ends
//! at the first step end after its time, so up to dt late; a position in a phase of deceleration a falls short by a t dt/2; a
//! contact is found up to one step late, so the line of centres of a hit with offset b is turned by at most v dt b / D^2.

mod cloth;
mod impacts;
mod orders;
mod whole;

use crate::support::{Scenario, run, scenario};
use carom::math::Vec3;
use carom::physics::cloth::rotational::{self, Coefficients};
use carom::physics::{Cloth, Contact, Effects, State};
use carom::scene::Scene;
use carom::trace::{EventKind, Record, Trace};

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

/// Position, velocity and spin of a ball.
type Start = ([f64; 2], [f64; 2], [f64; 3]);

/// Pool balls on a pool cloth.
fn pool(name: &str, mu: Coefficients, balls: &[Start]) -> Scene {
    let start =
        |scene: Scenario, (i, (p, v, _)): (usize, &Start)| scene.moving(&i.to_string(), *p, *v);
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
