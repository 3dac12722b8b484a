//! A folder for one test, and the program run in it.

use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Nothing here may take longer; a run that does is stopped, and its test fails.
const LONGEST: Duration = Duration::from_secs(30);

/// One flipped sign in (6.73).
pub const SIGN: (&str, &str) = ("\\, p_\\psi + MgR \\sin\\theta", "\\, p_\\psi - MgR \\sin\\theta");

/// The word for a verdict, however it was decided: what the field confirms is `verified` too.
pub fn outcome(word: &str) -> &str {
    if word == "certified" { "verified" } else { word }
}

/// A folder.
pub struct Desk(PathBuf);

/// What the program said.
pub struct Run {
    pub code: i32,
    pub out: String,
    pub err: String,
}

impl Run {
    /// The output as JSON.
    pub fn json(&self) -> serde_json::Value {
        serde_json::from_str(&self.out).unwrap_or_else(|error| panic!("{error} in:\n{}\n{}", self.out, self.err))
    }
}

impl Desk {
    /// An empty folder.
    pub fn new(name: &str) -> Desk {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cli").join(name);
        if path.exists() {
            std::fs::remove_dir_all(&path).expect("the folder of the run before can be removed");
        }
        std::fs::create_dir_all(&path).expect("a folder can be made");
        Desk(path)
    }

    /// A folder with a copy of `derivations/` in it.
    pub fn with_the_derivations(name: &str) -> Desk {
        let desk = Desk::new(name);
        std::fs::create_dir_all(desk.0.join("derivations")).expect("a folder can be made");
        let originals = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations");
        for entry in std::fs::read_dir(originals).expect("derivations/ can be read") {
            let from = entry.expect("derivations/ can be read").path();
            let name = from.file_name().expect("it has a name");
            std::fs::copy(&from, desk.0.join("derivations").join(name)).expect("it can be copied");
        }
        desk
    }

    /// The path of a file in it.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// Writes a file.
    pub fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        let path = self.0.join(name);
        std::fs::create_dir_all(path.parent().expect("a file is in a folder")).expect("the folder can be made");
        std::fs::write(path, text).expect("the file can be written");
    }

    /// The text of a file.
    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.join(name)).expect("the file can be read")
    }

    /// Changes a file in the one place that says `from`.
    pub fn change(&self, name: &str, (from, to): (&str, &str)) {
        let text = self.read(name);
        assert_eq!(text.matches(from).count(), 1, "“{from}” in {name}");
        self.write(name, text.replace(from, to));
    }

    /// Runs the program in the folder, in lines so wide that none is wrapped.
    pub fn onshell(&self, arguments: &[&str]) -> Run {
        self.onshell_on(None, arguments)
    }

    /// Runs it on that many threads.
    pub fn onshell_on(&self, threads: Option<usize>, arguments: &[&str]) -> Run {
        self.run(threads, Some("2000"), arguments)
    }

    /// Runs it with this value of `COLUMNS`, or without that variable.
    pub fn onshell_in_columns(&self, columns: Option<&str>, arguments: &[&str]) -> Run {
        self.run(None, columns, arguments)
    }

    fn run(&self, threads: Option<usize>, columns: Option<&str>, arguments: &[&str]) -> Run {
        let mut command = Command::new(env!("CARGO_BIN_EXE_onshell"));
        command.args(arguments).current_dir(&self.0).stdin(Stdio::null());
        if let Some(threads) = threads {
            command.env("RAYON_NUM_THREADS", threads.to_string());
        }
        match columns {
            Some(columns) => command.env("COLUMNS", columns),
            None => command.env_remove("COLUMNS"),
        };
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("onshell can be run");
        let (mut out, mut err) = (child.stdout.take().expect("piped"), child.stderr.take().expect("piped"));
        let reading = std::thread::spawn(move || {
            let mut text = Vec::new();
            out.read_to_end(&mut text).map(|_| text)
        });
        let reading_errors = std::thread::spawn(move || {
            let mut text = Vec::new();
            err.read_to_end(&mut text).map(|_| text)
        });
        let started = Instant::now();
        let status = loop {
            if let Some(status) = child.try_wait().expect("it can be waited for") {
                break status;
            }
            if started.elapsed() > LONGEST {
                child.kill().expect("it can be stopped");
                panic!("onshell {arguments:?} did not end within {LONGEST:?}");
            }
            std::thread::sleep(Duration::from_millis(2));
        };
        let text = |reading: std::thread::JoinHandle<std::io::Result<Vec<u8>>>| {
            String::from_utf8(reading.join().expect("it is read").expect("it is read")).expect("it is UTF-8")
        };
        let run = Run { code: status.code().unwrap_or(-1), out: text(reading), err: text(reading_errors) };
        assert!(!run.err.contains("panicked") && run.code >= 0, "onshell {arguments:?}: {status}\n{}", run.err);
        run
    }
}

/// The points of a hand-in of these lines for a problem, judged in a folder of its own.
pub fn points(folder: &str, (notes, claims): (&str, &str), lines: &str) -> f64 {
    let desk = Desk::new(folder);
    desk.write("p.md", notes);
    desk.write("p.json", claims);
    desk.write("one.md", lines);
    let report = desk.onshell(&["mark", "one.md", "--claims", "p.json", "--format", "json"]).json();
    report["students"][0]["credit"].as_f64().expect("the points of the student")
}

/// The marks of the lines of a hand-in for a problem, its notes and its claims.
pub fn marks(name: &str, (notes, claims): (&str, &str), lines: &str) -> Vec<String> {
    // Two tests may use one name; each runs in a thread that has its own.
    let test = std::thread::current().name().unwrap_or_default().replace("::", "-");
    let desk = Desk::new(&format!("marks-{test}-{name}"));
    desk.write("p.md", notes);
    desk.write("p.json", claims);
    desk.write("one.md", lines);
    let run = desk.onshell(&["mark", "one.md", "--claims", "p.json", "--format", "json"]);
    let report = run.json();
    let rows = report["rows"].as_array().unwrap().iter().filter(|row| !row["line"].is_null());
    rows.map(|row| row["mark"].as_str().unwrap().to_owned()).collect()
}

/// The verdicts on the displays of a page without a claims file.
pub fn verdicts(name: &str, notes: &str) -> Vec<String> {
    let desk = Desk::new(name);
    desk.write("notes.md", notes);
    let report = desk.onshell(&["check", "notes.md", "--format", "json"]).json();
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    equations.iter().map(|equation| equation["verdict"].as_str().expect("a verdict").to_owned()).collect()
}
