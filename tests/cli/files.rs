//! `--fix` never harms the notes: what cannot be written whole is not written.

use std::process::Command;

use crate::support::Desk;

const CLAIMS: &str = r#"{ "notes": "notes.md", "constants": { "m, v": "> 0" } }"#;

const WRONG: &str = "$$ (m + v)^2 = m^2 - 2 m v + v^2 \\tag{1} $$\n";

fn desk(name: &str) -> Desk {
    let desk = Desk::new(name);
    desk.write("notes.json", CLAIMS);
    desk.write("notes.md", WRONG);
    desk
}

#[cfg(unix)]
#[test]
fn with_no_room_left_the_notes_stay_as_they_were() {
    let desk = desk("files-room");
    // A file may have no byte, and the signal that says so is ignored: a write fails as on a full disk.
    let fix = r#"trap "" XFSZ; ulimit -f 0; exec "$0" check notes.md --fix --yes"#;
    let run = Command::new("sh")
        .args(["-c", fix, env!("CARGO_BIN_EXE_onshell")])
        .current_dir(desk.path("."))
        .output()
        .expect("sh runs");
    assert_eq!(run.status.code(), Some(2), "{}", String::from_utf8_lossy(&run.stderr));
    assert!(String::from_utf8_lossy(&run.stderr).contains("cannot change notes.md"));
    assert_eq!(desk.read("notes.md"), WRONG);
    // must-fail case: with room the edit is made, and nothing is left beside the notes
    let run = desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_ne!(desk.read("notes.md"), WRONG, "{}{}", run.out, run.err);
    let files = std::fs::read_dir(desk.path(".")).expect("the folder can be read").count();
    assert_eq!(files, 2);
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link_and_permissions_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let desk = desk("files-link");
    std::fs::rename(desk.path("notes.md"), desk.path("text.md")).expect("it can be renamed");
    symlink("text.md", desk.path("notes.md")).expect("a link can be made");
    let mode = |name: &str| std::fs::metadata(desk.path(name)).expect("it is there").permissions().mode() & 0o777;
    std::fs::set_permissions(desk.path("text.md"), PermissionsExt::from_mode(0o640)).expect("they can be set");
    desk.onshell(&["check", "notes.md", "--fix", "--yes"]);
    assert_ne!(desk.read("text.md"), WRONG);
    assert!(desk.path("notes.md").is_symlink());
    assert_eq!(mode("text.md"), 0o640);
}

#[cfg(target_os = "linux")]
#[test]
fn lost_output_is_an_error() {
    let desk = desk("files-output");
    for command in
        ["check notes.md", "read 'a + b'", "equal 'a + a' '2a'", "derive pendulum", "explain", "mutate notes.md"]
    {
        let run = Command::new("sh")
            .args(["-c", &format!("exec \"$0\" {command} > /dev/full"), env!("CARGO_BIN_EXE_onshell")])
            .current_dir(desk.path("."))
            .output()
            .expect("sh runs");
        assert_eq!(run.status.code(), Some(2), "{command}: {}", String::from_utf8_lossy(&run.stderr));
    }
}
