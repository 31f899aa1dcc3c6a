//! What the cloth does to a ball between two events, and where a phase of it ends.
//!
//! A ball slips over the cloth with `u = v + R (z x w)`. While it slips its centre loses `mu g` a second along `u` and `R` times the
//! spin 5/2 of that, so that `u` loses 7/2 and keeps its direction; once it rolls the centre loses `mu_roll g` along `v`, and the spin
//! goes with it. The spin about the vertical loses `5/2 mu_spin g / R` in any case.

use super::{Audit, Jump, NONE, Part, plan};
use crate::physics::{Cloth, State};
use crate::trace::{EventKind, Knot};
use nalgebra::Vector2;

/// A slip of so many ulp of what it is the difference of is one for sure, and below the second of so many none: what is between is called
/// either.
const SLIPS: [f64; 2] = [32.0, 2.0];

/// Steps of the cloth by which the clock of a stepped engine may miss its friction.
const STEPS: f64 = 2.0;

/// What the cloth takes each second: of a sliding, a rolling ball, and of R times the spin about the vertical; length/s^2.
#[derive(Clone, Copy)]
struct Rates {
    slide: f64,
    roll: f64,
    spin: f64,
}

/// A ball between two knots.
struct Piece {
    start: State,
    end: State,
    /// Times of both, s.
    times: [f64; 2],
    radius: f64,
}

/// How far a piece is off, and may be.
#[derive(Clone, Copy)]
struct Off {
    what: &'static str,
    off: f64,
    allowed: f64,
}

impl Audit<'_> {
    fn rates(&self) -> Rates {
        let g = self.scene.gravity;
        match self.scene.effects.cloth {
            None => Rates {
                slide: 0.0,
                roll: 0.0,
                spin: 0.0,
            },
            // what does not turn is slowed along its velocity, as if it rolled
            Some(Cloth::Translational { mu }) => Rates {
                slide: 0.0,
                roll: mu * g,
                spin: 0.0,
            },
            Some(Cloth::Rotational {
                mu_slide,
                mu_roll,
                mu_spin,
            }) => Rates {
                slide: mu_slide * g,
                roll: mu_roll * g,
                spin: 2.5 * (mu_spin * g),
            },
        }
    }

    /// The most that the cloth takes of the speed of a centre each second, length/s^2.
    pub(super) fn pull(&self) -> f64 {
        let rates = self.rates();
        rates.slide.max(rates.roll)
    }

    /// What a clock without steps is good to, s.
    pub(super) fn clock(&self, time: f64) -> f64 {
        4.0 * f64::EPSILON * time
    }

    /// Relative error of a number after `time` s: each step rounds it once more.
    fn grown(&self, time: f64) -> f64 {
        if self.step > 0.0 {
            self.grain + 4.0 * f64::EPSILON * (time / self.step)
        } else {
            self.grain
        }
    }

    fn turns_on_cloth(&self) -> bool {
        matches!(self.scene.effects.cloth, Some(Cloth::Rotational { .. }))
    }

    /// Holds the piece of the path of `ball` between two knots against the law of the cloth.
    pub(super) fn cloth(&mut self, ball: usize, start: &Knot, end: &Knot) {
        let piece = Piece {
            start: start.state,
            end: end.state,
            times: [start.time, end.time],
            radius: self.scene.balls[ball].radius,
        };
        let rates = self.rates();
        let figures = self.flight(&piece, rates);
        let vertical = self.vertical(&piece, rates);
        for figure in figures.into_iter().chain([vertical]) {
            if let Some(off) = self.off(Part::Piece, figure.off, figure.allowed) {
                let law = match self.scene.effects.cloth {
                    None => "no cloth",
                    Some(Cloth::Translational { .. }) => "cloth.translational",
                    Some(Cloth::Rotational { .. }) => "cloth.rotational",
                };
                let words = format!(
                    "{law}: {} from {:e} s to {:e} s: {off}",
                    self.name(ball),
                    piece.times[0],
                    piece.times[1]
                );
                self.fault(figure.what, words);
            }
        }
    }

    /// The phase in which it begins decides; where a slip is rounding, the one that fits better.
    fn flight(&self, piece: &Piece, rates: Rates) -> [Off; 4] {
        if !self.turns_on_cloth() {
            return self.rolling(piece, rates);
        }
        let (slip, made) = slip(&piece.start, piece.radius);
        let size = slip.norm();
        let [surely, never] = SLIPS.map(|ulps| ulps * f64::EPSILON * made);
        if size > surely {
            return self.sliding(piece, rates, slip);
        }
        let rolls = self.rolling(piece, rates);
        if size <= never {
            return rolls;
        }
        let slides = self.sliding(piece, rates, slip);
        let worst = |figures: &[Off; 4]| {
            let parts = figures.iter().map(|f| f.off / f.allowed);
            parts.fold(0.0, f64::max)
        };
        if worst(&slides) < worst(&rolls) {
            slides
        } else {
            rolls
        }
    }

    fn sliding(&self, piece: &Piece, rates: Rates, slip: Vector2<f64>) -> [Off; 4] {
        let size = slip.norm();
        let push = slip * (-rates.slide / size);
        let h = piece.times[1] - piece.times[0];
        // z x (5/2 a / R) h: what turns the lowest point along with the push
        let turn = Vector2::new(push.y, -push.x) * 2.5;
        let lost = 3.5 * rates.slide * h;
        let (_, made) = self::slip(&piece.start, piece.radius);
        let late = Off {
            what: "cloth-phase",
            off: (lost - size).max(0.0),
            allowed: self.grown(h) * made + 3.5 * rates.slide * self.blur(piece) + NONE,
        };
        let [velocity, place, spin] = self.figures(piece, push, turn);
        [velocity, place, spin, late]
    }

    fn rolling(&self, piece: &Piece, rates: Rates) -> [Off; 4] {
        let v = plan(&piece.start.velocity);
        let speed = v.norm();
        let push = if speed > 0.0 {
            v * (-rates.roll / speed)
        } else {
            Vector2::zeros()
        };
        let turn = if self.turns_on_cloth() {
            Vector2::new(-push.y, push.x)
        } else {
            Vector2::zeros()
        };
        let [velocity, place, spin] = self.figures(piece, push, turn);
        let late = Off {
            what: "cloth-phase",
            off: 0.0,
            allowed: 0.0,
        };
        [velocity, place, spin, late]
    }

    /// What a clock is good to, s: some ulp of its time, or steps.
    fn blur(&self, piece: &Piece) -> f64 {
        self.clock(piece.times[1]) + STEPS * self.step
    }

    /// Velocity, place and spin at the end under a constant push, length/s^2, and turn, R times rad/s^2.
    fn figures(&self, piece: &Piece, push: Vector2<f64>, turn: Vector2<f64>) -> [Off; 3] {
        let h = piece.times[1] - piece.times[0];
        let blur = self.blur(piece);
        let (v0, v1) = (plan(&piece.start.velocity), plan(&piece.end.velocity));
        let (w0, w1) = (plan(&piece.start.spin), plan(&piece.end.spin));
        let (x0, x1) = (plan(&piece.start.position), plan(&piece.end.position));
        let grain = self.grown(h);
        let pull = push.norm();
        let surface = w0.norm() * piece.radius;
        let speeds = v0.norm() + surface + pull * h;
        // within a step a slide may end and a roll begin
        let most = if self.step > 0.0 {
            let rates = self.rates();
            rates.slide + rates.roll
        } else {
            pull
        };
        let velocity = Off {
            what: "cloth-velocity",
            off: (v1 - v0 - push * h).norm(),
            allowed: grain * speeds + most * blur + NONE,
        };
        let spin = Off {
            what: "cloth-spin",
            off: ((w1 - w0) * piece.radius - turn * h).norm(),
            allowed: grain * speeds + 2.5 * most * blur + NONE,
        };
        let fastest = v0.norm().max(v1.norm());
        let place = Off {
            what: "cloth-place",
            off: (x1 - x0 - v0 * h - push * (0.5 * h * h)).norm(),
            allowed: grain * (x0.norm() + x1.norm())
                + grain * speeds * h
                + (fastest + most * h) * blur
                + self.closed
                + NONE,
        };
        [velocity, place, spin]
    }

    /// The spin about the vertical.
    fn vertical(&self, piece: &Piece, rates: Rates) -> Off {
        let h = piece.times[1] - piece.times[0];
        let [from, to] = [&piece.start, &piece.end].map(|state| state.spin.z * piece.radius);
        let grain = self.grown(h);
        let lost = if from == 0.0 { 0.0 } else { rates.spin * h };
        let want = from - lost.copysign(from);
        Off {
            what: "cloth-spin",
            off: (to - want).abs(),
            allowed: grain * (from.abs() + lost)
                + if from == 0.0 {
                    0.0
                } else {
                    rates.spin * self.blur(piece)
                }
                + NONE,
        }
    }

    /// A phase ended: the ball is where and what it was, but for what is exactly gone.
    pub(super) fn phase(&mut self, kind: EventKind, ball: usize, jump: &Jump) {
        let radius = self.scene.balls[ball].radius;
        let Jump { time, near, far } = *jump;
        let rates = self.rates();
        let blur = self.clock(time);
        let fastest = self.pull();
        let made = near.velocity.norm() + radius * near.spin.norm();
        let speeds = (far.velocity - near.velocity).norm() + radius * (far.spin - near.spin).norm();
        let speeds_allowed = self.history(ball, jump) + (8.0 * fastest + rates.spin) * blur + NONE;
        let moved = (far.position - near.position).norm();
        let moved_allowed = self.place + made * blur;
        let (gone, what) = match kind {
            EventKind::Stop(_) => (far.velocity.norm(), "a ball that stopped moves"),
            EventKind::SpinEnd(_) => (far.spin.z.abs(), "a spin that ended is there"),
            _ => {
                let (slip, made) = slip(&far, radius);
                let left = (slip.norm() - self.grain * made).max(0.0);
                // a step ends a slide and what comes next begins
                (left, "a ball that rolls slips")
            }
        };
        for (off, allowed, what) in [
            (speeds, speeds_allowed, "it jumps"),
            (moved, moved_allowed, "it moves at once"),
            (gone, NONE, what),
        ] {
            if let Some(off) = self.off(Part::Piece, off, allowed) {
                let name = self.name(ball);
                let words = format!("{} of {name} at {time:e} s: {what}, {off}", kind.id());
                self.fault("cloth-phase", words);
            }
        }
    }

    /// What the speeds of a ball at a jump are good to: they come from those at the knot before.
    fn history(&self, ball: usize, jump: &Jump) -> f64 {
        let radius = self.scene.balls[ball].radius;
        let knots = &self.trace.paths[ball].knots;
        let before = knots.partition_point(|knot| knot.time < jump.time);
        let from = before.checked_sub(1).and_then(|at| knots.get(at));
        let of = |state: &State| state.velocity.norm() + radius * state.spin.norm();
        let (since, speed) = from.map_or((jump.time, 0.0), |knot| (knot.time, of(&knot.state)));
        self.grown(jump.time - since) * (speed + of(&jump.near))
    }
}

/// Velocity of the lowest point over the cloth, and the size of what it is the difference of; length/s.
fn slip(state: &State, radius: f64) -> (Vector2<f64>, f64) {
    let v = plan(&state.velocity);
    let w = plan(&state.spin) * radius;
    // z x w turns it to the left
    let slip = Vector2::new(v.x - w.y, v.y + w.x);
    (slip, v.norm().hypot(w.norm()))
}
