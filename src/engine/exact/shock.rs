//! An instant with several contacts, resolved together by the scene's convention, and what is written down of it.
//!
//! Every contact that took part is one event with its whole impulse, in the order in which the contacts came to bear. Between
//! the rows of one instant the balls have the velocities that the impulses so far give them; what conserves energy is the
//! instant as a whole, so that is what is booked.

use super::doubt::Doubt;
use super::impact::{Party, finite};
use super::reflections::Shock;
use super::simultaneous::{Cluster, Touch};
use super::solve::Loop;
use crate::math::Real;
use crate::trace::Ending;

/// A gap larger than this part of the smallest radius is none that a convention about touching balls can close.
const FARTHEST: f64 = 1e-6;

impl<T: Real> Loop<'_, T> {
    /// Resolves the cluster around `seeds`, all of whose balls are on the near side of the instant; `window`: what its time
    /// is good to, s.
    #[cold]
    pub fn shock(&mut self, seeds: &[usize], window: T) -> Option<Ending> {
        let state = |ball: usize| self.solver.flights[ball].at(self.now);
        let cluster = self.cluster(seeds, &state, window, false);
        if self.reaches_out(&cluster) {
            let doubt = Doubt {
                balls: cluster.balls,
                happened: false,
            };
            return self.indeterminate(doubt, |_| {});
        }
        let found = cluster.reflect();
        let rows = found
            .as_ref()
            .map_or_else(Vec::new, |shock| rows(&cluster, shock));
        let Cluster { balls, .. } = cluster;
        let Some(shock) = found else {
            return Some(Ending::Collapsed(self.spot(
                &balls,
                "reflections of the contacts at one instant follow each other without end",
            )));
        };
        let mut parties: Vec<Party<T>> = balls.iter().map(|ball| self.arrival(*ball)).collect();
        for (party, after) in parties.iter_mut().zip(&shock.velocities) {
            party.after = *after;
        }
        if !parties.iter().all(finite) {
            return Some(Ending::NotFinite(
                self.spot(&balls, "the impacts left no finite velocity"),
            ));
        }
        let changed: Vec<Party<T>> = parties
            .iter()
            .filter(|party| party.after != party.before || seeds.contains(&party.ball))
            .copied()
            .collect();
        let hit: Vec<usize> = changed.iter().map(|party| party.ball).collect();
        if let Some(ending) = self.streak(&hit) {
            return Some(ending);
        }
        self.depart(&changed);
        self.write_down(&parties, &rows);
        None
    }

    /// Whether a contact of the cluster is one only because the time of the instant is uncertain: an impact that is slow beside
    /// other balls happens at any time within which they may get somewhere else. The convention is about balls that touch.
    fn reaches_out(&self, cluster: &Cluster<'_, T>) -> bool {
        let world = &self.solver.world;
        let smallest = world.radius.iter().copied().reduce(T::at_most);
        let farthest = smallest.map_or(T::zero(), |radius| radius * T::lift(FARTHEST));
        cluster.touches.iter().any(|touch| {
            let gap = match *touch {
                Touch::Pair(a, b, _) => {
                    let (a, b) = (cluster.balls[a], cluster.balls[b]);
                    let ([x, y], [u, v]) = (self.place(a), self.place(b));
                    ((u - x) * (u - x) + (v - y) * (v - y)).sqrt() - world.distance(a, b)
                }
                Touch::Cushion(a, side) => {
                    let a = cluster.balls[a];
                    (world.reach[a][side as usize] - self.place(a)[side.axis()]).abs()
                }
            };
            gap > farthest
        })
    }

    fn write_down(&mut self, parties: &[Party<T>], rows: &[Row<T>]) {
        self.record_shock_energy(parties);
        for row in rows {
            let side = |(member, before, after): (usize, [T; 2], [T; 2])| Party {
                before,
                after,
                ..parties[member]
            };
            match (row.touch, row.second) {
                (Touch::Pair(..), Some(second)) => {
                    self.record_contact(&side(row.first), &side(second));
                }
                (Touch::Cushion(_, edge), _) => self.record_edge(&side(row.first), edge),
                (Touch::Pair(..), None) => {}
            }
            for (member, before, after) in std::iter::once(row.first).chain(row.second) {
                if row.closes.contains(&member) {
                    self.record_rest(&Party {
                        before,
                        after,
                        ..parties[member]
                    });
                }
            }
        }
    }
}

/// What one contact did at the instant: members with their velocities on both sides.
struct Row<T: Real> {
    touch: Touch<T>,
    first: (usize, [T; 2], [T; 2]),
    second: Option<(usize, [T; 2], [T; 2])>,
    /// Members for which this is the last row of the instant.
    closes: Vec<usize>,
}

/// The impulses one after the other, each from where the ones before left its members; the last of a member leaves it with
/// exactly its velocity after the instant.
fn rows<T: Real>(cluster: &Cluster<'_, T>, shock: &Shock<T>) -> Vec<Row<T>> {
    let constraints = cluster.constraints();
    let mass = cluster.masses();
    let mut now = cluster.velocities.clone();
    let mut rows: Vec<Row<T>> = Vec::new();
    for (place, (contact, impulse)) in shock.impulses.iter().enumerate() {
        let constraint = &constraints[*contact];
        let before = now.clone();
        constraint.push(*impulse, &mass, &mut now);
        let later = &shock.impulses[place + 1..];
        let mut closes = Vec::new();
        for member in constraint.members() {
            let again =
                |(other, _): &(usize, T)| constraints[*other].members().any(|m| m == member);
            if !later.iter().any(again) {
                now[member] = shock.velocities[member];
                closes.push(member);
            }
        }
        let mut sides = constraint.members().map(|m| (m, before[m], now[m]));
        if let Some(first) = sides.next() {
            rows.push(Row {
                touch: cluster.touches[*contact],
                first,
                second: sides.next(),
                closes,
            });
        }
    }
    rows
}
