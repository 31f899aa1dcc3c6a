//! A ball that meets a cushion, in components into it, along it and up.

use super::facing::{Facing, nose};
use super::{Audit, Jump, NONE, Part, TOGETHER};
use crate::math::Vec3;
use crate::physics::{Cushion, Side};

/// Impacts of a run that are integrated again where a law has no closed form: they take a thousand times as long as others.
const INTEGRATED: u64 = 4;

impl Audit<'_> {
    /// A ball met a cushion; a stepped engine only puts it back where it is outside and moves inward.
    pub(super) fn cushion(
        &mut self,
        event: &crate::trace::Event,
        ball: usize,
        side: Side,
        jump: &Jump,
        together: bool,
    ) {
        let (Some(law), Some(table)) = (self.scene.effects.cushion, self.scene.table) else {
            let words = self.against("no cushion", ball, side, jump);
            return self.fault("cushion-told", words);
        };
        let radius = self.scene.balls[ball].radius;
        let (axis, sign) = (side.axis(), f64::from(side.sign()));
        let edge = if sign > 0.0 {
            table.max[axis]
        } else {
            table.min[axis]
        };
        self.edge(ball, side, jump, edge - sign * radius, together);
        let facing = |state: &crate::physics::State| {
            let turned = |v: &Vec3| {
                let (into, along) = if axis == 0 { (v.x, v.y) } else { (v.y, -v.x) };
                Vec3::new(sign * into, sign * along, v.z)
            };
            Facing {
                velocity: turned(&state.velocity),
                surface: turned(&state.spin) * radius,
            }
        };
        let (near, far) = (facing(&jump.near), facing(&jump.far));
        let size = near.velocity.norm() + near.surface.norm();
        if event.exchanges == Some(0) {
            let off = (far.velocity - near.velocity).norm() + (far.surface - near.surface).norm();
            if off > 0.0 {
                let words = self.against("not met", ball, side, jump);
                self.fault("cushion-restitution", words);
            }
            return;
        }
        // a ball that the cloth presses against a cushion meets it again and again with no speed, but for what the clock makes of it
        let parting = (-near.velocity.x).max(0.0);
        let allowed = self.grain * size + self.pull() * self.clock(jump.time) + NONE;
        if !together && let Some(off) = self.off(Part::Impact, parting, allowed) {
            let words = self.against("parting before they meet", ball, side, jump);
            return self.fault("cushion-parting", format!("{words}: {off}"));
        }
        if together {
            return self.among_others(law.rotates(), (ball, side, jump), near, far);
        }
        let (id, want, allowed) = match law {
            Cushion::Elastic {} => ("cushion.elastic", mirrored(near, 1.0), self.grain * size),
            Cushion::Restitution { e } => {
                ("cushion.restitution", mirrored(near, e), self.grain * size)
            }
            Cushion::Han2005 { e, mu, height } => {
                let (want, poor) = han(near, [e, mu, height]);
                ("cushion.han-2005", want, self.grain * poor * size)
            }
            Cushion::Mathavan2010 { .. } => {
                return self.integrated(ball, side, jump, near, far);
            }
        };
        self.found.impacts += 1;
        self.compare(
            Part::Impact,
            id,
            (ball, side, jump),
            (far, want),
            allowed + NONE,
        );
    }

    /// One of several contacts at an instant: its impulse has a size that others share, and the direction of its law. `turns`: whether the
    /// law turns balls; a mean over orders has the direction of no impulse.
    fn among_others(
        &mut self,
        turns: bool,
        (ball, side, jump): (usize, Side, &Jump),
        near: Facing,
        far: Facing,
    ) {
        self.leave_out(TOGETHER);
        if turns {
            return;
        }
        let mut other = far.velocity - near.velocity;
        other.x = 0.0;
        let off = other.norm() + (far.surface - near.surface).norm();
        let told = self.grain * self.loudest_at(ball, jump.time);
        if let Some(off) = self.off(Part::Impact, off, told + self.chain()) {
            let words = self.against("several at once", ball, side, jump);
            self.fault("cushion-friction", format!("{words}, {off}"));
        }
    }

    /// Holds a motion after an impact against what it should be.
    pub(super) fn compare(
        &mut self,
        part: Part,
        law: &str,
        (ball, side, jump): (usize, Side, &Jump),
        (got, want): (Facing, Facing),
        allowed: f64,
    ) {
        let figures = [
            (
                "cushion-restitution",
                "speed into it",
                got.velocity.x,
                want.velocity.x,
            ),
            (
                "cushion-friction",
                "speed along it",
                got.velocity.y,
                want.velocity.y,
            ),
            (
                "cushion-spin",
                "R times spin about its normal",
                got.surface.x,
                want.surface.x,
            ),
            (
                "cushion-spin",
                "R times spin along it",
                got.surface.y,
                want.surface.y,
            ),
            (
                "cushion-spin",
                "R times spin about the vertical",
                got.surface.z,
                want.surface.z,
            ),
        ];
        for (what, of, got, want) in figures {
            if let Some(off) = self.off(part, (got - want).abs(), allowed) {
                let words = self.against(law, ball, side, jump);
                let words = format!("{words}: {of} is {got:e} instead of {want:e}, {off}");
                self.fault(what, words);
            }
        }
    }

    /// The centre is one radius from the edge: at the impact, or put there by a step.
    fn edge(&mut self, ball: usize, side: Side, jump: &Jump, reach: f64, together: bool) {
        let axis = side.axis();
        let (near, far) = (&jump.near.position, &jump.far.position);
        let mut aside = far - near;
        aside[axis] = 0.0;
        let mut allowed = self.place;
        if together {
            allowed += 1e-6 * self.scene.smallest_radius();
        }
        let stays = self.step > 0.0 || far == near;
        if aside != Vec3::zeros() || !stays {
            let words = self.against("place", ball, side, jump);
            self.fault(
                "cushion-place",
                format!("{words}: it moves while it is hit"),
            );
        }
        if let Some(off) = self.off(Part::Impact, (far[axis] - reach).abs(), allowed) {
            let words = self.against("place", ball, side, jump);
            let at = far[axis];
            self.fault(
                "cushion-place",
                format!("{words}: at {at:e} instead of {reach:e}, {off}"),
            );
        }
    }

    /// What holds of the law of Mathavan 2010 whatever its integral, and, for the first impacts of a run, the integral itself.
    fn integrated(&mut self, ball: usize, side: Side, jump: &Jump, near: Facing, far: Facing) {
        let Some(Cushion::Mathavan2010 {
            e,
            mu,
            mu_cloth,
            height,
        }) = self.scene.effects.cushion
        else {
            return;
        };
        let law = "cushion.mathavan-2010";
        self.found.impacts += 1;
        let size = near.velocity.norm() + near.surface.norm();
        let (sin, cos) = nose(height);
        // the nose turns it about the vertical, nose and cloth about the normal, and both together push it along the cushion
        let turned = (far.surface - near.surface) / 2.5;
        let along = turned.x + (1.0 + sin) * turned.z / cos;
        let off = (far.velocity.y - near.velocity.y - along).abs();
        // the integration states an error of some 1e-12 a step, and takes some hundred
        let allowed = INTEGRATION * size / cos + NONE;
        if let Some(off) = self.off(Part::Impact, off, allowed) {
            let words = self.against(law, ball, side, jump);
            let words = format!("{words}: spin and speed along it do not fit, {off}");
            self.fault("cushion-friction", words);
        }
        if near.velocity.x <= 0.0 {
            return;
        }
        if self.found.integrated >= INTEGRATED {
            return self.leave_out("more than four integrals of a run");
        }
        match super::integral::rebound(near, [e, mu, mu_cloth, height]) {
            None => self.leave_out("an integral that does not settle"),
            Some((want, error)) => {
                self.found.integrated += 1;
                self.compare(Part::Integral, law, (ball, side, jump), (far, want), error);
            }
        }
    }

    fn against(&self, law: &str, ball: usize, side: Side, jump: &Jump) -> String {
        let name = self.name(ball);
        format!("{law}: {name} and {} at {:e} s", side.id(), jump.time)
    }
}

/// What a law that is integrated may miss of the sizes that it starts from.
const INTEGRATION: f64 = 1e-8;

fn mirrored(mut motion: Facing, e: f64) -> Facing {
    motion.velocity.x *= -e;
    motion
}

/// Han 2005 in closed form, per mass: a push along the line from the nose to the centre, and friction on the two tangents of the ball
/// there, `y` along the cushion and `q` from below over the nose. The second answer: by how much rounding grows.
fn han(motion: Facing, [e, mu, height]: [f64; 3]) -> (Facing, f64) {
    let (sin, cos) = nose(height);
    let Facing { velocity, surface } = motion;
    let push = (1.0 + e) * velocity.x * cos;
    let along = velocity.y + surface.z * cos - surface.x * sin;
    let over = -(velocity.x * sin) - surface.y;
    let slip = along.hypot(over);
    // a solid sphere yields at its surface as 2/7 of its mass would
    let size = (mu * push).min(slip * 2.0 / 7.0);
    let (mut y, mut q) = (0.0, 0.0);
    if slip > 0.0 {
        (y, q) = (-size * (along / slip), -size * (over / slip));
    }
    let far = Facing {
        velocity: Vec3::new(velocity.x - push * cos - q * sin, velocity.y + y, 0.0),
        surface: surface + Vec3::new(-sin * y, -q, cos * y) * 2.5,
    };
    // the cosine is a difference, and friction multiplies the push
    let poor = (1.0 + 1.0 / cos) * (1.0 + mu.min(1.0 / cos));
    (far, poor)
}
