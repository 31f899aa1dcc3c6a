//! Friction between balls while several contacts push at once.
//!
//! The normal impulses of all contacts grow in fixed proportion, `dJ_k = J_k dtau` with `J_k` what they would be without friction.
//! Meanwhile each contact rubs by Coulomb's law: against the slip that there is at that moment with `mu J_k dtau`, or with what
//! holds it where that is less. It ends when the work of the normal impulses is what it is without friction, so that
//! friction only takes energy. One contact alone ends at `tau = 1` with the impulse of the law of a pair.
//!
//! The velocities along `tau` follow a constant pull less the gradient, in the metric of the masses, of the convex function `sum mu_k J_k |s_k|`
//! of the slips: so they are unique, also where more contacts stick than there are motions, and an error of a step never grows.
//! Where a slip vanishes or begins its direction turns ever faster; the clock runs slower there in proportion, `dtau = phi dsigma` with
//! `1/phi = 1 + sum pull_k / |s_k|`, which makes the solution smooth. Steps are extrapolated, each to rounding. A slip
//! that begins slowly follows the forces: it is taken along the push that it withstands until it has a size, and then by an implicit rule,
//! as an explicit one would have to follow how fast it turns into that direction.
//!
//! Speeds are in units of the largest there is, impulses in those that give the reduced mass of their contact such a speed.

use super::reflections::Constraint;
use crate::math::Real;
use crate::math::extrapolation::{Step, step_within};
use crate::math::implicit;

/// A step is good to so many ulp: of the size of each slip, and of the unit of speed.
const ULPS: f64 = 32.0;

/// A slip of so many ulp of the unit of speed is none.
const ENDED: f64 = 4.0;

/// Longest step: a slip becomes smaller by no more than a factor e in a unit of the slowed clock.
const LONGEST: f64 = 2.0;

/// What a contact yields to a tangential impulse on two solid spheres, in reciprocal reduced masses.
const YIELD: f64 = 3.5;

/// A slip begins with the Euler step in which it grows by this part of the root of an ulp: the square of it is no error.
const KICK: f64 = 1e-2;

/// A slip that begins at less than this part of what friction could change is left to creep.
const CREEPS: f64 = 1e-3;

/// The size up to which a slip creeps, in units of speed and roots of an ulp: its direction lags by less than that part of a turn.
const CREPT: f64 = 0.01;

/// A contact holds where the slip changes by less than this part of what friction could change.
const HELD: f64 = 1e-12;

/// A slip follows the forces where it changes by less than this part of what friction could do to it,
const FOLLOWS: f64 = 0.05;

/// and could end within this part of the whole.
const SLOWED: f64 = 0.02;

/// Sweeps over the contacts that stick, for the forces that hold them.
const MOST_SWEEPS: u32 = 4000;

/// More steps than any instant takes.
const MOST_STEPS: u32 = 50_000;

/// Without friction it ends at 1.
const MOST_TAU: f64 = 1e3;

/// Trials for the end of the path within a step.
const MOST_TRIALS: u32 = 400;

/// A contact and what it does without friction.
#[derive(Clone, Copy, Debug)]
pub struct Push<T> {
    /// Its members and the directions in which it closes.
    pub constraint: Constraint<T>,
    /// The whole normal impulse, > 0.
    pub impulse: T,
    /// Closing speed before, and after all impulses without friction, length/s.
    pub closing: [T; 2],
    /// Coefficient of friction, >= 0; 0 for a cushion.
    pub mu: T,
    /// Slip velocity of the first ball's surface over the second's: across the normal, to the left of it, and up, length/s.
    pub slip: [T; 2],
}

/// What friction makes of an instant.
#[derive(Clone, Debug)]
pub struct Rubbed<T> {
    /// The normal impulses are these parts of what they would be.
    pub part: T,
    /// Tangential impulse of each push on its first ball: across the normal, to the left of it, and up.
    pub tangential: Vec<[T; 2]>,
    /// What the velocities may be off by beyond rounding, length/s.
    pub error: f64,
}

/// Changes of a ball for a unit of `tau`: of its velocity, x, y and z, and of its spin times its radius.
type Pull<T> = [T; 6];

/// What slips and sticks, and how that goes on.
struct Path<'a, T> {
    pushes: &'a [Push<T>],
    rubs: Vec<Rub<T>>,
    balls: usize,
    /// Part of each push in the sum of all.
    weights: Vec<T>,
    /// Power of the pushes before, and the rate at which it falls without friction: parts of the largest that it can be.
    power: T,
    fall: T,
    /// Whether each rubbing contact slips; the others stick, or creep.
    slips: Vec<bool>,
}

/// A contact that rubs.
#[derive(Clone, Copy, Debug)]
struct Rub<T> {
    /// Members, and the reduced mass as a part of the mass of each.
    members: [(usize, T); 2],
    /// To the left of the normal.
    left: [T; 2],
    /// The largest force of friction.
    limit: T,
    /// Change of the slip by all normal impulses.
    steady: [T; 2],
    /// Scale of the change of the slip.
    pull: T,
}

// components of the state: of each rubbing contact the slip and the impulse, then these
const TAIL: usize = 3;
const OF_RUB: usize = 4;

fn size<T: Real>([x, y]: [T; 2]) -> T {
    (x * x + y * y).sqrt()
}

/// The tangential impulses of pushes whose balls have these masses; `unit`: the largest speed of a surface, length/s. `None` if there is no end
/// to it.
pub fn rub<T: Real>(pushes: &[Push<T>], mass: &[T], unit: T) -> Option<Rubbed<T>> {
    let (path, mut start) = Path::new(pushes, mass, unit)?;
    let slips = |i: usize| path.slips[i] || size(path.rubs[i].steady) > path.nothing();
    if !(0..path.rubs.len()).any(slips) {
        // nothing slips, and nothing makes it
        let end = path.tail() + 2;
        start[end] = T::one();
        return Some(path.finish(&start, mass, unit, 0.0));
    }
    path.run(start, mass, unit)
}

impl<'a, T: Real> Path<'a, T> {
    fn new(pushes: &'a [Push<T>], mass: &[T], unit: T) -> Option<(Self, Vec<T>)> {
        let sum = pushes
            .iter()
            .fold(T::zero(), |sum, push| sum + push.impulse);
        let weights: Vec<T> = pushes.iter().map(|push| push.impulse / sum).collect();
        let weigh = |of: &dyn Fn(&Push<T>) -> T| {
            let parts = pushes.iter().zip(&weights);
            parts.fold(T::zero(), |sum, (push, weight)| {
                sum + *weight * of(push) / unit
            })
        };
        let mut path = Path {
            pushes,
            rubs: Vec::new(),
            balls: mass.len(),
            power: weigh(&|push| push.closing[0]),
            fall: weigh(&|push| push.closing[0] - push.closing[1]),
            weights,
            slips: Vec::new(),
        };
        let steady = path.steady(mass, unit);
        let mut state = Vec::new();
        for push in pushes {
            let (a, n) = push.constraint.first;
            let (Some((b, _)), true) = (push.constraint.second, push.mu > T::zero()) else {
                continue;
            };
            let reduced = mass[a] * mass[b] / (mass[a] + mass[b]);
            let mut rub = Rub {
                members: [(a, reduced / mass[a]), (b, reduced / mass[b])],
                left: [-n[1], n[0]],
                limit: push.mu * push.impulse / (reduced * unit),
                steady: [T::zero(); 2],
                pull: T::zero(),
            };
            rub.steady = rub.slip_rate(&steady);
            rub.pull = size(rub.steady) + T::lift(YIELD) * rub.limit;
            let slip = push.slip.map(|s| s / unit);
            path.slips.push(size(slip) > path.nothing());
            path.rubs.push(rub);
            state.extend([slip[0], slip[1], T::zero(), T::zero()]);
        }
        let numbers = [path.power, path.fall].into_iter();
        let numbers = numbers.chain(path.rubs.iter().map(|rub| rub.pull));
        if !numbers.fold(unit, |sum, x| sum + x).is_finite() {
            return None;
        }
        state.extend([T::zero(); TAIL]);
        Some((path, state))
    }

    /// What the normal impulses do to every ball.
    fn steady(&self, mass: &[T], unit: T) -> Vec<Pull<T>> {
        let mut pulls = vec![[T::zero(); 6]; self.balls];
        for push in self.pushes {
            for (ball, d) in push.constraint.ends() {
                for axis in 0..2 {
                    pulls[ball][axis] -= d[axis] * push.impulse / (mass[ball] * unit);
                }
            }
        }
        pulls
    }

    /// A slip, or a change of one, that is rounding.
    fn nothing(&self) -> T {
        T::lift(ENDED * T::ULP)
    }

    fn tail(&self) -> usize {
        OF_RUB * self.rubs.len()
    }

    fn slip(state: &[T], rub: usize) -> [T; 2] {
        [state[OF_RUB * rub], state[OF_RUB * rub + 1]]
    }

    /// Forces of friction and what they do to the balls.
    fn forces(&self, state: &[T]) -> (Vec<[T; 2]>, Vec<Pull<T>>) {
        let mut pulls = vec![[T::zero(); 6]; self.balls];
        let mut forces = vec![[T::zero(); 2]; self.rubs.len()];
        for (i, rub) in self.rubs.iter().enumerate() {
            if self.slips[i] {
                let slip = Self::slip(state, i);
                let part = -rub.limit / size(slip);
                forces[i] = slip.map(|s| s * part);
                rub.push(forces[i], &mut pulls);
            }
        }
        self.hold(&mut forces, &mut pulls);
        (forces, pulls)
    }

    /// The forces of contacts without slip: those within their limits that leave the least change of slips, which is none where they hold.
    fn hold(&self, forces: &mut [[T; 2]], pulls: &mut [Pull<T>]) {
        let still: Vec<usize> = (0..self.rubs.len()).filter(|i| !self.slips[*i]).collect();
        let largest = still.iter().map(|i| self.rubs[*i].limit);
        let rounding = largest.fold(T::zero(), T::at_least) * T::lift(2.0 * T::ULP);
        for _ in 0..MOST_SWEEPS {
            let mut changed = T::zero();
            for i in &still {
                let rub = &self.rubs[*i];
                let rate = rub.slip_rate(pulls);
                let mut force =
                    [0, 1].map(|c| forces[*i][c] - (rate[c] + rub.steady[c]) / T::lift(YIELD));
                let most = size(force);
                if most > rub.limit {
                    force = force.map(|f| f * (rub.limit / most));
                }
                let change = [0, 1].map(|c| force[c] - forces[*i][c]);
                rub.push(change, pulls);
                forces[*i] = force;
                changed = changed.at_least(size(change));
            }
            if changed <= rounding {
                break;
            }
        }
    }

    /// Rates of the state for a unit of `tau`, and `phi`.
    fn rates(&self, state: &[T]) -> (Vec<T>, T) {
        let (forces, pulls) = self.forces(state);
        let mut rates = Vec::with_capacity(state.len());
        let mut slowness = T::one();
        for (i, rub) in self.rubs.iter().enumerate() {
            let rate = rub.slip_rate(&pulls);
            rates.extend([0, 1].map(|c| rate[c] + rub.steady[c]));
            rates.extend(forces[i]);
            if self.slips[i] {
                slowness += rub.pull / size(Self::slip(state, i));
            }
        }
        let mut closing = T::zero();
        for (push, weight) in self.pushes.iter().zip(&self.weights) {
            for (ball, d) in push.constraint.ends() {
                closing += *weight * (d[0] * pulls[ball][0] + d[1] * pulls[ball][1]);
            }
        }
        rates.extend([closing, state[self.tail()], T::one()]);
        (rates, T::one() / slowness)
    }

    /// Rate at which the normal impulses do work on the balls: negative while they compress.
    fn power(&self, state: &[T]) -> T {
        let tail = self.tail();
        self.fall * state[tail + 2] - self.power - state[tail]
    }

    /// Work of the normal impulses, less what it is at the end.
    fn work(&self, state: &[T]) -> T {
        let tail = self.tail();
        let tau = state[tail + 2];
        let half = self.fall / T::lift(2.0);
        (tau - T::one()) * (half * (tau + T::one()) - self.power) - state[tail + 1]
    }

    /// The longest step in `tau` where a slip follows the forces, so that an explicit rule would be slow: no slip may end in it. `None` where
    /// none follows.
    fn follows(&self, state: &[T]) -> Option<T> {
        let (rates, _) = self.rates(state);
        let (mut follows, mut longest) = (false, T::one());
        for (i, rub) in self.rubs.iter().enumerate() {
            if self.slips[i] {
                let (slip, rate) = (size(Self::slip(state, i)), size(Self::slip(&rates, i)));
                follows |= rate < rub.pull * T::lift(FOLLOWS) && slip < rub.pull * T::lift(SLOWED);
                longest = longest.at_most(slip / (rate + rate));
            }
        }
        follows.then_some(longest)
    }

    /// A step, its error and how many rows of the extrapolation were spared. `length`: of the slowed clock, or of `tau` if `stiff`.
    fn step(&self, state: &[T], length: T, stiff: bool) -> Option<(Vec<T>, f64, usize)> {
        let rows = match (T::BITS, stiff) {
            (0..=64, _) => 8,
            (65..=128, false) => 14,
            (65..=128, true) => 16,
            _ => 22,
        };
        let Step {
            end,
            error,
            rows: taken,
        } = if stiff {
            self.implicit(state, length, rows)?
        } else {
            self.explicit(state, length, rows)?
        };
        let holds = self.holds(state, &end);
        let finite = end.iter().all(|x| x.is_finite());
        (holds && finite).then_some((end, error, rows - taken))
    }

    /// Whether contacts that stick did so all through a step, or have crept all through it, and not far. The rules look at forces up to
    /// the last of their substeps: one that gives way after it shows at the end.
    fn holds(&self, state: &[T], end: &[T]) -> bool {
        let (first, last) = (self.rates(state).0, self.rates(end).0);
        let during = end[self.tail() + 2] - state[self.tail() + 2];
        let mut still = (0..self.rubs.len()).filter(|i| !self.slips[*i]);
        still.all(|i| {
            let pull = self.rubs[i].pull;
            let crept = size(Self::slip(&first, i)) > pull * T::lift(HELD);
            let missed = size(Self::slip(&last, i)) * during;
            let far = self.creeps() * T::lift(4.0);
            size(Self::slip(end, i)) <= far && (crept || missed <= self.nothing())
        })
    }

    /// The size up to which a slip creeps.
    fn creeps(&self) -> T {
        T::lift(CREPT * T::ULP.sqrt()).at_least(self.nothing())
    }

    /// The forces on a slip that follows them change as it does by a part of itself.
    fn implicit(&self, state: &[T], length: T, rows: usize) -> Option<Step<Vec<T>>> {
        let mut sizes = vec![T::zero(); state.len()];
        for i in (0..self.rubs.len()).filter(|i| self.slips[*i]) {
            let slip = size(Self::slip(state, i));
            sizes[OF_RUB * i] = slip;
            sizes[OF_RUB * i + 1] = slip;
        }
        let rate = |state: &[T]| self.rates(state).0;
        implicit::step(rows, rate, state, &sizes, length, 2.0 * ULPS * T::ULP)
    }

    fn explicit(&self, state: &[T], length: T, rows: usize) -> Option<Step<Vec<T>>> {
        // a slip is followed to its own digits: it may be small, and gives a direction
        let mut scales = vec![T::one(); state.len()];
        for i in (0..self.rubs.len()).filter(|i| self.slips[*i]) {
            let slip = size(Self::slip(state, i)).at_most(T::one());
            scales[OF_RUB * i] = slip;
            scales[OF_RUB * i + 1] = slip;
        }
        let times = |state: &[T]| -> Vec<T> {
            let scaled = state.iter().zip(&scales);
            scaled.map(|(x, scale)| *x * *scale).collect()
        };
        let over = |state: &[T], factor: T| -> Vec<T> {
            let scaled = state.iter().zip(&scales);
            scaled.map(|(x, scale)| *x * factor / *scale).collect()
        };
        let rate = |scaled: &Vec<T>| {
            let (rates, phi) = self.rates(&times(scaled));
            over(&rates, phi)
        };
        let start = over(state, T::one());
        let taken = step_within(rows, rate, &start, length, ULPS * T::ULP)?;
        Some(Step {
            end: times(&taken.end),
            ..taken
        })
    }

    /// What the lag of slips that creep may have done during a step.
    fn crept(&self, state: &[T], end: &[T]) -> f64 {
        let still = (0..self.rubs.len()).filter(|i| !self.slips[*i]);
        let slips = still.map(|i| size(Self::slip(end, i)).to_f64());
        let during = end[self.tail() + 2] - state[self.tail() + 2];
        slips.sum::<f64>() * during.to_f64()
    }

    /// Slips that end stick, and contacts that do not hold begin to slip.
    fn change_modes(&mut self, state: &mut [T]) {
        let (rates, _) = self.rates(state);
        for i in (0..self.rubs.len())
            .filter(|i| self.slips[*i])
            .collect::<Vec<_>>()
        {
            let (slip, rate) = (Self::slip(state, i), Self::slip(&rates, i));
            let shrinks = slip[0] * rate[0] + slip[1] * rate[1] <= T::zero();
            if shrinks && size(slip) <= self.nothing() {
                self.slips[i] = false;
                state[OF_RUB * i] = T::zero();
                state[OF_RUB * i + 1] = T::zero();
            }
        }
        let (rates, phi) = self.rates(state);
        let begins: Vec<usize> = (0..self.rubs.len())
            .filter(|i| {
                let jumps = size(Self::slip(&rates, *i)) > self.rubs[*i].pull * T::lift(CREEPS);
                let crept = size(Self::slip(state, *i)) > self.creeps();
                !self.slips[*i] && (jumps || crept)
            })
            .collect();
        if !begins.is_empty() {
            let kick = phi * T::lift(KICK * T::ULP.sqrt());
            for (x, rate) in state.iter_mut().zip(&rates) {
                *x += *rate * kick;
            }
            for i in begins {
                self.slips[i] = true;
            }
        }
    }

    /// Follows the path to its end.
    fn run(mut self, mut state: Vec<T>, mass: &[T], unit: T) -> Option<Rubbed<T>> {
        let mut error = 0.0;
        // of the slowed clock, and of tau where a slip follows the forces
        let mut lengths = [T::lift(0.5), T::lift(1e-3)];
        let mut restores = false;
        for _ in 0..MOST_STEPS {
            self.change_modes(&mut state);
            let follows = self.follows(&state);
            let stiff = follows.is_some();
            let length = &mut lengths[usize::from(stiff)];
            *length = length.at_most(follows.unwrap_or(*length));
            let Some((end, off, spare)) = self.step(&state, *length, stiff) else {
                *length /= T::lift(2.0);
                continue;
            };
            error += off + self.crept(&state, &end);
            let reached = |state: &[T], restores: bool| match restores {
                true => self.work(state),
                false => self.power(state),
            };
            if reached(&end, restores) >= T::zero() {
                let within = (*length, stiff);
                let Some(landed) = self.land(&state, within, |state| reached(state, restores))
                else {
                    *length /= T::lift(2.0);
                    continue;
                };
                state = landed;
                if restores || self.work(&state) >= T::zero() {
                    return Some(self.finish(&state, mass, unit, error));
                }
                restores = true;
                continue;
            }
            state = end;
            if state[self.tail() + 2] > T::lift(MOST_TAU) {
                return None;
            }
            if spare > 1 {
                *length = (*length * T::lift(1.5)).at_most(T::lift(LONGEST));
            }
        }
        None
    }

    /// The state at which `reached`, negative at `start`, vanishes within a step: by the false position, and halves where that is slow. `None`
    /// where a shorter step is not as good as the whole one.
    fn land(
        &self,
        start: &[T],
        (length, stiff): (T, bool),
        reached: impl Fn(&[T]) -> T,
    ) -> Option<Vec<T>> {
        let mut low = (T::zero(), reached(start));
        let (mut high, mut next) = (None, length);
        let mut last_sign = 0;
        for _ in 0..MOST_TRIALS {
            let (state, ..) = self.step(start, next, stiff)?;
            let value = reached(&state);
            let sign = if value >= T::zero() { 1 } else { -1 };
            // the end that stays counts half (Illinois)
            if sign > 0 {
                high = Some((next, value));
                if last_sign > 0 {
                    low.1 /= T::lift(2.0);
                }
            } else {
                low = (next, value);
                if let (true, Some((_, value))) = (last_sign < 0, &mut high) {
                    *value /= T::lift(2.0);
                }
            }
            last_sign = sign;
            let (top, above) = high?;
            let width = top - low.0;
            if value.abs() <= T::lift(T::ULP / 4.0) || width <= top * T::lift(T::ULP) {
                return Some(state);
            }
            next = low.0 - low.1 * width / (above - low.1);
        }
        None
    }

    fn finish(&self, state: &[T], mass: &[T], unit: T, error: f64) -> Rubbed<T> {
        let mut impulses = (0..self.rubs.len()).map(|i| [2, 3].map(|c| state[OF_RUB * i + c]));
        let tangential = self.pushes.iter().map(|push| {
            let rubs = push.mu > T::zero();
            match push.constraint.second.filter(|_| rubs) {
                None => [T::zero(); 2],
                Some((b, _)) => {
                    let a = push.constraint.first.0;
                    let reduced = mass[a] * mass[b] / (mass[a] + mass[b]);
                    let of = impulses.next().unwrap_or([T::zero(); 2]);
                    of.map(|impulse| impulse * reduced * unit)
                }
            }
        });
        Rubbed {
            tangential: tangential.collect(),
            part: state[self.tail() + 2],
            error: error * unit.to_f64(),
        }
    }
}

impl<T: Real> Rub<T> {
    /// Adds what a force does to both balls.
    fn push(&self, [across, up]: [T; 2], pulls: &mut [Pull<T>]) {
        let mut sign = T::one();
        for (ball, share) in self.members {
            let pull = &mut pulls[ball];
            let turn = T::lift(2.5) * share;
            pull[0] += sign * share * across * self.left[0];
            pull[1] += sign * share * across * self.left[1];
            pull[2] += sign * share * up;
            pull[3] -= turn * up * self.left[0];
            pull[4] -= turn * up * self.left[1];
            pull[5] += turn * across;
            sign = -sign;
        }
    }

    /// Change of the slip when balls change so: across the normal, and up.
    fn slip_rate(&self, pulls: &[Pull<T>]) -> [T; 2] {
        let [(a, _), (b, _)] = self.members;
        let (one, two) = (&pulls[a], &pulls[b]);
        let left = |x: T, y: T| x * self.left[0] + y * self.left[1];
        [
            left(one[0] - two[0], one[1] - two[1]) + one[5] + two[5],
            one[2] - two[2] - left(one[3] + two[3], one[4] + two[4]),
        ]
    }
}
