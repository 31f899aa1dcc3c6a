//! Where balls may be: on the table, apart from each other, outside pockets, and at coordinates that f64 resolves.

use super::Scene;
use super::diagnostics::{Diagnostic, Kind, short};
use super::located::Located;
use crate::physics::{Side, pockets};

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
    in_pockets(scene, paths, at, problems);
}

fn too_far_out(scene: &Scene, paths: &[String], at: &Located<'_>) -> Diagnostic {
    let largest = scene.largest_coordinate();
    let is_it = |position: &crate::math::Vec3| position.x.abs().max(position.y.abs()) == largest;
    let ball = scene.balls.iter().position(|b| is_it(&b.state.position));
    let span = ball.map_or_else(|| at.value("table"), |i| at.value(&paths[i]));
    let radius = scene.smallest_radius();
    let message = format!(
        "a coordinate of {} is too large for balls of radius {}: rounding would move them",
        short(largest),
        short(radius)
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
    // sweep along the axis on which the balls spread more, so that a row of many balls stays cheap
    let spread = |axis: usize| {
        let along = scene.balls.iter().map(|b| b.state.position[axis]);
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        high - low
    };
    let axis = usize::from(spread(1) > spread(0));
    let along = |i: usize| scene.balls[i].state.position[axis];
    let mut order: Vec<usize> = (0..scene.balls.len()).collect();
    order.sort_by(|&a, &b| along(a).total_cmp(&along(b)).then(a.cmp(&b)));
    let near = order.iter().enumerate().flat_map(|(k, &i)| {
        let after = order[k + 1..].iter();
        let near = after.take_while(move |&&j| along(j) - along(i) <= 2.0 * largest);
        near.map(move |&j| (i.min(j), i.max(j)))
    });
    let overlapping = near.filter_map(|(i, j)| {
        let apart = scene.balls[i].state.position - scene.balls[j].state.position;
        let overlap = scene.contact_distance(i, j) - apart.xy().norm();
        (overlap > slack).then_some((i, j, overlap))
    });
    let found = overlapping.take(MOST);
    problems.extend(found.map(|(i, j, overlap)| overlap_of(scene, paths, at, (i, j), overlap)));
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

fn in_pockets(scene: &Scene, paths: &[String], at: &Located<'_>, problems: &mut Vec<Diagnostic>) {
    let Some(pockets) = &scene.effects.pockets else {
        return;
    };
    let held = |ball: &super::Ball| pockets::holding(pockets, &ball.state.position);
    let balls = scene.balls.iter().zip(paths);
    let found = balls.filter_map(|(ball, path)| Some((ball, path, held(ball)?)));
    problems.extend(found.take(MOST).map(|(ball, path, pocket)| {
        let [x, y, r] = pockets.circles[pocket];
        let message = format!("ball \"{}\" starts in pocket p{pocket}", ball.id);
        let help = format!(
            "its centre must be more than {} from [{}, {}], or the pocket elsewhere",
            short(r),
            short(x),
            short(y)
        );
        let circle = at.value(&format!("effects.pockets.circles[{pocket}]"));
        Diagnostic::new(Kind::Overlap, at.value(path), message, help).and(circle, "this pocket")
    }));
}
