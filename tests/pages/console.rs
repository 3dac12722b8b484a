//! The files and console blocks of a Markdown page: the files are written to a folder, the commands are run there.
//!
//! A block whose first line is ```` ```LANGUAGE NAME ```` with a dot in the name is a file. In a ```` ```console ```` block each
//! line that begins with `$ ` is a command, and the lines up to the next one are what it prints: standard output, then
//! standard error. Commands are `onshell …`, `cargo run -- …` and `echo $?`, the last exit code.
//! The folder has a copy of `derivations/` and of `examples/`.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The page with the output of every console block as it is now.
///
/// # Panics
/// For a command that is not `onshell`, and for a page that is not well-formed.
pub fn refreshed(page: &str, name: &str) -> String {
    let mut folder = None;
    let (mut out, mut code) = (String::new(), 0);
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        out.push_str(line);
        out.push('\n');
        let Some(info) = line.strip_prefix("```") else { continue };
        let block: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
        let file = info.split_once(' ').map(|(_, file)| file).filter(|file| file.contains('.'));
        if info != "console" && file.is_none() {
            block.iter().for_each(|line| out.extend([line, "\n"]));
        } else {
            let folder = folder.get_or_insert_with(|| self::folder(name));
            if let Some(file) = file {
                let text = block.iter().flat_map(|line| [line, "\n"]).collect::<String>();
                let path = folder.join(file);
                std::fs::create_dir_all(path.parent().expect("it is in a folder")).expect("a folder can be made");
                std::fs::write(path, &text).expect("the file can be written");
                out.push_str(&text);
            }
            for command in block.iter().filter(|line| info == "console" && line.starts_with("$ ")) {
                out.extend([command, "\n"]);
                out.push_str(&printed(&command[2..], folder, &mut code));
            }
        }
        out.push_str("```\n");
    }
    out
}

/// What a command prints. `code` is the exit code of the command before, and then of this one.
fn printed(command: &str, folder: &Path, code: &mut i32) -> String {
    if command == "echo $?" {
        return format!("{code}\n");
    }
    let arguments = ["cargo run -- ", "onshell "].iter().find_map(|start| command.strip_prefix(start));
    let words = words(arguments.unwrap_or_else(|| panic!("a page may run onshell and nothing else: {command}")));
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let output = run(&words, folder);
    *code = output.status.code().unwrap_or(-1);
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("the output is UTF-8"));
    // Editors remove spaces at the ends of lines.
    text.concat().lines().flat_map(|line| [line.trim_end(), "\n"]).collect()
}

/// The words of a command, as a shell splits them: at spaces outside of single quotes.
fn words(command: &str) -> Vec<String> {
    let (mut words, mut quoted) = (vec![String::new()], false);
    for c in command.chars() {
        match c {
            '\'' => quoted = !quoted,
            ' ' if !quoted => words.push(String::new()),
            c => words.last_mut().expect("there is one").push(c),
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// Runs onshell in a folder, with the width of a terminal that is none.
fn run(arguments: &[&str], folder: &Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_onshell"));
    command.args(arguments).current_dir(folder).env_remove("COLUMNS").env("NO_COLOR", "1");
    command.output().expect("onshell can be run")
}

/// The exit code of onshell.
pub fn exit_code(arguments: &[&str]) -> i32 {
    run(arguments, Path::new(env!("CARGO_TARGET_TMPDIR"))).status.code().unwrap_or(-1)
}

/// What onshell prints as JSON, whatever its exit code.
pub fn json(arguments: &[&str], folder: &Path) -> serde_json::Value {
    let output = run(arguments, folder);
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{arguments:?}: {error}"))
}

/// A new folder with a copy of the documents of the project.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages").join(name);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).expect("the folder of the last run can be removed");
    }
    for part in ["derivations", "examples"] {
        copy(&Path::new(env!("CARGO_MANIFEST_DIR")).join(part), &folder.join(part));
    }
    folder
}

/// Copies a folder with all that is in it.
fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("a folder can be made");
    for entry in std::fs::read_dir(from).expect("it can be read") {
        let path = entry.expect("it can be read").path();
        let to = to.join(path.file_name().expect("it has a name"));
        if path.is_dir() {
            copy(&path, &to);
        } else {
            std::fs::copy(path, to).expect("it can be copied");
        }
    }
}

/// The first line that differs, as it stands on the page and as it should be.
pub fn first_difference(page: &str, now: &str) -> String {
    let at = page
        .lines()
        .zip(now.lines())
        .position(|(a, b)| a != b)
        .unwrap_or(page.lines().count().min(now.lines().count()));
    let line = |text: &str| text.lines().nth(at).unwrap_or("(the end)").to_owned();
    format!("line {}\n  on the page: {}\n  the program: {}", at + 1, line(page), line(now))
}
