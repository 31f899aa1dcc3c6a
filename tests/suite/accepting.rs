//! A program that is killed while it accepts findings, the same for `check` and `stability`.

use carom::gate;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

/// Kills a program while it accepts findings, at eight moments from just before the first file is written on, and demands that every
/// file is a whole one each time. `folder` holds the accepted files of `scenes`; `command` makes the command with its arguments.
pub fn kill_while_accepting(
    folder: &Path,
    scenes: &[&str],
    command: impl Fn(&Path, &[&str]) -> Command,
) {
    let file = |scene: &str| folder.join(format!("{scene}.csv"));
    let whole: Vec<String> = scenes
        .iter()
        .map(|scene| fs::read_to_string(file(scene)).unwrap())
        .collect();
    let mut killed = 0;
    for attempt in 0..8 {
        // every file differs from what is found, so every file is written anew
        for (scene, text) in scenes.iter().zip(&whole) {
            fs::write(file(scene), text.replacen("holds", "breaks", 1)).unwrap();
        }
        let arguments = [scenes, &["--accept", "--reason", "again"]].concat();
        let mut child = command(folder, &arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        // the first word of the document is printed just before the files are written
        let mut first = [0; 1];
        std::io::Read::read_exact(child.stdout.as_mut().unwrap(), &mut first).unwrap();
        std::thread::sleep(Duration::from_micros(400 * attempt));
        child.kill().unwrap();
        killed += usize::from(!child.wait().unwrap().success());
        for scene in scenes {
            let text = fs::read_to_string(file(scene)).unwrap();
            let read = gate::read(&text).unwrap_or_else(|error| panic!("{scene}: {error}"));
            assert!(read.rows.len() > 20, "{scene}: {}", read.rows.len());
        }
    }
    assert!(killed > 0, "no attempt was killed before its end");
}
