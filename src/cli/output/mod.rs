//! Writing files so that an interrupted run leaves the old file or the new one, never half of one, and files that belong together
//! come from one writer.
//!
//! Everything is written to a stage first, to disk; then, when it is this writer's turn in the folder, renamed file by file.

mod stage;
mod turn;

pub use stage::abandon;
use stage::{Stage, sweep};
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Component, Path, PathBuf};
use thiserror::Error;
use turn::{Busy, PATIENCE, Turn};

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
    /// Somebody else holds the folder and does not go on.
    #[error("another program has held {} for {} s; end it, or name another folder", path.display(), PATIENCE.as_secs())]
    Busy {
        /// The folder.
        path: PathBuf,
    },
}

/// How the files of a set belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Bond {
    /// The last is the sign that the others are complete: it is taken away before the first of them changes.
    Sign,
    /// Each can be read without the others.
    None,
}

/// Writes a set of files below `folder`, in order, making folders as needed.
///
/// `files`: path relative to `folder`, with `/` between its parts, and content. The set comes from one writer, however many write at a
/// time: the last one's stays. The last file is the sign that the others are complete: it is not there while they change, so that
/// a writer that was ended in the middle leaves no set that looks like one.
pub fn write_files<N: AsRef<str>, C: AsRef<[u8]>>(
    folder: &Path,
    files: impl IntoIterator<Item = (N, C)>,
) -> Result<(), OutputError> {
    write_files_unless(folder, files, || false).map(|_| ())
}

/// The same, unless `enough`, which is asked before each file is put to disk, while none has its name: then nothing is written, not
/// even the folder where it was not there. True if they were written.
pub fn write_files_unless<N: AsRef<str>, C: AsRef<[u8]>>(
    folder: &Path,
    files: impl IntoIterator<Item = (N, C)>,
    enough: impl Fn() -> bool,
) -> Result<bool, OutputError> {
    let mut placed = Vec::new();
    for (name, content) in files {
        let name = Path::new(name.as_ref());
        let inside = name
            .components()
            .all(|part| matches!(part, Component::Normal(_)));
        if !inside || name.as_os_str().is_empty() {
            return Err(OutputError::Outside { path: name.into() });
        }
        placed.push((folder.join(name), content));
    }
    write(folder, &placed, Bond::Sign, enough)
}

/// Writes files at their paths in or below `folder`, as [`write_files`] does, each of which can be read without the others.
pub fn write_at<P: AsRef<Path>, C: AsRef<[u8]>>(
    folder: &Path,
    files: &[(P, C)],
) -> Result<(), OutputError> {
    write(folder, files, Bond::None, || false).map(|_| ())
}

/// Writes one file, making its folder as needed.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), OutputError> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    write(folder, &[(path, content)], Bond::None, || false).map(|_| ())
}

/// What `read` makes of files in `folder` while nobody renames others there.
pub fn undisturbed<T>(folder: &Path, read: impl FnOnce() -> T) -> Result<T, OutputError> {
    let _turn = turn(folder)?;
    Ok(read())
}

fn turn(folder: &Path) -> Result<Option<Turn>, OutputError> {
    Turn::take(folder).map_err(|Busy| OutputError::Busy {
        path: folder.into(),
    })
}

/// Writes files at their paths, unless `enough`; `folder`: where the stage is, and the turn. True if they were written.
fn write<P: AsRef<Path>, C: AsRef<[u8]>>(
    folder: &Path,
    files: &[(P, C)],
    bond: Bond,
    enough: impl Fn() -> bool,
) -> Result<bool, OutputError> {
    if enough() {
        return Ok(false);
    }
    make_folder(folder)?;
    let paths: Vec<&Path> = files.iter().map(|(path, _)| path.as_ref()).collect();
    for path in &paths {
        path.parent().map_or(Ok(()), make_folder)?;
        if path.is_dir() {
            // before anything is changed
            return Err(failed(path)(ErrorKind::IsADirectory.into()));
        }
    }
    let stage = {
        let turn = turn(folder)?;
        if turn.is_some() {
            sweep(folder);
        }
        Stage::new(folder).map_err(failed(folder))?
    };
    for (number, (path, content)) in files.iter().enumerate() {
        if enough() {
            return Ok(false);
        }
        let written = stage.put(number, content.as_ref());
        written.map_err(failed(path.as_ref()))?;
    }
    let _turn = turn(folder)?;
    publish(&stage, &paths, bond)?;
    // before the turn ends: nobody shall take what is left of it for somebody else's
    drop(stage);
    Ok(true)
}

/// Gives the files of a stage their names.
fn publish(stage: &Stage, paths: &[&Path], bond: Bond) -> Result<(), OutputError> {
    let _whole = stage::in_one_piece();
    if let ([_, .., sign], Bond::Sign) = (paths, bond) {
        match fs::remove_file(sign) {
            Err(error) if error.kind() != ErrorKind::NotFound => return Err(failed(sign)(error)),
            _ => {}
        }
    }
    for (number, path) in paths.iter().enumerate() {
        stage.publish(number, path).map_err(failed(path))?;
    }
    // a rename is on disk only when the folder is; not every file system can say so, and the files themselves are complete
    #[cfg(unix)]
    for folder in paths
        .iter()
        .filter_map(|path| path.parent())
        .collect::<BTreeSet<_>>()
    {
        fs::File::open(folder)
            .and_then(|folder| folder.sync_all())
            .ok();
    }
    Ok(())
}

fn failed(path: &Path) -> impl FnOnce(io::Error) -> OutputError {
    let path = path.to_owned();
    |source| OutputError::File { path, source }
}

fn make_folder(path: &Path) -> Result<(), OutputError> {
    fs::create_dir_all(path).map_err(|source| OutputError::Folder {
        path: path.into(),
        source,
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::expect_used)]
mod tests {
    use super::stage::Stage;
    use super::turn::Turn;
    use super::{Bond, OutputError, publish, undisturbed, write_at, write_file, write_files};
    use std::fs;
    use std::path::Path;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::thread;

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

    /// Names of a set of four; the last is its sign.
    const SET: [&str; 4] = ["events.csv", "below/samples.csv", "final.csv", "run.json"];

    /// Who wrote each file of the set that is there.
    fn writers(folder: &Path) -> Vec<Option<String>> {
        SET.map(|name| fs::read_to_string(folder.join(name)).ok())
            .into()
    }

    #[test]
    fn a_set_comes_from_one_writer_however_many_write_it() {
        const WRITERS: usize = 6;
        const ROUNDS: usize = 25;
        let folder = tempfile::tempdir().unwrap();
        let (left, mixed, seen) = (
            AtomicUsize::new(WRITERS),
            AtomicUsize::new(0),
            AtomicUsize::new(0),
        );
        let is_mixed = |set: &[Option<String>]| set.iter().any(|file| *file != set[0]);
        thread::scope(|scope| {
            for writer in 0..WRITERS {
                let (left, folder) = (&left, folder.path());
                scope.spawn(move || {
                    for round in 0..ROUNDS {
                        let content = format!("{writer} {round}");
                        write_files(folder, SET.map(|name| (name, &content))).unwrap();
                    }
                    left.fetch_sub(1, Ordering::SeqCst);
                });
            }
            while left.load(Ordering::SeqCst) > 0 {
                let set = undisturbed(folder.path(), || writers(folder.path())).unwrap();
                mixed.fetch_add(usize::from(is_mixed(&set)), Ordering::SeqCst);
                seen.fetch_add(1, Ordering::SeqCst);
            }
        });
        let set = writers(folder.path());
        assert!(!is_mixed(&set) && set[0].is_some(), "{set:?}");
        let (mixed, seen) = (mixed.into_inner(), seen.into_inner());
        assert_eq!(mixed, 0, "of {seen} sets that were read");
        assert_eq!(
            names(folder.path()),
            ["events.csv", "final.csv", "run.json", "samples.csv"]
        );
    }

    #[test]
    fn a_set_that_was_cut_short_has_no_sign() {
        let folder = tempfile::tempdir().unwrap();
        let paths = ["a", "b", "sign"].map(|name| folder.path().join(name));
        write_files(folder.path(), [("a", "1"), ("b", "1"), ("sign", "1")]).unwrap();
        let stage = Stage::new(folder.path()).unwrap();
        for number in 0..3 {
            stage.put(number, b"2").unwrap();
        }
        // the writer is ended between the first file and the second
        fs::remove_file(stage.path(1)).unwrap();
        let paths: Vec<&Path> = paths.iter().map(|path| path.as_path()).collect();
        publish(&stage, &paths, Bond::Sign).expect_err("a file that is not there was renamed");
        drop(stage);
        assert_eq!(names(folder.path()), ["a", "b"]);
        // files that stand each for itself stay, whatever becomes of the others
        write_files(folder.path(), [("a", "1"), ("b", "1"), ("sign", "1")]).unwrap();
        let taken = folder.path().join("taken");
        write_file(&taken.join("x"), b"").unwrap();
        let files = [(folder.path().join("a"), "3"), (taken, "3")];
        write_at(folder.path(), &files).expect_err("a folder was replaced");
        assert_eq!(names(folder.path()), ["a", "b", "sign", "x"]);
        assert_eq!(fs::read_to_string(paths[0]).unwrap(), "1");
    }

    #[test]
    fn what_a_killed_writer_left_goes_and_what_a_living_one_has_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        // as a version without stages left it, and stages before and after their first file
        fs::write(path(".carom-abC123.part"), "half").unwrap();
        for (stage, files) in [
            (".carom-000000.part", &[][..]),
            (".carom-ZZZZZZ.part", &["alive", "0", "17"][..]),
        ] {
            fs::create_dir(path(stage)).unwrap();
            for file in files {
                fs::write(path(stage).join(file), "half").unwrap();
            }
        }
        let living = Stage::new(folder.path()).unwrap();
        living.put(0, b"mine").unwrap();
        write_file(&path("new"), b"new").unwrap();
        assert_eq!(names(folder.path()), ["0", "alive", "new"]);
        living.publish(0, &path("late")).unwrap();
        drop(living);
        assert_eq!(names(folder.path()), ["late", "new"]);
    }

    #[test]
    fn no_file_comes_into_a_stage_while_the_program_ends() {
        let folder = tempfile::tempdir().unwrap();
        let stage = Stage::new(folder.path()).unwrap();
        let ends = super::stage::in_one_piece();
        thread::scope(|scope| {
            let writer = scope.spawn(|| stage.put(0, b"late"));
            // as long as it takes a writer that does not wait, many times over
            thread::sleep(std::time::Duration::from_millis(100));
            let came = stage.path(0).exists();
            drop(ends);
            writer.join().unwrap().unwrap();
            assert!(!came, "a file came into a stage that may be being removed");
        });
        assert_eq!(fs::read(stage.path(0)).unwrap(), b"late");
    }

    #[test]
    fn what_is_not_ours_is_not_touched() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let others = [
            ".carom-abc.part",
            ".carom-abc1234.part",
            ".carom-abc12_.part",
            ".carom-abc123.part.bak",
            "carom-abc123.part",
            "x.carom-abc123.part",
            ".other-abc123.part",
            // the name of a stage, and something in it that no writer puts there
            ".carom-abc123.part/notes.txt",
        ];
        for name in others {
            write_file(&path(name), b"").unwrap();
        }
        #[cfg(unix)]
        std::os::unix::fs::symlink(path(others[0]), path(".carom-link00.part")).unwrap();
        let before = names(folder.path());
        write_file(&path("new"), b"").unwrap();
        let mut expected = before;
        expected.push("new".to_owned());
        expected.sort();
        assert_eq!(names(folder.path()), expected);
    }

    #[test]
    fn a_turn_is_had_by_one_at_a_time_and_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let (inside, most) = (AtomicUsize::new(0), AtomicUsize::new(0));
        thread::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|| {
                    for _ in 0..50 {
                        let turn = Turn::take(folder.path()).unwrap();
                        assert!(turn.is_some(), "this file system knows no locks");
                        most.fetch_max(inside.fetch_add(1, Ordering::SeqCst) + 1, Ordering::SeqCst);
                        thread::yield_now();
                        inside.fetch_sub(1, Ordering::SeqCst);
                    }
                });
            }
        });
        assert_eq!(most.into_inner(), 1);
        assert_eq!(names(folder.path()), [""; 0]);
        // a folder that is not there knows no turns, and reading there fails as it would
        assert!(Turn::take(&folder.path().join("none")).unwrap().is_none());
    }
}
