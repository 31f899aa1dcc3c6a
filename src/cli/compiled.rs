//! Build script: tells the program which compiler made it, for the baselines that it writes.

// what a build script prints is for cargo
#![allow(clippy::print_stdout)]

use std::process::Command;

fn main() {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let said = Command::new(rustc).arg("--version").output();
    let version = said.map_or(String::new(), |said| {
        String::from_utf8_lossy(&said.stdout).trim().to_owned()
    });
    println!("cargo::rustc-env=CAROM_COMPILER={version}");
    println!("cargo::rerun-if-changed=src/cli/compiled.rs");
}
