//! Traces that tell of wrong laws: each changes one thing on one side of an event and leaves the rest as it was.

use carom::math::Vec3;
use carom::physics::{Cushion, Side, State};
use carom::scene::Scene;
use carom::trace::{EventKind, Trace};

/// Changes the far side of each jump of one ball: the scene, the event's kind, ball, near and far side.
fn jumps(trace: &mut Trace, mut change: impl FnMut(EventKind, usize, State, &mut State)) {
    for (ball, path) in trace.paths.iter_mut().enumerate() {
        for i in 1..path.knots.len() {
            if let Some(event) = path.knots[i].after {
                let near = path.knots[i - 1].state;
                let kind = trace.events[event as usize].kind;
                change(kind, ball, near, &mut path.knots[i].state);
            }
        }
    }
}

/// Balls of unequal radii touch where their radii add up in plan.
pub fn touch_at_the_sum(scene: &Scene, trace: &mut Trace) {
    let hits: Vec<(usize, usize, u32)> = trace
        .events
        .iter()
        .enumerate()
        .filter_map(|(i, event)| match event.kind {
            EventKind::BallBall(a, b) => Some((a as usize, b as usize, i as u32)),
            _ => None,
        })
        .collect();
    for (a, b, event) in hits {
        let sum = scene.balls[a].radius + scene.balls[b].radius;
        let at = |trace: &Trace, ball: usize| {
            let knots = &trace.paths[ball].knots;
            knots
                .iter()
                .position(|knot| knot.after == Some(event))
                .unwrap()
        };
        let (i, j) = (at(trace, a), at(trace, b));
        let from = trace.paths[a].knots[i].state.position;
        let line = trace.paths[b].knots[j].state.position - from;
        let plan = Vec3::new(line.x, line.y, 0.0);
        let moved = plan * (sum / plan.norm() - 1.0);
        for knot in &mut trace.paths[b].knots[j - 1..=j] {
            knot.state.position += moved;
        }
    }
}

pub fn spin_reversed(_: &Scene, trace: &mut Trace) {
    jumps(trace, |kind, _, _, far| {
        if let EventKind::BallBall(..) = kind {
            far.spin = -far.spin;
        }
    });
}

/// The second ball of a hit goes on as if nothing were.
pub fn one_ball_only(_: &Scene, trace: &mut Trace) {
    jumps(trace, |kind, ball, near, far| {
        if let EventKind::BallBall(_, second) = kind
            && second as usize == ball
        {
            *far = near;
        }
    });
}

pub fn side_forgotten(_: &Scene, trace: &mut Trace) {
    jumps(trace, |kind, _, _, far| {
        if let EventKind::BallCushion(..) = kind {
            far.spin.z = 0.0;
        }
    });
}

pub fn han_never_sticks(scene: &Scene, trace: &mut Trace) {
    han_friction(scene, trace, |limit, _| limit);
}

pub fn han_always_sticks(scene: &Scene, trace: &mut Trace) {
    han_friction(scene, trace, |_, sticking| sticking);
}

/// Friction of Han's cushion of another size, from its limit and what ends the slip.
fn han_friction(scene: &Scene, trace: &mut Trace, size: fn(f64, f64) -> f64) {
    let Some(Cushion::Han2005 { e, mu, height }) = scene.effects.cushion else {
        return;
    };
    jumps(trace, |kind, ball, near, far| {
        let EventKind::BallCushion(_, side) = kind else {
            return;
        };
        let radius = scene.balls[ball].radius;
        let sin = height - 1.0;
        let cos = (1.0 - sin * sin).sqrt();
        let into = match side {
            Side::X0 => -Vec3::x(),
            Side::X1 => Vec3::x(),
            Side::Y0 => -Vec3::y(),
            Side::Y1 => Vec3::y(),
        };
        let nose = into * cos + Vec3::z() * sin;
        let closing = near.velocity.dot(&nose);
        let slip = near.velocity - nose * closing + near.spin.cross(&nose) * radius;
        let normal = (1.0 + e) * closing;
        let speed = slip.norm();
        if speed > 0.0 {
            let push = slip * (-size(mu * normal, 2.0 / 7.0 * speed) / speed);
            far.velocity = near.velocity - nose * normal + push;
            far.velocity.z = 0.0;
            far.spin = near.spin + nose.cross(&push) * (2.5 / radius);
        }
    });
}

pub fn position_drifts(scene: &Scene, trace: &mut Trace) {
    let rate = 1e-6 * scene.largest_speed();
    for knot in trace.paths.iter_mut().flat_map(|path| &mut path.knots) {
        knot.state.position.x += rate * knot.time;
    }
}

/// What moves freely has stopped when it comes to the next knot.
pub fn stops_early(scene: &Scene, trace: &mut Trace) {
    if scene.effects.cloth.is_some() {
        return;
    }
    for path in &mut trace.paths {
        if let Some(last) = path.knots.last_mut().filter(|knot| knot.after.is_none()) {
            last.state.velocity = Vec3::zeros();
        }
    }
}

pub fn event_not_told(_: &Scene, trace: &mut Trace) {
    if let Some(event) = trace.events.iter_mut().find(|e| e.kind.is_collision()) {
        event.kind = EventKind::Stop(0);
    }
}
