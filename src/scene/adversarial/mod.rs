//! Scenes that look for trouble: balls that touch, stand in line, move equally fast, differ a billionfold, stand at cushions and
//! in corners; under any laws; with numbers from the middle and from the edges of what a file may hold.
//!
//! A scene is a function of a seed and an index alone, and is made as a file: what engines get has gone through the same
//! checks as any other file, and a scene that shows something can be saved, read and changed. `try` names the step with which an
//! engine that has one should run it.

mod dice;
mod laws;
mod layout;

use super::Simultaneous;
use super::file::{BallDefaults, BallFile, SceneFile, ShotFile, TableFile, UnitsFile};
use crate::physics::contact::plan_distance;
use crate::physics::{Effects, pockets};
use dice::Dice;
use layout::{Layout, Placed};

/// Most balls of such a scene.
pub const MOST_BALLS: usize = 40;

/// Numbers that are not 0 are within these bounds in scene files; see the scene checker.
const LEGAL: (f64, f64) = (1e-30, 1e30);

/// The largest coordinate, in the smallest radius: beyond twice as much, rounding would move balls by a part of their size that the
/// scene checker does not allow.
const FARTHEST: f64 = 2.5e8;

/// How large, fast and long a scene is.
#[derive(Clone, Copy, Debug)]
struct Scale {
    /// Radius that others are drawn around, length.
    radius: f64,
    /// Speed that others are drawn around, length/s.
    speed: f64,
    /// Mass that others are drawn around.
    mass: f64,
    /// s.
    duration: f64,
}

impl Scale {
    fn draw(dice: &mut Dice) -> Self {
        let radius = match dice.below(10) {
            0..=4 => dice.pick(&[0.028575, 0.25, 1.0, 0.234375]),
            5..=7 => dice.decades(-6.0, 6.0),
            8 => dice.decades(-12.0, 12.0),
            _ => dice.decades(-20.0, 18.0),
        };
        // radii a second
        let rate = match dice.below(10) {
            0..=5 => dice.between(1.0, 50.0),
            6..=7 => dice.decades(-3.0, 4.0),
            8 => dice.decades(-9.0, 6.0),
            _ => dice.decades(-12.0, 11.0),
        };
        let speed = legal(radius * rate);
        // radii that the fastest ball would go without a cloth
        let way = match dice.below(10) {
            0..=6 => dice.between(10.0, 100.0),
            7..=8 => dice.decades(0.0, 2.5),
            _ => dice.decades(-2.0, 4.0),
        };
        let mass = match dice.below(4) {
            0..=1 => dice.pick(&[0.17, 1.0, 0.107]),
            2 => dice.decades(-6.0, 6.0),
            _ => dice.decades(-18.0, 18.0),
        };
        Scale {
            radius,
            speed: if speed == 0.0 { 1e-30 } else { speed },
            mass,
            duration: (way / rate).clamp(1e-18, 1e18),
        }
    }
}

/// The scene file with number `index` under `seed`: the same on every machine, for ever.
pub fn adversarial(seed: u64, index: u64) -> SceneFile {
    let mut dice = Dice::new(seed, index);
    let dice = &mut dice;
    let scale = Scale::draw(dice);
    let Layout {
        what,
        mut balls,
        table,
    } = layout::draw(dice, &scale);
    let table = table.map(|table| table_file(&table));
    let mut effects = laws::draw(dice, &scale, table.is_some());
    if let Some(table) = &table {
        effects.pockets = laws::pockets(dice, table, &balls, &scale);
    }
    balls.truncate(MOST_BALLS);
    for ball in &mut balls {
        ball.position = ball.position.map(legal);
        ball.velocity = ball.velocity.map(legal);
    }
    keep_legal(&mut balls, table.as_ref(), &effects);
    if balls.is_empty() {
        effects.pockets = None;
        balls.push(alone(table.as_ref(), &scale));
    }
    let mut files: Vec<BallFile> = balls
        .iter()
        .enumerate()
        .map(|(i, ball)| ball_file(dice, i, ball, &scale, &effects))
        .collect();
    let shot = shot(dice, &mut files, &scale, &effects);
    let gravity = laws::gravity(dice, &scale);
    let lossy = laws::lossy(&effects);
    SceneFile {
        name: format!("random-{seed}-{index}"),
        description: format!("{what}; random scene {index} of seed {seed}."),
        sets: Vec::new(),
        duration: scale.duration,
        run_to_duration: dice.chance(0.05),
        gravity: (effects.cloth.is_some() || dice.chance(0.1)).then_some(gravity),
        units: UnitsFile {
            length_in_metres: Some(legal(0.03 / scale.radius).max(LEGAL.0)),
            ..UnitsFile::default()
        },
        table,
        ball: BallDefaults::default(),
        balls: files,
        rack: None,
        shot,
        effects,
        simultaneous: match dice.below(8) {
            0..=2 if !lossy => Simultaneous::GeneralizedReflections,
            0 => Simultaneous::Ensemble,
            _ => Simultaneous::Refuse,
        },
        richer: None,
        r#try: vec![format!(
            "stepper contact=approaching-only dt={:e}",
            scale.duration / dice.pick(&[1000.0, 300.0, 100.0, 100.0, 10.0])
        )],
    }
}

/// The nearest number that a file may hold.
fn legal(x: f64) -> f64 {
    if x.abs() < LEGAL.0 {
        0.0
    } else {
        x.clamp(-LEGAL.1, LEGAL.1)
    }
}

/// `[min, max]` as a file gives it.
fn table_file([min, max]: &[[f64; 2]; 2]) -> TableFile {
    TableFile {
        width: (max[0] - min[0]).max(LEGAL.0),
        length: (max[1] - min[1]).max(LEGAL.0),
        origin: min.map(legal),
    }
}

fn edges(table: &TableFile) -> [[f64; 2]; 2] {
    let [x, y] = table.origin;
    [table.origin, [x + table.width, y + table.length]]
}

/// Takes away what the scene checker would refuse: balls that are too small for their coordinates, outside, overlapping or in a
/// pocket. What remains is legal by a part of the allowance, which depends on the balls that remain.
fn keep_legal(balls: &mut Vec<Placed>, table: Option<&TableFile>, effects: &Effects) {
    let edges = table.map(edges);
    let coordinates = balls.iter().flat_map(|ball| ball.position);
    let extent = coordinates
        .chain(edges.iter().flatten().flatten().copied())
        .fold(0.0_f64, |largest, x| largest.max(x.abs()));
    balls.retain(|ball| extent <= FARTHEST * ball.radius);
    let smallest = balls.iter().map(|b| b.radius).fold(f64::INFINITY, f64::min);
    let allowance = |size: f64| 0.9e-12 * smallest + 4.0 * f64::EPSILON * size;
    let size = |p: [f64; 2]| p[0].abs().max(p[1].abs());
    let mut kept: Vec<Placed> = Vec::new();
    for ball in balls.drain(..) {
        let [x, y] = ball.position;
        let inside = edges.is_none_or(|[min, max]| {
            let slack = allowance(size(min).max(size(max)));
            let within = |at: f64, low: f64, high: f64| {
                low + ball.radius - at <= slack && at - (high - ball.radius) <= slack
            };
            within(x, min[0], max[0]) && within(y, min[1], max[1])
        });
        let apart = |other: &Placed| {
            let gap = (x - other.position[0]).hypot(y - other.position[1])
                - plan_distance(ball.radius, other.radius);
            -gap <= allowance(size(ball.position).max(size(other.position)))
        };
        let centre = crate::math::Vec3::new(x, y, ball.radius);
        let falls = effects
            .pockets
            .as_ref()
            .is_some_and(|p| pockets::holding(p, &centre).is_some());
        if inside && !falls && kept.iter().all(apart) {
            kept.push(ball);
        }
    }
    *balls = kept;
}

/// One ball in the middle of nothing else: what is left of a scene in which no ball could stay.
fn alone(table: Option<&TableFile>, scale: &Scale) -> Placed {
    let edges = table.map(edges);
    let middle = |axis: usize| edges.map_or(0.0, |[min, max]| 0.5 * (min[axis] + max[axis]));
    let room = table.map_or(f64::INFINITY, |table| 0.4 * table.width.min(table.length));
    Placed {
        position: [middle(0), middle(1)],
        velocity: [scale.speed, 0.0],
        radius: scale.radius.min(room),
        mass: scale.mass,
    }
}

fn ball_file(
    dice: &mut Dice,
    i: usize,
    ball: &Placed,
    scale: &Scale,
    effects: &Effects,
) -> BallFile {
    let moves = ball.velocity != [0.0; 2];
    BallFile {
        id: if i == 0 {
            "cue".to_owned()
        } else {
            i.to_string()
        },
        position: ball.position,
        velocity: moves.then_some(ball.velocity),
        spin: effects
            .rotates()
            .then(|| laws::spin(dice, ball, scale).map(legal))
            .filter(|spin| *spin != [0.0; 3]),
        radius: Some(ball.radius),
        mass: Some(ball.mass),
    }
}

/// Sometimes one ball is set in motion by a shot instead.
fn shot(
    dice: &mut Dice,
    balls: &mut [BallFile],
    scale: &Scale,
    effects: &Effects,
) -> Option<ShotFile> {
    let cue = balls.iter_mut().find(|ball| ball.velocity.is_some())?;
    if !dice.chance(0.2) {
        return None;
    }
    let [vx, vy] = cue.velocity.take()?;
    let angle_deg = vy.atan2(vx).to_degrees();
    let speed = legal(vx.hypot(vy));
    let ball = cue.id.clone();
    Some(match dice.below(4) {
        // as little as a file can say: speeds down to 1e-90
        0 if dice.chance(0.3) => ShotFile::Force {
            ball,
            angle_deg,
            force: dice.decades(-30.0, -10.0),
            contact_time: dice.decades(-30.0, -10.0),
        },
        0 => ShotFile::Force {
            ball,
            angle_deg,
            force: legal(speed * cue.mass.unwrap_or(1.0)),
            contact_time: 1.0,
        },
        1 | 2 if effects.rotates() && speed / scale.radius < 1e24 => {
            cue.spin = None;
            let tip = dice.pick(&[0.0, 0.3, 0.5, 0.7]);
            ShotFile::Strike {
                ball,
                speed,
                angle_deg,
                elevation_deg: dice.pick(&[0.0, 5.0, 45.0, 89.0, 90.0]),
                cue_mass: scale.mass * dice.pick(&[3.0, 1.0, 1e-9, 1e9]),
                end_mass: dice.chance(0.5).then_some(scale.mass / 30.0),
                side: dice.pick(&[-tip, tip, 0.0]),
                top: dice.pick(&[-tip, tip, 0.0, 0.4]),
            }
        }
        _ => ShotFile::Velocity {
            ball,
            speed,
            angle_deg,
        },
    })
}
