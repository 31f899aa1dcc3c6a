//! `[shot...]`: what sets one ball in motion, from the file to the velocity and spin of that ball.

use super::check::LARGEST;
use super::diagnostics::{Diagnostic, Kind, nearest, short};
use super::file::{SceneFile, ShotFile};
use super::located::Located;
use super::placed::Placed;
use super::problems::Problems;
use super::{Ball, Shot, plan_vector};
use crate::physics::cue::{Strike, speed_from_force};
use crate::physics::{Motion, State};

/// Longest list of balls that an error prints.
const LISTED: usize = 16;

/// Sets the ball of the shot in motion.
pub(super) fn play(
    file: &SceneFile,
    at: &Located<'_>,
    placed: &mut [Placed],
    problems: &mut Problems,
) -> Option<Shot> {
    let shot = file.shot.as_ref()?;
    let (path, id) = match shot {
        ShotFile::Force { ball, .. } => ("shot.force", ball),
        ShotFile::Velocity { ball, .. } => ("shot.velocity", ball),
        ShotFile::Strike { ball, .. } => ("shot.strike", ball),
    };
    let listed = file.balls.iter().position(|ball| &ball.id == id);
    two_motions(file, at, path, listed, problems);
    let found = problems.found();
    strike(file, at, problems);
    let Some(ball) = placed.iter().position(|placed| &placed.ball.id == id) else {
        // a ball that lacks its radius or mass is in the file, and reported already
        if listed.is_none() {
            problems.push(unknown_ball(id, path, placed, at));
        }
        return None;
    };
    if problems.found() > found {
        return None;
    }
    let shot = set_in_motion(shot, ball, &mut placed[ball].ball);
    let state = &placed[ball].ball.state;
    too_fast(shot, path, state, at, problems);
    Some(shot)
}

/// Gives the ball of the shot, with index `ball` in the scene, its motion.
fn set_in_motion(shot: &ShotFile, ball: usize, body: &mut Ball) -> Shot {
    let (mass, radius) = (body.mass, body.radius);
    let state = &mut body.state;
    match *shot {
        ShotFile::Force {
            angle_deg,
            force,
            contact_time,
            ..
        } => {
            state.velocity = plan_vector(speed_from_force(force, contact_time, mass), angle_deg);
            Shot::Force {
                ball,
                angle_deg,
                force,
                contact_time,
            }
        }
        ShotFile::Velocity {
            angle_deg, speed, ..
        } => {
            state.velocity = plan_vector(speed, angle_deg);
            Shot::Velocity {
                ball,
                angle_deg,
                speed,
            }
        }
        ShotFile::Strike {
            speed,
            angle_deg,
            elevation_deg,
            cue_mass,
            end_mass,
            side,
            top,
            ..
        } => {
            let strike = Strike {
                speed,
                angle_deg,
                elevation_deg,
                cue_mass,
                end_mass,
                side,
                top,
            };
            let Motion { velocity, spin } = strike.motion(mass, radius);
            (state.velocity, state.spin) = (velocity, spin);
            Shot::Strike { ball, strike }
        }
    }
}

/// A motion beyond what numbers of a scene may be.
fn too_fast(shot: Shot, path: &str, state: &State, at: &Located<'_>, problems: &mut Problems) {
    let (speed, spin) = (state.speed(), state.spin.norm());
    for (what, size) in [("speed", speed), ("spin", spin)] {
        if size > LARGEST {
            let message = format!(
                "this shot gives a {what} of {}, more than {LARGEST:e}",
                short(size)
            );
            let help = match shot {
                Shot::Force { .. } => "the speed is force * contact_time / mass",
                Shot::Velocity { .. } | Shot::Strike { .. } => {
                    "the speed is up to twice that of the cue, the spin up to 5 times that speed by the radius"
                }
            };
            problems.push(Diagnostic::new(
                Kind::OutOfRange,
                at.key(path),
                message,
                help,
            ));
        }
    }
}

/// A ball has one motion: its own or the shot's.
fn two_motions(
    file: &SceneFile,
    at: &Located<'_>,
    path: &str,
    listed: Option<usize>,
    problems: &mut Problems,
) {
    let Some((i, ball)) = listed.and_then(|i| Some((i, file.balls.get(i)?))) else {
        return;
    };
    let id = &ball.id;
    let strikes = matches!(file.shot, Some(ShotFile::Strike { .. }));
    let both = [
        (ball.velocity.is_some(), "velocity", "velocities"),
        (strikes && ball.spin.is_some(), "spin", "spins"),
    ];
    for (_, what, plural) in both.iter().filter(|(given, _, _)| *given) {
        let message = format!("two {plural} for ball \"{id}\": its own and the shot's");
        let help = format!("remove `{what}` from the ball, or remove the shot");
        let own = at.value(&format!("balls[{i}].{what}"));
        let problem = Diagnostic::new(Kind::TwoLaws, at.key(path), message, help)
            .labelled("the shot")
            .and(own, format!("its own {what}"));
        problems.push(problem);
    }
}

/// A strike turns the ball, and its tip must meet it.
fn strike(file: &SceneFile, at: &Located<'_>, problems: &mut Problems) {
    let Some(ShotFile::Strike { side, top, .. }) = file.shot else {
        return;
    };
    if !file.effects.rotates() {
        let message = "a strike turns the ball, and no effect of the scene lets a ball turn";
        let help =
            "name `[effects.cloth.rotational]`, or set the ball in motion by `[shot.velocity]`";
        let span = at.key("shot.strike");
        problems.push(Diagnostic::new(Kind::NoEffect, span, message, help));
    }
    if side * side + top * top >= 1.0 {
        let (larger, other) = if side.abs() >= top.abs() {
            ("side", "top")
        } else {
            ("top", "side")
        };
        let message = format!(
            "a tip {} radii from the centre does not meet the ball",
            short(side.hypot(top))
        );
        let help = "side^2 + top^2 must be less than 1; a tip slips beyond about 0.5 radii";
        let span = at.value(&format!("shot.strike.{larger}"));
        let mut problem = Diagnostic::new(Kind::OutOfRange, span, message, help);
        if side != 0.0 && top != 0.0 {
            problem = problem.and(at.value(&format!("shot.strike.{other}")), "and here");
        }
        problems.push(problem);
    }
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
