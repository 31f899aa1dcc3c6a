//! Time stepping after Moreau: a step finds the impulse that keeps a held pair apart. What the cloth does in a step is the
//! projection onto what its friction can do, so that sliding, rolling, rest, spin and the threshold of each are one rule.

use super::laws::{Ball, Laws, Plane, Space, approach, gap, impact, rub};

/// How far a pair that pressed may part and still press, in diameters: some roundings of what the steps leave.
const NEAR: f64 = 1e-12;

/// A ball a step later, which its contacts give an impulse and a turn.
fn pushed(ball: &Ball, push: Plane, turn: Space, dt: f64, laws: &Laws) -> Ball {
    let mut next = *ball;
    next.v += push;
    next.w += turn;
    next.unwind(laws, dt);
    let (slip, before) = (next.slip(), ball.slip().norm());
    let (size, most) = (slip.norm(), 3.5 * laws.slide * dt);
    if size > most {
        let lost = slip * (laws.slide * dt / size);
        next.v -= lost;
        next.w += 2.5 * Space::new(-lost.y, lost.x, 0.0);
    } else {
        next.v -= slip * (2.0 / 7.0);
        // it rolls for the part of the step in which it does not slide any more
        let mut rolls = dt;
        if before > 0.0 {
            let driven = (slip - ball.slip()).dot(&ball.slip()) / before;
            rolls *= 1.0 - (before / (most - driven)).clamp(0.0, 1.0);
        }
        let speed = next.v.norm();
        let lost = laws.roll * rolls;
        next.v *= if speed > lost {
            1.0 - lost / speed
        } else {
            0.0
        };
        next.roll();
    }
    next.r += (ball.v + next.v) * (0.5 * dt);
    next
}

/// Balls of which one pair is held together, and the others meet as they come.
pub struct Stepping<'a> {
    pub laws: &'a Laws,
    pub balls: Vec<Ball>,
    pub held: (usize, usize),
    /// How far apart these were when they pressed last: what the steps leave of their gap.
    pub apart: f64,
    pub time: f64,
    /// Up to when each ball can meet another.
    pub until: &'a [f64],
}

impl Stepping<'_> {
    /// All balls a step later, and whether the pair presses.
    fn pressed(&self, dt: f64) -> (Vec<Ball>, bool) {
        let (laws, (i, j)) = (self.laws, self.held);
        let free = |ball: &Ball| pushed(ball, Plane::zeros(), Space::zeros(), dt, laws);
        let mut next: Vec<Ball> = self.balls.iter().map(free).collect();
        let (one, other) = (&self.balls[i], &self.balls[j]);
        // directions in the middle of the step and at its end
        let at = |t: f64| (other.r - one.r + (other.v - one.v) * t).normalize();
        let (n, last) = (at(0.5 * dt), at(dt));
        let whole = |push: f64| {
            let rub = rub(one, other, n, push, laws);
            rub - Space::new(n.x, n.y, 0.0) * push
        };
        let both = |push: f64| {
            let whole = whole(push);
            let turn = 2.5 * Space::new(n.x, n.y, 0.0).cross(&whole);
            [
                pushed(one, whole.xy(), turn, dt, laws),
                pushed(other, -whole.xy(), turn, dt, laws),
            ]
        };
        let opens = |balls: &[Ball; 2]| (balls[1].v - balls[0].v).dot(&last);
        let free = [next[i], next[j]];
        let least = opens(&free);
        let pressed =
            least < 0.0 && gap(&free[0], &free[1], laws) <= self.apart + NEAR * laws.diameter;
        if pressed {
            // the impulse that leaves no approach, by the secant within its bounds: a ball takes at least 2/7 of it
            let (mut low, mut high) = ((0.0, least), (0.0, least));
            let mut guess = -least;
            for _ in 0..60 {
                let there = opens(&both(guess));
                if there < 0.0 {
                    low = (guess, there);
                } else {
                    high = (guess, there);
                }
                if there.abs() <= f64::EPSILON * (one.v.norm() + other.v.norm()) {
                    break;
                }
                guess = if high.1 < 0.0 {
                    2.0 * guess
                } else {
                    let secant = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
                    let (a, b) = (
                        low.0 + 0.01 * (high.0 - low.0),
                        high.0 - 0.01 * (high.0 - low.0),
                    );
                    secant.clamp(a, b)
                };
            }
            [next[i], next[j]] = both(guess);
        }
        (next, pressed)
    }

    fn stepped(&self, dt: f64) -> Vec<Ball> {
        self.pressed(dt).0
    }

    /// Whether something happens on the way from `self.balls` to `next` at which a step has to end: a slip, a speed or a spin
    /// ends, or two balls meet that are not held.
    fn happens(&self, next: &[Ball]) -> bool {
        let ends = |before: &Ball, after: &Ball| {
            let ends = |before: f64, after: f64| before != 0.0 && after == 0.0;
            ends(before.slip().norm(), after.slip().norm())
                || ends(before.v.norm(), after.v.norm())
                || ends(before.w.z, after.w.z)
        };
        let mut each = self.balls.iter().zip(next);
        each.any(|(before, after)| ends(before, after)) || self.meets(next).is_some()
    }

    /// Two balls that are not held and run into each other on the way to `next`.
    fn meets(&self, next: &[Ball]) -> Option<(usize, usize)> {
        let count = next.len();
        let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j)));
        let apart = |balls: &[Ball], (i, j): (usize, usize)| gap(&balls[i], &balls[j], self.laws);
        let mut others = pairs
            .filter(|&(i, j)| (i, j) != self.held && self.until[i].min(self.until[j]) > self.time);
        others.find(|&(i, j)| apart(next, (i, j)) < 0.0 && approach(&next[i], &next[j]) > 0.0)
    }

    /// Steps by `dt`, in parts that end where something happens.
    pub fn step(&mut self, dt: f64) {
        let mut left = dt;
        while left > 0.0 {
            let (mut low, mut high) = (0.0, left);
            let mut next = self.stepped(left);
            if self.happens(&next) {
                loop {
                    let middle = 0.5 * (low + high);
                    if middle <= low || middle >= high || high - low < f64::EPSILON * dt {
                        break;
                    }
                    let there = self.stepped(middle);
                    if self.happens(&there) {
                        (high, next) = (middle, there);
                    } else {
                        low = middle;
                    }
                }
            }
            let met = self.meets(&next);
            if self.pressed(high).1 {
                let (i, j) = self.held;
                self.apart = gap(&next[i], &next[j], self.laws);
            }
            self.balls = next;
            if let Some((i, j)) = met {
                let [one, other] = self.balls.get_disjoint_mut([i, j]).unwrap();
                impact(one, other, self.laws.e, self.laws);
            }
            left -= high;
            self.time += high;
        }
    }
}
