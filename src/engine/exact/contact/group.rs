//! Balls that press on each other or on a cushion: who, in which state, and the equations of their common motion.
//!
//! A contact carries a normal force `lambda >= 0` that keeps the gap's acceleration at zero, and Coulomb friction `mu lambda` against the slip
//! where balls rub. Every ball answers to the sum of what the cloth and its contacts do: one that slides, or meets no cloth, with its whole mass; one
//! that rolls with 7/5 of it, its rolling loss acting wholly all the while; one at rest not at all, up to its threshold. So all accelerations are affine in
//! the forces, and the forces follow from one linear equation a contact.
//!
//! Per ball, with `F` its sum of contact forces and `q = (F_x + (n x F)_y, F_y - (n x F)_x)` the part that counts for rolling: sliding
//! `a = -mu_s g u/|u| + F/m`; rolling `a = -mu_r g v/|v| + 5/7 q/m`; at rest while `|q| <= 7/5 mu_r m g`. Vertical forces change neither
//! the height of a ball nor its weight on the cloth.

use crate::engine::exact::encounter::Encounter;
use crate::engine::exact::spin::Moving;
use crate::engine::exact::world::World;
use crate::math::Real;
use crate::physics::Side;

/// What the cloth does to a ball that is pressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Its lowest point slips over the cloth.
    Slides,
    /// It rolls.
    Rolls,
    /// Its centre rests.
    Rests,
    /// It does not turn, and friction acts on its centre.
    Drags,
    /// The cloth does nothing.
    Floats,
}

/// What the cloth does to the spin about the vertical.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Twist {
    /// It falls towards zero from this side.
    Falls(bool),
    /// It is zero and held there.
    Held,
    /// The cloth does nothing about it.
    Free,
}

/// A ball of a group.
#[derive(Clone, Copy, Debug)]
pub struct Member<T> {
    /// Index in scene order.
    pub ball: usize,
    /// How it moves at the start.
    pub moving: Moving<T>,
    /// What the cloth does to its centre.
    pub mode: Mode,
    /// What the cloth does to its spin about the vertical.
    pub twist: Twist,
}

/// Who touches whom; balls as positions in the group's list of members.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// Two members.
    Pair(usize, usize),
    /// A member and a cushion.
    Cushion(usize, Side),
}

impl Touch {
    /// The touch of an encounter; `None` if a party is no member.
    pub fn of<T>(encounter: Encounter, members: &[Member<T>]) -> Option<Self> {
        let place = |ball: usize| members.iter().position(|m| m.ball == ball);
        Some(match encounter {
            Encounter::Pair(a, b) => Touch::Pair(place(a)?, place(b)?),
            Encounter::Cushion(a, side) => Touch::Cushion(place(a)?, side),
        })
    }

    /// The same by balls.
    pub fn encounter<T>(self, members: &[Member<T>]) -> Encounter {
        match self {
            Touch::Pair(a, b) => {
                let (a, b) = (members[a].ball, members[b].ball);
                Encounter::Pair(a.min(b), a.max(b))
            }
            Touch::Cushion(a, side) => Encounter::Cushion(members[a].ball, side),
        }
    }

    /// The members that take part, and on which side of the normal: -1 for the first, +1 for the second.
    pub fn members(self) -> impl Iterator<Item = (usize, f64)> {
        let (first, second) = match self {
            Touch::Pair(a, b) => (a, Some(b)),
            Touch::Cushion(a, _) => (a, None),
        };
        std::iter::once((first, -1.0)).chain(second.map(|b| (b, 1.0)))
    }
}

/// A contact of a group.
#[derive(Clone, Copy, Debug)]
pub struct Hold {
    /// Who touches whom.
    pub touch: Touch,
    /// Whether it carries a force; otherwise its parties move alongside.
    pub pressed: bool,
}

impl Hold {
    /// A contact of which it is not known whether it carries a force.
    pub fn open(touch: Touch) -> Self {
        Hold {
            touch,
            pressed: false,
        }
    }
}

/// Balls that are held together by contacts.
#[derive(Clone, Debug)]
pub struct Group<T> {
    /// The balls.
    pub members: Vec<Member<T>>,
    /// The contacts.
    pub holds: Vec<Hold>,
}

/// What ends a stretch of smooth motion of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// The force of a contact has fallen to zero.
    Released(usize),
    /// A contact without force would be pressed.
    Presses(usize),
    /// A contact without force opens.
    Opens(usize),
    /// The slip of a member ends: it rolls.
    Rolls(usize),
    /// The centre of a member stops.
    Stops(usize),
    /// The spin of a member about the vertical ends.
    Unspun(usize),
    /// Rolling needs more friction than there is: a member slips.
    Slips(usize),
    /// A member at rest is pushed beyond its threshold.
    Breaks(usize),
    /// A member that did not turn about the vertical does.
    Twists(usize),
}

impl<T: Real> Group<T> {
    /// Who touches whom.
    pub fn touches(&self) -> Vec<Touch> {
        self.holds.iter().map(|hold| hold.touch).collect()
    }

    /// The largest acceleration of what the cloth does to members and of those that turn round others, length/s^2: of what the forces between
    /// them are made, and so what their openings are good to.
    pub fn at_work(&self, world: &World<T>) -> T {
        let each = self.members.iter().map(|member| {
            let cloth = match (member.mode, world.rotation) {
                (Mode::Slides | Mode::Drags, _) => world.strongest(),
                (Mode::Rolls, Some(rotation)) => rotation.roll,
                _ => T::zero(),
            };
            let [x, y] = member.moving.velocity;
            cloth.at_least((x * x + y * y) / world.radius[member.ball])
        });
        let most = each.fold(T::zero(), T::at_least);
        if most > T::zero() {
            most
        } else {
            world.strongest()
        }
    }

    /// The contacts that carry a force.
    pub fn pressed(&self) -> Vec<usize> {
        (0..self.holds.len())
            .filter(|k| self.holds[*k].pressed)
            .collect()
    }
}

/// The largest speed of members and of their surfaces, length/s.
pub fn loudest<T: Real>(world: &World<T>, members: &[Member<T>]) -> T {
    let each = members.iter().map(|m| world.loudness(m.ball, &m.moving));
    each.fold(T::zero(), T::at_least)
}
