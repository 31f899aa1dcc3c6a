//! The program, stopped by a signal at ten moments of each of its long commands: exit code, first line, files.
//!
//! What is run would take far longer than the last of the moments, so that nearly every signal meets it at work; Ctrl-C and SIGTERM take
//! turns. Some are met before they have begun their study: on a machine that is busy with other things later moments are added until one
//! meets the study itself. A system without signals has nothing to show here, and says so.
#![cfg_attr(not(unix), allow(dead_code, unused_imports))]

use super::STOPPED;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

/// Moments of a command.
const MOMENTS: u32 = 10;

/// The first moment but zero, from when the program listens; the others follow as squares do.
const FIRST: Duration = Duration::from_millis(8);

/// No moment is later.
const LAST: Duration = Duration::from_secs(60);

/// Of ten signals at least so many must meet a command at work, or nothing is shown.
const MET: usize = 8;

fn spawn(arguments: &str, out: &Path) -> Child {
    let out = out.to_str().unwrap();
    let words = arguments.split_whitespace();
    Command::new(assert_cmd::cargo::cargo_bin("carom"))
        .args(words.map(|word| word.replace("OUT", out)))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Waits until signals reach the program itself: before that the system ends it.
fn until_it_listens(child: &mut Child) {
    if !cfg!(target_os = "linux") {
        return std::thread::sleep(Duration::from_millis(500));
    }
    // SIGHUP is signal 1 and the first bit, SIGINT 2, SIGTERM 15
    const ALL: u64 = 1 | 1 << 1 | 1 << 14;
    let file = format!("/proc/{}/status", child.id());
    while child.try_wait().unwrap().is_none() {
        let status = fs::read_to_string(&file).unwrap_or_default();
        let mask = status
            .lines()
            .find_map(|line| line.strip_prefix("SigCgt:"))
            .and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
        if mask.is_some_and(|mask| mask & ALL == ALL) {
            return;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Sends a signal by its name. One that comes too late finds nobody.
fn send(signal: &str, child: &Child) {
    Command::new("sh")
        .arg("-c")
        .arg(format!("kill -{signal} {} 2>/dev/null", child.id()))
        .status()
        .unwrap();
}

/// What a command printed, and the files that it left.
struct Left {
    case: String,
    out: String,
    err: String,
    code: Option<i32>,
    files: Vec<PathBuf>,
}

impl Left {
    fn of(case: String, output: Output, folder: &Path) -> Self {
        Left {
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
            code: output.status.code(),
            files: below(folder),
            case,
        }
    }

    fn show(&self) -> String {
        let Left { case, out, err, .. } = self;
        format!("{case}\n{out}\n{err}")
    }

    /// Every file can be read to its end by what reads such files, and says what the program says.
    fn files_are_whole(&self, stopped: bool) {
        for file in &self.files {
            let case = format!("{}: {}", file.display(), self.case);
            let text = fs::read_to_string(file).unwrap();
            match file
                .extension()
                .and_then(|e| e.to_str())
                .unwrap_or_default()
            {
                "html" => {
                    assert!(text.ends_with("</html>\n"), "{case}");
                    assert_eq!(text.contains(STOPPED), stopped, "{case}");
                }
                "md" => assert_eq!(
                    text.lines().next().unwrap().contains(STOPPED),
                    stopped,
                    "{case}"
                ),
                // the prices of a study are those of all that it ran
                "json" if file.ends_with("prices.json") => assert!(!stopped, "{case}"),
                "json" => {
                    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
                    assert_eq!(!json["stopped_early"].is_null(), stopped, "{case}");
                }
                "svg" => {
                    roxmltree::Document::parse(&text).unwrap();
                }
                "csv" | "toml" => {
                    assert!(text.ends_with('\n'), "{case}");
                    let mut rows = csv::Reader::from_reader(text.as_bytes());
                    if file.extension().is_some_and(|e| e == "csv") {
                        assert!(rows.records().all(|row| row.is_ok()), "{case}");
                    }
                }
                other => panic!("a file that nobody asked for, `{other}`: {case}"),
            }
        }
    }

    /// It says first that it was stopped early, in the format that was asked for.
    fn says_so(&self) {
        let first = |text: &str| text.lines().next().unwrap_or_default().contains(STOPPED);
        if self.out.is_empty() || self.case.contains("--format csv") {
            assert!(first(&self.err), "{}", self.show());
        } else if self.case.contains("--format json") {
            let json: serde_json::Value = serde_json::from_str(&self.out).unwrap();
            let words = json["stopped_early"].as_str();
            assert!(
                words.is_some_and(|words| words.contains(STOPPED)),
                "{}",
                self.show()
            );
        } else {
            assert!(first(&self.out), "{}", self.show());
        }
    }
}

fn below(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => found.extend(below(&path)),
            false => found.push(path),
        }
    }
    found.sort();
    found
}

/// Sends a signal to a command after some time; what is then left of it. Its words may name `OUT`, the folder of its files.
#[cfg(unix)]
fn stopped_at(arguments: &str, delay: Duration, signal: &str) -> Left {
    let folder = tempfile::tempdir().unwrap();
    let mut child = spawn(arguments, folder.path());
    until_it_listens(&mut child);
    std::thread::sleep(delay);
    send(signal, &child);
    let output = child.wait_with_output().unwrap();
    let case = format!("carom {arguments}, {signal} after {delay:?}");
    let left = Left::of(case, output, folder.path());
    let stopped = left.code == Some(130);
    if stopped {
        left.says_so();
    } else {
        let finished = matches!(left.code, Some(0 | 1));
        assert!(finished, "{:?}, {}", left.code, left.show());
        let silent = !left.out.contains(STOPPED) && !left.err.contains(STOPPED);
        assert!(silent, "{}", left.show());
    }
    left.files_are_whole(stopped);
    left
}

/// Stops a command at each moment. `studies`: whether it has a study that a signal can meet.
#[cfg(unix)]
fn interrupted(arguments: &str, studies: bool) {
    let (mut met, mut in_study) = (0, 0);
    let mut count = |left: &Left| {
        met += usize::from(left.code == Some(130));
        // what was stopped before it had begun prints no result
        in_study += usize::from(left.code == Some(130) && !left.out.is_empty());
        (met, in_study)
    };
    let mut counted = (0, 0);
    for moment in 0..MOMENTS {
        let signal = ["INT", "TERM"][moment as usize % 2];
        let delay = FIRST * moment * moment;
        counted = count(&stopped_at(arguments, delay, signal));
    }
    let at_work = counted.0;
    assert!(
        at_work >= MET,
        "{at_work} of {MOMENTS} signals met `carom {arguments}` at work"
    );
    let mut delay = FIRST * MOMENTS * MOMENTS;
    while studies && counted.1 == 0 && delay < LAST {
        counted = count(&stopped_at(arguments, delay, "INT"));
        delay *= 2;
    }
    assert!(
        !studies || counted.1 > 0,
        "no signal met `carom {arguments}` in its study"
    );
}

#[cfg(not(unix))]
fn interrupted(arguments: &str, _: bool) {
    // visible with --nocapture, and in no other way a pass of anything
    eprintln!("skipped: there are no signals here to stop `carom {arguments}` by");
}

#[test]
fn a_run_is_stopped() {
    interrupted(
        "run report-break --engine rapier-f64 --set dt=1e-6 --out OUT",
        true,
    );
}

#[test]
fn a_comparison_is_stopped() {
    interrupted(
        "compare report-break --engines rapier-f64:dt=1e-6 --format json",
        true,
    );
}

#[test]
fn a_report_is_stopped() {
    interrupted(
        "report head-on report-break --engines exact,rapier-f64:dt=1e-5 --out OUT",
        true,
    );
}

#[test]
fn a_study_of_cost_is_stopped() {
    interrupted("cost report-break --grid full --out OUT", true);
}

#[test]
fn an_ensemble_is_stopped() {
    interrupted(
        "ensemble report-break --samples 20000 --format markdown --out OUT",
        true,
    );
}

#[test]
fn a_horizon_is_stopped() {
    interrupted(
        "horizon bounces-100000 --precision dd --format json --out OUT",
        true,
    );
}

#[test]
fn an_ablation_is_stopped() {
    interrupted(
        "effects draw --engines exact,stepper:dt=1e-8 --out OUT",
        true,
    );
}

#[test]
fn curves_are_stopped() {
    interrupted(
        "effects --curves --engines exact,rapier-f64:dt=1e-7 --out OUT",
        true,
    );
}

#[test]
fn random_scenes_are_stopped() {
    interrupted("fuzz --scenes 200000 --save OUT", true);
}

#[test]
fn mutated_inputs_are_stopped() {
    interrupted("fuzz --inputs 2000000 --format csv --save OUT", true);
}

#[test]
fn hard_cases_are_stopped() {
    interrupted("stability --full --out OUT", true);
}

#[test]
fn a_check_is_stopped() {
    interrupted("check --out OUT", true);
}

#[test]
fn a_command_that_looks_at_nothing_ends_at_once() {
    interrupted("scene generate --balls 10000000 --density 0.3", false);
}

/// The second signal ends the program wherever it is.
#[cfg(unix)]
#[test]
fn a_second_signal_ends_the_program_and_leaves_no_half_of_a_file() {
    for moment in 0..MOMENTS {
        let folder = tempfile::tempdir().unwrap();
        let arguments = "report --out OUT";
        let mut child = spawn(arguments, folder.path());
        until_it_listens(&mut child);
        std::thread::sleep(FIRST * moment * moment);
        send("INT", &child);
        std::thread::sleep(FIRST);
        send("TERM", &child);
        let output = child.wait_with_output().unwrap();
        let left = Left::of(format!("{arguments}, twice"), output, folder.path());
        assert_eq!(left.code, Some(130), "{}", left.show());
        left.files_are_whole(true);
    }
}

/// What a stopped run left is kept, and compared with nothing.
#[cfg(unix)]
#[test]
fn a_stopped_run_is_no_run_to_compare() {
    let arguments = "run report-break --engine rapier-f64 --set dt=1e-6 --out OUT";
    let mut delay = FIRST * MOMENTS;
    // until one meets the run itself
    let folder = loop {
        let folder = tempfile::tempdir().unwrap();
        let mut child = spawn(arguments, folder.path());
        until_it_listens(&mut child);
        std::thread::sleep(delay);
        send("TERM", &child);
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130));
        if !output.stdout.is_empty() {
            break folder;
        }
        assert!(delay < LAST);
        delay *= 2;
    };
    let names: Vec<String> = below(folder.path())
        .iter()
        .map(|path| path.file_name().unwrap().to_str().unwrap().to_owned())
        .collect();
    assert_eq!(
        names,
        ["events.csv", "final.csv", "run.json", "samples.csv"]
    );
    let diff = spawn("diff OUT OUT", folder.path());
    let output = diff.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.lines().next().unwrap().contains(STOPPED), "{said}");
    assert!(output.stdout.is_empty());
}

/// `nohup` begins a program with SIGHUP ignored, and means it.
#[cfg(target_os = "linux")]
#[test]
#[allow(clippy::print_stderr)]
fn a_hangup_stops_a_program_unless_it_was_told_to_ignore_it() {
    let program = assert_cmd::cargo::cargo_bin("carom");
    // what these tests were begun with goes on to the program, and no shell can take it back
    let own = fs::read_to_string("/proc/self/status").unwrap();
    let ignored = own.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = u64::from_str_radix(ignored.unwrap().trim(), 16).unwrap() & 1 == 1;
    if ignored {
        eprintln!("SKIPPED: these tests run under nohup: a hangup stops nothing that they begin");
    }
    let told = [("true", true), ("trap '' HUP", false)];
    for (trap, stops) in told.into_iter().skip(usize::from(ignored)) {
        let script = format!("{trap}; exec {} fuzz --scenes 200000", program.display());
        let mut child = Command::new("sh")
            .args(["-c", &script])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        until_it_listens(&mut child);
        send("HUP", &child);
        if !stops {
            // it was sent, and nobody gets it
            let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
            let pending = status.lines().find_map(|line| line.strip_prefix("ShdPnd:"));
            let pending = u64::from_str_radix(pending.unwrap().trim(), 16).unwrap();
            assert_eq!(pending & 1, 1, "{status}");
            assert!(child.try_wait().unwrap().is_none());
            send("TERM", &child);
        }
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130), "{trap}");
    }
}
