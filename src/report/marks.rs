//! Marks for people and for machines: text, and one table as CSV and JSON.
//!
//! Every table has the same columns, [`COLUMNS`]: one row for each student and line, and one for each missing result. What
//! a hint may say depends on its level; nothing else here says what the right line is.

use serde_json::{Value, json};

use crate::check::mark::{Because, Derived, Line, Mark, Marked, Reached, ResultMark};
use crate::notes::claims::Lost;

use super::style::Style;
use super::wrap::wrap;

/// The columns of a table.
pub const COLUMNS: [&str; 13] = [
    "student",
    "file",
    "line",
    "id",
    "statement",
    "mark",
    "credit",
    "verdict",
    "follows_from",
    "hint",
    "result",
    "points",
    "because",
];

/// The most that a hint says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Hints(pub u8);

/// The kind of a slip in words.
pub fn kind(lost: Lost) -> &'static str {
    match lost {
        Lost::Sign => "a sign is wrong",
        Lost::Factor => "a factor or a number is wrong",
        Lost::Power => "a power is wrong",
        Lost::Function => "a function is wrong, such as a sine for a cosine",
        Lost::Symbol => "one symbol stands in the place of another",
        Lost::Dot => "a dot is missing, or there is one too many",
        Lost::Term => "a term is missing, or one does not belong there",
    }
}

/// The hint for a wrong line; empty, if the level allows none.
pub fn hint(marked: &Marked, line: &Line, hints: Hints) -> String {
    if marked.count(Mark::Wrong) == 0 {
        return String::new();
    }
    if hints.0 == 0 {
        return "something in this hand-in is wrong".to_owned();
    }
    if line.mark != Mark::Wrong {
        return String::new();
    }
    let slip = line.slip.as_ref();
    let mut text = "look at this line".to_owned();
    if hints.0 >= 2 {
        let kind = match (slip, correction(marked, line)) {
            (None, _) if matches!(line.because, Because::Unit { .. }) => "the unit is wrong",
            (None, _) => "no single change that was tried makes the line right",
            (Some(slip), Some((is, _))) if slip.lost == Lost::Function && is.is_empty() => "a function is missing",
            (Some(slip), _) => kind(slip.lost),
        };
        text += &format!(": {kind}");
    }
    if hints.0 >= 3 {
        if let Some((is, should)) = correction(marked, line) {
            text += &match (is.as_str(), should.as_str()) {
                ("", should) => match corrected(marked, line) {
                    Some(whole) => format!("; insert {should}, which makes it {whole}"),
                    None => format!("; insert {should}"),
                },
                (is, "") => format!("; leave out {is}"),
                (is, should) => format!("; write {should} in place of {is}"),
            };
        } else if let Some(derived) = &line.derived {
            text += &match derived {
                Derived::Instead(formula) => format!("; the derived equation is {formula}"),
                Derived::Difference(formula) => format!("; left side − right side should be 0, and is {formula}"),
            };
        }
    }
    text
}

/// What a wrong line has, and what should stand there.
pub fn correction(marked: &Marked, line: &Line) -> Option<(String, String)> {
    let slip = line.slip.as_ref()?;
    let replacement = slip.replacement.as_ref()?;
    // A thin space parts the factor from what follows it, and is no part of the correction.
    let should = replacement.trim().trim_end_matches("\\,").trim();
    Some((marked.source.slice(slip.span).trim().to_owned(), should.to_owned()))
}

/// A wrong line with its correction.
fn corrected(marked: &Marked, line: &Line) -> Option<String> {
    let slip = line.slip.as_ref()?;
    let replacement = slip.replacement.as_ref()?;
    if !line.span.contains(slip.span) {
        return None;
    }
    let text = &marked.source.text;
    let (before, after) = (text.get(line.span.start..slip.span.start)?, text.get(slip.span.end..line.span.end)?);
    let whole = format!("{before}{replacement}{after}");
    Some(whole.trim_matches('$').split_whitespace().collect::<Vec<_>>().join(" "))
}

/// What is said of a file without lines.
const NO_FORMULA: &str =
    "no formula was found in this file; write each formula in LaTeX between $ … $, such as $v = \\sqrt{2 a s}$";

/// The rows of a class, as texts under [`COLUMNS`].
pub fn rows(class: &[Marked], hints: Hints) -> Vec<[String; 13]> {
    let mut rows = Vec::new();
    for marked in class {
        let row = || {
            let mut row: [String; 13] = Default::default();
            (row[0], row[1]) = (marked.student.clone(), marked.source.path.clone());
            row
        };
        let nothing = marked.lines.is_empty().then_some(NO_FORMULA);
        if let Some(why) = marked.fault.as_deref().or(nothing) {
            let mut row = row();
            (row[5], row[12]) = (Mark::Unread.word().to_owned(), why.to_owned());
            rows.push(row);
        }
        for line in &marked.lines {
            let mut row = row();
            row[2] = line.line.to_string();
            row[3] = line.id.clone().unwrap_or_else(|| line.name.clone());
            row[4] = shortened(&line.statement);
            row[5] = line.mark.word().to_owned();
            row[6] = line.credit.map(number).unwrap_or_default();
            row[7] = line.verdict.map(|verdict| verdict.word().to_owned()).unwrap_or_default();
            row[8] = line.follows_from.map(|from| marked.lines[from].name.clone()).unwrap_or_default();
            row[9] = hint(marked, line, hints);
            if let Some(result) = line.result.and_then(|at| marked.results.get(at)) {
                (row[10], row[11]) = (result.id.clone(), number(result.points));
            }
            row[12] = line.because.to_string();
            rows.push(row);
        }
        for result in marked.results.iter().filter(|result| result.reached == Reached::No) {
            let mut row = row();
            (row[5], row[6]) = ("missing".to_owned(), number(0.0));
            (row[10], row[11]) = (result.id.clone(), number(result.points));
            row[12] = format!("no line gives the result {}", called(result));
            rows.push(row);
        }
    }
    rows
}

/// A statement, of which at most the first characters are shown: no cell of a table holds more.
fn shortened(statement: &str) -> String {
    match statement.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{} …", &statement[..end]),
        None => statement.to_owned(),
    }
}

/// The most characters of a statement that are shown.
const LONGEST: usize = 2000;

/// A number of points, without needless digits.
pub fn number(points: f64) -> String {
    let text = format!("{points:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The name of a result.
pub fn called(result: &ResultMark) -> String {
    match &result.name {
        Some(name) => format!("({}), {name}", result.id),
        None => format!("({})", result.id),
    }
}

/// The table as CSV.
pub fn csv(class: &[Marked], hints: Hints) -> String {
    let quoted = |text: &str| match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    };
    let mut out = COLUMNS.join(",") + "\r\n";
    for row in rows(class, hints) {
        // A spreadsheet would take such a text for a formula of its own.
        let safe = row.iter().map(|text| {
            match text.starts_with(['=', '+', '@', '\t', '\r']) || text.starts_with('-') && text.len() > 1 {
                true => quoted(&format!(" {text}")),
                false => quoted(text),
            }
        });
        out += &(safe.collect::<Vec<_>>().join(",") + "\r\n");
    }
    out
}

/// The class as JSON: the same rows, and the students with their results.
pub fn json(problem: &str, class: &[Marked], hints: Hints) -> Value {
    let row = |row: [String; 13]| {
        let value = |(name, text): (&&str, String)| {
            let value = match *name {
                "line" => text.parse::<usize>().map_or(Value::Null, Value::from),
                "credit" | "points" => text.parse::<f64>().map_or(Value::Null, Value::from),
                _ if text.is_empty() => Value::Null,
                _ => Value::from(text),
            };
            ((*name).to_owned(), value)
        };
        Value::Object(COLUMNS.iter().zip(row).map(value).collect())
    };
    let result = |marked: &Marked, result: &ResultMark| {
        json!({
            "id": result.id, "name": result.name, "points": result.points, "credit": result.got,
            "reached": result.reached.word(), "line": result.line.map(|at| marked.lines[at].name.clone()),
        })
    };
    let student = |marked: &Marked| {
        let letters: serde_json::Map<String, Value> =
            marked.letters.iter().map(|(own, other)| (own.clone(), Value::from(other.clone()))).collect();
        json!({
            "student": marked.student, "file": marked.source.path, "credit": marked.got(), "points": marked.points(),
            "right": marked.count(Mark::Right), "wrong": marked.count(Mark::Wrong), "carried": marked.count(Mark::Carried),
            "letters": letters, "fault": marked.fault,
            "results": marked.results.iter().map(|found| result(marked, found)).collect::<Vec<_>>(),
        })
    };
    json!({
        "schema": 1,
        "problem": problem,
        "students": class.iter().map(student).collect::<Vec<_>>(),
        "rows": rows(class, hints).into_iter().map(row).collect::<Vec<_>>(),
    })
}

/// The class as text: each student with the lines, and the points of all.
pub fn text(class: &[Marked], hints: Hints, style: Style) -> String {
    let mut out = String::new();
    for marked in class {
        let head = format!("{}: {} of {} points", marked.source.path, number(marked.got()), number(marked.points()));
        out += &(wrap("", &head, 2, style.width) + "\n");
        if let Some(fault) = &marked.fault {
            out += &(wrap("  ? not read: ", fault, 6, style.width) + "\n");
        }
        if !marked.letters.is_empty() {
            let letters: Vec<String> = marked.letters.iter().map(|(own, other)| format!("{own} for {other}")).collect();
            out += &(wrap("  letters taken as: ", &format!("{} (please check)", letters.join(", ")), 4, style.width)
                + "\n");
        }
        if hints.0 == 0 {
            let said = match (marked.is_wrong(), open_lines(marked)) {
                (true, _) => "something in this hand-in is wrong or missing".to_owned(),
                (false, None) => "no mistake was found".to_owned(),
                (false, Some(open)) => format!("no mistake was found, but {open}"),
            };
            out += &(wrap("  ", &said, 4, style.width) + "\n\n");
            continue;
        }
        marked_lines(marked, hints, style, &mut out);
        for result in marked.results.iter().filter(|result| result.reached == Reached::No) {
            out += &(wrap("  missing: ", &called(result), 4, style.width) + "\n");
        }
        if marked.lines.is_empty() && marked.fault.is_none() {
            out += &(wrap("  ", NO_FORMULA, 4, style.width) + "\n");
        }
        out.push('\n');
    }
    let width = class.iter().map(|marked| marked.student.chars().count()).max().unwrap_or(0).max("student".len());
    out += &format!(
        "{:width$}  {:>7}  {:>5}  {:>5}  {:>7}  {:>7}\n",
        "student", "points", "right", "wrong", "carried", "missing"
    );
    for marked in class {
        let missing = marked.results.iter().filter(|result| result.reached == Reached::No).count();
        let points = format!("{}/{}", number(marked.got()), number(marked.points()));
        let (right, wrong, carried) =
            (marked.count(Mark::Right), marked.count(Mark::Wrong), marked.count(Mark::Carried));
        let open = open_lines(marked).map_or_else(String::new, |open| format!("  ({open})"));
        out += &format!(
            "{:width$}  {points:>7}  {right:>5}  {wrong:>5}  {carried:>7}  {missing:>7}{open}\n",
            marked.student
        );
    }
    out
}

/// How many lines could not be read or decided, and what to do; nothing, if there are none.
fn open_lines(marked: &Marked) -> Option<String> {
    if marked.fault.is_some() {
        return Some("the file was not read; check it by hand".to_owned());
    }
    let said = |count: usize, what: &str| match count {
        0 => None,
        1 => Some(format!("1 line {what}")),
        count => Some(format!("{count} lines {what}")),
    };
    let (unread, undecided) = (marked.count(Mark::Unread), marked.count(Mark::Open));
    let parts = [said(unread, "could not be read"), said(undecided, "could not be decided")];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    let them = if unread + undecided == 1 { "it" } else { "them" };
    (!parts.is_empty()).then(|| format!("{}; check {them} by hand", parts.join(" and ")))
}

/// The lines of a hand-in, each with its mark, and under it what is to be said of it.
fn marked_lines(marked: &Marked, hints: Hints, style: Style, out: &mut String) {
    let width = marked.lines.iter().map(|line| line.name.len()).max().unwrap_or(0);
    for (at, line) in marked.lines.iter().enumerate() {
        let first = format!("  {} {:width$}  ", line.mark.sign(), line.name);
        *out += &(wrap(&first, &shortened(&line.statement), 4 + width + 2, style.width) + "\n");
        let mut notes = Vec::new();
        match line.mark {
            Mark::Right if line.because == Because::Follows => {}
            Mark::Given => notes.push(format!("{}: this line {}", line.mark.word(), line.because)),
            Mark::Unread => notes.push(format!("{}: {}; mark this line by hand", line.mark.word(), line.because)),
            _ => notes.push(format!("{}: {}", line.mark.word(), line.because)),
        }
        for result in marked.results.iter().filter(|result| result.line == Some(at)) {
            let how = match result.reached {
                Reached::Yes => String::new(),
                // With a name, the words before stand between commas.
                Reached::WithSlip => {
                    let comma = if result.name.is_some() { "," } else { "" };
                    let what = if line.mark == Mark::Carried { "builds on a mistake" } else { "has a mistake" };
                    format!("{comma} {what}")
                }
                reached => format!(", {}", reached.word()),
            };
            notes.push(format!("result {}{how}: {} of {}", called(result), number(result.got), number(result.points)));
        }
        if line.mark == Mark::Wrong {
            notes.push(hint(marked, line, hints));
        }
        let indent = " ".repeat(4 + width + 2);
        for note in notes {
            *out += &(wrap(&indent, &note, 4 + width + 2, style.width) + "\n");
        }
    }
}
