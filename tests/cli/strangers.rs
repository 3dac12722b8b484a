//! Pages in the style of different authors, without a claims file: nothing true is called wrong, and planted slips are.
//!
//! The pages are in `tests/strangers/`. After a display a comment plants a slip in it: `slip: … => …` is found, and
//! `unseen: … => …` is one that is not found yet. A new page needs no code.

use std::path::Path;

use serde_json::Value;

use crate::support::Desk;

/// A page with one slip in it.
struct Planted {
    file: String,
    text: String,
    /// The lines in which the slip is.
    lines: std::ops::RangeInclusive<usize>,
    what: String,
}

/// The slips of a page that are found, each planted alone, and the number of those that are not found yet.
fn planted(name: &str, page: &str) -> (Vec<Planted>, usize) {
    let (stem, extension) = name.rsplit_once('.').expect("a page has an extension");
    let (mut found, mut unseen, mut block, mut last) = (Vec::new(), 0, 0, 0);
    let mut start = 0;
    for line in page.split_inclusive('\n') {
        let (at, end) = (start, start + line.len());
        start = end;
        let comment = line.trim().trim_start_matches("<!--").trim_end_matches("-->").trim_start_matches('%').trim();
        let is_found = comment.strip_prefix("slip: ");
        let Some(slip) = is_found.or_else(|| comment.strip_prefix("unseen: ")) else { continue };
        if !page[last..at].trim().is_empty() {
            block = last;
        }
        last = end;
        if is_found.is_none() {
            unseen += 1;
            continue;
        }
        let (right, wrong) = slip.split_once(" => ").expect("a slip has two sides");
        let place = block + page[block..at].rfind(right).unwrap_or_else(|| panic!("{name} has no {right}"));
        let line_of = |at: usize| page[..at].matches('\n').count() + 1;
        found.push(Planted {
            file: format!("{stem}-{:02}.{extension}", found.len()),
            text: format!("{}{wrong}{}", &page[..place], &page[place + right.len()..]),
            lines: line_of(block)..=line_of(at),
            what: format!("{name}: {slip}"),
        });
    }
    (found, unseen)
}

/// The documents of a report.
fn documents(report: &Value) -> &[Value] {
    report["documents"].as_array().expect("a list")
}

fn equations(document: &Value) -> &[Value] {
    document["equations"].as_array().expect("a list")
}

/// Whether the slip is refuted in its place, with a repair; a number with a unit needs none. Where nothing else decides, its
/// display contradicts a definition, and an edit of each is shown.
fn is_refuted(slip: &Planted, report: &Value) -> bool {
    documents(report).iter().flat_map(equations).any(|equation| {
        let line = equation["line"].as_u64().and_then(|line| usize::try_from(line).ok()).unwrap_or_default();
        let has_repair = equation["repairs"].as_array().is_some_and(|repairs| !repairs.is_empty());
        let is_number = equation["code"] == "numbers-differ";
        let is_wrong = equation["verdict"] == "refuted" || equation["code"] == "contradiction";
        is_wrong && (has_repair || is_number) && slip.lines.contains(&line)
    })
}

#[test]
fn slips_of_strangers_are_found_and_true_pages_have_none() {
    let desk = Desk::new("strangers");
    let (mut found, mut missed, mut unseen) = (0, Vec::new(), 0);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/strangers");
    let entries = std::fs::read_dir(folder).expect("the pages can be read");
    for entry in entries {
        let path = entry.expect("the pages can be read").path();
        let name = path.file_name().expect("it has a name").to_string_lossy().into_owned();
        let page = std::fs::read_to_string(&path).expect("a page can be read");
        let (slips, more) = planted(&name, &page);
        desk.write(&format!("true/{name}"), &page);
        unseen += more;
        for slip in slips {
            desk.write(&slip.file, &slip.text);
            let report = desk.onshell(&["check", &slip.file, "--format", "json"]).json();
            match is_refuted(&slip, &report) {
                true => found += 1,
                false => missed.push(slip.what),
            }
        }
    }
    assert!(missed.is_empty(), "not found:\n{}", missed.join("\n"));
    assert!(2 * unseen <= found, "{unseen} slips are not found, and {found} are");

    let run = desk.onshell(&["check", "true", "--format", "json"]);
    assert_eq!(run.code, 0, "{}", run.out);
    let report = run.json();
    let verdicts: Vec<&str> =
        documents(&report).iter().flat_map(equations).filter_map(|equation| equation["verdict"].as_str()).collect();
    let decided = |verdict: &&&str| ["certified", "verified", "definition"].contains(*verdict);
    let share = verdicts.iter().filter(decided).count() as f64 / verdicts.len() as f64;
    assert!(share >= 0.6, "{share} of the displays follow or are introduced");
}
