//! Where balls stand and how they move: one function a kind of trouble.

use super::dice::Dice;
use super::{FARTHEST, MOST_BALLS, Scale};
use crate::physics::contact::plan_distance;

/// A ball in the making.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub(super) position: [f64; 2],
    pub(super) velocity: [f64; 2],
    pub(super) radius: f64,
    pub(super) mass: f64,
}

/// Balls, and the table around them if there is one: `[min, max]`.
#[derive(Debug)]
pub(super) struct Layout {
    pub(super) what: &'static str,
    pub(super) balls: Vec<Placed>,
    pub(super) table: Option<[[f64; 2]; 2]>,
}

/// How balls of one scene differ.
#[derive(Clone, Copy, Debug)]
enum Sizes {
    Equal,
    /// Within a factor of two or so, in radius and mass.
    Mild,
    /// Every second one lighter by this factor.
    Alternating(f64),
    /// Radii and masses up to this factor apart.
    Wide(f64, f64),
}

struct Maker<'a> {
    dice: &'a mut Dice,
    scale: Scale,
    sizes: Sizes,
    balls: Vec<Placed>,
}

/// A kind of trouble: its name, and what makes it.
type Kind<'a> = (&'static str, fn(&mut Maker<'a>));

fn kinds<'a>() -> [Kind<'a>; 10] {
    [
        ("balls anywhere", Maker::scatter),
        ("a row", Maker::row),
        ("a rack", Maker::rack),
        ("a graze", Maker::graze),
        ("balls that meet in one point", Maker::converge),
        ("a mirrored scene", Maker::mirror),
        ("a lattice in motion", Maker::lattice),
        ("two rows that meet", Maker::two_rows),
        ("one ball that catches up", Maker::catch_up),
        ("a ball between its neighbours", Maker::squeeze),
    ]
}

pub(super) fn draw(dice: &mut Dice, scale: &Scale) -> Layout {
    let (what, place) = dice.pick(&kinds());
    let sizes = match dice.below(10) {
        0..=4 => Sizes::Equal,
        5..=6 => Sizes::Mild,
        7 => Sizes::Alternating(dice.pick(&[1e9, 1e6, 1e3, 1e-9, 100.0])),
        _ => {
            let (radii, masses) = (dice.decades(0.0, 3.0), dice.decades(0.0, 9.0));
            Sizes::Wide(radii, masses)
        }
    };
    let mut maker = Maker {
        dice,
        scale: *scale,
        sizes,
        balls: Vec::new(),
    };
    place(&mut maker);
    if maker.dice.chance(0.2) {
        let more = maker.dice.count(1, 3);
        maker.sprinkle(more);
    }
    let table = maker.table();
    let Maker { mut balls, .. } = maker;
    if balls.is_empty() {
        balls.push(Placed {
            position: [0.0; 2],
            velocity: [scale.speed, 0.0],
            radius: scale.radius,
            mass: scale.mass,
        });
    }
    Layout { what, balls, table }
}

impl Maker<'_> {
    fn size(&mut self) -> (f64, f64) {
        let (r, m) = (self.scale.radius, self.scale.mass);
        match self.sizes {
            Sizes::Equal => (r, m),
            Sizes::Mild => (
                r * self.dice.between(0.7, 1.4),
                m * self.dice.between(0.5, 2.0),
            ),
            Sizes::Alternating(ratio) if self.balls.len() % 2 == 1 => (r, m / ratio),
            Sizes::Alternating(_) => (r, m),
            Sizes::Wide(radii, masses) => (
                r / radii.powf(self.dice.between(0.0, 1.0)),
                m / masses.powf(self.dice.between(0.0, 1.0)),
            ),
        }
    }

    /// A speed: that of the scene, a part of it, next to nothing, or nothing.
    fn speed(&mut self) -> f64 {
        let part = match self.dice.below(8) {
            0..=2 => 1.0,
            3..=4 => self.dice.between(0.0, 1.0),
            5 => self.dice.tiny(),
            6 => 0.0,
            _ => self.dice.decades(-30.0, 0.0),
        };
        part * self.scale.speed
    }

    fn push(&mut self, position: [f64; 2], velocity: [f64; 2]) {
        let (radius, mass) = self.size();
        self.push_sized(position, velocity, (radius, mass));
    }

    fn push_sized(&mut self, position: [f64; 2], velocity: [f64; 2], (radius, mass): (f64, f64)) {
        self.balls.push(Placed {
            position,
            velocity,
            radius,
            mass,
        });
    }

    /// Half the side of a square that `n` balls fill to a drawn part.
    fn half_side(&mut self, n: usize) -> f64 {
        self.scale.radius * (n as f64).sqrt() * self.dice.pick(&[1.2, 2.0, 5.0, 20.0])
    }

    /// So many balls anywhere among those that are there.
    fn sprinkle(&mut self, n: usize) {
        let half = self.half_side(n.max(self.balls.len()));
        for _ in 0..n {
            let position = [
                self.dice.between(-half, half),
                self.dice.between(-half, half),
            ];
            let (direction, speed) = (self.dice.direction(), self.speed());
            self.push(position, times(speed, direction));
        }
    }

    fn scatter(&mut self) {
        let n = self.dice.count(1, MOST_BALLS);
        self.sprinkle(n);
    }

    /// Balls one after the other along `direction` from `start`, each `gap` radii from the last.
    fn line(&mut self, n: usize, start: [f64; 2], direction: [f64; 2], gap: f64) {
        let mut at = start;
        let mut last: Option<f64> = None;
        for _ in 0..n {
            let (radius, mass) = self.size();
            if let Some(last) = last {
                let pitch = plan_distance(last, radius) + gap * self.scale.radius;
                at = plus(at, times(pitch, direction));
            }
            self.push_sized(at, [0.0; 2], (radius, mass));
            last = Some(radius);
        }
    }

    /// A row at rest, hit from one end, from both, moving as one, or with speeds that differ little.
    fn row(&mut self) {
        let n = self.dice.count(2, 20);
        let (direction, gap) = (self.dice.direction(), self.dice.gap());
        self.line(n, [0.0; 2], direction, gap);
        let (v, off) = (self.scale.speed, self.aside());
        let along = plus(direction, times(off, across(direction)));
        let equal = self.dice.chance(0.5);
        match self.dice.below(5) {
            0 => self.balls[0].velocity = times(v, along),
            1 => {
                self.balls[0].velocity = times(v, along);
                let other = if equal { v } else { self.speed() };
                self.balls[n - 1].velocity = times(-other, along);
            }
            2 => self
                .balls
                .iter_mut()
                .for_each(|b| b.velocity = times(v, along)),
            3 => {
                let step = self.dice.tiny();
                for (i, ball) in self.balls.iter_mut().enumerate() {
                    ball.velocity = times(v * (1.0 - step * i as f64), along);
                }
            }
            _ => {
                for i in 0..n {
                    self.balls[i].velocity = times(self.speed(), along);
                }
            }
        }
        if self.dice.chance(0.5) {
            self.move_away(0, direction);
        }
    }

    /// A part by which an aim is off; often nothing.
    fn aside(&mut self) -> f64 {
        if self.dice.chance(0.5) {
            0.0
        } else {
            self.dice.tiny() * self.dice.pick(&[-1.0, 1.0])
        }
    }

    /// Moves one ball back along `direction`, by up to ten radii or next to nothing.
    fn move_away(&mut self, i: usize, direction: [f64; 2]) {
        let by = self.scale.radius * self.dice.pick(&[10.0, 3.0, 1.0, 1e-3, 1e-9]);
        let ball = &mut self.balls[i];
        ball.position = plus(ball.position, times(-by, direction));
    }

    /// A triangle with a ball that comes at its apex.
    fn rack(&mut self) {
        let (rows, gap) = (self.dice.count(2, 8), self.dice.gap());
        let pitch = self.scale.radius * (2.0 + gap);
        let (direction, speed) = (self.dice.direction(), self.scale.speed);
        let side = across(direction);
        let aim = self.aside();
        let back = -self.scale.radius * self.dice.pick(&[2.0, 3.0, 10.0]);
        let start = plus(times(back, direction), times(aim * self.scale.radius, side));
        self.push(start, times(speed, direction));
        for row in 0..rows {
            for place in 0..=row {
                let (i, j) = (row as f64, place as f64);
                let along = pitch * 0.75_f64.sqrt() * i;
                let position = plus(times(along, direction), times(pitch * (j - 0.5 * i), side));
                self.push(position, [0.0; 2]);
            }
        }
    }

    /// A ball that passes another by next to nothing, or hits it by next to nothing; sometimes a row of them.
    fn graze(&mut self) {
        let direction = self.dice.direction();
        let targets = self.dice.count(1, 4);
        let (radius, mass) = self.size();
        let speed = self.scale.speed;
        self.push_sized([0.0; 2], times(speed, direction), (radius, mass));
        for i in 0..targets {
            let (other, weight) = self.size();
            let distance = plan_distance(radius, other);
            let miss =
                distance * (1.0 + self.dice.tiny() * self.dice.pick(&[-1.0, -1.0, 0.0, 1.0]));
            let side = self.dice.pick(&[-1.0, 1.0]);
            let along = self.scale.radius * (3.0 + 5.0 * i as f64);
            let position = plus(
                times(along, direction),
                times(side * miss, across(direction)),
            );
            let velocity = if self.dice.chance(0.2) {
                self.speed()
            } else {
                0.0
            };
            self.push_sized(position, times(velocity, direction), (other, weight));
        }
    }

    /// Balls on a circle that move to its middle, with or without a ball there.
    fn converge(&mut self) {
        let n = self.dice.count(2, 12);
        let circle = self.scale.radius * self.dice.pick(&[4.0, 8.0, 20.0]);
        if self.dice.chance(0.5) {
            self.push([0.0; 2], [0.0; 2]);
        }
        let turn = self.dice.pick(&[0.0, 45.0, 10.0]);
        let late = if self.dice.chance(0.5) {
            self.dice.tiny()
        } else {
            0.0
        };
        for i in 0..n {
            let (cos, sin) = crate::math::angle::unit_vector(turn + 360.0 * i as f64 / n as f64);
            let out = circle * if i == 0 { 1.0 + late } else { 1.0 };
            self.push([out * cos, out * sin], times(-self.scale.speed, [cos, sin]));
        }
    }

    /// Balls and their images in the y axis, some on the axis.
    fn mirror(&mut self) {
        let n = self.dice.count(1, MOST_BALLS / 2);
        let half = self.half_side(2 * n);
        for _ in 0..n {
            let position = [self.dice.between(0.0, half), self.dice.between(-half, half)];
            let (direction, speed, size) = (self.dice.direction(), self.speed(), self.size());
            let velocity = times(speed, direction);
            if self.dice.chance(0.2) {
                self.push_sized([0.0, position[1]], [0.0, velocity[1]], size);
                continue;
            }
            self.push_sized(position, velocity, size);
            self.push_sized(
                [-position[0], position[1]],
                [-velocity[0], velocity[1]],
                size,
            );
        }
    }

    /// A square lattice, touching or not, whose rows move as one or against each other.
    fn lattice(&mut self) {
        let (columns, rows) = (self.dice.count(1, 6), self.dice.count(1, 6));
        let pitch = self.scale.radius * (2.0 + self.dice.gap());
        let direction = self.dice.direction();
        let speeds = [self.scale.speed, self.speed()];
        let opposite = self.dice.pick(&[1.0, -1.0]);
        for row in 0..rows {
            for column in 0..columns {
                let speed = if row % 2 == 0 {
                    speeds[0]
                } else {
                    opposite * speeds[1]
                };
                self.push(
                    [pitch * column as f64, pitch * row as f64],
                    times(speed, direction),
                );
            }
        }
    }

    /// Two rows, each of them touching, that run into each other.
    fn two_rows(&mut self) {
        let (n, m) = (self.dice.count(1, 12), self.dice.count(1, 12));
        let direction = self.dice.direction();
        let across = across(direction);
        let apart = self.scale.radius * self.dice.pick(&[2.5, 4.0, 12.0]);
        let gap = self.dice.gap();
        let lie = self.dice.pick(&[direction, across]);
        self.line(n, [0.0; 2], times(-1.0, lie), gap);
        let aim = self.aside() * self.scale.radius;
        let start = plus(times(apart, direction), times(aim, across));
        self.line(m, start, lie, gap);
        let (speed, other) = (self.scale.speed, self.speed());
        for (i, ball) in self.balls.iter_mut().enumerate() {
            ball.velocity = times(if i < n { speed } else { -other }, direction);
        }
    }

    /// A ball behind another that is as fast but for next to nothing.
    fn catch_up(&mut self) {
        let direction = self.dice.direction();
        let (n, gap) = (self.dice.count(2, 6), self.dice.gap().abs().max(1e-15));
        self.line(n, [0.0; 2], direction, gap);
        let slower = self.dice.tiny();
        for i in 0..n {
            let part = if i == 0 { 1.0 } else { 1.0 - slower * i as f64 };
            self.balls[i].velocity = times(part * self.scale.speed, direction);
        }
    }

    /// A ball that goes to and fro between two that close in on it.
    fn squeeze(&mut self) {
        let direction = self.dice.direction();
        let r = self.scale.radius;
        let (gap, m) = (self.dice.decades(-9.0, 1.0), self.scale.mass);
        let light = m / self.dice.pick(&[1.0, 10.0, 1e3, 1e6, 1e9]);
        let v = self.scale.speed;
        let speed = self.dice.pick(&[0.0, v, -v]);
        self.push_sized([0.0; 2], times(speed, direction), (r, light));
        for sign in [-1.0, 1.0] {
            let at = sign * r * (2.0 + gap);
            self.push_sized(times(at, direction), times(-sign * v, direction), (r, m));
        }
    }

    /// The table around the balls, often so tight that the outermost stand at its cushions; moved far away once in a while.
    fn table(&mut self) -> Option<[[f64; 2]; 2]> {
        let r = self.scale.radius;
        let bounded = self.dice.chance(0.75);
        if self.dice.chance(0.1) {
            let smallest = self.balls.iter().map(|b| b.radius).fold(r, f64::min);
            let far = smallest * self.dice.pick(&[1e3, 1e6, 0.5 * FARTHEST]);
            let [x, y] = times(far, self.dice.direction());
            for ball in &mut self.balls {
                ball.position = plus(ball.position, [x, y]);
            }
        }
        if !bounded || self.balls.is_empty() {
            return None;
        }
        let tight = self.dice.pick(&[0.0, 0.0, 1.0, 5.0, 20.0]);
        let margins = [0; 4].map(|_| r * tight * self.dice.pick(&[0.0, 1.0, 1.0]));
        let reach = |axis: usize, sign: f64| {
            let outer = self
                .balls
                .iter()
                .map(|b| sign * b.position[axis] + b.radius);
            sign * outer.fold(f64::NEG_INFINITY, f64::max)
        };
        let min = [reach(0, -1.0) - margins[0], reach(1, -1.0) - margins[1]];
        let max = [reach(0, 1.0) + margins[2], reach(1, 1.0) + margins[3]];
        if self.dice.chance(0.2) {
            let (radius, mass) = self.size();
            let corner = [min[0] + radius, min[1] + radius];
            let velocity = times(-self.speed(), self.dice.direction());
            self.push_sized(corner, velocity, (radius, mass));
        }
        Some([min, max])
    }
}

pub(super) fn times(k: f64, [x, y]: [f64; 2]) -> [f64; 2] {
    [k * x, k * y]
}

pub(super) fn plus([x, y]: [f64; 2], [u, v]: [f64; 2]) -> [f64; 2] {
    [x + u, y + v]
}

/// A quarter turn to the left.
pub(super) fn across([x, y]: [f64; 2]) -> [f64; 2] {
    [-y, x]
}
