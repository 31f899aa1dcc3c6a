//! Where balls may be: on the table, apart from each other, outside pockets, and at coordinates that f64 resolves.

use super::diagnostics::{Diagnostic, Kind, short};
use super::located::Located;
use super::problems::Problems;
use super::{Ball, Scene};
use crate::math::grid::Grid;
use crate::physics::contact::plan_distance;
use crate::physics::{Side, pockets};

/// Largest share of a radius that "touching" may be: beyond it coordinates are too large to hold the ball.
const COARSEST: f64 = 1e-6;

/// Errors of one kind that are reported at most: a file with a thousand balls in one place needs no million lines.
const MOST: usize = 100;

/// Checks a scene whose balls come from `paths`, in scene order.
pub(super) fn check(scene: &Scene, paths: &[String], at: &Located<'_>, problems: &mut Problems) {
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

fn outside(scene: &Scene, paths: &[String], at: &Located<'_>, problems: &mut Problems) {
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

fn overlaps(scene: &Scene, paths: &[String], at: &Located<'_>, problems: &mut Problems) {
    let slack = scene.touching();
    let overlapping = pairs_within(&scene.balls, 0.0).filter(|(_, gap)| -gap > slack);
    let found = overlapping.take(MOST);
    problems.extend(found.map(|(pair, gap)| overlap_of(scene, paths, at, pair, -gap)));
}

/// Pairs of balls whose surfaces are at most `reach` apart in plan, length, with their gap; negative where they overlap.
pub(super) fn pairs_within(
    balls: &[Ball],
    reach: f64,
) -> impl Iterator<Item = ((usize, usize), f64)> {
    let largest = balls.iter().map(|b| b.radius).fold(0.0, f64::max);
    let centre = |ball: &Ball| [ball.state.position.x, ball.state.position.y];
    let centres: Vec<[f64; 2]> = balls.iter().map(centre).collect();
    // wider than a contact, so that no overlap is hidden by rounding
    let grid = Grid::over(&centres, 2.5 * largest + reach, centres.len());
    let square = |i: usize| grid.square(grid.place(centres[i]));
    let mut order: Vec<(usize, usize)> = (0..centres.len()).map(|i| (square(i), i)).collect();
    order.sort_unstable();
    let near = (0..centres.len()).flat_map(move |i| {
        let rows = grid.around(grid.place(centres[i])).into_iter();
        let first = |square: usize| order.partition_point(|entry| entry.0 < square);
        let balls = rows.flat_map(|row| &order[first(row.start)..first(row.end)]);
        let before = balls.filter(|(_, j)| *j < i);
        before.map(|(_, j)| (*j, i)).collect::<Vec<_>>()
    });
    near.filter_map(move |(i, j)| {
        let apart = balls[i].state.position - balls[j].state.position;
        let gap = apart.xy().norm() - plan_distance(balls[i].radius, balls[j].radius);
        (gap <= reach).then_some(((i, j), gap))
    })
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

fn in_pockets(scene: &Scene, paths: &[String], at: &Located<'_>, problems: &mut Problems) {
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
