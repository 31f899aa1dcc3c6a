//! An impact as a value: what its law makes of the balls that meet. Deciding it changes nothing; the event loop applies it, or does not.
//!
//! This is the cold side of the loop: it runs once an event and is never inlined into the search for the next one.

use super::encounter::Encounter;
use super::kinematics::{Course, Kinematics};
use super::spin::Moving;
use crate::math::Real;
use crate::physics::{Body, Contact, Cushion, Motion, Side, contact, cushion};
use crate::trace::{Ending, Spot};
use nalgebra::Vector3;

/// A velocity that an impact cancels down to this many ulps of what was cancelled is zero.
const CANCELLED: f64 = 8.0;

/// A ball that an event reaches now.
#[derive(Clone, Copy, Debug)]
pub struct Arrival<T> {
    ball: usize,
    moved: bool,
    position: [T; 2],
    velocity: [T; 2],
    spin: [T; 3],
}

impl<T: Real> Arrival<T> {
    /// A ball as it is now.
    #[inline]
    pub fn of(balls: &Kinematics<'_, T>, ball: usize) -> Self {
        let (position, velocity) = balls.at(ball);
        Arrival {
            ball,
            moved: balls.flight(ball).moves(),
            position,
            velocity,
            spin: balls.spin_now(ball),
        }
    }

    /// The ball on both sides of an impact that leaves it with another velocity and spin.
    #[inline]
    pub fn leaving(
        &self,
        balls: &Kinematics<'_, T>,
        velocity: [T; 2],
        spin: [T; 3],
    ) -> ImpactSide<T> {
        let far = Moving {
            position: self.position,
            velocity,
            spin,
        };
        ImpactSide {
            ball: self.ball,
            moved: self.moved,
            position: self.position,
            before: self.velocity,
            after: velocity,
            spin_before: self.spin,
            spin_after: spin,
            course: balls.course(self.ball, far),
        }
    }

    /// The same after the impact of a law.
    #[inline(always)]
    fn moved_by(&self, balls: &Kinematics<'_, T>, motion: &Motion<T>) -> ImpactSide<T> {
        let spin = if balls.rotates() {
            motion.spin.into()
        } else {
            self.spin
        };
        self.leaving(balls, settled(self.velocity, motion), spin)
    }

    #[inline]
    fn body(&self, balls: &Kinematics<'_, T>) -> Body<T> {
        Body {
            velocity: Vector3::new(self.velocity[0], self.velocity[1], T::zero()),
            spin: self.spin.into(),
            mass: balls.world().mass[self.ball],
            radius: balls.world().radius[self.ball],
        }
    }
}

/// A ball on both sides of an impact.
#[derive(Clone, Copy, Debug)]
pub struct ImpactSide<T> {
    /// Index in scene order.
    pub ball: usize,
    /// Whether its centre moved until now.
    pub moved: bool,
    /// Where it is.
    pub position: [T; 2],
    /// Velocity on the near side.
    pub before: [T; 2],
    /// Velocity on the far side.
    pub after: [T; 2],
    /// Angular velocity on the near side; zero in a scene that does not call for rotation.
    pub spin_before: [T; 3],
    /// Angular velocity on the far side.
    pub spin_after: [T; 3],
    /// The course on which it leaves.
    pub course: Course<T>,
}

impl<T: Real> ImpactSide<T> {
    /// True unless a number of the far side is none.
    #[inline]
    pub fn is_finite(&self) -> bool {
        (self.after[0] + self.after[1] + self.position[0] + self.position[1]).is_finite()
    }
}

/// What happens when `N` balls meet each other or a cushion, by the law of that impact alone.
#[derive(Clone, Copy, Debug)]
pub struct Impact<T, const N: usize> {
    /// Who meets whom.
    pub encounter: Encounter,
    /// The balls, in the order of the encounter.
    pub sides: [ImpactSide<T>; N],
    /// Speed at which they closed in, length/s.
    pub closing: T,
}

impl<T: Real> Impact<T, 2> {
    /// Two balls meet now, by `law`.
    #[inline(always)]
    pub fn of_balls(balls: &Kinematics<'_, T>, law: Contact<T>, a: usize, b: usize) -> Self {
        let (one, other) = (Arrival::of(balls, a), Arrival::of(balls, b));
        let x = other.position[0] - one.position[0];
        let y = other.position[1] - one.position[1];
        let apart = (x * x + y * y).sqrt();
        let n = Vector3::new(x / apart, y / apart, T::zero());
        let closing = (one.velocity[0] - other.velocity[0]) * n.x
            + (one.velocity[1] - other.velocity[1]) * n.y;
        let (first, second) = (one.body(balls), other.body(balls));
        let law = match law {
            // the same to the bit, with a number that has derivatives
            Contact::Elastic {} if T::DIFFERENTIATES => Contact::Inelastic {
                e: T::one() + balls.world().restitution[0],
            },
            law => law,
        };
        // balls that do not turn do not rub
        let friction = balls.world().friction.filter(|_| balls.rotates());
        let (motion, reaction) = contact::impact(law, friction, &first, &second, &n);
        Impact {
            encounter: Encounter::Pair(a, b),
            sides: [
                one.moved_by(balls, &motion),
                other.moved_by(balls, &reaction),
            ],
            closing,
        }
    }
}

impl<T: Real> Impact<T, 1> {
    /// A ball meets a cushion now, by `law`.
    #[inline(always)]
    pub fn on_cushion(balls: &Kinematics<'_, T>, law: Cushion<T>, a: usize, edge: Side) -> Self {
        let one = Arrival::of(balls, a);
        let law = match law {
            Cushion::Elastic {} if T::DIFFERENTIATES => Cushion::Restitution {
                e: T::one() + balls.world().restitution[1],
            },
            law => law,
        };
        let motion = cushion::impact(law, &one.body(balls), edge).motion;
        Impact {
            encounter: Encounter::Cushion(a, edge),
            sides: [one.moved_by(balls, &motion)],
            closing: one.velocity[edge.axis()].abs(),
        }
    }

    /// What the law of an impact on a cushion may be off by, length/s.
    pub fn error_on_cushion(
        balls: &Kinematics<'_, T>,
        law: Cushion<T>,
        a: usize,
        edge: Side,
    ) -> f64 {
        cushion::impact(law, &Arrival::of(balls, a).body(balls), edge).error
    }
}

impl<T: Real, const N: usize> Impact<T, N> {
    /// The ending of a run that this impact stops: its balls do not close in, or the law leaves no numbers.
    #[inline]
    pub fn fault(&self, balls: &Kinematics<'_, T>) -> Option<Ending> {
        let is_pair = matches!(self.encounter, Encounter::Pair(..));
        if is_pair && self.closing <= balls.world().blur.speed {
            let why = "they are pressed together without closing in: impacts follow each other without end";
            return Some(Ending::Collapsed(self.spot(balls, why)));
        }
        if self.sides.iter().all(ImpactSide::is_finite) {
            return None;
        }
        let why = if is_pair {
            "the impact left no finite velocity"
        } else {
            "the cushion left no finite velocity"
        };
        Some(Ending::NotFinite(self.spot(balls, why)))
    }

    #[cold]
    fn spot(&self, balls: &Kinematics<'_, T>, why: &str) -> Spot {
        balls.spot(&self.sides.each_ref().map(|side| side.ball), why)
    }
}

/// The velocity after an impact; zero where nothing but the rounding of a cancellation is left.
///
/// Without this a head-on hit off the axes would leave the cue ball creeping at 1e-17 in a direction that is noise.
fn settled<T: Real>(before: [T; 2], motion: &Motion<T>) -> [T; 2] {
    let after = [motion.velocity.x, motion.velocity.y];
    let square = |v: [T; 2]| v[0] * v[0] + v[1] * v[1];
    let cancelled = square(before) + square([after[0] - before[0], after[1] - before[1]]);
    let rounding = T::lift(CANCELLED * T::ULP);
    if square(after) <= rounding * rounding * cancelled {
        [T::zero(); 2]
    } else {
        after
    }
}
