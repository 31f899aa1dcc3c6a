//! The laws of equal balls on a cloth, as `physics.md` states them, per unit of mass, with spin as the speed of the surface.

use nalgebra::{Vector2, Vector3};

/// In the plane of the table.
pub type Plane = Vector2<f64>;
/// In space.
pub type Space = Vector3<f64>;

/// What the balls and the table are.
#[derive(Clone, Copy, Debug)]
pub struct Laws {
    /// Diameter of the balls.
    pub diameter: f64,
    /// Deceleration of a ball that slides, and of one that rolls.
    pub slide: f64,
    pub roll: f64,
    /// By how much the speed of the surface about the vertical falls in a second.
    pub spin: f64,
    /// Restitution of balls.
    pub e: f64,
    /// Friction of balls: a + b exp(-c s) at the slip speed s.
    pub friction: [f64; 3],
}

/// A ball: centre, velocity, and radius times angular velocity.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    pub r: Plane,
    pub v: Plane,
    pub w: Space,
}

/// In the plane, a vector as one in space.
fn raised(a: Plane) -> Space {
    Space::new(a.x, a.y, 0.0)
}

impl Ball {
    /// The velocity with which its spin would roll.
    pub fn rolling(&self) -> Plane {
        Plane::new(self.w.y, -self.w.x)
    }

    /// The velocity of its lowest point.
    pub fn slip(&self) -> Plane {
        self.v - self.rolling()
    }

    /// Makes it roll with its velocity.
    pub fn roll(&mut self) {
        (self.w.x, self.w.y) = (-self.v.y, self.v.x);
    }

    /// An impulse at the surface, at `n` from the centre.
    pub fn push(&mut self, n: Plane, impulse: Space) {
        self.v += impulse.xy();
        self.w += 2.5 * raised(n).cross(&impulse);
    }

    /// Its spin about the vertical falls for `t`.
    pub fn unwind(&mut self, laws: &Laws, t: f64) {
        self.w.z = self.w.z.signum() * (self.w.z.abs() - laws.spin * t).max(0.0);
    }

    pub fn numbers(&self) -> [f64; 7] {
        let Ball { r, v, w } = self;
        [r.x, r.y, v.x, v.y, w.x, w.y, w.z]
    }
}

/// From one ball to the other: direction of their centres.
pub fn normal(one: &Ball, other: &Ball) -> Plane {
    (other.r - one.r).normalize()
}

/// How far they are apart.
pub fn gap(one: &Ball, other: &Ball, laws: &Laws) -> f64 {
    (other.r - one.r).norm() - laws.diameter
}

/// How fast they come together.
pub fn approach(one: &Ball, other: &Ball) -> f64 {
    (one.v - other.v).dot(&normal(one, other))
}

/// The friction on the first of two balls that meet along `n` with the impulse `push`.
pub fn rub(one: &Ball, other: &Ball, n: Plane, push: f64, laws: &Laws) -> Space {
    let along = raised(n);
    let slip = raised(one.v - other.v) + (one.w + other.w).cross(&along);
    let slip = slip - along * slip.dot(&along);
    let speed = slip.norm();
    if speed == 0.0 {
        return Space::zeros();
    }
    let [a, b, c] = laws.friction;
    let most = (a + b * (-c * speed).exp()) * push;
    slip * (-most.min(speed / 7.0) / speed)
}

/// An impact of two balls, with restitution `e`.
pub fn impact(one: &mut Ball, other: &mut Ball, e: f64, laws: &Laws) {
    let n = normal(one, other);
    let push = 0.5 * (1.0 + e) * (one.v - other.v).dot(&n);
    let rub = rub(one, other, n, push, laws);
    let whole = rub - raised(n) * push;
    one.push(n, whole);
    other.push(-n, -whole);
}
