//! Wrong laws in random scenes: each must be flagged by the closed forms that are written apart, with a fault that names the law.
//!
//! Most of them keep energy, edges and overlaps, which is all that random scenes were held to before.

use super::engines::{Fault, Wrong};
use super::slip::Slip;
use carom::engine::Setting;
use carom::math::Vec3;
use carom::physics::{Cloth, Contact, Cushion, Friction, Side};
use carom::scene::Scene;
use carom::study::matrix::{Column, Watch};
use carom::study::random::{Outcome, Plan, study};
use carom::trace::{EventKind, Trace};
use std::sync::atomic::AtomicBool;

/// Enough for each law with numbers that show it.
const SCENES: u64 = 400;

const SEED: u64 = 7;

const EXACT: &str = "exact";
const STEPPER: &str = "stepper";

/// One wrong law: the engine, what is wrong, the fault that must be seen, and a word of the law that it names.
type Mutant = (&'static str, Fault, &'static str, &'static str);

fn outcome(engine: &str, fault: Fault, scenes: u64) -> Outcome {
    static NEVER: AtomicBool = AtomicBool::new(false);
    let rule = (engine == STEPPER).then_some("contact=approaching-only");
    let plan = Plan {
        first: 0,
        scenes,
        seed: SEED,
        columns: vec![Column {
            engine: Wrong::engine(engine, fault),
            setting: Setting::parse(rule).unwrap(),
        }],
        max_events: 100,
    };
    let watch = Watch {
        progress: &|_, _, _| {},
        cancelled: &NEVER,
    };
    study(plan, watch)
}

#[test]
fn a_wrong_law_is_flagged_by_name_in_some_hundred_random_scenes() {
    let mut missed = Vec::new();
    for (number, (engine, fault, what, law)) in MUTANTS.iter().enumerate() {
        let found = outcome(engine, *fault, SCENES);
        let named = |failure: &&carom::study::random::Failure| {
            failure.fault.what == *what && failure.fault.words.contains(law)
        };
        if found.failures.iter().find(named).is_none() {
            let seen: std::collections::BTreeSet<&str> =
                found.failures.iter().map(|f| f.fault.what).collect();
            missed.push(format!("{number}: {engine} {what} {law}: {seen:?}"));
        }
    }
    assert!(MUTANTS.len() > 40, "{}", MUTANTS.len());
    assert!(missed.is_empty(), "not flagged:\n{}", missed.join("\n"));
}

#[test]
fn the_engines_as_they_are_are_flagged_by_nothing_where_the_wrong_ones_are() {
    for engine in [EXACT, STEPPER] {
        let found = outcome(engine, Fault::Scene(|_| {}), SCENES);
        assert_eq!(found.failures, [], "{engine}");
        let held = &found.entries[0].laws;
        assert!(
            held.impacts > 2000 && held.pieces > 5000,
            "{engine}: {held:?}"
        );
        assert!(held.integrated > 5, "{engine}: {held:?}");
        // looked at, and not from afar
        assert!(held.impact.value > 1e-3, "{engine}: {held:?}");
        assert!(held.piece.value > 1e-3, "{engine}: {held:?}");
    }
}

const MUTANTS: &[Mutant] = &[
    (
        EXACT,
        Fault::Scene(restitution_squared),
        "hit-restitution",
        "contact.inelastic",
    ),
    (
        EXACT,
        Fault::Scene(always_elastic),
        "hit-restitution",
        "contact.inelastic",
    ),
    (
        EXACT,
        Fault::Scene(not_quite_elastic),
        "hit-restitution",
        "contact.elastic",
    ),
    (
        EXACT,
        Fault::Scene(masses_equal),
        "hit-restitution",
        "contact.",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.effects.friction = None),
        "hit-friction",
        "friction.constant",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.effects.friction = None),
        "hit-spin",
        "friction.alciatore",
    ),
    (
        EXACT,
        Fault::Scene(friction_doubled),
        "hit-friction",
        "friction.constant",
    ),
    (
        EXACT,
        Fault::Scene(friction_pushes),
        "hit-friction",
        "friction.constant",
    ),
    (
        EXACT,
        Fault::Scene(slip_ignored),
        "hit-friction",
        "friction.alciatore",
    ),
    (
        EXACT,
        Fault::Scene(length_unit_ignored),
        "hit-friction",
        "friction.alciatore",
    ),
    (
        EXACT,
        Fault::Scene(falls_twice_as_fast),
        "hit-friction",
        "friction.alciatore",
    ),
    (
        EXACT,
        Fault::Scene(balls_too_large),
        "hit-distance",
        "touch",
    ),
    (
        EXACT,
        Fault::Trace(touch_at_the_sum),
        "hit-distance",
        "touch",
    ),
    (EXACT, Fault::Trace(spin_reversed), "hit-spin", "friction."),
    (
        EXACT,
        Fault::Trace(one_ball_only),
        "hit-momentum",
        "momentum",
    ),
    (
        EXACT,
        Fault::Scene(cushion_squared),
        "cushion-restitution",
        "cushion.restitution",
    ),
    (
        EXACT,
        Fault::Scene(cushion_elastic),
        "cushion-restitution",
        "cushion.restitution",
    ),
    (EXACT, Fault::Scene(cushion_off), "cushion-place", "place"),
    (
        EXACT,
        Fault::Scene(han_squared),
        "cushion-restitution",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Scene(han_friction_off),
        "cushion-friction",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Scene(han_friction_doubled),
        "cushion-spin",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Scene(han_nose_lower),
        "cushion-restitution",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Trace(han_never_sticks),
        "cushion-friction",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Trace(han_always_sticks),
        "cushion-friction",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Scene(mathavan_work_is_speed),
        "cushion-restitution",
        "cushion.mathavan-2010",
    ),
    (
        EXACT,
        Fault::Scene(mathavan_nose_smooth),
        "cushion-friction",
        "cushion.mathavan-2010",
    ),
    (
        EXACT,
        Fault::Scene(mathavan_cloth_smooth),
        "cushion-restitution",
        "cushion.mathavan-2010",
    ),
    (
        EXACT,
        Fault::Trace(side_forgotten),
        "cushion-spin",
        "cushion.elastic",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.gravity /= 2.0),
        "cloth-velocity",
        "cloth.translational",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.gravity /= 2.0),
        "cloth-velocity",
        "cloth.rotational",
    ),
    (
        EXACT,
        Fault::Scene(rolling_doubled),
        "cloth-velocity",
        "cloth.rotational",
    ),
    (
        EXACT,
        Fault::Scene(spinning_doubled),
        "cloth-spin",
        "cloth.rotational",
    ),
    (
        EXACT,
        Fault::Scene(sliding_doubled),
        "cloth-velocity",
        "cloth.rotational",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.effects.cloth = None),
        "cloth-velocity",
        "cloth.translational",
    ),
    (
        EXACT,
        Fault::Trace(position_drifts),
        "cloth-place",
        "cloth.",
    ),
    (
        EXACT,
        Fault::Trace(stops_early),
        "cloth-velocity",
        "no cloth",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.effects.pockets = None),
        "pocket-missed",
        "goes through pocket",
    ),
    (
        EXACT,
        Fault::Scene(pockets_too_small),
        "pocket-place",
        "rim",
    ),
    (EXACT, Fault::Trace(event_not_told), "told", "paths"),
    (
        STEPPER,
        Fault::Step(Slip::RestitutionSquared),
        "hit-restitution",
        "contact.inelastic",
    ),
    (
        STEPPER,
        Fault::Step(Slip::NotQuiteElastic),
        "hit-restitution",
        "contact.elastic",
    ),
    (
        STEPPER,
        Fault::Step(Slip::EnergyLeaks),
        "hit-restitution",
        "contact.",
    ),
    (
        STEPPER,
        Fault::Step(Slip::NormalTurned),
        "hit-friction",
        "no friction between balls",
    ),
    (
        STEPPER,
        Fault::Step(Slip::MassIgnored),
        "hit-momentum",
        "momentum",
    ),
    (
        STEPPER,
        Fault::Step(Slip::StaleContact),
        "hit-parting",
        "contact.",
    ),
    (
        STEPPER,
        Fault::Step(Slip::ThrowOff),
        "hit-friction",
        "friction.constant",
    ),
    (
        STEPPER,
        Fault::Step(Slip::SpinReversed),
        "hit-spin",
        "friction.",
    ),
    (
        STEPPER,
        Fault::Step(Slip::CushionLosesTwice),
        "cushion-restitution",
        "cushion.han-2005",
    ),
    (
        STEPPER,
        Fault::Step(Slip::SideForgotten),
        "cushion-spin",
        "cushion.elastic",
    ),
    (
        STEPPER,
        Fault::Step(Slip::WallForgetsPlace),
        "cushion-place",
        "place",
    ),
    (
        STEPPER,
        Fault::Step(Slip::CornerReversed),
        "corner-order",
        "into both",
    ),
    (
        STEPPER,
        Fault::Step(Slip::FrictionOnOneAxis),
        "cloth-velocity",
        "cloth.translational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::FrictionPushes),
        "cloth-velocity",
        "cloth.translational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::HalfGravity),
        "cloth-velocity",
        "cloth.translational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::RollAtFourSevenths),
        "cloth-spin",
        "cloth.rotational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::RollingDoubled),
        "cloth-velocity",
        "cloth.rotational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::SpinningDoubled),
        "cloth-spin",
        "cloth.rotational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::StepDoubled),
        "cloth-place",
        "cloth.",
    ),
    (
        STEPPER,
        Fault::Step(Slip::PocketMissed),
        "pocket-missed",
        "goes through pocket",
    ),
];

fn restitution_squared(scene: &mut Scene) {
    if let Some(Contact::Inelastic { e }) = &mut scene.effects.contact {
        *e *= *e;
    }
}

fn always_elastic(scene: &mut Scene) {
    scene.effects.contact = scene.effects.contact.map(|_| Contact::Elastic {});
}

fn not_quite_elastic(scene: &mut Scene) {
    if let Some(Contact::Elastic {}) = scene.effects.contact {
        scene.effects.contact = Some(Contact::Inelastic { e: 1.0 - 1e-9 });
    }
}

fn masses_equal(scene: &mut Scene) {
    let mass = scene.balls[0].mass;
    scene.balls.iter_mut().for_each(|ball| ball.mass = mass);
}

fn friction_doubled(scene: &mut Scene) {
    if let Some(Friction::Constant { mu }) = &mut scene.effects.friction {
        *mu *= 2.0;
    }
}

fn friction_pushes(scene: &mut Scene) {
    if let Some(Friction::Constant { mu }) = &mut scene.effects.friction {
        *mu = -*mu;
    }
}

/// The coefficient of a slip of nothing.
fn slip_ignored(scene: &mut Scene) {
    if let Some(Friction::Alciatore { a, b, .. }) = scene.effects.friction {
        scene.effects.friction = Some(Friction::Constant { mu: a + b });
    }
}

fn length_unit_ignored(scene: &mut Scene) {
    if let Some(Friction::Alciatore {
        length_in_metres, ..
    }) = &mut scene.effects.friction
    {
        *length_in_metres = 1.0;
    }
}

fn falls_twice_as_fast(scene: &mut Scene) {
    if let Some(Friction::Alciatore { c, .. }) = &mut scene.effects.friction {
        *c *= 2.0;
    }
}

fn balls_too_large(scene: &mut Scene) {
    scene
        .balls
        .iter_mut()
        .for_each(|ball| ball.radius *= 1.0 + 1e-8);
}

fn cushion_squared(scene: &mut Scene) {
    if let Some(Cushion::Restitution { e }) = &mut scene.effects.cushion {
        *e *= *e;
    }
}

fn cushion_elastic(scene: &mut Scene) {
    if let Some(Cushion::Restitution { .. }) = scene.effects.cushion {
        scene.effects.cushion = Some(Cushion::Elastic {});
    }
}

fn cushion_off(scene: &mut Scene) {
    let off = 1e-6 * scene.smallest_radius();
    if let Some(table) = &mut scene.table {
        table.max[0] += off;
    }
}

fn han(scene: &mut Scene, change: fn(&mut f64, &mut f64, &mut f64)) {
    if let Some(Cushion::Han2005 { e, mu, height }) = &mut scene.effects.cushion {
        change(e, mu, height);
    }
}

fn han_squared(scene: &mut Scene) {
    han(scene, |e, _, _| *e *= *e);
}

fn han_friction_off(scene: &mut Scene) {
    han(scene, |_, mu, _| *mu = 0.0);
}

fn han_friction_doubled(scene: &mut Scene) {
    han(scene, |_, mu, _| *mu *= 2.0);
}

fn han_nose_lower(scene: &mut Scene) {
    han(scene, |_, _, height| *height *= 0.99);
}

fn mathavan(scene: &mut Scene, change: fn(&mut f64, &mut f64, &mut f64)) {
    if let Some(Cushion::Mathavan2010 {
        e, mu, mu_cloth, ..
    }) = &mut scene.effects.cushion
    {
        change(e, mu, mu_cloth);
    }
}

/// Work returns `e` of what it was, where it should return `e^2`.
fn mathavan_work_is_speed(scene: &mut Scene) {
    mathavan(scene, |e, _, _| *e = e.sqrt());
}

fn mathavan_nose_smooth(scene: &mut Scene) {
    mathavan(scene, |_, mu, _| *mu = 0.0);
}

fn mathavan_cloth_smooth(scene: &mut Scene) {
    mathavan(scene, |_, _, mu_cloth| *mu_cloth = 0.0);
}

fn cloth(scene: &mut Scene, change: fn(&mut f64, &mut f64, &mut f64)) {
    if let Some(Cloth::Rotational {
        mu_slide,
        mu_roll,
        mu_spin,
    }) = &mut scene.effects.cloth
    {
        change(mu_slide, mu_roll, mu_spin);
    }
}

fn sliding_doubled(scene: &mut Scene) {
    cloth(scene, |slide, _, _| *slide *= 2.0);
}

fn rolling_doubled(scene: &mut Scene) {
    cloth(scene, |_, roll, _| *roll *= 2.0);
}

fn spinning_doubled(scene: &mut Scene) {
    cloth(scene, |_, _, spin| *spin *= 2.0);
}

fn pockets_too_small(scene: &mut Scene) {
    for circle in scene
        .effects
        .pockets
        .iter_mut()
        .flat_map(|p| &mut p.circles)
    {
        circle[2] *= 0.9;
    }
}

/// Changes the far side of each jump of one ball: the scene, the event's kind, ball, near and far side.
fn jumps(
    trace: &mut Trace,
    mut change: impl FnMut(EventKind, usize, carom::physics::State, &mut carom::physics::State),
) {
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
fn touch_at_the_sum(scene: &Scene, trace: &mut Trace) {
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

fn spin_reversed(_: &Scene, trace: &mut Trace) {
    jumps(trace, |kind, _, _, far| {
        if let EventKind::BallBall(..) = kind {
            far.spin = -far.spin;
        }
    });
}

/// The second ball of a hit goes on as if nothing were.
fn one_ball_only(_: &Scene, trace: &mut Trace) {
    jumps(trace, |kind, ball, near, far| {
        if let EventKind::BallBall(_, second) = kind
            && second as usize == ball
        {
            *far = near;
        }
    });
}

fn side_forgotten(_: &Scene, trace: &mut Trace) {
    jumps(trace, |kind, _, _, far| {
        if let EventKind::BallCushion(..) = kind {
            far.spin.z = 0.0;
        }
    });
}

fn han_never_sticks(scene: &Scene, trace: &mut Trace) {
    han_friction(scene, trace, |limit, _| limit);
}

fn han_always_sticks(scene: &Scene, trace: &mut Trace) {
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

fn position_drifts(scene: &Scene, trace: &mut Trace) {
    let rate = 1e-6 * scene.largest_speed();
    for knot in trace.paths.iter_mut().flat_map(|path| &mut path.knots) {
        knot.state.position.x += rate * knot.time;
    }
}

/// What moves freely has stopped when it comes to the next knot.
fn stops_early(scene: &Scene, trace: &mut Trace) {
    if scene.effects.cloth.is_some() {
        return;
    }
    for path in &mut trace.paths {
        if let Some(last) = path.knots.last_mut().filter(|knot| knot.after.is_none()) {
            last.state.velocity = Vec3::zeros();
        }
    }
}

fn event_not_told(_: &Scene, trace: &mut Trace) {
    if let Some(event) = trace.events.iter_mut().find(|e| e.kind.is_collision()) {
        event.kind = EventKind::Stop(0);
    }
}
