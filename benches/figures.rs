//! Writes the tables of `docs/benchmarks.md`: what `onshell` finds in `derivations`, how fast, and the accelerations of
//! the heavy top.
//!
//! `cargo bench --bench figures` takes some minutes, most of them for the suggestions. The tests compare the counts on
//! the page with the program; times stand on the page beside a description of the machine.

#[path = "../tests/pages/counts.rs"]
mod counts;

use std::fmt::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

/// Each time is the best of this many runs.
const RUNS: usize = 5;

/// The program, built with the same profile.
const ONSHELL: &str = env!("CARGO_BIN_EXE_onshell");

fn main() {
    // `cargo test --benches` starts this file too; only `cargo bench` is meant to write.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/benchmarks.md");
    let mut page = std::fs::read_to_string(&path).expect("the page can be read");
    let report = |words: &[&str]| json(&[words, &["--format", "json"]].concat());
    for (heading, table) in [
        ("Verdicts", counts::verdicts(&report(&["check", "derivations"]))),
        ("Mutants", counts::mutants(&report(&["mutate", "derivations"]))),
        ("Suggestions", suggestions(&report(&["mutate", "derivations", "--repair"]))),
        ("Times", times()),
        ("Accelerations", accelerations()),
        ("Machine", machine()),
    ] {
        page = counts::with_table(&page, heading, &table);
    }
    std::fs::write(&path, page).expect("the page can be written");
    println!("{} is written", path.display());
}

/// A row for each command: its time and its memory.
fn times() -> String {
    let mut table = "| command | time | memory |\n| --- | ---: | ---: |\n".to_owned();
    for command in ["check", "mutate"] {
        let (time, memory) = best(&[command, "derivations"]);
        let _ = writeln!(table, "| `onshell {command} derivations` | {time} | {memory} |");
    }
    table
}

/// Runs onshell in the project's folder and reads its JSON.
fn json(arguments: &[&str]) -> Value {
    let mut command = Command::new(ONSHELL);
    let output = command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).output().expect("onshell can be run");
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{arguments:?}: {error}"))
}

/// The shortest time and the largest memory of several runs.
fn best(arguments: &[&str]) -> (String, String) {
    let (mut shortest, mut most) = (Duration::MAX, None);
    for _ in 0..RUNS {
        let mut command = Command::new(ONSHELL);
        command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).stdout(Stdio::null()).stderr(Stdio::null());
        let start = Instant::now();
        let mut child = command.spawn().expect("onshell can be run");
        while child.try_wait().expect("it can be waited for").is_none() {
            most = most.max(memory(child.id()));
            std::thread::sleep(Duration::from_millis(1));
        }
        shortest = shortest.min(start.elapsed());
    }
    let memory = most.map_or("not measured".to_owned(), |kilobytes| format!("{:.0} MB", kilobytes as f64 / 1024.0));
    (format!("{:.2} s", shortest.as_secs_f64()), memory)
}

/// The most memory that a running process has had, in kilobytes, where the system tells.
fn memory(process: u32) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.split_whitespace().next()?.parse().ok()
}

/// A row for each document: how many slips were noticed, and how many are undone by a suggestion.
fn suggestions(report: &Value) -> String {
    let mut table =
        "| document | slips noticed | undone by the first suggestion | undone by one of three |\n".to_owned();
    table.push_str("| --- | ---: | ---: | ---: |\n");
    let mut row = |name: &str, counts: [u64; 3]| {
        let [noticed, first, offered] = counts;
        let share = |count: u64| format!("{count} ({:.1} %)", 100.0 * count as f64 / noticed.max(1) as f64);
        let _ = writeln!(table, "| {name} | {noticed} | {} | {} |", share(first), share(offered));
    };
    let mut sums = [0; 3];
    for document in report["documents"].as_array().expect("documents is a list") {
        let mut counts = [0; 3];
        for equation in document["equations"].as_array().expect("equations is a list") {
            for (count, key) in counts.iter_mut().zip(["noticed", "first", "offered"]) {
                *count += equation["repairs"][key].as_u64().unwrap_or(0);
            }
        }
        row(document["path"].as_str().expect("a document has a path"), counts);
        sums.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
    }
    row("all", sums);
    table
}

/// A row for each way, from the lines that the other benchmark prints first.
fn accelerations() -> String {
    let mut cargo = Command::new(env!("CARGO"));
    // The filter leaves divan's table out.
    cargo.args(["bench", "--bench", "accelerations", "--", "none"]);
    cargo.current_dir(env!("CARGO_MANIFEST_DIR")).stderr(Stdio::null());
    let text = String::from_utf8(cargo.output().expect("cargo can be run").stdout).expect("the output is UTF-8");
    let mut table = "| way | nanoseconds | ratio |\n| --- | ---: | ---: |\n".to_owned();
    for (before, after) in text.lines().filter_map(|line| line.split_once(" ns a state")) {
        let (way, time) = before.rsplit_once(' ').expect("a time follows the name");
        let ratio = after.trim_matches(|c: char| !c.is_ascii_digit());
        let _ = writeln!(table, "| {} | {time} | {} |", way.trim(), if ratio.is_empty() { "1" } else { ratio });
    }
    table
}

/// The processor, its cores, the system and the compiler.
fn machine() -> String {
    let processor = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        line.split_once(": ").map(|(_, name)| name.to_owned())
    });
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let rustc = Command::new("rustc").arg("--version").output().map(|output| output.stdout).unwrap_or_default();
    let rustc = String::from_utf8_lossy(&rustc);
    let version = rustc.split_whitespace().nth(1).unwrap_or("unknown");
    let (processor, system) = (processor.as_deref().unwrap_or(std::env::consts::ARCH), std::env::consts::OS);
    format!(
        "| processor | cores | system | rustc |\n| --- | ---: | --- | --- |\n\
         | {processor} | {cores} | {system} | {version} |\n"
    )
}
