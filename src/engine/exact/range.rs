//! Whether a scene's numbers leave room for what is computed from them in the scalar of a run.

use super::kinematics::Kinematics;
use crate::math::Real;
use crate::trace::Ending;

/// Numbers whose products leave the range of the scalar cannot be run: the ending of a run that cannot begin.
pub fn unfit<T: Real>(balls: &Kinematics<'_, T>) -> Option<Ending> {
    let world = balls.world();
    let fit = |ball: usize| {
        let flight = balls.flight(ball);
        let [x, y] = flight.position;
        let [vx, vy] = flight.velocity;
        let [ax, ay] = flight.acceleration;
        let (p, v, a) = (x * x + y * y, vx * vx + vy * vy, ax * ax + ay * ay);
        (p * v).is_finite() && (p * a).is_finite() && (v * v).is_finite() && (a * a).is_finite()
    };
    let unfit: Vec<usize> = (0..balls.count())
        .filter(|ball| !fit(*ball) || creeps(balls, *ball))
        .collect();
    let range = world.fastest.is_finite() && world.blur.length.is_finite();
    if unfit.is_empty() && range && world.duration.is_finite() {
        return None;
    }
    Some(Ending::NotFinite(balls.spot(
        &unfit,
        "its position or velocity is not a number, or too large or too small to compute with",
    )))
}

/// True if a ball is so slow that the square of its speed has lost its digits, and still gets somewhere within the duration:
/// farther than surfaces that touch may be apart.
fn creeps<T: Real>(balls: &Kinematics<'_, T>, ball: usize) -> bool {
    let world = balls.world();
    let given = balls.scene().balls[ball].state.velocity;
    // without squares that vanish
    let path = given.x.hypot(given.y) * world.duration.to_f64();
    // products with the square must keep their digits: a number that survives an ulp of itself has room for them
    let [x, y] = [T::lift(given.x), T::lift(given.y)];
    let square = x * x + y * y;
    let small = T::lift(T::ULP) / T::lift(3.0);
    let lost = (square * small / small - square).abs();
    (square == T::zero() || lost > square * T::lift(16.0 * T::ULP))
        && path > world.touching.to_f64()
}
