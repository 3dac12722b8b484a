//! The layout of the project: imports run one way, folders and files stay small, links on the pages lead somewhere.
//!
//! Each check stands beside made-up input on which it must fail.

#[path = "layout/imports.rs"]
mod imports;
#[path = "layout/links.rs"]
mod links;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The most files that a folder of `src` may have.
const FILES_IN_A_FOLDER: usize = 16;
/// The most lines that a file of `src` may have.
const LINES_IN_A_FILE: usize = 500;
/// The most lines that these pages may have.
const LINES_ON_A_PAGE: [(&str, usize); 2] = [("README.md", 200), ("docs/architecture.md", 200)];

/// Texts by their path, with `/` between folders.
type Files = BTreeMap<String, String>;

/// The folder of the project.
fn project() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All files with an ending in a folder of the project and the folders in it.
fn files(folder: &str, ending: &str) -> Files {
    let mut found = Files::new();
    let mut folders: Vec<PathBuf> = vec![project().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("the folder can be read") {
            let path = entry.expect("the entry can be read").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == ending) {
                let text = std::fs::read_to_string(&path).expect("the file can be read");
                let name = path.strip_prefix(project()).expect("it is in the project").display().to_string();
                found.insert(name.replace('\\', "/"), text);
            }
        }
    }
    found
}

/// The pages whose links are checked: all Markdown at the top level and in `docs`, and the overview of `derivations`.
fn pages() -> Files {
    let mut pages = files("docs", "md");
    for entry in std::fs::read_dir(project()).expect("the folder can be read") {
        let path = entry.expect("the entry can be read").path();
        if path.extension().is_some_and(|ending| ending == "md") {
            let name = path.file_name().expect("a file has a name").to_string_lossy().into_owned();
            pages.insert(name, std::fs::read_to_string(&path).expect("the page can be read"));
        }
    }
    let overview = std::fs::read_to_string(project().join("derivations/README.md")).expect("the page can be read");
    pages.insert("derivations/README.md".to_owned(), overview);
    pages
}

/// Made-up files.
fn made_up(texts: &[(&str, &str)]) -> Files {
    texts.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect()
}

/// Folders with more files than they may have.
fn crowded(files: &Files) -> Vec<String> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for path in files.keys() {
        *counts.entry(path.rsplit_once('/').map_or("", |(folder, _)| folder)).or_default() += 1;
    }
    let crowded = counts.into_iter().filter(|(_, count)| *count > FILES_IN_A_FOLDER);
    crowded.map(|(folder, count)| format!("{folder} has {count} files")).collect()
}

/// Files with more lines than they may have.
fn long(files: &Files, most: impl Fn(&str) -> usize) -> Vec<String> {
    let counts = files.iter().map(|(path, text)| (path, text.lines().count()));
    counts.filter(|(path, count)| *count > most(path)).map(|(path, n)| format!("{path} has {n} lines")).collect()
}

/// The most lines of a page.
fn most_lines(path: &str) -> usize {
    LINES_ON_A_PAGE.iter().find(|(page, _)| *page == path).map_or(usize::MAX, |(_, most)| *most)
}

/// Fails with a list, unless it is empty.
fn assert_none(what: &str, found: &[String]) {
    assert!(found.is_empty(), "{what}:\n{}", found.join("\n"));
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    assert_none("imports must run one way; these files import each other", &imports::circles(&files("src", "rs")));
}

#[test]
fn no_folder_has_too_many_files() {
    assert_none("split the folder by purpose", &crowded(&files("src", "rs")));
}

#[test]
fn no_file_is_too_long() {
    assert_none("split the file by purpose", &long(&files("src", "rs"), |_| LINES_IN_A_FILE));
}

#[test]
fn the_readme_and_the_architecture_are_short() {
    assert_none("move what a newcomer does not need to another page", &long(&pages(), most_lines));
}

#[test]
fn every_link_and_every_path_on_the_pages_leads_somewhere() {
    assert_none("links that lead nowhere", &links::dead(&pages(), |path| project().join(path).exists()));
}

#[test]
fn links_between_pages_work_on_the_documentation_site_too() {
    let guide = std::fs::read_to_string(project().join("src/guide.rs")).expect("the guide can be read");
    assert_none("define the link in src/guide.rs too", &links::without_a_module(&pages(), &guide));
}

#[test]
fn circles_are_found_through_braces_faces_and_super() {
    let found = |texts: &[(&str, &str)]| imports::circles(&made_up(texts));
    let direct = [("src/a.rs", "use crate::b::B;"), ("src/b.rs", "use crate::a::{self, A};")];
    assert_eq!(found(&direct), ["src/a.rs, src/b.rs"]);
    let braces = [
        ("src/a.rs", "use crate::{\n    c::{d::D as E, f},\n};"),
        ("src/c/mod.rs", "pub mod d;"),
        ("src/c/d.rs", "use crate::a;"),
    ];
    assert_eq!(found(&braces), ["src/a.rs, src/c/d.rs"]);
    let face = [
        ("src/a.rs", "use crate::c::D;"),
        ("src/c/mod.rs", "mod d;\npub use d::D;"),
        ("src/c/d.rs", "use super::super::a::A;"),
    ];
    assert_eq!(found(&face), ["src/a.rs, src/c/d.rs"]);
    let child = [("src/c/mod.rs", "mod d;\nuse d::D;\npub struct C;"), ("src/c/d.rs", "use super::C;")];
    assert_eq!(found(&child), ["src/c/mod.rs, src/c/d.rs"]);
    let inline = [("src/a.rs", "fn f() -> crate::b::B {}"), ("src/b.rs", "fn f(a: crate::a::A) {}")];
    assert_eq!(found(&inline), ["src/a.rs, src/b.rs"]);
    let ring = [("src/a.rs", "use crate::b::B;"), ("src/b.rs", "use crate::c;"), ("src/c.rs", "use crate::a::A;")];
    assert_eq!(found(&ring), ["src/a.rs, src/b.rs, src/c.rs"]);
}

#[test]
fn what_is_no_circle_is_not_called_one() {
    let found = |texts: &[(&str, &str)]| imports::circles(&made_up(texts));
    assert_eq!(found(&[("src/a.rs", "use crate::b::B;"), ("src/b.rs", "use std::fmt;")]), [""; 0]);
    // A face that re-exports what its files offer needs none of them.
    assert_eq!(found(&[("src/c/mod.rs", "mod d;\npub use d::D;"), ("src/c/d.rs", "use super::E;")]), [""; 0]);
    // Comments and tests are no imports.
    let comment = "// use crate::a::A;\n#[cfg(test)]\nmod tests {\n    use crate::a::A;\n}";
    assert_eq!(found(&[("src/a.rs", "use crate::b::B;"), ("src/b.rs", comment)]), [""; 0]);
}

#[test]
fn crowded_folders_and_long_files_are_found() {
    let many: Files = (0..=FILES_IN_A_FOLDER).map(|i| (format!("src/a/f{i}.rs"), String::new())).collect();
    assert_eq!(crowded(&many), ["src/a has 17 files"]);
    let fewer = many.into_iter().skip(1).collect();
    assert_eq!(crowded(&fewer), [""; 0]);
    let page = |lines: usize| made_up(&[("README.md", &"x\n".repeat(lines)), ("docs/claims.md", &"x\n".repeat(900))]);
    assert_eq!(long(&page(201), most_lines), ["README.md has 201 lines"]);
    assert_eq!(long(&page(200), most_lines), [""; 0]);
    assert_eq!(long(&made_up(&[("src/a.rs", &"x\n".repeat(501))]), |_| LINES_IN_A_FILE), ["src/a.rs has 501 lines"]);
}

#[test]
fn dead_links_are_found() {
    let page =
        "# One `part`, two\n\n[a](docs/b.md#its-heading) [b](docs/b.md#no) [c](c.md) [d](#one-part-two) `src/x.rs`\n";
    let pages = made_up(&[("README.md", page), ("docs/b.md", "## Its heading\n\n[up](../README.md#one)\n")]);
    let found = links::dead(&pages, |path| ["README.md", "docs/b.md"].contains(&path));
    let wanted = [
        "README.md: the heading docs/b.md#no",
        "README.md: the file c.md",
        "README.md: the file src/x.rs",
        "docs/b.md: the heading README.md#one",
    ];
    assert_eq!(found, wanted);
    let page = "[inline](c.md), [by name][c], [missing][d], [here](#b)\n\n[c]: c.md#part\n[d]: d.md\n";
    let found = links::without_a_module(&made_up(&[("docs/b.md", page)]), "/// [c]: c#part\n/// [d]: e\n");
    assert_eq!(
        found,
        ["docs/b.md: c.md is not written as a reference, [text][name]", "docs/b.md: the guide has no line [d]: d"]
    );
}
