//! What ends a phase besides an impact, as a value: a ball stops, begins to roll, or has spun down.

use super::flight::Phase;
use super::kinematics::{Course, Kinematics};
use super::spin::{Moving, Spin, Turn};
use crate::math::Real;
use crate::physics::State;

/// What happens to a ball whose phase ends now.
#[derive(Clone, Debug)]
pub struct PhaseEnd<T> {
    /// Index in scene order.
    pub ball: usize,
    /// How it goes on.
    pub course: Course<T>,
    /// Its near side.
    pub before: State,
    /// Its far side.
    pub after: State,
    /// Its spin about the vertical ends.
    pub unspun: bool,
    /// It begins to roll.
    pub rolls: bool,
    /// Its centre comes to rest.
    pub stops: bool,
}

impl<T: Real> PhaseEnd<T> {
    /// The end of the phase of `ball`, which is now.
    #[inline]
    pub fn of(balls: &Kinematics<'_, T>, ball: usize) -> Self {
        if balls.rotates() {
            PhaseEnd::turning(balls, ball)
        } else {
            PhaseEnd::sliding(balls, ball)
        }
    }

    /// The centre of a ball that does not turn comes to rest.
    #[inline]
    fn sliding(balls: &Kinematics<'_, T>, ball: usize) -> Self {
        let was = balls.flight(ball);
        let position = match was.phase {
            Phase::Slide => was.rest_position(),
            Phase::Free | Phase::Rest | Phase::Curve | Phase::Held => balls.place(ball),
        };
        let at_rest = Moving {
            position,
            velocity: [T::zero(); 2],
            spin: [T::zero(); 3],
        };
        let state = balls.state(ball, position, at_rest.velocity, at_rest.spin);
        PhaseEnd {
            ball,
            course: balls.course(ball, at_rest),
            before: state,
            after: state,
            unspun: false,
            rolls: false,
            stops: true,
        }
    }

    /// The phase of a ball that turns ends: it rolls, stops, or has no spin about the vertical any more.
    #[cold]
    #[inline(never)]
    fn turning(balls: &Kinematics<'_, T>, ball: usize) -> Self {
        let was = balls.course_of(ball);
        let spin = was.spin.unwrap_or_else(Spin::none);
        let next = match &balls.world().rotation {
            Some(rotation) => rotation.turned(balls.world().radius[ball], &was.flight, &spin),
            // as it is, where nothing turns
            None => balls.moving(ball),
        };
        let (_, velocity) = balls.at(ball);
        let course = balls.course(ball, next);
        let slides = course.spin.as_ref().is_some_and(|spin| spin.slides);
        let stops = was.flight.moves() && !course.flight.moves();
        PhaseEnd {
            ball,
            before: balls.state(ball, next.position, velocity, balls.spin_now(ball)),
            after: balls.state(ball, next.position, next.velocity, next.spin),
            unspun: spin.turn == Turn::Unspun,
            rolls: spin.slides && !slides && !stops,
            stops,
            course,
        }
    }
}
