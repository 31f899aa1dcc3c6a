//! Which crates the program is built from, by the lock file of the build: version and source of each.
//!
//! A source is one of the words `registry`, `git` and `path`, with the commit of a git repository and a digest of what is in a folder. No address
//! and no folder is told. Cargo tells a build script neither, so where a folder lies is asked of cargo: it knows what `Cargo.toml` and
//! its configuration say of patches, but not what stood on the command line of the build. That is what [`PATCH`] is for; without it such a folder's
//! content is `unknown`.

use sha2::{Digest, Sha256};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Environment variable with the patches of the command line, one `NAME=FOLDER` a line. `.ci/fork` sets it.
pub const PATCH: &str = "CAROM_PATCH";

/// What the lock file calls the registry of crates.io, whatever protocol and mirror it is read by.
const REGISTRY: &str = "registry+https://github.com/rust-lang/crates.io-index";

/// Characters of a commit and of a digest that are told.
const SHOWN: usize = 16;

/// A crate in a lock file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Package {
    /// Its name.
    pub name: String,
    /// Its version.
    pub version: String,
    /// As the lock file has it, empty for a folder; [`built`] makes it what is told.
    pub source: String,
    /// What it needs: `NAME`, `NAME VERSION` or `NAME VERSION (SOURCE)`.
    pub needs: Vec<String>,
}

/// What a program is built from.
#[derive(Debug, Default)]
pub struct Built {
    /// Every crate of the lock file but the program itself; none where there is no lock file.
    pub packages: Vec<Package>,
    /// The files that this was read from.
    pub from: Vec<PathBuf>,
}

/// What the package `own` in the folder `root` is built from. `patches`: name and folder of what the command line patches.
pub fn built(root: &Path, own: &str, patches: &[(String, String)]) -> Built {
    let workspace = workspace(root).unwrap_or_else(|| root.to_owned());
    let lock = workspace.join("Cargo.lock");
    let Ok(text) = fs::read_to_string(&lock) else {
        return Built::default();
    };
    let mut from = vec![lock, root.join("Cargo.toml"), workspace.join("Cargo.toml")];
    let homes = workspace.ancestors().map(|folder| folder.join(".cargo"));
    let homes = homes.chain(std::env::var_os("CARGO_HOME").map(PathBuf::from));
    from.extend(homes.flat_map(|home| [home.join("config.toml"), home.join("config")]));
    let mut packages = packages(&text);
    packages.retain(|package| package.name != own || !package.source.is_empty());
    for package in &mut packages {
        package.source = match package.source.as_str() {
            "" => {
                let files = folder_of(root, package, patches).map_or(Vec::new(), |f| files(&f));
                from.extend(files.iter().map(|(_, file)| file.clone()));
                match digest(&files) {
                    Some(digest) => format!("path {digest}"),
                    None => "path, content unknown".to_owned(),
                }
            }
            REGISTRY => "registry".to_owned(),
            other => match other.strip_prefix("git+").and_then(|s| s.split_once('#')) {
                Some((_, commit)) => format!("git {}", shortened(commit)),
                None if other.contains("registry+") || other.contains("sparse+") => {
                    "another registry".to_owned()
                }
                None => "unknown".to_owned(),
            },
        };
    }
    Built { packages, from }
}

/// The crates of a lock file, in its order. Cargo writes it, one key a line.
pub fn packages(lock: &str) -> Vec<Package> {
    let mut packages: Vec<Package> = Vec::new();
    // a patch that was not used stands below in a table of its own
    let mut within = false;
    for line in lock.lines() {
        if line.starts_with('[') {
            within = line == "[[package]]";
            if within {
                packages.push(Package::default());
            }
            continue;
        }
        let Some(package) = packages.last_mut().filter(|_| within) else {
            continue;
        };
        let text = |value: &str| value.trim_matches('"').to_owned();
        match line.split_once(" = ") {
            Some(("name", value)) => package.name = text(value),
            Some(("version", value)) => package.version = text(value),
            Some(("source", value)) => package.source = text(value),
            // `[replace]` names another crate that is built in its place
            Some(("replace", _)) => package.source = "replaced".to_owned(),
            _ => {
                let needed = line.strip_prefix(" \"").and_then(|l| l.strip_suffix("\","));
                package.needs.extend(needed.map(str::to_owned));
            }
        }
    }
    packages
}

/// The packages as the value of a constant: name, version, source, and the indices of what each needs.
pub fn rust(packages: &[Package]) -> String {
    let index = |need: &String| {
        let mut words = need.split(' ');
        let (name, version) = (words.next(), words.next());
        packages.iter().position(|p| {
            Some(p.name.as_str()) == name && version.is_none_or(|version| p.version == version)
        })
    };
    let line = |package: &Package| {
        let needs: Vec<usize> = package.needs.iter().filter_map(index).collect();
        let Package {
            name,
            version,
            source,
            ..
        } = package;
        format!("    ({name:?}, {version:?}, {source:?}, &{needs:?}),\n")
    };
    let lines: String = packages.iter().map(line).collect();
    format!("&[\n{lines}]\n")
}

fn shortened(text: &str) -> String {
    text.chars().take(SHOWN).collect()
}

fn cargo(root: &Path) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(root);
    command
}

fn said(command: &mut Command) -> Option<String> {
    let said = command.output().ok().filter(|said| said.status.success())?;
    Some(String::from_utf8(said.stdout).ok()?.trim().to_owned())
}

/// The folder of the lock file.
fn workspace(root: &Path) -> Option<PathBuf> {
    let manifest =
        said(cargo(root).args(["locate-project", "--workspace", "--message-format=plain"]))?;
    Path::new(&manifest).parent().map(Path::to_owned)
}

/// The folder of a crate that the lock file gives no source. `None` where cargo, with what it is told, would build another lock file than it did.
fn folder_of(root: &Path, package: &Package, patches: &[(String, String)]) -> Option<PathBuf> {
    let mut command = cargo(root);
    command.args(["pkgid", "--locked", "--offline"]);
    for (name, folder) in patches {
        let patch = format!("patch.crates-io.{name}.path={}", literal(folder));
        command.args(["--config", &patch]);
    }
    command.arg(format!("{}@{}", package.name, package.version));
    let id = said(&mut command)?;
    let (url, _) = id.strip_prefix("path+file://")?.split_once('#')?;
    let folder = decoded(url)?;
    // on Windows an address has a slash before the letter of the drive
    let folder = match folder.as_bytes() {
        [b'/', _, b':', ..] => &folder[1..],
        _ => &folder,
    };
    let folder = PathBuf::from(folder);
    folder.join("Cargo.toml").is_file().then_some(folder)
}

/// A string as TOML has it.
fn literal(text: &str) -> String {
    let escaped = text.replace('\\', "\\\\").replace('"', "\\\"");
    format!("\"{escaped}\"")
}

/// The path of an address, with `%20` and the like as what they stand for.
fn decoded(url: &str) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = url.as_bytes();
    while let [first, after @ ..] = rest {
        rest = after;
        if *first == b'%' {
            let [a, b, after @ ..] = rest else {
                return None;
            };
            let digits = [*a, *b];
            let hex = std::str::from_utf8(&digits).ok()?;
            bytes.push(u8::from_str_radix(hex, 16).ok()?);
            rest = after;
        } else {
            bytes.push(*first);
        }
    }
    String::from_utf8(bytes).ok()
}

/// What a crate is made of, by name: what is in its folder, and in the folder of its library where that lies elsewhere. Neither hidden files nor
/// what cargo made.
pub fn files(folder: &Path) -> Vec<(String, PathBuf)> {
    let mut found = Vec::new();
    walk(folder, "", &mut found);
    let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_default();
    // a path within the folder was walked already
    if let Some(library) = library(&manifest).filter(|path| path.contains("..")) {
        let elsewhere = folder.join(library);
        walk(elsewhere.parent().unwrap_or(folder), "library/", &mut found);
    }
    found.sort();
    found
}

/// The path that `[lib]` of a manifest names.
fn library(manifest: &str) -> Option<&str> {
    let mut lines = manifest.lines().map(str::trim);
    lines.find(|line| *line == "[lib]")?;
    let own = lines.take_while(|line| !line.starts_with('['));
    let mut pairs = own.filter_map(|line| line.split_once('='));
    let (_, value) = pairs.find(|(key, _)| key.trim() == "path")?;
    value.split(['"', '\'']).nth(1)
}

fn walk(folder: &Path, name: &str, found: &mut Vec<(String, PathBuf)>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let own = entry.file_name().to_string_lossy().into_owned();
        let (name, path) = (format!("{name}{own}"), entry.path());
        // cargo marks the folder that it builds in
        if own.starts_with('.') || path.join("CACHEDIR.TAG").exists() {
            continue;
        }
        // a link to a folder that it lies in has no end
        let ends = || {
            let both = path.canonicalize().ok().zip(folder.canonicalize().ok());
            both.is_some_and(|(own, folder)| !folder.starts_with(own))
        };
        if path.is_dir() {
            if ends() {
                walk(&path, &format!("{name}/"), found);
            }
        } else {
            found.push((name, path));
        }
    }
}

/// A digest of names and contents. `None` for no files, or one that cannot be read.
pub fn digest(files: &[(String, PathBuf)]) -> Option<String> {
    let mut all = Sha256::new();
    for (name, file) in files {
        let content = fs::read(file).ok()?;
        all.update((name.len() as u64).to_le_bytes());
        all.update(name);
        all.update((content.len() as u64).to_le_bytes());
        all.update(content);
    }
    let digest = all.finalize();
    let hex: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
    (!files.is_empty()).then(|| shortened(&hex))
}
