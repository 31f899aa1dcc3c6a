//! Files, written whole or not at all.

use std::fs;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// A file or folder that could not be written.
#[derive(Debug, Error)]
#[error("cannot write {}: {why}", path.display())]
pub struct OutputError {
    path: PathBuf,
    why: std::io::Error,
}

/// Writes files below a folder.
pub fn write_files<N: AsRef<str>, T: AsRef<str>>(
    folder: &Path,
    files: impl IntoIterator<Item = (N, T)>,
) -> Result<(), OutputError> {
    for (name, text) in files {
        let path = folder.join(name.as_ref());
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(|why| OutputError {
                path: parent.to_owned(),
                why,
            })?;
        }
        fs::write(&path, text.as_ref()).map_err(|why| OutputError { path, why })?;
    }
    Ok(())
}
