//! Where the energy of two balls that press on each other goes, from their knots and the laws alone: the cloth takes mu_s g |u| where a
//! ball slides, 7/5 mu_r g |v| where it rolls, and mu_sp g of the speed of its surface about the vertical; the contact takes its friction times its
//! slip. What presses is what keeps the distance: one linear equation at each knot.

use super::laws::{Ball, Laws, Plane, Space, normal, rub};
use super::method::ball;
use crate::contact::energy::through;
use carom::trace::{EventKind, Trace};

/// Below this slip a ball rolls, in parts of its speed: some roundings of its spin.
const SLIPS: f64 = 1e-9;

/// Knots crowd towards an end where the last step is this part of all: what is lost in it is that much less.
const CROWDED: f64 = 1e-11;

/// Knots that a polynomial goes through.
const THROUGH: usize = 6;

/// What a ball does between two changes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Does {
    Slides,
    Rolls,
    Rests,
}

/// Two balls at a knot of both.
type Both = [Ball; 2];

fn energy(both: &Both) -> f64 {
    let one = |ball: &Ball| 0.5 * (ball.v.norm_squared() + 0.4 * ball.w.norm_squared());
    both.iter().map(one).sum()
}

/// What the two do in a piece without changes.
struct Piece<'a> {
    laws: &'a Laws,
    does: [Does; 2],
    spins: [bool; 2],
}

fn along(a: Plane) -> Plane {
    let size = a.norm();
    if size > 0.0 { a / size } else { a }
}

impl Piece<'_> {
    /// How a ball is accelerated that is pushed so, and whose surface is turned so.
    fn accelerated(&self, which: usize, ball: &Ball, force: Plane, turn: Space) -> Plane {
        match self.does[which] {
            Does::Slides => force - along(ball.slip()) * self.laws.slide,
            Does::Rolls => {
                // the slip that the push would cause is held by the cloth
                let held = (force * 5.0 + Plane::new(turn.y, -turn.x) * 2.0) / 7.0;
                let way = if ball.v.norm() > 0.0 { ball.v } else { held };
                held - along(way) * self.laws.roll
            }
            Does::Rests => Plane::zeros(),
        }
    }

    /// How both are accelerated where they press so much, and what their contact takes.
    fn pressed(&self, both: &Both, pressing: f64) -> ([Plane; 2], f64) {
        let [one, other] = both;
        let n = normal(one, other);
        let up = Space::new(n.x, n.y, 0.0);
        // far below what would stop the slip at once, so that it is the friction of a contact
        let small = 1e-9;
        let friction = rub(one, other, n, small, self.laws) * (pressing / small);
        let slip = one.v - other.v;
        let slip = Space::new(slip.x, slip.y, 0.0) + (one.w + other.w).cross(&up);
        let force = friction.xy() - n * pressing;
        let turn = 2.5 * up.cross(&friction);
        let all = [
            self.accelerated(0, one, force, turn),
            self.accelerated(1, other, -force, turn),
        ];
        (all, -friction.dot(&slip))
    }

    /// How fast the rate of their gap grows where they press so much.
    fn parts(&self, both: &Both, pressing: f64) -> f64 {
        let ([one, other], _) = self.pressed(both, pressing);
        let n = normal(&both[0], &both[1]);
        let passing = both[1].v - both[0].v;
        let sideways = passing.norm_squared() - passing.dot(&n).powi(2);
        (other - one).dot(&n) + sideways / (both[1].r - both[0].r).norm()
    }

    /// What keeps their distance.
    fn pressing(&self, both: &Both) -> f64 {
        let (free, unit) = (self.parts(both, 0.0), self.laws.roll);
        // linear, but for the way in which a ball sets off
        let (a, b) = (self.parts(both, unit), self.parts(both, 2.0 * unit));
        if free >= 0.0 || b <= a {
            return 0.0;
        }
        (unit - unit * a / (b - a)).max(0.0)
    }

    /// What cloth and contact take in a second.
    fn power(&self, both: &Both) -> f64 {
        let cloth = |which: usize| {
            let ball = &both[which];
            let moves = match self.does[which] {
                Does::Slides => self.laws.slide * ball.slip().norm(),
                Does::Rolls => 1.4 * self.laws.roll * ball.v.norm(),
                Does::Rests => 0.0,
            };
            let turns = if self.spins[which] {
                0.4 * self.laws.spin * ball.w.z.abs()
            } else {
                0.0
            };
            moves + turns
        };
        cloth(0) + cloth(1) + self.pressed(both, self.pressing(both)).1
    }
}

/// What is taken in one piece.
fn taken(piece: &Piece, mut knots: &[(f64, Both)]) -> f64 {
    let (first, last) = (knots[0].0, knots[knots.len() - 1].0);
    let mut sum = 0.0;
    while knots.len() > 2 && last - knots[knots.len() - 2].0 < CROWDED * (last - first) {
        knots = &knots[..knots.len() - 1];
    }
    let end = &knots[knots.len() - 1];
    sum += (last - end.0) * piece.power(&end.1);
    let points: Vec<(f64, f64)> = knots
        .iter()
        .map(|(time, both)| (*time, piece.power(both)))
        .collect();
    for i in 1..points.len() {
        let from = i
            .saturating_sub(THROUGH / 2)
            .min(points.len().saturating_sub(THROUGH));
        let near = &points[from..points.len().min(from + THROUGH)];
        let middle = 0.5 * (points[i - 1].0 + points[i].0);
        let half = 0.5 * (points[i].0 - points[i - 1].0);
        // four nodes of Gauss: exact up to the seventh degree
        let root = (1.2_f64).sqrt();
        for sign in [-1.0, 1.0] {
            let node = ((3.0 + sign * 2.0 * root) / 7.0).sqrt();
            let weight = (18.0 - sign * 30.0_f64.sqrt()) / 36.0;
            for node in [-node, node] {
                sum += half * weight * through(near, middle + half * node);
            }
        }
    }
    sum
}

/// What a contact from `begin` to `end` loses beyond what friction takes, in its energy; and what it would with every second knot, less that.
pub fn unbalanced(
    trace: &Trace,
    pair: (usize, usize),
    [begin, end]: [f64; 2],
    laws: &Laws,
) -> [f64; 2] {
    let at = |time: f64, after: bool| {
        let state = |ball: usize| {
            let path = &trace.paths[ball];
            let state = if after {
                path.state_at(time)
            } else {
                path.before(time)
            };
            state.unwrap_or_else(|| panic!("no ball {ball}"))
        };
        [pair.0, pair.1].map(|b| ball(&state(b), Plane::zeros(), 0.5 * laws.diameter))
    };
    let mine = |ball: u32| ball as usize == pair.0 || ball as usize == pair.1;
    let changes = trace.events.iter().filter(|event| match event.kind {
        EventKind::SlideToRoll(ball) | EventKind::Stop(ball) | EventKind::SpinEnd(ball) => {
            mine(ball)
        }
        _ => false,
    });
    let mut ends: Vec<f64> = changes.map(|event| event.time).collect();
    ends.retain(|time| *time > begin && *time < end);
    ends.push(end);
    ends.dedup();
    let (mut from, mut took, mut second) = (begin, 0.0, 0.0);
    for to in ends {
        let times = |ball: usize| trace.paths[ball].knots.iter().map(|knot| knot.time);
        let mut inner: Vec<f64> = times(pair.0).filter(|t| *t > from && *t < to).collect();
        inner.retain(|t| times(pair.1).any(|other| other == *t));
        inner.dedup();
        let mut knots = vec![(from, at(from, true))];
        knots.extend(inner.into_iter().map(|t| (t, at(t, false))));
        knots.push((to, at(to, false)));
        let inside = &knots[..knots.len() - 1];
        let any = |is: &dyn Fn(&Ball) -> bool| {
            [0, 1].map(|i| inside.iter().any(|(_, both)| is(&both[i])))
        };
        let moves = any(&|ball| ball.v.norm() > 0.0);
        let slides = any(&|ball| ball.slip().norm() > SLIPS * ball.v.norm());
        let piece = Piece {
            laws,
            does: [0, 1].map(|i| match (slides[i], moves[i]) {
                (true, _) => Does::Slides,
                (false, true) => Does::Rolls,
                (false, false) => Does::Rests,
            }),
            spins: any(&|ball| ball.w.z != 0.0),
        };
        took += taken(&piece, &knots);
        let last = knots.len() - 1;
        let each = knots.into_iter().enumerate();
        let fewer = each.filter(|(i, _)| i % 2 == 0 || *i == last);
        let fewer: Vec<(f64, Both)> = fewer.map(|(_, knot)| knot).collect();
        second += taken(&piece, &fewer);
        from = to;
    }
    let before = energy(&at(begin, true));
    let left = before - energy(&at(end, false)) - took;
    [left / before, (took - second) / before]
}
