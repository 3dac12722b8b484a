//! Files that cannot be read.

use super::*;

/// A folder of this process's own.
fn folder() -> std::path::PathBuf {
    let folder = std::env::temp_dir().join(format!("onshell-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn file(name: &str, bytes: &[u8]) -> std::path::PathBuf {
    let path = folder().join(name);
    std::fs::write(&path, bytes).unwrap();
    path
}

#[test]
fn readable() {
    let path = file("good.md", "\u{feff}$$a = \\bar{é} \\tag{1}$$".as_bytes());
    assert_eq!(numbers(&Notes::read(&path, "good.md").unwrap().equations), ["1"]);
}

#[test]
fn unreadable() {
    let read = |name: &str, bytes: &[u8]| Notes::read(&file(name, bytes), name).unwrap_err().to_string();
    assert!(read("utf8.md", b"one\ntwo \xff").contains("byte 8 (0xff, line 2)"));
    assert!(read("empty.md", b"").contains("empty"));
    assert!(read("blank.md", b"\xef\xbb\xbf \n").contains("empty"));
    assert!(read("notes.pdf", b"x").contains("is not supported"));
    let missing = Notes::read(Path::new("/nowhere/x.md"), "x.md").unwrap_err().to_string();
    assert!(missing.contains("cannot read x.md"));
    assert!(Claims::read(&folder(), "tmp").unwrap_err().to_string().contains("folder"));
    assert!(Claims::read(&file("utf8.json", b"{\xff}"), "u").unwrap_err().to_string().contains("byte 1"));
}

#[test]
fn beside() {
    assert_eq!(claims_beside(Path::new("a/top.md")), Path::new("a/top.json"));
    assert_eq!(claims(&with("\"equations\": {}")).unwrap().notes_path(), Path::new("dir/top.md"));
}
