//! Samples of an ensemble: a scene whose aim, speed and gaps vary by a stated law.
//!
//! [`Perturbation::in_words`] is the law as printed. A sample is a pure function of scene, law, seed and index; aim, speed and each
//! resting ball have draws of their own in a fixed order, so that varying one more of them leaves the others as they were.
//!
//! Touching balls have no gap that could vary, so their cluster is opened first: scaled about its centre until every touching
//! pair is at least the size of the gaps apart (exactly, if the balls are equal), and moved off the cushions that it touches
//! by as much. Displacements within half of a gap then leave room between all surfaces.

use super::geometry::pairs_within;
use super::{Ball, Scene, Shot, Simultaneous, plan_vector};
use crate::math::Vec3;
use crate::math::angle::unit_vector;
use crate::math::random::Draws;
use crate::physics::cue::speed_from_force;
use crate::physics::{Side, State};
use std::collections::BTreeMap;
use thiserror::Error;

/// What varies, and how much. 0: it does not vary.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Law {
    /// Aim of the cue ball: uniform within so many degrees to either side, 0 to 180.
    pub aim: f64,
    /// Speed of the cue ball: uniform within this part of it, up and down; at least 0, below 1.
    pub speed: f64,
    /// Size of the gaps, R: touching pairs are opened to it, and every resting ball is displaced uniformly within a disc of
    /// half this radius, or of half its smallest gap where that is less; 0 to 1.
    pub gap: f64,
}

/// Gaps between touching balls by default, R: small enough for the distribution that gaps in the limit of 0 have.
const DEFAULT_OPENING: f64 = 1e-5;
/// Gaps by which balls that do not touch are displaced by default, R.
const DEFAULT_GAP: f64 = 1e-2;
/// Aim by default, degrees.
const DEFAULT_AIM: f64 = 0.1;
/// Speed by default, as a part of it.
const DEFAULT_SPEED: f64 = 0.01;

/// A gap must be this many times what counts as touching, so that rounding has no say in it.
const RESOLVED: f64 = 100.0;

/// Why a scene cannot vary by a law.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PerturbError {
    /// A number of the law is out of range.
    #[error("{what} must be {wanted}, not {got}")]
    OutOfRange {
        /// Which number.
        what: &'static str,
        /// What would be right.
        wanted: String,
        /// What was given.
        got: f64,
    },
    /// Every number of the law is 0.
    #[error(
        "nothing varies, so all samples would be the same: give an aim (degrees), a speed (part of it) or a gap (R) above 0"
    )]
    Nothing,
    /// Aim or speed vary, and no ball moves.
    #[error("aim and speed cannot vary: no ball of {scene} moves; give a gap above 0 instead")]
    NothingMoves {
        /// Name of the scene.
        scene: String,
    },
    /// Gaps vary, and there is no ball whose gap could.
    #[error(
        "gaps cannot vary: every ball of {scene} moves and none touch; give an aim or a speed above 0 instead"
    )]
    NothingRests {
        /// Name of the scene.
        scene: String,
    },
    /// A cluster of touching balls cannot be opened between the cushions.
    #[error(
        "the touching balls around ball {ball} of {scene} cannot be opened by {gap} R: there is no room before cushion {side}; \
         give a smaller gap"
    )]
    NoRoom {
        /// Name of the scene.
        scene: String,
        /// Id of the ball that has no room.
        ball: String,
        /// The cushion in the way.
        side: &'static str,
        /// The gap asked for, R.
        gap: f64,
    },
}

impl Law {
    /// The law for a scene about which nothing else is said: where it asks for an ensemble of gaps, gaps alone; else aim,
    /// speed and gaps, as far as the scene has something that they act on.
    pub fn default_for(scene: &Scene) -> Law {
        let touching = pairs_within(&scene.balls, scene.touching())
            .next()
            .is_some();
        let gap = match (touching, scene.balls.iter().any(rests)) {
            (true, _) => DEFAULT_OPENING,
            (false, true) => DEFAULT_GAP,
            (false, false) => 0.0,
        };
        if scene.simultaneous == Simultaneous::Ensemble && gap > 0.0 {
            return Law {
                gap,
                ..Law::default()
            };
        }
        let moves = driven(scene).is_some();
        let if_it_moves = |size: f64| if moves { size } else { 0.0 };
        Law {
            aim: if_it_moves(DEFAULT_AIM),
            speed: if_it_moves(DEFAULT_SPEED),
            gap,
        }
    }

    fn check(&self) -> Result<(), PerturbError> {
        let rules = [
            (
                "the aim",
                self.aim,
                (0.0..=180.0).contains(&self.aim),
                "0 to 180 degrees",
            ),
            (
                "the speed",
                self.speed,
                (0.0..1.0).contains(&self.speed),
                "at least 0 and below 1, a part of the scene's",
            ),
            (
                "the gap",
                self.gap,
                (0.0..=1.0).contains(&self.gap),
                "0 to 1 R",
            ),
        ];
        for (what, got, right, wanted) in rules {
            if !right {
                let wanted = wanted.to_owned();
                return Err(PerturbError::OutOfRange { what, wanted, got });
            }
        }
        if *self == Law::default() {
            return Err(PerturbError::Nothing);
        }
        Ok(())
    }
}

/// A scene and the law by which it varies: what samples are drawn from.
#[derive(Clone, Debug)]
pub struct Perturbation {
    /// The law.
    pub law: Law,
    /// The scene, with touching balls opened: the middle of all samples.
    middle: Scene,
    /// The ball whose aim and speed vary.
    driven: Option<usize>,
    /// How far each ball may be displaced, length.
    rooms: Vec<f64>,
    /// Pairs that touch in the scene as written.
    touching: usize,
}

impl Perturbation {
    /// Prepares the samples of a scene, or says why there are none.
    pub fn new(scene: &Scene, law: Law) -> Result<Self, PerturbError> {
        law.check()?;
        let driven = driven(scene);
        if driven.is_none() && (law.aim > 0.0 || law.speed > 0.0) {
            let scene = scene.name.clone();
            return Err(PerturbError::NothingMoves { scene });
        }
        let mut middle = scene.clone();
        // a sample is a single run
        if middle.simultaneous == Simultaneous::Ensemble {
            middle.simultaneous = Simultaneous::Refuse;
        }
        let touching = pairs_within(&scene.balls, scene.touching()).count();
        let mut rooms = vec![0.0; scene.balls.len()];
        if law.gap > 0.0 {
            if touching == 0 && !scene.balls.iter().any(rests) {
                let scene = scene.name.clone();
                return Err(PerturbError::NothingRests { scene });
            }
            let least = RESOLVED * scene.touching() / scene.smallest_radius();
            if law.gap < least {
                return Err(PerturbError::OutOfRange {
                    what: "the gap",
                    wanted: format!(
                        "at least {least:.1e} R, or rounding has a say in which balls touch"
                    ),
                    got: law.gap,
                });
            }
            middle.balls = opened(scene, law.gap)?;
            rooms = rooms_of(&middle, law.gap * scene.smallest_radius());
        }
        Ok(Perturbation {
            law,
            middle,
            driven,
            rooms,
            touching,
        })
    }

    /// Sample number `index` under `seed`: the same scene on every machine, for ever.
    pub fn sample(&self, seed: u64, index: u64) -> Scene {
        let mut draws = Draws::new(seed, index);
        let mut scene = self.middle.clone();
        let turn = draws.between(-1.0, 1.0) * self.law.aim;
        let factor = 1.0 + draws.between(-1.0, 1.0) * self.law.speed;
        if let Some(ball) = self.driven {
            drive(&mut scene, ball, turn, factor);
        }
        for (ball, room) in scene.balls.iter_mut().zip(&self.rooms) {
            if rests(ball) {
                let (dx, dy) = draws.in_disc(1.0);
                ball.state.position += Vec3::new(dx, dy, 0.0) * *room;
            }
        }
        scene
    }

    /// The law as applied to this scene, one sentence for each thing that varies.
    pub fn in_words(&self) -> Vec<String> {
        let Law { aim, speed, gap } = self.law;
        let mut words = Vec::new();
        let ball = self.driven.map_or("", |i| &self.middle.balls[i].id);
        if aim > 0.0 {
            words.push(format!(
                "aim of ball {ball}: uniform within {aim} degrees to either side"
            ));
        }
        if speed > 0.0 {
            words.push(format!(
                "speed of ball {ball}: uniform within {} % up and down",
                // without the last digits of the product
                (1e12 * speed).round() / 1e10
            ));
        }
        if gap > 0.0 {
            let small = |x: f64| {
                if x < 1e-3 {
                    format!("{x:e}")
                } else {
                    x.to_string()
                }
            };
            let (gap, room) = (small(gap), small(0.5 * gap));
            let opened = match self.touching {
                0 => String::new(),
                1 => format!("the touching pair is opened to {gap} R; "),
                n => format!("the {n} touching pairs are opened to {gap} R; "),
            };
            words.push(format!(
                "gaps: {opened}every resting ball is displaced uniformly within a disc of radius {room} R, or half its smallest gap where \
                 that is less"
            ));
        }
        words
    }
}

fn rests(ball: &Ball) -> bool {
    ball.state.is_at_rest()
}

/// The ball whose aim and speed can vary: the shot's, else the first that moves.
fn driven(scene: &Scene) -> Option<usize> {
    let shot = scene.shot.map(|shot| shot.ball());
    let moves = |i: &usize| scene.balls[*i].state.velocity != Vec3::zeros();
    shot.filter(moves)
        .or_else(|| (0..scene.balls.len()).find(moves))
}

/// Turns the motion of a ball by `turn` degrees and multiplies it by `factor`; a shot that set it in motion with it.
fn drive(scene: &mut Scene, ball: usize, turn: f64, factor: f64) {
    let (mass, radius) = (scene.balls[ball].mass, scene.balls[ball].radius);
    let State { velocity, spin, .. } = &mut scene.balls[ball].state;
    match &mut scene.shot {
        Some(Shot::Force {
            ball: shot,
            angle_deg,
            force,
            contact_time,
        }) if *shot == ball => {
            *angle_deg += turn;
            *force *= factor;
            *velocity = plan_vector(speed_from_force(*force, *contact_time, mass), *angle_deg);
        }
        Some(Shot::Velocity {
            ball: shot,
            angle_deg,
            speed,
        }) if *shot == ball => {
            *angle_deg += turn;
            *speed *= factor;
            *velocity = plan_vector(*speed, *angle_deg);
        }
        Some(Shot::Strike { ball: shot, strike }) if *shot == ball => {
            strike.angle_deg += turn;
            strike.speed *= factor;
            let motion = strike.motion(mass, radius);
            (*velocity, *spin) = (motion.velocity, motion.spin);
        }
        _ => {
            let (c, s) = unit_vector(turn);
            let (x, y) = (velocity.x * factor, velocity.y * factor);
            *velocity = Vec3::new(c * x - s * y, s * x + c * y, velocity.z);
        }
    }
}

/// The balls of a scene with every touching pair at least `gap` apart, in R, and everything else where it was.
///
/// Clusters that opening brings together are opened as one, so that no gap of the scene is closed.
fn opened(scene: &Scene, gap: f64) -> Result<Vec<Ball>, PerturbError> {
    let size = gap * scene.smallest_radius();
    let was = gaps(&scene.balls, size);
    // of each ball, the smallest index among the balls that are opened with it
    let mut cluster: Vec<usize> = (0..scene.balls.len()).collect();
    let touching = pairs_within(&scene.balls, scene.touching());
    for ((i, j), _) in touching {
        join(&mut cluster, i, j);
    }
    loop {
        let balls = scaled(scene, &cluster, size);
        let closed = gaps(&balls, size).into_iter().find(|((i, j), now)| {
            let before = was.get(&(*i, *j)).copied().unwrap_or(size);
            cluster[*i] != cluster[*j] && *now < 0.5 * before
        });
        match closed {
            Some(((i, j), _)) => join(&mut cluster, i, j),
            None => return within_cushions(scene, balls, size, gap),
        }
    }
}

/// Gaps of up to `reach`, length, by pair.
fn gaps(balls: &[Ball], reach: f64) -> BTreeMap<(usize, usize), f64> {
    pairs_within(balls, reach).collect()
}

fn join(cluster: &mut [usize], i: usize, j: usize) {
    let (a, b) = (cluster[i].min(cluster[j]), cluster[i].max(cluster[j]));
    for label in cluster {
        if *label == b {
            *label = a;
        }
    }
}

/// Every cluster scaled about its centre by one plus `size` over its smallest contact distance, then moved off the cushions.
fn scaled(scene: &Scene, cluster: &[usize], size: f64) -> Vec<Ball> {
    let mut balls = scene.balls.clone();
    let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (ball, label) in cluster.iter().enumerate() {
        members.entry(*label).or_default().push(ball);
    }
    for members in members.values() {
        if members.len() > 1 {
            let sum: Vec3 = members.iter().map(|i| balls[*i].state.position).sum();
            let centre = sum / members.len() as f64;
            let smallest = members.iter().map(|i| balls[*i].radius);
            let stretch = size / (2.0 * smallest.fold(f64::INFINITY, f64::min));
            for &i in members {
                let out = balls[i].state.position - centre;
                balls[i].state.position += Vec3::new(out.x, out.y, 0.0) * stretch;
            }
        }
        for side in Side::ALL {
            let nearest = |balls: &[Ball]| {
                let gaps = members
                    .iter()
                    .filter_map(|i| cushion_gap(scene, &balls[*i], side));
                gaps.reduce(f64::min)
            };
            let (Some(before), Some(now)) = (nearest(&scene.balls), nearest(&balls)) else {
                continue;
            };
            if before <= scene.touching() || now < 0.5 * before.min(size) {
                let inward = f64::from(-side.sign()) * (size - now);
                for &i in members {
                    balls[i].state.position[side.axis()] += inward;
                }
            }
        }
    }
    balls
}

/// Distance from the surface of a ball to a cushion, length; `None` without a table.
fn cushion_gap(scene: &Scene, ball: &Ball, side: Side) -> Option<f64> {
    let reach = scene.reach(side, ball.radius)?;
    Some(f64::from(side.sign()) * (reach - ball.state.position[side.axis()]))
}

/// The balls, if opening has left each of them room before every cushion.
fn within_cushions(
    scene: &Scene,
    balls: Vec<Ball>,
    size: f64,
    gap: f64,
) -> Result<Vec<Ball>, PerturbError> {
    for (ball, was) in balls.iter().zip(&scene.balls) {
        for side in Side::ALL {
            let gaps = cushion_gap(scene, ball, side).zip(cushion_gap(scene, was, side));
            // what touched is to be off by the size of the gaps, what did not is to keep half of its own
            let lacks = gaps.is_some_and(|(now, before)| {
                let own = if before <= scene.touching() {
                    size
                } else {
                    before.min(size)
                };
                now < 0.5 * own
            });
            if lacks {
                return Err(PerturbError::NoRoom {
                    scene: scene.name.clone(),
                    ball: ball.id.clone(),
                    side: side.id(),
                    gap,
                });
            }
        }
    }
    Ok(balls)
}

/// How far each ball may be displaced, length: half of `size` and of every gap to another ball, and no farther than a cushion.
fn rooms_of(scene: &Scene, size: f64) -> Vec<f64> {
    let mut rooms: Vec<f64> = scene
        .balls
        .iter()
        .map(|ball| {
            let before_cushions = Side::ALL
                .iter()
                .filter_map(|side| cushion_gap(scene, ball, *side));
            before_cushions.fold(0.5 * size, f64::min).max(0.0)
        })
        .collect();
    for ((i, j), gap) in gaps(&scene.balls, size) {
        for ball in [i, j] {
            rooms[ball] = rooms[ball].min(0.5 * gap.max(0.0));
        }
    }
    rooms
}
