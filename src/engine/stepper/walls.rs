//! Which balls are past a wall: almost always none, and that must be cheap to see.

use super::balls::remove;
use crate::physics::Side;
use crate::scene::Scene;
use std::ops::Range;

/// Balls that are looked at together.
const BLOCK: usize = 32;

/// The walls of a table, in the order of [`Side::ALL`]; none where a scene has no cushions.
#[derive(Clone, Debug)]
pub struct Walls {
    walls: Vec<Wall>,
    /// Where no ball is past any wall, whatever its radius: the least and the greatest x, and those of y.
    inner: [[f64; 2]; 2],
    /// Blocks of balls of which some may be past a wall.
    suspects: Vec<usize>,
}

/// One wall.
#[derive(Clone, Debug)]
pub struct Wall {
    /// Which.
    pub side: Side,
    /// Where the centre of each ball touches it, length.
    pub limits: Vec<f64>,
}

impl Walls {
    /// The walls of a scene for balls of these radii.
    pub fn new(scene: &Scene, radii: &[f64]) -> Self {
        let walls: Vec<Wall> = match (scene.effects.cushion, scene.table) {
            (Some(_), Some(table)) => {
                let wall = |side| Wall {
                    side,
                    limits: radii.iter().map(|&r| table.reach(side, r)).collect(),
                };
                Side::ALL.into_iter().map(wall).collect()
            }
            _ => Vec::new(),
        };
        let mut inner = [[f64::NEG_INFINITY, f64::INFINITY]; 2];
        for wall in &walls {
            let [least, greatest] = &mut inner[wall.side.axis()];
            for &limit in &wall.limits {
                if wall.side.sign() < 0 {
                    *least = least.max(limit);
                } else {
                    *greatest = greatest.min(limit);
                }
            }
        }
        Walls {
            suspects: Vec::with_capacity(radii.len() / BLOCK + 1),
            walls,
            inner,
        }
    }

    /// Looks for balls that may be past a wall and answers whether there are any.
    pub fn look(&mut self, x: &[f64], y: &[f64]) -> bool {
        if self.walls.is_empty() {
            return false;
        }
        self.suspects.clear();
        let [[x0, x1], [y0, y1]] = self.inner;
        let blocks = x.chunks(BLOCK).zip(y.chunks(BLOCK));
        for (block, (xs, ys)) in blocks.enumerate() {
            let mut any = false;
            for (x, y) in xs.iter().zip(ys) {
                any |= (*x < x0) | (*x > x1) | (*y < y0) | (*y > y1);
            }
            if any {
                self.suspects.push(block);
            }
        }
        !self.suspects.is_empty()
    }

    /// Number of walls.
    pub fn count(&self) -> usize {
        self.walls.len()
    }

    /// Number of suspect blocks.
    pub fn suspects(&self) -> usize {
        self.suspects.len()
    }

    /// The balls of a suspect block, of `n` in all.
    pub fn suspect(&self, index: usize, n: usize) -> Range<usize> {
        let first = self.suspects[index] * BLOCK;
        first..n.min(first + BLOCK)
    }

    /// A wall and where ball `i` touches it.
    pub fn limit(&self, wall: usize, i: usize) -> (Side, f64) {
        let wall = &self.walls[wall];
        (wall.side, wall.limits[i])
    }

    /// Forgets balls that left play, by ascending index; those after them move up.
    pub fn remove(&mut self, leaving: &[usize]) {
        for wall in &mut self.walls {
            remove(&mut wall.limits, leaving);
        }
    }
}
