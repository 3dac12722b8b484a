//! Links on Markdown pages: the files and headings that they name, and what they become on the documentation site.

use std::collections::BTreeMap;

use pulldown_cmark::{Event, LinkType, Options, Parser, Tag, TagEnd};

use crate::Files;

/// What a page has that can lead nowhere.
#[derive(Default)]
struct Page {
    /// Addresses of links, and whether each stands beside its text.
    links: Vec<(String, bool)>,
    /// Paths in code, such as `src/lib.rs`.
    paths: Vec<String>,
    /// The names of its headings, as links spell them.
    headings: Vec<String>,
    /// The names and addresses of its references, `[name]: address`.
    references: Vec<(String, String)>,
}

/// Reads a page.
fn read(text: &str) -> Page {
    let mut page = Page::default();
    let parser = Parser::new_ext(text, Options::ENABLE_TABLES);
    page.references =
        parser.reference_definitions().iter().map(|(name, d)| (name.to_owned(), d.dest.to_string())).collect();
    page.references.sort();
    let mut heading: Option<String> = None;
    for event in parser {
        match event {
            Event::Start(Tag::Link { link_type, dest_url, .. }) => {
                page.links.push((dest_url.to_string(), link_type == LinkType::Inline));
            }
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => page.headings.extend(heading.take().map(|text| slug(&text))),
            Event::Text(text) => heading.iter_mut().for_each(|heading| heading.push_str(&text)),
            Event::Code(code) => match &mut heading {
                Some(heading) => heading.push_str(&code),
                None if is_path(&code) => page.paths.push(code.to_string()),
                None => {}
            },
            _ => {}
        }
    }
    page
}

/// Whether code on a page is the path of a file of the project.
fn is_path(code: &str) -> bool {
    let folders = ["src/", "docs/", "tests/", "benches/", "examples/", "derivations/", "fuzz/", "editors/", ".ci/"];
    folders.iter().any(|folder| code.starts_with(folder)) && !code.contains([' ', '*', '…', '<', '{'])
}

/// A heading as a link spells it: lower case, hyphens for spaces, no punctuation.
fn slug(heading: &str) -> String {
    let kept = heading
        .to_lowercase()
        .chars()
        .filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c))
        .collect::<String>();
    kept.replace(' ', "-")
}

/// Whether a link leads out of the project.
fn is_outside(link: &str) -> bool {
    link.contains("://") || link.starts_with("mailto:")
}

/// The links and paths on the pages that lead nowhere. `exists` tells of a path from the top of the project.
pub fn dead(pages: &Files, exists: impl Fn(&str) -> bool) -> Vec<String> {
    let read: BTreeMap<&str, Page> = pages.iter().map(|(path, text)| (path.as_str(), read(text))).collect();
    let mut dead = Vec::new();
    for (path, page) in &read {
        let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
        for (link, _) in page.links.iter().filter(|(link, _)| !is_outside(link)) {
            let (file, heading) = link.split_once('#').map_or((link.as_str(), None), |(file, name)| (file, Some(name)));
            let target = if file.is_empty() { (*path).to_owned() } else { joined(folder, file) };
            if !exists(&target) {
                dead.push(format!("{path}: the file {target}"));
            } else if let Some(heading) = heading
                && !read.get(target.as_str()).is_some_and(|page| page.headings.iter().any(|name| name == heading))
            {
                dead.push(format!("{path}: the heading {target}#{heading}"));
            }
        }
        let missing = page.paths.iter().filter(|file| !exists(file.trim_end_matches('/')));
        dead.extend(missing.map(|file| format!("{path}: the file {file}")));
    }
    dead
}

/// The path of a file that a page in a folder names.
fn joined(folder: &str, file: &str) -> String {
    let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    for part in file.split('/') {
        match part {
            ".." => drop(parts.pop()),
            "." | "" => {}
            part => parts.push(part),
        }
    }
    parts.join("/")
}

/// The links of `docs` to other files that are not written as references, or that the guide does not define.
///
/// The pages are modules of the documentation, where `claims.md` leads nowhere. So they write `[text][name]`, and the
/// guide says before each page which module the name is.
pub fn without_a_module(pages: &Files, guide: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (path, text) in pages.iter().filter(|(path, _)| path.starts_with("docs/")) {
        let page = read(text);
        let inline = page.links.iter().filter(|(link, inline)| *inline && !is_outside(link) && !link.starts_with('#'));
        found.extend(inline.map(|(link, _)| format!("{path}: {link} is not written as a reference, [text][name]")));
        let inside = page.references.iter().filter(|(_, address)| !is_outside(address));
        let lines = inside.map(|(name, address)| format!("[{name}]: {}", address.replace(".md", "")));
        let missing = lines.filter(|line| !guide.lines().any(|in_guide| in_guide.ends_with(line.as_str())));
        found.extend(missing.map(|line| format!("{path}: the guide has no line {line}")));
    }
    found
}
