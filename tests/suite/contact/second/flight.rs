//! Impacts one by one: between them every ball moves along a parabola, and two meet where a polynomial of the fourth degree
//! vanishes. An accumulation is cut after a given number of impacts of its pair.

use super::laws::{Ball, Laws, Plane, approach, gap, impact};

/// From this part of its time on a phase is over: two that end together do, whatever their rounding.
const ENDED: f64 = 1.0 - 1e-12;

/// What a ball does.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    Slides,
    Rolls,
    Rests,
}

/// Balls in flight at a time.
#[derive(Clone, Debug)]
pub struct Flight<'a> {
    pub laws: &'a Laws,
    pub time: f64,
    pub balls: Vec<Ball>,
    phases: Vec<Phase>,
    /// Up to when each of them can meet another.
    pub until: Vec<f64>,
    /// Those that met now, and touch.
    met: Vec<(usize, usize)>,
}

impl<'a> Flight<'a> {
    /// Balls as they are at `time`; a slip or speed below `nothing` is rounding.
    pub fn new(
        laws: &'a Laws,
        time: f64,
        mut balls: Vec<Ball>,
        until: Vec<f64>,
        nothing: f64,
    ) -> Self {
        let phase = |ball: &mut Ball| {
            if ball.slip().norm() > nothing {
                return Phase::Slides;
            }
            if ball.v.norm() > nothing {
                ball.roll();
                return Phase::Rolls;
            }
            (ball.v, ball.w.x, ball.w.y) = (Plane::zeros(), 0.0, 0.0);
            Phase::Rests
        };
        let phases = balls.iter_mut().map(phase).collect();
        Flight {
            laws,
            time,
            balls,
            phases,
            until,
            met: Vec::new(),
        }
    }

    /// How a ball is accelerated, and how long.
    fn motion(&self, ball: usize) -> (Plane, f64) {
        let (it, laws) = (&self.balls[ball], self.laws);
        match self.phases[ball] {
            Phase::Slides => {
                let slip = it.slip();
                let size = slip.norm();
                (slip * (-laws.slide / size), size / (3.5 * laws.slide))
            }
            Phase::Rolls => {
                let speed = it.v.norm();
                (it.v * (-laws.roll / speed), speed / laws.roll)
            }
            Phase::Rests => (Plane::zeros(), f64::INFINITY),
        }
    }

    fn advance(&mut self, t: f64) {
        if t > 0.0 {
            self.met.clear();
        }
        for ball in 0..self.balls.len() {
            let (a, lasts) = self.motion(ball);
            let it = &mut self.balls[ball];
            it.r += (it.v + a * (0.5 * t)) * t;
            it.v += a * t;
            it.unwind(self.laws, t);
            match self.phases[ball] {
                Phase::Slides => {
                    it.w.x += 2.5 * a.y * t;
                    it.w.y -= 2.5 * a.x * t;
                    if t >= lasts * ENDED {
                        it.roll();
                        self.phases[ball] = Phase::Rolls;
                    }
                }
                Phase::Rolls if t >= lasts * ENDED => {
                    it.v = Plane::zeros();
                    it.roll();
                    self.phases[ball] = Phase::Rests;
                }
                Phase::Rolls => it.roll(),
                Phase::Rests => {}
            }
        }
        self.time += t;
    }

    /// When two balls meet within `most`.
    fn meeting(&self, i: usize, j: usize, most: f64) -> Option<f64> {
        let most = most
            .min(self.until[i] - self.time)
            .min(self.until[j] - self.time);
        if most <= 0.0 {
            return None;
        }
        let (one, other) = (&self.balls[i], &self.balls[j]);
        let (dr, dv) = (other.r - one.r, other.v - one.v);
        let da = self.motion(j).0 - self.motion(i).0;
        let reach = (dv.norm() + 0.5 * da.norm() * most) * most;
        let apart = gap(one, other, self.laws);
        if apart > reach {
            return None;
        }
        // |dr + dv t + da t^2/2|^2 - D^2
        let d = self.laws.diameter;
        let mut c = [
            apart * (dr.norm() + d),
            2.0 * dr.dot(&dv),
            dv.norm_squared() + dr.dot(&da),
            dv.dot(&da),
            0.25 * da.norm_squared(),
        ];
        if !self.met.contains(&(i, j)) {
            return first_zero(&c, most);
        }
        // they touch and part: the root at 0 is known
        c.rotate_left(1);
        first_zero(&c[..4], most)
    }

    /// Goes on to `end`, or to what `last` says of the impact of two balls: whether it is the last one, after which they are to be held.
    pub fn run(&mut self, end: f64, mut last: impl FnMut(usize, usize, f64) -> bool) {
        let count = self.balls.len();
        while self.time < end {
            let ends = (0..count).map(|ball| self.motion(ball).1);
            let mut step = ends.fold(end - self.time, f64::min);
            let mut hit = None;
            for i in 0..count {
                for j in i + 1..count {
                    if let Some(t) = self.meeting(i, j, step) {
                        (step, hit) = (t, Some((i, j)));
                    }
                }
            }
            let reaches = step >= end - self.time;
            self.advance(step);
            if let Some((i, j)) = hit {
                let speed = approach(&self.balls[i], &self.balls[j]);
                let held = last(i, j, speed);
                let e = if held { 0.0 } else { self.laws.e };
                let [one, other] = self.balls.get_disjoint_mut([i, j]).unwrap();
                impact(one, other, e, self.laws);
                for ball in [i, j] {
                    self.phases[ball] = Phase::Slides;
                    self.met.retain(|(a, b)| *a != ball && *b != ball);
                }
                self.met.push((i, j));
                if held {
                    return;
                }
            } else if reaches {
                self.time = end;
            }
        }
    }
}

fn value(c: &[f64], t: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * t + c)
}

/// Where the sign of a polynomial changes in (`from`, `to`], which holds no extremum inside.
fn zero_between(c: &[f64], from: f64, to: f64) -> Option<f64> {
    let positive = value(c, from) > 0.0;
    if positive == (value(c, to) > 0.0) {
        return None;
    }
    let (mut a, mut b) = (from, to);
    loop {
        let middle = 0.5 * (a + b);
        if middle <= a || middle >= b {
            return Some(b);
        }
        if positive == (value(c, middle) > 0.0) {
            a = middle;
        } else {
            b = middle;
        }
    }
}

/// All changes of sign in (0, `most`), in order.
fn zeros(c: &[f64], most: f64) -> Vec<f64> {
    if c.len() < 2 {
        return Vec::new();
    }
    let slope: Vec<f64> = (1..c.len()).map(|i| i as f64 * c[i]).collect();
    let mut bounds = zeros(&slope, most);
    bounds.insert(0, 0.0);
    bounds.push(most);
    let pairs = bounds.windows(2);
    pairs
        .filter_map(|pair| zero_between(c, pair[0], pair[1]))
        .collect()
}

/// The first time up to `most` at which a polynomial falls below 0.
fn first_zero(c: &[f64], most: f64) -> Option<f64> {
    let found = zeros(c, most);
    if value(c, 0.0) > 0.0 {
        return found.first().copied();
    }
    // it is below: by rounding, where they part
    found.get(1).copied()
}
