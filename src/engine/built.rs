//! What an engine was built from: version and source of a crate, by the lock file of the build, held against the code itself.
//!
//! The build script reads `Cargo.lock`. That file can be another one than what was built: cargo's `paths` and an installation without
//! `--locked` leave it as it is, and a library has none of its own. So the engine's code says where its source lay when it was compiled, and where
//! the two disagree nothing is said at all: `unknown`, also for sources that were vendored or whose paths were remapped.

use std::fmt;

/// A crate of a lock file: name, version, source, and the indices of what it needs.
type Locked = (&'static str, &'static str, &'static str, &'static [usize]);

/// Every crate of the lock file of the build.
const LOCKED: &[Locked] = include!(concat!(env!("OUT_DIR"), "/locked.rs"));

/// What is told of a source that is not known.
const UNKNOWN: &str = "unknown";

/// A crate that an engine was built from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Built {
    /// Its name.
    pub name: &'static str,
    /// Its version, such as `0.36.1`; empty where it is not known.
    pub version: &'static str,
    /// `registry`, `git COMMIT`, `path DIGEST`, `path, content unknown`, `another registry` or `unknown`.
    pub source: &'static str,
    /// Crates that it needs, near or far, and that are not from the registry.
    pub with: Vec<Built>,
}

impl Built {
    /// The first word of the source.
    pub fn word(&self) -> &'static str {
        let mut words = self.source.split([' ', ',']);
        words.next().unwrap_or(UNKNOWN)
    }
}

impl fmt::Display for Built {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Built { name, version, .. } = self;
        if self.source == UNKNOWN {
            return write!(f, "{name} {UNKNOWN}");
        }
        write!(f, "{name} {version} ({})", self.source)?;
        for (index, other) in self.with.iter().enumerate() {
            let link = if index == 0 { " with" } else { " and" };
            write!(f, "{link} {other}")?;
        }
        Ok(())
    }
}

/// The crate called `name`, which the compiler found at `compiled`: the path of a source file, as the code itself tells it.
pub fn built(name: &'static str, compiled: &str) -> Built {
    of(own(), name, compiled)
}

/// The crates of the lock file that are called `name`; none for a library that others build.
pub fn locked(name: &str) -> Vec<Built> {
    let own = own().iter().filter(|(own, ..)| *own == name);
    own.map(alone).collect()
}

/// The lock file of the build. Cargo sets the variable for the package that it was asked to build and not for a dependency, which is built by the lock
/// file of others, whatever lies beside its manifest.
fn own() -> &'static [Locked] {
    match option_env!("CARGO_PRIMARY_PACKAGE") {
        Some(_) => LOCKED,
        None => &[],
    }
}

fn alone(&(name, version, source, _): &Locked) -> Built {
    Built {
        name,
        version,
        source,
        with: Vec::new(),
    }
}

fn of(all: &[Locked], name: &'static str, compiled: &str) -> Built {
    let fits = |&(own, version, source, _): &Locked| {
        own == name && is_from(compiled, name, version, source)
    };
    let mut found = (0..all.len()).filter(|&index| fits(&all[index]));
    match (found.next(), found.next()) {
        (Some(index), None) => Built {
            with: others(all, index),
            ..alone(&all[index])
        },
        _ => alone(&(name, "", UNKNOWN, &[])),
    }
}

/// Crates that one needs, near or far, and that are not from the registry.
fn others(all: &[Locked], first: usize) -> Vec<Built> {
    let mut reached = vec![first];
    let mut next = 0;
    while let Some((.., needs)) = reached.get(next).and_then(|&index| all.get(index)) {
        for &needed in *needs {
            if !reached.contains(&needed) {
                reached.push(needed);
            }
        }
        next += 1;
    }
    let others = reached.iter().skip(1).filter_map(|&index| all.get(index));
    others
        .filter(|(_, _, source, _)| *source != "registry")
        .map(alone)
        .collect()
}

/// Whether a source file at `compiled` can be one of a crate from this source: cargo unpacks what it fetches in places of its own.
fn is_from(compiled: &str, name: &str, version: &str, source: &str) -> bool {
    let parts: Vec<&str> = compiled.split(['/', '\\']).collect();
    let fetched = |kind: [&str; 2]| {
        let mut four = parts.windows(4);
        four.find(|four| four[..2] == kind).map(|four| four[3])
    };
    let (registry, git) = (fetched(["registry", "src"]), fetched(["git", "checkouts"]));
    match source.split_once(' ') {
        None if source == "registry" => registry == Some(&format!("{name}-{version}")),
        Some(("git", commit)) => git.is_some_and(|short| commit.starts_with(short)),
        Some(("path" | "path,", _)) => registry.is_none() && git.is_none(),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::{Built, Locked, is_from, of};

    #[test]
    fn the_code_says_whether_the_lock_file_is_that_of_the_build() {
        let registry = "/home/a/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/some-crate-1.2.3/src/a.rs";
        let windows = r"C:\Users\a\.cargo\registry\src\index.crates.io-1949cf8c6b5b557f\some-crate-1.2.3\src\a.rs";
        let git = "/home/a/.cargo/git/checkouts/fork-0123456789abcdef/89abcde/crates/some-crate/../../src/a.rs";
        let folder = "/home/a/fork/crates/some-crate/../../src/a.rs";
        for (source, from) in [
            ("registry", [true, true, false, false]),
            ("git 89abcdef01234567", [false, false, true, false]),
            ("git 0000000001234567", [false; 4]),
            ("path 0123456789abcdef", [false, false, false, true]),
            ("path, content unknown", [false, false, false, true]),
            ("another registry", [false; 4]),
            ("unknown", [false; 4]),
        ] {
            let found = [registry, windows, git, folder]
                .map(|compiled| is_from(compiled, "some-crate", "1.2.3", source));
            assert_eq!(found, from, "{source}");
        }
        for (name, version) in [("some-crate", "1.2.4"), ("some", "1.2.3")] {
            assert!(!is_from(registry, name, version, "registry"), "{name}");
        }
        // what was remapped tells nothing
        assert!(!is_from(
            "some-crate-1.2.3/src/a.rs",
            "some-crate",
            "1.2.3",
            "registry"
        ));
    }

    #[test]
    fn a_crate_names_its_source_and_what_it_needs_from_elsewhere() {
        let of = |name, source, with| Built {
            name,
            version: "1.2.3",
            source,
            with,
        };
        let shapes = of("shapes", "path 01", Vec::new());
        let other = of("numbers", "git 23", Vec::new());
        for (built, word, words) in [
            (
                of("a", "registry", Vec::new()),
                "registry",
                "a 1.2.3 (registry)",
            ),
            (
                of("a", "registry", vec![shapes, other]),
                "registry",
                "a 1.2.3 (registry) with shapes 1.2.3 (path 01) and numbers 1.2.3 (git 23)",
            ),
            (
                of("a", "path, content unknown", Vec::new()),
                "path",
                "a 1.2.3 (path, content unknown)",
            ),
            (
                of("a", "another registry", Vec::new()),
                "another",
                "a 1.2.3 (another registry)",
            ),
            (of("a", "unknown", Vec::new()), "unknown", "a unknown"),
        ] {
            assert_eq!(built.word(), word);
            assert_eq!(built.to_string(), words);
        }
    }

    #[test]
    fn what_the_lock_file_does_not_say_is_unknown() {
        let unpacked = "/a/registry/src/index-0/some-crate-1.2.3/src/a.rs";
        let folder = "/a/fork/src/a.rs";
        let locked: [Locked; 4] = [
            ("numbers", "0.1.0", "path 01", &[1]),
            // two that need each other, as tests do
            ("shapes", "2.0.0", "registry", &[0, 2]),
            ("some-crate", "1.2.3", "registry", &[1]),
            ("other", "1.0.0", "path 02", &[]),
        ];
        let known = "some-crate 1.2.3 (registry) with numbers 0.1.0 (path 01)";
        for (all, name, compiled, words) in [
            (&locked[..], "some-crate", unpacked, known),
            // cargo's `paths`, or an installation by another lock file
            (&locked, "some-crate", folder, "some-crate unknown"),
            (&locked, "other", folder, "other 1.0.0 (path 02)"),
            (&locked, "missing", folder, "missing unknown"),
            // a library that others build
            (&[], "some-crate", unpacked, "some-crate unknown"),
        ] {
            assert_eq!(of(all, name, compiled).to_string(), words, "{compiled}");
        }
        let twice: [Locked; 2] = [
            ("other", "1.0.0", "path 02", &[]),
            ("other", "2.0.0", "path 03", &[]),
        ];
        assert_eq!(of(&twice, "other", folder).to_string(), "other unknown");
    }
}
