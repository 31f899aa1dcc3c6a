//! Images of a scene that must run alike: mirrored, with its balls in another order, and backward from its end.

use crate::math::Vec3;
use crate::physics::State;
use crate::physics::{Cloth, Contact, Cushion};
use crate::scene::{Scene, Shot, Table};
use crate::trace::Trace;

/// The scene mirrored at x = 0. Every number only changes its sign, so that rounding is mirrored as well.
pub fn mirrored(scene: &Scene) -> Scene {
    let mut image = scene.clone();
    for ball in &mut image.balls {
        ball.state = mirror(&ball.state);
    }
    image.table = scene.table.map(|table| Table {
        min: [-table.max[0], table.min[1]],
        max: [-table.min[0], table.max[1]],
    });
    for circle in image
        .effects
        .pockets
        .iter_mut()
        .flat_map(|p| &mut p.circles)
    {
        circle[0] = -circle[0];
    }
    match &mut image.shot {
        Some(Shot::Force { angle_deg, .. } | Shot::Velocity { angle_deg, .. }) => {
            *angle_deg = 180.0 - *angle_deg;
        }
        Some(Shot::Strike { strike, .. }) => {
            strike.angle_deg = 180.0 - strike.angle_deg;
            strike.side = -strike.side;
        }
        None => {}
    }
    image
}

/// A state mirrored at x = 0. A spin is the vector of a turn, whose sense a mirror reverses.
pub fn mirror(state: &State) -> State {
    let across = |v: Vec3| Vec3::new(-v.x, v.y, v.z);
    State {
        position: across(state.position),
        velocity: across(state.velocity),
        spin: -across(state.spin),
    }
}

/// The scene with its balls listed in reverse. Who is shot does not change.
pub fn relabelled(scene: &Scene) -> Scene {
    let mut image = scene.clone();
    image.balls.reverse();
    let last = scene.balls.len() - 1;
    match &mut image.shot {
        Some(
            Shot::Force { ball, .. } | Shot::Velocity { ball, .. } | Shot::Strike { ball, .. },
        ) => *ball = last - *ball,
        None => {}
    }
    image
}

/// The scene that starts where `trace` ended, with every motion reversed; `None` if a ball left play, or is no number.
pub fn reversed(scene: &Scene, trace: &Trace) -> Option<Scene> {
    let mut image = scene.clone();
    // the motion is the trace's and no longer the shot's
    image.shot = None;
    for (ball, state) in image.balls.iter_mut().zip(trace.final_states()) {
        let state = state.filter(is_finite)?;
        ball.state = State {
            position: state.position,
            velocity: -state.velocity,
            spin: -state.spin,
        };
    }
    Some(image)
}

/// True if every number of a state is finite.
pub fn is_finite(state: &State) -> bool {
    let all = [state.position, state.velocity, state.spin];
    all.iter().all(|v| v.iter().all(|x| x.is_finite()))
}

/// True where no law of the scene takes energy, so that motion can run backward.
pub fn is_reversible(scene: &Scene) -> bool {
    let effects = &scene.effects;
    let smooth = scene.gravity == 0.0
        || match effects.cloth {
            None => true,
            Some(Cloth::Translational { mu }) => mu == 0.0,
            Some(Cloth::Rotational {
                mu_slide,
                mu_roll,
                mu_spin,
            }) => mu_slide == 0.0 && mu_roll == 0.0 && mu_spin == 0.0,
        };
    let contact = matches!(effects.contact, None | Some(Contact::Elastic {}));
    let cushion = matches!(effects.cushion, None | Some(Cushion::Elastic {}));
    smooth && contact && cushion && effects.friction.is_none() && effects.pockets.is_none()
}
