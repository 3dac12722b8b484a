//! The schemas that `onshell schema` prints: every claims file and every report is valid, and damaged ones are not.

use std::path::Path;

use jsonschema::Validator;
use serde_json::{Value, json};

use crate::support::Desk;

fn schema(of: &str) -> Validator {
    let desk = Desk::new(&format!("schema-{of}"));
    let run = desk.onshell(&["schema", of]);
    assert_eq!(run.code, 0, "{}", run.err);
    let schema: Value = serde_json::from_str(&run.out).expect("a schema is JSON");
    jsonschema::draft202012::new(&schema).unwrap_or_else(|error| panic!("{of} is no schema: {error}"))
}

fn problems(schema: &Validator, value: &Value) -> Vec<String> {
    schema.iter_errors(value).map(|error| format!("{}: {error}", error.instance_path())).collect()
}

/// The claims files of a folder.
fn claims_in(folder: &str) -> Vec<(String, Value)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let files = std::fs::read_dir(&folder).expect("the folder is there").flatten().map(|entry| entry.path());
    let claims = files.filter(|path| path.extension().is_some_and(|extension| extension == "json"));
    let read = |path: std::path::PathBuf| {
        let text = std::fs::read_to_string(&path).expect("the file can be read");
        let value: Value = serde_json::from_str(&text).ok()?;
        value.get("notes").is_some().then(|| (path.display().to_string(), value.clone()))
    };
    claims.filter_map(read).collect()
}

#[test]
fn every_claims_file_is_valid() {
    let schema = schema("claims");
    let mut count = 0;
    for folder in ["derivations", "examples", "examples/systems", "tests/gallery", "tests/mark"] {
        for (path, claims) in claims_in(folder) {
            assert_eq!(problems(&schema, &claims), Vec::<String>::new(), "{path}");
            count += 1;
        }
    }
    assert!(count > 50, "{count}");
    for damaged in [
        json!({}),
        json!({ "notes": 1 }),
        json!({ "notes": "a.md", "coordinate": {} }),
        json!({ "notes": "a.md", "constants": { "m": 1 } }),
        json!({ "notes": "a.md", "equations": { "1": { "hold": "always" } } }),
        json!({ "notes": "a.md", "equations": { "1": { "holds": "sometimes" } } }),
        json!({ "notes": "a.md", "sentences": [{ "claim": "x = y" }] }),
    ] {
        assert!(!schema.is_valid(&damaged), "{damaged}");
    }
}

#[test]
fn every_report_is_valid() {
    let schema = schema("report");
    let desk = Desk::new("schema-reports");
    desk.write("wrong.md", "$$ (a+b)^2 = a^2 + b^2 $$\n\n$$ \\nonsense{ $$\n\n$$ x = 1 \\\\ y = 2 $$\n");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let derivations = root.join("derivations").display().to_string();
    let torque = root.join("examples/torque.md").display().to_string();
    for arguments in [&["wrong.md"][..], &["missing.md"], &[&derivations], &[&torque]] {
        let arguments = [&["check", "--format", "json"], arguments].concat();
        let run = desk.onshell(&arguments);
        let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
        assert_eq!(problems(&schema, &report), Vec::<String>::new(), "{arguments:?}");
        let mut damaged = report.clone();
        damaged["schema"] = json!(0);
        assert!(!schema.is_valid(&damaged));
        if let Some(equation) = damaged.pointer_mut("/documents/0/equations/0/verdict") {
            *equation = json!("wrong");
            damaged["schema"] = json!(1);
            assert!(!schema.is_valid(&damaged));
        }
    }
}
