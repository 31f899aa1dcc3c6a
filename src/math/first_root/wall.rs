//! First contact of a disc with a straight wall under constant acceleration.

use super::{Blur, Contact};
use crate::math::Real;

/// First time up to `limit` at which a centre is at or beyond the line that it may not cross, *and* moves outward.
///
/// `gap`: distance still free, negative beyond the line. `speed` and `acceleration`: outward, along the wall's normal.
/// A centre beyond the line and moving inward waits until it moves outward again.
pub fn first_crossing<T: Real>(
    gap: T,
    speed: T,
    acceleration: T,
    limit: T,
    blur: &Blur<T>,
) -> Contact<T> {
    let zero = T::zero();
    let two = T::lift(2.0);
    if gap <= blur.length && speed > blur.speed {
        return Contact::At(zero);
    }
    // the square of the outward speed at the line
    let square = speed * speed + two * acceleration * gap;
    let outward = speed > zero && gap > zero;
    let t = if outward {
        let doubt = two * acceleration.abs() * blur.length;
        if acceleration < zero && square <= doubt {
            if square < -doubt {
                return Contact::Never;
            }
            // it turns back, or stops, within the blur of the line: unclear from where the blur begins
            let free = (gap - two * blur.length).at_least(zero);
            let entry = speed * speed + two * acceleration * free;
            let t = two * free / (speed + entry.at_least(zero).sqrt());
            return within(t, limit, Contact::Unclear);
        }
        two * gap / (speed + square.sqrt())
    } else if acceleration <= zero {
        return Contact::Never;
    } else if square < zero {
        // never comes inside: contact when it turns outward again
        -speed / acceleration
    } else {
        (square.sqrt() - speed) / acceleration
    };
    within(t, limit, Contact::At)
}

fn within<T: Real>(t: T, limit: T, found: impl Fn(T) -> Contact<T>) -> Contact<T> {
    if t <= limit { found(t) } else { Contact::Never }
}
