//! Build script: tells the program which compiler made it and which crates it was built from, and puts the files into it that travel with it.

// what a build script prints is for cargo
#![allow(clippy::print_stdout)]

mod carried;
mod locked;

use std::path::Path;
use std::process::Command;
use std::{env, fs};

fn main() -> Result<(), String> {
    let of = |name: &str| env::var(name).map_err(|_| format!("cargo sets no {name}"));
    let (root, out) = (of("CARGO_MANIFEST_DIR")?, of("OUT_DIR")?);
    let (root, out) = (Path::new(&root), Path::new(&out));
    println!("cargo::rerun-if-changed=src/cli/build");
    compiler();

    let carried = carried::files(&root.join("validation"))?;
    write(out, "carried.rs", &carried::rust(&carried))?;
    for folder in carried::FOLDERS {
        rerun(&root.join("validation").join(folder));
    }

    println!("cargo::rerun-if-env-changed={}", locked::PATCH);
    let built = locked::built(root, &of("CARGO_PKG_NAME")?, &patches());
    write(out, "locked.rs", &locked::rust(&built.packages))?;
    built.from.iter().for_each(|path| rerun(path));
    Ok(())
}

/// What `CAROM_PATCH` says: `NAME=FOLDER`, one a line.
fn patches() -> Vec<(String, String)> {
    let said = env::var(locked::PATCH).unwrap_or_default();
    let pairs = said.lines().filter_map(|line| line.split_once('='));
    pairs
        .map(|(name, folder)| (name.to_owned(), folder.to_owned()))
        .collect()
}

/// A file that is not there would make cargo run this again each time.
fn rerun(path: &Path) {
    if path.exists() {
        println!("cargo::rerun-if-changed={}", path.display());
    }
}

fn write(out: &Path, name: &str, text: &str) -> Result<(), String> {
    let file = out.join(name);
    fs::write(&file, text).map_err(|error| format!("cannot write {}: {error}", file.display()))
}

fn compiler() {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let said = Command::new(rustc).arg("--version").output();
    let version = said.map_or(String::new(), |said| {
        String::from_utf8_lossy(&said.stdout).trim().to_owned()
    });
    println!("cargo::rustc-env=CAROM_COMPILER={version}");
}
