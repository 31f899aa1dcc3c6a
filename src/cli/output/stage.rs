//! Where files are written before they are renamed, and what is done with what a killed program left there.
//!
//! A stage is a folder `.carom-XXXXXX.part` beside the files that it will become. The file `alive` in it is locked by its writer. The
//! system takes that lock back when the writer ends, however it ends, so a stage whose lock can be had belongs to nobody.

use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::{Builder, TempDir};

/// How the name of a stage begins; earlier versions named single files so.
const PREFIX: &str = ".carom-";

/// How it ends.
const SUFFIX: &str = ".part";

/// Letters and digits between the two.
const RANDOM: usize = 6;

/// The file that a living writer has locked.
const ALIVE: &str = "alive";

/// The stages of this program.
static STAGES: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn stages() -> MutexGuard<'static, Vec<PathBuf>> {
    STAGES.lock().unwrap_or_else(PoisonError::into_inner)
}

/// While the answer is held, [`abandon`] waits: a set gets its names or none.
pub fn in_one_piece() -> impl Drop {
    stages()
}

/// Removes the stages of this program; while the answer is held, none is begun and no file gets its name. For the end of the program.
pub fn abandon() -> impl Drop {
    let mut stages = stages();
    for stage in stages.drain(..) {
        // there is nobody left to tell
        remove_stage(&stage).ok();
    }
    stages
}

/// Files that are whole before anybody sees them under their names. What is left of it goes when it is dropped.
#[derive(Debug)]
pub struct Stage {
    // dropped in this order: some systems remove no folder with an open file in it
    _alive: File,
    folder: TempDir,
}

impl Stage {
    /// An empty stage in `folder`. Whoever calls has the turn there, or somebody may take the stage for a leftover.
    pub fn new(folder: &Path) -> io::Result<Self> {
        let mut builder = Builder::new();
        builder.prefix(PREFIX).suffix(SUFFIX).rand_bytes(RANDOM);
        let mut stages = stages();
        let folder = builder.tempdir_in(folder)?;
        stages.push(folder.path().to_owned());
        let alive = File::create_new(folder.path().join(ALIVE))?;
        drop(stages);
        // where the file system has no locks nobody can find out that this is no leftover, and nobody removes one
        alive.try_lock().ok();
        Ok(Stage {
            _alive: alive,
            folder,
        })
    }

    /// The path of file `number`.
    pub fn path(&self, number: usize) -> PathBuf {
        self.folder.path().join(number.to_string())
    }

    /// Writes file `number`, to disk.
    pub fn put(&self, number: usize, content: &[u8]) -> io::Result<()> {
        // no file comes into a stage that is being removed
        let turn = stages();
        let mut file = File::create_new(self.path(number))?;
        drop(turn);
        file.write_all(content)?;
        file.sync_all()
    }

    /// Gives file `number` its name, in place of an older file.
    pub fn publish(&self, number: usize, name: &Path) -> io::Result<()> {
        match fs::rename(self.path(number), name) {
            // a folder below that of the stage may be a link to another disk
            Err(error) if error.kind() == ErrorKind::CrossesDevices => {
                let beside = name.parent().unwrap_or(Path::new("."));
                let near = Builder::new().prefix(PREFIX).tempdir_in(beside)?;
                let copy = near.path().join("0");
                fs::copy(self.path(number), &copy)?;
                fs::rename(copy, name)
            }
            renamed => renamed,
        }
    }
}

impl Drop for Stage {
    fn drop(&mut self) {
        stages().retain(|stage| stage != self.folder.path());
    }
}

/// Removes what writers that are no more left in `folder`. Whoever calls has the turn there. What cannot be removed stays.
pub fn sweep(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    for entry in entries.flatten() {
        if !is_ours(&entry.file_name()) {
            continue;
        }
        let path = entry.path();
        match entry.file_type() {
            Ok(kind) if kind.is_dir() && is_left(&path.join(ALIVE), true) => {
                remove_stage(&path).ok();
            }
            // a version of carom without stages
            Ok(kind) if kind.is_file() && is_left(&path, false) => {
                fs::remove_file(&path).ok();
            }
            _ => {}
        }
    }
}

fn is_ours(name: &OsStr) -> bool {
    let middle = name
        .to_str()
        .and_then(|name| name.strip_prefix(PREFIX)?.strip_suffix(SUFFIX));
    middle.is_some_and(|middle| {
        middle.len() == RANDOM && middle.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

/// True if nobody has locked `file`; `without`: what is true if it is not there. Where it cannot be known, somebody has.
fn is_left(file: &Path, without: bool) -> bool {
    match OpenOptions::new().read(true).write(true).open(file) {
        Ok(file) => match file.try_lock() {
            Ok(()) => true,
            Err(TryLockError::WouldBlock | TryLockError::Error(_)) => false,
        },
        Err(error) => error.kind() == ErrorKind::NotFound && without,
    }
}

/// Removes a stage with the files that a writer puts there, and no others: if there are some, it stays.
fn remove_stage(stage: &Path) -> io::Result<()> {
    for entry in fs::read_dir(stage)? {
        let name = entry?.file_name();
        let is_part = |name: &str| name == ALIVE || name.bytes().all(|byte| byte.is_ascii_digit());
        if name.to_str().is_some_and(is_part) {
            fs::remove_file(stage.join(name))?;
        }
    }
    fs::remove_dir(stage)
}
