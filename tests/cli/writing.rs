//! What the program writes: the notes whole or not at all, and its output all of it or with exit code 2.

use std::process::{Command, Stdio};

use serde_json::json;

use crate::support::Desk;

const WRONG: &str = "$$ \\frac{1}{a} - \\frac{1}{b} = \\frac{ab}{b - a} \\tag{1} $$\n";
const RIGHT: &str = "$$ \\frac{1}{a} - \\frac{1}{b} = \\frac{b - a}{ab} \\tag{1} $$\n";

fn desk(name: &str, notes: &str) -> Desk {
    let desk = Desk::new(name);
    desk.write("notes.json", json!({ "notes": "notes.md", "constants": { "a, b": "> 0" } }).to_string());
    desk.write("notes.md", notes);
    desk
}

/// Runs the program by a shell in a folder; `$onshell` is its path.
#[cfg(unix)]
fn by_shell(desk: &Desk, script: &str) -> (i32, String) {
    let mut command = Command::new("sh");
    command.args(["-c", script]).env("onshell", env!("CARGO_BIN_EXE_onshell")).current_dir(desk.path("."));
    let run = command.stdin(Stdio::null()).output().expect("a shell can be run");
    (run.status.code().unwrap_or(-1), String::from_utf8_lossy(&run.stderr).into_owned())
}

#[cfg(unix)]
#[test]
fn where_there_is_no_room_the_notes_stay() {
    let desk = desk("write-no-room", WRONG);
    // No file may grow, as on a full disk.
    let (code, said) = by_shell(&desk, "trap '' XFSZ; ulimit -f 0; exec \"$onshell\" check notes.md --fix --yes");
    assert_eq!((code, desk.read("notes.md").as_str()), (2, WRONG), "{said}");
    assert!(said.contains("cannot change notes.md"), "{said}");
    let files = std::fs::read_dir(desk.path(".")).expect("the folder can be read").count();
    assert_eq!(files, 2, "nothing is left beside the notes");
    // The program is stopped where it writes.
    let (_, said) = by_shell(&desk, "ulimit -f 0; \"$onshell\" check notes.md --fix --yes; true");
    assert_eq!(desk.read("notes.md"), WRONG, "{said}");
    // The twin: where there is room, the edit is made.
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("notes.md").as_str()), (0, RIGHT), "{}{}", run.out, run.err);
}

#[cfg(unix)]
#[test]
fn in_a_folder_that_cannot_be_written_the_notes_stay() {
    use std::os::unix::fs::PermissionsExt;
    let desk = desk("write-read-only", WRONG);
    let mode = |mode: u32| {
        std::fs::set_permissions(desk.path("."), std::fs::Permissions::from_mode(mode)).expect("the folder is ours");
    };
    mode(0o555);
    // Nothing is read-only for the superuser.
    let is_superuser = std::fs::write(desk.path("probe"), "").is_ok();
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    mode(0o755);
    match is_superuser {
        true => assert_eq!((run.code, desk.read("notes.md").as_str()), (0, RIGHT), "{}", run.err),
        false => {
            assert_eq!((run.code, desk.read("notes.md").as_str()), (2, WRONG), "{}", run.err);
            assert!(run.err.contains("cannot change notes.md"), "{}", run.err);
        }
    }
}

#[cfg(unix)]
#[test]
fn a_link_still_leads_to_the_edited_notes() {
    let desk = desk("write-link", WRONG);
    std::fs::rename(desk.path("notes.md"), desk.path("chapter.md")).expect("it can be renamed");
    std::os::unix::fs::symlink("chapter.md", desk.path("notes.md")).expect("a link can be made");
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("chapter.md").as_str()), (0, RIGHT), "{}{}", run.out, run.err);
    assert!(desk.path("notes.md").is_symlink());
}

#[test]
fn a_display_that_cannot_be_read_is_not_edited() {
    let broken = "$$ (a + b^2 = a^2 + 2ab + b^2 \\tag{1} $$\n";
    let desk = desk("write-unreadable", broken);
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_eq!((run.code, desk.read("notes.md").as_str()), (2, broken), "{}{}", run.out, run.err);
}

const COMMANDS: [&str; 8] = [
    "check notes.md",
    "check notes.md --format json",
    "read 'a + b'",
    "equal a a",
    "eval 1+1",
    "mutate notes.md",
    "derive heavy_top",
    "explain ambiguous",
];

#[cfg(target_os = "linux")]
#[test]
fn output_that_is_lost_is_exit_code_two() {
    let desk = desk("write-full", RIGHT);
    for command in COMMANDS {
        let (code, said) = by_shell(&desk, &format!("\"$onshell\" {command} > /dev/full"));
        assert_eq!(code, 2, "{command}: {said}");
        assert!(said.contains("cannot write the output"), "{command}: {said}");
        let (code, said) = by_shell(&desk, &format!("\"$onshell\" {command} > /dev/null"));
        assert!(code < 2, "{command}: {said}");
    }
}

#[cfg(unix)]
#[test]
fn a_reader_that_left_is_exit_code_two_without_a_word() {
    let desk = desk("write-pipe", RIGHT);
    for command in COMMANDS {
        let script = format!("{{ sleep 0.2; \"$onshell\" {command}; echo $? >&2; }} | true");
        let (_, said) = by_shell(&desk, &script);
        assert_eq!(said.trim(), "2", "{command}");
    }
}
