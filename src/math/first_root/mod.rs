//! When two discs first touch, and when a disc first touches a wall, under constant acceleration.
//!
//! Both are first-root problems, and the first root is all that matters: a root that is missed or invented changes every
//! later event of a run. So three things are fixed here, once:
//!
//! - **Geometry.** The distance function `f(t) = |p + v t + a t^2/2|^2 - D^2` is evaluated in this form and never by the
//!   five coefficients of the quartic, whose cancellation loses half of the digits in a graze.
//! - **Event rule.** Contact is the first `t` in `[0, limit]` with `f <= 0` *and* `f' < 0`. Overlapping and approaching is
//!   contact now; overlapping and receding waits for the next turn inward.
//! - **Honesty.** What is decided by the last digits is answered [`Contact::Unclear`]: a graze or a stop that is a hit or a
//!   miss depending on an error of size [`Blur`].
//!
//! [`first_contact`] is the finder that the engine uses (one-sided: it cannot step past a root; [`first_contact_by`] gives up
//! early on what comes too late), [`straight_contact`] its closed form for motion along a line, [`first_crossing`] the same
//! for a wall. [`bracketed_contact`] is a second finder that shares no code with them; tests hold the two against each other.
//!
//! How good a contact time can be at all, and how good the finders make it, is derived in `error.rs` and answered by
//! [`time_error`], [`turn_error`] and [`crossing_error`]. `cargo bench --bench roots` prints the errors of every pathological
//! class of `validation/references/contact_roots.csv` in units of that bound.

mod bracketing;
mod error;
mod one_sided;
mod straight;
mod wall;

#[cfg(test)]
mod tests;

pub use bracketing::bracketed_contact;
pub use error::{InputError, crossing_error, time_error, turn_error};
pub use one_sided::{first_contact, first_contact_by};
pub use straight::straight_contact;
pub use wall::first_crossing;

/// Motion of one disc as seen from another: `p + v t + a t^2 / 2` in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach<T> {
    /// From the centre of the first to the centre of the second at time 0, length.
    pub p: [T; 2],
    /// Relative velocity at time 0, length/s.
    pub v: [T; 2],
    /// Relative acceleration, length/s^2.
    pub a: [T; 2],
    /// Distance of the centres at contact, length, > 0.
    pub distance: T,
}

/// Errors of what a finder is given: what lies below them cannot be decided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blur<T> {
    /// Error of a relative position, length, > 0.
    pub length: T,
    /// Error of a relative velocity, length/s, >= 0.
    pub speed: T,
}

/// What a finder found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact<T> {
    /// No contact up to the limit. What is within the blur of contact at the limit itself is for the caller, who searches on
    /// from there, unless the motion ends there.
    Never,
    /// First contact, s from now.
    At(T),
    /// From this time on, s from now, the scalar cannot tell whether there is a contact.
    Unclear(T),
}

impl<T: Copy> Contact<T> {
    /// Time of the contact, if there is one without doubt.
    pub fn time(self) -> Option<T> {
        match self {
            Contact::At(t) => Some(t),
            Contact::Never | Contact::Unclear(_) => None,
        }
    }
}
