//! The README and the pages of `docs/`: every console block is run, and the figures are compared with the program's.
//!
//! `PAGES=overwrite cargo test --test pages` writes the program's present output into the pages.

#[path = "pages/console.rs"]
mod console;
#[path = "pages/counts.rs"]
mod counts;

use std::path::{Path, PathBuf};

/// The folder of the project.
fn project() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Whether the pages are to be written and not compared.
fn overwrites() -> bool {
    std::env::var("PAGES").is_ok_and(|value| value == "overwrite")
}

/// All pages in Markdown, the notes in `derivations/` and `examples/` apart.
fn pages() -> Vec<PathBuf> {
    let markdown = |folder: &str| {
        let entries = std::fs::read_dir(project().join(folder)).expect("the folder can be read");
        let paths = entries.map(|entry| entry.expect("the entry can be read").path());
        paths.filter(|path| path.extension().is_some_and(|ending| ending == "md")).collect::<Vec<_>>()
    };
    let mut pages = [markdown("."), markdown("docs"), vec![project().join("derivations/README.md")]].concat();
    pages.sort();
    pages
}

#[test]
fn every_console_block_shows_what_the_program_prints() {
    let mut stale = Vec::new();
    for path in pages() {
        let page = std::fs::read_to_string(&path).expect("the page can be read");
        let name = path.strip_prefix(project()).expect("it is in the project").display().to_string();
        let now = console::refreshed(&page, &name.replace(['/', '.'], "-"));
        if now == page {
            continue;
        }
        if overwrites() {
            std::fs::write(&path, now).expect("the page can be written");
        } else {
            stale.push(format!("{name}: {}", console::first_difference(&page, &now)));
        }
    }
    assert!(stale.is_empty(), "{}\nto refresh: PAGES=overwrite cargo test --test pages", stale.join("\n"));
}

/// A page with a file and a command on it.
const MADE_UP: &str = "\
# A page

```markdown one.md
$$ x + x = 2x \\tag{1} $$
```

```json one.json
{ \"notes\": \"one.md\", \"constants\": { \"x\": \"any\" } }
```

```console
$ onshell read 'x + x'
x + x
  taken for real numbers: x
```

```text
$ onshell read 'this block is not run'
```
";

#[test]
fn a_page_with_the_right_output_stays_as_it_is_and_a_wrong_one_does_not() {
    let page = console::refreshed(MADE_UP, "made-up");
    assert_eq!(console::refreshed(&page, "made-up"), page);
    // The case that must fail: one changed line of output.
    let wrong = page.replace("\nx + x\n", "\nx + y\n");
    assert_ne!(wrong, page);
    assert_eq!(console::refreshed(&wrong, "made-up-wrong"), page);
    assert!(console::first_difference(&wrong, &page).contains("x + y"));
}

#[test]
fn files_on_a_page_are_there_for_its_commands_and_exit_codes_are_shown() {
    let page = MADE_UP.replace("$ onshell read 'x + x'", "$ onshell check one.md --format json\n$ echo $?");
    let shown = console::refreshed(&page, "made-up-files");
    assert!(shown.contains("\"certified\"") && shown.contains("$ echo $?\n0\n"), "{shown}");
    // The case that must fail: the file has another equation.
    let wrong = console::refreshed(&page.replace("= 2x", "= 3x"), "made-up-files-wrong");
    assert!(wrong.contains("\"refuted\"") && wrong.contains("$ echo $?\n1\n"), "{wrong}");
}

/// The formulas in the columns of a table: of each row, those that are rejected and those to write instead.
fn rejected(page: &str) -> Vec<(Vec<String>, Vec<String>)> {
    let codes = |cell: &str| -> Vec<String> {
        let every_other = cell.split('`').skip(1).step_by(2);
        every_other.map(|code| code.replace("\\|", "|")).collect()
    };
    let section = page.split("\n## ").find(|section| section.starts_with("Rejected as ambiguous"));
    let rows = section.expect("the page has this section").lines().filter(|line| line.starts_with("| `"));
    let cells = rows.map(|row| row.split(" | ").collect::<Vec<_>>());
    cells.map(|row| (codes(row[0]), codes(row.last().expect("a row has cells")))).collect()
}

/// What is wrong with a table of rejected formulas.
fn misstated(page: &str) -> Vec<String> {
    let mut wrong = Vec::new();
    for (rejected, instead) in rejected(page) {
        let read = |formula: &String| console::exit_code(&["read", formula]) == 0;
        wrong.extend(rejected.into_iter().filter(read).map(|formula| format!("{formula} is read")));
        wrong.extend(
            instead.into_iter().filter(|formula| !read(formula)).map(|formula| format!("{formula} is not read")),
        );
    }
    wrong
}

/// What is wrong with the table of formulas without a value: each must be read, and have no value.
fn valued(page: &str) -> Vec<String> {
    let section = page.split("\n## ").find(|section| section.starts_with("Structure only"));
    let rows = section.expect("the page has this section").lines().filter(|line| line.starts_with("| `"));
    let mut wrong = Vec::new();
    for row in rows {
        let cell = row.split(" | ").next().unwrap_or_default();
        for formula in cell.split('`').skip(1).step_by(2) {
            if console::exit_code(&["read", formula]) != 0 {
                wrong.push(format!("{formula} is not read"));
            }
            if console::exit_code(&["eval", formula]) == 0 {
                wrong.push(format!("{formula} has a value"));
            }
        }
    }
    wrong
}

#[test]
fn what_the_page_of_notation_calls_structure_is_read_and_has_no_value() {
    let page = std::fs::read_to_string(project().join("docs/notation.md")).expect("the page can be read");
    assert_eq!(valued(&page), [""; 0]);
    // The case that must fail: a formula with a value, and one that is rejected.
    assert_eq!(valued("\n## Structure only\n| `1+1`, `a/bc` | x |\n"), ["1+1 has a value", "a/bc is not read"]);
}

#[test]
fn what_the_page_of_notation_calls_rejected_is_rejected_and_what_it_advises_is_read() {
    let page = std::fs::read_to_string(project().join("docs/notation.md")).expect("the page can be read");
    assert!(rejected(&page).len() > 15);
    assert_eq!(misstated(&page), [""; 0]);
    // The case that must fail: a formula in the wrong column.
    let wrong = "\n## Rejected as ambiguous\n| `a+b` | why | `a/bc` |\n";
    assert_eq!(misstated(wrong), ["a+b is read", "a/bc is not read"]);
}

#[test]
fn the_counts_on_the_page_of_benchmarks_are_those_of_the_program() {
    let path = project().join("docs/benchmarks.md");
    let page = std::fs::read_to_string(&path).expect("the page can be read");
    let run = |command| console::json(&[command, "derivations", "--format", "json"], project());
    let now = counts::with_table(&page, "Verdicts", &counts::verdicts(&run("check")));
    let now = counts::with_table(&now, "Mutants", &counts::mutants(&run("mutate")));
    if overwrites() {
        std::fs::write(&path, &now).expect("the page can be written");
    } else {
        assert_eq!(page, now, "to refresh: PAGES=overwrite cargo test --test pages");
    }
    // The case that must fail: a table of another program.
    assert_ne!(counts::with_table(&now, "Mutants", "| all | 1 | 1 | 0 | 0 | 0 |\n"), now);
}
