//! From the file as written to the [`Scene`] that engines see: defaults applied, rack laid, shot played, geometry checked.
//!
//! Works on typed values that are each in range already; what it finds are errors between values, and it finds all of them.

use super::check::{LARGEST, missing};
use super::diagnostics::{Diagnostic, Kind, nearest, short};
use super::file::{SceneFile, ShotFile};
use super::located::Located;
use super::rack;
use super::{Ball, Scene, Shot, Table, Units, geometry, names};
use crate::math::Vec3;
use crate::math::angle::unit_vector;
use crate::physics::cue::speed_from_force;
use crate::physics::{Cloth, Effects, State};
use std::collections::HashMap;

/// Longest list of balls that an error prints.
const LISTED: usize = 16;

/// A ball and the place in the file that it comes from.
pub(super) struct Placed {
    pub ball: Ball,
    /// Path of what gives its position: `balls[0].position` or `rack`.
    pub path: String,
}

/// The scene that `file` describes, or everything that is wrong with it.
pub(super) fn resolve(file: SceneFile, at: &Located<'_>) -> Result<Scene, Vec<Diagnostic>> {
    let mut problems = Vec::new();
    names::check(&file, at, &mut problems);
    check_gravity(&file, at, &mut problems);
    let table = table_of(&file, at, &mut problems);
    let mut placed = listed_balls(&file, at, &mut problems);
    placed.extend(rack::balls(&file, at, &mut problems));
    names::check_balls(&placed, at, &mut problems);
    if file.balls.is_empty() && file.rack.is_none() {
        let help = "add `[[balls]]` with `id` and `position`, or a `[rack]`";
        problems.push(missing(0..0, "a scene must have a ball", help));
    }
    let shot = play(&file, at, &mut placed, &mut problems);
    let (balls, paths): (Vec<Ball>, Vec<String>) =
        placed.into_iter().map(|p| (p.ball, p.path)).unzip();
    let scene = Scene {
        name: file.name,
        description: file.description,
        sets: file.sets.iter().map(|set| set.id().to_owned()).collect(),
        duration: file.duration,
        run_to_duration: file.run_to_duration,
        gravity: file.gravity.unwrap_or(0.0),
        units: Units {
            length: file.units.length.unwrap_or_else(|| "length unit".into()),
            length_in_metres: file.units.length_in_metres,
            mass: file.units.mass.unwrap_or_else(|| "mass unit".into()),
            mass_in_kg: file.units.mass_in_kg,
            time: file.units.time.unwrap_or_else(|| "s".into()),
        },
        table,
        balls,
        shot,
        effects: file.effects,
        simultaneous: file.simultaneous,
        richer: file.richer,
        try_settings: file.r#try,
    };
    geometry::check(&scene, &paths, at, &mut problems);
    if problems.is_empty() {
        Ok(scene)
    } else {
        Err(problems)
    }
}

/// Whether a law of the scene cannot do without gravity.
fn needs_gravity(effects: &Effects) -> Option<&'static str> {
    match effects.cloth {
        Some(Cloth::Translational { .. }) => Some("effects.cloth.translational"),
        None => None,
    }
}

fn check_gravity(file: &SceneFile, at: &Located<'_>, problems: &mut Vec<Diagnostic>) {
    if let (Some(law), None) = (needs_gravity(&file.effects), file.gravity) {
        let message = format!("`[{law}]` needs `gravity`, which the scene does not give");
        let help = "add `gravity` at the top of the file, in length/s^2; 9.81 in metres";
        let span = at.value(law);
        problems.push(missing(span, message, help).labelled("this law uses it"));
    }
}

fn table_of(file: &SceneFile, at: &Located<'_>, problems: &mut Vec<Diagnostic>) -> Option<Table> {
    let Some(table) = &file.table else {
        if file.effects.cushion.is_some() {
            let help = "add `[table]` with `width` and `length`, or remove the cushions";
            let message = "cushions need a `[table]`, which the scene does not give";
            let span = at.key("effects.cushion");
            problems.push(missing(span, message, help).labelled("cushions are named here"));
        }
        return None;
    };
    let [x, y] = table.origin;
    Some(Table {
        min: [x, y],
        max: [x + table.width, y + table.length],
    })
}

/// The balls of `[[balls]]`, without those that lack a radius or a mass.
fn listed_balls(file: &SceneFile, at: &Located<'_>, problems: &mut Vec<Diagnostic>) -> Vec<Placed> {
    let mut placed = Vec::new();
    for (i, ball) in file.balls.iter().enumerate() {
        let path = format!("balls[{i}]");
        let mut own_or_default = |own: Option<f64>, default: Option<f64>, what: &str| {
            let number = own.or(default);
            if number.is_none() {
                let message = format!("ball \"{}\" has no {what}", ball.id);
                let help = format!("add `{what}` here, or to `[ball]` for every ball");
                problems.push(missing(at.value(&path), message, help));
            }
            number
        };
        let radius = own_or_default(ball.radius, file.ball.radius, "radius");
        let mass = own_or_default(ball.mass, file.ball.mass, "mass");
        let spin = ball.spin.unwrap_or_default();
        if spin != [0.0; 3] && !file.effects.rotates() {
            let message = "spin has no meaning in a scene in which no effect turns balls";
            let help = "remove it, or name a cloth with rotation once one is built";
            let span = at.value(&format!("{path}.spin"));
            problems.push(Diagnostic::new(Kind::NoEffect, span, message, help));
        }
        if let (Some(radius), Some(mass)) = (radius, mass) {
            let velocity = ball.velocity.unwrap_or_default();
            placed.push(Placed {
                ball: Ball {
                    id: ball.id.clone(),
                    radius,
                    mass,
                    state: State {
                        position: Vec3::new(ball.position[0], ball.position[1], radius),
                        velocity: Vec3::new(velocity[0], velocity[1], 0.0),
                        spin: Vec3::from(spin),
                    },
                },
                path: format!("{path}.position"),
            });
        }
    }
    placed
}

/// Sets the ball of the shot in motion.
fn play(
    file: &SceneFile,
    at: &Located<'_>,
    placed: &mut [Placed],
    problems: &mut Vec<Diagnostic>,
) -> Option<Shot> {
    let (path, id, angle_deg) = match file.shot.as_ref()? {
        ShotFile::Force {
            ball, angle_deg, ..
        } => ("shot.force", ball, *angle_deg),
        ShotFile::Velocity {
            ball, angle_deg, ..
        } => ("shot.velocity", ball, *angle_deg),
    };
    let listed = file.balls.iter().position(|ball| &ball.id == id);
    if let Some(i) = listed.filter(|&i| file.balls[i].velocity.is_some()) {
        let message = format!("two velocities for ball \"{id}\": its own and the shot's");
        let help = "remove `velocity` from the ball, or remove the shot";
        let span = at.key(path);
        let own = at.value(&format!("balls[{i}].velocity"));
        let problem = Diagnostic::new(Kind::TwoLaws, span, message, help)
            .labelled("the shot")
            .and(own, "its own velocity");
        problems.push(problem);
    }
    let Some(ball) = placed.iter().position(|placed| &placed.ball.id == id) else {
        // a ball that lacks its radius or mass is in the file, and reported already
        if listed.is_none() {
            problems.push(unknown_ball(id, path, placed, at));
        }
        return None;
    };
    let (speed, shot) = match *file.shot.as_ref()? {
        ShotFile::Force {
            force,
            contact_time,
            ..
        } => (
            speed_from_force(force, contact_time, placed[ball].ball.mass),
            Shot::Force {
                ball,
                angle_deg,
                force,
                contact_time,
            },
        ),
        ShotFile::Velocity { speed, .. } => (
            speed,
            Shot::Velocity {
                ball,
                angle_deg,
                speed,
            },
        ),
    };
    if speed > LARGEST {
        let message = format!(
            "this shot gives a speed of {}, more than {LARGEST:e}",
            short(speed)
        );
        let help = "the speed is force * contact_time / mass";
        problems.push(Diagnostic::new(
            Kind::OutOfRange,
            at.key(path),
            message,
            help,
        ));
    }
    let (cos, sin) = unit_vector(angle_deg);
    placed[ball].ball.state.velocity = Vec3::new(speed * cos, speed * sin, 0.0);
    Some(shot)
}

fn unknown_ball(id: &str, path: &str, placed: &[Placed], at: &Located<'_>) -> Diagnostic {
    let known: Vec<&str> = placed.iter().map(|p| p.ball.id.as_str()).collect();
    let message = format!("the scene has no ball \"{id}\"");
    let guess = nearest(id, known.iter().copied());
    let help = match guess {
        Some(name) => format!("did you mean \"{name}\"?"),
        None if known.len() > LISTED => format!("the scene has {} other balls", known.len()),
        None => format!("the scene has {}", known.join(", ")),
    };
    let span = at.value(&format!("{path}.ball"));
    Diagnostic::new(Kind::UnknownBall, span, message, help)
}

/// For each word that occurs more than once: the index of its first occurrence and that of each repetition.
pub(super) fn repetitions<'a>(words: impl Iterator<Item = &'a str>) -> Vec<(usize, usize)> {
    let mut first: HashMap<&str, usize> = HashMap::new();
    let mut repeated = Vec::new();
    for (i, word) in words.enumerate() {
        let earliest = *first.entry(word).or_insert(i);
        if earliest != i {
            repeated.push((earliest, i));
        }
    }
    repeated
}
