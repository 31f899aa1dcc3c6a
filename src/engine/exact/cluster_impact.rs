//! An instant with several contacts, resolved together by the scene's convention: what happens to each ball of the cluster, as a value.
//!
//! Every contact that took part is one row with its whole impulse, in the order in which the contacts came to bear. Between
//! the rows of one instant the balls have the velocities that the impulses so far give them; what conserves energy is the
//! instant as a whole, so that is what is booked.

use super::agenda::Agenda;
use super::ambiguity::indeterminate;
use super::encounter::Encounter;
use super::impact::{Arrival, ImpactSide};
use super::instant::{Change, Exchange, Resolved};
use super::kinematics::Kinematics;
use super::simultaneous::{Cluster, Touch};
use crate::math::Real;
use crate::physics::Side;
use crate::trace::Ending;

/// A gap larger than this part of the smallest radius is none that a convention about touching balls can close.
const FARTHEST: f64 = 1e-6;

/// What an instant with several contacts does.
#[derive(Clone, Debug)]
pub struct ClusterImpact<T: Real> {
    /// Every ball of the cluster, on both sides of the instant.
    pub sides: Vec<ImpactSide<T>>,
    /// Those that leave on another course, as indices into `sides`.
    pub leaving: Vec<usize>,
    /// What each contact did, in order.
    pub rows: Vec<ContactRow<T>>,
    /// What velocities may be off by beyond rounding, length/s.
    pub error: f64,
}

/// What one contact did at the instant.
#[derive(Clone, Debug)]
pub struct ContactRow<T: Real> {
    /// The balls that it moved.
    pub first: RowSide<T>,
    /// The other one, or the cushion.
    pub second: Met<T>,
}

/// What a ball met.
#[derive(Clone, Copy, Debug)]
pub enum Met<T: Real> {
    /// A ball.
    Ball(RowSide<T>),
    /// A cushion.
    Cushion(Side),
}

/// A ball on both sides of one contact.
#[derive(Clone, Copy, Debug)]
pub struct RowSide<T: Real> {
    /// Index into the sides of the instant.
    pub member: usize,
    /// Velocity before this contact.
    pub before: [T; 2],
    /// Velocity after it.
    pub after: [T; 2],
    /// Angular velocity before and after it, where the instant changes it.
    pub spins: Option<[[T; 3]; 2]>,
    /// Whether it is the ball's last row of the instant.
    pub closes: bool,
}

impl<T: Real> ClusterImpact<T> {
    /// Resolves the cluster around `seeds`, all of whose balls are on the near side of the instant; `window`: what its time
    /// is good to, s. Errors: the ending of a run that cannot go on from here.
    #[cold]
    pub fn of(
        balls: &Kinematics<'_, T>,
        agenda: &Agenda<T>,
        seeds: &[usize],
        window: T,
    ) -> Result<Self, Ending> {
        let state = |ball: usize| balls.at(ball);
        let spin = |ball: usize| balls.spin_now(ball);
        let cluster = Cluster::within(balls, agenda, seeds, &state, &spin, window);
        if reaches_out(balls, &cluster) {
            return Err(indeterminate(balls, &cluster.balls));
        }
        ClusterImpact::of_cluster(balls, &cluster, seeds)
    }

    /// Resolves a cluster whose contacts are known; those of `seeds` leave in any case. Errors: the ending of a run that cannot go on from here.
    pub fn of_cluster(
        balls: &Kinematics<'_, T>,
        cluster: &Cluster<'_, T>,
        seeds: &[usize],
    ) -> Result<Self, Ending> {
        let Some(found) = cluster.resolve() else {
            return Err(Ending::Collapsed(balls.spot(
                &cluster.balls,
                "reflections of the contacts at one instant follow each other without end",
            )));
        };
        let motions = found.velocities.iter().zip(&found.spins);
        let sides = cluster.balls.iter().zip(motions);
        let sides = sides
            .map(|(ball, (after, spin))| Arrival::of(balls, *ball).leaving(balls, *after, *spin));
        let sides: Vec<ImpactSide<T>> = sides.collect();
        if !sides.iter().all(ImpactSide::is_finite) {
            return Err(Ending::NotFinite(
                balls.spot(&cluster.balls, "the impacts left no finite velocity"),
            ));
        }
        let turned = |side: &ImpactSide<T>| side.spin_after != side.spin_before;
        let leaves = |side: &ImpactSide<T>| {
            side.after != side.before || turned(side) || seeds.contains(&side.ball)
        };
        Ok(ClusterImpact {
            rows: rows(cluster, &found),
            error: found.error,
            leaving: (0..sides.len()).filter(|i| leaves(&sides[*i])).collect(),
            sides,
        })
    }

    /// Takes over how the balls turn that have set off and whose spin no contact has changed: one that rolls on turns as it rolls.
    pub fn turn_as(&mut self, balls: &Kinematics<'_, T>) {
        let unturned = |side: &&mut ImpactSide<T>| side.spin_after == side.spin_before;
        for side in self.sides.iter_mut().filter(unturned) {
            side.spin_before = balls.spin_now(side.ball);
            side.spin_after = side.spin_before;
        }
    }

    /// The sides that leave on another course.
    pub fn leaving(&self) -> impl Iterator<Item = &ImpactSide<T>> + Clone {
        self.leaving.iter().map(|member| &self.sides[*member])
    }
}

/// Whether a contact of the cluster is one only because the time of the instant is uncertain: an impact that is slow beside
/// other balls happens at any time within which they may get somewhere else. The convention is about balls that touch.
fn reaches_out<T: Real>(balls: &Kinematics<'_, T>, cluster: &Cluster<'_, T>) -> bool {
    let world = balls.world();
    let smallest = world.radius.iter().copied().reduce(T::at_most);
    let farthest = smallest.map_or(T::zero(), |radius| radius * T::lift(FARTHEST));
    cluster.touches.iter().any(|touch| {
        let encounter = match *touch {
            Touch::Pair(a, b, _) => Encounter::Pair(cluster.balls[a], cluster.balls[b]),
            Touch::Cushion(a, side) => Encounter::Cushion(cluster.balls[a], side),
        };
        balls.gap(encounter) > farthest
    })
}

/// The contacts one after the other, each from where the ones before left its members; the last of a member leaves it with
/// exactly its motion after the instant.
fn rows<T: Real>(cluster: &Cluster<'_, T>, found: &Resolved<T>) -> Vec<ContactRow<T>> {
    let mut now = cluster.velocities.clone();
    let mut turning = cluster.spins.clone();
    let mut rows: Vec<ContactRow<T>> = Vec::new();
    for (place, exchange) in found.exchanges.iter().enumerate() {
        let later = &found.exchanges[place + 1..];
        let mut side = |change: &Change<T>| {
            let member = change.member;
            let again = |other: &Exchange<T>| other.changes.iter().any(|c| c.member == member);
            let closes = !later.iter().any(again);
            let (before, turned) = (now[member], turning[member]);
            if closes {
                now[member] = found.velocities[member];
                turning[member] = found.spins[member];
            } else {
                now[member] = [0, 1].map(|i| before[i] + change.velocity[i]);
                turning[member] = [0, 1, 2].map(|i| turned[i] + change.spin[i]);
            }
            let spins = found.spins[member] != cluster.spins[member];
            RowSide {
                member,
                before,
                after: now[member],
                spins: spins.then_some([turned, turning[member]]),
                closes,
            }
        };
        let sides: Vec<RowSide<T>> = exchange.changes.iter().map(&mut side).collect();
        let second = match (cluster.touches[exchange.contact], sides.get(1)) {
            (Touch::Cushion(_, edge), _) => Met::Cushion(edge),
            (Touch::Pair(..), Some(second)) => Met::Ball(*second),
            (Touch::Pair(..), None) => continue,
        };
        let Some(first) = sides.first() else {
            continue;
        };
        rows.push(ContactRow {
            first: *first,
            second,
        });
    }
    rows
}
