//! Processes that write into one folder at a time, and processes that are killed while they write.

use assert_cmd::cargo::cargo_bin;
use carom::trace::files::{EVENTS, FINAL, RUN, SAMPLES};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

const SET: [&str; 4] = [EVENTS, SAMPLES, FINAL, RUN];

fn run(arguments: &[&str], out: &Path) -> Child {
    let mut command = Command::new(cargo_bin("carom"));
    command.arg("run").args(arguments).arg("--out").arg(out);
    let command = command.stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().unwrap()
}

/// The four files in a folder, as far as they are there.
fn set(folder: &Path) -> Vec<Option<Vec<u8>>> {
    SET.iter()
        .map(|name| fs::read(folder.join(name)).ok())
        .collect()
}

/// Names in a folder that begin with a dot.
fn hidden(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let names = entries.map(|entry| PathBuf::from(entry.file_name()));
    names
        .filter(|name| name.to_string_lossy().starts_with('.'))
        .collect()
}

#[test]
fn the_files_of_a_run_come_from_one_process_however_many_write_them() {
    let runs: [&[&str]; 4] = [
        &["head-on", "--engine", "exact"],
        &["head-on", "--engine", "stepper"],
        &["head-on", "--engine", "stepper", "--set", "dt=0.01"],
        &["slide", "--engine", "exact"],
    ];
    let folder = tempfile::tempdir().unwrap();
    let alone = runs.map(|arguments| {
        let out = folder.path().join("alone");
        assert!(run(arguments, &out).wait().unwrap().success());
        set(&out)
    });
    for (i, own) in alone.iter().enumerate() {
        assert!(own.iter().all(Option::is_some));
        for other in &alone[..i] {
            assert!(
                own.iter().zip(other).all(|(a, b)| a != b),
                "two runs wrote one file alike: the test could not tell them apart"
            );
        }
    }
    let out = folder.path().join("shared");
    for round in 0..8 {
        let mut writers: Vec<Child> = (0..12).map(|k| run(runs[k % 4], &out)).collect();
        for writer in &mut writers {
            assert!(writer.wait().unwrap().success());
        }
        let written = set(&out);
        assert!(
            alone.contains(&written),
            "round {round}: files of several writers"
        );
        assert_eq!(hidden(&out), [""; 0].map(PathBuf::from));
    }
}

/// A killed process leaves what it was writing; the next one that writes there takes it away.
#[cfg(unix)]
#[test]
fn what_a_killed_process_left_goes_with_the_next_write() {
    const LONG: &[&str] = &["report-break", "--engine", "stepper", "--every", "1e-3"];
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    let mut left = 0;
    for _ in 0..100 {
        let mut writer = run(LONG, &out);
        // until it has begun to write; then it cannot end before it has the folder, which is ours
        let begun = loop {
            if hidden(&out).len() > left {
                break true;
            }
            if writer.try_wait().unwrap().is_some() {
                break false;
            }
            std::thread::yield_now();
        };
        let ours = fs::File::open(&out).unwrap();
        ours.lock().unwrap();
        writer.kill().unwrap();
        writer.wait().unwrap();
        left = hidden(&out).len();
        if begun && left > 0 {
            break;
        }
    }
    assert_eq!(left, 1, "no writer was met while it wrote");
    assert!(out.join(&hidden(&out)[0]).join("alive").exists());
    let mut next = run(&["head-on", "--engine", "exact"], &out);
    assert!(next.wait().unwrap().success());
    assert_eq!(hidden(&out), [""; 0].map(PathBuf::from));
    assert!(set(&out).iter().all(Option::is_some));
}
