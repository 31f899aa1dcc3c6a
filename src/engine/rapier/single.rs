//! rapier in f32. [`world`] is the same file as in [`super::double`]; only the crate that it is compiled against differs.

use rapier3d as rapier;

#[path = "world.rs"]
#[allow(clippy::duplicate_mod, reason = "one source, two precisions")]
pub(super) mod world;
