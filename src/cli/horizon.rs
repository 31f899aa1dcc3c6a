//! `carom horizon`.

use super::arguments::HorizonArguments;
use super::{Failure, publish, scene, terminal};
use crate::page;
use crate::study::horizon;
use std::process::ExitCode;

/// Prints how far a scene can be predicted; writes it as a page where a folder is given.
pub fn horizon(arguments: &HorizonArguments) -> Result<ExitCode, Failure> {
    let scene = scene::resolve(&arguments.scene)?;
    let precision = arguments.precision;
    let outcome = horizon::study(&scene, precision, terminal::cancelled())
        .map_err(|refusal| Failure::Message(format!("{}: {refusal}", scene.name)))?;
    let document = page::horizon::page(&outcome);
    publish(
        &document,
        &arguments.format,
        || document.clone(),
        arguments.out.as_deref(),
    )
}
