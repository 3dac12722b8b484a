//! The same page in every format: the same verdicts, the right places, and `--fix` that changes the slip alone.

use serde_json::{Value, json};

use crate::support::Desk;

const SOUND: &str = r"(a + b)^2 = a^2 + 2 a b + b^2";
const SLIP: &str = r"\frac12 (\alpha + b)^3 = \frac12 (\alpha^3 + 3 \alpha^2 b + 3 \alpha b^2 - b^3)";
const OTHER: &str = r"\sin 2x = 2 \sin x \cos x";

/// The three displays, each between two texts, with prose around them.
fn page(open: &str, close: &str) -> String {
    [SOUND, SLIP, OTHER].map(|display| format!("{open}{display}{close}")).join("Then π and so on.\n\n")
}

/// Every line behind a mark.
fn behind(mark: &str, text: &str) -> String {
    text.lines().map(|line| format!("{mark}{line}\n")).collect()
}

/// The page in each format, as the name of a file and its text.
fn pages() -> Vec<(&'static str, String)> {
    let markdown = page("$$\n", "\n$$\n\n");
    let lines: Vec<String> = markdown.split_inclusive('\n').map(str::to_owned).collect();
    let cell = |source: Value| json!({ "cell_type": "markdown", "metadata": {}, "source": source });
    let code = json!({ "cell_type": "code", "metadata": {}, "outputs": [], "source": ["x = '$$\\t'\n"] });
    let notebook = |source: Value| json!({ "cells": [code, cell(source)], "nbformat": 4, "nbformat_minor": 5 });
    let rst = page(".. math::\n\n   ", "\n\n");
    vec![
        ("a.md", markdown.clone()),
        ("fence.md", page("```math\n", "\n```\n\n")),
        ("myst.md", page("```{math}\n:label: x\n\n", "\n```\n\n").replacen(": x", ": y", 1).replacen(": x", ": z", 1)),
        ("colons.md", page(":::{math}\n", "\n:::\n\n")),
        ("mdbook.md", page("\\\\[ ", " \\\\]\n\n")),
        ("oneline.md", page("$$", "$$\n\n")),
        ("quarto.qmd", page("$$\n", "\n$$ {#eq-}\n\n").replacen("eq-}", "eq-a}", 1).replacen("eq-}", "eq-b}", 1)),
        ("quoted.md", behind("> ", &markdown)),
        ("list.md", format!("- a list\n\n{}", behind("  ", &markdown))),
        ("a.Rmd", markdown.clone()),
        ("a.tex", page("\\begin{equation}\n", "\n\\end{equation}\n\n")),
        ("indented.ipynb", format!("{:#}", notebook(json!(lines)))),
        ("one.ipynb", notebook(json!(markdown)).to_string()),
        ("escaped.ipynb", notebook(json!(lines)).to_string().replace("π", "\\u03c0").replace("alpha", "\\u0061lpha")),
        ("a.rst", rst.clone()),
        ("a.adoc", page("[latexmath]\n++++\n", "\n++++\n\n")),
        ("a.org", page("\\[\n", "\n\\]\n\n")),
        ("a.rs", behind("/// ", &markdown) + "fn main() {}\n"),
        ("b.rs", behind("    //! ", &markdown)),
        ("a.cpp", format!("/**\n{} */\n", behind(" * ", &page("\\f[\n", "\n\\f]\n\n")))),
        ("a.h", behind("/// ", &page("\\f{equation*}{\n", "\n\\f}\n\n"))),
        ("a.py", format!("def f():\n    r\"\"\"A sum.\n\n{}    \"\"\"\n", behind("    ", &rst))),
        ("b.py", format!("def f():\n    '''A sum.\n\n{}    '''\n", behind("    ", &markdown.replace('\\', "\\\\")))),
        ("a.jl", format!("@doc raw\"\"\"\n{}\"\"\"\nf(x) = x\n", page("```math\n", "\n```\n\n"))),
    ]
}

fn verdicts(report: &Value) -> Vec<String> {
    let equations = report["documents"][0]["equations"].as_array().cloned().unwrap_or_default();
    equations.iter().map(|item| item["verdict"].as_str().unwrap_or_default().to_owned()).collect()
}

#[test]
fn each_format_has_the_same_verdicts_at_the_right_places() {
    let desk = Desk::new("formats-verdicts");
    for (name, text) in pages() {
        desk.write(name, &text);
        let run = desk.onshell(&["check", name, "--format", "json"]);
        let report = run.json();
        assert_eq!(verdicts(&report), ["certified", "refuted", "certified"], "{name}:\n{text}\n{}", run.out);
        let wrong = &report["documents"][0]["equations"][1];
        let at = |key: &str| wrong["span"][key].as_u64().unwrap_or_default() as usize;
        let marked = &text[at("start")..at("end")];
        assert!(marked.contains("frac12") && marked.contains("b^3)"), "{name}: {marked}");
        assert_eq!(text[..at("start")].matches('\n').count() + 1, at("line"), "{name}");
        assert_eq!(wrong["file"], *name);
    }
}

#[test]
fn an_edit_changes_the_slip_alone_in_each_format() {
    let desk = Desk::new("formats-fix");
    for (name, text) in pages() {
        desk.write(name, &text);
        let run = desk.onshell(&["check", name, "--fix", "--yes"]);
        assert_eq!(run.code, 0, "{name}: {}{}", run.out, run.err);
        assert_eq!(desk.read(name), text.replace("- b^3", "+ b^3"), "{name}: {}", run.err);
        if name.ends_with("ipynb") {
            serde_json::from_str::<Value>(&desk.read(name)).expect("it is still JSON");
        }
    }
}

#[test]
fn a_file_that_ends_anywhere_is_read_or_refused() {
    let desk = Desk::new("formats-cut");
    for (name, text) in pages() {
        for part in 1..8 {
            let mut at = text.len() * part / 8;
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            desk.write(name, &text[..at]);
            // A panic fails in `onshell`.
            let run = desk.onshell(&["check", name]);
            assert!([0, 1, 2].contains(&run.code), "{name}: {}", run.err);
        }
    }
}

#[test]
fn parts_of_a_project_are_read_with_it_and_named_in_findings() {
    let desk = Desk::new("formats-project");
    let main = "\\documentclass{article}\n\\usepackage{own}\n\\begin{document}\n\\input{ch/one}\n% \\input{no}\n\\include{ch/two}\n";
    desk.write("main.tex", format!("{main}\\end{{document}}\n"));
    desk.write("own.sty", "\\newcommand{\\half}{\\frac12}\n");
    desk.write("ch/one.tex", format!("\\[ {SOUND} \\]\nIn short:\n\\[ \\half (a + a) = a \\]\n"));
    desk.write("ch/two.tex", format!("Two.\n\n\\[ {SLIP} \\]\n"));
    let run = desk.onshell(&["check", ".", "--format", "json"]);
    let report = run.json();
    assert_eq!(report["documents"].as_array().map(Vec::len), Some(1), "{}", run.out);
    assert_eq!(verdicts(&report), ["certified", "certified", "refuted"], "{}", run.out);
    let wrong = &report["documents"][0]["equations"][2];
    let file = wrong["file"].as_str().unwrap_or_default();
    assert!(file.ends_with("ch/two.tex") && wrong["line"] == 3 && wrong["span"]["column"] == 4, "{wrong:#}");
    let run = desk.onshell(&["check", "main.tex", "--fix", "--yes"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert_eq!(desk.read("ch/two.tex"), format!("Two.\n\n\\[ {} \\]\n", SLIP.replace("- b^3", "+ b^3")));
    // What is not there is told, and the rest is checked; what leads in a circle is an error.
    desk.write("main.tex", format!("{main}\\input{{gone}}\\end{{document}}\n"));
    let run = desk.onshell(&["check", "main.tex"]);
    assert_eq!(run.code, 2, "{}", run.out);
    assert!(run.err.contains("the file gone is not there") && run.out.contains("3 displays"), "{}{}", run.out, run.err);
    desk.write("ch/two.tex", "\\input{main}\n");
    let run = desk.onshell(&["check", "main.tex"]);
    assert!(run.code == 2 && run.err.contains("includes itself") && run.err.contains("ch/two.tex:1:1"), "{}", run.err);
}

#[test]
fn other_encodings_are_read_where_they_are_declared_and_else_refused_at_the_byte() {
    let desk = Desk::new("formats-encodings");
    let text = format!("Zürich\n\n$$\n{SLIP}\n$$\n");
    let utf16: Vec<u8> = [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    desk.write("a.md", &utf16);
    let report = desk.onshell(&["check", "a.md", "--format", "json"]).json();
    let start = report["documents"][0]["equations"][0]["span"]["start"].as_u64().unwrap_or_default() as usize;
    assert_eq!(utf16[start..start + 4], [b'\\', 0, b'f', 0]);
    assert_eq!(desk.onshell(&["check", "a.md", "--fix", "--yes"]).code, 0);
    let fixed = text.replace("- b^3", "+ b^3");
    let expected: Vec<u8> = [0xff, 0xfe].into_iter().chain(fixed.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    assert_eq!(std::fs::read(desk.path("a.md")).expect("it is there"), expected);
    let latin = |head: &str| -> Vec<u8> {
        let text = format!("{head}\n\\begin{{document}}\nZürich\n\\[ {SLIP} \\]\n\\end{{document}}\n");
        text.chars().map(|c| u8::try_from(u32::from(c)).expect("Latin-1")).collect()
    };
    desk.write("b.tex", latin("\\usepackage[latin1]{inputenc}"));
    assert_eq!(desk.onshell(&["check", "b.tex"]).code, 1);
    desk.write("c.tex", latin(""));
    let run = desk.onshell(&["check", "c.tex"]);
    assert!(run.code == 2 && run.err.contains("is not UTF-8: byte 19 (0xfc, line 3)"), "{}", run.err);
}

#[test]
fn a_folder_is_searched_for_all_formats_and_for_programs_with_displays() {
    let desk = Desk::new("formats-folder");
    desk.write("in/a.rst", page(".. math::\n\n   ", "\n\n"));
    desk.write("in/b.rs", "//! $$\n//! x = x + 0\n//! $$\n");
    desk.write("in/c.rs", "//! A price of $$ and no more.\nfn main() {}\n");
    desk.write("in/.hidden/d.md", "$$ x = $$\n");
    desk.write("in/built/CACHEDIR.TAG", "Signature: 8a477f597d28d172789f06886806bc55\n");
    desk.write("in/built/e.md", "$$ x = $$\n");
    let report = desk.onshell(&["check", "in", "--format", "json"]).json();
    let paths: Vec<&Value> = report["documents"].as_array().into_iter().flatten().map(|d| &d["path"]).collect();
    assert_eq!(paths, ["in/a.rst", "in/b.rs"]);
    assert_eq!(report["errors"], json!([]));
}
