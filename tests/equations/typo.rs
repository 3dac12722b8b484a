//! A single slip in a printed equation: applied in memory, and refuted.
//!
//! A slip in a definition shows in an equation that stands on it. An equation with an erratum is wrong as printed anyway,
//! so there the slip is looked for in what the erratum corrects it to.

use std::sync::Arc;

use libtest_mimic::Failed;
use onshell::check::{Counterexample, Equation, Finding, Verdict};
use onshell::notes::{Kind, Notes};
use onshell::{Code, Formula, Source};

use crate::paper::{Paper, check, describe, failing};

/// "For … read …", where what is to be read is wrong.
#[derive(Clone, Debug)]
pub struct Typo {
    /// The notes.
    pub document: String,
    /// The number of the equation.
    pub equation: String,
    /// What is printed, once in the equation.
    pub printed: String,
    /// The slip.
    pub slip: String,
    /// What kind of slip it is.
    pub kind: String,
    /// The equation that must go red, where the slip is in a definition that this one stands on.
    pub breaks: Option<String>,
    /// Whether the slip is in a definition that only a sentence uses: then nothing pins it any more.
    pub unpinned: bool,
}

/// The typos of `tests/typos.json`.
pub fn all() -> Vec<Typo> {
    let list: Vec<serde_json::Value> = serde_json::from_str(include_str!("../typos.json")).expect("typos.json is JSON");
    let typo = |entry: &serde_json::Value| {
        let text = |key: &str| entry[key].as_str().unwrap_or_else(|| panic!("no “{key}” in {entry}")).to_owned();
        Typo {
            document: text("document"),
            equation: text("equation"),
            printed: text("for"),
            slip: text("read"),
            kind: text("kind"),
            breaks: entry.get("breaks").map(|_| text("breaks")),
            unpinned: entry["unpinned"] == true,
        }
    };
    list.iter().map(typo).collect()
}

impl Typo {
    /// The name of its test.
    pub fn title(&self) -> String {
        format!("typo::{}::{}: for “{}” read “{}”", self.equation, self.kind, self.printed, self.slip)
    }

    /// The notes with the slip in them.
    pub fn apply(&self, paper: &Paper) -> Result<Notes, Failed> {
        let numbered = |display: &&onshell::notes::Display| display.id() == Some(&self.equation);
        let display = paper.notes.equations.iter().find(numbered);
        let display = display.ok_or_else(|| format!("({}) is not in {}", self.equation, self.document))?;
        let body = paper.notes.source.slice(display.body);
        let places: Vec<usize> = body.match_indices(&self.printed).map(|(at, _)| at + display.body.start).collect();
        let [place] = places.as_slice() else {
            let count = places.len();
            return Err(Failed::from(format!("“{}” stands {count} times in ({})", self.printed, self.equation)));
        };
        let mut text = paper.notes.source.text.clone();
        text.replace_range(*place..place + self.printed.len(), &self.slip);
        Notes::parse(Arc::new(Source::new(&self.document, text)), Kind::Markdown).map_err(|e| e.to_string().into())
    }

    /// The test: the slip is refuted, with a counterexample that stands, or it is no formula any more.
    pub fn must_fail(&self, paper: &Paper) -> Result<(), Failed> {
        let notes = self.apply(paper)?;
        let red = self.breaks.as_ref().unwrap_or(&self.equation);
        let (notes, claims) = paper.corrected(notes, red)?;
        let report = check(&claims, &notes, Some(red)).map_err(|error| error.to_string())?;
        let [equation] = report.equations.as_slice() else {
            return Err(Failed::from(format!("{} equations in the report, for one", report.equations.len())));
        };
        if equation.ok {
            return Err(Failed::from(format!("the slip goes unnoticed: {}", describe(equation))));
        }
        match equation.finding.verdict {
            Verdict::Unreadable if equation.finding.message.is_empty() => Err("refused without a reason".into()),
            Verdict::Unreadable => Ok(()),
            Verdict::Refuted => stands(equation, &notes),
            Verdict::Undecided if self.unpinned && is_untested_definition(&equation.finding) => Ok(()),
            _ => Err(Failed::from(format!("neither refuted nor unreadable: {}", describe(equation)))),
        }
    }
}

/// Whether a finding is that no equation tests a definition, or that the definition gives 0.
fn is_untested_definition(finding: &Finding) -> bool {
    use Code::{DefinitionNotTested, DefinitionUnused, DefinitionUsersFail, DefinitionZero};
    matches!(finding.code, DefinitionUnused | DefinitionUsersFail | DefinitionNotTested | DefinitionZero)
}

/// Whether the counterexamples of a refuted equation are ones: finite, both sides as they must not be, and the printed sides have
/// these values at that state wherever they are plain formulas of it.
fn stands(equation: &Equation, notes: &Notes) -> Result<(), Failed> {
    let links = links(equation, notes)?;
    for finding in failing(equation).into_iter().filter(|finding| finding.verdict == Verdict::Refuted) {
        let Some(found) = &finding.counterexample else { continue };
        let finite = found.state.iter().map(|(_, value)| *value).chain([found.lhs, found.rhs]).all(f64::is_finite);
        // an equality fails where its sides differ, and ≠ where they are equal, up to rounding
        let largest = found.state.iter().map(|(_, value)| value.abs()).fold(1.0, f64::max);
        let is_unequal = finding.code == Code::InequalityFails && notes.source.slice(finding.span).contains("\\neq");
        let fails = match is_unequal {
            true => (found.lhs - found.rhs).abs() <= 1e-14 * largest,
            false => found.lhs != found.rhs,
        };
        if !finite || !fails || (links.plain && found.state.is_empty()) {
            return Err(Failed::from(format!("this is no counterexample: {}", describe(equation))));
        }
        if links.plain && found.entry.is_none() && !links.give(found) {
            return Err(Failed::from(format!("the two sides have other values there: {}", describe(equation))));
        }
    }
    Ok(())
}

/// The printed sides of an equation, to be computed again without the checker.
struct Links {
    sides: Vec<[Formula; 2]>,
    /// Whether what is checked is just these links, between numbers.
    plain: bool,
}

fn links(equation: &Equation, notes: &Notes) -> Result<Links, Failed> {
    let plain = ["5.69", "5.70", "6.71", "6.73", "6.74"].contains(&equation.id.as_str());
    let display = notes.equations.iter().find(|display| display.id() == Some(&equation.id));
    let display = display.ok_or("the equation is gone")?;
    let statements =
        if plain { Formula::read_all(&display.text).map_err(|error| error.to_string())? } else { Vec::new() };
    let pairs = |statement: &Formula| {
        let members = statement.members();
        members.windows(2).map(|pair| [pair[0].clone(), pair[1].clone()]).collect::<Vec<_>>()
    };
    Ok(Links { sides: statements.iter().flat_map(pairs).collect(), plain })
}

impl Links {
    /// Whether one of the links has these values at this state.
    fn give(&self, found: &Counterexample) -> bool {
        let value = |formula: &Formula| {
            let letters = formula.letters();
            let needed = found.state.iter().filter(|(name, _)| letters.contains(name));
            let needed: Vec<(&str, f64)> = needed.map(|(name, value)| (name.as_str(), *value)).collect();
            formula.value(&needed).unwrap_or(f64::NAN)
        };
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (1.0 + a.abs() + b.abs());
        self.sides.iter().any(|[lhs, rhs]| near(value(lhs), found.lhs) && near(value(rhs), found.rhs))
    }
}
