//! One at a time: whoever renames a set of files into a folder, or reads one out of it, has the folder meanwhile.
//!
//! The system keeps the turn and takes it back when its holder ends, however that ends; nothing is left behind. On Unix it is an
//! advisory lock on the folder itself, on Windows a file that nobody else can open and that goes with its handle. Where a folder
//! knows neither (some file systems of clusters), everything is written without.

use std::fs::File;
use std::io;
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

/// How long a turn is waited for: a set is renamed in milliseconds, so whoever holds it longer was stopped meanwhile.
pub const PATIENCE: Duration = Duration::from_secs(60);

/// How often it is looked whether it is our turn.
const LOOK: Duration = Duration::from_millis(2);

/// The turn of whoever holds it, until it is dropped.
#[derive(Debug)]
pub struct Turn(#[allow(dead_code, reason = "what holds the turn is that it is open")] File);

/// Somebody else has held the folder for [`PATIENCE`].
#[derive(Debug)]
pub struct Busy;

/// How one attempt went.
enum Attempt {
    Ours(File),
    Theirs,
}

impl Turn {
    /// Waits for the turn in a folder; `None` where the folder is not there or knows no turns.
    pub fn take(folder: &Path) -> Result<Option<Turn>, Busy> {
        let begin = Instant::now();
        loop {
            match attempt(folder) {
                Ok(Attempt::Ours(file)) => return Ok(Some(Turn(file))),
                Err(_) => return Ok(None),
                Ok(Attempt::Theirs) if begin.elapsed() > PATIENCE => return Err(Busy),
                Ok(Attempt::Theirs) => thread::sleep(LOOK),
            }
        }
    }
}

#[cfg(unix)]
fn attempt(folder: &Path) -> io::Result<Attempt> {
    use std::fs::TryLockError;
    let file = File::open(folder)?;
    match file.try_lock() {
        Ok(()) => Ok(Attempt::Ours(file)),
        Err(TryLockError::WouldBlock) => Ok(Attempt::Theirs),
        Err(TryLockError::Error(error)) => Err(error),
    }
}

#[cfg(windows)]
fn attempt(folder: &Path) -> io::Result<Attempt> {
    use std::os::windows::fs::OpenOptionsExt;
    /// Of `CreateFile`: the file is removed with its last handle.
    const DELETE_ON_CLOSE: u32 = 0x0400_0000;
    /// Somebody else has it open.
    const SHARING_VIOLATION: i32 = 32;
    /// Somebody else had it open, and it is being removed.
    const ACCESS_DENIED: i32 = 5;
    let path = folder.join(".carom-turn");
    let mut options = std::fs::OpenOptions::new();
    options.write(true).create(true).truncate(false);
    match options
        .share_mode(0)
        .custom_flags(DELETE_ON_CLOSE)
        .open(&path)
    {
        Ok(file) => Ok(Attempt::Ours(file)),
        Err(error) => match error.raw_os_error() {
            Some(SHARING_VIOLATION) => Ok(Attempt::Theirs),
            Some(ACCESS_DENIED) if path.exists() => Ok(Attempt::Theirs),
            _ => Err(error),
        },
    }
}

#[cfg(not(any(unix, windows)))]
fn attempt(_folder: &Path) -> io::Result<Attempt> {
    Err(io::ErrorKind::Unsupported.into())
}
