//! No line is wider than the terminal; failures are shown in full, and passes are counted.

use serde_json::json;
use unicode_width::UnicodeWidthStr;

use crate::support::{Desk, Run, SIGN};

/// The widest line of what a run printed, in columns.
fn widest(run: &Run) -> (usize, &str) {
    let lines = run.out.lines().chain(run.err.lines());
    lines.map(|line| (line.width(), line)).max().unwrap_or((0, ""))
}

/// Fails if a run printed a line of more columns than this, or nothing.
fn fits(run: &Run, columns: usize) {
    let (width, line) = widest(run);
    assert!(0 < width && width <= columns, "{width} columns: {line}\n{}{}", run.out, run.err);
}

/// A folder with a document that has a fault of each kind.
fn with_faults(name: &str) -> Desk {
    let desk = Desk::with_the_derivations(name);
    desk.change("derivations/06-spinning-top.md", SIGN);
    let ambiguous = r"\lambda_1 \ddot{\theta} = \lambda_1 \dot{\phi}^2 \sin\theta \cos\theta - \cos\theta p_\psi";
    let long = "a + ".repeat(100);
    let notes = format!(
        "$$ {long} a = 100 a \\tag{{1}} $$\n\n$$ {ambiguous} \\tag{{2}} $$\n\n\
         $$\n(a + b)^2 = a^2 + ab + b^2 , \\quad a + b\n= b + 2 a , \\quad a b = b a a\n\\tag{{3}}\n$$\n\n\
         $$ a + 1 = {long} b \\tag{{4}} $$\n"
    );
    desk.write("faults.md", notes);
    let claims = json!({
        "notes": "faults.md",
        "constants": { "a, b, \\lambda_1": "> 0" },
        "varies with time": { "\\theta, \\phi, p_\\psi": "any" },
    });
    desk.write("faults.json", claims.to_string());
    desk.write("broken.md", "$$ a = a \\tag{1} $$\n");
    let far = " ".repeat(300);
    desk.write("broken.json", format!("{{ {far} \"notes\": \"broken.md\", {far} \"constnats\": {{}} {far} }}"));
    desk
}

#[test]
fn a_pipe_is_eighty_columns_wide() {
    let desk = with_faults("widths");
    for arguments in [
        &["check", "derivations"][..],
        &["check", "derivations", "-v"],
        &["check", "faults.md"],
        &["check", "faults.md", "-v"],
        &["check", "broken.json"],
        &["check", "absent.md"],
        &["mutate", "derivations", "--only", "6.73", "--repair"],
        &["mutate", "derivations", "--only", "6.74", "-v"],
        &["equal", r"\sqrt{y^2}", "y"],
        &["equal", r"(a+b+c+d)^2", r"a^2+b^2+c^2+d^2+2ab+2ac+2ad+2bc+2bd+2cd+abcdabcdabcdabcdabcd"],
        &["equal", r"\cos\theta p_\psi", "y"],
        &["derive", "heavy_top"],
        &["derive", "double_pendulum"],
        &[
            "read",
            r"\lambda_1 \ddot{\theta} = \lambda_1 \dot{\phi}^2 \sin\theta \cos\theta - \dot\phi \sin\theta\,p_\psi",
        ],
        &["eval", "x + y + z"],
        &["explain"],
        &["explain", "refuted"],
        &["explain", "nothing-of-the-kind"],
    ] {
        fits(&desk.onshell_in_columns(None, arguments), 80);
    }
}

#[test]
fn a_width_that_is_asked_for_is_used() {
    let desk = with_faults("widths-asked");
    let run = |columns: &str| desk.onshell_in_columns(Some(columns), &["check", "faults.md"]);
    fits(&run("60"), 60);
    fits(&run("120"), 120);
    // The check can fail: a wide report is wide.
    assert!(widest(&run("120")).0 > 80 && widest(&run("2000")).0 > 400);
    // What is no width is not used.
    assert_eq!(run("wide").out, desk.onshell_in_columns(None, &["check", "faults.md"]).out);
}

#[test]
fn help_fits_and_has_an_example_for_each_command() {
    let desk = Desk::new("widths-help");
    for command in ["check", "derive", "equal", "eval", "explain", "mutate", "read"] {
        for flag in ["-h", "--help"] {
            let help = desk.onshell_in_columns(None, &[command, flag]);
            assert_eq!(help.code, 0);
            fits(&help, 80);
            let example = format!("\n  onshell {command}");
            assert!(help.out.contains("Example") && help.out.contains(&example), "{command}: {}", help.out);
        }
    }
    fits(&desk.onshell_in_columns(None, &["--help"]), 80);
    fits(&desk.onshell_in_columns(None, &["check", "--frobnicate"]), 80);
}

#[test]
fn the_place_that_is_marked_is_seen_however_long_its_line() {
    let desk = with_faults("widths-crop");
    let long = desk.onshell_in_columns(None, &["check", "faults.md"]);
    assert_eq!(long.code, 1, "{}", long.out);
    // One edit of (1) is at the end of a line of more than 400 columns.
    let edit = long.out.lines().find(|line| line.starts_with("1 + …"));
    assert!(edit.is_some_and(|line| line.ends_with(r"a = 101 a \tag{1} $$")), "{}", long.out);
    // What cannot be read is marked in the middle of its line.
    let marked = long.out.lines().collect::<Vec<_>>();
    let at = marked.iter().position(|line| line.contains(r"\cos\theta p_\psi")).expect("(2) is shown");
    assert!(marked[at + 1].contains('^'), "{}", long.out);
}

#[test]
fn a_document_that_passes_is_one_line_and_verbose_lists_it() {
    let desk = Desk::with_the_derivations("widths-counted");
    let brief = desk.onshell(&["check", "derivations"]);
    assert_eq!(brief.code, 0, "{}", brief.out);
    let lines: Vec<&str> = brief.out.lines().collect();
    // Nine documents, an empty line, and the summary.
    assert_eq!(lines.len(), 11, "{}", brief.out);
    assert!(lines[8].starts_with("derivations/06-spinning-top.md: ") && lines[8].contains("refuted as expected"));
    assert!(lines[10].starts_with("78 equations, 154 sentences: ") && lines[10].ends_with("all as expected"));
    let listed = desk.onshell(&["check", "derivations", "-v"]);
    assert!(listed.out.lines().any(|line| line.starts_with("  ✓ 6.73  ")), "{}", listed.out);
    assert_eq!(listed.out.lines().last(), lines.last().copied());
    // One that fails is shown in full without being asked for, and the rest is counted.
    desk.change("derivations/06-spinning-top.md", SIGN);
    let wrong = desk.onshell(&["check", "derivations"]);
    assert!(wrong.out.contains("error[sides-differ]: (6.73) is refuted: "), "{}", wrong.out);
    assert!(wrong.out.lines().nth(8).is_some_and(|line| line.ends_with(", 1 refuted")), "{}", wrong.out);
    assert!(!wrong.out.contains("6.74"), "{}", wrong.out);
}

#[test]
fn one_mistake_is_one_error_though_the_display_has_several_parts() {
    let desk = with_faults("one-error");
    let run = desk.onshell(&["check", "faults.md", "--only", "3"]);
    assert_eq!(run.code, 1, "{}", run.out);
    assert_eq!(run.out.matches("error[").count(), 1, "{}", run.out);
    // Each of its other two parts that fail is a note, with its place.
    for part in ["part 2 of 3, at 6:36, is refuted", "part 3 of 3, at 7:19, is refuted"] {
        assert!(run.out.contains(part), "no “{part}” in:\n{}", run.out);
    }
    // Two equations that are wrong are two errors.
    desk.write("faults.md", "$$ a = a + 1 \\tag{1} $$\n\n$$ b = b + 1 \\tag{2} $$\n");
    let run = desk.onshell(&["check", "faults.md"]);
    assert_eq!(run.out.matches("error[").count(), 2, "{}", run.out);
}

#[test]
fn the_last_line_of_a_failing_run_says_how_to_look_up_a_code() {
    let desk = with_faults("code-hint");
    let last = |text: &str| text.lines().last().unwrap_or_default().to_owned();
    for (arguments, code) in [(&["check", "faults.md"][..], 1), (&["read", "a +"], 2)] {
        let run = desk.onshell(arguments);
        assert_eq!(run.code, code, "{}{}", run.out, run.err);
        let said = if run.err.is_empty() { &run.out } else { &run.err };
        let hint = last(said);
        let word = hint.strip_prefix("For more information about a code, try: onshell explain ");
        let word = word.unwrap_or_else(|| panic!("no hint: {said}"));
        assert!(said.contains(&format!("error[{word}]: ")), "{said}");
        let explained = desk.onshell(&["explain", word]);
        assert!(explained.code == 0 && explained.out.starts_with(word), "{}{}", explained.out, explained.err);
    }
    // Of a file that is not there, the message says all.
    let absent = desk.onshell(&["check", "absent.md"]);
    assert!(absent.code == 2 && absent.err.contains("error[input]: "), "{}", absent.err);
    assert!(!absent.err.contains("onshell explain"), "{}", absent.err);
    let sound = desk.onshell(&["check", "derivations", "--only", "6.74"]);
    assert!(sound.code == 0 && !sound.out.contains("onshell explain"), "{}", sound.out);
}

#[test]
fn output_that_is_lost_is_exit_code_two() {
    let desk = Desk::with_the_derivations("lost-output");
    let into = |file: &str| {
        let out = std::fs::OpenOptions::new().write(true).open(file).expect("the device is there");
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_onshell"));
        command.args(["explain", "refuted"]).current_dir(desk.path("")).stdout(out).output().expect("it can be run")
    };
    if std::path::Path::new("/dev/full").exists() {
        let full = into("/dev/full");
        let said = String::from_utf8_lossy(&full.stderr).into_owned();
        assert_eq!(full.status.code(), Some(2), "{said}");
        assert!(said.starts_with("error: cannot write the output: "), "{said}");
    }
    if std::path::Path::new("/dev/null").exists() {
        assert_eq!(into("/dev/null").status.code(), Some(0));
    }
    // A reader that leaves before anything is written.
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_onshell"));
    command.arg("explain").stdout(std::process::Stdio::piped()).stderr(std::process::Stdio::piped());
    let (reader, writer) = std::io::pipe().expect("a pipe can be made");
    drop(reader);
    let run = command.stdout(writer).output().expect("it can be run");
    assert_eq!((run.status.code(), run.stderr.is_empty()), (Some(2), true));
}
