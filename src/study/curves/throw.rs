//! Throw: by how much the struck ball leaves off the line of centres, against the cut angle, for stun shots at three speeds.
//!
//! Published: D. Alciatore, "The amount of throw", technical proofs TP A.14 and A.28. Where the surfaces slip the throw is the coefficient of
//! friction at the slip speed, `tan th = mu(v sin phi)`; where they stick it is `2 tan phi / (7 (1 + e))`, the smaller of the two.

use super::{Curve, DEGREES, GAP, Lab, line, velocity_after};
use crate::finding::{Axis, Figure, Style};
use crate::math::Vec3;
use crate::math::angle::unit_vector;
use crate::physics::friction::alciatore;
use crate::physics::{Contact, Friction};
use crate::scene::{Scene, SceneError, catalogue};

/// Metres per second in a mile per hour.
const MILE_PER_HOUR: f64 = 0.44704;
/// Slow, medium, fast: the speeds of the published plots, mph.
const SPEEDS: [f64; 3] = [1.0, 3.0, 7.0];
/// Restitution of the balls.
const E: f64 = 0.95;
/// Cut angles at which engines are asked, degrees.
const ASKED: [f64; 9] = [5.0, 10.0, 15.0, 20.0, 30.0, 40.0, 50.0, 60.0, 75.0];

/// The published throw of a stun shot, degrees. `speed`: m/s; `cut`: degrees.
pub(super) fn published(speed: f64, cut: f64) -> f64 {
    let (cos, sin) = unit_vector(cut);
    let slipping = alciatore::coefficient(alciatore::PUBLISHED, speed * sin);
    let sticking = 2.0 * sin / cos / (7.0 * (1.0 + E));
    slipping.min(sticking).atan().to_degrees()
}

pub(super) fn curve(lab: &Lab<'_>) -> Result<Curve, SceneError> {
    let mut shots = Vec::new();
    let mut series = Vec::new();
    for mph in SPEEDS {
        let speed = mph * MILE_PER_HOUR;
        let line_of = (1..=170).map(|k| 0.5 * f64::from(k));
        let points = line_of.map(|cut| [cut, published(speed, cut)]).collect();
        series.push(line(format!("published, {mph} mph"), points, Style::Line));
        for cut in ASKED {
            shots.push((cut, stun_shot(speed, cut)?, published(speed, cut)));
        }
    }
    let (points, departures) =
        lab.points(&shots, "published closed form", DEGREES, |trace, cut| {
            let velocity = velocity_after(trace, 1)?;
            Some(cut - velocity.x.atan2(velocity.y).to_degrees())
        });
    series.extend(points);
    let figure = Figure {
        id: "throw".to_owned(),
        title: "Throw of stun shots".to_owned(),
        caption: "Angle between the struck ball's path and the line of centres, for equal balls with e = 0.95 and the published \
                  friction; lines: sticking up to the kink, slipping beyond."
            .to_owned(),
        x: Axis::linear("cut angle", "degrees"),
        y: Axis::linear("throw", "degrees"),
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

/// A ball without spin, along +y, a moment before it cuts another by `cut` degrees.
fn stun_shot(speed: f64, cut: f64) -> Result<Scene, SceneError> {
    let mut scene = catalogue::scene("throw")?;
    scene.balls.truncate(2);
    let [a, b, c] = alciatore::PUBLISHED;
    scene.effects.contact = Some(Contact::Inelastic { e: E });
    scene.effects.friction = Some(Friction::Alciatore {
        a,
        b,
        c,
        length_in_metres: 1.0,
    });
    let (cos, sin) = unit_vector(cut);
    let distance = scene.contact_distance(0, 1);
    let radius = scene.balls[0].radius;
    scene.balls[0].state.velocity = Vec3::new(0.0, speed, 0.0);
    scene.balls[1].state.position = Vec3::new(distance * sin, distance * cos + GAP, radius);
    // a moment is enough
    scene.duration = 0.01;
    Ok(scene)
}
