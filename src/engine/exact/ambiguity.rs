//! Where the loop stops to think: something else is within reach of an impact or a stop.
//!
//! Both questions are put about what would happen, before it does: nothing here changes a course.

use super::agenda::Agenda;
use super::encounter::Encounter;
use super::impact::ImpactSide;
use super::kinematics::Kinematics;
use super::predict::Watch;
use super::simultaneous::Cluster;
use crate::math::Real;
use crate::scene::Simultaneous;
use crate::trace::Ending;

/// What an impact is, once everything within its reach has been looked at.
#[derive(Clone, Debug)]
pub enum Standing {
    /// Nothing else has a say: it stands.
    Alone,
    /// Impacts at one instant whose order decides the result.
    Ambiguous {
        /// The cluster.
        balls: Vec<usize>,
        /// Whether the impact under which it showed is itself beyond doubt.
        happened: bool,
    },
    /// It is one of several that the scene's convention resolves together.
    Together,
}

/// An impact that would happen now.
struct Proposed<'a, T: Real> {
    balls: &'a Kinematics<'a, T>,
    sides: &'a [ImpactSide<T>],
    /// What the time of the impact is good to, s.
    window: T,
}

impl<T: Real> Proposed<'_, T> {
    fn side(&self, ball: usize) -> Option<&ImpactSide<T>> {
        self.sides.iter().find(|side| side.ball == ball)
    }

    /// Centre and velocity of a ball, on the near or the far side.
    fn state(&self, ball: usize, far: bool) -> ([T; 2], [T; 2]) {
        match self.side(ball) {
            Some(side) if far => side.course.flight.at(self.balls.now()),
            Some(side) => (side.position, side.before),
            None => self.balls.at(ball),
        }
    }

    /// Angular velocity of a ball, on the near or the far side.
    fn spin(&self, ball: usize, far: bool) -> [T; 3] {
        match self.side(ball) {
            Some(side) if far => side.spin_after,
            Some(side) => side.spin_before,
            None => self.balls.spin_now(ball),
        }
    }

    /// Of what is near, how much is reached within the window, at the velocities of one side.
    fn live(&self, near: &[Encounter], far: bool) -> usize {
        let closes = |encounter: &&Encounter| self.closes(encounter, far);
        near.iter().filter(closes).count()
    }

    fn closes(&self, encounter: &Encounter, far: bool) -> bool {
        let world = self.balls.world();
        let (gap, closing) = match *encounter {
            Encounter::Pair(a, b) => {
                let ((p, v), (q, w)) = (self.state(a, far), self.state(b, far));
                let (x, y) = (q[0] - p[0], q[1] - p[1]);
                let apart = (x * x + y * y).sqrt();
                let closing = ((v[0] - w[0]) * x + (v[1] - w[1]) * y) / apart;
                (apart - world.distance(a, b), closing)
            }
            Encounter::Cushion(a, side) => {
                let (position, velocity) = self.state(a, far);
                let axis = side.axis();
                let outward = |x: T| if side.sign() < 0 { -x } else { x };
                let reach = world.reach[a][side as usize];
                (outward(reach - position[axis]), outward(velocity[axis]))
            }
        };
        closing > world.blur.speed && gap <= world.touching + closing * self.window
    }
}

/// Something else is within reach of an impact: does the order matter? `window`: what its time is good to, s.
#[cold]
pub fn standing<T: Real>(
    balls: &Kinematics<'_, T>,
    agenda: &Agenda<T>,
    sides: &[ImpactSide<T>],
    window: T,
    watch: Watch<T>,
) -> Standing {
    let near = watch.found();
    let proposed = Proposed {
        balls,
        sides,
        window,
    };
    let (before, after) = (proposed.live(&near, false), proposed.live(&near, true));
    let together = match balls.scene().simultaneous {
        Simultaneous::GeneralizedReflections => true,
        Simultaneous::Refuse | Simultaneous::Ensemble => false,
    };
    // a chain of single impacts has one order only; the convention takes it whole
    let enough = if together { 1 } else { 2 };
    if before == 0 && after < enough {
        return Standing::Alone;
    }
    if together {
        return Standing::Together;
    }
    // where something else is reached already before, the impact itself is in doubt
    let happened = before == 0;
    let seeds: Vec<usize> = sides.iter().map(|side| side.ball).collect();
    let cluster = Cluster::within(
        balls,
        agenda,
        &seeds,
        &|ball| proposed.state(ball, happened),
        &|ball| proposed.spin(ball, happened),
        window,
    );
    if cluster.order_matters() {
        Standing::Ambiguous {
            balls: cluster.balls,
            happened,
        }
    } else {
        Standing::Alone
    }
}

/// The ending of a run in which the order of impacts decides the result.
#[cold]
pub fn indeterminate<T: Real>(balls: &Kinematics<'_, T>, cluster: &[usize]) -> Ending {
    let hint = match balls.scene().simultaneous {
        Simultaneous::Ensemble => {
            "; the scene asks for an ensemble of small gaps, which `carom ensemble` runs"
        }
        Simultaneous::Refuse => {
            "; a scene can name a convention, simultaneous = \"generalized-reflections\", or ask for small gaps, \
             simultaneous = \"ensemble\""
        }
        Simultaneous::GeneralizedReflections => "",
    };
    Ending::Indeterminate(balls.spot(
        cluster,
        &format!("several impacts at one instant: their order decides the result{hint}"),
    ))
}

/// A ball that would stop now does so within the uncertainty of others: did it reach one? The ending of the run if nobody can tell.
#[cold]
pub fn of_stop<T: Real>(balls: &Kinematics<'_, T>, ball: usize, watch: Watch<T>) -> Option<Ending> {
    let flight = balls.flight(ball);
    for encounter in watch.found() {
        let Encounter::Pair(_, other) = encounter else {
            continue;
        };
        let there = balls.flight(other);
        if there.moves() {
            continue;
        }
        let to = balls.place(other);
        // where it was when both had begun what they were doing
        let since = flight.start.at_least(there.start);
        let (earlier, velocity) = flight.at(since);
        let (sx, sy) = (to[0] - earlier[0], to[1] - earlier[1]);
        let approached = velocity[0] * sx + velocity[1] * sy;
        let apart = (sx * sx + sy * sy).sqrt() - balls.world().distance(ball, other);
        let blur = balls.world().blur.length;
        if approached > T::zero() && apart > blur + blur {
            return Some(Ending::Undecidable(balls.spot(
                &[ball.min(other), ball.max(other)],
                "one stops so close to the other that rounding decides whether it touches",
            )));
        }
    }
    None
}
