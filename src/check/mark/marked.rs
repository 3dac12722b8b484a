//! A marked hand-in: plain data.

use std::fmt;
use std::sync::Arc;

use crate::formula::symbols::Name;
use crate::notes::claims::Lost;
use crate::source::{Source, Span};

use crate::check::verdict::Verdict;

/// The mark of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// It follows from the problem.
    Right,
    /// It is false, and it follows from a false line before it: the step is right.
    Carried,
    /// It is false, and follows from nothing before it.
    Wrong,
    /// It gives a name or a condition, or prints what the problem gives.
    Given,
    /// It was not decided.
    Open,
    /// It was not read.
    Unread,
}

impl Mark {
    /// The word in tables.
    pub fn word(self) -> &'static str {
        match self {
            Mark::Right => "right",
            Mark::Carried => "carried",
            Mark::Wrong => "wrong",
            Mark::Given => "given",
            Mark::Open => "undecided",
            Mark::Unread => "not read",
        }
    }

    /// The sign before the word.
    pub fn sign(self) -> &'static str {
        match self {
            Mark::Right => "✓",
            Mark::Carried => "→",
            Mark::Wrong => "✗",
            Mark::Given => "·",
            Mark::Open | Mark::Unread => "?",
        }
    }
}

/// The slip in a wrong line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Slipped {
    /// What was lost or changed.
    pub lost: Lost,
    /// The bytes of the hand-in that are wrong.
    pub span: Span,
    /// What should stand there, if an edit of the line corrects it.
    pub replacement: Option<String>,
}

/// What a line is, or why it has its mark.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Because {
    /// It follows from the problem, and nothing more is to be said.
    Follows,
    /// It follows at the instant at which this speed is reached.
    AtSpeed(Name),
    /// It follows where the first has the value of the second, which the problem names.
    AtValue(Name, Name),
    /// It numbers two values the other way round.
    OtherOrder,
    /// It gives, under another letter, these values to which the problem gives numbers.
    OneOf(Vec<Name>),
    /// Its number is right, but its unit is that of another quantity.
    Unit {
        /// The unit of the quantity.
        wanted: String,
        /// The value that is printed, with its unit.
        printed: String,
    },
    /// What this predicate says.
    Said(String),
}

impl fmt::Display for Because {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Because::Follows => f.write_str("follows from the problem"),
            Because::AtSpeed(speed) => write!(f, "follows where the speed is {speed}"),
            Because::OtherOrder => f.write_str("is true with the two signs in the other order"),
            Because::OneOf(values) => {
                let names: Vec<String> = values.iter().map(ToString::to_string).collect();
                write!(f, "follows for {}", names.join(" and "))
            }
            Because::AtValue(of, value) => write!(f, "follows where {of} is {value}"),
            Because::Unit { wanted, printed } => {
                write!(
                    f,
                    "has the right number, but not the right unit: the left side is in {wanted}, and {printed} is printed"
                )
            }
            Because::Said(predicate) => f.write_str(predicate),
        }
    }
}

impl<T: Into<String>> From<T> for Because {
    fn from(predicate: T) -> Self {
        Because::Said(predicate.into())
    }
}

/// What shows how far a line is wrong, as LaTeX.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Derived {
    /// The derived equation, for one of motion.
    Instead(String),
    /// Its left side minus its right side.
    Difference(String),
}

/// A line of a hand-in.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its line in the file, from 1.
    pub line: usize,
    /// Its name, which no other line has: `line 7`, `line 7b`.
    pub name: String,
    /// The number or label that the student gave it.
    pub id: Option<String>,
    /// Its bytes.
    pub span: Span,
    /// Its LaTeX; of a row that continues a chain, with the member that it continues.
    pub statement: String,
    /// Whether it stands inside the text.
    pub inline: bool,
    /// Its mark.
    pub mark: Mark,
    /// The verdict on it as an equation of the problem.
    pub verdict: Option<Verdict>,
    /// The line, by its place among the lines, from which a carried line follows.
    pub follows_from: Option<usize>,
    /// What it is, or why it has its mark, without the correction.
    pub because: Because,
    /// The slip in a wrong line, if it is known.
    pub slip: Option<Slipped>,
    /// What shows how far it is wrong.
    pub derived: Option<Derived>,
    /// The wanted result that it reaches, by its place among the results.
    pub result: Option<usize>,
    /// The points for that.
    pub credit: Option<f64>,
}

/// How a hand-in reached a wanted result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reached {
    /// A line says it.
    Yes,
    /// A line says it, and nothing before it shows where it comes from.
    WithoutSteps,
    /// A later result shows that it was passed.
    Passed,
    /// A line says it with a slip, or with a slip carried on.
    WithSlip,
    /// A line gives something else for it, and no single slip explains that.
    Wrong,
    /// No line says it.
    No,
}

impl Reached {
    /// The word in tables.
    pub fn word(self) -> &'static str {
        match self {
            Reached::Yes => "right",
            Reached::WithoutSteps => "right, without steps",
            Reached::Passed => "passed over",
            Reached::WithSlip => "with a slip",
            Reached::Wrong => "wrong",
            Reached::No => "missing",
        }
    }
}

/// A wanted result, as a hand-in has it.
#[derive(Clone, Debug, PartialEq)]
pub struct ResultMark {
    /// The number of the equation in the problem.
    pub id: String,
    /// What the rubric calls it.
    pub name: Option<String>,
    /// Its points.
    pub points: f64,
    /// How it was reached.
    pub reached: Reached,
    /// The line that says it, by its place among the lines.
    pub line: Option<usize>,
    /// The points that it got.
    pub got: f64,
}

/// A marked hand-in.
#[derive(Clone, Debug, PartialEq)]
pub struct Marked {
    /// The student: the name of the file without its extension.
    pub student: String,
    /// The file.
    pub source: Arc<Source>,
    /// The letters of the student, and those of the problem that they stand for.
    pub letters: Vec<(String, String)>,
    /// The lines in order.
    pub lines: Vec<Line>,
    /// The wanted results in order.
    pub results: Vec<ResultMark>,
    /// Why nothing could be marked.
    pub fault: Option<String>,
}

impl Marked {
    /// The points of the student.
    pub fn got(&self) -> f64 {
        self.results.iter().map(|result| result.got).sum()
    }

    /// The points of the problem.
    pub fn points(&self) -> f64 {
        self.results.iter().map(|result| result.points).sum()
    }

    /// The number of lines with a mark.
    pub fn count(&self, mark: Mark) -> usize {
        self.lines.iter().filter(|line| line.mark == mark).count()
    }

    /// Whether a line is wrong or a result is missing.
    pub fn is_wrong(&self) -> bool {
        self.count(Mark::Wrong) > 0 || self.results.iter().any(|result| result.reached == Reached::No)
    }

    /// Whether something was not read, so that a teacher must look.
    pub fn is_open(&self) -> bool {
        self.fault.is_some() || self.count(Mark::Unread) + self.count(Mark::Open) > 0
    }
}
