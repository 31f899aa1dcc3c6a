//! What several contacts at one instant leave of a cluster, by the convention of generalised reflections and its extension to losses and
//! friction.
//!
//! - Without losses and friction: [`reflections`](super::reflections) alone.
//! - With restitution: `v+ = (1 - e) v0 + e v1`, `v0` the inelastic projection and `v1` the reflections. Momentum is kept, nothing approaches
//!   afterwards, and kinetic energy is at most `(1 - e)` that of `v0` and `e` that of `v`; one contact is Newton's law. Where
//!   restitutions differ (balls, cushions), `e` is the smallest of the contacts that take an impulse together.
//! - With friction between balls: the impulses of the mix grow together, and rub ([`rubbing`](super::rubbing)).
//! - What approaches after that is the next round.
//! - A cushion whose law rubs or turns (Han, Mathavan) has no part in a mix. Balls, cushions across x and cushions across y then take turns
//!   until nothing approaches, and the answer is the mean over the orders in which they begin.
//!
//! Contacts that share no ball with others that take an impulse are left to their law.

use super::reflections::{Approaching, Constraint, groups};
use super::rubbing::{Push, Rubbed, rub};
use super::simultaneous::{Cluster, Touch};
use crate::math::Real;
use crate::physics::{Contact, Cushion, Friction, friction};

/// Rounds, and turns of different laws, before the answer is that they never end.
const MOST_ROUNDS: u32 = 10_000;

/// What the contacts of a cluster leave together.
#[derive(Clone, Debug)]
pub struct Resolved<T> {
    /// Velocities of the members, length/s.
    pub velocities: Vec<[T; 2]>,
    /// Angular velocities of the members, rad/s.
    pub spins: Vec<[T; 3]>,
    /// What each contact did that took part, once each, in the order in which they came to bear.
    pub exchanges: Vec<Exchange<T>>,
    /// What velocities may be off by beyond rounding, length/s: 0 without friction.
    pub error: f64,
}

/// What one contact did, in all.
#[derive(Clone, Debug)]
pub struct Exchange<T> {
    /// Index into the touches of the cluster.
    pub contact: usize,
    /// What it did to each of its members.
    pub changes: Vec<Change<T>>,
}

/// What a contact did to a ball.
#[derive(Clone, Copy, Debug)]
pub struct Change<T> {
    /// Index into the balls of the cluster.
    pub member: usize,
    /// Change of its velocity, length/s.
    pub velocity: [T; 2],
    /// Change of its angular velocity, rad/s.
    pub spin: [T; 3],
}

impl<T: Real> Cluster<'_, T> {
    /// What the contacts of the cluster leave of its velocities and spins together, by the laws of its world. `None` if there is no end to it.
    ///
    /// It does not ask whether the scene names the convention.
    pub fn resolve(&self) -> Option<Resolved<T>> {
        let instant = Passage::of(self);
        let all: Vec<usize> = (0..self.touches.len()).collect();
        let cushions: Vec<usize> = all
            .iter()
            .copied()
            .filter(|i| matches!(self.touches[*i], Touch::Cushion(..)))
            .collect();
        let rubs = match self.world.cushion {
            None | Some(Cushion::Elastic {} | Cushion::Restitution { .. }) => false,
            Some(Cushion::Han2005 { .. } | Cushion::Mathavan2010 { .. }) => true,
        };
        if rubs && !cushions.is_empty() {
            return instant.mean(&all);
        }
        if instant.is_lossless() {
            return instant.reflected();
        }
        let mut instant = instant;
        instant.rounds(&all)?;
        Some(instant.now)
    }

    /// Restitution of a contact; 1 for laws that have no such number.
    fn restitution(&self, contact: usize) -> T {
        match self.touches[contact] {
            Touch::Pair(..) => match self.world.contact {
                Some(Contact::Inelastic { e }) => e,
                None | Some(Contact::Elastic {}) => T::one() + self.world.restitution[0],
            },
            Touch::Cushion(..) => match self.world.cushion {
                Some(Cushion::Restitution { e }) => e,
                None
                | Some(
                    Cushion::Elastic {} | Cushion::Han2005 { .. } | Cushion::Mathavan2010 { .. },
                ) => T::one() + self.world.restitution[1],
            },
        }
    }

    /// Friction between the balls; balls that do not turn do not rub.
    fn rubs(&self) -> Option<Friction<T>> {
        self.world
            .friction
            .filter(|_| self.world.rotation.is_some())
    }

    /// The contacts as bounds on velocities, in the order of the touches.
    fn constraints(&self) -> Vec<Constraint<T>> {
        let bound = |touch: &Touch<T>| match *touch {
            Touch::Pair(a, b, n) => Constraint {
                first: (a, [n.x, n.y]),
                second: Some((b, [-n.x, -n.y])),
            },
            Touch::Cushion(a, side) => {
                let mut outward = [T::zero(); 2];
                outward[side.axis()] = if side.sign() < 0 { -T::one() } else { T::one() };
                Constraint {
                    first: (a, outward),
                    second: None,
                }
            }
        };
        self.touches.iter().map(bound).collect()
    }
}

/// A cluster on its way through an instant.
#[derive(Clone)]
struct Passage<'a, T: Real> {
    cluster: &'a Cluster<'a, T>,
    constraints: Vec<Constraint<T>>,
    mass: Vec<T>,
    now: Resolved<T>,
}

/// Impulses of a round on contacts that hang together.
struct Mix<'a, T> {
    /// Contacts with the impulses of the mix.
    impulses: Vec<(usize, T)>,
    /// Velocities of all members without friction.
    after: &'a [[T; 2]],
}

impl<'a, T: Real> Passage<'a, T> {
    fn of(cluster: &'a Cluster<'a, T>) -> Self {
        Passage {
            cluster,
            constraints: cluster.constraints(),
            mass: cluster.masses(),
            now: Resolved {
                velocities: cluster.velocities.clone(),
                spins: cluster.spins.clone(),
                exchanges: Vec::new(),
                error: 0.0,
            },
        }
    }

    fn is_lossless(&self) -> bool {
        let mut contacts = 0..self.constraints.len();
        let cluster = self.cluster;
        cluster.rubs().is_none() && contacts.all(|i| cluster.restitution(i) == T::one())
    }

    /// What conserves energy and does not rub.
    fn reflected(mut self) -> Option<Resolved<T>> {
        let found = {
            let approaching = Approaching {
                constraints: &self.constraints,
                mass: &self.mass,
                velocities: &self.now.velocities,
                slow: self.cluster.world.blur.speed,
            };
            // what reflects is smooth, and leaves spins alone
            let mut spins = self.cluster.spins.clone();
            approaching.reflect(|contact, velocities| {
                let touch = self.cluster.touches[contact];
                self.cluster.apply(touch, velocities, &mut spins);
            })?
        };
        self.now.velocities = found.velocities;
        for (contact, impulse) in found.impulses {
            self.book(contact, impulse, [T::zero(); 2]);
        }
        Some(self.now)
    }

    /// Rounds among some of the contacts, until none of them approaches.
    fn rounds(&mut self, among: &[usize]) -> Option<()> {
        let slow = self.cluster.world.blur.speed;
        for _ in 0..MOST_ROUNDS {
            let live = |i: &usize| self.constraints[*i].closing(&self.now.velocities) > slow;
            if !among.iter().any(live) {
                return Some(());
            }
            self.round(among)?;
        }
        None
    }

    fn round(&mut self, among: &[usize]) -> Option<()> {
        let set: Vec<Constraint<T>> = among.iter().map(|i| self.constraints[*i]).collect();
        let before = self.now.velocities.clone();
        let mass = self.mass.clone();
        let approaching = Approaching {
            constraints: &set,
            mass: &mass,
            velocities: &before,
            slow: self.cluster.world.blur.speed,
        };
        let elastic = approaching.reflect(|contact, velocities| {
            let touch = self.cluster.touches[among[contact]];
            self.cluster.apply_elastic(touch, velocities);
        })?;
        let inelastic = approaching.project()?;
        // of each contact that takes an impulse: both impulses
        let mut both: Vec<(usize, [T; 2])> = Vec::new();
        for (kind, impulses) in [&elastic.impulses, &inelastic.impulses]
            .into_iter()
            .enumerate()
        {
            for (contact, impulse) in impulses {
                let contact = among[*contact];
                match both.iter_mut().find(|(known, _)| *known == contact) {
                    Some((_, of)) => of[kind] += *impulse,
                    None => {
                        let mut of = [T::zero(); 2];
                        of[kind] = *impulse;
                        both.push((contact, of));
                    }
                }
            }
        }
        let pushing: Vec<usize> = both.iter().map(|(contact, _)| *contact).collect();
        for group in groups(&pushing, |a, b| self.hangs_together(a, b)) {
            if let [contact] = group[..] {
                self.alone(contact);
                continue;
            }
            let smallest = group.iter().map(|i| self.cluster.restitution(*i));
            let e = smallest.fold(T::one(), T::at_most);
            let lost = T::one() - e;
            let mut after = before.clone();
            for member in group.iter().flat_map(|i| self.constraints[*i].members()) {
                after[member] = [0, 1].map(|axis| {
                    let (v0, v1) = (inelastic.velocities[member], elastic.velocities[member]);
                    if lost == T::zero() {
                        v1[axis]
                    } else {
                        lost * v0[axis] + e * v1[axis]
                    }
                });
            }
            approaching.settle(&mut after, group.len());
            let mixed = both.iter().filter(|(contact, _)| group.contains(contact));
            let mixed = mixed.map(|(contact, [one, zero])| (*contact, e * *one + lost * *zero));
            self.mix(&Mix {
                impulses: mixed.filter(|(_, impulse)| *impulse > T::zero()).collect(),
                after: &after,
            })?;
        }
        Some(())
    }

    /// Whether an impulse at one contact matters to the other.
    fn hangs_together(&self, a: usize, b: usize) -> bool {
        let (one, other) = (&self.constraints[a], &self.constraints[b]);
        let rubs = one.second.is_some() || other.second.is_some();
        one.meets(other)
            && (one.coupling(other, &self.mass) != T::zero()
                || (rubs && self.cluster.rubs().is_some()))
    }

    /// One contact by its law.
    fn alone(&mut self, contact: usize) {
        let Resolved {
            velocities, spins, ..
        } = &mut self.now;
        let before = (velocities.clone(), spins.clone());
        let touch = self.cluster.touches[contact];
        self.cluster.apply(touch, velocities, spins);
        let members = self.constraints[contact].members();
        let changes = members.map(|member| Change {
            member,
            velocity: [0, 1].map(|i| velocities[member][i] - before.0[member][i]),
            spin: [0, 1, 2].map(|i| spins[member][i] - before.1[member][i]),
        });
        let changes = changes.collect();
        self.add(contact, changes);
    }

    /// Contacts together, with friction if there is any.
    fn mix(&mut self, mix: &Mix<'_, T>) -> Option<()> {
        let Some(found) = self.rub(mix)? else {
            for (contact, impulse) in &mix.impulses {
                self.book(*contact, *impulse, [T::zero(); 2]);
            }
            for member in self.members(mix) {
                self.now.velocities[member] = mix.after[member];
            }
            return Some(());
        };
        let beyond = found.part - T::one();
        for member in self.members(mix) {
            let before = self.now.velocities[member];
            let after = mix.after[member];
            self.now.velocities[member] =
                [0, 1].map(|i| after[i] + beyond * (after[i] - before[i]));
        }
        for ((contact, impulse), across) in mix.impulses.iter().zip(&found.tangential) {
            for change in self.book(*contact, *impulse * found.part, *across) {
                for i in 0..2 {
                    self.now.velocities[change.member][i] += change.velocity[i];
                }
                for i in 0..3 {
                    self.now.spins[change.member][i] += change.spin[i];
                }
            }
        }
        self.now.error += found.error;
        Some(())
    }

    /// The members that a mix pushes, each once.
    fn members(&self, mix: &Mix<'_, T>) -> Vec<usize> {
        let contacts = mix.impulses.iter();
        let mut members: Vec<usize> = contacts
            .flat_map(|(contact, _)| self.constraints[*contact].members())
            .collect();
        members.sort_unstable();
        members.dedup();
        members
    }

    /// Friction of a mix; `None` inside where nothing slips and nothing makes it.
    fn rub(&self, mix: &Mix<'_, T>) -> Option<Option<Rubbed<T>>> {
        let Some(law) = self.cluster.rubs() else {
            return Some(None);
        };
        let now = &self.now.velocities;
        let pushes: Vec<Push<T>> = mix
            .impulses
            .iter()
            .map(|(contact, impulse)| {
                let constraint = self.constraints[*contact];
                let slip = self.slip(&constraint);
                let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
                Push {
                    constraint,
                    impulse: *impulse,
                    closing: [constraint.closing(now), constraint.closing(mix.after)],
                    mu: match constraint.second {
                        Some(_) => friction::coefficient(law, speed),
                        None => T::zero(),
                    },
                    slip,
                }
            })
            .collect();
        let sizes = self.members(mix).into_iter().flat_map(|member| {
            let radius = self.radius(member);
            let spin = self.now.spins[member].map(|w| (w * radius).abs());
            now[member].map(T::abs).into_iter().chain(spin)
        });
        let unit = sizes.fold(T::zero(), T::at_least);
        Some(Some(rub(&pushes, &self.mass, unit)?))
    }

    /// Slip of the first ball's surface over the second's: across the normal, to the left of it, and up; none at a cushion.
    fn slip(&self, constraint: &Constraint<T>) -> [T; 2] {
        let (a, n) = constraint.first;
        let Some((b, _)) = constraint.second else {
            return [T::zero(); 2];
        };
        let left = |x: T, y: T| y * n[0] - x * n[1];
        let (v, w) = (self.now.velocities[a], self.now.velocities[b]);
        let (one, two) = (self.now.spins[a], self.now.spins[b]);
        let (r, s) = (self.radius(a), self.radius(b));
        let turning = [0, 1, 2].map(|i| one[i] * r + two[i] * s);
        [
            left(v[0] - w[0], v[1] - w[1]) + turning[2],
            -left(turning[0], turning[1]),
        ]
    }

    fn radius(&self, member: usize) -> T {
        self.cluster.world.radius[self.cluster.balls[member]]
    }

    /// Writes down a normal impulse and a tangential one (across, to the left of the normal, and up). Answers what the tangential one does.
    fn book(&mut self, contact: usize, impulse: T, [across, up]: [T; 2]) -> Vec<Change<T>> {
        let constraint = self.constraints[contact];
        let (_, n) = constraint.first;
        let left = [-n[1], n[0]];
        let (mut whole, mut tangential) = (Vec::new(), Vec::new());
        let mut sign = T::one();
        for (member, d) in constraint.ends() {
            let mass = self.mass[member];
            let turn = T::lift(2.5) / (mass * self.radius(member));
            let change = Change {
                member,
                velocity: left.map(|l| sign * across * l / mass),
                spin: [
                    -(turn * up * left[0]),
                    -(turn * up * left[1]),
                    turn * across,
                ],
            };
            tangential.push(change);
            whole.push(Change {
                velocity: [0, 1].map(|i| change.velocity[i] - d[i] * impulse / mass),
                ..change
            });
            sign = -sign;
        }
        self.add(contact, whole);
        tangential
    }

    fn add(&mut self, contact: usize, changes: Vec<Change<T>>) {
        let exchanges = &mut self.now.exchanges;
        let known = exchanges.iter_mut().find(|known| known.contact == contact);
        let Some(known) = known else {
            exchanges.push(Exchange { contact, changes });
            return;
        };
        for (sum, change) in known.changes.iter_mut().zip(changes) {
            for i in 0..2 {
                sum.velocity[i] += change.velocity[i];
            }
            for i in 0..3 {
                sum.spin[i] += change.spin[i];
            }
        }
    }

    /// Balls and cushions that take turns: the mean over the orders in which they begin.
    fn mean(&self, all: &[usize]) -> Option<Resolved<T>> {
        let kind = |i: &usize| match self.cluster.touches[*i] {
            Touch::Pair(..) => 2,
            Touch::Cushion(_, side) => side.axis(),
        };
        let kinds = [0, 1, 2].map(|one| {
            let of = all.iter().copied().filter(|i| kind(i) == one);
            of.collect::<Vec<usize>>()
        });
        let kinds = kinds.iter().filter(|kind| !kind.is_empty());
        let orders = orders(&kinds.collect::<Vec<_>>());
        let mut results = Vec::new();
        for order in &orders {
            results.push(self.clone().in_turns(order)?);
        }
        let part = T::one() / T::lift(results.len() as f64);
        let mut mean = Passage::of(self.cluster);
        for result in results {
            for Exchange { contact, changes } in result.exchanges {
                let parts = changes.into_iter().map(|change| Change {
                    member: change.member,
                    velocity: change.velocity.map(|v| v * part),
                    spin: change.spin.map(|w| w * part),
                });
                mean.add(contact, parts.collect());
            }
            for (member, sum) in mean.now.velocities.iter_mut().enumerate() {
                let (before, after) = (self.now.velocities[member], result.velocities[member]);
                *sum = [0, 1].map(|i| sum[i] + (after[i] - before[i]) * part);
            }
            for (member, sum) in mean.now.spins.iter_mut().enumerate() {
                let (before, after) = (self.now.spins[member], result.spins[member]);
                *sum = [0, 1, 2].map(|i| sum[i] + (after[i] - before[i]) * part);
            }
            mean.now.error = mean.now.error.max(result.error);
        }
        Some(mean.now)
    }

    /// Contacts of several kinds take turns until none approaches.
    fn in_turns(mut self, order: &[&Vec<usize>]) -> Option<Resolved<T>> {
        let slow = self.cluster.world.blur.speed;
        for _ in 0..MOST_ROUNDS {
            let mut rests = true;
            for kind in order {
                let live: Vec<usize> = kind
                    .iter()
                    .copied()
                    .filter(|i| self.constraints[*i].closing(&self.now.velocities) > slow)
                    .collect();
                let Some(first) = live.first() else {
                    continue;
                };
                rests = false;
                match self.cluster.touches[*first] {
                    Touch::Pair(..) => self.rounds(kind)?,
                    // cushions across the same coordinate share no ball
                    Touch::Cushion(..) => live.iter().for_each(|contact| self.alone(*contact)),
                }
            }
            if rests {
                return Some(self.now);
            }
        }
        None
    }
}

/// Every order of a few things.
fn orders<U: Copy>(of: &[U]) -> Vec<Vec<U>> {
    if of.is_empty() {
        return vec![Vec::new()];
    }
    let mut found = Vec::new();
    for (place, first) in of.iter().enumerate() {
        let rest: Vec<U> = [&of[..place], &of[place + 1..]].concat();
        for order in orders(&rest) {
            found.push([vec![*first], order].concat());
        }
    }
    found
}

#[cfg(test)]
mod tests;
