//! Five shots of a paper with its measured numbers: S. Mathavan, M. Jackson, R. Parkin, "Numerical simulations of the frictional collisions of
//! solid balls on a rough surface", Sports Engineering 17 (2014), tables 1 and 2.
//!
//! The paper integrates the friction of the cloth during the impact, the laws here do not: they are expected within 2 %.

use super::{GAP, Lab};
use crate::finding::{Cell, Column, Table, Tone};
use crate::math::Vec3;
use crate::math::angle::unit_vector;
use crate::physics::{Cloth, Contact, Friction};
use crate::scene::{Scene, SceneError, catalogue};
use crate::trace::{EventKind, Trace};

/// The paper's shots and numbers, as transcribed by an independent program.
const SHOTS: &str = include_str!("../../../validation/references/b_mathavan2014_paper.csv");
/// Snooker balls, m and kg.
const RADIUS: f64 = 0.02625;
const MASS: f64 = 0.1406;

/// One shot: the paper's input and answers. Speeds in m/s once both balls roll, angles in degrees from the incoming direction.
struct Shot {
    speed: f64,
    topspin: f64,
    cut: f64,
    paper: [f64; 4],
}

/// What the paper gives of each shot: heading and unit.
const ANSWERS: [(&str, &str); 4] = [
    ("cue ball", "m/s"),
    ("struck", "m/s"),
    ("cue ball", "degrees"),
    ("struck", "degrees"),
];

pub(super) fn table(lab: &Lab<'_>) -> Result<Table, SceneError> {
    let mut columns = vec![
        Column::number("speed", "speed", "m/s"),
        Column::number("cut", "cut", "degrees"),
        Column::words("who", "who"),
    ];
    for (k, (title, unit)) in ANSWERS.into_iter().enumerate() {
        columns.push(Column::number(&format!("answer-{}", k + 1), title, unit));
    }
    columns.push(Column::number("departure", "largest departure", "%"));
    let mut rows = Vec::new();
    for shot in shots() {
        let row = |who: Cell, answers: Option<[f64; 4]>, departure: Cell| {
            let mut row = vec![Cell::Fixed(shot.speed, 3), Cell::Fixed(shot.cut, 2), who];
            row.extend(match answers {
                Some(answers) => answers.map(|x| Cell::Fixed(x, 3)),
                None => [const { Cell::Empty }; 4],
            });
            row.push(departure);
            row
        };
        rows.push(row(Cell::text("the paper"), Some(shot.paper), Cell::Empty));
        for (column, answer) in lab.columns.iter().zip(lab.run(&scene(&shot)?)) {
            let label = column.label();
            let ours = answer.ok().and_then(|trace| once_rolling(&trace));
            let off = ours.map(|ours| {
                let parts = ours.iter().zip(&shot.paper);
                let parts = parts.map(|(a, b)| (a / b - 1.0).abs());
                100.0 * parts.fold(0.0, crate::math::worse)
            });
            let who = match ours {
                Some(_) => Cell::Text(label),
                None => Cell::verdict(Tone::Quiet, format!("{label}: no answer")),
            };
            rows.push(row(who, ours, Cell::maybe(off)));
        }
    }
    Ok(Table {
        id: "shots-2014".to_owned(),
        title: "Five measured shots (Mathavan, Jackson, Parkin 2014)".to_owned(),
        columns,
        rows,
        note: "Speeds and directions once both balls roll; e = 0.89, friction 0.05 between the balls and 0.21 on the cloth. The paper \
               lets the cloth act during the impact, and is expected within 2 %."
            .to_owned(),
    })
}

fn shots() -> Vec<Shot> {
    let mut lines = SHOTS.lines();
    let heading: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let read = |row: &str| -> Option<Shot> {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |name: &str| -> Option<f64> {
            let place = heading.iter().position(|known| *known == name)?;
            cells.get(place)?.parse().ok()
        };
        Some(Shot {
            speed: number("V0")?,
            topspin: number("topspin_rad_s")?,
            cut: number("cut_deg")?,
            paper: [
                number("paper_v1")?,
                number("paper_v2")?,
                number("paper_theta1")?,
                number("paper_theta2")?,
            ],
        })
    };
    let mut shots: Vec<Shot> = lines.filter_map(read).collect();
    // the file has each shot with two resolutions of its own integration
    shots.dedup_by(|next, kept| next.speed == kept.speed && next.cut == kept.cut);
    shots
}

/// The cue ball along +y, a moment before it cuts the other.
fn scene(shot: &Shot) -> Result<Scene, SceneError> {
    let mut scene = catalogue::scene("throw")?;
    scene.balls.truncate(2);
    for ball in &mut scene.balls {
        (ball.radius, ball.mass, ball.state.position.z) = (RADIUS, MASS, RADIUS);
    }
    scene.effects.cloth = Some(Cloth::Rotational {
        mu_slide: 0.21,
        mu_roll: 0.0,
        mu_spin: 0.0,
    });
    scene.effects.contact = Some(Contact::Inelastic { e: 0.89 });
    scene.effects.friction = Some(Friction::Constant { mu: 0.05 });
    let (cos, sin) = unit_vector(shot.cut);
    scene.balls[0].state.velocity = Vec3::new(0.0, shot.speed, 0.0);
    scene.balls[0].state.spin = Vec3::new(-shot.topspin, 0.0, 0.0);
    scene.balls[1].state.position = Vec3::new(2.0 * RADIUS * sin, 2.0 * RADIUS * cos + GAP, RADIUS);
    scene.duration = 2.0;
    Ok(scene)
}

/// Speeds and directions of both balls once they roll: `[v1, v2, theta1, theta2]`.
fn once_rolling(trace: &Trace) -> Option<[f64; 4]> {
    let velocity = |ball: usize| {
        let last = trace
            .events
            .iter()
            .rposition(|event| event.kind == EventKind::SlideToRoll(ball as u32))?;
        let mut knots = trace.paths[ball].knots.iter();
        let knot = knots.find(|knot| knot.after == Some(last as u32))?;
        Some(knot.state.velocity)
    };
    let (cue, struck) = (velocity(0)?, velocity(1)?);
    let angle = |v: Vec3| v.x.abs().atan2(v.y).to_degrees();
    Some([cue.norm(), struck.norm(), angle(cue), angle(struck)])
}
