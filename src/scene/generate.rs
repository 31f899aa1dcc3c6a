//! Scenes of any size: discs at a packing density in a square box with cushions, as the text of a scene file.
//!
//! The law, which the text repeats for its reader: the box has the area that N discs cover at the density asked for. Centres
//! are sites of a hexagonal lattice stretched to the box (the one of all numbers of rows whose nearest neighbours are farthest
//! apart; sites left over are spread evenly), each displaced uniformly within a disc whose radius is nine tenths of half the gap
//! between neighbours. Velocities are uniform in a disc, with the root mean square asked for. Draws of ball i depend on the
//! seed and i alone. Balls are listed row by row, so that neighbours in space are neighbours in the scene.

use crate::math::random::Draws;
use std::f64::consts::{PI, SQRT_2};
use std::fmt::Write;
use thiserror::Error;

/// Most balls that a generated scene can have.
pub const MOST_BALLS: usize = 10_000_000;

/// Lengths, masses, times and speeds that are not 0 are within these bounds, far from those of scene files.
const RANGE: (f64, f64) = (1e-9, 1e9);

/// How much of the free gap jitter may use, so that rounding cannot make balls touch.
const JITTER: f64 = 0.9;

/// Least gap between lattice neighbours, in radii: what touches is not a scene for an event-driven engine.
const LEAST_GAP: f64 = 1e-6;

/// What to generate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recipe {
    /// Number of balls, 1 to [`MOST_BALLS`].
    pub balls: usize,
    /// Covered part of the box, above 0; at most what a stretched hexagonal lattice of so many discs leaves room for.
    pub density: f64,
    /// Seed of all draws.
    pub seed: u64,
    /// Friction of the cloth, 0 or greater; `None`: there is no cloth.
    pub mu: Option<f64>,
    /// Root mean square of the speeds, length/s, 0 or greater.
    pub speed: f64,
    /// Radius of every ball, length, > 0.
    pub radius: f64,
    /// Mass of every ball, > 0.
    pub mass: f64,
    /// Longest simulated time, s, > 0.
    pub duration: f64,
}

impl Default for Recipe {
    fn default() -> Self {
        Recipe {
            balls: 100,
            density: 0.3,
            seed: 1,
            mu: None,
            speed: 1.0,
            radius: 1.0,
            mass: 1.0,
            duration: 20.0,
        }
    }
}

/// Why there is no such scene.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum GenerateError {
    /// The number of balls is out of range.
    #[error("a generated scene has 1 to {MOST_BALLS} balls, not {0}")]
    Balls(usize),
    /// A number is out of range.
    #[error("{what} must be {wanted}, not {got}")]
    OutOfRange {
        /// Which number.
        what: &'static str,
        /// What would be right.
        wanted: String,
        /// What was given.
        got: f64,
    },
    /// The discs do not fit.
    #[error("{balls} balls do not fit at density {density}; at most {most:.4} can be generated")]
    TooDense {
        /// Number of balls.
        balls: usize,
        /// The density asked for.
        density: f64,
        /// The largest that can be generated, rounded down.
        most: f64,
    },
}

/// The text of the scene file that `recipe` describes; the same for the same recipe, for ever.
pub fn generate(recipe: &Recipe) -> Result<String, GenerateError> {
    check(recipe)?;
    let side = side(recipe, recipe.density);
    let lattice = Lattice::in_box(recipe, side).ok_or_else(|| GenerateError::TooDense {
        balls: recipe.balls,
        density: recipe.density,
        most: (densest(recipe) * 1e4).floor() / 1e4,
    })?;
    let mut text = head(recipe, side);
    for ball in 0..recipe.balls {
        let mut draws = Draws::new(recipe.seed, ball as u64);
        let [x, y] = lattice.place(ball, &mut draws);
        // the root mean square of a uniform disc is its radius over sqrt 2
        let (vx, vy) = draws.in_disc(recipe.speed * SQRT_2);
        let id = ball + 1;
        let written = write!(
            text,
            "\n[[balls]]\nid = \"{id}\"\nposition = [{x:?}, {y:?}]\nvelocity = [{vx:?}, {vy:?}]\n"
        );
        debug_assert!(written.is_ok(), "writing to a String cannot fail");
    }
    Ok(text)
}

fn check(recipe: &Recipe) -> Result<(), GenerateError> {
    if !(1..=MOST_BALLS).contains(&recipe.balls) {
        return Err(GenerateError::Balls(recipe.balls));
    }
    let (least, most) = RANGE;
    let positive = |x: f64| (least..=most).contains(&x);
    let above = format!("between {least:e} and {most:e}");
    let or_zero = format!("0 or {above}");
    let rules = [
        (
            "density",
            recipe.density,
            recipe.density > 0.0 && recipe.density <= 1.0,
            "above 0 and at most 1",
        ),
        ("radius", recipe.radius, positive(recipe.radius), &above),
        ("mass", recipe.mass, positive(recipe.mass), &above),
        (
            "duration",
            recipe.duration,
            positive(recipe.duration),
            &above,
        ),
        (
            "speed",
            recipe.speed,
            recipe.speed == 0.0 || positive(recipe.speed),
            &or_zero,
        ),
    ];
    for (what, got, right, wanted) in rules {
        if !right {
            let wanted = wanted.to_owned();
            return Err(GenerateError::OutOfRange { what, wanted, got });
        }
    }
    match recipe.mu {
        Some(mu) if mu != 0.0 && !positive(mu) => Err(GenerateError::OutOfRange {
            what: "mu",
            wanted: or_zero,
            got: mu,
        }),
        _ => {
            // the sides of the box enter the file as well
            let side = side(recipe, recipe.density);
            if side <= 1e6 * most {
                Ok(())
            } else {
                Err(GenerateError::OutOfRange {
                    what: "density",
                    wanted: "large enough for a box of at most 1e15".to_owned(),
                    got: recipe.density,
                })
            }
        }
    }
}

/// Side of the box in which the discs have this density, length.
fn side(recipe: &Recipe, density: f64) -> f64 {
    recipe.radius * (recipe.balls as f64 * PI / density).sqrt()
}

/// The largest density at which the discs fit.
fn densest(recipe: &Recipe) -> f64 {
    let (mut fits, mut fails) = (0.0, 1.0);
    for _ in 0..40 {
        let middle = 0.5 * (fits + fails);
        if Lattice::in_box(recipe, side(recipe, middle)).is_some() {
            fits = middle;
        } else {
            fails = middle;
        }
    }
    fits
}

fn head(recipe: &Recipe, side: f64) -> String {
    let &Recipe {
        balls,
        density,
        seed,
        mu,
        speed,
        radius,
        mass,
        duration,
    } = recipe;
    let plural = if balls == 1 { "" } else { "s" };
    let cloth = mu.map_or_else(String::new, |mu| {
        format!("\n[effects.cloth.translational]\nmu = {mu:?}\n")
    });
    let gravity = if mu.is_some() { "gravity = 9.81\n" } else { "" };
    format!(
        "\
name = \"discs-{balls}\"
description = \"\"\"
{balls} disc{plural} at packing density {density:?} in a square box: a hexagonal lattice stretched to the box and jittered, \\
velocities uniform in a disc with root mean square {speed:?}, all drawn with seed {seed}.\"\"\"
duration = {duration:?}
{gravity}
[table]
width = {side:?}
length = {side:?}

[ball]
radius = {radius:?}
mass = {mass:?}

[effects.contact.elastic]

[effects.cushion.elastic]
{cloth}"
    )
}

/// Sites for the balls, and how far each may be displaced.
struct Lattice {
    balls: usize,
    columns: usize,
    sites: usize,
    radius: f64,
    /// Extent of the box, and of it what centres may use.
    side: f64,
    pitch: [f64; 2],
    /// Every second row begins this much later.
    offset: f64,
    jitter: f64,
}

impl Lattice {
    /// The lattice with the farthest neighbours; `None` if they would still touch.
    fn in_box(recipe: &Recipe, side: f64) -> Option<Self> {
        let free = side - 2.0 * recipe.radius;
        // a row is at most sqrt(3) as close to the next one as its own sites are to each other, with room for small numbers
        let most = (2.0 * (recipe.balls as f64).sqrt()).ceil() as usize + 2;
        let mut best: Option<(f64, Lattice)> = None;
        for rows in 1..=most.min(recipe.balls) {
            let columns = recipe.balls.div_ceil(rows);
            let steps = columns as f64 - if rows > 1 { 0.5 } else { 1.0 };
            let across = if steps > 0.0 {
                free / steps
            } else {
                f64::INFINITY
            };
            let along = if rows > 1 {
                free / (rows as f64 - 1.0)
            } else {
                f64::INFINITY
            };
            let offset = if rows > 1 { 0.5 * across } else { 0.0 };
            let in_row = if columns > 1 { across } else { f64::INFINITY };
            let apart = in_row.min(offset.hypot(along)).min(2.0 * along);
            if best.as_ref().is_none_or(|(least, _)| apart > *least) {
                let gap = apart - 2.0 * recipe.radius;
                // a lone ball may be anywhere
                let jitter = (0.5 * JITTER * gap).min(0.5 * free);
                let lattice = Lattice {
                    balls: recipe.balls,
                    columns,
                    sites: rows * columns,
                    radius: recipe.radius,
                    side,
                    pitch: [across, along].map(|p| if p.is_finite() { p } else { 0.0 }),
                    offset,
                    jitter,
                };
                best = Some((apart, lattice));
            }
        }
        let (apart, lattice) = best?;
        (free >= 0.0 && apart >= (2.0 + LEAST_GAP) * recipe.radius).then_some(lattice)
    }

    /// The centre of a ball: its site, displaced; what would leave the box is displaced the other way.
    fn place(&self, ball: usize, draws: &mut Draws) -> [f64; 2] {
        let site = (ball as u128 * self.sites as u128 / self.balls as u128) as usize;
        let (row, column) = (site / self.columns, site % self.columns);
        let shift = if row % 2 == 1 { self.offset } else { 0.0 };
        let at = [
            self.radius + shift + column as f64 * self.pitch[0],
            self.radius + row as f64 * self.pitch[1],
        ];
        let (dx, dy) = draws.in_disc(self.jitter);
        let (low, high) = (self.radius, self.side - self.radius);
        let inside = |site: f64, by: f64| {
            let there = site + by;
            if there < low || there > high {
                (site - by).clamp(low, high)
            } else {
                there
            }
        };
        [inside(at[0], dx), inside(at[1], dy)]
    }
}
