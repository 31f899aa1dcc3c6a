//! A second method for a contact phase: inelastic time stepping after Moreau, written here and nowhere else, from the state in
//! which the contact begins. It knows nothing of phases: a step finds the impulse that keeps the pair apart, a ball slides
//! or rolls by its slip. First order in the step; three steps are extrapolated, and their last two columns say how well.

use super::{G, MU_ROLL, MU_SLIDE, R, lasting, run_of};
use carom::trace::{Partner, Trace};

type Vector = [f64; 2];

/// Longest step, s; the others are a half and a quarter of it.
const STEP: f64 = 8e-6;

/// Centre, velocity, and the velocity that rolling with the ball's spin would have.
#[derive(Clone, Copy, Debug)]
struct Ball {
    position: Vector,
    velocity: Vector,
    rolling: Vector,
}

impl Ball {
    fn slip(&self) -> Vector {
        minus(self.velocity, self.rolling)
    }
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

fn plus(a: Vector, b: Vector, times: f64) -> Vector {
    [a[0] + times * b[0], a[1] + times * b[1]]
}

fn size(a: Vector) -> f64 {
    a[0].hypot(a[1])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// What the cloth does in a step to a ball that nothing pushes, and the share of a push that changes its speed.
fn cloth(ball: &Ball, dt: f64) -> (Ball, f64) {
    let (slip, speed) = (ball.slip(), size(ball.velocity));
    let lost = MU_SLIDE * G * dt;
    let mut next = *ball;
    // the impulse that ends the slip: 7/2 of it goes into the slip
    if 3.5 * lost >= size(slip) {
        next.velocity = plus(ball.velocity, slip, -2.0 / 7.0);
        let slower = (1.0 - MU_ROLL * G * dt / speed).max(0.0);
        next.velocity = next.velocity.map(|v| v * slower);
        next.rolling = next.velocity;
        return (next, 5.0 / 7.0);
    }
    let along = slip.map(|u| u / size(slip));
    next.velocity = plus(ball.velocity, along, -lost);
    next.rolling = plus(ball.rolling, along, 2.5 * lost);
    (next, 1.0)
}

/// Two balls `time` later in `steps` steps.
fn pair(mut balls: [Ball; 2], time: f64, steps: u32) -> [Ball; 2] {
    let dt = time / f64::from(steps);
    for _ in 0..steps {
        // the gap is that in the middle of the step
        let middle = balls.map(|ball| plus(ball.position, ball.velocity, 0.5 * dt));
        let apart = minus(middle[1], middle[0]);
        let normal = apart.map(|x| x / size(apart));
        let [(mut one, share), (mut other, its)] = balls.map(|ball| cloth(&ball, dt));
        let gap = dot(minus(balls[1].position, balls[0].position), normal) - 2.0 * R;
        let opening = dot(minus(other.velocity, one.velocity), normal);
        let push = (-(opening + gap / dt) / (share + its)).max(0.0);
        for (ball, share, push) in [(&mut one, share, -push), (&mut other, its, push)] {
            ball.velocity = plus(ball.velocity, normal, share * push);
            if share < 1.0 {
                ball.rolling = ball.velocity;
            }
            ball.position = plus(ball.position, ball.velocity, dt);
        }
        balls = [one, other];
    }
    balls
}

fn numbers(balls: &[Ball; 2]) -> Vec<f64> {
    let all = balls.iter().map(|b| [b.position, b.velocity, b.rolling]);
    all.flatten().flatten().collect()
}

/// A ball of a trace at `time`, on the side before or after what happens then.
fn of(trace: &Trace, ball: usize, time: f64, after: bool) -> Ball {
    let path = &trace.paths[ball];
    let state = if after {
        path.state_at(time)
    } else {
        path.before(time)
    };
    let state = state.unwrap_or_else(|| panic!("no ball {ball}"));
    let (r, v, w) = (state.position, state.velocity, state.spin);
    Ball {
        position: [r.x, r.y],
        velocity: [v.x, v.y],
        rolling: [R * w.y, -R * w.x],
    }
}

#[test]
fn inelastic_time_stepping_ends_a_contact_phase_in_the_same_state() {
    for name in ["b3-offline-release", "a3-three-e1"] {
        let (_, solution) = run_of(name);
        let trace = &solution.trace;
        let (a, partner, begin, end) = lasting(trace)[0];
        let Partner::Ball(b) = partner else {
            panic!("{name}: {partner:?}");
        };
        let start = [a, b as usize].map(|ball| of(trace, ball, begin, true));
        let last = [a, b as usize].map(|ball| of(trace, ball, end, false));
        let steps = ((end - begin) / STEP).ceil() as u32;
        let runs = [1, 2, 4].map(|finer| numbers(&pair(start, end - begin, finer * steps)));
        let (mut worst, mut doubt, mut moved): (f64, f64, f64) = (0.0, 0.0, 0.0);
        let (known, first) = (numbers(&last), numbers(&start));
        for (i, known) in known.iter().enumerate() {
            // two halvings: the error in dt, then that in dt^2
            let [coarse, half, quarter] = [&runs[0], &runs[1], &runs[2]].map(|run| run[i]);
            let (one, two) = (2.0 * half - coarse, 2.0 * quarter - half);
            let best = (4.0 * two - one) / 3.0;
            worst = worst.max((best - known).abs());
            doubt = doubt.max((best - two).abs());
            moved = moved.max((known - first[i]).abs());
        }
        assert!(moved > 1e-3, "{name}: nothing happens in the phase");
        assert!(
            doubt <= 1e-5 * moved,
            "{name}: the stepping leaves {doubt:e} open"
        );
        assert!(
            worst <= 10.0 * doubt,
            "{name}: {worst:e} apart at the end, the stepping doubts {doubt:e}"
        );
    }
}
