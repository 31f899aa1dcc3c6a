//! Cushion with a nose at height h and friction at the cushion and at the cloth, integrated through the impact.
//!
//! Source: S. Mathavan, M. R. Jackson, R. M. Parkin, "A theoretical analysis of billiard ball dynamics under cushion impacts",
//! Proc. IMechE C 224 (2010), 1863-1873. It has no closed form. It runs in f64 (in dual numbers where derivatives are asked for)
//! and states what its result may be off by.
//!
//! Per unit of mass, x into the cushion, y along it, z up, `sin th = height - 1`: the independent variable is the normal impulse
//! `P` at the nose, along `-N = -(cos th, 0, sin th)`. Friction at the nose, at most `mu dP`, acts against the slip there; friction
//! at the cloth, at most `mu_cloth dQ`, against the slip there, where `dQ = max(0, ...)` is the impulse of the cloth that keeps
//! the ball from moving down. Compression ends when `v_x = 0`; restitution when the work returned, `dW = |v_x| cos th dP`, is
//! `e^2` times that of compression.
//!
//! Where a slip ends the paper's fixed steps make it chatter about zero. The limit of small steps is Coulomb's law: the contact
//! sticks with whatever friction holds it while that is within its limit, and slips again where it is not. So each contact
//! has two modes, and a step of the integration stays in one.

use super::{Rebound, facing, nose, turned_back};
use crate::math::extrapolation::{Step, step};
use crate::math::{Real, worse};
use crate::physics::{Body, Motion, Side};
use nalgebra::Vector3;

/// A slip below this, in units of the ball's speed, has ended.
const ENDED: f64 = 1e-12;

/// Error of one step of the integration, in units of the ball's speed.
const TOLERANCE: f64 = 1e-13;

/// Rounding of one step, in units of the ball's speed: some tens of operations of f64.
const ROUNDING: f64 = 1e-14;

/// Within this impulse, in units of the ball's speed, the end of a sticking is located; forces are continuous there.
const LEAVING: f64 = 1e-8;

/// A slip counts as ending when it would end within this many times the impulse to the goal.
const SOON: f64 = 4.0;

/// More steps than any impact takes; past them the result is not a number, which every engine notices.
const MOST_STEPS: usize = 20_000;

/// Motion of a ball after it meets the cushion `side`. `[e, mu, mu_cloth, height]`: restitution of work, friction at the nose
/// and at the cloth, height of the nose in radii.
#[inline(never)]
pub fn impact<T: Real>(numbers: [T; 4], ball: &Body<T>, side: Side) -> Rebound<T> {
    let (v, w) = (facing(side, &ball.velocity), facing(side, &ball.spin));
    let surface = w * ball.radius;
    let start = [v.x, v.y, surface.x, surface.y, surface.z];
    let (end, error) = if T::DIFFERENTIATES {
        rebound(numbers, start, TOLERANCE)
    } else {
        let (end, error) = rebound(numbers.map(T::to_f64), start.map(T::to_f64), TOLERANCE);
        (end.map(T::lift), error)
    };
    let [vx, vy, sx, sy, sz] = end;
    let spin = Vector3::new(sx, sy, sz) / ball.radius;
    let motion = Motion {
        velocity: turned_back(side, &Vector3::new(vx, vy, T::zero())),
        spin: turned_back(side, &spin),
    };
    Rebound { motion, error }
}

/// Velocity and spin times radius after the impact, and what they may be off by, length/s.
fn rebound<T: Real>(numbers: [T; 4], start: [T; 5], tolerance: f64) -> ([T; 5], f64) {
    let sizes = start.iter().map(|x| x.abs().to_f64());
    let size = sizes.fold(0.0, worse);
    if start[0] <= T::zero() || !size.is_finite() {
        return (start, 0.0);
    }
    let [e, mu, mu_cloth, height] = numbers;
    let (sin, cos) = nose(height);
    // the law is of the first degree in the speeds: a power of two brings them near 1 without rounding
    let unit = 2.0_f64.powi(size.log2().floor() as i32);
    let [vx, vy, sx, sy, sz] = start.map(|x| x / T::lift(unit));
    let mut run = Integration {
        mu: [mu, mu_cloth],
        sin,
        cos,
        tolerance,
        state: [vx, vy, sx, sy, sz, T::zero()],
        modes: [Mode::Slips([T::zero(); 2]); 2],
        error: 0.0,
        steps: 0,
    };
    run.choose([NOSE, CLOTH].map(|i| run.speed(i) <= ENDED));
    let mut finished = run.until(Goal::Stopped);
    let returned = run.state[WORK] * e * e;
    run.state[WORK] = T::zero();
    if returned > T::zero() {
        finished = finished && run.until(Goal::Returned(returned));
    }
    if !finished {
        return ([T::lift(f64::NAN); 5], f64::NAN);
    }
    let [vx, vy, sx, sy, sz, _] = run.state;
    (
        [vx, vy, sx, sy, sz].map(|x| x * T::lift(unit)),
        run.error * unit,
    )
}

/// What ends a half of the impact.
#[derive(Clone, Copy)]
enum Goal<T> {
    /// `v_x = 0`: the end of compression.
    Stopped,
    /// The work returned, as the integral of `|v_x| dP`, has this value: the end of restitution.
    Returned(T),
}

/// What one contact does.
#[derive(Clone, Copy)]
enum Mode<T> {
    /// It slips; while the slip is as good as zero, in this direction.
    Slips([T; 2]),
    /// Friction holds it.
    Sticks,
}

/// Index of the contact with the cushion's nose.
const NOSE: usize = 0;

/// Index of the contact with the cloth.
const CLOTH: usize = 1;

/// Index of the integral of `|v_x| dP` in a state.
const WORK: usize = 5;

/// Forces on the ball per unit of normal impulse at the nose.
struct Forces<T> {
    /// Friction at each contact: at the nose along y and along `(-sin th, 0, cos th)`; at the cloth along x and y.
    friction: [[T; 2]; 2],
    /// Normal force of the cloth.
    load: T,
}

/// An impact on its way.
struct Integration<T> {
    /// Friction at the nose and at the cloth.
    mu: [T; 2],
    sin: T,
    cos: T,
    tolerance: f64,
    /// Velocity x and y, spin times radius x, y and z, and the integral of `|v_x| dP`; speeds in units of the ball's.
    state: [T; 6],
    modes: [Mode<T>; 2],
    /// Sum of the errors of all steps.
    error: f64,
    steps: usize,
}

impl<T: Real> Integration<T> {
    /// Slip velocity at a contact, in the directions of its friction.
    fn slip(&self, contact: usize, [vx, vy, sx, sy, sz, _]: &[T; 6]) -> [T; 2] {
        if contact == NOSE {
            [
                *vy + *sz * self.cos - *sx * self.sin,
                -(*vx * self.sin) - *sy,
            ]
        } else {
            [*vx - *sy, *vy + *sx]
        }
    }

    fn speed(&self, contact: usize) -> f64 {
        length(self.slip(contact, &self.state)).to_f64()
    }

    /// Direction in which a contact slips.
    fn direction(&self, contact: usize, state: &[T; 6], from_rest: [T; 2]) -> [T; 2] {
        let slip = self.slip(contact, state);
        let speed = length(slip);
        if speed.to_f64() > ENDED {
            slip.map(|u| u / speed)
        } else {
            from_rest
        }
    }

    /// Factors by which friction at one contact moves the slip: at the nose across, at the other contact along y, and across.
    fn factors(&self) -> (T, T, T) {
        let inertia = T::lift(2.5);
        (
            inertia + self.sin * self.sin,
            T::one() - inertia * self.sin,
            inertia - self.sin,
        )
    }

    /// Forces in the given modes. Where a contact sticks, its friction keeps its slip from changing.
    fn forces(&self, state: &[T; 6], modes: &[Mode<T>; 2]) -> Forces<T> {
        let (sin, cos) = (self.sin, self.cos);
        let (zero, stiff) = (T::zero(), T::lift(3.5));
        let (across, coupled_y, coupled_x) = self.factors();
        let load_at = |nose: T| (sin - cos * nose).at_least(zero);
        let slips = |contact: usize, from_rest: [T; 2]| {
            self.direction(contact, state, from_rest)
                .map(|u| -(u * self.mu[contact]))
        };
        match *modes {
            [Mode::Slips(nose), Mode::Slips(cloth)] => {
                let nose = slips(NOSE, nose);
                let load = load_at(nose[1]);
                let cloth = slips(CLOTH, cloth).map(|f| f * load);
                Forces {
                    friction: [nose, cloth],
                    load,
                }
            }
            [Mode::Slips(nose), Mode::Sticks] => {
                let nose = slips(NOSE, nose);
                let cloth = [cos - coupled_x * nose[1], -(coupled_y * nose[0])];
                Forces {
                    friction: [nose, cloth.map(|f| f / stiff)],
                    load: load_at(nose[1]),
                }
            }
            [Mode::Sticks, Mode::Slips(cloth)] => {
                let per_load = slips(CLOTH, cloth);
                let pull = coupled_x * per_load[0];
                let pressed = -(sin * (cos + pull)) / (across - pull * cos);
                let lifted = -(sin * cos) / across;
                let up = if sin - cos * pressed > zero {
                    pressed
                } else {
                    lifted
                };
                let load = load_at(up);
                let cloth = per_load.map(|f| f * load);
                Forces {
                    friction: [[-(coupled_y * cloth[1]) / stiff, up], cloth],
                    load,
                }
            }
            [Mode::Sticks, Mode::Sticks] => {
                let held = cos / (T::one() + sin);
                Forces {
                    friction: [[zero, -held], [held, zero]],
                    load: load_at(-held),
                }
            }
        }
    }

    /// Rates of the state by the normal impulse at the nose.
    fn rates(&self, state: &[T; 6], modes: &[Mode<T>; 2]) -> [T; 6] {
        let Forces { friction, .. } = self.forces(state, modes);
        let [[y, up], [cloth_x, cloth_y]] = friction;
        let turn = T::lift(2.5);
        [
            cloth_x - self.cos - self.sin * up,
            y + cloth_y,
            turn * (cloth_y - self.sin * y),
            -(turn * (up + cloth_x)),
            turn * self.cos * y,
            state[0].abs(),
        ]
    }

    /// Whether friction can hold the contacts that stick.
    fn holds(&self, modes: &[Mode<T>; 2]) -> bool {
        let Forces { friction, load } = self.forces(&self.state, modes);
        let limits = [self.mu[NOSE], self.mu[CLOTH] * load];
        [NOSE, CLOTH]
            .into_iter()
            .all(|contact| match modes[contact] {
                Mode::Sticks => length(friction[contact]) <= limits[contact],
                Mode::Slips(_) => true,
            })
    }

    /// Chooses the modes of the contacts that are at rest; the others slip.
    fn choose(&mut self, at_rest: [bool; 2]) {
        let stays = Mode::Slips([T::zero(); 2]);
        for sticks in [[true, true], [true, false], [false, true]] {
            let modes = sticks.map(|sticks| if sticks { Mode::Sticks } else { stays });
            let possible = (0..2).all(|i| at_rest[i] || !sticks[i]);
            if possible && self.holds(&self.started(at_rest, modes)) {
                self.modes = self.started(at_rest, modes);
                return;
            }
        }
        self.modes = self.started(at_rest, [stays; 2]);
    }

    /// The same modes with the direction in which each contact at rest begins to slip: along the rate of its own slip.
    fn started(&self, at_rest: [bool; 2], mut modes: [Mode<T>; 2]) -> [Mode<T>; 2] {
        // one pass is exact at the cloth, where friction moves the slip against itself; a few settle the nose
        for _ in 0..4 {
            for contact in [NOSE, CLOTH] {
                if let (true, Mode::Slips(_)) = (at_rest[contact], modes[contact]) {
                    let rate = self.slip(contact, &self.rates(&self.state, &modes));
                    let speed = length(rate);
                    if speed > T::zero() {
                        modes[contact] = Mode::Slips(rate.map(|u| u / speed));
                    }
                }
            }
        }
        modes
    }

    /// Goes on until `goal` is reached; false if that takes too many steps.
    fn until(&mut self, goal: Goal<T>) -> bool {
        // length of the next step as a share of what is nearest: the goal, or the end of a slip
        let mut share = 1.0;
        let mut overshot = false;
        while self.steps < MOST_STEPS {
            self.steps += 1;
            let rates = self.rates(&self.state, &self.modes);
            let far = self.impulse_to(goal, &rates);
            let to_rest = [NOSE, CLOTH].map(|contact| self.impulse_to_rest(contact, &rates));
            let ends = to_rest.map(|impulse| impulse.is_some_and(|impulse| impulse < SOON * far));
            let near = to_rest.iter().flatten().copied().fold(far, f64::min);
            let impulse = share * near;
            let lands = overshot || (share >= 1.0 && ends == [false; 2] && self.sees(goal));
            let taken = if lands {
                self.land(goal)
            } else {
                self.advance(impulse, ends)
            };
            let Some(taken) = taken else {
                share *= 0.3;
                overshot = false;
                continue;
            };
            if !lands && is_past(goal, &taken.end) {
                overshot = true;
                continue;
            }
            let before = std::mem::replace(&mut self.state, taken.end);
            if impulse > LEAVING && !self.holds(&self.modes) {
                self.state = before;
                share *= 0.5;
                overshot = false;
                continue;
            }
            self.error += taken.error + ROUNDING;
            if lands {
                return true;
            }
            share = match taken.rows {
                ..=5 => f64::min(2.0 * share, 3.0),
                6 => share,
                _ => 0.8 * share,
            };
            self.change_modes();
        }
        false
    }

    /// One step over the normal impulse `impulse`. Slips that end slow the clock, so that the last part of a slip, in which its
    /// direction turns ever faster, is as smooth as the first.
    fn advance(&self, impulse: f64, ends: [bool; 2]) -> Option<Step<T, 6>> {
        let now = [NOSE, CLOTH].map(|contact| length(self.slip(contact, &self.state)));
        let rate = |state: &[T; 6]| {
            let mut pace = T::one();
            for contact in [NOSE, CLOTH] {
                if ends[contact] {
                    pace *= length(self.slip(contact, state)) / now[contact];
                }
            }
            self.rates(state, &self.modes).map(|rate| rate * pace)
        };
        step(rate, &self.state, T::lift(impulse), self.tolerance)
    }

    /// One step to the goal, by what the goal is a value of: so it ends there exactly, derivatives included (Henon 1982).
    fn land(&self, goal: Goal<T>) -> Option<Step<T, 6>> {
        let length = match goal {
            Goal::Stopped => self.state[0],
            Goal::Returned(work) => work - self.state[WORK],
        };
        let rate = |state: &[T; 6]| {
            let rates = self.rates(state, &self.modes);
            let pace = match goal {
                Goal::Stopped => -rates[0],
                Goal::Returned(_) => rates[WORK],
            };
            rates.map(|rate| rate / pace)
        };
        step(rate, &self.state, length, self.tolerance)
    }

    /// Normal impulse to the goal at the present rates.
    fn impulse_to(&self, goal: Goal<T>, rates: &[T; 6]) -> f64 {
        let (speed, slowing) = (self.state[0].abs().to_f64(), -rates[0].to_f64());
        let impulse = match goal {
            Goal::Stopped => speed / slowing,
            Goal::Returned(work) => {
                let rest = (work - self.state[WORK]).to_f64();
                let gain = speed * speed + 2.0 * slowing.max(0.0) * rest;
                // half-way at most while the ball is still slow: the work then grows with the square
                let part = if self.sees(goal) { 1.0 } else { 0.5 };
                part * 2.0 * rest / (speed + gain.sqrt())
            }
        };
        // where friction overcomes the cushion for a while there is no such impulse: then a step of the size of the speed
        if impulse > 0.0 && impulse < 1.0 {
            impulse
        } else {
            1.0
        }
    }

    /// Whether the goal can be reached by what it is a value of.
    fn sees(&self, goal: Goal<T>) -> bool {
        match goal {
            Goal::Stopped => true,
            // at first the ball is at rest and returns no work
            Goal::Returned(work) => self.state[WORK] * T::lift(4.0) >= work,
        }
    }

    /// Normal impulse until the slip of a contact ends, at the present rates; `None` where it does not.
    fn impulse_to_rest(&self, contact: usize, rates: &[T; 6]) -> Option<f64> {
        let slips = matches!(self.modes[contact], Mode::Slips(_));
        if !slips || self.mu[contact] <= T::zero() || self.speed(contact) <= ENDED {
            return None;
        }
        let [slip, rate] = [&self.state, rates].map(|of| self.slip(contact, of));
        let closing = -dot(slip, rate);
        (closing > T::zero()).then(|| (dot(slip, slip) / closing).to_f64())
    }

    /// Ends the slips that have become as good as zero, and lets go what friction cannot hold.
    fn change_modes(&mut self) {
        let mut at_rest = [false; 2];
        let mut changes = !self.holds(&self.modes);
        for contact in [NOSE, CLOTH] {
            let sticks = matches!(self.modes[contact], Mode::Sticks);
            let arrives = !sticks && self.mu[contact] > T::zero() && self.speed(contact) <= ENDED;
            if arrives {
                self.arrive(contact);
            }
            at_rest[contact] = sticks || arrives;
            changes |= arrives;
        }
        if changes {
            self.choose(at_rest);
        }
    }

    /// Takes away what is left of a slip: at the present rates as far as they do it, then by friction alone.
    fn arrive(&mut self, contact: usize) {
        let rates = self.rates(&self.state, &self.modes);
        let [slip, rate] = [&self.state, &rates].map(|of| self.slip(contact, of));
        let closing = -dot(slip, rate);
        if closing > T::zero() {
            let impulse = dot(slip, slip) / closing;
            self.state = std::array::from_fn(|i| self.state[i] + rates[i] * impulse);
        }
        let [along, across] = self.slip(contact, &self.state);
        let (stiff, turn) = (T::lift(3.5), T::lift(2.5));
        let push = if contact == NOSE {
            let (y, up) = (-(along / stiff), -(across / self.factors().0));
            [
                -(self.sin * up),
                y,
                -(turn * self.sin * y),
                -(turn * up),
                turn * self.cos * y,
            ]
        } else {
            let (x, y) = (-(along / stiff), -(across / stiff));
            [x, y, turn * y, -(turn * x), T::zero()]
        };
        for (value, push) in self.state.iter_mut().zip(push) {
            *value += push;
        }
        self.error += ENDED;
    }
}

/// Whether a step went beyond the goal.
fn is_past<T: Real>(goal: Goal<T>, state: &[T; 6]) -> bool {
    match goal {
        Goal::Stopped => state[0] < T::zero(),
        Goal::Returned(work) => state[WORK] > work,
    }
}

fn dot<T: Real>(a: [T; 2], b: [T; 2]) -> T {
    a[0] * b[0] + a[1] * b[1]
}

fn length<T: Real>(u: [T; 2]) -> T {
    dot(u, u).sqrt()
}
