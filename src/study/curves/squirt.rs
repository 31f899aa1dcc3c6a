//! Squirt: by how much a ball leaves off the cue's direction, against the offset of the tip.
//!
//! Published: D. Alciatore, technical proof TP A.31, `tan q = 5/2 a sqrt(1 - a^2) / (1 + m/m_e + 5/2 (1 - a^2))`. Points: an independent
//! program, pooltool 0.6.0.

use super::{Curve, DEGREES, Departure, Lab, line};
use crate::finding::{Axis, Figure, Style};
use crate::physics::cue::Strike;
use crate::scene::{Scene, SceneError, Shot, catalogue};

/// The independent program's strikes, whose end mass is a thirtieth of the ball.
const STRIKES: &str = include_str!("../../../validation/references/f_cue_strike.csv");
/// Ball masses in the end mass of a cue: low squirt, typical, high squirt.
const RATIOS: [f64; 3] = [60.0, 30.0, 15.0];
/// The ratio of the independent program.
const TYPICAL: f64 = 30.0;
/// Offsets at which engines are asked, R.
const ASKED: [f64; 5] = [0.1, 0.2, 0.3, 0.4, 0.5];

/// The published deflection, degrees to the right of the cue's direction. `a`: offset to the left, R.
pub(super) fn published(a: f64, ball_in_end_mass: f64) -> f64 {
    let inward = 1.0 - a * a;
    let tangent = 2.5 * a * inward.sqrt() / (1.0 + ball_in_end_mass + 2.5 * inward);
    tangent.atan().to_degrees()
}

pub(super) fn curve(lab: &Lab<'_>) -> Result<Curve, SceneError> {
    let (mut shots, mut series) = (Vec::new(), Vec::new());
    for ratio in RATIOS {
        let offsets = (0..=55).map(|k| 0.01 * f64::from(k));
        let points = offsets.map(|a| [a, published(a, ratio)]).collect();
        let name = format!("published, end mass m/{ratio}");
        series.push(line(name, points, Style::Line));
        for a in ASKED {
            shots.push((a, level_strike(a, ratio)?, published(a, ratio)));
        }
    }
    let (points, mut departures) = lab.points(&shots, "published formula", DEGREES, |trace, _| {
        let launched = trace.paths.first()?.knots.first()?.state.velocity;
        Some(launched.x.atan2(launched.y).to_degrees())
    });
    let program = independent();
    let mut departure = Departure {
        who: "pooltool".to_owned(),
        from: "published formula",
        points: 0,
        largest: None,
        unit: DEGREES,
        missing: Vec::new(),
    };
    for [a, deflection] in &program {
        departure.note((deflection - published(*a, TYPICAL)).abs());
    }
    departures.push(departure);
    series.push(line("pooltool, end mass m/30", program, Style::Points));
    series.extend(points);
    let figure = Figure {
        id: "squirt".to_owned(),
        title: "Squirt of level strikes".to_owned(),
        caption: "Angle between the ball's path and the cue's direction, away from the side that is struck.".to_owned(),
        x: Axis::linear("offset of the tip", "R"),
        y: Axis::linear("deflection", "degrees"),
        equal_scale: false,
        outline: None,
        series,
        marks: Vec::new(),
    };
    Ok(Curve {
        figures: vec![figure],
        departures,
    })
}

/// Offset to the left and deflection to the right of the independent program's level strikes, each offset once.
fn independent() -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = Vec::new();
    for row in STRIKES.lines().skip(1) {
        let numbers: Vec<f64> = row
            .split(',')
            .filter_map(|cell| cell.parse().ok())
            .collect();
        // V0_cue, theta_deg, a_side, ..., deflection to the left in the last column
        let (Some(&elevation), Some(&a), Some(&left)) =
            (numbers.get(1), numbers.get(2), numbers.last())
        else {
            continue;
        };
        let known = points.iter().any(|[known, _]| *known == a);
        if elevation == 0.0 && a > 0.0 && !known {
            points.push([a, -left]);
        }
    }
    points
}

fn level_strike(a: f64, ball_in_end_mass: f64) -> Result<Scene, SceneError> {
    let mut scene = catalogue::scene("side")?;
    let ball = &mut scene.balls[0];
    let strike = Strike {
        speed: 1.0,
        angle_deg: 90.0,
        elevation_deg: 0.0,
        cue_mass: 0.567,
        end_mass: Some(ball.mass / ball_in_end_mass),
        side: a,
        top: 0.0,
    };
    let motion = strike.motion(ball.mass, ball.radius);
    (ball.state.velocity, ball.state.spin) = (motion.velocity, motion.spin);
    scene.shot = Some(Shot::Strike { ball: 0, strike });
    scene.duration = 0.01;
    Ok(scene)
}
