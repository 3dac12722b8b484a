//! A document of `derivations/` with its claims, checked once, its equations and sentences asked for one by one.

use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use libtest_mimic::Failed;
use onshell::Result;
use onshell::Source;
use onshell::check::{Document, Equation, Finding, Options, check_document};
use onshell::notes::Kind;
use onshell::notes::{Claims, Notes};
use onshell::systems::Registry;

/// What the command line checks with, unless told otherwise.
fn options() -> Options {
    let mut options = Options::default();
    options.explain = false;
    options
}

/// A document and its claims.
pub struct Paper {
    /// The name of the files without their extensions.
    pub stem: String,
    pub claims: Claims,
    pub notes: Notes,
    checked: OnceLock<Result<Document>>,
}

/// Every claims file in `derivations/`, in order.
pub fn claims_files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations");
    let entries = std::fs::read_dir(folder).expect("derivations/ can be read");
    let paths = entries.map(|entry| entry.expect("derivations/ can be read").path());
    let is_claims = |path: &PathBuf| {
        path.extension().is_some_and(|extension| extension == "json")
            && std::fs::read_to_string(path).is_ok_and(|text| {
                serde_json::from_str::<serde_json::Value>(&text).is_err() || text.contains("\"notes\"")
            })
    };
    let mut found: Vec<PathBuf> = paths.filter(is_claims).collect();
    found.sort();
    found
}

/// The name of a file without folder and extension.
pub fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

impl Paper {
    /// Reads a claims file and its notes, known by their paths within the repository.
    pub fn read(path: &Path) -> Result<Paper> {
        let shown = |path: &Path| format!("derivations/{}", path.file_name().unwrap_or_default().to_string_lossy());
        let claims = Claims::read(path, &shown(path))?;
        let notes = Notes::read(&claims.notes_path(), &shown(&claims.notes_path()))?;
        Ok(Paper { stem: stem(path), claims, notes, checked: OnceLock::new() })
    }

    /// The numbers of its equations, in order.
    pub fn numbers(&self) -> Vec<String> {
        self.notes.equations.iter().filter_map(|display| display.id()).map(str::to_owned).collect()
    }

    /// What the `at`-th sentence is called in reports.
    pub fn sentence_name(&self, at: usize) -> String {
        let name = self.claims.sentences[at].name.as_ref();
        name.map_or_else(|| format!("sentence {}", at + 1), |name| name.value.clone())
    }

    /// Notes like the paper's in which the errata of one equation have been followed, with claims that no longer list them.
    pub fn corrected(&self, notes: Notes, id: &str) -> Result<(Notes, Claims), Failed> {
        let mut claims = self.claims.clone();
        let Some(display) = notes.equations.iter().find(|display| display.id() == Some(id)) else {
            return Err(Failed::from(format!("({id}) is not in {}", notes.source.path)));
        };
        let (mut text, body) = (notes.source.text.clone(), display.body);
        let mut mended = text[body.start..body.end].to_owned();
        for (address, claim) in &mut claims.equations {
            let of_this_one =
                address.resolve(&notes, &self.claims.source)?.iter().any(|at| notes.equations[*at].id() == Some(id));
            for erratum in claim.errata.extract_if(.., |_| of_this_one) {
                let count = mended.matches(&erratum.printed.value).count();
                if count != erratum.times {
                    return Err(Failed::from(format!("“{}” stands {count} times in ({id})", erratum.printed.value)));
                }
                mended = mended.replace(&erratum.printed.value, &erratum.read.value);
            }
        }
        text.replace_range(body.start..body.end, &mended);
        let source = Arc::new(Source::new(&notes.source.path, text));
        Ok((Notes::parse(source, Kind::Markdown)?, claims))
    }

    /// The test of one equation.
    pub fn equation(&self, id: &str) -> Result<(), Failed> {
        let document = self.checked()?;
        let found = document.equations.iter().find(|equation| equation.id == id);
        as_expected(found.ok_or_else(|| format!("({id}) is not in the report"))?)
    }

    /// The test of one sentence.
    pub fn sentence(&self, at: usize) -> Result<(), Failed> {
        as_expected(self.checked()?.sentences.get(at).ok_or("it is not in the report")?)
    }

    fn checked(&self) -> Result<&Document, Failed> {
        let checked = self.checked.get_or_init(|| check(&self.claims, &self.notes, None));
        checked.as_ref().map_err(|error| Failed::from(error.to_string()))
    }
}

/// Checks notes against claims as the command line does.
pub fn check(claims: &Claims, notes: &Notes, only: Option<&str>) -> Result<Document> {
    check_document(claims, notes, &Registry::standard(), options(), only)
}

fn as_expected(item: &Equation) -> Result<(), Failed> {
    if item.ok { Ok(()) } else { Err(Failed::from(describe(item))) }
}

/// The equation, its verdict, and for each part that fails the state and both sides' values.
pub fn describe(item: &Equation) -> String {
    let mut text = format!("({}), line {}, is {}", item.id, item.line, item.finding.verdict);
    if let Some(because) = &item.because {
        text.push_str(&format!(", where another verdict was expected: {because}"));
    }
    for finding in failing(item) {
        text.push_str(&format!("\n  {}: {}", finding.verdict, finding.message));
        if let Some(found) = &finding.counterexample {
            text.push_str(&format!("\n    {} and {} at {:?}", found.lhs, found.rhs, found.state));
        }
    }
    text.push_str(&format!("\n  {}", item.latex.trim()));
    text
}

/// The findings of the parts that are not as expected, or else of the whole.
pub fn failing(item: &Equation) -> Vec<&Finding> {
    let parts: Vec<&Finding> = item.parts.iter().filter(|part| !part.ok).map(|part| &part.finding).collect();
    if parts.is_empty() { vec![&item.finding] } else { parts }
}
