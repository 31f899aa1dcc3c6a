//! Order of convergence, measured over halvings of the step.

use super::{G, M, MU, R, pool, simulate, time_of, within};
use carom::math::Vec3;
use carom::physics::cloth::rotational::{self, Coefficients, roll_distance, slid, slide_time};
use carom::physics::contact;
use carom::physics::{Body, Contact, Friction, Motion, State};
use carom::trace::{EventKind, Record};

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
            // slide: a t dt/2 short; roll: v_roll dt/2 short; together v dt/2, and some a dt^2/2 of steps that a phase ends in
            within("short", short, 0.5 * v * dt, 2.0 * a * dt * dt);
            place += short;
        }
        times.push(time / f64::from(PHASES));
        places.push(place / f64::from(PHASES));
    }
    for (dt, time) in STEPS.iter().zip(&times) {
        within("mean lateness of rolling in steps", time / dt, 0.5, 1e-9);
    }
    // terms of second order have the relative size of dt over the time to roll, 0.025 at the coarsest step
    for order in orders(&times).into_iter().chain(orders(&places)) {
        within("order", order, 1.0, 0.03);
    }
}

/// Where a ball ends that leaves an impact with this state: slide, then roll, in closed form.
fn end(state: &State, mu: Coefficients) -> Vec3 {
    let slip = rotational::slip_velocity(&state.velocity, &state.spin, R);
    let rolls = slid(state, R, mu, G, slide_time(slip.norm(), mu.mu_slide, G));
    let speed = rolls.velocity.norm();
    rolls.position + rolls.velocity * (roll_distance(speed, mu.mu_roll, G) / speed)
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
    // mean distance from the closed form, by ball and step size
    let mut errors = [Vec::new(), Vec::new()];
    for dt in STEPS {
        let mut error = [0.0; 2];
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
                let got = trace.final_states()[i].unwrap().position;
                error[i] += (got - end(&state, mu)).norm() / f64::from(PHASES);
            }
        }
        for (of_ball, error) in errors.iter_mut().zip(error) {
            of_ball.push(error);
        }
    }
    // n phases sample the lateness of the contact, which is most of the error, to 1/n of its mean
    let sampled = 1.0 / f64::from(PHASES);
    let halvings = (STEPS.len() - 1) as f64;
    let bound = ((1.0 + sampled) / (1.0 - sampled)).log2() / halvings;
    for errors in &errors {
        let slope = (errors[0] / errors[STEPS.len() - 1]).log2() / halvings;
        within(&format!("order of {errors:?}"), slope, 1.0, bound);
    }
}
