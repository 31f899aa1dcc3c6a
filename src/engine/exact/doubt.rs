//! Where the loop stops to think: something else is within reach of an impact or a stop.

use super::flight::Flight;
use super::impact::Party;
use super::predict::Near;
use super::simultaneous::Cluster;
use super::solve::Loop;
use crate::math::Real;
use crate::scene::Simultaneous;
use crate::trace::Ending;

/// Impacts at one instant whose order decides the result.
pub struct Doubt {
    /// The cluster.
    pub balls: Vec<usize>,
    /// Whether the impact under which it showed is itself beyond doubt.
    pub happened: bool,
}

/// What an impact is, once everything within its reach has been looked at.
pub enum Outcome {
    /// Nothing else has a say: it stands.
    Alone,
    /// Its order among others decides the result.
    InDoubt(Doubt),
    /// It was one of several that were resolved, and recorded, together; and whether that ends the run.
    Together(Option<Ending>),
}

impl<T: Real> Loop<'_, T> {
    /// Something else is within reach of an impact: does the order matter?
    #[cold]
    pub fn doubt(&mut self, sides: &[Party<T>], window: T) -> Outcome {
        let mut near = std::mem::take(&mut self.notes.near);
        near.sort_unstable();
        let live = |velocity: &dyn Fn(usize) -> [T; 2]| {
            let closes = |near: &&Near| self.closes(near, velocity, window);
            near.iter().filter(closes).count()
        };
        let now = |ball: usize| self.solver.flights[ball].at(self.now).1;
        let earlier = |ball: usize| {
            let side = sides.iter().find(|side| side.ball == ball);
            side.map_or_else(|| now(ball), |side| side.before)
        };
        let (before, after) = (live(&earlier), live(&now));
        let together = match self.solver.scene.simultaneous {
            Simultaneous::GeneralizedReflections => true,
            Simultaneous::Refuse | Simultaneous::Ensemble => false,
        };
        // a chain of single impacts has one order only; the convention takes it whole
        let enough = if together { 1 } else { 2 };
        if before == 0 && after < enough {
            return Outcome::Alone;
        }
        let seeds: Vec<usize> = sides.iter().map(|side| side.ball).collect();
        if together {
            self.take_back(sides);
            return Outcome::Together(self.shock(&seeds, window));
        }
        let state = |ball: usize| {
            let velocity = if before > 0 { earlier(ball) } else { now(ball) };
            (self.place(ball), velocity)
        };
        let cluster = self.cluster(&seeds, &state, window, before == 0);
        if !cluster.order_matters() {
            return Outcome::Alone;
        }
        let balls = cluster.balls;
        if before > 0 {
            // the impact itself is in doubt
            self.take_back(sides);
        }
        Outcome::InDoubt(Doubt {
            balls,
            happened: before == 0,
        })
    }

    /// The cluster around `seeds`, whose balls have `state`: centre and velocity; `far`: on the far side of the impact at hand.
    pub fn cluster(
        &self,
        seeds: &[usize],
        state: &dyn Fn(usize) -> ([T; 2], [T; 2]),
        window: T,
        far: bool,
    ) -> Cluster<'_, T> {
        let world = &self.solver.world;
        // no two balls close in faster than this
        let gap = world.touching + (world.fastest + world.fastest) * window;
        let neighbours = |ball: usize| self.neighbours(ball, gap);
        let cluster = Cluster::around(world, seeds, state, &neighbours, window, usize::MAX);
        if self.solver.spins.is_empty() {
            return cluster;
        }
        cluster.turning(|ball| self.spins_of(ball)[usize::from(far)])
    }

    /// Undoes an impact: its balls are on the flights that led to it.
    fn take_back(&mut self, sides: &[Party<T>]) {
        for side in sides {
            self.moving -= usize::from(self.solver.is_active(side.ball));
            self.solver.flights[side.ball] = side.flight;
            if let Some(turned) = self.turned.iter().find(|turned| turned.ball == side.ball) {
                self.solver.spins[side.ball] = turned.spin;
            }
            self.moving += usize::from(self.solver.is_active(side.ball));
        }
        self.turned.clear();
    }

    /// True if a neighbour is reached within the window, at the velocities given.
    fn closes(&self, near: &Near, velocity: &dyn Fn(usize) -> [T; 2], window: T) -> bool {
        let world = &self.solver.world;
        let (gap, closing) = match *near {
            Near::Pair(a, b) => {
                let (p, q) = (self.place(a), self.place(b));
                let (v, w) = (velocity(a), velocity(b));
                let (x, y) = (q[0] - p[0], q[1] - p[1]);
                let apart = (x * x + y * y).sqrt();
                let closing = ((v[0] - w[0]) * x + (v[1] - w[1]) * y) / apart;
                (apart - world.distance(a, b), closing)
            }
            Near::Cushion(a, side) => {
                let axis = side.axis();
                let outward = |x: T| if side.sign() < 0 { -x } else { x };
                let reach = world.reach[a][side as usize];
                (
                    outward(reach - self.place(a)[axis]),
                    outward(velocity(a)[axis]),
                )
            }
        };
        closing > world.blur.speed && gap <= world.touching + closing * window
    }

    /// Where a ball is now.
    pub fn place(&self, ball: usize) -> [T; 2] {
        self.solver.flights[ball].at(self.now).0
    }

    /// The ending of an impact in doubt, after recording it if it happened for certain.
    #[cold]
    pub fn indeterminate(
        &mut self,
        doubt: Doubt,
        record: impl FnOnce(&mut Self),
    ) -> Option<Ending> {
        if doubt.happened {
            record(self);
        }
        let hint = match self.solver.scene.simultaneous {
            Simultaneous::Ensemble => {
                "; the scene asks for an ensemble of small gaps, which `carom ensemble` runs"
            }
            Simultaneous::Refuse | Simultaneous::GeneralizedReflections => "",
        };
        Some(Ending::Indeterminate(self.spot(
            &doubt.balls,
            &format!("several impacts at one instant: their order decides the result{hint}"),
        )))
    }

    /// A ball stopped within the blur of another: did it reach it?
    #[cold]
    pub fn stop_in_doubt(&mut self, ball: usize, flight: &Flight<T>) -> Option<Ending> {
        let mut near = std::mem::take(&mut self.notes.near);
        near.sort_unstable();
        for neighbour in near {
            let Near::Pair(_, other) = neighbour else {
                continue;
            };
            if self.solver.flights[other].moves() {
                continue;
            }
            let to = self.place(other);
            // where it was when both had begun what they were doing
            let since = flight.start.at_least(self.solver.flights[other].start);
            let (earlier, velocity) = flight.at(since);
            let (sx, sy) = (to[0] - earlier[0], to[1] - earlier[1]);
            let approached = velocity[0] * sx + velocity[1] * sy;
            let apart = (sx * sx + sy * sy).sqrt() - self.solver.world.distance(ball, other);
            let blur = self.solver.world.blur.length;
            if approached > T::zero() && apart > blur + blur {
                return Some(Ending::Undecidable(self.spot(
                    &[ball.min(other), ball.max(other)],
                    "one stops so close to the other that rounding decides whether it touches",
                )));
            }
        }
        None
    }
}
