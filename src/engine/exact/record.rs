//! What a run writes down of an impact: rows, both sides, and the extrema.

use super::impact::Party;
use super::solve::Loop;
use crate::math::Real;
use crate::physics::invariants::{kinetic_energy, momentum};
use crate::physics::{Side, State};
use crate::trace::EventKind;

impl<T: Real> Loop<'_, T> {
    fn both(&self, side: &Party<T>) -> (State, State) {
        (
            self.solver.state(side.ball, side.position, side.before),
            self.solver.state(side.ball, side.position, side.after),
        )
    }

    /// An impact of two balls, whose centres were `apart`.
    pub fn record_pair(&mut self, one: &Party<T>, other: &Party<T>, apart: T) {
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
        let energy = |state: &State, mass: f64| kinetic_energy(state, mass, None);
        let gained = (energy(&a1, ma) - energy(&a0, ma)) + (energy(&b1, mb) - energy(&b0, mb));
        self.recorder.energy_change(time, gained, a, Some(b));
        let change =
            (momentum(&a1, ma) - momentum(&a0, ma)) + (momentum(&b1, mb) - momentum(&b0, mb));
        self.recorder.momentum_error(time, change.norm(), a, b);
        let overlap = self.solver.world.distance(a, b) - apart;
        self.recorder.overlap(time, overlap.to_f64(), a, b);
        self.record_stop(one, time);
        self.record_stop(other, time);
    }

    /// An impact on a cushion.
    pub fn record_cushion(&mut self, one: &Party<T>, side: Side) {
        let a = one.ball;
        let time = self.now.to_f64();
        let (before, after) = self.both(one);
        self.count_event();
        self.counts.ball_cushion += 1;
        let kind = EventKind::BallCushion(a as u32, side);
        let event = self.recorder.event(time, kind, Some(1));
        self.recorder.jump(a, time, &before, &after, event);
        let mass = self.solver.scene.balls[a].mass;
        let gained = kinetic_energy(&after, mass, None) - kinetic_energy(&before, mass, None);
        self.recorder.energy_change(time, gained, a, None);
        let beyond = one.position[side.axis()] - self.solver.world.reach[a][side as usize];
        let beyond = if side.sign() < 0 { -beyond } else { beyond };
        self.recorder.outside(time, beyond.to_f64(), a);
        self.record_stop(one, time);
    }

    /// A moving ball that an impact brought to rest.
    fn record_stop(&mut self, side: &Party<T>, time: f64) {
        let zero = [T::zero(); 2];
        if side.flight.moves() && side.before != zero && side.after == zero {
            let at_rest = self.solver.state(side.ball, side.position, zero);
            self.count_event();
            self.recorder.stop(side.ball, time, &at_rest, &at_rest);
        }
    }
}
