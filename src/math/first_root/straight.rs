//! First contact of two discs whose relative motion is along a straight line: the closed form.
//!
//! It serves every pair with a resting partner (a decelerating ball keeps its line) and every pair without cloth, which
//! together are almost all. The line is `p + v w` with `w(t) = t - t^2 / (2 rest)`, so the quartic is a quadratic in `w`.
//! Where the motion ends within the blur of contact, the answer is [`Contact::Unclear`].

use super::{Blur, Contact};
use crate::math::Real;

/// First contact up to `limit` of discs at relative position `p` with relative velocity `v`, which decreases evenly to zero
/// within `rest_in` (infinite: it is constant).
///
/// `distance`: of the centres at contact. Times in s from now. The miss distance is computed from the cross product of `p`
/// and `v`, whose error is an ulp of `|p|`; the usual discriminant would lose `|p| / distance` times more.
#[inline]
pub fn straight_contact<T: Real>(
    p: [T; 2],
    v: [T; 2],
    rest_in: T,
    distance: T,
    limit: T,
    blur: &Blur<T>,
) -> Contact<T> {
    let inward = -(p[0] * v[0] + p[1] * v[1]);
    if inward <= T::zero() {
        return Contact::Never;
    }
    let speed2 = v[0] * v[0] + v[1] * v[1];
    let cross = p[0] * v[1] - p[1] * v[0];
    let blurred = (distance + distance) * blur.length;
    // (half chord times speed)^2: positive for a hit
    let chord2 = distance * distance * speed2 - cross * cross;
    if chord2 < -(blurred * speed2) {
        return Contact::Never;
    }
    hit(
        &Line {
            p,
            v,
            inward,
            speed2,
            chord2,
            blurred,
            rest_in,
            distance,
        },
        limit,
        blur,
    )
}

struct Line<T> {
    p: [T; 2],
    v: [T; 2],
    inward: T,
    speed2: T,
    chord2: T,
    blurred: T,
    rest_in: T,
    distance: T,
}

fn hit<T: Real>(line: &Line<T>, limit: T, blur: &Blur<T>) -> Contact<T> {
    let (zero, one, two) = (T::zero(), T::one(), T::lift(2.0));
    let p2 = line.p[0] * line.p[0] + line.p[1] * line.p[1];
    let f = p2 - line.distance * line.distance;
    if f <= line.blurred {
        return if line.inward > line.distance * blur.speed {
            Contact::At(zero)
        } else {
            Contact::Never
        };
    }
    let grazes = line.chord2 <= line.blurred * line.speed2;
    // a graze is reported from the earliest time at which it could be a hit
    let chord = if grazes {
        (line.chord2 + line.blurred * line.speed2).sqrt()
    } else {
        line.chord2.sqrt()
    };
    let w = f / (line.inward + chord);
    if w > limit {
        return Contact::Never;
    }
    // the square of the speed at contact, relative to the speed now
    let left = one - two * w / line.rest_in;
    if left <= zero {
        return line.stops_short(limit, blur);
    }
    let t = two * w / (one + left.sqrt());
    if t > limit {
        return Contact::Never;
    }
    // how far they would pass through each other: f'^2 / (2 f'') in units of f
    let shallow = line.chord2 * left
        <= line.blurred * (line.speed2 * left + line.chord2.at_least(zero).sqrt() / line.rest_in);
    let slow = line.chord2 * left <= line.distance * line.distance * blur.speed * blur.speed;
    if grazes || shallow || slow {
        Contact::Unclear(t)
    } else {
        Contact::At(t)
    }
}

impl<T: Real> Line<T> {
    /// It stops before the contact: a miss, unless what is missing is within the blur.
    #[cold]
    fn stops_short(&self, limit: T, blur: &Blur<T>) -> Contact<T> {
        let (half, four) = (T::lift(0.5) * self.rest_in, T::lift(4.0));
        let [x, y] = [0, 1].map(|i| self.p[i] + self.v[i] * half);
        if x * x + y * y - self.distance * self.distance > self.blurred {
            return Contact::Never;
        }
        // from two blurs before the stop, which is at v tau^2 / (2 rest)
        let tau = (four * blur.length * self.rest_in / self.speed2.sqrt()).sqrt();
        let t = (self.rest_in - tau).at_least(T::zero());
        if t > limit {
            Contact::Never
        } else {
            Contact::Unclear(t)
        }
    }
}
