//! What ends a flight besides an impact: a ball stops, begins to roll, has spun down, or falls into a pocket.

use super::flight::{Flight, Phase};
use super::queue::Candidate;
use super::solve::Loop;
use super::spin::{Moving, Spin, Turn};
use crate::math::Real;
use crate::trace::{Ending, EventKind};

impl<T: Real> Loop<'_, T> {
    /// The centre of a ball that does not turn comes to rest.
    #[inline(never)]
    pub fn phase_end(&mut self, ball: usize) -> Option<Ending> {
        let flight = self.solver.flights[ball];
        let zero = [T::zero(); 2];
        let position = match flight.phase {
            Phase::Slide => flight.rest_position(),
            Phase::Free | Phase::Rest | Phase::Curve => flight.at(self.now).0,
        };
        self.solver.flights[ball] = Flight::new(self.solver.world.ground, self.now, position, zero);
        self.versions[ball] = self.versions[ball].wrapping_add(1);
        self.moving -= 1;
        self.count_event();
        let at_rest = self.solver.state(ball, position, zero, self.now);
        let time = self.now.to_f64();
        self.recorder.stop(ball, time, &at_rest, &at_rest);
        self.predict_after_stop(ball, &flight)
    }

    /// Predicts what comes after a stop, and whether something was within reach of it.
    fn predict_after_stop(&mut self, ball: usize, flight: &Flight<T>) -> Option<Ending> {
        self.notes.watch = Some(self.solver.world.blur.length);
        self.notes.near.clear();
        self.predict(ball, None);
        self.notes.watch = None;
        if self.notes.near.is_empty() {
            return None;
        }
        self.stop_in_doubt(ball, flight)
    }

    /// The phase of a ball that rotates ends: it rolls, stops, or has no spin about the vertical any more.
    #[cold]
    #[inline(never)]
    pub fn turn_end(&mut self, ball: usize) -> Option<Ending> {
        let rotation = self.solver.world.rotation?;
        let (flight, spin) = (self.solver.flights[ball], self.solver.spins[ball]);
        let radius = self.solver.world.radius[ball];
        let next = rotation.turned(radius, &flight, &spin);
        let before = self
            .solver
            .state(ball, next.position, flight.at(self.now).1, self.now);
        self.set_off(ball, next);
        let Moving {
            position,
            velocity,
            spin: turning,
        } = next;
        let after = self.solver.state_with(ball, position, velocity, turning);
        let time = self.now.to_f64();
        let stops = flight.moves() && !self.solver.flights[ball].moves();
        let slides = self.solver.spins[ball].slides;
        let mut near = &before;
        if spin.turn == Turn::Unspun {
            self.count_event();
            self.recorder
                .phase(ball, time, near, &after, EventKind::SpinEnd(ball as u32));
            // what else ends at this instant finds the ball on the far side
            near = &after;
        }
        if spin.slides && !slides && !stops {
            self.count_event();
            let rolls = EventKind::SlideToRoll(ball as u32);
            self.recorder.phase(ball, time, near, &after, rolls);
        }
        if !stops {
            self.predict(ball, None);
            return None;
        }
        self.count_event();
        self.recorder.stop(ball, time, near, &after);
        self.predict_after_stop(ball, &flight)
    }

    /// A ball leaves play.
    #[cold]
    #[inline(never)]
    pub fn pocket(&mut self, ball: usize, pocket: u32) -> Option<Ending> {
        let (position, velocity) = self.solver.flights[ball].at(self.now);
        let last = self.solver.state(ball, position, velocity, self.now);
        self.moving -= usize::from(self.solver.is_active(ball));
        // from here on it is nowhere, and nothing meets it
        let nowhere = [T::lift(f64::INFINITY); 2];
        let zero = T::zero();
        self.solver.flights[ball] = Flight {
            start: self.now,
            end: T::lift(f64::INFINITY),
            position: nowhere,
            velocity: [zero; 2],
            acceleration: [zero; 2],
            fastest: zero,
            phase: Phase::Rest,
        };
        if let Some(spin) = self.solver.spins.get_mut(ball) {
            *spin = Spin::none();
        }
        self.versions[ball] = self.versions[ball].wrapping_add(1);
        self.queue.set(ball, Candidate::none());
        self.count_event();
        self.recorder.pocket(ball, self.now.to_f64(), &last, pocket);
        None
    }

    /// Puts a ball that rotates on its way from here and now.
    pub fn set_off(&mut self, ball: usize, moving: Moving<T>) {
        let Some(rotation) = &self.solver.world.rotation else {
            return;
        };
        let radius = self.solver.world.radius[ball];
        let (flight, spin) = rotation.depart(radius, self.now, moving);
        self.moving -= usize::from(self.solver.is_active(ball));
        self.solver.flights[ball] = flight;
        self.solver.spins[ball] = spin;
        self.moving += usize::from(self.solver.is_active(ball));
        self.versions[ball] = self.versions[ball].wrapping_add(1);
    }
}
