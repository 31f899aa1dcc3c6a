//! Where the energy of a contact phase goes: sliding takes mu_s m g |u|, rolling 7/5 mu_r m g |v|, and a contact without
//! friction nothing. The powers are integrated over the knots and held against the energies at both ends.

use super::phase::within;
use super::{G, MU_ROLL, MU_SLIDE, R, lasting, run_of};
use carom::physics::State;
use carom::trace::{EventKind, Knot, Partner, Trace};

/// Below this slip a ball rolls, m/s: some roundings of its spin.
const SLIPS: f64 = 1e-9;

/// What an energy balance may leave, in the energy at the start of the phase.
const BALANCE: f64 = 1e-10;

fn slip(state: &State) -> f64 {
    let (v, w) = (state.velocity, state.spin);
    (v.x - R * w.y).hypot(v.y + R * w.x)
}

/// Value at `t` of the polynomial through `points`.
pub fn through(points: &[(f64, f64)], t: f64) -> f64 {
    let term = |i: usize| {
        let (ti, value) = points[i];
        let others = (0..points.len()).filter(|j| *j != i);
        others.fold(value, |product, j| {
            product * (t - points[j].0) / (ti - points[j].0)
        })
    };
    (0..points.len()).map(term).sum()
}

/// Integral over points by the cubic through the four nearest, which two nodes of Gauss integrate exactly.
fn integral(points: &[(f64, f64)]) -> f64 {
    let mut sum = 0.0;
    for i in 1..points.len() {
        let from = (i - 1)
            .saturating_sub(1)
            .min(points.len().saturating_sub(4));
        let near = &points[from..points.len().min(from + 4)];
        let (t0, t1) = (points[i - 1].0, points[i].0);
        let (middle, half) = (0.5 * (t0 + t1), 0.5 * (t1 - t0));
        let node = half / 3.0_f64.sqrt();
        sum += half * (through(near, middle - node) + through(near, middle + node));
    }
    sum
}

/// What the cloth took from one ball, by its knots between changes of its phase: by all of them, and by every second one.
fn taken(trace: &Trace, ball: usize, mass: f64, begin: f64, end: f64) -> [f64; 2] {
    let changes = trace.events.iter().filter(|event| {
        let mine = event.kind.balls().0 == ball;
        mine && matches!(event.kind, EventKind::SlideToRoll(_) | EventKind::Stop(_))
    });
    let mut ends: Vec<f64> = changes.map(|event| event.time).collect();
    ends.retain(|t| *t > begin && *t < end);
    ends.push(end);
    let mut sums = [0.0; 2];
    let mut from = begin;
    for to in ends {
        let knots: Vec<Knot> = within(trace, ball, from, to);
        let slides = knots
            .iter()
            .skip(1)
            .rev()
            .skip(1)
            .any(|k| slip(&k.state) > SLIPS)
            || slip(&knots[0].state) > SLIPS;
        let power = |state: &State| match slides {
            true => MU_SLIDE * G * mass * slip(state),
            false => 1.4 * MU_ROLL * G * mass * state.velocity.norm(),
        };
        let mut points: Vec<(f64, f64)> = knots.iter().map(|k| (k.time, power(&k.state))).collect();
        points.dedup_by(|later, earlier| later.0 <= earlier.0);
        let last = points.len() - 1;
        let second = points.iter().copied().enumerate();
        let second: Vec<(f64, f64)> = second
            .filter(|(i, _)| i % 2 == 0 || *i == last)
            .map(|(_, point)| point)
            .collect();
        sums[0] += integral(&points);
        sums[1] += integral(&second);
        from = to;
    }
    sums
}

#[test]
fn what_a_contact_phase_loses_is_what_sliding_and_rolling_take() {
    let mut held = 0;
    for name in [
        "a3-three-e1",
        "b1-plastic-inline",
        "b3-offline-release",
        "b4-cushion",
        "b7-b35",
    ] {
        let (case, solution) = run_of(name);
        let trace = &solution.trace;
        for (ball, partner, begin, end) in lasting(trace) {
            let other = match partner {
                Partner::Ball(other) => Some(other as usize),
                Partner::Cushion(_) => None,
            };
            let (mut before, mut lost, mut took) = (0.0, 0.0, [0.0; 2]);
            for ball in std::iter::once(ball).chain(other) {
                let knots = within(trace, ball, begin, end);
                let mass = case.scene.balls[ball].mass;
                let energy = |knot: Option<&Knot>| {
                    knot.map_or(f64::NAN, |knot| {
                        let (v, w) = (knot.state.velocity, R * knot.state.spin);
                        0.5 * mass * (v.norm_squared() + 0.4 * w.norm_squared())
                    })
                };
                before += energy(knots.first());
                lost += energy(knots.first()) - energy(knots.last());
                let one = taken(trace, ball, mass, begin, end);
                took = [took[0] + one[0], took[1] + one[1]];
            }
            let error = (lost - took[0]).abs();
            // the rule over every second knot is worse than that over all by far more than the latter is wrong
            let bound = (took[0] - took[1]).abs() + 64.0 * f64::EPSILON * before;
            assert!(
                error <= bound && error <= BALANCE * before,
                "{name}: loses {lost:e} from {begin} to {end}, friction took {:e}: {error:e} apart, {bound:e} resolved",
                took[0]
            );
            held += 1;
        }
    }
    assert_eq!(held, 5, "phases");
}
