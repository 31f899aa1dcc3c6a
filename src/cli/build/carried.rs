//! The files of `validation/` that travel with the program, as Rust: one list, by path.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders below `validation/` whose files travel; one that is not there holds nothing.
pub const FOLDERS: [&str; 4] = ["baselines", "engines", "hard", "scenes"];

/// A file that travels.
#[derive(Debug)]
pub struct Carried {
    /// Path below `validation/`, with `/` between its parts: `scenes/slide.toml`.
    pub name: String,
    /// Where it is now.
    pub file: PathBuf,
}

/// Every file of the folders, by name. Hidden ones, such as those of an interrupted write, stay behind.
/// Errors: a folder that cannot be read; a file that a package would leave out.
pub fn files(validation: &Path) -> Result<Vec<Carried>, String> {
    let mut found = Vec::new();
    for folder in FOLDERS {
        let path = validation.join(folder);
        if path.is_dir() {
            walk(&path, folder, &mut found)?;
        }
    }
    found.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(found)
}

fn walk(folder: &Path, name: &str, found: &mut Vec<Carried>) -> Result<(), String> {
    let cannot = |error| format!("cannot read {}: {error}", folder.display());
    for entry in fs::read_dir(folder).map_err(cannot)? {
        let entry = entry.map_err(cannot)?;
        let own = entry.file_name().to_string_lossy().into_owned();
        if own.starts_with('.') {
            continue;
        }
        let name = format!("{name}/{own}");
        if own == "Cargo.toml" {
            return Err(format!(
                "{name}: cargo leaves a folder with a Cargo.toml out of a package; call the template otherwise, such as Cargo.toml.in"
            ));
        }
        if entry.path().is_dir() {
            walk(&entry.path(), &name, found)?;
        } else {
            found.push(Carried {
                name,
                file: entry.path(),
            });
        }
    }
    Ok(())
}

/// The list as the value of a constant: pairs of name and text.
pub fn rust(files: &[Carried]) -> String {
    let line = |carried: &Carried| {
        let file = carried.file.to_string_lossy();
        format!("    ({:?}, include_str!({file:?})),\n", carried.name)
    };
    let lines: String = files.iter().map(line).collect();
    format!("&[\n{lines}]\n")
}
