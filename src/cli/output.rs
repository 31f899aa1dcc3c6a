//! Writing files so that an interrupted run leaves the old file or the new one, never half of one.

use std::fs;
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::Builder;
use thiserror::Error;

/// The temporary file that is being written.
static PART: Mutex<Option<PathBuf>> = Mutex::new(None);

fn part() -> MutexGuard<'static, Option<PathBuf>> {
    PART.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Takes away the file that is being written, if one is; while the answer is held, no other is begun and none gets its name.
pub fn abandon() -> impl Drop {
    let mut part = part();
    if let Some(path) = part.take() {
        // there is nobody left to tell
        fs::remove_file(path).ok();
    }
    part
}

/// Why a file could not be written. Files written before it stay.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The folder is not there and cannot be made.
    #[error("cannot make the folder {}: {source}", path.display())]
    Folder {
        /// The folder.
        path: PathBuf,
        /// The system's answer.
        source: io::Error,
    },
    /// The file cannot be written; an older one of that name is untouched.
    #[error("cannot write {}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The system's answer.
        source: io::Error,
    },
    /// A name leads out of the folder that the user named.
    #[error("cannot write {}: the name leads out of the output folder", path.display())]
    Outside {
        /// The name.
        path: PathBuf,
    },
}

/// Writes files below `folder`, in order, making folders as needed.
///
/// `files`: path relative to `folder`, with `/` between its parts, and content. Each file is replaced at once; the set of
/// them is not, so what others find their way by belongs last.
pub fn write_files<N: AsRef<str>, C: AsRef<[u8]>>(
    folder: &Path,
    files: impl IntoIterator<Item = (N, C)>,
) -> Result<(), OutputError> {
    write_files_until(folder, files, || false).map(|_| ())
}

/// The same until `enough`, which is asked before each file. Answers how many were written.
pub fn write_files_until<N: AsRef<str>, C: AsRef<[u8]>>(
    folder: &Path,
    files: impl IntoIterator<Item = (N, C)>,
    enough: impl Fn() -> bool,
) -> Result<usize, OutputError> {
    make_folder(folder)?;
    let mut written = 0;
    for (name, content) in files {
        if enough() {
            break;
        }
        let name = Path::new(name.as_ref());
        let inside = name
            .components()
            .all(|part| matches!(part, Component::Normal(_)));
        if !inside || name.as_os_str().is_empty() {
            return Err(OutputError::Outside { path: name.into() });
        }
        write_file(&folder.join(name), content.as_ref())?;
        written += 1;
    }
    Ok(written)
}

/// Writes one file, making its folder as needed: to a temporary name beside it, then to disk, then renamed.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), OutputError> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    make_folder(folder)?;
    replace(folder, path, content).map_err(|source| OutputError::File {
        path: path.into(),
        source,
    })
}

fn make_folder(path: &Path) -> Result<(), OutputError> {
    fs::create_dir_all(path).map_err(|source| OutputError::Folder {
        path: path.into(),
        source,
    })
}

fn replace(folder: &Path, path: &Path, content: &[u8]) -> io::Result<()> {
    let mut builder = Builder::new();
    builder.prefix(".carom-").suffix(".part");
    // a temporary file is private by default; a result is as readable as any file of this user
    #[cfg(unix)]
    let permissions = std::os::unix::fs::PermissionsExt::from_mode(0o666);
    #[cfg(unix)]
    builder.permissions(permissions);
    let mut file = {
        let mut part = part();
        let file = builder.tempfile_in(folder)?;
        *part = Some(file.path().to_owned());
        file
    };
    let written = file
        .write_all(content)
        .and_then(|()| file.as_file().sync_all());
    // from here on it has its name or none
    let mut part = part();
    *part = None;
    written?;
    file.persist(path).map_err(|error| error.error)?;
    drop(part);
    // the rename is on disk only when the folder is; not every file system can say so, and the file itself is complete
    #[cfg(unix)]
    fs::File::open(folder)
        .and_then(|folder| folder.sync_all())
        .ok();
    Ok(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::expect_used)]
mod tests {
    use super::{OutputError, write_file, write_files};
    use std::fs;
    use std::path::Path;

    /// Names in a folder and below it.
    fn names(folder: &Path) -> Vec<String> {
        let mut names = Vec::new();
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                names.extend(self::names(&path));
            } else {
                names.push(path.file_name().unwrap().to_string_lossy().into_owned());
            }
        }
        names.sort();
        names
    }

    #[test]
    fn files_are_written_with_their_folders_and_nothing_else_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("a/b");
        write_files(&out, [("index.html", "1"), ("pages/x.html", "2")]).unwrap();
        write_files(&out, [("index.html", "3")]).unwrap();
        assert_eq!(fs::read_to_string(out.join("index.html")).unwrap(), "3");
        assert_eq!(fs::read_to_string(out.join("pages/x.html")).unwrap(), "2");
        assert_eq!(names(folder.path()), ["index.html", "x.html"]);
    }

    #[test]
    fn a_write_that_fails_leaves_the_old_file_and_no_other() {
        let folder = tempfile::tempdir().unwrap();
        // a folder that is not empty cannot be replaced by a file: the rename fails after everything was written
        let taken = folder.path().join("taken");
        write_file(&taken.join("old"), b"old").unwrap();
        let error = write_file(&taken, b"new").expect_err("a folder was replaced");
        assert!(matches!(error, OutputError::File { .. }), "{error}");
        assert!(error.to_string().starts_with("cannot write "), "{error}");
        assert_eq!(names(folder.path()), ["old"]);
        assert_eq!(fs::read(taken.join("old")).unwrap(), b"old");
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        write_file(&file, b"").unwrap();
        let error = write_files(&file.join("below"), [("x", "")]).expect_err("a folder in a file");
        assert!(matches!(error, OutputError::Folder { .. }), "{error}");
        assert!(error.to_string().contains("file"), "{error}");
    }

    #[test]
    fn no_name_leads_out_of_the_folder() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["../x", "/x", "a/../../x", ""] {
            let error = write_files(folder.path(), [(name, "")]).expect_err(name);
            assert!(
                matches!(error, OutputError::Outside { .. }),
                "{name}: {error}"
            );
        }
        assert_eq!(names(folder.path()), [""; 0]);
    }

    #[cfg(unix)]
    #[test]
    fn results_are_as_readable_as_other_files() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (ours, plain) = (folder.path().join("ours"), folder.path().join("plain"));
        write_file(&ours, b"").unwrap();
        fs::write(&plain, b"").unwrap();
        let mode = |path| fs::metadata(path).unwrap().permissions().mode();
        assert_eq!(mode(&ours), mode(&plain));
    }
}
