//! Pockets: where a ball falls, and that none goes over one.

use super::{Audit, Jump, Part, plan};
use crate::trace::{Knot, UNEXPLAINED_IN_CONTACT};
use nalgebra::Vector2;

/// Places of a piece of a path that are looked at.
const LOOKS: u32 = 16;

impl Audit<'_> {
    fn circles(&self) -> &[[f64; 3]] {
        let pockets = self.scene.effects.pockets.as_ref();
        pockets.map_or(&[], |pockets| &pockets.circles)
    }

    /// A ball falls when its centre is on the rim, or in a stepped engine within.
    pub(super) fn falls(&mut self, ball: usize, pocket: u32, jump: &Jump) {
        let Some(&[x, y, r]) = self.circles().get(pocket as usize) else {
            let words = format!(
                "{} falls into no pocket at {:e} s",
                self.name(ball),
                jump.time
            );
            return self.fault("pocket-told", words);
        };
        let out = (plan(&jump.near.position) - Vector2::new(x, y)).norm() - r;
        let off = if self.step > 0.0 {
            out.max(0.0)
        } else {
            out.abs()
        };
        if let Some(off) = self.off(Part::Impact, off, self.place) {
            let words = format!(
                "{} falls into pocket {pocket} at {:e} s, {out:e} from its rim: {off}",
                self.name(ball),
                jump.time
            );
            self.fault("pocket-place", words);
        }
    }

    /// No centre is inside a pocket on its way from one knot to the next.
    pub(super) fn passes(&mut self, ball: usize, start: &Knot, end: &Knot) {
        let h = end.time - start.time;
        // what a step moves to a cushion may be in a pocket, and falls at its end
        if self.circles().is_empty() || (self.step > 0.0 && h < 2.0 * self.step) {
            return;
        }
        let (x, v) = (plan(&start.state.position), plan(&start.state.velocity));
        let last = plan(&end.state.velocity);
        // a step ends beyond the rim, and its path is not quite the one through both knots
        let steps = 4.0 * self.step * v.norm().max(last.norm());
        // nor that of a ball in contact
        let unexplained = if self.contacts.during(ball, [start.time, end.time]) {
            2.0 * UNEXPLAINED_IN_CONTACT * self.scene.balls[ball].radius
        } else {
            0.0
        };
        let allowed = self.place + steps + unexplained;
        for pocket in 0..self.circles().len() {
            let [cx, cy, r] = self.circles()[pocket];
            let deepest = (0..=LOOKS).map(|look| {
                let t = h * f64::from(look) / f64::from(LOOKS);
                let along = if h > 0.0 {
                    x + v * t + (last - v) * (0.5 * t * (t / h))
                } else {
                    x
                };
                r - (along - Vector2::new(cx, cy)).norm()
            });
            let deepest = deepest.fold(0.0, f64::max);
            if let Some(off) = self.off(Part::Piece, deepest, allowed) {
                let words = format!(
                    "{} goes through pocket {pocket} between {:e} s and {:e} s: {off}",
                    self.name(ball),
                    start.time,
                    end.time
                );
                self.fault("pocket-missed", words);
            }
        }
    }
}
