//! Circles of imports between the files of a crate, found in the text of its `use` lines and `crate::` paths.
//!
//! It reads text and is no compiler: `use` trees with braces, `self`, `super`, `crate`, and re-exports of a folder's
//! `mod.rs`. A re-export needs nothing: what a user of it imports is the file that has the name.

use std::collections::{BTreeMap, BTreeSet};

use crate::Files;

/// A path of names, `["check", "verdict"]` for `crate::check::verdict`.
type Path = Vec<String>;

/// The circles, each as the paths of its files in order, the longest first.
pub fn circles(files: &Files) -> Vec<String> {
    let modules: BTreeMap<Path, (&String, Imports)> =
        files.iter().map(|(path, text)| (module(path), (path, imports(&code(text))))).collect();
    let mut exported = BTreeMap::new();
    for (module, (_, imports)) in &modules {
        for target in imports.exported.iter().filter_map(|path| absolute(module, path, &modules)) {
            if let Some(name) = target.last() {
                exported.insert([module.as_slice(), std::slice::from_ref(name)].concat(), target.clone());
            }
        }
    }
    let owner = |mut target: Path| {
        // A chain of re-exports is never longer than the folders are deep.
        for _ in 0..8 {
            let Some(next) = exported.get(&target) else { break };
            target = next.clone();
        }
        while !target.is_empty() && !modules.contains_key(&target) {
            target.pop();
        }
        target
    };
    let mut graph: BTreeMap<&Path, BTreeSet<Path>> = BTreeMap::new();
    for (module, (_, imports)) in &modules {
        let targets = imports.needed.iter().filter_map(|path| absolute(module, path, &modules)).map(&owner);
        graph.insert(module, targets.filter(|target| target != module && modules.contains_key(target)).collect());
    }
    let mut found: Vec<Vec<&str>> = rings(&graph)
        .into_iter()
        .map(|ring| ring.into_iter().map(|module| modules[module].0.as_str()).collect())
        .collect();
    found.sort_by_key(|ring| std::cmp::Reverse(ring.len()));
    found.into_iter().map(|ring| ring.join(", ")).collect()
}

/// The module of a file: `src/check/mod.rs` is `check`, `src/check/verdict.rs` is `check::verdict`.
fn module(path: &str) -> Path {
    let path = path.strip_prefix("src/").unwrap_or(path).trim_end_matches(".rs");
    let mut parts: Path = path.split('/').map(str::to_owned).collect();
    if parts.last().is_some_and(|last| ["mod", "lib", "main"].contains(&last.as_str())) {
        parts.pop();
    }
    parts
}

/// The text without comments and without the tests at its end.
fn code(text: &str) -> String {
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
    let tests = lines.windows(2).position(|pair| {
        let (attribute, next) = (pair[0].trim(), pair[1].trim());
        attribute == "#[cfg(test)]" && next.contains("mod ") && next.ends_with('{')
    });
    lines[..tests.unwrap_or(lines.len())].join("\n")
}

/// What a file imports.
#[derive(Default)]
struct Imports {
    /// The paths of its `use` lines, and of all `crate::` paths besides.
    needed: Vec<Path>,
    /// The paths of its `pub use` lines.
    exported: Vec<Path>,
}

/// Reads the imports of a file from its code.
fn imports(text: &str) -> Imports {
    let mut found = Imports::default();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        let (public, tree) = match line.trim_start().split_once("use ") {
            Some(("", tree)) => (false, tree),
            Some((before, tree)) if before.starts_with("pub") && !before.contains('=') => (true, tree),
            _ => {
                found.needed.extend(inline(line));
                continue;
            }
        };
        let mut tree = tree.to_owned();
        while !tree.contains(';') {
            let Some(next) = lines.next() else { break };
            tree.push_str(next);
        }
        let list = if public { &mut found.exported } else { &mut found.needed };
        list.extend(leaves(tree.split(';').next().unwrap_or_default()));
    }
    found
}

/// The paths of a `use` tree: `a::{b, c::d as e}` gives `a::b` and `a::c::d`.
fn leaves(tree: &str) -> Vec<Path> {
    let tree = tree.trim();
    let Some((head, rest)) = tree.split_once('{') else {
        let path = tree.split(" as ").next().unwrap_or_default();
        let names = path.split("::").map(|name| name.trim().to_owned());
        return vec![names.filter(|name| !name.is_empty()).collect()];
    };
    let inner = rest.rsplit_once('}').map_or(rest, |(inner, _)| inner);
    let (mut parts, mut depth) = (vec![String::new()], 0);
    for c in inner.chars() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if c == ',' && depth == 0 {
            parts.push(String::new());
        } else if let Some(part) = parts.last_mut() {
            part.push(c);
        }
    }
    parts.retain(|part| !part.trim().is_empty());
    // `a::{self, …}` imports a itself.
    parts.iter().flat_map(|part| leaves(&format!("{head}{}", if part.trim() == "self" { "" } else { part }))).collect()
}

/// The paths in a line of code that begin with `crate::`.
fn inline(line: &str) -> Vec<Path> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let starts = line.match_indices("crate::").filter(|(at, _)| !line[..*at].ends_with(['$', ':', '_']));
    let paths = starts.map(|(at, _)| line[at..].split(|c| !is_name(c)).next().unwrap_or_default());
    paths.map(|path| path.split("::").filter(|name| !name.is_empty()).map(str::to_owned).collect()).collect()
}

/// A path from the root of the crate, or nothing for one into another crate.
fn absolute<T>(module: &[String], path: &[String], modules: &BTreeMap<Path, T>) -> Option<Path> {
    let (first, rest) = path.split_first()?;
    match first.as_str() {
        "crate" => Some(rest.to_vec()),
        "self" => Some([module, rest].concat()),
        "super" => {
            let ups = path.iter().take_while(|name| *name == "super").count();
            Some([&module[..module.len().saturating_sub(ups)], &path[ups..]].concat())
        }
        _ => {
            let child = [module, &path[..1]].concat();
            modules.contains_key(&child).then(|| [module, path].concat())
        }
    }
}

/// The rings of a graph: its strongly connected components of two members or more.
fn rings<'a>(graph: &BTreeMap<&'a Path, BTreeSet<Path>>) -> Vec<Vec<&'a Path>> {
    let reached: BTreeMap<&Path, BTreeSet<&Path>> = graph
        .keys()
        .map(|start| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![*start]);
            while let Some(module) = open.pop() {
                open.extend(graph[module].iter().filter(|next| seen.insert(*next)));
            }
            (*start, seen)
        })
        .collect();
    let mut found = BTreeSet::new();
    for (start, seen) in &reached {
        let ring: Vec<&Path> =
            graph.keys().copied().filter(|m| seen.contains(*m) && reached[m].contains(*start)).collect();
        if ring.len() > 1 {
            found.insert(ring);
        }
    }
    found.into_iter().collect()
}
