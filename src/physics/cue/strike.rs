//! A cue that strikes a ball off its centre: speed, spin and deflection.
//!
//! The tip hits without slipping and the impact loses no energy: a centre hit of a cue of mass `M` at speed `V` gives the speed
//! `2 V / (1 + m / M)`. Offsets give spin at the cost of speed; the mass at the end of the cue that the ball pushes aside gives
//! the deflection (squirt). Sources: D. Alciatore, technical proofs TP A.30 and A.31; E. Kiefl, pooltool's theory of the cue.
//! It runs in f64: it is part of reading a scene, not of simulating it.

use crate::math::Vec3;
use crate::math::angle::unit_vector;
use crate::physics::Motion;
use serde::Serialize;

/// A strike, seen by the player behind the cue.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Strike {
    /// Speed of the cue at the impact, length/s, >= 0.
    pub speed: f64,
    /// Direction of the cue in plan, degrees counter-clockwise from +x.
    pub angle_deg: f64,
    /// How far the butt of the cue is raised, degrees, 0 to 90.
    pub elevation_deg: f64,
    /// Mass of the cue, > 0.
    pub cue_mass: f64,
    /// Mass at the tip that gives way sideways, > 0; `None` for a cue that does not deflect the ball.
    pub end_mass: Option<f64>,
    /// Offset of the tip to the left of the centre, in radii.
    pub side: f64,
    /// Offset of the tip above the centre, square to the cue, in radii. `side^2 + top^2 < 1`: beyond it there is no ball to hit.
    pub top: f64,
}

impl Strike {
    /// Motion of a ball of mass `mass` and radius `radius` that was at rest.
    ///
    /// With the cue along +y, offsets a (side) and b (top) in radii and elevation th: the tip meets the ball at
    /// `R Q = R (-a x + b (0, sin th, cos th) - c d)`, `c = sqrt(1 - a^2 - b^2)`, the cue's direction `d = (0, cos th, -sin th)`.
    /// Speed `v = 2 V / (1 + m/M + 5/2 (a^2 + b^2))`; spin `5 / (2 R) Q x (v d)`; velocity `v cos th` in plan, turned by the
    /// deflection `tan q = 5/2 a sqrt(1 - a^2) / (1 + m/m_e + 5/2 (1 - a^2))`, away from the side that is hit. The cloth takes
    /// the vertical part.
    pub fn motion(&self, mass: f64, radius: f64) -> Motion {
        let (a, b) = (self.side, self.top);
        let offset = a * a + b * b;
        let speed = 2.0 * self.speed / (1.0 + mass / self.cue_mass + 2.5 * offset);
        let (cos, sin) = unit_vector(self.elevation_deg);
        // to the right, forward, up
        let cue = Vec3::new(0.0, cos, -sin);
        let tip = Vec3::new(-a, b * sin, b * cos) - cue * (1.0 - offset).sqrt();
        let spin = tip.cross(&(cue * speed)) * (2.5 / radius);
        let tangent = self.end_mass.map_or(0.0, |end_mass| {
            let inward = 1.0 - a * a;
            2.5 * a * inward.sqrt() / (1.0 + mass / end_mass + 2.5 * inward)
        });
        let along = speed * cos / (1.0 + tangent * tangent).sqrt();
        let velocity = Vec3::new(along * tangent, along, 0.0);
        let (forward_x, forward_y) = unit_vector(self.angle_deg);
        let in_scene = |v: Vec3| {
            Vec3::new(
                v.x * forward_y + v.y * forward_x,
                v.y * forward_y - v.x * forward_x,
                v.z,
            )
        };
        Motion {
            velocity: in_scene(velocity),
            spin: in_scene(spin),
        }
    }
}
