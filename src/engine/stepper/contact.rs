//! When two balls overlap, and what the report does to a pair that does.

use super::ContactRule;
use super::balls::remove;
use crate::math::Vec3;
use crate::physics::{self, Body, Contact, Friction, Motion};
use nalgebra::Vector2;

/// The squared distance below which a distance is less than `contact`: `sqrt(d2) < contact` exactly when `d2 < bound`.
///
/// The report compares distances. The square root is monotone and correctly rounded, so there is one f64 that separates
/// the squares, and a step needs no square root to give the same answer to the bit.
pub fn squared_bound(contact: f64) -> f64 {
    let mut bound = contact * contact;
    while bound.sqrt() < contact {
        bound = bound.next_up();
    }
    while bound > 0.0 && bound.next_down().sqrt() >= contact {
        bound = bound.next_down();
    }
    bound
}

/// Distances of contact for balls of a few sizes.
#[derive(Clone, Debug)]
pub struct Sizes {
    class: Vec<usize>,
    bounds: Vec<f64>,
    distances: Vec<f64>,
    count: usize,
}

impl Sizes {
    /// Groups balls by radius. `radii`: length, one a ball.
    pub fn new(radii: &[f64]) -> Self {
        let mut distinct: Vec<f64> = radii.to_vec();
        distinct.sort_by(f64::total_cmp);
        distinct.dedup();
        let class = radii
            .iter()
            .map(|r| distinct.partition_point(|d| d < r))
            .collect();
        let mut bounds = Vec::new();
        let mut distances = Vec::new();
        for &a in &distinct {
            for &b in &distinct {
                let contact = physics::contact::plan_distance(a, b);
                distances.push(contact);
                bounds.push(squared_bound(contact));
            }
        }
        Sizes {
            class,
            bounds,
            distances,
            count: distinct.len(),
        }
    }

    /// Distance of the centres of balls `i` and `j` below which they overlap, length.
    pub fn distance(&self, i: usize, j: usize) -> f64 {
        self.distances[self.pair(i, j)]
    }

    /// True when balls `i` and `j` overlap at a squared distance of `d2`, length^2.
    pub fn overlap(&self, i: usize, j: usize, d2: f64) -> bool {
        d2 < self.bounds[self.pair(i, j)]
    }

    /// The largest distance below which two balls overlap, length. Distances grow with both radii.
    pub fn largest_distance(&self) -> f64 {
        self.distances.last().copied().unwrap_or(0.0)
    }

    /// The squared distance from which on no two balls overlap, length^2.
    pub fn largest_bound(&self) -> f64 {
        self.bounds.last().copied().unwrap_or(0.0)
    }

    /// Forgets balls that left play, by ascending index; those after them move up.
    pub fn remove(&mut self, leaving: &[usize]) {
        remove(&mut self.class, leaving);
    }

    fn pair(&self, i: usize, j: usize) -> usize {
        self.class[i] * self.count + self.class[j]
    }
}

/// Square of the length of a difference in plan, in the report's order of operations.
pub fn squared(dx: f64, dy: f64) -> f64 {
    dx * dx + dy * dy
}

/// What two balls do to each other.
#[derive(Clone, Copy, Debug)]
pub struct Laws {
    /// Along the line of centres.
    pub contact: Contact,
    /// Across it.
    pub friction: Option<Friction>,
}

/// Motions of both balls of an overlapping pair after the report's rule; `None` if it leaves them alone. `apart`: from the
/// centre of the second ball to that of the first, in plan.
///
/// Smooth elastic balls of equal mass exchange their normal components in the report's words: `v1' = vt1 + vn2`,
/// `v2' = vt2 + vn1`, with `n` the unit vector from ball 2 to ball 1. All others go by the impact laws of the scene. A pair that
/// separates exchanges as written too, but does not rub: friction needs balls that press on each other, and a law that was
/// given a pull would add energy. Coincident centres have no normal, and nothing happens.
pub fn exchange(
    rule: ContactRule,
    laws: Laws,
    apart: Vector2<f64>,
    first: &Body,
    second: &Body,
) -> Option<(Motion, Motion)> {
    let distance = apart.norm();
    if distance == 0.0 {
        return None;
    }
    let n = apart / distance;
    let (v1, v2) = (first.velocity.xy(), second.velocity.xy());
    let (along1, along2) = (v1.dot(&n), v2.dot(&n));
    let separating = along1 - along2 >= 0.0;
    if rule == ContactRule::ApproachingOnly && separating {
        return None;
    }
    let friction = laws.friction.filter(|_| !separating);
    let smooth = laws.contact == (Contact::Elastic {}) && friction.is_none();
    let (one, two) = if smooth && first.mass == second.mass {
        let (normal1, normal2) = (n * along1, n * along2);
        let moved = |v: Vector2<f64>, spin| Motion {
            velocity: Vec3::new(v.x, v.y, 0.0),
            spin,
        };
        (
            moved(v1 - normal1 + normal2, first.spin),
            moved(v2 - normal2 + normal1, second.spin),
        )
    } else {
        let n = Vec3::new(-n.x, -n.y, 0.0);
        physics::contact::impact(laws.contact, friction, first, second, &n)
    };
    let changed = one != motion(first) || two != motion(second);
    changed.then_some((one, two))
}

fn motion(body: &Body) -> Motion {
    Motion {
        velocity: body.velocity,
        spin: body.spin,
    }
}

#[cfg(test)]
mod tests {
    use super::squared_bound;

    #[test]
    fn squared_bound_separates_exactly_the_distances_below_contact() {
        for contact in [0.46875, 0.05715, 1.0, 0.1, 3.3e-7, 1e8 / 3.0] {
            let bound = squared_bound(contact);
            let mut d2 = contact * contact;
            for _ in 0..50 {
                d2 = d2.next_down();
            }
            for _ in 0..100 {
                assert_eq!(
                    d2.sqrt() < contact,
                    d2 < bound,
                    "contact {contact}, d2 {d2:e}"
                );
                d2 = d2.next_up();
            }
        }
    }
}
