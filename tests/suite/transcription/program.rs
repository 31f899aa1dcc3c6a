//! The report's program, transcribed sentence by sentence and as plainly as possible. It shares no code with `stepper`, so the
//! two can be held against each other to the bit; benches measure what plainness costs.

use carom::physics::Cloth;
use carom::scene::Scene;

/// One ball in play.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    pub index: usize,
    pub r: [f64; 2],
    pub v: [f64; 2],
    pub radius: f64,
    pub mass: f64,
}

/// The program and the balls in play, the one that was shot first.
pub struct Program {
    pub balls: Vec<Ball>,
    /// Pocketed balls, where they fell.
    pub pocketed: Vec<Ball>,
    pub steps: u64,
    pub exchanges: u64,
    approaching_only: bool,
    friction: f64,
    dt: f64,
    duration: f64,
    table: Option<([f64; 2], [f64; 2])>,
    pockets: Vec<[f64; 3]>,
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

impl Program {
    pub fn new(scene: &Scene, dt: f64, approaching_only: bool) -> Self {
        let ball = |index: usize| {
            let ball = &scene.balls[index];
            Ball {
                index,
                r: [ball.state.position.x, ball.state.position.y],
                v: [ball.state.velocity.x, ball.state.velocity.y],
                radius: ball.radius,
                mass: ball.mass,
            }
        };
        let cue = scene.cue_ball();
        let others = (0..scene.balls.len()).filter(|index| *index != cue);
        Program {
            balls: std::iter::once(cue).chain(others).map(ball).collect(),
            pocketed: Vec::new(),
            steps: 0,
            exchanges: 0,
            approaching_only,
            friction: match scene.effects.cloth {
                Some(Cloth::Translational { mu }) => mu * scene.gravity,
                _ => 0.0,
            },
            dt,
            duration: scene.duration,
            table: scene.table.map(|table| (table.min, table.max)),
            pockets: scene
                .effects
                .pockets
                .as_ref()
                .map_or(Vec::new(), |pockets| pockets.circles.clone()),
        }
    }

    /// Runs until nothing moves or the time is over.
    pub fn run(&mut self) {
        while (self.steps as f64) * self.dt < self.duration
            && self.balls.iter().any(|b| b.v != [0.0, 0.0])
        {
            self.step();
        }
    }

    pub fn step(&mut self) {
        // "every collision[] ball is checked for a collision with the cue ball"
        for j in 1..self.balls.len() {
            self.collide(0, j);
        }
        // "whether any of the collision[] balls collided with any other collision[] balls"
        for i in 1..self.balls.len() {
            for j in i + 1..self.balls.len() {
                self.collide(i, j);
            }
        }
        // "all of the balls have their velocity updated"
        for b in &mut self.balls {
            let speed = dot(b.v, b.v).sqrt();
            if speed == 0.0 || self.friction == 0.0 {
                continue;
            }
            let slower = (-self.friction * b.mass * self.dt + b.mass * speed) / b.mass;
            let factor = if slower <= 0.0 { 0.0 } else { slower / speed };
            b.v = [b.v[0] * factor, b.v[1] * factor];
        }
        // "moves the ball to the edge of the wall, turns the appropriate velocity component negative"
        for b in &mut self.balls {
            let Some((min, max)) = self.table else {
                continue;
            };
            for k in 0..2 {
                if b.r[k] < min[k] + b.radius {
                    b.r[k] = min[k] + b.radius;
                    b.v[k] = b.v[k].abs();
                }
                if b.r[k] > max[k] - b.radius {
                    b.r[k] = max[k] - b.radius;
                    b.v[k] = -b.v[k].abs();
                }
            }
        }
        // "lastly each ball has their position updated"
        for b in &mut self.balls {
            for k in 0..2 {
                b.r[k] += b.v[k] * self.dt;
            }
        }
        // not the report's: a ball whose centre is in a pocket is gone
        for i in (0..self.balls.len()).rev() {
            let b = self.balls[i];
            let falls = |[x, y, radius]: &[f64; 3]| {
                let apart = [b.r[0] - x, b.r[1] - y];
                dot(apart, apart) <= radius * radius
            };
            if self.pockets.iter().any(falls) {
                self.pocketed.push(self.balls.remove(i));
            }
        }
        self.steps += 1;
    }

    fn collide(&mut self, i: usize, j: usize) {
        let (a, b) = (self.balls[i], self.balls[j]);
        let apart = [a.r[0] - b.r[0], a.r[1] - b.r[1]];
        let distance = dot(apart, apart).sqrt();
        // spheres of different sizes on one table touch with tilted normals
        let contact = if a.radius == b.radius {
            a.radius + b.radius
        } else {
            (a.radius * b.radius).sqrt() * 2.0
        };
        // written so that what is not a number collides with nothing
        let overlap = distance < contact;
        if !overlap || distance == 0.0 {
            return;
        }
        let n = [apart[0] / distance, apart[1] / distance];
        let (c1, c2) = (dot(a.v, n), dot(b.v, n));
        if self.approaching_only && c1 - c2 >= 0.0 {
            return;
        }
        let (vn1, vn2) = ([n[0] * c1, n[1] * c1], [n[0] * c2, n[1] * c2]);
        for k in 0..2 {
            self.balls[i].v[k] = a.v[k] - vn1[k] + vn2[k];
            self.balls[j].v[k] = b.v[k] - vn2[k] + vn1[k];
        }
        let changed = self.balls[i].v != a.v || self.balls[j].v != b.v;
        self.exchanges += u64::from(changed);
    }
}
