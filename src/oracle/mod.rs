//! Who is the reference of a scene, up to where it can be believed, and what is said where there is none.
//!
//! - Who: [`engine`], in whatever precision a study wants; [`is_reference`] tells its runs from those that are held against them.
//! - Up to where: [`horizon()`], with a finer precision as the witness and the growth of perturbations beside it; an [`Oracle`] is what is
//!   known of one scene by both, in f64, and what error a first-order engine may have by then; [`believed_until`] cuts a scene off there.
//! - A run is a reference only if it reached the end that the scene asks for: [`answer()`] says so, or why there is none ([`Absence`]).
//!
//! Whoever wants any of this asks here, so this is the only room above `engine/` that names an engine.

mod absence;
mod answer;
mod horizon;
mod places;

pub use crate::engine::exact::Precision;
pub use crate::engine::exact::place_errors;
pub use crate::engine::exact::sensitivity::{
    Growth, Influence, Input, Lost, Why, growth, influences,
};
pub use absence::{Absence, Lack, NOTHING, answer};
pub use answer::{Allowance, Oracle, rounding};
pub use horizon::{BAND, Horizon, Limit, MOST_BALLS, Sight, believed_until, horizon};

use crate::engine::exact::Exact;
use crate::engine::{Engine, Setting};
use std::sync::{Arc, LazyLock};

static ENGINE: LazyLock<Arc<dyn Engine>> = LazyLock::new(|| Arc::new(Exact));

/// The engine that others are held against.
pub fn engine() -> &'static Arc<dyn Engine> {
    &ENGINE
}

/// True for the engine that others are held against.
pub fn is_reference(engine: &dyn Engine) -> bool {
    engine.id() == self::engine().id()
}

/// The precision that a setting of the reference asks for; `None` if it is no setting of that engine.
pub fn precision(setting: &Setting) -> Option<Precision> {
    Exact::precision(setting)
}

/// The setting in which the reference has more digits than any engine but itself.
pub fn finest() -> Setting {
    Setting::default().with("precision", Precision::F256.id())
}
