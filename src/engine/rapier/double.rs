//! rapier in f64. [`world`] is the same file as in [`super::single`]; only the crate that it is compiled against differs.

use rapier3d_f64 as rapier;

#[path = "world.rs"]
#[allow(clippy::duplicate_mod, reason = "one source, two precisions")]
pub(super) mod world;
