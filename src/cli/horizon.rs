//! `carom horizon`.

use super::arguments::HorizonArguments;
use super::{Failure, output, scene, terminal};
use crate::engine::exact::Precision;
use crate::report;
use crate::study::horizon;
use std::process::ExitCode;

/// Prints how far a scene can be predicted; writes it as a page where a folder is given.
pub fn horizon(arguments: &HorizonArguments) -> Result<ExitCode, Failure> {
    let scene = scene::resolve(&arguments.scene)?;
    let precision = Precision::find(&arguments.precision).unwrap_or_default();
    let document = horizon::study(&scene, precision, terminal::cancelled())
        .map_err(|refusal| Failure::Message(format!("{}: {refusal}", scene.name)))?;
    if let Some(folder) = &arguments.out {
        output::write_files(folder, report::site(&document))?;
    }
    let printed =
        terminal::print(&report::render(&document, &arguments.format).unwrap_or_default());
    if let Some(folder) = &arguments.out {
        terminal::say(&format!("Page: {}", folder.join("index.html").display()));
    }
    printed
}
