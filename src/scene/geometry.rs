//! Where balls may be: on the table, apart from each other, and at coordinates that f64 resolves.

use super::Scene;
use super::diagnostics::{Diagnostic, Kind};
use super::located::Located;
use crate::physics::Side;

/// Largest share of a radius that "touching" may be: beyond it coordinates are too large to hold the ball.
const COARSEST: f64 = 1e-6;

/// Errors of one kind that are reported at most: a file with a thousand balls in one place needs no million lines.
const MOST: usize = 100;

/// Checks a scene whose balls come from `paths`, in scene order.
pub(super) fn check(
    scene: &Scene,
    paths: &[String],
    at: &Located<'_>,
    problems: &mut Vec<Diagnostic>,
) {
    if scene.balls.is_empty() {
        return;
    }
    if scene.touching() > COARSEST * scene.smallest_radius() {
        problems.push(too_far_out(scene, paths, at));
        return;
    }
    outside(scene, paths, at, problems);
    overlaps(scene, paths, at, problems);
}

fn too_far_out(scene: &Scene, paths: &[String], at: &Located<'_>) -> Diagnostic {
    let largest = scene.largest_coordinate();
    let is_it = |position: &crate::math::Vec3| position.x.abs().max(position.y.abs()) == largest;
    let ball = scene.balls.iter().position(|b| is_it(&b.state.position));
    let span = ball.map_or_else(|| at.value("table"), |i| at.value(&paths[i]));
    let radius = scene.smallest_radius();
    let message = format!(
        "a coordinate of {largest:e} is too large for balls of radius {radius:e}: rounding would move them"
    );
    let help = "move the scene nearer to the origin, or use larger balls";
    Diagnostic::new(Kind::OutOfRange, span, message, help)
}

fn outside(scene: &Scene, paths: &[String], at: &Located<'_>, problems: &mut Vec<Diagnostic>) {
    let Some(table) = scene.table else {
        return;
    };
    let slack = scene.touching();
    let mut found = 0;
    for (ball, path) in scene.balls.iter().zip(paths) {
        let out = Side::ALL.into_iter().find_map(|side| {
            let outward = f64::from(side.sign());
            let past =
                outward * (ball.state.position[side.axis()] - table.reach(side, ball.radius));
            (past > slack).then_some((side, past))
        });
        if let Some((side, past)) = out
            && found < MOST
        {
            found += 1;
            let message = format!(
                "ball \"{}\" is outside the table: past {} by {}",
                ball.id,
                side.id(),
                short(past)
            );
            let reach = |side| short(table.reach(side, ball.radius));
            let help = format!(
                "its centre must have x from {} to {} and y from {} to {}",
                reach(Side::X0),
                reach(Side::X1),
                reach(Side::Y0),
                reach(Side::Y1)
            );
            problems.push(Diagnostic::new(
                Kind::Outside,
                at.value(path),
                message,
                help,
            ));
        }
    }
}

fn overlaps(scene: &Scene, paths: &[String], at: &Located<'_>, problems: &mut Vec<Diagnostic>) {
    let slack = scene.touching();
    let largest = scene.balls.iter().map(|b| b.radius).fold(0.0, f64::max);
    let x = |i: usize| scene.balls[i].state.position.x;
    let mut by_x: Vec<usize> = (0..scene.balls.len()).collect();
    by_x.sort_by(|&a, &b| x(a).total_cmp(&x(b)).then(a.cmp(&b)));
    let mut found = 0;
    for (k, &i) in by_x.iter().enumerate() {
        let near = by_x[k + 1..]
            .iter()
            .take_while(|&&j| x(j) - x(i) <= 2.0 * largest);
        for &j in near {
            let apart = scene.balls[i].state.position - scene.balls[j].state.position;
            let distance = apart.xy().norm();
            let overlap = scene.contact_distance(i, j) - distance;
            if overlap > slack && found < MOST {
                found += 1;
                problems.push(overlap_of(scene, paths, at, (i.min(j), i.max(j)), overlap));
            }
        }
    }
}

fn overlap_of(
    scene: &Scene,
    paths: &[String],
    at: &Located<'_>,
    (first, second): (usize, usize),
    overlap: f64,
) -> Diagnostic {
    let shown = |i: usize| {
        let ball = &scene.balls[i];
        let position = ball.state.position;
        format!(
            "\"{}\" at [{}, {}]",
            ball.id,
            short(position.x),
            short(position.y)
        )
    };
    let message = format!(
        "balls {} and {} overlap by {}",
        shown(first),
        shown(second),
        short(overlap)
    );
    let help = format!(
        "their centres must be at least {} apart",
        short(scene.contact_distance(first, second))
    );
    // a ball of the rack has no position of its own in the file: mark the other one, if it has
    let (mark, other) = if paths[second] == "rack" {
        (first, second)
    } else {
        (second, first)
    };
    let problem = Diagnostic::new(Kind::Overlap, at.value(&paths[mark]), message, help);
    if paths[mark] == paths[other] {
        return problem;
    }
    problem.and(
        at.value(&paths[other]),
        format!("ball \"{}\"", scene.balls[other].id),
    )
}

/// A number with at most six significant digits, as a person would write it.
fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    if rounded == 0.0 || (1e-3..1e6).contains(&rounded.abs()) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}
