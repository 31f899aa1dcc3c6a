//! Random scenes from fixed seeds.

use crate::support::{Scenario, scenario};
use carom::math::Vec3;
use carom::physics::{Cloth, State};
use carom::scene::{Ball, Scene, Table};

/// SplitMix64: the sample depends on the seed alone, on every machine.
pub struct Random(pub u64);

impl Random {
    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.unit()
    }
}

/// What a random scene is drawn from.
#[derive(Clone, Copy, Debug)]
pub struct Draw {
    pub balls: usize,
    /// How many of them move at the start.
    pub moving: usize,
    /// Coefficient of friction; 0 is no cloth at all.
    pub mu: f64,
    pub duration: f64,
    /// Unequal masses (a factor of 4) and radii (a factor of 1.5).
    pub unequal: bool,
}

/// A table of 6 by 10 with elastic cushions, balls nowhere closer than a tenth of the smaller radius.
pub fn random_scene(seed: u64, draw: Draw) -> Scene {
    let mut random = Random(seed);
    let empty: Scenario = scenario(&format!("random-{seed}"));
    let mut scene = empty.cushions(6.0, 10.0).duration(draw.duration).build();
    if draw.mu > 0.0 {
        scene.effects.cloth = Some(Cloth::Translational { mu: draw.mu });
    }
    while scene.balls.len() < draw.balls {
        let (radius, mass) = if draw.unequal {
            (random.between(0.2, 0.3), random.between(0.1, 0.4))
        } else {
            (0.25, 0.17)
        };
        let x = random.between(1.1 * radius, 6.0 - 1.1 * radius);
        let y = random.between(1.1 * radius, 10.0 - 1.1 * radius);
        let free = |ball: &Ball| {
            let p = ball.state.position;
            (p.x - x).hypot(p.y - y) > ball.radius + radius + 0.025
        };
        if !scene.balls.iter().all(free) {
            continue;
        }
        let (angle, speed) = (
            random.between(0.0, std::f64::consts::TAU),
            random.between(2.0, 10.0),
        );
        let speed = if scene.balls.len() < draw.moving {
            speed
        } else {
            0.0
        };
        scene.balls.push(Ball {
            id: scene.balls.len().to_string(),
            radius,
            mass,
            state: State {
                position: Vec3::new(x, y, radius),
                velocity: Vec3::new(speed * angle.cos(), speed * angle.sin(), 0.0),
                spin: Vec3::zeros(),
            },
        });
    }
    scene
}

/// The scene with every position and velocity mapped by `f` (linear, in the plane) and the table by its corners.
pub fn mapped(scene: &Scene, f: impl Fn(f64, f64) -> (f64, f64)) -> Scene {
    let mut mapped = scene.clone();
    for ball in &mut mapped.balls {
        let state = &mut ball.state;
        (state.position.x, state.position.y) = f(state.position.x, state.position.y);
        (state.velocity.x, state.velocity.y) = f(state.velocity.x, state.velocity.y);
    }
    mapped.table = scene.table.map(|table| {
        let (a, b) = f(table.min[0], table.min[1]);
        let (c, d) = f(table.max[0], table.max[1]);
        Table {
            min: [a.min(c), b.min(d)],
            max: [a.max(c), b.max(d)],
        }
    });
    mapped
}

fn draws(mu: f64) -> Vec<Draw> {
    let mut draws = Vec::new();
    for (balls, moving) in [(2, 1), (3, 3), (5, 2), (8, 1), (12, 4)] {
        for unequal in [false, true] {
            draws.push(Draw {
                balls,
                moving,
                mu,
                duration: if mu > 0.0 { 20.0 } else { 1.5 },
                unequal,
            });
        }
    }
    draws
}

/// Random scenes of every kind, `each` of ten kinds: one ball moving or several, equal or not, sparse or crowded.
///
/// Without friction they are short, so that errors do not grow too much.
pub fn scenes(mu: f64, each: u64) -> Vec<Scene> {
    let draws = draws(mu);
    let of = |(i, draw): (usize, &Draw)| -> Vec<Scene> {
        (0..each)
            .map(|seed| random_scene(1000 * i as u64 + seed, *draw))
            .collect()
    };
    draws.iter().enumerate().flat_map(of).collect()
}
