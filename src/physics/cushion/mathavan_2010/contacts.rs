//! The two contacts of a ball that meets a cushion: where it slips, where friction holds it, and the forces that follow.
//!
//! Forces are per unit of normal impulse at the nose and depend on the directions of the two slips only.

use crate::math::Real;

/// A state of the impact: velocity x and y, spin times radius x, y and z, and the integral of `|v_x| dP`.
pub type State<T> = [T; 6];

/// The direction of the slip at each contact; `None` where it sticks.
pub type Directions<T> = [Option<[T; 2]>; 2];

/// Index of the contact with the cushion's nose. Its slip and friction are along y and along `(-sin th, 0, cos th)`.
pub const NOSE: usize = 0;

/// Index of the contact with the cloth. Its slip and friction are along x and y.
pub const CLOTH: usize = 1;

/// Index of the integral of `|v_x| dP` in a state.
pub const WORK: usize = 5;

/// Impulse over which the turning of a creeping slip is looked at, in units of the ball's speed.
const AHEAD: f64 = 1e-4;

/// Steps that the direction of a beginning slip may take, and the change of its rate after which the next would be rounding.
const ROUNDS: usize = 12;
const SETTLED: f64 = 1e-9;

/// What one contact does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// Friction holds it.
    Sticks,
    /// It slips.
    Slips,
    /// It has begun to slip: the direction is that of the forces, which it follows at once, and the slip is too small to tell it.
    Creeps,
}

/// Friction and geometry.
#[derive(Clone, Copy, Debug)]
pub struct Contacts<T> {
    /// Friction at the nose and at the cloth.
    pub mu: [T; 2],
    /// Sine of the angle of the nose above the centre.
    pub sin: T,
    /// Its cosine.
    pub cos: T,
}

/// Forces on the ball per unit of normal impulse at the nose.
#[derive(Clone, Copy, Debug)]
pub struct Forces<T> {
    /// Friction at each contact.
    pub friction: [[T; 2]; 2],
    /// Normal force of the cloth.
    pub load: T,
}

/// How a contact at rest begins to slip: `rate u = b - K u` along its unit direction `u`, with `b` the rate of the slip without
/// friction and `K` what friction takes from it.
#[derive(Clone, Copy, Debug)]
pub struct Onset<T> {
    /// The direction `u`.
    pub direction: [T; 2],
    /// Rate at which another direction would turn into this one, times the slip.
    pub pull: T,
}

impl<T: Real> Contacts<T> {
    /// Slip velocity at a contact.
    pub fn slip(&self, contact: usize, [vx, vy, sx, sy, sz, _]: &State<T>) -> [T; 2] {
        if contact == NOSE {
            [
                *vy + *sz * self.cos - *sx * self.sin,
                -(*vx * self.sin) - *sy,
            ]
        } else {
            [*vx - *sy, *vy + *sx]
        }
    }

    /// What friction does to slips: the nose across its line by itself, and each contact by the other, along y and across.
    fn factors(&self) -> (T, T, T) {
        let inertia = T::lift(2.5);
        (
            inertia + self.sin * self.sin,
            T::one() - inertia * self.sin,
            inertia - self.sin,
        )
    }

    /// The forces for given directions. Where a contact sticks, its friction keeps its slip from changing.
    pub fn forces(&self, directions: &Directions<T>) -> Forces<T> {
        let (sin, cos) = (self.sin, self.cos);
        let (zero, stiff) = (T::zero(), T::lift(3.5));
        let (across, coupled_y, coupled_x) = self.factors();
        let load_at = |up: T| (sin - cos * up).at_least(zero);
        let against =
            |contact: usize, direction: [T; 2]| direction.map(|u| -(u * self.mu[contact]));
        match *directions {
            [Some(nose), Some(cloth)] => {
                let nose = against(NOSE, nose);
                let load = load_at(nose[1]);
                Forces {
                    friction: [nose, against(CLOTH, cloth).map(|f| f * load)],
                    load,
                }
            }
            [Some(nose), None] => {
                let nose = against(NOSE, nose);
                let cloth = [cos - coupled_x * nose[1], -(coupled_y * nose[0])];
                Forces {
                    friction: [nose, cloth.map(|f| f / stiff)],
                    load: load_at(nose[1]),
                }
            }
            [None, Some(cloth)] => {
                let per_load = against(CLOTH, cloth);
                let pull = coupled_x * per_load[0];
                let pressed = -(sin * (cos + pull)) / (across - pull * cos);
                let lifted = -(sin * cos) / across;
                let up = if sin - cos * pressed > zero {
                    pressed
                } else {
                    lifted
                };
                let load = load_at(up);
                let cloth = per_load.map(|f| f * load);
                Forces {
                    friction: [[-(coupled_y * cloth[1]) / stiff, up], cloth],
                    load,
                }
            }
            [None, None] => {
                let held = cos / (T::one() + sin);
                Forces {
                    friction: [[zero, -held], [held, zero]],
                    load: load_at(-held),
                }
            }
        }
    }

    /// Rates of the velocities and spins of a state by the normal impulse at the nose; that of the work is left at zero.
    fn pushes(&self, directions: &Directions<T>) -> State<T> {
        let [[y, up], [cloth_x, cloth_y]] = self.forces(directions).friction;
        let turn = T::lift(2.5);
        [
            cloth_x - self.cos - self.sin * up,
            y + cloth_y,
            turn * (cloth_y - self.sin * y),
            -(turn * (up + cloth_x)),
            turn * self.cos * y,
            T::zero(),
        ]
    }

    /// Rates of a state by the normal impulse at the nose.
    pub fn rates(&self, state: &State<T>, modes: &[Mode; 2]) -> State<T> {
        let mut rates = self.pushes(&self.directions(state, modes));
        rates[WORK] = state[0].abs();
        rates
    }

    /// How much more friction the contacts that stick could take before one lets go, as a force; infinite if none sticks.
    pub fn margin(&self, directions: &Directions<T>) -> f64 {
        let Forces { friction, load } = self.forces(directions);
        let limits = [self.mu[NOSE], self.mu[CLOTH] * load];
        let of = |contact: usize| match directions[contact] {
            None => (limits[contact] - length(friction[contact])).to_f64(),
            Some(_) => f64::INFINITY,
        };
        of(NOSE).min(of(CLOTH))
    }

    /// In which direction each contact slips.
    pub fn directions(&self, state: &State<T>, modes: &[Mode; 2]) -> Directions<T> {
        let asked = self.settled(state, modes);
        let lags = self.lags(state, modes, &asked);
        [NOSE, CLOTH].map(|contact| {
            let turned = asked[contact]?;
            let lag = lags[contact];
            if lag == T::zero() {
                return Some(turned);
            }
            let size = (T::one() + lag * lag).sqrt();
            let across = [-turned[1], turned[0]];
            Some([0, 1].map(|i| (turned[i] + across[i] * lag) / size))
        })
    }

    /// By what angle each creeping slip lags behind the direction that the forces ask for, to first order in the slip: the direction
    /// asked for turns, and a slip takes the longer to follow the larger it is.
    pub fn lags(&self, state: &State<T>, modes: &[Mode; 2], asked: &Directions<T>) -> [T; 2] {
        let mut lags = [T::zero(); 2];
        if !modes.contains(&Mode::Creeps) {
            return lags;
        }
        let mut ahead = *state;
        for (value, push) in ahead.iter_mut().zip(self.pushes(asked)) {
            *value += push * T::lift(AHEAD);
        }
        let later = self.settled(&ahead, modes);
        for contact in [NOSE, CLOTH] {
            if let (Mode::Creeps, Some(now), Some(then)) =
                (modes[contact], asked[contact], later[contact])
            {
                let turning = dot(then, [-now[1], now[0]]) / T::lift(AHEAD);
                let pull = self.onset(contact, asked).pull;
                if pull > T::zero() {
                    lags[contact] = -(length(self.slip(contact, state)) * turning) / pull;
                }
            }
        }
        lags
    }

    /// Directions, those of creeping slips as the forces ask for them.
    pub fn settled(&self, state: &State<T>, modes: &[Mode; 2]) -> Directions<T> {
        let along = |contact: usize| {
            let slip = self.slip(contact, state);
            let speed = length(slip);
            if speed > T::zero() {
                slip.map(|u| u / speed)
            } else {
                slip
            }
        };
        let mut directions = [NOSE, CLOTH].map(|contact| match modes[contact] {
            Mode::Sticks => None,
            Mode::Slips => Some(along(contact)),
            Mode::Creeps => Some([T::zero(); 2]),
        });
        // one round is exact unless both begin to slip at once
        let rounds = if *modes == [Mode::Creeps; 2] { 4 } else { 1 };
        for contact in [NOSE, CLOTH].into_iter().cycle().take(2 * rounds) {
            if let Mode::Creeps = modes[contact] {
                directions[contact] = Some(self.onset(contact, &directions).direction);
            }
        }
        directions
    }

    /// How a contact begins to slip, the other doing as in `directions`.
    ///
    /// Its direction `u` solves `(s + K) u = b`, `|u| = 1`, in which `|u|` falls with `s`: Hebden's iteration, as for a trust region.
    pub fn onset(&self, contact: usize, directions: &Directions<T>) -> Onset<T> {
        let (zero, one) = (T::zero(), T::one());
        let rate = |direction: [T; 2]| {
            let mut tried = *directions;
            tried[contact] = Some(direction);
            self.slip(contact, &self.pushes(&tried))
        };
        let free = rate([zero; 2]);
        // across the cushion from one side, where the cloth is not relieved; along it from both, so that mirror images stay so
        let columns = [[one, zero], [zero, one]].map(|unit| {
            let [x, y] = rate(unit);
            let [p, q] = rate(unit.map(|u| -u));
            let along = if contact == NOSE { unit[0] } else { unit[1] };
            if along == one {
                [(p - x) / T::lift(2.0), (q - y) / T::lift(2.0)]
            } else {
                [free[0] - x, free[1] - y]
            }
        });
        let [[a, c], [b, d]] = columns;
        let solve = |s: T, [x, y]: [T; 2]| {
            let (p, q) = (a + s, d + s);
            let determinant = p * q - b * c;
            [(q * x - b * y) / determinant, (p * y - c * x) / determinant]
        };
        // where friction acts against the slip, as at the cloth, this is the answer
        let mut s = (length(free) - (a + d) / T::lift(2.0)).at_least(zero);
        for _ in 0..ROUNDS {
            let u = solve(s, free);
            let size = length(u);
            let slope = dot(u, solve(s, u));
            if slope <= zero || !size.is_finite() {
                break;
            }
            let next = (s + (size - one) * size * size / slope).at_least(zero);
            let change = (next - s).abs().to_f64();
            s = next;
            // convergence is quadratic, of the derivatives as well, which are one step behind
            if change <= SETTLED {
                break;
            }
        }
        let u = solve(s, free);
        let size = length(u);
        if size <= zero || !size.is_finite() {
            return Onset {
                direction: [zero; 2],
                pull: zero,
            };
        }
        let direction = u.map(|u| u / size);
        let across = [-direction[1], direction[0]];
        let taken = [0, 1].map(|i| columns[0][i] * across[0] + columns[1][i] * across[1]);
        Onset {
            direction,
            pull: s + dot(taken, across),
        }
    }

    /// The change of a state that takes away a slip by friction at that contact alone.
    pub fn undoing(&self, contact: usize, [first, second]: [T; 2]) -> State<T> {
        let (stiff, turn) = (T::lift(3.5), T::lift(2.5));
        if contact == NOSE {
            let (y, up) = (-(first / stiff), -(second / self.factors().0));
            [
                -(self.sin * up),
                y,
                -(turn * self.sin * y),
                -(turn * up),
                turn * self.cos * y,
                T::zero(),
            ]
        } else {
            let (x, y) = (-(first / stiff), -(second / stiff));
            [x, y, turn * y, -(turn * x), T::zero(), T::zero()]
        }
    }
}

/// Scalar product.
pub fn dot<T: Real>(a: [T; 2], b: [T; 2]) -> T {
    a[0] * b[0] + a[1] * b[1]
}

/// Length of a vector.
pub fn length<T: Real>(u: [T; 2]) -> T {
    dot(u, u).sqrt()
}
