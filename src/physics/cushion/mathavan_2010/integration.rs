//! The impact integrated over its normal impulse, each step in one pair of modes.

use super::super::nose;
use super::contacts::{CLOTH, Contacts, Mode, NOSE, State, WORK, dot, length};
use crate::math::extrapolation::{Step, step};
use crate::math::{Real, worse};

/// How well an impact is integrated. Lengths of slips, steps and errors are in units of the ball's speed, within a factor of 2.
#[derive(Clone, Copy, Debug)]
pub struct Accuracy {
    /// Error of one step of the integration.
    pub step: f64,
    /// Rounding of one step: the sizes of the extrapolation's weights add up to 119, and its row to sixteen substeps.
    pub rounding: f64,
    /// A slip below this has ended.
    pub ended: f64,
    /// A slip that began has a direction of its own above this. Below it the direction is that of the forces with a lag of
    /// first order, so what is neglected goes with the square.
    pub creep: f64,
    /// The lag of that direction above which it has one of its own, too; rad.
    pub lag: f64,
    /// Impulse within which the moment is found at which friction no longer holds; the forces are continuous there.
    pub leave: f64,
}

impl Accuracy {
    /// What f64 can do.
    pub const F64: Accuracy = Accuracy {
        step: 1e-12,
        rounding: 2e-14,
        ended: 1e-11,
        creep: 1e-5,
        lag: 1e-4,
        leave: 1e-8,
    };
}

/// A speed into the cushion smaller than this, in units of the ball's largest speed, is not integrated: it is about what a slip may
/// be and count as none, and its work, which goes with the square, may be none that a number holds.
const SLOW: f64 = 1e-9;

/// Largest impulse, in units of the ball's speed, over which forces and speeds are taken to stay the same: the work is off by its square.
const BRIEF: f64 = 1e-6;

/// A ball that slows down to this speed while it leaves the cushion is held by it, in units of the ball's speed.
const STALLED: f64 = 1e-9;

/// A slip counts as ending when it would end within this many times the impulse to the goal.
const SOON: f64 = 4.0;

/// A clock that goes by what is left of a slip is good to a rounding in that slip. Where next to no friction takes longer than so many slips to end one, a step by such
/// a clock would not be good enough; but there the slip hardly turns.
const CLOCKED: f64 = 4096.0;

/// Part of a slip that ends to which its last steps are resolved.
const RESOLVED: f64 = 1e-2;

/// How much longer each step after the beginning of a slip may be.
const GROWTH: f64 = 3.0;

/// Longest step in units of the impulse to the end of a slip, which the clock of that slip stretches.
const LONGEST: f64 = 3.0;

/// Part of the impulse to the moment at which friction no longer holds that a step covers; the moment is estimated by a straight line.
const CAUTION: f64 = 0.95;

/// By how much the error of a step may have grown at the end of the impact: slips shrink under friction, but each contact moves the
/// other's, and an end that comes too late adds what the forces do meanwhile.
const GAIN: f64 = 16.0;

/// Steps after which a slip that is small and follows the forces is taken to creep: an explicit integration would follow it for ever.
const STIFF: usize = 200;

/// More steps than any impact takes; past them the result is not a number, which every engine notices.
const MOST_STEPS: usize = 20_000;

/// Velocity and spin times radius after the impact, and what they may be off by, length/s.
///
/// `numbers`: as of the law. `start`: velocity x and y, spin times radius x, y and z, with x into the cushion.
pub fn rebound<T: Real>(numbers: [T; 4], start: [T; 5], accuracy: Accuracy) -> ([T; 5], f64) {
    let sizes = start.iter().map(|x| x.abs().to_f64());
    let size = sizes.fold(0.0, worse);
    if start[0] <= T::zero() || !size.is_finite() {
        return (start, 0.0);
    }
    let [e, mu, mu_cloth, height] = numbers;
    let (sin, cos) = nose(height);
    // the law is of the first degree in the speeds: a power of two brings them near 1 without rounding
    // (powers below this have no reciprocal)
    let unit = 2.0_f64.powi((size.log2().floor() as i32).max(-1000));
    let [vx, vy, sx, sy, sz] = start.map(|x| x / T::lift(unit));
    let mut run = Integration {
        contacts: Contacts {
            mu: [mu, mu_cloth],
            sin,
            cos,
        },
        accuracy,
        state: [vx, vy, sx, sy, sz, T::zero()],
        modes: [Mode::Slips; 2],
        error: 0.0,
        steps: 0,
    };
    run.begin();
    if let Some(end) = run.brief(e) {
        return (end.map(|x| x * T::lift(unit)), GAIN * run.error * unit);
    }
    let mut finished = run.until(Goal::Stopped);
    let returned = run.state[WORK] * e * e;
    run.state[WORK] = T::zero();
    if returned > T::zero() {
        run.begin();
        finished = finished && run.until(Goal::Returned(returned));
    }
    if !finished {
        return ([T::lift(f64::NAN); 5], f64::NAN);
    }
    let [vx, vy, sx, sy, sz, _] = run.state;
    (
        [vx, vy, sx, sy, sz].map(|x| x * T::lift(unit)),
        GAIN * run.error * unit,
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

/// A step that is about to be tried.
struct Plan {
    /// Impulse to what is nearest: the goal, or the end of a slip.
    near: f64,
    /// Its length.
    impulse: f64,
    /// The contact whose slip ends in it.
    ends: Option<usize>,
    /// Whether it ends on the goal.
    lands: bool,
}

/// How far the next step goes.
struct Pacing {
    /// Its length as a share of what is nearest: the goal, or the end of a slip.
    share: f64,
    /// Whether the last one went past the goal.
    overshot: bool,
    /// Impulse at which friction will no longer hold, once that is known.
    edge: f64,
    /// Its length after a slip has begun: where there is a slip at all, its direction is smooth over a multiple of the impulse since it
    /// began.
    reach: f64,
}

impl Pacing {
    fn new() -> Self {
        Pacing {
            share: 1.0,
            overshot: false,
            edge: f64::INFINITY,
            reach: f64::INFINITY,
        }
    }

    /// After a step that was not taken.
    fn shorten(&mut self, plan: &Plan) {
        self.share = 0.3 * plan.impulse / plan.near;
        self.overshot = false;
    }

    /// After one that was, by an extrapolation with so many `rows`; `creeps`: whether a contact creeps.
    fn go_on(&mut self, plan: &Plan, rows: usize, creeps: bool) {
        self.share = match rows {
            ..=5 => f64::min(2.0 * self.share, LONGEST),
            6 => self.share,
            _ => 0.8 * self.share,
        };
        self.reach = if creeps {
            GROWTH * plan.impulse
        } else if self.reach < plan.near {
            GROWTH * self.reach
        } else {
            f64::INFINITY
        };
    }
}

/// An impact on its way.
struct Integration<T> {
    contacts: Contacts<T>,
    accuracy: Accuracy,
    state: State<T>,
    modes: [Mode; 2],
    /// Sum of the errors of all steps.
    error: f64,
    steps: usize,
}

impl<T: Real> Integration<T> {
    fn speed(&self, contact: usize) -> f64 {
        length(self.contacts.slip(contact, &self.state)).to_f64()
    }

    fn margin(&self) -> f64 {
        let directions = self.contacts.directions(&self.state, &self.modes);
        self.contacts.margin(&directions)
    }

    /// Looks for contacts at rest, as at the beginning of each half.
    fn begin(&mut self) {
        let at_rest = [NOSE, CLOTH].map(|contact| self.speed(contact) <= self.accuracy.ended);
        for contact in [NOSE, CLOTH] {
            if at_rest[contact] {
                self.still(contact);
            }
        }
        self.choose(at_rest);
    }

    /// Chooses the modes of the contacts that are at rest; the others go on slipping.
    fn choose(&mut self, at_rest: [bool; 2]) {
        for sticks in [[true, true], [true, false], [false, true], [false, false]] {
            if (0..2).any(|contact| sticks[contact] && !at_rest[contact]) {
                continue;
            }
            let modes = [NOSE, CLOTH].map(|contact| match at_rest[contact] {
                _ if sticks[contact] => Mode::Sticks,
                true => Mode::Creeps,
                false => self.modes[contact],
            });
            let directions = self.contacts.directions(&self.state, &modes);
            if sticks == [false; 2] || self.contacts.margin(&directions) >= 0.0 {
                self.modes = modes;
                return;
            }
        }
    }

    /// What an impact leaves that is too slow to be integrated, as if its forces stayed the same, which makes the restitution of work one
    /// of speed; `None` if it is fast enough, or takes long.
    fn brief(&mut self, e: T) -> Option<[T; 5]> {
        let [vx, vy, sx, sy, sz, _] = self.state;
        if vx.to_f64() >= SLOW {
            return None;
        }
        self.error += vx.abs().to_f64();
        let rates = self.contacts.rates(&self.state, &self.modes);
        if self.modes == [Mode::Sticks; 2] || rates[0] >= T::zero() {
            // held between nose and cloth
            return Some([T::zero(), vy, sx, sy, sz]);
        }
        let impulse = -(vx * (T::one() + e)) / rates[0];
        (impulse.to_f64() < BRIEF).then(|| {
            let [_, y, x_spin, y_spin, z_spin, _] = rates.map(|rate| rate * impulse);
            [-(e * vx), vy + y, sx + x_spin, sy + y_spin, sz + z_spin]
        })
    }

    /// Goes on until `goal` is reached; false if that takes too many steps.
    fn until(&mut self, goal: Goal<T>) -> bool {
        let mut pacing = Pacing::new();
        while self.steps < MOST_STEPS {
            self.steps += 1;
            // what was left of a slip may have been taken away beyond the goal
            if is_past(goal, &self.state) {
                if let Goal::Stopped = goal {
                    self.halt();
                }
                return true;
            }
            let rates = self.contacts.rates(&self.state, &self.modes);
            if self.is_wedged(goal, &rates) {
                self.halt();
                return true;
            }
            let plan = self.plan(goal, &rates, &pacing);
            if self.attempt(goal, &plan, &mut pacing) {
                return true;
            }
        }
        false
    }

    /// What is left of the speed into the cushion is error.
    fn halt(&mut self) {
        self.error += self.state[0].abs().to_f64();
        self.state[0] = T::zero();
    }

    /// The next step.
    fn plan(&self, goal: Goal<T>, rates: &State<T>, pacing: &Pacing) -> Plan {
        let far = self.impulse_to(goal, rates);
        let to_rest = [NOSE, CLOTH].map(|contact| self.impulse_to_rest(contact, rates));
        // the slip that ends first, if that is soon
        let sooner =
            to_rest[NOSE].unwrap_or(f64::INFINITY) <= to_rest[CLOTH].unwrap_or(f64::INFINITY);
        let first = if sooner { NOSE } else { CLOTH };
        let ending = to_rest[first]
            .filter(|impulse| *impulse < SOON * far && self.modes[first] == Mode::Slips);
        let weak = ending.is_some_and(|impulse| impulse > CLOCKED * self.speed(first));
        let ends = ending.filter(|_| !weak).map(|_| first);
        let creep = [NOSE, CLOTH].map(|contact| self.impulse_of_creep(contact, rates));
        let near = to_rest.iter().chain(&creep).flatten();
        let near = near.copied().fold(far, f64::min);
        let share = if ends.is_some() {
            pacing.share
        } else {
            pacing.share.min(1.0)
        };
        let impulse = (share * near).min(pacing.edge).min(pacing.reach);
        Plan {
            near,
            impulse,
            ends,
            lands: pacing.overshot
                || (impulse >= near && ends.is_none() && !(weak && near < far) && self.sees(goal)),
        }
    }

    /// Tries a step, and takes it or has it tried shorter; true if it reached `goal`.
    fn attempt(&mut self, goal: Goal<T>, plan: &Plan, pacing: &mut Pacing) -> bool {
        let impulse = plan.impulse;
        let taken = if plan.lands {
            self.land(goal)
        } else {
            self.advance(impulse, plan.ends)
        };
        let Some(taken) = taken else {
            pacing.shorten(plan);
            return false;
        };
        if !plan.lands && is_past(goal, &taken.end) {
            pacing.overshot = true;
            return false;
        }
        let (before, held) = (self.state, self.margin());
        self.state = taken.end;
        let holds = self.margin();
        if holds < 0.0 && impulse > self.accuracy.leave {
            self.state = before;
            let part = f64::max(held, 0.0) / (f64::max(held, 0.0) - holds);
            pacing.edge = f64::max(CAUTION * part * impulse, self.accuracy.leave);
            pacing.overshot = false;
            return false;
        }
        if [NOSE, CLOTH]
            .into_iter()
            .any(|contact| self.crept(contact, 2.0))
            || self.turned_back(&before)
        {
            self.state = before;
            pacing.shorten(plan);
            return false;
        }
        self.error += taken.error
            + self.accuracy.rounding
            + self.lags().map(|lag| lag * lag).iter().sum::<f64>() * impulse;
        if plan.lands {
            return true;
        }
        let slope = (held - holds) / impulse;
        pacing.edge = if pacing.edge.is_finite() && holds >= 0.0 && slope > 0.0 {
            f64::max(CAUTION * holds / slope, self.accuracy.leave)
        } else {
            f64::INFINITY
        };
        pacing.go_on(plan, taken.rows, self.modes.contains(&Mode::Creeps));
        self.change_modes(plan.ends);
        false
    }

    /// One step over the normal impulse `impulse`. A slip that ends slows the clock, so that its last part, in which its direction
    /// turns ever faster, is as smooth as the first.
    fn advance(&self, impulse: f64, ends: Option<usize>) -> Option<Step<[T; 6]>> {
        let start = &self.state;
        let Some(contact) = ends else {
            let rate = |state: &State<T>| self.contacts.rates(state, &self.modes);
            return step(rate, start, T::lift(impulse), self.accuracy.step);
        };
        let speed = |state: &State<T>| length(self.contacts.slip(contact, state));
        let now = speed(start);
        let rate = |state: &State<T>| {
            let pace = speed(state) / now;
            self.contacts
                .rates(state, &self.modes)
                .map(|rate| rate * pace)
        };
        let resolved = RESOLVED * now.to_f64();
        step(
            rate,
            start,
            T::lift(impulse),
            self.accuracy.step.min(resolved),
        )
    }

    /// One step to the goal, by what the goal is a value of: so it ends there exactly, derivatives included (Henon 1982).
    fn land(&self, goal: Goal<T>) -> Option<Step<[T; 6]>> {
        let length = match goal {
            Goal::Stopped => self.state[0],
            Goal::Returned(work) => work - self.state[WORK],
        };
        let rate = |state: &State<T>| {
            let rates = self.contacts.rates(state, &self.modes);
            let pace = match goal {
                Goal::Stopped => -rates[0],
                Goal::Returned(_) => rates[WORK],
            };
            rates.map(|rate| rate / pace)
        };
        step(rate, &self.state, length, self.accuracy.step)
    }

    /// Whether the ball is held between nose and cloth. Where both contacts stick it does not move across and no impulse moves it;
    /// it comes near that when friction takes all that restitution would return.
    fn is_wedged(&self, goal: Goal<T>, rates: &State<T>) -> bool {
        let sticks = self.modes == [Mode::Sticks; 2];
        let stalls = match goal {
            Goal::Stopped => false,
            Goal::Returned(_) => {
                let slow = -self.state[0].to_f64() <= STALLED;
                self.state[WORK] > T::zero() && slow && rates[0] > T::zero()
            }
        };
        sticks || stalls
    }

    /// Normal impulse to the goal at the present rates.
    fn impulse_to(&self, goal: Goal<T>, rates: &State<T>) -> f64 {
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
    fn impulse_to_rest(&self, contact: usize, rates: &State<T>) -> Option<f64> {
        let slips = self.modes[contact] != Mode::Sticks;
        let rubs = self.contacts.mu[contact] > T::zero();
        if !slips || !rubs || self.speed(contact) <= self.accuracy.ended {
            return None;
        }
        let [slip, rate] = [&self.state, rates].map(|of| self.contacts.slip(contact, of));
        let closing = -dot(slip, rate);
        (closing > T::zero()).then(|| (dot(slip, slip) / closing).to_f64())
    }

    /// Normal impulse over which a creeping contact may creep, at the present rates; `None` for the others.
    fn impulse_of_creep(&self, contact: usize, rates: &State<T>) -> Option<f64> {
        if self.modes[contact] != Mode::Creeps {
            return None;
        }
        let rate = length(self.contacts.slip(contact, rates)).to_f64();
        Some((1.5 * self.accuracy.creep / rate).min(1.0))
    }

    /// Whether a slip turned by more than a right angle since `before`. No rate is evaluated at the end of a step, so a slip that is
    /// reversed there would not be noticed otherwise.
    fn turned_back(&self, before: &State<T>) -> bool {
        [NOSE, CLOTH].into_iter().any(|contact| {
            let [now, then] = [&self.state, before].map(|of| self.contacts.slip(contact, of));
            self.modes[contact] != Mode::Sticks
                && self.contacts.mu[contact] > T::zero()
                && length(now).to_f64() > self.accuracy.ended
                && dot(now, then) < T::zero()
        })
    }

    /// Lag of each creeping contact.
    fn lags(&self) -> [f64; 2] {
        if !self.modes.contains(&Mode::Creeps) {
            return [0.0; 2];
        }
        let asked = self.contacts.settled(&self.state, &self.modes);
        let lags = self.contacts.lags(&self.state, &self.modes, &asked);
        lags.map(|lag| lag.abs().to_f64())
    }

    /// Whether a creeping contact is beyond `share` of the slip or of the lag up to which it may creep.
    fn crept(&self, contact: usize, share: f64) -> bool {
        self.modes[contact] == Mode::Creeps
            && (self.speed(contact) > share * self.accuracy.creep
                || self.lags()[contact] > share * self.accuracy.lag)
    }

    /// Whether a slip is small and turns with the forces as a creeping one does.
    fn follows(&self, contact: usize) -> bool {
        let mut creeping = Integration {
            modes: self.modes,
            ..*self
        };
        creeping.modes[contact] = Mode::Creeps;
        let asked = creeping.contacts.directions(&self.state, &creeping.modes);
        let slip = self.contacts.slip(contact, &self.state);
        let along = asked[contact].map_or(T::zero(), |direction| dot(direction, slip));
        let across = dot(slip, slip) - along * along;
        let apart = across.to_f64().max(0.0).sqrt() / self.speed(contact);
        along > T::zero() && apart < self.accuracy.lag && !creeping.crept(contact, 0.5)
    }

    /// Ends the slips that have become as good as zero, lets go what friction cannot hold, and sees creeping slips off.
    /// `ends`: the slip that was about to end.
    fn change_modes(&mut self, ends: Option<usize>) {
        let mut at_rest = [false; 2];
        let mut changes = self.margin() < 0.0;
        let rates = self.contacts.rates(&self.state, &self.modes);
        for contact in [NOSE, CLOTH] {
            let speed = self.speed(contact);
            let [slip, rate] = [&self.state, &rates].map(|of| self.contacts.slip(contact, of));
            let closing = dot(slip, rate) < T::zero();
            let rubs = self.contacts.mu[contact] > T::zero();
            match self.modes[contact] {
                Mode::Sticks => at_rest[contact] = true,
                Mode::Creeps if self.crept(contact, 1.0) => {
                    self.modes[contact] = Mode::Slips;
                }
                Mode::Slips if self.steps > STIFF && rubs && self.follows(contact) => {
                    self.modes[contact] = Mode::Creeps;
                }
                Mode::Creeps | Mode::Slips => {
                    if rubs && (closing || ends == Some(contact)) && speed <= self.accuracy.ended {
                        self.arrive(contact);
                        at_rest[contact] = true;
                        changes = true;
                    }
                }
            }
        }
        if changes {
            self.choose(at_rest);
        }
    }

    /// Takes away what is left of a slip: at the present rates as far as they do it at once, then by force. Weak friction takes long to
    /// end even such a slip, and over a long impulse the work is not that of the present speed.
    fn arrive(&mut self, contact: usize) {
        self.error += self.speed(contact);
        let rates = self.contacts.rates(&self.state, &self.modes);
        let [slip, rate] = [&self.state, &rates].map(|of| self.contacts.slip(contact, of));
        let closing = -dot(slip, rate);
        if closing > T::zero() {
            let impulse = dot(slip, slip) / closing;
            if impulse.to_f64() < BRIEF {
                self.state = std::array::from_fn(|i| self.state[i] + rates[i] * impulse);
            }
        }
        self.still(contact);
    }

    /// Takes away a slip that is as good as zero, by friction at that contact alone.
    fn still(&mut self, contact: usize) {
        self.error += self.speed(contact);
        let left = self.contacts.slip(contact, &self.state);
        for (value, push) in self
            .state
            .iter_mut()
            .zip(self.contacts.undoing(contact, left))
        {
            *value += push;
        }
    }
}

/// Whether a step went beyond the goal.
fn is_past<T: Real>(goal: Goal<T>, state: &State<T>) -> bool {
    match goal {
        Goal::Stopped => state[0] < T::zero(),
        Goal::Returned(work) => state[WORK] > work,
    }
}

#[cfg(test)]
mod tests;
