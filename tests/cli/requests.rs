//! The reports for pull requests: SARIF with the parts that its schema requires, JUnit XML, and GitHub's commands.

use serde_json::Value;

use crate::support::Desk;

/// A slip behind characters of several bytes, of which one is two UTF-16 units.
const NOTES: &str =
    "# Ü\n\né 𝔸 $$ \\alpha^2 + (a + b)^3 = \\alpha^2 + a^3 + 3 a^2 b + 3 a b^2 - b^3 $$\n\n$$ a + a = 2 a $$\n";

fn desk(name: &str) -> Desk {
    let desk = Desk::new(name);
    desk.write("my, notes.md", NOTES);
    desk
}

/// What is missing or wrong in a SARIF log, by its schema.
fn faults(log: &Value) -> Vec<String> {
    let mut faults = Vec::new();
    let mut need = |holds: bool, what: &str| {
        if !holds {
            faults.push(what.to_owned());
        }
    };
    need(log["version"] == "2.1.0", "version");
    let run = &log["runs"][0];
    need(run["tool"]["driver"]["name"].is_string(), "name");
    let rules = run["tool"]["driver"]["rules"].as_array().cloned().unwrap_or_default();
    need(run["results"].is_array(), "results");
    for result in run["results"].as_array().into_iter().flatten() {
        need(result["message"]["text"].is_string(), "message");
        let rule = result["ruleIndex"].as_u64().and_then(|at| rules.get(at as usize));
        need(rule.is_some_and(|rule| rule["id"] == result["ruleId"] && rule["help"]["text"].is_string()), "rule");
        for location in result["locations"].as_array().into_iter().flatten() {
            let region = &location["physicalLocation"]["region"];
            need(region["startLine"].as_u64().is_some_and(|line| line >= 1), "startLine");
            need(region["startColumn"].as_u64().is_some_and(|column| column >= 1), "startColumn");
        }
        for fix in result["fixes"].as_array().into_iter().flatten() {
            let change = &fix["artifactChanges"][0];
            need(change["artifactLocation"]["uri"].is_string(), "uri");
            need(change["replacements"][0]["deletedRegion"].is_object(), "deletedRegion");
        }
    }
    faults
}

#[test]
fn sarif_has_the_region_in_bytes_and_in_utf_16_and_a_fix_that_mends() {
    let desk = desk("requests-sarif");
    let run = desk.onshell(&["check", "my, notes.md", "--format", "sarif"]);
    let log = run.json();
    assert_eq!((run.code, faults(&log)), (1, Vec::new()), "{}", run.out);
    let result = &log["runs"][0]["results"][0];
    assert_eq!(log["runs"][0]["results"].as_array().map(Vec::len), Some(1));
    let place = &result["locations"][0]["physicalLocation"];
    assert_eq!(place["artifactLocation"]["uri"], "my%2C%20notes.md");
    let region = &place["region"];
    let number = |region: &Value, key: &str| region[key].as_u64().expect("a number") as usize;
    let start = number(region, "byteOffset");
    assert!(NOTES[start..start + number(region, "byteLength")].starts_with("\\alpha^2 + (a"));
    let units = NOTES[NOTES.find('é').expect("it is there")..start].encode_utf16().count();
    assert_eq!((number(region, "startLine"), number(region, "startColumn")), (3, units + 1));
    let replacement = &result["fixes"][0]["artifactChanges"][0]["replacements"][0];
    let from = number(&replacement["deletedRegion"], "byteOffset");
    let to = from + number(&replacement["deletedRegion"], "byteLength");
    let mut mended = NOTES.to_owned();
    mended.replace_range(from..to, replacement["insertedContent"]["text"].as_str().expect("a text"));
    desk.write("my, notes.md", mended);
    assert_eq!(desk.onshell(&["check", "my, notes.md"]).code, 0);
    // A log that lacks something is found to lack it.
    let mut broken = log.clone();
    broken["runs"][0]["results"][0]["ruleIndex"] = serde_json::json!(7);
    broken["version"] = serde_json::json!("2.0");
    assert_eq!(faults(&broken), ["version", "rule"]);
}

#[test]
fn github_shows_each_problem_at_its_line() {
    let desk = desk("requests-github");
    let run = desk.onshell(&["check", "my, notes.md", "--format", "github"]);
    let start = "::error file=my%2C notes.md,line=3,endLine=3,col=8,endColumn=";
    assert!(run.out.starts_with(start) && run.out.contains(",title=sides-differ::(L3) is refuted"), "{}", run.out);
    assert_eq!((run.out.lines().count(), run.code), (1, 1));
    let run = desk.onshell(&["check", "absent.md", "--format", "github"]);
    assert!(run.code == 2 && run.out.starts_with("::error title=input::"), "{}", run.out);
}

#[test]
fn junit_has_a_case_for_each_equation() {
    let desk = desk("requests-junit");
    let run = desk.onshell(&["check", "my, notes.md", "--format", "junit"]);
    assert!(run.out.contains("<testsuites tests=\"2\" failures=\"1\" errors=\"0\">"), "{}", run.out);
    assert_eq!((run.out.matches("<testcase ").count(), run.out.matches("<failure ").count()), (2, 1));
    assert!(run.out.contains("file=\"my, notes.md\" line=\"3\""), "{}", run.out);
    let run = desk.onshell(&["check", "absent.md", "--format", "junit"]);
    assert!(run.code == 2 && run.out.contains("<error type=\"input\""), "{}", run.out);
}
