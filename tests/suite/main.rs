//! One test binary: what the crate promises, held from outside.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

<<<<<<< HEAD
mod architecture;
mod stepper;
=======
mod rapier;
>>>>>>> rapier
mod support;
mod transcription;
