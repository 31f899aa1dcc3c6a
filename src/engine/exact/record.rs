//! What a run writes down of an impact: rows, both sides, and the extrema.

use super::impact::Party;
use super::solve::Loop;
use crate::math::Real;
use crate::physics::invariants::{kinetic_energy, momentum};
use crate::physics::{Side, State};
use crate::trace::EventKind;

impl<T: Real> Loop<'_, T> {
    fn both(&self, side: &Party<T>) -> (State, State) {
        let [before, after] = self.spins_of(side.ball);
        let solver = &self.solver;
        (
            solver.state_with(side.ball, side.position, side.before, before),
            solver.state_with(side.ball, side.position, side.after, after),
        )
    }

    /// An impact of two balls, whose centres were `apart`.
    pub fn record_pair(&mut self, one: &Party<T>, other: &Party<T>, apart: T) {
        let gained = self.gain(one) + self.gain(other);
        let time = self.now.to_f64();
        self.recorder
            .energy_change(time, gained, one.ball, Some(other.ball));
        self.record_exchange(one, other, apart);
        self.record_stop(one, one.flight.moves());
        self.record_stop(other, other.flight.moves());
    }

    /// An impact on a cushion.
    pub fn record_cushion(&mut self, one: &Party<T>, side: Side) {
        let gained = self.gain(one);
        self.recorder
            .energy_change(self.now.to_f64(), gained, one.ball, None);
        self.record_edge(one, side);
        self.record_stop(one, one.flight.moves());
    }

    /// The energy of an instant at which several contacts were resolved together, booked as one change.
    pub fn record_shock_energy(&mut self, parties: &[Party<T>]) {
        let gained: f64 = parties.iter().map(|party| self.gain(party)).sum();
        if let Some(first) = parties.first() {
            self.recorder
                .energy_change(self.now.to_f64(), gained, first.ball, None);
        }
    }

    /// One contact of two balls out of several at this instant: all but energy and stops.
    pub fn record_contact(&mut self, one: &Party<T>, other: &Party<T>) {
        let x = other.position[0] - one.position[0];
        let y = other.position[1] - one.position[1];
        self.record_exchange(one, other, (x * x + y * y).sqrt());
    }

    /// A ball that an instant with several contacts brought to rest.
    pub fn record_rest(&mut self, side: &Party<T>) {
        self.record_stop(side, true);
    }

    fn record_exchange(&mut self, one: &Party<T>, other: &Party<T>, apart: T) {
        let (a, b) = (one.ball, other.ball);
        let time = self.now.to_f64();
        let ((a0, a1), (b0, b1)) = (self.both(one), self.both(other));
        self.count_event();
        self.counts.ball_ball += 1;
        let event = self
            .recorder
            .event(time, EventKind::ball_ball(a, b), Some(1));
        self.recorder.jump(a, time, &a0, &a1, event);
        self.recorder.jump(b, time, &b0, &b1, event);
        let (ma, mb) = (
            self.solver.scene.balls[a].mass,
            self.solver.scene.balls[b].mass,
        );
        let change =
            (momentum(&a1, ma) - momentum(&a0, ma)) + (momentum(&b1, mb) - momentum(&b0, mb));
        self.recorder.momentum_error(time, change.norm(), a, b);
        let overlap = self.solver.world.distance(a, b) - apart;
        self.recorder.overlap(time, overlap.to_f64(), a, b);
    }

    /// An impact on a cushion: all but energy and stops.
    pub fn record_edge(&mut self, one: &Party<T>, side: Side) {
        let a = one.ball;
        let time = self.now.to_f64();
        let (before, after) = self.both(one);
        self.count_event();
        self.counts.ball_cushion += 1;
        let kind = EventKind::BallCushion(a as u32, side);
        let event = self.recorder.event(time, kind, Some(1));
        self.recorder.jump(a, time, &before, &after, event);
        let beyond = one.position[side.axis()] - self.solver.world.reach[a][side as usize];
        let beyond = if side.sign() < 0 { -beyond } else { beyond };
        self.recorder.outside(time, beyond.to_f64(), a);
    }

    /// Change of a ball's kinetic energy.
    fn gain(&self, side: &Party<T>) -> f64 {
        let mass = self.solver.scene.balls[side.ball].mass;
        if self.solver.spins.is_empty() {
            let energy = |velocity: [T; 2]| {
                let [x, y] = velocity.map(T::to_f64);
                0.5 * mass * (x * x + y * y)
            };
            return energy(side.after) - energy(side.before);
        }
        let (before, after) = self.both(side);
        let inertia = self.solver.scene.inertia(side.ball);
        kinetic_energy(&after, mass, inertia) - kinetic_energy(&before, mass, inertia)
    }

    /// A ball that an impact brought to rest, if it `moved` before.
    fn record_stop(&mut self, side: &Party<T>, moved: bool) {
        let zero = [T::zero(); 2];
        if moved && side.before != zero && side.after == zero {
            let time = self.now.to_f64();
            let at_rest = self.solver.state(side.ball, side.position, zero, self.now);
            self.count_event();
            self.recorder.stop(side.ball, time, &at_rest, &at_rest);
        }
    }
}
