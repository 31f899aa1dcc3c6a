//! From the file as written to the [`Scene`] that engines see: defaults applied, rack laid, shot played, geometry checked.
//!
//! Works on typed values that are each in range already; what it finds are errors between values, and it finds all of them.

use super::check::missing;
use super::diagnostics::{Diagnostic, Kind};
use super::file::SceneFile;
use super::located::Located;
use super::placed::Placed;
use super::problems::Problems;
use super::{Ball, Scene, Table, Units, geometry, laws, names, rack, shot, tried};
use crate::math::Vec3;
use crate::physics::State;

/// The scene that `file` describes, or everything that is wrong with it.
pub(super) fn resolve(file: SceneFile, at: &Located<'_>) -> Result<Scene, Problems> {
    let (scene, problems) = whatever(file, at);
    if problems.is_empty() {
        Ok(scene)
    } else {
        Err(problems)
    }
}

/// The scene that `file` describes, and everything that is wrong with it.
pub(super) fn whatever(file: SceneFile, at: &Located<'_>) -> (Scene, Problems) {
    let mut problems = Problems::new();
    names::check(&file, at, &mut problems);
    let try_settings = tried::tried(&file.r#try, at, &mut problems);
    laws::check(&file, at, &mut problems);
    let table = table_of(&file, at, &mut problems);
    let mut placed = listed_balls(&file, at, &mut problems);
    placed.extend(rack::balls(&file, at, &mut problems));
    names::check_balls(&placed, at, &mut problems);
    if file.balls.is_empty() && file.rack.is_none() {
        let help = "add `[[balls]]` with `id` and `position`, or a `[rack]`";
        problems.push(missing(0..0, "a scene must have a ball", help));
    }
    let shot = shot::play(&file, at, &mut placed, &mut problems);
    let (balls, paths): (Vec<Ball>, Vec<String>) =
        placed.into_iter().map(|p| (p.ball, p.path)).unzip();
    let effects = laws::in_units(file.effects, file.units.length_in_metres);
    let scene = Scene {
        name: file.name,
        description: file.description,
        sets: file.sets,
        duration: file.duration,
        run_to_duration: file.run_to_duration,
        gravity: file.gravity.unwrap_or(0.0),
        units: Units {
            length: file.units.length.unwrap_or_else(|| "length unit".into()),
            length_in_metres: file.units.length_in_metres,
            mass: file.units.mass.unwrap_or_else(|| "mass unit".into()),
            mass_in_kg: file.units.mass_in_kg,
            time: file.units.time.unwrap_or_default().id().to_owned(),
        },
        table,
        balls,
        shot,
        effects,
        simultaneous: file.simultaneous,
        richer: file.richer,
        try_settings,
    };
    geometry::check(&scene, &paths, at, &mut problems);
    (scene, problems)
}

fn table_of(file: &SceneFile, at: &Located<'_>, problems: &mut Problems) -> Option<Table> {
    let Some(table) = &file.table else {
        let edges = [
            ("cushion", "cushions", file.effects.cushion.is_some()),
            ("pockets", "pockets", file.effects.pockets.is_some()),
        ];
        for (key, what, named) in edges {
            if named {
                let help = format!("add `[table]` with `width` and `length`, or remove the {what}");
                let message = format!("{what} need a `[table]`, which the scene does not give");
                let span = at.key(&format!("effects.{key}"));
                let label = format!("{what} are named here");
                problems.push(
                    missing(span, message, help)
                        .labelled(label)
                        .wanting("table"),
                );
            }
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
fn listed_balls(file: &SceneFile, at: &Located<'_>, problems: &mut Problems) -> Vec<Placed> {
    let mut placed = Vec::with_capacity(file.balls.len());
    let (mut lacking, mut turning) = (0, 0);
    for (i, ball) in file.balls.iter().enumerate() {
        let path = format!("balls[{i}]");
        let mut own_or_default = |own: Option<f64>, default: Option<f64>, what: &str| {
            let number = own.or(default);
            if number.is_none() {
                problems.push_along(&mut lacking, || {
                    let message = format!("ball \"{}\" has no {what}", ball.id);
                    let help = format!("add `{what}` here, or to `[ball]` for every ball");
                    let problem = missing(at.value(&path), message, help);
                    problem.wanting(format!("ball.{what}"))
                });
            }
            number
        };
        let radius = own_or_default(ball.radius, file.ball.radius, "radius");
        let mass = own_or_default(ball.mass, file.ball.mass, "mass");
        let spin = ball.spin.unwrap_or_default();
        if spin != [0.0; 3] && !file.effects.rotates() {
            problems.push_along(&mut turning, || {
                let message = "spin has no meaning in a scene in which no effect turns balls";
                let help =
                    "remove it, or name a law that turns balls, such as `[effects.cloth.rotational]`";
                let span = at.value(&format!("{path}.spin"));
                Diagnostic::new(Kind::NoEffect, span, message, help)
            });
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
