//! The files that travel with the program: all that are in `validation/`, and all in a package.

#[path = "../../src/cli/build/carried.rs"]
mod files;

use carom::carried::{below, text};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

#[test]
fn what_travels_is_what_is_in_the_folders() {
    let validation = Path::new(env!("CARGO_MANIFEST_DIR")).join("validation");
    for (folder, least) in [("baselines", 20), ("hard", 80), ("scenes", 100)] {
        let mut found = BTreeSet::new();
        for entry in fs::read_dir(validation.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            let own = text(&format!("{folder}/{name}"));
            let is = fs::read_to_string(&path).unwrap();
            assert_eq!(
                own,
                Some(is.as_str()),
                "{folder}/{name} is another one in the program"
            );
            found.insert(name);
        }
        assert!(found.len() >= least, "{folder}: {}", found.len());
        let carried: BTreeSet<String> = below(folder).map(|(name, _)| name.to_owned()).collect();
        assert_eq!(carried, found, "{folder}");
    }
}

#[test]
fn a_package_has_all_that_travels_and_all_that_builds_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let listed = Command::new(env!("CARGO"))
        .args(["package", "--list", "--allow-dirty", "--offline"])
        .current_dir(root)
        .output()
        .unwrap();
    assert!(
        listed.status.success(),
        "{}",
        String::from_utf8_lossy(&listed.stderr)
    );
    let listed = String::from_utf8(listed.stdout).unwrap().replace('\\', "/");
    let listed: BTreeSet<&str> = listed.lines().collect();
    let files = files::files(&root.join("validation")).unwrap();
    assert!(files.len() > 200, "{}", files.len());
    for file in &files {
        let name = format!("validation/{}", file.name);
        assert!(listed.contains(name.as_str()), "{name} is in no package");
    }
    for name in [
        "Cargo.lock",
        "src/cli/build/main.rs",
        "src/cli/build/carried.rs",
        "src/cli/build/locked.rs",
    ] {
        assert!(listed.contains(name), "{name} is in no package");
    }
}

#[test]
fn folders_below_travel_as_well_and_what_a_package_leaves_out_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let validation = folder.path();
    let names = || {
        let files = files::files(validation)?;
        Ok::<_, String>(files.into_iter().map(|file| file.name).collect::<Vec<_>>())
    };
    assert_eq!(names().unwrap(), [""; 0]);
    let own = validation.join("engines/some");
    fs::create_dir_all(own.join("src")).unwrap();
    fs::create_dir_all(validation.join("scenes")).unwrap();
    fs::create_dir_all(validation.join("references")).unwrap();
    for name in [
        "engines/some/src/main.rs",
        "engines/some/Cargo.toml.in",
        "scenes/b.toml",
        "scenes/.a.toml.part",
        "references/big.csv",
    ] {
        fs::write(validation.join(name), "").unwrap();
    }
    let expected = [
        "engines/some/Cargo.toml.in",
        "engines/some/src/main.rs",
        "scenes/b.toml",
    ];
    assert_eq!(names().unwrap(), expected);
    let rust = files::rust(&files::files(validation).unwrap());
    assert_eq!(rust.matches("include_str!").count(), 3, "{rust}");
    fs::write(own.join("Cargo.toml"), "").unwrap();
    let error = names().unwrap_err();
    assert!(
        error.contains("engines/some/Cargo.toml") && error.contains("package"),
        "{error}"
    );
}
