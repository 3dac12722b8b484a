//! The tables of `docs/benchmarks.md`: where they are on the page, and the counts from the program's reports as JSON.

use std::fmt::Write;

use serde_json::Value;

/// The page with another table below a heading.
///
/// # Panics
/// If the page has no such heading, or no table below it.
pub fn with_table(page: &str, heading: &str, table: &str) -> String {
    let section = page.find(&format!("\n## {heading}\n")).unwrap_or_else(|| panic!("no heading {heading}"));
    let start = section + page[section..].find("\n|").expect("the section has a table") + 1;
    let end = page[start..].find("\n\n").map_or(page.len(), |length| start + length + 1);
    [&page[..start], table, &page[end..]].concat()
}

/// How many equations and sentences have each verdict: from `onshell check --format json`.
pub fn verdicts(report: &Value) -> String {
    let mut table = "| verdict | equations and sentences |\n| --- | ---: |\n".to_owned();
    let summary = report["summary"].as_object().expect("the report has a summary");
    for (verdict, count) in summary.iter().filter(|(_, count)| count.as_u64() != Some(0)) {
        let _ = writeln!(table, "| {verdict} | {count} |");
    }
    table
}

/// How many slips each document's equations have, and what becomes of them: from `onshell mutate --format json`.
pub fn mutants(report: &Value) -> String {
    let mut table = "| document | mutants | refuted | refused | equivalent | survived |\n".to_owned();
    table.push_str("| --- | ---: | ---: | ---: | ---: | ---: |\n");
    let mut sums = [0; 5];
    for document in report["documents"].as_array().expect("documents is a list") {
        let mut row = [0; 5];
        for equation in document["equations"].as_array().expect("equations is a list") {
            for (count, key) in row.iter_mut().zip(["mutants", "refuted", "refused", "equivalent"]) {
                *count += equation[key].as_u64().unwrap_or(0);
            }
            row[4] += equation["survivors"].as_array().map_or(0, |list| list.len() as u64);
        }
        line(&mut table, document["path"].as_str().expect("a document has a path"), &row);
        sums.iter_mut().zip(row).for_each(|(sum, count)| *sum += count);
    }
    line(&mut table, "all", &sums);
    table
}

/// A row of a table: a name and counts.
fn line(table: &mut String, name: &str, counts: &[u64]) {
    let cells: Vec<String> = counts.iter().map(u64::to_string).collect();
    let _ = writeln!(table, "| {name} | {} |", cells.join(" | "));
}
