//! What the engines were built from: the lock file of the build, and nothing that it does not say.

#[path = "../../src/cli/build/locked.rs"]
#[allow(dead_code, reason = "the build script calls the rest")]
mod locked;

use carom::engine::{self, Limits, Setting};
use carom::scene::catalogue;
use carom::trace::Record;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

#[test]
fn version_and_source_are_those_of_the_lock_file() {
    let packages = locked::packages(include_str!("../../Cargo.lock"));
    let scene = catalogue::scene("slide").unwrap();
    let mut crates = 0;
    for engine in crate::support::roster() {
        for built in engine.built() {
            let mut own = packages.iter().filter(|package| package.name == built.name);
            let (package, others) = (own.next().unwrap(), own.count());
            assert_eq!(others, 0, "{}", built.name);
            assert_eq!(built.version, package.version, "{}", built.name);
            let word = match package.source.split_once('+') {
                Some((word, _)) => word,
                None => "path",
            };
            assert_eq!(built.word(), word, "{}", built.name);
            let words = format!("{} {} ({})", built.name, package.version, built.source);
            assert!(engine.version().starts_with(&words), "{}", engine.version());
            let run = engine::prepare(engine.as_ref(), &scene, &Setting::default()).unwrap();
            let trace = run.simulate(Record::Final, &Limits::NONE);
            assert_eq!(
                trace.provenance.version,
                engine.version(),
                "run.json says another one"
            );
            crates += 1;
        }
    }
    assert_eq!(crates, 2, "crates that engines are built from");
}

#[test]
fn each_source_has_its_word_and_nothing_else_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    let crates_io = "registry+https://github.com/rust-lang/crates.io-index";
    let lock = format!(
        "version = 4\n\n[[package]]\nname = \"own\"\nversion = \"0.1.0\"\ndependencies = [\n \"a\",\n \"b 1.0.0\",\n]\n\n\
         [[package]]\nname = \"a\"\nversion = \"1.2.3\"\nsource = \"{crates_io}\"\nchecksum = \"00\"\ndependencies = [\n \"b 2.0.0\",\n]\n\n\
         [[package]]\nname = \"b\"\nversion = \"1.0.0\"\nsource = \"git+https://where.example/b?rev=1#89abcdef0123456789abcdef\"\n\n\
         [[package]]\nname = \"b\"\nversion = \"2.0.0\"\nsource = \"sparse+https://where.example/index/\"\n\n\
         [[package]]\nname = \"c\"\nversion = \"3.0.0\"\n\n\
         [[package]]\nname = \"d\"\nversion = \"4.0.0\"\nsource = \"{crates_io}\"\nreplace = \"d 4.0.0\"\n\n\
         [[patch.unused]]\nname = \"a\"\nversion = \"9.9.9\"\n"
    );
    fs::write(root.join("Cargo.lock"), lock).unwrap();
    let built = locked::built(root, "own", &[]);
    let told: Vec<String> = built
        .packages
        .iter()
        .map(|p| format!("{} {} {}", p.name, p.version, p.source))
        .collect();
    let expected = [
        "a 1.2.3 registry",
        "b 1.0.0 git 89abcdef01234567",
        "b 2.0.0 another registry",
        "c 3.0.0 path, content unknown",
        "d 4.0.0 unknown",
    ];
    assert_eq!(told, expected);
    assert!(built.from.contains(&root.join("Cargo.lock")));
    let rust = locked::rust(&built.packages);
    assert!(
        rust.contains("(\"a\", \"1.2.3\", \"registry\", &[2]),"),
        "{rust}"
    );
    assert!(!rust.contains("example") && !rust.contains("://"), "{rust}");
    fs::remove_file(root.join("Cargo.lock")).unwrap();
    assert!(locked::built(root, "own", &[]).packages.is_empty());
}

/// A package that asks for a crate of the registry, and a folder that is patched in for it; gives the root and the folder.
fn patched(home: &Path, manifest: &str, configuration: &str) -> (PathBuf, PathBuf) {
    let (root, fork) = (home.join("own"), home.join("a fork/made-up"));
    for folder in [&root, &fork] {
        fs::create_dir_all(folder.join("src")).unwrap();
        fs::write(folder.join("src/lib.rs"), "").unwrap();
    }
    let package = |name: &str, rest: &str| {
        format!("[package]\nname = \"{name}\"\nversion = \"1.2.3\"\nedition = \"2024\"\n{rest}")
    };
    fs::write(fork.join("Cargo.toml"), package("made-up", "[workspace]\n")).unwrap();
    let needs = format!("[dependencies]\nmade-up = \"=1.2.3\"\n[workspace]\n{manifest}");
    fs::write(root.join("Cargo.toml"), package("own", &needs)).unwrap();
    if !configuration.is_empty() {
        fs::create_dir_all(root.join(".cargo")).unwrap();
        fs::write(root.join(".cargo/config.toml"), configuration).unwrap();
    }
    (root, fork)
}

#[test]
fn the_folder_of_a_patch_is_found_in_each_way_to_say_it() {
    let patch = "[patch.crates-io]\nmade-up = { path = \"../a fork/made-up\" }\n";
    let configured = "[patch.crates-io]\nmade-up.path = \"../a fork/made-up\"\n";
    for (manifest, configuration, on_command_line, known) in [
        (patch, "", false, true),
        ("", configured, false, true),
        ("", "", true, true),
        // what cargo alone was told cannot be known
        ("", "", false, false),
    ] {
        let home = tempfile::tempdir().unwrap();
        let home = home.path().canonicalize().unwrap();
        let (root, fork) = patched(&home, manifest, configuration);
        let shown = fork.display().to_string();
        let mut cargo = Command::new(env!("CARGO"));
        cargo
            .args(["generate-lockfile", "--offline"])
            .current_dir(&root);
        if manifest.is_empty() && configuration.is_empty() {
            cargo.args([
                "--config",
                &format!("patch.crates-io.made-up.path='{shown}'"),
            ]);
        }
        let locked = cargo.output().unwrap();
        assert!(
            locked.status.success(),
            "{}",
            String::from_utf8_lossy(&locked.stderr)
        );
        let patches = if on_command_line {
            vec![("made-up".to_owned(), shown.clone())]
        } else {
            Vec::new()
        };
        let found = || {
            let built = locked::built(&root, "own", &patches);
            assert_eq!(built.packages.len(), 1, "{:?}", built.packages);
            let watched = built.from.contains(&fork.join("src/lib.rs"));
            assert_eq!(watched, known, "{:?}", built.from);
            built.packages[0].source.clone()
        };
        let first = found();
        if known {
            let digest = first.strip_prefix("path ").unwrap();
            assert!(
                digest.len() == 16 && digest.chars().all(|c| c.is_ascii_hexdigit()),
                "{first}"
            );
            assert_eq!(found(), first);
            fs::write(fork.join("src/lib.rs"), "// other").unwrap();
            assert_ne!(found(), first);
        } else {
            assert_eq!(first, "path, content unknown");
        }
    }
}

#[test]
fn a_digest_is_of_names_and_contents_and_of_sources_that_lie_elsewhere() {
    let home = tempfile::tempdir().unwrap();
    let folder = home.path().join("crates/one");
    fs::create_dir_all(&folder).unwrap();
    fs::create_dir_all(home.path().join("src/inner")).unwrap();
    let write = |name: &str, text: &str| fs::write(home.path().join(name), text).unwrap();
    write(
        "crates/one/Cargo.toml",
        "[lib]\nname = \"one\"\npath = \"../../src/lib.rs\" # shared\n",
    );
    write("src/lib.rs", "mod inner;");
    write("src/inner/mod.rs", "");
    let digest = || locked::digest(&locked::files(&folder)).unwrap();
    let first = digest();
    assert_eq!(locked::files(&folder).len(), 3);
    write("src/inner/mod.rs", "// changed");
    let second = digest();
    assert_ne!(second, first);
    fs::rename(
        home.path().join("src/inner/mod.rs"),
        home.path().join("src/inner.rs"),
    )
    .unwrap();
    let third = digest();
    assert_ne!(third, second);
    // neither what cargo makes nor what is hidden
    fs::create_dir_all(folder.join("target/debug")).unwrap();
    write("crates/one/target/CACHEDIR.TAG", "");
    write("crates/one/target/debug/one", "");
    write("crates/one/.cargo-ok", "");
    assert_eq!(digest(), third);
    #[cfg(unix)]
    {
        // a link to sources counts as what it leads to, and one to a folder around it has an end
        std::os::unix::fs::symlink("../../src", folder.join("linked")).unwrap();
        let linked = digest();
        assert_ne!(linked, third);
        write("src/lib.rs", "");
        assert_ne!(digest(), linked);
        std::os::unix::fs::symlink("..", folder.join("around")).unwrap();
        assert!(!locked::files(&folder).is_empty());
    }
    assert_eq!(locked::digest(&[]), None);
    let missing = ("a".to_owned(), home.path().join("missing"));
    assert_eq!(locked::digest(&[missing]), None);
}
