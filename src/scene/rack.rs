//! The triangle of a `[rack]`: geometry of `[rack]`, and its optional displacements.

use super::Ball;
use super::check::missing;
use super::file::{RackFile, SceneFile};
use super::located::Located;
use super::placed::Placed;
use super::problems::Problems;
use crate::math::Vec3;
use crate::math::random::Draws;
use crate::physics::State;

/// Balls "1", "2", ... of the rack, row by row from the apex, x ascending; none if something is missing.
pub(super) fn balls(file: &SceneFile, at: &Located<'_>, problems: &mut Problems) -> Vec<Placed> {
    let Some(rack) = &file.rack else {
        return Vec::new();
    };
    let span = at.value("rack");
    for (number, what) in [(file.ball.radius, "radius"), (file.ball.mass, "mass")] {
        if number.is_none() {
            let message = format!("the balls of the rack have no {what}");
            let help = format!("add `{what}` to `[ball]`");
            let problem = missing(span.clone(), message, help).labelled("this rack");
            problems.push(problem.wanting(format!("ball.{what}")));
        }
    }
    if rack.jitter.is_some() && rack.seed.is_none() {
        let message = "jitter needs a `seed`, so that the scene is the same every time";
        let help = "add `seed` to `[rack]`, any whole number";
        let span = at.value("rack.jitter");
        let problem = missing(span, message, help).labelled("here");
        problems.push(problem.wanting("rack.seed"));
    }
    let (Some(radius), Some(mass)) = (file.ball.radius, file.ball.mass) else {
        return Vec::new();
    };
    let place = |(i, [x, y]): (usize, [f64; 2])| Placed {
        ball: Ball {
            id: (i + 1).to_string(),
            radius,
            mass,
            state: State::at_rest(Vec3::new(x, y, radius)),
        },
        path: "rack".to_owned(),
    };
    centres(rack, radius)
        .into_iter()
        .enumerate()
        .map(place)
        .collect()
}

/// Centres of the rack's balls: neighbours `2 R + gap` apart, rows `sqrt(3)/2` of that, then each displaced by its own draw.
fn centres(rack: &RackFile, radius: f64) -> Vec<[f64; 2]> {
    let pitch = 2.0 * radius + rack.gap;
    let row_distance = pitch * (3.0_f64.sqrt() / 2.0);
    let mut centres = Vec::new();
    for row in 0..rack.rows {
        for place in 0..=row {
            // in half pitches from the axis, so that both sides are mirror images
            let half_pitches = f64::from(2 * i16::from(place) - i16::from(row));
            centres.push([
                rack.apex[0] + half_pitches * (pitch / 2.0),
                rack.apex[1] + f64::from(row) * row_distance,
            ]);
        }
    }
    if let (Some(jitter), Some(seed)) = (rack.jitter, rack.seed) {
        for (i, centre) in centres.iter_mut().enumerate() {
            let (dx, dy) = Draws::new(seed, i as u64).in_disc(jitter);
            *centre = [centre[0] + dx, centre[1] + dy];
        }
    }
    centres
}
