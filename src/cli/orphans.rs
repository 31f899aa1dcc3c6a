//! Accepted files that no scene reads: what they hold is held by nothing, and looks as if it were.

use std::fs;
use std::path::{Path, PathBuf};

/// Names of accepted files in a folder that are none of `known`, in order.
pub fn orphans(folder: &Path, known: &[PathBuf]) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut found: Vec<String> = entries
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|e| e == "csv") && !known.contains(path))
        .map(|path| path.display().to_string())
        .collect();
    found.sort();
    found
}
