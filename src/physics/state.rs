//! The state of one ball.

use crate::math::Real;
use approx::{AbsDiffEq, RelativeEq};
use nalgebra::Vector3;

/// Position and motion of one ball: scene units, world frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<T: Real = f64> {
    /// Centre, length. A ball on the table has z equal to its radius.
    pub position: Vector3<T>,
    /// Velocity of the centre, length/s.
    pub velocity: Vector3<T>,
    /// Angular velocity, rad/s; zero wherever the scene does not call for rotation.
    pub spin: Vector3<T>,
}

impl<T: Real> State<T> {
    /// A ball at rest with its centre at `position`.
    pub fn at_rest(position: Vector3<T>) -> Self {
        State {
            position,
            velocity: zero(),
            spin: zero(),
        }
    }

    /// True when velocity and spin are both exactly zero.
    pub fn is_at_rest(&self) -> bool {
        self.velocity == zero() && self.spin == zero()
    }

    /// Speed of the centre, length/s, >= 0.
    pub fn speed(&self) -> T {
        self.velocity.dot(&self.velocity).sqrt()
    }
}

fn zero<T: Real>() -> Vector3<T> {
    Vector3::new(T::zero(), T::zero(), T::zero())
}

/// Velocity and spin: what an impact changes, while the position stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<T: Real = f64> {
    /// Velocity of the centre, length/s.
    pub velocity: Vector3<T>,
    /// Angular velocity, rad/s.
    pub spin: Vector3<T>,
}

impl<T: Real> Motion<T> {
    /// The motion of a ball that stays on its cloth, and the kinetic energy, per mass, that the cloth takes: the vertical velocity
    /// is dropped with `v_z^2 / 2`, length^2/s^2.
    pub fn on_cloth(mut self) -> (Self, T) {
        let vertical = self.velocity.z;
        self.velocity.z = T::zero();
        (self, vertical * vertical / T::lift(2.0))
    }
}

/// What an impact law needs to know of a ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body<T: Real = f64> {
    /// Velocity of the centre, length/s.
    pub velocity: Vector3<T>,
    /// Angular velocity, rad/s.
    pub spin: Vector3<T>,
    /// Mass, in the scene's unit, > 0.
    pub mass: T,
    /// Radius, length, > 0.
    pub radius: T,
}

/// One of the four cushions, named by the coordinate it bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// At the smallest x.
    X0,
    /// At the largest x.
    X1,
    /// At the smallest y.
    Y0,
    /// At the largest y.
    Y1,
}

impl Side {
    /// All sides; x before y, as a corner's two events are ordered.
    pub const ALL: [Side; 4] = [Side::X0, Side::X1, Side::Y0, Side::Y1];

    /// The name used in files: `x0`, `x1`, `y0` or `y1`.
    pub fn id(self) -> &'static str {
        match self {
            Side::X0 => "x0",
            Side::X1 => "x1",
            Side::Y0 => "y0",
            Side::Y1 => "y1",
        }
    }

    /// The coordinate that this cushion bounds: 0 for x, 1 for y.
    pub fn axis(self) -> usize {
        match self {
            Side::X0 | Side::X1 => 0,
            Side::Y0 | Side::Y1 => 1,
        }
    }

    /// -1 for the cushions at the small end of their axis, +1 at the large end: the sign of the outward normal.
    pub fn sign(self) -> i8 {
        match self {
            Side::X0 | Side::Y0 => -1,
            Side::X1 | Side::Y1 => 1,
        }
    }
}

/// Two states are as near as their farthest coordinates: position (length), velocity (length/s) and spin (rad/s) by one number.
impl AbsDiffEq for State {
    type Epsilon = f64;

    fn default_epsilon() -> f64 {
        f64::default_epsilon()
    }

    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        self.position.abs_diff_eq(&other.position, epsilon)
            && self.velocity.abs_diff_eq(&other.velocity, epsilon)
            && self.spin.abs_diff_eq(&other.spin, epsilon)
    }
}

/// Relative to the larger of two coordinates, one by one.
impl RelativeEq for State {
    fn default_max_relative() -> f64 {
        f64::default_max_relative()
    }

    fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
        let near = |a: &Vector3<f64>, b: &Vector3<f64>| a.relative_eq(b, epsilon, max_relative);
        near(&self.position, &other.position)
            && near(&self.velocity, &other.velocity)
            && near(&self.spin, &other.spin)
    }
}

#[cfg(test)]
mod tests {
    use super::State;
    use approx::{assert_abs_diff_eq, assert_abs_diff_ne, assert_relative_eq, assert_relative_ne};
    use nalgebra::Vector3;

    #[test]
    fn states_are_as_near_as_their_farthest_coordinates() {
        let here = State::at_rest(Vector3::new(1.0, 2.0, 0.5));
        let mut spins = here;
        spins.spin.z = 1e-6;
        assert_abs_diff_eq!(here, spins, epsilon = 1e-5);
        assert_abs_diff_ne!(here, spins, epsilon = 1e-7);
        let mut moved = here;
        moved.position.y *= 1.0 + 1e-9;
        assert_relative_eq!(here, moved, max_relative = 1e-8);
        assert_relative_ne!(here, moved, max_relative = 1e-10);
    }
}
